#include "models/solid/solid_model.h"

#include <math.h>
#include <stdlib.h>

enum status solid_model_advance(void *state, struct counters *counters)
{
    return solid_motion_step(state, counters);
}

void solid_model_size(const void *state, struct model_size *size)
{
    solid_motion_size(state, size);
}

void solid_model_energy(const void *state, struct energy *energy)
{
    solid_motion_energy(state, energy);
}

enum status solid_model_equilibrium(void *state, struct counters *counters,
                                    struct message *why)
{
    return solid_rest_equilibrium(state, counters, why);
}

enum status solid_model_modes(void *state, int count, double *omega, struct message *why)
{
    return solid_rest_modes(state, count, omega, why);
}

enum status solid_model_refuse(const struct scene *scene, unsigned serves,
                               struct message *why)
{
    unsigned missing = scene_needs(scene) & ~serves;
    char text[256];

    if (!missing)
        return STATUS_OK;
    scene_needs_text(missing, text, sizeof text);
    return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no %s", text);
}

enum status solid_model_basis(const struct scene *scene, const struct discretization *d,
                              bool possible, bool *thickness, struct message *why)
{
    bool can = possible && supports_whole_columns(scene);

    if (d->unknowns == UNKNOWNS_THICKNESS && !can)
        return status_fail(why, STATUS_INPUT,
                           "unknowns=thickness needs one element through the thickness, no "
                           "weights, and supports that take the whole thickness");
    *thickness = can && d->unknowns != UNKNOWNS_POINTS;
    return STATUS_OK;
}

unsigned char *solid_model_parity(const struct scene *scene, int nodes, const int *degree)
{
    const double *u = scene->axis_u, *v = scene->axis_v;
    int normal = -1;

    for (int i = 0; i < 3; i++) {
        double w = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
        if (fabs(w) == 1 && u[i] == 0 && v[i] == 0)
            normal = i;
    }
    if (normal < 0)
        return NULL;
    unsigned char *parity = malloc(3 * (size_t)nodes);
    for (int a = 0; parity && a < nodes; a++)
        for (int i = 0; i < 3; i++)
            parity[3 * a + i] = (unsigned char)((degree[a] + (i == normal)) % 2);
    return parity;
}

int *solid_model_order(int n, int m, int l)
{
    int *order = m > n ? malloc((size_t)n * (size_t)m * (size_t)l * sizeof *order) : NULL;
    int count = 0;

    for (int j = 0; order && j < m; j++)
        for (int i = 0; i < n; i++)
            for (int k = 0; k < l; k++)
                order[count++] = (i * m + j) * l + k;
    return order;
}
