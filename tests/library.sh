#!/usr/bin/env bash
# The library for other programs, as doc/library.md has it: installed, moved, and the example
# built against it by pkg-config and by find_package; both move as the program does.
#   library.sh PROGRAM SOURCE BUILD COMPILER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1 source=$2 build=$3 compiler=$4
scene=$source/models/scenes/edge_drop.yaml
own_folder

cmake --build "$build" --target clothbench_archive >log.txt 2>&1 || { cat log.txt; exit 1; }
cmake --install "$build" --prefix first >log.txt 2>&1 || { cat log.txt; exit 1; }
mv first "a tree" # what is installed may be moved
pc=$(find "a tree" -name clothbench.pc)
[[ $pc ]] || { echo "no clothbench.pc"; exit 1; }
mv "a tree" tree
PKG_CONFIG_PATH=$PWD/$(dirname "tree${pc#a tree}")
export PKG_CONFIG_PATH

# A cross compiler's sysroot; pkg-config puts it before what lies outside of it, too.
sysroot=${PKG_CONFIG_SYSROOT_DIR-}
read -ra flags <<<"$(pkg-config --cflags --libs clothbench | sed "s|$sysroot$PWD|$PWD|g")"
[ -z "$sysroot" ] || flags+=("--sysroot=$sysroot")
"$compiler" -o by_pkg_config "$source/doc/library/example.c" "${flags[@]}" 2>log.txt ||
    { cat log.txt; fail "pkg-config: does not build"; }
if ! cmake -S "$source/doc/library" -B by_cmake -D CMAKE_C_COMPILER="$compiler" \
    -D CMAKE_PREFIX_PATH="$PWD/tree" >log.txt 2>&1 ||
    ! cmake --build by_cmake >>log.txt 2>&1; then
    cat log.txt
    fail "find_package: does not build"
fi

want=$("$program" run "$scene" --model mass_spring_leapfrog --quiet --probe 1,1,0.5 |
    tail -n 1 | cut -d, -f 5-)
for example in ./by_pkg_config by_cmake/example; do
    got=$("$example" "$scene" mass_spring_leapfrog | tail -n 1 | cut -d' ' -f 2- | tr ' ' ,)
    [[ $want && $got == "$want" ]] || fail "$example ends at $got, the program at $want"
    "$example" "$scene" nobody >out.txt 2>err.txt && fail "$example takes a contestant that is none"
    grep -q "no model or contestant 'nobody'" err.txt || fail "$example: $(cat err.txt)"
done
exit $((failures > 0))
