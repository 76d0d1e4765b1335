"""How the program takes what becomes of the Python that it starts: by its exit code, and its words."""
import os
import subprocess

import pytest

import clothbench

@pytest.mark.parametrize("script, code, words", [
    ("exit 0", 0, ""),
    ("echo no such table >&2; exit 2", 2, "no such table"),  # the input
    ("echo the disk is full >&2; exit 1", 1, "the disk is full"),
    ("echo 'apt-get install python3-x' >&2; exit 3", 1, "python3-x"),
    ("exit 127", 1, "Python is not there"),
    ("exit 1", 1, "without a word"),
    ("kill -9 $$", 1, "without a word"),
    ("yes 0123456789 | head -n 100000 >&2; exit 2", 2, "0123456789"),
    (r"printf 'a\033[2Jb\n' >&2; exit 2", 2, "a?[2Jb"),
])
@pytest.mark.parametrize("command, optional", [("report", False), ("export", True)])
def test_exit_codes(tmp_path, script, code, words, command, optional):
    """`report` ends with what it means; `export`, which has other files, fails only for a fault of these."""
    python = tmp_path / "python"
    python.write_text(f"#!/bin/sh\n{script}\n")
    python.chmod(0o755)
    given = {"report": [tmp_path], "export": ["edge_drop", "--points", "3,3", "--out", tmp_path / "new"]}[command]
    done = subprocess.run([clothbench.program.find(), command, *given], capture_output=True, text=True, check=False,
                          env=os.environ | {"CLOTHBENCH_PYTHON": str(python)})
    lacks = "exit 3" in script or "exit 127" in script
    assert done.returncode == (0 if optional and lacks else code) and words in done.stderr, done.stderr
    assert "\033" not in done.stderr and len(done.stderr) < 5000
