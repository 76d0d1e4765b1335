#define _XOPEN_SOURCE 700 /* realpath */
#include "bench/files/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The most temporary files to remove on a signal; one beyond that is merely not removed. */
enum { PENDING_MAX = 256 };
static struct {
    _Atomic(char *) name;
    pid_t owner; /* a forked child must not remove its parent's files */
} pending[PENDING_MAX];

static void pending_add(char *name)
{
    for (int i = 0; i < PENDING_MAX; i++) {
        char *none = NULL;
        pending[i].owner = pending[i].name ? pending[i].owner : getpid();
        if (atomic_compare_exchange_strong(&pending[i].name, &none, name))
            return;
    }
}

static void pending_remove(char *name)
{
    for (int i = 0; i < PENDING_MAX; i++) {
        char *expected = name;
        if (atomic_compare_exchange_strong(&pending[i].name, &expected, NULL))
            return;
    }
}

void atomic_file_remove_all(void)
{
    for (int i = 0; i < PENDING_MAX; i++) {
        char *name = pending[i].name;
        if (name && pending[i].owner == getpid())
            unlink(name);
    }
}

static void remove_pending(int signal_number)
{
    atomic_file_remove_all();
    raise(signal_number); /* SA_RESETHAND: the default action now ends the process */
}

void atomic_file_catch_signals(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        struct sigaction old,
            new = {.sa_handler = remove_pending, .sa_flags = SA_RESETHAND};
        sigemptyset(&new.sa_mask);
        if (sigaction(numbers[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN)
            sigaction(numbers[i], &new, NULL);
    }
}

static void clear(struct atomic_file *a)
{
    if (a->temporary)
        pending_remove(a->temporary);
    free(a->path);
    free(a->target);
    free(a->temporary);
    *a = (struct atomic_file){0};
}

/* Creates TARGET.PID-N.part for the first N that is free. */
static enum status create_temporary(struct atomic_file *a, struct message *why)
{
    size_t size = strlen(a->target) + 48;
    a->temporary = malloc(size);
    if (!a->temporary)
        return STATUS_MEMORY;
    for (int n = 0; n < 1000; n++) {
        snprintf(a->temporary, size, "%s.%ld-%d.part", a->target, (long)getpid(), n);
        int file = open(a->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            close(file);
            pending_add(a->temporary);
            return STATUS_OK;
        }
        if (errno != EEXIST)
            break;
    }
    return status_fail(why, STATUS_FILE, "%s: cannot be created: %s", a->path,
                       strerror(errno));
}

void atomic_file_claim(const char *path)
{
    struct stat info;

    if (lstat(path, &info) == 0 &&
        (S_ISLNK(info.st_mode) || S_ISFIFO(info.st_mode) || S_ISSOCK(info.st_mode)))
        unlink(path);
}

enum status atomic_file_open(const char *path, struct atomic_file *a, struct message *why)
{
    enum status st = STATUS_OK;
    struct stat info;

    *a = (struct atomic_file){.path = strdup(path)};
    bool exists = stat(path, &info) == 0;
    a->target = exists ? realpath(path, NULL) : strdup(path);
    if (!a->path || !a->target)
        TRY(STATUS_MEMORY);
    if (exists && S_ISDIR(info.st_mode))
        TRY(status_fail(why, STATUS_FILE, "%s: is a folder, not a file", path));
    if (*path == '\0')
        TRY(status_fail(why, STATUS_FILE, "the name of an output file is empty"));
    if (exists && !S_ISREG(info.st_mode)) {
        a->in_place = true;
        a->temporary = strdup(a->target);
        TRY(a->temporary ? STATUS_OK : STATUS_MEMORY);
    } else {
        TRY(create_temporary(a, why));
    }
out:
    if (st != STATUS_OK)
        clear(a);
    return st;
}

static enum status sync_name(const char *name, int flags)
{
    int file = open(name, O_RDONLY | O_CLOEXEC | flags);
    if (file < 0)
        return STATUS_FILE;
    int failed = fsync(file), reason = errno;
    close(file);
    errno = reason;
    return failed ? STATUS_FILE : STATUS_OK;
}

/* Syncs the folder, so that the new name itself survives a power cut; file systems that
 * cannot do it are excused. */
static void sync_folder(const char *target)
{
    char *folder = strdup(target);
    char *slash = folder ? strrchr(folder, '/') : NULL;
    if (slash)
        slash[slash == folder] = '\0';
    if (folder)
        sync_name(slash ? folder : ".", O_DIRECTORY);
    free(folder);
}

enum status atomic_file_commit(struct atomic_file *a, struct message *why)
{
    enum status st = STATUS_OK;

    if (!a->in_place) {
        if (sync_name(a->temporary, 0) != STATUS_OK || rename(a->temporary, a->target) != 0)
            TRY(status_fail(why, STATUS_FILE, "%s: cannot be written: %s", a->path,
                            strerror(errno)));
        sync_folder(a->target);
    }
    clear(a);
out:
    if (st != STATUS_OK)
        atomic_file_discard(a);
    return st;
}

void atomic_file_discard(struct atomic_file *a)
{
    if (a->temporary && !a->in_place)
        unlink(a->temporary);
    clear(a);
}
