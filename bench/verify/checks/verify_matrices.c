/* Stiffness and mass of a box against products of matrices of one variable; six motions
 * without energy, flat and curved; and a sheet turned as a whole, which keeps no energy.
 */
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify.h"
#include "bench/verify/verify_box.h"

extern const struct verify_check verify_matrices;

/* Asked: 1e-12. An entry is a sum over a few hundred points of a dozen roundings each. */
static const double TOL_MATRIX = 1e-12;
/* Eigenvalues of round-off: some n eps |K|, n < 500; the softest true mode of these boxes,
 * bending at h / L = 0.05, is at 1e-8 of the largest or above. */
static const double ZERO = 1e-11;
/* Asked: 1e-12 of E (times 1 m^3), turned by any angle. */
static const double TOL_RIGID = 1e-12;

static const double LENGTH = 1.1, WIDTH = 0.7, THICKNESS = 0.05;
static const double YOUNG = 3, POISSON = 0.3, DENSITY = 1.7;

#define SIX "three shifts, three turns"

static const struct sheet {
    const char *title, *model, *settings;
    int points[3], degree[3]; /* r = 0: a surface                                      */
    bool own_rule;            /* its stiffness is not that of the full rule, on purpose */
} sheets[] = {
    {"iga, none", "iga", "", {6, 5, 2}, {2, 2, 1}, false},
    {"iga, none", "iga", "discretization.degree=[3,3,2]", {6, 5, 3}, {3, 3, 2}, false},
    {"iga, none", "iga", "discretization.degree=[4,2,3]", {6, 4, 4}, {4, 2, 3}, false},
    {"iga, reduced", "iga", "discretization.remedy=reduced", {6, 5, 2}, {2, 2, 1}, true},
    {"iga, selective",
     "iga",
     "discretization.remedy=selective",
     {6, 5, 2},
     {2, 2, 1},
     true},
    {"hex, none", "hex", "", {6, 5, 2}, {1, 1, 1}, false},
    {"hex, none", "hex", "", {4, 5, 4}, {1, 1, 1}, false},
    {"hex, incompatible",
     "hex",
     "discretization.remedy=incompatible",
     {6, 5, 2},
     {1, 1, 1},
     true},
    {"shell", "shell", "discretization.degree=[2,2]", {6, 5, 1}, {2, 2, 0}, true},
    {"shell", "shell", "discretization.degree=[3,3]", {7, 6, 1}, {3, 3, 0}, true},
    {"mass_spring, matched", "mass_spring", "", {6, 5, 1}, {1, 1, 0}, true},
    {"projective_dynamics, matched", "projective_dynamics", "", {6, 5, 1}, {1, 1, 0}, true},
};
enum { SHEETS = sizeof sheets / sizeof *sheets };

struct named {
    char title[VERIFY_TEXT], settings[512];
    struct verify_subject subject;
};

static void name_subject(const struct sheet *s, const char *more, double tolerance,
                         const char *reason, struct named *named)
{
    const int *n = s->points, *p = s->degree;

    snprintf(named->title, sizeof named->title, "%s, p = %d, %d, %d, %dx%dx%d", s->title,
             p[0], p[1], p[2], n[0], n[1], n[2]);
    snprintf(named->settings, sizeof named->settings,
             "discretization.points=[%d,%d,%d] %s %s", n[0], n[1], n[2], s->settings, more);
    named->subject =
        (struct verify_subject){named->title, s->model, named->settings, tolerance, reason};
}

/* --- K and M. */

/* Solids may have other unknowns than control points. */
static const char *points_of(const struct sheet *s)
{
    return s->degree[2] ? "discretization.unknowns=points" : "";
}

/* The full matrix [rows][rows] of a lower triangle; NULL: out of memory. */
static double *dense(const struct matrix *m)
{
    double *full = calloc((size_t)m->rows * (size_t)m->rows, sizeof *full);

    for (long t = 0; full && t < m->entries; t++)
        full[(size_t)m->row[t] * (size_t)m->rows + (size_t)m->column[t]] =
            full[(size_t)m->column[t] * (size_t)m->rows + (size_t)m->row[t]] = m->value[t];
    return full;
}

/* The model's dense K and M, 3 nodes rows; *given is false, and the row says why, if it has
 * none. Owned by the caller. */
