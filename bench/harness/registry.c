#include "bench/harness/registry.h"

#include <stdio.h>
#include <string.h>

#include "fem_ref/hex_model.h"
#include "iga/plate_model.h"
#include "mass_spring/spring_model.h"
#include "projective_dynamics/projective_dynamics_model.h"
#include "shell_ref/shell_model.h"

const struct model *const registry[] = {
    &plate_model, &hex_model, &shell_model, &spring_model, &projective_dynamics_model, NULL,
};

void registry_names(char *text, int size)
{
    int used = 0;

    *text = '\0';
    for (int n = 0; registry[n] && used < size; n++)
        used += snprintf(text + used, (size_t)(size - used), "%s%s", n ? ", " : "",
                         registry[n]->name);
}

enum status registry_find(const char *name, const struct model **model, struct message *why)
{
    char names[256];

    for (int n = 0; registry[n]; n++)
        if (!strcmp(registry[n]->name, name)) {
            *model = registry[n];
            return STATUS_OK;
        }
    registry_names(names, sizeof names);
    return status_fail(why, STATUS_INPUT, "there is no model '%s'; models: %s", name,
                       names);
}
