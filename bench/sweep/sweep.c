#include "bench/sweep/sweep.h"

#include <math.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/harness/pool.h"
#include "bench/harness/run_file.h"
#include "bench/sweep/sweep_map.h"
#include "bench/sweep/sweep_table.h"
#include "bench/experiment/plan_read.h"

/* What the processes of a sweep share. */
struct sweep {
    const char *word; /* the plan, as the command line has it                           */
    struct sweep_options options;
    struct plan own; /* where the command reads it                                      */
    const struct plan *plan;
    struct sweep_folder folder;
    struct pool pool;
};

/* A case in its own process, which leaves its file. */
static enum status work(void *context, long number, struct message *why)
{
    const struct sweep *s = context;
    struct plan_case c = {0};
    struct scene scene = {0};
    char path[SWEEP_FOLDER_PATH];
    enum status st;

    TRY(plan_case_open(s->plan, number, &c, why));
    TRY(plan_case_scene(&c, &scene, why));
    const struct run_plan run = plan_case_run(&c);
    sweep_folder_file(&s->folder, number, "h5", path);
    st = run_file_write(&run,
                        &(struct run_keep){.file = path,
                                           .every = s->plan->look,
                                           .times = scene.snapshot_count,
                                           .time = scene.snapshots,
                                           .fields = s->plan->keep == PLAN_KEEP_SNAPSHOTS
                                                         ? RUN_FIELDS_TIMES
                                                         : RUN_FIELDS_NONE,
                                           .intersections = s->plan->intersections},
                        NULL, why);
out:
    scene_clear(&scene);
    plan_case_clear(&c);
    return st;
}

static enum status begin(void *context, long number, struct message *why)
{
    const struct sweep *s = context;

    return sweep_folder_log(&s->folder, "start", number, why);
}

/* A case is over: its row is kept, the log has it. */
static enum status settle(void *context, long number, const struct child_end *end,
                          struct message *why)
{
    const struct sweep *s = context;
    const bool failed = end->outcome == CHILD_FAILED;
    enum status st = STATUS_OK;

    if (failed)
        st = sweep_folder_fail(&s->folder, number, end->why.text, why);
    return st ? st : sweep_folder_log(&s->folder, failed ? "failed" : "end", number, why);
}

/* What is done already; true where a case needs no run. */
static enum status scan(const struct sweep *s, bool **done, struct message *why)
{
    const long count = plan_case_count(s->plan);
    struct sweep_row row;

    *done = calloc((size_t)count, sizeof **done);
    if (!*done)
        return status_fail(why, STATUS_MEMORY, "%s", status_text(STATUS_MEMORY));
    for (long n = 0; n < count; n++) {
        sweep_folder_read(&s->folder, n, true, &row);
        (*done)[n] = row.there;
        run_result_clear(&row.result);
    }
    return STATUS_OK;
}

/* Table, seconds and map from the files of the cases. */
static enum status collect(const struct plan *plan, const struct sweep_folder *folder,
                           struct sweep_table *t, struct message *plot, struct message *why)
{
    struct sweep_map *map = NULL;
    struct chart *chart = NULL;
    struct plan_case c;
    struct sweep_row row;
    char labels[1024];
    enum status st;

