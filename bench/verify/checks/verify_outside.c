#include <math.h>
#include <stdlib.h>

#include "bench/verify/checks/verify_plates.h"

/* --- Tips. */

/* This is the same element on the same nodes; the file has 7 digits. */
static const struct verify_subject twin[] = {
    {"hex_incompatible_linear", 1e-6, "the same element", {33}}, {NULL}};
static const struct verify_field twin_field = {.subject = twin};

static void add_tip(struct verify_subject *s)
{
    const double uvw[2][3] = {{1, 0.5, 0.5}, {1, 1, 0.5}};
    const char *const column[] = {"middle", "corner"};
    const double h = verify_number(s, "thickness");
    /* CalculiX solves for nodes of both faces, where K has the condition 2.5e12 at h/L =
     * 1e-3, growing as h^-4 */
    const double rounding = 1e-16 * 2.5e12 * pow(h / 1e-3, -4);
    double xyz[2][3];
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "tip [m] by C3D8I, h/L = %g, %s", h, column[0]);

    settings_number(&t.settings, "sheet.thickness", h);
    verify_plates_physics(s->sheet, &t.settings);
    verify_trial_equilibrium(&t, 2, uvw[0], xyz[0]);
    for (int k = 0; k < 2 && t.lived; k++) {
        if (k == 1)
            t.row = verify_sheet_add(s, "tip [m] by C3D8I, h/L = %g, %s", h, column[1]);
        verify_row_judge(t.row, -xyz[k][2], verify_number(s, column[k]), rounding);
    }
}

/* --- A large swing. */

#define SWING 1e-3, "asked" /* claim for nonlinear solids */
static const struct verify_subject strips[] = {
    {"iga_nonlinear_3", SWING, {19}, {4}, 0, "r = 2", {"discretization.degree=[3,3,2]"}, 3},
    {"iga_selective", SWING, {66}, {3}},
    {"hex_incompatible", SWING, {129}, {2}},
    {"shell_3", 1e-3, "as of solids", {35}, {4}},
    {"triangles", SWING, {80}, {3}},
    {"mass_spring", 0, "implicit Euler damps", {40}, {3}},
    {"position_based", 0, "damps as implicit Euler, in small steps", {40}, {3}},
    {"projective_dynamics", 0, "implicit Euler damps", {40}, {3}},
    {NULL}};
#define OTHERS "iga_nonlinear,hex_nonlinear,shell_selective_3"
static const struct verify_field strip_field = {strips, CONTESTANT_LARGE, OTHERS, {40}};

enum { TIMES = 6, POINTS = 4 };

/* Judges the positions at every 0.05 s of the table's 0.01 s. */
static void add_swing(struct verify_subject *s)
{
    static const double uvw[POINTS][3] = {
        {1, 0.5, 0.5}, {0.75, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}};
    static const char *const column[POINTS][2] = {
        {"x1.00", "z1.00"}, {"x0.75", "z0.75"}, {"x0.50", "z0.50"}, {"x0.25", "z0.25"}};
    double time[TIMES], xyz[TIMES][POINTS][3], worst = 0;
    struct verify_trial t = verify_trial_of(s, "cantilever_transient",
                                            "swing by C3D20R: position / L until 0.3 s");

    for (s->at = 4; s->at < 5 * TIMES; s->at += 5)
        time[s->at / 5] = verify_number(s, "t");
    settings_set(&t.settings, "time.step=0.005");
    verify_plates_physics(s->sheet, &t.settings);
    if (!verify_trial_motion(&t, TIMES, time, POINTS, uvw[0], xyz[0][0]))
        return;
    for (s->at = 4; s->at < 5 * TIMES; s->at += 5)
        for (int p = 0; p < POINTS; p++) {
            const double *x = xyz[s->at / 5][p];
            worst = verify_row_worse(hypot(x[0] - verify_number(s, column[p][0]),
                                           x[2] - verify_number(s, column[p][1])),
                                     worst);
        }
    verify_row_judge_error(t.row, worst,
                           verify_note(s, "mesh_error_m") + verify_note(s, "step_error_m"));
}

/* --- Denim, at rest and in motion, and outlines; the tables have scene and settings. */

