#include "bench/speed/bench.h"

#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/ui/progress.h"
#include "models/linalg/blas_kernel.h"
#include "models/reader/scene_file.h"

static const struct command_item *const items[] = {
    &bench_part_solids.item,  &bench_part_projective.item,  &bench_part_nonlinear.item,
    &bench_part_contact.item, &bench_part_contestants.item, NULL,
};

/* The end of a short run [s]: twenty frames after two of warm-up (measurement.h). */
static const double SOME = 0.11;

enum status bench_part_add(struct bench *b, const struct bench_row *row,
                           struct message *why)
{
    const struct contestant *who;
    char name[64];
    const enum status st = contestant_find(row->contestant, &who, why);

    if (st != STATUS_OK)
        return st;
    snprintf(name, sizeof name, "%s_%d", row->contestant, b->batch.count);
    struct measurement_case *c = batch_add(&b->batch, b->path, who, name);
    c->plan.end = row->end > 0 ? row->end : SOME;
    c->timed = row->end > 0 ? MEASUREMENT_WHOLE : MEASUREMENT_SOME;
    c->phases = !(row->end > 0);
    settings_list(batch_settings(&b->batch), sizeof row->settings / sizeof *row->settings,
                  row->settings);
    return STATUS_OK;
}

static void show(void *context, const char *what, int done, int total)
{
    struct progress *bar = context;

    (void)what;
    bar->total = total;
    progress_update(bar, done);
}

static enum status measure(const struct bench_part *part, struct bench *b,
                           struct message *why)
{
    struct progress bar = progress_start(part->item.name, 1, false);
    const struct measurement_options options = {.what = part->item.name,
                                                .quick = b->quick,
                                                .progress = show,
                                                .context = &bar,
                                                .again = true};
    enum status st;

    TRY(folder_make(b->folder, why));
    TRY(batch_run(&b->batch, &options, why));
out:
    progress_end(&bar);
    return st;
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
    TRY(batch_init(&b->batch, folder, BENCH_PART_RUNS));
    b->part = part;
    for (int n = 0; n < part->count; n++)
        TRY(bench_part_add(b, &part->rows[n], why));
    if (part->plan)
        TRY(part->plan(b, why));
    if (!read_only)
        TRY(measure(part, b, why));
    b->result = calloc((size_t)b->batch.count + 1, sizeof *b->result);
    TRY(b->result ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < b->batch.count; n++)
        TRY(batch_read(&b->batch, n, false, &b->result[n], why));
    TRY(part->print(b, why));
    if (table_format_is_prose(b->format)) {
        measurement_machine(b->batch.files[0], b->file);
        fprintf(b->file, "\n");
    }
out:
    for (int n = 0; b->result && n < b->batch.count; n++)
        run_result_clear(&b->result[n]);
    free(b->result);
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
                                     "%s keeps no files: leave --from out", word)
                       : STATUS_OK;
        TEXT_JOIN(names, ", ", "%s", items[p]->name);
    }
    return status_fail(why, STATUS_INPUT, "there is no benchmark '%s'; there are %s", word,
                       names);
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *from;
    struct bench b = {.folder = "results/bench",
                      .models = command_value(line, "--models"),
                      .file = stdout,
                      .quick = command_given(line, "--quick")};
    char *path = NULL;
    enum status st = STATUS_OK;

    TRY(command_format(line, &b.format, why));
    TRY(command_folder(line, &b.folder, &from, why));
    for (int n = 0; n < line->word_count; n++)
        TRY(check_word(line->words[n], from != NULL, why));
    TRY(contestant_check(b.models, why));
    TRY(scene_file_find("edge_drop", &path, why));
    b.path = path;
    timing_alone();
    for (int n = 0; items[n]; n++) {
        const struct bench_part *part = (const struct bench_part *)items[n];
        if (wanted(line, part, from != NULL))
            TRY(run_part(part, &b, from != NULL, why));
    }
    if (!from && table_format_is_prose(b.format))
        printf("Peak memory %.0f MB; BLAS kernel %s, %d thread.\n",
               (double)clock_peak_memory() / 1e6, blas_kernel_name(),
               blas_kernel_threads());
out:
    free(path);
    return st;
}

static const struct command_option options[] = {
    {"--models", "NAME,NAME,...", false,
     "models or contestants of the timing table (those that\n"
     "take part; `clothbench list contestants`)"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of all repeats (results/bench)"},
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
