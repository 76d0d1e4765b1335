/* What CalculiX and FreeFEM computed, stored in tests/reference: element matrices, tips and
 * a large swing by the one; plates let go, as three-dimensional solids, by the other.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/truth/truth_table.h"
#include "bench/verify/verify_check.h"
#include "fem_ref/freefem.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* The larger one; NaN if one is. */
static double worse(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

/* The physics that a file's notes tell. */
static void add_physics(const struct reference *table, struct settings *all)
{
    static const char *const key[][2] = {
        {"length", "sheet.length"},      {"width", "sheet.width"},
        {"young", "material.young"},     {"poisson", "material.poisson"},
        {"density", "material.density"}, {"thickness", "sheet.thickness"}};

    for (int n = 0; n < COUNT(key); n++)
        if (reference_note(table, key[n][0]))
            settings_number(all, key[n][1], truth_table_note(table, key[n][0]));
    if (reference_note(table, "gravity"))
        settings_numbers(all, "gravity", 3,
                         (double[]){0, 0, -truth_table_note(table, "gravity")});
}

/* ------------------------------------------------------------------ matrices -------- */

/* Asked: two codes that do the same sums differ by round-off. The file has 14 digits. */
#define MATRIX 1e-12
static const double DIGITS = 5e-14;

#define LINEAR MATRIX, "linear B-splines are the same functions"
#define BLOCKS "discretization.unknowns=points"
static const struct verify_entry blocks[] = {
    {"hex", MATRIX, "the same sums", {3}, .settings = {BLOCKS}},
    {"iga", LINEAR, {3}, {3}, 0, "p = 1", {BLOCKS, "discretization.degree=[1,1,1]"}},
    {NULL}};
static const struct verify_field block_field = {.entry = blocks};

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
    struct matrix K = {0}, M = {0};
    struct verify_row *row =
        verify_sheet_add(sheet, s, "stiffness matrix of a block, CalculiX");
    struct verify_trial t = {row, s, "cantilever"};

    add_physics(table, &t.settings);
    TRY(verify_trial_open(&t, why));
    if (!t.lived)
        goto out;
    TRY(t.run.model->matrices(t.run.state, &K, &M));
    verify_row_judge_error(row, matrix_error(&K, table, "stiffness"), DIGITS);
    row = verify_sheet_add(sheet, s, "mass matrix of a block, CalculiX");
    verify_row_judge_error(row, matrix_error(&M, table, "mass"), DIGITS);
out:
    matrix_clear(&K);
    matrix_clear(&M);
    verify_trial_close(&t);
    return st;
}

static enum status run_blocks(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    struct verify_subject s;

    TRY(truth_table_open("calculix_matrices_box", &table, why));
    for (int n = 0; verify_sheet_next(sheet, &block_field, &n, &s);)
        TRY(add_block(sheet, &s, table, why));
out:
    reference_close(table);
    return st;
}

/* ------------------------------------------------------------------ tips ------------ */

/* The same element on the same nodes, to the 7 digits of the file. */
static const struct verify_entry twin[] = {
    {"hex_incompatible_linear", 1e-6, "the same element", {33}}, {NULL}};
static const struct verify_field twin_field = {.entry = twin};

/* What round-off leaves of an answer in nodes of both faces, which CalculiX solves for: the
 * condition of K, 2.5e12 at h/L = 1e-3 and as h^-4. */
static double rounding(double h)
{
    return 1e-16 * 2.5e12 * pow(h / 1e-3, -4);
}

static enum status add_tip(struct verify_sheet *sheet, const struct verify_subject *s,
                           const struct reference *table, int n, struct message *why)
{
    const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    const char *const column[] = {"middle", "corner"};
    const double h = reference_number(table, n, "thickness");
    double xyz[2][3];
    struct verify_row *row =
        verify_sheet_add(sheet, s, "tip [m] by C3D8I, h/L = %g, %s", h, column[0]);
    struct verify_trial t = {row, s, "cantilever"};

    settings_number(&t.settings, "sheet.thickness", h);
    add_physics(table, &t.settings);
    enum status st = verify_trial_equilibrium(&t, 2, uvw[0], xyz[0], why);
    for (int k = 0; k < 2 && t.lived; k++) {
        if (k == 1)
            row =
                verify_sheet_add(sheet, s, "tip [m] by C3D8I, h/L = %g, %s", h, column[1]);
        verify_row_judge(row, -xyz[k][2], reference_number(table, n, column[k]),
                         rounding(h));
    }
    return st;
}

static enum status run_tips(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    struct verify_subject s;

    TRY(truth_table_open("calculix_tips", &table, why));
    for (int n = 0; (n = reference_find(table, n, "element", "C3D8I")) >= 0; n++)
        for (int k = 0; verify_sheet_next(sheet, &twin_field, &k, &s);)
            TRY(add_tip(sheet, &s, table, n, why));
out:
    reference_close(table);
    return st;
}

/* ------------------------------------------------------------------ swing ----------- */

/* Asked of nonlinear solids. */
#define SWING 1e-3, "asked"

