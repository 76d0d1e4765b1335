/* named_file.h - files that have names: where they are searched, and which there are.
 *
 * NAME is NAME.yaml (or another ending) in the user's folder (an environment variable),
 * else in the one installed with the program (seen from the program, so that an installed
 * tree may be moved), else in the source tree.
 */
#ifndef NAMED_FILE_H
#define NAMED_FILE_H

#include <stddef.h>

#include "models/status.h"

/* A kind of files: scenes are one, the plans of sweeps another. */
struct named_file_kind {
    const char *what;         /* in sentences: "scene"                                 */
    const char *ending;       /* ".yaml"                                               */
    const char *environment;  /* variable that may hold the user's folder              */
    const char *from_program; /* the installed folder, seen from the program's         */
    const char *in_source;    /* the source tree's                                     */
    /* Returns a line on the file for lists, or what is wrong with it; NULL if memory is
     * out. The pointer may be NULL: lists then have no lines, and no file is read for
     * one. */
    char *(*describe)(const char *path);
    size_t most; /* bytes of a file; 0: as many as a YAML text may have                 */
};

/* Finds the file of an argument: one with a '/' or its ending is a path already; another is
 * a name. *path is freed by the receiver. STATUS_INPUT: no such name, with a sentence that
 * lists the known ones. */
enum status named_file_find(const struct named_file_kind *kind, const char *argument,
                            char **path, struct message *why);

struct named_file_entry {
    char *name; /* owned                                                               */
    char *text; /* the line that `describe` made, or NULL                      owned   */
};

/* Lists all files with names, sorted; *entries is freed with named_file_list_free. */
enum status named_file_list(const struct named_file_kind *kind,
                            struct named_file_entry **entries, int *count,
                            struct message *why);
/* Lists them without lines: no file is read. */
enum status named_file_names(const struct named_file_kind *kind,
                             struct named_file_entry **entries, int *count,
                             struct message *why);
void named_file_list_free(struct named_file_entry *entries, int count);

/* Reads the bytes of a file, at most one more than its kind may have (YAML_TREE_MAX_TEXT
 * by default), so that its reader sees when it is too long; behind them is a zero. *bytes
 * is freed by the receiver. STATUS_FILE with a sentence. */
enum status named_file_read(const struct named_file_kind *kind, const char *path,
                            char **bytes, size_t *size, struct message *why);

#endif
