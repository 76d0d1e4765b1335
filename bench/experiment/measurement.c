#include "bench/experiment/measurement.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/files/seal.h"
#include "bench/files/store.h"
#include "bench/harness/deadline.h"
#include "bench/harness/timing.h"
#include "bench/experiment/bench_solid.h"
#include "bench/ui/progress.h"
#include "bench/data/printer.h"
#include "bench/truth/truth.h"
#include "models/metric/metric.h"

/* Frames of a repeat, where a frame costs the same all along the motion. */
enum { FRAMES = 20, QUICK_FRAMES = 5, WARMUP = 2 };

/* Seconds of cases that are timed in turn, and their share of the rest of a budget. */
static const double GROUP = 10, GROUP_SHARE = 0.1;

/* A case that is being measured. */
struct job {
    struct case_plan c; /* as asked, with its key and whether it is quick; borrows       */
    struct run run;     /* read for the key; the model is built when its turn comes      */
    struct motion motion;
    struct run_file *file;
    char key[CASE_KEY];
    struct timing_case *timing; /* NULL: it is not timed                                */
};

/* Frees the state of a case that waits to be timed, which takes fresh ones. */
static enum status put_away(struct job *j, struct message *why)
{
    const enum status st = run_file_end(j->file, why);

    model_destroy(j->run.model, j->run.state);
    j->run.state = j->motion.state = NULL;
    return st;
}

/* Returns whether a case is timed; one that died in its first frames has nothing to be
 * timed. */
static bool is_timed(const struct job *j)
{
    return j->file && !run_file_refused(j->file) && j->c.timed != CASE_UNTIMED &&
           (j->c.rest || j->motion.frames > WARMUP);
}

/* Returns whether frames cost more at some times of a motion than at others. */
static bool is_uneven(const struct job *j)
{
    return j->run.discretization.kinematics == KINEMATICS_NONLINEAR ||
           scene_needs(&j->run.scene) & SCENE_NEED_CONTACT;
}

/* Plans how many frames of a case are timed. */
static void plan_frames(const struct measurement_options *options, const struct job *j,
                        struct timing_case *t)
{
    const bool some = j->c.timed == CASE_SOME || (j->c.timed == CASE_FAIR && !is_uneven(j));
    const int wanted = options->quick ? QUICK_FRAMES : FRAMES;
    const int lived = j->motion.frames;

    *t = (struct timing_case){
        .run = &j->run, .rest = j->c.rest, .repeats = j->c.repeats, .until = j->c.until};
    t->warmup = some ? WARMUP : 0;
    t->frames = some ? (int)fmin(wanted, lived - t->warmup) : lived;
}

static enum status store_phases(const struct measurement_options *options, struct job *j,
                                struct message *why)
{
    static const char *const name[BENCH_SOLID_FRAME] = {"assemble", "factor", "solve"};
    const int repeats = options->quick ? TIMING_REPEATS_QUICK : TIMING_REPEATS;
    double seconds[TIMING_REPEATS];
    struct run fresh = j->run;
    enum status st;

    fresh.state = NULL;
    TRY(run_build(&fresh, why));
    for (int p = 0; p < BENCH_SOLID_FRAME && st == STATUS_OK; p++) {
        st = bench_solid_time(fresh.state, p, repeats, seconds);
        if (st == STATUS_OK)
            st = run_file_seconds(j->file, name[p], seconds, repeats, 0, why);
    }
out:
    model_destroy(fresh.model, fresh.state);
    return status_is_death(st) ? STATUS_OK : st;
}

static enum status store_times(const struct measurement_options *options, struct job *j,
                               const double together[2], struct message *why)
{
    const struct timing_case *t = j->timing;
    enum status st = STATUS_OK;

    if (!t)
        return STATUS_OK;
    CALL(run_file_seconds(j->file, "create", t->create, t->repeats, 0, why));
    CALL(run_file_seconds(j->file, t->rest ? "equilibrium" : "advance", t->advance,
                          t->repeats, t->frames, why));
    CALL(run_file_bytes(j->file, t->bytes, why));
    CALL(run_file_seconds(j->file, "timed", &together[0], 1, 0, why));
    CALL(run_file_seconds(j->file, "processor", &together[1], 1, 0, why));
    if (j->c.phases)
        st = store_phases(options, j, why);
    return st;
}

