#include "bench/tables.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/progress.h"
#include "bench/table1.h"
#include "bench/timing.h"

static const struct command_option options[] = {
    {"--format", "text|csv|markdown|latex", false, "how to print (text)"},
    {"--out", "DIR", false, "where the result files go (results/table1)"},
    {"--from", "DIR", false, "make the tables from result files of an earlier run"},
    {"--quick", NULL, false, "3 repeats of 5 frames instead of 9 of 20"},
    {NULL, NULL, false, NULL},
};

static const struct command_item items[] = {
    {"1", "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at equal looks "
          "and against truth"},
    {NULL, NULL},
};

struct bar {
    struct progress progress;
    const char *what;
};

static void show(void *context, const char *what, int done, int total)
{
    struct bar *bar = context;

    if (bar->what != what) {
        progress_end(&bar->progress);
        bar->progress = progress_start(what, total, false);
        bar->what = what;
    }
    progress_update(&bar->progress, done);
    if (done == total)
        progress_end(&bar->progress);
}

/* One thread, on one processor: the tables compare models, not schedulers. */
static enum status measure(const struct command_line *line, const char *folder,
                           struct message *why)
{
    struct bar bar = {{0}, NULL};
    struct table1_options o = {.folder = folder,
                               .quick = command_given(line, "--quick"),
                               .progress = show,
                               .context = &bar};

    omp_set_num_threads(1);
    timing_pin();
    return table1_measure(&o, why);
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    const char *word = command_value(line, "--format");
    const char *folder = from ? from : out ? out : "results/table1";
    enum table_format format = TABLE_TEXT;
    enum status st = STATUS_OK;

    if (strcmp(line->words[0], "1") != 0)
        return status_fail(why, STATUS_INPUT,
                           "table %s: only table 1 is built; tables 2, 3 and 4 are planned",
                           line->words[0]);
    if (from && out)
        return status_fail(why, STATUS_INPUT,
                           "--from reads result files and --out writes "
                           "them; give one of the two");
    if (word)
        TRY(table_format_parse(word, &format, why));
    if (!from)
        TRY(measure(line, folder, why));
    TRY(table1_print(folder, format, stdout, why));
out:
    return st;
}

const struct command tables_command = {
    .name = "table",
    .summary = "recompute a table of the paper, its numbers beside ours",
    .arguments = "1 [OPTION]...",
    .text =
        "Runs every case of the table, keeps a result file of each and makes the tables\n"
        "from these files. Times are medians of interleaved repeats on one thread.\n",
    .examples =
        "table 1\ntable 1 --quick --format markdown\ntable 1 --from results/table1\n",
    .least = 1,
    .most = 1,
    .options = options,
    .section = "tables",
    .items = items,
    .run = run,
};
