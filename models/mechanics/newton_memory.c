#include "models/mechanics/newton_memory.h"

/* The least curvature of a change that is learnt from, over what it was driven by: the
 * corrected tangent's condition is at most its inverse times that of the tangent. */
static const double LEAST_CURVE = 1e-2;

void newton_memory_learn(struct newton_memory *m, const double *d, const double *before,
                         const double *r)
{
    double *step = m->pairs + 2 * m->known * m->count, *fall = step + m->count, curve = 0;
    double driven = 0;

    if (m->known == NEWTON_LEARNT)
        return;
    for (size_t t = 0; t < m->count; t++) {
        step[t] = d[t], fall[t] = before[t] - r[t];
        curve += step[t] * fall[t], driven += step[t] * before[t];
    }
    m->curve[m->known] = curve;
    m->known += curve > LEAST_CURVE * driven && driven > 0;
}

void newton_memory_correct(const struct newton_memory *m, double *b, double *share,
                           bool solved)
{
    for (int n = 0; n < m->known; n++) {
        const int k = solved ? n : m->known - 1 - n;
        const double *step = m->pairs + 2 * k * m->count, *fall = step + m->count;
        double sum = 0;
        for (size_t t = 0; t < m->count; t++)
            sum += b[t] * (solved ? fall[t] : step[t]);
        sum /= m->curve[k];
        share[k] = solved ? share[k] - sum : sum;
        for (size_t t = 0; t < m->count; t++)
            b[t] += solved ? share[k] * step[t] : -share[k] * fall[t];
    }
}
