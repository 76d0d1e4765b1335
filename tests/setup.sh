#!/usr/bin/env bash
# ./check and ./reproduce where something is in the way. Nothing is installed or built: they
# run in a copied folder and find pretended commands first in PATH.
set -uo pipefail

source=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

mkdir "$folder/tools" "$folder/bin"
cp "$source/check" "$source/reproduce" "$folder"
cp "$source/tools/setup.sh" "$folder/tools"
for tool in bash cat chmod dirname env flock mkdir mktemp nproc rm sed sleep tail tee mv; do
    ln -s "$(command -v "$tool")" "$folder/bin"
done

pretend() { # COMMAND SCRIPT
    printf '#!/usr/bin/env bash\n%s\n' "$2" >"$folder/bin/$1"
    chmod +x "$folder/bin/$1"
}

run() { # COMMAND...; fills $code and $output
    output=$(cd "$folder" && PATH="$folder/bin" OS_RELEASE="$folder/os-release" CI='' "$@" 2>&1)
    code=$?
}

expect() { # CASE CODE TEXT...
    local name=$1 want=$2 text
    shift 2
    [ "$code" -eq "$want" ] || { echo "$name: exit $code, want $want" && ((++failures)); }
    for text in "$@"; do
        [[ $output == *"$text"* ]] || { echo "$name: '$text' is not in: $output" && ((++failures)); }
    done
}

expect_not_installed() { # CASE
    [ ! -e "$folder/installed" ] || { echo "$1: apt-get was run" && ((++failures)); }
    rm -f "$folder/installed"
}

mapfile -t names < <(bash "$folder/check" --help | sed -n 's/^  \([a-z0-9-]*\)  .*/\1/p' |
    grep -v python3-numpy)
debian='ID=debian VERSION_ID="12"'
# shellcheck disable=SC2016 # for the pretended command to expand
pretend apt-get 'echo "$@" >>"${0%/*}/../installed"'
pretend dpkg-query 'exit 1'
pretend id 'echo 1000'

for other in 'ID=fedora VERSION_ID=41' 'ID=debian VERSION_ID="11"'; do
    echo "${other// /$'\n'}" >"$folder/os-release"
    run ./check
    expect "$other" 1 'not Debian 12' libsuitesparse-dev libyaml-dev 'check: '
    expect_not_installed "$other"
done

echo "${debian// /$'\n'}" >"$folder/os-release"
run ./reproduce
expect 'neither root nor sudo' 1 \
    'reproduce: ' 'no sudo here' 'as root run: apt-get install gcc libc6-dev'
expect_not_installed 'neither root nor sudo'

pretend sudo 'exit 1'
run ./check
expect 'sudo refuses' 1 'sudo refused; as root run: apt-get install gcc'
expect_not_installed 'sudo refuses'

pretend id 'echo 0'
pretend apt-get 'echo no such host; exit 100'
run ./check
expect 'no network' 1 'no such host' 'apt-get update failed' 'packages failed'

# A source that has nothing to do with it is broken; nothing may be removed.
# shellcheck disable=SC2016
pretend apt-get '[[ " $* " != *" update "* ]] || exit 100; echo "$@" >>"${0%/*}/../installed"'
pretend cmake 'exit 1'
run ./check
expect 'a broken source' 1 'apt-get update failed' 'configure failed'
grep -q -- '--no-remove.* gcc libc6-dev' "$folder/installed" ||
    { echo "nothing was installed without removing: $(cat "$folder/installed")" && ((++failures)); }
rm -f "$folder/installed"

# shellcheck disable=SC2016
pretend apt-get 'echo "$@" >>"${0%/*}/../installed"'
pretend dpkg-query "printf 'installed , numpy-qt, numpy, python3-numpy (= 5),\\n'
    for name in $(printf '%s ' "${names[@]}"); do
        printf 'installed , %s, ,\\n' \$name \$name # for two architectures
    done"
pretend cmake 'echo a clumsy compiler; exit 1'
run ./check
expect 'configuring fails' 1 'packages   all' 'a clumsy compiler' 'configure failed'
expect_not_installed 'all packages there'

