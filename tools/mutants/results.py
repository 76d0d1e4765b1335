"""What became of the mutants: a file of rows, those excused, tables."""
import csv
import os
import re

FIELDS = ("file", "line", "function", "nth", "kind", "old", "new", "end", "by", "ran",
          "covering", "seconds", "commit")
# Ends that tell a mutant; 'same' code and 'does not compile' are none.
NOTICED = ("noticed", "hangs")
SURVIVED = ("survived", "unreached")


def key(row):
    return row["file"], row["function"], row["old"], row["new"], int(row["nth"])


def load(path):
    """Rows by mutant; the last of each counts."""
    if not path or not os.path.exists(path):
        return {}
    with open(path, newline="") as text:
        return {key(row): row for row in csv.DictReader(text)}


def append(path, row):
    new = not os.path.exists(path)
    if os.path.dirname(path):
        os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "a", newline="") as text:
        writer = csv.DictWriter(text, FIELDS, lineterminator="\n")
        if new:
            writer.writeheader()
        writer.writerow(row)


def rewrite(path, rows):
    """Each mutant once, in order."""
    os.replace(path, path + ".old")
    for row in sorted(rows, key=lambda r: (r["file"], int(r["line"]), r["new"])):
        append(path, row)
    os.remove(path + ".old")


class Excuses:
    """tests/survivors.txt: `file`, -line, +line that takes its place, `why`."""

    def __init__(self, top):
        self.path, self.reasons = os.path.join(top, "tests", "survivors.txt"), {}
        entry = {}
        if not os.path.exists(self.path):
            return
        with open(self.path) as text:
            for number, line in enumerate(text, 1):
                line = line.strip()
                kind = next((k for k in ("file ", "-", "+", "why ") if line.startswith(k)), None)
                if line and not line.startswith("#") and not kind:
                    raise SystemExit(f"tests/survivors.txt:{number}: what is this? {line}")
                if kind:
                    entry[kind] = line[len(kind) :].strip()
                if kind == "why ":
                    self.reasons[entry["file "], entry["-"], entry["+"]] = entry["why "]

    def why(self, file, old, new):
        return self.reasons.get((file, old, new))

    def stale(self, top):
        """Entries whose line is no more."""
        for file, old, _ in self.reasons:
            path = os.path.join(top, file)
            lines = open(path).read().split("\n") if os.path.exists(path) else []
            if old not in (line.strip() for line in lines):
                yield f"tests/survivors.txt: not in {file}: {old}"


def mark_excused(rows, excuses):
    for row in rows:
        reason = excuses.why(row["file"], row["old"], row["new"])
        if reason and row["end"] in SURVIVED + ("excused",):
            row["end"], row["by"] = "excused", reason
        elif row["end"] == "excused":
            row["end"] = "untried"


def counts(rows):
    ends = [row["end"] for row in rows]
    noticed = sum(ends.count(e) for e in NOTICED)
    survived = sum(ends.count(e) for e in SURVIVED)
    return noticed, survived, ends.count("hangs"), ends.count("excused")


def share(noticed, survived):
    return f"{100 * noticed / (noticed + survived):.0f} %" if noticed + survived else "-"


def share_table(rows, group, head):
    """A line a group and one of all."""
    yield f"| {head} | mutants | noticed | share | by a time limit alone | excused |"
    yield "|---|---|---|---|---|---|"
    names = sorted({group(row) for row in rows})
    for name in names + (["all"] if len(names) > 1 else []):
        noticed, survived, hangs, excused = counts(
            [row for row in rows if name == "all" or group(row) == name])
        yield (f"| {name} | {noticed + survived} | {noticed} | {share(noticed, survived)} "
               f"| {hangs} | {excused} |")


def cell(text):
    return "`" + re.sub(r"\|", r"\\|", text) + "`"


def survivors(rows, ends=SURVIVED, last="tests that ran"):
    found = [row for row in rows if row["end"] in ends]
    if not found:
        return
    yield f"| where | function | kind | change | {last} |"
    yield "|---|---|---|---|---|"
    for row in sorted(found, key=lambda r: (r["file"], int(r["line"]))):
        told = row["by"] if "excused" in ends else f"{row['ran']} of {row['covering']}"
        yield (f"| {row['file']}:{row['line']} | {row['function']} | {row['kind']} "
               f"| {cell(row['old'])} to {cell(row['new'])} | {told} |")


def room(row):
    return os.path.dirname(row["file"])


PAGE = """# Mutants

Made by `tools/faults --mutants-summary doc/mutants/*.csv`. A mutant is one small change of one
line, made by a program (`tools/mutants/changes.py`): a comparison turned, `and` for `or`, a
condition or a sign turned, a constant or an index changed, a call left out. A few are drawn
in each file; those that compile to the same code are none. Each is built in a copy of the
sources, and the tests that reach its function run, cheapest first, until one fails: those of
`ctest` without the slow ones and without the checks of `clothbench verify`.

"Excused": it changes nothing that counts, for the reason that stands in `tests/survivors.txt`;
such mutants are in neither of the other columns. "By a time limit alone": it never ends, and
the test's time limit is who says so.
"""


def summary(paths, excuses):
    rows = list({key: row for path in paths for key, row in load(path).items()}.values())
    mark_excused(rows, excuses)
    yield PAGE
    yield from share_table(rows, room, "folder")
    yield "\n## By file\n"
    yield from share_table(rows, lambda row: row["file"], "file")
    for title, ends, last in (("Survivors", SURVIVED, "tests that ran, of those that reach it"),
                              ("Excused", ("excused",), "reason")):
        table = list(survivors(rows, ends, last))
        if table:
            yield f"\n## {title}\n"
            yield from table
