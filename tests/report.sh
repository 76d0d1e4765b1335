#!/usr/bin/env bash
# The page that `report` writes: verdicts that follow the numbers, what is missing or damaged
# told, nothing of a file taken for markup, and a limit to its size. The results are those of
# doc/results, changed row by row.
#   report.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
results=$2/doc/results
skeleton=$2/bench/report/page.html
own_folder
# Empty files stand before the stored truths: what a page is held to below needs none, and to
# read them all takes a second a page.
mkdir light
for truth in "$2"/bench/truths/*.h5; do : >"light/${truth##*/}"; done
export CLOTHBENCH_TRUTHS=$PWD/light

page() { # FOLDER; page.html, $code
    rm -f page.html
    "$program" report "$1" --out page.html >out 2>err </dev/null
    code=$?
}

good() { # FOLDER
    page "$1"
    [ "$code" -eq 0 ] || fail "report $1: exit $code: $(<err)"
    [ "$(stat -c %s page.html)" -lt 10000000 ] || fail "report $1: the page has 10 MB"
}

has() { # TEXT; in the page
    grep -qF -- "$1" page.html || fail "the page has no: $1"
}

verdict() { # CLAIM WANT
    local is
    is=$(tr '{' '\n' <page.html | grep -F -- "\"claim\":\"$1\"," | head -n 1 |
        sed 's/.*"verdict":"\([^"]*\)".*/\1/')
    [ "$is" = "$2" ] || fail "'$1' is '$is', want '$2'"
}

has_quick() { # whether the claims of Table 4 are of a quick run
    tr '{' '\n' <page.html | grep -F '"part":"table4"' | grep -cF '"quick":true' >/dev/null # reads on: a pipe that closes early fails
}

# --- nothing there
mkdir empty
good empty
has '"verdict":"not run","text":"clothbench table 1"'
has '"verdict":"not run","text":"clothbench study mesh"'
has '"verdict":"not run","text":"clothbench study fig6"'
[ "$(grep -o '"there":true' page.html)" = '' ] || fail 'an empty folder has a part'
page nowhere
[ "$code" -eq 2 ] || fail "no folder: exit $code"
[ "$(wc -l <err)" -eq 1 ] || fail "no folder: not one line: $(<err)"
[ ! -e page.html ] || fail 'no folder, and a page'

# --- verdicts are those of the command, and a quick run is told
claim='rows 14 and 15 alone are feasible'
mkdir changed
cp "$results/table4.csv" changed
good changed
verdict "$claim" 'does not hold'
sed -E "s/($claim,\"[^\"]*\"),does not hold/\\1,holds/" "$results/table4.csv" >changed/table4.csv
good changed
verdict "$claim" holds
! has_quick || fail 'a full run is told as a quick one'
touch changed/quick.txt
good changed
has_quick || fail 'quick.txt is not seen'
rm changed/quick.txt
sed '1s/^.*$/# clothbench table 4 --format csv --quick | commit/' "$results/table4.csv" >changed/table4.csv
good changed
has_quick || fail 'a quick command is not seen'

# --- the four sentences on what was found, each turned by what is in the folder
found() { # NUMBER, words that the sentence has
    sed -n 's/.*"found":\[\([^]]*\)\].*/\1/p' page.html | sed 's/","/\n/g' | sed -n "${1}p" | grep -cF -- "$2" >/dev/null ||
        fail "sentence $1 has not: $2"
}
good empty
found 1 'claims 0 hold and 0 do not; '
found 2 'Speed against error was not measured: clothbench compare edge_drop'
found 3 'Nothing was compared with closed forms: clothbench verify'
found 4 'Contact was not run: clothbench study touching'
rm -rf changed
mkdir changed
for verdict in holds holds 'does not hold' open; do
    [ -s changed/study_mesh.csv ] || printf '# Sentences of the paper\nsource,claim,verdict,sentence\n,a,holds,s\n' >changed/study_mesh.csv
    echo "4.3,c,$verdict,s" >>changed/study_mesh.csv
