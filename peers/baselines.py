#!/usr/bin/env python3
"""Rows of peers/baselines.csv: writes those of a run, or reads the file and says what is wrong.

    baselines.py rows KEY=VALUE... score.json     # what `score --format json` printed
    baselines.py rows KEY=VALUE... --failed WORDS # it did not get that far
    baselines.py check FILE
"""
import csv
import json
import math
import pathlib
import sys

# error, bar and floor are rms over the sheet as fractions of its length; time, step and seconds
# in s. A run that failed has one row without numbers, and its sentence as diagnosis.
COLUMNS = ["simulator", "version", "scene", "net", "step", "time", "error", "bar", "floor",
           "seconds", "diagnosis", "date"]
UNEXPLAINED = "No flaw that is known here explains the difference."
JUDGED = ["time", "error", "bar", "floor"]


def score_rows(about, score):
    """about: the other columns. The diagnosis stands at the last time, which it is about."""
    said = " ".join(d["text"] for d in score["diagnosis"]) or UNEXPLAINED
    about = {**about, "seconds": f"{float(about['seconds']):.4g}"}
    for k, judged in enumerate(score["rows"]):
        last = k == len(score["rows"]) - 1
        yield {**about, **{c: f"{judged[c]:.6g}" for c in JUDGED}, "diagnosis": said * last}


def failed_rows(about, words):
    yield {**about, **dict.fromkeys(JUDGED, ""), "seconds": "", "diagnosis": " ".join(words.split())}


def write(rows, file):
    csv.DictWriter(file, COLUMNS, lineterminator="\n").writerows(rows)


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
    if not any(row[c] for c in JUDGED):
        return "" if row["diagnosis"] else "neither judged nor a sentence why not"
    for c in JUDGED + ["step", "seconds"]:
        try:
            value = float(row[c])
        except ValueError:
            value = math.nan
        if not (math.isfinite(value) and value >= 0):
            return f"{c} is '{row[c]}'; it is to be a number from 0"
    return ""


def main(words):
    if len(words) == 2 and words[0] == "check":
        try:
            print(f"{len(read(words[1]))} rows")
        except (OSError, ValueError) as e:
            sys.exit(str(e))
        return
    if len(words) < 2 or words[0] != "rows":
        sys.exit(__doc__)
    about = {c: "" for c in COLUMNS}
    rest = words[1:]
    while rest and rest[0].partition("=")[0] in COLUMNS:
        key, _, about[key] = rest.pop(0).partition("=")
    if rest[:1] == ["--failed"]:
        write(failed_rows(about, " ".join(rest[1:])), sys.stdout)
    else:
        write(score_rows(about, json.loads(pathlib.Path(rest[0]).read_text())), sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1:])
