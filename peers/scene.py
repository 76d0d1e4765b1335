"""What the drivers share: a folder of `clothbench export` as read, what of it none hands over, and
frames as they come back.

A driver is run as  DRIVER FOLDER FRAMES step=0.005 [until=0.5] [KEY=VALUE]...  and prints a line
of JSON, {"version", "seconds"}, of the processor, and {"died", "why"} if it did. FRAMES get a line
a time, `t x y z x y z ...`. Those not in Python read FOLDER/plain.txt: a line a quantity, its name
and then its numbers.
"""
import csv
import json
import math
import pathlib
import re
import sys

# Further from where it began than so many times the length and the way of a free fall no sheet
# comes: what does has blown up.
REACH = 10

# Rows of a fabric; E, nu and D are then its isotropic mean's.
MODULI = ("Y11", "Y22", "Y12", "G", "warp")

# A fabric's law as far as each simulator cannot hold it.
LOST = {
    "blender": "warp and weft: it has their mean in stretch, and the isotropic mean's bending",
    "bullet": "bending and Y12, and with implicit springs warp and weft, of which it has the mean",
    "calculix": "bending of its own: it bends with h^2/12 of the membrane",
    "cannon-es": "all but its masses",
    "jolt": "Y12, which is G in a net of springs, and B12",
    "mujoco": "warp and weft: it has E, nu and h of the isotropic mean",
    "rapier3d": "Y12, and of bending all but one frequency for all hinges"}
WITHOUT_SPRINGS = ("calculix", "mujoco")
# These have no hinges, and take any mesh, with its edges as links; and any number of capsules.
ANY_MESH = ("bullet",)


