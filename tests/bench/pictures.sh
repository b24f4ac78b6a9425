#!/bin/sh
# Says what a picture costs, in processor time: simulating, drawing, and reading back with writing as PNG.
# usage: tests/bench/pictures.sh DRAPE-CAPTURE [CSV [WAY [SCENE [OPTION...]]]]
# Appends a row to CSV, docs/pictures.csv if not given, under the name of a WAY to draw ("as it is"), with more OPTIONs;
# tests/docs/tables.sh then makes the table of docs/design.md from the last row of each way.
set -eu
docs=$(cd "$(dirname "$0")/../../docs" && pwd)
program=$1 table=${2:-$docs/pictures.csv} way=${3:-as it is} scene=${4:-drop} frames=120
shift $(($# < 4 ? $# : 4))
columns=what,date,commit,simulating_ms,drawing_ms,writing_ms
case $way in *,*) echo "$way: a way has no comma" >&2 && exit 2 ;; esac
[ -s "$table" ] || echo "$columns" >"$table"
grep -qx "$columns" "$table" || { echo "$table: its columns are not $columns" >&2 && exit 2; }
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# Seconds of the processor that a run takes.
cost() {
    { LC_ALL=C bash -c 'TIMEFORMAT="%U %S"; time "$@" >/dev/null 2>&1' x "$program" "$scene" --frames $frames "$@"; } 2>&1 |
        awk '{ print $1 + $2 }'
}
simulating=$(cost "$@" --hash)
drawing=$(cost "$@" --stats "$folder/stats.csv")
writing=$(cost "$@" --out "$folder/pictures")
awk -v n=$frames -v s="$simulating" -v d="$drawing" -v w="$writing" -v way="$way" -v date="$(date -u +%Y-%m-%d)" \
    -v commit="$(git -C "$docs" describe --always --dirty=+ --exclude='*' 2>/dev/null || echo unknown)" \
    'BEGIN { printf "%s,%s,%s,%.3g,%.3g,%.3g\n", way, date, commit, 1e3 * s / n, 1e3 * (d - s) / n, 1e3 * (w - d) / n }' |
    tee -a "$table"
