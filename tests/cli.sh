#!/usr/bin/env bash
# The program as a user meets it: what it prints where, and how it ends.
#   cli.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
blunt=$2/tests/truths
readme=("$2/README.md" "$2"/doc/*.md)
own_folder

short=(--set time.end=0.05 --quiet)

# --- help -------------------------------------------------------------------------------
good help
mv out overview
good --help
cmp overview out || fail '--help is not help'
sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' out | grep -Ev '^(help|version)$' >commands
[ -s commands ] || fail 'help lists no commands'
while read -r command; do
    good help "$command"
    has out "clothbench $command"
    mv out help
    good "$command" --help
    cmp help out || fail "$command --help is not help $command"
    grep -o '^  --[a-z]*' out >>options
done <commands
# the pages use no other options
grep -h '^    build/clothbench' "${readme[@]}" | grep -o ' --[a-z]*' | sort -u | while read -r option; do
    grep -qx -- "  $option" options || exit 1
done || fail 'a page has an option that help has not'
good run edge_drop --model hex --help
for words in version --version 'help version' 'help help' 'help scene' 'help plan'; do
    # shellcheck disable=SC2086 # words
    good $words
    [ -s out ] || fail "$words prints nothing"
done

# --- list -------------------------------------------------------------------------------
# empty files stand before the stored truths, which take a second to read
mkdir light
for truth in "$2"/bench/truths/*.h5; do : >"light/${truth##*/}"; done
for words in '' models contestants studies cases checks; do
    # shellcheck disable=SC2086 # words
    CLOTHBENCH_TRUTHS=light good list $words
    [ "$(wc -l <out)" -gt 5 ] || fail "list $words: $(<out)"
done
good list scenes
names=$(cut -d' ' -f1 out)
[ "$(wc -w <<<"$names")" -ge 9 ] || fail "few scenes: $names"
grep -q '^corners_drop .* two corner' out || fail "corners_drop is not held at two corners"
good list fabrics
for name in ponte_roma interlock rib_knit; do
    sed -n "/^$name /,/^[a-z]/p" out | tr -s ' \n' ' ' | grep -q 'it widens when it is pulled' ||
        fail "list fabrics: $name, whose Y12 is negative, is not flagged"
done
! sed -n '/^twill /,/^[a-z]/p' out | grep -q 'it widens' || fail 'list fabrics: twill widens'
for name in $names; do
    good run "$name" "${short[@]}" --set 'discretization.points=[6,6,2]'
    [ -z "$(cat out err)" ] || fail "run $name --quiet says $(cat out err)"
done
good list truths
# a truth's bar is the smaller one of both models or, if larger, their difference; its packing is some
# of that, but a tenth at most
good truth flag --stored --format csv
awk -F, '/^time_s,/ { for (n = 1; n <= NF; n++) at[$n] = n }
    /^[0-9]/ {
        a = $at["solid_bar_over_length"]; b = $at["shell_bar_over_length"]; rows++
        own = a < b ? a : b; apart = $at["difference_over_length"]
        bar = $at["error_bar_over_length"]; packing = $at["packing_over_length"]
        want = own > apart ? own : apart
        if ((bar - want) ^ 2 > 1e-12 * bar ^ 2 || packing <= 0 || packing > 0.1001 * bar) wrong = 1
    }
    END { exit wrong || rows < 4 }' out || fail "columns of a truth: $(<out)"
sed 's/^name:.*/name: mine/' "$2/models/scenes/edge_drop.yaml" >mine.yaml
good truth corners_patch --stored
# what it has made is found where it was left
sed 's/^name:.*/name: yours/' mine.yaml >yours.yaml
refused truth yours.yaml --stored
ends 1 truth yours.yaml --error 0.0001% --until 0.04 --budget 1e-6
good truth yours.yaml --stored
has out 'Truth of yours'
for scene in flag sphere; do # truths that end within what is stored
    CLOTHBENCH_TRUTHS=$blunt good truth "$scene" --stored
    has out 'no claim'
done
# a budget that holds no more than the first runs: a truth as it is, no, and until when it would do
ends 1 truth stiff --error 0.0001% --until 0.04 --budget 1e-6 --runs t --out t.h5
[ -s out ] || fail 'truth without a budget: nothing is told of what was made'
[ "$(find t -name '*.h5' | wc -l)" -eq 5 ] || fail "its runs: $(ls t)"
cp t.h5 light
CLOTHBENCH_TRUTHS=light good list truths
grep -q '^ *t ' out || fail "list truths has not t: $(<out)"

