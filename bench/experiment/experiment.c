#include "bench/experiment/experiment.h"
#include "bench/experiment/plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/dataset.h"
#include "bench/experiment/judge.h"
#include "bench/experiment/kept.h"
#include "bench/experiment/study.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/ui/progress.h"

const struct command_option experiment_command_options[] = {
    {"--models", "A,B,...", false, "contestants (study ensemble)"},
    {"--runs", "N", false,
     "runs of each, each pushed in another direction (study\nensemble: 32)"},
    {"--until", "S", false, "end of the motion in seconds (study ensemble: the scene's)"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false,
     "folder of result files, plots and pictures\n"
     "(results/table1, results/study_mesh, ...)"},
    {"--from", "DIR", false, "print again from the result files of an earlier run"},
    {"--quick", NULL, false, "the same on smaller nets and shorter times"},
    {NULL, NULL, false, NULL},
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

static const struct experiment *find(const struct command *command, const char *name)
{
    for (int n = 0; command->items[n]; n++)
        if (!strcmp(command->items[n]->name, name))
            return (const struct experiment *)command->items[n];
    return NULL;
}

static enum status refuse(const struct command *command, const char *name, bool plans,
                          struct message *why)
{
    struct named_file_entry *entries = NULL;
    char known[512] = "";
    int count = 0;

    for (int n = 0; command->items[n]; n++)
        snprintf(known + strlen(known), sizeof known - strlen(known), "%s%s", n ? ", " : "",
                 command->items[n]->name);
    if (plans)
        named_file_list(&plan_study_kind, &entries, &count, NULL);
    for (int n = 0; n < count; n++)
        if (*entries[n].text && !find(command, entries[n].name))
            snprintf(known + strlen(known), sizeof known - strlen(known), ", %s",
                     entries[n].name);
    named_file_list_free(entries, count);
    return status_fail(why, STATUS_INPUT, "%s: there is no '%s'; there are %s%s",
                       command->name, name, known,
                       plans ? ", or give the path of a plan with levels" : "");
}

static enum status read_plan(const char *name, struct plan *plan, struct message *why)
{
    char *path = NULL;
    enum status st;

    TRY(named_file_find(&plan_kind, name, &path, why));
    TRY(plan_read(path, plan, why));
    TRY(dataset_check(plan, why));
    if (!plan->study_count)
        st = status_fail(why, STATUS_INPUT,
                         "%s: the plan has no levels, so it is no study; clothbench sweep "
                         "runs it",
                         path);
out:
    free(path);
    return st;
}

enum status experiment_measure(const struct experiment *e,
                               const struct experiment_options *options,
                               struct message *why)
{
    const struct measurement_options how = {.quick = options->quick,
                                            .repeats = options->repeats,
                                            .progress = options->progress,
                                            .context = options->context};
    struct plan plan = {0};
    enum status st = STATUS_OK;

    if (options->quick)
        judge_mark(options->folder, true);
    if (e->plan) {
        TRY(read_plan(e->plan, &plan, why));
        TRY(study_measure(&plan, options->folder, &how, why));
    }
    if (e->measure)
        TRY(e->measure(options, why));
    judge_mark(options->folder, options->quick);
out:
    plan_clear(&plan);
    return st;
}

enum status experiment_print(const struct experiment *e, const char *folder,
                             enum table_format format, FILE *file, struct message *why)
{
    struct study_results r = {0};
    struct plan plan = {0};
    enum status st;

    if (!e->plan)
        return e->print(folder, format, file, why);
    TRY(read_plan(e->plan, &plan, why));
    TRY(study_read(&plan, folder, &r, why));
    st = e->tell ? e->tell(&r, folder, format, file, why)
                 : dataset_print(&r, folder, format, file, why);
out:
    study_clear(&r);
    plan_clear(&plan);
    return st;
}

/* One thread, on one processor: experiments compare models, not schedulers. What works in
 * processes of its own is not timed. */
static enum status measure(const struct experiment *e, struct experiment_options o,
                           struct message *why)
{
    struct bar bar = {{0}, NULL};
    enum status st = folder_make(o.folder, why);

    if (st != STATUS_OK)
        return st;
    o.progress = show;
    o.context = &bar;
    if (!e->chooses)
        timing_alone();
    st = experiment_measure(e, &o, why);
    progress_end(&bar.progress);
    return st;
}

/* To standard output, and what a report reads into the folder: always tables and sentences,
 * though machines are printed no sentences. */
static enum status print(const struct command_line *line, const struct experiment *e,
                         const char *folder, enum table_format format, struct message *why)
{
    const bool prose = table_format_is_prose(format);
    struct kept *kept = NULL;
    FILE *nowhere = NULL;
    enum status st;

    kept_open(folder, line->command->name, line->words[0], &kept);
    if (kept && !prose && (nowhere = fopen("/dev/null", "w"))) {
        TRY(experiment_print(e, folder, TABLE_TEXT, nowhere, why));
        TRY(kept_close(&kept, why));
    }
    TRY(experiment_print(e, folder, format, stdout, why));
    TRY(kept_close(&kept, why));
out:
    if (nowhere)
        fclose(nowhere);
    kept_discard(&kept);
    return st;
}

/* results/table1, results/study_mesh; of a plan somewhere else, by its name. */
static enum status name_folder(const struct command_line *line, const struct experiment *e,
                               char usual[128], struct message *why)
{
    const char *command = line->command->name;
    struct plan plan = {0};
    enum status st = STATUS_OK;

    if (!e->item.name)
        TRY(read_plan(e->plan, &plan, why));
    snprintf(usual, 128, "results/%s%s%s", command, strcmp(command, "table") ? "_" : "",
             e->item.name ? e->item.name : plan.name);
out:
    plan_clear(&plan);
    return st;
}

/* What the word means: `own` is filled in if it is a plan. */
static enum status choose(const struct command_line *line, experiment_tell *plans,
                          struct experiment *own, const struct experiment **e,
                          struct message *why)
{
    const char *word = line->words[0];
    char *path = NULL;

    *e = find(line->command, word);
    if (*e)
        return STATUS_OK;
    const enum status st =
        plans ? named_file_find(&plan_study_kind, word, &path, NULL) : STATUS_INPUT;
    if (st != STATUS_OK)
        return st == STATUS_MEMORY ? st : refuse(line->command, word, plans != NULL, why);
    free(path);
    *own = (struct experiment){.plan = word, .tell = plans};
    *e = own;
    return STATUS_OK;
}

/* What an experiment that chooses is told. */
static enum status read_choice(const struct command_line *line, const struct experiment *e,
                               bool from, struct experiment_options *o, struct message *why)
{
    long runs = 0;
    enum status st;

    o->scene = line->words + 1;
    o->scene_count = line->word_count - 1;
    o->models = command_value(line, "--models");
    TRY(command_integer(line, "--runs", 1, 256, &runs, why));
    TRY(command_number(line, "--until", false, &o->until, why));
    o->runs = (int)runs;
    const bool any = o->scene_count || o->models || o->runs || o->until > 0;
    if (any && (!e->chooses || from))
        st = status_fail(why, STATUS_INPUT,
                         from ? "scenes, --models, --runs and --until are for a new run, "
                                "not for --from"
                              : "%s takes no scenes, --models, --runs and --until; study "
                                "ensemble does",
                         e->plan ? e->plan : e->item.name);
out:
    return st;
}

enum status experiment_command(const struct command_line *line, experiment_tell *plans,
                               struct message *why)
{
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    const char *word = command_value(line, "--format");
    const struct experiment *e = NULL;
    struct experiment own;
    enum table_format format = TABLE_TEXT;
    char usual[128];
    enum status st;

    TRY(choose(line, plans, &own, &e, why));
    TRY(name_folder(line, e, usual, why));
    if (from && out)
        return status_fail(why, STATUS_INPUT,
                           "--from reads result files and --out writes "
                           "them; give one of the two");
    if (word)
        TRY(table_format_parse(word, &format, why));
    struct experiment_options options = {.folder = from  ? from
                                                   : out ? out
                                                         : usual,
                                         .quick = command_given(line, "--quick")};
    if (plans)
        TRY(read_choice(line, e, from, &options, why));
    if (!from)
        TRY(measure(e, options, why));
    TRY(print(line, e, options.folder, format, why));
out:
    return st;
}
