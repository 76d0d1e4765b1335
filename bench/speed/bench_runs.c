/* Times runs on edge_drop: frames and phases against aims, and a frame of each contestant.
 */
#include <math.h>
#include <string.h>

#include "bench/experiment/bench_solid.h"
#include "bench/speed/bench.h"
#include "fem_ref/reference.h"

#define LEN(array) (sizeof array / sizeof *array)

#define UNDAMPED   "damping={kind: none}"
#define MATCHED    "discretization.parameters=matched"
#define NET(n)     "discretization.points=[" #n "," #n ",2]"
#define SPRINGS_32 "discretization.points=[32,32]"

/* clang-format off */
static const struct bench_row solids[] = {
    {"iga 10x10x2 rebuilt", "iga_paper", {0}, 0, 0.7, {0}},
    {"iga 10x10x2 prefactored", "iga_linear", {UNDAMPED}, 0, 0.025, {0}},
    {"hex 32x32x2 rebuilt", "hex_paper", {NET(32)}, 0, 12, {0}},
    {"iga 100x100x2 prefactored", "iga_linear", {UNDAMPED, NET(100)}, 0, 20, {80, 800, 0}},
};

static const struct bench_row motions[] = {
    {"shell 10x10, p = 2", "shell_2", {UNDAMPED}, 0.4, 1, {0}},
    {"shell 10x10, p = 3", "shell_3", {UNDAMPED}, 0.4, 2, {0}},
    {"mass-spring 32x32, to its tolerance", "mass_spring_paper",
     {UNDAMPED, MATCHED, SPRINGS_32}, 0.4, 2, {0}},
    {"mass-spring 32x32, one iteration", "mass_spring_paper",
     {UNDAMPED, MATCHED, SPRINGS_32, "discretization.iterations=1"}, 0.4, 2, {0}},
    {"iga 10x10x2, none (the paper's)", "iga_nonlinear", {UNDAMPED}, 0.4, 5, {0}},
    {"iga 10x10x2, reduced", "iga_reduced", {UNDAMPED}, 0.4, 5, {0}},
    {"iga 10x10x2, selective", "iga_selective", {UNDAMPED}, 0.4, 5, {0}},
    {"shell 10x10, p = 2, selective", "shell_selective_2", {UNDAMPED}, 0.4, 1, {0}},
    {"shell 10x10, p = 3, selective", "shell_selective_3", {UNDAMPED}, 0.4, 2, {0}},
};