/* --- files of an earlier call -----------------------------------------------------------
 */

static bool is_kept(const struct case_plan *c)
{
    struct run_result r SCOPED(run_result_clear) = {0};
    const bool kept = run_result_read(c->keep.file, false, &r, NULL) == STATUS_OK &&
                      !strcmp(r.made_for, c->keep.made_for);

    return kept;
}

void measurement_tell(const char *what, const struct measurement_taken *taken,
                      const char *folder)
{
    if (taken->taken)
        fprintf(stderr, "%s: %d of %d cases were taken from %s\n", what ? what : "runs",
                taken->taken, taken->cases, folder);
}

/* Adds the stored truth of a scene, if there is one, to a sum: its cases keep their
 * distance from it. Its beginning, where it is sealed, is enough. */
static unsigned long add_truth(unsigned long sum, const struct scene *scene)
{
    char *path = NULL, *bytes = NULL;
    size_t size;

    if (named_file_find(&truth_file_kind, scene->name, &path, NULL) == STATUS_OK &&
        named_file_read(&truth_file_kind, path, &bytes, &size, NULL) == STATUS_OK)
        sum = seal_sum(sum, bytes, size);
    free(path);
    free(bytes);
    return sum;
}

/* Reads the scene of a case and finds its key. */
static enum status open_job(const struct measurement_options *o, struct job *j,
                            struct message *why)
{
    struct run_keep *keep = &j->c.keep;
    unsigned long sum = case_program(j->c.timed != CASE_UNTIMED);

    j->c.until = o->until;
    keep->quick = o->quick;
    CALL(run_read(&j->run, &j->c, why));
    if (keep->times < 0)
        keep->times = j->run.scene.snapshot_count, keep->time = j->run.scene.snapshots;
    if (o->pool)
        sum = seal_sum(sum, &o->pool->time_limit, sizeof o->pool->time_limit);
    case_key(&j->c, &j->run.scene, o->truth ? add_truth(sum, &j->run.scene) : sum, j->key);
    keep->made_for = j->key;
    return STATUS_OK;
}

/* Reads the scenes, and marks the cases that are done, whose files are there. */
static enum status take(const struct measurement_options *o, int count,
                        struct case_plan *cases, struct job *jobs, struct message *why)
{
    struct measurement_taken here = {0, count};
    enum status st = STATUS_OK;

    for (int n = 0; n < count; n++) {
        struct job *j = &jobs[n];
        j->c = cases[n];
        st = open_job(o, j, why);
        if (st == STATUS_INPUT && o->pool) { /* whoever reads the results finds out why */
            remove(j->c.keep.file);
            st = STATUS_OK, cases[n].done = true;
            continue;
        }
        CALL(st);
        cases[n].done = !o->again && is_kept(&j->c);
        if (cases[n].done)
            run_close(&j->run);
        here.taken += cases[n].done;
    }
    if (o->taken)
        o->taken->taken += here.taken, o->taken->cases += count;
    return STATUS_OK;
}

/* --- in groups ---------------------------------------------------------------------------
 */

/* One progress bar for all: a case counts for its followed run and for its repeats. */
struct bar {
    const struct measurement_options *options;
    struct progress progress;
    int before;
};

static void report(void *context, int done, int total)
{
    struct bar *bar = context;

    (void)total;
    progress_update(&bar->progress, bar->before + done);
}

static enum status time_all(struct bar *bar, int count, struct job *jobs,
                            struct message *why)
{
    const struct measurement_options *options = bar->options;
    struct arena arena = {0};
    struct timing_case *timing = arena_take(&arena, (size_t)count, sizeof *timing);
    const struct timing_plan plan = {
        .quick = options->quick, .progress = report, .context = bar};
    enum status st;
    int timed = 0;

    for (int n = 0; n < count; n++)
        if (is_timed(&jobs[n])) {
            jobs[n].timing = &timing[timed];
            plan_frames(options, &jobs[n], &timing[timed++]);
        }
    const double start = clock_now(), processor = clock_processor();
    TRY(timing_run(&plan, timed, timing, why));
    const double together[2] = {clock_now() - start, clock_processor() - processor};
    for (int n = 0; n < count; n++)
        TRY(store_times(options, &jobs[n], together, why));
out:
    for (int n = 0; n < timed; n++)
        timing_clear(&timing[n]);
    for (int n = 0; n < count; n++)
        jobs[n].timing = NULL;
    arena_clear(&arena);
    return st;
}

