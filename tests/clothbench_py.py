#!/usr/bin/env python3
"""The package in python/: frames that come back, truths of a scene and of files, an exported
folder, and a sentence for what is wrong; its wheel, and its example with that. Ends with 77 where
numpy is missing.
    clothbench_py.py PROGRAM TOP
"""

import ctypes
import importlib.util
import os
import shutil
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

program, top = map(os.path.abspath, sys.argv[1:])
sys.path.insert(0, os.path.join(top, "python"))
sys.dont_write_bytecode = True
os.environ["CLOTHBENCH"] = program
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
    again = clothbench.frames.read("mine.npz")
    check("read", (again.xyz == xyz).all() and (again.t == t).all() and (again.uv == uv).all())
    check("may be read", stat.S_IMODE(os.stat("mine.npz").st_mode) == 0o666 & ~umask)
    clothbench.frames.write("mine.npz", t, uv, xyz.astype("f4").tolist())  # again, lists
    with numpy.load("mine.npz") as file:
        check("float", abs(file["xyz"] - xyz).max() < 1e-6)
    if h5py:
        clothbench.frames.write("mine.h5", t, uv, xyz)
        with h5py.File("mine.h5") as file:
            check("h5", (file["xyz"][...] == xyz).all() and (file["uv"][...] == uv).all())
            check("units", file["xyz"].attrs["unit"] == "m" and file["t"].attrs["unit"] == "s")
        check("read h5", (clothbench.frames.read("mine.h5").xyz == xyz).all())
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
    says("no folder", OSError, "mine.npz", clothbench.frames.write, "mine.npz/bad.npz", t, uv, xyz)
    numpy.savez("mine.npz", t=t, xyz=xyz)
    says("no uv", ValueError, "has no uv", clothbench.frames.read, "mine.npz")
    check("nothing is left", not [name for name in os.listdir() if "mine" not in name])


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
        file.write(clothbench.run("truth", "edge_drop", "--stored", "--points", "5,4"))
    drop = clothbench.truth.read("small.csv")
    check("a file", drop.xyz.shape == (74, 20, 3) and drop.t[-1] == 1.48)
    check("held", abs(drop.xyz[:, drop.uv[:, 0] == 0, 0]).max() < 1e-6)
    if h5py:
        clothbench.run("truth", "hanging", "--out", "hanging.h5")
        a, b = clothbench.truth.read("hanging.h5"), clothbench.truth.read("hanging")
        check("h5 and csv", abs(a.xyz - b.xyz).max() < b.bar.min() / 10)  # packed
        check("uv of h5 and csv", abs(a.uv - b.uv).max() < 1e-15)
        check("h5's bar", (a.bar == b.bar).all() and a.source == b.source)
        stored = clothbench.truth.read(os.path.join(top, "bench/truths/edge_drop.h5"))
        check("a bar a time", len(stored.bar) == len(stored.t) == 74)


def scored():
    """What is written here is read there; and doc/score.md's simulator is told what its page says."""
    fall = clothbench.truth.read("free_fall")
    for path in ["fall.npz"] + ["fall.h5"] * bool(h5py):
        clothbench.frames.write(path, fall.t, fall.uv, fall.xyz)
        (sheet,) = clothbench.score("free_fall", path)
        check(path + " is sound", [d["kind"] for d in sheet["diagnosis"]] == ["sound"])
        check(path + " fits", len(sheet["rows"]) == 5 and max(
            row["error"] for row in sheet["rows"]) < 1e-12)
    with open(os.path.join(top, "doc/score.md")) as file:
        page = file.read()
    block = page[page.index("    import numpy"):]
    exec(textwrap.dedent(block[:block.index("\n\n")]), {})
    said = page[page.index("    scene       time"):]
    said = textwrap.dedent(said[:said.index("\n\n## ")])
    check("the page's simulator", said in clothbench.run("score", "free_fall", "frames.npz"))
    made = numpy.load("frames.npz")
    numpy.savez_compressed("packed.npz", **{name: made[name].astype("f4") for name in made})
    (sheet,) = clothbench.score("free_fall", "packed.npz")
    check("the same, packed", [d["kind"] for d in sheet["diagnosis"]] == ["first_order_step"])
    os.mkdir("both")
    for scene in ("free_fall", "hanging"):
        known = clothbench.truth.read(scene)
        clothbench.frames.write(f"both/{scene}.npz", known.t, known.uv, known.xyz)
    check("two scenes", [sheet["scene"] for sheet in clothbench.score("both")] ==
          ["free_fall", "hanging"])


