#define _GNU_SOURCE /* pipe2 */
#include "bench/ui/show.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "models/reader/named_file.h"

/* The absolute path of Debian's Python: no other one has Debian's packages. */
#define PYTHON "/usr/bin/python3"

/* Exit codes of show.py, and of a child that could not become Python. */
enum { SHOWN = 0, IS_WRONG = 2, LACKS_PACKAGE = 3, NO_PYTHON = 127 };

static const struct named_file_kind package = {
    .what = "part of the Python package",
    .ending = ".py",
    .environment = "CLOTHBENCH_PACKAGE",
    .from_program = PACKAGE_FROM_PROGRAM,
    .in_source = PACKAGE_IN_SOURCE,
};

/* Becomes Python, isolated (-I): neither the folder that it is started in nor the
 * environment is searched for modules. */
static void become_python(int error, const char *script, const char *const *words)
{
    const char *asked = getenv("CLOTHBENCH_PYTHON"),
               *python = asked && *asked ? asked : PYTHON;
    /* Its own path, from which it finds its modules: a bare name would lead it to the PATH.
     */
    char *argv[SHOW_WORDS + 5] = {(char *)python, "-I", "-B", (char *)script};

    for (int n = 0; words[n] && n < SHOW_WORDS; n++)
        argv[n + 4] = (char *)words[n];
    dup2(error, STDERR_FILENO);
    execv(python, argv);
    _exit(NO_PYTHON);
}

/* Reads what the child says, to its end; without the last line's end. */
static void read_said(int from, char *text, size_t size)
{
    char rest[512];
    size_t got = 0;
    ssize_t more;

    do {
        const bool full = got + 1 >= size;
        more =
            full ? read(from, rest, sizeof rest) : read(from, text + got, size - 1 - got);
        got += more > 0 && !full ? (size_t)more : 0;
    } while (more > 0 || (more < 0 && errno == EINTR));
    while (got && text[got - 1] == '\n')
        got--;
    text[got] = '\0';
}

static enum status judge(int code, const char *said, struct message *why)
{
    if (code == SHOWN)
        return STATUS_OK;
    if (code == NO_PYTHON)
        return status_fail(why, STATUS_LIBRARY,
                           "Python is not there: apt-get install python3 "
                           "python3-numpy python3-h5py python3-matplotlib python3-jinja2 "
                           "python3-markdown");
    return status_fail(why,
                       code == LACKS_PACKAGE ? STATUS_LIBRARY
                       : code == IS_WRONG    ? STATUS_INPUT
                                             : STATUS_FILE,
                       "%s", *said ? said : "Python ended without a word");
}

enum status show_run(const char *const *words, struct message *why)
{
    char *found = NULL, *script = NULL;
    struct message said = {""};
    int ends[2] = {-1, -1}, status = 0;
    pid_t pid = -1;
    enum status st;

    TRY(named_file_find(&package, "show", &found, why));
    script = realpath(found, NULL);
    if (script && pipe2(ends, O_CLOEXEC) == 0 && (pid = fork()) == 0)
        become_python(ends[1], script, words);
    if (pid < 0)
        TRY(status_fail(why, STATUS_LIBRARY, "%s: cannot be run: %s", found,
                        strerror(errno)));
    close(ends[1]);
    ends[1] = -1;
    read_said(ends[0], said.text, sizeof said.text);
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
        ;
    st = judge(WIFEXITED(status) ? WEXITSTATUS(status) : -1, said.text, why);
out:
    for (int n = 0; n < 2; n++)
        if (ends[n] >= 0)
            close(ends[n]);
    free(script);
    free(found);
    return st;
}

void show_tell(const char *folder)
{
    fprintf(stderr, "%s: clothbench report %s draws what is in it\n", folder, folder);
}
