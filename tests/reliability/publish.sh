#!/bin/bash
# Takes the figures of a run into the pages: publish.sh FILE.csv. The table is kept as docs/reliability.csv, and the
# part of docs/reliability.md between its two marks is made from it: for each means the last row.
set -eu
docs=$(cd "$(dirname "$0")/../../docs" && pwd)
head -n 1 "$1" | grep -q '^date,commit,machine,build,what,tried,failed,seconds$' || {
    echo "$1: not a table of reliability" >&2
    exit 2
}
[ "$1" -ef "$docs/reliability.csv" ] || cp "$1" "$docs/reliability.csv"
awk -F, -v OFS=' | ' '
    FNR == NR {
        if (FNR == 1) next
        key = $5 " (" $4 ")"
        if (!(key in row)) order[++count] = key
        row[key] = "| " key " | " $6 " | " $7 " | " $8 " | " $1 " | " $2 " | " $3 " |"
        next
    }
    /<!-- figures -->/ {
        print
        print ""
        print "| What was tried (build) | Times | Failed | Seconds | Date | Commit | Machine |"
        print "| --- | --- | --- | --- | --- | --- | --- |"
        for (i = 1; i <= count; ++i) print row[order[i]]
        print ""
        skipping = 1
        next
    }
    /<!-- end of figures -->/ { skipping = 0 }
    !skipping { print }
' "$docs/reliability.csv" "$docs/reliability.md" >"$docs/reliability.md.new"
mv "$docs/reliability.md.new" "$docs/reliability.md"
