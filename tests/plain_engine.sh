#!/usr/bin/env bash
# A plain engine of somebody else's (bench/export/plain_engine.c) runs exported scenes, and comes
# nearer to their truths on a finer mesh: what export tells of hinges is right for its mesh.
#   plain_engine.sh PROGRAM ENGINE
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
engine=$2
own_folder

# Prints the error over the length, in millionths, at the last of the times.
error() { # SCENE POINTS STEP DAMPING GX GY GZ TIME...
    local scene=$1 points=$2
    shift 2
    "$program" export "$scene" --out "$scene-$points" --points "$points,$points" 2>/dev/null
    "$engine" "$scene-$points" "$points" "$@" >frames.csv
    "$program" score "$scene-$points/scene.yaml" frames.csv --format csv |
        awk -F, -v scene="$scene" '$1 == scene { e = $3 } END { printf "%.0f\n", 1e6 * e }'
}

# With D |e|^2 / (A1 + A2) it is 1.2 % off on any net: its D is 5/6. What is left, 0.2 %, is the
# rims', whose Poisson's ratio is -1/3.
rest=$(error rest_small 11 5e-5 20 0 0 -9.81 1.5)
[ "$rest" -lt 4000 ] || fail "rest_small is $rest millionths off"

# A flag bends askew, where that rule has 4/3 of D: 1.3 % off on 11 and on 21 points.
coarse=$(error flag 11 1e-4 0 0 0.09809836500817498 -9.809509504087487 0.3)
fine=$(error flag 21 1e-4 0 0 0.09809836500817498 -9.809509504087487 0.3)
[ "$coarse" -lt 10000 ] || fail "flag is $coarse millionths off"
[ $((10 * fine)) -lt $((8 * coarse)) ] || fail "flag: $coarse millionths, on a finer mesh $fine"

coarse=$(error corners_patch 11 1e-4 1 0 0 -9.81 0.3)
fine=$(error corners_patch 21 1e-4 1 0 0 -9.81 0.3)
[ $((10 * fine)) -lt $((5 * coarse)) ] ||
    fail "corners_patch: $coarse millionths, on a finer mesh $fine"
# Springs give way under tension with free sides as the sheet does: with E h/(1-nu^2) - G h along u
# and v, right between held sides, it is 0.10 % off. The 0.05 % left are that they narrow, which
# the sheet does not.
hung=$(error hanging 11 1e-4 20 0 0 -9.81 1.5)
[ "$hung" -lt 700 ] || fail "hanging is $hung millionths off"
[ "$failures" -eq 0 ]
