#!/usr/bin/env bash
# Shell scripts and man page, by tools that .ci/run installs and ./check does not: skipped,
# exit 77, without them.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v shellcheck >/dev/null && command -v mandoc >/dev/null || exit 77

shellcheck --external-sources check reproduce .ci/run doc/refresh tools/*.sh tools/plant tools/aarch64 peers/run peers/bullet/run peers/tinyvbd/run tests/*.sh fem_ref/freefem/*.sh
mandoc -T lint -W warning doc/clothbench.1
