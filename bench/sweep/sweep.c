#include "bench/sweep/sweep.h"

#include <math.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "bench/sweep/ranks.h"
#include "bench/sweep/sweep_map.h"
#include "bench/sweep/sweep_queue.h"
#include "bench/sweep/sweep_summary.h"
#include "bench/sweep/sweep_table.h"

/* What is done already; true where a case needs no run. */
static enum status scan(const struct plan *plan, const struct sweep_folder *folder,
                        bool **done, struct message *why)
{
    const long count = plan_case_count(plan);
    struct sweep_row row;

    *done = calloc((size_t)count, sizeof **done);
    if (!*done)
        return status_fail(why, STATUS_MEMORY, "%s", status_text(STATUS_MEMORY));
    for (long n = 0; n < count; n++) {
        sweep_folder_read(folder, n, true, &row);
        (*done)[n] = row.there;
    }
    return STATUS_OK;
}

/* Table, seconds and map from the files of the cases. */
static enum status collect(const struct plan *plan, const struct sweep_folder *folder,
                           struct sweep_table *t, struct message *plot, struct message *why)
{
    struct sweep_map *map = NULL;
    struct plan_case c;
    struct sweep_row row;
    char labels[1024];
    enum status st;

    TRY(sweep_table_open(t, plan, folder, why));
    TRY(sweep_map_open(&map, plan, folder, "feasible", why));
    for (long n = 0; n < plan_case_count(plan); n++) {
        sweep_folder_read(folder, n, false, &row);
        if (!row.there)
            TRY(status_fail(why, STATUS_FILE,
                            "%s: the file of case %ld is gone or broken; "
                            "--resume runs it again",
                            folder->path, n + 1));
        const struct verdict verdict = sweep_table_verdict(plan, &row);
        TRY(plan_case_given(plan, n, &c));
        sweep_table_row(t, &c, &row, &verdict);
        sweep_map_row(map, &c, &row,
                      sweep_table_labels(plan, &row, verdict, labels, sizeof labels));
        plan_case_clear(&c);
    }
    TRY(sweep_table_close(t, why));
    struct sweep_map *whole = map;
    map = NULL;
    st = sweep_map_close(whole, plot);
    if (st == STATUS_UNSUPPORTED || st == STATUS_LIBRARY) /* no plot is no harm */
        st = STATUS_OK;
    else if (st != STATUS_OK)
        *why = *plot;
out:
    sweep_map_discard(map);
    sweep_table_discard(t);
    return st;
}

/* A sentence on how to go on, and the end that the signal would have been. */
static void stop(const struct sweep_queue *queue, const char *name)
{
    fprintf(stderr,
            "clothbench: stopped by signal %d after %ld cases; what is done is kept: "
            "clothbench sweep %s --resume goes on\n",
            queue->stopped_by, queue->ran, name);
    signal(queue->stopped_by, SIG_DFL);
    raise(queue->stopped_by);
}

/* The sweep of the process that leads. `name`: of the plan on the command line. */
static enum status lead(const struct plan *plan, const struct sweep_options *options,
                        const struct ranks *ranks, const char *name, FILE *file,
                        struct message *why)
{
    enum status st;
    struct sweep_folder folder = {.lock = -1, .log = -1};
    char path[SWEEP_FOLDER_PATH];
    bool *done = NULL;
    struct sweep_table table = {0};
    struct message plot = {""}, reason = {""};

