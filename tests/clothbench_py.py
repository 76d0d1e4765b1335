#!/usr/bin/env python3
"""bench/export/clothbench.py from plain Python: frames that come back, truths of a scene and of
files, and a sentence for what is wrong. Ends with 77 where numpy is missing.
    clothbench_py.py PROGRAM FOLDER-OF-clothbench.py
"""

import json
import os
import stat
import subprocess
import sys
import tempfile
import textwrap

DEBIANS = "/usr/bin/python3"  # where its packages are, whichever python3 comes first
try:
    import numpy
except ImportError:
    if os.path.exists(DEBIANS) and not os.environ.get("CLOTHBENCH_PY_AGAIN"):
        os.environ["CLOTHBENCH_PY_AGAIN"] = "1"
        os.execv(DEBIANS, [DEBIANS] + sys.argv)
    print("skipped: no numpy (Debian package python3-numpy)")
    sys.exit(77)
try:
    import h5py
except ImportError:
    h5py = None

program, folder = sys.argv[1:]
sys.path.insert(0, folder)
sys.dont_write_bytecode = True
os.environ["CLOTHBENCH"] = os.path.abspath(program)
import clothbench
from checks import check, finish, says


def frames_come_back():
    t = [0.1, 0.25]
    uv = numpy.array([[0, 0], [1, 0], [0.5, 1]])
    xyz = numpy.random.default_rng(1).normal(size=(2, 3, 3))
    clothbench.frames.write("mine.npz", t, uv, xyz)
    with numpy.load("mine.npz") as file:
        check("names", sorted(file.files) == ["t", "uv", "xyz"])
        check("t", (file["t"] == t).all() and (file["uv"] == uv).all())
        check("xyz", (file["xyz"] == xyz).all() and file["xyz"].dtype == float)
    check("may be read", stat.S_IMODE(os.stat("mine.npz").st_mode) == 0o666 & ~umask)
    clothbench.frames.write("mine.npz", t, uv, xyz.astype("f4").tolist())  # again, lists
    with numpy.load("mine.npz") as file:
        check("float", abs(file["xyz"] - xyz).max() < 1e-6)
    if h5py:
        clothbench.frames.write("mine.h5", t, uv, xyz)
        with h5py.File("mine.h5") as file:
            check("h5", (file["xyz"][...] == xyz).all() and (file["uv"][...] == uv).all())
            check("units", file["xyz"].attrs["unit"] == "m" and file["t"].attrs["unit"] == "s")
    else:
        says("no h5py", ImportError, "needs h5py", clothbench.frames.write, "x.h5", t, uv, xyz)
    check("nothing else is left", sorted(os.listdir()) == ["mine.h5", "mine.npz"][not h5py:])


def bad_frames():
    t, uv, xyz = [0.1, 0.2], numpy.zeros((4, 2)), numpy.zeros((2, 4, 3))
    hole = xyz.copy()
    hole[1, 2, 0] = numpy.nan
    for what, words, arguments in (
            ("axes in front", "[frames][vertices][3]", (t, uv, numpy.zeros((3, 4, 2)))),
            ("one frame as two axes", "[frames][vertices][3]", (t, uv, xyz[0])),
            ("frames and vertices exchanged", "for 4 frames", (t, uv, xyz.transpose(1, 0, 2))),
            ("a time too many", "for 2 frames", ([1, 2, 3], uv, xyz)),
            ("a vertex less", "for 4 vertices", (t, uv[:3], xyz)),
            ("rows of uv as columns", "[4][2]", (t, uv.T, xyz)),
            ("a hole", "xyz[1, 2, 0] is not", (t, uv, hole)),
            ("no time", "t[1] is not", ([0, numpy.inf], uv, xyz)),
            ("back in time", "must increase", ([2, 1], uv, xyz)),
            ("the same time", "must increase", ([1, 1], uv, xyz)),
            ("outside", "from 0 to 1", (t, uv - 0.05, xyz)),
            ("millimetres of u", "from 0 to 1", (t, uv + 1000, xyz)),
            ("words", "could not convert", (t, uv, [["x"]]))):
        says(what, ValueError, words, clothbench.frames.write, "bad.npz", *arguments)
    says("an ending", ValueError, "must end in", clothbench.frames.write, "bad.mat", t, uv, xyz)
    says("a folder", OSError, "nowhere", clothbench.frames.write, "nowhere/bad.npz", t, uv, xyz)
    check("nothing is left", not [name for name in os.listdir() if "mine" not in name])


