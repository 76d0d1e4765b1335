"""CalculiX (Debian calculix-ccx): quadratic shells S8R, large displacements, implicit steps of
Hilber, Hughes and Taylor with its default alpha, -0.05. E, nu, rho and h are its own parameters;
a fabric is *ELASTIC, TYPE=ORTHO along the warp, and bends with h^2/12 of its membrane.

An element covers two by two cells of the exported net, whose counts of cells are to be even. The
vertex in its middle is no node of S8R: it is where the element's own shape functions have it.
Rotations are held where the export has a vertex outside the sheet beside, which is not used, and in
patches. Mass damping is Rayleigh's alpha. A scene whose truth is a shape at rest is solved for at
rest, without time. There is no ball: refused.
S4 and S8 lock here, S4R runs away by hourglassing.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import scene as export  # noqa: E402

FIRST = 1e4  # a load at rest begins with so small a share; CalculiX picks the later ones
MOST = 2000  # increments to rest


def elements(scene):
    """(corners and midsides in CalculiX's order, the vertex in the middle) of each."""
    if hasattr(scene, "shells"):  # a net of outlines.py
        return scene.shells
    n, m = scene.columns, scene.count // scene.columns
    if n % 2 == 0 or m % 2 == 0:
        sys.exit(f"{n} x {m} points: an S8R needs two by two cells, so odd counts of points")
    ring = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
    return [([(b + j) * n + a + i for i, j in ring], (b + 1) * n + a + 1)
            for b in range(0, m - 1, 2) for a in range(0, n - 1, 2)]


def in_patches(scene):
    """Vertices of cells that are held at all corners."""
    n = scene.columns
    cells = ({v, v + 1, v + n, v + n + 1} for v in range(scene.count - n) if (v + 1) % n)
    return set().union(*(cell for cell in cells if cell <= scene.held))


def elastic(scene):
    """Lines of the law. A fabric's membrane over h is that of plane stress, for nothing across the
    sheet is coupled to it; across it is as stiff as along the warp, and sheared as in the plane."""
    if not scene.fabric:
        return ["*ELASTIC", f"{scene.E!r}, {scene.nu!r}"]
    a, b, c, g = (scene.fabric[name] / scene.h for name in ("Y11", "Y22", "Y12", "G"))
    return ["*ELASTIC, TYPE=ORTHO", "%.12g, %.12g, %.12g, 0, 0, %.12g, %.12g, %.12g," %
            (a, c, b, a, g, g), "%.12g" % g]


def orientation(scene):
    """Directions of warp and weft of a flat sheet."""
    u, v = ([q - p for p, q in zip(scene.x[0], scene.x[far])]
            for far in (scene.columns - 1, scene.count - scene.columns))
    u, v = ([c / math.hypot(*side) for c in side] for side in (u, v))
    turn = math.radians(scene.fabric["warp"])
    axes = [math.cos(turn) * p + math.sin(turn) * q for p, q in zip(u, v)] + \
        [math.cos(turn) * q - math.sin(turn) * p for p, q in zip(u, v)]
    return ["*ORIENTATION, NAME=WARP", ", ".join("%.12g" % (c + 0.0) for c in axes)]


def deck(scene, settings):
    if scene.ball:
        sys.exit("CalculiX has contact between faces of elements, and no ball")
    shells = elements(scene)
    middles = {middle for _, middle in shells}
    nodes = [v for v in range(scene.count) if v not in middles]
    clamped = set(scene.beside.values()) | in_patches(scene)
    g = sum(c * c for c in scene.gravity) ** 0.5
    step, times = settings["step"], scene.times
    damping, procedure = [], ["*STATIC", "%.12g, %.12g" % (times[-1] / FIRST, times[-1])]
    if not scene.at_rest:
        procedure = ["*DYNAMIC, ALPHA=-0.05", "%.12g, %.12g, 1e-8, %.12g" % (step, times[-1], step)]
        damping = ["*DAMPING, ALPHA=%.12g, BETA=0" % scene.damping] * (scene.damping > 0)
    return "\n".join(
        ["*NODE, NSET=ALL"] +
        ["%d, %.12g, %.12g, %.12g" % (v + 1, *scene.x[v]) for v in nodes] +
        ["*ELEMENT, TYPE=S8R, ELSET=SHEET"] +
        [", ".join(str(k) for k in [e + 1] + [v + 1 for v in ring])
         for e, (ring, _) in enumerate(shells)] +
        (orientation(scene) if scene.fabric else []) +
        ["*MATERIAL, NAME=CLOTH", *elastic(scene), "*DENSITY", repr(scene.rho)] + damping +
        ["*SHELL SECTION, ELSET=SHEET, MATERIAL=CLOTH" + ", ORIENTATION=WARP" * bool(scene.fabric),
         repr(scene.h)] +
        (["*BOUNDARY"] if scene.held else []) +
        ["%d, 1, %d" % (v + 1, 6 if v in clamped else 3) for v in nodes if v in scene.held] +
        ["*TIME POINTS, NAME=TRUTH"] + ["%.12g" % t for t in times] +
        ["*STEP, NLGEOM, INC=%d" % (MOST if scene.at_rest else 100 * times[-1] / step)] + procedure +
        ["*DLOAD", "SHEET, GRAV, %.12g, %.12g, %.12g, %.12g" % (g, *(c / g for c in scene.gravity)),
         "*NODE FILE, NSET=ALL, OUTPUT=2D, TIME POINTS=TRUTH", "U", "*END STEP"]) + "\n"


def displacements(path):
    """{time: {vertex: displacement}} of a result file, whose columns are fixed."""
    found, now, on = {}, None, False
    with open(path) as file:
        for line in file:
            if line.startswith("  100CL"):
                now = float(line[12:24])
            elif line.startswith(" -4"):
                on = line.split()[1] == "DISP"
            elif line.startswith(" -3"):
                on = False
            elif on and line.startswith(" -1"):
                found.setdefault(now, {})[int(line[3:13]) - 1] = [
                    float(line[13 + 12 * c:25 + 12 * c]) for c in range(3)]
    return found


def positions(scene, moved):
    x = [None] * scene.count
    for v, d in moved.items():
        if v < scene.count:
            x[v] = [a + b for a, b in zip(scene.x[v], d)]
    for ring, middle in elements(scene):
        if middle is None:
            continue
        x[middle] = [sum(x[v][c] for v in ring[4:]) / 2 - sum(x[v][c] for v in ring[:4]) / 4
                     for c in range(3)]
    return x


SHARES = [(0, 0), (1, 0), (1, 1), (0, 1), (.5, 0), (1, .5), (.5, 1), (0, .5)]


def shape(a, b):
    """Of an S8R's nodes, corners and then midsides, at a, b of [0, 1] x [0, 1]."""
    x, y, found = 2 * a - 1, 2 * b - 1, []
    for p, q in ((2 * i - 1, 2 * j - 1) for i, j in SHARES):
        found.append((1 - x * x) * (1 + q * y) / 2 if p == 0 else
                     (1 + p * x) * (1 - y * y) / 2 if q == 0 else
                     (1 + p * x) * (1 + q * y) * (p * x + q * y - 1) / 4)
    return found


def sampled(scene, x, points):
    """Positions at points x points of the sheet, u fastest, of positions at the vertices: by the
    elements' own shape functions."""
    n, m = (scene.columns - 1) // 2, (scene.count // scene.columns - 1) // 2
    rings = [ring for ring, _ in elements(scene)]
    found = []
    for j in range(points):
        for i in range(points):
            u, v = i * n / (points - 1), j * m / (points - 1)
            a, b = min(int(u), n - 1), min(int(v), m - 1)
            weights, ring = shape(u - a, v - b), rings[b * n + a]
            found.append([sum(w * x[k][c] for w, k in zip(weights, ring)) for c in range(3)])
    return found


def reached(path):
    """When the last increment that converged ended; its columns are fixed, total time the sixth."""
    lines = path.read_text().splitlines()[2:] if path.exists() else []
    return float(lines[-1].split()[4]) if lines else 0.0


def solve(folder):
    """Runs folder/job.inp: seconds of the processor, {"died", "why"} if it did."""
    start = os.times()
    run = subprocess.run(["ccx", "job"], cwd=folder, capture_output=True, text=True)
    end = os.times()
    seconds = sum(end[2:4]) - sum(start[2:4])  # of the child
    errors = [line.strip() for line in run.stdout.splitlines() if "*ERROR" in line]
    if not run.returncode and not errors:
        return seconds, {}
    why = (errors + run.stdout.strip().splitlines()[-1:] + ["nothing"])[0]
    return seconds, {"died": reached(folder / "job.sta"), "why": f"ccx says {why}"}


def frames_of(scene, folder):
    """{time: positions} of what was solved."""
    result = folder / "job.frd"
    found = displacements(result) if result.exists() else {}
    return {t: positions(scene, d) for t, d in found.items() if t in scene.times}


def version():
    return subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout.split()[-1]


def main():
    scene, out, settings = export.words(sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "job.inp").write_text(deck(scene, settings))
        seconds, died = solve(folder)
        frames = frames_of(scene, folder)
    export.finish(out, frames, version(), seconds, **died)


if __name__ == "__main__":
    main()