static const struct verify_entry strips[] = {
    {"iga_nonlinear_3", SWING, {19}, {4}, 0, "r = 2", {"discretization.degree=[3,3,2]"}, 3},
    {"iga_reduced", SWING, {66}, {3}},
    {"hex_incompatible", SWING, {129}, {2}},
    {"shell_3", 1e-3, "as of solids", {35}, {4}},
    {"mass_spring", 0, "implicit Euler damps", {40}, {3}},
    {"projective_dynamics", 0, "implicit Euler damps", {40}, {3}},
    {NULL}};
static const struct verify_field strip_field = {
    strips,
    CONTESTANT_LARGE,
    "iga_nonlinear,iga_reduced_3,iga_selective,hex_nonlinear",
    {40}};

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
    double time[TIMES], truth[TIMES * POINTS][2], xyz[TIMES * POINTS][3];
    struct verify_subject s;

    TRY(truth_table_open("calculix_swing_h5mm", &table, why));
    read_swing(table, time, truth);
    for (int k = 0; verify_sheet_next(sheet, &strip_field, &k, &s);) {
        struct verify_row *row =
            verify_sheet_add(sheet, &s, "swing by C3D20R: position / L until 0.3 s");
        struct verify_trial t = {row, &s, "cantilever_transient"};
        double worst = 0;
        settings_set(&t.settings, "time.step=0.005");
        add_physics(table, &t.settings);
        TRY(verify_trial_motion(&t, TIMES, time, POINTS, uvw[0], xyz[0], why));
        for (int n = 0; t.lived && n < TIMES * POINTS; n++) {
            double far = hypot(xyz[n][0] - truth[n][0], xyz[n][2] - truth[n][1]);
            worst = worse(far, worst);
        }
        if (t.lived)
            verify_row_judge_error(row, worst,
                                   truth_table_note(table, "mesh_error_m") +
                                       truth_table_note(table, "step_error_m"));
    }
out:
    reference_close(table);
    return st;
}

/* ------------------------------------------------------------------ plates let go --- */

/* As in `transient`, on its finest nets: a solid 1 %; a thin shell is to be as good. */
#define PLATE 0.01, NULL

static const struct verify_entry plates[] = {
    {"iga_linear", 0, "the paper's: locks", {10}},
    {"iga_reduced_linear", PLATE, {34}, {18}},
    {"iga_linear_32", PLATE, {35}, {19}},
    {"hex_incompatible_linear", PLATE, {65}, {33}},
    {"shell_linear_3", PLATE, {19}, {11}},
    {NULL},
};
static const struct verify_field plate_field = {
    plates,
    CONTESTANT_SMALL,
    "iga_linear_3,iga_reduced_linear_3,iga_selective_linear,iga_selective_linear_3,"
    "hex_linear,shell_linear,mass_spring,projective_dynamics",
    {35},
    {19}};

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
                             const struct reference *table, const struct freefem_field *f,
                             struct message *why)
{
    double uvw[PLATE_POINTS][3], bar = NAN;
    double(*xyz)[3] = calloc((size_t)f->times * PLATE_POINTS, sizeof *xyz);
    struct verify_row *row =
        verify_sheet_add(sheet, s, "let go, field by FreeFEM to 0.4 s, h/L = %g",
                         truth_table_note(table, "thickness"));
    struct verify_trial t = {row, s, "cantilever_transient"};

    if (!xyz)
        return STATUS_MEMORY;
    for (int n = 0; n < PLATE_POINTS; n++) {
        uvw[n][0] = n % SIDE / (SIDE - 1.0), uvw[n][1] = n / SIDE / (SIDE - 1.0);
        uvw[n][2] = 0.5;
    }
    settings_set(&t.settings, "time.step=0.00125");
    add_physics(table, &t.settings);
    enum status st =
        verify_trial_motion(&t, f->times, f->time, PLATE_POINTS, uvw[0], xyz[0], why);
    if (t.lived) {
        double error = plate_error(f, uvw, xyz, &bar);
        verify_row_judge_error(row, error, bar);
    }
    free(xyz);
    return st;
}

/* Rows of one field, with the physics that its notes tell. */
static enum status add_plates(struct verify_sheet *sheet, const char *name,
                              struct freefem_field *f, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    struct verify_subject s;
    char *path = NULL;

    TRY(truth_table_path(name, &path, why));
    TRY(reference_open(path, &table, why));
    struct freefem_job job = {.thickness = truth_table_note(table, "thickness"),
                              .young = truth_table_note(table, "young"),
                              .poisson = truth_table_note(table, "poisson"),
                              .density = truth_table_note(table, "density"),
                              .gravity = truth_table_note(table, "gravity"),
                              .steps = (int)truth_table_note(table, "steps")};
    TRY(freefem_stored(&job, path, f, why));
    for (int n = 0; verify_sheet_next(sheet, &plate_field, &n, &s);)
        TRY(add_plate(sheet, &s, table, f, why));
out:
    reference_close(table);
    free(path);
    return st;
}

static enum status run_plates(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;
    struct freefem_field *f = malloc(sizeof *f);

    if (!f)
        return STATUS_MEMORY;
    TRY(add_plates(sheet, "freefem_transient_h10mm", f, why));
    if (!sheet->quick)
        TRY(add_plates(sheet, "freefem_transient_h1mm", f, why));
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
