"""Reads what commands left in a folder: tables (CSV), and runs and truths (HDF5).

Whoever made a file, reading it does no more than that: only regular files are opened, and no
links; of HDF5 only numbers that stand in the file itself, in pieces of about a frame; what is no
finite number is left out of charts.
"""
import contextlib
import errno
import math
import os
import pathlib
import re
import stat
import zlib
from dataclasses import dataclass, field

import numpy

from . import bodies

CSV_MOST, H5_MOST, PIECE_MOST = 64 << 20, 4 << 30, 1 << 20  # bytes, bytes, numbers
SEAL = "clothbench result file, sealed: "

class Bad(ValueError):
    """A file that cannot be read, with a sentence that names it."""

def opened(path, most):
    """The regular file at a path, for reading bytes."""
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError as error:
        raise Bad(f"{path}: is a symbolic link, which is not followed" if error.errno == errno.ELOOP
                  else f"{path}: cannot be read: {os.strerror(error.errno)}") from None
    about = os.fstat(handle)
    if stat.S_ISREG(about.st_mode) and about.st_size <= most:
        return os.fdopen(handle, "rb")
    os.close(handle)
    raise Bad(f"{path}: has more than {most >> 20} MB" if stat.S_ISREG(about.st_mode) else
              f"{path}: is no regular file")

def write(path, data):
    """The whole file or none; an earlier one stays until then."""
    path = pathlib.Path(path)
    aside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        aside.write_bytes(data if isinstance(data, bytes) else data.encode("utf-8", "replace"))
        os.replace(aside, path)
    except OSError as error:
        aside.unlink(missing_ok=True)
        raise Bad(f"{path}: cannot be written: {error.strerror}") from None

# --- tables ----------------------------------------------------------------------------------

@dataclass
class Table:
    """Rows {key: words} below a caption; `made` is the line of the command, and notes stand below."""
    caption: str
    keys: list
    rows: list
    made: str = ""
    notes: list = field(default_factory=list)

    def has(self, *keys):
        return all(key in self.keys for key in keys)

def number(words):
    """A cell's number; NaN where there is none, or it is infinite."""
    try:
        value = float(words)
    except (TypeError, ValueError):
        return math.nan
    return value if math.isfinite(value) else math.nan

def grouped(rows, *keys):
    """{cell, or cells, of these columns: rows}, in their order."""
    found = {}
    for r in rows:
        found.setdefault(tuple(r[k] for k in keys) if keys[1:] else r[keys[0]], []).append(r)
    return found

def where(rows, **cells):
    return [r for r in rows if cells.items() <= r.items()]

def best(rows):
    """Of each model the contestant that is first to 1 %, else the nearest: [(seconds or inf, lowest
    error, title, model, contestant)], best first."""
    models = {}
    for (title, model, who), runs in grouped(rows, "title", "model", "contestant").items():
        runs = [(number(r["worst_rmse_over_length"]), number(r["seconds"])) for r in runs]
        runs = [(error, seconds) for error, seconds in runs if seconds > 0 and error > 0]
        near = min((seconds for error, seconds in runs if error <= 0.01), default=math.inf)
        models.setdefault(model, []).extend([(near, min(runs)[0], title, model, who)] if runs else [])
    return sorted(min(of) for of in models.values() if of)

CELL = re.compile(r'"((?:[^"]|"")*)"|([^",\n]*)')

def cells_of(path, text, at, line):
    """The cells of the row that begins at text[at], and where and in which line the next begins."""
    cells = []
    while True:
        found = CELL.match(text, at)
        cells.append(found[2] if found[1] is None else found[1].replace('""', '"'))
        line += cells[-1].count("\n")
        at = found.end()
        if at == len(text) or text[at] == "\n":
            return cells, at + 1, line + 1
        if text[at] != ",":
            raise Bad(f"{path}:{line}: a quote has no end, or words behind it")
        at += 1

