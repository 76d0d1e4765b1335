#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/compare/compare.h"
#include "bench/experiment/batch.h"
#include "bench/harness/deadline.h"
#include "bench/harness/timing.h"
#include "bench/ui/progress.h"
#include "models/damping.h"
#include "models/reader/scene_file.h"

/* The time up to which scenes are compared: an edge drop's first quarter swing, before
 * motions part for good [s]. */
static const double UNTIL = 0.5;

/* Chooses how the truth is damped (truth.h), and all contestants but the paper's own
 * scheme. */
static void choose_damping(struct compare_job *j)
{
    const char *truth = truth_plan_damping(&j->scene);

    snprintf(j->contest.physics, sizeof j->contest.physics, "damping %s",
             damping_words[j->scene.damping.kind]);
    settings_append(&j->truth, &j->user);
    for (int n = 0; n < j->user.count; n++)
        if (!strncmp(j->user.text[n], "damping", 7))
            return;
    if (!truth)
        return;
    settings_set(&j->truth, truth);
    snprintf(j->contest.physics, sizeof j->contest.physics,
             "undamped, but for the paper's own scheme with velocity_scale %g",
             j->scene.damping.value);
}

static enum status spread_times(struct compare_job *j, double until, struct message *why)
{
    j->times = CONTEST_TIMES;
    for (int n = 0; n < j->times; n++)
        j->time[n] =
            fmax(1, round((n + 1) * until / j->times / j->scene.step)) * j->scene.step;
    for (int n = 1; n < j->times; n++)
        if (j->time[n] <= j->time[n - 1])
            return status_fail(why, STATUS_INPUT,
                               "--until %g: at least %d frames of %g s are needed", until,
                               j->times, j->scene.step);
    return STATUS_OK;
}

static enum status choose_times(struct compare_job *j, double until, struct message *why)
{
    const double most = fmin(UNTIL, j->scene.end);
    enum status st;

    if (!isnan(until))
        return spread_times(j, until, why);
    /* late: known at rest, at the end */
    for (int late = 0; late < 2 && !j->times; late++)
        TRY(truth_stored_times(j->path, &j->truth, late ? j->scene.end : most,
                               CONTEST_TIMES, j->time, &j->times, why));
    return j->times ? STATUS_OK : spread_times(j, most, why);
out:
    return st;
}

enum status compare_job_open(struct compare_job *j, const char *scene, double until,
                             struct message *why)
{
    enum status st;

    TRY(scene_file_find(scene, &j->path, why));
    TRY(contestant_read_scene(&j->user, j->path, &j->scene, why));
    j->contest.scene = &j->scene;
    choose_damping(j);
    TRY(choose_times(j, until, why));
out:
    return st;
}

void compare_job_close(struct compare_job *j)
{
    contest_clear(&j->contest);
    settings_clear(&j->user);
    settings_clear(&j->truth);
    truth_destroy(j->found);
    scene_clear(&j->scene);
    free(j->path);
}

enum status compare_job_enter(struct compare_job *j, const char *models, int rungs,
                              bool paper_scheme, struct message *why)
{
    const struct model *model;
    struct contest_at at[CONTEST_RUNGS];
    enum status st;

    TRY(contestant_check(models, why));
    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *who = contestant_table; who->name; who++) {
            if (who->model != model || !contestant_chosen(who, models, CONTESTANT_COMPARE))
                continue;
            if (!paper_scheme && contestant_is_paper_scheme(who))
                continue;
            const int count = contest_ladder(&j->contest, who, at);
            for (int n = 0; n < count && n < rungs; n++)
                TRY(contest_add(&j->contest, &at[n], NULL));
        }
out:
    return st;
}

enum status compare_job_truth(struct compare_job *j, const struct truth_wish *wish,
                              struct message *said, struct message *why)
{
    deadline_set(wish->seconds);
    const enum status st = truth_find_or_make(j->path, &j->truth, j->times, j->time,
                                              j->folder, wish, &j->found, said);

    j->contest.truth = j->found;
    if (st == STATUS_UNSUPPORTED || st == STATUS_LATE || status_is_death(st))
        return STATUS_OK;
    return st ? status_fail(why, st, "%s", said->text) : STATUS_OK;
}

/* --- runs --- */

/* Adds a row's run to a batch. Its file is named after the points along u, the steps, the
 * iterations and the threads beyond one; after the points across, too, where cells are not
 * about square. */
static void plan_row(struct compare_job *j, const struct contest_row *row, int threads,
                     struct batch *batch)
{
    const struct contest_at *at = &row->at;
    const int along = at->size[CONTEST_NET], across = at->size[CONTEST_ACROSS];
    char name[128], more[16] = "", tag[16] = "";

