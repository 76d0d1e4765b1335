/* The timing table: every contestant that enters it, on edge_drop. */
#include <math.h>

#include "bench/speed/bench_part.h"

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
        const char *damping = contestant_is_paper_scheme(c) ? NULL : "damping={kind: none}";
        st = bench_part_add(
            b, &(struct bench_row){c->title, c->name, {damping}, *end, 0, {0}, NULL}, why);
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

static enum status print_contestants(const struct bench *b)
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
        table_create(sizeof columns / sizeof *columns, columns,
                     "A frame of each contestant, edge_drop to 0.2 s, one thread");

    for (int n = 0; n < b->batch.count; n++)
        add_contestant(t, b->batch.cases[n].plan.contestant, &b->result[n]);
    table_note(t, "Medians of the repeats; undamped, but for the paper's own scheme. "
                  "Iterations: Newton's, or local and global steps; "
                  "none: one solve a frame.");
    return table_finish(t, b->format, stdout);
}

const struct bench_part bench_part_contestants = {
    .item = {"contestants", "set-up and a frame of each contestant on one scene"},
    .plan = plan_contestants,
    .print = print_contestants};
