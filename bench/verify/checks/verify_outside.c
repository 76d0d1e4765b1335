/* What CalculiX and FreeFEM computed, stored in tests/reference: element matrices, tips and
 * a large swing by the one; plates let go, as three-dimensional solids, by the other.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify.h"
#include "fem_ref/freefem.h"

extern const struct verify_check verify_outside;

#define LINEAR(remedy) "discretization.kinematics=linear discretization.remedy=" remedy
#define LARGE(remedy)  "discretization.kinematics=nonlinear discretization.remedy=" remedy
#define NET(a, b, c)   " discretization.points=[" #a "," #b "," #c "]"
#define SURFACE(a, b)  " discretization.points=[" #a "," #b "] discretization.degree=[3,3]"
#define QUADRATIC      " discretization.degree=[2,2,1]"
#define CUBIC          " discretization.degree=[3,3,2]"
#define COUNT(array)   ((int)(sizeof(array) / sizeof *(array)))

/* The physics that a file's notes tell, as settings, and one more. */
struct physics {
    char text[7][64];
    const char *list[9]; /* ends with NULL */
};

/* The larger one; NaN if one is. */
static double worse(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

static double note_number(const struct reference *table, const char *key)
{
    const char *text = reference_note(table, key);
    return text ? strtod(text, NULL) : NAN;
}

static void physics_of(const struct reference *table, const char *more, struct physics *p)
{
    static const char *const key[][2] = {
        {"length", "sheet.length=%.17g"},      {"width", "sheet.width=%.17g"},
        {"young", "material.young=%.17g"},     {"poisson", "material.poisson=%.17g"},
        {"density", "material.density=%.17g"}, {"gravity", "gravity=[0,0,-%.17g]"},
        {"thickness", "sheet.thickness=%.17g"}};
    int count = 0;

    memset(p, 0, sizeof *p);
    p->list[count++] = more;
    for (int n = 0; n < COUNT(key); n++)
        if (reference_note(table, key[n][0])) {
            snprintf(p->text[n], sizeof p->text[n], key[n][1],
                     note_number(table, key[n][0]));
            p->list[count++] = p->text[n];
        }
}

/* ------------------------------------------------------------------ matrices -------- */

/* Asked: two codes that do the same sums differ by round-off. The file has 14 digits. */
static const double MATRIX = 1e-12, DIGITS = 5e-14;

static const struct verify_subject blocks[] = {
    {"hex, none, 3x3x2", "hex", "discretization.unknowns=points" NET(3, 3, 2), MATRIX,
     "the same sums"},
    {"iga, p = 1, 3x3x2", "iga",
     "discretization.unknowns=points discretization.degree=[1,1,1]" NET(3, 3, 2), MATRIX,
     "linear B-splines are the same functions"},
};

/* Largest difference of the triangles' entries, of the largest; INFINITY for other sizes.
 */
static double matrix_error(const struct matrix *m, const struct reference *table,
                           const char *column)
{
    size_t rows = (size_t)m->rows;
    double most = 0, apart = 0, *rest = calloc(rows * rows, sizeof *rest);

    for (long t = 0; rest && t < m->entries; t++)
        rest[rows * (size_t)m->row[t] + (size_t)m->column[t]] = m->value[t];
    for (int n = 0; rest && n < reference_rows(table); n++) {
        double i = reference_number(table, n, "row");
        double j = reference_number(table, n, "column");
        double value = reference_number(table, n, column);
        most = fmax(most, fabs(value));
        if (i < (double)rows && j < (double)rows)
            rest[rows * (size_t)i + (size_t)j] -= value;
        else
            apart = INFINITY;
    }
    for (size_t n = 0; rest && n < rows * rows; n++)
        apart = worse(fabs(rest[n]), apart);
    free(rest);
    return apart / most;
}

static enum status add_block(struct verify_sheet *sheet, const struct verify_subject *s,
                             const struct reference *table, struct message *why)
{
    enum status st;
    struct physics physics;
    struct trial trial;
    struct matrix K = {0}, M = {0};
    bool ready;
    struct verify_row *row = verify_add(sheet, s, "stiffness matrix of a block, CalculiX");

    physics_of(table, "sheet.length=1", &physics);
    TRY(verify_open(row, s, "cantilever", physics.list, &trial, &ready, why));
    if (!ready)
        goto out;
    TRY(trial.model->matrices(trial.state, &K, &M));
    verify_judge_error(row, matrix_error(&K, table, "stiffness"), DIGITS);
    row = verify_add(sheet, s, "mass matrix of a block, CalculiX");
    verify_judge_error(row, matrix_error(&M, table, "mass"), DIGITS);
out:
    matrix_clear(&K);
    matrix_clear(&M);
    trial_close(&trial);
    return st;
}

static enum status run_blocks(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("calculix_matrices_box", &table, why));
    for (int n = 0; n < COUNT(blocks); n++)
        if (verify_wanted(sheet, &blocks[n]))
            TRY(add_block(sheet, &blocks[n], table, why));
out:
    reference_close(table);
    return st;
}

