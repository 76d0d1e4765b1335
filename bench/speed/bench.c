#include "bench/speed/bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/bench_solid.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/ui/show.h"
#include "fem_ref/reference.h"
#include "models/linalg/blas_kernel.h"
#include "models/reader/scene_file.h"

/* A run on edge_drop of twenty frames, its phases timed apart, with the times that a frame
 * and its phases should reach [ms] (0: no aim). peers.csv has what other programs take for
 * the work of its title. */
struct solid_row {
    const char *title, *contestant;
    const char *settings[2]; /* KEY=VALUE; NULL ends */
    double frame, phase[BENCH_SOLID_FRAME];
};

#define UNDAMPED "damping={kind: none}"
#define NET(n)   "discretization.points=[" #n "," #n ",2]"

/* clang-format off */
static const struct solid_row solids[] = {
    {"iga 10x10x2 rebuilt", "iga_paper", {0}, 0.7, {0}},
    {"iga 10x10x2 prefactored", "iga_linear", {UNDAMPED}, 0.025, {0}},
    {"hex 32x32x2 rebuilt", "hex_paper", {NET(32)}, 12, {0}},
    {"iga 100x100x2 prefactored", "iga_linear", {UNDAMPED, NET(100)}, 20, {80, 800, 0}},
};
/* clang-format on */
enum { SOLIDS = sizeof solids / sizeof *solids };

/* Adds a run; settings are KEY=VALUE, and NULL ends them. */
static struct case_plan *add_run(struct bench *b, const struct contestant *who, int count,
                                 const char *const *settings, double end)
{
    char name[64];

    snprintf(name, sizeof name, "%s_%d", who->name, b->batch.count);
    struct case_plan *c = batch_add(&b->batch, b->path, who, name);
    c->end = end;
    settings_list(&c->settings, count, settings);
    return c;
}

/* --- solids: frames and their phases against aims ---------------------------------------
 */

static enum status plan_solids(struct bench *b, struct message *why)
{
    static const double end = 0.11; /* twenty frames after two of warm-up (measurement.h) */

    for (const struct solid_row *row = solids; row < solids + SOLIDS; row++) {
        const struct contestant *who;
        CALL(contestant_find(row->contestant, &who, why));
        struct case_plan *c = add_run(b, who, 2, row->settings, end);
        c->timed = CASE_SOME;
        c->phases = true;
    }
    return STATUS_OK;
}

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
static enum status note_peers(struct dataset *t, const char *name, struct message *why)
{
    struct reference *r = NULL;
    char text[WORDS] = "";
    enum status st;

    TRY(reference_open_named("peers", &r, why));
    for (int row = reference_find(r, 0, "case", name), before = -1; row >= 0;
         before = row, row = reference_find(r, row + 1, "case", name))
        add_peer(r, row, before, text);
    if (*text)
        dataset_note(t, "%s elsewhere, %s, %s, beside %s. %s.", name,
                     reference_note(r, "source"), reference_note(r, "date"),
                     reference_note(r, "ours"), text);
out:
    reference_close(r);
    return st;
}

static void add_phase(struct dataset *t, const struct solid_row *row, const char *phase,
                      const struct clock_summary *s, double aim)
{
    dataset_line(t, "%s|%s|%.3g|%.3g|%.3g|%.3g|%d", row->title, phase, 1e3 * s->median,
                 1e3 * s->min, 1e3 * s->lower, 1e3 * s->upper, s->count);
    if (aim <= 0)
        return;
    dataset_add(t, "%.3g|%s", aim, 1e3 * s->median <= aim ? "yes" : "no");
}

static enum status add_rows(struct dataset *t, const struct solid_row *row,
                            const struct run_result *r, struct message *why)
{
    static const char *const phase[] = {"K and M", "factor", "solve"};

    add_phase(t, row, "frame", &r->step, row->frame);
    for (int p = 0; p < BENCH_SOLID_FRAME && r->phase[p].count; p++)
        add_phase(t, row, phase[p], &r->phase[p], row->phase[p]);
    if (r->outcome || run_result_missed(r))
        dataset_note(t, "%s: %s.", row->title, r->sentence.text);
    dataset_note(t, "%s: %.0f unknowns, %.0f numbers in L, set-up %.3g ms.", row->title,
                 r->unknowns, r->factor_entries, 1e3 * r->create.median);
    return note_peers(t, row->title, why);
}

