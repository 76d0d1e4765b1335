#!/usr/bin/env bash
# What `clothbench sweep` promises: the same bits for any number of jobs; cases that die or are
# refused are rows; a disk that is full, a signal, another sweep in the folder are sentences, and
# resuming goes on. (sweep_ends.sh: how cases end; files that are damaged, or not the sweep's.)
#   sweep.sh PROGRAM FOLDER TOY        TOY: clothbench_toy, with tests/odd_model.c
program=$1
folder=$2
toy=$3
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"
count=0

ends() { # CODE: the last run ended so, and said why
    [ "$code" -eq "$1" ] || fail "exit $code, want $1: $(<err)"
    [ "$(wc -l <err)" -eq 1 ] || fail "not one line: $(<err)"
}

# --- the plan that help shows -----------------------------------------------------------
"$program" help sweep | sed -n '/^    name: /,/^$/p' >shown.yaml
run shown.yaml --out shown
[ "$code" -eq 0 ] || fail "the plan of help sweep: exit $code: $(<err)"
[ "$(grep -c "done" shown/table.csv)" -eq 6 ] || fail "the plan of help sweep: $(<shown/table.csv)"

# --- jobs -------------------------------------------------------------------------------
write_plan plan.yaml 2
run plan.yaml --out one --jobs 1
[ "$code" -eq 0 ] || fail "exit $code: $(<err)"
run plan.yaml --out three --jobs 3 --quiet
{ [ "$code" -eq 0 ] && [ ! -s out ]; } || fail "--quiet says $(<out)"
cmp one/table.csv three/table.csv || fail 'the table depends on the number of jobs'
run plan.yaml --out three
grep -q 'Nothing was left to run' out || fail "a finished sweep runs again: $(<out)"
cmp one/table.csv three/table.csv || fail 'the table changes when made again'
# the first axis changes slowest, the last fastest
for damping in 0.1 0.9; do
    for gamma in 10 100 1000 1e4; do
        for poisson in 0 0.3 0.45; do echo "$((++count)),$damping,$gamma,$poisson"; done
    done
done >order
sed 's/"[^"]*"/quoted/g' one/table.csv |
    awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        NR > 1 { print $1, $column["damping.value"], $column["gamma"],
                 $column["material.poisson"] }' | cmp - order || fail 'rows are out of order'
# Gamma of a row is what was asked for
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
         NR > 1 { gsub(/"[^"]*"/, "quoted")
                  off = $column["gamma_measured"] / $column["gamma"] - 1
                  if (off > 1e-14 || off < -1e-14) { print; exit 1 } }' \
    one/table.csv || fail 'gamma is not what the plan asks for'

# --- the folder -------------------------------------------------------------------------
sed 's/scene: edge_drop/scene: .\/here.yaml/' plan.yaml >here_plan.yaml
cp "$source_folder/models/scenes/edge_drop.yaml" here.yaml
run here_plan.yaml --out here --quiet
[ "$code" -eq 0 ] || fail "a scene beside the plan: $(<err)"
sed -i 's/density: .*}/density: 0.6}/' here.yaml
run here_plan.yaml --out here
grep -q '^24 cases run now' out || fail "another scene: $(<out)"
run plan.yaml --out plan.yaml
ends 1

# --- rows that are no runs --------------------------------------------------------------
cat >rows.yaml <<'PLAN'
name: rows
source: a test
settings: {discretization.kinematics: printed}
axes:
  case:
    fine: {scene: edge_drop, time.end: 0.02}
    dies: {scene: edge_drop, time.end: 0.5, material.young: 5e4,
      material.density: 0.1, damping.value: 0.9}
    refused: {scene: edge_drop, discretization.degree: [5,2,1],
      discretization.points: [5,5,2]}
    unsupported: {scene: edge_drop, model: mass_spring,
      discretization.kinematics: nonlinear, "supports": [{at: {u: 0, w: 0}, fix: xyz}]}
intersections: true
verdicts:
  - {label: chaotic, measure: blowup_time, below: 1e9, why: it died}
  - {label: penetration, measure: intersections_max, above: 0, why: matter}
PLAN
run rows.yaml --out rows
[ "$code" -eq 0 ] || fail "rows: exit $code: $(<err)"
row() { # NAME TEXT
    grep -q "^[0-9]*,$1,.*$2" rows/table.csv || fail "$1: $(grep ",$1," rows/table.csv)"
}
row fine 'feasible,feasible,'
row dies 'infeasible,"chaotic, penetration",.* 0.265 s'
row refused 'none,no result,'
row unsupported 'none,unsupported,'
# --- distances to the truth ---------------------------------------------------------------
cat >true.yaml <<'PLAN'
name: true
source: a test
scene: strip_swing
settings: {time.end: 0.25}
axes:
  model: [mass_spring_leapfrog, triangles]
  discretization.points: [[6, 6], [11, 11]]
