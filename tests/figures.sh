#!/usr/bin/env bash
# The figures of README.md are those of doc/results: that they are, and that every kind of
# difference is noticed, in a copy.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
failures=0

fresh() {
    rm -rf "${copy:?}"/*
    mkdir -p "$copy/tests/reference"
    cp -r "$source/doc" "$source/README.md" "$copy"
    cp "$source/tests/reference/paper_tables.csv" "$copy/tests/reference"
}

# expect CODE WORDS: what --check ends with, and what it says.
expect() {
    local code=0
    "$copy/doc/figures" --check >"$copy/out" 2>&1 || code=$?
    if [ "$code" -ne "$1" ] || { [ "$2" ] && ! grep -qF -- "$2" "$copy/out"; }; then
        echo "$3: ended with $code, want $1 and '$2':"
        head -n 20 "$copy/out"
        failures=$((failures + 1))
    fi
}

# change FILE SED: an edit that must change something.
change() {
    cp "$copy/$1" "$copy/before"
    sed -i "$2" "$copy/$1"
    if cmp -s "$copy/$1" "$copy/before"; then
        echo "$2 changes nothing in $1"
        failures=$((failures + 1))
    fi
}

fresh
expect 0 '' 'the tree as it is'

# A cell, a word, the paper's, a result: each turned into something else.
while IFS='|' read -r what file edit; do
    fresh
    change "$file" "$edit"
    expect 1 'want' "$what"
    "$copy/doc/figures" >/dev/null 2>&1
    expect 0 '' "$what, filled in again"
done <<'EDITS'
a cell of Table 1|README.md|s/^\(. IGA, paper.s . 10x10x2 . [0-9.]*\)/\17/
a cell of Table 2|README.md|s/^\(. Fig. 13c .*\)[0-9] [|]$/\177 |/
a word|README.md|s/<!--=growth-->1/<!--=growth-->7/
a word of the paper|README.md|s/<!--=paper_ratio-->1/<!--=paper_ratio-->7/
a cell of the truths|README.md|s/^\(. `flag` .*0\)[.]27/\1.28/
a cell of compare|README.md|s/^\(. mass-spring, explicit .*\)0[.]/\17./
a bar|doc/results/truth_sphere.csv|s/^0[.]2[0-9]*,.*,0[.]02/&9/
a result|doc/results/table2.csv|s/^"Fig. 15, falling flag",flag,2,2,1,15,15,2,450,169,1260,[0-9]*,/&9/
the second transcription|tests/reference/paper_tables.csv|s/^1,FEM,seconds,16.048/1,FEM,seconds,17/
EDITS

fresh
change README.md 's/^recomputes this on the scene/took 1.5 s here, &/'
expect 1 "Table 1: '1.5 s' comes from no result" 'a figure that nobody stands for'
fresh
change README.md 's/^## Two commands/&\n\ntook 1.5 s here/'
expect 0 '' 'a figure elsewhere'
fresh
change README.md 's/<!--=growth-->/<!--=growht-->/'
expect 1 'growht' 'a word that is none'
fresh
change doc/results/table1.csv 's/^# The same spaces against truth/# Nothing/'
expect 1 "doc/results/table1.csv has no table 'against truth'" 'a table that a result lacks'
fresh
rm "$copy/doc/results/table3.csv"
expect 1 'table3.csv' 'a result that is gone'

[ "$failures" -eq 0 ] || exit 1
echo "figures hold, and differences are noticed"
