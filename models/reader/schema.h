/* schema.h - tables that say which keys a section may have, of what type and range, and
 * where their values go. One table reads, refuses, prints and documents.
 */
#ifndef SCHEMA_H
#define SCHEMA_H

#include <stdio.h>

#include "models/reader/yaml_tree.h"

enum schema_type {
    SCHEMA_NUMBER,  /* double                                                          */
    SCHEMA_VECTOR,  /* double[3]                                                       */
    SCHEMA_NUMBERS, /* double * [count], owned; the count is an int at count_offset     */
    SCHEMA_COUNT,   /* int                                                             */
    SCHEMA_COUNTS,  /* int[3]; two numbers leave the third as it was                    */
    SCHEMA_WORD,    /* an enum of int's size, by the names that `word` gives            */
    SCHEMA_TEXT,    /* char *, owned, replaced                                          */
    SCHEMA_SECTION, /* a map with the keys of `keys`, into the same target              */
    SCHEMA_SPECIAL, /* by the function `read`; `keys`, if given, document its elements  */
};

enum schema_order { SCHEMA_ANY, SCHEMA_NON_DECREASING, SCHEMA_INCREASING };

struct schema_key {
    const char *key;  /* NULL ends a table                                            */
    const char *what; /* for people: the quantity with its unit; NULL: not listed     */
    enum schema_type type;
    bool required;
    bool open; /* low and high themselves are not allowed                      */
    enum schema_order order;        /* of NUMBERS                                         */
    int most;                       /* count of NUMBERS                                   */
    double low, high;               /* of every number                                    */
    size_t offset, count_offset;    /* in the target                                      */
    const char *(*word)(int value); /* "unknown" beyond the last                       */
    const struct schema_key *keys;  /* of a SECTION                                    */
    /* SPECIAL: reads the node. SECTION: checks what was read; optional. */
    enum status (*read)(const struct schema_key *key, const struct yaml_tree *node,
                        void *target, struct message *why);
    const char *want; /* SPECIAL: what would be right, for a sentence                  */
};

/* Reads the map `node`, called `name` in sentences, into *target. STATUS_INPUT with one
 * sentence that names the node's origin, or STATUS_MEMORY; *target then owns what it owned
 * and what was read so far. */
enum status schema_read(const struct schema_key *keys, const struct yaml_tree *node,
                        const char *name, void *target, struct message *why);

/* Reads a finite number inside the key's range, or refuses; for special readers. */
enum status schema_number(const struct schema_key *key, const struct yaml_tree *node,
                          double *value, struct message *why);

/* Reads likewise a line of text that is not empty and has no control characters, owned, in
 * place of *text. */
enum status schema_text(const struct schema_key *key, const struct yaml_tree *node,
                        char **text, struct message *why);

/* Fails with the sentence "KEY is FOUND, but must be WANTED". */
enum status schema_refuse(const struct schema_key *key, const struct yaml_tree *node,
                          struct message *why);

/* Calls line() once a key of the table and its sections, as `prefix` + section.key. */
void schema_list(const struct schema_key *keys, const char *prefix,
                 void (*line)(void *context, const char *key, const char *text),
                 void *context);

/* Prints lines `prefix` + key=value as a setting is written, 17 digits; arrays that are
 * NULL are left out. For tables of numbers, counts and words. */
void schema_print(const struct schema_key *keys, const char *prefix, const void *source,
                  FILE *out);

#endif
