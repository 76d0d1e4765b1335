#!/usr/bin/env bash
# `clothbench compare` on a cantilever so lightly loaded that its truth is the Kirchhoff plate:
# the table, its CSV, and that --from makes the same of the same files.
#   compare.sh PROGRAM FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
blunt=$(cd "$(dirname "$0")" && pwd)/truths
folder=$2

rm -rf "$folder" "$folder.none"
light=(compare cantilever_transient --quick --until 0.005
    --set material.density=1e-4 --set time.step=5e-4)
"$program" "${light[@]}" --models iga_linear,iga_selective_3,hex_incompatible --out "$folder" >"$folder.txt" 2>"$folder.log" ||
    { cat "$folder.log"; fail "exit $?"; }
grep -q quick "$folder"/iga_linear_*.h5 || fail "the runs do not say that they are quick"

# Cells of compare.csv, by the names of their columns; a title has a comma, nothing else.
# shellcheck disable=SC2016 # awk's own words
rows='{ sub(/^"[^"]*"/, "") } NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }'

# Every run of the ladder is there, timed three times, lives, and stays within 1 % of L; what
# does not lock and has the highest degree is the best of the coarse ones. The others are
# refined in one thing alone, to see what limits, and no seconds are told of them.
awk -F, "$rows"' { worst = $at["worst_rmse_over_length"]
             if (!(worst + 0 < 0.01) || worst == "") bad++
             if ($at["repeats"] == "") { more++; if ($at["seconds"] != "") bad++; next }
             n++; if ($at["repeats"] != 3) bad++
             if (best == "" || worst + 0 < best) { best = worst + 0; name = $at["contestant"] } }
         END { if (n != 6 || bad || more != 9) { print n, "runs,", more, "more,", bad + 0, "bad"; exit 1 }
               if (name != "iga_selective_3") { print "best:", name; exit 1 } }' \
    "$folder/compare.csv" || fail "compare.csv is not as it should be"

# What is refined for that is refined indeed: net, net across and step, each changes the error.
awk -F, 'NR > 1 { n++; for (i = NF - 3; i < NF; i++) if ($i == "" || $i == 0) bad++ }
         END { exit !(n == 3 && !bad) }' "$folder/compare_limits.csv" || fail "a refinement that changes nothing"

# The same from its files, in words and numbers, and nothing is run or made for it.
mkdir "$folder/first" && mv "$folder"/*.csv "$folder/first"
"$program" "${light[@]}" --models iga_linear,iga_selective_3,hex_incompatible --from "$folder" >"$folder.again" 2>>"$folder.log" || fail "--from"
cmp -s "$folder.txt" "$folder.again" || fail "--from prints something else"
for table in compare compare_targets compare_limits; do
    cmp -s "$folder/first/$table.csv" "$folder/$table.csv" || fail "--from: another $table.csv"
done
"$program" "${light[@]}" --models iga_linear,iga_selective_3,hex_incompatible --from "$folder" --format csv \
    2>/dev/null | sed -n 1,2p >"$folder.csv"
grep -q '^title,contestant,.*,rmse_over_length_0.001_s,.*_0.002_s,.*_0.003_s,.*_0.004_s,.*_0.005_s,worst' "$folder.csv" || fail "--format csv, or other times"
"$program" compare edge_drop --quick --from "$folder.none" >/dev/null 2>&1 && fail "--from of nothing"
[ ! -e "$folder.none" ] || fail "--from makes a folder"

# Stopped, it leaves what was finished and no parts; called again it takes that, and runs
# anew what has other settings.
again=("${light[@]}" --models "iga_linear,iga_selective_3" --out "$folder/stopped")
timeout -s INT 1 "$program" "${again[@]}" >/dev/null 2>&1
[ -z "$(find "$folder/stopped" -name '*.part')" ] || fail "stopped: leaves parts"
"$program" "${again[@]}" >/dev/null 2>"$folder.log" || fail "stopped: does not go on"
"$program" "${again[@]}" >/dev/null 2>"$folder.log" || fail "a third time"
grep -Eq "^compare: ([0-9]+) of \1 cases were taken from $folder/stopped$" "$folder.log" || fail "finished cases are run again"
"$program" "${again[@]}" --set material.density=2e-4 >/dev/null 2>"$folder.log" || fail "other settings"
grep -q "were taken" "$folder.log" && fail "cases of other settings are taken"

# A budget that pays for little runs little, and again from files.
two=("${light[@]}" --models "mass_spring_single,iga_selective_3")
for from in out from; do
    "$program" "${two[@]}" --budget 1e-6 "--$from" "$folder/thrifty" >"$folder.$from" 2>"$folder.log" ||
        { cat "$folder.log"; fail "a budget, --$from"; }
done
cmp -s "$folder.out" "$folder.from" || fail "--from prints something else"
awk -F, "$rows"' { n++; if ($at["model_bytes"] == "") bad++ } END { exit !(n == 2 && !bad) }' "$folder/thrifty/compare.csv" ||
    fail "a budget that is not kept, or no memory"

# The search goes to strips, whose files are called by both numbers of points; of a folder from
# before that, which has none of them, the rest is told.
strips=(compare cantilever_transient "${light[@]:3}" --budget 1 --models mass_spring_single)
"$program" "${strips[@]}" --out "$folder/strips" >/dev/null 2>"$folder.log" || { cat "$folder.log"; fail "strips"; }
compgen -G "$folder/strips/mass_spring_single_*x*.h5" >/dev/null || fail "no strip was tried"
rm "$folder"/strips/mass_spring_single_*x*
"$program" "${strips[@]}" --from "$folder/strips" >/dev/null 2>"$folder.log" || { cat "$folder.log"; fail "--from without strips"; }
files=$(find "$folder/strips" -name '*.h5' | wc -l)
awk -F, "$rows"' { n++; if ($at["repeats"] == "" && $at["unknowns"] == "") bad++ }
         END { exit !(n > '"$files"' / 2 && n > 3 && !bad) }' "$folder/strips/compare.csv" || fail "what is there is not told"

# A factor on the velocity is the paper's scheme's own: all others and the truth move undamped,
# unless the user damps them.
sed 's/^damping:.*/damping: {kind: velocity_scale, value: 0.5}/' "$CLOTHBENCH_SCENES/cantilever_transient.yaml" >"$folder/slowed.yaml"
grep -q velocity_scale "$folder/slowed.yaml" || echo "damping: {kind: velocity_scale, value: 0.5}" >>"$folder/slowed.yaml"
errors() { # of a contestant in a folder
    awk -F, "$rows"' $at["contestant"] == "'"$1"'" { print $at["worst_rmse_over_length"] }' "$2/compare.csv"
}
slowed=(compare "$folder/slowed.yaml" "${light[@]:2}" --models "iga_paper,iga_linear")
"$program" "${slowed[@]}" --out "$folder/slowed" >"$folder.txt" 2>"$folder.log" || { cat "$folder.log"; fail "slowed"; }
"$program" "${slowed[@]}" --set "damping={kind: none}" --out "$folder/free" >"$folder.txt" 2>"$folder.log" || { cat "$folder.log"; fail "free"; }
[ "$(errors iga_linear "$folder/slowed")" = "$(errors iga_linear "$folder/free")" ] || fail "others are damped"
[ "$(errors iga_paper "$folder/slowed")" != "$(errors iga_paper "$folder/free")" ] || fail "the paper's scheme is not damped"

