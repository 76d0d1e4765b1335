#include "bench/files/folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <stdio.h>
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

enum status folder_lock(const char *path, int *lock, struct message *why)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    char name[4096];
    enum status st = folder_make(path, why);

    *lock = -1;
    CALL(st);
    if (snprintf(name, sizeof name, "%s/lock", path) >= (int)sizeof name)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", path);
    /* a pipe without a reader would be waited for */
    *lock = open(name, O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (*lock < 0)
        return status_fail(why, STATUS_FILE, "%s: %s", name,
                           errno == ENXIO
                               ? "this is a pipe, where a file is made: remove it"
                               : strerror(errno));
    if (fcntl(*lock, F_SETLK, &whole) != 0 && (errno == EACCES || errno == EAGAIN))
        return status_fail(why, STATUS_FILE, "%s: another run is at work in this folder",
                           path);
    return STATUS_OK;
}

void folder_tidy(const char *path)
{
    DIR *folder = opendir(path);

    for (const struct dirent *e; folder && (e = readdir(folder));)
        if (fnmatch("*.[0-9]*-[0-9]*.part", e->d_name, 0) == 0)
            unlinkat(dirfd(folder), e->d_name, 0);
    if (folder)
        closedir(folder);
}

bool folder_is(const char *path)
{
    struct stat about;

    return !stat(path, &about) && S_ISDIR(about.st_mode);
}

/* Checks that there is no folder of this name, or an empty one. */
static enum status check_free(const char *path, struct message *why)
{
    struct stat info;
    bool empty = true;

    if (*path == '\0')
        return status_fail(why, STATUS_INPUT, "the name of the folder is empty");
    if (lstat(path, &info) != 0)
        return STATUS_OK; /* its making reports what is wrong */
    if (!S_ISDIR(info.st_mode))
        return status_fail(why, STATUS_INPUT, "%s: is there already, and no folder", path);
    DIR *folder = opendir(path);
    for (const struct dirent *e; folder && (e = readdir(folder));)
        empty = empty && (!strcmp(e->d_name, ".") || !strcmp(e->d_name, ".."));
    if (folder)
        closedir(folder);
    if (folder && empty)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: is there already, with something in it; a new folder is needed",
                       path);
}

enum status folder_aside_open(const char *path, struct folder_aside *f, struct message *why)
{
    size_t size = strlen(path);
    enum status st;

    *f = (struct folder_aside){0};
    TRY(check_free(path, why));
    while (size > 1 && path[size - 1] == '/')
        size--;
    f->temporary = arena_print(&f->arena, "%.*s.%ld.part", (int)size, path, (long)getpid());
    f->path = arena_print(&f->arena, "%.*s", (int)size, path);
    if (folder_make(f->temporary, NULL) != STATUS_OK)
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be made: %s", path, strerror(errno)));
out:
    if (st != STATUS_OK)
        folder_aside_discard(f);
    return st;
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

enum status folder_aside_commit(struct folder_aside *f, struct message *why)
{
    enum status st = STATUS_OK;

    if (rename(f->temporary, f->path) != 0)
        st = status_fail(why, STATUS_FILE, "%s: cannot be written: %s", f->path,
                         strerror(errno));
    folder_aside_discard(f);
    return st;
}

void folder_aside_discard(struct folder_aside *f)
{
    if (f->temporary)
        remove_files(f->temporary);
    arena_clear(&f->arena);
    *f = (struct folder_aside){0};
}