/* Predicts the seconds that timing a followed case will take. */
static double expected(const struct measurement_options *o, const struct job *j)
{
    struct timing_case t;
    double seconds = j->run.create_seconds;

    if (!is_timed(j))
        return 0;
    plan_frames(o, j, &t);
    for (int n = 0; n < t.warmup + t.frames; n++)
        seconds += j->motion.seconds[n];
    return seconds * (t.repeats ? t.repeats : timing_repeats(seconds, o->quick));
}

/* Follows cases from `*next` on, until enough are together, times them and completes their
 * files. */
static enum status run_group(struct bar *bar, int count, struct case_plan *cases,
                             struct job *jobs, int *next, struct message *why)
{
    const double start = clock_now(), until = bar->options->until,
                 room = fmin(GROUP, GROUP_SHARE * deadline_left(until));
    const int first = *next;
    int followed = 0;
    double timing = 0;

    for (; *next < count && (*next == first || clock_now() - start + timing < room);
         ++*next) {
        struct job *j = &jobs[*next];
        if (cases[*next].done)
            continue;
        CALL(run_file_follow(&j->c, &j->run, &j->motion, &j->file, why));
        CALL(put_away(j, why));
        timing += expected(bar->options, j);
        report(bar, ++followed, 0);
    }
    bar->before += followed;
    CALL(time_all(bar, *next - first, &jobs[first], why));
    bar->before += TIMING_REPEATS * followed;
    for (int n = first; n < *next; n++) {
        struct run_file *file = jobs[n].file;
        jobs[n].file = NULL;
        if (file)
            CALL(run_file_close(file, jobs[n].motion.model ? &jobs[n].motion : NULL, NULL,
                                why));
        cases[n].done = true;
    }
    return STATUS_OK;
}

/* --- without timing ----------------------------------------------------------------------
 */

/* Cases whose time nobody asks for, which share the processors. */
struct untimed {
    struct bar *bar;
    struct job *jobs;
};

/* A truth, and the length of its sheet [m]. */
struct known {
    struct truth truth;
    double length;
};

/* Finds the distance from the truth, look by look. */
static void look(const void *context, double time, const double *xyz, double *error,
                 double *bar)
{
    const struct known *k = context;
    const int n = truth_index(&k->truth, k->truth.claimed, time);

    *error = n < 0 ? NAN : metric_rmse(xyz, k->truth.xyz[n]) / k->length;
    *bar = n < 0 ? NAN : k->truth.error[n] / k->length;
}

static enum status follow(void *context, long n, struct message *why)
{
    const struct untimed *u = context;
    struct job *j = &u->jobs[n];
    struct known known = {.length = j->run.scene.length};
    enum status st = STATUS_OK;

    timing_apart();
    /* A factor a step is no physics that a truth could have: nothing needs to be read. */
    if (u->bar->options->truth && !truth_plan_damping(&j->run.scene))
        TRY(truth_judged(&j->run.scene, &known.truth, why));
    j->c.keep.truth = known.truth.claimed ? look : NULL;
    j->c.keep.context = &known;
    st = run_file_make(&j->c, &j->run, NULL, why);
out:
    truth_clear(&known.truth);
    return st;
}

static enum status settle(void *context, long n, const struct child_end *end,
                          struct message *why)
{
    const struct untimed *u = context;
    struct job *j = &u->jobs[n];

    u->bar->before += TIMING_REPEATS + 1;
    report(u->bar, 0, 0);
    if (end->outcome == CHILD_DONE)
        return STATUS_OK;
    if (!u->bar->options->pool)
        return status_fail(why, STATUS_LIBRARY, "%s: %s", j->c.keep.file, end->why.text);
    j->c.keep.made_for = end->outcome == CHILD_CUT ? NULL : j->key;
    return run_file_lost(&j->c, &j->run, &end->why, why);
}

