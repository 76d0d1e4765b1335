#!/usr/bin/env bash
# A scene of this folder's `through`, in which a sheet is folded, drawn or pressed, runs to its
# end, and its steps have at most four times the factorisations, or iterations where factors are
# kept, of those without contact. A scene that nothing holds has none without: it would fall.
#   through.sh PROGRAM SCENE MODEL
program=$1
scene=$(dirname "$(realpath "$0")")/through/$2.yaml
model=$3
MOST=4
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"

own_folder
work() { # WORD: how many of it the last run counted
    sed -n "s/^work .* \([0-9]*\) $1.*/\1/p" err
}

good run "$scene" --model "$model"
grep -q 'of itself' err && fail "$2, $model: the sheet has passed through itself"
read -ra touching <<<"$(work factorisations) $(work iterations)"
sed '/^contact:/d; /^obstacles:/,/^[a-np-z]/{/^obstacles:/d; /^ /d}' "$scene" >free.yaml
if grep -q '^supports:' free.yaml; then
    "$program" run free.yaml --model "$model" >out 2>err </dev/null
    read -ra free <<<"$(work factorisations) $(work iterations)"
    echo "$2, $model: ${touching[*]} factorisations and iterations, ${free[*]} without contact"
    ((touching[0] <= MOST * free[0] || touching[1] <= MOST * free[1])) ||
        fail "$2, $model: more than $MOST times the work of a free sheet"
fi
exit $((failures > 0))
