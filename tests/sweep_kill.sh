#!/usr/bin/env bash
# A sweep is killed with SIGKILL again and again, at random moments, its whole process group at
# once, and resumed each time: no case is lost, none is run again after it finished, and the
# table is that of an undisturbed sweep, bit for bit.
#   sweep_kill.sh PROGRAM FOLDER KILLS CASES       CASES: a multiple of 12
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"
kills=$3
cases=$4
write_plan plan.yaml $((cases / 12))
RANDOM=${SEED:-$$}
echo "SEED=${SEED:-$$}"

sweep plan.yaml --out whole --quiet || fail "undisturbed: exit $?"

ended() { # cases that have a file
    find killed -name '*.h5' 2>/dev/null | wc -l
}

# A sweep that has come to its end, however often it was killed on the way.
check_end() {
    cmp whole/table.csv killed/table.csv || fail 'the tables differ'
    [ "$(wc -l <killed/table.csv)" -eq $((cases + 1)) ] || fail "not $cases rows"
    [ -z "$(find killed -name '*.part')" ] || fail 'left behind: a half-written file'
    # a file that was there after any of the lives is the very same in the end
    stat -c '%n %i' killed/case_*.h5 | sort >ids.end
    sort -u ids | comm -23 - ids.end | grep . && fail 'a finished case was written again'
}

# One life: killed early on, or in the middle of the work, after one or two more cases.
live() {
    local wanted=$((RANDOM % 3)) pause=$((RANDOM % 60)) group before until
    before=$(ended)
    setsid "$program" sweep plan.yaml --out killed --quiet </dev/null 2>err &
    group=$!
    until=$((${EPOCHREALTIME/./} + 10000000))
    if ((wanted > 0)); then
        pause=$((pause / 6))
        while [ "$(ended)" -lt $((before + wanted)) ] && ((${EPOCHREALTIME/./} < until)); do
            sleep 0.01
        done
    fi
    sleep "0.$(printf '%03d' "$pause")"
    kill -KILL -- "-$group" 2>/dev/null && ((++killed))
    wait "$group" 2>/dev/null
    while kill -0 -- "-$group" 2>/dev/null; do sleep 0.002; done
    [ ! -s err ] || fail "a life says: $(<err)"
    stat -c '%n %i' killed/case_*.h5 >>ids 2>/dev/null
    cut=$((cut + $(find killed -name '*.part' 2>/dev/null | wc -l)))
}

: >ids
cut=0 killed=0
while ((killed < kills && failures == 0)); do
    live
    if [ -e killed/table.csv ]; then # on a fast machine it comes to its end before
        check_end
        rm -rf killed
        : >ids
    fi
done
sweep plan.yaml --out killed --quiet || fail "the last life: exit $?"
check_end
echo "$killed kills, $cut cases cut short"
((cut > 0)) || fail 'no case was ever cut short'
[ "$failures" -eq 0 ]
