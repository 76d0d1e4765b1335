"""Diagnoses of `score`: frames made to have one flaw get its sentence with its number and no other flaw's;
sound frames get none. The flaws of physics are runs of a model; others are made of its sound run, of closed
forms, or of the truths, which are sound as they are and, on a coarse net, at its floor. Every verdict is the
same however far apart frames are, and where some are left out."""
import functools
import json
import math
import os
import pathlib
import tempfile
from dataclasses import dataclass

import numpy as np
import pytest

import clothbench
from clothbench import results

STEP, FRAMES = 0.005, 101  # of the sound run [s]: every 5 ms to 0.5 s
FEW, SIDE = 12, 34  # every ninth and every third point of the material grid, along u and v
INTERVALS = [2, 4, 8, 10, 20, 2]  # of frames, in steps; of the last some are left out
HINGE = "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"
os.environ["CLOTHBENCH_PYTHON"] = "/nowhere"  # nobody draws what is exported
BLUNT = str(pathlib.Path(__file__).resolve().parents[1] / "truths")

@dataclass
class Want:
    """The finding that frames must get, its number and words in its sentence; None: nothing, "sound": no flaw at
    all. Another flaw that is to be told, too."""
    kind: str
    value: float = 0
    within: float = 0
    words: str = ""
    also: str = ""

def check(tmp_path, scene, t, xyz, want, *words):
    """Scores frames xyz[frame, vertex, 3] on a square net."""
    side = math.isqrt(xyz.shape[1])
    u, v = np.meshgrid(*[np.linspace(0, 1, side)] * 2)
    clothbench.frames.write(tmp_path / "frames.npz", t, np.stack([u, v], -1).reshape(-1, 2), xyz)
    check_file(scene, tmp_path / "frames.npz", want, *words)

def check_file(scene, path, want, *words):
    sheet, = json.loads(f"[{clothbench.run('score', scene, path, '--format', 'json', *words)}]")
    sheet = sheet[0] if isinstance(sheet, list) else sheet
    found = {d["kind"]: d for d in sheet["diagnosis"]}
    assert not found.keys() - {"floor", "sound", want.kind, want.also}, found
    if want.kind is None:
        assert not found
        return
    assert abs(found[want.kind]["value"] - want.value) <= want.within and want.words in found[want.kind]["text"], found
    assert not want.also or want.also in found

def left_out(n, k):
    """Whether the k-th frame is, of the n-th interval."""
    return n == len(INTERVALS) - 1 and k * 7 % 5 > 1

