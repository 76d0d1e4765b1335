#!/usr/bin/env bash
# `clothbench score` as it is met: one scene, a folder of several, its formats; what is wrong
# is a sentence, nothing on standard output, and exit 2. (What it finds: pages/test_score.py.)
#   score.sh CLOTHBENCH SOURCE
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1 truths=$2/bench/truths
own_folder

good score edge_drop "$truths/edge_drop.h5"
[ -s out ] || fail 'a sound truth: nothing is said'
good score sphere "$truths/sphere.h5" --format csv
has out 'scene,time,error,bar,floor' 'sphere,0.1'
good score sphere "$truths/sphere.h5" --format json
has out '"diagnosis": [{"kind": "sound", "value": 0,'
good score sphere "$truths/sphere.h5" --format markdown
has out '|'

mkdir all all/sphere none
cp "$truths/flag.h5" all
cp "$truths/sphere.h5" all/sphere/mine.h5
echo "beside it" >all/flag.xdmf
good score all --format csv
[[ $(cut -d, -f1 out | uniq | tr '\n' ' ') == 'scene flag sphere '* ]] || fail "a folder's scenes are not all there"

# One that is refused is a row; the others are judged.
echo nothing >all/hanging.csv
ends 2 score all --format json
python3 -c 'import json
sheets = {s["scene"]: s for s in json.load(open("out"))}
assert sheets["sphere"]["rows"] and "refused" not in sheets["sphere"], sheets
assert sheets["hanging"]["refused"] and not sheets["hanging"]["rows"], sheets' || fail 'bad frames are no row, or end the sheet'
has err 'hanging.csv: line 1'

# A light cantilever has an exact solution, which is known at any time.
sed 's/density: 0.5/density: 1.0e-4/; s/end: 4.25/end: 1/; /^snapshots/d' "$2/models/scenes/edge_drop.yaml" >light.yaml
awk 'BEGIN { for (k = 0; k < 5; k++) for (n = 0; n < 4; n++)
    printf "%g,%d,%d,%d,%d,0\n", k / 10, n % 2, int(n / 2), n % 2, int(n / 2) }' >still.csv
good score light.yaml still.csv --format csv
[ "$(grep -c , out)" -gt 3 ] || fail "a light cantilever: $(<out)"

# A strip that is folded through itself from the third frame on, 5 mm then and 10 mm later.
awk 'BEGIN { for (k = 0; k < 5; k++) for (n = 0; n < 121; n++) {
    u = n % 11 / 10; b = (u - 0.6) / 0.4; end = 0.005 * (1.0001 - k)
    x = u <= 0.5 ? 2 * u : 1 - 0.73 * b; z = u <= 0.5 ? 0 : 0.21 + (end - 0.21) * b
    if (u > 0.55 && u < 0.65) x = 1
    printf "%g,%.9g,%.9g,%.9g,%.9g,%.9g\n", k / 10, u, int(n / 11) / 10, x, int(n / 11) / 10, z } }' \
    >folded.csv
good score free_fall folded.csv --format json
has out '"contact": [{"kind": "through_itself", "frame": 3, "time": 0.20000000000000001, "value": 0.00'
good score sphere "$truths/sphere.h5" --format json
! grep -q through_itself out || fail 'a truth passes through itself'

# One page on a simulator; what is wrong in its folder leaves none.
mkdir -p mine/free_fall
cp folded.csv mine/free_fall/11x11.csv
good score --protocol mine
has out free_fall/11x11.csv
grep -q '</html>' mine/protocol.html || fail "--protocol writes no page"
good score --protocol mine --out page.html --format csv
has out subject,verdict,sentence
grep -q "</html>" page.html || fail "--out: no page"
rm page.html
# result files count with the points of their net, not with the places that they store
mkdir -p ours/free_fall
for points in 5,4 7,4; do
    good run free_fall --model triangles --set "discretization.points=[$points]" --quiet \
        --out "ours/free_fall/net-${points/,/x}.h5"
done
good score --protocol ours --format csv
has out 'On free_fall its error is at most'
has out '(7x4 points'
echo nothing >mine/free_fall/cells.csv
refused score --protocol mine --out page.html
[ ! -e page.html ] || fail "bad input, and a page"
refused score --protocol mine edge_drop
refused score edge_drop folded.csv --out x.html
refused score

echo "0,0,0,0,0,0" >one.csv
refused score edge_drop "$truths/sphere.h5"
has err 'is a run of sphere; one of edge_drop'
refused score edge_drop absent.csv
refused score one.csv
refused score none
refused score edge_drop none
refused score edge_drop one.csv
refused score corners_drop one.csv
sed 's/young: 1.0e5/young: 2.0e5/' "$2/models/scenes/edge_drop.yaml" >my.yaml
refused score my.yaml one.csv
for cell in 50 1; do # per cent, and from 0 to 2
    awk -v w=$cell 'BEGIN { for (n = 0; n < 9; n++) printf "0,%d,%d,1,0,0\n", n % 3 * w, int(n / 3) * w }' \
        >uv.csv
    refused score edge_drop uv.csv
    has err 'must run from 0 to 1'
done
refused score edge_drop one.csv --up q
refused score edge_drop one.csv --dt -1
refused score edge_drop one.csv --scale no
awk 'BEGIN { for (k = 2; k < 4; k++) for (n = 0; n < 4; n++)
    printf "%g,%d,%d,1,0,0\n", k, n % 2, int(n / 2) }' >late.csv
refused score edge_drop late.csv
awk 'BEGIN { for (k = 0; k < 5; k++) for (n = 0; n < 4; n++)
    printf "%g,%d,%d,%d,%d,0\n", k / 10 + 0.05, n % 2, int(n / 2), n % 2, int(n / 2) }' \
    >far.csv
refused score edge_drop far.csv
printf '%%s%%n,0,0,0,0,0\n' >"%s%n.csv"
refused score edge_drop "%s%n.csv"
exit $((failures > 0))
