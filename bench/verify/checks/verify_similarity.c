/* The same physics told otherwise: in other units, E and density together larger, the whole
 * scene turned. Motions over the length must be the same. */
#include <math.h>

#include "bench/verify/verify_check.h"

/* Round-off alone, carried through 40 frames; what units do to powers of ten, a little
 * more.
 */
#define SAME 1e-9, NULL
static const double UNITS = 1e-8;

enum { POINTS = 6, TIMES = 2 };

/* Marked: damped as in the paper. */
static const struct verify_entry entries[] = {
    {"iga_linear", SAME},
    {"iga_paper", 0, "the paper's scheme", .mark = true},
    {"iga_reduced_incremental"},
    {"iga_reduced", SAME},
    {"iga_selective", SAME},
    {"hex_incompatible_linear", SAME},
    {"hex_incompatible", SAME},
    {"shell_linear", SAME},
    {"shell_2", SAME},
    {"triangles", SAME, {11}, {8}},
    {"mass_spring", SAME, {11}, {8}},
    {"position_based", SAME, {11}, {8}},
    {"mass_spring_leapfrog", SAME, {11}, {8}},
    {"mass_spring_momentum", SAME, {11}, {8}},
    {"projective_dynamics", SAME, {11}, {8}},
    {NULL}};
#define OTHERS                                                                             \
    "iga_nonlinear,iga_nonlinear_3,iga_reduced_3,hex_nonlinear,shell_3,"                   \
    "shell_selective_3"
static const struct verify_field field = {entries, CONTESTANT_LARGE, OTHERS, {7}, {6}};

/* How the scene is told. */
struct telling {
    const char *name;
    double unit;    /* lengths are so many times as large, kg and s stay               */
    double heavier; /* E, density and drag                                             */
    double turn[3][3];
    bool scaled; /* the tolerance is that of units                                     */
};

static const struct telling plain = {"", 1, 1, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, false};
static const struct telling tellings[] = {
    {"in mm", 1e3, 1, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true},
    {"in inches", 1 / 0.0254, 1, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true},
    {"E and density times 7", 1, 7, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, false},
    {"turned onto other axes", 1, 1, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, false},
    {"turned", 1, 1, {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}, false},
};

static void turn(const struct telling *t, const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = t->turn[i][0] * from[0] + t->turn[i][1] * from[1] + t->turn[i][2] * from[2];
}

static void add_vector(const struct telling *t, const char *name, double x, double y,
                       double z, double scale, struct settings *all)
{
    double to[3];

    turn(t, (const double[3]){x, y, z}, to);
    settings_numbers(all, name, 3, (double[]){scale * to[0], scale * to[1], scale * to[2]});
}

/* A sheet that is pulled along all axes, so that nothing vanishes by symmetry. */
static void tell(const struct telling *t, struct settings *all)
{
    const double l = t->unit, m = t->heavier;

    settings_print(all, "sheet={length: %.17g, width: %.17g, thickness: %.17g}", l, 0.7 * l,
                   0.01 * l);
    settings_print(all, "material={young: %.17g, poisson: 0.3, density: %.17g}",
                   1e5 * m / l, 2 * m / (l * l * l));
    add_vector(t, "gravity", 1, 2, -9.81, l, all);
    add_vector(t, "pose.u", 1, 0, 0, 1, all);
    add_vector(t, "pose.v", 0, 1, 0, 1, all);
    add_vector(t, "pose.origin", 0.3, -0.2, 0.5, l, all);
    settings_number(all, "drag.coefficient", 0.4 * m / (l * l * l));
    add_vector(t, "drag.wind", 3, 2, 1, l, all);
}

static bool run_told(struct verify_trial *trial, const struct telling *t,
                     double xyz[TIMES][POINTS][3])
{
    static const double uvw[POINTS][3] = {{0.2, 0.3, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0.5},
                                          {1, 0.5, 0},     {1, 0.5, 1},     {1, 1, 0.5}};
    static const double time[TIMES] = {0.1, 0.2};

    tell(t, &trial->settings);
    settings_set(&trial->settings, trial->subject->mark
                                       ? "damping={kind: velocity_scale, value: 0.5}"
                                       : "damping={kind: mass, value: 0.5}");
    return verify_trial_motion(trial, TIMES, time, POINTS, uvw[0], xyz[0][0]);
}

/* Largest deviation over the length, 1 m. */
static double deviation(const struct telling *t, double plainly[TIMES][POINTS][3],
                        double told[TIMES][POINTS][3])
{
    double worst = 0;

    for (int k = 0; k < TIMES * POINTS; k++) {
        double x[3];
        turn(t, plainly[k / POINTS][k % POINTS], x);
        for (int i = 0; i < 3; i++) {
            double e = fabs(told[k / POINTS][k % POINTS][i] / t->unit - x[i]);
            worst = verify_row_worse(e, worst);
        }
    }
    return worst;
}

static void add_row(const struct verify_subject *s, const struct telling *t)
{
    double plainly[TIMES][POINTS][3], told[TIMES][POINTS][3];
    struct verify_trial trial =
        verify_trial_of(s, "edge_drop", "%s: position / L at 0.2 s", t->name);

    if (t->scaled && !isnan(trial.row->tolerance))
        trial.row->tolerance = UNITS;
    if (run_told(&trial, &plain, plainly) && run_told(&trial, t, told))
        verify_row_judge_error(trial.row, deviation(t, plainly, told), 0);
}

static void run(struct verify_sheet *sheet)
{
    struct verify_subject s;

    for (size_t t = 0; t < sizeof tellings / sizeof *tellings; t++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);)
            add_row(&s, &tellings[t]);
}

const struct verify_check verify_similarity = {
    .item = {"similarity", "one motion in other units, stiffer and heavier, turned"},
    .source = "the same model's motion as told in m, upright",
    .run = run,
};
