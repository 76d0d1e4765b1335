#!/usr/bin/env python3
"""Cells that a report packs expand to the words of the files; so do those of a table made of what
packing could mistake.

    report_packed.py PROGRAM SOURCE-FOLDER
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
program, source = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(source / "doc"))
import figures_read  # noqa: E402

SHORT = 8  # characters; a longer number has six digits in the page
TRICKY = """\
# Cells that packing could mistake
model,net,zero,text,number
hex,hex,0,,0.12345678901234567
hex,0,0,,0.12345678901234567
0,0,0,0,1e-300
iga,0,1,0.0,1.00000000000
iga,iga,0,"a, b",nan
iga,hex,0,"a, b",nan
"""


def packed(folder):
    """What the page about a folder is made of."""
    page = folder / "page.html"
    subprocess.run([program, "report", str(folder), "--out", str(page)], check=True,
                   capture_output=True)
    data = re.search(r'<script type="application/json" id="data">(.*?)</script>',
                     page.read_text(), re.S)
    return json.loads(data[1])


def expanded(rows):
    """A cell that is 0, not '0', is that of the row above."""
    full = []
    for row in rows:
        full.append([full[-1][k] if cell == 0 else cell for k, cell in enumerate(row)])
    return full


def shown(words):
    """A word of a file as the page has it."""
    try:
        number = float(words)
    except ValueError:
        return words
    finite = number - number == 0
    return f"{number:.6g}" if finite and len(words) > SHORT else words


def check(part, path):
    """How many cells were compared, and packed."""
    compared = zeros = 0
    for mine, (caption, rows) in zip(part["tables"], figures_read.tables(path), strict=True):
        assert mine["left"] == len(rows) - len(mine["rows"]), (path, caption)
        for row, want in zip(expanded(mine["rows"]), rows):
            want = [shown(want[key]) for key in mine["keys"]]
            assert row == want, f"{path}, {caption}: {row} for {want}"
            compared += len(row)
        zeros += sum(cell == 0 for row in mine["rows"] for cell in row)
    return compared, zeros


with tempfile.TemporaryDirectory() as made:
    folder = pathlib.Path(made)
    results = source / "doc" / "results"
    for path in results.glob("*.csv"):
        (folder / path.name).write_text(path.read_text())
    (folder / "study_locking.csv").write_text(TRICKY)
    parts = [part for part in packed(folder)["parts"] if part["path"].endswith(".csv")]
    counts = [check(part, pathlib.Path(part["path"])) for part in parts]
    assert any(table["caption"] in TRICKY for part in parts for table in part["tables"])
    print(f"{len(counts)} parts, {sum(c for c, _ in counts)} cells, {sum(z for _, z in counts)} "
          "of them packed")
    assert len(counts) > 10 and sum(z for _, z in counts) > 1000
