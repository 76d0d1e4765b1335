#!/usr/bin/env python3
"""Mutants of C files and who notices them; see tools/faults --help."""
import argparse
import collections
import os
import queue
import random
import re
import sys
import threading

import changes
import copied
import coverage
import results

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRATCH = os.path.join(TOP, "build-faults")
VERIFY = "verify."  # claims about the numerics: what reads and judges has tests of its own
WAIT = 20  # seconds more than ten times a test's own before it is said to hang


def free_copy():
    """The first copy that nobody uses."""
    for number in range(64):
        try:
            copy = copied.Copy(TOP, os.path.join(SCRATCH, f"mutants-{number}"))
        except OSError:
            continue
        copy.bring()
        copy.configure()
        return copy
    raise SystemExit("64 copies are in use")


class Trial:
    """What all copies share: the map, the rows, which tests are sound."""

    def __init__(self, o, commit):
        self.o, self.commit = o, commit
        self.map = coverage.load(o.covered)
        self.excuses = results.Excuses(TOP)
        self.lock = threading.Lock()
        self.sound, self.unsound, self.rows = set(), set(), []
        self.told = collections.Counter()  # (file, test): mutants that it noticed

    def seconds(self, name):
        return self.map["tests"].get(name, {"seconds": 0})["seconds"]

    def covering(self, mutant, tests):
        """Tests to run, in order: first those that the map does not know as they are."""
        functions = self.map["functions"].get(mutant.file)
        unknown = {name for name, test in tests.items()
                   if self.map["tests"].get(name, {}).get("hash") != test.hash}
        if functions is None:
            known = set(tests)
        elif mutant.function in functions:
            known = set(functions[mutant.function])
        else:  # a table's values, or younger than the map
            known = {name for names in functions.values() for name in names}
        wanted = [n for n in tests if (n in unknown or n in known) and n not in self.unsound
                  and re.search(self.o.tests, n)
                  and (self.o.verify or not n.startswith(VERIFY))]
        return sorted(wanted, key=lambda n: (
            self.seconds(n) > self.o.longest, n not in unknown,
            (0.1 + self.seconds(n)) / (1 + self.told[mutant.file, n])))

    def tell(self, mutant, end, by="", ran=0, covering=0, seconds=0.0):
        row = dict(mutant._asdict(), end=end, by=by, ran=ran, covering=covering,
                   seconds=round(seconds, 1), commit=self.commit)
        with self.lock:
            self.rows.append(row)
            self.told[mutant.file, by] += end in results.NOTICED
            if self.o.results:
                results.append(self.o.results, row)
            if end not in ("same", "does not compile"):
                print(f"{end.upper() if end in results.SURVIVED else end:9} "
                      f"{mutant.file}:{mutant.line}: {mutant.kind}: {mutant.old}  ->  "
                      f"{mutant.new}  ({by + ', ' if by else ''}{ran} of {covering} tests, "
                      f"{seconds:.0f} s)", flush=True)


class Worker(threading.Thread):
    """Plants mutants in a copy of its own until none is left."""

    def __init__(self, trial, copy, mutants):
        super().__init__(daemon=True)
        self.trial, self.copy, self.mutants = trial, copy, mutants
        self.tests, self.codes = copy.tests(), {}

    def run(self):
        while True:
            try:
                mutant = self.mutants.get_nowait()
            except queue.Empty:
                return
            self.try_mutant(mutant)

    def write(self, mutant, text):
        with open(os.path.join(self.copy.source, mutant.file), "w") as source:
            source.write(text)

    def try_mutant(self, mutant):
        with open(os.path.join(self.copy.source, mutant.file)) as source:
            text = source.read()
        why = self.trial.excuses.why(mutant.file, mutant.old, mutant.new)
        if why:
            self.trial.tell(mutant, "excused", why)
            return
        if mutant.file not in self.codes:
            self.codes[mutant.file] = self.copy.code(mutant.file)
        try:
            self.write(mutant, changes.planted(text, mutant))
            code = self.copy.code(mutant.file)
            if code in (None, self.codes[mutant.file]) and mutant.file in self.copy.objects:
                self.trial.tell(mutant, "same" if code else "does not compile")
            else:
                self.run_tests(mutant, text)
        finally:
            self.write(mutant, text)

    def run_tests(self, mutant, text):
        tests = self.trial.covering(mutant, self.tests)
        ran = spent = 0
        for name in tests:
            if ran and spent + self.trial.seconds(name) > self.trial.o.limit:
                continue
            end, seconds = self.run_test(name)
            if end == "does not compile":
                self.trial.tell(mutant, end)
                return
            ran, spent = ran + 1, spent + seconds
            if end != "passed" and self.is_sound(name, mutant, text):
                end = "noticed" if end == "failed" else end
                self.trial.tell(mutant, end, name, ran, len(tests), spent)
                return
        self.trial.tell(mutant, "survived" if tests else "unreached", "", ran, len(tests), spent)

    def run_test(self, name):
        if self.copy.make(self.tests[name].programs).returncode:
            return "does not compile", 0
        limit = 10 * self.trial.seconds(name) + WAIT
        return self.copy.test(name, min(limit, self.tests[name].limit))

    def is_sound(self, name, mutant, text):
        """Does it pass without the mutant? Asked once a test."""
        trial = self.trial
        if name not in trial.sound and name not in trial.unsound:
            self.write(mutant, text)
            end, _ = self.run_test(name)
            self.write(mutant, changes.planted(text, mutant))
            (trial.sound if end == "passed" else trial.unsound).add(name)
            if end != "passed":
                print(f"{name} fails without a mutant and is left out", file=sys.stderr)
        return name in trial.sound


