
#include "bench/truth/truth.h"
#include "bench/verify/verify_check.h"
#include "fem_ref/kirchhoff.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "models/reader/scene_file.h"

/* Claims as in `pendulum`: 1 % for solids, 1e-3 for shells, whose theory is the truth's. */
#define SOLID 0.01, NULL
#define SHELL 1e-3, NULL

/* Share of gravity under which the plate falls by 8e-5 m, a fifteenth of its thickness:
 * models of large displacements are linear there, too, and linear ones as under all of it.
 */
#define SMALL 1e-4
static const char *const settings[] = {"gravity=[0,0,-9.81e-4]", NULL};

#define SCENE "cantilever_transient"
enum { TIMES = 4 };
static const double times[TIMES] = {0.1, 0.2, 0.3, 0.4}; /* [s] */
static const double STEP = 0.00125;

/* clang-format off */
#define EULER        "implicit Euler: first order in time"
#define ITERATED     "discretization.iterations=100000", "discretization.tolerance=1e-13"
#define CHEBYSHEV    "discretization.acceleration=chebyshev"
#define TO_THE_END   {0}, 0, "iterated to the end"
#define LEFT         "11x11 and 21x21 at first, whose net leaves 1.7 %"
#define EVERY_EIGHTH {10, 18, 34}, {6, 10, 18}
#define THREE        {11, 19, 35}, {7, 11, 19}
#define MANY         {17, 33, 65}, {9, 17, 33}
static const struct verify_subject entries[] = {
    {"iga_linear", 0, "the paper's space: locks", EVERY_EIGHTH},
    {"iga_paper", 0, "the paper's scheme: viscous, not elastic", {10}, {6}},
    {"iga_selective_incremental", 0, "stress is forgotten after each step", {10, 18}, {6, 10},
     .dear = true},
    {"iga_selective_linear", SOLID, EVERY_EIGHTH},
    {"iga_linear_32", SOLID, THREE},
    {"iga_selective", SOLID, EVERY_EIGHTH, .dear = true},
    {"hex_linear", 0, "locks", MANY},
    {"hex_incompatible_linear", SOLID, MANY},
    {"hex_incompatible", SOLID, MANY, .dear = true},
    {"shell_linear_3", SHELL, THREE},
    {"shell_3", SHELL, THREE, .dear = true},
    {"triangles", SOLID, THREE},
    {"mass_spring", 0, EULER, {21, 41}, .settings = {"discretization.tolerance=1e-9"}},
    {"position_based", 0, EULER, {11, 21}},
    {"projective_dynamics", 0, EULER, {11, 21}, TO_THE_END, {ITERATED, CHEBYSHEV}},
    {"projective_dynamics_bdf2", SOLID, {21, 41}, TO_THE_END, {ITERATED}, .dear = true,
     .changed = LEFT},
    {NULL}};
/* clang-format on */
#define OTHERS "iga_linear_3,iga_selective_linear_3,shell_linear"
static const struct verify_field field = {
    entries, CONTESTANT_SMALL, OTHERS, {11, 19, 35}, {7, 11, 19}};

struct transient {
    double fallen[TIMES]; /* rms deflection of the truth [m]                              */
    double uvw[3 * GRID_POINTS], truth[TIMES * 3 * GRID_POINTS];
    double field[TIMES * 3 * GRID_POINTS];
};

/* Computes the truth into *t, which is all zero. */
static enum status transient_init(struct arena *arena, struct transient *t,
                                  struct message *why)
{
    char *path;
    struct scene scene SCOPED(scene_clear) = {0};
    double *plate[TIMES];

    CALL(scene_file_find(SCENE, &path, why));
    CALL(
        contestant_read_scene(&(struct settings){0}, arena_keep(arena, path), &scene, why));
    for (int n = 0; n < TIMES; n++)
        plate[n] = t->truth + 3 * GRID_POINTS * n;
    CALL(kirchhoff_field(&scene, KIRCHHOFF_TERMS, TIMES, times, plate, why));
    const double *rest = arena_keep(arena, metric_rest_field(&scene));
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, t->uvw + 3 * n);
    for (int n = 0; n < TIMES; n++) {
        for (int i = 0; i < 3 * GRID_POINTS; i++)
            plate[n][i] = rest[i] + SMALL * (plate[n][i] - rest[i]);
        t->fallen[n] = metric_rmse(plate[n], rest);
    }
    return STATUS_OK;
}

/* Returns the rms error over the grid, of the truth's rms deflection, at the worst time. */
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

static void run(struct verify_sheet *sheet)
{
    struct transient *t = arena_take(&sheet->arena, 1, sizeof *t);
    struct verify_subject all[VERIFY_MOST];

    verify_sheet_holds(sheet, transient_init(&sheet->arena, t, &sheet->why));
    struct verify_trial_refine r = {.scene = SCENE, .settings = settings, .step = STEP};
    r.steps = sheet->quick ? 1 : VERIFY_TRIAL_STEPS;
    r.times = TIMES, r.time = times, r.n = GRID_POINTS, r.uvw = t->uvw, r.truth = t->truth;
    r.measure = plate_error, r.context = t, r.bar = KIRCHHOFF_TRANSIENT_ERROR;
    r.field = t->field;
    const int subjects = verify_sheet_subjects(sheet, &field, all);
    for (struct verify_subject *s = all; s < all + subjects; s++) {
        if (sheet->quick) /* the finest two nets, no coarser step */
            verify_subject_last(s, 2);
        verify_trial_refine(s, &r, "rms deflection, Kirchhoff");
    }
}

const struct verify_check verify_transient = {
    {"transient", "a cantilevered plate let go, small deflections to 0.4 s"},
    "Kirchhoff plate by 48 x 48 modes, exact in time, 1e-5 (3-D elasticity: outside)",
    .slow = true,
    .run = run};
