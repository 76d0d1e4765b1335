"""scene.usda of `export`: sheets and the cells of their clamps lie as they should, and what is held is
what held.csv has; without numpy the other files are there, and the sentence says what is missing."""
import os
import re
import subprocess

import numpy as np
import pytest

import clothbench
from clothbench import usd

FAR = "supports=[{at: {u: 1}, fix: xyz}, {at: {u: 0}, fix: z}]"
ALL = "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}, {at: {v: 0}, fix: xyz}, {at: {v: 1}, fix: xyz}]"
TWO = "supports=[{at: {sheet: 2, u: 0}, fix: xyz}, {at: {sheet: 3, u: 1}, fix: xyz}]"

def numbers(text, name):
    return [float(n) for n in re.findall(r"[-\d.e]+", re.search(rf"{name} = \[([^\]]*)\]", text)[1])]

@pytest.mark.parametrize("scene, change, has, vertices, area", [
    ("edge_drop", None, "surfaceBendStiffness = 1.49316139e-05", 24, 1.25),
    ("edge_drop", FAR, '"z"', 24, 1.25),
    ("edge_drop", ALL, "thicknesses = [0.001177]", 30, 1.5),
    ("stack", TWO, '"PhysicsCollisionAPI"', 68, 3 * 0.04 + 2 * 0.01),
    ("moving_edge", None, "0.1: (0, 0, 0.1),", 24, 1.25),
    ("edge_drop", "motion={velocity: [1, 2, 3], spin: [0, 0, 0]}", "(0, 0, 0), (1, 2, 3)", 24, 1.25),
    ("cloak", None, '"restShape"', 24, None),
    ("free_fall", None, "held = []", 20, None),
])
def test_usd(tmp_path, scene, change, has, vertices, area):
    export = clothbench.export(scene, 5, 4, tmp_path / "out", dict([change.split("=", 1)]) if change else {})
    text = (tmp_path / "out" / "scene.usda").read_text()
    x = np.array(numbers(text, r"point3f\[\] points")).reshape(-1, 3)
    corners = np.array(numbers(text, "faceVertexIndices"), int).reshape(-1, 3)
    assert has in text and len(x) == vertices and np.allclose(x, export.x, atol=1e-8)
    assert len(numbers(text, "primvars:st")) == 2 * vertices
    assert len(numbers(text, "faceVertexCounts")) == len(corners)
    sides = np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(np.unique(sides, axis=0)) == len(sides)  # none lies on another, and all turn the same way
    if area:  # in the plane x, y, counted from above
        a, b, c = (x[corners[:, k], :2] for k in range(3))
        assert np.cross(b - a, c - a).sum() / 2 == pytest.approx(area)
    assert numbers(text, "clothbench:held") == list(export.held)
    whole = [v for v, fix in export.held.items() if fix == "xyz"]
    held = [numbers(part, "indices0") for part in text.split("def PhysicsAttachment")[1:]]
    assert sorted(sum(held, [])) == whole and ("PhysicsAttachment" in text) == bool(whole)
    at = [numbers(part, "coords1") for part in text.split("def PhysicsAttachment")[1:]]
    assert np.allclose(sum(at, []), x[np.array(sum(held, []), int)].ravel())

def test_a_mesh_has_its_clamp_across_held_edges(tmp_path):
    export = clothbench.export("trapezoid", 7, 7, tmp_path / "out")
    text = (tmp_path / "out" / "scene.usda").read_text()
    corners = np.array(numbers(text, "faceVertexIndices"), int).reshape(-1, 3)
    sides = np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(export.beside) > 3 and len(corners) == len(export.triangles) + len(export.beside)
    assert len(np.unique(sides, axis=0)) == len(sides)
    a, b, c = (export.x[corners[:, k], :2] for k in range(3))
    assert np.cross(b - a, c - a).min() > 0

def test_what_turns_moves_as_its_path(tmp_path):
    export = clothbench.export("twist", 3, 3, tmp_path / "out")
    text = usd.text_of(tmp_path / "out")
    turned = {p for p in export.path.values() if len(export.paths[p]) > 100}
    assert len(turned) == 3 and text.count("def Xform \"Path") == len(set(export.path.values()))
    assert all(f'"HeldPath{p}"' in text for p in turned)

def test_without_numpy(tmp_path):
    bare = tmp_path / "bare"
    bare.write_text('#!/bin/sh\nshift 2\nexec /usr/bin/python3 -ISB "$@"\n')
    bare.chmod(0o755)
    for python in bare, "/nowhere":
        out = tmp_path / os.path.basename(python)
        out = out.with_suffix(".out")
        done = subprocess.run([clothbench.program.find(), "export", "edge_drop", "--points", "3,3", "--format", "ply",
                               "--out", out], capture_output=True, text=True, check=False,
                              env=os.environ | {"CLOTHBENCH_PYTHON": str(python)})
        assert done.returncode == 0 and re.search("no scene.usda: .*python3-numpy", done.stderr), done.stderr
        assert (out / "rest.ply").exists() and not {"scene.usda", "rest.obj", "rest.csv"} & set(os.listdir(out))
