# Completion of clothbench in bash: commands, options, names and keys, as the program itself
# lists them. Debian's bash-completion loads the installed file by itself.

_clothbench_names() { # KIND: the names of `clothbench list KIND`
    "$program" list "$1" 2>/dev/null | sed -n 's/^\([a-z0-9_-]\{1,\}\)\( .*\)\?$/\1/p'
}

_clothbench_words() { # all words that may stand here
    local values
    case $before in
    --model | --models | --contestant)
        _clothbench_names contestants
        return
        ;;
    --set)
        "$program" help scene 2>/dev/null | sed -n 's/^  \([a-z][a-z.]*\) .*/\1=/p'
        return
        ;;
    --*) # the words that the help of the option names: --format text|csv|...
        values=$("$program" "$command" --help 2>/dev/null | sed -n "s/^  $before \([a-z]*|[a-z|]*\).*/\1/p")
        [ -z "$values" ] || { tr '|' '\n' <<<"$values" && return; }
        ;;
    esac
    case $command,$word in
    *,-*) "$program" "$command" --help 2>/dev/null | grep -o -e '--[a-z][a-z-]*' ;;
    list,*) "$program" list 2>/dev/null | sed -n 's/^\([a-z]*\):$/\1/p' ;;
    study,*) _clothbench_names studies ;;
    sweep,*) _clothbench_names plans ;;
    verify,*) _clothbench_names checks ;;
    stress,*) _clothbench_names cases ;;
    bench,*) _clothbench_names benchmarks ;;
    table,*) _clothbench_names tables ;;
    help,*) "$program" help 2>/dev/null | sed -n 's/^  \([a-z]\{1,\}\) .*/\1/p' ;;
    run,* | compare,* | advise,* | truth,* | export,* | score,*) _clothbench_names scenes ;;
    esac
}

_clothbench() {
    local program=$1 word=$2 before=$3 command=${COMP_WORDS[1]}
    [ "$COMP_CWORD" -gt 1 ] || command=help
    mapfile -t COMPREPLY < <(compgen -W "$(_clothbench_words | sort -u)" -- "$word")
    [[ ${COMPREPLY[*]} != *= ]] || compopt -o nospace 2>/dev/null
}
complete -o default -F _clothbench clothbench
