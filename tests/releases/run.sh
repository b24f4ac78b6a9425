#!/bin/bash
# What a bare root of a Debian release does with a clone: runs the README's first or second command in it as it stands,
# or makes the Debian package in it and runs what that installs in another root, with nothing else. Warnings are errors.
#     tests/releases/run.sh RELEASE first|second|package [FOLDER]
# RELEASE is a name that debootstrap knows: bookworm, trixie, testing. Roots are kept in FOLDER, where it is named.
# Needs root, debootstrap and its mirror (MIRROR, if not deb.debian.org); without root or debootstrap: exit code 77.
set -eu

release=${1:-} what=${2:-} folder=${3:-}
case $release:$what in
    ?*:first | ?*:second | ?*:package) ;;
    *) echo "usage: tests/releases/run.sh RELEASE first|second|package [FOLDER]" >&2; exit 2 ;;
esac
sources=$(cd "$(dirname "$0")/../.." && pwd)
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null || ! unshare --mount true 2>/dev/null; then
    echo "tests/releases/run.sh: a bare root needs root, with the right to mount, and debootstrap" >&2
    exit 77
fi
if [ -z "$folder" ]; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
fi

# A copy of the bare root, which is made once; apt takes an older list from a mirror that stands still
bare_root() {
    local bare=$folder/bare-$release
    if [ ! -e "$bare/made" ]; then
        rm -rf "$bare"
        debootstrap --variant=minbase "$release" "$bare" "${MIRROR:-http://deb.debian.org/debian}" >&2
        echo 'Acquire::Check-Valid-Until "false";' >"$bare/etc/apt/apt.conf.d/90mirror"
        touch "$bare/made"
    fi
    rm -rf "$1"
    cp -a "$bare" "$1"
    cp /etc/resolv.conf "$1/etc/"
}

# Runs a command in /drape of a root, with processes and devices, which end with it
within() {
    unshare --mount --pid --fork bash -c '
        mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" &&
        exec chroot "$0" env -i CI=true HOME=/root LANG=C PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd /drape && $1"' "$1" "$2"
}

# The n-th command in a block of shell of the README
readme_command() { sed -n '/^```sh$/,/^```$/p' "$sources/README.md" | grep -v '^```' | sed -n "$1p"; }

case $what in
    first) command=$(readme_command 1) ;;
    second) command=$(readme_command 2) ;;
    package) command=".ci/install package && cmake --workflow --preset package" ;;
esac
root=$folder/$release-$what
bare_root "$root"
git clone --quiet --no-hardlinks "$sources" "$root/drape"
echo "$release: $command"
SECONDS=0
within "$root" "$command"
echo "$release: the command took $SECONDS s"

# As a user has it: the package, what it depends on, and no clone
if [ "$what" = package ]; then
    user=$folder/$release-user
    bare_root "$user"
    mkdir "$user/drape"
    cp "$root"/drape/build/release/package/*.deb "$user/drape"
    within "$user" "apt-get update -q && apt-get install -q -y --no-install-recommends ./*.deb &&
        drape --version && drape-lab list scenes && drape-lab simulate drop --time 0.05 --hash &&
        drape-capture drop --frames 2 --size 64x48 --out frames && ls frames/frame_0002.png &&
        drape </dev/null && ls drape-frames/frame_0120.png &&
        zcat /usr/share/man/man1/drape-capture.1.gz | grep -q -- --frames &&
        grep -q Expat /usr/share/doc/drape/copyright && dpkg --verify drape"
fi
if [ -n "${3:-}" ]; then echo "$release: the root stays in $root"; fi