static enum status model_matrices(struct verify_row *row, const struct named *named,
                                  const char *scene, const char *const *settings, int *rows,
                                  double **K, double **M, bool *given, struct message *why)
{
    enum status st;
    struct trial trial;
    struct matrix sparse[2] = {{0}};

    *K = *M = NULL;
    TRY(verify_open(row, &named->subject, scene, settings, &trial, given, why));
    if (*given && !trial.model->matrices) {
        verify_not_applicable(row, "%s has no constant matrices", trial.model->name);
        *given = false;
    }
    if (!*given)
        goto out;
    st = trial.model->matrices(trial.state, &sparse[0], &sparse[1]);
    if (st == STATUS_UNSUPPORTED) {
        verify_not_applicable(row, "it has none for control points as unknowns");
        *given = false;
        st = STATUS_OK;
        goto out;
    }
    TRY(st);
    *rows = sparse[0].rows;
    *K = dense(&sparse[0]);
    *M = dense(&sparse[1]);
    st = *K && *M ? STATUS_OK : STATUS_MEMORY;
out:
    trial_close(&trial);
    matrix_clear(&sparse[0]);
    matrix_clear(&sparse[1]);
    return st;
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

/* Products for the sheet: K, and M spread over three components, [3 nodes][3 nodes]. */
static enum status products(const struct sheet *s, double *K, double *M,
                            struct message *why)
{
    enum status st = STATUS_OK;
    struct bspline basis[3] = {{0}};
    struct verify_box box = {.size = {LENGTH, WIDTH, THICKNESS}, .density = DENSITY};
    double *small = NULL;

    box.lambda = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON));
    box.mu = YOUNG / (2 * (1 + POISSON));
    for (int d = 0; d < 3; d++)
        if (s->degree[d]) {
            TRY(bspline_init_uniform(&basis[d], s->degree[d], s->points[d], why));
            box.basis[d] = &basis[d];
        }
    size_t n = (size_t)verify_box_nodes(&box);
    small = malloc(n * n * sizeof *small);
    st = small ? verify_box_matrices(&box, K, small) : STATUS_MEMORY;
    memset(M, 0, 9 * n * n * sizeof *M);
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

static enum status add_box(struct verify_sheet *sheet, const struct sheet *s, bool mass,
                           struct message *why)
{
    enum status st;
    static const char *const settings[] = {"sheet.length=1.1",
                                           "sheet.width=0.7",
                                           "sheet.thickness=0.05",
                                           "material.young=3",
                                           "material.poisson=0.3",
                                           "material.density=1.7",
                                           NULL};
    double *K = NULL, *M = NULL, *want = NULL;
    struct named named;
    bool given;
    int rows;

    name_subject(s, points_of(s), TOL_MATRIX, NULL, &named);
    struct verify_row *row =
        verify_add(sheet, &named.subject, "%s of a box, entries", mass ? "M" : "K");
    TRY(model_matrices(row, &named, "cantilever", settings, &rows, &K, &M, &given, why));
    if (!given)
        goto out;
    if (!mass && s->own_rule) {
        verify_not_applicable(row, "its stiffness differs from the solid's on purpose");
        goto out;
    }
    size_t count = (size_t)rows * (size_t)rows;
    want = malloc(2 * count * sizeof *want);
    st = want ? products(s, want, want + count, why) : STATUS_MEMORY;
    if (st == STATUS_OK)
        verify_judge_error(row,
                           mass ? apart(count, M, want + count) : apart(count, K, want), 0);
out:
    free(K);
    free(M);
    free(want);
    return st;
}

/* --- Motions without energy. */

static enum status add_zero_modes(struct verify_sheet *sheet, const struct sheet *s,
                                  const char *scene, struct message *why)
{
    enum status st;
    double *K = NULL, *M = NULL, *lambda = NULL;
    struct named named;
    bool given;
    int rows, zeros = 0;

    name_subject(s, points_of(s), 0.1, SIX, &named); /* of six: not one more or less */
    struct verify_row *row =
        verify_add(sheet, &named.subject, "eigenvalues of K that vanish, %s", scene);
    static const char *const settings[] = {"sheet.thickness=0.05", NULL};
    TRY(model_matrices(row, &named, scene, settings, &rows, &K, &M, &given, why));
    if (!given)
        goto out;
    lambda = malloc((size_t)rows * sizeof *lambda);
    if (!lambda)
        TRY(STATUS_MEMORY);
    if (LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'N', 'U', rows, K, rows, lambda))
        TRY(status_fail(why, STATUS_LIBRARY, "LAPACK's dsyevd failed"));
    for (int n = 0; n < rows; n++)
        zeros += fabs(lambda[n]) < ZERO * lambda[rows - 1];
    verify_judge(row, zeros, 6, 0);
