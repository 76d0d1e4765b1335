#include "bench/studies/studies.h"

#include <stdlib.h>
#include <string.h>

#include "bench/claims/claim.h"
#include "bench/experiment/kept.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/ui/progress.h"

/* Tables are plans and the claims on them. */
static const struct table_plan {
    struct command_item item; /* first: the command's items point to these               */
    const char *plan;
} tables[] = {
    {{"1", "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at equal "
           "looks and against truth"},
     "table1"},
    {{"2", "Ren et al. 2024, Table 2: milliseconds a frame over ten scenes, and how they "
           "grow with the net"},
     "table2"},
    {{"3", "Ren et al. 2024, Table 3: milliseconds a frame over degree and net"}, "table3"},
    {{"4", "E, rho and mu that give cloth, and why the others do not"}, "table4-readings"},
};

static const struct command_item *const table_items[] = {
    &tables[0].item, &tables[1].item, &tables[2].item, &tables[3].item, NULL,
};

/* Studies are plans and the claims on them, but for one. */
static const struct command_item ensemble = {
    "ensemble",
    "beyond the horizon: motions that cannot be predicted, compared as distributions"};
static const struct command_item *const study_items[] = {&ensemble, NULL};

/* A table or study that a command line asks for. */
struct asked {
    struct plan plan; /* all-zero for the ensemble                                       */
    bool ensemble;
    const char *from;  /* NULL: it is measured */
    char folder[4096]; /* of the result files                                            */
    enum table_format format;
    struct study_ensemble_options options;
};

/* --- what the words mean -----------------------------------------------------------------
 */

static const struct command_item *find_item(const struct command *command, const char *name)
{
    for (int n = 0; command->items[n]; n++)
        if (!strcmp(command->items[n]->name, name))
            return command->items[n];
    return NULL;
}

/* Fails with a sentence that lists what there is, with `plans` also the studies. */
static enum status refuse(const struct command *command, const char *name, bool plans,
                          struct message *why)
{
    struct named_file_entry *entries = NULL;
    char known[512] = "";
    int count = 0;

    for (int n = 0; command->items[n]; n++)
        TEXT_JOIN(known, ", ", "%s", command->items[n]->name);
    if (plans)
        named_file_list(&plan_study_kind, &entries, &count, NULL);
    for (int n = 0; n < count; n++)
        if (*entries[n].text && !find_item(command, entries[n].name))
            TEXT_ADD(known, ", %s", entries[n].name);
    named_file_list_free(entries, count);
    return status_fail(why, STATUS_INPUT, "%s: there is no '%s'; there are %s%s",
                       command->name, name, known,
                       plans ? ", or give the path of a plan with levels" : "");
}

/* Reads the plan of a file, freed by the caller also after a failure, which must have
 * studies. */
static enum status read_plan(const char *path, struct plan *plan, struct message *why)
{
    enum status st;

    TRY(plan_read(path, plan, why));
    TRY(dataset_check(plan, why));
    if (!plan->study_count)
        st = status_fail(why, STATUS_INPUT,
                         "%s: the plan has no levels, so it is no study; clothbench sweep "
                         "runs it",
                         path);
out:
    return st;
}

/* Finds the plan of the first word, or that it is the ensemble; and the usual folder:
 * results/table1, results/study_mesh, of a plan somewhere else by its name. */
static enum status choose(const struct command_line *line, struct asked *a,
                          struct message *why)
{
    const struct command *command = line->command;
    const char *word = line->words[0];
    const struct command_item *item = find_item(command, word);
    const bool table = command->items == table_items;
    char *path = NULL;
    enum status st = STATUS_OK;

    a->ensemble = item == &ensemble;
    if (item && table)
        TRY(named_file_find(&plan_kind, ((const struct table_plan *)item)->plan, &path,
                            why));
    else if (!item) {
        st = table ? STATUS_INPUT : named_file_find(&plan_study_kind, word, &path, NULL);
        if (st != STATUS_OK && st != STATUS_MEMORY)
            st = refuse(command, word, !table, why);
        TRY(st);
    }
    if (path)
        TRY(read_plan(path, &a->plan, why));
    snprintf(a->folder, sizeof a->folder, "results/%s%s%s", command->name, table ? "" : "_",
             item ? item->name : a->plan.name);
out:
    free(path);
    return st;
}

/* Reads what the ensemble is told, which no other takes. */
static enum status read_choice(const struct command_line *line, struct asked *a,
                               struct message *why)
{
    struct study_ensemble_options *o = &a->options;
    long runs = 0;
    enum status st;

    o->scene = line->words + 1;
    o->scene_count = line->word_count - 1;
    o->models = command_value(line, "--models");
    TRY(command_integer(line, "--runs", 1, 256, &runs, why));
    TRY(command_number(line, "--until", false, &o->until, why));
    o->runs = (int)runs;
    const bool any = o->scene_count || o->models || o->runs || o->until > 0;
    if (any && a->from)
        return status_fail(why, STATUS_INPUT,
                           "scenes, --models, --runs and --until are for a new run, not "
                           "for --from");
    if (any && !a->ensemble)
        return status_fail(why, STATUS_INPUT,
                           "%s takes no scenes, --models, --runs and --until; study "
                           "ensemble does",
                           line->words[0]);
out:
    return st;
}

