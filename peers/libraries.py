#!/usr/bin/env python3
"""Times CHOLMOD and LAPACK as they come on the matrices of the program's solids, beside its own
factor and solve of the same work; a row a net and library, with the ratios, as CSV.

    peers/libraries.py [PROGRAM]      # build/clothbench

The matrix is that of a frame, M + dt^2/4 K without the held points, as `run --matrices` writes K
and M. All on one thread and one processor; medians of nine, analysis not counted.
"""
import array
import csv
import ctypes
import itertools
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

NETS = {"iga 10x10x2 rebuilt": ("iga_paper", (10, 10, 2)),  # cases of `bench solids`: contestant, points
        "hex 32x32x2 rebuilt": ("hex_paper", (32, 32, 2)),
        "iga 100x100x2 prefactored": ("iga_linear", (100, 100, 2))}
STEP = 0.005        # edge_drop's [s]
BAND_MOST = 10000   # unknowns: the band of a large net would take 7 GB
REPEATS = 9
AGREED = 1e-6       # the solutions' difference: above round-off, below any other matrix

class Sparse(ctypes.Structure):  # cholmod_sparse
    _fields_ = [(name, kind) for names, kind in (("nrow ncol nzmax", ctypes.c_size_t), ("p i nz x z", ctypes.c_void_p),
                                                 ("stype itype xtype dtype sorted packed", ctypes.c_int))
                for name in names.split()]

def add(columns, path, scale, held):
    """Adds scale times a Matrix Market file without its first `held` rows to {row: value} a column."""
    with path.open() as file:
        lines = (line for line in file if not line.startswith("%"))
        size = int(next(lines).split()[0]) - held
        columns.extend({} for _ in range(size - len(columns)))
        for line in lines:
            row, column, value = line.split()
            i, j = int(row) - 1 - held, int(column) - 1 - held
            if i >= 0 and j >= 0:
                columns[j][i] = columns[j].get(i, 0) + scale * float(value)

def matrix(program, contestant, points):
    """Returns the columns' lower triangles of the net's matrix; the edge u = 0 is held."""
    columns, net = [], ",".join(map(str, points))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "run", "edge_drop", "--model", contestant, "--static", "--matrices", folder,
                        "--set", f"discretization.points=[{net}]"], check=True, capture_output=True)
        for name, scale in ("M.mtx", 1), ("K.mtx", STEP * STEP / 4):
            add(columns, pathlib.Path(folder, name), scale, 3 * points[1] * points[2])
    return columns

def median(call, prepare=lambda: None):
    """Returns the median seconds of a call that gives `True` if it went well."""
    seconds = []
    for _ in range(REPEATS + 1):  # the first warms up
        prepare()
        begin = time.perf_counter()
        assert call()
        seconds.append(time.perf_counter() - begin)
    return statistics.median(seconds[1:])

def by_cholmod(columns):
    """Returns the seconds of factor and solve, and the solution for a right-hand side of ones."""
    lib, common = ctypes.CDLL("libcholmod.so.3"), ctypes.create_string_buffer(1 << 16)
    for name in "analyze", "ones", "solve":
        getattr(lib, "cholmod_l_" + name).restype = ctypes.c_void_p
    lib.cholmod_l_start(common)
    n = len(columns)
    start = array.array("q", itertools.accumulate(map(len, columns), initial=0))
    row = array.array("q", (i for column in columns for i in sorted(column)))
    value = array.array("d", (column[i] for column in columns for i in sorted(column)))
    address = [a.buffer_info()[0] for a in (start, row, value)]
    A = ctypes.byref(Sparse(n, n, len(row), address[0], address[1], None, address[2], None, -1, 2, 1, 0, 1, 1))
    L = ctypes.c_void_p(lib.cholmod_l_analyze(A, common))
    b = ctypes.c_void_p(lib.cholmod_l_ones(ctypes.c_size_t(n), ctypes.c_size_t(1), 1, common))
    x = ctypes.c_void_p()
    factor = median(lambda: lib.cholmod_l_factorize(A, L, common))
    seconds = median(lambda: setattr(x, "value", lib.cholmod_l_solve(0, L, b, common)) or x.value,
                     lambda: lib.cholmod_l_free_dense(ctypes.byref(x), common))
    solution = ctypes.cast(x.value + 4 * 8, ctypes.POINTER(ctypes.POINTER(ctypes.c_double)))  # behind four sizes
    return factor, seconds, solution.contents[:n]

def by_lapack(columns):
    """Does the same with a band matrix in natural order."""
    lib, n = ctypes.CDLL("liblapacke.so.3"), len(columns)
    width = max(max(column) - j for j, column in enumerate(columns))
    full, band, x = (array.array("d", bytes(8 * size)) for size in (n * (width + 1), n * (width + 1), n))
    for j, column in enumerate(columns):
        for i, value in column.items():
            full[j * (width + 1) + i - j] = value
    pointer = [ctypes.c_void_p(a.buffer_info()[0]) for a in (full, band, x)]
    lower, ones = ctypes.c_char(b"L"), array.array("d", [1] * n)
    factor = median(lambda: not lib.LAPACKE_dpbtrf_work(102, lower, n, width, pointer[1], width + 1),
                    lambda: ctypes.memmove(pointer[1], pointer[0], 8 * len(full)))
    solve = median(lambda: not lib.LAPACKE_dpbtrs_work(102, lower, n, width, 1, pointer[1], width + 1, pointer[2], n),
                   lambda: ctypes.memmove(pointer[2], ones.buffer_info()[0], 8 * n))
    return factor, solve, list(x)

def main(program):
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    with tempfile.TemporaryDirectory() as folder:
        told = subprocess.run([program, "bench", "solids", "--format", "csv", "--out", folder],
                              check=True, capture_output=True, text=True).stdout
    rows = csv.DictReader(line for line in told.splitlines() if line and not line.startswith("#"))
    ours = {(r["case"], r["phase"]): float(r["median_ms"]) for r in rows}
    print("case,library,factor_ms,our_factor_ms,factor_ratio,solve_ms,our_solve_ms,solve_ratio")
    for case, (contestant, points) in NETS.items():
        columns = matrix(program, contestant, points)
        answers = {"CHOLMOD": by_cholmod(columns)}
        if len(columns) < BAND_MOST:
            answers["LAPACK band"] = by_lapack(columns)
        for name, (factor, solve, x) in answers.items():
            assert max(abs(a - b) for a, b in zip(x, answers["CHOLMOD"][2])) < AGREED * max(map(abs, x))
            f, s = ours[case, "factor"], ours[case, "solve"]
            print(f"{case},{name},{1e3 * factor:.3g},{f:.3g},{1e3 * factor / f:.3g},"
                  f"{1e3 * solve:.3g},{s:.3g},{1e3 * solve / s:.3g}", flush=True)

if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "build/clothbench")
