"""Nets of S8R for two kinds of flat sheets that are no rectangles, in place of an exported net: the
bilinear image of a square for an outline of four corners, and rings from a square to a hole in it.
Sides of elements are straight, and the hole is the scene's polygon, whose sides they divide.
"""
import json
import re

RING = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]  # of an S8R, in halves
SAMPLES = 8  # along a and b of a net; twice and half as many around a hole


def between(p, q, share):
    return [c + share * (d - c) for c, d in zip(p, q)]


def along(line, a):
    """The point at a, counted in sides, of a closed line."""
    k = int(a + 1e-9)
    return between(line[k % len(line)], line[(k + 1) % len(line)], a - k)


def place(outline, hole, a, b):
    """The point at a, b of [0, 1] x [0, 1]; with a hole a goes around, from the middle of the
    second side, where the hole's first point is, and b inwards."""
    if hole:
        return between(along(outline, 1.5 + 4 * a), along(hole, len(hole) * a), b)
    return between(along(outline, a), along(outline, 3 - a), b)


def lay(scene, text, net):
    """Puts a net of so many elements along a and b in place of the exported one: x, count, held,
    beside, shells, and samples {(u, v): vertex}. What is held is clamped, as by the vertices outside
    that the export has, and is all of a side."""
    outline, hole = (re.search(key + r": (\[\[.*\]\])", text) for key in ("outline", "holes"))
    outline, hole = json.loads(outline[1]), json.loads(hole[1])[0] if hole else []
    n, m = net
    low, high = [min(c) for c in zip(*outline)], [max(c) for c in zip(*outline)]
    vertices, places = {}, []

    def vertex(i, j):
        key = i % (2 * n) if hole else i, j
        if key not in vertices:
            vertices[key] = len(places)
            places.append(place(outline, hole, key[0] / (2 * n), j / (2 * m)))
        return vertices[key]

    scene.shells = [([vertex(2 * e + i, 2 * f + j) for i, j in RING], None)
                    for f in range(m) for e in range(n)]
    uv = [[(c - a) / (b - a) for c, a, b in zip(p, low, high)] for p in places]
    fixed = [tuple(map(float, scene.uv[v])) for v in scene.held if v < scene.count]
    side = min((0, 1), key=lambda c: len({at[c] for at in fixed}))
    scene.held = {v for v, at in enumerate(uv) if abs(at[side] - fixed[0][side]) < 1e-9}
    scene.beside = {-1 - v: v for v in scene.held}
    scene.x = [[*p, 0.0] for p in places]
    scene.length = high[0] - low[0]
    scene.count = scene.columns = len(places)
    k, l = (2 * SAMPLES, SAMPLES // 2) if hole else (SAMPLES, SAMPLES)
    chosen = [vertices[2 * n * i // k, 2 * m * j // l]
              for j in range(l + 1) for i in range(k + (not hole))]
    scene.samples = {tuple(uv[v]): v for v in chosen}
