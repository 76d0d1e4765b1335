#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: round-off alone, carried through 40 frames; units that scale numbers by other
 * than powers of two make a little more. */
#define SAME 1e-9, NULL
static const double UNITS = 1e-8;

enum { POINTS = 6, TIMES = 2 };

/* The one marked is damped as in the paper. */
static const struct verify_subject entries[] = {
    {"iga_linear", SAME},
    {"iga_paper", 0, "the paper's scheme", .mark = true},
    {"iga_selective_incremental"},
    {"iga_selective,hex_incompatible_linear", SAME},
    {"hex_incompatible,shell_linear,shell_2", SAME},
    {"triangles,mass_spring,position_based,mass_spring_leapfrog", SAME, {11}, {8}},
    {"mass_spring_momentum,projective_dynamics", SAME, {11}, {8}},
    {NULL}};
#define OTHERS                                                                             \
    "iga_nonlinear,iga_nonlinear_3,hex_nonlinear,shell_3,"                                 \
    "shell_selective_3"
static const struct verify_field field = {entries, CONTESTANT_LARGE, OTHERS, {7}, {6}};

/* A way to describe the scene. */
struct telling {
    const char *name;
    double unit;    /* factor on lengths; kg and s stay                                */
    double heavier; /* factor on E, density and drag                                   */
    double turn[3][3];
    bool scaled; /* whether the claim is that of units                                 */
};

/* clang-format off */
#define UPRIGHT {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}
/* clang-format on */
static const struct telling plain = {"", 1, 1, UPRIGHT, false};
static const struct telling tellings[] = {
    {"in mm", 1e3, 1, UPRIGHT, true},
    {"in inches", 1 / 0.0254, 1, UPRIGHT, true},
    {"E and density times 7", 1, 7, UPRIGHT, false},
    {"turned onto other axes", 1, 1, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, false},
    {"turned", 1, 1, {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}, false},
};

static void turn(const struct telling *t, const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = t->turn[i][0] * from[0] + t->turn[i][1] * from[1] + t->turn[i][2] * from[2];
}

/* Moves a sheet that is pulled along all axes, so that nothing vanishes by symmetry. */
static bool run_told(struct verify_trial *trial, const struct telling *t, double *xyz)
{
    static const double uvw[POINTS][3] = {{0.2, 0.3, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0.5},
                                          {1, 0.5, 0},     {1, 0.5, 1},     {1, 1, 0.5}};
    static const double time[TIMES] = {0.1, 0.2};
    const double l = t->unit, m = t->heavier;
    const struct {
        const char *key;
        double x[3], scale;
    } vectors[] = {{"gravity", {1, 2, -9.81}, l},
                   {"pose.u", {1, 0, 0}, 1},
                   {"pose.v", {0, 1, 0}, 1},
                   {"pose.origin", {0.3, -0.2, 0.5}, l},
                   {"drag.wind", {3, 2, 1}, l}};

    verify_trial_set(trial,
                     "sheet={length: %.17g, width: %.17g, thickness: %.17g};"
                     "material={young: %.17g, poisson: 0.3, density: %.17g};"
                     "drag.coefficient=%.17g; damping={kind: %s, value: 0.5}",
                     l, 0.7 * l, 0.01 * l, 1e5 * m / l, 2 * m / (l * l * l),
                     0.4 * m / (l * l * l),
                     trial->subject->mark ? "velocity_scale" : "mass");
    for (size_t n = 0; n < sizeof vectors / sizeof *vectors; n++) {
        const double k = vectors[n].scale;
        double to[3];
        turn(t, vectors[n].x, to);
        verify_trial_set(trial, "%s=[%.17g,%.17g,%.17g]", vectors[n].key, k * to[0],
                         k * to[1], k * to[2]);
    }
    return verify_trial_motion(trial, TIMES, time, POINTS, uvw[0], xyz);
}

static void add_row(struct verify_subject *s)
{
    const struct telling *t = &tellings[s->at];
    double plainly[TIMES * POINTS][3], told[TIMES * POINTS][3];

    if (t->scaled)
        verify_subject_claim(s, UNITS, s->reason);
    struct verify_trial trial =
        verify_trial_of(s, "edge_drop", "%s: position / L at 0.2 s", t->name);
    if (!run_told(&trial, &plain, plainly[0]) || !run_told(&trial, t, told[0]))
        return;
    for (int k = 0; k < TIMES * POINTS; k++) {
        const double x[3] = {plainly[k][0], plainly[k][1], plainly[k][2]};
        turn(t, x, plainly[k]);
        for (int i = 0; i < 3; i++)
            told[k][i] /= t->unit;
    }
    /* of the length, 1 m */
    verify_row_judge_error(trial.row,
                           verify_row_apart(3 * TIMES * POINTS, told[0], plainly[0]), 0);
}

const struct verify_check verify_similarity = {
    {"similarity", "one motion in other units, stiffer and heavier, turned"},
    "the same model's motion as told in m, upright",
    .parts = {{&field, add_row, sizeof tellings / sizeof *tellings}}};
