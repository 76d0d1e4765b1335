#include "bench/sweep/sweep.h"

#include <math.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/looks.h"
#include "bench/harness/pool.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth.h"
#include "models/metric/metric.h"
#include "bench/experiment/plan.h"

/* What the processes of a sweep share. */
struct sweep {
    const char *word; /* the plan, as the command line has it                           */
    struct sweep_options options;
    struct plan own; /* where the command reads it                                      */
    const struct plan *plan;
    struct sweep_folder folder;
    struct pool pool;
};

/* --- A case in its own process. */

/* What is known of a case's scene without a run, and what the case keeps of it: how far it
 * is from that, look by look (LOOKS_TRUTH). */
struct known {
    struct truth made; /* nothing is claimed: no truth is known                   */
    double length;     /* of the scene [m]                                        */
};

/* Fills in the distance and the bar where the truth is known at this time. */
static enum status look(void *context, const struct motion *m, const double *xyz,
                        double *value)
{
    const struct known *truth = context;
    const struct truth *made = &truth->made;
    const int n = truth_index(made, made->claimed, m->time);

    value[LOOKS_TRUTH_ERROR] = n < 0 ? NAN : metric_rmse(xyz, made->xyz[n]) / truth->length;
    value[LOOKS_TRUTH_BAR] = n < 0 ? NAN : made->error[n] / truth->length;
    return STATUS_OK;
}

/* Leaves the file of a case. */
static enum status work(void *context, long number, struct message *why)
{
    const struct sweep *s = context;
    struct plan_case c = {0};
    struct scene scene = {0};
    struct known truth = {{0}};
    struct run_own own[LOOKS_TRUTH];
    char path[SWEEP_FOLDER_PATH], made_for[SWEEP_ROW_MADE_FOR];
    enum status st;

    TRY(plan_case_open(s->plan, number, &c, why));
    TRY(plan_case_scene(&c, &scene, why));
    truth.length = scene.length;
    /* A factor a step is no physics that a truth could have: nothing needs to be read. */
    if (!truth_plan_damping(&scene))
        TRY(truth_judged(&scene, &truth.made, why));
    const struct run_plan run = plan_case_run(&c);
    sweep_folder_file(&s->folder, number, "h5", path);
    sweep_row_made_for(&s->folder, s->plan, &c, made_for);
    struct run_keep keep = {
        .file = path,
        .made_for = made_for,
        .every = s->plan->look ? s->plan->look : 10,
        .times = scene.snapshot_count,
        .time = scene.snapshots,
        .fields = s->plan->keep == PLAN_KEEP_SNAPSHOTS ? RUN_FIELDS_TIMES : RUN_FIELDS_NONE,
        .intersections = s->plan->intersections,
        .own_count = truth.made.claimed ? LOOKS_TRUTH : 0,
        .own = own,
        .own_look = look,
        .context = &truth};
    for (int n = 0; n < LOOKS_TRUTH; n++)
        own[n] = (struct run_own){looks_truth[n], "1"};
    st = run_file_write(&run, &keep, NULL, why);
out:
    truth_clear(&truth.made);
    scene_clear(&scene);
    plan_case_clear(&c);
    return st;
}

static enum status begin(void *context, long number, struct message *why)
{
    const struct sweep *s = context;

    return sweep_folder_log(&s->folder, "start", number, why);
}

/* What the files of a case are made for. */
static enum status find_made_for(const struct sweep *s, long number,
                                 char made_for[SWEEP_ROW_MADE_FOR])
{
    struct plan_case c = {0};
    const enum status st = plan_case_given(s->plan, number, &c);

    if (st == STATUS_OK)
        sweep_row_made_for(&s->folder, s->plan, &c, made_for);
    plan_case_clear(&c);
    return st;
}

/* A case is over: its row is kept, the log has it. */
static enum status settle(void *context, long number, const struct child_end *end,
                          struct message *why)
{
    const struct sweep *s = context;
    char made_for[SWEEP_ROW_MADE_FOR];
    enum status st;

    if (end->outcome == CHILD_DONE)
        return sweep_folder_log(&s->folder, "end", number, why);
    TRY(find_made_for(s, number, made_for));
    TRY(sweep_row_write(&s->folder, number, made_for,
                        end->outcome == CHILD_CUT ? SWEEP_ROW_CUT : SWEEP_ROW_FAILED,
                        end->why.text, why));
    st = sweep_folder_log(&s->folder, "failed", number, why);
out:
    return st;
}

/* The row of a case; one that is of another sweep is refused. */
static enum status read_row(const struct sweep *s, long number, struct sweep_row *row,
                            struct message *why)
{
    char made_for[SWEEP_ROW_MADE_FOR];
    enum status st;

    *row = (struct sweep_row){0};
    TRY(find_made_for(s, number, made_for));
    TRY(sweep_row_read(&s->folder, number, made_for, false, row));
    if (row->state == SWEEP_ROW_FOREIGN)
        st = status_fail(why, STATUS_INPUT, "%s", row->why.text);
out:
    return st;
}

