#!/usr/bin/env python3
"""peers/third without CalculiX: the decks of today are those of the thirds that are stored, and
another deck is told; points are where an S8R has them.
    peers_third.py PROGRAM FOLDER-OF-peers
"""
import importlib.machinery
import importlib.util
import pathlib
import sys

from checks import check, finish, says

sys.dont_write_bytecode = True
program, peers = sys.argv[1], pathlib.Path(sys.argv[2])
loader = importlib.machinery.SourceFileLoader("third", str(peers / "third"))
third = importlib.util.module_from_spec(importlib.util.spec_from_loader("third", loader))
loader.exec_module(third)


def decks(name):
    third.check(program, name)
    check(f"{name}: decks are those of what is stored", True)


def other_decks(book):
    """Refuses what is stored of the book's first scene where its coarsest net is another one."""
    name, kept = next(iter(book.items()))
    (along, across), *finer = kept[0]
    book[name] = [(along + 10, across), *finer], *kept[1:]
    says(f"{name}: another net", SystemExit, "of another deck", third.check, program, name)
    book[name] = kept


def shapes():
    """All quadratics but u^2 v^2 are an S8R's own."""
    for a, b in (0, 0), (.3, .7), (1, .25):
        weights = third.drive.shape(a, b)
        for what in (lambda u, v: 1, lambda u, v: u, lambda u, v: u * v * v, lambda u, v: v * v):
            own = sum(w * what(u, v) for w, (u, v) in zip(weights, third.drive.SHARES))
            check(f"a quadratic at {a}, {b}", abs(own - what(a, b)) < 1e-12)


shapes()
for path in sorted((peers.parent / "bench" / "truths" / "third").glob("*.h5")):
    decks(path.stem)
for name in third.TABLES:
    decks(name)
for book in third.TABLES, third.NETS:
    other_decks(book)
finish()
