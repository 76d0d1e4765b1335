#!/usr/bin/env bash
# The version is CMake's, and every file that repeats it, or the day of its release, has the same;
# CHANGELOG.md has a section for it, below one for what is not released yet.
#   version.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
cd "$2" || exit 1
version=$(sed -n 's/^project(clothbench VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
day=$(sed -n "s/^## \[$version\] - \(20[0-9-]*\)\$/\1/p" CHANGELOG.md)

same() { # FILE WORDS EXPRESSION; what sed finds in FILE is WORDS
    local found
    found=$(sed -n "s/$3/\1/p" "$1" | head -n 1)
    [ "$found" = "$2" ] || fail "$1 has '$found' where '$2' is right"
}

[[ $day ]] || fail "CHANGELOG.md has no section '## [$version] - DAY'"
[[ $("$program" --version) =~ "clothbench $version"$'\n' ]] || fail "the program is not of version $version"
same CHANGELOG.md Unreleased '^## \[\(.*\)\].*'
same CITATION.cff "$version" '^version: \(.*\)$'
same CITATION.cff "$day" '^date-released: "\(.*\)"$'
same doc/clothbench.1 "$version" '^\.TH .* "clothbench \(.*\)"$'
for key in cff-version message type title abstract authors license keywords references doi; do
    grep -q "^ *$key: " CITATION.cff || grep -q "^ *$key:\$" CITATION.cff || fail "CITATION.cff has no $key"
done
[ "$failures" -eq 0 ]
