#include "mass_spring/spring_strain.h"

#include <stddef.h>

#include "models/vector.h"

enum { MOST_SWEEPS = 1000 };

/* A spring is still too long if it exceeds the limit by more than this share of it. */
static const double SLACK = 1e-3;

/* Shortens a spring; returns whether it was too long and could be moved. */
static bool shorten(const struct spring *s, const struct supports *supports, double limit,
                    double *x)
{
    double e[3];
    const int *place = supports->free_index;
    bool moved = false;

    vector_between(x + 3 * (size_t)s->a, x + 3 * (size_t)s->b, e);
    double length = vector_length(e), excess = length - (1 + limit) * s->length;
    if (!(excess > SLACK * limit * s->length))
        return false;
    for (int i = 0; i < 3; i++) {
        size_t a = 3 * (size_t)s->a + (size_t)i, b = 3 * (size_t)s->b + (size_t)i;
        double by = excess / length * e[i];
        bool a_free = place[a] >= 0, b_free = place[b] >= 0;
        if (a_free)
            x[a] += b_free ? by / 2 : by;
        if (b_free)
            x[b] -= a_free ? by / 2 : by;
        moved |= a_free || b_free;
    }
    return moved;
}

void spring_strain_limit(const struct spring_net *net, const struct supports *supports,
                         double limit, double *x)
{
    bool moved = true;

    for (int sweep = 0; moved && sweep < MOST_SWEEPS; sweep++) {
        moved = false;
        for (int n = 0; n < net->spring_count; n++) {
            int at = sweep % 2 ? net->spring_count - 1 - n : n;
            moved |= shorten(&net->springs[at], supports, limit, x);
        }
    }
}
