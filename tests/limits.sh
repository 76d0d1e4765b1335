#!/usr/bin/env bash
# What is no file, cannot be read or is too much; limits of the machine; names with control
# characters: a sentence and an exit code each, never a signal, never a wait.
#   limits.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
scene=$2/models/scenes/edge_drop.yaml
own_folder

# CODE TEXT COMMAND...: ends at once with the code; the last line it says has TEXT.
ends() {
    local want=$1 text=$2 code said
    shift 2
    timeout 60 "$@" >out 2>err </dev/null
    code=$?
    said=$(tail -n 1 err)
    [ "$code" -eq "$want" ] || fail "$*: exit $code, want $want: $said"
    [[ $said == *"$text"* ]] || fail "$*: '$text' is not in: $said"
    LC_ALL=C grep -q '[[:cntrl:]]' err && fail "$*: control characters in: $said"
    [ -z "$(find . -name '*.part')" ] || fail "$*: leaves $(find . -name '*.part')"
}

# --- what is given as a file --------------------------------------------------------------
mkfifo pipe.yaml
mkdir folder.yaml
cp "$scene" secret.yaml
chmod 000 secret.yaml
truncate -s 1G large.yaml # a hole: it takes no room
ln -s loop.yaml loop.yaml
printf 'name: a\0b\n' >nul.yaml
: >empty.yaml
while IFS='|' read -r file text; do
    [ "$file" = secret.yaml ] && [ -r secret.yaml ] && continue # root may read all
    for command in run compare truth; do
        ends 2 "$text" "$program" $command "$file"
    done
    ends 2 "$text" "$program" sweep "$file" --out sweep
    [ ! -e sweep ] || fail "sweep $file: makes a folder"
done <<'FILES'
pipe.yaml|it is a pipe
folder.yaml|it is a directory
secret.yaml|Permission denied
large.yaml|longer than 1048576 bytes
loop.yaml|Too many levels of symbolic links
none.yaml|No such file
nul.yaml|byte 0x00
empty.yaml|empty
FILES

# Folders that are read, and gone on with, may have pipes in them: nobody waits for one.
plan=$(dirname "$scene")/../../bench/plans/feasibility.yaml
mkdir waits && mkfifo waits/lock
ends 1 lock "$program" sweep "$plan" --out waits
rm waits/lock && mkfifo waits/table.csv waits/case_000001.xdmf && ln -s ../empty.yaml waits/case_000001.h5
printf '%s\n' 'name: p' 'source: s' 'scene: edge_drop' 'model: triangles' 'settings: {time.end: 0.01}' \
    'axes: {level: {one: {discretization.points: [4,4]}}}' >plan.yaml
ends 0 '' "$program" sweep plan.yaml --out waits
if [ ! -f waits/table.csv ] || [ -s empty.yaml ]; then fail 'a sweep writes into a pipe, or through a link'; fi
mkfifo waits/p.csv && ln -s ../empty.yaml waits/p_one.h5
echo 'times: [0.01]' >>plan.yaml
ends 0 '' "$program" study plan.yaml --out waits
if [ ! -f waits/p.csv ] || [ -s empty.yaml ]; then fail 'a study writes into a pipe, or through a link'; fi
rm -r waits
mkdir waits && mkfifo waits/table.csv waits/run.h5 waits/M.mtx
ends 0 '' "$program" run edge_drop --static --matrices waits --quiet --set 'discretization.points=[4,4,2]'
[ -f waits/M.mtx ] || fail 'run writes a matrix into a pipe'
timeout 60 "$program" report waits >out 2>err </dev/null
[ $? -lt 124 ] || fail 'report waits for a pipe'
for command in score export; do
    timeout 60 "$program" $command waits/run.h5 >out 2>err </dev/null
    [ $? -lt 124 ] || fail "$command waits for a pipe"
done
rm -r waits

# line ends and marks of other systems are read as ours are
sed 's/$/\r/' "$scene" >crlf.yaml
{ printf '\xef\xbb\xbf' && cat "$scene"; } >bom.yaml
for file in crlf bom; do
    ends 0 '' "$program" run $file.yaml --quiet --set time.end=0.01
done

# names that a terminal obeys are refused; keys of a scene and of a plan
for name in 'a\nb' 'a\e[2J' 'a\x9b2J' 'a\u0007'; do
    { printf '%s\n' "name: \"$name\"" && grep -v '^name:' "$scene"; } >name.yaml
    ends 2 'name is' "$program" run name.yaml
    printf 'name: p\nsource: s\nscene: edge_drop\naxes: {a: {"%s": {}}}\n' "$name" >plan.yaml
    ends 2 'plan.yaml:4: a label is' "$program" sweep plan.yaml --out sweep
done

