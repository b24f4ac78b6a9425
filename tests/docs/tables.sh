#!/bin/bash
# Makes the tables of the pages from their data: tables.sh [--check] [FOLDER]
#
# In a page of docs/ (or FOLDER, or course/ in it, or the README above it) a table stands between two lines,
#     <!-- table NAME DATA.csv -->
#     <!-- end of table -->
# and is what tables/NAME.awk prints for DATA.csv beside the page, with a line that says where the data is from. A script
# has cells by the names of their columns: cell("step_s"). With --check no page is changed: differences are shown, and end
# with 1.
#
# A number in a sentence is written
#     <!-- value NAME -->1.23<!-- /value -->
# where NAME begins a line of tests/docs/values, which says from which cells it is made. The mark is no line's beginning:
# there it would end the paragraph.
set -eu
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
check=false
[ "${1-}" != --check ] || { check=true && shift; }
docs=${1-$here/../../docs}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT

# What all scripts have: cells by name, and an end where the data is not what they expect
prelude='BEGIN { FS = "," }
function fail(text) { print FILENAME ": " text >"/dev/stderr"; failed = 1; exit 2 }
function cell(name) { if (!(name in column)) fail("there is no column " name); return $column[name] }
/^#/ { next }
!columns { columns = NF; for (i = 1; i <= NF; ++i) column[$i] = i; next }
NF != columns { fail("line " FNR " has " NF " cells in place of " columns) }
END { if (failed) exit 2 }'

# One table: make_table NAME DATA.csv, and from the page to the folder of the data, if that is another
make_table() {
    [ -f "$here/tables/$1.awk" ] && [ -f "$docs/$2" ] || {
        echo "there is no tables/$1.awk, or no $2 beside the page" >&2
        return 2
    }
    local rows head
    rows=$(awk "$prelude"$'\n'"$(cat "$here/tables/$1.awk")" "$docs/$2") || return 2
    [ -z "$rows" ] || printf '%s\n\n' "$rows"
    head=$(sed -n 's/^# \(commit\|machine\|compiler\|date\|settings\|note\): \(.\+\)/\1 \2/p' "$docs/$2" |
        sed 's/^\(machine\|compiler\|date\|settings\|note\) //' | paste -s -d ';' | sed 's/;/, /g')
    printf 'Made from [%s](%s%s)%s.\n' "$2" "${3-}" "$2" "${head:+ ($head)}"
}

# One value: make_value NAME. Its script gives cells to one(), which must agree, or to largest(), smallest() or median().
make_value() {
    local name data format script
    while read -r name data format script; do
        [ "$name" = "$1" ] || continue
        awk "$prelude"'
            function one(x) { if (value != "" && x != value) fail("there are several values"); value = x }
            function largest(x) { if (value == "" || x + 0 > value + 0) value = x }
            function smallest(x) { if (value == "" || x + 0 < value + 0) value = x }
            function median(x, i) {
                for (i = ++count; i > 1 && sorted[i - 1] > x + 0; --i) sorted[i] = sorted[i - 1]
                sorted[i] = x + 0
                value = (sorted[int((count + 1) / 2)] + sorted[int(count / 2) + 1]) / 2
            }
            '"$script"'
            END { if (value == "") fail("there is no such value"); printf "'"$format"'", value }' "$docs/$data"
        return
    done <"$here/values"
    echo "tests/docs/values has no $1" >&2
    return 2
}

# A line of a page with the values that it names: fill LINE
fill() {
    local line=$1 filled='' before
    while [[ $line =~ '<!-- value '([a-z0-9_]+)' -->'[^\<]*'<!-- /value -->' ]]; do
        before=${line%%"${BASH_REMATCH[0]}"*}
        line=${line#"$before${BASH_REMATCH[0]}"}
        filled+="$before<!-- value ${BASH_REMATCH[1]} -->$(make_value "${BASH_REMATCH[1]}")<!-- /value -->" || return
    done
    [[ $line != *'<!-- value'* && $line != *'/value -->'* && ! $1 =~ ^[' -']*'<!-- value' ]] || {
        echo "a value has no end in its line, or begins it" >&2
        return 2
    }
    printf '%s\n' "$filled$line"
}

status=0 tables=0
for page in "$docs"/*.md "$docs"/course/*.md "$docs"/../README.md; do
    [ -e "$page" ] || continue  # no course, or no README, beside these pages
    inside=false up=''
    case ${page#"$docs"/} in course/*) up=../ ;; ../*) up=docs/ ;; esac
    while IFS= read -r line || [ -n "$line" ]; do
        if [[ $line =~ ^'<!-- table '([a-z_]+)' '([a-z_]+\.csv)' -->'$ ]]; then
            $inside && { echo "$page: a table begins before the end of the one above: $line" >&2; exit 2; }
            inside=true tables=$((tables + 1))
            printf '%s\n\n' "$line"
            make_table "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" "$up" || { echo "$page: $line" >&2; exit 2; }
            echo
        elif [[ $line == '<!-- end of table -->' ]]; then
            $inside || { echo "$page: the end of a table that did not begin" >&2; exit 2; }
            inside=false
            printf '%s\n' "$line"
        elif ! $inside && [[ $line == *'<!-- '?(/)'value'* ]]; then
            fill "$line" || { echo "$page: $line" >&2; exit 2; }
        elif ! $inside; then
            printf '%s\n' "$line"
        fi
    done <"$page" >"$made/page"
    $inside && { echo "$page: a table has no end" >&2; exit 2; }
    if $check; then
        diff -u --label "$page" --label "as made by $(basename "$0")" "$page" "$made/page" || status=1
    elif ! cmp -s "$page" "$made/page"; then
        cat "$made/page" >"$page"
    fi
done
for name in $(awk '/^[a-z]/ { print $1 }' "$here/values"); do
    grep -rqF --include=*.md "<!-- value $name -->" "$docs" "$docs"/../README.md || { echo "tests/docs/values: no page has $name"; status=1; }
done
echo "$tables tables"
exit "$status"