/* Ten iterations a frame, whatever they come to. */
#define PROJECTIVE(n, constraint, aim)                                                     \
    {"projective " #n "x" #n " " constraint, "projective_dynamics",                        \
     {UNDAMPED, "discretization.constraint=" constraint, "discretization.iterations=10",   \
      "discretization.points=[" #n "," #n "]"}, 0.1, aim, {0}}
static const struct bench_row projective[] = {
    PROJECTIVE(10, "triangles", 0.03), PROJECTIVE(10, "edges", 0.03),
    PROJECTIVE(32, "triangles", 0.6), PROJECTIVE(32, "edges", 0.6),
    PROJECTIVE(100, "triangles", 7), PROJECTIVE(100, "edges", 7),
};
/* clang-format on */

enum { WORDS = 2048 };

/* Appends the words of a row of peers.csv: "PetIGA cc362e1 (AIJ + CHOLMOD) 9.05 ms"; where
 * another kind of work begins, its name and our time come first. */
static void add_peer(const struct reference *r, int row, int before, char text[WORDS])
{
    const char *what = reference_text(r, row, "what");
    const char *version = reference_text(r, row, "version");
    const char *solver = reference_text(r, row, "solver");
    const bool next = before < 0 || strcmp(what, reference_text(r, before, "what")) != 0;

    if (next)
        status_join(text, WORDS, "; ", "%s, ours %s ms:", what,
                    reference_text(r, row, "ours_ms"));
    status_join(text, WORDS, next ? "" : ",", " %s%s%s%s%s%s %s ms",
                reference_text(r, row, "peer"), *version ? " " : "", version,
                *solver ? " (" : "", solver, *solver ? ")" : "",
                reference_text(r, row, "ms"));
}

/* Adds a note on the programs of other people that did the work `name`: their times in
 * tests/reference/peers.csv, measured elsewhere side by side with ours, with version and
 * solver, and never in a ratio with what is measured here; nothing if there are none. */
static enum status note_peers(struct table *t, const char *name, struct message *why)
{
    struct reference *r = NULL;
    char text[WORDS] = "";
    enum status st;

    TRY(reference_open_named("peers", &r, why));
    for (int row = reference_find(r, 0, "case", name), before = -1; row >= 0;
         before = row, row = reference_find(r, row + 1, "case", name))
        add_peer(r, row, before, text);
    if (*text)
        table_note(t, "%s elsewhere, %s, %s, beside %s. %s.", name,
                   reference_note(r, "source"), reference_note(r, "date"),
                   reference_note(r, "ours"), text);
out:
    reference_close(r);
    return st;
}

static void add_phase(struct table *t, const struct bench_row *row, const char *phase,
                      const struct clock_summary *s, double aim)
{
    table_line(t, "%s|%s|%.3g|%.3g|%.3g|%.3g|%d", row->title, phase, 1e3 * s->median,
               1e3 * s->min, 1e3 * s->lower, 1e3 * s->upper, s->count);
    if (aim <= 0)
        return;
    table_add(t, "%.3g|%s", aim, 1e3 * s->median <= aim ? "yes" : "no");
}

static enum status add_run(struct table *t, const struct bench_row *row,
                           const struct run_result *r, struct message *why)
{
    static const char *const phase[] = {"K and M", "factor", "solve"};

    add_phase(t, row, "frame", &r->step, row->frame);
    for (int p = 0; p < BENCH_SOLID_FRAME && r->phase[p].count; p++)
        add_phase(t, row, phase[p], &r->phase[p], row->phase[p]);
    if (r->outcome)
        table_note(t, "%s: %s.", row->title, r->sentence.text);
    table_note(t, "%s: %.0f unknowns, %.0f numbers in L, set-up %.3g ms.", row->title,
               r->unknowns, r->factor_entries, 1e3 * r->create.median);
    return note_peers(t, row->title, why);
}

static enum status print_runs(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"case", NULL, TABLE_LEFT},
                                                  {"phase", NULL, TABLE_LEFT},
                                                  {"median", "ms"},
                                                  {"min", "ms"},
                                                  {"lower", "ms"},
                                                  {"upper", "ms"},
                                                  {"repeats"},
                                                  {"aim", "ms"},
                                                  {"reached", NULL, TABLE_LEFT}};
    struct table *t = TABLE_OF(columns, b->part->caption);
    enum status st;

    for (int n = 0; n < b->batch.count; n++)
        TRY(add_run(t, &b->part->rows[n], &b->result[n], why));
    if (b->part->note)
        table_note(t, "%s", b->part->note);
    if (b->part->peers)
        TRY(note_peers(t, b->part->peers, why));
    return table_finish(t, b->format, b->file);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_solids = {
    .item = {"solids",
             "IGA plate and hexahedra: K and M, factor, solve, frame, against their aims"},
    .caption = "Speed of the solids, one thread",
    .count = LEN(solids),
    .rows = solids,
    .print = print_runs};

const struct bench_part bench_part_nonlinear = {
    .item = {"nonlinear", "shell, springs and nonlinear solids over whole motions"},
    .caption = "Frames of the models that iterate, edge_drop to 0.4 s, undamped",
    .note = "A repeat counts with its mean frame, because frames differ: iterations "
            "grow where the sheet buckles.",
    .peers = "shell 10x10",
    .count = LEN(motions),
    .rows = motions,
    .print = print_runs};

const struct bench_part bench_part_projective = {
    .item = {"projective", "projective dynamics: frames of ten iterations"},
    .caption = "Projective dynamics, frames of 10 iterations, one thread",
    .count = LEN(projective),
    .rows = projective,
    .print = print_runs};

/* --- contestants: the timing table of all that enter it, on edge_drop --------------------
 */

/* Returns ten points a side, or the first of its nets if it is never refined so. */
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
        st = bench_part_add(
            b, &(struct bench_row){c->title, c->name, {damping}, *end, 0, {0}}, why);
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

    table_line(t, "%s|%s|%s|%dx%d|%.0f|%.3g|%.3g|%.0f|%.3g|%s", c->title, c->name,
               c->model->name, usual_side(c), usual_side(c), ran ? r->unknowns : NAN,
               ran ? 1e3 * r->create.median : NAN, ran ? 1e3 * r->step.median : NAN,
               ran ? r->step.count : NAN,
               ran && r->work.iterations
                   ? (double)r->work.iterations / (double)r->work.steps
                   : NAN,
               r->sentence.text);
    if (r->outcome)
        table_note(t, "%s: %s.", c->title, r->sentence.text);
}

static enum status print_contestants(const struct bench *b, struct message *why)
{
    (void)why;
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
        TABLE_OF(columns, "A frame of each contestant, edge_drop to 0.2 s, one thread");

    for (int n = 0; n < b->batch.count; n++)
        add_contestant(t, b->batch.cases[n].plan.contestant, &b->result[n]);
    table_note(t, "Times are medians of the repeats. Motions are undamped except for the "
                  "paper's own scheme. Iterations are Newton's, or local and global steps; "
                  "none means one solve a frame.");
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_contestants = {
    .item = {"contestants", "set-up and a frame of each contestant on one scene"},
    .plan = plan_contestants,
    .print = print_contestants};
