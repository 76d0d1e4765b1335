#!/usr/bin/env bash
# Reference tables that somebody damaged: each is told with file and line, and nothing dies.
#   bad_tables.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
tables=$2/tests/reference
own_folder

# MODEL CHECK TABLE COLUMN: a check of the model that reads the column of the table.
while read -r models check table column; do
    for damage in column text cell cut; do
        awk -v FS=, -v OFS=, -v column="$column" -v damage="$damage" '
            /^#/ { print; next }
            !head { head = NR; for (i = 1; i <= NF; i++) if ($i == column) at = i
                    if (damage == "column") $at = "gone"
                    print; next }
            { row++ }
            damage == "text" { $at = "damaged" }
            damage == "cell" && row == 1 { $NF = ""; sub(/,$/, "") }
            damage == "cut" && row == 2 { printf "%s", substr($0, 1, 3); exit }
            { print }' "$tables/$table.csv" >"$table.csv"
        CLOTHBENCH_REFERENCE=$folder timeout 60 "$program" verify "$check" --quick \
            --models "$models" --out rows >out 2>err </dev/null
        code=$?
        if [ "$code" -ne 2 ] || [ -s out ] ||
            ! grep -q "^clothbench: [^ ]*$table.csv:[0-9]*: " err; then
            fail "$check, $table, $damage of $column: exit $code: $(<out) $(<err)"
        fi
    done
    rm "$table.csv"
done <<'TABLE'
mass_spring elastica heavy_elastica Gamma
mass_spring pendulum pendulum_C0_E1e5_h5mm_undamped x1
mass_spring frequencies leissa_plate_frequencies lambda
mass_spring navier navier_plate kirchhoff
mass_spring fabrics fabrics D_eq_Nm
mass_spring hanging beam_elastica_cable v1
mass_spring postbuckling beam_elastica_cable a
mass_spring lateral lateral_buckling Gamma_star_c
mass_spring sze sze_benchmarks exact2
hex outside calculix_tips middle
TABLE
[ "$failures" -eq 0 ]
