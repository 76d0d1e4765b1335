/* The second stage of table1.h: tables and sentences from result files. */
#include "bench/table1.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/paper.h"
#include "bench/store_scene.h"
#include "bench/table1_truth.h"
#include "models/clock.h"
#include "models/metric.h"

/* What the tables need of one result file. */
struct cell {
    int frames; /* fewer than TABLE1_TIMES after a death                               */
    double *xyz[TABLE1_TIMES]; /* owned                                                */
    double rmse[TABLE1_TIMES]; /* against the baseline, NaN if not reached        [m]  */
    double unknowns;
    struct clock_summary create, step; /* [s]; count = 0 for statics                   */
    char *outcome; /* owned                                                */
};

struct table1_data {
    struct cell cell[TABLE1_PARTS][TABLE1_VARIANTS];
    struct table1_truth truth;
};

static void data_clear(struct table1_data *d)
{
    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++) {
            for (int t = 0; t < TABLE1_TIMES; t++)
                free(d->cell[part][n].xyz[t]);
            free(d->cell[part][n].outcome);
        }
    table1_truth_clear(&d->truth);
    free(d);
}

/* Summary of the numbers there are; a death leaves some out. */
static enum status load_seconds(const struct store_read *file, const char *name,
                                struct clock_summary *summary, struct message *why)
{
    enum status st;
    double *seconds = NULL;
    int rows, columns, count = 0;

    if (!store_read_has(file, name))
        return STATUS_OK;
    TRY(store_read_array(file, name, &seconds, &rows, &columns, why));
    for (int n = 0; n < rows * columns; n++)
        if (!isnan(seconds[n]))
            seconds[count++] = seconds[n];
    if (count)
        *summary = clock_summarise(seconds, count);
out:
    free(seconds);
    return st;
}

static enum status load_cell(const char *path, struct cell *c, struct message *why)
{
    struct store_read *file = NULL;
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_read_number(file, "unknowns", &c->unknowns, why));
    TRY(store_read_text(file, "/", "outcome", &c->outcome, why));
    c->frames = store_read_frames(file);
    if (c->frames > TABLE1_TIMES) {
        st = status_fail(why, STATUS_INPUT, "%s: %d frames, but Table 1 keeps %d", path,
                         c->frames, TABLE1_TIMES);
        goto out;
    }
    for (int t = 0; t < c->frames; t++) {
        c->xyz[t] = malloc(3 * GRID_POINTS * sizeof(double));
        if (!c->xyz[t])
            TRY(STATUS_MEMORY);
        TRY(store_read_frame(file, t, c->xyz[t], why));
    }
    TRY(load_seconds(file, "seconds/create", &c->create, why));
    TRY(load_seconds(file, "seconds/advance", &c->step, why));
out:
    store_read_close(file);
    return st;
}

static enum status load(const char *folder, struct table1_data *d, struct message *why)
{
    enum status st = STATUS_OK;
    char path[4096];

    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++) {
            struct cell *c = &d->cell[part][n], *baseline = &d->cell[part][0];
            table1_path(folder, part, n, path, sizeof path);
            TRY(load_cell(path, c, why));
            for (int t = 0; t < TABLE1_TIMES; t++)
                c->rmse[t] = t < c->frames && t < baseline->frames
                                 ? metric_rmse(c->xyz[t], baseline->xyz[t])
                                 : NAN;
        }
out:
    return st;
}

static void name_cells(struct table *t, const struct cell *c, int variant)
{
    struct table1_variant v = table1_variant(variant);

    table_text(t, "%s%s", v.model, v.incompatible ? " incompatible" : "");
    table_text(t, "%dx%dx2", v.side, v.side);
    table_integer(t, lround(c->unknowns));
}

static void time_cells(struct table *t, const struct cell *c, const struct cell *baseline)
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

static bool within(const struct cell *c)
{
    for (int t = 0; t < TABLE1_TIMES; t++)
        if (!(c->rmse[t] <= PAPER_TABLE1_RMSE))
            return false;
    return true;
}

static void rmse_cells(struct table *t, const struct cell *c, bool baseline)
{
    for (int n = 0; n < TABLE1_TIMES; n++)
        if (baseline || isnan(c->rmse[n]))
            table_dash(t);
        else
            table_fixed(t, c->rmse[n], 4);
    table_text(t, "%s", baseline ? "baseline" : within(c) ? "yes" : "no");
}