/* ------------------------------------------------------------------ tips ------------ */

/* The same element on the same nodes, to the 7 digits of the file. */
static const struct verify_subject twin = {"hex, incompatible, 33x33x2", "hex",
                                           LINEAR("incompatible") NET(33, 33, 2), 1e-6,
                                           "the same element"};

/* What round-off leaves of an answer in nodes of both faces, which CalculiX solves for: the
 * condition of K, 2.5e12 at h/L = 1e-3 and as h^-4. */
static double rounding(double h)
{
    return 1e-16 * 2.5e12 * pow(h / 1e-3, -4);
}

static enum status add_tip(struct verify_sheet *sheet, const struct reference *table, int n,
                           struct message *why)
{
    const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    const char *const column[] = {"middle", "corner"};
    double h = reference_number(table, n, "thickness"), xyz[2][3];
    struct physics physics;
    char thickness[64];
    bool lived;
    struct verify_row *row =
        verify_add(sheet, &twin, "tip [m] by C3D8I, h/L = %g, %s", h, column[0]);

    snprintf(thickness, sizeof thickness, "sheet.thickness=%.17g", h);
    physics_of(table, thickness, &physics);
    enum status st = verify_equilibrium(row, &twin, "cantilever", physics.list, 2, uvw[0],
                                        xyz[0], &lived, why);
    for (int k = 0; k < 2 && st == STATUS_OK && lived; k++) {
        if (k == 1)
            row = verify_add(sheet, &twin, "tip [m] by C3D8I, h/L = %g, %s", h, column[1]);
        verify_judge(row, -xyz[k][2], reference_number(table, n, column[k]), rounding(h));
    }
    return st;
}

static enum status run_tips(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("calculix_tips", &table, why));
    for (int n = reference_find(table, 0, "element", "C3D8I");
         n >= 0 && verify_wanted(sheet, &twin);
         n = reference_find(table, n + 1, "element", "C3D8I"))
        TRY(add_tip(sheet, table, n, why));
out:
    reference_close(table);
    return st;
}

/* ------------------------------------------------------------------ swing ----------- */

/* Asked of nonlinear solids. */
static const double SWING = 1e-3;

static const struct verify_subject strips[] = {
    {"iga, p = 3, r = 2, nonlinear, 19x4x3", "iga", LARGE("none") CUBIC NET(19, 4, 3),
     SWING, "asked"},
    {"iga, reduced, nonlinear, 66x3x2", "iga", LARGE("reduced") QUADRATIC NET(66, 3, 2),
     SWING, "asked"},
    {"hex, incompatible, nonlinear, 129x2x2", "hex", LARGE("incompatible") NET(129, 2, 2),
     SWING, "asked"},
    {"shell, p = 3, nonlinear, 35x4", "shell",
     "discretization.kinematics=nonlinear" SURFACE(35, 4), SWING, "as of solids"},
    {"mass_spring, matched, 40x3", "mass_spring", " discretization.points=[40,3]", NAN,
     "implicit Euler damps"},
    {"projective_dynamics, matched, 40x3", "projective_dynamics",
     " discretization.points=[40,3]", NAN, "implicit Euler damps"},
};

