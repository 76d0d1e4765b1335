#!/usr/bin/env bash
# What tests that are scripts share: sourced. `fail` tells and counts; `own_folder` goes to an
# empty folder that is gone at the end.
# shellcheck disable=SC2034 # failures
set -uo pipefail
failures=0

fail() {
    echo "$*"
    ((++failures))
}

own_folder() {
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    cd "$folder" || exit 1
}
