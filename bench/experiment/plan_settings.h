/* plan_settings.h - keys and values as a plan gives them, each with its line. */
#ifndef PLAN_SETTINGS_H
#define PLAN_SETTINGS_H

#include "models/reader/yaml_tree.h"

struct plan_setting {
    char *key, *value; /* as --set takes them: KEY=VALUE                         owned */
    int line;          /* in the plan                                                  */
};

struct plan_settings {
    int count;
    struct plan_setting *list; /* owned                                                */
};

/* Adds the children of a map {KEY: VALUE, ...} or of a list of such maps; `what` names the
 * node in sentences. STATUS_INPUT with one sentence: not such a thing, a key given twice;
 * STATUS_MEMORY. */
enum status plan_settings_read(const struct yaml_tree *node, const char *what,
                               struct plan_settings *settings, struct message *why);

/* Adds a key with the value that `node` has, or with the text `value`. STATUS_INPUT: a text
 * that does not fit a line. */
enum status plan_settings_add(struct plan_settings *settings, const char *key,
                              const struct yaml_tree *node, struct message *why);
enum status plan_settings_add_text(struct plan_settings *settings, const char *key,
                                   const char *value, int line);

/* The setting of a key; NULL if there is none. */
const struct plan_setting *plan_settings_find(const struct plan_settings *settings,
                                              const char *key);

void plan_settings_clear(struct plan_settings *settings); /* all-zero is allowed */

#endif