def tables(path):
    """The tables of a CSV file, one below the other. Lines `# ...` above the keys are a caption,
    those below the rows are notes; an empty line ends a table."""
    with opened(path, CSV_MOST) as file:
        data = file.read()
    if b"\0" in data:
        raise Bad(f"{path}: has a byte 0")
    text = data.decode("utf-8", "replace").replace("\r\n", "\n")
    found, caption, made, table, at, line = [], [], "", None, 0, 1
    while at < len(text):
        if text[at] in "\n#":
            end = text.find("\n", at) % (len(text) + 1)
            words = text[at + 1:end].strip()
            if text[at] == "\n":
                table = None
            elif table:
                table.notes.append(words)
            elif not found and not caption and not made and " | " in words:
                made = words
            else:
                caption.append(words)
            at, line = end + 1, line + 1
            continue
        first = line
        cells, at, line = cells_of(path, text, at, line)
        if table is None:
            table, caption = Table(" ".join(caption), cells, [], made), []
            found.append(table)
        elif len(cells) != len(table.keys):
            raise Bad(f"{path}:{first}: {len(cells)} cells below {len(table.keys)} keys")
        else:
            table.rows.append({key: "" if cell == "nan" else cell  # of older results
                               for key, cell in zip(table.keys, cells)})
    if not found:
        raise Bad(f"{path}: has no table in it")
    return found

# --- runs and truths -------------------------------------------------------------------------

@dataclass
class Run:
    """Positions xyz[frame, sheet, v, u, component] [m] of mid-surfaces at time[frame] [s]; of a
    truth its error bar [m] at these times. A sheet that is no rectangle has, besides, points
    surface[frame, point, component] of triangle[triangle, corner]."""
    name: str
    scene: str
    model: str
    title: str
    length: float
    time: list
    xyz: object
    bar: list
    note: str
    bodies: list
    facts: dict
    surface: object = None
    triangle: object = None

    def side_by_side(self):
        """Positions [frame, v, u, component]: all sheets as one, beside each other along u."""
        return self.xyz.swapaxes(1, 2).reshape(len(self.xyz), self.xyz.shape[2], -1, 3)

    def faces(self, frame):
        """The corners [face, corner, component] of what is drawn of a frame: four, or three and the last again."""
        if self.surface is None:
            return numpy.concatenate([bodies.quads(one) for one in self.xyz[frame]])
        return self.surface[frame][self.triangle[:, [0, 1, 2, 2]]]

    def is_good(self):
        """Of each frame, whether all of its numbers are finite, but for places beside a sheet that is no
        rectangle: these have none in the first frame either."""
        return (numpy.isfinite(self.xyz) | numpy.isnan(self.xyz[:1])).all((1, 2, 3, 4)) & \
            numpy.isfinite(self.xyz).any((1, 2, 3, 4))

def checked_seal(path, file):
    """Refuses a file that is no longer what its first line says."""
    file.seek(0)
    head, crc, size = file.read(512), 0, 0
    if not head.startswith(SEAL.encode()):
        raise Bad(f"{path}: is not a result file of this program (its first line has no seal)")
    while part := file.read(1 << 20):
        crc, size = zlib.crc32(part, crc), size + len(part)
    if head != f"{SEAL}{size} bytes, crc32 {crc:08x}\n".encode().ljust(512, b"\0"):
        raise Bad(f"{path}: is damaged: it is no longer what its first line says it was")
    file.seek(0)

def numbers(path, file, name):
    """A dataset of numbers that stand in the file itself; None: there is none of that name."""
    import h5py
    place = file
    for part in name.split("/"):
        link = place.get(part, getlink=True) if isinstance(place, h5py.Group) else False
        if link is None:
            return None
        place = place[part] if isinstance(link, h5py.HardLink) else None
    if isinstance(place, h5py.Dataset) and 0 in place.shape:
        return None
    if (not isinstance(place, h5py.Dataset) or place.dtype.kind not in "fiu" or place.is_virtual or
            place.external or not 0 < len(place.shape) <= 8 or not place.id.get_storage_size() or
            place.chunks and math.prod(place.chunks) > max(math.prod(place.shape[1:]), PIECE_MOST)):
        raise Bad(f"{path}: its {name} are no numbers that stand in the file itself")
    return place

