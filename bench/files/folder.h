/* folder.h - folders for results. */
#ifndef FOLDER_H
#define FOLDER_H

#include "bench/files/arena.h"
#include "models/status.h"

/* Makes a folder and those it is in, like mkdir -p. STATUS_FILE with a sentence. */
enum status folder_make(const char *path, struct message *why);

/* Makes a folder and locks it for this process alone; *lock is a file to close. The system
 * drops the lock when the process dies, however it does, and children do not have it.
 * STATUS_FILE with a sentence: it cannot be written, or another process has it. */
enum status folder_lock(const char *path, int *lock, struct message *why);

/* Removes the files `NAME.PID-N.part` (atomic_file.h) that killed processes left half done.
 */
void folder_tidy(const char *path);

/* Tells whether there is a folder of this path. */
bool folder_is(const char *path);

/* A folder that is written under a temporary name and renamed at the end: it appears with
 * all of its files, or not at all. */
struct folder_aside {
    char *path;         /* the wanted name                                             */
    char *temporary;    /* where to put the files                                      */
    struct arena arena; /* of both                                              owned  */
};

/* Makes it, and the folders that it is in. STATUS_INPUT with a sentence: there is something
 * of that name which is no empty folder; STATUS_FILE. On failure *f is all-zero. */
enum status folder_aside_open(const char *path, struct folder_aside *f,
                              struct message *why);

/* Renames it and clears *f. STATUS_FILE: that failed, and the folder is discarded. */
enum status folder_aside_commit(struct folder_aside *f, struct message *why);

/* Removes it with its files and clears *f; all-zero is allowed. */
void folder_aside_discard(struct folder_aside *f);

#endif
