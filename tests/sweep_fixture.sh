#!/usr/bin/env bash
# What the scripts that test `clothbench sweep` share: sourced, with $program and $folder set; goes
# to that folder, which is empty then.
# shellcheck disable=SC2034,SC2154 # source_folder, code; program, folder
# shellcheck source=tests/fixture.sh
. "$(dirname "${BASH_SOURCE[0]}")/fixture.sh"
export OMP_NUM_THREADS=1 LC_ALL=C
source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1

# A plan of 12 * $2 cases, milliseconds each, into FILE.
write_plan() { # FILE COUNT
    cat >"$1" <<PLAN
name: fast
source: a test
scene: edge_drop
settings:
  discretization.points: [4,4,2]
  time.end: 0.03
axes:
  damping.value: {from: 0.1, to: 0.9, count: $2}
  gamma: [10, 100, 1000, 1e4]
  material.poisson: [0, 0.3, 0.45]
look: 2
time_limit: 120
verdicts:
  - {label: falls, measure: drop_max, above: 0.001, why: a test}
PLAN
}

sweep() { # ARGUMENT...
    "$program" sweep "$@" </dev/null
}

run() { # ARGUMENT...; a sweep: fills $code, out and err
    sweep "$@" >out 2>err
    code=$?
}