#define REST   5e-3, "half of what is asked of solids, on a net as fine as theirs"
#define MOTION 0.01, "asked of solids"
static const struct verify_subject resting[] = {
    {"shell_selective_3", REST, {30}},
    {"shell_3,iga_selective_3", REST, {30}, .dear = true},
    VERIFY_MESH("irregular", true, "irregular", NULL, REST, {40}),
    {NULL}};
static const struct verify_subject moving[] = {
    {"shell_selective_3,shell_3", MOTION, {30}, .dear = true}, {NULL}};
static const struct verify_subject outlined[] = {
    {"triangles", MOTION, {40}, {40}, 0, "mid-edge", {"discretization.bending=midedge"}},
    {"mass_spring", 0, "implicit Euler damps", {40}, {40}},
    {"vbd", 0, "implicit Euler damps", {40}, {40}},
    {NULL}};
static const struct verify_subject hanging[] = {
    {"triangles", REST, {40}, {40}, 0, "mid-edge", {"discretization.bending=midedge"}},
    {NULL}};
static const struct verify_field rest_field = {resting}, motion_field = {moving},
                                 outline_field = {outlined}, hanging_field = {hanging};

enum { MOST_POINTS = 11 * 11, MOTION_TIMES = 3, DENIM = 3, OUTLINES = 2 };
static const char *const rest_tables[DENIM] = {"calculix_denim_square_rest",
                                               "calculix_denim_edge_drop_rest",
                                               "calculix_denim_flag_rest"};
static const char *const motion_tables[DENIM] = {"calculix_denim_square_motion",
                                                 "calculix_denim_edge_drop_motion",
                                                 "calculix_denim_flag_motion"};
static const char *const outline_tables[OUTLINES] = {"calculix_trapezoid_motion",
                                                     "calculix_hole_motion"};
static const char *const hanging_tables[OUTLINES] = {"calculix_trapezoid_rest",
                                                     "calculix_hole_rest"};

/* Returns how many points a table has: the rows of its first time. */
static int points_of(const struct reference *table)
{
    int n = 1;

    while (n < MOST_POINTS && n < reference_rows(table) &&
           reference_number(table, n, "t") == reference_number(table, 0, "t"))
        n++;
    return n;
}

/* Opens a table; computes its points, one block of rows for each time. Returns a trial that
 * did not live if it cannot be read. */
static struct verify_trial open_field(struct verify_subject *s, const char *table,
                                      double uvw[MOST_POINTS][3])
{
    struct verify_sheet *sheet = s->sheet;
    struct verify_trial none = {0};

    if (!verify_sheet_table(sheet, table))
        return none;
    for (int n = 0; n < points_of(sheet->table); n++) {
        uvw[n][0] = reference_number(sheet->table, n, "u");
        uvw[n][1] = reference_number(sheet->table, n, "v");
        uvw[n][2] = 0.5;
    }
    const char *scene = reference_note(sheet->table, "scene");
    const char *set = reference_note(sheet->table, "set");
    if (!scene || !set) {
        verify_sheet_holds(sheet, status_fail(&sheet->why, STATUS_INPUT,
                                              "%s: has no notes `scene` and `set`", table));
        return none;
    }
    struct verify_trial t = verify_trial_of(s, scene, "%s: rms distance / L", table);
    verify_trial_set(&t, "%s", set);
    return t;
}

/* Judges the rms distance over the length at one of the table's times, if it is the worst.
 */
static void judge_field(struct verify_trial *t, int time, double length, const double *xyz)
{
    const struct reference *table = t->subject->sheet->table;
    const int points = points_of(table), first = time * points;
    double square = 0;

    for (int n = 0; n < points; n++, xyz += 3)
        square += pow(xyz[0] - reference_number(table, first + n, "x"), 2) +
                  pow(xyz[1] - reference_number(table, first + n, "y"), 2) +
                  pow(xyz[2] - reference_number(table, first + n, "z"), 2);
    const double error = sqrt(square / points) / length;
    if (time == 0 || verify_row_worse(error, t->row->error) != t->row->error)
        verify_row_judge_error(t->row, error, reference_number(table, first, "bar"));
}

static void judge_rest(struct verify_subject *s, const char *table)
{
    double uvw[MOST_POINTS][3], xyz[MOST_POINTS][3];
    struct verify_trial t = open_field(s, table, uvw);

    if (t.row && verify_trial_equilibrium(&t, points_of(s->sheet->table), uvw[0], xyz[0]))
        judge_field(&t, 0, verify_note(s, "length"), xyz[0]);
}

