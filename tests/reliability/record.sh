#!/bin/bash
# Runs a means that looks for faults and keeps its figures: record.sh FILE.csv WHAT COMMAND...
# The command ends with lines "result,WHAT,TRIED,FAILED"; a fuzz target says "Done N runs" instead, and WHAT names it.
set -u
file=$1 what=$2
shift 2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
here=$(dirname "$0")

start=$SECONDS
"$@" 2>&1 | tee "$log"
status=${PIPESTATUS[0]}
seconds=$((SECONDS - start))

machine=$(sed -n 's/^model name[[:space:]]*: //p' /proc/cpuinfo | head -n 1 | tr ',' ' ')
commit=$(git -C "$here" rev-parse --short=12 HEAD 2>/dev/null || echo unknown)
[ -z "$(git -C "$here" status --porcelain --untracked-files=no 2>/dev/null)" ] || commit+="+"
[ -s "$file" ] || echo "date,commit,machine,build,what,tried,failed,seconds" >>"$file"
row() { echo "$(date -u +%F),$commit,${machine:-unknown},$(basename "$(dirname "$(realpath "$file")")"),$1,$2,$3,$seconds" >>"$file"; }

runs=$(sed -n 's/^Done \([0-9]*\) runs in .*/\1/p' "$log" | tail -n 1)
if [ -n "$runs" ]; then
    row "$what" "$runs" $((status != 0))
elif grep -q '^result,' "$log"; then
    while IFS=, read -r _ name tried failed; do row "$name" "$tried" "$failed"; done < <(grep '^result,' "$log")
else
    row "$what" 0 1
fi
exit "$status"
