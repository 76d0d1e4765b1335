#!/usr/bin/env bash
# The page and the site that `report` starts Python for: what is made of a folder of results, that
# nothing is made without a folder or without room, and what is said without Python or a package.
# (tests/pages: what is on the page.)
#   report.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
results=$2/doc/results
own_folder
/usr/bin/python3 -c 'import h5py, jinja2, markdown, matplotlib' 2>/dev/null || exit 77

page() { # FOLDER OPTION...; page.html, $code
    rm -f page.html
    "$program" report "$1" --out page.html "${@:2}" >out 2>err </dev/null
    code=$?
}

mkdir some
cp "$results"/{table4,stress}.csv some
mkdir some/run_edge_drop
"$program" run edge_drop --model mass_spring --set 'discretization.points=[4,4]' --set time.end=0.05 \
    --quiet --out some/run_edge_drop/springs.h5 || fail 'run'
"$program" run edge_drop --model mass_spring --set time.end=0.05 --quiet --out sheet.h5 --picture sheet.png 2>err ||
    fail "--picture: $(<err)"
head -c 4 sheet.png | grep -q PNG || fail '--picture draws no PNG'
CLOTHBENCH_PYTHON=/nowhere "$program" run edge_drop --model mass_spring --set time.end=0.05 --quiet --out again.h5 \
    --picture again.png 2>err || fail '--picture without Python: no exit 0'
{ [ -s again.h5 ] && grep -q python3-matplotlib err; } || fail "--picture without Python: $(<err)"
"$program" run edge_drop --picture none.png 2>err && fail '--picture without --out'
# What stands beside the folder that Python is started in, or in it, is no module.
for place in . some; do echo 'raise SystemExit("a module of the folder ran")' >"$place/jinja2.py"; done
PYTHONPATH=$PWD page some
[ "$code" -eq 0 ] || fail "report: exit $code: $(<err)"
[ "$(stat -c %s page.html)" -lt 5000000 ] || fail 'the page has 5 MB'
grep -q 'rows 14 and 15 alone are feasible' page.html || fail 'no statement on the page'
grep -q 'alt="springs: mass-spring' page.html || fail 'no picture of the run'
cp page.html before.html

page nowhere
[ "$code" -eq 2 ] || fail "no folder: exit $code"
[ "$(wc -l <err)" -eq 1 ] || fail "no folder: not one line: $(<err)"
page some --site site
[ "$code" -eq 2 ] || fail "--out and --site: exit $code"

# No room on the disk: a sentence, exit 1, and the page of before is as it was.
cp before.html page.html
(ulimit -f 20 && exec "$program" report some --out page.html) >out 2>err
code=$?
[ "$code $(wc -l <err)" = '1 1' ] || fail "a full disk: exit $code: $(<err)"
cmp -s page.html before.html || fail 'a full disk, and another page'
[ "$(find . -name '*.part' | wc -l)" -eq 0 ] || fail 'a full disk, and half a page is left'

# Without Python, and without a package: the Debian packages by name.
CLOTHBENCH_PYTHON=/nowhere/python3 page some
[ "$code" -eq 1 ] || fail "no Python: exit $code"
grep -q 'apt-get install python3 .*python3-matplotlib' err || fail "no Python: $(<err)"
printf '#!/bin/sh\nshift 2\nexec /usr/bin/python3 -ISB "$@"\n' >bare && chmod +x bare # no packages
CLOTHBENCH_PYTHON=$PWD/bare page some
[ "$code" -eq 1 ] || fail "no packages: exit $code"
grep -q 'apt-get install python3-numpy python3-h5py python3-matplotlib python3-jinja2$' err ||
    fail "no packages: $(<err)"
CLOTHBENCH_PYTHON=/nowhere/python3 "$program" table 4 --from some --format csv >out 2>err
grep -q Python err && fail "a table asks for Python: $(<err)"

# The site: pages and links; it takes the place of an older one; a folder that is no site stays.
mkdir site && touch site/clothbench.site site/scene_gone.html
"$program" report some --site site >out 2>err || fail "site: exit $?: $(<err)"
/usr/bin/python3 - <<'SCRIPT' || fail 'a link of the site leads nowhere, or a page has a script'
import html.parser, pathlib
class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors, self.tags = [], [], set()
        self.feed(path.read_text())
    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        self.links += [value for name, value in attributes if name == "href"]
        self.anchors += [value for name, value in attributes if name == "id"]
site = pathlib.Path("site")
pages = {path.name: Page(path) for path in site.glob("*.html")}
wrong = [f"{name}: {link}" for name, page in pages.items() for link in page.links
         for file, _, anchor in [link.partition("#")] if not link.startswith("http")
         if not (site / (file or name)).is_file() or anchor and anchor not in pages[file or name].anchors]
wrong += [name for name, page in pages.items() if "script" in page.tags and name != "index.html"]
print(*wrong, sep="\n")
assert not wrong and len(pages) > 50, len(pages)
assert "scene_gone.html" not in pages
assert {"manual_report.html", "scene_edge_drop.html", "scenes.html", "manual.html"} <= set(pages)
SCRIPT
echo mine >site/notes.txt
"$program" report some --site site >out 2>err && fail 'a folder with notes is replaced'
grep -q notes.txt err || fail "the notes are not named: $(<err)"
exit $((failures > 0))
