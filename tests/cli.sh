#!/usr/bin/env bash
# The program as a user meets it: what it prints where, and how it ends.
#   cli.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
blunt=$2/tests/truths
readme=("$2/README.md" "$2"/doc/*.md)
own_folder

run() { # ARGUMENT...; fills $code, $out and $err
    "$program" "$@" >out 2>err </dev/null
    code=$?
    out=$(<out)
    err=$(<err)
}

# Bad usage: exit 2, nothing on standard output, one sentence that has TEXT.
refused() { # TEXT ARGUMENT...
    local text=$1
    shift
    run "$@"
    [ "$code" -eq 2 ] || fail "$*: exit $code, want 2"
    [ -z "$out" ] || fail "$*: prints $out"
    [ "$(wc -l <err)" -eq 1 ] || fail "$*: not one line: $err"
    [[ $err == clothbench:* && $err == *"$text"* ]] || fail "$*: '$text' is not in: $err"
}

good() { # ARGUMENT...
    run "$@"
    [ "$code" -eq 0 ] || fail "$*: exit $code: $err"
}

says() { # WHAT TEXT...; each is in $WHAT
    local what=$1 text
    shift
    for text in "$@"; do
        [[ ${!what} == *"$text"* ]] || fail "'$text' is not in $what: ${!what}"
    done
}

short=(--set time.end=0.05 --quiet)

# --- help -------------------------------------------------------------------------------
good help
says out 'usage: clothbench' list run Examples
overview=$out
good --help
[ "$out" = "$overview" ] || fail '--help is not help'
sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p' out | grep -Ev '^(help|version)$' >commands
[ -s commands ] || fail 'help lists no commands'
while read -r command; do
    good help "$command"
    says out "usage: clothbench $command" Examples
    help=$out
    good "$command" --help
    [ "$out" = "$help" ] || fail "$command --help is not help $command"
    grep -o '^  --[a-z]*' out >>options
done <commands
# the pages use no other options
grep -h '^    build/clothbench' "${readme[@]}" | grep -o ' --[a-z]*' | sort -u | while read -r option; do
    grep -qx -- "  $option" options || exit 1
done || fail 'a page has an option that help has not'
good run edge_drop --model hex --help
says out --static --modes --probe --matrices --out --set
good version
says out 'clothbench 1' compiler blas_kernel
good --version
good help version
good help help
good help scene
says out material.young discretization.points supports
good help plan
says out 'axes[i].values' time_limit 'map.marks' stretch_max gamma

# --- list -------------------------------------------------------------------------------
# empty files stand before the stored truths, which take a second to read
mkdir light
for truth in "$2"/bench/truths/*.h5; do : >"light/${truth##*/}"; done
CLOTHBENCH_TRUTHS=light good list
says out scenes: models: edge_drop 'Ren et al. 2024'
good list models
says out iga hex shell mass_spring projective_dynamics
good list contestants
says out 'iga_paper ' 'compare; stress; bench' 'verify bending far'
good run edge_drop "${short[@]}" --model iga_linear
good run cantilever --model iga_nonlinear --static
says err 'kinematics nonlinear'
good list scenes
names=$(cut -d' ' -f1 <<<"$out")
[ "$(wc -w <<<"$names")" -ge 9 ] || fail "few scenes: $names"
for name in $names; do
    good run "$name" "${short[@]}" --set 'discretization.points=[6,6,2]'
    [ -z "$out$err" ] || fail "run $name --quiet says $out$err"
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
    END { exit wrong || rows < 4 }' out || fail "columns of a truth: $out"
sed 's/^name:.*/name: mine/' "$2/models/scenes/edge_drop.yaml" >mine.yaml
refused "no truth 'mine'" truth mine.yaml --stored
refused 'corners_drop has no truth: support 0 holds a point' truth corners_drop --stored
good truth corners_patch --stored
says out 'All of it is claimed.' 'Made at commit'
export CLOTHBENCH_TRUTHS=$blunt # truths that end within what is stored
good truth flag --stored
says out 'Nothing is claimed from 0.4 s on: the error bar there, ' ' %, is above 5 %.'
grep -q '^0.400 .* no claim' out || fail "truth flag claims 0.4 s: $out"
mkdir nets
refused 'has 0 of three nets of frames' truth strip_swing --third nets --out third.h5
[ ! -e third ] || fail 'a third that is refused leaves a folder'
good truth sphere --stored
says out 'Nothing is claimed from 0.3 s on: the growth there, ' ', is above 1000.'
unset CLOTHBENCH_TRUTHS
refused 'of other physics: material 100000 0.3 0.5, not material 1000000 0.3 0.5' \
    truth edge_drop --stored --set material.young=1e6
