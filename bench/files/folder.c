#include "bench/files/folder.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

/* Checks that a folder of this name would replace nothing. */
static enum status check_free(const char *path, struct message *why)
{
    struct stat info;
    int entries = 0;

    if (*path == '\0')
        return status_fail(why, STATUS_INPUT, "the name of the folder is empty");
    if (lstat(path, &info) != 0)
        return STATUS_OK; /* its making reports what is wrong */
    if (!S_ISDIR(info.st_mode))
        return status_fail(why, STATUS_INPUT, "%s: is there already, and no folder", path);
    DIR *folder = opendir(path);
    for (const struct dirent *e; folder && (e = readdir(folder));)
        entries += strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0;
    if (folder)
        closedir(folder);
    if (!folder || entries)
        return status_fail(why, STATUS_INPUT,
                           "%s: is there already, with something in it; a new folder is "
                           "needed",
                           path);
    return STATUS_OK;
}

static enum status make_parents(char *path, struct message *why)
{
    char *slash = strrchr(path, '/');
    enum status st = STATUS_OK;

    if (slash && slash != path) {
        *slash = '\0';
        st = folder_make(path, why);
        *slash = '/';
    }
    return st;
}

enum status folder_aside_open(const char *path, struct folder_aside *f, struct message *why)
{
    const size_t size = strlen(path) + 32;
    enum status st;

    /* zeros: the folder is not made yet */
    *f = (struct folder_aside){.path = strdup(path), .temporary = calloc(size, 1)};
    TRY(f->path && f->temporary ? STATUS_OK : STATUS_MEMORY);
    for (size_t n = strlen(f->path); n > 1 && f->path[n - 1] == '/'; n--)
        f->path[n - 1] = '\0';
    TRY(check_free(f->path, why));
    TRY(make_parents(f->path, why));
    snprintf(f->temporary, size, "%s.%ld.part", f->path, (long)getpid());
    if (mkdir(f->temporary, 0777) != 0) {
        *f->temporary = '\0';
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be made: %s", path, strerror(errno)));
    }
out:
    if (st != STATUS_OK)
        folder_aside_discard(f);
    return st;
}

enum status folder_aside_commit(struct folder_aside *f, struct message *why)
{
    enum status st = STATUS_OK;

    if (rename(f->temporary, f->path) == 0)
        *f->temporary = '\0'; /* nothing to remove */
    else
        st = status_fail(why, STATUS_FILE, "%s: cannot be written: %s", f->path,
                         strerror(errno));
    folder_aside_discard(f);
    return st;
}

void folder_aside_discard(struct folder_aside *f)
{
    char path[4096];
    DIR *folder = f->temporary && *f->temporary ? opendir(f->temporary) : NULL;

    for (const struct dirent *e; folder && (e = readdir(folder));)
        if (snprintf(path, sizeof path, "%s/%s", f->temporary, e->d_name) <
            (int)sizeof path)
            unlink(path); /* not . and .. */
    if (folder) {
        closedir(folder);
        rmdir(f->temporary);
    }
    free(f->path);
    free(f->temporary);
    *f = (struct folder_aside){0};
}
