#!/usr/bin/env python3
"""Mutants of C files, one at a time, and who notices them: tools/faults --mutants calls this.

A mutant is one small change of one line of code: a comparison turned, an `and` made an `or`,
a sign, a constant, an index moved by one, a call left out. It is planted in a copy of the
sources and built; what does not compile, or compiles to the same machine code, is no mutant.
Then the tests run until the first that fails. Survivors are told: each wants a test, or a
reason why it changes nothing.
"""
import argparse
import hashlib
import os
import random
import re
import subprocess
import sys

# What a line loses before it is changed: strings stay as they are.
STRING = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'')
CHANGES = [  # kind, pattern, what takes its place
    ("comparison", r"(?<![-<>=!])(<|>)(?![<>=])", {"<": ">=", ">": "<="}),
    ("comparison", r"(<=|>=|==|!=)", {"<=": ">", ">=": "<", "==": "!=", "!=": "=="}),
    ("logic", r"(&&|\|\|)", {"&&": "||", "||": "&&"}),
    ("sign", r"(?<=[\w)\]] )([+-])(?= [\w(])", {"+": "-", "-": "+"}),
    ("constant", r"(?<![\w.])(\d+)(?![\w.])", lambda n: str(int(n) + 1)),
    ("constant", r"(?<![\w.])(\d+\.\d*|\d+e-?\d+|\d*\.\d+e-?\d+)(?![\w.])",
     lambda x: "(%s * 1.5)" % x),
    ("index", r"\[(\w+)\](?! *=[^=])", lambda i: "[%s + 1]" % i),
    ("call", r"^\s+(?:TRY\()?\w+\(.*\);$", lambda call: "    ;"),
]
# Tests that say nothing of a mutant: of style, of the machine, or by luck of its speed.
LEFT_OUT = "^(external|slow|bench|style)$"


# Room alone: more of it changes nothing.
ROOM = re.compile(r"^\s+(static |const |enum )*(double|float|int|long|char|bool|size_t|hsize_t"
                  r"|struct \w+|\{)[^=()]*;$|[mc]alloc\(|snprintf\(|realloc\(")


def code_lines(text):
    """Numbers of the lines that hold code inside functions."""
    inside = comment = False
    for number, line in enumerate(text):
        bare = line.strip()
        if comment or bare.startswith("/*"):
            comment = "*/" not in line
            continue
        if line.startswith("{"):
            inside = True
        elif line.startswith("}"):
            inside = False
        elif inside and bare and not bare.startswith(
                ("#", "*", "//", "case ", "assert(")) and not ROOM.search(line):
            yield number


def changes_of(line):
    """Every change of one line: kind and new line."""
    hidden = STRING.sub(lambda m: '"' + "\1" * (len(m.group()) - 2) + '"', line)
    hidden = re.sub(r"/\*.*?\*/", lambda m: " " * len(m.group()), hidden)
    for kind, pattern, put in CHANGES:
        for m in re.finditer(pattern, hidden):
            if kind == "call":
                yield kind, put(m.group())
                continue
            old = m.group(1)
            new = put[old] if isinstance(put, dict) else put(old)
            if kind == "index":
                yield kind, line[: m.start()] + new + line[m.end() :]
            else:
                yield kind, line[: m.start(1)] + new + line[m.end(1) :]


def all_mutants(top, files):
    for file in files:
        with open(os.path.join(top, file)) as source:
            text = source.read().split("\n")
        for number in code_lines(text):
            for kind, new in changes_of(text[number]):
                if new != text[number]:
                    yield file, number, kind, text[number], new


class Copy:
    """The sources and a build of them, with shared libraries: one link serves all tests."""

    def __init__(self, source, build, jobs, tests):
        self.source, self.build, self.jobs, self.tests = source, build, jobs, tests

    def run(self, command, seconds):
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=seconds)

    def make(self):
        return self.run(["cmake", "--build", self.build, "--parallel", self.jobs], 900)

    def object_hash(self, file):
        name = os.path.splitext(file)[0] + ".c.o"
        for folder, _, names in os.walk(os.path.join(self.build, "CMakeFiles")):
            path = os.path.join(folder, os.path.basename(name))
            if os.path.basename(name) in names and path.endswith(name):
                code = self.run(["objcopy", "-O", "binary", "--strip-debug", path, path + ".code"],
                                60)
                if code.returncode:
                    return None
                with open(path, "rb") as content:
                    return hashlib.sha256(content.read()).hexdigest()
        return None

    def failing(self):
        """The first test that fails, or None."""
        command = ["ctest", "--test-dir", self.build, "-LE", LEFT_OUT, "--stop-on-failure",
                   "--parallel", self.jobs, "--timeout", "120"]
        if self.tests:
            command += ["-R", self.tests]
        try:
            said = self.run(command, 1800).stdout
        except subprocess.TimeoutExpired:
            return "time limit"
        failed = re.search(r"^\s*\d+ - (\S+) \(", said, re.M)
        return failed.group(1) if failed else None


def try_mutant(copy, sound, mutant):
    """How it ends: 'same', 'does not compile', the test that noticed, or None."""
    file, number, _, _, new = mutant
    path = os.path.join(copy.source, file)
    with open(path) as source:
        text = source.read()
    lines = text.split("\n")
    lines[number] = new
    with open(path, "w") as source:
        source.write("\n".join(lines))
    try:
        if copy.make().returncode:
            return "does not compile"
        if copy.object_hash(file) == sound[file]:
            return "same"
        return copy.failing()
    finally:
        with open(path, "w") as source:
            source.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("source", help="a copy of the sources, to be changed")
    parser.add_argument("build", help="a build of it that was configured")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--most", type=int, default=0, help="mutants, drawn at random (all)")
    parser.add_argument("--seed", type=int, default=1, help="of the draw")
    parser.add_argument("--tests", default="", help="as ctest -R (all but the slow ones)")
    parser.add_argument("--jobs", default="2")
    parser.add_argument("--list", action="store_true", help="print the mutants, plant none")
    o = parser.parse_args()

    mutants = list(all_mutants(o.source, o.files))
    if o.most and o.most < len(mutants):
        mutants = sorted(random.Random(o.seed).sample(mutants, o.most))
    if o.list:
        for file, number, kind, _, new in mutants:
            print(f"{file}:{number + 1}: {kind}: {new.strip()}")
        return 0
    copy = Copy(o.source, o.build, o.jobs, o.tests)
    made = copy.make()
    if made.returncode:
        sys.exit("does not compile without a mutant:\n" + made.stdout[-2000:])
    failed = copy.failing()
    if failed:
        sys.exit(f"{failed} fails without a mutant")
    sound = {file: copy.object_hash(file) for file in o.files}
    counted = noticed = 0
    for mutant in mutants:
        file, number, kind, old, new = mutant
        end = try_mutant(copy, sound, mutant)
        if end in ("same", "does not compile"):
            continue
        counted += 1
        noticed += end is not None
        print(f"{'SURVIVED' if end is None else 'noticed':9}{file}:{number + 1}: {kind}: "
              f"{old.strip()}  ->  {new.strip()}{'' if end is None else '  by ' + end}",
              flush=True)
    print(f"{noticed} of {counted} mutants were noticed")
    return 0 if noticed == counted else 2


if __name__ == "__main__":
    sys.exit(main())