# What a shell may have exported, and a build/ that something else made.
# shellcheck disable=SC2016
pretend cmake 'echo "$@" >>"${0%/*}/../asked"; env >|"${0%/*}/../environment"
    [ "$1" != --build ]'
mkdir -p "$folder/build"
printf '%s\n' 'CMAKE_GENERATOR:INTERNAL=Unix Makefiles' \
    "CMAKE_HOME_DIRECTORY:INTERNAL=$folder" >"$folder/build/CMakeCache.txt"
run env SHELLOPTS=noclobber CDPATH=/ GIT_DIR=/nowhere CMAKE_C_COMPILER_LAUNCHER=nowhere \
    TMPDIR=/nowhere ./check
expect 'exported' 1 'no nowhere: built without it' 'build/tmp is taken' 'build failed'
grep -q -- '--preset release .*BUILD_TESTING=ON.*--fresh' "$folder/asked" ||
    { echo "not configured afresh: $(cat "$folder/asked")" && ((++failures)); }
if grep -qE '^(GIT_DIR|CDPATH|CMAKE_C_COMPILER_LAUNCHER)=' "$folder/environment"; then
    echo 'variables of another place are handed on' && ((++failures))
fi

# A build/ whose launcher is gone, or that was made for another place.
for stale in "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere" "CMAKE_C_COMPILER_LAUNCHER:STRING=nowhere"; do
    printf '%s\n' "CMAKE_GENERATOR:INTERNAL=Ninja" "$stale" "CMAKE_HOME_DIRECTORY:INTERNAL=$folder" |
        awk -F: '!seen[$1]++' >"$folder/build/CMakeCache.txt"
    rm "$folder/asked"
    run ./check
    grep -q -- '--preset release .*--fresh' "$folder/asked" ||
        { echo "not configured afresh with $stale: $(cat "$folder/asked")" && ((++failures)); }
done

# What takes long says a line a minute in a pipe (here its minutes are short).
printf '[3/9] building\n' >"$folder/long.log"
# shellcheck disable=SC2016
output=$(cd "$folder" && bash -c '. tools/setup.sh; sleep() { :; }; set +o pipefail
    command sleep 100 & setup_follow $! long.log | head -n 1; kill $!' check 2>&1)
code=$?
expect 'a long command' 0 '1 min, 3 of 9'

# A folder's name may have what a shell takes for its own: commands that generate have it, too.
# shellcheck disable=SC2016 # the name has a dollar sign
odd=$folder/'a$b (1)'
ln -s "$source" "$odd"
mkdir "$folder/broken" # MPI that is half there
for name in mpi-c ompi-c mpich; do
    printf 'Name: x\nDescription: x\nVersion: 1\nRequires: nowhere\n' >"$folder/broken/$name.pc"
done
output=$(PKG_CONFIG_PATH=$folder/broken cmake -G Ninja -S "$odd" -B "$odd built" 2>&1 &&
    for file in provenance tests/toy_table.c; do
        ninja -C "$odd built" -t commands $file | tail -n 1 | bash 2>&1 || exit
    done)
code=$?
expect 'an odd folder, half of MPI' 0 'one machine' 'Generating done'

for character in '"' ';' \\ '#' '[' ']' '<' '>' '|' $'\n'; do
    odd="$folder/${character}x"
    mkdir "$odd"
    cp -r "$folder/check" "$folder/reproduce" "$folder/tools" "$odd"
    for program in check reproduce; do
        run "$odd/$program"
        expect "a folder with ${character@Q}" 1 "$program: the folder" "has ${character@Q} in its name" 'rename it'
    done
    [ ! -e "$odd/build" ] || { echo "built in a folder with ${character@Q}" && ((++failures)); }
done

run ./reproduce --fast
expect 'unknown option' 2 'usage: ./reproduce'
run ./reproduce --help
expect 'help' 0 'usage: ./reproduce' libhdf5-dev
run ./check --help
expect 'help' 0 'usage: ./check' libhdf5-dev

[ "$failures" -eq 0 ]
