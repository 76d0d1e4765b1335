/* schema_key.h - tables that say which keys a section may have, of what type and range, and
 * where their values go (reader/schema.h). */
#ifndef SCHEMA_KEY_H
#define SCHEMA_KEY_H

#include <stddef.h>

#include "models/status.h"

struct yaml_tree;

enum schema_type {
    SCHEMA_NUMBER,  /* double                                                          */
    SCHEMA_VECTOR,  /* double[3], or [most]                                            */
    SCHEMA_NUMBERS, /* double * [count], owned; the count is an int at count_offset     */
    SCHEMA_COUNT,   /* int                                                             */
    SCHEMA_COUNTS,  /* int[3]; two numbers leave the third as it was                    */
    SCHEMA_WORD, /* an enum of int's size, by `words`, or by the names that `word` gives */
    SCHEMA_TEXT, /* char *, owned, replaced                                          */
    SCHEMA_SECTION, /* a map with the keys of `keys`, into the same target              */
    SCHEMA_SPECIAL, /* anything, by the function `read`; `keys` may document elements  */
};

enum schema_order { SCHEMA_ANY, SCHEMA_NON_DECREASING, SCHEMA_INCREASING };

struct schema_key {
    const char *key;  /* NULL ends a table                                            */
    const char *what; /* for people: the quantity with its unit; NULL: not listed     */
    enum schema_type type;
    bool required;
    bool open; /* low and high themselves are not allowed                      */
    enum schema_order order;        /* order of NUMBERS                                   */
    int most;                       /* count of NUMBERS; of a row of a SPECIAL table      */
    double low, high;               /* range of every number                              */
    size_t offset, count_offset;    /* in the target                                      */
    const char *const *words;       /* words by value, NULL ends; in place of it:      */
    const char *(*word)(int value); /* "unknown" beyond the last                       */
    unsigned only;                  /* bits of the words that a model has; 0: all      */
    const char *with;               /* an option that is set needs another, of ...     */
    unsigned of;                    /* ... these words                                 */
    const struct schema_key *keys;  /* keys of a SECTION                               */
    /* SPECIAL: reads the node. SECTION: checks what was read; optional. */
    enum status (*read)(const struct schema_key *key, const struct yaml_tree *node,
                        void *target, struct message *why);
    const char *want; /* what would be right, for a sentence; required of SPECIAL      */
};

#endif
