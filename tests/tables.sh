#!/usr/bin/env bash
# Tables 1 to 4 from end to end, by quick runs: claims, files, and what an independent
# prototype found of Table 1. No test depends on seconds.
#   tables.sh PROGRAM
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
own_folder

# The prototype (h = 1 mm instead of 1.177 mm) has these RMSE of 32x32x2 to IGA, in metres; a
# difference of more than a fifth would want an explanation.
prototype() { # STUDY TIME RMSE
    awk -F, -v study="$1" -v time="$2" -v want="$3" '
        NR == 1 { for (n = 1; n <= NF; n++) at[$n] = n }
        $at["study"] == study && $at["model"] == "hex" && $at["net"] == "32x32x2" && $at["scene"] == "edge" &&
            $at["time_s"] - time < 1e-9 && time - $at["time_s"] < 1e-9 {
            found = $at["apart"] > 0.8 * want && $at["apart"] < 1.2 * want }
        END { exit !found }' results/table1/table1.csv ||
        fail "Table 1, $1, $2 s: hexahedra 32x32x2 are not $3 m from IGA"
}

for n in 1 2 3 4; do
    "$program" table "$n" --quick >"text$n" 2>err || fail "table $n: $(<err)"
    grep -q '^Measured: ' "text$n" || fail "table $n does not tell the machine"
    ! grep -q 'cannot be judged' "text$n" || fail "table $n: $(grep 'cannot be' "text$n")"
    "$program" table "$n" --from "results/table$n" --format csv >"csv$n" 2>err ||
        fail "table $n --from: $(<err)"
    name=table$n
    [[ $n != 4 ]] || name=table4-readings
    grep -v '^#' "csv$n" | sed '/^$/d' | diff - "results/table$n/$name.csv" >&2 ||
        fail "table $n: $name.csv is not what is printed"
done
prototype printed 0.2 0.042
prototype printed 0.3 0.043
prototype incremental 0.2 0.027
prototype incremental 0.3 0.045
"$program" report results --out page.html >out 2>err || fail "report: $(<err)"
for claim in 'hexahedra of 32x32x2 take 176 times' 'degree 4 takes 3.37 times' 'degree (1,3,3) takes 2.08'; do
    grep -qF -- "$claim" page.html || fail "the page has no: $claim"
done
exit "$failures"
