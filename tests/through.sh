#!/usr/bin/env bash
# A scene of this folder's `through`, in which a sheet is folded, drawn or pressed, runs to its
# end, and its steps have at most four times the work of those without contact: of solves, of
# which an assembly and a factorisation cost three to four (models/mechanics/large_newton.c).
# A scene that nothing holds has none without: it would fall.
#   through.sh PROGRAM SCENE MODEL
program=$1
scene=$(dirname "$(realpath "$0")")/through/$2.yaml
model=$3
MOST=4
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"

own_folder
work() { # in half solves, of the last run
    sed -n 's/^work .* \([0-9]*\) factorisations, \([0-9]*\) solves.*/\1 \2/p' err |
        { read -r factorisations solves && echo $((7 * factorisations + 2 * solves)); }
}

good run "$scene" --model "$model"
grep -q 'of itself' err && fail "$2, $model: the sheet has passed through itself"
touching=$(work)
sed '/^contact:/d; /^obstacles:/,/^[a-np-z]/{/^obstacles:/d; /^ /d}' "$scene" >free.yaml
if grep -q '^supports:' free.yaml; then
    "$program" run free.yaml --model "$model" >out 2>err </dev/null
    free=$(work)
    echo "$2, $model: $touching of work, $free without contact, in half solves"
    ((touching <= MOST * free)) ||
        fail "$2, $model: more than $MOST times the work of a free sheet"
fi
exit $((failures > 0))
