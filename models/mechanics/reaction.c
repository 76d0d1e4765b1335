#include "models/mechanics/reaction.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

/* Adds `times` a moment, and, unless it is that of a couple, a force. */
static void add(const double at[3], const double force[3], bool couple, double times,
                double sum[6])
{
    double moment[3];

    vector_cross(at, force, moment);
    for (int i = 0; i < 3; i++) {
        sum[i] += couple ? 0 : times * force[i];
        sum[3 + i] += times * moment[i];
    }
}

void reaction_add(const struct supports *s, const double *left, const double *at,
                  double share, double (*support)[6])
{
    for (int h = 0; h < s->held_count; h++) {
        const int u = s->held[h], owner = s->owner[h];
        const size_t first = 3 * (size_t)(u / 3);
        const bool framed = s->frame_count && s->framed[u / 3] >= 0;
        double force[3] = {0};
        if (owner == SUPPORTS_NOBODY || (framed && u % 3 != 1))
            continue;
        for (int i = 0; i < 3; i++)
            force[i] = framed || i == u % 3 ? left[first + i] : 0;
        add(at + first, force, owner < 0, -share, support[owner < 0 ? -1 - owner : owner]);
    }
}

void reaction_inertia(const struct supports *s, const struct scene *scene, double t,
                      double dt, const double *mass, const double *drag, double *shift,
                      double *left)
{
    for (int k = -1; s->moving && k < 2; k++) {
        const double a = (k ? 1 : -2) / (dt * dt), v = k / (2 * dt);
        supports_shift(s, scene, t + k * dt, shift);
        for (int h = 0; h < s->held_count; h++) {
            const int u = s->held[h];
            left[u] -= (a * mass[u / 3] + v * drag[u / 3]) * shift[h];
        }
    }
}

void reaction_clamps(const struct scene *scene, int nodes, const double *slope,
                     const double *at, double share, double (*support)[6])
{
    double sum[6] = {0};

    for (size_t a = 0; a < (size_t)nodes; a++)
        add(at + 3 * a, slope + 3 * a, true, -share, sum);
    for (int n = 0; n < scene->support_count; n++)
        for (int i = 3; i < 6; i++)
            support[n][i] = scene->support_count == 1 ? support[n][i] + sum[i] : NAN;
}

void reaction_begin(struct march *m, bool weighed)
{
    m->weighed = weighed;
    for (int n = 0; n < m->scene->support_count; n++)
        memset(m->reaction[n], 0, sizeof *m->reaction);
    for (int o = 0; o < m->scene->obstacle_count; o++)
        memset(m->push[o], 0, sizeof *m->push);
}

enum status reaction_weigh(struct march *m, const struct large_equation *q, double share)
{
    enum status st;
    const size_t count = march_count(m);
    const double g = q->path.g1;
    double *left = m->work + count, *at = left + count;

    for (size_t t = 0; t < count; t++)
        at[t] = g == 1 ? m->x[t] : (1 - g) * q->path.x_old[t] + g * m->x[t];
    if (m->clamps) {
        TRY(large_body_force(&m->body, &q->path, m->x, left));
        reaction_clamps(m->scene, m->graph->nodes, left, at, share, m->reaction);
    }
    TRY(large_newton_left(m, q, m->x, left));
    reaction_add(m->supports, left, at, share, m->reaction);
out:
    return st;
}

enum status march_forces(void *state, double (*support)[6], double (*body)[6])
{
    struct march *m = state;

    m->weighs |= !support && !body;
    for (int n = 0; support && n < 6 * m->scene->support_count; n++)
        support[n / 6][n % 6] = m->weighed ? m->reaction[n / 6][n % 6] : NAN;
    for (int n = 0; body && n < 6 * m->scene->obstacle_count; n++)
        body[n / 6][n % 6] =
            m->weighed && !m->outside.face[0].count ? m->push[n / 6][n % 6] : NAN;
    return STATUS_OK;
}