static enum status print_solids(const struct bench *b, struct message *why)
{
    static const struct dataset_column columns[] = {
        {"case"},        {"phase"},   {"median", "ms"}, {"min", "ms"}, {"lower", "ms"},
        {"upper", "ms"}, {"repeats"}, {"aim", "ms"},    {"reached"}};
    struct dataset *t = DATASET_OF(columns, "Speed of the solids, one thread");
    enum status st;

    for (int n = 0; n < b->batch.count; n++)
        TRY(add_rows(t, &solids[n], &b->result[n], why));
    return printer_table(b->printer, t, "solids", why);
out:
    dataset_destroy(t);
    return st;
}

const struct bench_part bench_part_solids = {
    .item = {"solids",
             "IGA plate and hexahedra: K and M, factor, solve, frame, against their aims"},
    .plan = plan_solids,
    .print = print_solids};

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
        struct case_plan *run = add_run(b, c, 1, &damping, *end);
        run->timed = CASE_WHOLE;
        run->keep.times = 1;
        run->keep.time = end; /* the work up to there */
        contestant_points(c, usual_side(c), usual_side(c), &run->settings);
    }
    return st;
}

static void add_contestant(struct dataset *t, const struct contestant *c,
                           const struct run_result *r)
{
    const bool ran = !run_result_refused(r);

    dataset_line(t, "%s|%s|%s|%dx%d|%.0f|%.3g|%.3g|%.0f|%.3g|%s", c->title, c->name,
                 c->model->name, usual_side(c), usual_side(c), ran ? r->unknowns : NAN,
                 ran ? 1e3 * r->create.median : NAN, ran ? 1e3 * r->step.median : NAN,
                 ran ? r->step.count : NAN,
                 ran && r->work.iterations
                     ? (double)r->work.iterations / (double)r->work.steps
                     : NAN,
                 r->sentence.text);
    if (r->outcome || run_result_missed(r))
        dataset_note(t, "%s: %s.", c->title, r->sentence.text);
}

static enum status print_contestants(const struct bench *b, struct message *why)
{
    static const struct dataset_column columns[] = {
        {"model", .key = "title"},
        {"contestant", .readers = DATASET_MACHINES},
        {"model", .readers = DATASET_MACHINES, .key = "model"},
        {"net"},
        {"unknowns"},
        {"set-up", "ms"},
        {"a frame", "ms"},
        {"repeats"},
        {"iterations", "a frame", .key = "iterations_a_frame"},
        {"outcome", .readers = DATASET_MACHINES}};
    struct dataset *t =
        DATASET_OF(columns, "A frame of each contestant, edge_drop to 0.2 s, one thread");

    for (int n = 0; n < b->batch.count; n++)
        add_contestant(t, b->batch.cases[n].contestant, &b->result[n]);
    dataset_note(t,
                 "Times are medians of the repeats. Motions are undamped except for the "
                 "paper's own scheme. Iterations are Newton's, or local and global steps; "
                 "none means one solve a frame.");
    return printer_table(b->printer, t, "contestants", why);
}

const struct bench_part bench_part_contestants = {
    .item = {"contestants", "set-up and a frame of each contestant on one scene"},
    .plan = plan_contestants,
    .print = print_contestants};

/* --- the command -------------------------------------------------------------------------
 */

static const struct command_item *const items[] = {
    &bench_part_solids.item, &bench_part_contact.item, &bench_part_contestants.item, NULL};

static enum status measure(const struct bench_part *part, struct bench *b,
                           struct message *why)
{
    const struct measurement_options options = {
        .what = part->item.name, .quick = b->quick, .again = true};

    CALL(folder_make(b->folder, why));
    return batch_run(&b->batch, &options, why);
}

static enum status run_part(const struct bench_part *part, struct bench *b, bool read_only,
                            struct message *why)
{
    char folder[4096];
    const char *all = b->folder;
    enum status st;

