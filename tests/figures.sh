#!/usr/bin/env bash
# doc/figures --check: the figures of the pages are those of doc/results/, and one that is another
# is told, in a table, in the chart and in a sentence.
#   figures.sh SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
own_folder
ln -s "$1"/{bench,models,peers,python,tests} .
cp -r "$1/doc" "$1/README.md" .
doc/figures --check || fail 'figures of the pages are not those of doc/results/'
while read -r file told change; do
    cp "$file" whole
    sed -i "$change" "$file"
    said=$(doc/figures --check 2>&1) && fail "$file: '$change' passes"
    [[ $said == *"$told"* ]] || fail "$file: '$change' is not told: $said"
    mv whole "$file"
done <<'CHANGES'
README.md want /^<!-- figures: /,/figures end -->/s/\([0-9]\)\./\17./
doc/speed_against_error.svg other s/sum.of.its.data:.[0-9a-f]/&x/
README.md 3.5 $a It takes 3.5 s.
CHANGES
[ "$failures" -eq 0 ]
