#include "bench/sweep/sweep.h"

#include <math.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/measurement.h"
#include "bench/files/seal.h"
#include "bench/truth/truth.h"
#include "models/metric/metric.h"

/* A sweep, as all of its processes know it. */
struct sweep {
    const char *word; /* the plan, as the command line has it                           */
    const char *out;  /* the folder that was asked for; NULL: results/sweep_NAME        */
    bool quiet;
    struct plan plan;
    struct sweep_folder folder;
    unsigned long program; /* case_program                                       */
    struct pool pool;
};

/* --- a case in its own process ----------------------------------------------------------
 */

/* A case as it is run, or looked for in the folder. */
struct opened {
    struct plan_case c;
    struct run run;     /* read, with its scene                                         */
    struct truth truth; /* of its scene; it claims nothing where none is known, or read  */
    char path[SWEEP_FOLDER_PATH], key[CASE_KEY];
};

/* Finds the distance from the truth, look by look. */
static void look(const void *context, double time, const double *xyz, double *error,
                 double *bar)
{
    const struct opened *o = context;
    const struct truth *made = &o->truth;
    const int n = truth_index(made, made->claimed, time);

    *error = n < 0 ? NAN : metric_rmse(xyz, made->xyz[n]) / o->run.scene.length;
    *bar = n < 0 ? NAN : made->error[n] / o->run.scene.length;
}

/* Adds the stored truth of a scene, if there is one, to a sum: its cases keep their
 * distance from it. Its beginning, where it is sealed, is enough. */
static unsigned long add_truth(unsigned long sum, const struct scene *scene)
{
    char *path = NULL, *bytes = NULL;
    size_t size;

    if (named_file_find(&truth_file_kind, scene->name, &path, NULL) == STATUS_OK &&
        named_file_read(&truth_file_kind, path, &bytes, &size, NULL) == STATUS_OK)
        sum = seal_text_sum(sum, bytes, size);
    free(path);
    free(bytes);
    return sum;
}

/* Errors as plan_case_open; close it in any case. */
static enum status open_case(const struct sweep *s, long number, struct opened *o,
                             struct message *why)
{
    unsigned long sum;
    enum status st;

    *o = (struct opened){.key = "not read"};
    TRY(plan_case_open(&s->plan, number, &o->c, why));
    TRY(run_read(&o->run, &o->c.run, why));
    sweep_folder_file(&s->folder, number, "h5", o->path);
    o->c.run.keep = (struct run_keep){
        .file = strdup(o->path),
        .every = s->plan.look ? s->plan.look : 10,
        .times = o->run.scene.snapshot_count,
        .time = o->run.scene.snapshots,
        .fields = s->plan.keep == PLAN_KEEP_SNAPSHOTS ? RUN_FIELDS_TIMES : RUN_FIELDS_NONE,
        .intersections = s->plan.intersections,
        .made_for = o->key};
    sum = seal_text_sum(s->program, &s->plan.time_limit, sizeof s->plan.time_limit);
    case_key(&o->c.run, &o->run.scene, add_truth(sum, &o->run.scene), o->key);
out:
    return st;
}

static void close_case(struct opened *o)
{
    truth_clear(&o->truth);
    run_close(&o->run);
    plan_case_clear(&o->c);
}

/* Runs a case and leaves its file. */
static enum status work(void *context, long number, struct message *why)
{
    struct opened o;
    enum status st;

    TRY(open_case(context, number, &o, why));
    /* A factor a step is no physics that a truth could have: nothing needs to be read. */
    if (!truth_plan_damping(&o.run.scene))
        TRY(truth_judged(&o.run.scene, &o.truth, why));
    o.c.run.keep.truth = o.truth.claimed ? look : NULL;
    o.c.run.keep.context = &o;
    st = run_file_make(&o.c.run, &o.run, NULL, why);
out:
    close_case(&o);
    return st;
}

/* Keeps why a case came to no result. */
static enum status settle(void *context, long number, const struct child_end *end,
                          struct message *why)
{
    const struct sweep *s = context;
    struct opened o;
    enum status st = STATUS_OK;