/* The first density that meets the paper's criterion at all times; -1 if none does. */
static int first_within(const struct cell *cells, bool incompatible)
{
    for (int n = 0; n < TABLE1_DENSITIES; n++) {
        int variant = 1 + n + (incompatible ? TABLE1_DENSITIES : 0);
        if (within(&cells[variant]))
            return variant;
    }
    return -1;
}

/* The first density that meets it at one time. */
static int first_at(const struct cell *cells, bool incompatible, int time)
{
    for (int n = 0; n < TABLE1_DENSITIES; n++) {
        int variant = 1 + n + (incompatible ? TABLE1_DENSITIES : 0);
        if (cells[variant].rmse[time] <= PAPER_TABLE1_RMSE)
            return table1_density[n];
    }
    return 0;
}

static void note_first(struct table *t, const struct cell *cells, bool incompatible)
{
    int variant = first_within(cells, incompatible);
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
static void note_away(struct table *t, const struct cell *cells)
{
    const struct cell *coarse = &cells[1 + TABLE1_DENSITIES];
    const struct cell *fine = &cells[TABLE1_VARIANTS - 1];
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

static void shell_row(struct table *t)
{
    table_row(t);
    table_text(t, "shell");
    table_text(t, "not built yet");
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
    const struct cell *cells = d->cell[part];
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns, caption[part]);
    enum status st;

    for (int n = 0; n < TABLE1_VARIANTS; n++) {
        if (n == 1 || n == 1 + TABLE1_DENSITIES)
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
        shell_row(t);
        paper_rows(t);
    }
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
        const struct cell *rest = &d->cell[TABLE1_STATIC][n],
                          *move = &d->cell[TABLE1_LINEAR][n];
        if (n == 1 || n == 1 + TABLE1_DENSITIES)
            table_rule(t);
        table_row(t);
        name_cells(t, rest, n);
        table_number(t, table1_truth_tip(&d->truth, rest->xyz[0]), 3);
        table_number(t, 100 * table1_truth_error(&d->truth, TABLE1_TIMES, rest->xyz[0]), 3);
        for (int time = 0; time < TABLE1_TIMES; time++)
            if (time < move->frames)
                table_number(t, 100 * table1_truth_error(&d->truth, time, move->xyz[time]),
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

/* Truth for the scene of the linear runs. */
static enum status load_truth(const char *folder, struct table1_truth *truth,
                              struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    char path[4096];
    enum status st;

    table1_path(folder, TABLE1_LINEAR, 0, path, sizeof path);
    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    TRY(table1_truth_init(truth, &scene, why));
out:
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

/* The claim of Table 1 at equal error against truth. */
static void worth(const struct table1_data *d, FILE *file)
{
    const struct cell *printed = d->cell[TABLE1_PRINTED], *rest = d->cell[TABLE1_STATIC];
    const int hex32 = 4, cured = 1 + TABLE1_DENSITIES;
    double iga = table1_truth_error(&d->truth, TABLE1_TIMES, rest[0].xyz[0]);
    double hex = table1_truth_error(&d->truth, TABLE1_TIMES, rest[hex32].xyz[0]);
    double incompatible = table1_truth_error(&d->truth, TABLE1_TIMES, rest[cured].xyz[0]);
    double cost = printed[cured].step.median / printed[0].step.median;

    fprintf(file,
            "- What it is worth. Against truth the static error is %.0f %% for IGA 10x10x2 "
            "(tip %.3f of Kirchhoff's) and\n  %.1f %% for hex 32x32x2 (tip %.4f)%s.\n",
            100 * iga, table1_truth_tip(&d->truth, rest[0].xyz[0]), 100 * hex,
            table1_truth_tip(&d->truth, rest[hex32].xyz[0]),
            iga > 0.1 && hex > 0.1
                ? ": the criterion matches one locked mesh to\n  another. A small RMSE "
                  "between them says that the printed scheme, which has no elastic memory "
                  "(it is\n  a viscosity E dt), hides their stiffness, not that either is "
                  "right"
                : "");
    fprintf(file,
            "- At equal error. The same hexahedra with incompatible modes have %.1f %% at "
            "10x10x2 for %.2g times the cost\n  of IGA's frame. The claim that hexahedra "
            "need many times IGA's cost %s at equal error against truth.\n",
            100 * incompatible, cost,
            incompatible <= iga && cost < 2 ? "does not hold" : "holds");
}

/* What a reader should take away, from the numbers above it. */
static void summary(const struct table1_data *d, FILE *file)
{
    const struct cell *printed = d->cell[TABLE1_PRINTED];
    int first = first_within(printed, false);
    double paper_ratio = paper_table1[1].seconds / paper_table1[0].seconds;
    double growth = log(paper_ratio) / log(32 * 32 / 100.0);

    fprintf(file, "What was reproduced, and what not\n\n");
    fprintf(file,
            "- The criterion. The paper refines hexahedra until their RMSE against IGA "
            "10x10x2 is at most %.2f,\n  and ends at 32x32x2. Here, with its printed "
            "scheme, ",
            PAPER_TABLE1_RMSE);
    if (first < 0)
        fprintf(file,
                "no density up to %d meets that at all four times: at 32x32x2\n  the "
                "RMSE is %.3f, %.3f, %.3f, %.3f m at 0.1 ... 0.4 s. ",
                table1_density[TABLE1_DENSITIES - 1], printed[4].rmse[0],
                printed[4].rmse[1], printed[4].rmse[2], printed[4].rmse[3]);
    else
        fprintf(file, "%dx%dx2 is the first to meet it at all four times.\n  ",
                table1_variant(first).side, table1_variant(first).side);
    fprintf(file, "The paper does not say after how many\n  steps it compares.\n");
    fprintf(file,
            "- The ratio. A rebuilt frame of hex 32x32x2 costs %.1f times one of IGA "
            "10x10x2 here, %.0f times in the\n  paper. 10.24 times the nodes at a "
            "ratio of %.0f is a cost growing as nodes^%.1f; a banded or nested-\n  "
            "dissection factorisation of a sheet grows as nodes^1.5 to nodes^2. The "
            "paper's absolute times\n  (91 ms and 16048 ms a frame) are %.0f and %.0f "
            "times ours, on another machine.\n",
            printed[4].step.median / printed[0].step.median, paper_ratio, paper_ratio,
            growth, paper_table1[0].seconds / printed[0].step.median,
            paper_table1[1].seconds / printed[4].step.median);
    worth(d, file);
    fprintf(file,
            "- Range. Gamma = rho g h L^3 / D is %.0f: small-strain linear theory (the "
            "linear table and its truth) is a test\n  of the spaces, not of the "
            "motion; it is 10 %% off from Gamma = 2.9 on.\n",
            d->truth.gamma);
}

static void machine(const char *folder, FILE *file)
{
    static const char *const keys[] = {
        "commit",      "changed_files", "compiler",    "flags",        "cpu",
        "blas_kernel", "cholmod",       "omp_threads", "blas_threads", "date"};
    struct store_read *run = NULL;
    char path[4096];

    table1_path(folder, TABLE1_PRINTED, 0, path, sizeof path);
    if (store_read_open(path, &run, NULL) != STATUS_OK)
        return;
    fprintf(file, "\nMeasured:");
    for (size_t n = 0; n < sizeof keys / sizeof *keys; n++) {
        char *text = NULL;
        if (store_read_text(run, "provenance", keys[n], &text, NULL) == STATUS_OK)
            fprintf(file, "%s%s %s", n ? "; " : " ", keys[n], text);
        free(text);
    }
    fprintf(file, "\n");
    store_read_close(run);
}

enum status table1_print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct table1_data *d = calloc(1, sizeof *d);
    enum status st = d ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(load(folder, d, why));
    TRY(load_truth(folder, &d->truth, why));
    for (int part = 0; part < TABLE1_STATIC; part++) {
        TRY(print_part(d, part, format, file));
        fprintf(file, "\n");
    }
    TRY(print_truth(d, format, file));
    if (format == TABLE_TEXT) {
        fprintf(file, "\n");
        summary(d, file);
        machine(folder, file);
    }
out:
    if (d)
        data_clear(d);
    return st;
}
