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