    if (part->measure)
        return part->measure(b, why);
    snprintf(folder, sizeof folder, "%s/%s", all, part->item.name);
    b->folder = folder;
    batch_init(&b->batch, folder, BENCH_PART_RUNS);
    TRY(part->plan(b, why));
    if (!read_only)
        TRY(measure(part, b, why));
    b->result = arena_take(&b->batch.arena, (size_t)b->batch.count, sizeof *b->result);
    for (int n = 0; n < b->batch.count; n++)
        TRY(run_result_read(b->batch.cases[n].keep.file, false, &b->result[n], why));
    TRY(part->print(b, why));
    if (printer_is_prose(b->printer)) {
        measurement_machine(b->batch.cases->keep.file, b->printer->file);
        fprintf(b->printer->file, "\n");
    }
out:
    for (int n = 0; b->result && n < b->batch.count; n++)
        run_result_clear(&b->result[n]);
    b->result = NULL;
    batch_clear(&b->batch);
    b->folder = all;
    return st;
}

/* Says if a part is asked for: by name, or with no name every part that can be printed. */
static bool wanted(const struct command_line *line, const struct bench_part *part,
                   bool read_only)
{
    for (int n = 0; n < line->word_count; n++)
        if (!strcmp(line->words[n], part->item.name))
            return true;
    return line->word_count == 0 && !(read_only && part->measure);
}

static enum status check_word(const char *word, bool read_only, struct message *why)
{
    char names[256] = "";

    for (int p = 0; items[p]; p++) {
        const struct bench_part *part = (const struct bench_part *)items[p];
        if (!strcmp(word, items[p]->name))
            return read_only && part->measure
                       ? status_fail(why, STATUS_INPUT,
                                     "%s keeps no result files: leave --from out", word)
                       : STATUS_OK;
        TEXT_JOIN(names, ", ", "%s", items[p]->name);
    }
    return status_fail(why, STATUS_INPUT, "there is no benchmark '%s'; there are %s", word,
                       names);
}

static enum status run(struct command_line *line, struct message *why)
{
    const char *from;
    struct bench b = {.folder = "results/bench",
                      .models = command_value(line, "--models"),
                      .printer = &line->printer,
                      .quick = command_given(line, "--quick")};
    char *path SCOPED(scope_free) = NULL;

    CALL(command_folder(line, &b.folder, &from, why));
    for (int n = 0; n < line->word_count; n++)
        CALL(check_word(line->words[n], from != NULL, why));
    CALL(contestant_check(b.models, why));
    CALL(scene_file_find("edge_drop", &path, why));
    b.path = path;
    if (!from)
        CALL(folder_make(b.folder, why));
    line->printer.folder = b.folder;
    timing_alone();
    for (int n = 0; items[n]; n++) {
        const struct bench_part *part = (const struct bench_part *)items[n];
        if (wanted(line, part, from != NULL))
            CALL(run_part(part, &b, from != NULL, why));
    }
    if (!from && printer_is_prose(b.printer))
        printf("Peak memory %.0f MB; BLAS kernel %s, %d thread.\n",
               (double)clock_peak_memory() / 1e6, blas_kernel_name(),
               blas_kernel_threads());
    show_tell(b.folder);
    return STATUS_OK;
}

static const struct command_option options[] = {
    {"--models", "NAME,NAME,...", false,
     "models or contestants of the timing table (those that\n"
     "take part; `clothbench list contestants`)"},
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of result files and CSV (results/bench)"},
    {"--from", "DIR", false, "print again from the files of an earlier run"},
    {"--quick", NULL, false, "three repeats of everything, and the smaller nets"},
    {NULL, NULL, false, NULL},
};

const struct command bench_command = {
    .name = "bench",
    .summary = "time the models and compare them with aims",
    .arguments = "[NAME]... [OPTION]...",
    .text =
        "Times set-up and frames of all contestants, the phases of a frame, which are\n"
        "compared with aims, and the search for contact. All of a part take turns on one\n"
        "thread, with nine repeats of what takes up to 0.2 s and three of the rest; the\n"
        "number stands beside the medians. Other work on the machine spoils the times:\n"
        "look at the quartiles.\n",
    .examples = "bench contestants\nbench solids contestants --out times\n"
                "bench solids contestants --from times --format csv\n",
    .least = 0,
    .most = 16,
    .options = options,
    .section = "benchmarks",
    .items = items,
    .run = run,
};
