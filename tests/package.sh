#!/usr/bin/env bash
# The Debian package: it names the libraries that it needs, and the program that is unpacked
# from it finds its scenes, plans and references without the source folder and meets its claims;
# so does its Python package.
#   package.sh BUILD [CHECK]...     all checks without one
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
/usr/bin/python3 -c 'import json, sys
for preset in json.load(open(sys.argv[1]))["buildPresets"]:
    if preset["name"] in ("release", "portable") and "clothbench_archive" not in preset["targets"]:
        sys.exit("the preset " + preset["name"] + " does not build what is installed")
' "$(dirname "$0")/../CMakePresets.json" || fail "a preset builds less than cpack and cmake --install take"
own_folder
command -v dpkg-deb >/dev/null || exit 77
(cd "$1" && cpack -G DEB -B "$folder" -D CPACK_DEBIAN_COMPRESSION_TYPE=none) >out 2>&1 || fail "cpack: $(tail -n 3 out)"
package=$(echo clothbench_*.deb)
dpkg-deb -x "$package" root || fail "no package: $package"
needs=$(dpkg-deb -f "$package" Depends)
for name in libcholmod3 libhdf5-103 liblapacke libyaml-0-2 libzip4; do
    [[ $needs == *$name* ]] || fail "the package does not depend on $name: $needs"
done
for file in bin/clothbench share/man/man1/clothbench.1 share/doc/clothbench/copyright \
    share/clothbench/truths/edge_drop.h5 share/bash-completion/completions/clothbench lib/python3/dist-packages/clothbench/truth.py; do
    [ -f "root/usr/$file" ] || fail "$file is not in the package"
done
cd / || exit 1
"$folder/root/usr/bin/clothbench" verify "${@:2}" --quick --out "$folder/rows" >"$folder/out" 2>&1 ||
    fail "verify from the package: $(tail -n 3 "$folder/out")"

# The Python package in it calls the program in it, and the program has its page made by it.
cd "$folder" || exit 1
usr=$folder/root/usr
if /usr/bin/python3 -c 'import h5py, jinja2, matplotlib' 2>/dev/null; then
    PATH=$usr/bin PYTHONPATH=$usr/lib/python3/dist-packages /usr/bin/python3 -c '
import clothbench
assert clothbench.__file__.startswith("'"$usr"'"), clothbench.__file__
assert clothbench.export("edge_drop", 3, 3).x.shape == (12, 3)' >out 2>&1 ||
        fail "Python from the package: $(tail -n 3 out)"
    "$usr/bin/clothbench" report rows --out page.html >out 2>&1 || fail "report from the package: $(tail -n 3 out)"
    grep -q '<table' page.html || fail 'a page of the package has no table'
fi
[ "$failures" -eq 0 ]
