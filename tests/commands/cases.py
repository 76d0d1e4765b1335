#!/usr/bin/env python3
"""Runs the cases of a command: rows of a text file, each in an empty folder of its own.

    cases.py FOLDER[:FOLDER]... FILE.cases [PART OF A ROW'S NAME]...

FOLDERs are where the programs are that the commands call.

Before the first row a file may have `setup` and `file` blocks, which all its rows share. A row is

    == its name
    each                    its rows follow, indented: the case is done once for each of these
        A | B               lines, whose parts stand for {1}, {2} below; of two such blocks
                            each line with each
    file NAME               the contents follow, indented
    $ COMMAND               a line of bash, as a user types it, with nothing on standard input;
                            what it prints is in the files `out` and `err`
    exit 1                  how it must end; 0 unless this or `refused` says otherwise
    refused: TEXT           it must end with 2, print nothing, write nothing, and say one line,
                            which has TEXT
    FILE has TEXT           and `lacks TEXT`, `matches REGEX`, `is TEXT` wherever lines
                            break, `empty`, `lines 3` or
                            `lines 3..5`, `number REGEX in A..B` of what its group matches
    FILE rows K=V ... : COLUMN=V COLUMN<V COLUMN~REGEX ...
                            all rows of its tables that have these cells have those; there is one
    FILE count 3 K=V ...    so many rows have these cells
    written NAME...         and `absent NAME...`: what is there now, with * as in a shell

Whatever a row says, no command may leave a .part file, unless it kills or makes it, or say anything that a terminal obeys.
"""
import contextlib
import csv
import itertools
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile

TIMEOUT = 300  # [s] of a command, many times what the longest takes
ROUND_OFF = 1e-12  # of a number that a case has in fewer digits than a table
SHOWN = 1500   # characters of what was printed, for who reads a failure
ENDS = {"exit", "refused:"}
CHECKS = {"has", "lacks", "matches", "is", "empty", "lines", "number", "rows", "count"}


class Wrong(Exception):
    """What was wanted, and what came."""


def indented(lines, at):
    """The block below line `at`, without its indentation."""
    block = []
    while at + 1 < len(lines) and (lines[at + 1].startswith("    ") or not lines[at + 1]):
        at += 1
        block.append(lines[at][4:])
    while block and not block[-1]:
        block.pop()
    return block, at


def read(path):
    """The rows of a file: a name and a list of (line, kind, rest, block)."""
    lines = path.read_text().split("\n")
    rows, at = [("", [])], -1
    while (at := at + 1) < len(lines):
        line, begun = lines[at], at + 1
        if not line or line.startswith("#"):
            continue
        if line.startswith("== "):
            rows.append((line[3:], []))
            continue
        kind, _, rest = line.partition(" ")
        block, at = indented(lines, at) if kind in ("file", "each", "setup") else ([], at)
        word = rest.split(" ")[0]
        if kind not in {"file", "each", "setup", "$", "written", "absent"} | ENDS and word not in CHECKS:
            sys.exit(f"{path}:{begun}: '{line}' is nothing that a case has")
        rows[-1][1].append((begun, kind, rest, block))
    return rows


def parts(line):
    """What stands between bars, without a blank on either side of a bar."""
    return [part.removeprefix(" ") if n else part
            for n, part in enumerate(re.split(r"(?:^| )\|(?= |$)", line))]


def cases(items):
    """A row's steps, once for each line of its `each`, or each pair of lines of two."""
    blocks = [[parts(line) for line in block] for _, kind, _, block in items if kind == "each"]
    rest = [item for item in items if item[1] != "each"]
    for lines in itertools.product(*blocks):
        part = [p for line, block in zip(lines, blocks)
                for p in line + [""] * (max(map(len, block)) - len(line))]

        def fill(text):
            return re.sub(r"\{(\d)\}", lambda m: part[int(m[1]) - 1], text) if blocks else text
        yield " | ".join(part), [(n, fill(kind), fill(text), [fill(t) for t in block])
                                 for n, kind, text, block in rest]


def tables(text):
    """All rows of the CSV tables of a text, which remarks and blank lines part."""
    for part in re.split(r"\n\s*\n|^#.*\n", text, flags=re.M):
        lines = part.strip("\n").split("\n")
        if "," in lines[0]:
            yield from csv.DictReader(lines)


def is_same(cell, want):
    if cell == want:
        return True
    with contextlib.suppress(ValueError):
        return abs(float(cell) - float(want)) <= ROUND_OFF * max(1, abs(float(want)))
    return False


def holds(row, condition):
    match = re.fullmatch(r"([^=<>~!]+)(!=|=|~|<|>)(.*)", condition, re.S)
    column, sign, want = match.groups()
    if column not in row or row[column] is None:
        return False
    if sign in "<>":
        with contextlib.suppress(ValueError):
            number = float(row[column])
            return number < float(want) if sign == "<" else number > float(want)
        return False
    if sign == "~":
        return re.search(want, row[column]) is not None
    return is_same(row[column], want) == (sign == "=")


def chosen(text, conditions):
    return [row for row in tables(text) if all(holds(row, c) for c in conditions)]


def want(what, right, got):
    if not right:
        got = got if len(got) <= SHOWN else got[:SHOWN] + " ..."
        raise Wrong(f"    want: {what}\n    got:  {got.strip()}")