# --- verify judges nobody by a truth of other physics ------------------------------------
mkdir scenes
sed 's/young: *1.0e5/young: 1.0e6/' "$2/models/scenes/edge_drop.yaml" >scenes/edge_drop.yaml
CLOTHBENCH_SCENES=$PWD/scenes good verify truths --quick \
    --models mass_spring_leapfrog --format csv
[ "$(grep -c '^"edge_drop, rms / L",' out)" = 1 ] || fail "verify truths leaves one out: $(<out)"
grep -q '^"edge_drop, rms / L".*,not applicable,' out ||
    fail "verify truths judges by another physics: $(<out)"
grep -q '^"flag, rms / L at 0.1 s".*,no claim,0' out || fail "verify truths lacks the flag: $(<out)"
mkdir truths
echo no truth >truths/flag.h5
CLOTHBENCH_TRUTHS=$PWD/truths refused verify truths --quick --models mass_spring_leapfrog

# --- bad usage: a line is a command -------------------------------------------------------
mkdir nets
while read -ra words; do
    refused "${words[@]}"
done <<'USAGE'

dance
--dance
list cats
list scenes two
report nowhere
stress dance
stress --models ibm
stress --out a --from b
bench dance
bench solids --from times --out more
verify dance
verify elastica --models iga,ibm
verify elastica --from a --out b
verify elastica --from a --quick
verify elastica --format html
table 1 --runs 2
study locking flag
truth mine.yaml --stored
truth corners_drop --stored
truth corners_drop --error 1%
truth strip_swing --third nets --out third.h5
truth edge_drop --stored --set material.young=1e6
truth edge_drop --error 5%
truth edge_drop --error 0
truth edge_drop --error 1% --quick
truth edge_drop --error 1% --store --out t.h5
truth edge_drop --error 1% --budget -1
truth stiff --error 1% --until 0.01 --runs t --out t.h5
run
run one two
run nowhere
run nowhere.yaml
run edge_drop --model ibm
run edge_drop --dance
run edge_drop -x
run edge_drop --model
run edge_drop --model iga --model iga
run edge_drop --static=yes
run edge_drop --static --modes 3 --set discretization.kinematics=linear
run edge_drop --modes 0
run edge_drop --modes many
run edge_drop --modes 541 --quiet
run edge_drop --modes 1 --probe 0,0,0
run edge_drop --modes 1 --out a.h5
run edge_drop --out a.h5 --every 0
run edge_drop --every 2
run edge_drop --static --out a.h5 --every 2
run edge_drop --format csv
run edge_drop --static --format html
run edge_drop --set wind_speed=3
run edge_drop --set material.young=-1
run edge_drop --set discretization.points=[10000,10000,2]
run edge_drop --set discretization.degree=[5,2,1] --set discretization.points=[5,5,2]
run edge_drop --model projective_dynamics --set discretization.integrator=momentum
run hinge --set time.end=0.05 --quiet --matrices hinged
run edge_drop --probe 1
run edge_drop --probe 1,1
run edge_drop --probe 1,1,1,1
run edge_drop --probe 1,1,x
run edge_drop --probe 1,1,1.5
run edge_drop --probe -1,0,0
run edge_drop --probe nan,0,0
run edge_drop --probe ,,
USAGE
for point in '' '1,1,1 '; do
    refused run edge_drop --probe "$point"
done
for path in a.h5 third third.h5 hinged; do
    [ ! -e "$path" ] || fail "what is refused leaves $path"
done