    if (end->outcome == CHILD_DONE)
        return st;
    open_case(s, number, &o, NULL);
    st = sweep_folder_write(&s->folder, number, o.key, end->outcome == CHILD_CUT,
                            end->why.text, why);
    close_case(&o);
    return st;
}

/* --- the process that leads -------------------------------------------------------------
 */

/* Finds the cases that are done, and removes the files of the others. STATUS_MEMORY. */
static enum status scan(const struct sweep *s, bool *done)
{
    struct run_result result;
    struct message sentence;
    enum sweep_state state;
    struct opened o;
    enum status st = STATUS_OK;

    for (long n = 0; n < plan_case_count(&s->plan) && st == STATUS_OK; n++) {
        if (!sweep_folder_has(&s->folder, n))
            continue;
        open_case(s, n, &o, NULL);
        st = sweep_folder_read(&s->folder, n, o.key, false, &state, &result, &sentence);
        done[n] = state != SWEEP_OPEN;
        if (!done[n])
            sweep_folder_remove(&s->folder, n);
        run_result_clear(&result);
        close_case(&o);
    }
    return st;
}

/* Returns the folder that was asked for, or else the usual one in path[]. */
static const char *folder_of(const struct sweep *s, char path[SWEEP_FOLDER_PATH])
{
    snprintf(path, SWEEP_FOLDER_PATH, "results/sweep_%s", s->plan.name);
    return s->out ? s->out : path;
}

/* Runs the cases that are not done. */
static enum status run_all(struct sweep *s, struct message *why)
{
    struct pool *pool = &s->pool;
    struct message reason = {""};
    bool *done = NULL;
    enum status st;

    pool->count = plan_case_count(&s->plan);
    done = calloc((size_t)pool->count, sizeof *done);
    TRY(done ? STATUS_OK : STATUS_MEMORY);
    TRY(scan(s, done));
    pool->done = done;
    pool->time_limit = s->plan.time_limit;
    st = pool_run(pool, &reason);
    if (!pool->ranks || (st == STATUS_OK && !pool->stopped_by)) /* else others still work */
        sweep_folder_tidy(&s->folder);
    if (st != STATUS_OK)
        TRY(status_fail(why, st,
                        "%s; what is done is kept, and clothbench sweep %s goes on",
                        reason.text, s->word));
out:
    free(done);
    if (!pool->stopped_by)
        return st;
    fprintf(stderr,
            "clothbench: stopped by signal %d after %ld cases; what is done is kept: "
            "clothbench sweep %s goes on\n",
            pool->stopped_by, pool->ran, s->word);
    pool_raise(pool);
    return st;
}

static void print_cost(const struct sweep *s)
{
    const struct pool *p = &s->pool;

    if (p->ran)
        printf("%ld cases run now, %d at a time: %.3g s of processor time each, %.4g s in "
               "all within %.4g s; efficiency %.1f %%.\n",
               p->ran, p->hands, p->seconds / (double)p->ran, p->seconds, p->wall,
               100 * p->seconds / (p->wall * p->hands));
    else
        printf("Nothing was left to run.\n");
    printf("%s: table.csv, a file a case; clothbench report %s draws them.\n",
           s->folder.path, s->folder.path);
}

/* Writes the table from the files of the cases, and prints a summary. */
static enum status collect(const struct sweep *s, struct message *why)
{
    struct printer p = {TABLE_TEXT, s->quiet ? NULL : stdout, s->folder.path};
    struct sweep_rows rows = {0};
    enum status st;

    TRY(sweep_rows_read(&rows, &s->plan, &s->folder));
    TRY(sweep_rows_save(&rows, &p, why));
    if (!s->quiet)
        sweep_rows_print(&rows, stdout);
    if (!s->quiet)
        print_cost(s);
    TRY(ferror(stdout) ? STATUS_FILE : STATUS_OK);
out:
    arena_clear(&rows.arena);
    return st;
}

static enum status lead(struct sweep *s, struct message *why)
{
    char path[SWEEP_FOLDER_PATH];
    enum status st;

