#!/bin/sh
# `clothbench score` as it is met: one scene, a folder of several, its formats; what is wrong
# is a sentence, nothing on standard output, and exit 2.
#   score.sh CLOTHBENCH SOURCE
set -eu
program=$1 truths=$2/bench/truths
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0

fail() {
    echo "$*"
    failed=1
}

# says WORDS ARGUMENT... : exit 0, the words on standard output
says() {
    words=$1
    shift
    "$program" score "$@" >"$scratch/out" 2>"$scratch/err" || fail "score $*: exit $?"
    tr '\n' ' ' <"$scratch/out" | grep -qF -- "$words" || fail "score $*: does not say: $words"
}

# refuses WORDS ARGUMENT... : exit 2, the words on standard error, nothing printed
refuses() {
    words=$1
    shift
    code=0
    "$program" score "$@" >"$scratch/out" 2>"$scratch/err" || code=$?
    [ $code = 2 ] || fail "score $*: exit $code"
    [ ! -s "$scratch/out" ] || fail "score $*: prints something"
    tr '\n' ' ' <"$scratch/err" | grep -qF -- "$words" || {
        fail "score $*: does not say: $words"
        cat "$scratch/err"
    }
}

says "Nothing wrong was found" edge_drop "$truths/edge_drop.h5"
tr '\n' ' ' <"$scratch/out" | grep -q "moves undamped here" || fail "it says nothing of damping"
says "scene,time,error,bar,floor sphere,0.1" sphere "$truths/sphere.h5" --format csv
says '"diagnosis": [{"kind": "sound", "value": 0, "text": "' \
    sphere "$truths/sphere.h5" --format json
says '|' sphere "$truths/sphere.h5" --format markdown

mkdir "$scratch/all" "$scratch/all/sphere" "$scratch/none"
cp "$truths/flag.h5" "$scratch/all"
cp "$truths/sphere.h5" "$scratch/all/sphere/mine.h5"
echo "beside it" >"$scratch/all/flag.xdmf"
says "sphere: Nothing wrong was found" "$scratch/all"
"$program" score "$scratch/all" --format csv 2>/dev/null | cut -d, -f1 | uniq | tr '\n' ' ' |
    grep -q "^scene flag sphere " || fail "a folder's scenes are not all there"

# One that is refused is a row; the others are judged.
echo "nothing" >"$scratch/all/hanging.csv"
code=0
"$program" score "$scratch/all" >"$scratch/out" 2>"$scratch/err" || code=$?
[ $code = 2 ] || fail "a folder with bad frames: exit $code"
grep -q "sphere: Nothing wrong" "$scratch/out" || fail "bad frames end the sheet"
grep -q "hanging.*refused" "$scratch/out" || fail "bad frames are no row"
grep -q "^clothbench: .*hanging.csv: line 1" "$scratch/err" || fail "bad frames are not told at the end"
"$program" score "$scratch/all" --format json 2>/dev/null |
    grep -qF '"scene": "hanging", "rows": [], "diagnosis": [], "refused": "' || fail "bad frames are no JSON"

# A light cantilever has an exact solution, which is known at any time.
sed 's/density: 0.5/density: 1.0e-4/; s/end: 4.25/end: 1/; /^snapshots/d' "$2/models/scenes/edge_drop.yaml" >"$scratch/light.yaml"
awk 'BEGIN { for (k = 0; k < 5; k++) for (n = 0; n < 4; n++)
    printf "%g,%d,%d,%d,%d,0\n", k / 10, n % 2, int(n / 2), n % 2, int(n / 2) }' >"$scratch/still.csv"
says "truth at 10 times from 0.1 to 1 s" "$scratch/light.yaml" "$scratch/still.csv"