# --- what a run says: words on standard error alone ---------------------------------------
warnings() { # COUNT
    [ "$(grep -c '^warning:' err)" -eq "$1" ] || fail "not $1 warnings: $(<err)"
}
good run edge_drop --set time.end=0.05
{ [ ! -s out ] && [ -s err ]; } || fail "run prints data nobody asked for: $(<out)"
warnings 1 # its damping is no rate
! grep -q $'\033\|\r' err || fail 'a progress bar without a terminal'
good run edge_drop --set time.end=0.05 --set 'damping={kind: none}'
warnings 0
good run cantilever --model iga_nonlinear --static
good run fold --model triangles_explicit --set time.end=0.005 --set discretization.points=[31,7]
# rho = 2.5e-3, 4e-3, 1e-3 kg/m^3: Gamma = 1.9, 3.1, 0.77, on either side of 0.9 and of 2.9
for light in 2.5e-3:'1 %' 4e-3:'10 %' 1e-3:; do
    good run edge_drop --set discretization.kinematics=linear --set time.end=0.005 \
        --set 'damping={kind: none}' --set material.density="${light%:*}"
    [ "$(grep '^warning:' err | grep -o '1[0]* %')" = "${light#*:}" ] || fail "small strains at ${light%:*} kg/m^3: $(<err)"
done
# on a terminal a long run has a bar, which goes at its end
if command -v script >/dev/null; then
    out=$(script -qec "$program run edge_drop --set time.end=2" /dev/null </dev/null)
    [[ $out == *'] '*' %, '* ]] || fail "no bar on a terminal: $out"
    out=$(script -qec "$program run edge_drop --set time.end=2 --quiet" /dev/null </dev/null)
    [ -z "$out" ] || fail "--quiet says on a terminal: $out"
fi
good run sphere --model mass_spring --set time.end=0.5 --quiet
[ ! -s err ] || fail "words for nobody: $(<err)"

# --- probes -----------------------------------------------------------------------------
good run edge_drop "${short[@]}" --probe 1,0.5,0.5 --probe=0.3,0.7,1
[ ! -s err ] || fail "--quiet says $(<err)"
[ "$(wc -l <out)" -eq $((1 + 2 * 11)) ] || fail "probe lines: $(wc -l <out)"
[ "$(head -n 1 out)" = t,u,v,w,x,y,z ] || fail "probe header: $(head -n 1 out)"
tail -n +2 out | grep -Evq '^([-+.e0-9]+,){6}[-+.e0-9]+$' && fail 'probe lines do not parse'
# each number in its column: at rest where the scene has it, its own point in each row, a
# frame for both; the free edge falls
awk -F, 'function wrong() { print "line " NR ": " $0; bad = 1 }
    NR == 1 { next }
    { u = NR % 2 ? 0.3 : 1; v = NR % 2 ? 0.7 : 0.5; w = NR % 2 ? 1 : 0.5 }
    ($1 - 0.005 * int((NR - 2) / 2))^2 > 1e-24 || $2 != u || $3 != v || $4 != w { wrong() }
    NR < 4 && ($5 - u)^2 + ($6 - v)^2 + ($7 - 0.001177 * (w - 0.5))^2 > 1e-24 { wrong() }
    NR == 22 && !($7 < -0.002 && $7 > -0.005 && $6 > 0.49 && $6 < 0.51) { wrong() }
    END { exit bad }' out || fail 'probe columns'
# 17 digits: every number comes back as it is when printed again from its double
tail -n +2 out | tr , '\n' | while read -r number; do
    [ "$(LC_ALL=C awk -v x="$number" 'BEGIN { printf "%.17g", x }')" = "$number" ] || exit 1
done || fail 'a number does not come back as it was'
grep -Eq '[0-9]\.[0-9]{15}' out || fail 'no number with 16 digits'
mv out first
good run edge_drop "${short[@]}" --probe 1,0.5,0.5 --probe 0.3,0.7,1
cmp first out || fail 'the same run gives other numbers'

# --- statics and modes ------------------------------------------------------------------
good run cantilever --static --quiet --format csv
grep -q '^1,0.5,0.5,' out || fail "--static --format csv prints $(<out)"
good run cantilever --static --quiet --format json
python3 -c 'import json, sys
table = json.load(sys.stdin)
tip = table["rows"][7]
assert (tip["u"], tip["v"]) == (1, 0.5) and tip["dz_m"] < 0, tip
assert table["units"]["dz_m"] == "m"' <out || fail "--format json prints $(<out)"
good run cantilever --static --quiet --format latex
has out '\begin{tabular}' '\end{table}'
good run cantilever --static --quiet --probe 1,0.5,0.5
[ "$(wc -l <out)" -eq 2 ] || fail "--static --probe prints $(<out)"
good run cantilever --modes 3 --quiet --format csv
[ "$(grep -c '^[1-9]' out)" -eq 3 ] || fail "--modes 3 prints $(<out)"
# pulled down along its plane it falls over, above some weight
for gravity in 9.81:1 1:0; do
    good run cantilever --model shell --static --modes 2 --set "gravity=[0,-${gravity%:*},0]" --quiet
    [ "$(grep -c '^ .* unstable ' out)" -eq "${gravity#*:}" ] || fail "stability at ${gravity%:*} m/s^2: $(<out)"
