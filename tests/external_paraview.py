#!/usr/bin/env python3
"""ParaView opens the XDMF of a result file: steps, times, extent, bounds, point data.

    external_paraview.py TEST_STORE FOLDER

TEST_STORE PATH writes a sheet that rolls up in time. Run by python3, this starts itself again
inside pvbatch; 77 where there is none.
"""
import math
import os
import shutil
import subprocess
import sys

FRAMES, POINTS = 3, (100, 100, 2)
# Positions are printed and stored as doubles, but ParaView's bounds of float data would be
# off by 1e-7 of 1 m.
TOL_BOUNDS = 1e-12


def position(frame, u, v, w):
    """As in tests/bench/files/store.c."""
    curvature = frame + 0.01
    radius = 1 / curvature - 0.05 * (w - 0.5)
    return (radius * math.sin(u * curvature), 0.5 * v,
            radius * math.cos(u * curvature) - 1 / curvature)


def bounds(frame):
    """Bounding box over the grid: xmin, xmax, ymin, ... as ParaView gives it."""
    points = [position(frame, i / 99, j, k)
              for i in range(100) for j in (0, 1) for k in (0, 1)]
    return [f(p[c] for p in points) for c in range(3) for f in (min, max)]


def check(reader, simple):
    """All failures as sentences."""
    times = list(reader.TimestepValues)
    if len(times) != FRAMES or any(abs(t - 0.1 * n) > 1e-15 for n, t in enumerate(times)):
        return [f"time steps {times}"]
    failed = []
    for frame, time in enumerate(times):
        # 5.11's readers of XDMF 3 take a script's time 0 for no time (in a view they do not)
        if time == 0 and type(reader).__name__.startswith("Xdmf3"):
            continue
        simple.UpdatePipeline(time, reader)
        info = reader.GetDataInformation()
        actual, want = info.GetBounds(), bounds(frame)
        print(f"t = {time}: {info.GetNumberOfPoints()} points, extent {info.GetExtent()}, "
              f"bounds {actual}")
        if any(not abs(a - b) <= TOL_BOUNDS for a, b in zip(actual, want)):
            failed.append(f"bounds {actual}, want {want}")
        if tuple(info.GetExtent()) != (0, 99, 0, 99, 0, 1):
            failed.append(f"extent {info.GetExtent()}")
        start = reader.PointData["start"].GetRange(1) if "start" in reader.PointData.keys() \
            else None
        if start != (0.0, 0.5):
            failed.append(f"point data start: range of y {start}")
    return failed


def inside(xdmf):
    try:
        from paraview import simple
    except ModuleNotFoundError:
        print("skipped: no Python for ParaView (Debian package python3-paraview)")
        sys.exit(77)
    # what "Open" offers: the reader of XDMF 2, of XDMF 3, and of XDMF 3 with all times at once
    readers = [simple.XDMFReader(FileNames=[xdmf]), simple.Xdmf3ReaderS(FileName=[xdmf]),
               simple.Xdmf3ReaderT(FileName=[xdmf])]
    failed = [f"{type(reader).__name__}: {sentence}" for reader in readers
              for sentence in check(reader, simple)]
    for sentence in failed:
        print(f"{xdmf}: {sentence}")
    print(f"{len(failed)} failed")
    sys.stdout.flush()
    os._exit(1 if failed else 0)  # some builds of ParaView crash in their own clean-up


def main():
    if sys.argv[1] == "--inside":
        inside(sys.argv[2])
    if not shutil.which("pvbatch"):
        print("skipped: no pvbatch (Debian package paraview)")
        return 77
    program, folder = sys.argv[1], os.path.abspath(sys.argv[2])
    os.makedirs(folder, exist_ok=True)
    subprocess.run([program, os.path.join(folder, "bent.h5")], check=True)
    return subprocess.run(["pvbatch", os.path.abspath(__file__), "--inside",
                           os.path.join(folder, "bent.xdmf")]).returncode



if __name__ == "__main__":
    sys.exit(main())