refused 'support 0 holds a point' truth corners_drop --error 1%
refused '--error: below 5%' truth edge_drop --error 5%
refused '--error 0: a number above 0' truth edge_drop --error 0
refused 'one of the two' truth edge_drop --error 1% --quick
refused 'one of the two' truth edge_drop --error 1% --store --out t.h5
refused '--budget -1' truth edge_drop --error 1% --budget -1
refused '--until 0.01: a frame is 0.02 s' truth stiff --error 1% --until 0.01 --runs t --out t.h5
# a budget that holds no more than the first runs: a truth as it is, no, and until when it would do
run truth stiff --error 0.0001% --until 0.04 --budget 1e-6 --runs t --out t.h5
[ "$code" -eq 1 ] || fail "truth without a budget: exit $code: $err"
says err 'no: the bar is' 'the budget of 1e-06 s' 'known to 0.0001 % at none of its times'
says out '0.040' 'own by the difference of two'
[ "$(find t -name '*.h5' | wc -l)" -eq 5 ] || fail "its runs: $(ls t)"
cp t.h5 light
CLOTHBENCH_TRUTHS=light good list truths
says out 't  ' 'cured of locking, p = 3, 12x12'
good list studies
says out mesh
good list cases
says out thin_5 spinning_bar
refused "no case 'dance'" stress dance
refused "no model or contestant 'ibm'" stress --models ibm
refused 'one of the two' stress --out a --from b
good list checks
says out elastica

# --- verify judges nobody by a truth of other physics, and says so ---------------------------
mkdir scenes
sed 's/young: *1.0e5/young: 1.0e6/' "$2/models/scenes/edge_drop.yaml" >scenes/edge_drop.yaml
CLOTHBENCH_SCENES=$PWD/scenes good verify truths --quick \
    --models mass_spring_leapfrog --format csv
[ "$(grep -c '^"edge_drop, rms / L",' out)" = 1 ] || fail "verify truths leaves one out: $out"
grep -q '^"edge_drop, rms / L".*,not applicable,.*of other physics: material 100000 ' out ||
    fail "verify truths judges by another physics: $out"
grep -q '^"flag, rms / L at 0.1 s".*,no claim,0' out || fail "verify truths lacks the flag: $out"
mkdir truths
echo no truth >truths/flag.h5
CLOTHBENCH_TRUTHS=$PWD/truths refused truths/flag.h5 verify truths --quick --models mass_spring_leapfrog

refused "no benchmark 'dance'; there are solids" bench dance
refused 'one of the two' bench solids --from times --out more

# --- bad usage --------------------------------------------------------------------------
refused 'which command'
refused "no command 'dance'" dance
refused 'no such folder of results' report nowhere
refused "no model or contestant 'ibm'; models: iga, hex" run edge_drop --model ibm
refused "no scene 'nowhere'" run nowhere
refused 'nowhere.yaml' run nowhere.yaml
refused 'needs an argument' run
refused "'two' is one word too many" run one two
refused "'two' is one word too many" list scenes two
refused "no 'cats'" list cats
refused 'no option --dance' run edge_drop --dance
refused 'no option -x' run edge_drop -x
refused '--model needs a value' run edge_drop --model
refused '--model is given twice' run edge_drop --model iga --model iga
refused '--static takes no value' run edge_drop --static=yes
refused 'kinematics=nonlinear' run edge_drop --static --modes 3 \
    --set discretization.kinematics=linear