def check_rows(text, rest):
    where, _, conditions = rest.partition(":")
    rows = chosen(text, shlex.split(where))
    want(f"a row with {where}", rows, text)
    for row in rows:
        for c in shlex.split(conditions):
            want(f"{c} where {where}", holds(row, c), str(row))


def between(number, bounds):
    low, _, high = bounds.partition("..")
    return float(low or "-inf") <= number <= float((high or "inf") if _ else low)


def check_file(name, what, rest, text):
    line = f"{name} {what} {rest}"
    if what == "rows":
        return check_rows(text, rest)
    if what == "count":
        count, *conditions = shlex.split(rest)
        rows = chosen(text, conditions)
        return want(line, between(len(rows), count), f"{len(rows)}: {text}")
    if what == "number":
        pattern, _, bounds = rest.rpartition(" in ")
        found = re.search(pattern, text, re.M)
        want(line, found, text)
        return want(line, between(float(found[1]), bounds), found[1])
    right = {
        "has": lambda: rest in text,
        "lacks": lambda: rest not in text,
        "matches": lambda: re.search(rest, text, re.M),
        "is": lambda: text.split() == rest.split(),
        "empty": lambda: not text,
        "lines": lambda: between(text.count("\n"), rest),
    }[what]()
    return want(line, right, text)


class Folder:
    """One case, done step by step."""

    def __init__(self, path, setup, environment):
        self.path, self.setup, self.environment = path, setup, environment
        self.command, self.code, self.before = None, 0, set()

    def files(self):
        return {str(p) for p in self.path.rglob("*") if p.name not in ("out", "err")}

    def text(self, name):
        path = self.path / name
        want(f"a file {name}", path.is_file(), " ".join(sorted(self.files())))
        return path.read_text(errors="backslashreplace")

    def run(self, command):
        self.command, self.before = command, self.files()
        said = [self.path.parent / name for name in ("out", "err")]
        with open(said[0], "w") as out, open(said[1], "w") as err:
            process = subprocess.Popen(
                ["bash", "-c", f"{self.setup}\n{command}"], cwd=self.path, stdout=out, stderr=err,
                stdin=subprocess.DEVNULL, env=self.environment, start_new_session=True)
            try:
                self.code = process.wait(TIMEOUT)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                raise Wrong(f"    want: an end within {TIMEOUT} s") from None
        for path in said:  # so that the command may read what the last one said
            path.rename(self.path / path.name)
        parts = [p for p in self.files() - self.before if p.endswith(".part")]
        want("no .part files", not parts or re.search(r"\.part|-KILL", command), " ".join(parts))
        said = self.text("err")
        want("nothing that a terminal obeys", not re.search(r"[\0-\x08\x0b-\x1f\x7f]", said), repr(said))

    def ended(self, code):
        want(f"exit {code}", self.code == code, f"exit {self.code}: {self.text('err')}{self.text('out')}")

    def refused(self, text):
        self.ended(2)
        want("nothing on standard output", not self.text("out"), self.text("out"))
        said = self.text("err")
        want(f"one line that has '{text}'", said.count("\n") == 1 and text in said, said)
        made = self.files() - self.before
        want("nothing written", not made, " ".join(made))

    def step(self, kind, rest, block, is_judged):
        if kind == "file":
            path = self.path / rest
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("\n".join(block) + "\n" * bool(block))
        elif kind == "$":
            self.run(rest)
            if not is_judged:
                self.ended(0)
        elif kind == "exit":
            self.ended(int(rest))
        elif kind == "refused:":
            self.refused(rest)
        elif kind in ("written", "absent"):
            for name in rest.split():
                there = sorted(p.name for p in self.path.glob(name) if p.name not in ("out", "err"))
                want(f"{kind} {name}", bool(there) == (kind == "written"),
                     " ".join(there) or " ".join(sorted(os.listdir(self.path))))
        else:
            what, _, rest = rest.partition(" ")
            check_file(kind, what, rest, self.text(kind))


def do(file, name, line, shared, items, environment):
    """Does a case and returns whether all of it is as it says."""
    setup = "\n".join(t for _, kind, _, block in shared if kind == "setup" for t in block)
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(pathlib.Path(path, "case"), setup, environment)
        folder.path.mkdir()
        steps = [s for s in shared if s[1] != "setup"] + items
        for at, (number, kind, rest, block) in enumerate(steps):
            is_judged = at + 1 < len(steps) and steps[at + 1][1] in ENDS
            try:
                folder.step(kind, rest, block, is_judged)
            except Wrong as wrong:
                print(f"{file.name}:{number}: {name}{f' [{line}]' * bool(line)}")
                print(f"    $ {folder.command}\n{wrong}")
                return False
    return True


def main():
    programs, file, *names = sys.argv[1:]
    programs = ":".join(os.path.abspath(folder) for folder in programs.split(":"))
    file = pathlib.Path(file)
    environment = dict(os.environ, LC_ALL="C", SOURCE=str(pathlib.Path(__file__).resolve().parents[2]),
                       PATH=f"{programs}:{os.environ['PATH']}")
    environment.setdefault("OMP_NUM_THREADS", "1")
    (_, shared), *rows = read(file)
    done = failed = 0
    for name, items in rows:
        if names and not any(n in name for n in names):
            continue
        for line, steps in cases(items):
            done += 1
            failed += not do(file, name, line, shared, steps, environment)
    print(f"{done} cases, {failed} failed")
    sys.exit(failed > 0 or not done)


if __name__ == "__main__":
    main()
