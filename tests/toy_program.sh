#!/usr/bin/env bash
# The program with one row more in its table of contestants, the toy's: every command that
# takes contestants has it, without another edit.
#   toy_program.sh PROGRAM FOLDER
set -uo pipefail
program=$1
folder=$2
failed=0

fail() {
    echo "toy_program.sh: $*"
    failed=1
}

# Runs it; its output is in $folder/out.
good() { # ARGUMENT...
    "$program" "$@" >"$folder/out" 2>"$folder/err" </dev/null ||
        fail "$*: exit $?: $(tail -3 "$folder/err")"
}

# Checks that the last call left CSV in a folder and said which command draws it.
leaves() { # FOLDER FILE
    [ -s "$folder/$1/$2.csv" ] || fail "$1 has no $2.csv"
    grep -qxF "$folder/$1: clothbench report $folder/$1 draws what is in it" "$folder/err" ||
        fail "$1: it does not say what draws it: $(<"$folder/err")"
}

rm -rf "$folder"
mkdir -p "$folder"
good list models
grep -q '^toy  *' "$folder/out" || fail "list models has no toy"
good list contestants
grep '^toy ' "$folder/out" | grep compare | grep stress | grep verify | grep -q bench ||
    fail "list contestants has no toy that enters everywhere"

good run edge_drop --model toy
grep -q '6\.37650e-05' "$folder/err" || fail "its drop is not rho g L / 2 G"

good compare edge_drop --models toy --quick --out "$folder/compare"
grep '^toy,toy,toy,20,' "$folder/compare/compare.csv" | grep -q ',done$' ||
    fail "compare has no run of the toy"
leaves compare compare

# Exit 1: a case or a claim is missed, as a toy may.
"$program" stress thin_2 --models toy --out "$folder/stress" >"$folder/out" 2>"$folder/err"
[ $? -le 1 ] || fail "stress: $(tail -3 "$folder/err")"
grep -q toy "$folder/out" || fail "stress has no toy"
leaves stress thin_2
"$program" verify cantilever --quick --models toy --out "$folder/verify" >"$folder/out" \
    2>"$folder/err"
[ $? -le 1 ] || fail "verify: $(tail -3 "$folder/err")"
grep -q toy "$folder/out" || fail "verify has no toy"
leaves verify cantilever

good bench contestants --models toy --quick --out "$folder/bench" --format csv
grep '^toy,toy,' "$folder/out" | grep -q ',done$' || fail "the timing table has no toy"
leaves bench contestants
exit $failed
