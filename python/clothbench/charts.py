"""Draws charts (SVG) and sheets (PNG) as bytes: the only engine for both.

A model has one colour everywhere, a line its label at its end, a truth's error bar is a band, ticks
are round, and nothing is cut. Infinite numbers and those that do not exist are left out.
"""
import collections
import io
import math
import textwrap

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from . import bodies

COLOURS = {"iga": "#2a84c4", "hex": "#555555", "shell": "#d98c00", "mass_spring": "#0a4f8f",
           "triangles": "#d55e00", "position_based": "#00875f", "projective_dynamics": "#b8529a",
           "vbd": "#7a6a00"}
OTHERS = ["#2a84c4", "#d55e00", "#00875f", "#b8529a", "#0a4f8f", "#d98c00", "#7a6a00", "#555555",
          "#9467bd", "#8c564b", "#17becf", "#e377c2"]
WORDS = {"feasible": "#2a8a4a", "died": "#1b1b1b", "refused": "#c9c9c9", "degraded": "#e69f00"}
SIZE, INK, SOFT, PALE = 10, "#1b1f24", "#5c6670", "#e4e8ec"
LINES_MOST = 10  # in a panel; more of them stand in the next one

plt.rcParams.update({
    "font.size": SIZE, "font.family": "DejaVu Sans", "svg.fonttype": "none", "svg.hashsalt": "c",
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": SOFT,
    "axes.labelcolor": INK, "xtick.color": SOFT, "ytick.color": SOFT, "text.color": INK})

def colour_of(label, n=0):
    """The colour of a model by its name, of a word for how a case ended, else the n-th."""
    return COLOURS.get(label) or WORDS.get(label) or OTHERS[n % len(OTHERS)]

def saved(figure, description=None):
    data = io.BytesIO()
    figure.savefig(data, format="svg", metadata={"Date": None, "Creator": None, "Description": description})
    plt.close(figure)
    return data.getvalue()

# --- axes ------------------------------------------------------------------------------------

def words_of(value):
    """A tick's: 0.001, 20, 5e5."""
    if value == 0 or 1e-3 <= abs(value) < 1e5:
        return f"{value:g}"
    digits, exponent = f"{value:.3e}".split("e")
    return f"{float(digits):g}e{int(exponent)}"

def is_log(values):
    return min(values) > 0 and max(values) / min(values) > 20

def ticks(values, log):
    """(low, high, round ticks) so that all values lie inside, the ends being round numbers."""
    low, high = min(values), max(values)
    if log:
        marks = [s * 10.0 ** n for n in range(math.floor(math.log10(low)) - 1,
                                              math.ceil(math.log10(high)) + 2) for s in (1, 2, 5)]
        low = max(m for m in marks if m <= low * (1 + 1e-9))
        high = min(m for m in marks if m >= high * (1 - 1e-9))
        marks = [m for m in marks if low <= m <= high]
        decades = [m for m in marks if f"{m:e}"[0] == "1"]
        return low, high, marks if len(decades) < 3 else decades[::-(-len(decades) // 7)]
    span = high - low or abs(high) or 1
    step = 10.0 ** math.floor(math.log10(span))
    step *= next((s for s in (0.1, 0.2, 0.25, 0.5, 1, 2) if span / (step * s) <= 6), 2)
    first = math.floor(low / step + 1e-9)
    last = max(math.ceil(high / step - 1e-9), first + 1)
    return first * step, last * step, [n * step for n in range(first, last + 1)]

def set_marks(axis, marks, words, low, high):
    """Gives an axis its ends and its ticks, whose words come of their places."""
    axis.set_major_locator(FixedLocator(marks))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: words(value)))
    axis.axes.set(**{f"{axis.axis_name}lim": (low, high)})

def set_axis(axis, values, log, tight=False):
    """Scales an axis so that all values lie inside, or at its ends."""
    low, high, marks = ticks(values, log)
    if tight:
        low, high = min(values), max(values)
        marks = [m for m in marks if low <= m <= high]
    axis.axes.set(**{f"{axis.axis_name}scale": "log" if log else "linear"})
    margin = (high / low) ** 0.02 if log else 0.02 * (high - low)
    set_marks(axis, marks, words_of, *((low / margin, high * margin) if log else (low - margin, high + margin)))