refused 'whole number from 1' run edge_drop --modes 0
refused 'whole number from 1' run edge_drop --modes many
refused 'modes: 1 to 540' run edge_drop --modes 541 --quiet
refused '--probe makes no sense' run edge_drop --modes 1 --probe 0,0,0
refused '--out makes no sense' run edge_drop --modes 1 --out a.h5
refused "no check 'dance'; there are elastica" verify dance
refused "no model or contestant 'ibm'" verify elastica --models iga,ibm
refused 'give one of the two' verify elastica --from a --out b
refused 'are for a new run' verify elastica --from a --quick
refused 'text, csv, markdown, latex or json' verify elastica --format html
refused 'takes no scenes' study locking flag
refused 'not for --from' study ensemble flag --from nowhere
refused 'whole number from 1 to 256' study ensemble --runs 0
refused 'above 0' study ensemble --until 0
refused "no model or contestant 'ibm'" study ensemble --models ibm
refused 'shell_3 is given twice' study ensemble edge_drop --models shell_3,shell_3
refused 'an ensemble takes 0.08 s at least' study ensemble edge_drop --models shell_3 --until 0.05
refused 'table has no option --runs' table 1 --runs 2
refused 'whole number from 1' run edge_drop --out a.h5 --every 0
refused '--every is for the frames' run edge_drop --every 2
refused '--every is for the frames' run edge_drop --static --out a.h5 --every 2
refused 'is for the tables' run edge_drop --format csv
refused 'text, csv, markdown, latex or json' run edge_drop --static --format html
for point in 1 1,1 1,1,1,1 1,1,x 1,1,1.5 -1,0,0 nan,0,0 ',,' '' '1,1,1 '; do
    refused 'must be u,v,w' run edge_drop --probe "$point"
done
refused "no key 'wind_speed'" run edge_drop --set wind_speed=3
refused 'young' run edge_drop --set material.young=-1
refused 'points' run edge_drop --set 'discretization.points=[10000,10000,2]'
refused 'degree' run edge_drop --set 'discretization.degree=[5,2,1]' \
    --set 'discretization.points=[5,5,2]'
refused 'integrator=momentum: projective_dynamics has implicit, bdf2' run edge_drop \
    --model projective_dynamics --set discretization.integrator=momentum
refused 'unsupported: no damping by stiffness' run cantilever --model projective_dynamics \
    --set 'damping={kind: rayleigh, alpha: 0, beta: 0.1}'

# --- what a run says --------------------------------------------------------------------
good run edge_drop --set time.end=0.05
[ -z "$out" ] || fail "run prints data nobody asked for: $out"
says err 'Gamma           386.6 (weight against bending: it bends far' '10 x 10 x 2' 'degree (3,3,1)' nonlinear selective 540 \
    'ms a frame' median quartiles '10 steps' 'peak memory' drop stretch roughness
[ "$(grep -c '^warning:' err)" -eq 1 ] || fail "warnings: $err"
says err 'warning: damping velocity_scale is no rate'
good run edge_drop --set time.end=0.05 --set 'damping={kind: none}'
[[ $err == *warning* ]] && fail "a warning for the defaults: $err"
[[ $err == *$'\033'* || $err == *$'\r'* ]] && fail 'a progress bar without a terminal'
[[ $err == *kappa* ]] && fail "a law of contact without contact: $err"
good run fold --model triangles_explicit --set time.end=0.005 --set discretization.points=[31,7]
says err 'contact         from 0.001 m off bodies, range 0.0005 m; from t = 0.002 m off itself' 'kappa' \
    'it rests 0.0009807 m off a body' 'lambda = 0.0066 m' 'warning: spans of'
good run edge_drop --set discretization.kinematics=linear --set time.end=0.05
says err 'warning: small-strain' 'more than 10 %' 'kinematics linear'
# rho = 2.5e-3, 4e-3, 1e-3 kg/m^3: Gamma = 1.9, 3.1, 0.77, on either side of 0.9 and of 2.9
for light in 2.5e-3:1 4e-3:10 1e-3:; do
    good run edge_drop --set discretization.kinematics=linear --set time.end=0.005 \
        --set material.density="${light%:*}"
    if [ "${light#*:}" ]; then
        says err "warning: small-strain" "more than ${light#*:} %"
    elif [[ $err == *small-strain* ]]; then
        fail "a warning at Gamma = 0.77"
    fi
done

good run sphere --model mass_spring --set time.end=0.5
[[ $err == 'Do not trust this result: an obstacle is '* ]] || fail "opens otherwise: $err"
# on a terminal a long run has a bar, which goes at its end
if command -v script >/dev/null; then
    out=$(script -qec "$program run edge_drop --set time.end=2" /dev/null </dev/null)
    says out '] ' ' %, ' ' s left'
    out=$(script -qec "$program run edge_drop --set time.end=2 --quiet" /dev/null </dev/null)
    [ -z "$out" ] || fail "--quiet says on a terminal: $out"
fi
good run sphere --model mass_spring --set time.end=0.5 --quiet
[ -z "$err" ] || fail "words for nobody: $err"

# --- probes -----------------------------------------------------------------------------
good run edge_drop "${short[@]}" --probe 1,0.5,0.5 --probe=0.3,0.7,1
[ -z "$err" ] || fail "--quiet says $err"
first=$out
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
[[ $out =~ [0-9]\.[0-9]{15} ]] || fail 'no number with 16 digits'
good run edge_drop "${short[@]}" --probe 1,0.5,0.5 --probe 0.3,0.7,1
[ "$out" = "$first" ] || fail 'the same run gives other numbers'

