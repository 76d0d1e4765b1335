/* Frames over whole motions: the models that iterate, against aims; every contestant. */
#include <math.h>
#include <stdlib.h>

#include "bench/files/store_read.h"
#include "bench/speed/bench_nets.h"

#define LEN(array) (sizeof array / sizeof *array)

struct motion_case {
    struct bench_run run;
    double aim; /* [ms] a frame; of a swing [s]                                         */
};

#define MATCHED "discretization.parameters=matched"

/* clang-format off */
static const struct motion_case frames[] = {
    {{"shell 10x10, p = 2", "shell_2", {UNDAMPED}, 0.4}, 1},
    {{"shell 10x10, p = 3", "shell_3", {UNDAMPED}, 0.4}, 2},
    {{"mass-spring 32x32, to its tolerance", "mass_spring_paper",
      {UNDAMPED, MATCHED, "discretization.points=[32,32]"}, 0.4}, 2},
    {{"mass-spring 32x32, one iteration", "mass_spring_paper",
      {UNDAMPED, MATCHED, "discretization.points=[32,32]", "discretization.iterations=1"},
      0.4}, 2},
    {{"iga 10x10x2, none (the paper's)", "iga_nonlinear", {UNDAMPED}, 0.4}, 5},
    {{"iga 10x10x2, reduced", "iga_reduced", {UNDAMPED}, 0.4}, 5},
    {{"iga 10x10x2, selective", "iga_selective", {UNDAMPED}, 0.4}, 5},
};

/* The first is the baseline. */
static const struct motion_case swings[] = {
    {{"iga 20x20x2, p = 3, none", "iga_nonlinear_3",
      {UNDAMPED, "discretization.points=[20,20,2]"}, 1}, 60},
    {{"iga 20x20x2, p = 3, selective", "iga_selective_3",
      {UNDAMPED, "discretization.points=[20,20,2]"}, 1}, 60},
};
/* clang-format on */

static enum status plan_frames(struct bench *b, struct message *why)
{
    enum status st = STATUS_OK;

    for (size_t n = 0; n < LEN(frames) && st == STATUS_OK; n++)
        st = bench_part_add(b, &frames[n].run, why);
    return st;
}

/* Of all frames of all repeats. */
static enum status read_frames(const char *path, struct clock_summary *s,
                               struct message *why)
{
    struct store_read *file = NULL;
    double *seconds = NULL;
    int rows, columns;
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_read_array(file, "seconds/advance", &seconds, &rows, &columns, why));
    *s = clock_summarise(seconds, rows * columns);
out:
    free(seconds);
    store_read_close(file);
    return st;
}

static enum status print_frames(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"case", NULL, TABLE_LEFT},
                                                  {"median", "ms"},
                                                  {"min", "ms"},
                                                  {"lower", "ms"},
                                                  {"upper", "ms"},
                                                  {"mean", "ms"},
                                                  {"repeats"},
                                                  {"aim", "ms"},
                                                  {"reached by", NULL, TABLE_LEFT}};
    struct table *t = table_create(LEN(columns), columns,
                                   "Frames of the models that iterate, edge_drop to 0.4 s, "
                                   "undamped");
    enum status st = STATUS_OK;

    for (int n = 0; n < b->batch.count; n++) {
        const double aim = frames[n].aim;
        struct clock_summary all;
        struct run_result r;
        TRY(batch_read(&b->batch, n, false, &r, why));
        TRY(read_frames(b->batch.files[n], &all, why));
        table_row(t);
        table_text(t, "%s", frames[n].run.title);
        table_number(t, 1e3 * all.median, 3);
        table_number(t, 1e3 * all.min, 3);
        table_number(t, 1e3 * all.lower, 3);
        table_number(t, 1e3 * all.upper, 3);
        table_number(t, 1e3 * r.step.median, 3);
        table_integer(t, r.step.count);
        table_number(t, aim, 2);
        table_text(t, "%s",
                   1e3 * r.step.median <= aim ? "yes"
                   : 1e3 * all.median <= aim  ? "the median frame"
                   : 1e3 * all.min <= aim     ? "the cheapest frame"
                                              : "no");
        run_result_clear(&r);
    }
    table_note(t,
               "Frames differ: iterations grow where the sheet buckles. Elsewhere, on "
               "another machine: gsKLShell 10x10 118 ms (p = 2) and 484 ms (p = 3) for one "
               "Newton iteration; the paper's shell 130 ms a frame.");
    return table_finish(t, b->format, stdout);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_nonlinear = {
    .item = {"nonlinear", "shell, springs and nonlinear solids over whole motions"},
    .plan = plan_frames,
    .print = print_frames};

static enum status plan_swings(struct bench *b, struct message *why)
{
    enum status st = STATUS_OK;

