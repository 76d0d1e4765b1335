/* Stiffness and mass of a box against products of matrices of one variable; six motions
 * without energy, flat and curved; and a sheet turned as a whole, which keeps no energy.
 */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify_box.h"
#include "bench/verify/verify_check.h"

/* Asked: 1e-12 of matrices, where an entry is a sum over a few hundred points of a dozen
 * roundings each; and of E (times 1 m^3), turned by any angle. */
#define ASKED 1e-12, NULL
/* Eigenvalues of round-off: some n eps |K|, n < 500; the softest true mode of these boxes,
 * bending at h / L = 0.05, is at 1e-8 of the largest or above. */
static const double ZERO = 1e-11;
static const double LENGTH = 1.1, WIDTH = 0.7, THICKNESS = 0.05;
static const double YOUNG = 3, POISSON = 0.3, DENSITY = 1.7;
static const char *const box_settings[] = {
    "sheet={length: 1.1, width: 0.7, thickness: 0.05}", "material.young=3",
    "material.poisson=0.3", "material.density=1.7", NULL};
enum { BOX = sizeof box_settings / sizeof *box_settings, SHAPE = 2 };

/* Degrees are in the settings, and in the title. Marked: its stiffness is not that of the
 * full rule, on purpose. */
#define REMEDY "discretization.remedy="
#define DEGREE "discretization.degree="
static const struct verify_entry entries[] = {
    {"iga", ASKED, {6}, {5}, 0, "p = 2, 2, 1", {DEGREE "[2,2,1]", REMEDY "none"}},
    {"iga", ASKED, {6}, {5}, 0, "p = 3, 3, 2", {DEGREE "[3,3,2]", REMEDY "none"}, 3},
    {"iga", ASKED, {6}, {4}, 0, "p = 4, 2, 3", {DEGREE "[4,2,3]", REMEDY "none"}, 4},
    {"iga",
     ASKED,
     {6},
     {5},
     0,
     "reduced",
     {DEGREE "[2,2,1]", REMEDY "reduced"},
     .mark = true},
    {"iga",
     ASKED,
     {6},
     {5},
     0,
     "selective",
     {DEGREE "[2,2,1]", REMEDY "selective"},
     .mark = true},
    {"hex", ASKED, {6}, {5}, .settings = {REMEDY "none"}},
    {"hex", ASKED, {4}, {5}, .settings = {REMEDY "none"}, .layers = 4},
    {"hex", ASKED, {6}, {5}, 0, "incompatible", {REMEDY "incompatible"}, .mark = true},
    {"shell", ASKED, {6}, {5}, 0, "p = 2", {DEGREE "[2,2]", REMEDY "none"}, .mark = true},
    {"shell", ASKED, {7}, {6}, 0, "p = 3", {DEGREE "[3,3]", REMEDY "none"}, .mark = true},
    {"shell_selective_2", ASKED, {6}, {5}, .mark = true},
    {"shell_selective_3", ASKED, {7}, {6}, .mark = true},
    {"triangles",
     0,
     "mass is lumped on purpose",
     {6},
     {5},
     .mark = true,
     .changed = "1e-12 of M, as of the others, which is not what lumped mass is"},
    {"mass_spring", ASKED, {6}, {5}, .mark = true},
    {"position_based", ASKED, {6}, {5}, .mark = true},
    {"projective_dynamics", ASKED, {6}, {5}, .mark = true},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_SMALL, "iga,hex,shell", {6}, {5}};

/* --- K and M. */

/* The full matrix [rows][rows] of a lower triangle; NULL: out of memory. */
static double *dense(const struct matrix *m)
{
    double *full = calloc((size_t)m->rows * (size_t)m->rows, sizeof *full);

    for (long t = 0; full && t < m->entries; t++)
        full[(size_t)m->row[t] * (size_t)m->rows + (size_t)m->column[t]] =
            full[(size_t)m->column[t] * (size_t)m->rows + (size_t)m->row[t]] = m->value[t];
    return full;
}

/* Of a model that was opened. */
struct matrices {
    double *K, *M; /* [rows][rows]                                              owned  */
    int rows, points[3], degree[3];
};

static void matrices_clear(struct matrices *m)
{
    free(m->K);
    free(m->M);
}