def run(*arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


def truths():
    fall = clothbench.truth.read("free_fall")
    want = -9.81 * fall.t ** 2 / 2
    check("times", numpy.allclose(fall.t, [0.1, 0.2, 0.3, 0.4, 0.5], atol=1e-15))
    check("shape", fall.xyz.shape == (5, 10000, 3) and fall.uv.shape == (10000, 2))
    check("falls", abs(fall.xyz[:, :, 2] - want[:, None]).max() < 1e-13)
    check("u, v are x, y", abs(fall.xyz[:, :, :2] - fall.uv).max() < 1e-13)
    check("bar", (fall.bar < 1e-13).all() and (fall.bar > 0).all())
    check("source", "falls as one body" in fall.source)
    with open("small.csv", "w") as file:
        file.write(run("truth", "edge_drop", "--stored", "--points", "5,4"))
    drop = clothbench.truth.read("small.csv")
    check("a file", drop.xyz.shape == (74, 20, 3) and drop.t[-1] == 1.48)
    check("held", abs(drop.xyz[:, drop.uv[:, 0] == 0, 0]).max() < 1e-6)
    if h5py:
        run("truth", "hanging", "--out", "hanging.h5")
        a, b = clothbench.truth.read("hanging.h5"), clothbench.truth.read("hanging")
        check("h5 and csv", abs(a.xyz - b.xyz).max() < b.bar.min() / 10)  # packed
        check("uv of h5 and csv", abs(a.uv - b.uv).max() < 1e-15)
        check("h5's bar", (a.bar == b.bar).all() and a.source == b.source)
        stored = clothbench.truth.read(os.path.join(folder, "../truths/edge_drop.h5"))
        check("a bar a time", len(stored.bar) == len(stored.t) == 74)


def scored():
    """What is written here is read there; and doc/score.md's simulator is told what its page says."""
    drop = clothbench.truth.read("edge_drop")
    for path in ["drop.npz"] + ["drop.h5"] * bool(h5py):
        clothbench.frames.write(path, drop.t, drop.uv, drop.xyz)
        sheet = json.loads(run("score", "edge_drop", path, "--format", "json"))
        check(path + " is sound", [d["kind"] for d in sheet["diagnosis"]] == ["sound"])
        check(path + " fits", len(sheet["rows"]) == 14 and max(
            row["error"] for row in sheet["rows"]) < 1e-12)
    with open(os.path.join(folder, "../../doc/score.md")) as file:
        page = file.read()
    block = page[page.index("    import numpy"):]
    exec(textwrap.dedent(block[:block.index("\n\n")]), {})
    said = page[page.index("    scene       time"):]
    said = textwrap.dedent(said[:said.index("\n\n## ")])
    check("the page's simulator", said in run("score", "free_fall", "frames.npz"))
    made = numpy.load("frames.npz")
    numpy.savez_compressed("packed.npz", **{name: made[name].astype("f4") for name in made})
    sheet = json.loads(run("score", "free_fall", "packed.npz", "--format", "json"))
    check("the same, packed", [d["kind"] for d in sheet["diagnosis"]] == ["first_order_step"])


def bad_truths():
    says("no scene", ValueError, "nobody", clothbench.truth.read, "nobody")
    says("none stored", ValueError, "corners_drop", clothbench.truth.read, "corners_drop")
    says("no file", OSError, "none.csv", clothbench.truth.read, "none.csv")
    with open("small.csv") as file:
        lines = file.read().splitlines()
    for what, words, text in (
            ("a line cut short", "bad.csv:13:", lines[:12] + ["0.1,0"]),
            ("a word", "bad.csv:14:", lines[:13] + ["0.1,0,0,x,0,0"]),
            ("a line missing", "is no truth", lines[:-1]),
            ("no bars", "is no truth", [line for line in lines if "# bar" not in line]),
            ("empty", "is no truth", [])):
        with open("bad.csv", "w") as file:
            file.write("\n".join(text))
        says(what, ValueError, words, clothbench.truth.read, "bad.csv")
    if h5py:
        h5py.File("bad.h5", "w").close()
        says("no truth", ValueError, "is no truth", clothbench.truth.read, "bad.h5")
    os.environ["CLOTHBENCH"] = ""
    os.environ["PATH"] = ""
    says("no program", FileNotFoundError, "no program", clothbench.truth.read, "free_fall")


umask = os.umask(0o022)
umask = 0o022
with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    frames_come_back()
    bad_frames()
    truths()
    scored()
    bad_truths()
    os.chdir("/")
finish()
