/* The second stage of table1.h: tables from result files. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/paper.h"
#include "bench/tables/table1_data.h"

static void name_cells(struct table *t, const struct table1_cell *c, int variant)
{
    struct table1_variant v = table1_variant(variant);

    table_text(t, "%s%s", v.model, v.incompatible ? " incompatible" : "");
    table_text(t, variant == TABLE1_SHELL ? "%dx%d" : "%dx%dx2", v.side, v.side);
    table_integer(t, lround(c->unknowns));
}

static void time_cells(struct table *t, const struct table1_cell *c,
                       const struct table1_cell *baseline)
{
    if (!c->step.count || !baseline->step.count) {
        for (int n = 0; n < 5; n++)
            table_dash(t);
        return;
    }
    table_number(t, 1e3 * c->create.median, 3);
    table_number(t, 1e3 * c->step.median, 3);
    table_number(t, 1e3 * c->step.min, 3);
    table_text(t, "%.3g-%.3g", 1e3 * c->step.lower, 1e3 * c->step.upper);
    table_number(t, c->step.median / baseline->step.median, 3);
}

static void rmse_cells(struct table *t, const struct table1_cell *c, bool baseline)
{
    for (int n = 0; n < TABLE1_TIMES; n++)
        if (baseline || isnan(c->rmse[n]))
            table_dash(t);
        else
            table_fixed(t, c->rmse[n], 4);
    table_text(t, "%s", baseline ? "baseline" : table1_data_within(c) ? "yes" : "no");
}

/* The first density that meets it at one time. */
static int first_at(const struct table1_cell *cells, bool incompatible, int time)
{
    for (int n = 0; n < TABLE1_DENSITIES; n++) {
        int variant = 1 + n + (incompatible ? TABLE1_DENSITIES : 0);
        if (cells[variant].rmse[time] <= PAPER_TABLE1_RMSE)
            return table1_density[n];
    }
    return 0;
}

static void note_first(struct table *t, const struct table1_cell *cells, bool incompatible)
{
    int variant = table1_data_first(cells, incompatible);
    const char *what =
        incompatible ? "Hexahedra with incompatible modes" : "Plain hexahedra";
    char at[128] = "";

    for (int n = 0; n < TABLE1_TIMES; n++) {
        int side = first_at(cells, incompatible, n);
        size_t used = strlen(at);
        used += (size_t)snprintf(at + used, sizeof at - used, n ? ", " : "");
        if (side)
            snprintf(at + used, sizeof at - used, "%d at %.1f s", side, table1_time[n]);
        else
            snprintf(at + used, sizeof at - used, "none at %.1f s", table1_time[n]);
    }
    if (variant < 0)
        table_note(t,
                   "%s: no density here keeps the RMSE within %.2f m at all four times "
                   "(first density that does: %s).",
                   what, PAPER_TABLE1_RMSE, at);
    else
        table_note(
            t,
            "%s: %dx%dx2 is the first to keep the RMSE within %.2f m at all four "
            "times (first density that does: %s), at %.3g times the cost of IGA; the "
            "paper has 32x32x2 and %.0f.",
            what, table1_variant(variant).side, table1_variant(variant).side,
            PAPER_TABLE1_RMSE, at, cells[variant].step.median / cells[0].step.median,
            paper_table1[1].seconds / paper_table1[0].seconds);
}

/* Refinement towards the truth leads away from a baseline that misses it. */
static void note_away(struct table *t, const struct table1_cell *cells)
{
    const struct table1_cell *coarse = &cells[1 + TABLE1_DENSITIES];
    const struct table1_cell *fine = &cells[TABLE1_SHELL - 1];
    double from = coarse->rmse[TABLE1_TIMES - 1], to = fine->rmse[TABLE1_TIMES - 1];

    if (to > from)
        table_note(t,
                   "Refining the hexahedra with incompatible modes leads away from the "
                   "baseline (%.3f to %.3f m at %.1f s): what they converge to is not the "
                   "IGA result.",
                   from, to, table1_time[TABLE1_TIMES - 1]);
}

static void paper_rows(struct table *t)
{
    table_rule(t);
    for (int n = 0; n < PAPER_TABLE1_ROWS; n++) {
        const struct paper_table1_row *p = &paper_table1[n];
        table_row(t);
        table_text(t, "paper: %s", p->method);
        if (p->points[2])
            table_text(t, "%dx%dx%d", p->points[0], p->points[1], p->points[2]);
        else
            table_text(t, "%dx%d", p->points[0], p->points[1]);
        table_dash(t);
        table_dash(t);
        table_number(t, 1e3 * p->seconds, p->seconds > 1 ? 5 : 3);
        table_dash(t);
        table_dash(t);
        table_number(t, p->seconds / paper_table1[0].seconds, 3);
        for (int time = 0; time < TABLE1_TIMES; time++)
            table_dash(t);
        table_text(t, n == 0 ? "baseline" : n == 1 ? "yes" : "");
    }
}

