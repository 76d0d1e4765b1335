/* scratch.h - a folder for a test's files. */
#ifndef SCRATCH_H
#define SCRATCH_H

#include <dirent.h>

#include "tests/check.h"

static char scratch[] = "/tmp/clothbench-test-XXXXXX"; /* after mkdtemp */

/* Of a file in it; four at a time. */
static inline const char *scratch_path(const char *name)
{
    static char path[4][256];
    static int turn;
    char *text = path[turn++ % 4];

    snprintf(text, sizeof path[0], "%s/%s", scratch, name);
    return text;
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