    snprintf(path, sizeof path, "results/sweep_%s", plan->name);
    TRY(sweep_folder_open(&folder, options->folder ? options->folder : path, plan,
                          options->resume, why));
    TRY(scan(plan, &folder, &done, why));
    struct sweep_queue queue = {
        .plan = plan,
        .folder = &folder,
        .ranks = ranks,
        .jobs = ranks           ? 1
                : options->jobs ? options->jobs
                                : omp_get_num_procs(),
        .done = done,
        .quiet = options->quiet,
    };
    st = sweep_queue_run(&queue, &reason);
    if (st != STATUS_OK)
        TRY(status_fail(why, st,
                        "%s; what is done is kept, and clothbench sweep %s "
                        "--resume goes on",
                        reason.text, name));
    if (queue.stopped_by) {
        free(done);
        stop(&queue, name);
    }
    TRY(collect(plan, &folder, &table, &plot, why));
    if (!options->quiet)
        TRY(sweep_summary_print(plan, &folder, &queue, &table, plot.text, file));
out:
    free(done);
    sweep_folder_close(&folder);
    return st;
}

enum status sweep_run(const struct plan *plan, const struct sweep_options *options,
                      FILE *file, struct message *why)
{
    return lead(plan, options, NULL, plan->path, file, why);
}

static enum status read_options(const struct command_line *line, const struct ranks *ranks,
                                struct sweep_options *o, struct message *why)
{
    long jobs = 0;
    enum status st = command_integer(line, "--jobs", 1, 1024, &jobs, why);

    if (st == STATUS_OK && jobs && ranks)
        st = status_fail(why, STATUS_INPUT,
                         "--jobs: under mpirun every rank runs one case at a time; say "
                         "how many with mpirun -n");
    *o = (struct sweep_options){.folder = command_value(line, "--out"),
                                .resume = command_given(line, "--resume"),
                                .jobs = (int)jobs,
                                .quiet = command_given(line, "--quiet")};
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st;
    const struct ranks *ranks = NULL;
    struct sweep_options options;
    struct plan plan = {0};
    char *path = NULL;

    omp_set_num_threads(1);
    signal(SIGXFSZ, SIG_IGN); /* a limit on file sizes is a full disk, not a death */
    TRY(ranks_start(&ranks, why));
    if (ranks && ranks->rank) { /* rank 0 tells what is wrong, if something is */
        named_file_find(&plan_kind, line->words[0], &path, NULL);
        TRY(sweep_queue_serve(ranks, path ? path : line->words[0], why));
        goto out;
    }
    TRY(read_options(line, ranks, &options, why));
    TRY(named_file_find(&plan_kind, line->words[0], &path, why));
    TRY(plan_read(path, &plan, why));
    if (plan.study_count)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: the plan has levels, so it is no sweep; clothbench study runs "
                        "it",
                        path));
    TRY(lead(&plan, &options, ranks, line->words[0], stdout, why));
out:
    if (ranks && !ranks->rank)
        sweep_queue_dismiss(ranks);
    if (ranks)
        ranks->finish();
    plan_clear(&plan);
    free(path);
    return st;
}

static const struct command_option options[] = {
    {"--resume", NULL, false,
     "go on with what is in the folder: cases that ended are not\nrun again"},
    {"--jobs", "N", false, "cases at a time (as many as there are processors)"},
    {"--out", "DIR", false, "where results go (results/sweep_NAME)"},
    {"--quiet", NULL, false, "no progress bar, no summary"},
    {NULL, NULL, false, NULL},
};

const struct command sweep_command = {
    .name = "sweep",
    .summary = "many cases of one plan: parameter feasibility",
    .arguments = "PLAN [OPTION]...",
    .text =
        "Runs every case of a plan, each in a process of its own, judges them by the\n"
        "plan's rules and leaves one result file a case, table.csv with all keys and\n"
        "measures, and map.png (needs gnuplot). PLAN is a name from clothbench list plans\n"
        "or the path of a YAML file (clothbench help plan). A case that dies, hangs or is\n"
        "refused is a row.\n"
        "\n"
        "Whatever ends a sweep - Ctrl-C, SIGKILL, a full disk -, the cases in flight are\n"
        "lost, no more; --resume goes on. Under mpirun the ranks share the cases; on\n"
        "several machines they must see the same folder.\n",
    .examples = "sweep feasibility\nsweep plan.yaml --jobs 4 --out results/mine\n"
                "sweep feasibility --resume\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
