#include "models/damping.h"

#include <stddef.h>

double damping_mass(const struct scene *scene)
{
    switch (scene->damping.kind) {
    case DAMPING_MASS:
        return scene->damping.value;
    case DAMPING_RAYLEIGH:
        return scene->damping.alpha;
    default:
        return 0;
    }
}

double damping_drag(const struct scene *scene)
{
    return scene->drag / scene->density;
}

double damping_stiffness(const struct scene *scene)
{
    return scene->damping.kind == DAMPING_RAYLEIGH ? scene->damping.beta : 0;
}

double damping_velocity(const struct scene *scene)
{
    switch (scene->damping.kind) {
    case DAMPING_VELOCITY_SCALE:
        return scene->damping.value;
    case DAMPING_VELOCITY_RATE:
        return 1 - scene->damping.value * scene->step;
    default:
        return 1;
    }
}

const char *const damping_words[] = {
    [DAMPING_NONE] = "none",
    [DAMPING_VELOCITY_SCALE] = "velocity_scale",
    [DAMPING_VELOCITY_RATE] = "velocity_rate",
    [DAMPING_MASS] = "mass",
    [DAMPING_RAYLEIGH] = "rayleigh",
    NULL,
};
