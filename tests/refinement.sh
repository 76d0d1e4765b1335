#!/usr/bin/env bash
# Where the error of a contestant grows with refinement: the plans refinement, refinement_nets
# and remedies, run anew, have the rows that grow where doc/results says so, and no others.
# A case that is cut off by its time limit on a slow machine is not judged.
#   refinement.sh PROGRAM FOLDER
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"

grows() { # FILE: scene, contestant, remedy if any, and where it grows, of the rows that do
    sed -E '/^#/d; /^(name|case),/d; s/^(([a-z_0-9]*,)*[a-z_0-9]*),.*,("[^"]*"|)$/\1 \2/; / $/d' "$1"
}

for plan in refinement refinement_nets remedies; do
    sweep "$plan" --out "$plan" --quiet 2>err
    code=$?
    [ "$code" -le 1 ] || fail "$plan: exit $code: $(<err)"
    grows "$plan/falls.csv" >is
    grows "$source_folder/doc/results/$plan.csv" >want
    if grep -q 'timed out' "$plan/table.csv"; then
        grep -vxFf want is >added && fail "$plan grows where doc/results has it falling: $(<added)"
    else
        diff want is || fail "$plan grows elsewhere than doc/results says"
    fi
done
[ "$failures" -eq 0 ]
