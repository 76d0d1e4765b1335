#!/usr/bin/env bash
# Recomputes the stored FreeFEM fields, tests/reference/freefem_*.csv (about 25 minutes on one core)
# or those named:
#
#   fem_ref/freefem/store.sh FOLDER [NAME...]
#
# Each file holds the answer of the finest run. Its error bar is measured, not assumed:
# mesh_error_m, from the rms difference d of two meshes of n > m boxes a side, is what second
# order leaves at n, d / ((n/m)^2 - 1) (observed orders: 2.2 to 2.6); step_error_m is the
# rms difference between this time step and half of it on a mesh of 10 (told where it is another).
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
target=${1:-$(dirname "$(dirname "$here")")/tests/reference}
wanted=("${@:2}")
script=$here/transient.edp
export FF_LOADPATH='/usr/lib/freefem++;./' FF_INCLUDEPATH='/usr/include/freefem++/idp;;'
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run NAME ARGUMENT...: one run into $work/NAME.csv, its last words into NAME.log
run() {
    local name=$1
    shift
    FreeFem++ -nw -v 0 "$script" -out "$work/$name.csv" "$@" >"$work/$name.log"
    if grep -qiE 'nan|inf' "$work/$name.csv" || grep -q Error "$work/$name.log"; then
        echo "store.sh: $name: no solution, though FreeFEM ended with exit code 0" >&2
        exit 1
    fi
}

# rms FACTOR A B: FACTOR times the rms over the points of |displacement difference|, one
# number per time
rms() {
    paste -d, "$work/$2.csv" "$work/$3.csv" | awk -F, -v factor="$1" '
        NR == 1 { n = NF / 2; next }
        {
            t = n == 6 ? $1 : "static"
            if (!(t in count)) order[++times] = t
            for (c = n - 2; c <= n; c++) sum[t] += ($c - $(c + n)) ^ 2
            count[t]++
        }
        END { for (i = 1; i <= times; i++)
                  printf "%s%.1e", (i > 1 ? " " : ""), factor * sqrt(sum[order[i]] / count[order[i]]) }'
}

# store NAME THICKNESS STEPS POISSON FINE COARSE [N]: the field NAME from two meshes, CELLSxLAYERS,
# and its step error from N (10) boxes a side
store() {
    local name=$1 thickness=$2 steps=$3 poisson=$4 fine=$5 coarse=$6 third=${7:-10}
    local file=$target/freefem_$name.csv plate mesh_error step_error factor
    [ ${#wanted[@]} = 0 ] || [[ " ${wanted[*]} " = *" $name "* ]] || return 0
    plate=(-thickness "$thickness" -poisson "$poisson")
    run fine "${plate[@]}" -cells "${fine%x*}" -layers "${fine#*x}" -steps "$steps"
    run coarse "${plate[@]}" -cells "${coarse%x*}" -layers "${coarse#*x}" -steps "$steps"
    factor=$(awk -v n="${fine%x*}" -v m="${coarse%x*}" 'BEGIN { print 1 / ((n / m)^2 - 1) }')
    mesh_error=$(rms "$factor" fine coarse)
    if [ "$steps" -gt 0 ]; then
        run step "${plate[@]}" -cells "$third" -steps "$steps"
        run half "${plate[@]}" -cells "$third" -steps $((2 * steps))
        step_error=$(rms 1 step half)
    fi
    {
        echo "# Displacements of the mid-surface of a plate 1 m x 1 m, clamped on the face x = 0, under its own weight,"
        echo "# 3-D linear elasticity in FreeFEM (P3 tetrahedra); transient: at rest until t = 0. Computed for this project"
        echo "# by fem_ref/freefem/store.sh; nothing here is shared with a model or with plate theory."
        echo "# script: fem_ref/freefem/transient.edp"
        echo "# script_sha256: $(sha256sum <"$script" | cut -d' ' -f1)"
        echo "# freefem: Debian $(dpkg-query -W -f '${Version}' freefem++), calls itself $(sed 's/.*version //' "$work/fine.log")"
        echo "# date: $(date -u +%F)"
        echo "# mesh: ${fine%x*} x ${fine%x*} x ${fine#*x} boxes in 6 tetrahedra each, graded to the clamp, $(sed 's/ version.*//' "$work/fine.log")"
        echo "# thickness: $thickness"
        echo "# young: 1e5"
        echo "# poisson: $poisson"
        echo "# density: 0.5"
        echo "# gravity: 9.81"
        echo "# steps: $steps"
        echo "# mesh_error_m: $mesh_error"
        if [ "$steps" -gt 0 ]; then
            echo "# step_error_m: $step_error"
            [ "$third" = 10 ] || echo "# step_error_by: $third boxes a side"
        fi
        cat "$work/fine.csv"
    } >"$work/done.csv"
    mv "$work/done.csv" "$file"
    echo "$file: mesh_error_m $mesh_error" >&2
}

store static_h100mm_nu03 0.1 0 0.3 12x4 9x3
store static_h100mm_nu00 0.1 0 0 12x4 9x3
store static_h100mm_nu049 0.1 0 0.49 12x4 9x3
store static_h10mm 0.01 0 0.3 20x1 16x1
store transient_h10mm 0.01 400 0.3 20x1 16x1
store transient_h1177um 0.001177 400 0.3 20x1 16x1
store transient_h1mm 0.001 400 0.3 20x1 16x1 6
