#include "bench/harness/derived_key.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static double young_over_density(const struct scene *scene)
{
    return scene->young / scene->density;
}

/* The derived numbers are products of powers of these keys. */
enum { KEYS = 4 };
static const struct derived_key {
    const char *key;
    double (*number)(const struct scene *scene);
    struct {
        const char *by;
        double power;
        size_t offset; /* in struct scene */
    } of[KEYS];
} all[] = {
    {"gamma",
     scene_gamma,
     {{"material.young", -1, offsetof(struct scene, young)},
      {"material.density", 1, offsetof(struct scene, density)},
      {"sheet.thickness", -2, offsetof(struct scene, thickness)},
      {"sheet.length", 3, offsetof(struct scene, length)}}},
    {"young_over_density",
     young_over_density,
     {{"material.young", 1, offsetof(struct scene, young)},
      {"material.density", -1, offsetof(struct scene, density)}}},
};
enum { ALL = sizeof all / sizeof *all };

static const struct derived_key *find(const char *key)
{
    for (int n = 0; n < ALL; n++)
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

double derived_key_solve(const char *key, const char *by, double want,
                         const struct scene *scene)
{
    const struct derived_key *s = find(key);
    const double now = s->number(scene);

    /* the moduli and the mass of a fabric are none of these keys */
    if (scene->is_fabric && strcmp(by, "sheet.length"))
        return NAN;
    for (int n = 0; n < KEYS && s->of[n].by; n++)
        if (!strcmp(s->of[n].by, by) && now > 0)
            return *(const double *)((const char *)scene + s->of[n].offset) *
                   pow(want / now, 1 / s->of[n].power);
    return NAN;
}
