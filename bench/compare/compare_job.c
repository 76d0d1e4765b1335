#include "bench/compare/compare_job.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/experiment/batch.h"
#include "bench/truth/truth_plan.h"
#include "bench/ui/progress.h"
#include "models/damping.h"
#include "models/reader/scene_file.h"

/* Half a second: an edge drop's first quarter swing, before motions part for good. */
static const double UNTIL = 0.5;

enum { MOST_ROUNDS = 20 };

/* All but the paper's own scheme move as the truth does (truth_plan.h). */
static void choose_damping(struct compare_job *j)
{
    const char *truth = truth_plan_damping(&j->scene);

    snprintf(j->contest.physics, sizeof j->contest.physics, "damping %s",
             damping_name((int)j->scene.damping.kind));
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
    TRY(truth_stored_times(j->path, &j->truth, most, CONTEST_TIMES, j->time, &j->times,
                           why));
    return j->times ? STATUS_OK : spread_times(j, most, why);
out:
    return st;
}

enum status compare_job_open(struct compare_job *j, const char *scene, double until,
                             struct message *why)
{
    enum status st;

    TRY(scene_file_find(scene, &j->path, why));
    TRY(settings_read_scene(&j->user, j->path, &j->scene, why));
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

static int length(const int *list, int most)
{
    int n = 0;

    while (n < most && list[n])
        n++;
    return n;
}

/* Nets, time steps and iterations of a contestant, from cheap to dear; `quick` leaves out
 * the dear half. */
static enum status add_rows(struct contest *c, const struct contestant *who, bool quick)
{
    const int sides = length(who->points, quick ? 2 : CONTESTANT_STEPS);
    const int divisors = length(who->divisors, quick ? 1 : CONTESTANT_STEPS);
    const int iterations = length(who->iterations, CONTESTANT_STEPS);
    struct contest_row *unused;
    enum status st = STATUS_OK;

    for (int s = 0; s < sides; s++)
        for (int d = 0; d < divisors; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                TRY(contest_add(c,
                                &(struct contest_at){who,
                                                     {who->points[s], who->divisors[d],
                                                      iterations ? who->iterations[i] : 0}},
                                &unused));
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
                TRY(add_rows(&j->contest, who, j->quick));
out:
    return st;
}

/* One more of each thing from the nearest of each contestant that may come nearer. */
static enum status add_probes(struct compare_job *j)
{
    struct contest *c = &j->contest;
    const struct contestant *who;
    enum status st = STATUS_OK;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const struct contest_limit limit = contest_limit(c, who);
        struct contest_at at[CONTEST_AXES];
        struct contest_row *row;
        int count = 0;
        if (!limit.best || limit.kind == CONTEST_BY_TRUTH)
            continue;
        for (int axis = 0; axis < CONTEST_AXES; axis++)
            count += contest_probe(c, limit.best, (enum contest_axis)axis, &at[count]);
        for (int n = 0; n < count; n++) {
            TRY(contest_add(c, &at[n], &row));
            row->probe = true;
        }
    }
out:
    return st;
}

static void refine(const struct contest_at *at, double frame, struct settings *s)
{
    const int *size = at->size;

    contestant_settings(at->contestant, s); /* again: what the user set may not change it */
    contestant_points(at->contestant, size[CONTEST_NET], size[CONTEST_NET], s);
    settings_number(s, "time.step", frame / size[CONTEST_STEP]);
    if (size[CONTEST_ITERATIONS])
        settings_integer(s, "discretization.iterations", size[CONTEST_ITERATIONS]);
}

static void plan_row(struct compare_job *j, const struct contest_row *row,
                     struct batch *batch)
{
    const struct contest_at *at = &row->at;
    char name[128];

    snprintf(name, sizeof name, "%s_%d_%d_%d", at->contestant->name, at->size[CONTEST_NET],
             at->size[CONTEST_STEP], at->size[CONTEST_ITERATIONS]);
    struct measurement_case *c = batch_add(batch, j->path, at->contestant, name);
    c->plan.end = j->time[j->times - 1];
    c->keep.times = j->times;
    c->keep.time = j->time;
    c->keep.fields = RUN_FIELDS_TIMES;
    c->timed = row->probe ? MEASUREMENT_UNTIMED : MEASUREMENT_WHOLE;
    settings_append(batch_settings(batch),
                    contestant_is_paper_scheme(at->contestant) ? &j->user : &j->truth);
    refine(at, j->scene.step, batch_settings(batch));
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
        .what = "compare", .quick = j->quick, .progress = show, .context = &bar};
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
        plan_row(j, &c->rows[n], &batch);
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

enum status compare_job_rows(struct compare_job *j, int first, struct message *why)
{
    return measure(j, first, true, why);
}

enum status compare_job_propose(struct compare_job *j, const struct contest_wish *wish)
{
    struct contest *c = &j->contest;
    const struct contestant *who;
    struct contest_at at[CONTEST_PROPOSALS];
    struct contest_row *unused;
    enum status st = STATUS_OK;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const int count = contest_search(c, who, wish, at);
        for (int n = 0; n < count; n++)
            TRY(contest_add(c, &at[n], &unused));
    }
out:
    return st;
}

/* Each contestant's best for each target, from what its ladder showed. */
static enum status search(struct compare_job *j, struct message *why)
{
    const struct contest_wish wish = {CONTEST_TARGETS, contest_target, j->longest};
    enum status st = STATUS_OK;

    for (int round = 0; round < MOST_ROUNDS && j->longest > 0; round++) {
        const int first = j->contest.count;
        TRY(compare_job_propose(j, &wish));
        const int proposed = j->contest.count;
        if (proposed > first)
            TRY(measure(j, first, false, why));
        if (proposed == first || j->contest.count < proposed)
            break;
    }
out:
    return st;
}

/* The ladder, what it makes worth a try, and then what tells the limits of each. */
enum status compare_job_measure(struct compare_job *j, struct message *why)
{
    enum status st;

    TRY(measure(j, 0, true, why));
    TRY(search(j, why));
    const int searched = j->contest.count;
    TRY(add_probes(j));
    if (j->contest.count > searched)
        TRY(measure(j, searched, true, why));
out:
    return st;
}