done

# --- files ------------------------------------------------------------------------------
good run edge_drop "${short[@]}" --out kept.h5 --matrices matrices
[ -s kept.h5 ] || fail '--out: no file'
[ -s kept.xdmf ] || fail '--out: no XDMF'
[ "$(head -c 520 kept.h5 | tail -c 7 | head -c 3)" = HDF ] || fail 'kept.h5 is no HDF5 file'
head -n 1 kept.h5 | grep -qa 'clothbench result file, sealed' || fail 'kept.h5 has no seal'
for name in K M; do
    grep -q '^%%MatrixMarket matrix coordinate real symmetric' matrices/$name.mtx ||
        fail "$name.mtx: no header"
    grep -q '^600 600 ' matrices/$name.mtx || fail "$name.mtx: not 600 x 600"
done
times() { # FILE.xdmf: the times of its frames [s]
    sed -n 's/^<Time Value="\(.*\)".*/\1/p' "$1" | awk '{ printf "%s%g", n++ ? " " : "", $1 }'
}
good run edge_drop "${short[@]}" --out some.h5 --every 4
[ "$(times some.xdmf)" = '0 0.02 0.04 0.05' ] || fail "--every 4 keeps $(times some.xdmf)"
good run edge_drop "${short[@]}" --out some.h5 --every 5
[ "$(times some.xdmf)" = '0 0.025 0.05' ] || fail "--every 5 keeps $(times some.xdmf)"
coarse=("${short[@]}" --set 'discretization.points=[4,4,2]')
good run edge_drop "${coarse[@]}" --matrices matrices # the folder may be there
good run hinge "${coarse[@]}" --set 'supports=[]' --matrices hinged
for words in '--out missing/kept.h5' '--matrices missing/matrices' '--matrices kept.h5'; do
    # shellcheck disable=SC2086 # words
    ends 1 run edge_drop "${short[@]}" $words
    has err "${words#* }"
done
[ -z "$(find . -name '*.tmp*' -o -name '.*kept*')" ] || fail "left behind: $(ls -A)"

# --- death ------------------------------------------------------------------------------
# Ren et al. 2024, Table 4 row 7: E = 5e4, rho = 0.1, mu = 0.9
row7=(--model iga_paper --set material.young=5e4 --set material.density=0.1 --set damping.value=0.9
    --quiet)
ends 1 run edge_drop "${row7[@]}" --probe 1,0.5,0.5 --out dead.h5
[ "$(wc -l <err)" -eq 1 ] || fail "a dead run says more than one line: $(<err)"
has err '0.265 s'
[ "$(wc -l <out)" -gt 40 ] || fail 'a dead run: its life is not printed'
[ -s dead.h5 ] || fail 'a dead run: nothing is kept'
last=$(times dead.xdmf | awk '{ print $NF }')
ends 1 run edge_drop "${row7[@]}" --out dead.h5 --every 1000
[ "$(times dead.xdmf)" = "0 $last" ] ||
    fail "a dead run, --every 1000: keeps $(times dead.xdmf), want 0 and $last"

# --- nobody listens ---------------------------------------------------------------------
"$program" run edge_drop --quiet --probe 1,0.5,0.5 2>err | head -n 1 >/dev/null
code=${PIPESTATUS[0]}
{ [ "$code" -eq 1 ] && [ -s err ]; } || fail "closed pipe: exit $code, want 1 and a sentence"
if [ -w /dev/full ]; then
    for words in 'list models' 'help' 'run edge_drop --quiet --probe 1,0.5,0.5' \
        'run cantilever --static --quiet'; do
        # shellcheck disable=SC2086 # words
        "$program" $words >/dev/full 2>err
        code=$?
        { [ "$code" -eq 1 ] && [ -s err ]; } || fail "$words >/dev/full: exit $code, want 1 and a sentence"
    done
fi
"$program" list models >&- 2>err
[ $? -eq 1 ] || fail 'list to a closed output: not exit 1'

[ "$failures" -eq 0 ]