    TRY(sweep_table_open(t, plan, folder, why));
    TRY(sweep_map_create(&map, plan, "feasible"));
    for (long n = 0; n < plan_case_count(plan); n++) {
        sweep_folder_read(folder, n, false, &row);
        if (!row.there)
            TRY(status_fail(why, STATUS_FILE,
                            "%s: the file of case %ld is gone or broken; "
                            "--resume runs it again",
                            folder->path, n + 1));
        TRY(plan_case_given(plan, n, &c));
        sweep_table_row(t, &c, &row, labels, sizeof labels);
        st = sweep_map_row(map, &c, &row, labels);
        plan_case_clear(&c);
        run_result_clear(&row.result);
        TRY(st);
    }
    TRY(sweep_table_close(t, why));
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

static void print_plan(const struct plan *plan, FILE *file)
{
    const struct plan_setting *scene = plan_settings_find(&plan->settings, "scene");

    fprintf(file, "%s: %ld cases", plan->name, plan_case_count(plan));
    if (scene)
        fprintf(file, " of %s", scene->value);
    if (plan->listed_count)
        fprintf(file, "; %d listed", plan->listed_count);
    for (int n = 0; n < plan->axis_count; n++)
        fprintf(file, "%s%d of %s", n || plan->listed_count ? " x " : "; ",
                plan->axes[n].values.count, plan->axes[n].key);
    fprintf(file, "\n\n");
}

/* Whether a rule before n has the same label. */
static bool said(const struct verdict_rules *rules, int n)
{
    for (int m = 0; m < n; m++)
        if (!strcmp(rules->rule[m].label, rules->rule[n].label))
            return true;
    return false;
}

/* How many cases have a label; what was not measured is not counted as passed. */
static void print_label(const struct verdict_rules *rules, int n,
                        const struct sweep_table *t, FILE *file)
{
    const char *label = rules->rule[n].label;

    if (t->lacking[n] && t->lacking[n] == t->judged)
        fprintf(file, "  %-24s not judged: it was not measured\n", label);
    else if (t->lacking[n])
        fprintf(file, "  %-24s%6ld   not judged in %ld more, where it was not measured\n",
                label, t->labels[n], t->lacking[n]);
    else
        fprintf(file, "  %-24s%6ld\n", label, t->labels[n]);
}

/* Those of which there are none are not worth a line, but for labels. */
static void print_verdicts(const struct plan *plan, const struct sweep_table *t, FILE *file)
{
    const struct verdict_rules *rules = &plan->verdicts;
    const struct {
        const char *end, *why;
        long count;
    } ends[] = {
        {"not judged", "no label, but not all could be asked for", t->unjudged},
        {"died", "the numerics ended the run", t->died},
        {"unsupported", "the model leaves something out", t->unsupported},
        {"no result", "timed out, killed or refused: see table.csv", t->failed},
    };

    if (rules->count)
        fprintf(file, "  %-24s%6ld\n", "feasible", t->feasible);
    for (int n = 0; n < rules->count; n++)
        if (!said(rules, n))
            print_label(rules, n, t, file);
    for (size_t n = 0; n < sizeof ends / sizeof *ends; n++)
        if (ends[n].count)
            fprintf(file, "  %-24s%6ld   %s\n", ends[n].end, ends[n].count, ends[n].why);
    fprintf(file, "\n");
}

/* Of a result file on average [kB]. */
static double file_size(const struct sweep_folder *folder, long cases)
{
    double sum = 0;
    long count = 0;

    for (long n = 0; n < cases; n++) {
        char path[SWEEP_FOLDER_PATH];
        struct stat info;

        sweep_folder_file(folder, n, "h5", path);
        if (stat(path, &info) == 0)
            sum += 1e-3 * (double)info.st_size, count++;
    }
    return count ? sum / (double)count : 0;
}

static void print_cost(const struct pool *p, FILE *file)
{
    const double most = p->wall * p->hands;

    if (!p->ran) {
        fprintf(file, "Nothing was left to run.\n");
        return;
    }
    fprintf(file,
            "%ld cases run now, %d at a time: %.3g s of processor time each, %.4g s in all "
            "within %.4g s; efficiency %.1f %%.\n",
            p->ran, p->hands, p->seconds / (double)p->ran, p->seconds, p->wall,
            100 * p->seconds / most);
}

/* What a sweep found, in words for people. `plot`: why there is no picture, or "". */
static enum status print_summary(const struct sweep *s, const struct sweep_table *table,
                                 const char *plot)
{
    const struct plan *plan = s->plan;
    FILE *file = stdout;

    print_plan(plan, file);
    print_verdicts(plan, table, file);
    print_cost(&s->pool, file);
    fprintf(file, "%s: table.csv, seconds.csv, %sa file a case, %.3g kB on average.\n",
            s->folder.path, plan->map.x && !*plot ? "map.png, " : "",
            file_size(&s->folder, plan_case_count(plan)));
    if (*plot)
        fprintf(file, "%s\n", plot);
    return ferror(file) ? STATUS_FILE : STATUS_OK;
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
    struct message plot = {""};
    enum status st;

    TRY(sweep_folder_open(&s->folder, folder_of(s, path), s->plan, o->start, why));
    s->pool.slots = s->pool.ranks ? 1 : o->jobs ? o->jobs : omp_get_num_procs();
    s->pool.quiet = o->quiet;
    TRY(run_all(s, why));
    TRY(collect(s->plan, &s->folder, &table, &plot, why));
    if (!o->quiet)
        TRY(print_summary(s, &table, plot.text));
out:
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
    return STATUS_OK;
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