    for (size_t n = 0; n < LEN(swings) && st == STATUS_OK; n++)
        st = bench_part_add(b, &swings[n].run, why);
    return st;
}

static enum status print_swings(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"case", NULL, TABLE_LEFT},
                                                  {"stepping", "s"},
                                                  {"over the first"},
                                                  {"repeats"},
                                                  {"aim", "s"},
                                                  {"reached", NULL, TABLE_LEFT}};
    struct table *t =
        table_create(LEN(columns), columns, "A swing of 1 s, edge_drop, undamped");
    double first = NAN;
    enum status st = STATUS_OK;

    for (int n = 0; n < b->batch.count; n++) {
        struct run_result r;
        TRY(batch_read(&b->batch, n, false, &r, why));
        const double total = r.step.median * (double)r.steps;
        first = n ? first : total;
        table_row(t);
        table_text(t, "%s", swings[n].run.title);
        table_number(t, total, 3);
        table_number(t, total / first, 3);
        table_integer(t, r.step.count);
        table_number(t, swings[n].aim, 2);
        table_text(t, "%s", total <= swings[n].aim ? "yes" : "no");
        run_result_clear(&r);
    }
    return table_finish(t, b->format, stdout);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_swings = {
    .item = {"swings", "a second of nonlinear solids on 20x20x2 points of degree 3"},
    .plan = plan_swings,
    .print = print_swings};

/* --- contestants -------------------------------------------------------------------------
 */

/* Ten points a side, unless it is never refined so. */
static int usual_side(const struct contestant *c)
{
    for (int n = 0; n < CONTESTANT_STEPS; n++)
        if (c->points[n] == 10)
            return 10;
    return c->points[0];
}

static enum status plan_contestants(struct bench *b, struct message *why)
{
    static const double end[] = {0.2};
    enum status st = contestant_check(b->models, why);

    for (const struct contestant *c = contestant_table; c->name && st == STATUS_OK; c++) {
        if (!contestant_chosen(c, b->models, CONTESTANT_SPEED))
            continue;
        const char *damping = contestant_is_paper_scheme(c) ? NULL : UNDAMPED;
        st =
            bench_part_add(b, &(struct bench_run){c->title, c->name, {damping}, *end}, why);
        if (st != STATUS_OK)
            break;
        contestant_points(c, usual_side(c), usual_side(c), batch_settings(&b->batch));
        b->batch.cases[b->batch.count - 1].keep.times = 1;
        b->batch.cases[b->batch.count - 1].keep.time = end; /* the work up to there */
    }
    return st;
}

static void add_contestant(struct table *t, const struct contestant *c,
                           const struct run_result *r)
{
    const bool ran = !run_result_refused(r);

    table_row(t);
    table_text(t, "%s", c->title);
    table_text(t, "%s", c->name);
    table_text(t, "%s", c->model->name);
    table_text(t, "%dx%d", usual_side(c), usual_side(c));
    table_fixed(t, ran ? r->unknowns : NAN, 0);
    table_number(t, ran ? 1e3 * r->create.median : NAN, 3);
    table_number(t, ran ? 1e3 * r->step.median : NAN, 3);
    table_fixed(t, ran ? r->step.count : NAN, 0);
    table_number(t,
                 ran && r->work.iterations
                     ? (double)r->work.iterations / (double)r->work.steps
                     : NAN,
                 3);
    table_text(t, "%s", r->sentence.text);
    if (r->outcome)
        table_note(t, "%s: %s.", c->title, r->sentence.text);
}

static enum status print_contestants(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT, .readers = TABLE_MACHINES, .key = "model"},
        {"net", NULL, TABLE_LEFT},
        {"unknowns"},
        {"set-up", "ms"},
        {"a frame", "ms"},
        {"repeats"},
        {"iterations", "a frame", .key = "iterations_a_frame"},
        {"outcome", NULL, TABLE_LEFT, .readers = TABLE_MACHINES}};
    struct table *t =
        table_create(LEN(columns), columns,
                     "A frame of each contestant, edge_drop to 0.2 s, one thread");
    enum status st = STATUS_OK;

    for (int n = 0; n < b->batch.count; n++) {
        struct run_result r;
        TRY(batch_read(&b->batch, n, false, &r, why));
        add_contestant(t, b->batch.cases[n].plan.contestant, &r);
        run_result_clear(&r);
    }
    table_note(t, "Medians of the repeats; undamped, but for the paper's own scheme. "
                  "Iterations: Newton's, or local and global steps; "
                  "none: one solve a frame.");
    return table_finish(t, b->format, stdout);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_contestants = {
    .item = {"contestants", "set-up and a frame of each contestant on one scene"},
    .plan = plan_contestants,
    .print = print_contestants};
