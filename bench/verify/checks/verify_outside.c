/* What CalculiX and FreeFEM computed, stored in tests/reference: element matrices, tips and
 * a large swing by the one; plates let go, as three-dimensional solids, by the other.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/verify/checks/verify_plates.h"

/* ------------------------------------------------------------------ matrices -------- */

/* Asked: two codes that do the same sums differ by round-off. The file has 14 digits. */
#define MATRIX 1e-12
static const double DIGITS = 5e-14;

#define LINEAR MATRIX, "linear B-splines are the same functions"
#define BLOCKS "discretization.unknowns=points"
static const struct verify_entry blocks[] = {
    {"hex",
     MATRIX,
     "the same sums",
     {3},
     .settings = {BLOCKS, "discretization.remedy=none"}},
    {"iga",
     LINEAR,
     {3},
     {3},
     0,
     "p = 1",
     {BLOCKS, "discretization.remedy=none", "discretization.degree=[1,1,1]"}},
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
        if (i >= 0 && j >= 0 && i < (double)rows && j < (double)rows)
            rest[rows * (size_t)i + (size_t)j] -= value;
        else
            apart = INFINITY;
    }
    for (size_t n = 0; rest && n < rows * rows; n++)
        apart = verify_row_worse(fabs(rest[n]), apart);
    free(rest);
    return apart / most;
}

static void add_block(const struct verify_subject *s)
{
    const struct reference *table = s->sheet->table;
    struct matrix K = {0}, M = {0};
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "stiffness matrix of a block, CalculiX");

    verify_plates_physics(s->sheet, &t.settings);
    if (verify_trial_open(&t) &&
        verify_sheet_holds(s->sheet, t.run.model->matrices(t.run.state, &K, &M))) {
        verify_row_judge_error(t.row, matrix_error(&K, table, "stiffness"), DIGITS);
        verify_row_judge_error(verify_sheet_add(s, "mass matrix of a block, CalculiX"),
                               matrix_error(&M, table, "mass"), DIGITS);
    }
    matrix_clear(&K);
    matrix_clear(&M);
    run_close(&t.run);
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

static void add_tip(const struct verify_subject *s, int n)
{
    const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    const char *const column[] = {"middle", "corner"};
    const double h = reference_number(s->sheet->table, n, "thickness");
    double xyz[2][3];
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "tip [m] by C3D8I, h/L = %g, %s", h, column[0]);

    settings_number(&t.settings, "sheet.thickness", h);
    verify_plates_physics(s->sheet, &t.settings);
    verify_trial_equilibrium(&t, 2, uvw[0], xyz[0]);
    for (int k = 0; k < 2 && t.lived; k++) {
        if (k == 1)
            t.row = verify_sheet_add(s, "tip [m] by C3D8I, h/L = %g, %s", h, column[1]);
        verify_row_judge(t.row, -xyz[k][2], reference_number(s->sheet->table, n, column[k]),
                         rounding(h));
    }
}

/* ------------------------------------------------------------------ swing ----------- */

/* Asked of nonlinear solids. */
#define SWING 1e-3, "asked"

static const struct verify_entry strips[] = {
    {"iga_nonlinear_3", SWING, {19}, {4}, 0, "r = 2", {"discretization.degree=[3,3,2]"}, 3},
    {"iga_reduced", SWING, {66}, {3}},
    {"hex_incompatible", SWING, {129}, {2}},
    {"shell_3", 1e-3, "as of solids", {35}, {4}},
    {"triangles", SWING, {80}, {3}},
    {"mass_spring", 0, "implicit Euler damps", {40}, {3}},
    {"position_based", 0, "damps as implicit Euler, in small steps", {40}, {3}},
    {"projective_dynamics", 0, "implicit Euler damps", {40}, {3}},
    {NULL}};
#define OTHERS                                                                             \
    "iga_nonlinear,iga_reduced_3,iga_selective,hex_nonlinear,"                             \
    "shell_selective_3"
static const struct verify_field strip_field = {strips, CONTESTANT_LARGE, OTHERS, {40}};

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

