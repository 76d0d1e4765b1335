#!/usr/bin/env python3
"""Rows of peers/baselines.csv: those of a run (runs.py), and the file that is kept.

    baselines.py check FILE
    baselines.py head               # the columns
    baselines.py merge FILE ROWS    # what was run takes the place of what the file had of it
    baselines.py protocol FILE ROWS # the same of peers/protocol.csv, by simulator
"""
import csv
import math
import re
import sys

# error, bar and floor are rms over the sheet as fractions of its length; time, step and seconds
# in s. A run that died has a last row without an error, with the time of its death; one that was
# refused has that row only, without a time. Both have their sentence as diagnosis.
COLUMNS = ["simulator", "version", "scene", "net", "step", "time", "error", "bar", "floor",
           "seconds", "diagnosis", "date"]
HEAD = ",".join(COLUMNS)
UNEXPLAINED = "No flaw that is known here explains the difference."
FORMULA = re.compile(r"[=@\t\r].|[+-]([a-zA-Z]|.*[|(])", re.S)
JUDGED = ["time", "error", "bar", "floor"]


def score_rows(about, score):
    """The diagnosis stands at the last time, which it is about."""
    said = " ".join(d["text"] for d in score["diagnosis"]) or UNEXPLAINED
    for k, judged in enumerate(score["rows"]):
        last = k == len(score["rows"]) - 1
        yield {**about, **{c: f"{judged[c]:.6g}" for c in JUDGED}, "diagnosis": said * last}


def case_rows(about, told, score):
    """about: columns that all rows have; told: what a driver said, with "died" [s] and "why", or
    "refused"; score: an object of `score --format json`, or None where there are no frames."""
    about = {**about, "version": told["version"]}
    refused = told.get("refused") or (score or {}).get("refused")
    none = {**about, **dict.fromkeys([*JUDGED, "seconds"], "")}
    if refused:
        yield {**none, "diagnosis": " ".join(refused.split())}
        return
    about["seconds"] = f"{told['seconds']:.4g}"
    if score:
        yield from score_rows(about, score)
    if "died" in told:
        why = told.get("why", "vertices are not finite, or further off than any fall takes them")
        yield {**none, "time": f"{told['died']:.6g}", "diagnosis": f"Died at {told['died']:.3g} s: "
               f"{' '.join(why.split())}."}


def write(rows, file, columns=None):
    """Puts lines with these columns, which are then their head too; what others' programs said is no
    formula of a spreadsheet (bench/data/table.c)."""
    to = csv.DictWriter(file, columns or COLUMNS, lineterminator="\n")
    if columns:
        to.writeheader()
    for row in rows:
        to.writerow({key: "'" + text if FORMULA.match(text) else text for key, text in row.items()})


def read(path):
    """Its rows as dicts of text; ValueError with file and line at what is not a baseline."""
    with open(path, newline="") as file:
        lines = list(csv.reader(file))
    if not lines or lines[0] != COLUMNS:
        raise ValueError(f"{path}:1: the columns are to be {','.join(COLUMNS)}")
    found = []
    for number, cells in enumerate(lines[1:], 2):
        if len(cells) != len(COLUMNS):
            raise ValueError(f"{path}:{number}: {len(cells)} cells; there are {len(COLUMNS)} columns")
        found.append(dict(zip(COLUMNS, cells)))
        wrong = fault(found[-1])
        if wrong:
            raise ValueError(f"{path}:{number}: {wrong}")
    if not found:
        raise ValueError(f"{path}: has no rows")
    return found


def fault(row):
    """What is wrong with a row, or ''."""
    empty = [c for c in ("simulator", "version", "scene", "net", "step", "date") if not row[c]]
    if empty:
        return f"{empty[0]} is empty"
    if not row["error"]:
        return "" if row["diagnosis"] else "neither judged nor a sentence why not"
    for c in JUDGED + ["step", "seconds"]:
        try:
            value = float(row[c])
        except ValueError:
            value = math.nan
        if not (math.isfinite(value) and value >= 0):
            return f"{c} is '{row[c]}'; it is to be a number from 0"
    return ""


def case_of(row):
    return row["simulator"], row["net"], row["step"], row["scene"]


def merged(kept, made):
    """Rows of both, made ones in place of kept ones of the same case and scene; new cases at the
    end, new scenes after the others of their case."""
    new = {case_of(r) for r in made}
    groups = {}
    for row in [r for r in kept if case_of(r) not in new] + made:
        groups.setdefault(case_of(row), []).append(row)
    order = list(dict.fromkeys(case_of(r) for r in kept + made))
    cases = list(dict.fromkeys(case[:3] for case in order))
    scenes = list(dict.fromkeys(case[3] for case in order))
    order.sort(key=lambda case: (cases.index(case[:3]), scenes.index(case[3])))
    return [row for case in order for row in groups[case]]


def keep_protocol(path, made):
    """Puts the rows of a file into another, in place of those of the same simulators."""
    with open(made, newline="") as file:
        rows = list(csv.DictReader(file))
    ran = {row["simulator"] for row in rows}
    try:
        with open(path, newline="") as file:
            kept = list(csv.DictReader(file))
    except FileNotFoundError:
        kept = []
    order = list(dict.fromkeys(row["simulator"] for row in kept + rows))  # each stays in its place
    rows += [row for row in kept if row["simulator"] not in ran]
    with open(path, "w", newline="") as file:
        write(sorted(rows, key=lambda row: order.index(row["simulator"])), file, list(rows[0]))


def main(words):
    try:
        if words[:1] == ["check"] and len(words) == 2:
            print(f"{len(read(words[1]))} rows")
        elif words[:1] == ["merge"] and len(words) == 3:
            rows = merged(read(words[1]), read(words[2]))
            with open(words[1], "w", newline="") as file:
                file.write(HEAD + "\n")
                write(rows, file)
        elif words[:1] == ["protocol"] and len(words) == 3:
            keep_protocol(words[1], words[2])
        elif words == ["head"]:
            print(HEAD)
        else:
            sys.exit(__doc__)
    except (OSError, ValueError) as e:
        sys.exit(str(e))


if __name__ == "__main__":
    main(sys.argv[1:])