# A strip that is folded through itself from the third frame on, 5 mm then and 10 mm later.
awk 'BEGIN { for (k = 0; k < 5; k++) for (n = 0; n < 121; n++) {
    u = n % 11 / 10; b = (u - 0.6) / 0.4; end = 0.005 * (1.0001 - k)
    x = u <= 0.5 ? 2 * u : 1 - 0.73 * b; z = u <= 0.5 ? 0 : 0.21 + (end - 0.21) * b
    if (u > 0.55 && u < 0.65) x = 1
    printf "%g,%.9g,%.9g,%.9g,%.9g,%.9g\n", k / 10, u, int(n / 11) / 10, x, int(n / 11) / 10, z } }' \
    >"$scratch/folded.csv"
says "Passes through itself, first in frame 3 (0.2 s)" free_fall "$scratch/folded.csv"
says '"contact": [{"kind": "through_itself", "frame": 3, "time": 0.20000000000000001, "value": 0.00' \
    free_fall "$scratch/folded.csv" --format json
says "No frame passes through itself or has a vertex in a body." sphere "$truths/sphere.h5"

# One page on a simulator; what is wrong in its folder leaves none.
mkdir -p "$scratch/mine/free_fall"
cp "$scratch/folded.csv" "$scratch/mine/free_fall/11x11.csv"
says "free_fall/11x11.csv: Passes through itself, first in frame 3" --protocol "$scratch/mine"
grep -q '</html>' "$scratch/mine/protocol.html" || fail "--protocol writes no page"
says 'subject,verdict,sentence' --protocol "$scratch/mine" --out "$scratch/page.html" --format csv
grep -q "</html>" "$scratch/page.html" || fail "--out: no page"
rm "$scratch/page.html"
cp "$scratch/folded.csv" "$scratch/mine/free_fall/cells.csv"
refuses "cells.csv: its name says no net" --protocol "$scratch/mine" --out "$scratch/page.html"
[ ! -e "$scratch/page.html" ] || fail "bad input, and a page"
refuses "has no SCENE, FRAMES or --rest" --protocol "$scratch/mine" edge_drop
refuses "--out is for the page of --protocol" edge_drop "$scratch/folded.csv" --out x.html
refuses "score --protocol DIR, would be right"

echo "0,0,0,0,0,0" >"$scratch/one.csv"
refuses "No such file" edge_drop "$scratch/absent.csv"
refuses "no folder of several" "$scratch/one.csv"
refuses "named like scenes" "$scratch/none"
refuses "has no frames in it" edge_drop "$scratch/none"
refuses "runs from 0 to 0" edge_drop "$scratch/one.csv"
refuses "corners_drop has no truth" corners_drop "$scratch/one.csv"
sed 's/young: 1.0e5/young: 2.0e5/' "$2/models/scenes/edge_drop.yaml" >"$scratch/my.yaml"
refuses "clothbench truth $scratch/my.yaml makes" "$scratch/my.yaml" "$scratch/one.csv"
awk 'BEGIN { for (n = 0; n < 9; n++) printf "0,%d,%d,1,0,0\n", n % 3 * 50, int(n / 3) * 50 }' \
    >"$scratch/cent.csv"
refuses "u runs from 0 to 100; uv of the sheet must run from 0 to 1" \
    edge_drop "$scratch/cent.csv"
refuses "--up q" edge_drop "$scratch/one.csv" --up q
refuses "--dt -1" edge_drop "$scratch/one.csv" --dt -1
refuses "--scale no" edge_drop "$scratch/one.csv" --scale no
awk 'BEGIN { for (k = 2; k < 4; k++) for (n = 0; n < 4; n++)
    printf "%g,%d,%d,1,0,0\n", k, n % 2, int(n / 2) }' >"$scratch/late.csv"
refuses "frames run from 2 to 3 s" edge_drop "$scratch/late.csv"
awk 'BEGIN { for (k = 0; k < 5; k++) for (n = 0; n < 4; n++)
    printf "%g,%d,%d,%d,%d,0\n", k / 10 + 0.05, n % 2, int(n / 2), n % 2, int(n / 2) }' \
    >"$scratch/far.csv"
refuses "no frame is at a time of the truth" edge_drop "$scratch/far.csv"
printf '%%s%%n,0,0,0,0,0\n' >"$scratch/%s%n.csv"
refuses "%s%n.csv: line 1" edge_drop "$scratch/%s%n.csv"
exit $failed
