"""What a simulator did: positions of vertices at times."""

import collections
import io
import os

import numpy

from . import results

Frames = collections.namedtuple("Frames", "t uv xyz")

def _checked(t, uv, xyz):
    """The three as arrays of doubles; ValueError with a sentence if they do not fit."""
    t, uv, xyz = (numpy.asarray(a, dtype=float) for a in (t, uv, xyz))
    if xyz.ndim != 3 or xyz.shape[2] != 3:
        raise ValueError("xyz is %s; it must be [frames][vertices][3]" % (xyz.shape,))
    if t.shape != xyz.shape[:1]:
        raise ValueError("t is %s for %d frames; one time each" % (t.shape, len(xyz)))
    if uv.shape != (xyz.shape[1], 2):
        raise ValueError("uv is %s for %d vertices; it must be [%d][2]" % (uv.shape, xyz.shape[1], xyz.shape[1]))
    for name, a in ("t", t), ("uv", uv), ("xyz", xyz):
        if not numpy.isfinite(a).all():
            where = [int(k) for k in numpy.argwhere(~numpy.isfinite(a))[0]]
            raise ValueError("%s%s is not a number" % (name, where))
    if (numpy.diff(t) <= 0).any():
        raise ValueError("t must increase from frame to frame")
    if uv.min(initial=0) < 0 or uv.max(initial=1) > 1:
        raise ValueError("u and v are from 0 to 1; vertices outside the sheet are left out")
    return Frames(t, uv, xyz)

def h5py():
    try:
        import h5py as module
    except ImportError:
        raise ImportError("an .h5 file needs h5py (Debian: python3-h5py); .npz does not") from None
    return module

def _ending(path):
    ending = os.path.splitext(path)[1]
    if ending not in (".npz", ".h5"):
        raise ValueError("%s: the name must end in .npz or .h5" % path)
    return ending

def write(path, t, uv, xyz):
    """Writes positions xyz[frames][vertices][3] [m] at t[frames] [s] of the vertices at
    uv[vertices][2] to PATH, .npz or .h5; the whole file or none.
    Folders that are not there are made."""
    t, uv, xyz = _checked(t, uv, xyz)
    path, data = os.fspath(path), io.BytesIO()
    if _ending(path) == ".npz":
        numpy.savez(data, t=t, uv=uv, xyz=xyz)
    else:
        with h5py().File(data, "w") as file:
            for name, a, unit in ("t", t, "s"), ("uv", uv, "1"), ("xyz", xyz, "m"):
                file.create_dataset(name, data=a).attrs["unit"] = unit
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    results.write(path, data.getvalue())

def read(path):
    """Reads what write wrote, as .t, .uv and .xyz."""
    path = os.fspath(path)
    with (numpy.load(path) if _ending(path) == ".npz" else h5py().File(path, "r")) as file:
        if lacks := [name for name in Frames._fields if name not in file]:
            raise ValueError("%s: has no %s" % (path, ", ".join(lacks)))
        return _checked(*(file[name][...] for name in Frames._fields))
