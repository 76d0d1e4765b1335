/* registry.h - the only list of the models. */
#ifndef REGISTRY_H
#define REGISTRY_H

#include "models/model.h"

/* All that are built, in the order of the tables; ends with NULL. */
extern const struct model *const registry[];

/* By its name. STATUS_INPUT with a sentence that lists the names: no such model. */
enum status registry_find(const char *name, const struct model **model,
                          struct message *why);

/* "iga, hex" into text[size]. */
void registry_names(char *text, int size);

#endif
