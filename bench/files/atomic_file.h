/* atomic_file.h - a file is written aside under a temporary name in the same folder and
 * renamed when it is complete: whoever looks at the wanted name sees the old file or the
 * whole new one, never half of it.
 *
 * A symbolic link is followed. A device or pipe (/dev/full, /dev/stdout) is written in
 * place.
 */
#ifndef ATOMIC_FILE_H
#define ATOMIC_FILE_H

#include <stdbool.h>

#include "models/status.h"

struct atomic_file {
    char *path;      /* the wanted name, as the user wrote it                   owned */
    char *target;    /* the same with symbolic links followed                   owned */
    char *temporary; /* name to write to                                        owned */
    bool in_place;   /* a device: temporary = target, nothing is renamed              */
};

/* Removes a symbolic link, pipe or socket of a name that the program chose, in a folder
 * that somebody else may have filled: what it leads to is not written. A device stays, for
 * who may make one may write it anyway. */
void atomic_file_claim(const char *path);

/* Finds a free temporary name and leaves an empty file there, so that a run learns at its
 * start what would stop it at its end. STATUS_FILE with a sentence: a folder, no such
 * folder, no permission. On failure *a is all-zero. */
enum status atomic_file_open(const char *path, struct atomic_file *a, struct message *why);

/* Finishes the file after its writer has closed it: syncs it to disk, renames it, syncs the
 * folder; clears *a. On failure the temporary file is removed. */
enum status atomic_file_commit(struct atomic_file *a, struct message *why);

/* Removes the temporary file and clears *a; all-zero is allowed. */
void atomic_file_discard(struct atomic_file *a);

/* Removes the temporary files of this process, which is about to end; calls only what a
 * signal handler may call. */
void atomic_file_remove_all(void);

/* Makes SIGINT, SIGTERM and SIGHUP remove the temporary files of this process before they
 * end it. Signals that are ignored stay so. Call once, early in main. */
void atomic_file_catch_signals(void);

#endif