/* What is done already; of what is not, nothing is left. */
static enum status scan(const struct sweep *s, bool **done, struct message *why)
{
    const long count = plan_case_count(s->plan);
    struct sweep_row row;
    enum status st = STATUS_OK;

    *done = calloc((size_t)count, sizeof **done);
    TRY(*done ? STATUS_OK : STATUS_MEMORY);
    for (long n = 0; n < count; n++) {
        TRY(read_row(s, n, &row, why));
        (*done)[n] = !sweep_row_is_open(&row);
        if (!(*done)[n])
            sweep_row_remove(&s->folder, n);
        run_result_clear(&row.result);
    }
out:
    return st;
}

/* Table, seconds, map and what falls from the files of the cases. */
static enum status collect(const struct sweep *s, struct sweep_table *t,
                           struct sweep_falls *falls, struct message *plot,
                           struct message *why)
{
    const struct sweep_folder *folder = &s->folder;
    struct sweep_map *map = NULL;
    struct chart *chart = NULL;
    struct plan_case c = {0};
    struct sweep_row row;
    char labels[1024];
    enum status st;

    TRY(sweep_table_open(t, s->plan, folder, why));
    TRY(sweep_map_create(&map, s->plan, "feasible"));
    for (long n = 0; n < plan_case_count(s->plan); n++) {
        TRY(read_row(s, n, &row, why));
        TRY(plan_case_given(s->plan, n, &c));
        const bool learnt = sweep_table_row(t, &c, &row, labels, sizeof labels);
        st = sweep_map_row(map, &c, &row, labels, learnt);
        sweep_falls_row(falls, n, &row);
        plan_case_clear(&c);
        run_result_clear(&row.result);
        TRY(st);
    }
    TRY(sweep_table_close(t, why));
    TRY(sweep_falls_judge(falls, folder->path, why));
    TRY(sweep_map_chart(map, &chart, why));
    if (chart)
        st = chart_write(chart, folder->path, "map", plot);
    if (st == STATUS_UNSUPPORTED || st == STATUS_LIBRARY) /* no plot is no harm */
        st = STATUS_OK;
    else if (st != STATUS_OK)
        *why = *plot;
out:
    chart_destroy(chart);
    sweep_map_destroy(map);
    sweep_table_discard(t);
    return st;
}

/* Into path[], which it returns, if no folder was asked for. */
static const char *folder_of(const struct sweep *s, char path[SWEEP_FOLDER_PATH])
{
    snprintf(path, SWEEP_FOLDER_PATH, "results/sweep_%s", s->plan->name);
    return s->options.folder ? s->options.folder : path;
}

/* Runs what is not done. */
static enum status run_all(struct sweep *s, struct message *why)
{
    struct pool *pool = &s->pool;
    struct message reason = {""};
    bool *done = NULL;
    enum status st;

    TRY(scan(s, &done, why));
    pool->count = plan_case_count(s->plan);
    pool->done = done;
    pool->time_limit = s->plan->time_limit;
    st = pool_run(pool, &reason);
    if (!pool->ranks || (st == STATUS_OK && !pool->stopped_by)) /* else others still work */
        sweep_folder_tidy(&s->folder);
    if (st != STATUS_OK)
        TRY(status_fail(why, st,
                        "%s; what is done is kept, and clothbench sweep %s "
                        "--resume goes on",
                        reason.text, s->word));
out:
    free(done);
    if (!pool->stopped_by)
        return st;
    fprintf(stderr,
            "clothbench: stopped by signal %d after %ld cases; what is done is kept: "
            "clothbench sweep %s --resume goes on\n",
            pool->stopped_by, pool->ran, s->word);
    pool_raise(pool);
    return st;
}

/* The sweep of the process that leads. */
static enum status lead(struct sweep *s, struct message *why)
{
    const struct sweep_options *o = &s->options;
    char path[SWEEP_FOLDER_PATH];
    struct sweep_table table = {0};
    struct sweep_falls *falls = NULL;
    struct message plot = {""};
    enum status st;

    TRY(sweep_folder_open(&s->folder, folder_of(s, path), s->plan, o->start, why));
    s->pool.slots = s->pool.ranks ? 1 : o->jobs ? o->jobs : omp_get_num_procs();
    s->pool.quiet = o->quiet;
    TRY(run_all(s, why));
    TRY(sweep_falls_create(&falls, s->plan));
    TRY(collect(s, &table, falls, &plot, why));
    if (!o->quiet)
        TRY(sweep_table_print(s->plan, &s->folder, &s->pool, &table, falls, plot.text,
                              stdout));
    TRY(sweep_falls_check(falls, why));
out:
    sweep_falls_destroy(falls);
    sweep_folder_close(&s->folder);
    return st;
}

static struct sweep sweep_of(const char *word)
{
    return (struct sweep){.word = word,
                          .folder = {.lock = -1, .log = -1},
                          .pool = {.work = work, .begin = begin, .settle = settle}};
}

