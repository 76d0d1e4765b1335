#!/usr/bin/env bash
# The command `stress` from its words to its files: cases and contestants that are chosen, quick
# runs, rows that are gone, what is refused. (tests/stress*.c: errors and sentences.)
#   stress.sh PROGRAM FOLDER        PROGRAM: clothbench_toy, with tests/odd_model.c
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"

is() { # FILE LINE: it has the line
    grep -qxF "$2" "$1" || fail "no '$2' in $1: $(<"$1")"
}

good stress still swing_10000 folded_knots --models odd,mass_spring --quick --jobs 1 --out few \
    --format csv
sed -E 's/,[^,]*(,[^,]*)$/,TOOK\1/' out >rows
is rows 'still,odd,1e-10,degraded,0.10000000000000001,0.0050000000000000001,TOOK,'
grep -q '^still,mass_spring,1e-10,accurate,' rows || fail "still: $(<out)"
grep -q '^swing_10000,odd,0.01,refused,,,TOOK,' rows || fail "swing: $(<out)"
grep -q '^swing_10000,mass_spring,0.01,degraded,' out || fail "swing: $(<out)"
grep -q '^folded_knots,mass_spring,0.02,refused,,' out || fail "refused: $(<out)"
[ "$(grep -c '^[a-z]' out)" -eq 13 ] || fail "not twelve rows: $(<out)"
cp out first
good stress still swing_10000 folded_knots --models odd,mass_spring --from few --format csv
cmp first out || fail 'printed again, it is another'
# a truth that is made first, once for all
good stress two_corners --models odd,mass_spring --quick --out few --format csv
grep -q '^two_corners,mass_spring,0.02,accurate,.* 0.00' out || fail "$(<out)"
grep -q '^two_corners,odd,0.02,degraded,.* 0.00' out || fail "$(<out)"
# one that is killed on its way has died, and its row says of what
"$program" stress swing_10000 --models mass_spring --out lost --format csv >out 2>err </dev/null &
stress=$!
until run=$(ps -o pid= --ppid "$stress"); do
    kill -0 "$stress" 2>/dev/null || break
    sleep 0.01
done
# shellcheck disable=SC2086 # a blank before the number
kill -KILL $run
wait "$stress" || fail "a run that was killed: $(<err)"
grep -q '^swing_10000,mass_spring,.*,died,.*signal 9' out || fail "a run that was killed: $(<out)"
# a strip whose systems round-off leaves without a solution, at long steps towards rest
good stress narrow --models mass_spring --out narrow --format csv
grep -q '^narrow,mass_spring,0.02,accurate,' out || fail "narrow: $(<out)"
# a row that is gone
good stress still --models odd,mass_spring --out few
sed -i '/^still,mass_spring,/d' few/stress.csv
good stress still --models odd,mass_spring --from few
grep -qE '^still +-( +ok [^ ]+){2} +off [^ ]+$' out || fail "a row is gone: $(<out)"
for words in 'thrown --models odd --from few' nowhere 'still --models nobody' 'still --jobs 0' \
    'still --format scroll' 'still --from few --out other'; do
    # shellcheck disable=SC2086 # words
    refused stress $words
done
[ ! -e other ] || fail 'a refused run wrote'
[ "$failures" -eq 0 ]