# Who refuses is a row, and the others run.
"$program" "${light[@]}" --models iga_linear,projective_dynamics \
    --set discretization.acceleration=chebyshev --out "$folder/refused" >"$folder.txt" 2>"$folder.log" || fail "a refusal ends it"
awk -F, "$rows"' $at["unknowns"] == "" || $at["repeats"] != "" { seen[$at["contestant"] ($at["unknowns"] == "" ? " no" : " yes")]++ }
         END { exit !(seen["projective_dynamics yes"] == 4 && seen["iga_linear no"] == 2) }' \
    "$folder/refused/compare.csv" || fail "a refusal is no row"

# Scenes with a stored truth need no other: at its times, and beside its error bar.
"$program" compare edge_drop --models mass_spring_single --quick --budget 1e-6 --out "$folder/stored" \
    >"$folder.txt" 2>"$folder.log" || { cat "$folder.log"; fail "edge_drop"; }
sed 1q "$folder/stored/compare.csv" >"$folder.csv"
grep -q ',rmse_over_length_0.1_s,.*_0.2_s,.*_0.3_s,.*_0.4_s,.*_0.5_s,worst' "$folder.csv" || fail "other times than the stored ones"
[ -z "$(find "$folder/stored" -name 'truth_*')" ] || fail "edge_drop ran for its truth"

# Times at which the truth is too blunt for any target are left.
CLOTHBENCH_TRUTHS=$blunt "$program" compare flag --models mass_spring_single --quick --budget 1e-6 --out "$folder/flag" >"$folder.txt" 2>"$folder.log" || { cat "$folder.log"; fail "flag"; }
sed 1q "$folder/flag/compare.csv" >"$folder.csv"
grep -q ',rmse_over_length_0.1_s,rmse_over_length_0.2_s,worst' "$folder.csv" || fail "blunt times are compared"

# Scenes and options are read before anything is run: no folder is made.
while read -r arguments; do
    # shellcheck disable=SC2086 # words of a line
    "$program" compare $arguments --quick --out "$folder.none" >/dev/null 2>"$folder.log"
    [ $? = 2 ] || fail "$arguments does not end with exit 2"
    [ "$(wc -l <"$folder.log")" -eq 1 ] || fail "$arguments: $(cat "$folder.log")"
    [ ! -e "$folder.none" ] || fail "$arguments leaves a folder"
done <<END
cantilever_transient nowhere
cantilever_transient cantilever_transient
edge_drop --models nothing
edge_drop --until -1
edge_drop --until 0.1s
edge_drop --until 0.02
edge_drop --from $folder
edge_drop --budget 0
edge_drop --budget 3m
edge_drop --longest -1
edge_drop --format words
edge_drop --set material.yung=1
END
exit $((failures > 0))
