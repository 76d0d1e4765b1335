#!/usr/bin/env bash
# setup.sh - what ./check and ./reproduce do first; sourced by them, not run.
#
# Looks for the Debian packages that clothbench is built from, installs the missing ones,
# configures and builds. Needs bash and what every Debian has. People see one line a phase;
# the rest is in build/*.log.
set -euo pipefail
set +o noclobber # which a shell may have exported
unset CDPATH GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE # of another place

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$top/build
export LC_ALL=C

# Package, and what it is for. The order is the order of printing.
packages=(
    "gcc: the C compiler and OpenMP"
    "libc6-dev: the C library's headers"
    "cmake: configures the build (3.25 or newer) and runs the tests"
    "ninja-build: runs the compiler on what changed"
    "pkg-config: finds the libraries below"
    "libsuitesparse-dev: CHOLMOD, sparse Cholesky factorisation"
    "libopenblas-dev: fast BLAS and LAPACK"
    "liblapacke-dev: LAPACK from C"
    "libarpack2-dev: eigenvalues of large sparse matrices"
    "libhdf5-dev: result files"
    "zlib1g-dev: checksums of result files"
    "libzip-dev: reads frames in NumPy's .npz"
    "libyaml-dev: reads scene files"
    "python3: makes pages, charts and pictures of results"
    "python3-numpy: arrays for it"
    "python3-h5py: reads result files"
    "python3-matplotlib: draws charts and sheets"
    "python3-jinja2: fills pages in"
    "python3-markdown: makes the manual's pages HTML, for a site"
)

setup_say() { # PHASE SENTENCE
    printf '%-10s %s\n' "$1" "$2"
}

setup_fail() { # SENTENCE
    printf '%s: %s\n' "${0##*/}" "$1" >&2
    exit 1
}

setup_print_packages() {
    local row
    for row in "$@"; do
        printf '  %-20s %s\n' "${row%%:*}" "${row#*: }"
    done
}

# Shows how far a process is, from the last "[n/m]" of its log, until it ends: in place on a
# terminal, else a line a minute.
setup_follow() { # PID LOG
    local ticks=0 far
    while kill -0 "$1" 2>/dev/null; do
        sleep 0.2
        far=$(sed -n 's/^\[\([0-9]*\)\/\([0-9]*\)\].*/\1 of \2/p' "$2" | tail -n 1)
        if [ -t 1 ]; then
            printf '\r%-10s %s\033[K\r' "" "$far"
        elif ((++ticks % 300 == 0)); then
            printf '%-10s %d min%s\n' "" $((ticks / 300)) "${far:+, $far}"
        fi
    done
    [ ! -t 1 ] || printf '\033[K'
}

# Runs a command with its output in build/NAME.log; on failure shows the end of the log.
setup_logged() { # NAME COMMAND...
    local name=$1 log=$build/$1.log
    shift
    "$@" >"$log" 2>&1 </dev/null &
    setup_follow $! "$log"
    wait $! && return
    tail -n 30 "$log" >&2
    setup_fail "$name failed; the end of build/$name.log is above"
}

# Refuses a folder whose name has a character that CMake takes for its own.
setup_folder() {
    local character
    for character in '"' ';' \\ '#' '[' ']' '<' '>' '|' $'\n'; do
        [[ $top != *"$character"* ]] ||
            setup_fail "the folder ${top@Q} has ${character@Q} in its name, where CMake cannot build; \
rename it, or move clothbench elsewhere"
    done
}

# One at a time in this folder: the lock is held until the script ends.
setup_lock() {
    if ! mkdir -p "$build" 2>/dev/null || [ ! -w "$build" ]; then
        setup_fail "cannot write to $build; it may belong to another user"
    fi
    command -v flock >/dev/null || return 0
    exec 9>"$build/.lock"
    flock --nonblock 9 && return
    setup_say wait "another ./check or ./reproduce works in this folder"
    flock 9
}

setup_is_debian() {
    local file=${OS_RELEASE:-/etc/os-release}
    [ -r "$file" ] && command -v apt-get >/dev/null && command -v dpkg-query >/dev/null ||
        return 1
    (
        ID='' ID_LIKE='' VERSION_ID=''
        # shellcheck disable=SC1090
        . "$file"
        case $ID in
        debian) [ "${VERSION_ID:-99}" -ge 12 ] ;; # testing and unstable have no number
        *) [[ " $ID_LIKE " == *" debian "* ]] ;;
        esac
    )
}

