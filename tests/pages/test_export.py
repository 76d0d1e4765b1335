"""The files of `export` against the scene: areas, masses, springs, times, meshes that agree, what is held
under every kind of support, the rules; and what it refuses, leaving nothing behind, nor taking anything
away. (A scene file of the same physics: bench/export/export.c; scene.usda: test_usd.py.)"""
import csv
import os
import re
import resource
import signal
import subprocess
from math import hypot, pi, sin, sqrt

import numpy as np
import pytest

from clothbench import program

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MESH = f"mesh: {{file: {SOURCE}/tests/bad_scenes/mesh_inside.obj"
SUMS, ONE = dict(rel=1e-12, abs=0), dict(rel=1e-14, abs=1e-14)  # of thousands of vertices; of a product
AREA = dict(rel=2e-3)  # chords of 8 cells for 60 degrees of a cone

def near(value, by):
    return pytest.approx(value, **by)

def told(*words, **how):
    """(exit code, sentence) of `export WORDS...`; nothing draws scene.usda."""
    done = subprocess.run([program.find(), "export", *map(str, words)], capture_output=True, text=True, check=False,
                          env=os.environ | {"CLOTHBENCH_PYTHON": "/nowhere"}, **how)
    return done.returncode, done.stderr

class Files:
    """A scene with settings on such a net, in a folder."""

    def __init__(self, tmp_path, scene, points, *settings):
        self.folder = tmp_path / f"{scene}_{len(os.listdir(tmp_path))}"
        code, said = told(scene, "--points", points, "--out", self.folder,
                          *(w for s in settings for w in ("--set", s)))
        assert code == 0, said

    def rows(self, name):
        """[{column: number, or words}] of a table."""
        def value(cell):
            try:
                return float(cell)
            except ValueError:
                return cell

        with open(self.folder / f"{name}.csv") as file:
            return [{key: value(cell) for key, cell in row.items()} for row in csv.DictReader(file)]

    def numbers(self):
        """{quantity: [value]} of materials.csv."""
        found = {}
        for row in self.rows("materials"):
            found.setdefault(row["quantity"], []).append(row["value"])
        return found

    def text(self, name):
        return (self.folder / name).read_text()

@pytest.fixture
def files(tmp_path):
    return lambda *words: Files(tmp_path, *words)

# --- numbers -------------------------------------------------------------------------------------

