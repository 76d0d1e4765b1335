#!/usr/bin/env bash
# A simulator of peers/ on a small free fall: its frames are read, and it falls as far as its step
# lets it. Skipped, exit 77, where it is not installed.
#   peers.sh NAME
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)

# A step of first order falls g t dt / 2 too far, 0.0123 m at 0.5 s with 5 ms; a tenth more for
# positions in single precision.
farthest=0.0135

rows=$("$top/peers/run" "$1" free_fall --points 5,5 --installed)
echo "$rows"
# The last row of the first case: its time, and error as a fraction of the length, 1 m.
python3 -c '
import csv, sys
rows = list(csv.DictReader(sys.stdin))
last = [r for r in rows if r["simulator"] == rows[0]["simulator"] and r["step"] == rows[0]["step"]][-1]
if last["time"] != "0.5" or not float(last["error"]) <= float(sys.argv[1]):
    sys.exit("at %s s it is %s m off; %s at most" % (last["time"], last["error"], sys.argv[1]))
' "$farthest" <<<"$rows"

# Mass damping c is handed over: z = -g/c (t - (1 - exp(-c t))/c). CalculiX, whose steps become
# ever smaller on a damped sheet that nothing holds, is left out.
[ "$1" != calculix ] || exit 0
build=$top/build damped=$(mktemp -d)
trap 'rm -rf "$damped"' EXIT
"$build/clothbench" export free_fall --points 5,5 --set 'damping={kind: mass, value: 5}' \
    --out "$damped/fall" >/dev/null 2>&1
settings=$(sed -n "s/^$1 *|[^|]*|[^|]*| *\([^|]*\) *|.*/\1/p" "$top/peers/cases.txt" | head -n 1)
# shellcheck disable=SC2086 # words
python3 "$top/peers/runs.py" drive "$build/peers" "$1" "$damped/fall" "$damped/fall.csv" $settings
python3 -c '
import math, sys
t, u, v, x, y, z = map(float, sys.stdin.read().split()[-1].split(","))
off = abs(z + 9.81 / 5 * (t - (1 - math.exp(-5 * t)) / 5))
if t != 0.5 or not off <= float(sys.argv[1]):
    sys.exit("damped, at %s s it is %s m off; %s at most" % (t, off, sys.argv[1]))
' "$farthest" <"$damped/fall.csv"
