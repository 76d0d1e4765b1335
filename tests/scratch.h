/* scratch.h - a folder for a test's files, gone when the test ends, also when it fails.
 *
 *     scratch_open();
 *     FILE *file = fopen(scratch_path("deck.inp"), "w");
 */
#ifndef SCRATCH_H
#define SCRATCH_H

#include <dirent.h>
#include <unistd.h>

#include "tests/check.h"

static char scratch[128]; /* once it is opened */
static pid_t scratch_owner;

/* A file, or a folder with all that is in it. */
static inline void scratch_remove(const char *path)
{
    DIR *dir = unlink(path) == 0 ? NULL : opendir(path);
    char inside[1024];

    for (const struct dirent *e; dir && (e = readdir(dir));)
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0 &&
            snprintf(inside, sizeof inside, "%s/%s", path, e->d_name) < (int)sizeof inside)
            scratch_remove(inside);
    if (dir)
        closedir(dir);
    rmdir(path);
}

static inline void scratch_close(void)
{
    if (getpid() == scratch_owner) /* children end, too */
        scratch_remove(scratch);
}

/* Once a program; in TMPDIR, as those of other programs. */
static inline void scratch_open(void)
{
    const char *parent = getenv("TMPDIR");

    snprintf(scratch, sizeof scratch, "%.96s/clothbench-test-XXXXXX",
             parent && *parent == '/' ? parent : "/tmp");
    REQUIRE(mkdtemp(scratch));
    scratch_owner = getpid();
    REQUIRE(atexit(scratch_close) == 0);
}

/* Of a file in it, as long as the program runs: the same for the same name. */
static inline const char *scratch_path(const char *name)
{
    enum { NAMES = 128 };
    static char path[NAMES][256];
    char wanted[sizeof path[0]];
    int n = 0;

    REQUIRE(*scratch &&
            snprintf(wanted, sizeof wanted, "%s/%s", scratch, name) < (int)sizeof wanted);
    while (n < NAMES - 1 && *path[n] && strcmp(path[n], wanted) != 0)
        n++;
    REQUIRE(n < NAMES - 1);
    return strcpy(path[n], wanted);
}

/* How many files a folder has, this one or another; of "/proc/self/fd" how many are open.
 */
static inline int scratch_files(const char *folder)
{
    int count = 0;
    DIR *dir = opendir(folder);

    REQUIRE(dir);
    for (struct dirent *e; (e = readdir(dir));)
        count += e->d_name[0] != '.';
    closedir(dir);
    return count;
}

#endif
