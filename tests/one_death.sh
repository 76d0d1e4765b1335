#!/usr/bin/env bash
# Every command tells the same death of the same run: two runs of the paper's scheme, told by
# `run` and `sweep` with cause and time. (Tables and studies: tests/run_file.c.)
#   one_death.sh PROGRAM FOLDER
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1

names=('ground' 'row 7')
scenes=('ground' 'edge_drop')
settings=('discretization.points=[10,10,2]'
    'material.young=5e4 material.density=0.1 damping.value=0.9')
deaths=('t = 0.365 s: a point is farther than 10 lengths from its support'
    't = 0.265 s: an element turned inside out (det J <= 0)')

cat >plan.yaml <<'PLAN'
name: deaths
source: a test
model: iga
settings: {discretization.kinematics: printed, time.end: 0.5, snapshots: []}
cases:
  - {name: ground, scene: ground, discretization.points: [10,10,2]}
  - {name: row 7, scene: edge_drop, material.young: 5e4, material.density: 0.1, damping.value: 0.9}
look: 7
PLAN
sweep plan.yaml --out swept --quiet --jobs 2 || fail 'the sweep fails'

for n in 0 1; do
    set=()
    for s in ${settings[n]} discretization.kinematics=printed; do set+=(--set "$s"); done
    "$program" run "${scenes[n]}" --model iga "${set[@]}" --quiet --out run.h5 2>err
    [ $? -eq 1 ] || fail "run ${scenes[n]}: exit code is not 1"
    [[ $(<err) == *"died at ${deaths[n]}" ]] || fail "run ${scenes[n]}: $(<err)"
    grep -q "^$((n + 1)),${names[n]},.*died at ${deaths[n]}" swept/table.csv ||
        fail "sweep of ${names[n]}: $(grep "${names[n]}" swept/table.csv)"
done
exit $((failures > 0))
