#!/bin/bash
# Makes the pictures of the README by drape-capture: front.sh DRAPE-CAPTURE. Needs ffmpeg.
# docs/front.gif is a recorded session, docs/needs.png the full model of `hang` beside the shipped one, and
# docs/blown_up.png the last good state of a scene that fails.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
capture=$(realpath "$1")
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$capture" --replay "$here/front.txt" --frames 180 --every 2 --size 640x360 --out "$made"
ffmpeg -loglevel error -y -framerate 15 -pattern_type glob -i "$made/frame_*.png" -vf \
    "split[a][b];[a]palettegen=max_colors=112:stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle" \
    "$here/../../docs/front.gif"

hang() {
    "$capture" hang --set "view.eye=[1.0, 0.95, 1.45]" --set "view.target=[0.05, 0.78, 0.15]" --frames 45 --every 45 \
        --size 420x300 --out "$@"
}
hang "$made/full" --set cloth.particles=[40,40] --set cloth.bend.stiffness=5 --set cloth.bend.damping=0.01 \
    --set cloth.drag=1.125e-4 --set solver.integrator=dormand_prince --set solver.dt=1e-4
hang "$made/minimal"
ffmpeg -loglevel error -y -i "$made/full/frame_0045.png" -i "$made/minimal/frame_0045.png" -filter_complex hstack=2 \
    "$here/../../docs/needs.png"
"$capture" fails_rk4 --fps 60 --frames 60 --size 630x300 --out "$made/fails" || true  # as it should
cp "$(ls "$made"/fails/frame_*.png | tail -n 1)" "$here/../../docs/blown_up.png"