class Refused(Exception):
    """A sentence."""


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Scene:
    """x[vertex] of the sheet, then of the vertices outside; beside[outside] = vertex."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.read_material(rows(self.folder / "materials.csv"))
        self.read_net(rows(self.folder / "rest.csv"), rows(self.folder / "held.csv"))
        self.times = [float(r["time"]) for r in rows(self.folder / "times.csv")
                      if r["what"] == "truth"]
        text = (self.folder / "scene.yaml").read_text()
        snapshots = re.search(r"^snapshots: (.*)$", text, re.M)
        if snapshots and not self.times:  # without a truth
            self.times = json.loads(snapshots[1])
        self.gravity = json.loads(re.search(r"^gravity: (.*)$", text, re.M)[1])
        kind, value = re.search(r"^damping: {kind: (\w+)(?:, value: (.*))?}", text, re.M).groups()
        self.damping = float(value or 0)  # 1/s
        self.drag = kind not in ("none", "mass") or re.search(r"^(drag|air):", text, re.M)
        self.at_rest = "truth is the shape at rest" in (self.folder / "README.md").read_text()
        obstacles = self.folder / "obstacles.csv"
        self.obstacles = rows(obstacles) if obstacles.exists() else []
        self.ball = [[float(r[c]) for c in ("x", "y", "z", "radius", "friction")]
                     for r in self.obstacles if r["kind"] == "sphere"]
        self.capsules = [[*json.loads(a), *json.loads(b), float(radius), float(friction)]
                         for a, b, radius, friction in re.findall(
                             r"- capsule:\n +from: (.*)\n +to: (.*)\n +radius: (.*)\n"
                             r" +friction: (.*)$", text, re.M)]
        self.meets_itself = re.search(r"^contact: {self: true", text, re.M)

    def read_material(self, material):
        value = {r["quantity"]: float(r["value"]) for r in material}
        self.E, self.nu, self.rho, self.h = (value[q] for q in ("E", "nu", "rho", "h"))
        self.D = value.get("D", self.E * self.h ** 3 / 12 / (1 - self.nu ** 2))
        self.fabric = {q: value[q] for q in MODULI} if "warp" in value else None
        self.bends = {q[6:]: k for q, k in value.items() if q.startswith("hinge ")}
        self.mass = [float(r["value"]) for r in material if r["quantity"] == "mass"]
        self.springs = [(int(r["a"]), int(r["b"]), float(r["value"]), float(r["rest_length"]),
                         r["quantity"]) for r in material if r["quantity"].startswith("spring ")]
        u, v, self.shear = (max((s[2] for s in self.springs if s[4] == f"spring {kind}"), default=0)
                            for kind in ("u", "v", "diagonal"))
        self.stretch = (u + v) / 2  # N/m, of springs that are not on the rim; shear, too

    def read_net(self, rest, held):
        self.uv = [(r["u"], r["v"]) for r in rest]
        self.count = len(rest)
        self.columns = len({r["u"] for r in rest})
        self.held = {int(r["vertex"]) for r in held}
        self.held_in = {r["fix"] for r in held}
        outside = [r for r in held if r["beside"]]
        self.x = [[float(r[c]) for c in "xyz"] for r in rest + outside]
        self.beside = {int(r["vertex"]): int(r["beside"]) for r in outside}

    @property
    def reach(self):
        """[a, b] of the distance a + b t^2 beyond which a vertex is lost."""
        size = max(math.dist(self.x[0], x) for x in self.x)
        return [REACH * size, REACH * math.hypot(*self.gravity) / 2]

    def edges(self):
        """Of any mesh, as springs of no stiffness, as long as they start."""
        sides = {tuple(sorted(side)) for a, b, c in self.faces()[0]
                 for side in ((a, b), (b, c), (c, a))}
        return [(a, b, 0.0, math.dist(self.x[a], self.x[b]), "spring") for a, b in sorted(sides)]

    def faces(self):
        """Triangles of the sheet, and those between vertices outside of it and the held row beside,
        whose cells have the diagonal (+u,+v)."""
        lines = (self.folder / "rest.obj").read_text().splitlines()
        faces = [[int(corner.split("/")[0]) - 1 for corner in line.split()[1:]]
                 for line in lines if line.startswith("f ")]
        outside = {vertex: beyond for beyond, vertex in self.beside.items()}
        clamp = []
        for a, b, c in faces:
            for p, q in (a, b), (b, c), (c, a):
                if p in outside and q in outside:
                    s, t = outside[p], outside[q]
                    clamp += ([[q, p, t], [p, s, t]] if self.uv[p][0] == self.uv[q][0]
                              else [[q, p, s], [q, s, t]])
        return faces, clamp

    def hinges(self, triangles):
        """Where two triangles meet that are not both held: edge a b, corners c and d off it, k of
        k theta^2 / 2 as exported, another where one is held, and the inverse mass of theta,
        sum over vertices of |d theta / d x|^2 / m, of the flat sheet."""
        met = {}
        for t in triangles:
            for i in range(3):
                a, b, c = t[i], t[(i + 1) % 3], t[(i + 2) % 3]
                if (b, a) not in met:
                    met[a, b] = c
                elif not {a, b, c, met[b, a]} <= self.held:
                    yield [a, b, c, met[b, a], *self.hinge(a, b, c, met[b, a])]

    def hinge(self, a, b, c, d):
        edge = [q - p for p, q in zip(self.x[a], self.x[b])]
        length = math.hypot(*edge)

        def side(v):
            w = [q - p for p, q in zip(self.x[a], self.x[v])]
            s = sum(p * q for p, q in zip(w, edge)) / length ** 2
            return s, math.sqrt(max(0, sum(p * p for p in w) - (s * length) ** 2))

        (s, high), (r, low) = side(c), side(d)
        slopes = [(a, (1 - s) / high + (1 - r) / low), (b, s / high + r / low), (c, 1 / high),
                  (d, 1 / low)]
        along = [p == q for p, q in zip(self.uv[a], self.uv[b])]  # whether u, v stay
        kind = "v" if along[0] else "u" if along[1] else "diagonal"
        clamped = any({a, b, corner} <= self.held for corner in (c, d))
        return (self.bends[kind + " held" * clamped],
                sum(g * g / self.mass[v] for v, g in slopes if v not in self.held))


def refuse(scene, name):
    """Raises a sentence about what the driver of a simulator does not hand over; a driver itself
    tells what its simulator cannot."""
    if not scene.bends and name not in ANY_MESH:
        raise Refused("the drivers hand flat sheets over: the export tells no hinges of others")
    if scene.bends and not scene.springs and name not in WITHOUT_SPRINGS:
        raise Refused("the driver needs springs, and the export tells none: nets along u and v "
                      "cannot hold this warp")
    if "\n  softening:" in (scene.folder / "scene.yaml").read_text():
        raise Refused("the drivers hand no softening over")
    for file in "loads", "paths", "velocities":
        if (scene.folder / f"{file}.csv").exists():
            raise Refused(f"the drivers hand no {file} over")
    kinds = [r["kind"] for r in scene.obstacles]
    capsules = name in ANY_MESH and {*kinds} <= {"sphere", "capsule"}
    if kinds not in ([], ["sphere"]) and not capsules:
        raise Refused("the drivers hand one ball over and no other obstacle: no truth has one")
    if scene.drag:
        raise Refused("the drivers hand mass damping over, no other drag")
    if any(fix != "xyz" for fix in scene.held_in):
        raise Refused("the drivers hold whole vertices only")


def write_plain(scene):
    faces, clamp = scene.faces()
    outside = len(scene.x) - scene.count
    springs = [(*s[:4], int(s[4] == "spring diagonal"))
               for s in (scene.springs if scene.bends else scene.edges())]
    lists = {
        **{name: [getattr(scene, name)] for name in ("E", "nu", "h", "stretch", "shear", "count",
                                                     "columns", "damping")},
        "gravity": scene.gravity, "reach": scene.reach, "times": scene.times,
        "held": sorted(scene.held),
        "mass": scene.mass + [0] * outside,
        **{name: [number for row in table for number in row] for name, table in (
            ("ball", scene.ball), ("capsules", scene.capsules), ("x", scene.x),
            ("springs", springs), ("faces", faces), ("clamp", clamp),
            ("hinges", scene.hinges(faces + clamp) if scene.bends else []))}}
    (scene.folder / "plain.txt").write_text("".join(
        " ".join([name, *map(repr, numbers)]) + "\n" for name, numbers in lists.items()))


def words(arguments):
    """The scene, FRAMES and {KEY: VALUE} of a command line; times to come are in scene.times."""
    folder, out, *rest = arguments
    settings = dict(word.split("=", 1) for word in rest)
    settings["step"] = float(settings["step"])
    scene = Scene(folder)
    scene.times = [t for t in scene.times if t <= float(settings.get("until", math.inf)) + 1e-9]
    return scene, out, settings


def is_lost(scene, t, x):
    """Whether a vertex is not finite, or further off than it can have come."""
    far = scene.reach[0] + scene.reach[1] * t * t
    return not all(math.dist(p, q) <= far for p, q in zip(scene.x, x))


def finish(out, frames, version, seconds, **died):
    """frames: {time: [x of each vertex of the sheet]}"""
    with open(out, "w") as file:
        for t, x in sorted(frames.items()):
            print("%.12g" % t, *("%.9g" % c for place in x for c in place), file=file)
    print(json.dumps({"version": version, "seconds": seconds, **died}))


def to_csv(scene, frames, out):
    """A driver's frames, with u and v; how many."""
    lines = [line.split() for line in pathlib.Path(frames).read_text().splitlines()]
    with open(out, "w") as file:
        file.write("t,u,v,x,y,z\n")
        for t, *x in lines:
            if len(x) != 3 * scene.count:
                sys.exit(f"{frames}: {len(x)} coordinates at {t} s for {scene.count} vertices")
            for v, uv in enumerate(scene.uv):
                file.write(",".join([t, *uv, *x[3 * v:3 * v + 3]]) + "\n")
    return len(lines)
