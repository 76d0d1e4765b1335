"""The page in Chromium at two widths: no error in the console, nothing wider than the screen, every
picture loaded, and what is played moves. Each check is turned round once."""
import pathlib
import re
import shutil
import subprocess

import numpy as np
import pytest
from test_results import sheet

from clothbench import page

BROWSER = shutil.which("chromium")
RESULTS = pathlib.Path(__file__).resolve().parents[2] / "doc" / "results"
READER = """<script>
const say = [], text = () => document.querySelector('div#play output').textContent;
window.addEventListener('load', () => setTimeout(() => {
  say.push('wide=' + (document.documentElement.scrollWidth > innerWidth));
  say.push('broken=' + [...document.images].filter(i => !i.complete || !i.naturalWidth).length);
  say.push('pictures=' + document.images.length);
  const canvas = document.querySelector('canvas'), before = canvas.toDataURL(), slider = document.querySelector('input');
  slider.value = slider.max; slider.dispatchEvent(new Event('input'));
  say.push('moved=' + (canvas.toDataURL() !== before) + ' ' + text());
  parent.postMessage(say.join('|'), '*');
}, 100));
</script>"""

# A window of Chromium is at least 500 px wide, a frame in it as narrow as it should be.
FRAME = """<body><iframe src="page.html" style="border:0;width:{}px;height:800px"></iframe><script>
window.addEventListener('message', e => document.body.setAttribute('data-said', e.data));
</script>"""

pytestmark = pytest.mark.skipif(not BROWSER, reason="there is no Chromium")

@pytest.fixture(scope="module")
def text(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    shutil.copytree(RESULTS, folder, dirs_exist_ok=True)
    (folder / "run_edge_drop").mkdir()
    sheet(folder / "run_edge_drop" / "mine.h5", np.random.default_rng(3).random((2, 2, 100, 100, 3)))
    return page.report(folder)

def browse(tmp_path, text, width):
    """{key: value} of what the page is like, and what its console says."""
    (tmp_path / "page.html").write_text(text.replace("</body>", READER + "</body>"))
    (tmp_path / "frame.html").write_text(FRAME.format(width))
    done = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
                           f"--user-data-dir={tmp_path}/profile", "--window-size=1400,900", "--dump-dom",
                           "--virtual-time-budget=5000", f"file://{tmp_path}/frame.html"],
                          capture_output=True, text=True, timeout=120, check=False)
    said = re.search(r'data-said="([^"]*)"', done.stdout)
    return dict(w.split("=") for w in said[1].split("|")) if said else {}, "CONSOLE" in done.stderr

@pytest.mark.parametrize("width", [1280, 390])
def test_page(tmp_path, text, width):
    said, console = browse(tmp_path, text, width)
    assert said["wide"] == "false" and said["broken"] == "0" and int(said["pictures"]) == text.count("<img") > 10
    assert said["moved"].startswith("true 0.500") and not console

def test_that_faults_are_seen(tmp_path, text):
    said, console = browse(tmp_path, text.replace("<h1>", '<div style="width:3000px">x</div><img src="none.png"><h1>')
                           .replace("'use strict';", "'use strict'; undefined_name();"), 390)
    assert said.get("wide", "true") == "true" and said.get("broken", "1") == "1" and console
