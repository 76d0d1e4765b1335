/* plan_settings.h - keys and values as a plan gives them, each with its line. */
#ifndef PLAN_SETTINGS_H
#define PLAN_SETTINGS_H

#include "models/reader/schema.h"

struct plan_setting {
    char *key, *value; /* as --set takes them: KEY=VALUE                         owned */
    int line;          /* in the plan                                                  */
};

struct plan_settings {
    int count;
    struct plan_setting *list; /* owned                                                */
};

/* Adds a key with the value that `node` has, or with the text `value`. STATUS_INPUT: a text
 * that does not fit a line. */
enum status plan_settings_add(struct plan_settings *settings, const char *key,
                              const struct yaml_tree *node, struct message *why);
enum status plan_settings_add_text(struct plan_settings *settings, const char *key,
                                   const char *value, int line);

/* Readers of schema.h, into the struct plan_settings at key->offset: the children of a map
 * {KEY: VALUE, ...} or of a list of such maps; the key itself with its value, a word.
 * STATUS_INPUT with one sentence: not such a thing, a key given twice; STATUS_MEMORY. */
enum status plan_settings_read_key(const struct schema_key *key,
                                   const struct yaml_tree *node, void *target,
                                   struct message *why);
enum status plan_settings_read_word(const struct schema_key *key,
                                    const struct yaml_tree *node, void *target,
                                    struct message *why);

/* For readers of a list of key->low to key->most things of so many bytes: room for all of
 * them, all-zero, freed by the receiver, and each read into it. *count has what was begun,
 * on failure, too. NULL: *st says why. */
void *plan_settings_list(const struct schema_key *key, const struct yaml_tree *node,
                         size_t size, int *count,
                         enum status read(const struct yaml_tree *node, void *element,
                                          struct message *why),
                         enum status *st, struct message *why);

/* The words of schema.h for 0 and 1. */
const char *plan_settings_truth(int value);

/* The setting of a key; NULL if there is none. */
const struct plan_setting *plan_settings_find(const struct plan_settings *settings,
                                              const char *key);

void plan_settings_clear(struct plan_settings *settings); /* all-zero is allowed */

#endif
