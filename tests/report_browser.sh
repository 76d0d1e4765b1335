#!/usr/bin/env bash
# The page in headless Chromium: it opens without a word on the console, a point shows its
# numbers, motions play and follow the slider, a phone's width is kept.
#   report_browser.sh PROGRAM SOURCE-FOLDER
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
source=$2
browser=$(command -v chromium || command -v chromium-browser)
if [ -z "$browser" ]; then
    echo 'skipped: chromium is not installed'
    exit 77
fi
own_folder

# What a reader does, and what the page then shows, as attributes of its body.
cat >reader.js <<'SCRIPT'
const said = {}, seen = document.getElementById('tip'), when = document.getElementById('when');
const point = document.querySelector('.chart circle'), slider = document.getElementById('frame');
point.dispatchEvent(new PointerEvent('pointerenter', {clientX: 50, clientY: 50}));
said.hover = seen.style.display + ' ' + seen.textContent;
point.dispatchEvent(new PointerEvent('pointerleave'));
said.left = seen.style.display;
const picture = () => document.querySelector('#sheets canvas').toDataURL();
const first = picture();
said.start = when.textContent;
const caption = n => document.querySelectorAll('#sheets figcaption')[n].textContent;
for (const [name, value] of [['exact', 20], ['between', 22], ['slid', 43]]) {
  slider.value = value;
  slider.dispatchEvent(new Event('input'));
  said[name] = when.textContent + ', ' + caption(0) + ', ' + caption(1);
}
said.moved = picture() !== first;
said.claims = document.querySelectorAll('.claims li').length;
[said.tally, said.least, said.checks] = [1, 2, 3].map(n =>
  document.querySelectorAll('p')[n].textContent);
said.lines = document.querySelectorAll('.chart path').length;
const fabrics = name => document.querySelectorAll('[aria-label*="isotropic mean"] ' + name).length;
said.fabrics = fabrics('circle') + ', ' + fabrics('rect');
said.quick = document.querySelector('.quick')?.textContent;
const cells = [...document.querySelectorAll('td')].map(cell => cell.textContent);
said.above = cells.filter(words => words === 'hex').length;
said.wide = document.documentElement.scrollWidth > innerWidth;
document.getElementById('play').click();
setTimeout(() => {
  said.played = when.textContent;
  document.body.setAttribute('data-said', Object.entries(said).map(x => x.join('=')).join('|'));
}, 300);
SCRIPT
cp -r "$source/doc/results" results
mkdir results/run_edge_drop
"$program" run edge_drop --model mass_spring --set 'discretization.points=[4,4]' \
    --set time.end=0.3 --quiet --out results/run_edge_drop/springs.h5 || fail "run: exit $?"
"$program" report results --out page.html >/dev/null || fail "report: exit $?"
{
    sed '/<\/body>/,$d' page.html
    printf '<script>%s</script></body></html>\n' "$(<reader.js)"
} >read.html

browse() { # FILE OPTION...; out, err
    local file=$1
    shift
    timeout 60 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
        --enable-logging=stderr --virtual-time-budget=3000 "$@" "file://$folder/$file" >out 2>err
}
said() { # KEY PATTERN
    grep -oP "data-said=\"\K[^\"]*" out | tr '|' '\n' | grep -qP "^$1=$2" ||
        fail "$1 is not '$2': $(grep -o 'data-said="[^"]*"' out)"
}

browse read.html --dump-dom --window-size=390,844
! grep CONSOLE err || fail 'the console has something to say'
said hover 'block .* points, step .* s, .*: .* %'
said left none
said start '0[.]000 s'
# 61 frames of the run, and the truth's, fifty a second: nothing between them is made up
said exact '0[.]100 s, truth, springs[.]h5$'
said between '0[.]110 s, truth; at 0[.]100 s, springs[.]h5; truth at 0[.]100 s$'
said slid '0[.]215 s, truth; at 0[.]220 s, springs[.]h5; truth at 0[.]220 s$'
said moved true
said played '0[.]2[2-9][05] s$'
said claims '[0-9]{2}'
said tally 'Of the paper.s [0-9]{2} claims [0-9]+ hold and [0-9]+ do not; [0-9]+ were not'
said least 'The least time to an error of 1 % .* is 0[.]0[0-9]+ s, by .*; the next model, .* times as long'
said checks 'Of the results .*, [0-9]{3} have it and [0-9]+ do not'
said lines '[5-9]'
said fabrics '[34][0-9], 3$' # two laws in seven models and three scenes, but for what refuses
said quick '$'
said wide false
# cells that are packed because they are those of the row above: all rows of hexahedra, at least
above=$(grep -oP 'data-said="\K[^"]*' out | tr '|' '\n' | sed -n 's/^above=//p')
[ "$above" -ge "$(grep -c '^hex,' results/table1.csv)" ] || fail "only $above cells are 'hex'"
# the same with a fault planted, so that this test can fail
sed 's/tip.textContent = text/undefined_name()/' read.html >broken.html
browse broken.html --dump-dom
grep -q CONSOLE err || fail 'an error of the page is not seen'
exit $((failures > 0))
