#!/usr/bin/env bash
# The command `stress` from its words to its files: cases and contestants that are chosen, quick
# runs, earlier ones, what is refused. (tests/bench/verify/stress*.c: errors and sentences.)
#   stress.sh PROGRAM FOLDER        PROGRAM: clothbench_toy, with tests/odd_model.c
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"

row() { # CASE CONTESTANT VERDICT [WORDS]: a row of the CSV in `out` says so
    python3 - "$@" <<'EOF' || fail "no $*: $(<out)"
import csv, sys
rows = [r for r in csv.DictReader(l for l in open("out") if l[0] != "#")]
case, name, verdict = sys.argv[1:4]
[r] = [r for r in rows if (r["check"], r["contestant"]) == (case, name)]
sys.exit(r["verdict"] != verdict or not all(w in str(r) for w in sys.argv[4:]))
EOF
}

good stress still swing_10000 folded_knots --models odd,mass_spring --quick --jobs 1 --out few \
    --format csv
row still odd MISSED "'tolerance': '1e-10'" "'error': '0.10000000000000001'" "'until_s': '0.0050000000000000001'"
row still mass_spring met
row swing_10000 odd 'not applicable'
row swing_10000 mass_spring MISSED
row folded_knots mass_spring 'not applicable'
[ "$(grep -c , out)" -eq 13 ] || fail "not twelve rows: $(<out)"
cp out first
good stress still swing_10000 folded_knots --from few --format csv
cmp first out || fail 'printed again, it is another'
# a truth that is made first, once for all
good stress two_corners --models odd,mass_spring --quick --out few --format csv
row two_corners mass_spring met 'bar is 0.00'
row two_corners odd MISSED 'bar is 0.00'
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
row swing_10000 mass_spring died 'signal 9'
# a strip whose systems round-off leaves without a solution, at long steps towards rest
good stress narrow --models mass_spring --out narrow --format csv
row narrow mass_spring met
# all that an earlier run left
good stress --from few
grep -qE '^two_corners( +[0-9]+){8}' out || fail "cases of an earlier run: $(<out)"
for words in 'thrown --from few' 'still --models odd --from few' nowhere 'still --models nobody' 'still --jobs 0' \
    'still --format scroll' 'still --from few --out other'; do
    # shellcheck disable=SC2086 # words
    refused stress $words
done
[ ! -e other ] || fail 'a refused run wrote'
[ "$failures" -eq 0 ]
