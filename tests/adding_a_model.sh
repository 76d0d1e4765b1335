#!/usr/bin/env bash
# Follows the steps of doc/adding_a_model.md in a copy of the sources, by what the page says: the
# new model compiles, is in the table, and is in layer.
#   adding_a_model.sh SOURCE-FOLDER CMAKE CC FLAG...
set -euo pipefail
source=$1 cmake=$2 cc=$3
shift 3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
page=$source/doc/adding_a_model.md
mapfile -t folders < <(sed -n 's/^\([a-z_]*\)[a-z_/]*:.*/\1/p' "$source/tests/layers.txt" | sort -u)
(cd "$source" && cp -r "${folders[@]}" CMakeLists.txt "$folder")
cd "$folder"

# 1
mkdir strands
for end in c h; do
    sed -e 's/toy_model/strands_model/g; s/TOY_MODEL/STRANDS_MODEL/g; s/TESTS_STRANDS/STRANDS/' \
        -e 's|"tests/strands|"strands/strands|; s/\.name = "toy"/.name = "strands"/' \
        "tests/toy_model.$end" >"strands/strands_model.$end"
done
# 2
[ "$(grep -c '^set(MODEL_FOLDERS ' CMakeLists.txt)" -eq 1 ] || { echo "no MODEL_FOLDERS" && exit 1; }
# 3
step=$(sed -n '/^3\. /,/^4\. /p' "$page" | tr '\n' ' ')
# shellcheck disable=SC2016 # backticks of the page
pattern='a line `([^`]*)` above that of `([^`]*)`, and `([^`]*)` in the +line of `([^`]*)`'
[[ $step =~ $pattern ]] ||
    { echo "step 3: $step" && exit 1; }
sed -i -e "s|^${BASH_REMATCH[2]}:|${BASH_REMATCH[1]}\n&|" \
    -e "s|^${BASH_REMATCH[4]}: .*|& ${BASH_REMATCH[3]}|" tests/layers.txt
# 4
table=bench/harness/contestant_table.c
include=$(sed -n 's/^ *\(#include "strands[^ ]*\)$/\1/p' "$page")
row=$(sed -n '/^ *{"strands",/,/},$/p' "$page" | tr -d '\n')
sed -i -e "0,/^#include \"shell_ref/s|^#include \"shell_ref|$include\n&|" \
    -e "s|^    {NULL},|    ${row//&/\\&}\n&|" $table
grep -q strands_model, $table || { echo "step 4: $row" && exit 1; }

"$cmake" -D SOURCE="$folder" -P tests/check_layers.cmake
for file in strands/strands_model.c $table; do
    "$cc" "$@" -I "$folder" -Wall -Werror -fsyntax-only "$file"
done
