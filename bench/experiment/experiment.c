#include "bench/experiment/experiment.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/ui/progress.h"
#include "bench/harness/timing.h"

const struct command_option experiment_command_options[] = {
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false,
     "where result files, plots and pictures go\n"
     "(results/table1, results/study_mesh, ...)"},
    {"--from", "DIR", false, "print again from result files of an earlier run"},
    {"--values", "A,B,...", false,
     "levels of the parameter varied instead of the usual\n"
     "ones (study locking: thicknesses in metres)"},
    {"--quick", NULL, false, "a smaller job of the same shape"},
    {NULL, NULL, false, NULL},
};

void experiment_progress(const struct experiment_options *options, const char *what,
                         int done, int total)
{
    if (options->progress)
        options->progress(options->context, what, done, total);
}

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

static enum status find(const struct command *command, const char *name,
                        const struct experiment **experiment, struct message *why)
{
    char known[512] = "";

    for (int n = 0; command->items[n]; n++) {
        const struct command_item *item = command->items[n];
        size_t used = strlen(known);
        if (!strcmp(item->name, name)) {
            *experiment = (const struct experiment *)item;
            return STATUS_OK;
        }
        snprintf(known + used, sizeof known - used, "%s%s", n ? ", " : "", item->name);
    }
    return status_fail(why, STATUS_INPUT, "%s: there is no '%s'; there are %s",
                       command->name, name, known);
}

enum { MOST_VALUES = 16 };

/* "0.001,0.02", increasing. */
static enum status read_values(const char *text, const struct experiment *experiment,
                               int *count, double *value, struct message *why)
{
    if (!experiment->values)
        return status_fail(why, STATUS_INPUT, "%s has no --values to choose",
                           experiment->item.name);
    for (const char *rest = text;; rest++) {
        char *end;
        double v = strtod(rest, &end);
        bool good = end != rest && (*end == ',' || !*end) && isfinite(v) && v > 0 &&
                    *count < MOST_VALUES && (!*count || v > value[*count - 1]);
        if (!good)
            return status_fail(
                why, STATUS_INPUT,
                "--values '%s': at most %d increasing positive numbers, as in "
                "0.001,0.02: %s",
                text, MOST_VALUES, experiment->values);
        value[(*count)++] = v;
        rest = end;
        if (!*rest)
            return STATUS_OK;
    }
}

/* One thread, on one processor: experiments compare models, not schedulers. */
static enum status measure(const struct experiment *experiment, struct experiment_options o,
                           struct message *why)
{
    struct bar bar = {{0}, NULL};
    enum status st = folder_make(o.folder, why);

    if (st != STATUS_OK)
        return st;
    o.progress = show;
    o.context = &bar;
    omp_set_num_threads(1);
    timing_pin();
    st = experiment->measure(&o, why);
    progress_end(&bar.progress);
    return st;
}

enum status experiment_run(const struct command_line *line, struct message *why)
{
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    const char *word = command_value(line, "--format"), *command = line->command->name;
    const struct experiment *experiment = NULL;
    enum table_format format = TABLE_TEXT;
    enum status st = STATUS_OK;
    const char *values = command_value(line, "--values");
    double value[MOST_VALUES];
    char usual[64];

    TRY(find(line->command, line->words[0], &experiment, why));
    snprintf(usual, sizeof usual, "results/%s%s%s", command,
             strcmp(command, "table") ? "_" : "", experiment->item.name);
    const char *folder = from ? from : out ? out : usual;
    if (from && out)
        return status_fail(why, STATUS_INPUT,
                           "--from reads result files and --out writes "
                           "them; give one of the two");
    if (word)
        TRY(table_format_parse(word, &format, why));
    struct experiment_options options = {
        .folder = folder, .quick = command_given(line, "--quick"), .value = value};
    if (values)
        TRY(read_values(values, experiment, &options.value_count, value, why));
    if (values && from)
        return status_fail(why, STATUS_INPUT, "--values is for a new run, not for --from");
    if (!from)
        TRY(measure(experiment, options, why));
    TRY(experiment->print(folder, format, stdout, why));
out:
    return st;
}
