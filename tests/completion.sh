#!/usr/bin/env bash
# Completion in bash offers what the program has.
#   completion.sh CLOTHBENCH SOURCE
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
# shellcheck source=doc/clothbench.bash
. "$2/doc/clothbench.bash"

offers() { # WANTED, the words so far, the last of them unfinished
    local wanted=$1
    shift
    COMP_WORDS=(clothbench "$@") COMP_CWORD=$#
    _clothbench "$program" "${!#}" "${COMP_WORDS[$(($# - 1))]}"
    [[ " ${COMPREPLY[*]} " == *" $wanted "* ]] || fail "$*: no $wanted in ${COMPREPLY[*]}"
}
offers compare co
offers edge_drop run ed
offers --probe run edge_drop --p
offers shell_selective_3 run edge_drop --model shell_s
offers material.young= run edge_drop --set material.y
offers scenes list s
offers fabrics list f
offers touching study to
offers feasibility sweep fea
offers stack verify st
offers contact bench c
offers strip_swing score strip
offers advise help ad
offers --site report --s
offers markdown compare edge_drop --format m
offers ply export edge_drop --format p
offers 3 table 3
COMP_WORDS=(clothbench run zzz) COMP_CWORD=2
_clothbench "$program" zzz run
[ ${#COMPREPLY[@]} -eq 0 ] || fail "zzz: ${COMPREPLY[*]}"
[ "$failures" -eq 0 ]