# Packages of the list that nothing installed provides, a row each. A package may be there for
# two architectures, and another may provide it.
setup_missing() {
    local row there
    # shellcheck disable=SC2016 # for dpkg-query to expand
    there=$(dpkg-query -W -f '${db:Status-Status} , ${Package}, ${Provides},\n' 2>/dev/null |
        sed -n 's/^installed //p' || true)
    for row in "${packages[@]}"; do
        [[ $there == *", ${row%%:*}"[,\ ]* ]] || printf '%s\n' "$row"
    done
}

setup_packages() {
    if ! setup_is_debian; then
        printf 'clothbench is built from these Debian packages:\n' >&2
        setup_print_packages "${packages[@]}" >&2
        setup_fail "this is not Debian 12 or a system made from it, so nothing was installed; \
install the like of these packages yourself, then build by hand as README.md says"
    fi
    local missing names become=()
    mapfile -t missing < <(setup_missing)
    if [ ${#missing[@]} -eq 0 ]; then
        setup_say packages "all ${#packages[@]} are there"
        return
    fi
    setup_say packages "missing, to be installed from Debian:"
    setup_print_packages "${missing[@]}"
    names=("${missing[@]%%:*}")
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null ||
            setup_fail "installing needs root and there is no sudo here; as root run: \
apt-get install ${names[*]}"
        become=(sudo)
        [ -z "${CI:-}" ] || become+=(--non-interactive)
    fi
    # sudo asks here, not inside the log.
    [ ${#become[@]} -eq 0 ] || "${become[@]}" true ||
        setup_fail "sudo refused; as root run: apt-get install ${names[*]}"
    local apt=("${become[@]}" env DEBIAN_FRONTEND=noninteractive
        apt-get -y -o DPkg::Lock::Timeout=600)
    # A source that has nothing to do with these packages may be broken.
    (setup_logged packages-update "${apt[@]}" update) 2>/dev/null ||
        setup_say packages "apt-get update failed (build/packages-update.log); going on without"
    setup_logged packages "${apt[@]}" install --no-install-recommends --no-remove "${names[@]}"
}

# The value of a variable in the cache of build/, nothing without one.
setup_cached() { # NAME
    sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" 2>/dev/null || true
}

# Whether build/ was configured for another place, generator or launcher: it was moved or
# copied, or made by hand.
setup_is_stale() {
    local launcher
    [ -e "$build/CMakeCache.txt" ] || return 1
    launcher=$(setup_cached CMAKE_C_COMPILER_LAUNCHER)
    [ "$(setup_cached CMAKE_HOME_DIRECTORY)" != "$top" ] ||
        [ "$(setup_cached CMAKE_GENERATOR)" != Ninja ] ||
        { [ -n "$launcher" ] && ! command -v "${launcher%%;*}" >/dev/null; }
}

# Sets TMPDIR to a folder in build/ where its own does not let programs be run.
setup_tmpdir() {
    local try
    if try=$(mktemp 2>/dev/null) && printf '#!/bin/sh\n' >"$try" && chmod +x "$try" &&
        "$try" 2>/dev/null; then
        rm -f "$try"
        return
    fi
    [ -z "${try:-}" ] || rm -f "$try"
    export TMPDIR=$build/tmp
    mkdir -p "$TMPDIR"
    setup_say configure "no program can be run in the folder for temporary files; build/tmp is taken"
}

# Configures build/ and builds TARGET of it.
setup_build() { # TARGET
    local fresh=()
    setup_tmpdir
    ! setup_is_stale || fresh=(--fresh)
    if [ -n "${CMAKE_C_COMPILER_LAUNCHER:-}" ] &&
        ! command -v "${CMAKE_C_COMPILER_LAUNCHER%%;*}" >/dev/null; then
        setup_say configure "there is no $CMAKE_C_COMPILER_LAUNCHER: built without it"
        unset CMAKE_C_COMPILER_LAUNCHER
    fi
    setup_say configure "Release, in build/"
    cd "$top"
    setup_logged configure cmake --preset release -D BUILD_TESTING=ON "${fresh[@]}"
    setup_say build "this takes a minute the first time"
    setup_logged build cmake --build --preset "$1"
}

setup() { # BUILD-PRESET
    setup_folder
    setup_lock
    setup_packages
    setup_build "$1"
}
