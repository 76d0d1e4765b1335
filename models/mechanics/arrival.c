#include "models/mechanics/arrival.h"

#include <math.h>

/* The shares of the sheet's length that are no movement in a step, and that positions are
 * rounded by, with a margin of a hundred. */
static const double NO_MOVE = 1e-10, ROUNDED = 1e-14;

void arrival_init(struct arrival *a, int iterations, int limit, double loads, double mass,
                  int nodes, const struct scene *scene, double dt)
{
    const double stiffness = nodes * scene->young * scene->thickness;

    *a = (struct arrival){.fixed = iterations > 0,
                          .most = iterations > 0 ? iterations : limit,
                          .first = 1,
                          .loads = loads,
                          .nothing = scene->length *
                                     (NO_MOVE * mass / (dt * dt) + ROUNDED * stiffness)};
}

double arrival_sum(int nodes, const int *place, bool free, const double *mass,
                   const double *vectors)
{
    double sum = 0;

    for (int a = 0; a < nodes; a++) {
        double square = 0;
        for (int c = 3 * a; c < 3 * a + 3; c++)
            square += (place[c] >= 0) == free ? vectors[c] * vectors[c] : 0;
        sum += (mass ? mass[a] : 1) * sqrt(square);
    }
    return sum;
}

/* Goes on by a quarter: a measurement may cost as much as an iteration. */
int arrival_next(const struct arrival *a, int done)
{
    const int next = done ? done + (done + 3) / 4 : a->first;

    return a->fixed || next > a->most ? a->most : next;
}

bool arrival_ends(struct arrival *a, int done, const struct arrival_forces *f, double t)
{
    const double loads = a->loads > 0 ? a->loads : f->held,
                 left = f->left <= a->nothing ? 0 : f->left / fmax(loads, f->momentum);
    const bool arrived = left <= ARRIVAL_SHARE;

    if (!arrived && done < a->most)
        return false;
    if (!(left <= a->left))
        a->left = left, a->left_time = t;
    a->missed += !arrived && !a->fixed;
    a->first = done - done / 4; /* the next step is much the same */
    return true;
}

void arrival_count(const struct arrival *a, struct counters *counters)
{
    counters->left = a->left;
    counters->missed = a->missed;
    counters->astray = a->fixed && a->descends && a->left > ARRIVAL_ASTRAY ? a->left : 0;
}

void arrival_doubt(const struct arrival *a, struct message *line)
{
    if (a->fixed && a->left > ARRIVAL_SHARE)
        status_fail(
            line, STATUS_OK,
            "the number of iterations, %d, is fixed: in the step to t = %.4g s they "
            "left %.2g %% of the loads, or of the change of momentum, unbalanced; "
            "without the number they go on to %g %%",
            a->most, a->left_time, 100 * a->left, 100 * ARRIVAL_SHARE);
}

void arrival_describe(const struct arrival *a, const char *iterations, struct message *line)
{
    if (a->fixed)
        message_add(line, "%d %s, a fixed number", a->most, iterations);
    else
        message_add(line, "%s until %g %% of the loads are left, at most %d", iterations,
                    100 * ARRIVAL_SHARE, a->most);
}
