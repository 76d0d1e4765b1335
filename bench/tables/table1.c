/* Table 1: from results to numbers, and its tables. */
#include "bench/tables/table1.h"

#include <math.h>
#include <string.h>

#include "bench/experiment/measurement.h"
#include "bench/experiment/study.h"
#include "bench/truth/paper.h"
#include "bench/truth/truth_plate.h"
#include "models/metric/metric.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* --- numbers ----------------------------------------------------------------------------
 */

static struct table1_variant variant_of(const struct study *part, int n)
{
    const struct study_row *row = &part->row[n];
    const struct run_result *r = &row->result;
    const struct contestant *c = row->run.contestant;
    struct table1_variant v = {.model = c->model->name,
                               .cured =
                                   row->run.discretization.remedy == REMEDY_INCOMPATIBLE,
                               .side = row->run.discretization.points[0],
                               .layers = c->layers,
                               .unknowns = r->unknowns,
                               .create = r->create,
                               .step = r->step,
                               .trouble = r->outcome ? r->sentence.text : NULL};

    for (int time = 0; time < TABLE1_TIMES; time++) {
        const double *base = part->row[0].frame[time].xyz, *xyz = row->frame[time].xyz;
        v.rmse[time] = n && base && xyz ? metric_rmse(xyz, base) : NAN;
    }
    return v;
}

static void hold_against(const struct truth_plate *truth, const struct study_results *r,
                         int n, struct table1 *t)
{
    const double *rest = r->study[TABLE1_STATIC].row[n].frame[0].xyz;

    for (int time = 0; time < TABLE1_TIMES; time++) {
        const double *xyz = r->study[TABLE1_LINEAR].row[n].frame[time].xyz;
        t->error[n][time] = xyz ? truth_plate_error(truth, time, xyz) : NAN;
    }
    t->error[n][TABLE1_REST] = rest ? truth_plate_error(truth, TABLE1_TIMES, rest) : NAN;
    t->tip[n] = rest ? truth_plate_tip(truth, rest) : NAN;
}

enum status table1_read(const struct study_results *r, struct table1 *t,
                        struct message *why)
{
    const struct study *linear = &r->study[TABLE1_LINEAR];
    struct truth_plate truth = {0};
    enum status st;

    TRY(truth_plate_init(&truth, &linear->row[0].run.scene, linear->frames, linear->time,
                         why));
    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++)
            t->variant[part][n] = variant_of(&r->study[part], n);
    for (int n = 0; n < TABLE1_VARIANTS; n++)
        hold_against(&truth, r, n, t);
    memcpy(t->time, linear->time, sizeof t->time);
    t->gamma = truth.gamma;
    t->thickness_ratio = truth.thickness_ratio;
out:
    truth_plate_clear(&truth);
    return st;
}

/* --- tables -----------------------------------------------------------------------------
 */

/* Begins the row of a variant: what it is. */
static void name_cells(struct table *t, const struct table1_variant *v, int n)
{
    if (n == TABLE1_HEX || n == TABLE1_CURED || n == TABLE1_SHELL)
        table_rule(t);
    table_row(t);
    table_text(t, "%s%s", v->model, v->cured ? " incompatible" : "");
    table_text(t, v->layers ? "%dx%dx%d" : "%dx%d", v->side, v->side, v->layers);
    if (v->trouble)
        table_note(t, "%s%s %d: %s.", v->model, v->cured ? " incompatible" : "", v->side,
                   v->trouble);
}

static void dashes(struct table *t, int count)
{
    while (count--)
        table_dash(t);
}

/* How the milliseconds were measured. */
static void time_cells(struct table *t, const struct table1_variant *v)
{
    if (!v->step.count) {
        dashes(t, 6);
        return;
    }
    table_number(t, 1e3 * v->create.median, 3);
    table_number(t, 1e3 * v->step.min, 3);
    table_text(t, "%.3g-%.3g", 1e3 * v->step.lower, 1e3 * v->step.upper);
    table_number(t, 1e3 * v->step.lower, 3);
    table_number(t, 1e3 * v->step.upper, 3);
    table_integer(t, v->step.count);
}

static void paper_rows(struct table *t)
{
    table_rule(t);
    for (int n = 0; n < PAPER_TABLE1_ROWS; n++) {
        const struct paper_table1_row *p = &paper_table1[n];
        table_row(t);
        table_text(t, "paper: %s", p->method);
        table_text(t, p->points[2] ? "%dx%dx%d" : "%dx%d", p->points[0], p->points[1],
                   p->points[2]);
        table_number(t, 1e3 * p->seconds, p->seconds > 1 ? 5 : 3);
        table_number(t, p->seconds / paper_table1[0].seconds, 3);
        dashes(t, TABLE1_TIMES);
        table_text(t, "%s", n == 0 ? "baseline" : n == 1 ? "yes" : "");
        dashes(t, 7);
    }
}

