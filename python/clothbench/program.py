"""The program, called."""

import json
import os
import shutil
import subprocess
import tempfile

from .exported import Exported

def find():
    """Returns the program's path; FileNotFoundError with a sentence where there is none."""
    here = os.path.dirname(os.path.realpath(__file__))
    program = (os.environ.get("CLOTHBENCH")
               or shutil.which(here + "/../../../../bin/clothbench")  # PREFIX/lib/python3/...
               or shutil.which(here + "/../../build/clothbench") or shutil.which("clothbench"))
    if not program or not shutil.which(program):
        raise FileNotFoundError(f"no program {program or 'clothbench on the PATH'}; $CLOTHBENCH may name it")
    return program

def run(*words):
    """Returns what `clothbench WORDS...` prints; ValueError with its sentence if it fails."""
    command = [find(), *map(str, words)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise ValueError(done.stderr.strip() or "%s failed" % " ".join(command))
    return done.stdout

def export(scene, n=None, m=None, folder=None, settings=None):
    """Exports a scene on n x m points, or on the mesh that it has, and returns it as read; into a new
    folder, if one is named. settings are {"material.young": 5e4, ...}."""
    with tempfile.TemporaryDirectory() as aside:
        out = os.path.join(aside, "scene") if folder is None else folder
        changes = [w for key, value in (settings or {}).items() for w in ("--set", f"{key}={value}")]
        points = [] if n is None else ["--points", f"{n},{m}"]
        run("export", scene, *points, "--out", out, *changes)
        return Exported(out)

def score(*words):
    """Returns what `clothbench score WORDS...` finds, a dictionary a scene."""
    found = json.loads(run("score", *words, "--format", "json"))
    return found if isinstance(found, list) else [found]
