"""What is known of a scene's motion."""

import collections
import os
import pathlib

import numpy

from . import program, results

Truth = collections.namedtuple("Truth", "t uv xyz bar source")

def read(source):
    """Reads the truth of a scene, or of a file, what `truth SCENE --out FILE.h5` wrote or
    `truth SCENE --stored --points 100,100` printed: times .t [K] s, their rms error bars .bar [K]
    m, places .uv [n, 2], positions .xyz [K, n, 3] m of the middle surface, and .source."""
    source = os.fspath(source)
    if source.endswith(".h5"):
        return _read_h5(source)
    return _read_csv(source, pathlib.Path(source).read_text() if source.endswith(".csv") else
                     program.run("truth", source, "--stored", "--points", "100,100"))

def _read_csv(name, text):
    bars, source, rows = {}, "", []
    for number, line in enumerate(text.splitlines(), 1):
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
    t = numpy.unique([r[0] for r in rows])
    if not len(t) or len(rows) % len(t) or set(bars) != set(t):
        raise ValueError("%s: is no truth of `clothbench truth SCENE --stored --points N,M`" % name)
    table = numpy.array(rows).reshape(len(t), -1, 6)
    return Truth(t, table[0, :, 1:3], table[:, :, 3:], numpy.array([bars[k] for k in t]), source)

def _read_h5(path):
    run = results.run(path, most=1 << 30, step=1)
    if run is None or len(run.bar) < len(run.time):
        raise ValueError("%s: is no truth of `clothbench truth`" % path)
    xyz = run.side_by_side()
    grid = numpy.meshgrid(numpy.linspace(0, 1, xyz.shape[2]), numpy.linspace(0, 1, xyz.shape[1]))
    return Truth(numpy.array(run.time), numpy.stack(grid, -1).reshape(-1, 2), xyz.reshape(len(xyz), -1, 3),
                 numpy.array(run.bar), run.note)
