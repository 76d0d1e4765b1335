"""Vertices find their material points: by uv, vt, a rest mesh or their first positions, in any order, on uneven
nets, in triangles, with a row outside the sheet; and what covers no sheet is refused. Frames are the truth at
vertices: what is off is the net's floor. What is printed of a score has every number in its own column."""
import functools
import json
import os

import numpy as np
import pytest
from test_score import known

import clothbench

SIDE, FRAMES = 24, 6
NET = SIDE * SIDE
FLOOR = 8e-4  # more than the truth on SIDE x SIDE vertices is off at 0.5 s, bilinear [L]; in triangles twice

def net_of(outside=False, jitter=False, span=1):
    """uv[vertex, 2]"""
    n = np.arange(NET)
    i, j = n % SIDE, n // SIDE
    uv = np.stack([(i - 1) / (SIDE - 2) if outside else (i / (SIDE - 1)) ** 1.2, j / (SIDE - 1)], 1)
    inner = (i > 0) & (j > 0) & (i < SIDE - 1) & (j < SIDE - 1) & jitter
    uv += inner[:, None] * 0.3 / SIDE * np.sin(np.stack([12.9898 * n, 78.233 * n], 1))
    return uv * [span, 1]

@functools.lru_cache
def fields():
    """The sheet at rest and the truth each tenth of a second, [frame, v, u, 3] on the material grid."""
    rest, t, xyz = known("edge_drop", 100)
    kept = [int(abs(t - k / 10).argmin()) for k in range(1, FRAMES)]
    return np.concatenate([rest[None], xyz[kept]]).reshape(FRAMES, 100, 100, 3)

def position(k, uv):
    at = 99 * np.clip(uv, 0, 1)
    (i, j), (a, b) = np.minimum(at.astype(int), 98).T, (at % 1 + (at >= 99)).T[:, :, None]
    f = fields()[k]
    xyz = (1 - b) * ((1 - a) * f[j, i] + a * f[j, i + 1]) + b * ((1 - a) * f[j + 1, i] + a * f[j + 1, i + 1])
    xyz[:, 0] += np.minimum(uv[:, 0], 0)
    return xyz

def write(folder, told=False, shuffle=False, faces=False, holed=False, first=0, **net):
    """Frames of the net as meshes; told: with uv; holed: faces are missing along v = 0."""
    order = np.arange(NET) * 7 % NET if shuffle else np.arange(NET)  # 7 and 576 share no divisor
    at, uv, corners = np.argsort(order) + 1, net_of(**net), []
    for n in range(SIDE if holed else 0, NET - SIDE if faces else 0):
        corners += [(n, n + 1, n + SIDE), (n + 1, n + SIDE + 1, n + SIDE)] if n % SIDE < SIDE - 1 else []
    folder.mkdir()
    for k in range(first, FRAMES):
        lines = ["v %.17g %.17g %.17g" % tuple(x) for x in position(k, uv)[order]]
        lines += ["vt %.17g %.17g" % tuple(p) for p in uv[order] if told]
        lines += ["f " + " ".join(f"{at[c]}/{at[c]}" if told else str(at[c]) for c in face) for face in corners]
        (folder / f"f{k}.obj").write_text("\n".join(lines) + "\n")
    return folder

def score(folder, rest=None, form="json"):
    return clothbench.run("score", "edge_drop", folder, "--dt", "0.1", "--format", form,
                          *(["--rest", rest] if rest else []))

@pytest.mark.parametrize("net, rest, floors", [
    ({"told": True}, None, 1), ({"told": True, "faces": True, "shuffle": True}, None, 1), ({"shuffle": True}, None, 1),
    ({"shuffle": True}, {"shuffle": True}, 1), ({}, {"told": True}, 1), ({"told": True, "outside": True}, None, 2),
    ({"told": True, "jitter": True, "faces": True}, None, 2),
    ({"told": True, "jitter": True, "faces": True, "span": 0.9999}, None, 2),
    ({"jitter": True, "faces": True, "shuffle": True}, None, 2),
])
def test_found(tmp_path, net, rest, floors):
    other = write(tmp_path / "rest", **rest) / "f0.obj" if rest else None
    sheet = json.loads(score(write(tmp_path / "net", **net), other))
    assert sheet["frames"].startswith(f"{FRAMES} frames of {NET} vertices") and len(sheet["rows"]) == FRAMES - 1
    assert ("matched by their rest positions" in sheet["frames"]) == (not (rest or net).get("told"))
    for row in sheet["rows"]:
        assert 0 < row["error"] < floors * FLOOR and abs(row["error"] - row["floor"]) < 2e-4

@pytest.mark.parametrize("net, why", [
    ({"first": 3}, "vertex 2 of the first frame lies {:.3g} m from"), ({"told": True, "span": 0.5}, "u runs from 0 to 0.5;"),
    ({"told": True, "span": 2}, "u runs from 0 to 2;"), ({"told": True, "span": 1.4}, "u runs from 0 to 1.4;"),
    ({"told": True, "jitter": True}, "508 lines u and 508 lines v"), ({"told": True}, "grid.obj: has 3 vertices"),
    ({"told": True, "jitter": True, "faces": True, "holed": True}, "leave u = 0, v = 0 of the sheet bare"),
])
def test_refused(tmp_path, net, why):
    (tmp_path / "grid.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\n")
    with pytest.raises(ValueError, match=why.format(-position(3, net_of())[1, 2])):
        score(write(tmp_path / "net", **net), tmp_path / "grid.obj" if "grid" in why else None)

def test_ladders(tmp_path, monkeypatch):
    """A ladder of truths that lacks an array is refused; a scene that has none is not."""
    samples = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "samples")
    (tmp_path / "edge_drop_ladder.npz").symlink_to(os.path.join(samples, "stored.npz"))
    monkeypatch.setenv("CLOTHBENCH_LADDERS", str(tmp_path))
    with pytest.raises(ValueError, match="stored.npz|edge_drop_ladder"):
        score(write(tmp_path / "net", told=True))
    fall = clothbench.truth.read("free_fall")
    clothbench.frames.write(tmp_path / "fall.npz", fall.t, fall.uv, fall.xyz)
    assert clothbench.score("free_fall", tmp_path / "fall.npz")[0]["rows"]

def test_printed(tmp_path):
    """Each number in its own column, and how many of the times lie between frames."""
    t = np.array([0.1, 0.2, 0.31, 0.5])
    xyz = np.array([position(k, net_of()) for k in (1, 2, 3, 5)])
    clothbench.frames.write(tmp_path / "frames.npz", t, net_of(), xyz)
    words = ["score", "edge_drop", tmp_path / "frames.npz", "--format"]
    sheet, csv = json.loads(clothbench.run(*words, "json")), clothbench.run(*words, "csv")
    assert [row["time"] for row in sheet["rows"]] == [0.1, 0.2, 0.3, 0.5]
    for row in sheet["rows"]:
        assert ",".join(["edge_drop"] + [f"{row[key]:.17g}" for key in ("time", "error", "bar", "floor")]) in csv
        assert len({row[key] for key in ("error", "bar", "floor")}) == 3
    assert "at the 4 where both exist, at 1 of them" in sheet["frames"]
