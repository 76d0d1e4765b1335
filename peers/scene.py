"""What the drivers in Python share: reading a folder of `clothbench export`, writing frames.

A driver is run as  drive.py FOLDER FRAMES.csv step=0.005 until=0.5 [KEY=VALUE]...  and prints a
line of JSON, {"version", "seconds"}; seconds are the processor's.
"""
import csv
import json
import pathlib
import re


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Scene:
    """x[vertex] of the sheet, then of the vertices outside; beside[outside] = vertex."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        material = rows(folder / "materials.csv")
        value = {r["quantity"]: float(r["value"]) for r in material}
        self.E, self.nu, self.rho, self.h, self.D = (value[q] for q in ("E", "nu", "rho", "h", "D"))
        self.mass = [float(r["value"]) for r in material if r["quantity"] == "mass"]
        self.springs = [(r["quantity"], float(r["value"]), float(r["rest_length"]))
                        for r in material if r["quantity"].startswith("spring ")]
        rest, held = rows(folder / "rest.csv"), rows(folder / "held.csv")
        self.uv = [(r["u"], r["v"]) for r in rest]
        self.count = len(rest)
        self.columns = len({r["u"] for r in rest})
        self.held = {int(r["vertex"]) for r in held}
        outside = [r for r in held if r["beside"]]
        self.x = [[float(r[c]) for c in "xyz"] for r in rest + outside]
        self.beside = {int(r["vertex"]): int(r["beside"]) for r in outside}
        self.times = [float(r["time"]) for r in rows(folder / "times.csv") if r["what"] == "truth"]
        found = re.search(r"^gravity: (.*)$", (folder / "scene.yaml").read_text(), re.M)
        self.gravity = json.loads(found[1])


def words(arguments):
    """FOLDER, FRAMES and {KEY: VALUE} of a command line; step and until are numbers."""
    folder, out, *rest = arguments
    settings = dict(word.split("=", 1) for word in rest)
    for key in ("step", "until"):
        settings[key] = float(settings[key])
    return Scene(folder), out, settings


def finish(scene, out, frames, version, seconds):
    """frames: {time: [x of each vertex of the sheet]}"""
    with open(out, "w") as file:
        file.write("t,u,v,x,y,z\n")
        for t, x in sorted(frames.items()):
            for (u, v), place in zip(scene.uv, x):
                file.write("%.12g,%s,%s,%.9g,%.9g,%.9g\n" % (t, u, v, *place))
    print(json.dumps({"version": version, "seconds": seconds}))
