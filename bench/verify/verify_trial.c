#include "bench/verify/verify_trial.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/clock.h"
#include "models/reader/scene_file.h"

/* What a model's status means for the row; an error if it is neither a refusal nor a death.
 */
static enum status tell(struct verify_trial *t, enum status st,
                        const struct message *sentence, struct message *why)
{
    t->lived = st == STATUS_OK;
    if (st == STATUS_UNSUPPORTED)
        verify_row_end(t->row, VERIFY_NOT_APPLICABLE, "%s", sentence->text);
    else if (status_is_death(st))
        verify_row_end(t->row, VERIFY_DIED, "%s",
                       *sentence->text ? sentence->text : status_text(st));
    else if (st != STATUS_OK)
        return status_fail(why, st, "%s: %s", t->subject->contestant->title,
                           sentence->text);
    return STATUS_OK;
}

enum status verify_trial_scene(const char *name, struct scene *scene, struct message *why)
{
    enum status st;
    struct discretization unused = {0};
    char *path = NULL;

    TRY(scene_file_find(name, &path, why));
    TRY(scene_file_read(path, 0, NULL, scene, &unused, why));
out:
    discretization_clear(&unused);
    free(path);
    return st;
}

enum status verify_trial_open(struct verify_trial *t, struct message *why)
{
    enum status st;
    char *path = NULL;
    struct message sentence = {""};

    t->lived = false;
    verify_subject_settings(t->subject, t->net, &t->settings);
    TRY(scene_file_find(t->scene, &path, why));
    TRY(run_read(&t->run,
                 &(struct run_plan){path, t->subject->contestant, &t->settings, t->end},
                 why));
    st = run_build(&t->run, &sentence);
    t->row->seconds += t->run.create_seconds;
    if (st == STATUS_INPUT && isnan(t->row->tolerance))
        st = STATUS_UNSUPPORTED; /* one that the check does not know has no such net */
    TRY(tell(t, st, &sentence, why));
out:
    settings_clear(&t->settings);
    free(path);
    return st;
}

void verify_trial_close(struct verify_trial *t)
{
    run_close(&t->run);
}

enum status verify_trial_settle(struct verify_trial *t, struct message *why)
{
    enum status st;
    struct counters work = {0};
    struct message sentence = {""};

    TRY(verify_trial_open(t, why));
    if (!t->lived)
        goto out;
    const double start = clock_now();
    st = run_settle(&t->run, &work, &sentence);
    t->row->seconds += clock_now() - start;
    TRY(tell(t, st, &sentence, why));
out:
    return st;
}

enum status verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw,
                                     double *xyz, struct message *why)
{
    const enum status st = verify_trial_settle(t, why);

    if (t->lived)
        t->run.model->probe(t->run.state, n, uvw, xyz);
    verify_trial_close(t);
    return st;
}

/* Modes of what open() leaves. */
static enum status find_modes(struct verify_trial *t,
                              enum status (*open)(struct verify_trial *, struct message *),
                              int count, double *omega, struct message *why)
{
    enum status st;
    struct message sentence = {""};

    TRY(open(t, why));
    if (!t->lived)
        goto out;
    const double start = clock_now();
    st = run_modes(&t->run, count, omega, &sentence);
    t->row->seconds += clock_now() - start;
    TRY(tell(t, st, &sentence, why));
out:
    verify_trial_close(t);
    return st;
}

enum status verify_trial_modes(struct verify_trial *t, int count, double *omega,
                               struct message *why)
{
    return find_modes(t, verify_trial_open, count, omega, why);
}

enum status verify_trial_settled_modes(struct verify_trial *t, int count, double *omega,
                                       struct message *why)
{
    return find_modes(t, verify_trial_settle, count, omega, why);
}

enum status verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context,
                               struct message *why)
{
    enum status st;
    struct motion m = {0};

    TRY(verify_trial_open(t, why));
    if (!t->lived)
        goto out;
    TRY(motion_init(&m, t->run.model, &t->run.scene, t->run.state));
    TRY(motion_run(&m, watch, context, true, why));
    for (int i = 0; i < m.steps; i++)
        t->row->seconds += m.seconds[i];
    if (m.death != STATUS_OK) {
        verify_row_end(t->row, VERIFY_DIED, "at %g s: %s", m.death_time,
                       status_text(m.death));
        t->lived = false;
    }
out:
    motion_clear(&m);
    verify_trial_close(t);
    return st;
}

/* Keeps the points at the times that are wanted. */
struct keeper {
    int times, n, kept;
    const double *time, *uvw;
    double *xyz; /* [times][n][3] */
};

static enum status keep(void *context, const struct motion *m, struct message *why)
{
    struct keeper *k = context;

    (void)why;
    if (k->kept == k->times || m->time < k->time[k->kept] - m->scene->step / 4)
        return STATUS_OK;
    m->model->probe(m->state, k->n, k->uvw, k->xyz + 3 * (size_t)k->n * k->kept);
    k->kept++;
    return STATUS_OK;
}

enum status verify_trial_motion(struct verify_trial *t, int times, const double *time,
                                int n, const double *uvw, double *xyz, struct message *why)
{
    struct keeper k = {.times = times, .n = n, .time = time, .uvw = uvw, .xyz = xyz};

    t->end = time[times - 1];
    return verify_trial_watch(t, keep, &k, why);
}

enum status verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure,
                              void *context, double truth, double bar, struct message *why)
{
    enum status st = STATUS_OK;
    double value = NAN, error[VERIFY_NETS];

    for (t->net = 0; t->net < t->subject->nets; t->net++) {
        TRY(measure(t, context, &value, why));
        if (!t->lived)
            goto out;
        error[t->net] = isnan(truth) ? value : fabs(value - truth) / fabs(truth);
    }
    if (isnan(truth))
        verify_row_judge_error(t->row, value, bar);
    else
        verify_row_judge(t->row, value, truth, bar);
    t->row->order = verify_subject_order(t->subject, error, bar);
out:
    return st;
}
