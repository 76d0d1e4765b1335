#!/usr/bin/env bash
# setup.sh - what ./check and ./reproduce do first; sourced by them, not run.
#
# Looks for the Debian packages that clothbench is built from, installs the missing ones,
# configures and builds. Needs bash and what every Debian has. People see one line a phase;
# the rest is in build/*.log.
set -euo pipefail

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
    "libmd4c-dev: reads the manual's pages for a site"
    "libmd4c-html0-dev: makes them HTML"
    "gnuplot-nox: draws the charts"
    "python3: holds the figures of README.md and doc/ against doc/results (a test)"
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

# Runs a command with its output in build/NAME.log; on failure shows the end of the log.
setup_logged() { # NAME COMMAND...
    local name=$1 log=$build/$1.log
    shift
    "$@" >"$log" 2>&1 </dev/null && return
    tail -n 30 "$log" >&2
    setup_fail "$name failed; the end of build/$name.log is above"
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

# Packages of the list that are not installed, a row each.
setup_missing() {
    local row
    for row in "${packages[@]}"; do
        [ "$(dpkg-query -W -f '${db:Status-Status}' "${row%%:*}" 2>/dev/null)" = installed ] ||
            printf '%s\n' "$row"
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
    setup_logged packages-update "${apt[@]}" update
    setup_logged packages "${apt[@]}" install --no-install-recommends "${names[@]}"
}

# Configures build/ and builds TARGET of it.
setup_build() { # TARGET
    local home fresh=()
    # A folder that was moved or copied has a build/ that names the old place.
    home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null ||
        true)
    [ -z "$home" ] || [ "$home" = "$top" ] || fresh=(--fresh)
    setup_say configure "Release, in build/"
    cd "$top"
    setup_logged configure cmake --preset release "${fresh[@]}"
    setup_say build "this takes a minute the first time"
    setup_logged build cmake --build --preset "$1"
}

setup() { # BUILD-PRESET
    setup_lock
    setup_packages
    setup_build "$1"
}
