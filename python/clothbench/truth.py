"""What is known of a scene's motion."""

import collections
import os

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
    if source.endswith(".csv"):
        with open(source) as file:
            return _read_csv(source, file)
    return _read_csv(source, program.run(
        "truth", source, "--stored", "--points", "100,100").splitlines())

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
    run = results.run(path, most=1 << 30, step=1)
    if run is None or len(run.bar) < len(run.time):
        raise ValueError("%s: is no truth of `clothbench truth`" % path)
    xyz = run.side_by_side()
    grid = numpy.meshgrid(numpy.linspace(0, 1, xyz.shape[2]), numpy.linspace(0, 1, xyz.shape[1]))
    return Truth(numpy.array(run.time), numpy.stack(grid, -1).reshape(-1, 2), xyz.reshape(len(xyz), -1, 3),
                 numpy.array(run.bar), run.note)
