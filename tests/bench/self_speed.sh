#!/bin/sh
# Measures what contact between cloths costs: broad phase and search of `stack` at several sizes, a sheet that cannot
# touch itself with contact and without, and a second of `fold`; in processor time, medians of three (`fold` once).
# usage: tests/bench/self_speed.sh BENCH [CSV]
# Writes CSV, docs/self_speed.csv if not given; tests/docs/tables.sh then makes the tables of docs/contact-measured.md.
set -eu
export LC_ALL=C
docs=$(cd "$(dirname "$0")/../../docs" && pwd)
program=$1 table=${2:-$docs/self_speed.csv}
made=$(mktemp)
trap 'rm -f "$made"' EXIT
{
    "$(dirname "$0")/table_head.sh" "processor time, medians of three, fold once"
    echo "what,side,triangles,cpu_us"
    # Sheets that fold take minutes, and once is enough for them
    {
        "$program" --benchmark_filter='^self/([^f]|flat)' --benchmark_repetitions=3 --benchmark_min_time=0.1 \
            --benchmark_report_aggregates_only=true
        "$program" --benchmark_filter=^self/fold
    } 2>/dev/null | awk '$1 ~ /_median$|\/fold_/ {
        sub("/iterations:[0-9]+", "", $1); sub("_median$", "", $1); split($1, name, "/")
        sheets = name[2] ~ /^(broad_phase|new_list|listed)$/ ? 3 : 1
        triangles = sheets * 2 * (name[3] - 1) ^ 2
        if (name[2] !~ /^(flat|draped)$/) printf "%s,%s,%d,%s\n", name[2], name[3], triangles, $4
        # Seconds as 12.3u or 1.23m
        for (k = 5; k <= NF; ++k) {
            if (split($k, counter, "=") != 2 || counter[1] !~ /^(added|integration)$/) continue
            us = counter[2] * (counter[2] ~ /m$/ ? 1000 : counter[2] ~ /u$/ ? 1 : "?")
            printf "%s_%s,%s,%d,%g\n", name[2], counter[1], name[3], triangles, us
        }
    }'
} >"$made"
for row in broad_phase,256 new_list,256 listed,256 flat_added,128 flat_integration,128 draped_added,128 \
    draped_integration,128 fold_symplectic_euler,64 fold_backward_euler,64 fold_xpbd,64 fold_projective_dynamics,64; do
    grep -Eq "^$row,[0-9]+,[1-9]" "$made" || { echo "$program: did not measure $row" >&2 && exit 1; }
done
cat "$made" >"$table"
