#define _GNU_SOURCE /* asprintf */
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

/* Checks that a folder of this name would replace nothing but, with a mark, files that have
 * one of the endings and the file `mark` among them; *there: it is not empty. */
static enum status check_free(const char *path, const char *mark, const char *endings,
                              bool *there, struct message *why)
{
    struct stat info;
    char foreign[300] = "", word[300];
    bool marked = false;

    *there = false;
    if (*path == '\0')
        return status_fail(why, STATUS_INPUT, "the name of the folder is empty");
    if (lstat(path, &info) != 0)
        return STATUS_OK; /* its making reports what is wrong */
    if (!S_ISDIR(info.st_mode))
        return status_fail(why, STATUS_INPUT, "%s: is there already, and no folder", path);
    DIR *folder = opendir(path);
    for (const struct dirent *e; folder && (e = readdir(folder));) {
        const char *dot = strrchr(e->d_name, '.');
        snprintf(word, sizeof word, "|%s|", dot ? dot : "");
        const bool is_mark = mark && !strcmp(e->d_name, mark);
        if (!strcmp(e->d_name, ".") || !strcmp(e->d_name, ".."))
            continue;
        *there = true;
        marked |= is_mark;
        if (!is_mark && (!mark || !strstr(endings, word)))
            snprintf(foreign, sizeof foreign, "%s", e->d_name);
    }
    if (folder)
        closedir(folder);
    if (folder && (!*there || (marked && !*foreign)))
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: is there already, with %s in it; a new folder is needed%s",
                       path, mark && *foreign ? foreign : "something",
                       mark ? ", or one that this command has written" : "");
}

enum status folder_aside_replace(const char *path, const char *mark, const char *endings,
                                 struct folder_aside *f, struct message *why)
{
    size_t size = strlen(path);
    bool there;
    enum status st;

    *f = (struct folder_aside){0};
    TRY(check_free(path, mark, endings, &there, why));
    f->replaces = there;
    while (size > 1 && path[size - 1] == '/')
        size--;
    if (asprintf(&f->temporary, "%.*s.%ld.part", (int)size, path, (long)getpid()) < 0)
        f->temporary = NULL;
    f->path = strndup(path, size);
    TRY(f->path && f->temporary ? STATUS_OK : STATUS_MEMORY);
    if (folder_make(f->temporary, NULL) != STATUS_OK)
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be made: %s", path, strerror(errno)));
out:
    if (st != STATUS_OK)
        folder_aside_discard(f);
    return st;
}

enum status folder_aside_open(const char *path, struct folder_aside *f, struct message *why)
{
    return folder_aside_replace(path, NULL, NULL, f, why);
}

static void remove_files(const char *path)
{
    DIR *folder = opendir(path);

    for (const struct dirent *e; folder && (e = readdir(folder));)
        unlinkat(dirfd(folder), e->d_name, 0); /* not . and .. */
    if (folder) {
        closedir(folder);
        rmdir(path);
    }
}

/* Puts the new folder in the place of the one that is there, which is put back if that
 * fails. */
static int exchange(const struct folder_aside *f)
{
    char old[4096];

    if (snprintf(old, sizeof old, "%s.old", f->temporary) >= (int)sizeof old)
        return -1;
    if (rename(f->path, old) != 0)
        return -1;
    if (rename(f->temporary, f->path) != 0)
        return rename(old, f->path), -1;
    remove_files(old);
    return 0;
}

enum status folder_aside_commit(struct folder_aside *f, struct message *why)
{
    enum status st = STATUS_OK;

    if ((f->replaces ? exchange(f) : rename(f->temporary, f->path)) != 0)
        st = status_fail(why, STATUS_FILE, "%s: cannot be written: %s", f->path,
                         strerror(errno));
    folder_aside_discard(f);
    return st;
}

void folder_aside_discard(struct folder_aside *f)
{
    if (f->temporary)
        remove_files(f->temporary);
    free(f->path);
    free(f->temporary);
    *f = (struct folder_aside){0};
}
