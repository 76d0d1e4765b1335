#!/usr/bin/env bash
# A scene of this folder's `through`, in which a sheet is folded, drawn or pressed, runs to its
# end. `all`: on average over those that something holds, the others would fall, its steps have
# at most four times the work of those without contact: of solves, of which an assembly and a
# factorisation cost three to four (models/mechanics/large_newton.c).
# Half the step moves it by no more than MOST_APART % of its length, rms over 25 places at any
# time, or than twice what a tenth more friction does: where folds fall by chance, motions are
# about as far apart, whatever changes them; a step that ends with wrong friction moves it more.
# Backward Euler, which says what it takes of a swing at this step, is not judged by that.
#   through.sh PROGRAM SCENE|all MODEL
program=$1
scenes=$(dirname "$(realpath "$0")")/through
scene=$scenes/$2.yaml
model=$3
MOST=4
MOST_APART=2
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"

own_folder
work() { # in half solves, of the last run
    sed -n 's/^work .* \([0-9]*\) factorisations, \([0-9]*\) solves.*/\1 \2/p' err |
        { read -r factorisations solves && echo $((7 * factorisations + 2 * solves)); }
}

moves() { # FILE SCENE OPTION...: FILE gets where 25 places are in every frame
    local places=() u v
    for u in 0 .25 .5 .75 1; do
        for v in 0 .25 .5 .75 1; do places+=(--probe "$u,$v,0.5"); done
    done
    good run "$2" --model "$model" "${places[@]}" "${@:3}"
    mv out "$1"
}

apart() { # FILE FILE: the largest rms distance of two motions [% of the length]
    awk -F, -v L="$(sed -n 's/^sheet: {length: \([0-9.]*\).*/\1/p' "$scene")" '
        FNR == 1 { next }
        { k = sprintf("%.6f %s %s", $1, $2, $3) }
        NR == FNR { x[k] = $5; y[k] = $6; z[k] = $7; next }
        k in x { s[$1] += ($5 - x[k])^2 + ($6 - y[k])^2 + ($7 - z[k])^2; n[$1]++ }
        END { for (t in s) if (s[t] / n[t] > most) most = s[t] / n[t]
              printf "%.2f\n", 100 * sqrt(most) / L }' "$1" "$2"
}

more_than() { # A B
    awk "BEGIN { exit !($1 > $2) }"
}

if [[ $2 == all ]]; then
    for scene in "$scenes"/*.yaml; do
        sed '/^contact:/d; /^obstacles:/,/^[a-np-z]/{/^obstacles:/d; /^ /d}' "$scene" >free.yaml
        grep -q '^supports:' free.yaml || continue
        "$program" run "$scene" --model "$model" >out 2>err </dev/null
        case $? in
        0) touching=$(work) ;;
        2) continue ;; # refused
        *) fail "$(basename "$scene"), $model: $(tail -1 err)" && continue ;;
        esac
        good run free.yaml --model "$model"
        echo "$(basename "$scene" .yaml) $touching $(work)" >>all
    done
    awk -v most=$MOST '{ print $1 ": " $2 / $3; sum += $2 / $3 }
        END { print "mean of " NR ": " sum / NR; exit !(NR > 0 && sum / NR <= most) }' all ||
        fail "$model: more than $MOST times the work of a free sheet on average"
    exit $((failures > 0))
fi
moves step.csv "$scene"
grep -q 'of itself' err && fail "$2, $model: the sheet has passed through itself"
grep -q 'backward Euler takes' err && MOST_APART=100
step=$(sed -n 's/^time: {step: \([0-9.]*\).*/\1/p' "$scene")
moves half.csv "$scene" --set "time.step=$(awk "BEGIN { print $step / 2 }")"
by_half=$(apart step.csv half.csv)
awk '{ while (match($0, /friction: [0-9.]+/)) {
           printf "%sfriction: %g", substr($0, 1, RSTART - 1), 1.1 * substr($0, RSTART + 10, RLENGTH - 10)
           $0 = substr($0, RSTART + RLENGTH) }
       print }' "$scene" >rough.yaml
moves rough.csv rough.yaml
by_friction=$(apart step.csv rough.csv)
echo "$2, $model: moved by $by_half % of its length by half the step, $by_friction % by a tenth more friction"
more_than "$by_half" "$MOST_APART" && more_than "$by_half" "2 * $by_friction" &&
    fail "$2, $model: half the step moves it by $by_half %"
exit $((failures > 0))
