#!/bin/sh
# Compiles every source file and every header by itself, without code, by the compiler that is named. A build reads several
# files as one and some headers first of all, which hides an include that is missing.
# usage: tests/each_file.sh COMPILER, in any folder; the packages are those of `.ci/install test`, and for clang++ of
# `.ci/install clang`
set -eu

compiler=${1:?usage: tests/each_file.sh COMPILER}
source=$(cd "$(dirname "$0")/.." && pwd)
build=$source/build/each_file/$compiler
cmake -S "$source" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
    -DDRAPE_NIGHTLY=ON -DDRAPE_WERROR=ON >/dev/null
# One source file is made by the build
cmake --build "$build" --target drape_find_commit >/dev/null

# The command of each file is that of the build, but for what it writes; the first of each file is enough
commands=$build/commands
sed -n 's/^  "command": "\(.*\)",$/\1/p' "$build/compile_commands.json" |
    sed -e 's/\\"/"/g' -e 's/\\\\/\\/g' -e 's/ -o [^ ]* / -fsyntax-only /' >"$commands"

# A header is read as a file of the laboratory would read it, or of what draws, which both see all they may
flags_of() { grep -m 1 "$1" "$commands" | sed 's/ -c .*//'; }
lab=$(flags_of drape_experiments.dir) drawing="$(flags_of drape_offscreen.dir) $(pkg-config --cflags imgui)"
for header in "$source"/include/drape/*/*.h "$source"/src/*/*.h "$source"/src/*/*/*.h; do
    case $header in
        *-inl.h) continue ;; # read by a file that has chosen a kind of processor
        */render/* | */capture/* | */app/*) echo "$drawing -I$source/src -x c++ -include $header /dev/null" ;;
        *) echo "$lab -I$source/src -x c++ -include $header /dev/null" ;;
    esac
done >>"$commands"

echo "$(wc -l <"$commands") files and headers by $compiler"
failures=$build/failures
: >"$failures"
# One command a line, as many at a time as there are processors
tr '\n' '\0' <"$commands" | xargs -0 -n 1 -P "$(nproc)" sh -c '
    cd "$1" && sh -c "$3" 2>"$2.$$" || { printf "%s\n" "$3" >>"$2"; cat "$2.$$" >&2; }
    rm -f "$2.$$"' sh "$build" "$failures"
if [ -s "$failures" ]; then
    echo "$(wc -l <"$failures") of them do not compile by themselves" >&2
    exit 1
fi
