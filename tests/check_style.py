#!/usr/bin/env python3
"""What a reader should not meet: crowded rooms, long functions and lines, notes to self, tabs,
trailing blanks, places on somebody's machine, and assert in tests, where -DNDEBUG would silence it.

    check_style.py TOP
"""
import collections
import os
import pathlib
import re
import sys

LONGEST_BODY = 60    # lines of a C function between its braces
LONGEST_LINE = 100   # 92 is the aim, and clang-format's
LARGEST_ROOM = 7000  # lines of C in one folder
NAMES_MOST = 3       # files of bench, outside of its checks, that know a model by name

KINDS = {".c", ".h", ".cmake", ".txt", ".sh", ".yaml", ".md", ".edp", ".gp", ".1", ".py"}
ALONE = ("check", "reproduce", ".ci/run", "doc/refresh", "doc/figures", "tools/plant",
         "tools/compare_builds", "tools/constants")
# bad_scenes are bad on purpose; paper/ is not ours to format.
NOT_OURS = re.compile(r"(build[^/]*|results|paper|tests/bad_scenes|\.git)/")
# Brackets keep these expressions from finding themselves.
NOTE = re.compile(r"(^|[^A-Za-z])(T[O]DO|FIX[M]E|X[X]X)([^A-Za-z]|$)")
MACHINE = re.compile(r"(^|[^A-Za-z0-9_.}>*])/(home|root|work|mnt|Users)/[A-Za-z0-9_]")
ASSERT = re.compile(r"(^|[^A-Za-z0-9_])assert(\.h>| *[(])")
MODEL = re.compile(r'"(iga|hex|shell|mass_spring|projective_dynamics)"')


def faults_of_line(name, line):
    if "\t" in line:
        yield "a tab"
    if re.search(r"[ \r]$", line):
        yield "trailing blanks"
    if found := NOTE.search(line):
        yield f"a note to self ({found[2]})"
    if found := MACHINE.search(line):
        yield f"a place on one machine (/{found[2]}/)"
    if name.endswith((".c", ".h")):
        if name.startswith("tests/") and ASSERT.search(line):
            yield "assert in a test; use CHECK or REQUIRE"
        if len(line.encode()) > LONGEST_LINE:
            yield f"{len(line.encode())} columns; {LONGEST_LINE} at most"


def long_bodies(lines):
    opened = 0
    for number, line in enumerate(lines, 1):
        if line == "{":
            opened = number
        elif line == "}" and number - opened - 1 > LONGEST_BODY:
            yield opened, f"a function of {number - opened - 1} lines; {LONGEST_BODY} at most"


def main():
    top = pathlib.Path(sys.argv[1])
    faults, rooms, named = [], collections.Counter(), []
    names = sorted(path.relative_to(top).as_posix() for path in top.rglob("*")
                   if path.suffix in KINDS and path.is_file())
    names = [name for name in [*names, *ALONE] if not NOT_OURS.match(name)]
    for name in names:
        text = (top / name).read_text(errors="replace")
        lines = text.removesuffix("\n").split("\n")
        faults += [(name, n, fault) for n, line in enumerate(lines, 1)
                   for fault in faults_of_line(name, line)]
        if not name.endswith((".c", ".h")):
            continue
        faults += [(name, n, fault) for n, fault in long_bodies(lines)]
        if not name.startswith("tests/"):
            rooms[os.path.dirname(name)] += len(lines)
        if name.startswith("bench/") and not name.startswith("bench/verify/checks/") \
                and MODEL.search(text):
            named.append(name)
    faults += [(room, 0, f"{lines} lines in one room; {LARGEST_ROOM} at most")
               for room, lines in rooms.items() if lines > LARGEST_ROOM]
    if len(named) > NAMES_MOST:
        faults.append(("bench", 0, f"models by name in {len(named)} files; {NAMES_MOST} at most: "
                       + ", ".join(named)))
    for name, number, fault in faults:
        print(f"{name}:{number}: {fault}" if number else f"{name}: {fault}")
    print(f"{len(names)} files, {len(faults)} faults")
    return bool(faults) or not names


if __name__ == "__main__":
    sys.exit(main())
