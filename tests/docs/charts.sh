#!/bin/bash
# Draws the charts of the pages from their data: charts.sh [--check] DRAPE-LAB [FOLDER]
#
# A chart is a picture NAME.svg that a page of docs/ (or FOLDER) shows and that `drape-lab merge` draws from a table
# beside the page, by the scripts in src/charts; a table of the laboratory is a *.csv that ends with "# end: CASES".
# Of a table of another program, NAME.csv, a script NAME.gp beside this file draws the chart.
# Pictures reading_*.svg are drawn by hand. With --check nothing is changed: charts that differ are named, and end with 1;
# 77 if there is no drape-lab or gnuplot, or a gnuplot of another version than the one that drew the charts.
set -eu
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
check=false
[ "${1-}" != --check ] || { check=true && shift; }
lab=$(realpath -m "${1?charts.sh [--check] DRAPE-LAB [FOLDER]}")
docs=${2-$here/../../docs}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
[ -x "$lab" ] || { echo "there is no $lab"; exit 77; }
command -v gnuplot >/dev/null || { echo "there is no gnuplot"; exit 77; }

# Of all that a table gives only what is looked at is drawn: no chart that no page shows, and no PNG
grep -ohE '\]\([a-z0-9_]+\.svg\)' "$docs"/*.md | tr -d '()]' | sort -u >"$made/shown"
mkdir "$made/bin"
cat >"$made/bin/gnuplot" <<END
#!/bin/bash
grep -qxF "\${2%.gnuplot}.svg" "$made/shown" || exit 0
sed -i "/kind = 'png'/d" "\$2"
exec "$(command -v gnuplot)" "\$@"
END
chmod +x "$made/bin/gnuplot"
PATH=$made/bin:$PATH

# Draws every table in a folder of its own, where it has the name of its experiment
mkdir "$made/charts"
for table in "$docs"/*.csv; do
    tail -n 1 "$table" | grep -q '^# end: ' || continue
    experiment=$(sed -n 's/^# experiment: //p' "$table")
    folder=$made/$(basename "$table" .csv)
    mkdir "$folder"
    cp "$table" "$folder/$experiment.csv"
    "$lab" merge "$folder" --out "$folder/drawn" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 2; }
    for chart in "$folder"/drawn/*.svg; do
        [ -f "$chart" ] || continue
        [ ! -e "$made/charts/$(basename "$chart")" ] || { echo "$chart: two tables give this chart" >&2; exit 2; }
        mv "$chart" "$made/charts"
    done
done

# Of other programs: the script stands here, and begins as one of the laboratory
for script in "$here"/*.gp; do
    name=$(basename "$script" .gp)
    [ -f "$docs/$name.csv" ] || continue
    cp "$docs/$name.csv" "$made/charts"
    {
        printf "name = '%s'\ntable = '%s.csv'\n" "$name" "$name"
        cat "$here/../../src/charts/common.gp" "$script"
        echo 'unset output'
    } >"$made/charts/$name.gnuplot"
    (cd "$made/charts" && gnuplot --default-settings "$name.gnuplot")
done

version() { sed -n 's/.*<desc>Produced by \(.*[^ ]\) *<\/desc>.*/\1/p' "$1"; }
without_version() { sed 's/<desc>.*<\/desc>//' "$1"; }
status=0 charts=0
for chart in $(cat "$made/shown"); do
    [[ $chart != reading_* ]] || continue
    charts=$((charts + 1))
    if [ ! -f "$made/charts/$chart" ]; then
        echo "$chart: no table beside the pages gives it" && status=1
    elif ! $check; then
        cp "$made/charts/$chart" "$docs"
    elif [ ! -f "$docs/$chart" ]; then
        echo "$chart: not there" && status=1
    elif [ "$(version "$docs/$chart")" != "$(version "$made/charts/$chart")" ]; then
        echo "$chart was drawn by $(version "$docs/$chart"); here is $(version "$made/charts/$chart")"
        exit 77
    elif ! cmp -s <(without_version "$docs/$chart") <(without_version "$made/charts/$chart"); then
        echo "$chart: not what its script and data give; draw it by $(basename "$0") DRAPE-LAB" && status=1
    fi
done
for chart in "$docs"/*.svg; do
    grep -qF "($(basename "$chart"))" "$docs"/*.md || { echo "$(basename "$chart"): no page shows it"; status=1; }
done
echo "$charts charts"
exit "$status"
