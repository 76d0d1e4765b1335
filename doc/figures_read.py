"""Reads doc/results/, and writes numbers and tables as the pages have them (doc/figures).

doc/results/NAME.csv is what a command printed with --format csv, behind a line that says which
command, commit, processor and day (doc/refresh).
"""
import csv
import functools
import io
import pathlib
import re

TOP = pathlib.Path(__file__).resolve().parent.parent
RESULTS = TOP / "doc" / "results"

# --- reading ---------------------------------------------------------------------------------


class Missing(Exception):
    """A table that a result does not have: one of a quick run may lack it."""

    def __init__(self, name, what):
        super().__init__(f"doc/results/{name}.csv has no {what}")
        self.quick = is_quick(RESULTS / f"{name}.csv")


def is_quick(path):
    return "--quick" in path.read_text().partition("\n")[0]


def whole(name):
    """Stops who needs more than a quick run has."""
    if is_quick(RESULTS / f"{name}.csv"):
        raise Missing(name, "row but those of a quick run")


@functools.cache
def tables(path):
    """Of a file: [(caption, rows)], a row a dict of its cells."""
    found, caption, lines = [], "", []

    def end():
        if lines:
            rows = csv.DictReader(io.StringIO("\n".join(lines)))
            found.append((caption, [{key: "" if cell == "nan" else cell  # of older results
                                     for key, cell in r.items()} for r in rows]))
        lines.clear()

    for line in path.read_text().splitlines():
        if line.startswith("#"):
            end()
            caption = line[2:]
        elif line:
            lines.append(line)
        else:
            end()
    end()
    return found


def result(name):
    return tables(RESULTS / f"{name}.csv")


def part(name, words, column):
    """The rows of the table whose caption has these words and which has the column."""
    for caption, rows in result(name):
        if words in caption and column in rows[0]:
            return rows
    raise Missing(name, f"table '{words}' with {column}")


def row(rows, **cells):
    for r in rows:
        if all(r[key] == want for key, want in cells.items()):
            return r
    raise KeyError(f"no row {cells}")


def number(text):
    """A cell's; NaN where it is empty, as a number that does not exist is."""
    return float(text or "nan")


# --- writing ---------------------------------------------------------------------------------


def digits(value, count):
    """So many significant ones, without an exponent."""
    text = f"{float(value):#.{count}g}"
    return f"{float(text):.0f}" if "e+" in text else text.rstrip(".")


def percent(value):
    """Of a number in per cent; above 99 and below 100 the nines are told."""
    return digits(value, 3 if 99 <= value < 100 else 2) + " %"


def markdown(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return "\n".join(lines + ["| " + " | ".join(r) + " |" for r in rows]) + "\n"
