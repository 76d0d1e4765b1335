"""A copy of the sources, a build of it, its tests: what is changed is never the original."""
import fcntl
import filecmp
import hashlib
import json
import os
import re
import resource
import shutil
import subprocess
import time
from typing import NamedTuple

TEST = re.compile(r"^add_test\(\[=\[(.*?)\]=\](.*)\)$", re.M)
ARGUMENT = re.compile(r'"((?:[^"\\]|\\.)*)"')
TIMES = re.compile(r"(\d+)m([\d.]+)s")
# Tests that say nothing of a mutant: of style, of the machine.
LEFT_OUT = {"external", "slow", "bench", "style"}
MEMORY = 12 << 30  # bytes at most, of each process


class Test(NamedTuple):
    programs: tuple  # targets it needs
    hash: str  # of its own sources
    limit: float  # seconds, ctest's
    alone: bool


def run(command, **more):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", **more)


# A mutant may signal anyone, leave processes behind, replace /dev/full: its tests see no
# others, write to nothing but the copy ($1) and a /tmp in it ($2), and end with us.
APART = """set -e
copy=$1
tmp=$2
shift 2
cd "$copy"
mount --make-rprivate /
inside=$copy
case $copy in /tmp/*) inside=$tmp/${copy#/tmp/} ;; esac
mkdir -p "$inside"
mount --bind "$copy" "$inside"
mount --rbind "$tmp" /tmp
mount -o remount,bind,ro /
mount -o remount,bind,ro /dev
cd "$copy"
set +e
"$@"
code=$?
times
exit $code
"""


def apart(folder, tmp):
    """The beginning of a command that is to run so; tmp: a folder in it."""
    for user in ([], ["--user", "--map-root-user"]):
        command = ["setpriv", "--pdeathsig", "KILL", "unshare", *user, "--mount", "--pid",
                   "--fork", "--kill-child", "--mount-proc", "sh", "-c", APART, "sh", folder, tmp]
        if run([*command, "true"]).returncode == 0:
            return command
    raise SystemExit("no namespaces of its own can be had (unshare): a mutant could do harm")


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


