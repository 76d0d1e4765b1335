#include "models/mechanics/large_return.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

const double large_return_lag = 0.5;

/* The most that a step gives back, of twice the kinetic energy of w. */
static const double SHARE = 0.1;

static size_t count_of(const struct large_motion *m)
{
    return 3 * (size_t)m->graph->nodes;
}

/* Computes y = M x and its mean over the sheet's mass, a row of M summed to a node's. */
static void multiply(const struct large_motion *m, const double *x, double *y,
                     double mean[3])
{
    double mass = 0;

    for (long n = 0, a = 0; a < m->graph->nodes; a++)
        for (; n < m->graph->start[a + 1]; n++)
            mass += (m->graph->node[n] == a ? 1 : 2) * m->M[n];
    blocks_multiply_mass(m->graph, m->M, x, y);
    memset(mean, 0, 3 * sizeof *mean);
    for (size_t t = 0; t < count_of(m); t++)
        mean[t % 3] += y[t] / mass;
}

/* Takes the translation from w that supports have on the mean, and along axes that none
 * holds that of the same momentum: mean; y: work. */
static void take_drift(const struct large_motion *m, double *w, double *y, double mean[3])
{
    double held[3] = {0};
    int count[3] = {0};

    multiply(m, w, y, mean);
    for (int h = 0; h < m->supports->held_count; h++) {
        const int u = m->supports->held[h];
        held[u % 3] += w[u];
        count[u % 3]++;
    }
    for (int i = 0; i < 3; i++)
        mean[i] = count[i] ? held[i] / count[i] : mean[i];
    for (size_t t = 0; t < count_of(m); t++)
        w[t] -= mean[t % 3];
}

/* Takes the turn of the same angular momentum from w, whose momentum is zero; r and y:
 * work. */
static void take_turn(const struct large_motion *m, double *w, double *r, double *y)
{
    static const int FREE[3] = {0};
    const size_t count = count_of(m);
    double mean[3], J[9] = {0}, over[9], spin[3] = {0}, turn[3] = {0}, one[3];

    multiply(m, m->x, y, mean);
    for (size_t t = 0; t < count; t++)
        r[t] = m->x[t] - mean[t % 3];
    blocks_multiply_mass(m->graph, m->M, r, y);
    for (size_t t = 0; t < count; t += 3) {
        vector_cross(y + t, w + t, one);
        for (size_t i = 0; i < 3; i++) {
            spin[i] += one[i];
            for (size_t j = 0; j < 3; j++)
                J[3 * i + j] -= y[t + i] * r[t + j];
        }
    }
    const double trace = J[0] + J[4] + J[8];
    for (int i = 0; i < 3; i++)
        J[4 * i] -= trace;
    if (!blocks_invert(J, FREE, over))
        return;
    for (int i = 0; i < 3; i++)
        turn[i] = vector_dot(over + 3 * i, spin);
    for (size_t t = 0; t < count; t += 3) {
        vector_cross(turn, r + t, one);
        for (size_t i = 0; i < 3; i++)
            w[t + i] -= one[i];
    }
}

enum status large_return_begin(struct large_motion *m)
{
    m->owed = 0;
    return m->body.energy(m->body.self, m->x, &m->elastic);
}

/* Adds what the step from x_old lost to m->owed; f: work. */
static enum status add_loss(struct large_motion *m, const double *x_old, double *f)
{
    const struct large_path path = {.s0 = 0.5,
                                    .s1 = 0.5,
                                    .g1 = 0.5,
                                    .lag = m->lag,
                                    .x_old = x_old,
                                    .strain_old = m->strain_old};
    const double before = m->elastic;
    enum status st = large_body_force(&m->body, &path, m->x, f);

    if (st == STATUS_OK)
        st = m->body.energy(m->body.self, m->x, &m->elastic);
    m->owed += before - m->elastic;
    for (size_t t = 0; t < count_of(m); t++)
        m->owed += f[t] * (m->x[t] - x_old[t]);
    return st;
}

enum status large_return_give(struct large_motion *m, double dt, const double *x_old,
                              double *work)
{
    const size_t count = count_of(m);
    double *w = work, *r = work + count, *y = work + 2 * count, *v = m->newmark->v;
    double drift[3], square = 0, along = 0;
    enum status st = add_loss(m, x_old, w);

    if (st != STATUS_OK)
        return st;
    for (size_t t = 0; t < count; t++)
        w[t] = (m->x[t] - x_old[t]) / dt;
    take_drift(m, w, y, drift);
    if (m->supports->held_count == 0)
        take_turn(m, w, r, y);
    for (int h = 0; h < m->supports->held_count; h++)
        w[m->supports->held[h]] = 0;
    blocks_multiply_mass(m->graph, m->M, w, y);
    for (size_t t = 0; t < count; t++) {
        square += w[t] * y[t];
        along += y[t] * (v[t] - drift[t % 3]);
    }
    const double gift = fmax(-SHARE * square, fmin(SHARE * square, m->owed));
    const double root = along * along + 2 * square * gift;
    if (!(square > 0 && root > 0))
        return STATUS_OK;
    const double c = 2 * gift / (along + copysign(sqrt(root), along));
    for (size_t t = 0; t < count; t++)
        v[t] += c * w[t];
    m->owed -= gift;
    return STATUS_OK;
}
