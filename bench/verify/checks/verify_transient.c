/* A cantilevered plate that is let go, as long as its deflection is small. */
#include <math.h>
#include <stdlib.h>

#include "bench/truth/truth.h"
#include "bench/truth/truth_table.h"
#include "bench/verify/verify_check.h"
#include "fem_ref/freefem.h"
#include "fem_ref/kirchhoff_field.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* As in `pendulum`: a solid 1 %, a shell, whose theory is the truth's own, 1e-3. */
#define SOLID 0.01, NULL
#define SHELL 1e-3, NULL

/* So little of gravity that the plate falls by 8e-5 m, a fifteenth of its thickness: models
 * of large displacements are linear there, too, and linear ones the same as under all of
 * it.
 */
#define SMALL 1e-4
static const char *const settings[] = {"gravity=[0,0,-9.81e-4]", NULL};

enum { TIMES = FREEFEM_TIMES };
static const double times[TIMES] = {0.1, 0.2, 0.3, 0.4}; /* [s] */
static const double STEP = 0.00125;

#define EULER   "implicit Euler: first order in time"
#define FORGETS "stress is forgotten after each step"
#define TO_THE_END                                                                         \
    .more = "iterated to the end",                                                         \
    .settings = {"discretization.acceleration=chebyshev",                                  \
                 "discretization.iterations=100000", "discretization.tolerance=1e-13"}
#define EVERY_EIGHTH {10, 18, 34}, {6, 10, 18}, 0
#define THREE        {11, 19, 35}, {7, 11, 19}, 0
#define MANY         {17, 33, 65}, {9, 17, 33}, 0
static const struct verify_entry entries[] = {
    {"iga_linear", 0, "the paper's space: locks", EVERY_EIGHTH},
    {"iga_paper", 0, "the paper's scheme: viscous, not elastic", {10}, {6}},
    {"iga_reduced_incremental", 0, FORGETS, {10, 18}, {6, 10}, .dear = true},
    {"iga_reduced_linear", SOLID, EVERY_EIGHTH},
    {"iga_selective_linear", SOLID, EVERY_EIGHTH},
    {"iga_linear_32", SOLID, THREE},
    {"iga_reduced", SOLID, EVERY_EIGHTH, .dear = true},
    {"hex_linear", 0, "locks", MANY, .dear = true},
    {"hex_incompatible_linear", SOLID, MANY},
    {"hex_incompatible", SOLID, MANY, .dear = true},
    {"shell_linear_3", SHELL, THREE},
    {"shell_3", SHELL, THREE, .dear = true},
    {"triangles", SOLID, THREE},
    {"mass_spring", 0, EULER, {21, 41}, .settings = {"discretization.tolerance=1e-9"}},
    {"position_based", 0, EULER, {11, 21}},
    {"projective_dynamics", 0, EULER, {11, 21}, TO_THE_END, .dear = true},
    {"projective_dynamics_bdf2",
     SOLID,
     {21, 41},
     .more = "iterated to the end",
     .settings = {"discretization.iterations=100000", "discretization.tolerance=1e-13"},
     .changed = "11x11 and 21x21 at first, whose net leaves 1.7 %",
     .dear = true},
    {NULL}};
#define OTHERS "iga_linear_3,iga_reduced_linear_3,iga_selective_linear_3,shell_linear"
static const struct verify_field field = {
    entries, CONTESTANT_SMALL, OTHERS, {11, 19, 35}, {7, 11, 19}};

/* Truths and room. */
struct transient {
    struct scene scene; /* with all of gravity                                          */
    struct freefem_field solid; /* 3-D elasticity                                       */
    double fallen[TIMES];       /* rms [m]                                              */
    double uvw[3 * GRID_POINTS], truth[TIMES * 3 * GRID_POINTS];
    double field[TIMES * 3 * GRID_POINTS];
};

static enum status read_solid(struct transient *t, struct message *why)
{
    enum status st;
    char *path = NULL;
    struct freefem_job job;

