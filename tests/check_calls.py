#!/usr/bin/env python3
"""Calls between rooms run one way: no room calls another that, by others or not, calls it; and
tables are written by bench/data alone: other rooms fill datasets and hand them to a printer.

    check_calls.py TOP NM LIBRARY...

A room is a folder of the sources; bench/verify with its checks is one. Which object calls which
is read from the libraries' symbols, so that a function that is only declared in a room above is
seen, too.
"""
import collections
import pathlib
import subprocess
import sys

ONE_ROOM = {"bench/verify/checks": "bench/verify", "bench/harness/mpi": "bench/harness"}


def rooms_of(top):
    """Rooms by the name of a source file, and whether it is in bench: {(False, "grid.c"): ...}."""
    rooms = collections.defaultdict(set)
    for path in pathlib.Path(top).rglob("*.c"):
        folder = path.parent.relative_to(top).as_posix()
        if not folder.startswith(("build", "tests", "doc", "results", ".")):
            rooms[folder.startswith("bench"), path.name].add(ONE_ROOM.get(folder, folder))
    return rooms


def main():
    top, nm, *libraries = sys.argv[1:]
    rooms, room_of, calls, faults = rooms_of(top), {}, collections.defaultdict(set), 0
    lines = [line for library in libraries for line in subprocess.run(
        [nm, "-A", "-P", "-g", library], capture_output=True, text=True, check=True).stdout.splitlines()]
    seen = []
    for line in lines:  # libcloth_x.a[grid.c.o]: name T ...
        place, name, kind, *_ = line.replace(": ", " ").split()
        library, source = place.rstrip("]").removesuffix(".o").split("[")
        own = rooms["_bench" in library, source]
        if len(own) != 1:
            print(f"{source} is in {len(own)} rooms")
            return 1
        (room,) = own
        seen.append((room, source, name, kind))
        if kind != "U":
            room_of[name] = room
    for room, source, name, kind in seen:
        if kind == "U" and name in room_of and room_of[name] != room:
            calls[room].add(room_of[name])
        if kind == "U" and name.startswith("table_") and room != "bench/data":
            print(f"{source} of {room} calls {name}: printer_table writes tables")
            faults += 1

    def reached(room):
        found, wait = set(), [room]
        while wait:
            for other in calls[wait.pop()] - found:
                found.add(other)
                wait.append(other)
        return found

    for room in sorted(room for room in list(calls) if room in reached(room)):
        others = sorted(other for other in reached(room) if room in reached(other) and other != room)
        print(f"{room} calls what calls it: {', '.join(others)}")
        for where, source, name, kind in seen:
            if kind == "U" and where == room and room_of.get(name) in others:
                print(f"    {source}: {name} of {room_of[name]}")
        faults += 1
    print(f"{len(seen)} symbols, {sum(map(len, calls.values()))} pairs of rooms, {faults} faults")
    return faults > 0 or not seen


if __name__ == "__main__":
    sys.exit(main())
