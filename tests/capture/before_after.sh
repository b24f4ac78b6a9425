#!/bin/bash
# Pictures of all shipped scenes as an earlier commit drew them, left, and as they are drawn now, right, one below the
# other, for the eye: before_after.sh COMMIT OUT.png. Builds that commit's drape-capture; needs ffmpeg and build/test.
set -eu

commit=${1:?usage: before_after.sh COMMIT OUT.png} out=${2:?usage: before_after.sh COMMIT OUT.png}
sources=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
git clone -q "$sources" "$folder/before"
git -C "$folder/before" checkout -q "$commit"
(cd "$folder/before" && cmake --preset demo && cmake --build build/release --target drape-capture) >/dev/null

# At a time [s] at which the picture tells much
pairs=()
while read -r scene time; do
    for program in "$folder/before/build/release/bin/drape-capture" "$sources/build/test/bin/drape-capture"; do
        picture=$folder/$scene-$(( ${#pairs[@]} % 4 )).png
        "$program" "$scene" --frames 1 --fps "$(awk "BEGIN { print 1 / $time }")" --size 640x360 --out "$folder/one" \
            --again >/dev/null 2>&1 && cp "$folder/one/frame_0001.png" "$picture" ||
            ffmpeg -nostdin -loglevel error -y -f lavfi -i color=black:s=640x360 -frames:v 1 "$picture"
        pairs+=(-i "$picture")
    done
done <<'TIMES'
veil 1.5
drop 1.5
original 1.2
hang 1.5
two_corners 1.2
curtain 2
flag 1.5
fold 1.5
pinch 1.2
slide 1.5
bullet 0.1
stack 1.5
table 1.5
three_balls 1.5
trampoline 1
twist 2
figure 1.2
large 1
TIMES
count=$(( ${#pairs[@]} / 2 ))
layout=$(for k in $(seq 0 $((count - 1))); do echo "$((k % 2 * 640))_$((k / 2 * 360))"; done | paste -sd '|')
ffmpeg -nostdin -loglevel error -y "${pairs[@]}" -filter_complex "xstack=inputs=$count:layout=$layout" "$out"