class Copy:
    """In a folder that no other process uses meanwhile: source, build, tmp."""

    def __init__(self, top, folder):
        self.top, self.folder = top, folder
        self.source, self.build, self.tmp = (
            os.path.join(folder, name) for name in ("source", "build", "tmp"))
        os.makedirs(folder, exist_ok=True)
        self.lock = open(os.path.join(folder, "lock"), "w")
        fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        self.environment = dict(os.environ, TMPDIR="/tmp")
        os.makedirs(self.tmp, exist_ok=True)
        self.apart = apart(folder, self.tmp)

    def close(self):
        shutil.rmtree(self.tmp, ignore_errors=True)
        self.lock.close()

    def bring(self):
        """Files that differ get a new time stamp; those that are no more go."""
        shutil.rmtree(self.tmp, ignore_errors=True)
        listed = run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                     cwd=self.top, check=True).stdout
        names = listed.split("\0")
        wanted = {n for n in names if n and os.path.isfile(os.path.join(self.top, n))}
        for folder, _, files in os.walk(self.source):
            for name in files:
                path = os.path.join(folder, name)
                if os.path.relpath(path, self.source) not in wanted:
                    os.remove(path)
        for name in wanted:
            mine, theirs = os.path.join(self.source, name), os.path.join(self.top, name)
            if not os.path.exists(mine) or not filecmp.cmp(mine, theirs, shallow=False):
                os.makedirs(os.path.dirname(mine), exist_ok=True)
                shutil.copy(theirs, mine)

    def configure(self, launcher="ccache", linked=""):
        """A release's build; `linked`: more flags of the linker."""
        found = shutil.which(launcher)
        launchers = [f"-DCMAKE_C_COMPILER_LAUNCHER={found}"] if found else []
        fast = "-fuse-ld=lld " if shutil.which("ld.lld") else ""
        done = run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja",
                    "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                    f"-DCMAKE_EXE_LINKER_FLAGS={fast}{linked}", *launchers], env=self.environment)
        if done.returncode:
            raise SystemExit("cannot be configured:\n" + done.stdout[-2000:])
        with open(os.path.join(self.build, "compile_commands.json")) as text:
            commands = json.load(text)
        self.objects, self.sources = {}, {}  # of a file, of a program
        for entry in commands:
            file = os.path.relpath(entry["file"], self.source)
            output = entry.get("output") or re.search(r" -o (\S+)", entry["command"]).group(1)
            self.objects.setdefault(file, []).append(output)
            program = re.search(r"CMakeFiles/([^/]+)\.dir/", output).group(1)
            self.sources.setdefault(program, []).append(entry["file"])
        self.targets = set(re.findall(r"^([^:\s]+):", run(
            ["ninja", "-C", self.build, "-t", "targets", "all"]).stdout, re.M))

    def programs(self, arguments):
        """Those that a test's command names; the sweeps look for the MPI program beside."""
        found = {os.path.relpath(a, self.build) for a in arguments
                 if a.startswith(self.build + "/")} & self.targets
        found = found or {"clothbench"}
        if "clothbench" in found and "clothbench_mpi" in self.targets:
            found.add("clothbench_mpi")
        return tuple(sorted(found))

    def hash_of(self, arguments, programs):
        files = {a for a in arguments if a.startswith(self.source + "/tests/")}
        for program in programs:
            files.update(f for f in self.sources.get(os.path.basename(program), ())
                         if f.startswith(self.source + "/tests/"))
        digest = hashlib.sha256(repr(sorted(arguments[1:])).replace(self.folder, "").encode())
        for file in sorted(files):
            if os.path.isfile(file):
                with open(file, "rb") as content:
                    digest.update(content.read())
        return digest.hexdigest()[:16]

    def tests(self):
        """Those that count, by name."""
        with open(os.path.join(self.build, "tests", "CTestTestfile.cmake")) as text:
            commands = {name: ARGUMENT.findall(rest) for name, rest in TEST.findall(text.read())}
        shown = run(["ctest", "--test-dir", self.build, "--show-only=json-v1"]).stdout
        found = {}
        for entry in json.loads(shown)["tests"]:
            has = {p["name"]: p["value"] for p in entry["properties"]}
            name = entry["name"]
            if LEFT_OUT & set(has.get("LABELS", ())):
                continue
            programs = self.programs(commands[name])
            found[name] = Test(programs, self.hash_of(commands[name], programs),
                               has.get("TIMEOUT", 1500), has.get("RUN_SERIAL", False))
        return found

    def make(self, targets, jobs=1):
        return run(["ninja", "-C", self.build, "-j", str(jobs), *targets],
                   env=self.environment)

    def code(self, file):
        """Of what the file compiles to: a hash, None if it does not."""
        objects = self.objects.get(file, [])
        if self.make(objects).returncode:
            return None
        digest = hashlib.sha256()
        for path in objects:
            with open(os.path.join(self.build, path), "rb") as content:
                digest.update(content.read())
        return digest.hexdigest()

    def test(self, name, seconds, **environment):
        """How one test ends, 'passed', 'failed' or 'hangs', and its processor time.

        Stopped after so many seconds, more where others keep the machine busy."""
        start = time.monotonic()
        seconds *= max(1, os.getloadavg()[0] / os.cpu_count())
        tmp = os.path.join(self.tmp, name)
        os.makedirs(tmp, exist_ok=True)
        child = subprocess.Popen(
            [*self.apart[:-1], tmp, "ctest", "--test-dir", self.build, "-R",
             f"^{re.escape(name)}$"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace", preexec_fn=limit_memory,
            env=dict(self.environment, **environment))
        try:
            said, _ = child.communicate(timeout=seconds)
            end = ("passed" if child.returncode == 0 else
                   "hangs" if "***Timeout" in said else "failed")
        except subprocess.TimeoutExpired:
            end = "hangs"
            child.kill()  # and with it all that it started
            child.communicate()
        shutil.rmtree(tmp, ignore_errors=True)
        if end == "hangs":
            return end, time.monotonic() - start
        return end, sum(60 * float(m) + float(s) for m, s in TIMES.findall(said)[-2:])
