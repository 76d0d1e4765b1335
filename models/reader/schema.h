/* schema.h - what tables of keys (schema_key.h) do: read, refuse, print and document. */
#ifndef SCHEMA_H
#define SCHEMA_H

#include <stdio.h>

#include "models/reader/yaml_tree.h"
#include "models/schema_key.h"

/* Reads the map `node`, called `name` in sentences, into *target. STATUS_INPUT with one
 * sentence that names the node's origin, or STATUS_MEMORY; *target then owns what it owned
 * and what was read so far. */
enum status schema_read(const struct schema_key *keys, const struct yaml_tree *node,
                        const char *name, void *target, struct message *why);

/* Reads the value of one key into *target. Errors likewise. */
enum status schema_value(const struct schema_key *key, const struct yaml_tree *node,
                         void *target, struct message *why);

/* Reads, for special readers, a finite number inside the key's range. Errors likewise. */
enum status schema_number(const struct schema_key *key, const struct yaml_tree *node,
                          double *value, struct message *why);

/* Reads likewise a line of text that is not empty and has no control characters, owned, in
 * place of *text. */
enum status schema_text(const struct schema_key *key, const struct yaml_tree *node,
                        char **text, struct message *why);

/* Fails with the sentence "KEY is FOUND, but must be WANTED". */
enum status schema_refuse(const struct schema_key *key, const struct yaml_tree *node,
                          struct message *why);

/* Fails with the sentence "NAME lacks the key 'KEY', WANTED". */
enum status schema_lacks(const struct schema_key *key, const struct yaml_tree *node,
                         const char *name, struct message *why);

/* Calls line() once a key of the table and its sections, as `prefix` + section.key. */
void schema_list(const struct schema_key *keys, const char *prefix,
                 void (*line)(void *context, const char *key, const char *text),
                 void *context);

/* Lines `prefix` + key=value as a setting is written, 17 digits; arrays that are NULL are
 * left out, and keys that are not listed. For tables of numbers, counts and words. */
void schema_print(const struct schema_key *keys, const char *prefix, const void *source,
                  FILE *out);

#endif