def drawn(o):
    """The mutants to try; those that the results tell already are not tried again."""
    mutants = []
    for file in o.files:
        found = list(changes.mutants_of(TOP, file))
        if o.most_per_file and o.most_per_file < len(found):
            found = random.Random(f"{o.seed} {file}").sample(found, o.most_per_file)
        mutants += found
    if o.most and o.most < len(mutants):
        mutants = random.Random(o.seed).sample(mutants, o.most)
    known = results.load(o.results)
    if o.again:
        mutants = [m for file in o.files for m in changes.mutants_of(TOP, file)
                   if known.get(m.key(), {"end": ""})["end"] in results.SURVIVED]
    else:
        mutants = [m for m in mutants if m.key() not in known]
    return sorted(mutants)


def arguments():
    parser = argparse.ArgumentParser(prog="tools/faults --mutants", add_help=False)
    parser.add_argument("mode", choices=("mutants", "coverage", "mutants-summary", "check"))
    parser.add_argument("files", nargs="*")
    parser.add_argument("--most", type=int, default=0)
    parser.add_argument("--most-per-file", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tests", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--covered", default=os.path.join(SCRATCH, "coverage.json"))
    parser.add_argument("--results", default="")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--longest", type=float, default=20)
    parser.add_argument("--limit", type=float, default=120)
    parser.add_argument("--verify", action="store_true")
    parser.add_argument("--list", action="store_true")
    return parser.parse_intermixed_args()


def try_all(o):
    mutants = drawn(o)
    if o.list:
        for m in mutants:
            print(f"{m.file}:{m.line}: {m.function}: {m.kind}: {m.old}  ->  {m.new}")
        return 0
    if not os.path.exists(o.covered):
        raise SystemExit(f"there is no {o.covered}: tools/faults --coverage makes it")
    commit = copied.run(["git", "describe", "--always", "--dirty"], cwd=TOP).stdout.strip()
    trial, waiting = Trial(o, commit), queue.Queue()
    for mutant in mutants:
        waiting.put(mutant)
    workers = [Worker(trial, free_copy(), waiting) for _ in range(min(o.jobs, len(mutants)))]
    try:
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
    finally:
        for worker in workers:
            worker.copy.close()
    rows = [dict(row) for row in trial.rows]
    if o.results and os.path.exists(o.results):
        there_are = {m.key() for file in o.files for m in changes.mutants_of(TOP, file)}
        known = [row for key, row in results.load(o.results).items()
                 if row["file"] not in o.files or key in there_are]  # not of lines that went
        results.rewrite(o.results, known)
        rows = [row for row in known if row["file"] in o.files]
    results.mark_excused(rows, trial.excuses)
    print("\n".join(["", *results.share_table(rows, lambda row: row["file"], "file"), "",
                     *results.survivors(rows)]))
    return 2 if results.counts(rows)[1] else 0


def main():
    o = arguments()
    if o.mode == "coverage":
        os.makedirs(SCRATCH, exist_ok=True)
        wanted = re.compile(o.tests) if o.tests else None
        coverage.make_map(TOP, SCRATCH, o.covered, o.jobs, wanted)
        return 0
    excuses = results.Excuses(TOP)
    if o.mode == "mutants-summary":
        print("\n".join(results.summary(o.files, excuses)))
        return 0
    if o.mode == "check":
        stale = list(excuses.stale(TOP))
        print("\n".join(stale), end="\n" if stale else "")
        return 2 if stale else 0
    return try_all(o)


if __name__ == "__main__":
    sys.exit(main())
