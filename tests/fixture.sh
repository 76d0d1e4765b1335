#!/usr/bin/env bash
# What tests that are scripts share: sourced, with $program set. `fail` tells and counts;
# `own_folder` goes to an empty folder that is gone at the end; the others run the program and
# leave what it prints in the files `out` and `err`.
# shellcheck disable=SC2154 # program
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

ends() { # CODE ARGUMENT...: so it ends
    local want=$1 code
    shift
    "$program" "$@" >out 2>err </dev/null
    code=$?
    [ "$code" -eq "$want" ] || fail "$*: exit $code, want $want: $(<err)"
}

good() { # ARGUMENT...
    ends 0 "$@"
}