# --- statics and modes ------------------------------------------------------------------
good run cantilever --static --quiet --format csv
says out 'u,v,w,dx_m,dy_m,dz_m,deflection' '1,0.5,0.5,'
good run cantilever --static --quiet --format json
python3 -c 'import json, sys
table = json.load(sys.stdin)
tip = table["rows"][7]
assert (tip["u"], tip["v"]) == (1, 0.5) and tip["dz_m"] < 0, tip
assert table["units"]["dz_m"] == "m"' <out || fail "--format json prints $out"
good run cantilever --static --quiet --format latex
says out '\begin{tabular}' '\end{table}'
good run cantilever --static --quiet --probe 1,0.5,0.5
[ "$(wc -l <out)" -eq 2 ] || fail "--static --probe prints $out"
good run cantilever --modes 3 --quiet --format csv
[ "$(grep -c '^[1-9]' out)" -eq 3 ] || fail "--modes 3 prints $out"
says out lambda frequency 'about the rest shape'
good run cantilever --model shell --static --modes 2 --set 'gravity=[0,-9.81,0]' --quiet
says out 'about static equilibrium' unstable '1 of these modes grows'
good run cantilever --model shell --static --modes 2 --set 'gravity=[0,-1,0]' --quiet
says out 'no mode grows'

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
    grep -q 'row = 3 node' matrices/$name.mtx || fail "$name.mtx: order not told"
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
refuse_file() { # TEXT ARGUMENT...: exit 1 and a sentence
    local text=$1
    shift
    run run edge_drop "${short[@]}" "$@"
    [ "$code" -eq 1 ] || fail "$*: exit $code, want 1"
    says err "$text"
}
refused 'leave the supports out' run hinge "${short[@]}" --matrices hinged
good run hinge "${coarse[@]}" --set 'supports=[]' --matrices hinged
refuse_file 'missing/kept.h5' --out missing/kept.h5
refuse_file 'missing/matrices' --matrices missing/matrices
refuse_file 'kept.h5' --matrices kept.h5
[ -z "$(find . -name '*.tmp*' -o -name '.*kept*')" ] || fail "left behind: $(ls -A)"

# --- death ------------------------------------------------------------------------------
# Ren et al. 2024, Table 4 row 7: E = 5e4, rho = 0.1, mu = 0.9
row7=(--model iga_paper --set material.young=5e4 --set material.density=0.1 --set damping.value=0.9
    --quiet)
run run edge_drop "${row7[@]}" --probe 1,0.5,0.5 --out dead.h5
[ "$code" -eq 1 ] || fail "a dead run: exit $code, want 1"
[[ $err == *'died at t = 0.265 s: an element turned inside out (det J <= 0)' ]] || fail "a dead run says: $err"
[ "$(wc -l <err)" -eq 1 ] || fail "a dead run says more than one line: $err"
[ "$(wc -l <out)" -gt 40 ] || fail 'a dead run: its life is not printed'
[ -s dead.h5 ] || fail 'a dead run: nothing is kept'
last=$(times dead.xdmf | awk '{ print $NF }')
run run edge_drop "${row7[@]}" --out dead.h5 --every 1000
[ "$(times dead.xdmf)" = "0 $last" ] ||
    fail "a dead run, --every 1000: keeps $(times dead.xdmf), want 0 and $last"

# --- nobody listens ---------------------------------------------------------------------
"$program" run edge_drop --quiet --probe 1,0.5,0.5 2>err | head -n 1 >/dev/null
code=${PIPESTATUS[0]} err=$(<err)
[ "$code" -eq 1 ] || fail "closed pipe: exit $code, want 1"
says err 'went away'
if [ -w /dev/full ]; then
    for words in 'list models' 'help' 'run edge_drop --quiet --probe 1,0.5,0.5' \
        'run cantilever --static --quiet'; do
        # shellcheck disable=SC2086 # words
        "$program" $words >/dev/full 2>err
        code=$? err=$(<err)
        [ "$code" -eq 1 ] || fail "$words >/dev/full: exit $code, want 1"
        says err 'No space left on device'
    done
fi
"$program" list models >&- 2>err
[ $? -eq 1 ] || fail 'list to a closed output: not exit 1'

[ "$failures" -eq 0 ]
