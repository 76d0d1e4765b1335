#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims, since the equations are the same: round-off of a solve, over tens of steps, for a
 * linear model; others iterate to 1e-7 L, or as set below. */
#define EXACT    1e-8, NULL
#define ITERATED 1e-6, NULL

enum { STEPS = 60, TIMES = 3, POINTS = 6 };
static const double DT = 0.005, PUSH[3] = {0.5, -0.3, 4};

/* Those marked have the velocity of the step before, as with implicit Euler. */
#define CLOSE "discretization.tolerance=1e-9"
#define LONG  "discretization.iterations=100000", "discretization.acceleration=chebyshev"
#define LATE  "starts without acceleration"
static const struct verify_subject entries[] = {
    {"iga_linear", EXACT, {8}, {6}},
    {"iga_paper,iga_incremental", 0, LATE, {8}, {6}},
    {"iga_nonlinear", ITERATED, {8}, {6}},
    {"hex_linear", EXACT, {8}, {6}},
    {"hex_nonlinear", ITERATED, {8}, {6}},
    {"shell_linear", EXACT, {8}, {6}},
    {"shell_2", ITERATED, {8}, {6}},
    {"triangles", ITERATED, {11}},
    {"mass_spring", ITERATED, {11}, .settings = {CLOSE}, .mark = true},
    {"mass_spring_momentum", ITERATED, {11}},
    {"projective_dynamics", ITERATED, {11}, .settings = {CLOSE, LONG}, .mark = true},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {8}, {6}};

/* Returns the edge's way over PUSH after n steps, a parabola; for implicit Euler the sum of
 * its velocities n dt, which it sees in whole steps. */
static double way(const struct verify_subject *s, int n)
{
    return s->mark ? DT * DT * n * (n + 1) / 2 : DT * DT * n * n / 2;
}

/* Sets the path, with a row before the start and one after the end for its differences. */
static void add_path(const struct verify_subject *s, struct settings *all)
{
    settings_set(all, "supports=[{at: {u: 0}, fix: xyz, path: [");
    for (int n = -1; n <= STEPS + 1; n++) {
        double d = n < 0 && s->mark ? 0 : way(s, n);
        settings_more(all, "%s[%.17g,%.17g,%.17g,%.17g]", n < 0 ? "" : ",", n * DT,
                      PUSH[0] * d, PUSH[1] * d, PUSH[2] * d);
    }
    settings_more(all, "]}]");
}

static void add_row(struct verify_subject *s)
{
    static const double uvw[POINTS][3] = {{0, 0.5, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0.5},
                                          {1, 0.5, 0},   {1, 0.5, 1},     {1, 1, 0.5}};
    const double time[TIMES] = {0.1, 0.2, STEPS * DT};
    double at[2][TIMES * POINTS * 3]; /* still and moved */
    struct verify_trial t =
        verify_trial_of(s, "moving_edge", "seen from the edge / L, until %g s", STEPS * DT);

    for (int moved = 0; moved < 2; moved++) {
        if (moved)
            add_path(s, &t.settings);
        else
            verify_trial_set(&t, "supports=[{at: {u: 0}, fix: xyz}]; gravity=[%g,%g,%g]",
                             -PUSH[0], -PUSH[1], -PUSH[2]);
        settings_set(&t.settings, "damping={kind: none}");
        if (!verify_trial_motion(&t, TIMES, time, POINTS, uvw[0], at[moved]))
            return;
    }
    for (int n = 0; n < TIMES * POINTS * 3; n++) {
        const double led = way(s, (int)lround(time[n / 3 / POINTS] / DT));
        at[1][n] -= PUSH[n % 3] * led;
    }
    verify_row_judge_error(t.row, verify_row_apart(TIMES * POINTS * 3, at[1], at[0]), 0);
}

const struct verify_check verify_moving = {
    {"moving", "a plate whose held edge is accelerated along a path"},
    "the same model under the inertial force, edge at rest: equal equations",
    .parts = {{&field, add_row, 1}}};