    if (across != contest_across(&j->contest, at->contestant, along))
        snprintf(more, sizeof more, "x%d", across);
    if (threads > 1)
        snprintf(tag, sizeof tag, "_t%d", threads);
    snprintf(name, sizeof name, "%s_%d%s_%d_%d%s", at->contestant->name, along, more,
             at->size[CONTEST_STEP], at->size[CONTEST_ITERATIONS], tag);
    struct measurement_case *c = batch_add(batch, j->path, at->contestant, name);
    c->plan.end = j->time[j->times - 1];
    c->keep.times = j->times;
    c->keep.time = j->time;
    c->keep.fields = RUN_FIELDS_TIMES;
    c->timed = row->probe ? MEASUREMENT_UNTIMED : MEASUREMENT_WHOLE;
    settings_append(batch_settings(batch),
                    contestant_is_paper_scheme(at->contestant) ? &j->user : &j->truth);
    /* again: the user's settings do not change what defines it */
    contestant_settings(at->contestant, batch_settings(batch));
    contest_settings(&j->contest, at, batch_settings(batch));
}

static void show(void *context, const char *what, int done, int total)
{
    struct progress *bar = context;

    (void)what;
    bar->total = total;
    progress_update(bar, done);
}

static enum status run_batch(struct compare_job *j, struct batch *batch,
                             struct message *why)
{
    struct progress bar = progress_start("compare", 1, false);
    const struct measurement_options options = {.what = "compare",
                                                .quick = j->contest.quick,
                                                .progress = show,
                                                .context = &bar,
                                                .taken = &j->taken};
    const enum status st = batch_run(batch, &options, why);

    progress_end(&bar);
    return st;
}

enum status compare_job_rows(void *job, int first, struct message *why)
{
    struct compare_job *j = job;
    struct contest *c = &j->contest;
    const bool needed = first == 0 && !(c->budget > 0); /* no budget cut the ladder short */
    struct batch batch;
    struct message said = {""};
    enum status st, late = STATUS_OK;

    TRY(batch_init(&batch, j->folder, c->count - first));
    for (int n = first; n < c->count; n++)
        plan_row(j, &c->rows[n], 1, &batch);
    if (!j->read_only)
        late = run_batch(j, &batch, &said);
    if (late != STATUS_LATE && late != STATUS_OK)
        TRY(status_fail(why, late, "%s", said.text));
    for (int n = first; n < c->count; n++) {
        struct run_result r = {0};
        if ((late && !batch.cases[n - first].done) ||
            (!needed && j->read_only && access(batch.files[n - first], F_OK) != 0)) {
            contest_set_absent(&c->rows[n]);
            continue;
        }
        TRY(batch_read(&batch, n - first, true, &r, why));
        contest_fill(c, &r, &c->rows[n]);
        run_result_clear(&r);
    }
    st = late ? status_fail(why, late, "%s", said.text) : late;
out:
    batch_clear(&batch);
    return st;
}

/* Times the best rows once more with a number of threads. */
static enum status measure_team(struct compare_job *j, int team, struct message *why)
{
    struct contest *c = &j->contest;
    struct batch batch;
    int at = 0;
    enum status st;

    TRY(batch_init(&batch, j->folder, c->count));
    for (int n = 0; n < c->count; n++)
        if (contest_is_best(c, &c->rows[n]))
            plan_row(j, &c->rows[n], c->team[team], &batch);
    timing_threads(c->team[team]);
    if (!j->read_only)
        TRY(run_batch(j, &batch, why));
    for (int n = 0; n < c->count; n++) {
        struct run_result r = {0};
        if (!contest_is_best(c, &c->rows[n]))
            continue;
        if (j->read_only && access(batch.files[at], F_OK) != 0)
            TRY(status_fail(why, STATUS_LATE, "%s is not there", batch.files[at]));
        TRY(batch_read(&batch, at++, true, &r, why));
        contest_fill_team(c, team, &r, &c->rows[n]);
        run_result_clear(&r);
    }
out:
    batch_clear(&batch);
    return st;
}

static enum status measure_all(struct compare_job *j, struct message *why)
{
    struct contest *c = &j->contest;
    enum status st;

    TRY(compare_job_rows(j, 0, why));
    TRY(contest_search_all(c, compare_job_rows, j, why));
    const int searched = c->count;
    TRY(contest_search_limits(c));
    if (c->count > searched)
        TRY(compare_job_rows(j, searched, why));
out:
    return st;
}

enum status compare_job_measure(struct compare_job *j, struct message *why)
{
    struct contest *c = &j->contest;
    struct message said = {""};
    enum status st = measure_all(j, &said);
    const int all = c->count;

    contest_drop_absent(c);
    contest_choose_best(c);
    for (int t = 0; t < c->teams && st == STATUS_OK; t++)
        st = measure_team(j, t, &said);
    if (st == STATUS_LATE) {
        fprintf(stderr, "compare: %s; %d of %d runs were skipped\n", said.text,
                all - c->count, all);
        c->teams = 0;
        TRY(contest_tell_unsearched(c));
    } else {
        TRY(st ? status_fail(why, st, "%s", said.text) : st);
    }
out:
    measurement_tell("compare", &j->taken, j->folder);
    timing_threads(1);
    return st;
}
