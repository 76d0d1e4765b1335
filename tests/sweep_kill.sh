#!/usr/bin/env bash
# A sweep is killed with SIGKILL 50 times, at random moments, its whole process group at once,
# and resumed each time: no case is lost, none is run again after it finished, and the table
# is that of an undisturbed sweep, bit for bit.
#   sweep_kill.sh PROGRAM FOLDER
program=$1
folder=$2
. "$(dirname "$0")/sweep_fixture.sh"
kills=50
rm -rf "$folder"
mkdir -p "$folder/ids"
cd "$folder" || exit 1
write_plan plan.yaml 15
RANDOM=${SEED:-$$}
echo "SEED=${SEED:-$$}"

sweep plan.yaml --out whole --quiet || fail "undisturbed: exit $?"

ended() { # cases that the log says have ended
    local count
    count=$(grep -cs '^end' killed/log.txt)
    echo "${count:-0}"
}

for ((life = 1; life <= kills; life++)); do
    setsid "$program" sweep plan.yaml --out killed --quiet --resume </dev/null 2>err &
    group=$!
    # either early on, or in the middle of the work: after one or two more cases
    wanted=$((RANDOM % 3)) pause=$((RANDOM % 60))
    until=$((${EPOCHREALTIME/./} + 10000000))
    if ((wanted > 0)); then
        pause=$((pause / 6))
        before=$(ended)
        while [ "$(ended)" -lt $((before + wanted)) ] &&
            ((${EPOCHREALTIME/./} < until)); do
            sleep 0.005
        done
    fi
    sleep "0.$(printf '%03d' "$pause")"
    kill -KILL -- "-$group" 2>/dev/null || fail "life $life: nothing was left to kill"
    wait "$group" 2>/dev/null
    while kill -0 -- "-$group" 2>/dev/null; do sleep 0.002; done
    [ -s err ] && fail "life $life says: $(<err)"
    stat -c '%n %i' killed/case_*.h5 >"ids/$life" 2>/dev/null
done
[ ! -e killed/table.csv ] || fail 'it finished before it was killed often enough'
sweep plan.yaml --out killed --quiet --resume || fail "the last life: exit $?"

cmp whole/table.csv killed/table.csv || fail 'the tables differ'
[ "$(wc -l <killed/table.csv)" -eq 181 ] || fail "not 180 rows: $(wc -l <killed/table.csv)"
[ -z "$(find killed -name '*.part')" ] || fail 'left behind: a half-written file'
awk '$1 == "start" && ended[$2] { print "case", $2, "is run again"; bad = 1 }
     $1 == "start" { started[$2]++; lives++ }
     $1 == "end" { ended[$2] = 1 }
     END { for (n = 1; n <= 180; n++) if (!started[n]) { print "case", n, "is lost"; bad = 1 }
           if (lives <= 180) { print "no case was ever cut short"; bad = 1 }
           print lives, "starts of 180 cases"
           exit bad }' killed/log.txt || fail 'the log is not as it should be'
# a file that was there after any of the lives is the very same in the end
stat -c '%n %i' killed/case_*.h5 | sort >ids/end
sort -u ids/[0-9]* | comm -23 - ids/end | grep . && fail 'a finished case was written again'
[ "$failures" -eq 0 ]