done
cat >changed/compare.csv <<'TABLE'
title,contestant,model,side,step_s,iterations,seconds,worst_rmse_over_length,front
slow,a,one,5,0.005,,9,0.009,1
quick,b,one,5,0.005,,1.26,0.01,1
rough,c,one,5,0.005,,0.1,0.02,1
other,d,two,5,0.005,,2.52,0.001,1
far,e,three,5,0.005,,0.2,0.5,1
none,f,four,5,0.005,,,0.001,0
TABLE
mkdir changed/verify
printf 'check,quantity,verdict\na,b,met\na,b,MISSED\n' >changed/verify/a.csv
printf 'check,quantity,verdict\na,b,met\na,b,died\na,b,met\na,b,no claim\n' >changed/verify/b.csv
cat >changed/study_touching.csv <<'TABLE'
study,level,time_s,penetration,crossings
fold,a,1,0.0001,0
fold,a,2,,2
fold,a,3,0.0002,2
fold,b,1,0.00126,0
wipe,b,1,0.001,0
wipe,c,1,,
TABLE
good changed
found 4 'In 1 of 3 runs of scenes with contact a sheet passes through itself or another; a body is at most 1.3 mm deep'
found 1 ' claims 2 hold and 1 do not; '
found 1 ' 1 claims of ours '
found 2 '1 % of the length on edge_drop is 1.3 s, by quick; the next model, other, takes 2 times as long.'
found 3 ' 3 have it and 2 do not.'
grep -oP '"chart":"\K[^"]*' page.html | grep -cP '/b.u003e quick.*/b.u003e other.*/b.u003e far' >/dev/null ||
    fail 'the chart has not the best contestant of each model'
sed -i 's/,0.001,1$/,0.5,1/' changed/compare.csv
good changed
found 2 ' is 1.3 s, by quick.'
sed -i '/,one,/d' changed/compare.csv
good changed
found 2 'No run of edge_drop comes within 1 % of the length.'

# --- damaged: told with file and line, and the other parts are there
rm -rf changed
mkdir changed
cp "$results"/table[1234].csv changed
sed -i '5s/,[^,]*$//' changed/table1.csv
good changed
verdict 'Table 1: cost at comparable looks' damaged
has 'changed/table1.csv, line 5: 17 cells below 18 keys'
verdict 'rows 14 and 15 alone are feasible' 'does not hold'
printf 'no table\0' >changed/table1.csv
good changed
has 'changed/table1.csv: has a byte 0'
: >changed/table1.csv
good changed
has 'changed/table1.csv has no table in it'

# --- hostile names: the page has the tags of its skeleton, and no others
hostile='</script><script>alert(1)</script><img src=x onerror=alert(2)><!--'
odd="o\"dd<b>&'"
mkdir -p "$odd/study_mesh" "$odd/compare_edge_drop" "$odd/table1"
{
    printf '# %s\n%s,"%s"\n"%s",\xff\xfe\n# %s\n\n' "$hostile" "$hostile" "$hostile" \
        "$hostile" "$hostile"
    printf '# Sentences of the paper\nclaim,verdict,sentence\n%s,holds,%s\n' "$hostile" "$hostile"
} >"$odd/study_mesh/printed.csv"
printf 'a\n%s,\n' "$hostile" >"$odd/table1/printed.csv" # damaged
printf 'title,contestant,model,side,step_s,iterations,seconds,worst_rmse_over_length,front\n%s,%s,%s,5,0.005,nan,1,0.1,1\n' \
    "$hostile" ../../etc/passwd "$hostile" >"$odd/compare_edge_drop/compare.csv"
good "$odd"
for tag in '<script' '</script' '<img' '<b>' '<!--'; do
    [ "$(grep -oF -- "$tag" page.html | wc -l)" -eq "$(grep -oF -- "$tag" "$skeleton" | wc -l)" ] ||
        fail "a file's '$tag' is in the page as it stands"
done
has '\u003c/script\u003e\u003cscript\u003ealert(1)'
LC_ALL=C sed -n 's/.*id="data">\(.*\)<.script>/\1/p' page.html >data.json
python3 -c 'import json; d = json.load(open("data.json", encoding="utf-8", errors="replace"))
rows = [p for p in d["parts"] if p["id"] == "study_mesh"][0]["tables"][0]["rows"]
assert rows[0][1] == "\ufffd" * 2, rows' || fail 'what the page holds is no JSON of the files'

# --- motions: all frames of a run's file; what cannot be read is told, the rest is there
unset CLOTHBENCH_TRUTHS
mkdir -p moves/run_edge_drop
sheet=(--model mass_spring --set 'discretization.points=[4,4]' --set time.end=0.05 --quiet)
"$program" run edge_drop "${sheet[@]}" --out moves/run_edge_drop/sound.h5 2>err || fail "run: $(<err)"
"$program" run corners_drop "${sheet[@]}" --out moves/run_edge_drop/other.h5 2>err || fail "run: $(<err)"
sound=moves/run_edge_drop/sound.h5
size=$(stat -c %s "$sound")
head -c $((size / 2)) "$sound" >moves/run_edge_drop/cut.h5
{ head -c $((size - 1000)) "$sound" && printf x && tail -c 999 "$sound"; } >moves/run_edge_drop/changed.h5
cp "$2/bench/truths/sphere.h5" moves/run_edge_drop/truth.h5
printf 'no HDF5\n' >moves/run_edge_drop/words.h5
mkdir -p moves/table2 moves/table3 moves/study_cures
{ printf '\x89PNG\r\n\x1a\n' && head -c 100 /dev/zero; } >moves/table2/cost.png
printf 'no PNG\n' >moves/table3/cost.png
mkdir moves/study_cures/cures.png
good moves
sed -n 's/.*id="data">\(.*\)<.script>/\1/p' page.html >data.json
python3 - <<'SCRIPT' || fail 'motions and pictures are not told as they are'
import base64, json
data = json.load(open("data.json", encoding="utf-8"))
motion = {m["name"]: m for m in data["motions"]}
assert motion["truth"]["truth"] and len(motion["truth"]["time"]) >= 10
sound = motion["sound.h5"]
assert len(sound["time"]) == 11 and abs(sound["time"][3] - 0.015) < 1e-6, sound["time"]
assert len(base64.b64decode(sound["data"])) == 2 * 11 * 3 * sound["side"] ** 2
for name, words in {"other": "of the scene corners_drop", "cut": "cut.h5", "changed": "changed.h5",
                    "truth": "truth.h5", "words": "words.h5"}.items():
    said = motion[name + ".h5"]
    assert words in said["trouble"] and "data" not in said, said
