#include "bench/harness/derived_key.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static double young_over_density(const struct scene *scene)
{
    return scene->young / scene->density;
}

/* The derived numbers, which are a power of E with all else as it is. */
static const struct derived_key {
    const char *key;
    double (*number)(const struct scene *scene);
    double power;
} all[] = {{"gamma", scene_gamma, -1}, {"young_over_density", young_over_density, 1}};

static const struct derived_key *find(const char *key)
{
    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        if (!strcmp(all[n].key, key))
            return &all[n];
    return NULL;
}

bool derived_key_is(const char *key)
{
    return find(key) != NULL;
}

double derived_key_number(const char *key, const struct scene *scene)
{
    return find(key)->number(scene);
}

double derived_key_young(const char *key, double want, const struct scene *scene)
{
    const struct derived_key *s = find(key);
    const double now = s->number(scene);

    return !scene->is_fabric && now > 0 ? scene->young * pow(want / now, 1 / s->power)
                                        : NAN;
}
