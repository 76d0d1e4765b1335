#include "bench/stress/stress.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/harness/child.h"
#include "bench/files/folder.h"
#include "bench/ui/progress.h"
#include "bench/harness/registry.h"
#include "models/reader/scene_file.h"

/* Of processor time [s]; of the clock ten times that, for those who sleep. */
enum { TIME_LIMIT = 120, QUICK_LIMIT = 20 };

struct options {
    const char *folder;
    struct stress_choice choice;
    int jobs;
};

/* A job in a process: a trial, or with no model the case's truth. */
static enum status work(void *context, struct message *why)
{
    const struct stress_job *job = context;
    struct stress_result result;
    struct truth *truth = NULL;
    char name[256];
    enum status st;

    child_limit(job->quick ? QUICK_LIMIT : TIME_LIMIT);
    if (!job->model) {
        TRY(stress_find_truth(job, TRUTH_QUICK, &truth, why));
        truth_destroy(truth);
        return STATUS_OK;
    }
    TRY(stress_run(job, &result, why));
    stress_name(job->c, job->model, name, sizeof name);
    st = stress_write(job->folder, name, &result, why);
out:
    return st;
}

/* A trial that came to no result of its own has died. */
static enum status settle(const struct stress_job *job, const struct child_end *end,
                          struct message *why)
{
    struct stress_result result = {.outcome = STRESS_DEAD,
                                   .error = NAN,
                                   .time = end->reached,
                                   .seconds = end->seconds};
    char name[256];

    if (end->outcome == CHILD_DONE)
        return STATUS_OK;
    if (end->outcome == CHILD_STUCK)
        return status_fail(why, STATUS_FILE, "%s", end->why.text);
    if (end->outcome == CHILD_ASKED)
        return status_fail(why, STATUS_LIBRARY, "stopped");
    if (!job->model)
        return STATUS_OK; /* trials without truth say so */
    result.sentence = end->why;
    stress_name(job->c, job->model, name, sizeof name);
    return stress_write(job->folder, name, &result, why);
}

struct queue {
    struct stress_job *jobs; /* [count]                                          owned */
    int count, next, running, done;
    int slots;
    struct child *slot;             /* [slots]                                   owned */
    const struct stress_job **busy; /* [slots]                                   owned */
    double time_limit;
    struct progress progress;
};

static void clear_queue(struct queue *q)
{
    progress_end(&q->progress);
    for (int n = 0; q->slot && n < q->slots; n++)
        child_clear(&q->slot[n]);
    free(q->slot);
    free(q->busy);
    free(q->jobs);
}

static enum status turn(struct queue *q, struct message *why)
{
    static const struct timespec moment = {.tv_nsec = 1000000};
    struct child_end end;
    enum status st = STATUS_OK;

    for (int n = 0; n < q->slots; n++) {
        if (!q->slot[n].pid && q->next < q->count) {
            q->busy[n] = &q->jobs[q->next++];
            TRY(child_start(&q->slot[n], work, (void *)q->busy[n], why));
            q->running++;
        } else if (q->slot[n].pid && child_poll(&q->slot[n], q->time_limit, &end)) {
            q->running--;
            progress_update(&q->progress, ++q->done);
            TRY(settle(q->busy[n], &end, why));
        }
    }
    nanosleep(&moment, NULL);
out:
    return st;
}

/* Runs q->jobs, as many at a time as there are slots. */
static enum status run_queue(struct queue *q, struct message *why)
{
    enum status st = STATUS_OK;

    q->slot = calloc((size_t)q->slots, sizeof *q->slot);
    q->busy = calloc((size_t)q->slots, sizeof *q->busy);
    TRY(q->slot && q->busy ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < q->slots; n++)
        TRY(child_init(&q->slot[n]));
    q->progress = progress_start("cases", q->count, false);
    while (q->next < q->count || q->running)
        TRY(turn(q, why));
out:
    return st;
}

/* The jobs asked for: `truths` of the cases that need one, or trials. */
static enum status list_jobs(const struct options *o, const char *path, bool truths,
                             struct queue *q)
{
    int cases = 0;

