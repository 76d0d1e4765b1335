#!/usr/bin/env bash
# `clothbench compare` on a cantilever so lightly loaded that its truth is the Kirchhoff plate:
# the table, its CSV, and that --from makes the same of the same files.
#   compare.sh PROGRAM FOLDER
set -u
program=$1
folder=$2
failed=0

fail() {
    echo "compare.sh: $*"
    failed=1
}

rm -rf "$folder" "$folder.none"
light=(compare cantilever_transient --quick --until 0.005
    --set material.density=1e-4 --set time.step=5e-4)
"$program" "${light[@]}" --models iga,hex --out "$folder" >"$folder.txt" 2>"$folder.log" ||
    { cat "$folder.log"; fail "exit $?"; }
grep -q "truth's error bar" "$folder.txt" || fail "no error bar of the truth"
grep -q "Kirchhoff plate" "$folder.txt" || fail "the truth is not named"

# Cells of compare.csv, by the names of their columns; a title has a comma, nothing else.
# shellcheck disable=SC2016 # awk's own words
rows='{ sub(/^"[^"]*"/, "") } NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }'

# Every run is there, timed three times, lives, and stays within 1 % of L; what does not lock
# and has the highest degree is the best of the coarse ones.
awk -F, "$rows"' { n++; worst = $at["worst_rmse_over_length"]
             if (!(worst + 0 < 0.01) || worst == "nan" || $at["repeats"] != 3) bad++
             if (best == "" || worst + 0 < best) { best = worst + 0; name = $at["contestant"] } }
         END { if (n != 22 || bad) { print n, "runs,", bad + 0, "bad"; exit 1 }
               if (name != "iga_selective_3") { print "best:", name; exit 1 } }' \
    "$folder/compare.csv" || fail "compare.csv is not as it should be"

"$program" "${light[@]}" --models iga,hex --from "$folder" >"$folder.again" 2>>"$folder.log" || fail "--from"
cmp -s "$folder.txt" "$folder.again" || fail "--from prints something else"

# Who refuses is a row with its sentence, and the others run; the table says how often.
"$program" "${light[@]}" --models iga_linear,projective_dynamics \
    --set discretization.acceleration=chebyshev --out "$folder/refused" >"$folder.txt" 2>"$folder.log" || fail "a refusal ends it"
grep -q "IGA, linear, 10x10: .*acceleration" "$folder.txt" || fail "no sentence of a refusal"
awk -F, "$rows"' { seen[$at["contestant"] ($at["unknowns"] == "nan" ? " no" : " yes")]++ }
         END { exit !(seen["projective_dynamics yes"] == 4 && seen["iga_linear no"] == 2) }' \
    "$folder/refused/compare.csv" || fail "a refusal is no row"
grep -q repeats "$folder.txt" || fail "the number of repeats is not told"

# Scenes with a stored truth need no other: at its times, and beside its error bar.
"$program" compare edge_drop --models projective_dynamics --quick --out "$folder/stored" \
    >"$folder.txt" 2>"$folder.log" || { cat "$folder.log"; fail "edge_drop"; }
grep -q "Truth: stored" "$folder.txt" || fail "edge_drop has no stored truth"
[ -z "$(find "$folder/stored" -name 'truth_*')" ] || fail "edge_drop ran for its truth"

"$program" compare edge_drop --models nothing --out "$folder.none" >/dev/null 2>"$folder.log"
[ $? = 2 ] || fail "an unknown model does not end with exit 2"
[ ! -e "$folder.none" ] || fail "an unknown model leaves a folder"
"$program" compare edge_drop --until -1 >/dev/null 2>"$folder.log"
[ $? = 2 ] || fail "--until -1 does not end with exit 2"
exit $failed
