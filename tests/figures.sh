#!/usr/bin/env bash
# The figures of README.md and doc/*.md are those of doc/results: that they are, and that every
# kind of difference, and a figure that comes from no result, is noticed, in a copy.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
failures=0

fresh() {
    rm -rf "${copy:?}"/*
    mkdir -p "$copy/tests/reference" "$copy/peers" "$copy/bench/plans"
    cp "$source/bench/plans/table2.yaml" "$copy/bench/plans"
    cp "$source/peers/baselines.csv" "$copy/peers"
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

# Cells of the pages: turned into something else all at once, each is told by its line, and all
# are filled in again.
fresh
lines=()
while IFS='|' read -r what file edit; do
    change "$file" "$edit"
    while read -r line; do
        lines+=("$what|${file##*/}:$line: want")
    done < <(diff "$copy/before" "$copy/$file" | sed -n "s/^\([0-9]*\)[0-9,]*c.*/\1/p")
done <<'EDITS'
a cell of Table 1|README.md|s/^\(. IGA, paper.s . 10x10x2 . [0-9.]*\)/\17/
a cell of Table 2|doc/tables.md|s/^\(. Fig. 13c .*\)[0-9] [|]$/\177 |/
an exponent|doc/tables.md|s/^\(. exponent of assembly .*\)1[.]/\17./
a cell of the paper|README.md|s/^\(. paper: FEM .*\)176/\1776/
a cell of the truths|doc/truths.md|s/^\(. `flag` .*0\)[.]42/\1.43/
a cell of compare|doc/compare.md|s/^\(. mass-spring, explicit .*\)0[.]/\17./
a cell of the hard cases|doc/stress.md|s/^\(. buckling .*\|. ends pushed .*\)ok/\1died/
a cell of the map|doc/stress.md|s/^\(. shell.*\)100 ms/\1200 ms/
a cell of the peers|doc/peers.md|s/^\(. CalculiX.* 5 ms . \)0/\17/
a point of the chart|doc/speed_against_error.svg|0,/circle/s/cx="/&7/
a cell of the locking|doc/studies.md|s/^\(. degree 2 . \)6/\17/
EDITS
expect 1 '' 'cells'
for line in "${lines[@]}"; do
    grep -qF -- "${line#*|}" "$copy/out" || {
        echo "${line%%|*}: not told at ${line#*|}"
        failures=$((failures + 1))
    }
done
[ "${#lines[@]}" -ge 10 ] || { echo "edits of ${#lines[@]} lines" && failures=$((failures + 1)); }
"$copy/doc/figures" >/dev/null 2>&1
expect 0 '' 'cells, filled in again'

# A result that is another: each by itself, as it may stand on any page.
while IFS='|' read -r what file edit; do
    fresh
    change "$file" "$edit"
    expect 1 'want' "$what"
done <<'EDITS'
a baseline|peers/baselines.csv|s/^\("CalculiX[^"]*",[^,]*,edge_drop,21x21,[^,]*,0.5\),0/\1,7/
a bar|doc/results/truth_sphere.csv|s/^0[.]2[0-9]*,.*,0[.]01/&9/
a result|doc/results/table2.csv|s/^fig15,printed,450,1260,/&9/
how a hard case ended|doc/results/stress.csv|s/^thin_2,iga_reduced,\(.*\),accurate,/thin_2,iga_reduced,\1,died,/
an order|doc/results/study_timestep.csv|s/^\(nonlinear_mass,10 ms,.*,\)0[.]0002\(.*,.*,.*\)$/\10.0102\2/
the second transcription|tests/reference/paper_tables.csv|s/^1,FEM,seconds,16.048/1,FEM,seconds,17/
EDITS
"$copy/doc/figures" >/dev/null 2>&1
expect 0 '' 'another result, filled in again'

# Figures that nobody stands for: each kind, in prose, in a list, in a table of one's own.
fresh
sayings='README.md|took 1.5 s
README.md|was 12 s later
README.md|took 3 min
README.md|is 4 % off
README.md|is 40 times faster
README.md|grew 3-fold
doc/verification.md|held in 23 of 65 rows
doc/verification.md|left 3e-15
doc/verification.md|went as n^2
doc/truths.md|ran 16,000 steps
doc/adding_a_model.md|lost 0.846 of it
README.md|held in <!--=agree-->16<!----> rows
doc/tables.md|had <!-- figures: table4 --> no end'
while IFS='|' read -r page said; do
    printf '\nIt %s here.\n' "$said" >>"$copy/$page"
done <<<"$sayings"
expect 1 '' 'figures that nobody stands for'
while IFS='|' read -r page said; do
    figure=$(grep -F "${page##*/}: '" "$copy/out" | sed "s/^[^']*'\([^']*\)'.*/\1/" |
        while read -r figure; do if [[ $said == *"$figure"* ]]; then echo "$figure"; fi; done || true)
    [ "$figure" ] || { echo "$said in $page is not told" && failures=$((failures + 1)); }
done <<<"$sayings"
fresh
cat >>"$copy/README.md" <<'TEXT'

With nu = 0.3, h/L = 1e-2 and `--values 0.001`, 5 frames of 10 x 10 points.
TEXT
expect 0 '' 'settings, code and counts'
fresh
change doc/tables.md 's/run for 3 s on/run for long on/'
expect 1 "tables.md no longer says 'run for 3 s'" 'what is allowed and gone'
fresh
change doc/tables.md 's/figures: growth/figures: growht/'
expect 1 'growht' 'a table that is none'
fresh
change doc/tables.md '/figures: growth/,/figures end/{/figures end/d}'
expect 1 "'<!-- figures: growth -->'" 'a table without an end'
fresh
change doc/results/table1.csv 's/^# .*, Table 1: /# Nothing: /'
expect 1 "doc/results/table1.csv has no table 'Table 1'" 'a table that a result lacks'
fresh
rm "$copy/doc/results/table3.csv"
expect 1 'table3.csv' 'a result that is gone'

[ "$failures" -eq 0 ] || exit 1
echo "figures hold, and differences are noticed"