look: 20
PLAN
run true.yaml --out true
{ [ "$code" -eq 0 ] && [ ! -s err ]; } || fail "a truth: exit $code: $(<err)"
truths() { # FOLDER: error and bar at the end, of each case
    sed 's/"[^"]*"/quoted/g' "$1/table.csv" |
        awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
            NR > 1 { print $column["truth_error_end"] "," $column["truth_bar_end"] }'
}
# of the looks at 0.1, 0.2 and 0.25 s the truth has the first two; the bar is that at 0.2 s
bar=$("$program" truth strip_swing --stored --format csv | awk -F, '/^#/ { next }
    !names { for (i = 1; i <= NF; i++) column[$i] = i; names = 1; next }
    $1 - 0.2 < 1e-9 && 0.2 - $1 < 1e-9 { print $column["error_bar_over_length"] }')
truths true | awk -F, -v bar="$bar" '{ off = $2 / bar - 1
    if (off > 1e-6 || off < -1e-6 || $1 <= 0 || $1 > 0.05 || NR % 2 == 0 && $1 > coarse) exit 1
    coarse = $1 } END { if (NR != 4) exit 1 }' || fail "the bar of strip_swing is $bar: $(truths true)"
# other physics, and velocities that are scaled each step, have no truth
for other in 'material.young: 2e5' 'damping: {kind: velocity_scale, value: 0.5}'; do
    sed "s/{time.end/{$other, time.end/" true.yaml >other.yaml
    run other.yaml --out "other_${other%%[:.]*}"
    [ "$code" -eq 0 ] || fail "$other: exit $code: $(<err)"
    [ "$(truths "other_${other%%[:.]*}" | sort -u)" = , ] || fail "$other: $(truths "other_${other%%[:.]*}")"
done

# --- names are words ----------------------------------------------------------------------
# whatever a case is called, it is one cell of the table
cat >names.yaml <<'PLAN'
name: names
source: a test
scene: edge_drop
settings: {time.end: 0.01, discretization.points: [4,4,2]}
axes:
  case:
    "it's \"a\"'; system('touch pwned'); set title '": {}
    "EOD system('touch pwned') `touch pwned` %s $x {a} \\": {}
  damping.value: [0.1, 0.9]
  gamma: [10, 100]
PLAN
run names.yaml --out names
{ [ "$code" -eq 0 ] && [ ! -s err ]; } || fail "names: exit $code: $(<err)"
[ -z "$(find . -name pwned)" ] || fail 'a name ran as a command'
grep -qF "1,\"it's \"\"a\"\"" names/table.csv || fail "names: $(<names/table.csv)"

# --- signals ----------------------------------------------------------------------------
# Ctrl-C stops the sweep with a sentence, and no child is left.
cat >long.yaml <<'PLAN'
name: long
source: a test
scene: edge_drop
model: odd
settings: {material.density: 4} # hangs
axes: {damping.value: [0.1, 0.2]}
time_limit: 1e6
PLAN
children() {
    ps -o pid= --ppid "$1"
}
begin_long() { # fills $leader and ${cases[@]}
    "$toy" sweep long.yaml --out long --jobs 2 >out 2>err </dev/null &
    leader=$!
    for ((i = 0; i < 500; i++)); do
        mapfile -t cases < <(children "$leader")
        [ "${#cases[@]}" -eq 2 ] && return
        sleep 0.02
    done
    fail 'the cases do not start'
}
gone() { # PROCESS
    for ((i = 0; i < 500; i++)); do
        kill -0 "$1" 2>/dev/null || return 0
        sleep 0.02
    done
    return 1
}
begin_long
kill -KILL "${cases[0]}"
for ((i = 0; i < 500; i++)); do
    [ -s long/case_000001.h5 ] || [ -s long/case_000002.h5 ] && break
    sleep 0.02
done
grep -hq 'killed by signal 9' long/case_00000?.h5 || fail 'a case that was killed is no row'
kill -TERM "$leader" # SIGINT is ignored in the background
wait "$leader" 2>/dev/null
[ $? -eq $((128 + 15)) ] || fail 'a signal does not end it as a signal does'
[ -s err ] || fail 'SIGTERM: nothing is said'
gone "${cases[1]}" || fail 'a child outlives SIGTERM'
[ -z "$(find long -name '*.part')" ] || fail 'SIGTERM leaves half a file'
[ ! -e long/table.csv ] || fail 'SIGTERM: a table of half the cases'
# two sweeps in one folder; the leader alone is killed
rm -r long
begin_long
"$toy" sweep long.yaml --out long >out 2>err </dev/null
code=$?
ends 1
kill -KILL "$leader"
wait "$leader" 2>/dev/null
{ gone "${cases[0]}" && gone "${cases[1]}"; } || fail 'a child outlives its leader'

# --- full disk --------------------------------------------------------------------------
# kB a file: a case does not fit
(ulimit -f 12 && exec "$program" sweep plan.yaml --out full --jobs 2 >out 2>err </dev/null)
code=$?
ends 1
[ -z "$(find full -name '*.part' -o -name '*.h5')" ] || fail "left: $(ls full)"
run plan.yaml --out full --quiet
[ "$code" -eq 0 ] || fail "after a full disk: exit $code: $(<err)"
cmp one/table.csv full/table.csv || fail 'the table is another after a full disk'
mkdir small
if mount -t tmpfs -o size=300k none small 2>/dev/null; then
    run plan.yaml --out small/full --jobs 2
    ends 1
    [ -n "$(find small -name '*.h5')" ] || fail 'nothing was kept before the disk was full'
    mount -o remount,size=4m small
    run plan.yaml --out small/full --quiet
    [ "$code" -eq 0 ] || fail "with room again: exit $code: $(<err)"
    cmp one/table.csv small/full/table.csv || fail 'the table is another with room again'
    umount small
fi
[ "$failures" -eq 0 ]
