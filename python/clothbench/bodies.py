"""The surfaces of a scene's bodies, for pictures: quadrilaterals [n, 4, 3] from the scene's text."""
import re

import numpy as np

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")

def of_scene(text, triangles):
    """[(kind, {key: numbers})] of the text in a result file, below which settings stand; `triangles`
    [n, 3, 3] are those of the bodies, by number, that are meshes."""
    block = re.search(r"^obstacles:(.*(?:\n(?:[ \-].*|#(?! --set).*)?)*)", text, re.M)
    words = (re.findall(r"^# --set obstacles=(.*)", text, re.M) or [block[1] if block else ""])[-1]
    parts = re.split(r"\b(plane|sphere|capsule|box|mesh):", re.sub(r"#.*", "", words))
    made = []
    for n, (kind, told) in enumerate(zip(parts[1::2], parts[2::2])):
        words = re.split(r"(\w+):", told)
        keys = {key: np.array(NUMBER.findall(value), float) for key, value in zip(words[1::2], words[2::2])}
        made.append((kind, keys | {"triangles": triangles.get(n, np.zeros((0, 3, 3)))}))
    return made

def quads(grid):
    """Those of points [rows, columns, 3]."""
    return np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], 2).reshape(-1, 4, 3)

def across(axis):
    """Two directions across one, all of length 1."""
    first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    first /= np.linalg.norm(first)
    return first, np.cross(axis, first)

def rod(one, other, radius):
    """A round rod between two half balls."""
    axis = other - one if (other != one).any() else np.array([0, 0, 1.0])
    axis = axis / np.linalg.norm(axis)
    first, second = across(axis)
    polar = np.concatenate([np.linspace(0, np.pi / 2, 12), np.linspace(np.pi / 2, np.pi, 12)])[:, None, None]
    round_ = np.linspace(0, 2 * np.pi, 41)[None, :, None]
    ends = np.where(np.arange(24)[:, None, None] < 12, other, one)
    return quads(ends + radius * (np.cos(polar) * axis + np.sin(polar) * (
        np.cos(round_) * first + np.sin(round_) * second)))

def box(center, size, u, v):
    """Its six sides, cut into cells that hide each other rightly."""
    edges = np.stack([u, v, np.cross(u, v)]) * size[:, None] / 2
    steps, made = np.linspace(-1, 1, 13), []
    for k in range(3):
        face = steps[:, None, None] * edges[k - 1] + steps[None, :, None] * edges[k - 2]
        made += [quads(center + side * edges[k] + face) for side in (-1, 1)]
    return np.concatenate(made)

def plane(point, normal, low, high):
    """As much of it as lies below what reaches from low to high."""
    normal = normal / np.linalg.norm(normal)
    first, second = across(normal)
    middle, reach = (low + high) / 2, 0.9 * np.linalg.norm(high - low)
    steps = np.linspace(-reach, reach, 15)
    return quads(middle - (middle - point) @ normal * normal + steps[:, None, None] * first +
                 steps[None, :, None] * second)

def moved(points, keys, t):
    """Where a body's points are at a time: turned about a line, then shifted."""
    path, angles = (keys.get(k, np.zeros(0)).reshape(-1, n) for k, n in (("path", 4), ("angles", 2)))
    if len(angles):
        x, y, z = keys["axis"] / np.linalg.norm(keys["axis"])
        cross, angle = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), np.radians(np.interp(t, *angles.T))
        turn = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
        points = (points - keys["about"]) @ turn.T + keys["about"]
    return points + [np.interp(t, path[:, 0], path[:, c]) if len(path) else 0 for c in (1, 2, 3)]

def surfaces(bodies, t, low, high):
    """(the planes' quadrilaterals, the others') at a time; a body that is not told well is left out."""
    made = [np.zeros((0, 4, 3))], [np.zeros((0, 4, 3))]
    for kind, keys in bodies:
        try:
            if kind == "plane":
                ends = moved(np.stack([keys["point"], keys["point"] + keys["normal"]]), keys, t)
                made[0].append(plane(ends[0], ends[1] - ends[0], low, high))
            else:
                shape = {"sphere": lambda k: rod(k["center"], k["center"], k["radius"]),
                         "capsule": lambda k: rod(k["from"], k["to"], k["radius"]),
                         "box": lambda k: box(k["center"], k["size"], k.get("u", np.eye(3)[0]),
                                              k.get("v", np.eye(3)[1])),
                         "mesh": lambda k: k["triangles"][:, [0, 1, 2, 2]]}[kind](keys)
                made[1].append(moved(shape, keys, t))
        except (KeyError, ValueError, IndexError):
            continue
    return tuple(found[np.isfinite(found).all((1, 2))] for found in map(np.concatenate, made))