static void add_swing(const struct verify_subject *s)
{
    static const double uvw[POINTS][3] = {
        {1, 0.5, 0.5}, {0.75, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}};
    double time[TIMES], truth[TIMES * POINTS][2], xyz[TIMES * POINTS][3], worst = 0;
    struct verify_trial t = verify_trial_of(s, "cantilever_transient",
                                            "swing by C3D20R: position / L until 0.3 s");

    read_swing(s->sheet->table, time, truth);
    settings_set(&t.settings, "time.step=0.005");
    verify_plates_physics(s->sheet, &t.settings);
    if (!verify_trial_motion(&t, TIMES, time, POINTS, uvw[0], xyz[0]))
        return;
    for (int n = 0; n < TIMES * POINTS; n++)
        worst = verify_row_worse(hypot(xyz[n][0] - truth[n][0], xyz[n][2] - truth[n][1]),
                                 worst);
    verify_row_judge_error(t.row, worst,
                           truth_table_note(s->sheet->table, "mesh_error_m") +
                               truth_table_note(s->sheet->table, "step_error_m"));
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
#define THEIR_LIKE                                                                         \
    "iga_linear_3,iga_reduced_linear_3,iga_selective_linear,iga_selective_linear_3,"       \
    "hex_linear,shell_linear,mass_spring,position_based,projective_dynamics"
static const struct verify_field plate_field = {
    plates, CONTESTANT_SMALL, THEIR_LIKE, {35}, {19}};

/* Largest rms difference at one of the times, of the rms of the field; *bar: its error. */
static double plate_error(const struct freefem_field *f, const double (*xyz)[3],
                          double *bar)
{
    double worst = -1;

    for (int t = 0; t < f->times; t++) {
        const double moved = verify_plates_moved(f, t);
        const double error =
            sqrt(verify_plates_apart(f, t, xyz + t * VERIFY_PLATES_POINTS, 1) / moved);
        if (verify_row_worse(error, worst) != worst)
            *bar = f->error[t] / sqrt(moved / VERIFY_PLATES_POINTS);
        worst = verify_row_worse(error, worst);
    }
    return worst;
}

static void add_plate(const struct verify_subject *s, const struct freefem_field *f)
{
    double uvw[VERIFY_PLATES_POINTS][3], bar = NAN;
    double(*xyz)[3] = calloc((size_t)f->times * VERIFY_PLATES_POINTS, sizeof *xyz);
    struct verify_trial t = verify_trial_of(s, "cantilever_transient",
                                            "let go, field by FreeFEM to 0.4 s, h/L = %g",
                                            truth_table_note(s->sheet->table, "thickness"));

    verify_plates_points(uvw);
    settings_set(&t.settings, "time.step=0.00125");
    verify_plates_physics(s->sheet, &t.settings);
    if (verify_sheet_holds(s->sheet, xyz ? STATUS_OK : STATUS_MEMORY) &&
        verify_trial_motion(&t, f->times, f->time, VERIFY_PLATES_POINTS, uvw[0], xyz[0])) {
        double error = plate_error(f, xyz, &bar);
        verify_row_judge_error(t.row, error, bar);
    }
    free(xyz);
}

static void run_plates(struct verify_sheet *sheet, const char *name)
{
    struct verify_subject s;
    struct freefem_field *f = malloc(sizeof *f);

    if (verify_sheet_holds(sheet, f ? STATUS_OK : STATUS_MEMORY) &&
        verify_plates_read(sheet, name, f))
        for (int n = 0; verify_sheet_next(sheet, &plate_field, &n, &s);)
            add_plate(&s, f);
    free(f);
}

static void run(struct verify_sheet *sheet)
{
    struct verify_subject s;

    if (verify_sheet_table(sheet, "calculix_matrices_box"))
        for (int n = 0; verify_sheet_next(sheet, &block_field, &n, &s);)
            add_block(&s);
    if (verify_sheet_table(sheet, "calculix_tips"))
        for (int n = 0; (n = reference_find(sheet->table, n, "element", "C3D8I")) >= 0; n++)
            for (int k = 0; verify_sheet_next(sheet, &twin_field, &k, &s);)
                add_tip(&s, n);
    if (verify_sheet_table(sheet, "calculix_swing_h5mm"))
        for (int n = 0; verify_sheet_next(sheet, &strip_field, &n, &s);)
            add_swing(&s);
    run_plates(sheet, "freefem_transient_h10mm");
    if (!sheet->quick)
        run_plates(sheet, "freefem_transient_h1mm");
}

const struct verify_check verify_outside = {
    .item = {"outside", "matrices, tips and motions that CalculiX and FreeFEM computed"},
    .source = "CalculiX 2.20, tests/reference/calculix_*.csv, 14 digits of matrices, 7 of "
              "tips, round-off by the condition of K, and the swing's own refinement; "
              "FreeFEM, tests/reference/freefem_transient_*.csv, bars in the rows",
    .run = run,
};
