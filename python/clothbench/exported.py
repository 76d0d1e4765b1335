"""What `clothbench export` wrote, as arrays."""

import csv
import json
import pathlib
import re

import numpy

class Exported:
    """A folder of `clothbench export`, in SI units; vertices count from 0.

    x [n + outside, 3]   at rest: vertices of the sheet, then those outside that make a clamp
    uv [n, 2]            of the sheet, and outside_uv of the others
    triangles [m, 3]     of the sheet, counter-clockwise seen from u x v
    pattern [m, 3, 2]    places of their corners in the flat pattern of a garment [m]; else empty
    held                 {vertex: its held components, as "xyz"}
    beside               {vertex outside: the held vertex that it stands beside}
    path                 {held vertex that moves: the number of its path}
    paths                {number: [(t, x, y, z)]}, shifts [m] at times [s]
    mass [n]             of each vertex
    springs              an array with fields a, b, stiffness, length
    hinges               of a mesh: an array with fields a, b (the edge), c, d, stiffness; else empty
    material             {quantity: value}: E, nu, h, D, hinge u, ... of materials.csv
    times, bars          at which the truth is known, and how well; step, end
    velocities           [(x, y, z)] of the sheet's vertices; empty: they begin at rest
    gravity [3]          and damping, {"kind": "mass", "value": 2.0}
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        rest, held = self._rows("rest.csv"), self._rows("held.csv")
        outside = [r for r in held if r["beside"]]
        self.uv, self.outside_uv = _columns(rest, "uv"), _columns(outside, "uv")
        self.x = _columns(rest + outside, "xyz")
        self.held = {int(r["vertex"]): r["fix"] for r in held}
        self.beside = {int(r["vertex"]): int(r["beside"]) for r in held if r["beside"]}
        self.path = {int(r["vertex"]): int(r["path"]) for r in held if r["path"]}
        self.paths = {}
        for r in self._rows("paths.csv"):
            self.paths.setdefault(int(r["path"]), []).append(tuple(float(r[c]) for c in "txyz"))
        self.velocities = _columns(self._rows("velocities.csv"), "xyz").tolist()
        faces = re.findall(r"^f (\d+)/(\d+) (\d+)/(\d+) (\d+)/(\d+)$", self._text("rest.obj"), re.M)
        corners = numpy.array(faces, dtype=int).reshape(-1, 3, 2) - 1
        self.triangles = corners[:, :, 0]
        flat = numpy.array(re.findall(r"^vt (\S+) (\S+)$", self._text("rest.obj"), re.M), dtype=float)
        self.pattern = flat[corners[:, :, 1] if len(flat) == 3 * len(faces) else []]
        numbers = self._rows("materials.csv")
        self.mass = numpy.array([float(r["value"]) for r in numbers if r["quantity"] == "mass"])
        self.springs = numpy.array(
            [(r["a"], r["b"], r["value"], r["rest_length"]) for r in numbers if r["quantity"].startswith("spring")],
            dtype=[("a", int), ("b", int), ("stiffness", float), ("length", float)])
        self.hinges = numpy.array([tuple(r.values()) for r in self._rows("hinges.csv")], dtype=[
            *((c, int) for c in "abcd"), ("stiffness", float)])
        self.material = {r["quantity"]: float(r["value"]) for r in numbers if not r["a"]}
        times = self._rows("times.csv")
        self.step, self.end = (float(r["time"]) for r in times[:2])
        self.times, self.bars = _columns(times[2:], ("time", "bar")).T
        scene = self._text("scene.yaml")
        self.gravity = numpy.array(json.loads(re.search(r"^gravity: (.*)$", scene, re.M)[1]))
        damping = re.search(r"^damping: {(.*)}$", scene, re.M)[1]
        self.damping = {key: word if key == "kind" else float(word)
                        for key, word in re.findall(r"(\w+): ([^,]+)", damping)}

    def _text(self, name):
        return (self.folder / name).read_text()

    def _rows(self, name):
        """Of a file that only some scenes have: none."""
        if name in ("paths.csv", "velocities.csv", "hinges.csv") and not (self.folder / name).exists():
            return []
        return list(csv.DictReader(self._text(name).splitlines()))

def _columns(rows, names):
    return numpy.array([[float(r[c]) for c in names] for r in rows]).reshape(-1, len(names))