static enum status keep_matrices(const struct run *run, struct matrices *m)
{
    struct matrix sparse[2] = {{0}};
    enum status st;

    TRY(run->model->matrices(run->state, &sparse[0], &sparse[1]));
    m->rows = sparse[0].rows;
    m->K = dense(&sparse[0]);
    m->M = dense(&sparse[1]);
    memcpy(m->points, run->discretization.points, sizeof m->points);
    memcpy(m->degree, run->discretization.degree, sizeof m->degree);
    st = m->K && m->M ? STATUS_OK : STATUS_MEMORY;
out:
    matrix_clear(&sparse[0]);
    matrix_clear(&sparse[1]);
    return st;
}

/* Whether it has any; the row says why not. */
static bool find_matrices(struct verify_trial *t, struct matrices *m)
{
    enum status st = STATUS_OK;

    if (t->subject->layers) /* solids may have other unknowns than control points */
        settings_set(&t->settings, "discretization.unknowns=points");
    if (verify_trial_open(t) && !t->run.model->matrices) {
        t->lived = false;
        verify_row_end(t->row, VERIFY_NOT_APPLICABLE, "it has no constant matrices");
    } else if (t->lived) {
        st = keep_matrices(&t->run, m);
        t->lived = st == STATUS_OK;
    }
    if (st == STATUS_UNSUPPORTED)
        verify_row_end(t->row, VERIFY_NOT_APPLICABLE,
                       "it has none for control points as unknowns");
    else
        verify_sheet_holds(t->subject->sheet, st);
    run_close(&t->run);
    return t->lived;
}

/* Largest difference of A and B, of the largest of B. */
static double apart(size_t count, const double *A, const double *B)
{
    double worst = 0, most = 0;

    for (size_t t = 0; t < count; t++) {
        worst = fmax(worst, fabs(A[t] - B[t]));
        most = fmax(most, fabs(B[t]));
    }
    return worst / most;
}

/* Products for the box: K, and M (zeros) spread over three components, [3 nodes][3 nodes].
 */
static enum status products(const struct matrices *m, bool solid, double *K, double *M,
                            struct message *why)
{
    enum status st = STATUS_OK;
    struct bspline basis[3] = {{0}};
    struct verify_box box = {.size = {LENGTH, WIDTH, THICKNESS}, .density = DENSITY};
    double *small = NULL;

    box.lambda = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON));
    box.mu = YOUNG / (2 * (1 + POISSON));
    for (int d = 0; d < (solid ? 3 : 2); d++) {
        TRY(bspline_init_uniform(&basis[d], m->degree[d], m->points[d], why));
        box.basis[d] = &basis[d];
    }
    size_t n = (size_t)verify_box_nodes(&box);
    small = malloc(n * n * sizeof *small);
    st = small ? verify_box_matrices(&box, K, small) : STATUS_MEMORY;
    for (size_t t = 0; st == STATUS_OK && t < 3 * n * n; t++) {
        size_t a = t / 3 / n, b = t / 3 % n, i = t % 3;
        M[(3 * a + i) * 3 * n + 3 * b + i] = small[a * n + b];
    }
out:
    for (int d = 0; d < 3; d++)
        bspline_clear(&basis[d]);
    free(small);
    return st;
}

static void add_box(const struct verify_subject *s, bool mass)
{
    struct matrices m = {0};
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "%s of a box, entries", mass ? "M" : "K");

    settings_list(&t.settings, BOX, box_settings);
    if (find_matrices(&t, &m) && !mass && s->mark)
        verify_row_end(t.row, VERIFY_NOT_APPLICABLE,
                       "its stiffness differs from the solid's on purpose");
    else if (t.lived) {
        const size_t count = (size_t)m.rows * (size_t)m.rows;
        double *K = calloc(2 * count, sizeof *K), *M = K + count;
        if (verify_sheet_holds(s->sheet, K ? products(&m, s->layers, K, M, &s->sheet->why)
                                           : STATUS_MEMORY))
            verify_row_judge_error(t.row, apart(count, mass ? m.M : m.K, mass ? M : K), 0);
        free(K);
    }
    matrices_clear(&m);
}

/* --- Motions without energy. */

