#!/bin/bash
# Makes the moving picture of the README, docs/front.gif, by a recorded session: front.sh DRAPE-CAPTURE. Needs ffmpeg.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
capture=$(realpath "$1")
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$capture" --replay "$here/front.txt" --frames 180 --every 2 --size 640x360 --out "$made"
ffmpeg -loglevel error -y -framerate 15 -pattern_type glob -i "$made/frame_*.png" -vf \
    "split[a][b];[a]palettegen=max_colors=112:stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle" \
    "$here/../../docs/front.gif"