static enum status read_line(const struct command_line *line, struct asked *a,
                             struct message *why)
{
    const char *folder = NULL;
    enum status st;

    TRY(choose(line, a, why));
    TRY(command_folder(line, &folder, &a->from, why));
    TRY(command_format(line, &a->format, why));
    if (folder)
        snprintf(a->folder, sizeof a->folder, "%s", folder);
    a->options.folder = a->folder;
    a->options.quick = command_given(line, "--quick");
    if (line->command->items == study_items)
        TRY(read_choice(line, a, why));
out:
    return st;
}

/* --- what is done ------------------------------------------------------------------------
 */

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

/* Runs all cases on one thread and one processor: models are compared, not schedulers. The
 * ensemble is not timed and works in processes of its own. */
static enum status measure(const struct asked *a, struct message *why)
{
    const bool quick = a->options.quick;
    struct bar bar = {{0}, NULL};
    const struct measurement_options how = {
        .quick = quick, .progress = show, .context = &bar};
    enum status st;

    TRY(folder_make(a->folder, why));
    if (quick)
        judge_mark(a->folder, true);
    if (!a->ensemble)
        timing_alone();
    TRY(a->ensemble ? study_ensemble_measure(&a->options, why)
                    : study_measure(&a->plan, a->folder, &how, why));
    judge_mark(a->folder, quick);
out:
    progress_end(&bar.progress);
    return st;
}

static enum status print_to(const struct asked *a, const struct study_results *r,
                            enum table_format format, FILE *file, struct message *why)
{
    return a->ensemble ? study_ensemble_print(a->folder, format, file, why)
                       : claim_tell(r, a->folder, format, file, why);
}

/* Prints to standard output, and into the folder what a report reads: always tables and
 * sentences, though machines are printed no sentences. */
static enum status print(const struct command_line *line, const struct asked *a,
                         struct message *why)
{
    const bool prose = table_format_is_prose(a->format);
    struct study_results r = {0};
    struct kept *kept = NULL;
    FILE *nowhere = NULL;
    enum status st = STATUS_OK;

    kept_open(a->folder, line->command->name, line->words[0], &kept);
    if (!a->ensemble)
        TRY(study_read(&a->plan, a->folder, &r, why));
    if (kept && !prose && (nowhere = fopen("/dev/null", "w"))) {
        TRY(print_to(a, &r, TABLE_TEXT, nowhere, why));
        TRY(kept_close(&kept, why));
    }
    TRY(print_to(a, &r, a->format, stdout, why));
    TRY(kept_close(&kept, why));
out:
    if (nowhere)
        fclose(nowhere);
    kept_discard(&kept);
    study_clear(&r);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    struct asked *a = calloc(1, sizeof *a);
    enum status st = a ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(read_line(line, a, why));
    if (!a->from)
        TRY(measure(a, why));
    TRY(print(line, a, why));
out:
    if (a)
        plan_clear(&a->plan);
    free(a);
    return st;
}

enum { ENSEMBLE_OPTIONS = 3 }; /* the first, which tables do not have */
static const struct command_option options[] = {
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

const struct command studies_table_command = {
    .name = "table",
    .summary = "recompute a table of the paper and print its numbers beside ours",
    .arguments = "NUMBER [OPTION]...",
    .text =
        "Runs every case of the table, stores a result file of each and makes the tables\n"
        "from these files. Times are medians of interleaved repeats on one thread.\n",
    .examples =
        "table 1\ntable 1 --quick --format markdown\ntable 1 --from results/table1\n",
    .least = 1,
    .most = 1,
    .options = options + ENSEMBLE_OPTIONS,
    .section = "tables",
    .items = table_items,
    .run = run,
};

const struct command studies_command = {
    .name = "study",
    .summary = "vary the net, the degree or a parameter of a scene",
    .arguments = "NAME|PLAN [SCENE]... [OPTION]...",
    .text =
        "Runs a scene at several levels of one parameter, stores a result file of each\n"
        "and prints from these files how the levels differ, their errors against the\n"
        "truth if there is one, their cost, and whether the paper's statement holds.\n"
        "CSV, plots and pictures go into the folder. Most studies are plans (YAML) with\n"
        "levels. A plan of yours is run and printed in the same way, without a\n"
        "statement; `clothbench help plan` has the keys. Only `study ensemble` takes\n"
        "scenes.\n",
    .examples = "study mesh\nstudy mesh --quick --out mesh\n"
                "study mesh --from results/study_mesh --format csv\nstudy mine.yaml\n"
                "study ensemble flag --models mass_spring_single,triangles_explicit\n",
    .least = 1,
    .most = 1 + STUDIES_SCENES,
    .options = options,
    .section = "studies",
    .items = study_items,
    .run = run,
};
