/* yaml_tree.h - a YAML text as a tree whose every node knows where it was written.
 *
 * The subset that data needs: one document of maps, lists and scalars. Anchors, aliases,
 * tags, keys that are not scalars, duplicate keys and deep nesting are refused, so that a
 * tree is a tree and its size is bounded by the text's.
 */
#ifndef YAML_TREE_H
#define YAML_TREE_H

#include <stdbool.h>
#include <stddef.h>

#include "models/status.h"

enum {
    YAML_TREE_MAX_DEPTH = 12,
    YAML_TREE_MAX_KEYS = 64,      /* in one map */
    YAML_TREE_MAX_TEXT = 1 << 20, /* [bytes] */
};

enum yaml_tree_kind { YAML_TREE_SCALAR, YAML_TREE_LIST, YAML_TREE_MAP };

struct yaml_tree {
    enum yaml_tree_kind kind;
    char *key;          /* in its map; NULL in a list and at the root           owned */
    char *text;         /* a scalar's text, without NUL bytes; otherwise NULL   owned */
    bool quoted;        /* the scalar stood in quotes or as a block                   */
    const char *origin; /* file name, or the setting if line is 0            borrowed */
    int line;           /* in the file, from 1; 0: a setting; -1: no line             */
    int count;          /* children                                             */
    struct yaml_tree *first; /* child                                          owned */
    struct yaml_tree *next;  /* sibling                                        owned */
};

/* Parses text[size]. Nodes get `origin` and their line, or line 0 if the text is the value
 * of the setting `origin`. STATUS_INPUT with one sentence `origin:line: ...` or
 * `--set origin: ...`, or STATUS_MEMORY; *tree is then untouched. */
enum status yaml_tree_parse(const char *origin, bool setting, const char *text, size_t size,
                            struct yaml_tree **tree, struct message *why);

/* Applies one `key.key[index].key=value`: replaces the node of that path, or adds it to its
 * map. Nodes made have origin `setting` (borrowed) and line 0. STATUS_INPUT with one
 * sentence `--set SETTING: ...`; the tree is then still whole. */
enum status yaml_tree_set(struct yaml_tree *root, const char *setting, struct message *why);

/* Frees a node, its children and its later siblings; NULL is allowed. */
void yaml_tree_free(struct yaml_tree *tree);

/* Return the child of a map by key; the first in the list that it is; NULL if there is
 * none. The map may be NULL. */
struct yaml_tree *yaml_tree_find(const struct yaml_tree *map, const char *key);
struct yaml_tree *yaml_tree_first(const struct yaml_tree *map, const char *key);

/* Writes one sentence `origin:line: ...` or `--set SETTING: ...` without control
 * characters; returns STATUS_INPUT. */
enum status yaml_tree_refuse(const struct yaml_tree *node, struct message *why,
                             const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Describes a node in a sentence: 'text', a list of 3, a section. */
struct yaml_tree_words {
    char text[64];
};
struct yaml_tree_words yaml_tree_describe(const struct yaml_tree *node);

/* Quotes text, cut short, with '?' for what a terminal would obey. */
struct yaml_tree_words yaml_tree_quote(const char *text);

#endif
