"""clothbench.py - frames for `clothbench score`, and truths, from Python.

One file, to be copied anywhere; needs numpy, and h5py only for .h5 files.

    import numpy as np, clothbench
    clothbench.frames.write("mine.npz", t, uv, xyz)    # then: clothbench score edge_drop mine.npz
    truth = clothbench.truth.read("edge_drop")         # a scene, or a file NAME.h5 or NAME.csv
    truth.t, truth.bar                                 # [K] s, [K] rms error bar, m
    truth.uv, truth.xyz                                # [n, 2]; [K, n, 3] m, of the middle surface

A scene is asked of the program: $CLOTHBENCH, or `clothbench` beside this file or on the PATH.
"""

import collections
import os
import shutil
import subprocess
import tempfile

import numpy

Truth = collections.namedtuple("Truth", "t uv xyz bar source")


def _checked(t, uv, xyz):
    """The three as arrays of doubles; ValueError with a sentence if they do not fit."""
    t, uv, xyz = (numpy.asarray(a, dtype=float) for a in (t, uv, xyz))
    if xyz.ndim != 3 or xyz.shape[2] != 3:
        raise ValueError("xyz is %s; it must be [frames][vertices][3]" % (xyz.shape,))
    if t.shape != xyz.shape[:1]:
        raise ValueError("t is %s for %d frames; one time each" % (t.shape, len(xyz)))
    if uv.shape != (xyz.shape[1], 2):
        raise ValueError("uv is %s for %d vertices; it must be [%d][2]"
                         % (uv.shape, xyz.shape[1], xyz.shape[1]))
    for name, a in ("t", t), ("uv", uv), ("xyz", xyz):
        if not numpy.isfinite(a).all():
            where = [int(k) for k in numpy.argwhere(~numpy.isfinite(a))[0]]
            raise ValueError("%s%s is not a number" % (name, where))
    if (numpy.diff(t) <= 0).any():
        raise ValueError("t must increase from frame to frame")
    if uv.min(initial=0) < 0 or uv.max(initial=1) > 1:
        raise ValueError("u and v are from 0 to 1; vertices outside the sheet are left out")
    return t, uv, xyz


def _h5py():
    try:
        import h5py
    except ImportError:
        raise ImportError("an .h5 file needs h5py (Debian: python3-h5py); .npz does not") from None
    return h5py


class frames:
    """What a simulator did."""

    @staticmethod
    def write(path, t, uv, xyz):
        """Writes positions xyz[frames][vertices][3] [m] at t[frames] [s] of the vertices at
        uv[vertices][2] to PATH, .npz or .h5; the whole file or none."""
        t, uv, xyz = _checked(t, uv, xyz)
        path = os.fspath(path)
        ending = os.path.splitext(path)[1]
        if ending not in (".npz", ".h5"):
            raise ValueError("%s: the name must end in .npz or .h5" % path)
        handle, aside = tempfile.mkstemp(dir=os.path.dirname(path) or ".", suffix=ending)
        os.close(handle)
        try:
            if ending == ".npz":
                numpy.savez(aside, t=t, uv=uv, xyz=xyz)
            else:
                with _h5py().File(aside, "w") as file:
                    for name, a, unit in ("t", t, "s"), ("uv", uv, "1"), ("xyz", xyz, "m"):
                        file.create_dataset(name, data=a).attrs["unit"] = unit
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(aside, 0o666 & ~mask)
            os.replace(aside, path)
        except BaseException:
            os.remove(aside)
            raise


class truth:
    """What is known of a scene's motion."""

    @staticmethod
    def read(source):
        """Of a file, what `truth SCENE --out FILE.h5` wrote or
        `truth SCENE --stored --points 100,100` printed; else of a scene."""
        source = os.fspath(source)
        if source.endswith(".h5"):
            return _read_h5(source)
        if source.endswith(".csv"):
            with open(source) as file:
                return _read_csv(source, file)
        command = [_program(), "truth", source, "--stored", "--points", "100,100"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as run:
            found, said = run.communicate()
        if run.returncode:
            raise ValueError(said.strip() or "%s failed" % " ".join(command))
        return _read_csv(source, found.splitlines())


def _program():
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "clothbench")
    program = os.environ.get("CLOTHBENCH") or shutil.which(beside) or shutil.which("clothbench")
    if not program:
        raise FileNotFoundError("no program clothbench beside clothbench.py or on the PATH; "
                                "$CLOTHBENCH may name it")
    return program


def _read_csv(name, lines):
    bars, source, rows = {}, "", []
    for number, line in enumerate(lines, 1):
        try:
            if line.startswith("# source: "):
                source = line[10:].strip()
            elif line.startswith("# bar: "):
                at, bar = line[7:].split(",")
                bars[float(at)] = float(bar)
            elif line.strip() and line[0] not in "#t":
                t, u, v, x, y, z = map(float, line.split(","))
                rows.append((t, u, v, x, y, z))
        except ValueError:
            raise ValueError("%s:%d: is no line t,u,v,x,y,z" % (name, number)) from None
    table = numpy.array(rows).reshape(-1, 6)
    t = numpy.unique(table[:, 0])
    n = len(table) // max(1, len(t))
    if not len(t) or n * len(t) != len(table) or set(bars) != set(t):
        raise ValueError("%s: is no truth of `clothbench truth SCENE --stored --points N,M`" % name)
    table = table.reshape(len(t), n, 6)
    return Truth(t, table[0, :, 1:3], table[:, :, 3:], numpy.array([bars[k] for k in t]), source)


def _read_h5(path):
    with _h5py().File(path, "r") as file:
        if "xyz_time" not in file or "metrics/error" not in file:
            raise ValueError("%s: is no truth of `clothbench truth`" % path)
        t = file["xyz_time"][...]
        layers = file["xyz"][...].astype(float)  # [time][w][v][u][3]
        bar = file["metrics/error"][...][:len(t)]
        source = file.attrs["note"]
    grid = numpy.linspace(0, 1, layers.shape[3])
    across = numpy.linspace(0, 1, layers.shape[2])
    uv = numpy.stack(numpy.meshgrid(grid, across), -1).reshape(-1, 2)
    xyz = layers.mean(1).reshape(len(t), -1, 3)
    source = source.decode() if isinstance(source, bytes) else str(source)
    return Truth(t, uv, xyz, bar, source)
