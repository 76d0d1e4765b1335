"""Which tests reach which function: a build with gcc's counters, every test once."""
import concurrent.futures
import hashlib
import json
import os
import shutil
import subprocess

import copied

# Counts of a process that does not end by exit() would be lost: it writes them before. One
# that is to be killed is told first, by a signal that it minds.
LEAVE = """
#include <signal.h>
#include <stddef.h>
#include <time.h>
#include <unistd.h>

void __gcov_dump(void);
void __gcov_reset(void);
_Noreturn void __real__exit(int code);
int __real_raise(int number);
int __real_kill(pid_t pid, int number);
_Noreturn void __real_abort(void);

_Noreturn void __wrap__exit(int code)
{
    __gcov_dump();
    __real__exit(code);
}

int __wrap_raise(int number)
{
    __gcov_dump();
    __gcov_reset();
    return __real_raise(number);
}

_Noreturn void __wrap_abort(void)
{
    __gcov_dump();
    __real_abort();
}

int __wrap_kill(pid_t pid, int number)
{
    if (number == SIGKILL && pid > 0 && __real_kill(pid, SIGRTMAX - 1) == 0)
        nanosleep(&(struct timespec){.tv_nsec = 30000000}, NULL);
    return __real_kill(pid, number);
}

static void write_counts(int number)
{
    __gcov_dump();
    __gcov_reset();
    while (number == SIGRTMAX - 1)
        pause(); /* until it is killed: no sleep may end early */
    __real_raise(number);
}

__attribute__((constructor)) static void mind_signals(void)
{
    const int numbers[] = {SIGXCPU, SIGTERM, SIGINT, SIGHUP, SIGSEGV, SIGXFSZ};
    struct sigaction now, mine = {.sa_handler = write_counts, .sa_flags = SA_RESTART};

    sigaction(SIGRTMAX - 1, &mine, NULL);
    mine.sa_flags |= SA_RESETHAND | SA_NODEFER;
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
        if (sigaction(numbers[n], NULL, &now) == 0 && now.sa_handler == SIG_DFL)
            sigaction(numbers[n], &mine, NULL);
}
"""
# The compiler, with counters for the files that match: they cost what a kernel has of speed.
COMPILER = """#!/bin/sh
for word; do
    case $word in *.c) file=$word ;; esac
done
if printf '%%s\\n' "${file#%s/}" | grep -Eq '%s'; then
    exec %s "$@" --coverage
fi
exec %s "$@"
"""
COUNTED = "^(bench|fem_ref|models/(reader/|metric/)?[a-z0-9_]*[.]c)"
SLOWER = 5  # than without counters, at most


def prepare(top, scratch, only):
    copy = copied.Copy(top, os.path.join(scratch, "coverage"))
    copy.bring()
    mark = hashlib.sha256(LEAVE.encode()).hexdigest()[:8]  # ninja links anew if it changes
    leave = os.path.join(copy.folder, f"leave-{mark}.c")
    with open(leave, "w") as source:
        source.write(LEAVE)
    subprocess.run(["gcc", "-O2", "-c", leave, "-o", leave[:-1] + "o"], check=True)
    launcher = os.path.join(copy.folder, "counting")
    cache = shutil.which("ccache") or ""
    with open(launcher, "w") as script:
        script.write(COMPILER % (copy.source, only, cache, cache))
    os.chmod(launcher, 0o755)
    copy.configure(launcher, "--coverage -Wl,--wrap=_exit,--wrap=raise,--wrap=kill,--wrap=abort "
                   + leave[:-1] + "o")
    return copy


def counted(copy, folder):
    """{(file, function): reached?} from the counts in a folder of GCOV_PREFIX."""
    counts = folder + copy.build
    files = []
    for where, _, names in os.walk(counts):
        for name in names:
            path = os.path.join(where, name)
            notes = os.path.join(copy.build, os.path.relpath(path, counts))[:-4] + "gcno"
            if name.endswith(".gcda") and os.path.exists(notes):
                os.symlink(notes, path[:-4] + "gcno")
                files.append(path)
    found = {}
    if not files:
        return found
    said = subprocess.run(["gcov", "--json-format", "--stdout", *files], cwd=folder,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True).stdout
    for line in said.splitlines():
        if not line.strip():
            continue
        unit = json.loads(line)
        for file in unit["files"]:
            path = os.path.join(unit["current_working_directory"], file["file"])
            path = os.path.relpath(os.path.normpath(path), copy.source)
            if path.startswith(("..", "tests/")):
                continue
            for function in file["functions"]:
                at = path, function["name"].split(".")[0]
                found[at] = found.get(at, False) or function["execution_count"] > 0
    return found


def measure(copy, name, test):
    folder = os.path.join(copy.folder, "counts", name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    end, seconds = copy.test(name, SLOWER * test.limit, GCOV_PREFIX=folder)
    found = counted(copy, folder)
    shutil.rmtree(folder)
    reached = sum(found.values())
    print(f"{end:7} {seconds:6.1f} s {reached:5} functions  {name}", flush=True)
    return name, seconds, found


def load(path):
    if not os.path.exists(path):
        return {"tests": {}, "functions": {}}
    with open(path) as text:
        return json.load(text)


def save(path, known):
    with open(path + ".part", "w") as text:
        json.dump(known, text, indent=0, sort_keys=True)
    os.replace(path + ".part", path)


def enter(known, name, test, seconds, found):
    for functions in known["functions"].values():
        for tests in functions.values():
            if name in tests:
                tests.remove(name)
    for (file, function), reached in found.items():
        tests = known["functions"].setdefault(file, {}).setdefault(function, [])
        if reached:
            tests.append(name)
    known["tests"][name] = {"seconds": round(seconds, 2), "hash": test.hash}


def make_map(top, scratch, path, jobs, wanted, only=COUNTED):
    """Adds to the map the tests that it lacks or that have changed since, or `wanted`."""
    copy = prepare(top, scratch, only)
    known, tests = load(path), copy.tests()
    for name in set(known["tests"]) - set(tests):
        enter(known, name, copied.Test((), "", 0, False), 0, {})
        del known["tests"][name]
    due = [name for name, test in tests.items()
           if (wanted.search(name) if wanted
               else known["tests"].get(name, {}).get("hash") != test.hash)]
    programs = {p for name in due for p in tests[name].programs}
    made = copy.make(sorted(programs), jobs)
    if made.returncode:
        raise SystemExit("does not compile:\n" + made.stdout[-2000:])
    alone = [name for name in due if tests[name].alone]
    if alone:
        copy.make(["all"], jobs)  # it installs
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for name, seconds, found in pool.map(
                lambda name: measure(copy, name, tests[name]),
                [name for name in due if name not in alone]):
            enter(known, name, tests[name], seconds, found)
            save(path, known)
    for name in alone:
        _, seconds, found = measure(copy, name, tests[name])
        enter(known, name, tests[name], seconds, found)
        save(path, known)
    copy.close()
    print(f"{len(known['tests'])} tests, {sum(map(len, known['functions'].values()))} "
          f"functions in {path}")
