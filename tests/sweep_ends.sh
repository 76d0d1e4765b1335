#!/usr/bin/env bash
# Every way a case can end has its verdict, and resuming a sweep comes to what it would
# have been without what happened to it from outside: kills, damaged files, other people's files.
#   sweep_ends.sh PROGRAM FOLDER        PROGRAM: clothbench_toy, with tests/odd_model.c
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"

row() { # FOLDER NAME VERDICT,LABEL[,TIME]: the row has them
    local line
    line=$(grep "^[0-9]*,$2," "$1/table.csv")
    [[ $line == *",$3"* ]] || fail "$2: want '$3': $line"
}

# --- ends ---------------------------------------------------------------------------------
cat >ends.yaml <<'PLAN'
name: ends
source: a test
scene: edge_drop
model: odd
settings: {time.end: 0.03}
axes:
  case:
    sound: {material.density: 1}
    dies: {material.density: 2}
    escapes: {material.density: 3}
    crashes: {material.density: 5}
    leaves: {material.density: 6}
    killed: {material.density: 7}
    memory: {material.density: 8}
    library: {material.density: 9}
    unsupported: {material.density: 10}
    refused: {material.density: 11}
look: 1
time_limit: 1e6
verdicts: [{label: chaotic, measure: blowup_time, below: 1e9, why: it died}]
PLAN
ODD_TAME=1 run ends.yaml --out quiet
[ "$code" -eq 0 ] || fail "exit $code: $(<err)"
run ends.yaml --out ends
[ "$code" -eq 0 ] || fail "exit $code: $(<err)"
row ends sound 'feasible,feasible,'
for name in dies escapes; do row ends $name 'infeasible,chaotic,died at t = 0.015 s'; done
for name in crashes leaves library refused; do row ends $name 'none,no result,'; done
for name in killed memory; do row ends $name 'none,run again,'; done
row ends unsupported 'none,unsupported,'
for line in 'feasible  *1' 'chaotic  *2' 'died  *2' 'unsupported  *1' 'no result  *4' 'run again  *2'; do
    grep -q "^  $line" out || fail "no '$line': $(<out)"
done
run ends.yaml --out ends
grep -q '^2 cases run now' out || fail "cut again: $(<out)"
ODD_TAME=1 run ends.yaml --out ends
grep -q '^2 cases run now' out || fail "resumed: $(<out)"
grep -q 'run again' out && fail "resumed: $(<out)"
cmp quiet/table.csv ends/table.csv || fail 'resumed, the table is another'
run ends.yaml --out ends
grep -q 'Nothing was left to run' out || fail "ended cases run again: $(<out)"

# The limit is the only end of what hangs.
sed 's/^axes:/time_limit: 0.1\naxes: {case: {a: {material.density: 4}, b: {material.density: 4}}}/
    /^  case:/d; /^    [a-z]*: {/d; /^time_limit: 1e6/d; s/name: ends/name: hangs/' ends.yaml >hangs.yaml
run hangs.yaml --out hangs
[ "$code" -eq 0 ] || fail "hangs: exit $code: $(<err)"
for name in a b; do row hangs $name 'none,no result,timed out after 0.1 s'; done
run hangs.yaml --out hangs
grep -q 'Nothing was left' out || fail 'a case that hung is run again'

# --- files that are damaged, files of another sweep ------------------------------------------
spoil() { # FILE OFFSET: another byte there
    local byte
    byte=$(od -An -tu1 -j "$2" -N 1 "$1")
    printf "%b" "\\x$(printf %02x $((byte ^ 1)))" |
        dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
damage() { # of every kind, to files of results and of sentences
    spoil ends/case_000001.h5 0
    spoil ends/case_000002.h5 2000
    spoil ends/case_000003.h5 $(($(stat -c %s ends/case_000003.h5) - 1))
    spoil ends/case_000004.h5 5
    spoil ends/case_000005.h5 $(($(stat -c %s ends/case_000005.h5) - 4))
    head -c 3000 quiet/case_000006.h5 >ends/case_000006.h5
    : >ends/case_000007.h5
    head -n 2 quiet/case_000008.h5 >ends/case_000008.h5
    rm ends/case_000009.h5
    : >ends/case_000010.h5
}
damage
ODD_TAME=1 run ends.yaml --out ends
{ [ "$code" -eq 0 ] && grep -q '^10 cases run now' out; } || fail "damaged: $(<out) $(<err)"
cmp quiet/table.csv ends/table.csv || fail 'healed, the table is another'

again() { # COUNT FOLDER PLAN: so many cases are another's and run again
    ODD_TAME=1 run "$3" --out "$2"
    grep -q "^$1 cases run now" out || fail "$2: want $1 cases again: $(<out) $(<err)"
}
cp -r quiet moved
cp moved/case_000002.h5 moved/case_000001.h5
cp moved/case_000004.h5 moved/case_000005.h5
again 2 moved ends.yaml
cmp quiet/table.csv moved/table.csv || fail 'files of other cases: the table is another'
# rules only judge, and judge again; what the cases keep makes other cases of them
sed 's/below: 1e9/below: 0.001/' ends.yaml >rules.yaml
ODD_TAME=1 run rules.yaml --out moved
{ grep -q 'Nothing was left' out && grep -q 'chaotic  *0' out; } || fail "other rules: $(<out)"
sed 's/look: 1/look: 2/' ends.yaml >other.yaml
again 10 moved other.yaml

# --- files of others --------------------------------------------------------------------------
mkdir mine outside
mine=(movie.part case_12.h5 case_000001.h5.bak case_notes.txt table.csv.part map.csvx notes.h5
    case_000001.h5.12-x.part)
theirs=(case_000001.h5.12-0.part table.csv.999-1.part case_000003.xdmf.1-0.part)
for name in "${mine[@]}" "${theirs[@]}"; do echo "$name" >"mine/$name"; done
ODD_TAME=1 run ends.yaml --out mine
[ "$code" -eq 0 ] || fail "among others: exit $code: $(<err)"
for name in "${mine[@]}"; do
    [ "$(cat "mine/$name" 2>&1)" = "$name" ] || fail "mine/$name was touched"
done
for name in "${theirs[@]}"; do
    [ ! -e "mine/$name" ] || fail "mine/$name was left"
done
cut -d, -f 2- mine/table.csv | cmp - <(cut -d, -f 2- quiet/table.csv) || fail 'another table'
rm mine/lock
echo outside >outside/lock
ln -s ../outside/lock mine/lock
run ends.yaml --out mine
[ "$code" -eq 1 ] || fail "a link as lock: exit $code"
grep -q 'mine/lock: ' err || fail "a link as lock: $(<err)"
[ "$(<outside/lock)" = outside ] || fail 'the lock was written through a link'
[ "$failures" -eq 0 ]
