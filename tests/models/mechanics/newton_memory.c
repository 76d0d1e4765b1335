/* Tests what a kept tangent learns: the secant equation of the last change, symmetry, and
 * that neither a change without curvature nor one more than there is room for is learnt. */
#include "models/mechanics/newton_memory.h"

#include "tests/check.h"

enum { COUNT = 6 };

/* Sums of six products of numbers of order 1, eight times. */
static const double ROUND_OFF = 1e-12;

/* Returns number t of the k-th of some vectors that are not parallel. */
static double some(int k, int t)
{
    return sin(1 + 2.3 * k * k + 1.7 * t * (k + 1));
}

/* Computes what the true stiffness, positive definite, makes of d. */
static void stiffen(const double *d, double *f)
{
    for (int t = 0; t < COUNT; t++)
        f[t] = (3 + t) * d[t] + d[(t + 1) % COUNT] + d[(t + COUNT - 1) % COUNT];
}

/* Solves with the kept tangent, twice the unit matrix, corrected. */
static void solve(const struct newton_memory *m, double *b)
{
    double share[NEWTON_LEARNT];

    newton_memory_correct(m, b, share, false);
    for (int t = 0; t < COUNT; t++)
        b[t] /= 2;
    newton_memory_correct(m, b, share, true);
}

/* Learns from the k-th vector. */
static void learn(struct newton_memory *m, int k, double sign)
{
    double d[COUNT], before[COUNT], r[COUNT], fall[COUNT];

    for (int t = 0; t < COUNT; t++)
        d[t] = some(k, t);
    stiffen(d, fall);
    for (int t = 0; t < COUNT; t++)
        before[t] = sign * 2 * fall[t], r[t] = before[t] - sign * fall[t];
    newton_memory_learn(m, d, before, r);
}

int main(void)
{
    double pairs[2 * NEWTON_LEARNT * COUNT];
    struct newton_memory m = {.count = COUNT, .pairs = pairs};

    for (int k = 0; k < NEWTON_LEARNT; k++) {
        double d[COUNT], x[COUNT], a[COUNT], b[COUNT], ab = 0, ba = 0;
        learn(&m, k, 1);
        CHECK(m.known == k + 1);
        for (int t = 0; t < COUNT; t++)
            d[t] = some(k, t), a[t] = some(k + 20, t), b[t] = some(k + 40, t);
        stiffen(d, x);
        solve(&m, x);
        for (int t = 0; t < COUNT; t++)
            CHECK_NEAR(x[t], d[t], ROUND_OFF);
        solve(&m, a), solve(&m, b);
        for (int t = 0; t < COUNT; t++)
            ab += a[t] * some(k + 40, t), ba += b[t] * some(k + 20, t);
        CHECK_NEAR(ab, ba, ROUND_OFF);
    }
    learn(&m, NEWTON_LEARNT, 1);
    CHECK(m.known == NEWTON_LEARNT);
    m.known = 0;
    learn(&m, 0, -1);
    CHECK(m.known == 0);
    return check_result();
}