static void add_zero_modes(struct verify_subject *s, const char *scene)
{
    struct matrices m = {0};
    int zeros = 0;

    /* of six: not one more or less */
    verify_subject_claim(s, 0.1, "three shifts, three turns");
    struct verify_trial t =
        verify_trial_of(s, scene, "eigenvalues of K that vanish, %s", scene);
    settings_number(&t.settings, "sheet.thickness", THICKNESS);
    if (find_matrices(&t, &m)) {
        double *lambda = m.M; /* its room is enough, and it is not asked for */
        if (LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'N', 'U', m.rows, m.K, m.rows, lambda))
            verify_sheet_holds(s->sheet, status_fail(&s->sheet->why, STATUS_LIBRARY,
                                                     "LAPACK's dsyevd failed"));
        for (int n = 0; n < m.rows; n++)
            zeros += fabs(lambda[n]) < ZERO * lambda[m.rows - 1];
        verify_row_judge(t.row, zeros, 6, 0);
    }
    matrices_clear(&m);
}

/* --- A sheet whose corners are turned, and nothing else: all of it follows. From a third
 * of a turn on the search, which begins at the flat rest, can turn elements inside out. */

/* X turned about (1,2,2)/3 by `angle`, less X (Rodrigues). */
static void turn(double angle, const double X[3], double shift[3])
{
    const double n[3] = {1 / 3., 2 / 3., 2 / 3.};
    double along = n[0] * X[0] + n[1] * X[1] + n[2] * X[2];

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double across = n[j] * X[k] - n[k] * X[j];
        shift[i] = (cos(angle) - 1) * (X[i] - along * n[i]) + sin(angle) * across;
    }
}

/* Each corner goes round to its place in ROWS pieces, which statics follow. */
static void add_supports(double angle, bool solid, struct settings *all)
{
    enum { ROWS = 8 };

    settings_set(all, "supports=[");
    for (int c = 0; c < (solid ? 8 : 4); c++) {
        double u = c & 1, v = c >> 1 & 1, w = solid ? c >> 2 : 0.5, shift[3];
        settings_more(all, "%s{at: {u: %g, v: %g", c ? ", " : "", u, v);
        if (solid)
            settings_more(all, ", w: %g", w);
        settings_more(all, "}, fix: xyz, path: [");
        for (int k = 0; k <= ROWS; k++) {
            turn(angle * k / ROWS,
                 (double[3]){u * LENGTH, v * WIDTH, (w - 0.5) * THICKNESS}, shift);
            settings_more(all, "%s[%g, %.17g, %.17g, %.17g]", k ? ", " : "",
                          (double)k / ROWS, shift[0], shift[1], shift[2]);
        }
        settings_more(all, "]}");
    }
    settings_more(all, "]");
}

static void add_rigid(struct verify_subject *s, double angle)
{
    struct energy energy;

    if (!s->layers && s->degree == 1)
        verify_subject_claim(s, NAN, "springs may crumple between the corners");
    struct verify_trial t = verify_trial_of(
        s, "cantilever", "energy / (E m^3), corners turned by %g rad", angle);
    settings_list(&t.settings, SHAPE, box_settings);
    settings_set(&t.settings, "discretization.kinematics=nonlinear");
    settings_set(&t.settings, "gravity=[0,0,0]");
    add_supports(angle, s->layers, &t.settings);
    if (verify_trial_settle(&t) && t.run.model->energy) {
        t.run.model->energy(t.run.state, &energy);
        verify_row_judge_error(t.row, energy.elastic / YOUNG, 0);
    }
    run_close(&t.run);
}

static void run(struct verify_sheet *sheet)
{
    struct verify_subject s;

    for (int kind = 0; kind < 6; kind++)
        for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);)
            if (kind < 2)
                add_box(&s, kind == 1);
            else if (kind < 4)
                add_zero_modes(&s, kind == 2 ? "cantilever" : "cloak");
            else
                add_rigid(&s, kind == 4 ? 0.5 : 1);
}

const struct verify_check verify_matrices = {
    .item = {"matrices", "stiffness and mass of a box, zero modes, turned sheets"},
    .source = "products of matrices of one variable (verify_box.h); six rigid motions",
    .run = run,
};
