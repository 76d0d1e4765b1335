"""Scenes, frames and truths of clothbench, from Python; needs numpy, and h5py for .h5 files only.

    import clothbench
    scene = clothbench.export("edge_drop", 21, 21)   # .x .uv .triangles .mass .springs .held ...
    clothbench.frames.write("mine.npz", t, scene.uv, xyz)
    print(clothbench.run("score", "edge_drop", "mine.npz"))
    truth = clothbench.truth.read("edge_drop")       # .t .uv .xyz .bar .source

The program is $CLOTHBENCH, the one that this package was installed or built with, or the one on
the PATH.
"""

from . import frames, truth
from .exported import Exported
from .program import export, run, score

__all__ = ["Exported", "export", "frames", "run", "score", "truth"]
