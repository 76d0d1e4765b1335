#include "bench/compare/compare_job.h"

#include <stdio.h>
#include <unistd.h>

#include "bench/experiment/batch.h"
#include "bench/harness/timing.h"
#include "bench/ui/progress.h"

/* Of its ladder all, or where a budget has to do the least. */
static enum status add_rows(struct contest *c, const struct contestant *who)
{
    struct contest_at at[CONTEST_RUNGS];
    const int count = contest_ladder(c, who, at);
    struct contest_row *unused;
    enum status st = STATUS_OK;

    for (int n = 0; n < (c->budget > 0 ? 1 : count); n++)
        TRY(contest_add(c, &at[n], &unused));
out:
    return st;
}

/* All of a choice (contestant_chosen), model by model. */
enum status compare_job_ladder(struct compare_job *j, const char *models,
                               struct message *why)
{
    const struct model *model;
    enum status st;

    TRY(contestant_check(models, why));
    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *who = contestant_table; who->name; who++)
            if (who->model == model && contestant_chosen(who, models, CONTESTANT_COMPARE))
                TRY(add_rows(&j->contest, who));
out:
    return st;
}

static void refine(const struct contest *c, const struct contest_at *at, struct settings *s)
{
    const int *size = at->size;

    contestant_settings(at->contestant, s); /* again: what the user set may not change it */
    contestant_points(at->contestant, size[CONTEST_NET], contest_across(c, at), s);
    settings_number(s, "time.step", c->scene->step / size[CONTEST_STEP]);
    if (size[CONTEST_ITERATIONS])
        settings_integer(s, "discretization.iterations", size[CONTEST_ITERATIONS]);
}

static void plan_row(struct compare_job *j, const struct contest_row *row, const char *tag,
                     struct batch *batch)
{
    const struct contest_at *at = &row->at;
    char name[128];

    snprintf(name, sizeof name, "%s_%d_%d_%d%s", at->contestant->name,
             at->size[CONTEST_NET], at->size[CONTEST_STEP], at->size[CONTEST_ITERATIONS],
             tag);
    struct measurement_case *c = batch_add(batch, j->path, at->contestant, name);
    c->plan.end = j->time[j->times - 1];
    c->keep.times = j->times;
    c->keep.time = j->time;
    c->keep.fields = RUN_FIELDS_TIMES;
    c->timed = row->probe ? MEASUREMENT_UNTIMED : MEASUREMENT_WHOLE;
    settings_append(batch_settings(batch),
                    contestant_is_paper_scheme(at->contestant) ? &j->user : &j->truth);
    refine(&j->contest, at, batch_settings(batch));
}

static void show(void *context, const char *what, int done, int total)
{
    struct progress *bar = context;

    (void)what;
    bar->total = total;
    progress_update(bar, done);
}

static enum status run_batch(const struct compare_job *j, struct batch *batch,
                             struct message *why)
{
    struct progress bar = progress_start("compare", 1, false);
    const struct measurement_options options = {
        .what = "compare", .quick = j->contest.quick, .progress = show, .context = &bar};
    const enum status st = batch_run(batch, &options, why);

    progress_end(&bar);
    return st;
}

/* Of rows that an earlier call may not have had those from the first one missing are not
 * read. */
static int there(const struct compare_job *j, const struct batch *batch)
{
    int n = 0;

    while (n < batch->count && (!j->read_only || access(batch->files[n], F_OK) == 0))
        n++;
    return n;
}

/* Runs all rows from the first one given on, unless an earlier call has left their files,
 * and fills them. If they are not `needed`, those that it did not leave go. */
static enum status measure(struct compare_job *j, int first, bool needed,
                           struct message *why)
{
    struct contest *c = &j->contest;
    struct batch batch;
    enum status st;

    TRY(batch_init(&batch, j->folder, c->count - first));
    for (int n = first; n < c->count; n++)
        plan_row(j, &c->rows[n], "", &batch);
    if (!j->read_only)
        TRY(run_batch(j, &batch, why));
    if (!needed)
        c->count = first + there(j, &batch);
    for (int n = first; n < c->count; n++) {
        struct run_result r = {0};
        TRY(batch_read(&batch, n - first, true, &r, why));
        contest_fill(c, &r, &c->rows[n]);
        run_result_clear(&r);
    }
out:
    batch_clear(&batch);
    return st;
}

/* The best rows once more with a number of threads; the same bits, or it is told. */
static enum status measure_team(struct compare_job *j, int team, struct message *why)
{
    struct contest *c = &j->contest;
    struct batch batch;
    struct run_result r = {0};
    char tag[16];
    int at = 0;
    enum status st;

    snprintf(tag, sizeof tag, "_t%d", c->team[team]);
    TRY(batch_init(&batch, j->folder, c->count));
    for (int n = 0; n < c->count; n++)
        if (contest_is_best(c, &c->rows[n]))
            plan_row(j, &c->rows[n], tag, &batch);
    timing_threads(c->team[team]);
    if (!j->read_only)
        TRY(run_batch(j, &batch, why));
    for (int n = 0; n < c->count; n++) {
        if (!contest_is_best(c, &c->rows[n]))
            continue;
        TRY(batch_read(&batch, at++, true, &r, why));
        contest_fill_team(c, team, &r, &c->rows[n]);
        run_result_clear(&r);
    }
out:
    run_result_clear(&r);
    batch_clear(&batch);
    return st;
}

static enum status measure_searched(void *job, int first, struct message *why)
{
    return measure(job, first, false, why);
}

/* The ladder, what it makes worth a try, what tells the limits of each, and the best of all
 * with more threads. */
enum status compare_job_measure(struct compare_job *j, struct message *why)
{
    struct contest *c = &j->contest;
    enum status st;

    TRY(measure(j, 0, true, why));
    TRY(contest_search_all(c, measure_searched, j, why));
    const int searched = c->count;
    TRY(contest_search_limits(c));
    if (c->count > searched)
        TRY(measure(j, searched, true, why));
    contest_choose_best(c);
    for (int t = 0; t < c->teams; t++)
        TRY(measure_team(j, t, why));
out:
    timing_threads(1);
    return st;
}
