#include "models/solid/solid_large.h"

#include <math.h>
#include <stdlib.h>

#include "models/mechanics/large_leapfrog.h"
#include "models/mechanics/large_rest.h"
#include "models/solid/solid_green.h"

struct solid_large {
    struct solid_green green;
    struct large_motion motion;
    double (*K)[9]; /* [pairs] tangent; the assembly keeps the stiffness at rest       */
};

void solid_large_destroy(struct solid_large *large)
{
    if (!large)
        return;
    large_motion_clear(&large->motion);
    solid_green_clear(&large->green);
    free(large->K);
    free(large);
}

enum status solid_large_create(struct solid_motion *m, const struct discretization *d,
                               struct solid_large **large, struct message *why)
{
    enum status st;
    const struct blocks *graph = &m->assembly.graph;
    struct solid_large *new = calloc(1, sizeof *new);

    if (!new)
        TRY(STATUS_MEMORY);
    TRY(solid_green_init(&new->green, &m->assembly));
    new->K = malloc((size_t)graph->start[graph->nodes] * sizeof *new->K);
    if (!new->K)
        TRY(STATUS_MEMORY);
    new->motion = (struct large_motion){
        .body = new->green.body,
        .scene = m->scene,
        .graph = graph,
        .M = m->assembly.M,
        .rest = m->space->rest,
        .load = m->load,
        .supports = &m->supports,
        .system = &m->system,
        .newmark = &m->newmark,
        .K = new->K,
        .x = m->x,
        .held = m->held,
        .relief = d->viscosity == VISCOSITY_MEMBRANE,
        .full = d->newton == NEWTON_FULL,
        .contact = m->scene->obstacle_count ? &m->contact : NULL,
    };
    TRY(large_motion_init(&new->motion));
    TRY(large_leapfrog_make(&new->motion, d, why));
    *large = new, new = NULL;
out:
    solid_large_destroy(new);
    return st;
}

enum status solid_large_step(struct solid_motion *m, struct counters *counters)
{
    return large_motion_step(&m->large->motion, m->time, counters);
}

void solid_large_describe(const struct solid_motion *m, struct message *line)
{
    large_leapfrog_describe(&m->large->motion, line);
}

enum status solid_large_equilibrium(struct solid_motion *m, struct counters *counters,
                                    struct message *why)
{
    m->time = supports_rest_time(&m->supports, m->scene);
    return large_rest_equilibrium(&m->large->motion, counters, why);
}

enum status solid_large_modes(struct solid_motion *m, int count, double *omega,
                              struct message *why)
{
    return large_rest_modes(&m->large->motion, count, omega, why);
}

bool solid_large_rested(const struct solid_motion *m)
{
    return m->large->motion.rested;
}

void solid_large_contact(const struct solid_motion *m, struct model_contact *contact)
{
    large_motion_contact(&m->large->motion, contact);
}

double solid_large_energy(const struct solid_motion *m)
{
    double energy = NAN;

    return solid_green_energy(&m->large->green, m->x, &energy) == STATUS_OK ? energy : NAN;
}
