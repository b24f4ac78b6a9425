#!/bin/bash
# Does this code still give the tables of docs/? recompute.sh DRAPE_LAB: computes the cases that `measured` beside this
# file names, and compares all that they found but times. Exit code 1 if anything differs.
set -eu
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
lab=$(realpath "$1")
cd "$here/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0

# What a table has of a case, without times and their quartiles
results() {
    awk -F, -v number="$2" '
        /^#/ { next }
        !columns { columns = NF
                   for (k = 1; k <= NF; ++k) {
                       time[k] = $k ~ /^(build|cost|cpu|cumulative|exact|query|respond|search|whole)_(.*_)?s(_|$)/
                       if (!time[k]) printf "%s ", $k
                   }
                   print ""; next }
        $1 == number { for (k = 1; k <= NF; ++k) if (!time[k]) printf "%s ", $k
                       print "" }' "$1"
}

while IFS='|' read -r first _ cases; do
    read -r data experiment _ <<<"$first"
    for number in $cases; do
        made=$folder/$data-$number
        "$lab" "$experiment" --cases "$number-$number" --out "$made" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
        results "$made/$experiment.csv" "$number" >"$folder/now"
        [ "$(wc -l <"$folder/now")" -gt 1 ] || { echo "$experiment has no case $number"; exit 1; }
        diff <(results "docs/$data" "$number") "$folder/now" || { echo "docs/$data: case $number differs"; status=1; }
    done
done < <(grep '^[a-z]' "$here/measured")
exit "$status"
