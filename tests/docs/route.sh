#!/bin/bash
# Runs the gdb sessions of docs/reading.md: route.sh PROGRAM [PAGE]
#
# PROGRAM is drape-lab of a debug build. The page has the command line that starts gdb, in which PROGRAM takes the place
# of build/debug/bin/drape-lab, and sessions: blocks of code whose lines begin with "(gdb) ". Each is run by itself, from
# that start. One fails if a command does (no such function, symbol or frame), or if the program ends meanwhile.
# Ends with 1 if a session fails, with 77 if there is no gdb or no PROGRAM.
set -eu
export LC_ALL=C
program=${1:?"usage: tests/docs/route.sh PROGRAM [PAGE]"}
page=${2-$(dirname "$0")/../../docs/reading.md}
seconds=300  # that a session may take
built=build/debug/bin/drape-lab

command -v gdb >/dev/null || { echo "tests/docs/route.sh: there is no gdb (.ci/install gdb)" >&2; exit 77; }
[ -x "$program" ] || { echo "tests/docs/route.sh: there is no $program; docs/reading.md says how to build it" >&2; exit 77; }
printf -v program %q "$(realpath "$program")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
faults=0
fault() { echo "docs/reading.md: $1"; faults=$((faults + 1)); }

# The sessions, a file each: lines of gdb in one block, without the prompt
awk -v folder="$folder" '
    /^```/ { if (lines) ++sessions; lines = 0; next }
    sub(/^\(gdb\) /, "") { if (!lines++) print "set breakpoint pending off" >(folder "/session" sessions + 1)
        print >(folder "/session" sessions + 1) }' "$page"
shopt -s nullglob
sessions=("$folder"/session*)
[ ${#sessions[@]} -gt 0 ] || fault "has no gdb session"

# How the page starts gdb. The session stands before --args: what comes after is the program's.
mapfile -t starts < <(grep -E '^gdb ' "$page")
if [ ${#starts[@]} -ne 1 ] || [[ ${starts[0]} != *" --args $built "* ]]; then
    fault "has not one command line that runs gdb with --args $built"
    echo "$faults faults"
    exit 1
fi

for session in "${sessions[@]}"; do
    start=${starts[0]/#gdb /gdb -nx -batch -ex \'set breakpoint pending off\' }
    start=${start/" --args $built "/" -x '$session' --args $program "}
    status=0
    (cd "$folder" && timeout "$seconds" bash -c "$start" </dev/null >"$folder/output" 2>&1) || status=$?
    [ "$status" -ne 0 ] || ! grep -q '^\[Inferior .* exited' "$folder/output" || status=ended
    [ "$status" = 0 ] && continue
    fault "a session fails ($status):"
    tail -n +2 "$session" | sed 's/^/    (gdb) /'
    tail -n 12 "$folder/output" | sed 's/^/    /'
done

echo "${#sessions[@]} sessions, $faults faults"
[ "$faults" -eq 0 ]