enum status sweep_run(const struct plan *plan, const struct sweep_options *options,
                      struct message *why)
{
    struct sweep s = sweep_of(plan->path);

    s.plan = plan;
    s.options = *options;
    s.pool.context = &s;
    return lead(&s, why);
}

/* On another rank: what it needs for any case. */
static enum status prepare(void *context, struct message *why)
{
    struct sweep *s = context;
    char path[SWEEP_FOLDER_PATH];
    enum status st = plan_read(s->word, &s->own, why);

    if (st != STATUS_OK)
        return st;
    s->pool.time_limit = s->own.time_limit;
    snprintf(s->folder.path, sizeof s->folder.path, "%s", folder_of(s, path));
    return sweep_folder_identify(&s->folder, s->plan, why);
}

static enum status run(const struct command_line *line, struct message *why)
{
    const struct ranks *ranks = NULL;
    struct sweep s = sweep_of(line->words[0]);
    char *path = NULL;
    long jobs = 0;
    enum status st;

    omp_set_num_threads(1);
    signal(SIGXFSZ, SIG_IGN); /* a limit on file sizes is a full disk, not a death */
    TRY(ranks_start(&ranks, why));
    s.plan = &s.own;
    s.pool.context = &s;
    s.pool.ranks = ranks;
    s.options.folder = command_value(line, "--out");
    s.options.start = command_given(line, "--resume") ? SWEEP_RESUME : SWEEP_NEW;
    s.options.quiet = command_given(line, "--quiet");
    if (ranks && ranks->rank) { /* rank 0 tells what is wrong, if something is */
        named_file_find(&plan_kind, s.word, &path, NULL);
        s.word = path ? path : s.word;
        TRY(pool_serve(&s.pool, prepare, why));
        goto out;
    }
    TRY(command_integer(line, "--jobs", 1, 1024, &jobs, why));
    s.options.jobs = (int)jobs;
    if (jobs && ranks)
        TRY(status_fail(why, STATUS_INPUT,
                        "--jobs: under mpirun every rank runs one case at a time; say "
                        "how many with mpirun -n"));
    TRY(named_file_find(&plan_kind, s.word, &path, why));
    TRY(plan_read(path, &s.own, why));
    if (s.own.study_count)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: the plan has levels, so it is no sweep; clothbench study runs "
                        "it",
                        path));
    TRY(lead(&s, why));
out:
    if (ranks && !ranks->rank)
        pool_dismiss(ranks);
    if (ranks)
        ranks->finish();
    plan_clear(&s.own);
    free(path);
    return st;
}

#define SWEEP_PLAN                                                                         \
    "    name: mine\n"                                                                     \
    "    source: how stretch and drop depend on stiffness and weight\n"                    \
    "    scene: edge_drop\n"                                                               \
    "    model: mass_spring\n"                                                             \
    "    axes:\n"                                                                          \
    "      - {key: material.young, values: [5e4, 1e5]}\n"                                  \
    "      - {key: material.density, values: [0.3, 0.5, 0.7]}\n"

static const struct command_option options[] = {
    {"--resume", NULL, false,
     "continue with what is in the folder; cases that ended\n"
     "are not repeated"},
    {"--jobs", "N", false, "cases that run at a time (the number of processors)"},
    {"--out", "DIR", false, "folder of the results (results/sweep_NAME)"},
    {"--quiet", NULL, false, "print no progress bar and no summary"},
    {NULL, NULL, false, NULL},
};

const struct command sweep_command = {
    .name = "sweep",
    .summary = "run many cases of one plan: which parameters give cloth?",
    .arguments = "PLAN [OPTION]...",
    .text =
        "Runs every case of a plan, each in a process of its own, judges them by the\n"
        "plan's rules, and writes one result file a case, table.csv with all keys and\n"
        "measures, and map.png (needs gnuplot). PLAN is feasibility, table4, refinement,\n"
        "refinement_nets, remedies or a YAML file; the other plans of `clothbench list\n"
        "plans` have levels and are for `clothbench study`. A case that dies, hangs or\n"
        "is refused is a row, too. If the plan names a measure that has to fall along an\n"
        "axis (refinement, remedies), falls.csv lists it, and the exit code is 1 where\n"
        "it grows. This plan has two by three cases; `clothbench help plan` has all\n"
        "keys:\n"
        "\n" SWEEP_PLAN "\n"
        "Ctrl-C, SIGKILL or a full disk cost only the cases that are running; --resume\n"
        "continues. It repeats cases that were killed or suspended, ran out of memory,\n"
        "or have a damaged file, and refuses files of another plan or of another build\n"
        "of the program. Under mpirun the ranks share the cases; on several machines\n"
        "they need the same folder.\n",
    .examples = "sweep feasibility\nsweep mine.yaml --jobs 4 --out results/mine\n"
                "sweep feasibility --resume\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
