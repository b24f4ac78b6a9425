#!/bin/bash
# Makes docs/data.md, which says for each table of docs/ where it is from and whether its code has changed since:
# data.sh [--check]. What is measured stands in `measured` beside this file. With --check the page is not changed, and it
# is a fault (exit code 1) where it calls data fresh that is not, or lacks a table; 77 without the history.
set -eu
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
status=0
git rev-parse --git-dir >/dev/null 2>&1 && [ "$(git rev-parse --is-shallow-repository)" = false ] || {
    echo "there is no history here"
    exit 77
}

for commit in $(sed -n 's/^# commit: \([0-9a-f]*\).*/\1/p' docs/*.csv | sort -u); do
    git cat-file -e "$commit^{commit}" 2>/dev/null || {
        echo "the history here lacks $commit"
        exit 77
    }
done

# Whether what a table measures is as it was in a commit: paths of src/ stand for those of include/drape/, too
is_the_same() {
    local commit=$1 all=() path
    shift
    for path; do
        all+=("$path")
        [ ! -e "include/drape/${path#src/}" ] || all+=("include/drape/${path#src/}")
    done
    git merge-base --is-ancestor "$commit" HEAD 2>/dev/null && git diff --quiet "$commit" -- "${all[@]}"
}

page() {
    cat <<'END'
# The data

Each table of measurements on the other pages, and each chart, is made from one of these files. This list says which
command made it, of which commit, on what and when, and whether the code that it measures has changed since. "A case
recomputed": a test computes one case of the table again, and finds all as it was but times
(`tests/docs/recompute.sh`). The list is made by `tests/docs/data.sh`; a test holds it to the history.

| Data | Command | Commit | Date | Machine | Run | The code since |
| --- | --- | --- | --- | --- | --- | --- |
END
    local data command paths cases commit since
    while IFS='|' read -r first paths cases; do
        read -r data command <<<"$first"
        value() { sed -n "s/^# $1: //p" "docs/$data" | head -n 1; }
        commit=$(value commit)
        since=changed${cases:+, a case recomputed}
        [[ $commit == *[!0-9a-f]* ]] || ! is_the_same "$commit" $paths || since="the same"
        [[ $paths == *[a-z]* ]] || since="a record of the past"
        echo "| [$data]($data) | ${command:+\`$command\`} | $commit | $(value date) | $(value machine) | $(value settings) | $since |" |
            sed 's/`-`//'
    done < <(grep '^[a-z]' "$here/measured")
}

for data in docs/*.csv; do
    grep -q "^$(basename "$data") " "$here/measured" || { echo "tests/docs/measured lacks $data"; status=1; }
done
for path in $(sed -n 's/^[a-z][^|]*|\([^|]*\).*/\1/p' "$here/measured"); do
    [ "$path" = - ] || [ -e "$path" ] || { echo "tests/docs/measured: there is no $path"; status=1; }
done
if [ "${1-}" != --check ]; then
    made=$(page)
    echo "$made" >docs/data.md
else
    # Data that is called changed may be so called
    lenient() { sed 's/ | changed\(, a case recomputed\)\? |$/ | the same |/'; }
    page | grep ' | changed[^|]* |$' | while IFS= read -r line; do
        grep -qxF "$line" docs/data.md || { echo "docs/data.md: not so: $line"; exit 1; }
    done || status=1
    diff <(page | lenient) <(lenient <docs/data.md) || status=1
fi
exit "$status"
