#!/usr/bin/env bash
# Results that are there already are taken as long as nothing that they depend on changed, and
# never after it did: each of these things is edited, for a study and for a sweep that is resumed.
#   stale.sh PROGRAM FOLDER
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"

mkdir truths
export CLOTHBENCH_TRUTHS=$PWD/truths
cat >body.obj <<'OBJ'
v 0.2 0.2 -0.02
v 0.9 0.2 -0.02
v 0.5 0.9 -0.02
v 0.5 0.5 -0.3
f 1 2 3
f 2 1 4
f 3 2 4
f 1 3 4
OBJ
sed 's/-0.02$/-0.05/' body.obj >lower.obj
cat >laid.yaml <<'SCENE'
name: laid
source: a test
sheet: {length: 1, width: 1, thickness: 0.01}
material: {young: 1e5, poisson: 0.3, density: 30}
gravity: [0, 0, -9.81]
obstacles: [{mesh: {file: body.obj}}]
time: {step: 0.01, end: 0.1}
SCENE
cat >swept.yaml <<'PLAN'
name: swept
source: a test
scene: ./laid.yaml
model: mass_spring_leapfrog
settings: {discretization.points: [6,6]}
axes: {material.young: [1e5, 2e5]}
PLAN
sed -e 's/swept/studied/' -e '/^axes/d' swept.yaml >studied.yaml
cat >>studied.yaml <<'PLAN'
axes: {level: {one: {}}}
studies: {moves: {times: [0.05, 0.1]}, rests: {times: [], obstacles: []}}
PLAN
sed -e 's/swept/named/' -e 's/^axes.*/axes: {"obstacles[0].mesh.file": [lower.obj]}/' \
    swept.yaml >named.yaml

same() { # WHAT: it changed nothing
    "$program" study studied.yaml --out study >out 2>err || fail "$1: study: $(<err)"
    grep -q '2 of 2 cases were taken' err || fail "$1: the study runs again"
    run swept.yaml --out sweep
    grep -q 'Nothing was left to run' out || fail "$1: the sweep runs again: $(<err)"
}
anew() { # WHAT: it is no result of this any more
    "$program" study studied.yaml --out study >out 2>err || fail "$1: study: $(<err)"
    [ "$(grep -o '[12] of 2 cases were taken' err)" = "$still" ] ||
        fail "$1: of the study is taken: $(<err)"
    for plan in "${plans[@]}"; do
        run "$plan.yaml" --out "${plan/swept/sweep}"
        { [ "$code" -eq 0 ] && grep -q '^[12] cases run now' out; } ||
            fail "$1: the sweep $plan says $(<out) $(<err)"
    done
}

for plan in swept named; do
    run "$plan.yaml" --out "${plan/swept/sweep}"
    [ "$code" -eq 0 ] || fail "sweep $plan: exit $code: $(<err)"
done
"$program" study studied.yaml --out study >out 2>err || fail "study: $(<err)"
drop=$(<study/moves.csv)
same 'nothing'
touch body.obj lower.obj laid.yaml swept.yaml studied.yaml
same 'times of files'
sed -i '1i # a remark' body.obj
same 'a remark in the mesh'
cp body.obj other.obj
same 'a mesh that nobody names'

plans=(swept)
still='1 of 2 cases were taken' # of the study's sheets one meets no body
sed -i 's/-0.02$/-0.2/' body.obj
anew 'a mesh'
[ "$drop" != "$(<study/moves.csv)" ] || fail 'a lower body, and the same drop'
sed -i 's/density: 30/density: 31/' laid.yaml
plans=(swept named)
still=''
anew 'a scene'
sed -i 's/\[6,6\]/[7,7]/' swept.yaml named.yaml studied.yaml
anew 'a setting'
sed -i 's/mass_spring_leapfrog/triangles/' swept.yaml named.yaml studied.yaml
anew 'a model'
sed -i 's/-0.05$/-0.06/' lower.obj
run named.yaml --out named
grep -q '^1 cases run now' out || fail "a mesh that a value of an axis names: $(<out)"
run swept.yaml --out sweep
grep -q 'Nothing was left to run' out || fail "the mesh of another sweep: $(<err)"
# what a case of a sweep keeps its distance from; a study looks at its truth when it prints
cp "$source_folder/tests/truths/flag.h5" truths/laid.h5
run swept.yaml --out sweep
grep -q '^2 cases run now' out || fail "a truth that is stored now: $(<out)"
# the mesh of the sheet itself
printf 'v %s 0\n' '0 0' '1 0' '1 1' '0 1' '0.5 0.4' >sheet.obj
printf 'f %s 5\n' '1 2' '2 3' '3 4' '4 1' >>sheet.obj
cat >meshed.yaml <<'EOF'
name: meshed
source: ours
scene: edge_drop
model: triangles
settings: {time.end: 0.02}
axes: {discretization.mesh: [sheet.obj, irregular]}
EOF
run meshed.yaml --out meshed
run meshed.yaml --out meshed
grep -q 'Nothing was left to run' out || fail "the same mesh of a sheet: $(<out)"
sed -i 's/^v 0.5 0.4/v 0.5 0.6/' sheet.obj
run meshed.yaml --out meshed
grep -q '^1 cases run now' out || fail "a mesh of a sheet that was edited: $(<out)"
[ "$failures" -eq 0 ]
