#include "bench/files/folder.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum status folder_make(const char *path, struct message *why)
{
    char part[4096];

    if (snprintf(part, sizeof part, "%s", path) >= (int)sizeof part)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", path);
    for (char *end = part; end;) {
        end = strchr(end + 1, '/');
        if (end)
            *end = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return status_fail(why, STATUS_FILE, "%s: cannot be made: %s", part,
                               strerror(errno));
        if (end)
            *end = '/';
    }
    return STATUS_OK;
}
