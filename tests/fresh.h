/* fresh.h - the folder of a test's results, without the files of an earlier run: what is no
 * longer made must not be found; and what is in a file of it. */
#ifndef FRESH_H
#define FRESH_H

#include <dirent.h>

#include "bench/files/folder.h"
#include "tests/check.h"

/* Folders in it stay: truths take their time and tell by themselves what they are of. */
static inline void fresh_folder(const char *folder)
{
    char path[4096];

    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    DIR *directory = opendir(folder);
    REQUIRE(directory);
    for (struct dirent *entry; (entry = readdir(directory));)
        if (entry->d_name[0] != '.') {
            snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
            remove(path); /* not what holds something */
        }
    closedir(directory);
}

/* All of FOLDER/NAME, freed by the caller. */
static inline char *fresh_text(const char *folder, const char *name)
{
    enum { MOST = 1 << 20 };
    char path[4096], *text = calloc(1, MOST);

    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    REQUIRE(text && file);
    REQUIRE(fread(text, 1, MOST - 1, file) > 0);
    fclose(file);
    return text;
}

#endif