enum { TIMES = 6, POINTS = 4 };

/* Positions at every 0.05 s of the table's 0.01 s. */
static void read_swing(const struct reference *table, double time[TIMES],
                       double truth[TIMES * POINTS][2])
{
    static const char *const name[POINTS] = {"1.00", "0.75", "0.50", "0.25"};

    for (int t = 0; t < TIMES; t++) {
        int row = 5 * (t + 1) - 1;
        time[t] = reference_number(table, row, "t");
        for (int p = 0; p < POINTS; p++)
            for (int c = 0; c < 2; c++) {
                char column[8];
                snprintf(column, sizeof column, "%c%s", c ? 'z' : 'x', name[p]);
                truth[t * POINTS + p][c] = reference_number(table, row, column);
            }
    }
}

static enum status run_swing(struct verify_sheet *sheet, struct message *why)
{
    static const double uvw[POINTS][3] = {
        {1, 0.5, 0.5}, {0.75, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}};
    enum status st;
    struct reference *table = NULL;
    struct physics physics;
    double time[TIMES], truth[TIMES * POINTS][2], xyz[TIMES * POINTS][3];
    bool lived;

    TRY(verify_reference("calculix_swing_h5mm", &table, why));
    read_swing(table, time, truth);
    physics_of(table, "time.step=0.005", &physics);
    for (int s = 0; s < COUNT(strips); s++) {
        if (!verify_wanted(sheet, &strips[s]))
            continue;
        struct verify_row *row =
            verify_add(sheet, &strips[s], "swing by C3D20R: position / L until 0.3 s");
        double worst = 0;
        TRY(verify_motion(row, &strips[s], "cantilever_transient", physics.list, TIMES,
                          time, POINTS, uvw[0], xyz[0], &lived, why));
        for (int n = 0; lived && n < TIMES * POINTS; n++) {
            double far = hypot(xyz[n][0] - truth[n][0], xyz[n][2] - truth[n][1]);
            worst = worse(far, worst);
        }
        if (lived)
            verify_judge_error(row, worst,
                               note_number(table, "mesh_error_m") +
                                   note_number(table, "step_error_m"));
    }
out:
    reference_close(table);
    return st;
}

/* ------------------------------------------------------------------ plates let go --- */

/* As in `transient`, on its finest nets: a solid 1 %; a thin shell is to be as good. */
static const double PLATE = 0.01;

static const struct verify_subject plates[] = {
    {"iga, none, linear, 10x10x2", "iga", LINEAR("none") QUADRATIC NET(10, 10, 2), NAN,
     "the paper's: locks"},
    {"iga, reduced, linear, 34x18x2", "iga", LINEAR("reduced") QUADRATIC NET(34, 18, 2),
     PLATE, NULL},
    {"iga, p = 3, r = 2, linear, 35x19x3", "iga", LINEAR("none") CUBIC NET(35, 19, 3),
     PLATE, NULL},
    {"hex, incompatible, linear, 65x33x2", "hex", LINEAR("incompatible") NET(65, 33, 2),
     PLATE, NULL},
    {"shell, p = 3, linear, 19x11", "shell",
     "discretization.kinematics=linear" SURFACE(19, 11), PLATE, NULL},
};

enum { SIDE = FREEFEM_SIDE, PLATE_POINTS = SIDE * SIDE };