static void add_resting(struct verify_subject *s)
{
    judge_rest(s, rest_tables[s->at]);
}

static void add_hanging(struct verify_subject *s)
{
    judge_rest(s, hanging_tables[s->at]);
}

static void judge_motion(struct verify_subject *s, const char *table)
{
    double time[MOTION_TIMES], uvw[MOST_POINTS][3], xyz[MOTION_TIMES * MOST_POINTS][3];
    struct verify_trial t = open_field(s, table, uvw);

    if (!t.row)
        return;
    const int points = points_of(s->sheet->table);
    for (int n = 0; n < MOTION_TIMES; n++)
        time[n] = reference_number(s->sheet->table, n * points, "t");
    settings_set(&t.settings, "time.step=0.001");
    if (!verify_trial_motion(&t, MOTION_TIMES, time, points, uvw[0], xyz[0]))
        return;
    for (int n = 0; n < MOTION_TIMES; n++)
        judge_field(&t, n, verify_note(s, "length"), xyz[n * points]);
}

static void add_moving(struct verify_subject *s)
{
    judge_motion(s, motion_tables[s->at]);
}

static void add_outline(struct verify_subject *s)
{
    judge_motion(s, outline_tables[s->at]);
}

/* --- Plates let go, on the finest nets of `transient`; a thin shell is to be as good as a
 * solid. */
#define PLATE 0.01, NULL

static const struct verify_subject plates[] = {
    {"iga_linear", 0, "the paper's: locks", {10}},
    {"iga_selective_linear", PLATE, {34}, {18}},
    {"iga_linear_32", PLATE, {35}, {19}},
    {"hex_incompatible_linear", PLATE, {65}, {33}},
    {"shell_linear_3", PLATE, {19}, {11}},
    {NULL},
};
#define THEIR_LIKE                                                                         \
    "iga_linear_3,iga_selective_linear_3,"                                                 \
    "hex_linear,shell_linear,mass_spring,position_based,projective_dynamics"
static const struct verify_field plate_field = {
    plates, CONTESTANT_SMALL, THEIR_LIKE, {35}, {19}};

/* Judges the largest rms difference at one of the times, over the rms of the field. */
static void add_plate(struct verify_subject *s)
{
    static const char *const names[] = {"freefem_transient_h10mm",
                                        "freefem_transient_h1mm"};
    struct freefem_field f;
    double xyz[FREEFEM_TIMES][VERIFY_PLATES_POINTS][3];

    if (!verify_plates_read(s->sheet, names[s->at], &f))
        return;
    struct verify_trial t = verify_trial_of(s, "cantilever_transient",
                                            "let go, field by FreeFEM to 0.4 s, h/L = %g",
                                            verify_note(s, "thickness"));
    settings_set(&t.settings, "time.step=0.00125");
    verify_plates_physics(s->sheet, &t.settings);
    if (!verify_trial_motion(&t, f.times, f.time, VERIFY_PLATES_POINTS,
                             verify_plates_points(), xyz[0][0]))
        return;
    for (int n = 0; n < f.times; n++) {
        double bar, error = verify_plates_error(&f, n, xyz[n], 1, &bar);
        if (n == 0 || verify_row_worse(error, t.row->error) != t.row->error)
            verify_row_judge_error(t.row, error, bar);
    }
}

const struct verify_check verify_outside = {
    {"outside", "tips and motions that CalculiX and FreeFEM computed"},
    "CalculiX 2.20, tests/reference/calculix_*.csv, 7 digits of tips, round-off by the "
    "condition of K, and the swing's own refinement; FreeFEM, "
    "tests/reference/freefem_transient_*.csv, bars in the rows",
    .parts = {{&twin_field, add_tip, 0, "element", "C3D8I", .table = "calculix_tips"},
              {&strip_field, add_swing, 1, .table = "calculix_swing_h5mm"},
              {&rest_field, add_resting, DENIM, .every = DENIM},
              {&motion_field, add_moving, DENIM, .every = DENIM},
              {&outline_field, add_outline, OUTLINES, .every = OUTLINES},
              {&hanging_field, add_hanging, OUTLINES, .every = OUTLINES},
              {&plate_field, add_plate, 2, .every = 2}}};