def check_intervals(tmp_path, x, want, *words):
    """Checks frames of edge_drop every step, at each interval."""
    for n, every in enumerate(INTERVALS):
        kept = [k for k in range(-(-len(x) // every)) if not k or not left_out(n, k)]
        check(tmp_path, "edge_drop", [k * every * STEP for k in kept], x[[k * every for k in kept]], want, *words)

# --- motions -------------------------------------------------------------------------------------

def run_of(folder, *settings):
    """The run of edge_drop to 0.5 s, xyz[frame, vertex, 3] on SIDE x SIDE points."""
    words = ["discretization.points=[31,31]", "damping={kind: none}", "time.end=0.5", *settings]
    clothbench.run("run", "edge_drop", "--model", "triangles_explicit", "--quiet", "--every", 1, "--out",
                   folder / "run.h5", *(w for s in words for w in ("--set", s)))
    run = results.run(folder / "run.h5", most=1 << 20, step=3)
    assert len(run.time) == FRAMES
    return run.xyz[:, 0].reshape(FRAMES, -1, 3).astype(float)

@pytest.fixture(scope="module")
def hinged(tmp_path_factory):
    return run_of(tmp_path_factory.mktemp("hinged"), HINGE)

@pytest.fixture(scope="module")
def sound(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sound")
    made = run_of(folder)
    check_file("edge_drop", folder / "run.h5", Want("sound", 0, 0.01))
    return made

@functools.lru_cache
def known(scene, side):
    """(rest[vertex, 3], times, xyz[time, vertex, 3]) of a truth."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write(clothbench.run("truth", scene, "--stored", "--points", f"{side},{side}"))
        file.flush()
        truth = clothbench.truth.read(file.name)
    return clothbench.export(scene, side, side).x[:side * side], truth.t, truth.xyz

def between(scene, side, t):
    """The truth at a time, by the cubic through four."""
    rest, times, xyz = known(scene, side)
    times, xyz = np.append(0, times), np.concatenate([rest[None], xyz])
    first = int(np.clip(np.searchsorted(times, t) - 2, 0, len(times) - 4))
    near = times[first:first + 4]
    return sum(xyz[first + a] * math.prod((t - s) / (near[a] - s) for b, s in enumerate(near) if a != b)
               for a in range(4))

def bilinear(x, side):
    """x[vertex, 3] of a square net, on side x side points."""
    n = math.isqrt(len(x))
    at = np.linspace(0, n - 1, side)
    cell = np.minimum(at.astype(int), n - 2)
    part = (at - cell)[:, None]
    for _ in range(2):  # along one direction, then along the other
        x = x.reshape(n, -1, 3)
        x = ((1 - part) * x[cell].reshape(side, -1) + part * x[cell + 1].reshape(side, -1)).reshape(side, -1, 3)
        x = x.transpose(1, 0, 2)
    return x.reshape(-1, 3)

@pytest.mark.parametrize("model, points, linear", [("triangles_explicit", 21, True), ("shell", 10, False)])
def test_floor_of_result(tmp_path, model, points, linear):
    """A result file has 100x100 places, whose floor is that of its net's points, between which it is linear;
    a spline, which is not, has none."""
    clothbench.run("run", "edge_drop", "--model", model, "--quiet", "--every", 1, "--out", tmp_path / "run.h5",
                   "--set", f"discretization.points=[{points},{points}]", "--set", "time.end=0.1",
                   "--set", "damping={kind: none}")
    sheet = json.loads(clothbench.run("score", "edge_drop", tmp_path / "run.h5", "--format", "json"))
    rest, times, xyz = known("edge_drop", SIDE)
    k, = np.flatnonzero(np.isclose(times, 0.1))
    off = bilinear(known("edge_drop", points)[2][k], SIDE) - xyz[k]
    want = math.sqrt((off * off).sum() / len(off)) / np.ptp(rest[:, 0]) if linear else 0
    assert sheet["rows"][0]["floor"] == pytest.approx(want, rel=0.05)  # means over a ninth of the places
    assert not linear or want > 2e-4

# --- flaws of physics ----------------------------------------------------------------------------

def layer(young, thick, density):
    return f"material.young={young}", f"sheet.thickness={thick}", f"material.density={density}"

@pytest.mark.parametrize("settings, want", [  # the net's own error is in the numbers, too
    (["gravity=[0,0,-9.5157]", "damping={kind: mass, value: 0.4}"],
     Want("gravity", 0.97, 0.005, "gravity x 0.97", also="damping")),
    (["gravity=[0,0,-10.0062]"], Want("gravity", 1.02, 0.003, "x 1.0")),
    (["gravity=[0,0,-9.32]"], Want("gravity", 0.95, 0.003, "1.03 times as slow?")),
    (["damping={kind: mass, value: 0.2}"], Want("damping", 0.2, 0.02)), ([HINGE], Want("hinge", 1, 0.1)),
    # D x 0.47, 3 and 5 with E h and rho h as they are; E h x 0.003 with D as it is
    (layer(145864.99, 8.0690209e-4, 0.72932496), Want("bending", 0.47, 0.06)),
    (layer(57735.027, 2.0386238e-3, 0.28867513), Want("bending", 3, 0.2)),
    (layer(44721.360, 2.6318520e-3, 0.22360680), Want("bending", 4, 0.2, "or beyond: the ladder")),
    (layer(16.431677, 2.1488985e-2, 0.027386128), Want("stretch", 0.02, 0.007, "too soft")),
])
def test_physics(tmp_path, settings, want):
    check_intervals(tmp_path, run_of(tmp_path, *settings), want)

# --- flaws of time and space ---------------------------------------------------------------------

def shown(x, pace=1, shift=0):
    """Frame k shows frame pace k + shift, or the nearest."""
    return x[np.clip((pace * np.arange(FRAMES)).astype(int) + shift, 0, FRAMES - 1)]

def first_step(x):
    """With g dt in place of g dt / 2."""
    made = x.copy()
    made[1:-1] += 0.25 * (x[2:] - x[:-2])
    return made

def let_go(x):
    """From rest, as in a vacuum."""
    return x[0] - 9.81 / 2 * (np.arange(FRAMES)[:, None, None] * STEP) ** 2 * [0, 0, 1]

def turned(x):
    return x.reshape(-1, SIDE, SIDE, 3)[:, :, ::-1].reshape(x.shape)

@pytest.mark.parametrize("make, until, want, words", [
    (lambda x, h: x, 60, Want("sound", 0, 0.01), []),
    (lambda x, h: first_step(x), 95, Want("first_order_step", STEP, 0.001), []),
    (lambda x, h: shown(x, 1, -2), 100, Want("lag", 2 * STEP, 0.001), []),
    (lambda x, h: shown(x, 1, 3), 95, Want("lag", -3 * STEP, 0.002), []),
    (lambda x, h: let_go(x), 100, Want("support", 9.81 / 8, 0.1), []),  # at .48 s every 40 ms
    (lambda x, h: h + [0, 0, 0.1], 100, Want("support", 0.1, 1e-3, also="hinge"), []),
    (lambda x, h: shown(x, 0.5), 100, Want("time", 0.5, 0.01), []),
    (lambda x, h: shown(x, 2), 50, Want("time", 2, 0.02), []),
    (lambda x, h: x + 0.4 * (h - x), 100, Want("clamp", 0.4, 0.05), []),  # the plain stiffness, 20 cells
    (lambda x, h: x[:, np.arange(SIDE ** 2) * 7 % SIDE ** 2], 100, Want("order", 0, 0.02), []),
    (lambda x, h: turned(x), 100, Want("order", 0, 0.01), []),
    (lambda x, h: x.reshape(-1, SIDE, SIDE, 3).swapaxes(1, 2).reshape(x.shape), 100, Want("order", 0, 0.01), []),
    (lambda x, h: shown(x, 0), 100, Want("still", 0, 1e-3), []),
    (lambda x, h: 1e3 * x, 100, Want("sound", 0, 0.01), ["--scale", "0.001"]),
    (lambda x, h: x[..., [0, 2, 1]] * [1, 1, -1], 100, Want("sound", 0, 0.01), ["--up", "y"]),
    (lambda x, h: x[..., [2, 1, 0]] * [1, 1, -1], 100, Want("axes", 0, 0.01), []),
    (lambda x, h: x[..., [2, 1, 0]] * [1, 1, -1], 100, Want("sound", 0, 0.01), ["--up", "x"]),
])
def test_frames_of_others(tmp_path, sound, hinged, make, until, want, words):
    check_intervals(tmp_path, make(sound, hinged)[:until + 1], want, *words)

def fallen(t, g=9.81, first_order=0, damping=0, late=0, above=0):
    """A height; the scene's is -g t^2 / 2."""
    t, c = np.maximum(t - late, 0), damping
    return above - (g * (c * t - 1 + np.exp(-c * t)) / (c * c) if c else 0.5 * g * t * (t + first_order))

@pytest.mark.parametrize("begin, fall, want", [
    (0, {}, Want("sound", 0, 1e-4, "Nothing wrong")),
    (0, {"first_order": 0.01}, Want("first_order_step", 0.01, 1e-4, "10 ms")),
    (5, {"first_order": 0.01}, Want("first_order_step", 0.01, 1e-4, "10 ms")),
    (0, {"g": 1.02 * 9.81}, Want("gravity", 1.02, 1e-4, "x 1.020:")),
    (0, {"damping": 0.3}, Want("damping", 0.3, 0.02, "Is damped like by 0.")),
    (0, {"damping": -0.3}, Want("damping", -0.3, 0.02, "Gains energy")),
    (0, {"above": 0.1}, Want("support", 0.1, 1e-3, "(0, 0, 0.1) m")),
    (0, {"g": 4 * 9.81}, Want("gravity", 4, 1e-3, "2 times as fast")),
    (0, {"late": 0.004}, Want("lag", 0.004, 1e-4, "Lags behind")),
    (0, {"late": -0.004}, Want("lag", -0.004, 2e-4, "Is ahead of")),
])
def test_falls(tmp_path, begin, fall, want):
    t = np.arange(begin, 51) / 100
    xyz = np.zeros((len(t), 16, 3)) + np.stack(np.meshgrid(*[np.arange(4) / 3] * 2) + [np.zeros((4, 4))], -1).reshape(-1, 3)
    xyz[:, :, 2] = fallen(t, **fall)[:, None]
    check(tmp_path, "free_fall", t, xyz, want)

# --- truths --------------------------------------------------------------------------------------

def check_truth(tmp_path, scene, side, want, way=1, wide=1, aside=(0, 0), heap=math.inf):
    """Of a truth, changed: a factor on its displacement, then one on its width, then a shift of all of it with the
    edge that is held; then what is beyond `heap` along y lies there."""
    rest, t, xyz = known(scene, side)
    asked = clothbench.export(scene, side, side).times
    judged = [n for n, at in enumerate(t) if not len(asked) or np.isclose(at, asked).any()]
    xyz = (rest + way * (xyz[judged] - rest)) * [1, wide, 1] + [*aside, 0]
    xyz[..., 1] = np.minimum(xyz[..., 1], heap)
    check(tmp_path, scene, t[judged], xyz, want)

@pytest.mark.parametrize("scene", ["edge_drop", "flag", "corners_patch", "sphere", "free_fall", "hanging",
                                   "rest_small", "rest_large"])
def test_truths(tmp_path, scene):
    check_truth(tmp_path, scene, 20, Want("sound", 0, 0.02))

def test_coarse_or_none(tmp_path):
    check_truth(tmp_path, "edge_drop", 7, Want("floor", 0.0157, 0.001))
    with pytest.raises(ValueError, match="corners_drop has no truth: support 0 holds a point"):
        check(tmp_path, "corners_drop", [0.1], np.zeros((1, 4, 3)), Want("sound"))

def test_paced(tmp_path):
    """All frames that are stored, as 24 a second that were taken for 25."""
    rest, t, xyz = known("edge_drop", FEW)
    check(tmp_path, "edge_drop", np.append(0, t) * 24 / 25, np.concatenate([rest[None], xyz]), Want("time", 25 / 24, 1e-3))

NARROWER = 0.996  # is no flaw: less than 1 %, but many times more of a length than the floor of the stretch along u

@pytest.mark.parametrize("scene, change, want", [
    ("hanging", {"way": 2}, Want("stretch", 0.005, 2e-4, "2 times as much")),
    ("hanging", {"way": 0.5}, Want("stretch", -0.0025, 2e-4, "too stiff")),
    ("hanging", {"way": 1.02}, Want("sound", 0, 1e-3)),
    ("hanging", {"way": 1.2, "wide": NARROWER}, Want("stretch", 0.001, 1e-4, "1.2 times")),
    ("hanging", {"wide": NARROWER}, Want(None)),
    ("hanging", {"way": 0.25, "wide": NARROWER}, Want("stretch", -0.00375, 1e-4, "0.25 ")),
    ("hanging", {"way": 0}, Want(None)), ("hanging", {"aside": (0.001, 0)}, Want(None)),
    ("rest_small", {"wide": 0.7}, Want("stretch", -0.3, 0.01, "rest shape")),
    ("rest_small", {"heap": 0.7}, Want("stretch", -0.3, 0.02, "crumpled")),
    ("flag", {"aside": (0, 0.012)}, Want("support", 0.012, 1e-5, "support 0 (")),
    ("navier", {"aside": (0.012, 0)}, Want("support", 0.012, 1e-5, "support 2 (")),  # its edges along v are free to
    ("flag", {"aside": (0, 0.006)}, Want("sound", 0.006, 1e-4, "bar of up to 4.4 %")),
])
def test_unfitted(tmp_path, monkeypatch, scene, change, want):
    """Where nothing is fitted: by the truth's own stretch, by the shape of what shrank, by the bar that hides it;
    beside a blunt truth, too."""
    monkeypatch.setenv("CLOTHBENCH_TRUTHS", BLUNT)
    known.cache_clear()
    check_truth(tmp_path, scene, 20, want, **change)
    known.cache_clear()

# --- the same verdict at every interval -----------------------------------------------------------

def turn(x, degrees, axes):
    """Turned in the plane of two axes."""
    a, made = math.radians(degrees), x.copy()
    i, j = axes
    made[..., i] = math.cos(a) * x[..., i] - math.sin(a) * x[..., j]
    made[..., j] = math.sin(a) * x[..., i] + math.cos(a) * x[..., j]
    return made

def exchanged(x):
    made, (a, b) = x.copy(), (FEW + 2, 7 * FEW + 4)  # .57 apart: (2, 6) / 11
    made[:, [a, b]] = x[:, [b, a]]
    return made

# Name: kind, number, more for each second between frames, tolerance beside a twentieth of that, and what is done
# to the frames; to their times: None, of which nothing is seen on a sheet at rest.
FLAWS = {
    "sound": ("sound", 0, 0, 0.01, None), "lost": ("lost_frame", 0.3, 0, 0.04, None),
    "doubled": ("doubled_frame", 0.3, 1, 0.04, None), "late": ("lag", 0, 1, 0, None),
    "exchanged": ("order", 0.57, 0, 0.01, exchanged),
    "turned": ("turned", 10, 0, 0.01, lambda x: turn(x, 10, (0, 1))),
    "tilted": ("turned", 7, 0, 0.01, lambda x: turn(x, 7, (1, 2))),
    "aside": ("support", 0.05, 0, 0.001, lambda x: x + [0, 0.05, 0]),
    "millimetres": ("units", 0.001, 0, 0, lambda x: 1000 * x), "up": ("axes", 0, 0, 0.02, lambda x: turn(x, 90, (1, 2))),
}

AXES = {"turned": "about (0, 0, 1)", "tilted": "about (1, 0, 0)"}

def course(scene, off, sound):
    """A motion every STEP on FEW x FEW points: a sound run of ours, a truth, or what comes to a truth at rest; `off`:
    far from it, as those that are too coarse are."""
    if scene == "edge_drop":
        return sound.reshape(FRAMES, SIDE, SIDE, 3)[:, ::3, ::3].reshape(FRAMES, -1, 3)
    rest, t, xyz = known(scene, FEW)
    if len(t) <= 2:
        return rest + (xyz[-1] - rest) * (1 - np.exp(-np.arange(341) / 10))[:, None, None]
    made = np.array([between(scene, FEW, k * STEP) for k in range(FRAMES)])
    made[..., 1] += off * 0.3 * (np.arange(FRAMES)[:, None] / (FRAMES - 1)) ** 2 * (np.arange(FEW ** 2) % FEW) / FEW
    return made

@pytest.mark.parametrize("name", FLAWS)
@pytest.mark.parametrize("scene, off", [("edge_drop", False), ("flag", False), ("rest_small", False), ("flag", True)])
def test_other_scenes(tmp_path, sound, scene, off, name):
    kind, value, more, within, spoil = FLAWS[name]
    x = course(scene, off, sound)
    rests = len(x) > FRAMES
    for n, every in enumerate(INTERVALS):
        # its way turns in less than the longest intervals, and a jump is of whole ones
        if off and (every > 4 or n == len(INTERVALS) - 1 or name not in ("lost", "doubled")):
            continue
        at, count, kept = 60 // every, -(-len(x) // every), []  # of 0.3 s, or one before it
        for k in range(count):
            shows = k + (name == "lost" and k >= at) - (name == "doubled" and k > at) - (name == "late" and k > 0)
            # of flaws of place the first is left out, too, where the truth is known behind it
            gone = left_out(n, k) if k else n == len(INTERVALS) - 1 and spoil and not rests
            if shows < count and not (gone and (k + 1) * every < len(x)):
                kept.append((k, shows))
        frames = x[[shows * every for _, shows in kept]]
        interval = every * STEP
        check(tmp_path, scene, [k * interval for k, _ in kept], spoil(frames) if spoil else frames,
              Want("sound", 0, 0.01) if rests and not spoil else
              Want(kind, value + more * interval, within + more * interval / 20, AXES.get(name, "")))

def test_astray(tmp_path, sound):
    """Vertices that are elsewhere in a first frame that is not of the sheet at rest may have moved so: only ones in
    each other's places are told."""
    x = course("edge_drop", False, sound)[2::2].copy()
    x[0, [FEW + 2, 7 * FEW + 4], 2] += 0.2
    check(tmp_path, "edge_drop", np.arange(2, FRAMES, 2) * STEP, x, Want("sound", 0, 0.01))
