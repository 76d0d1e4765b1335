#!/usr/bin/env bash
# Where the error of a contestant grows with refinement: the plans refinement, refinement_nets
# and remedies, run anew, have the rows that grow where doc/results says so, and no others.
# A case that is cut off by its time limit on a slow machine is not judged.
#   refinement.sh PROGRAM FOLDER
program=$1
folder=$2
# shellcheck source=tests/sweep_fixture.sh
. "$(dirname "$0")/sweep_fixture.sh"

grows() { # FILE: scene, contestant, remedy and net whose error grows by more than the truth's bar
    /usr/bin/python3 - "$1" <<'PYTHON'
import csv, math, sys
least = {}
for r in csv.DictReader(line for line in open(sys.argv[1]) if line[0] != "#"):
    case = r.get("case") or r["name"], r["model"], r.get("discretization.remedy")
    error, bar = (float(r[key] or "nan") for key in ("truth_error_end", "truth_bar_end"))
    if error > least.get(case, math.inf) + bar:
        print(*case, r["discretization.points"])
    least[case] = min(least.get(case, math.inf), math.inf if math.isnan(error) else error)
PYTHON
}

for plan in refinement refinement_nets remedies; do
    sweep "$plan" --out "$plan" --quiet 2>err || fail "$plan: $(<err)"
    grows "$plan/table.csv" >is
    grows "$source_folder/doc/results/$plan.csv" >want
    if grep -q 'timed out' "$plan/table.csv"; then
        grep -vxFf want is >added && fail "$plan grows where doc/results has it falling: $(<added)"
    else
        diff want is || fail "$plan grows elsewhere than doc/results says"
    fi
done
[ "$failures" -eq 0 ]