static enum status print_part(const struct table1 *d, enum table1_part which,
                              enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"median", "ms"},
        {"cost/IGA", .key = "cost_over_iga"},
        {"RMSE 0.1 s", "m"},
        {"0.2 s", "m", .key = "rmse_0_2_s_m"},
        {"0.3 s", "m", .key = "rmse_0_3_s_m"},
        {"0.4 s", "m", .key = "rmse_0_4_s_m"},
        {"<= 0.04", NULL, TABLE_LEFT, .key = "within_0_04_m"},
        {"unknowns"},
        {"set-up", "ms"},
        {"min", "ms"},
        {"quartiles", "ms", .readers = TABLE_PEOPLE},
        {"lower quartile", "ms", .readers = TABLE_MACHINES},
        {"upper quartile", "ms", .readers = TABLE_MACHINES},
        {"repeats"}};
    static const char *const caption[] = {"Table 1, printed kinematics, mu = 0.5: a frame "
                                          "rebuilt each step, RMSE against IGA",
                                          "Table 1, incremental kinematics, undamped: a "
                                          "frame rebuilt each step, RMSE against IGA",
                                          "Table 1, linear kinematics, undamped: a step "
                                          "with one factorisation, RMSE against IGA"};
    struct table *t = table_create(COUNT(columns), columns, caption[which]);

    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        const struct table1_variant *v = &d->variant[which][n];
        name_cells(t, v, n);
        table_number(t, v->step.count ? 1e3 * v->step.median : NAN, 3);
        table_number(t, v->step.count ? table1_cost(d, which, n) : NAN, 3);
        for (int time = 0; time < TABLE1_TIMES; time++)
            table_fixed(t, v->rmse[time], 4);
        table_text(t, "%s",
                   !n                                       ? "baseline"
                   : table1_within(d, which, n, TABLE1_ALL) ? "yes"
                                                            : "no");
        table_integer(t, lround(v->unknowns));
        time_cells(t, v);
    }
    if (which == TABLE1_PRINTED)
        paper_rows(t);
    table_note(t,
               "Milliseconds a frame: mean over the frames of a repeat, then median, least "
               "and quartiles of the repeats, all cases in turn.%s",
               which == TABLE1_LINEAR
                   ? ""
                   : " The shell moves by its own nonlinear scheme, undamped.");
    table1_notes(d, which, t);
    return table_finish(t, format, file);
}

static enum status print_truth(const struct table1 *d, enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"unknowns"},
        {"static tip", "Kirchhoff", .key = "static_tip_over_kirchhoff"},
        {"static RMSE", "%"},
        {"RMSE 0.1 s", "%"},
        {"0.2 s", "%", .key = "rmse_0_2_s_percent"},
        {"0.3 s", "%", .key = "rmse_0_3_s_percent"},
        {"0.4 s", "%", .key = "rmse_0_4_s_percent"}};
    struct table *t = table_create(COUNT(columns), columns,
                                   "The same spaces against truth, linear kinematics: "
                                   "Kirchhoff plate, static and in motion");

    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        name_cells(t, &d->variant[TABLE1_STATIC][n], n);
        table_integer(t, lround(d->variant[TABLE1_STATIC][n].unknowns));
        table_number(t, d->tip[n], 3);
        table_number(t, 100 * d->error[n][TABLE1_REST], 3);
        for (int time = 0; time < TABLE1_TIMES; time++)
            table_number(t, 100 * d->error[n][time], 3);
    }
    table_note(t,
               "RMSE over the material grid, in per cent of the rms displacement of the "
               "truth. Error bar of the truth: %.0e in motion, %.0e static; Kirchhoff's "
               "theory itself leaves out shear, of order (h/L)^2 = %.0e.",
               KIRCHHOFF_TRANSIENT_ERROR, KIRCHHOFF_ERROR,
               d->thickness_ratio * d->thickness_ratio);
    return table_finish(t, format, file);
}

enum status table1_print(const struct table1 *t, enum table_format format, FILE *file)
{
    const bool prose = table_format_is_prose(format);
    enum status st = STATUS_OK;

    if (prose)
        table1_headline(t, file);
    for (int part = 0; part < TABLE1_STATIC; part++)
        TRY(print_part(t, part, format, file));
    TRY(print_truth(t, format, file));
    if (prose)
        table1_text(t, file);
out:
    return st;
}

static enum status print(const struct study_results *r, const char *folder,
                         enum table_format format, FILE *file, struct message *why)
{
    struct table1 t;
    enum status st;

    (void)folder;
    TRY(table1_read(r, &t, why));
    TRY(table1_print(&t, format, file));
    if (table_format_is_prose(format))
        measurement_machine(r->machine, file);
out:
    return st;
}

const struct experiment table1_exhibit = {
    .item = {"1", "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at "
                  "equal looks and against truth"},
    .plan = "table1",
    .tell = print,
};
