/* folder.h - folders for results. */
#ifndef FOLDER_H
#define FOLDER_H

#include <stdbool.h>

#include "models/status.h"

/* Makes a folder and those it is in, like mkdir -p. STATUS_FILE with a sentence. */
enum status folder_make(const char *path, struct message *why);

/* A folder that is written under a temporary name and renamed at the end: it appears with
 * all of its files, or not at all. */
struct folder_aside {
    char *path;      /* the wanted name                                        owned   */
    char *temporary; /* where to put the files                                 owned   */
    bool replaces;   /* a folder of that name, which is there, goes                    */
};

/* Makes it, and the folders that it is in. STATUS_INPUT with a sentence: there is something
 * of that name which is no empty folder; STATUS_FILE. On failure *f is all-zero. */
enum status folder_aside_open(const char *path, struct folder_aside *f,
                              struct message *why);

/* Does the same for a folder that may be there already, and is then replaced: if it has a
 * file `mark`, and no other files than those that end in one of `endings`, "|.html|.css|".
 * STATUS_INPUT with a sentence that says what else is in it. */
enum status folder_aside_replace(const char *path, const char *mark, const char *endings,
                                 struct folder_aside *f, struct message *why);

/* Renames it and clears *f. STATUS_FILE: that failed, and the folder is discarded. */
enum status folder_aside_commit(struct folder_aside *f, struct message *why);

/* Removes it with its files and clears *f; all-zero is allowed. */
void folder_aside_discard(struct folder_aside *f);

#endif