def run(path, most=12, times=None, step=4):
    """A run or truth, read at `times`, or at most `most` of its frames, at every `step`-th point;
    None: it has no positions."""
    import h5py
    path = pathlib.Path(path)
    with opened(path, H5_MOST) as raw:
        checked_seal(path, raw)
        try:
            with h5py.File(raw, "r") as file:
                return _run(path, file, most, times, step)
        except (OSError, KeyError, ValueError, RuntimeError, TypeError) as error:
            raise error if isinstance(error, Bad) else Bad(f"{path}: cannot be read: {error}") from None

def is_quick(folder):
    """Whether one of the first runs of a folder says that it is of --quick: of less than its name says."""
    import h5py
    for path in sorted(folder.glob("*.h5"))[:20]:
        with contextlib.suppress(OSError, RuntimeError, ValueError), opened(path, H5_MOST) as raw:
            with h5py.File(raw, "r") as file:
                if "quick" in file.attrs:
                    return True
    return False

def _run(path, file, most, times, step):
    xyz, when = numbers(path, file, "xyz"), numbers(path, file, "xyz_time")
    bar = numbers(path, file, "metrics/error")
    if xyz is None or when is None or not len(when):
        return None
    if xyz.ndim != 5 or xyz.shape[4] != 3 or xyz.shape[0] != len(when):
        raise Bad(f"{path}: its xyz are {xyz.shape} for {len(when)} times")
    time = when[:]
    frames = sorted({int(numpy.abs(time - t).argmin()) for t in times}) if times else \
        range(0, len(time), -(-len(time) // most))

    def text(key):
        value = file.attrs.get(key, "")
        return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)

    listed = re.search(r"^sheets:\n((?: .*\n)*)", text("scene"), re.M)
    sheets = max(1, len(re.findall(r"^ +- ", listed[1] if listed else "", re.M)))
    width = xyz.shape[3] // sheets
    if numpy.isnan(xyz[0]).any():  # an outline needs all points
        step = 1
    middle = numpy.array([xyz[n, :, ::step].mean(0) for n in frames])
    middle = numpy.stack([middle[:, :, s * width:(s + 1) * width:step] for s in range(sheets)], 1)
    triangle, surface = numbers(path, file, "surface/triangle"), None
    if triangle is not None:
        surface = [numbers(path, file, f"surface/{n}") for n in frames]
        count = len(surface[0]) if surface[0] is not None else 0
        if (triangle.ndim != 2 or triangle.shape[1] != 3 or triangle.dtype.kind not in "iu" or
                any(s is None or s.shape != (count, 3) for s in surface)):
            raise Bad(f"{path}: its surface is no triangles with points at each time")
        triangle, surface = triangle[:].astype(int), numpy.stack([s[:] for s in surface])
        if triangle.min() < 0 or triangle.max() >= count:
            raise Bad(f"{path}: its triangles name points that its surface has not")
    triangles = {n: found[:].reshape(-1, 3, 3) for n in range(64)
                 if (found := numbers(path, file, f"obstacle_{n}")) is not None}
    return Run(path.stem, text("scene_name"), text("model"), text("model_title"),
               float(file.attrs.get("length", 1)), [float(time[n]) for n in frames], middle,
               [] if bar is None else [float(bar[n]) for n in frames if n < len(bar)], text("note"),
               bodies.of_scene(text("scene"), triangles), facts(text("discretization"), text("scene")),
               surface, triangle)

def facts(discretization, scene):
    """{key: words} of what a run was made with; settings stand below the scene, and the last one holds."""
    found = dict(re.findall(r"^discretization\.(\w+)=(.*)$", discretization, re.M))
    for key in "young", "poisson", "density", "thickness", "step", "value":
        said = re.findall(rf"\b{key}(?:: *|=)([-+.\de]+)", scene)
        found |= {key: said[-1]} if said else {}
    kind = re.findall(r"\bdamping(?:: *|=)\{kind: (\w+)", scene)
    return found | ({"value": "0"} if kind[-1:] == ["none"] else {})

def shared(kind, tree):
    """A folder that comes with the program: the user's, the installed or the source tree's."""
    here = pathlib.Path(__file__).resolve().parent
    if named := os.environ.get(f"CLOTHBENCH_{kind.upper()}"):
        return pathlib.Path(named)
    installed = (above / "share" / "clothbench" / kind for above in here.parents[2:4])
    return next((folder for folder in installed if folder.is_dir()), here.parents[1] / tree)
