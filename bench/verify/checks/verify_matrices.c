#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify_box.h"
#include "bench/verify/verify_check.h"

/* Claim for matrices, whose entries are sums over a few hundred points of a dozen roundings
 * each, and for energies of turned sheets, in E times 1 m^3. */
#define ASKED 1e-12, NULL
/* Share of the largest eigenvalue up to which one counts as zero: round-off makes some n
 * eps |K|, n < 500; the softest true mode, bending at h / L = 0.05, is at 1e-8 or above. */
static const double ZERO = 1e-11;
static const double LENGTH = 1.1, WIDTH = 0.7, THICKNESS = 0.05;
static const double YOUNG = 3, POISSON = 0.3, DENSITY = 1.7;
#define SHAPE "sheet={length: 1.1, width: 0.7, thickness: 0.05}; material.young=3"
#define BOX   SHAPE "; material.poisson=0.3; material.density=1.7"

/* Those marked have, on purpose, a stiffness that is not that of the full rule. */
#define REMEDY "discretization.remedy="
#define DEGREE "discretization.degree="
#define LUMPED "1e-12 of M, as of the others, which is not what lumped mass is"
/* clang-format off */
static const struct verify_subject entries[] = {
    {"iga", ASKED, {6}, {5}, 0, "p = 2, 2, 1", {DEGREE "[2,2,1]", REMEDY "none"}},
    {"iga", ASKED, {6}, {5}, 0, "p = 3, 3, 2", {DEGREE "[3,3,2]", REMEDY "none"}, 3},
    {"iga", ASKED, {6}, {4}, 0, "p = 4, 2, 3", {DEGREE "[4,2,3]", REMEDY "none"}, 4},
    {"iga", ASKED, {6}, {5}, 0, "selective", {DEGREE "[2,2,1]", REMEDY "selective"},
     .mark = true},
    {"hex", ASKED, {6}, {5}, .settings = {REMEDY "none"}},
    {"hex", ASKED, {4}, {5}, .settings = {REMEDY "none"}, .layers = 4},
    {"hex", ASKED, {6}, {5}, 0, "incompatible", {REMEDY "incompatible"}, .mark = true},
    {"shell", ASKED, {6}, {5}, 0, "p = 2", {DEGREE "[2,2]", REMEDY "none"}, .mark = true},
    {"shell", ASKED, {7}, {6}, 0, "p = 3", {DEGREE "[3,3]", REMEDY "none"}, .mark = true},
    {"shell_selective_2", ASKED, {6}, {5}, .mark = true},
    {"shell_selective_3", ASKED, {7}, {6}, .mark = true},
    {"triangles", 0, "mass is lumped on purpose", {6}, {5}, .mark = true, .changed = LUMPED},
    {"mass_spring,position_based,projective_dynamics", ASKED, {6}, {5}, .mark = true},
    {NULL}};
/* clang-format on */
static const struct verify_field field = {
    entries, CONTESTANT_SMALL, "iga,hex,shell", {6}, {5}};

/* Holds K, or M, against the products for the box; a surface's net has one layer. */
static void judge_box(struct verify_trial *t, bool mass, int rows, const double *ours)
{
    const struct discretization *d = &t->run.discretization;
    const struct verify_box box = {
        .degree = {d->degree[0], d->degree[1], d->degree[2]},
        .points = {d->points[0], d->points[1], t->subject->layers ? d->points[2] : 0},
        .size = {LENGTH, WIDTH, THICKNESS},
        .density = DENSITY,
        .lambda = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)),
        .mu = YOUNG / (2 * (1 + POISSON))};
    struct verify_sheet *sheet = t->subject->sheet;
    const int count = rows * rows;
    double *zero = arena_take(&t->arena, 2 * (size_t)count, sizeof *zero),
           *want = zero + count;

    if (verify_sheet_holds(sheet, verify_box_matrix(&box, mass, want, &sheet->why)))
        verify_row_judge_error(
            t->row,
            verify_row_apart(count, ours, want) / verify_row_apart(count, want, zero), 0);
}

static void add_box(struct verify_subject *s)
{
    const bool mass = s->at == 1;
    int rows;
    struct verify_trial t SCOPED(verify_trial_close) =
        verify_trial_of(s, "cantilever", "%s of a box, entries", mass ? "M" : "K");

    verify_trial_set(&t, BOX);
    double *ours = verify_trial_matrix(&t, mass, &rows);
    if (ours && !mass && s->mark)
        verify_row_end(t.row, VERDICT_NOT_APPLICABLE,
                       "its stiffness differs from the solid's on purpose");
    else if (ours)
        judge_box(&t, mass, rows, ours);
}

/* Counts the motions without energy. */
static void add_zero_modes(struct verify_subject *s)
{
    const char *scene = s->at ? "cloak" : "cantilever";
    int rows, zeros = 0;

    /* a tenth of six allows not one more or less */
    verify_subject_claim(s, 0.1, "three shifts, three turns");
    struct verify_trial t SCOPED(verify_trial_close) =
        verify_trial_of(s, scene, "eigenvalues of K that vanish, %s", scene);
    settings_number(&t.settings, "sheet.thickness", THICKNESS);
    double *K = verify_trial_matrix(&t, false, &rows);
    double *lambda = arena_take(&t.arena, (size_t)rows, sizeof *lambda);
    if (K) {
        if (LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'N', 'U', rows, K, rows, lambda))
            verify_sheet_holds(s->sheet, status_fail(&s->sheet->why, STATUS_LIBRARY,
                                                     "LAPACK's dsyevd failed"));
        for (int n = 0; n < rows; n++)
            zeros += fabs(lambda[n]) < ZERO * lambda[rows - 1];
        verify_row_judge(t.row, zeros, 6, 0);
    }
}

/* --- A sheet whose corners alone are turned: all of it follows. From a third of a turn on
 * the search, which begins at the flat rest, can turn elements inside out. */

/* Computes the shift of X that is turned about (1,2,2)/3 by `angle` (Rodrigues). */
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

/* Leads each corner round to its place in ROWS pieces, which statics follow. */
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

static void add_rigid(struct verify_subject *s)
{
    const double angle = s->at ? 1 : 0.5;
    struct energy energy;

    if (!s->layers && s->degree == 1)
        verify_subject_claim(s, NAN, "springs may crumple between the corners");
    struct verify_trial t = verify_trial_of(
        s, "cantilever", "energy / (E m^3), corners turned by %g rad", angle);
    verify_trial_set(&t, SHAPE "; discretization.kinematics=nonlinear; gravity=[0,0,0]");
    add_supports(angle, s->layers, &t.settings);
    if (verify_trial_settle(&t) && t.run.model->energy) {
        t.run.model->energy(t.run.state, &energy);
        verify_row_judge_error(t.row, energy.elastic / YOUNG, 0);
    }
    run_close(&t.run);
}

const struct verify_check verify_matrices = {
    {"matrices", "stiffness and mass of a box, zero modes, turned sheets"},
    "products of matrices of one variable (verify_box.h); six rigid motions",
    .parts = {{&field, add_box, 2}, {&field, add_zero_modes, 2}, {&field, add_rigid, 2}}};
