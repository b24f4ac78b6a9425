#!/bin/bash
# Holds what the pages name to what there is: names.sh [ROOT]. Each fault is a line "file: what is wrong", and ends with 1.
#
# - Works: @cite KEY in the sources and [KEY](references.bib) in the pages are entries of docs/references.bib, and every
#   entry is cited; a page cites in no other way, such as "(Somebody 2001)" or "Somebody et al.".
# - Files: what a page links to is there, and so is every path in backticks that begins with a folder of the sources.
# - Names: in docs/reading.md, names in backticks that follow a file's, `file`, `name`, are in that file; what a line for
#   gdb stops in (break NAME, frame function NAME) is the name of a function in the sources.
set -eu
export LC_ALL=C.UTF-8
cd "${1-$(dirname "$0")/../..}"
shopt -s nullglob
pages=(README.md docs/*.md docs/course/*.md)
shopt -u nullglob
faults=0
fault() { echo "$1"; faults=$((faults + 1)); }
file_of() { [ -e "$1" ] || compgen -G "$1" >/dev/null; }

# Works
for key in $(sed -n 's/^@[a-z]*{\([a-z0-9]*\),$/\1/p' docs/references.bib | sort | uniq -d); do
    fault "docs/references.bib: $key is there twice"
done
keys=$(sed -n 's/^@[a-z]*{\([a-z0-9]*\),$/\1/p' docs/references.bib)
sources=$(grep -rhoE '@cite [a-z0-9]+' include src shaders tests --exclude-dir=docs |
    sed 's/@cite //')
in_pages=$(grep -ohE '\[[a-z]+[0-9]*\]\((docs/|\.\./)?references\.bib\)' "${pages[@]}" | sed 's/^\[\(.*\)\](.*/\1/') || true
cited=$(printf '%s\n' $sources $in_pages | sort -u)
for key in $cited; do grep -qxF "$key" <<<"$keys" || fault "docs/references.bib: there is no $key, which is cited"; done
for key in $keys; do grep -qxF "$key" <<<"$cited" || fault "docs/references.bib: nobody cites $key"; done
while IFS= read -r line; do fault "$line: not cited as [key](references.bib)"; done < <(
    grep -onE '\([A-Z][A-Za-z-]+( et al\.| and [A-Z][a-z]+)?,? (19|20)[0-9]{2}\)|[A-Z][a-z]+ et al\.' "${pages[@]}" || true)

# Merges
while IFS= read -r line; do fault "$line: a merge was not finished"; done < <(grep -nE '^(<<<<<<<|=======|>>>>>>>)( |$)' "${pages[@]}" || true)

# Files
for page in "${pages[@]}"; do
    folder=$(dirname "$page")
    for link in $(grep -oE '\]\([^)]+\)' "$page" | sed 's/^](//; s/)$//; s/#.*//' | grep -v '://' | sort -u); do
        [ -e "$folder/$link" ] || fault "$page: links to $link, which is not there"
    done
    for path in $(grep -oE '`(include|src|tests|docs|shaders|\.ci)/[^` ]*`' "$page" | tr -d '`' | sort -u); do
        [[ $path == *NAME* || $path == *LAYER* ]] || file_of "$path" || fault "$page: names $path, which is not there"
    done
done

# Names
while read -r path name; do
    [ -f "$path" ] || continue
    for word in ${name//::/ }; do
        grep -qw -- "$word" "$path" || fault "docs/reading.md: there is no $name in $path"
    done
done < <(grep -oE '`(include|src|shaders)/[^` ]*`(, `[A-Za-z_:]+`)+' docs/reading.md |
    awk -F'`' '{ for (i = 4; i <= NF; i += 2) print $2, $i }')
for name in $(grep -ohE "(\(gdb\) |['\`])(break|frame function) [A-Za-z_:]+" "${pages[@]}" | sed 's/.* //' | sort -u); do
    [ "$name" = NAME ] || grep -rqE "(^|[^A-Za-z0-9_])${name##*::}\(" include src || fault "gdb stops in $name, which is no function"
done

echo "$faults faults"
[ "$faults" -eq 0 ]
