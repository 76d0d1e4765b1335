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

# results of one commit and of the program's sources are fresh; another one is named
mkdir build
printf '#!/bin/sh\necho solvers 0abc\n' >build/clothbench
chmod +x build/clothbench
doc/figures --fresh >out && fail 'results of several commits are fresh'
sed -i '1s/ | commit .*/ | commit 1 | CPU | 2026-01-01 | solvers 0abc | 3 s/' doc/results/*.csv
doc/figures --fresh || fail 'results of one commit are not fresh'
for change in s/0abc/0abd/ s/CPU/GPU/; do
    sed -i "1$change" doc/results/truths.csv
    said=$(doc/figures --fresh) && fail "'$change' is fresh"
    [[ $said == *truths* ]] || fail "'$change' is not told: $said"
done

# what moved by more than its bar since a commit
git init -q . && git add doc/results && git -c user.name=a -c user.email=a@b commit -qm results
[ -z "$(doc/moved)" ] || fail "what is as it was moved: $(doc/moved)"
sed -i '/^stack,stored/s/$/1/' doc/results/truths.csv # a last digit more
[ -z "$(doc/moved)" ] || fail "the last digit moved: $(doc/moved)"
sed -i '/^fold,"shell, p = 3",0.4/s/,0\.00/,0.09/' doc/results/study_touching.csv
doc/moved | grep -q 'fold, shell, p = 3: error 0.00.* -> 0.09' || fail "an error moved: $(doc/moved)"
[ "$failures" -eq 0 ]