    TRY(sweep_rows_check(&s->plan, why));
    s->program = case_program(false);
    TRY(sweep_folder_open(&s->folder, folder_of(s, path), why));
    s->pool.quiet = s->quiet;
    TRY(run_all(s, why));
    st = collect(s, why);
out:
    return st;
}

/* Reads, on another rank, what it needs for any case. */
static enum status prepare(void *context, struct message *why)
{
    struct sweep *s = context;
    char path[SWEEP_FOLDER_PATH];
    const enum status st = plan_read(s->word, &s->plan, why);

    if (st != STATUS_OK)
        return st;
    s->pool.time_limit = s->plan.time_limit;
    snprintf(s->folder.path, sizeof s->folder.path, "%s", folder_of(s, path));
    s->program = case_program(false);
    return st;
}

static enum status run(struct command_line *line, struct message *why)
{
    struct sweep s = {.word = line->words[0],
                      .out = command_value(line, "--out"),
                      .quiet = command_given(line, "--quiet"),
                      .folder = {.lock = -1},
                      .pool = {.work = work, .settle = settle}};
    const struct ranks *ranks = NULL;
    char *path = NULL;
    long jobs = 0;
    enum status st;

    omp_set_num_threads(1);
    signal(SIGXFSZ, SIG_IGN); /* a limit on file sizes is a full disk, not a death */
    TRY(ranks_start(&ranks, why));
    s.pool.context = &s;
    s.pool.ranks = ranks;
    if (ranks && ranks->rank) { /* rank 0 tells what is wrong, if something is */
        named_file_find(&plan_kind, s.word, &path, NULL);
        s.word = path ? path : s.word;
        TRY(pool_serve(&s.pool, prepare, why));
        goto out;
    }
    TRY(command_integer(line, "--jobs", 1, 1024, &jobs, why));
    s.pool.slots = ranks ? 1 : jobs ? (int)jobs : omp_get_num_procs();
    if (jobs && ranks)
        TRY(status_fail(why, STATUS_INPUT,
                        "--jobs: under mpirun every rank runs one case at a time; say "
                        "how many with mpirun -n"));
    TRY(named_file_find(&plan_kind, s.word, &path, why));
    TRY(plan_read(path, &s.plan, why));
    if (plan_is_study(&s.plan))
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: the plan has times, so it is no sweep; clothbench study runs "
                        "it",
                        path));
    TRY(lead(&s, why));
out:
    sweep_folder_close(&s.folder);
    if (ranks && !ranks->rank)
        pool_dismiss(ranks);
    if (ranks)
        ranks->finish();
    plan_clear(&s.plan);
    free(path);
    return st;
}

#define SWEEP_PLAN                                                                         \
    "    name: mine\n"                                                                     \
    "    source: how stretch and drop depend on stiffness and weight\n"                    \
    "    scene: edge_drop\n"                                                               \
    "    model: mass_spring\n"                                                             \
    "    axes:\n"                                                                          \
    "      material.young: [5e4, 1e5]\n"                                                   \
    "      material.density: [0.3, 0.5, 0.7]\n"

static const struct command_option options[] = {
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
        "plan's rules, and writes one result file a case and table.csv with all keys and\n"
        "measures, which `clothbench report` draws as a map: the last axis along x, the\n"
        "one before it along y, and a panel for each case of the others. PLAN is\n"
        "feasibility, stability, table4, refinement, refinement_nets, remedies or a YAML\n"
        "file; the other plans of `clothbench list plans` have times and are for\n"
        "`clothbench study`. A case that\n"
        "dies, hangs or is refused is a row, too. This plan has two by three cases;\n"
        "`clothbench help plan` has all keys:\n"
        "\n" SWEEP_PLAN "\n"
        "Ctrl-C, SIGKILL or a full disk cost only the cases that are running. The same\n"
        "command continues: it repeats cases that were killed or suspended, ran out of\n"
        "memory, or have a damaged file, and those whose scene, settings or models'\n"
        "sources are not what they were. Under mpirun the ranks share the cases; on\n"
        "several machines they need the same folder.\n",
    .examples = "sweep feasibility\nsweep mine.yaml --jobs 4 --out results/mine\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