    while (stress_case_at(cases))
        cases++;
    *q = (struct queue){.slots = o->jobs,
                        .time_limit = 10 * (o->choice.quick ? QUICK_LIMIT : TIME_LIMIT)};
    q->jobs = calloc((size_t)(cases * STRESS_MODELS), sizeof *q->jobs);
    if (!q->jobs)
        return STATUS_MEMORY;
    for (int n = 0; n < cases; n++) {
        const struct stress_case *c = stress_case_at(n);
        const bool ask =
            stress_choice_case(&o->choice, c) && (!truths || c->truth == STRESS_SHELL);
        for (int m = 0; ask && m < (truths ? 1 : STRESS_MODELS); m++)
            if (truths || stress_choice_model(&o->choice, &stress_models[m]))
                q->jobs[q->count++] =
                    (struct stress_job){.c = c,
                                        .model = truths ? NULL : &stress_models[m],
                                        .path = path,
                                        .folder = o->folder,
                                        .quick = o->choice.quick};
    }
    return STATUS_OK;
}

static enum status measure(const struct options *o, struct message *why)
{
    struct queue q = {0};
    bool wanted[STRESS_MODELS];
    char *path = NULL;
    enum status st;

    TRY(folder_make(o->folder, why));
    TRY(scene_file_find(stress_scene, &path, why));
    for (int truths = 1; truths >= 0; truths--) {
        TRY(list_jobs(o, path, truths, &q));
        TRY(run_queue(&q, why));
        clear_queue(&q);
        q = (struct queue){0};
    }
    for (int m = 0; m < STRESS_MODELS; m++)
        wanted[m] = stress_choice_model(&o->choice, &stress_models[m]);
    if (stress_choice_map(&o->choice))
        TRY(stress_map_measure(o->folder, wanted, o->jobs, o->choice.quick, why));
out:
    clear_queue(&q);
    free(path);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    const char *word = command_value(line, "--format");
    struct options o = {.folder = from  ? from
                                  : out ? out
                                        : "results/stress",
                        .choice = {.word_count = line->word_count,
                                   .words = line->words,
                                   .models = command_value(line, "--models"),
                                   .quick = command_given(line, "--quick")}};
    enum table_format format = TABLE_TEXT;
    long jobs = omp_get_num_procs();
    enum status st = STATUS_OK;

    if (from && out)
        TRY(status_fail(why, STATUS_INPUT,
                        "--from reads result files and --out writes them; give one of the "
                        "two"));
    if (word)
        TRY(table_format_parse(word, &format, why));
    TRY(command_integer(line, "--jobs", 1, 1024, &jobs, why));
    TRY(stress_choice_check(&o.choice, why));
    o.jobs = (int)jobs;
    if (!from)
        TRY(measure(&o, why));
    TRY(stress_print(o.folder, &o.choice, format, stdout, why));
out:
    return st;
}

static const struct command_option options[] = {
    {"--models", "A,B,...", false, "models, or variants of them such as iga_reduced (all)"},
    {"--quick", NULL, false, "some of the cases, in less than a minute"},
    {"--jobs", "N", false, "runs at a time (as many as there are processors)"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where results go (results/stress)"},
    {"--from", "DIR", false, "print again from the results of an earlier run"},
    {NULL, NULL, false, NULL},
};

const struct command stress_command = {
    .name = "stress",
    .summary =
        "hard cases: thin, stiff, nearly incompressible, long steps, odd nets, units",
    .arguments = "[CASE]... [OPTION]...",
    .text =
        "Puts every model through hard cases, each run in a process of its own with a\n"
        "time limit. Each ends as accurate or degraded, by its error against the truth\n"
        "that the case names, or refused, with the model's sentence, or died, with time\n"
        "and cause. A bound is the same for all models, and printed with its reason.\n",
    .examples = "stress\nstress --quick\nstress thin_5 buckling --models iga,shell\n",
    .most = 64,
    .options = options,
    .section = "cases",
    .items = stress_items,
    .run = run,
};
