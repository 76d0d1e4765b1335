#include "bench/verify/verify_trial.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "models/clock.h"
#include "models/reader/scene_file.h"

struct verify_trial verify_trial_of(const struct verify_subject *subject, const char *scene,
                                    const char *quantity, ...)
{
    char text[VERIFY_TEXT];
    va_list arguments;

    va_start(arguments, quantity);
    vsnprintf(text, sizeof text, quantity, arguments);
    va_end(arguments);
    return (struct verify_trial){verify_sheet_add(subject, "%s", text), subject, scene};
}

/* A refusal and a death are the row's, anything else is the sheet's. */
static bool tell(struct verify_trial *t, enum status st, const struct message *sentence)
{
    t->lived = st == STATUS_OK;
    if (st == STATUS_UNSUPPORTED)
        verify_row_end(t->row, VERIFY_NOT_APPLICABLE, "%s", sentence->text);
    else if (status_is_death(st))
        verify_row_end(t->row, VERIFY_DIED, "%s",
                       *sentence->text ? sentence->text : status_text(st));
    else if (st != STATUS_OK)
        verify_sheet_holds(t->subject->sheet,
                           status_fail(&t->subject->sheet->why, st, "%s: %s",
                                       t->subject->contestant->title, sentence->text));
    return t->lived;
}

enum status verify_trial_scene(const char *name, struct scene *scene, struct message *why)
{
    enum status st;
    char *path = NULL;

    TRY(scene_file_find(name, &path, why));
    TRY(settings_read_scene(&(struct settings){0}, path, scene, why));
out:
    free(path);
    return st;
}

bool verify_trial_open(struct verify_trial *t)
{
    enum status st;
    char *path = NULL;
    struct message sentence = {""}, *why = &t->subject->sheet->why;

    t->lived = false;
    verify_subject_settings(t->subject, t->net, &t->settings);
    TRY(scene_file_find(t->scene, &path, why));
    TRY(run_read(&t->run,
                 &(struct run_plan){path, t->subject->contestant, &t->settings, t->end},
                 why));
    enum status built = run_build(&t->run, &sentence);
    t->row->seconds += t->run.create_seconds;
    if (built == STATUS_INPUT && isnan(t->row->tolerance))
        built = STATUS_UNSUPPORTED; /* one that the check does not know has no such net */
    tell(t, built, &sentence);
out:
    verify_sheet_holds(t->subject->sheet, st);
    settings_clear(&t->settings);
    free(path);
    return t->lived;
}

bool verify_trial_settle(struct verify_trial *t)
{
    struct counters work = {0};
    struct message sentence = {""};

    if (!verify_trial_open(t))
        return false;
    const double start = clock_now();
    const enum status st = run_settle(&t->run, &work, &sentence);
    t->row->seconds += clock_now() - start;
    return tell(t, st, &sentence);
}

bool verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw, double *xyz)
{
    if (verify_trial_settle(t))
        t->run.model->probe(t->run.state, n, uvw, xyz);
    run_close(&t->run);
    return t->lived;
}

bool verify_trial_tip(struct verify_trial *t, double xyz[3])
{
    return verify_trial_equilibrium(t, 1, (double[]){1, 0.5, 0.5}, xyz);
}

bool verify_trial_modes(struct verify_trial *t, bool settled, int count, double *omega)
{
    struct message sentence = {""};

    if (settled ? verify_trial_settle(t) : verify_trial_open(t)) {
        const double start = clock_now();
        const enum status st = run_modes(&t->run, count, omega, &sentence);
        t->row->seconds += clock_now() - start;
        tell(t, st, &sentence);
    }
    run_close(&t->run);
    return t->lived;
}

bool verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context)
{
    enum status st = STATUS_OK;
    struct motion m = {0};

    if (!verify_trial_open(t))
        goto out;
    TRY(motion_init(&m, t->run.model, &t->run.scene, t->run.state));
    TRY(motion_run(&m, watch, context, true, &t->subject->sheet->why));
    for (int i = 0; i < m.steps; i++)
        t->row->seconds += m.seconds[i];
    if (m.death != STATUS_OK)
        verify_row_end(t->row, VERIFY_DIED, "at %g s: %s", m.death_time,
                       status_text(m.death));
    t->lived = m.death == STATUS_OK;
out:
    t->lived &= verify_sheet_holds(t->subject->sheet, st);
    motion_clear(&m);
    run_close(&t->run);
    return t->lived;
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

bool verify_trial_motion(struct verify_trial *t, int times, const double *time, int n,
                         const double *uvw, double *xyz)
{
    struct keeper k = {.times = times, .n = n, .time = time, .uvw = uvw, .xyz = xyz};

    t->end = time[times - 1];
    return verify_trial_watch(t, keep, &k);
}

bool verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure, void *context,
                       double truth, double bar)
{
    double value = NAN, error[VERIFY_NETS];

    for (t->net = 0; t->net < t->subject->nets; t->net++) {
        value = measure(t, context);
        if (!t->lived)
            return false;
        error[t->net] = isnan(truth) ? value : fabs(value - truth) / fabs(truth);
    }
    if (isnan(truth))
        verify_row_judge_error(t->row, value, bar);
    else
        verify_row_judge(t->row, value, truth, bar);
    t->row->order = verify_subject_order(t->subject, error, bar);
    return true;
}