def check_springs(made, n, m):
    """Each joins vertices of an n x m net as its name says, and is as long as they are apart."""
    springs = [r for r in made.rows("materials") if r["quantity"].startswith("spring")]
    for r in springs:
        a, b = int(r["a"]), int(r["b"])
        du, dv = (b % n - a % n) / (n - 1), (b // n - a // n) / (m - 1)
        assert r["rest_length"] == near(hypot(du, dv), SUMS) and r["compliance"] * r["value"] == near(1, ONE)
        assert r["quantity"] == "spring " + ("v" if du == 0 else "u" if dv == 0 else "diagonal")
    assert len(springs) == (n - 1) * m + n * (m - 1) + 2 * (n - 1) * (m - 1)

def check_hinges(of, a, b, along, across, between):
    """The conditions of models/net/hinge_rule.h on cells of a x b: a cylinder bends with B11, B22, and with
    what lies between them, B = 2 B12 + 4 B33, in all other directions; None: no rule has that."""
    p, q, r = of["hinge v"][0] * a * b ** 3, of["hinge u"][0] * a ** 3 * b, \
        of["hinge diagonal"][0] * a * b * (a * a + b * b)
    assert p - p * p / (p + q + r) == near(along * b ** 4, SUMS)
    assert q - q * q / (p + q + r) == near(across * a ** 4, SUMS)
    assert between is None or r - 2 * p * q / (p + q + r) == near(between * a * a * b * b, SUMS)

def test_materials(files):
    """The paper's sheet: E h = 117.7 N/m; springs of the drivers that were tried by hand."""
    E, h, nu, rho = 1e5, 1.177e-3, 0.3, 0.5
    diagonal, D = E * h / 2 / (1 + nu), E * h ** 3 / 12 / (1 - nu * nu)
    # C11 - C12^2 / C11 = E h with free sides, C12 = G h
    straight = (E * h + sqrt(E * h * E * h + 4 * diagonal * diagonal)) / 2 - diagonal
    made = files("edge_drop", "21,21")
    of = made.numbers()
    for name, want in {"E h": 117.7, "E h/(1-nu^2)": E * h / (1 - nu * nu), "G h": diagonal, "D": D, "areal mass": rho * h,
                       "hinge u": 4 * D / 3, "hinge diagonal": 4 * D / 3,  # square cells
                       "hinge v held": 24 * D / (9 + sqrt(3))}.items():
        assert of[name][0] == near(want, ONE), name
    for name, want in {"mass": rho * h, "spring u": 400 * straight, "spring v": 400 * straight,
                       "spring diagonal": 800 * diagonal}.items():
        assert sum(of[name]) == near(want, SUMS), name
    assert of["mass"][0] == near(rho * h / 1600, SUMS)  # a corner's
    check_springs(made, 21, 21)
    made = files("edge_drop", "9,7")
    check_hinges(made.numbers(), 1 / 8, 1 / 6, D, D, 2 * D)
    check_springs(made, 9, 7)
    # along cells of 1 to 2 springs keep two fifths (spring_law.h); a cone has none
    of = files("edge_drop", "3,2").numbers()
    longest = 0.4 * E * h / (1 - 0.6 * 0.6 / 16)
    assert sum(of["spring v"]) == near(2 * longest / 2, SUMS) and sum(of["spring u"]) > 0  # two, half as wide
    of, around = files("cloak", "9,7").numbers(), pi / 3
    assert sum(of["mass"]) == near(0.5e-3 * around * (0.5 / around + sin(pi / 18) / 2), SUMS)
    assert "spring u" not in of

def test_fabrics(files):
    """On cells of 1/8 by 1/6: each number has the modulus that holds it there."""
    cloth = "material={membrane: [2000, 1000, 400, 300], bending: %s, areal_density: 0.1%s}"
    h = sqrt(12 * sqrt(4e-10 / 2e6))
    of = files("hanging", "9,7", cloth % ("[1e-5, 4e-5, 4e-6, 6e-6]", ", warp: 90")).numbers()
    assert of["Y11"] == [2000] and of["B2"] == [4e-5] and of["warp"] == [90] and "spring u" in of and "C1" not in of
    for name, want in {"E1": (2000 - 400 * 400 / 1000) / h, "E2": (1000 - 400 * 400 / 2000) / h,
                       "nu12": 0.4, "G12": 300 / h}.items():
        assert of[name][0] == near(want, SUMS), name
    check_hinges(of, 1 / 8, 1 / 6, 4e-5, 1e-5, None)  # bends along the weft; too unlike for more
    of = files("hanging", "9,7", cloth % ("[2e-5, 3e-5, 4e-6, 6e-6]", "")).numbers()
    check_hinges(of, 1 / 8, 1 / 6, 2e-5, 3e-5, 2 * 4e-6 + 4 * 6e-6)
    of = files("strip_bias", "9,7", "material.softening=[-1e-9, 0]").numbers()
    assert of["C1"] == [-1e-9] and "C2" not in of
    of = files("strip_bias", "9,7").numbers()
    assert of["warp"] == [45] and "hinge diagonal" in of and "spring diagonal" not in of

def test_times(files):
    t = files("edge_drop", "3,3").rows("times")
    assert [r["time"] for r in t[:3]] == [0.005, 4.25, 0.1] and len(t) == 16 and 1e-6 < t[2]["bar"] < 1e-3
    t = files("rest_large", "3,3").rows("times")
    assert len(t) == 3 and t[2]["time"] == 5
    assert len(files("corners_drop", "3,3").rows("times")) == 2  # no truth is stored

def test_world(files):
    """Obstacles, paths, loads and velocities where the scene has them, and nowhere else."""
    assert len(os.listdir(files("edge_drop", "5,4").folder)) == 8
    made = files(
        "edge_drop", "5,4", "obstacles=[{plane: {point: [0, 0, -1], normal: [0, 3, 4], friction: 0.25}}, "
        "{sphere: {center: [1, 2, -3], radius: 0.5}}]",
        "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [1, 0, 0, 2]]}]",
        "loads=[{at: {u: 1}, force: [0, 3, -1]}, {at: {u: 1, v: 0}, force: [0.5, 0, 0]}]",
        "motion={velocity: [1, 2, 3], spin: [0, 0, 0]}")
    assert len(os.listdir(made.folder)) == 12
    plane, sphere = made.rows("obstacles")
    assert (plane["kind"], plane["z"], plane["friction"], plane["radius"]) == ("plane", -1, 0.25, "")
    assert plane["normal_z"] == near(0.8, ONE) and (sphere["radius"], sphere["z"], sphere["normal_x"]) == (0.5, -3, "")
    path, loads, speeds = made.rows("paths"), made.rows("loads"), made.rows("velocities")
    assert len(path) == 2 and path[1]["z"] == 2 and len(loads) == 4 and loads[0]["vertex"] == 4
    assert [sum(r[c] for r in loads) for c in "yz"] == near([3, -1], SUMS)
    assert [loads[0][c] for c in "xy"] == near([0.5, 0.5], SUMS)  # half a cell of three
    assert len(speeds) == 20 and sum(r["z"] for r in speeds) == 16 * 3  # not where held
    assert speeds[5]["x"] == 0 and speeds[6]["x"] == 1
    made = files("edge_drop", "5,4", "obstacles=[{sphere: {center: [1, 2, -3], radius: 0.5}, path: [[0, 0, 0, 0]]}, "
                 "{capsule: {from: [1, 2, -8], to: [1, 3, -8], radius: 2}}, {" + MESH + ", at: [0, 0, -9], friction: 0.5}}]")
    ball, rod, body = made.rows("obstacles")
    assert len(os.listdir(made.folder)) == 10  # a mesh has its own
    assert (ball["kind"], rod["kind"], rod["radius"], rod["z"]) == ("moving_sphere", "capsule", 2, -8)
    assert (body["kind"], body["friction"]) == ("mesh", 0.5)

def test_what_turns(files):
    """Each vertex of an edge that turns has a path of its own: a ring beside a clamp's."""
    path = files("edge_drop", "5,4", "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [0.02, 0, 0, 2]], turn: "
                 "{axis: [0, 1, 0], about: [0, 0, 0], angles: [[0, 0], [0.02, 90]]}}]", "time.end=0.02",
                 "snapshots=[]").rows("paths")
    assert len(path) == 8 * 5 and [path[0][c] for c in ("path", "t", "x")] == [1, 0, 0]
    for n in range(8):  # .25 behind the axis, which is at u = 0, outside
        behind = 0 if n < 4 else 0.25
        assert [path[5 * n + 4][c] for c in "txz"] == near([0.02, behind, 2 + behind], ONE)

# --- meshes --------------------------------------------------------------------------------------

def read_obj(text):
    """(xyz, uv, triangles)"""
    def lines(key):
        return np.array([[float(w) for w in re.split("[ /]", words)] for words in
                         re.findall(rf"^{key} (.*)$", text, re.M)])

    return lines("v"), lines("vt"), lines("f")[:, ::2].astype(int) - 1

def read_ply(text):
    head, body = text.split("end_header\n", 1)
    count, lines = int(re.search(r"element vertex (\d+)", head)[1]), [line.split() for line in body.splitlines()]
    vertices, faces = np.array(lines[:count], float), np.array(lines[count:], int)
    assert re.findall(r"property double (\w)", head) == list("xyzst") and (faces[:, 0] == 3).all()
    return vertices[:, :3], vertices[:, 3:], faces[:, 1:]

def areas(x, triangles):
    """With the sign of the sum of the normal's components: of a flat sheet the sum is the area if all look
    that way."""
    normal = np.cross(x[triangles[:, 1]] - x[triangles[:, 0]], x[triangles[:, 2]] - x[triangles[:, 0]]) / 2
    return np.linalg.norm(normal, axis=1) * np.where(normal.sum(1) < 0, -1, 1)

def test_meshes(files):
    made = files("edge_drop", "5,4", "sheet.width=0.5", "pose={origin: [1, 2, 3], u: [0, 0.6, 0.8], v: [1, 0, 0]}")
    x, uv, triangles = read_obj(made.text("rest.obj"))
    ply, rest = read_ply(made.text("rest.ply")), made.rows("rest")
    assert all((a == b).all() for a, b in zip((x, uv, triangles), ply)) and len(x) == len(rest) == 20
    for n, r in enumerate(rest):
        u, v = n % 5 / 4, n // 5 / 3
        assert r["vertex"] == n and [r[c] for c in "uvxyz"] == near([u, v, 1 + v / 2, 2 + 0.6 * u, 3 + 0.8 * u], ONE)
        assert [r[c] for c in "uvxyz"] == [*uv[n], *x[n]]
    assert areas(x, triangles) == near(np.full(24, 0.5 / 24), SUMS)  # u x v = (0, 0.8, -0.6): its sum is positive
    assert triangles[0, 2] == triangles[2, 2] == 6  # one diagonal of each cell; neighbours have the other
    x, _, triangles = read_ply(files("cloak", "6,9").text("rest.ply"))
    assert abs(areas(x, triangles)).sum() == near(0.5 + pi / 6 * sin(pi / 18), AREA)

def test_sheets(files):
    """Several sheets stand side by side in rows of vertices: the mesh, its masses, springs and held vertices
    are those of each, and nothing lies between two."""
    n, m, sheets, side = 5, 4, 3, 0.2
    made = files("stack", "5,4", "supports=[{at: {sheet: 2, u: 0}, fix: xyz}, {at: {sheet: 3, u: 1}, fix: xyz}]",
                 "loads=[{at: {sheet: 2, u: 1}, force: [0, 0, 1]}]")
    row, (x, uv, triangles) = sheets * n, read_obj(made.text("rest.obj"))
    assert "; 15 x 4 vertices, u fastest" in made.text("rest.obj") and len(x) == row * m
    assert areas(x, triangles) == near(np.full(2 * sheets * (n - 1) * (m - 1), side ** 2 / (2 * (n - 1) * (m - 1))), SUMS)
    i, k = np.arange(row * m) % row % n, np.arange(row * m) % row // n
    assert x[:, 0] == near(-0.1 + side * i / (n - 1), ONE) and x[:, 2] == near(0.003 * k, ONE)
    assert uv[:, 0] == near((33 * k + (32 + k // 2) * i / 4) / 99, ONE)
    assert sum(made.numbers()["mass"]) == near(sheets * 0.3 * side ** 2, SUMS)
    springs = [r for r in made.rows("materials") if r["quantity"].startswith("spring")]
    assert all(r["a"] % row // n == r["b"] % row // n for r in springs)
    assert len(springs) == sheets * ((n - 1) * m + n * (m - 1) + 2 * (n - 1) * (m - 1))
    held = made.rows("held")
    assert len(held) == 4 * m and sum(r["vertex"] >= row * m for r in held) == 2 * m
    for r in held:
        second, out = r["z"] < 0.004, 1.5 if r["vertex"] >= row * m else 1
        assert [r["x"], r["z"]] == near([-0.1 * out, 0.003] if second else [0.1 * out, 0.006], ONE)
    loads = made.rows("loads")
    assert sum(r["z"] for r in loads) == near(1, SUMS) and all(r["vertex"] % row == 2 * n - 1 for r in loads)

@pytest.mark.parametrize("kind", ["obj", "ply", "csv"])
def test_formats(tmp_path, kind):
    """One format alone; the rest is always there."""
    assert told("flag", "--points", "3,4", "--out", tmp_path / "o", "--format", kind)[0] == 0
    assert len(os.listdir(tmp_path / "o")) == 6 and f"rest.{kind}" in os.listdir(tmp_path / "o")

# --- what is held --------------------------------------------------------------------------------

@pytest.mark.parametrize("scene, supports, held, outside, fix", [
    ("edge_drop", None, 11, 11, "xyz"), ("corners_drop", None, 2, 4, "xyz"),  # a corner is clamped along u and v
    ("corners_patch", None, 8, 0, "xyz"), ("hinge", None, 11, 0, "xyz"),
    ("navier", None, 40, 0, "xyz"),  # corners are held in all three
    ("moving_edge", None, 11, 11, "xyz"), ("cloak", None, 11, 11, "xyz"), ("flag", None, 11, 11, "xyz"),
    ("edge_drop", "{at: {v: 1}, fix: xyz}", 11, 11, "xyz"), ("edge_drop", "{at: {u: 0}, fix: yz}", 11, 0, "yz"),
    ("edge_drop", "{at: {u: 0}, fix: z}, {at: {u: 1}, fix: xyz}", 22, 11, "z"),
    ("edge_drop", "{at: {u: 0}, fix: x}, {at: {u: 0}, fix: yz}", 11, 11, "xyz"),
    ("edge_drop", "{at: {u: [0, 0.1]}, fix: xyz}", 22, 0, "xyz"),
    ("edge_drop", "{at: {u: [0, 0.05]}, fix: xyz}", 11, 11, "xyz"),
    ("edge_drop", "{at: {u: [0.4, 0.6]}, fix: xyz}", 33, 0, "xyz"),
    ("edge_drop", "{at: {u: 0.5, w: 0.5}, fix: xyz}", 11, 0, "xyz"),
    ("edge_drop", "{at: {u: [0, 1], w: 0.5}, fix: y}", 121, 0, "y"),
])
def test_held(files, scene, supports, held, outside, fix):
    rows = files(scene, "11,11", *([f"supports=[{supports}]"] if supports else [])).rows("held")
    assert (len(rows), sum(r["beside"] != "" for r in rows), rows[0]["fix"]) == (held + outside, outside, fix)

def test_clamps_are_mirrors(files):
    """Each row outside is the mirror image of the neighbour inside, seen from the held one."""
    rows = files("edge_drop", "5,4").rows("held")
    assert len(rows) == 8
    for n, (inside, out) in enumerate(zip(rows[:4], rows[4:])):
        assert (inside["vertex"], out["vertex"], out["beside"], inside["path"]) == (5 * n, 20 + n, 5 * n, "")
        assert (out["u"], out["x"]) == (-0.25, -0.25) and out["y"] == near(n / 3, ONE)
    assert {r["path"] for r in files("moving_edge", "5,4").rows("held")} == {0}
    assert files("free_fall", "11,11").text("held.csv") == "vertex,u,v,x,y,z,fix,path,beside\n"  # nothing is

@pytest.mark.parametrize("scene, points, has, lacks", [
    ("edge_drop", "21,21", "14 times from 0.1 to 1.4 s", "obstacles.csv"),
    ("strip_bias", "21,21", "1 times B1, 1 times B2", "E h^3"), ("sphere", "21,21", "2 1/s times mass", "paths.csv"),
    ("corners_drop", "21,21", "No truth is stored", "loads.csv"),
    ("corners_patch", "16,16", "ends at u = 0.1, between vertices", "undamped"),
    ("drag_fall", "21,21", "2.5 kg/m^3/s times", "held.csv:"), ("edge_drop", "41,4", "its cells are too long", "warp's"),
    ("edge_drop", "21,20", "14 times", "its cells are too long"),
])
def test_rules(files, scene, points, has, lacks):
    """Numbers that README.md tells its reader, and files that are not there."""
    text = files(scene, points).text("README.md")
    assert has in text and lacks not in text

# --- what is refused -----------------------------------------------------------------------------

NET = ["edge_drop", "--points", "5,5"]

@pytest.mark.parametrize("words, why", [
    *((["edge_drop", "--points", "11,11", "--out", "o", "--set", f"supports=[{bad}]"], why) for why, all_bad in {
        "free on both sides": ["{at: {u: 0.5}, fix: xyz}", "{at: {u: 0.5, v: 0.5}, fix: xyz}",
                               "{at: {u: 0, v: 0.5}, fix: xyz}"],
        "keeps the sheet from turning": ["{at: {u: 0}, fix: xz}", "{at: {u: 0}, fix: x}", "{at: {u: [0, 1]}, fix: y}"],
        "or w = 0.5": ["{at: {u: 0, w: 0}, fix: xyz}", "{at: {u: 0, w: [0.5, 1]}, fix: xyz}",
                       "{at: {u: 0}, fix: xyz}, {at: {u: 1, w: [0.2, 0.8]}, fix: z}"],
        "holds no node": ["{at: {u: [0.02, 0.04]}, fix: xyz}", "{at: {u: 0.333}, fix: xyz}"],
    }.items() for bad in all_bad),
    *((["edge_drop", "--points", points, "--out", "o"], "--points") for points in (
        "5", "5,", ",5", "5,5,2", "5x5", "5, 5", "1,5", "-5,5", "5,501", "5,99999999999999999999", "5.0,5")),
    (NET, "--out"), (["edge_drop", "--out", "o"], "--points"), (["nobody", "--points", "5,5", "--out", "o"], "nobody"),
    (NET + ["--out", ""], "empty"), (NET + ["--out", "o", "--format", "stl"], "stl"),
    (NET + ["--out", "o", "--set", "sheet.length=-1"], "length"),
])
def test_refused(tmp_path, words, why):
    code, said = told(*words, cwd=tmp_path)
    assert code == 2 and why in said and not os.listdir(tmp_path), said

def test_folders(tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis").write_text("")
    (tmp_path / "empty").mkdir()
    for out, code in [("mine", 2), ("mine/thesis", 2), ("mine/thesis/of/mine", 1), ("empty", 0),
                      ("empty", 2), ("new/one///", 0)]:  # not over itself either
        found, said = told("flag", "--points", "3,3", "--out", out, cwd=tmp_path)
        assert found == code and (found == 0 or said), out
    held = {name: len(os.listdir(tmp_path / name)) for name in ("mine", "empty", "new", "new/one")}
    assert held == {"mine": 1, "empty": 8, "new": 1, "new/one": 8}

@pytest.mark.parametrize("room", [0, 100, 1000, 8000, 60000])
def test_full_disk(tmp_path, room):
    """After so many bytes, the last after some of the files: a sentence, and nothing of it is left."""
    (tmp_path / "full").mkdir()
    code, said = told("edge_drop", "--points", "21,21", "--out", "full/disk", cwd=tmp_path, preexec_fn=lambda: (
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))))
    assert code == 1 and said and not os.listdir(tmp_path / "full")
