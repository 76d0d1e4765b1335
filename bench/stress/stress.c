#include "bench/stress/stress.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/kept.h"
#include "bench/files/folder.h"
#include "bench/harness/pool.h"
#include "models/reader/scene_file.h"

/* The limit of a job's processor time [s]; that of the clock is ten times as long, for a
 * job that sleeps. */
enum { TIME_LIMIT = 120 };

struct options {
    const char *folder;
    struct stress_choice choice;
    int jobs;
};

/* --- the choice -------------------------------------------------------------------------
 */

bool stress_choice_case(const struct stress_choice *choice, const struct stress_case *c)
{
    for (int n = 0; n < choice->word_count; n++)
        if (!strcmp(choice->words[n], c->item.name))
            return true;
    return !choice->word_count && (c->quick || !choice->quick);
}

const struct contestant *stress_choice_next(const struct stress_choice *choice,
                                            const struct contestant *last)
{
    const struct contestant *c = last ? last + 1 : contestant_table;

    while (c->name && !contestant_chosen(c, choice->models, CONTESTANT_STRESS))
        c++;
    return c->name ? c : NULL;
}

enum status stress_choice_check(const struct stress_choice *choice, struct message *why)
{
    for (int w = 0; w < choice->word_count; w++) {
        int n = 0;
        while (stress_case_items[n] && strcmp(stress_case_items[n]->name, choice->words[w]))
            n++;
        if (!stress_case_items[n])
            return status_fail(why, STATUS_INPUT,
                               "stress: there is no case '%s'; clothbench list cases has "
                               "them",
                               choice->words[w]);
    }
    return contestant_check(choice->models, why);
}

/* --- jobs -------------------------------------------------------------------------------
 */

enum status stress_find_truth(const struct stress_job *job, bool made, struct truth **truth,
                              struct message *why)
{
    /* The sheet hangs from points, which hold nothing of a solid. */
    static const struct truth_wish wish = {.error = 0.005, .seconds = 30, .shell = true};
    static const double time[] = {0.1, 0.2, 0.3};
    const int times = sizeof time / sizeof *time;
    char folder[4096];
    struct settings physics = {0};
    enum status st = STATUS_OK;

    settings_list(&physics, STRESS_SETTINGS, job->c->physics);
    snprintf(folder, sizeof folder, "%s/%s.truth", job->folder, job->c->item.name);
    if (made)
        TRY(folder_make(folder, why));
    st = made ? truth_find_or_make(job->path, &physics, times, time, folder, &wish, truth,
                                   why)
              : truth_find(job->path, &physics, times, time, folder, truth, why);
out:
    settings_clear(&physics);
    return st;
}

/* Does a job in a process of its own: a run, or with no contestant the case's truth. */
static enum status work(void *context, long number, struct message *why)
{
    const struct stress_job *job = (const struct stress_job *)context + number;
    struct stress_result result;
    struct truth *truth = NULL;
    enum status st;

    if (!job->contestant) {
        TRY(stress_find_truth(job, true, &truth, why));
        truth_destroy(truth);
        return STATUS_OK;
    }
    TRY(stress_judge(job, &result, why));
    st = stress_result_write(job->folder, job->c, job->contestant, &result, why);
out:
    return st;
}

/* Ends a job: a run that came to no result of its own has died; runs without a truth will
 * say why there is none. */
static enum status settle(void *context, long number, const struct child_end *end,
                          struct message *why)
{
    const struct stress_job *job = (const struct stress_job *)context + number;
    const struct stress_result dead = {.end = STRESS_DIED,
                                       .error = NAN,
                                       .time = end->reached,
                                       .seconds = end->seconds,
                                       .sentence = end->why};

    if (end->outcome == CHILD_DONE)
        return STATUS_OK;
    if (!job->contestant) {
        *job->no_truth = end->why;
        return STATUS_OK;
    }
    return stress_result_write(job->folder, job->c, job->contestant, &dead, why);
}

/* Lists the jobs of the chosen cases: for each its truth, if it must be made, then its
 * runs. Returns their number; list NULL: the number alone. no_truth[]: room for as many. */
static long list_jobs(const struct options *o, const char *path, struct message *no_truth,
                      struct stress_job *list)
{
    struct stress_job job = {.path = path, .folder = o->folder};
    long count = 0;