/* Largest rms difference at one of the times, of the rms of the field; *bar: its error. */
static double plate_error(const struct freefem_field *f, const double (*uvw)[3],
                          const double (*xyz)[3], double *bar)
{
    double worst = -1;

    for (int t = 0; t < f->times; t++) {
        const double *shift = f->shift[t][0][0];
        double far = 0, moved = 0;
        for (int n = 0; n < PLATE_POINTS; n++)
            for (int i = 0; i < 3; i++) {
                double x = xyz[t * PLATE_POINTS + n][i] - (i < 2 ? uvw[n][i] : 0);
                far += pow(x - shift[3 * n + i], 2);
                moved += pow(shift[3 * n + i], 2);
            }
        if (worse(sqrt(far / moved), worst) != worst)
            *bar = f->error[t] / sqrt(moved / PLATE_POINTS);
        worst = worse(sqrt(far / moved), worst);
    }
    return worst;
}

static enum status add_plate(struct verify_sheet *sheet, const struct verify_subject *s,
                             double h, const struct physics *physics,
                             const struct freefem_field *f, struct message *why)
{
    double uvw[PLATE_POINTS][3], bar = NAN;
    double(*xyz)[3] = calloc((size_t)f->times * PLATE_POINTS, sizeof *xyz);
    bool lived;
    struct verify_row *row =
        verify_add(sheet, s, "let go, field by FreeFEM to 0.4 s, h/L = %g", h);

    if (!xyz)
        return STATUS_MEMORY;
    for (int n = 0; n < PLATE_POINTS; n++) {
        uvw[n][0] = n % SIDE / (SIDE - 1.0), uvw[n][1] = n / SIDE / (SIDE - 1.0);
        uvw[n][2] = 0.5;
    }
    enum status st = verify_motion(row, s, "cantilever_transient", physics->list, f->times,
                                   f->time, PLATE_POINTS, uvw[0], xyz[0], &lived, why);
    if (st == STATUS_OK && lived) {
        double error = plate_error(f, uvw, xyz, &bar);
        verify_judge_error(row, error, bar);
    }
    free(xyz);
    return st;
}

/* Reads a field, for the physics that its notes tell. */
static enum status read_plate(const char *name, struct physics *physics, double *h,
                              struct freefem_field *f, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    char *path = NULL;

    TRY(verify_reference_path(name, &path, why));
    TRY(reference_open(path, &table, why));
    physics_of(table, "time.step=0.00125", physics);
    *h = note_number(table, "thickness");
    struct freefem_job job = {.thickness = *h,
                              .young = note_number(table, "young"),
                              .poisson = note_number(table, "poisson"),
                              .density = note_number(table, "density"),
                              .gravity = note_number(table, "gravity"),
                              .steps = (int)note_number(table, "steps")};
    TRY(freefem_stored(&job, path, f, why));
out:
    reference_close(table);
    free(path);
    return st;
}

static enum status run_plates(struct verify_sheet *sheet, struct message *why)
{
    static const char *const names[] = {"freefem_transient_h10mm",
                                        "freefem_transient_h1mm"};
    enum status st = STATUS_OK;
    struct freefem_field *f = malloc(sizeof *f);
    struct physics physics;
    double h;

    if (!f)
        return STATUS_MEMORY;
    for (int n = 0; n < (verify_quick(sheet) ? 1 : COUNT(names)); n++) {
        TRY(read_plate(names[n], &physics, &h, f, why));
        for (int s = 0; s < COUNT(plates); s++)
            if (verify_wanted(sheet, &plates[s]))
                TRY(add_plate(sheet, &plates[s], h, &physics, f, why));
    }
out:
    free(f);
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;

    TRY(run_blocks(sheet, why));
    TRY(run_tips(sheet, why));
    TRY(run_swing(sheet, why));
    TRY(run_plates(sheet, why));
out:
    return st;
}

const struct verify_check verify_outside = {
    .item = {"outside", "matrices, tips and motions that CalculiX and FreeFEM computed"},
    .source = "CalculiX 2.20, tests/reference/calculix_*.csv, 14 digits of matrices, 7 of "
              "tips, round-off by the condition of K, and the swing's own refinement; "
              "FreeFEM, tests/reference/freefem_transient_*.csv, bars in the rows",
    .run = run,
};
