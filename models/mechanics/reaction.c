#include "models/mechanics/reaction.h"

#include <math.h>
#include <string.h>

#include "models/contact/contact.h"

void reaction_add(const struct supports *s, const double *left, const double *at,
                  double share, double (*support)[6])
{
    for (int h = 0; h < s->held_count; h++) {
        const int u = s->held[h], owner = s->owner[h];
        const size_t first = 3 * (size_t)(u / 3);
        const bool framed = s->frame_count && s->framed[u / 3] >= 0;
        double force[3] = {0}, sum[6] = {0};
        if (owner == SUPPORTS_NOBODY || (framed && u % 3 != 1))
            continue;
        for (int i = 0; i < 3; i++)
            force[i] = framed || i == u % 3 ? left[first + i] : 0;
        contact_force_at(at + first, force, -share, sum);
        for (int i = owner < 0 ? 3 : 0; i < 6; i++)
            support[owner < 0 ? -1 - owner : owner][i] += sum[i];
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
        contact_force_at(at + 3 * a, slope + 3 * a, -share, sum);
    for (int n = 0; n < scene->support_count; n++)
        for (int i = 3; i < 6; i++)
            support[n][i] = scene->support_count == 1 ? support[n][i] + sum[i] : NAN;
}