    for (int n = 0; (job.c = stress_case_at(n)); n++) {
        if (!stress_choice_case(&o->choice, job.c))
            continue;
        job.no_truth = no_truth ? &no_truth[count] : NULL;
        do {
            if (!job.contestant && job.c->truth != STRESS_SHELL)
                continue;
            if (list)
                list[count] = job;
            count++;
        } while ((job.contestant = stress_choice_next(&o->choice, job.contestant)));
    }
    return count;
}

/* Makes the truths, then does the runs. */
static enum status run_jobs(const struct options *o, long count, struct stress_job *list,
                            bool *done, struct message *why)
{
    enum status st = STATUS_OK;

    for (int runs = 0; runs < 2 && st == STATUS_OK; runs++) {
        struct pool pool = {
            .count = count,
            .done = done,
            .context = list,
            .slots = o->jobs,
            .time_limit = TIME_LIMIT,
            .work = work,
            .settle = settle,
        };
        long open = 0;

        for (long n = 0; n < count; n++) {
            done[n] = (list[n].contestant != NULL) != runs;
            open += !done[n];
        }
        if (open)
            st = pool_run(&pool, why);
        if (pool.stopped_by)
            pool_raise(&pool);
    }
    return st;
}

static enum status measure(const struct options *o, struct message *why)
{
    const long count = list_jobs(o, NULL, NULL, NULL);
    struct stress_job *list = calloc((size_t)count + 1, sizeof *list);
    bool *done = calloc((size_t)count + 1, sizeof *done);
    struct message *no_truth = calloc((size_t)count + 1, sizeof *no_truth);
    char *path = NULL;
    enum status st;

    TRY(list && done && no_truth ? STATUS_OK : STATUS_MEMORY);
    TRY(folder_make(o->folder, why));
    TRY(scene_file_find(stress_case_scene, &path, why));
    list_jobs(o, path, no_truth, list);
    st = run_jobs(o, count, list, done, why);
out:
    free(list);
    free(done);
    free(no_truth);
    free(path);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *from;
    struct options o = {.folder = "results/stress",
                        .choice = {.word_count = line->word_count,
                                   .words = line->words,
                                   .models = command_value(line, "--models"),
                                   .quick = command_given(line, "--quick")}};
    enum table_format format = TABLE_TEXT;
    long jobs = omp_get_num_procs();
    struct kept *kept = NULL;
    enum status st = STATUS_OK;

    TRY(command_folder(line, &o.folder, &from, why));
    TRY(command_format(line, &format, why));
    TRY(command_integer(line, "--jobs", 1, 1024, &jobs, why));
    TRY(stress_choice_check(&o.choice, why));
    o.jobs = (int)jobs;
    if (!from)
        TRY(measure(&o, why));
    if (!o.choice.word_count)
        kept_open(o.folder, "stress", "", &kept);
    TRY(stress_print(o.folder, &o.choice, format, stdout, why));
    TRY(kept_close(&kept, why));
out:
    kept_discard(&kept);
    return st;
}

static const struct command_option options[] = {
    {"--models", "A,B,...", false, "models or contestants (those that take part here)"},
    {"--quick", NULL, false, "some of the cases, in less than a minute"},
    {"--jobs", "N", false, "runs at a time (the number of processors)"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of the results (results/stress)"},
    {"--from", "DIR", false, "print again from the results of an earlier run"},
    {NULL, NULL, false, NULL},
};

const struct command stress_command = {
    .name = "stress",
    .summary =
        "run hard cases: thin, stiff, incompressible, long steps, odd nets, units, contact",
    .arguments = "[CASE]... [OPTION]...",
    .text =
        "Runs every contestant on hard cases, each in a process of its own with a time\n"
        "limit. A run ends as accurate or degraded, by its error against the truth that\n"
        "the case names; as refused, with the model's sentence; or as died, with time\n"
        "and cause. The bound on the error is the same for all and is printed with its\n"
        "reason. Cases of contact also tell how near the middle of the sheet came to a\n"
        "body, and when and how deep it passed through one or through itself.\n",
    .examples = "stress\nstress --quick\nstress thin_5 buckling --models iga,shell\n",
    .most = 64,
    .options = options,
    .section = "cases",
    .items = stress_case_items,
    .run = run,
};
