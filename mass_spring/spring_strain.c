#include "mass_spring/spring_strain.h"

#include <math.h>
#include <stddef.h>

#include "models/vector.h"

enum { MOST_SWEEPS = 1000 };

/* A spring is still too long if it exceeds the limit by more than this share of it. */
static const double SLACK = 1e-3;

static double length_of(const struct spring *s, const double *x, double e[3])
{
    vector_between(x + 3 * (size_t)s->a, x + 3 * (size_t)s->b, e);
    return vector_length(e);
}

/* Shortens a spring; returns whether it was too long and could be moved. */
static bool shorten(const struct spring *s, const struct supports *supports, double limit,
                    double *x)
{
    double e[3], length = length_of(s, x, e);
    double excess = length - (1 + limit) * s->length;
    const int *place = supports->free_index;
    bool moved = false;

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

double spring_strain_largest(const struct spring_net *net, const double *x)
{
    double most = -1, e[3];

    for (int n = 0; n < net->spring_count; n++) {
        const struct spring *s = &net->springs[n];
        most = fmax(most, length_of(s, x, e) / s->length - 1);
    }
    return most;
}