out:
    free(K);
    free(M);
    free(lambda);
    return st;
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
static void write_supports(double angle, bool solid, size_t size, char *text)
{
    enum { ROWS = 8 };
    size_t used = (size_t)snprintf(text, size, "supports=[");

    for (int c = 0; c < (solid ? 8 : 4) && used < size; c++) {
        double u = c & 1, v = c >> 1 & 1, w = solid ? c >> 2 : 0.5, shift[3];
        char layer[32] = "";
        if (solid)
            snprintf(layer, sizeof layer, ", w: %g", w);
        used += (size_t)snprintf(text + used, size - used,
                                 "%s{at: {u: %g, v: %g%s}, fix: xyz, path: [",
                                 c ? ", " : "", u, v, layer);
        for (int k = 0; k <= ROWS && used < size; k++) {
            turn(angle * k / ROWS,
                 (double[3]){u * LENGTH, v * WIDTH, (w - 0.5) * THICKNESS}, shift);
            used += (size_t)snprintf(text + used, size - used,
                                     "%s[%g, %.17g, %.17g, %.17g]", k ? ", " : "",
                                     (double)k / ROWS, shift[0], shift[1], shift[2]);
        }
        if (used < size)
            used += (size_t)snprintf(text + used, size - used, "]}");
    }
    if (used < size)
        snprintf(text + used, size - used, "]");
}

static enum status add_rigid(struct verify_sheet *sheet, const struct sheet *s,
                             double angle, struct message *why)
{
    enum status st;
    const bool solid = s->degree[2] > 0, net = s->degree[0] == 1 && !solid;
    char supports[8192];
    const char *settings[] = {"sheet.length=1.1",
                              "sheet.width=0.7",
                              "sheet.thickness=0.05",
                              "material.young=3",
                              "gravity=[0,0,0]",
                              supports,
                              NULL};
    struct named named;
    struct trial trial;
    struct counters work = {0};
    struct message sentence = {""};
    struct energy energy;
    bool ready;

    write_supports(angle, solid, sizeof supports, supports);
    name_subject(s, net ? "" : "discretization.kinematics=nonlinear", net ? NAN : TOL_RIGID,
                 net ? "springs may crumple between the corners" : NULL, &named);
    struct verify_row *row = verify_add(
        sheet, &named.subject, "energy / (E m^3), corners turned by %g rad", angle);
    TRY(verify_open(row, &named.subject, "cantilever", settings, &trial, &ready, why));
    if (!ready)
        goto out;
    if (!trial.model->equilibrium || !trial.model->energy) {
        verify_not_applicable(row, "%s has no static equilibrium", trial.model->name);
        goto out;
    }
    st = trial.model->equilibrium(trial.state, &work, &sentence);
    if (st != STATUS_OK) {
        verify_died(row, "%s", sentence.text);
        st = STATUS_OK;
        goto out;
    }
    trial.model->energy(trial.state, &energy);
    verify_judge_error(row, energy.elastic / YOUNG, 0);
out:
    trial_close(&trial);
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;

    for (int kind = 0; kind < 6; kind++)
        for (int n = 0; n < SHEETS; n++) {
            const struct verify_subject subject = {.model = sheets[n].model};
            if (!verify_wanted(sheet, &subject))
                continue;
            if (kind < 2)
                TRY(add_box(sheet, &sheets[n], kind == 1, why));
            else if (kind < 4)
                TRY(add_zero_modes(sheet, &sheets[n], kind == 2 ? "cantilever" : "cloak",
                                   why));
            else
                TRY(add_rigid(sheet, &sheets[n], kind == 4 ? 0.5 : 1, why));
        }
out:
    return st;
}

const struct verify_check verify_matrices = {
    .item = {"matrices", "stiffness and mass of a box, zero modes, turned sheets"},
    .source = "products of matrices of one variable (verify_box.h); six rigid motions",
    .run = run,
};