def place_labels(axes, ends):
    """Writes labels [(x, y, label, colour)] beside the ends of lines, one below the other."""
    room, share = SIZE * 1.15 / 72 / PLACE[3], (axes.transData - axes.transAxes).transform
    wrapped = sorted((*share((x, y))[::-1], "\n".join(textwrap.wrap(label, 24)[:3]), colour)
                     for x, y, label, colour in ends)
    heights = [room * (label.count("\n") + 1.15) for _, _, label, _ in wrapped]
    at, below = [], -0.1
    for (y, *_), height in zip(wrapped, heights):  # as near to the line's end as those below let
        at.append(max(y, below + height / 2))
        below = at[-1] + height / 2
    above = max(1.05, sum(heights) - 0.1)
    for n in range(len(at) - 1, -1, -1):
        at[n] = min(at[n], above - heights[n] / 2)
        above = at[n] - heights[n] / 2
    for (y, x, label, colour), place in zip(wrapped, at):
        axes.plot([x + 0.015, 1.035], [y, place], transform=axes.transAxes, clip_on=False, lw=0.6,
                  color=colour, alpha=0.5)
        axes.text(1.045, place, label, transform=axes.transAxes, color=colour, va="center", fontsize=SIZE - 0.5)

SHAPE, PLACE = (6.1, 3.45), (0.84, 0.5, 3.3, 2.5)  # of a chart, and its axes: left, low, width, height [in]

def new_axes(title, x, y):
    figure = plt.figure(figsize=SHAPE)
    axes = figure.add_axes([PLACE[k] / SHAPE[k % 2] for k in range(4)])
    axes.set(xlabel=x, ylabel=y)
    axes.set_title("\n".join(textwrap.wrap(title, 66)[:2]), fontsize=SIZE, loc="left", color=SOFT, x=-0.15)
    axes.grid(color=PALE, lw=0.8)
    axes.set_axisbelow(True)
    return figure, axes

# --- charts ----------------------------------------------------------------------------------

def is_shown(value):
    """Whether axes can have a number: neither infinite, nor so large or small that their ends would be."""
    return value == 0 or 1e-250 < abs(value) < 1e250

def finite(points):
    return [(x, y) for x, y in points if is_shown(x) and is_shown(y)]

def lines(title, x, y, drawn, bar=None, others=(), real_time=None, description=None):
    """A chart of lines [(label, colour or None, [(x, y)])]; `bar` is the height of the truth's band,
    `others` are open points of the same form. None: there is nothing to draw."""
    drawn = [(label, colour or colour_of(label, n), sorted(finite(points)))
             for n, (label, colour, points) in enumerate(line for line in drawn if finite(line[2]))]
    if not drawn:
        return None
    xs, ys = zip(*(p for _, _, points in drawn + list(others) for p in finite(points)))
    bar = bar if bar and is_shown(bar) and bar > min(ys) / 30 else None  # far below all, it would flatten the lines
    ys += (bar,) if bar else ()
    figure, axes = new_axes(title, x, y)
    set_axis(axes.xaxis, xs, is_log(xs))
    set_axis(axes.yaxis, ys, is_log(ys))
    if bar:
        axes.axhspan(axes.get_ylim()[0], bar, color="#c9cfd6", alpha=0.55, lw=0)
        tall = (axes.transData - axes.transAxes).transform((xs[0], bar))[1] > 0.1
        axes.text(0.02, bar, "truth’s error bar", transform=axes.get_yaxis_transform(),
                  va="top" if tall else "bottom", fontsize=SIZE - 1.5, color=SOFT)
    if real_time and axes.get_xlim()[0] < real_time < axes.get_xlim()[1]:
        axes.axvline(real_time, color=SOFT, lw=0.9, ls=(0, (5, 3)))
        axes.text(real_time, 0.99, "real time ", transform=axes.get_xaxis_transform(), ha="right",
                  va="top", fontsize=SIZE - 1.5, color=SOFT)
    for _, colour, points in others:
        axes.plot(*zip(*finite(points)), "o", ms=2.5, mfc="none", mec=colour, alpha=0.35)
    for _, colour, points in drawn:
        axes.plot(*zip(*points), "o-", ms=3.5, lw=1.6, color=colour)
    place_labels(axes, [(*points[-1], label, colour) for label, colour, points in drawn if label])
    return saved(figure, description)