static enum status print_part(const struct table1_data *d, enum table1_part part,
                              enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {{"model", NULL, TABLE_LEFT},
                                                  {"net", NULL, TABLE_LEFT},
                                                  {"unknowns", NULL, 0},
                                                  {"set-up", "ms", 0},
                                                  {"median", "ms", 0},
                                                  {"min", "ms", 0},
                                                  {"quartiles", "ms", 0},
                                                  {"cost/IGA", NULL, 0},
                                                  {"RMSE 0.1 s", "m", 0},
                                                  {"0.2 s", "m", 0},
                                                  {"0.3 s", "m", 0},
                                                  {"0.4 s", "m", 0},
                                                  {"<= 0.04", NULL, TABLE_LEFT}};
    static const char *const caption[] = {"Table 1, printed kinematics, mu = 0.5: a frame "
                                          "rebuilt each step, RMSE against IGA",
                                          "Table 1, incremental kinematics, undamped: a "
                                          "frame rebuilt each step, RMSE against IGA",
                                          "Table 1, linear kinematics, undamped: a step "
                                          "with one factorisation, RMSE against IGA"};
    const struct table1_cell *cells = d->cell[part];
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns, caption[part]);
    enum status st;

    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        if (n == 1 || n == 1 + TABLE1_DENSITIES || n == TABLE1_SHELL)
            table_rule(t);
        table_row(t);
        name_cells(t, &cells[n], n);
        time_cells(t, &cells[n], &cells[0]);
        rmse_cells(t, &cells[n], n == 0);
        if (cells[n].frames < TABLE1_TIMES)
            table_note(t, "%s %d: %s.", table1_variant(n).model, table1_variant(n).side,
                       cells[n].outcome);
    }
    if (part == TABLE1_PRINTED) {
        table_rule(t);
        paper_rows(t);
    }
    table_note(t,
               "Milliseconds a frame: mean over the frames of a repeat, then median, least "
               "and quartiles of %d repeats, all cases in turn.%s",
               cells[0].step.count,
               part == TABLE1_LINEAR ? ""
                                     : " The shell moves by its own nonlinear scheme, "
                                       "undamped.");
    note_first(t, cells, false);
    note_first(t, cells, true);
    note_away(t, cells);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static enum status print_truth(const struct table1_data *d, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {{"model", NULL, TABLE_LEFT},
                                                  {"net", NULL, TABLE_LEFT},
                                                  {"unknowns", NULL, 0},
                                                  {"static tip", "Kirchhoff", 0},
                                                  {"static RMSE", "%", 0},
                                                  {"RMSE 0.1 s", "%", 0},
                                                  {"0.2 s", "%", 0},
                                                  {"0.3 s", "%", 0},
                                                  {"0.4 s", "%", 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "The same spaces against truth, linear kinematics: "
                                   "Kirchhoff plate, static and in motion");
    enum status st;

    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        const struct table1_cell *rest = &d->cell[TABLE1_STATIC][n],
                                 *move = &d->cell[TABLE1_LINEAR][n];
        if (n == 1 || n == 1 + TABLE1_DENSITIES || n == TABLE1_SHELL)
            table_rule(t);
        table_row(t);
        name_cells(t, rest, n);
        table_number(t, truth_plate_tip(&d->truth, rest->xyz[0]), 3);
        table_number(t, 100 * truth_plate_error(&d->truth, TABLE1_TIMES, rest->xyz[0]), 3);
        for (int time = 0; time < TABLE1_TIMES; time++)
            if (time < move->frames)
                table_number(t, 100 * truth_plate_error(&d->truth, time, move->xyz[time]),
                             3);
            else
                table_dash(t);
    }
    table_note(t,
               "RMSE over the material grid, in per cent of the rms displacement of the "
               "truth. Error bar of the truth: %.0e in motion, %.0e static; Kirchhoff's "
               "theory itself leaves out shear, of order (h/L)^2 = %.0e.",
               KIRCHHOFF_TRANSIENT_ERROR, KIRCHHOFF_ERROR,
               d->truth.thickness_ratio * d->truth.thickness_ratio);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

enum status table1_print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct table1_data *d = NULL;
    enum status st;

    TRY(table1_data_load(folder, &d, why));
    for (int part = 0; part < TABLE1_STATIC; part++) {
        TRY(print_part(d, part, format, file));
        fprintf(file, "\n");
    }
    TRY(print_truth(d, format, file));
    if (format == TABLE_TEXT) {
        fprintf(file, "\n");
        table1_text(d, folder, file);
    }
out:
    table1_data_clear(d);
    return st;
}
