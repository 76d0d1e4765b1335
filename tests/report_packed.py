#!/usr/bin/env python3
"""What a report packs. Cells of tables expand to the words of the files; so do those of a table
made of what packing could mistake. Pictures keep their colours in a palette; what is none stays.

    report_packed.py PROGRAM SOURCE-FOLDER
"""
import base64
import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

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


def chunks(png):
    at = 8
    while at < len(png):
        size, kind = struct.unpack_from(">I4s", png, at)
        body = png[at + 8:at + 8 + size]
        assert struct.unpack_from(">I", png, at + 8 + size)[0] == zlib.crc32(kind + body)
        yield kind, body
        at += 12 + size


def png_of(width, rows, kind, *more):
    """Of rows that are filtered, in chunks of data that are cut anywhere."""
    data = zlib.compress(b"".join(rows))
    parts = [(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), 8, kind, 0, 0, 0)), *more,
             (b"IDAT", data[:50]), (b"IDAT", data[50:]), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        for name, body in parts)


def guess(kind, left, up, corner):
    """What a filter foresees (PNG, W3C 2003, 9)."""
    if kind == 4:
        near = [abs(left + up - corner - x) for x in (left, up, corner)]
        return (left, up, corner)[near.index(min(near))]
    return (0, left, up, (left + up) // 2)[kind]


def filtered(rows):
    """Bytes of red, green, blue by each of the five filters in turn."""
    above = bytes(len(rows[0]))
    for y, row in enumerate(rows):
        before = [(row[k - 3], above[k - 3]) if k > 2 else (0, 0) for k in range(len(row))]
        yield bytes([y % 5]) + bytes((row[k] - guess(y % 5, before[k][0], above[k], before[k][1]))
                                     % 256 for k in range(len(row)))
        above = row


def check_pictures(folder):
    """Two hundred colours, one of which is white, come back as they are; fewer bytes hold them."""
    width, height = 90, 60
    colours = [bytes([255 - 8 * (n % 32), 255 - 24 * (n // 32), 255 - 56 * (n % 4)])
               for n in range(200)]
    rows = [b"".join(colours[(x * x + 7 * y) % 200] for x in range(width)) for y in range(height)]
    sound = png_of(width, list(filtered(rows)), 2)
    files = {"table2/cost.png": sound, "table3/cost.png": sound.replace(b"IDAT", b"iDAT", 1),
             "table4/table4.png": png_of(width, [b"\5" + row for row in rows], 2)}
    for name, png in files.items():
        (folder / name).parent.mkdir()
        (folder / name).write_bytes(png)
    found = {str(pathlib.Path(p["path"]).relative_to(folder)): base64.b64decode(p["data"])
             for p in packed(folder)["pictures"]}
    made = found.pop("table2/cost.png")
    assert len(made) < len(sound) and all(found[name] == files[name] for name in found)
    parts = list(chunks(made))
    palette = dict(parts)[b"PLTE"]
    raw = zlib.decompress(dict(parts)[b"IDAT"])
    for y, row in enumerate(rows):
        numbers = raw[y * (width + 1):(y + 1) * (width + 1)]
        assert numbers[0] == 0
        assert row == b"".join(palette[3 * n:3 * n + 3] for n in numbers[1:]), y


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
    check_pictures(folder)
    print(f"{len(counts)} parts, {sum(c for c, _ in counts)} cells, {sum(z for _, z in counts)} "
          "of them packed")
    assert len(counts) > 10 and sum(z for _, z in counts) > 1000
