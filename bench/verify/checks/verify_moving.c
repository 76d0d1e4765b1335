/* A plate whose held edge is accelerated: seen from the edge, a plate at rest under an
 * inertial force. */
#include <math.h>
#include <stdio.h>

#include "bench/verify/verify.h"

extern const struct verify_check verify_moving;

/* Both are the same equations: round-off of a solve, over tens of steps, for a linear
 * model; where Newton's method or others iterate they end at 1e-7 L, or at what is asked.
 */
static const double EXACT = 1e-8, ITERATED = 1e-6;

enum { STEPS = 60, TIMES = 3, POINTS = 6, PATH_TEXT = 12288 };
static const double DT = 0.005, PUSH[3] = {0.5, -0.3, 4};

struct subject {
    struct verify_subject subject;
    bool euler; /* its velocities are those of the step before                         */
};

#define SOLID(k) "discretization.points=[8,6,2] discretization.kinematics=" k
#define SHELL(k) "discretization.points=[8,6] discretization.kinematics=" k
#define LATE     "starts without acceleration"
#define ITERATES "discretization.points=[11,11] discretization.tolerance=1e-9"
static const struct subject subjects[] = {
    {{"iga, linear", "iga", SOLID("linear"), EXACT, NULL}, false},
    {{"iga, printed", "iga", SOLID("printed"), NAN, LATE}, false},
    {{"iga, incremental", "iga", SOLID("incremental"), NAN, LATE}, false},
    {{"iga, nonlinear", "iga", SOLID("nonlinear"), ITERATED, NULL}, false},
    {{"hex, linear", "hex", SOLID("linear"), EXACT, NULL}, false},
    {{"hex, nonlinear", "hex", SOLID("nonlinear"), ITERATED, NULL}, false},
    {{"shell, linear", "shell", SHELL("linear"), EXACT, NULL}, false},
    {{"shell, nonlinear", "shell", SHELL("nonlinear"), ITERATED, NULL}, false},
    {{"mass_spring", "mass_spring", ITERATES, ITERATED, NULL}, true},
    {{"projective_dynamics", "projective_dynamics",
      ITERATES " discretization.iterations=100000 discretization.acceleration=chebyshev",
      ITERATED, NULL},
     true},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* The edge's way over PUSH after n steps, a parabola; for implicit Euler that of its own
 * velocities n dt, which it sees in whole steps. */
static double way(const struct subject *s, int n)
{
    return s->euler ? DT * DT * n * (n + 1) / 2 : DT * DT * n * n / 2;
}

/* One row before the start and one after the end, for differences of the path. */
static void write_path(const struct subject *s, char *text, size_t size)
{
    size_t used = (size_t)snprintf(text, size, "supports=[{at: {u: 0}, fix: xyz, path: [");

    for (int n = -1; n <= STEPS + 1; n++) {
        double d = n < 0 && s->euler ? 0 : way(s, n);
        used += (size_t)snprintf(text + used, size - used, "%s[%.17g,%.17g,%.17g,%.17g]",
                                 n < 0 ? "" : ",", n * DT, PUSH[0] * d, PUSH[1] * d,
                                 PUSH[2] * d);
    }
    snprintf(text + used, size - used, "]}]");
}

static double worst_of(const struct subject *s, double (*moved)[POINTS][3],
                       double (*still)[POINTS][3], const double *time)
{
    double worst = 0;

    for (int t = 0; t < TIMES; t++)
        for (int n = 0; n < POINTS; n++)
            for (int i = 0; i < 3; i++) {
                double e =
                    fabs(moved[t][n][i] - PUSH[i] * way(s, (int)lround(time[t] / DT)) -
                         still[t][n][i]);
                worst = e > worst || isnan(e) ? e : worst;
            }
    return worst;
}

static enum status add_row(struct verify_sheet *sheet, const struct subject *s,
                           struct message *why)
{
    static const double uvw[POINTS][3] = {{0, 0.5, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0.5},
                                          {1, 0.5, 0},   {1, 0.5, 1},     {1, 1, 0.5}};
    static char path[PATH_TEXT];
    enum status st;
    const double time[TIMES] = {0.1, 0.2, STEPS * DT};
    double moved[TIMES][POINTS][3], still[TIMES][POINTS][3];
    char inertia[96];
    const char *of_moved[] = {"damping={kind: none}", path, NULL};
    const char *of_still[] = {"damping={kind: none}", "supports=[{at: {u: 0}, fix: xyz}]",
                              inertia, NULL};
    bool lived;
    struct verify_row *row =
        verify_add(sheet, &s->subject, "seen from the edge / L, until %g s", STEPS * DT);

    write_path(s, path, sizeof path);
    snprintf(inertia, sizeof inertia, "gravity=[%g,%g,%g]", -PUSH[0], -PUSH[1], -PUSH[2]);
    TRY(verify_motion(row, &s->subject, "moving_edge", of_still, TIMES, time, POINTS,
                      uvw[0], still[0][0], &lived, why));
    if (!lived)
        goto out;
    TRY(verify_motion(row, &s->subject, "moving_edge", of_moved, TIMES, time, POINTS,
                      uvw[0], moved[0][0], &lived, why));
    if (lived)
        verify_judge_error(row, worst_of(s, moved, still, time), 0);
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;

    for (int s = 0; s < SUBJECTS; s++)
        if (verify_wanted(sheet, &subjects[s].subject))
            TRY(add_row(sheet, &subjects[s], why));
out:
    return st;
}

const struct verify_check verify_moving = {
    .item = {"moving", "a plate whose held edge is accelerated along a path"},
    .source = "the same model under the inertial force, edge at rest: equal equations",
    .run = run,
};
