#!/bin/sh
# Says what a picture costs, in processor time: simulating, drawing, and reading back with writing as PNG.
# usage: tests/bench/pictures.sh DRAPE-CAPTURE [SCENE]
set -eu
program=$1 scene=${2:-drop} frames=120
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# Seconds of the processor that a run takes.
cost() {
    { LC_ALL=C bash -c 'TIMEFORMAT="%U %S"; time "$@" >/dev/null 2>&1' x "$program" "$scene" --frames $frames "$@"; } 2>&1 |
        awk '{ print $1 + $2 }'
}
simulating=$(cost --hash)
drawing=$(cost --stats "$folder/stats.csv")
writing=$(cost --out "$folder/pictures")
awk -v n=$frames -v s="$simulating" -v d="$drawing" -v w="$writing" 'BEGIN {
    print "| simulating | drawing | reading back and PNG | all |\n| --- | --- | --- | --- |"
    printf "| %.0f ms | %.0f ms | %.0f ms | %.0f ms |\n", 1e3 * s / n, 1e3 * (d - s) / n, 1e3 * (w - d) / n, 1e3 * w / n }'