# --- what people write otherwise, or meant ------------------------------------------------
while IFS='|' read -r text setting; do
    ends 2 "$text" "$program" run edge_drop --set "$setting"
done <<'SETTINGS'
decimals stand after a point|time.end=0,5
decimals stand after a point|time={step: 0,005, end: 1}
decimals stand after a point|gravity=[0, 0, -9,81]
numbers stand without their unit|sheet.length=30cm
numbers stand without their unit|gravity=[0, 0, 9.81 m]
its minus sign is not '-'|gravity=[0, 0, −9.81]
gravity holds '−9.81', but must|gravity=[0, 0, −9.81]
what follows a decimal comma|material={young: 1,5e5, poisson: 0.3, density: 0.5}
did you mean 'young'?|material.E=1e5
did you mean 'poisson'?|material.nu=0.3
did you mean 'step'?|time.dt=0.01
SETTINGS
ends 2 'decimals stand after a point' "$program" advise edge_drop --error 0,5%
ends 2 "no scene 'edge_dorp'; did you mean 'edge_drop'?" "$program" run edge_dorp
ends 2 "did you mean '--model'?" "$program" run edge_drop --modle iga
ends 2 "did you mean 'shell_linear'?" "$program" run edge_drop --model shell_liner
ends 2 'these models have it: iga, shell' "$program" run drape --model triangles
ends 2 "there is no check 'navire'; did you mean 'navier'?" "$program" verify navire
ends 2 "there is no command 'swep'; did you mean 'sweep'?" "$program" swep
for command in 'run edge_drop' 'truth free_fall'; do
    # shellcheck disable=SC2086 # words
    ends 2 'a name with .h5 would be right' "$program" $command --out drop.csv
done
[ ! -e drop.csv ] || fail 'a refused name is left behind'

# --- what is written ----------------------------------------------------------------------
short=(run edge_drop --quiet --set time.end=0.02)
ends 1 'cannot be a device' "$program" "${short[@]}" --out /dev/full
ends 1 'File too large' bash -c 'ulimit -f 8 && exec "$@"' - "$program" "${short[@]}" \
    --out big.h5
[ ! -e big.h5 ] || fail 'a file that is too large is left behind'
ends 1 'none/a.h5: cannot be created' timeout 10 "$program" truth edge_drop --out none/a.h5
for out in none/a.h5 '' "$(printf '%0300d' 0).h5"; do
    ends 1 '' "$program" "${short[@]}" --out "$out"
    [ -s err ] || fail "--out '$out' says nothing"
done

# --- the machine --------------------------------------------------------------------------
for threads in 99999 none 0 -1 2,x; do
    ends 2 "OMP_NUM_THREADS=$threads: a number from 1 to 1024" \
        env OMP_NUM_THREADS=$threads "$program" help
done
ends 0 '' env OMP_NUM_THREADS=2,1 "$program" help
# memory that is short from the start: whatever is left, the program says so or does it
export OPENBLAS_NUM_THREADS=2 # of which the library would wait for what it cannot have
unset OPENBLAS_CORETYPE
emulated=${QEMU_LD_PREFIX-} # it takes more memory for itself; /proc/cpuinfo is not its CPU's
nm -D "$program" | grep __asan_init >/dev/null || [ "$emulated" ] || for limit in $(seq 70000 8000 180000); do
    timeout 20 bash -c "ulimit -v $limit && exec \"\$@\"" - "$program" help >out 2>err
    code=$?
    case $code in
    0) [ -s out ] || fail "ulimit -v $limit: prints nothing" ;;
    127) grep -qE 'failed to map|cannot allocate TLS|Cannot allocate memory' err || fail "ulimit -v $limit: $(<err)" ;; # the loader
    1) grep -qi memory err || fail "ulimit -v $limit: $(<err)" ;; # or a library as it starts
    139) grep -q 'GnuTLS init' err || fail "ulimit -v $limit: $(<err)" ;; # it dies before main
    *) fail "ulimit -v $limit: exit $code: $(<err)" ;;
    esac
done
# one thread of BLAS, and the kernel that is the fastest here, unless told otherwise
kernel=$(awk '/^flags/ { wide = / avx512f / && / avx512vl / && / avx512dq / && / avx512bw /
    print wide ? "SkylakeX" : / avx2 / && / fma / ? "Haswell" : ""; exit }' /proc/cpuinfo)
[ -z "$emulated" ] || kernel=
"$program" version >out
grep -q "^blas_kernel .*$kernel" out || fail "not the kernel $kernel"
grep -q '^blas_threads *1$' out || fail 'more than one thread of BLAS'
OPENBLAS_CORETYPE=NEHALEM "$program" version >out
[ -z "$kernel" ] || grep -q '^blas_kernel *Nehalem' out || fail 'another kernel than it was told'
[ "$failures" -eq 0 ]
