/* Tests sweeps of a net that no force acts on, by themselves: it flies a hundred lengths as
 * it was thrown, each point as its own, in single precision, too, whose point follows; and
 * points are placed where they are held. */
#include "models/net/spring_sweep.h"

#include "tests/check.h"

enum { N = 5, M = 4, NODES = N * M, STEPS = 100, TURNS = 10 };
static const double DT = 1e-3;

static void check_flight(enum precision precision, double tolerance)
{
    static const double thrown[3] = {100, -3, 7};
    const struct spring_sweep_plan plan = {.n = N,
                                           .m = M,
                                           .sheet = N,
                                           .precision = precision,
                                           .origin = {.length = 1, .carried = true}};
    double c[NODES][SWEEP_COUNT] = {{0}}, x[3 * NODES], v[3 * NODES], y[3 * NODES],
           w[3 * NODES];
    struct spring_sweep *s;
    int followed = 0;

    for (int a = 0; a < NODES; a++) {
        c[a][SWEEP_KEEP] = 1;
        for (int i = 0; i < 3; i++) {
            c[a][SWEEP_FREE + i] = 1;
            x[3 * a + i] = i == 0 ? a / M / 4. : i == 1 ? a % M / 4. : 0;
            v[3 * a + i] = thrown[i] + 0.1 * sin(3 * a + i);
        }
    }
    REQUIRE(spring_sweep_make(&plan, &s) == STATUS_OK);
    spring_sweep_set(s, (const double(*)[SWEEP_COUNT])c);
    spring_sweep_put(s, x, v);
    for (int n = 0; n < TURNS; n++) {
        spring_sweep_run(s, DT, STEPS);
        spring_sweep_get(s, y, w);
        followed += spring_sweep_follow(s, y, w);
        spring_sweep_set(s, (const double(*)[SWEEP_COUNT])c);
    }
    CHECK(followed > 0);
    for (int t = 0; t < 3 * NODES; t++) {
        CHECK_NEAR(y[t], x[t] + TURNS * STEPS * DT * v[t], tolerance);
        CHECK_NEAR(w[t], v[t], tolerance);
    }
    spring_sweep_hold(s, 7, 1, 2.5, -0.5);
    spring_sweep_get(s, y, w);
    CHECK_NEAR(y[3 * 7 + 1], 2.5, tolerance);
    CHECK_NEAR(w[3 * 7 + 1], -0.5, tolerance);
    spring_sweep_free(s);
}

int main(void)
{
    /* A step rounds places within four lengths of the point by 2^-23 at most, a thousand by
     * 1.2e-4; the first hundred steps, up to ten lengths away, by 5e-5. */
    check_flight(PRECISION_SINGLE, 1.7e-4);
    check_flight(PRECISION_DOUBLE, 1e-11);
    return check_result();
}
