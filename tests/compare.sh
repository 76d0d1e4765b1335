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
light=(compare cantilever_transient --models "iga,hex" --quick --until 0.005
    --set material.density=1e-4 --set time.step=5e-4)
"$program" "${light[@]}" --out "$folder" >"$folder.txt" 2>"$folder.log" ||
    { cat "$folder.log"; fail "exit $?"; }
grep -q "truth's error bar" "$folder.txt" || fail "no error bar of the truth"
grep -q "Kirchhoff plate" "$folder.txt" || fail "the truth is not named"

# Every run is there, lives, and stays within 1 % of L; what does not lock and has the highest
# degree is the best of the coarse ones.
awk -F, 'NR > 1 && NF > 1 { n++; if (!($9 + 0 < 0.01) || $9 == "nan") bad++
             if (best == "" || $9 + 0 < best) { best = $9 + 0; name = $1 } }
         END { if (n != 22 || bad) { print n, "runs,", bad + 0, "bad"; exit 1 }
               if (name != "\"iga selective nonlinear p=3\"") { print "best:", name; exit 1 } }' \
    "$folder/compare.csv" || fail "compare.csv is not as it should be"

"$program" "${light[@]}" --from "$folder" >"$folder.again" 2>>"$folder.log" || fail "--from"
cmp -s "$folder.txt" "$folder.again" || fail "--from prints something else"

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
