"""Readers of what others may have made: only regular files, only numbers that stand in a file."""
import math
import os
import zlib

import h5py
import numpy as np
import pytest

from clothbench import charts, page, results
from clothbench.results import Bad

@pytest.mark.parametrize("text, want", [
    ("a,b\n1,2\n", [("", ["a", "b"], 1)]),
    ("# clothbench table 1 | commit x | cpu\n# Table 1\na\n1\n# a note\n\n# next\nb,c\nx,\n",
     [("Table 1", ["a"], 1), ("next", ["b", "c"], 1)]),
    ('a,"b ""quoted"", c"\n"two\nlines",nan\n', [("", ["a", 'b "quoted", c'], 1)]),
])
def test_tables(tmp_path, text, want):
    (tmp_path / "t.csv").write_text(text)
    found = results.tables(tmp_path / "t.csv")
    assert [(t.caption, t.keys, len(t.rows)) for t in found] == want

def test_cells(tmp_path):
    (tmp_path / "t.csv").write_text('# clothbench x | y\n# words\na,b\n"two\nlines",nan\n# a note\n')
    table, = results.tables(tmp_path / "t.csv")
    assert table.rows == [{"a": "two\nlines", "b": ""}]
    assert (table.made, table.caption, table.notes) == ("clothbench x | y", "words", ["a note"])
    assert math.isnan(results.number("inf")) and math.isnan(results.number("-")) and results.number("2") == 2

def test_opened(tmp_path):
    (tmp_path / "there").write_text("a\n1\n")
    os.symlink("there", tmp_path / "link")
    os.mkfifo(tmp_path / "pipe")
    for name, words in {"link": "symbolic link", "pipe": "no regular file", ".": "no regular file",
                        "none": "No such file"}.items():
        with pytest.raises(Bad, match=words):
            results.opened(tmp_path / name, 100)
    with pytest.raises(Bad, match="more than"):
        results.opened(tmp_path / "there", 2)

def seal(path):
    """Writes the first line of a result file."""
    data = path.read_bytes()[512:]
    head = f"{results.SEAL}{len(data)} bytes, crc32 {zlib.crc32(data):08x}\n".encode()
    path.write_bytes(head.ljust(512, b"\0") + data)

def sheet(path, xyz=None, **attributes):
    """A result file of two frames of a sheet."""
    with h5py.File(path, "w", userblock_size=512) as file:
        file["xyz"] = np.zeros((2, 2, 100, 100, 3)) if xyz is None else xyz
        file["xyz_time"] = [0.0, 0.5]
        file.attrs.update({"scene_name": "s", "model": "iga", "length": 1.0} | attributes)
    seal(path)

def test_run(tmp_path):
    xyz = np.random.default_rng(1).random((2, 2, 100, 100, 3))
    sheet(tmp_path / "r.h5", xyz, scene="sheets:\n  - origin: [0,0,0]\n  - origin: [0,0,1]\n")
    run = results.run(tmp_path / "r.h5", times=[0.4])
    assert run.time == [0.5] and run.xyz.shape == (1, 2, 25, 13, 3)
    assert np.allclose(run.xyz[0, 1, 2, 3], xyz[1, :, 8, 50 + 12].mean(0))
    assert np.allclose(run.side_by_side()[0, 2, 13 + 3], run.xyz[0, 1, 2, 3])

@pytest.mark.parametrize("triangle, place, words", [
    ([[0, 1, 2]], np.eye(3), ""), ([[0, 1, 2]], np.full((3, 3), np.nan), ""),
    ([[0, 1, 3]], np.eye(3), "points that its surface has not"), ([[-1, 1, 2]], np.eye(3), "points that its"),
    ([[0.0, 1, 2]], np.eye(3), "no triangles"), ([0, 1, 2], np.eye(3), "no triangles"),
    ([[0, 1, 2]], np.eye(3)[:, :2], "no triangles"), ([[0, 1, 2]], None, "no triangles")])
def test_surface(tmp_path, triangle, place, words):
    """Of a sheet that is no rectangle the triangles are drawn; those that are none are told, whether or not
    each time has their points."""
    path = tmp_path / "run_s" / "r.h5"
    path.parent.mkdir()
    sheet(path, np.ones((2, 2, 100, 100, 3)))
    with h5py.File(path, "r+") as file:
        file["surface/triangle"], file["surface/0"] = triangle, np.zeros((3, 3))
        if place is not None:
            file["surface/1"] = place
    seal(path)
    if words:
        with pytest.raises(Bad, match=words):
            results.run(path)
    else:
        run = results.run(path)
        assert np.array_equal(run.faces(1), [place[[0, 1, 2, 2]]], equal_nan=True)
        assert len(charts.pictures_of([run])) == 2
        motion, = page.motions_of(tmp_path)
        assert (motion["rows"], motion["columns"], motion["triangles"]) == (1, 3, triangle)

def test_bad_shape(tmp_path):
    sheet(tmp_path / "r.h5", np.zeros((3, 2, 100, 100, 3)))
    with pytest.raises(Bad, match="for 2 times"):
        results.run(tmp_path / "r.h5")

def test_numbers_for_a_folder(tmp_path):
    sheet(tmp_path / "r.h5")
    with h5py.File(tmp_path / "r.h5", "r+") as file:
        file["metrics"] = [1.0]
    seal(tmp_path / "r.h5")
    with pytest.raises(Bad, match="its metrics/error are no numbers"):
        results.run(tmp_path / "r.h5")