trouble = [p["trouble"] for p in data["pictures"]]
assert len(trouble) == 3 and all(p["data"] is None for p in data["pictures"]), trouble
assert trouble[0].endswith("table2/cost.png: is cut short"), trouble
assert trouble[1].endswith("table3/cost.png: is no PNG"), trouble
assert "cures.png: it is a directory" in trouble[2], trouble
SCRIPT
# more frames than there is room for: every so many of them, never beyond 10 MB
for n in {1..20}; do cp "$sound" "moves/run_edge_drop/more_$n.h5"; done
"$program" run edge_drop "${sheet[@]}" --set time.end=0.5 --out moves/run_edge_drop/long.h5 2>err
good moves
grep -q '"name":"long.h5","truth":false,"side":12,"stride":[2-9],' page.html || fail 'a long run has all its frames'

sed -n 's/.*id="data">\(.*\)<.script>/\1/p' page.html >data.json
python3 - <<'SCRIPT' || fail 'frames of a long run stand at the times of others'
import base64, json, struct
motion = {m["name"]: m for m in json.load(open("data.json", encoding="utf-8"))["motions"]}
def frame(m, n):
    size = 3 * m["side"] ** 2
    words = struct.unpack_from(f"<{size}h", base64.b64decode(m["data"]), 2 * size * n)
    return [m["scale"] * w for w in words]
long, sound = motion["long.h5"], motion["sound.h5"]
same = [n for n, t in enumerate(sound["time"]) if abs(t - long["time"][1]) < 1e-6]
apart = max(abs(a - b) for a, b in zip(frame(long, 1), frame(sound, same[0])))
assert same[0] > 0 and apart <= (long["scale"] + sound["scale"]) / 2 + 1e-9, apart
SCRIPT

# --- a stored truth that is damaged: told, and runs are played without it
mkdir truths
printf 'no truth\n' >truths/edge_drop.h5
CLOTHBENCH_TRUTHS=$PWD/truths "$program" report moves --out page.html >out 2>err || fail "damaged truth: exit $?"
grep -q '"name":"truth","trouble":"[^"]*truths/edge_drop.h5' page.html || fail 'a damaged truth is not told'
has '"name":"sound.h5","truth":false'

# --- no room on the disk: a sentence, exit 1, and the page of before is as it was
cp page.html before.html
(ulimit -f 100 && exec "$program" report moves --out page.html) >out 2>err
code=$?
[ "$code $(wc -l <err)" = '1 1' ] || fail "a full disk: exit $code: $(<err)"
cmp -s page.html before.html || fail 'a full disk, and another page'
[ "$(find . -name '*.part' | wc -l)" -eq 0 ] || fail 'a full disk, and half a page is left'

# --- pictures: the bytes of a file; what would make the page too large is named
export CLOTHBENCH_TRUTHS=$PWD/light
mkdir -p large/study_flag large/study_mesh large/table2
printf '\x89PNG\r\n\x1a\n' | cat - "$program" | head -c 20001 >large/table2/cost.png
printf 'IEND\xae\x42\x60\x82' >>large/table2/cost.png
good large
grep -oP '"data":"\KiVBOR[^"]*' page.html | base64 -d | cmp - large/table2/cost.png ||
    fail 'a picture is not that of its file'
for name in study_flag/flag_sheets study_mesh/corners_sheets study_mesh/edge_sheets; do
    { printf '\x89PNG\r\n\x1a\n' && head -c 3800000 /dev/zero && printf 'IEND\xae\x42\x60\x82'; } >"large/$name.png"
done
good large
has 'study_flag/flag_sheets.png","paper":"Fig. 15, flag falling, at 0.75, 1.0 and 2.075 s","trouble":"","data":null'
[ "$(grep -oF '"data":null' page.html | wc -l)" -eq 2 ] || fail 'not one of three fits'
exit $((failures > 0))
