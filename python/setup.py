"""The version is the program's; all else is in pyproject.toml."""
import pathlib
import re

from setuptools import setup

top = pathlib.Path(__file__).resolve().parent.parent / "CMakeLists.txt"
setup(version=re.search(r"project\(clothbench VERSION ([\d.]+)", top.read_text())[1])