def exported():
    """The same numbers as edge_drop has them, and a folder that is left."""
    scene = clothbench.export("edge_drop", 5, 4, "edge", {"material.young": 2e5})
    E, h, nu = 2e5, 1.177e-3, 0.3
    check("points", scene.x.shape == (24, 3) and abs(scene.x[:20, :2] - scene.uv).max() < 1e-12)
    check("outside", scene.beside[21] == 5 and scene.held[5] == scene.held[21] == "xyz")
    check("held", sorted(scene.held) == [0, 5, 10, 15, 20, 21, 22, 23] and not scene.path)
    check("mass", abs(scene.mass.sum() - 0.5 * h) < 1e-12)
    a, b, c = (scene.x[scene.triangles[:, k]] for k in range(3))
    area = numpy.cross(b - a, c - a)[:, 2] / 2
    check("triangles", area.shape == (24,) and abs(area.sum() - 1) < 1e-12 and area.min() > 0)
    length = numpy.linalg.norm(scene.x[scene.springs["a"]] - scene.x[scene.springs["b"]], axis=1)
    check("springs", len(length) == 55 and abs(length - scene.springs["length"]).max() < 1e-12)
    check("material", scene.material["E"] == E and "hinge u held" in scene.material and abs(
        scene.material["D"] / (E * h ** 3 / 12 / (1 - nu ** 2)) - 1) < 1e-12)
    check("times", scene.step == 0.005 and not len(scene.times) and list(scene.gravity) == [0, 0, -9.81])
    check("files", os.path.exists("edge/scene.usda") and scene.damping == {"kind": "none"})
    moves = clothbench.export("moving_edge", 3, 3)
    check("path", set(moves.path.values()) == {0} and len(moves.path) == 6)
    check("mass damping", clothbench.export("hanging", 3, 3).damping["value"] == 20)
    check("no springs", clothbench.export("cloak", 4, 3).springs.shape == (0,))
    says("no scene", ValueError, "nobody", clothbench.export, "nobody", 3, 3)
    check("a grid has neither", not len(scene.hinges) and not len(scene.pattern))


def garments():
    """A garment with its pattern, whose area has its mass; hinges and springs of a mesh."""
    shirt = clothbench.export("shirt")
    a, b, c = (shirt.pattern[:, k] for k in range(3))
    area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    check("pattern", area.min() > 0 and abs(area.sum() * shirt.material["areal mass"] / shirt.mass.sum() - 1) < 1e-12)
    check("seams", len(shirt.x) == shirt.triangles.max() + 1 and len(shirt.uv) == len(shirt.x))
    edges = {frozenset((t[k], t[k - 1])) for t in shirt.triangles.tolist() for k in range(3)}
    check("hinges", len(shirt.hinges) and edges >= {frozenset(e) for e in shirt.hinges[["a", "b"]].tolist()})
    sheet = clothbench.export("trapezoid", 7, 7)
    check("springs of a mesh", 3 * len(sheet.mass) > len(sheet.springs) > 2 * len(sheet.mass))


def wheel_and_example():
    """What pip installs, without a network, has the program's version and runs the example."""
    if not all(map(importlib.util.find_spec, ("pip", "setuptools", "wheel"))):
        print("not tested: the wheel, without python3-pip, python3-setuptools and python3-wheel")
        return
    for name in "CMakeLists.txt", "python":
        copy = shutil.copytree if name == "python" else shutil.copy
        copy(os.path.join(top, name), name)
    pip = subprocess.run(
        [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--no-index",
         "--target", "site", "./python"], capture_output=True, text=True)
    check("pip: " + pip.stderr[-500:], not pip.returncode)
    version = clothbench.run("--version").split()[2]
    check("version", os.path.isdir(f"site/clothbench-{version}.dist-info"))
    check("templates", os.path.exists("site/clothbench/page.html.j2"))
    try:
        ctypes.CDLL("libode.so.8")
    except OSError:
        print("not tested: python/examples/ode.py, without libode8")
        return
    done = subprocess.run([sys.executable, "python/examples/ode.py", "ode", "5", "free_fall"],
                          env={**os.environ, "PYTHONPATH": "site"}, capture_output=True, text=True)
    check("example: " + done.stderr[-500:], "of first order" in done.stdout)
    check("page: " + done.stderr[-500:], os.path.exists("ode/protocol.html"))
    fall = clothbench.frames.read("ode/free_fall/5x5.npz")
    far = abs(fall.xyz[-1, :, 2] + 9.81 * 0.5 * (0.5 + 0.005) / 2).max()  # symplectic Euler
    check("falls", fall.t[-1] == 0.5 and far < 1e-12)


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
        says("no truth", ValueError, "is not a result file", clothbench.truth.read, "bad.h5")
    os.environ["CLOTHBENCH"] = "nowhere/x"
    says("a program that is gone", FileNotFoundError, "no program nowhere/x", clothbench.truth.read, "free_fall")
    os.environ["CLOTHBENCH"] = ""
    os.environ["PATH"] = ""
    clothbench.program.__file__ = os.path.abspath("elsewhere.py")
    says("no program", FileNotFoundError, "no program", clothbench.truth.read, "free_fall")


umask = os.umask(0o022)
umask = 0o022
with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    frames_come_back()
    bad_frames()
    truths()
    scored()
    exported()
    garments()
    wheel_and_example()
    bad_truths()
    os.chdir("/")
finish()