    TRY(freefem_job_of(&t->scene, &job, why));
    job.moving = true;
    TRY(truth_table_path("freefem_transient_h1177um", &path, why));
    TRY(freefem_stored(&job, path, &t->solid, why));
    for (int n = 0; n < TIMES; n++) {
        double *shift = t->solid.shift[n][0][0];
        for (int i = 0; i < 3 * FREEFEM_SIDE * FREEFEM_SIDE; i++)
            shift[i] *= SMALL;
        t->solid.error[n] *= SMALL;
    }
out:
    free(path);
    return st;
}

/* *t all zero. */
static enum status transient_init(struct transient *t, struct message *why)
{
    double *truth[TIMES], *rest = NULL;
    enum status st;

    for (int n = 0; n < TIMES; n++)
        truth[n] = t->truth + 3 * GRID_POINTS * n;
    TRY(verify_trial_scene("cantilever_transient", &t->scene, why));
    TRY(truth_plate_fields(&t->scene, TIMES, times, truth, why));
    TRY(read_solid(t, why));
    rest = metric_rest_field(&t->scene);
    TRY(rest ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, t->uvw + 3 * n);
    for (int n = 0; n < TIMES; n++) {
        for (int i = 0; i < 3 * GRID_POINTS; i++)
            truth[n][i] = rest[i] + SMALL * (truth[n][i] - rest[i]);
        t->fallen[n] = metric_rmse(truth[n], rest);
    }
out:
    free(rest);
    return st;
}

/* rms over the grid by the truth's rms deflection, at the worst of the times. */
static double plate_error(const void *context, const double *a, const double *b)
{
    const struct transient *t = context;
    double worst = 0;

    for (int n = 0; n < TIMES; n++) {
        double e = metric_rmse(a + 3 * GRID_POINTS * n, b + 3 * GRID_POINTS * n);
        worst = verify_row_worse(e / t->fallen[n], worst);
    }
    return worst;
}

/* The same of the mid-surface against the solid; its bar at that time. */
static double solid_error(const struct transient *t, double *bar)
{
    double worst = -1;

    for (int n = 0; n < TIMES; n++) {
        double e = freefem_rmse(&t->solid, n, &t->scene, t->field + 3 * GRID_POINTS * n);
        if (e / t->fallen[n] > worst) {
            worst = e / t->fallen[n];
            *bar = t->solid.error[n] / t->fallen[n];
        }
    }
    return worst;
}

static void add_rows(struct verify_subject *s, struct transient *t)
{
    const struct verify_trial_refine r = {.scene = "cantilever_transient",
                                          .settings = settings,
                                          .steps = s->sheet->quick ? 1 : VERIFY_TRIAL_STEPS,
                                          .step = STEP,
                                          .times = TIMES,
                                          .time = times,
                                          .n = GRID_POINTS,
                                          .uvw = t->uvw,
                                          .truth = t->truth,
                                          .bar = KIRCHHOFF_TRANSIENT_ERROR,
                                          .measure = plate_error,
                                          .context = t,
                                          .field = t->field};
    double bar = NAN;

    if (s->sheet->quick) /* the finest two, no coarser step */
        verify_subject_last(s, 2);
    if (verify_trial_refine(s, &r, "rms deflection, Kirchhoff") && !s->sheet->quick) {
        double error = solid_error(t, &bar);
        verify_row_judge_error(verify_sheet_add(s, "rms deflection, 3-D elasticity"), error,
                               bar);
    }
}

static void run(struct verify_sheet *sheet)
{
    struct transient *t = calloc(1, sizeof *t);
    struct verify_subject s;

    if (!verify_sheet_holds(sheet, t ? STATUS_OK : STATUS_MEMORY))
        return;
    verify_sheet_holds(sheet, transient_init(t, &sheet->why));
    for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);)
        add_rows(&s, t);
    scene_clear(&t->scene);
    free(t);
}

const struct verify_check verify_transient = {
    .item = {"transient", "a cantilevered plate let go, small deflections to 0.4 s"},
    .source = "Kirchhoff plate by 48 x 48 modes, exact in time, 1e-5; 3-D elasticity by "
              "FreeFEM, tests/reference/freefem_transient_h1177um.csv, its bar in the row",
    .slow = true,
    .run = run,
};
