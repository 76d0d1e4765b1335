#!/usr/bin/env bash
# `mpirun -n 4 clothbench sweep` gives the table of a single process, bit for bit; all ranks
# work; what is wrong is said once. Skipped (77) without mpirun or without clothbench_mpi.so.
#   sweep_mpi.sh PROGRAM FOLDER TOY        TOY: clothbench_toy, with tests/odd_model.c
program=$1
folder=$2
toy=$3
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"
command -v mpirun >/dev/null && [ -e "$(dirname "$program")/clothbench_mpi.so" ] || exit 77
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export ASAN_OPTIONS=detect_leaks=0 # of MPI itself

ranks() { # N ARGUMENT...
    local count=$1
    shift
    mpirun --oversubscribe -n "$count" "$program" sweep "$@" </dev/null
}

write_plan plan.yaml 3
sweep plan.yaml --out single --jobs 1 --quiet || fail "alone: exit $?"
ranks 4 plan.yaml --out four >out 2>err || fail "four ranks: exit $?: $(<err)"
grep -q '36 cases run now, 4 at a time' out || fail "four ranks: $(<out)"
cmp single/table.csv four/table.csv || fail 'four ranks give another table'

# a case that is killed, one that crashes and one that is refused, on whatever rank
cat >rows.yaml <<'PLAN'
name: rows
source: a test
scene: edge_drop
axes:
  case:
    killed: {model: odd, material.density: 7}
    crashes: {model: odd, material.density: 5}
    refused: {discretization.degree: [5,2,1], discretization.points: [5,5,2]}
    fine: {time.end: 0.02}
    fine_2: {time.end: 0.03}
PLAN
mkdir bin
cp "$toy" "$(dirname "$program")/clothbench_mpi.so" bin/
toy=$PWD/bin/clothbench_toy
with_toy() { # FUNCTION ARGUMENT...
    program=$toy "$@"
}
with_toy ranks 4 rows.yaml --out rows --quiet 2>err || fail "rows: exit $?: $(<err)"
with_toy sweep rows.yaml --out rows_single --jobs 1 --quiet || fail "rows alone: exit $?"
cmp rows/table.csv rows_single/table.csv || fail 'rows without result are others'
grep -q 'run again,"killed by signal 9' rows/table.csv || fail "$(<rows/table.csv)"

# a plan that is wrong is refused once, not by every rank
sed 's/poisson/poison/' plan.yaml >wrong.yaml
ranks 3 wrong.yaml 2>err && fail 'a wrong plan runs'
[ "$(grep -c '^clothbench: wrong.yaml:' err)" -eq 1 ] || fail "a wrong plan: $(<err)"
ranks 2 plan.yaml --out jobs --jobs 2 2>err && fail '--jobs under mpirun'
grep -q 'say how many with mpirun -n' err || fail "--jobs: $(<err)"

# all ranks killed at once in the middle, then resumed with other numbers of them: cases
# long enough that the middle is not over before it is seen
write_plan plan.yaml 3
sed -i 's/time.end: .*/time.end: 1/' plan.yaml
sweep plan.yaml --out alone --quiet || fail "longer cases alone: exit $?"
setsid mpirun --oversubscribe -n 3 "$program" sweep plan.yaml --out killed --quiet \
    </dev/null >/dev/null 2>&1 &
group=$!
for ((i = 0; i < 1000; i++)); do
    [ "$(find killed -name '*.h5' 2>/dev/null | wc -l)" -ge 8 ] && break
    sleep 0.01
done
kill -TERM "$group"
wait "$group" 2>/dev/null
[ ! -e killed/table.csv ] || fail 'it was not stopped'
stat -c '%n %i' killed/case_*.h5 | sort >ids
ranks 2 plan.yaml --out killed --quiet 2>err || fail "resumed: exit $?: $(<err)"
cmp alone/table.csv killed/table.csv || fail 'another table after being stopped'
stat -c '%n %i' killed/case_*.h5 | sort | comm -13 - ids | grep . &&
    fail 'a case that had ended is run again'
[ "$failures" -eq 0 ]