/* Removes what killed processes left beside a file. */
static void tidy(const char *file)
{
    const char *slash = file ? strrchr(file, '/') : NULL;
    char folder[4096];

    if (slash && snprintf(folder, sizeof folder, "%.*s", (int)(slash - file), file) <
                     (int)sizeof folder)
        folder_tidy(folder);
}

/* Follows the cases that are not done and are not timed, each in a process of its own. */
static enum status run_untimed(struct bar *bar, int count, struct case_plan *cases,
                               struct job *jobs, struct message *why)
{
    struct untimed u = {bar, jobs};
    struct arena arena = {0};
    bool *done = arena_take(&arena, (size_t)count, sizeof *done);
    struct pool own = {.slots = timing_processors(), .time_limit = INFINITY},
                *pool = bar->options->pool ? bar->options->pool : &own;
    enum status st;

    for (int n = 0; n < count; n++)
        done[n] = cases[n].done || cases[n].timed != CASE_UNTIMED;
    pool->count = count, pool->done = done, pool->quiet = true;
    pool->context = &u, pool->work = follow, pool->settle = settle;
    if (pool->ranks && pool->ranks->rank) {
        st = pool_serve(pool, NULL, why);
        goto out;
    }
    st = pool_run(pool, why);
    if (count && (!pool->ranks || (!st && !pool->stopped_by))) /* else some still work */
        tidy(cases[0].keep.file);
    TRY(st);
    if (pool->stopped_by)
        pool_raise(pool);
    for (int n = 0; n < count; n++)
        cases[n].done = cases[n].done || !done[n];
out:
    pool->done = NULL;
    arena_clear(&arena);
    return st;
}

enum status measurement_run(const struct measurement_options *options, int count,
                            struct case_plan *cases, struct message *why)
{
    struct arena arena = {0};
    struct job *jobs = arena_take(&arena, (size_t)count, sizeof *jobs);
    struct bar bar = {.options = options};
    enum status st;
    int next = 0, all = 0;

    TRY(take(options, count, cases, jobs, why));
    for (int n = 0; n < count; n++)
        all += cases[n].done ? 0 : TIMING_REPEATS + 1;
    bar.progress = progress_start(options->what, all, !options->what);
    if (!(options->until > 0)) /* a budget's order is the caller's */
        TRY(run_untimed(&bar, count, cases, jobs, why));
    while (next < count && !(options->pool && options->pool->ranks))
        TRY(run_group(&bar, count, cases, jobs, &next, why));
out:
    progress_end(&bar.progress);
    for (int n = 0; n < count; n++) {
        run_file_discard(jobs[n].file);
        motion_clear(&jobs[n].motion);
        run_close(&jobs[n].run);
    }
    arena_clear(&arena);
    return st;
}

/* Prints for how much of the time there was a processor: milliseconds of a busy machine are
 * too long. */
static void tell_share(struct store_read *run, FILE *file)
{
    double *all, *ours;
    int rows, columns;

    if (store_read_array(run, "seconds/timed", &all, &rows, &columns, NULL) == STATUS_OK &&
        store_read_array(run, "seconds/processor", &ours, &rows, &columns, NULL) ==
            STATUS_OK) {
        fprintf(file, "; a processor for %.0f %% of the time", 100 * *ours / *all);
        if (*ours < MEASUREMENT_PROCESSOR * *all)
            fprintf(file, ": the machine was busy, and no statement on time is judged");
    }
}

void measurement_machine(const char *path, FILE *file)
{
    static const char *const keys[] = {
        "commit",      "changed_files", "compiler",    "flags",        "cpu",
        "blas_kernel", "cholmod",       "omp_threads", "blas_threads", "date"};
    struct store_read *run = NULL;
    char *words = NULL;
    size_t size;
    FILE *memory = open_memstream(&words, &size);

    if (!memory || store_read_open(path, &run, NULL) != STATUS_OK)
        goto out;
    fputs("Measured:", memory);
    for (size_t n = 0; n < sizeof keys / sizeof *keys; n++) {
        char *text;
        if (store_read_text(run, "provenance", keys[n], &text, NULL) == STATUS_OK)
            fprintf(memory, "%s%s %s", n ? "; " : " ", keys[n], text);
    }
    tell_share(run, memory);
    fflush(memory);
    wrap_say(file, "\n%s", words);
out:
    if (memory)
        fclose(memory);
    free(words);
    store_read_close(run);
}