def edges(places, log):
    """Half-way lines between places of cells, and beyond the ends as far as the next line."""
    at = np.log(places) if log else np.array(places, float)
    middle = (at[1:] + at[:-1]) / 2
    ends = np.concatenate([[2 * at[0] - middle[0]], middle, [2 * at[-1] - middle[-1]]]) \
        if len(at) > 1 else np.array([at[0] - 0.5, at[0] + 0.5])
    return np.exp(ends) if log else ends

def coded(values):
    """([number], words or None): words stand at 0, 1, ..."""
    words = list(dict.fromkeys(values))
    try:
        return [float(v) for v in values], None
    except ValueError:
        return [float(words.index(v)) for v in values], words

def classes(title, x, y, cases):
    """A map of cases [(x, y, label)], as words; cells where they lie on a grid. None: there is nothing
    to draw."""
    cases = [c for c in cases if all(c[:2])]
    at, words = zip(*(coded([c[k] for c in cases]) for k in (0, 1)))
    shown = [n for n in range(len(cases)) if is_shown(at[0][n]) and is_shown(at[1][n])]
    if not shown:
        return None
    cases, at = [cases[n] for n in shown], [[values[n] for n in shown] for values in at]
    places = [sorted(set(values)) for values in at]
    log = [not words[k] and is_log(places[k]) for k in (0, 1)]
    grid = len(cases) == len(places[0]) * len(places[1]) or max(map(len, places)) <= 24
    figure, axes = new_axes(title, x, y)
    limits = [edges(p, g) for p, g in zip(places, log)]
    count = collections.Counter(c[2] for c in cases)
    colours = {label: colour_of(label, n) for n, label in enumerate(sorted(count))}
    for k, axis in enumerate((axes.xaxis, axes.yaxis)):
        if words[k]:
            set_marks(axis, places[k], lambda n, of=words[k]: of[int(n)], -0.5, len(words[k]) - 0.5)
        else:
            set_axis(axis, limits[k] if grid else places[k], log[k], grid)
    if grid:
        sides = [dict(zip(places[k], zip(limits[k], limits[k][1:]))) for k in (0, 1)]
        boxes = [[(sides[0][cx][i], sides[1][cy][j]) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
                 for cx, cy in zip(*at)]
        axes.add_collection(PolyCollection(boxes, facecolors=[colours[c[2]] for c in cases],
                                           edgecolors="white", linewidths=0.8))
    else:
        axes.scatter(*at, c=[colours[c[2]] for c in cases], s=22, marker="s")
    for n, (label, uses) in enumerate(sorted(count.items(), key=lambda c: -c[1])):
        axes.text(1.04, 1 - 0.085 * n, "■ " + textwrap.shorten(f"{label}: {uses}", 28),
                  transform=axes.transAxes, color=colours[label], va="top", fontsize=SIZE - 1)
    return saved(figure)

# --- sheets ----------------------------------------------------------------------------------

TURN, TILT = 0.6, 0.35  # about z, then towards the eye [rad]
WIDTH, HEIGHT = 280, 240  # of a picture [pixels]
LIGHT = np.array([0.35, -0.5, 0.79])
BODY, FLOOR = "#a8a196", np.array([[226, 229, 232], [236, 238, 240]])

def seen(xyz):
    """Points as (across, up, depth) of the picture's plane."""
    x, y, z = np.moveaxis(xyz, -1, 0)
    along, away = x * np.cos(TURN) - y * np.sin(TURN), x * np.sin(TURN) + y * np.cos(TURN)
    return np.stack([along, z * np.cos(TILT) + away * np.sin(TILT), z * np.sin(TILT) - away * np.cos(TILT)], -1)

def shaded(corners, colour):
    """A colour each, by how much light falls on it; the two sides of a sheet look alike."""
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    size = np.linalg.norm(normal, axis=1, keepdims=True)
    light = np.abs((normal / np.where(size > 0, size, 1)) @ LIGHT)[:, None]
    base = 255 * np.array(matplotlib.colors.to_rgb(colour))
    return np.clip(base * (0.62 + 0.45 * light) + 85 * light ** 3, 0, 255).astype(int)

def sheets(fields):
    """A picture each of fields [(colour, faces [n, 4, 3], (planes, bodies))], in one view and
    scale; the sheets are whole in it, and bodies as far as they are near. NaN is beside a sheet."""
    from PIL import Image, ImageDraw
    fields = [(colour, faces[np.isfinite(faces).all((1, 2))] if not np.isinf(faces).any() else faces[:0], around)
              for colour, faces, around in fields]
    flat = [seen(faces)[..., :2].reshape(-1, 2) for _, faces, _ in fields if len(faces)]
    if not flat:
        return []
    low, high = np.concatenate(flat).min(0), np.concatenate(flat).max(0)
    near = 0.35 * (high - low).max()
    solid = np.concatenate([seen(solids)[..., :2].reshape(-1, 2) for *_, (_, solids) in fields])
    if len(solid):
        low, high = (np.minimum(low, np.maximum(solid.min(0), low - near)),
                     np.maximum(high, np.minimum(solid.max(0), high + near)))
    unit = max((high - low)[0] / (WIDTH - 12), (high - low)[1] / (HEIGHT - 12), 1e-9)
    size = [int(n) for n in np.ceil((high - low) / unit) + 12]
    made = []
    for colour, sheet, (planes, solids) in fields:
        corners = np.concatenate([planes, solids, sheet])
        plane = seen(corners)
        at = 2 * ((plane[:, :, :2] - low) / unit + 6)  # twice as fine, for smooth edges
        at[:, :, 1] = 2 * size[1] - at[:, :, 1]
        paint = np.concatenate([FLOOR[(np.arange(len(planes)) % 2)], shaded(solids, BODY), shaded(sheet, colour)])
        places, paint = at.reshape(-1, 8).tolist(), [tuple(c) for c in paint.tolist()]
        picture = Image.new("RGB", (2 * size[0], 2 * size[1]), "white")
        draw = ImageDraw.Draw(picture)
        low_, far, first = plane[:, :, 2].min(1), plane[:, :, 2].mean(1), len(planes) + len(solids)
        far[:first] = low_[:first] - (far - low_)[first:].max(initial=0)  # what touches a body is before it
        far[:len(planes)] -= 1e9  # under all else
        for n in far.argsort():
            draw.polygon(places[n], fill=paint[n], outline=paint[n])
        data = io.BytesIO()
        picture.reduce(2).quantize(128, Image.FASTOCTREE).save(data, "PNG")
        made.append(data.getvalue())
    return made

def points_of(runs):
    """All points [n, 3] of the frames that have no others; one at 0 where there are none."""
    points = [run.xyz[run.is_good()].reshape(-1, 3) for run in runs if run.is_good().any()]
    return np.concatenate([p[np.isfinite(p).all(1)] for p in points] or [np.zeros((1, 3))])

def pictures_of(runs):
    """Those of the frames of runs of a scene, one after the other."""
    flat = points_of(runs)
    return sheets([(colour_of(run.model), run.faces(n)[:None if good else 0],
                    bodies.surfaces(run.bodies, run.time[n], flat.min(0), flat.max(0)))
                   for run in runs for n, good in enumerate(run.is_good())])

def row_of(pictures, words):
    """One picture of several, side by side, with words below each."""
    from PIL import Image, ImageDraw
    opened = [Image.open(io.BytesIO(p)).convert("RGB") for p in pictures]
    width, height = opened[0].size
    row = Image.new("RGB", (width * len(opened), height + 20), "white")
    for n, (image, text) in enumerate(zip(opened, words)):
        row.paste(image, (n * width, 0))
        ImageDraw.Draw(row).text((n * width + width // 2 - 15, height + 4), text, fill=INK)
    data = io.BytesIO()
    row.save(data, "PNG")
    return data.getvalue()
