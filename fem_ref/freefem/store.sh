#!/usr/bin/env bash
# Recomputes the stored FreeFEM fields, tests/reference/freefem_*.csv (about 25 minutes on one core),
# or those named: fem_ref/freefem/store.sh [FOLDER [NAME...]]. Exit code 2 where FreeFEM is missing.
# morley_plate is a plate of Morley's triangles, with its mesh, without an error bar: our own must agree.
# Each file holds the finest run. Its error bar is measured, by rms differences over the points:
# mesh_error_m is what second order leaves at n boxes a side of the difference d to m < n boxes,
# d / ((n/m)^2 - 1) (observed orders: 2.2 to 2.6); step_error_m is the difference between this time
# step and half of it on a mesh of 10 (told where it is another).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
target=${1:-${here%/*/*}/tests/reference} wanted=" ${*:2} " script=$here/transient.edp
export FF_LOADPATH='/usr/lib/freefem++;./' FF_INCLUDEPATH='/usr/include/freefem++/idp;;'
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
if ! command -v FreeFem++ >/dev/null; then
    echo "store.sh: FreeFem++ is not installed (Debian: freefem++ libfreefem++ libfreefem++-dev)" >&2
    exit 2
fi
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

run() { # NAME ARGUMENT...: one run into $work/NAME.csv, its last words into NAME.log
    FreeFem++ -nw -v 0 "$script" -out "$work/$1.csv" "${@:2}" >"$work/$1.log"
    if grep -qiE 'nan|inf' "$work/$1.csv" || grep -q Error "$work/$1.log"; then
        echo "store.sh: $1: no solution, though FreeFEM ended with exit code 0" >&2
        exit 1
    fi
}

rms() { # FACTOR A B: FACTOR times the rms of |displacement difference| of 144 points, a number a time
    paste -d, "$work/$2.csv" "$work/$3.csv" | awk -F, -v factor="$1" '
        NR > 1 { for (c = NF / 2 - 2; c <= NF / 2; c++) sum[int((NR - 2) / 144)] += ($c - $(c + NF / 2)) ^ 2 }
        END { for (i = 0; i in sum; i++) printf "%s%.1e", i ? " " : "", factor * sqrt(sum[i] / 144) }'
}

store() { # NAME THICKNESS STEPS POISSON BOXES LAYERS and the coarse mesh's [N boxes for the step error]
    local plate=(-thickness "$2" -poisson "$4") n=${9:-10} mesh_error step_error
    [ "$wanted" = "  " ] || [[ $wanted = *" $1 "* ]] || return 0
    run fine "${plate[@]}" -cells "$5" -layers "$6" -steps "$3"
    run coarse "${plate[@]}" -cells "$7" -layers "$8" -steps "$3"
    mesh_error=$(rms "$(awk "BEGIN { print 1 / (($5 / $7)^2 - 1) }")" fine coarse)
    if [ "$3" -gt 0 ]; then
        run step "${plate[@]}" -cells "$n" -steps "$3"
        run half "${plate[@]}" -cells "$n" -steps $((2 * $3))
        step_error=$(rms 1 step half)
    fi
    cat - "$work/fine.csv" >"$work/done.csv" <<TEXT
# Displacements of the mid-surface of a plate 1 m x 1 m, clamped on the face x = 0, under its own weight,
# 3-D linear elasticity in FreeFEM (P3 tetrahedra); transient: at rest until t = 0. Computed for this project
# by fem_ref/freefem/store.sh; nothing here is shared with a model or with plate theory.
# script: fem_ref/freefem/transient.edp
# script_sha256: $(sha256sum <"$script" | cut -d' ' -f1)
# freefem: Debian $(dpkg-query -W -f '${Version}' freefem++), calls itself $(sed 's/.*version //' "$work/fine.log")
# date: $(date -u +%F)
# mesh: $5 x $5 x $6 boxes in 6 tetrahedra each, graded to the clamp, $(sed 's/ version.*//' "$work/fine.log")
# thickness: $2
# young: 1e5
# poisson: $4
# density: 0.5
# gravity: 9.81
# steps: $3
# mesh_error_m: $mesh_error${step_error:+
# step_error_m: $step_error}$([ "$n" = 10 ] || printf '\n# step_error_by: %s boxes a side' "$n")
TEXT
    mv "$work/done.csv" "$target/freefem_$1.csv" && echo "$target/freefem_$1.csv: mesh_error_m $mesh_error" >&2
}

store static_h100mm_nu03 0.1 0 0.3 12 4 9 3
store static_h100mm_nu00 0.1 0 0 12 4 9 3
store static_h100mm_nu049 0.1 0 0.49 12 4 9 3
store static_h10mm 0.01 0 0.3 20 1 16 1
store transient_h10mm 0.01 400 0.3 20 1 16 1
store transient_h1mm 0.001 400 0.3 20 1 16 1 6

morley() { # NAME CELLS POISSON HOLE WHAT
    [ "$wanted" = "  " ] || [[ $wanted = *" $1 "* ]] || return 0
    FreeFem++ -nw -v 0 "$here/morley.edp" -out "$work/$1" -cells "$2" -poisson "$3" -hole "$4" >"$work/log"
    cat - "$work/$1.csv" >"$target/freefem_$1.csv" <<TEXT
# Heights w of $5 of D = 1, small deflections, under the weights of its
# vertices' areas: Morley's triangle in FreeFEM on freefem_$1.obj, a row per vertex. Computed for this
# project by fem_ref/freefem/store.sh.
# script: fem_ref/freefem/morley.edp
# script_sha256: $(sha256sum <"$here/morley.edp" | cut -d' ' -f1)
# freefem: Debian $(dpkg-query -W -f '${Version}' freefem++)
# date: $(date -u +%F)
# poisson: $3
TEXT
    mv "$work/$1.obj" "$target/freefem_$1.obj" && echo "$target/freefem_$1.csv" >&2
}
morley morley_plate 12 0.3 0 "a plate 1 m x 1 m, clamped on x = 0,"
morley morley_hole 12 0.3 1 "a trapezoid with a round hole, clamped on y = 0,"
