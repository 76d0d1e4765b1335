/* A cantilevered plate that is let go, as long as its deflection is small. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/truth_plate.h"
#include "bench/verify/verify_refine.h"
#include "fem_ref/freefem.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

extern const struct verify_check verify_transient;

/* As in `pendulum`: a solid 1 %, a shell, whose theory is the truth's own, 1e-3. */
static const double SOLID = 0.01, SHELL = 1e-3;

/* So little of gravity that the plate falls by 8e-5 m, a fifteenth of its thickness: models
 * of large displacements are linear there, too, and linear ones the same as under all of
 * it.
 */
#define SMALL 1e-4
static const char *const settings[] = {"gravity=[0,0,-9.81e-4]", NULL};

enum { TIMES = FREEFEM_TIMES, NETS = VERIFY_REFINE_NETS };
static const double times[TIMES] = {0.1, 0.2, 0.3, 0.4}; /* [s] */
static const double STEP = 0.00125;

struct subject {
    struct verify_subject subject;
    const char *net[NETS]; /* NULL: fewer                                              */
    bool dear;
};

#define POINTS(a, b, c) "discretization.points=[" #a "," #b "," #c "]"
#define NET(a, b)       "discretization.points=[" #a "," #b "]"
#define KINEMATICS(k, remedy)                                                              \
    "discretization.kinematics=" k " discretization.remedy=" remedy
#define EULER "implicit Euler: first order in time"
#define EVERY_EIGHTH                                                                       \
    {                                                                                      \
        POINTS(10, 6, 2), POINTS(18, 10, 2), POINTS(34, 18, 2)                             \
    }
