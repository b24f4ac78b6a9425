#!/bin/bash
# Are planted faults caught? run.sh [NAME...]
#
# Builds a copy of the sources in build/planted with every fault of faults.txt beside this file in it, each asleep until
# the variable DRAPE_PLANTED has its name. The tests of each fault (or of those named) must pass while all are asleep, and
# fail when theirs is awake. Ends with 1 if a fault is missed, or if the list does not fit sources and tests.
#
# A fault is a paragraph of lines `KEY: VALUE`:
#     name    of letters, digits and _
#     file    where it is planted
#     old     an expression that is there exactly once, in one line
#     new     what stands there in its place: of the same type, and nothing that could run for ever
#     tests   a test program, and patterns of the tests that must see it; the most likely first
set -eu
export LC_ALL=C
unset DRAPE_PLANTED
here=$(cd "$(dirname "$0")" && pwd)
sources=$(cd "$here/../.." && pwd)
folder=$sources/build/planted
list=$here/faults.txt
seconds=900  # that the tests of a fault may take

fail() {
    echo "tests/planted/run.sh: $*" >&2
    exit 1
}

# The list, a fault a line; fields are apart by a control character, as white space would merge empty ones
faults=$(awk '
    function refuse(text) { print text >"/dev/stderr"; refused = 1; exit 1 }
    function put() { if (!fields) return
        if (fields != 5) refuse("the fault before line " NR " needs name, file, old, new and tests")
        printf "%s\001%s\001%s\001%s\001%s\n", v["name"], v["file"], v["old"], v["new"], v["tests"]
        split("", v); fields = 0 }
    /^#/ { next }
    /^[ \t]*$/ { put(); next }
    match($0, /^(name|file|old|new|tests): +/) { key = substr($0, 1, index($0, ":") - 1)
        if (key in v) refuse("line " NR " has a second " key)
        v[key] = substr($0, RLENGTH + 1); ++fields; next }
    { refuse("line " NR " is no field") }
    END { if (refused) exit 1; put() }' "$list") || fail "$list cannot be read"
[ -n "$faults" ] || fail "$list has no fault"
names=$(cut -d $'\001' -f 1 <<<"$faults")
repeated=$(sort <<<"$names" | uniq -d)
[ -z "$repeated" ] || fail "there are two faults of the name $repeated"
for name in "$@"; do
    grep -qxF -e "$name" <<<"$names" || fail "there is no fault $name"
done

# All files as they stand in the working tree
wanted=$folder/wanted
rm -rf "$wanted"
mkdir -p "$wanted" "$folder/source"
(cd "$sources" && git ls-files -z | while IFS= read -rd '' file; do
    [ ! -f "$file" ] || printf '%s\0' "$file"
done | xargs -0 cp --parents -t "$wanted")

# plant NAME FILE OLD NEW: the expression, and at the top of the file what wakes it, once where the file is read again
plant() {
    [[ $1 =~ ^[a-z0-9_]+$ ]] || fail "the name $1 has other characters than a-z, 0-9 and _"
    [ -f "$sources/$2" ] || fail "$1: there is no file $2"
    OLD=$3 NEW="(planted_$1() ? ($4) : ($3))" NAME=$1 awk '
        BEGIN { old = ENVIRON["OLD"]; name = ENVIRON["NAME"]
            print "#ifndef PLANTED_" name "\n#define PLANTED_" name "\n#include <cstdlib>\n#include <cstring>"
            print "static inline bool planted_" name "() {"
            print "    static const bool awake = std::getenv(\"DRAPE_PLANTED\") != nullptr &&"
            print "        std::strcmp(std::getenv(\"DRAPE_PLANTED\"), \"" name "\") == 0;"
            print "    return awake;\n}\n#endif\n#line 1" }
        { rest = $0; done = ""
            while (at = index(rest, old)) {
                done = done substr(rest, 1, at - 1) ENVIRON["NEW"]; rest = substr(rest, at + length(old)); ++count
            }
            print done rest }
        END { exit count != 1 }' "$wanted/$2" >"$wanted/planted" ||
        fail "$1: $2 does not have this exactly once: $3"
    mv "$wanted/planted" "$wanted/$2"
}
while IFS=$'\001' read -r name file old new _; do
    [ "$(grep -oF -e "$old" "$sources/$file" 2>/dev/null | wc -l)" -eq 1 ] ||
        fail "$name: $file does not have this exactly once: $old"
    plant "$name" "$file" "$old" "$new"
done <<<"$faults"

# Only what has changed is built again
sums() { (cd "$1" && find . -type f -exec sha256sum {} + | sort); }
names() { (cd "$1" && find . -type f | sort); }
comm -23 <(names "$folder/source") <(names "$wanted") | (cd "$folder/source" && xargs -rd '\n' rm)
comm -13 <(sums "$folder/source") <(sums "$wanted") | cut -d ' ' -f 3- |
    (cd "$wanted" && xargs -rd '\n' cp --parents -t "$folder/source")

cmake -S "$folder/source" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDRAPE_ASSERTS=ON \
    -DDRAPE_WERROR=OFF -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=26 >"$folder/configure.txt" ||
    { cat "$folder/configure.txt" >&2; fail "the planted sources cannot be configured"; }
mapfile -t programs < <(cut -d $'\001' -f 5 <<<"$faults" | cut -d ' ' -f 1 | sort -u)
cmake --build "$folder/build" --target "${programs[@]}" drape drape-capture drape-lab >"$folder/build.txt" ||
    { tail -n 60 "$folder/build.txt" >&2; fail "the planted sources do not build: $folder/build.txt"; }

# run_tests PROGRAM PATTERNS OUTPUT: ends as the program does
run_tests() {
    # What the shell itself says of a program that was killed is nothing new
    { (cd "$folder/build" && timeout "$seconds" "bin/$1" --gtest_filter="$2" --gtest_fail_fast) >"$3" 2>&1 </dev/null; } 2>/dev/null
}

# Which test of an output failed first; where the program has died of it there is but its beginning
first_failed() {
    local failed
    failed=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*/\1/p' "$1" | head -n 1)
    [ -n "$failed" ] || failed=$(sed -n 's/^\[ RUN      \] \([^ ]*\).*/\1/p' "$1" | tail -n 1)
    echo "${failed:-a program that does not start}"
}

tried=0 caught=0
while IFS=$'\001' read -r name _ _ _ tests; do
    [ $# -eq 0 ] || grep -qxF -e "$name" < <(printf '%s\n' "$@") || continue
    program=${tests%% *} patterns=${tests#* }
    IFS=: read -ra each <<<"$patterns"
    for pattern in "${each[@]}"; do
        "$folder/build/bin/$program" --gtest_list_tests --gtest_filter="$pattern" | grep -q '^  ' ||
            fail "$name: $program has no test $pattern"
    done
    tried=$((tried + 1))
    output=$folder/$name
    run_tests "$program" "$patterns" "$output.asleep.txt" ||
        fail "$name: $(first_failed "$output.asleep.txt") fails without a fault: $output.asleep.txt"
    status=0
    DRAPE_PLANTED=$name run_tests "$program" "$patterns" "$output.awake.txt" || status=$?
    if [ "$status" -eq 0 ]; then
        echo "MISSED $name"
    elif [ "$status" -eq 124 ]; then
        echo "MISSED $name: no end within $seconds s"
    else
        caught=$((caught + 1))
        echo "caught $name by $(first_failed "$output.awake.txt")"
    fi
done <<<"$faults"
echo "$caught of $tried planted faults are caught"
[ "$caught" -eq "$tried" ]