static const struct subject subjects[] = {
    {{"iga, none, linear", "iga", KINEMATICS("linear", "none"), NAN,
      "the paper's space: locks"},
     EVERY_EIGHTH,
     false},
    {{"iga, none, printed", "iga", KINEMATICS("printed", "none"), NAN,
      "the paper's scheme: viscous, not elastic"},
     {POINTS(10, 6, 2)},
     false},
    {{"iga, reduced, incremental", "iga", KINEMATICS("incremental", "reduced"), NAN,
      "stress is forgotten after each step"},
     {POINTS(10, 6, 2), POINTS(18, 10, 2)},
     true},
    {{"iga, reduced, linear", "iga", KINEMATICS("linear", "reduced"), SOLID, NULL},
     EVERY_EIGHTH,
     false},
    {{"iga, selective, linear", "iga", KINEMATICS("linear", "selective"), SOLID, NULL},
     EVERY_EIGHTH,
     false},
    {{"iga, p = 3, r = 2, linear", "iga",
      KINEMATICS("linear", "none") " discretization.degree=[3,3,2]", SOLID, NULL},
     {POINTS(11, 7, 3), POINTS(19, 11, 3), POINTS(35, 19, 3)},
     false},
    {{"iga, reduced, nonlinear", "iga", KINEMATICS("nonlinear", "reduced"), SOLID, NULL},
     EVERY_EIGHTH,
     true},
    {{"hex, none, linear", "hex", KINEMATICS("linear", "none"), NAN, "locks"},
     {POINTS(17, 9, 2), POINTS(33, 17, 2), POINTS(65, 33, 2)},
     true},
    {{"hex, incompatible, linear", "hex", KINEMATICS("linear", "incompatible"), SOLID,
      NULL},
     {POINTS(17, 9, 2), POINTS(33, 17, 2), POINTS(65, 33, 2)},
     false},
    {{"hex, incompatible, nonlinear", "hex", KINEMATICS("nonlinear", "incompatible"), SOLID,
      NULL},
     {POINTS(17, 9, 2), POINTS(33, 17, 2), POINTS(65, 33, 2)},
     true},
    {{"shell, p = 3, linear", "shell",
      "discretization.kinematics=linear discretization.degree=[3,3]", SHELL, NULL},
     {NET(11, 7), NET(19, 11), NET(35, 19)},
     false},
    {{"shell, p = 3, nonlinear", "shell",
      "discretization.kinematics=nonlinear discretization.degree=[3,3]", SHELL, NULL},
     {NET(11, 7), NET(19, 11), NET(35, 19)},
     true},
    {{"mass_spring, matched", "mass_spring", "discretization.tolerance=1e-9", NAN, EULER},
     {NET(21, 21), NET(41, 41)},
     false},
    {{"projective_dynamics, matched, iterated to the end", "projective_dynamics",
      "discretization.acceleration=chebyshev discretization.iterations=100000 "
      "discretization.tolerance=1e-13",
      NAN, EULER},
     {NET(11, 11), NET(21, 21)},
     true},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* Truths and room. */
struct transient {
    struct scene scene; /* with all of gravity                                          */
    struct truth_plate plate;
    struct freefem_field solid; /* 3-D elasticity                                       */
    double fallen[TIMES];       /* rms [m]                                              */
    double *uvw, *truth, *field;
};

static enum status read_scene(struct scene *scene, struct message *why)
{
    enum status st;
    char *path = NULL;
    struct discretization unused = {0};

    TRY(scene_file_find("cantilever_transient", &path, why));
    TRY(scene_file_read(path, 0, NULL, scene, &unused, why));
out:
    discretization_clear(&unused);
    free(path);
    return st;
}

static enum status read_solid(struct transient *t, struct message *why)
{
    enum status st;
    char *path = NULL;
    struct freefem_job job;

    TRY(freefem_job_of(&t->scene, &job, why));
    job.steps = FREEFEM_TIMES; /* not static */
    TRY(verify_reference_path("freefem_transient_h1177um", &path, why));
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

static void transient_clear(struct transient *t)
{
    scene_clear(&t->scene);
    truth_plate_clear(&t->plate);
    free(t->uvw);
    free(t->truth);
    free(t->field);
}

/* *t all zero. */
static enum status transient_init(struct transient *t, struct message *why)
{
    enum status st;
    const size_t grid = 3 * sizeof(double) * GRID_POINTS;

    TRY(read_scene(&t->scene, why));
    TRY(truth_plate_init(&t->plate, &t->scene, TIMES, times, why));
    TRY(read_solid(t, why));
    t->uvw = malloc(grid);
    t->truth = malloc(TIMES * grid);
    t->field = malloc(TIMES * grid);
    if (!t->uvw || !t->truth || !t->field)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, t->uvw + 3 * n);
    for (int n = 0; n < TIMES; n++) {
        double *truth = t->truth + 3 * GRID_POINTS * n;
        for (int i = 0; i < 3 * GRID_POINTS; i++)
            truth[i] = t->plate.rest[i] + SMALL * (t->plate.xyz[n][i] - t->plate.rest[i]);
        t->fallen[n] = metric_rmse(truth, t->plate.rest);
    }
out:
    return st;
}

/* rms over the grid by the truth's rms deflection, at the worst of the times. */
static double plate_error(const void *context, const double *a, const double *b)
{
    const struct transient *t = context;
    double worst = 0;

    for (int n = 0; n < TIMES; n++) {
        double e = metric_rmse(a + 3 * GRID_POINTS * n, b + 3 * GRID_POINTS * n);
        e /= t->fallen[n];
        worst = e > worst || isnan(e) ? e : worst;
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

static enum status add_rows(struct verify_sheet *sheet, const struct subject *s,
                            const struct transient *t, struct message *why)
{
    enum status st;
    struct verify_refine r = {.scene = "cantilever_transient",
                              .settings = settings,
                              .net = s->net,
                              .steps = VERIFY_REFINE_STEPS,
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
    bool lived;

    while (r.nets < NETS && s->net[r.nets])
        r.nets++;
    if (verify_quick(sheet)) { /* the finest two, no coarser step */
        int skip = r.nets > 2 ? r.nets - 2 : 0;
        r.net += skip, r.nets -= skip, r.steps = 1;
    }
    TRY(verify_refine(sheet, &s->subject, &r, "rms deflection, Kirchhoff", &lived, why));
    if (lived && !verify_quick(sheet)) {
        struct verify_row *row =
            verify_add(sheet, &s->subject, "rms deflection, 3-D elasticity");
        double error = solid_error(t, &bar);
        verify_judge_error(row, error, bar);
    }
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct transient t = {0};

    TRY(transient_init(&t, why));
    for (int s = 0; s < SUBJECTS; s++)
        if (verify_wanted(sheet, &subjects[s].subject) &&
            (!subjects[s].dear || !verify_quick(sheet)))
            TRY(add_rows(sheet, &subjects[s], &t, why));
out:
    transient_clear(&t);
    return st;
}

const struct verify_check verify_transient = {
    .item = {"transient", "a cantilevered plate let go, small deflections to 0.4 s"},
    .source = "Kirchhoff plate by 48 x 48 modes, exact in time, 1e-5; 3-D elasticity by "
              "FreeFEM, tests/reference/freefem_transient_h1177um.csv, its bar in the row",
    .slow = true,
    .run = run,
};
