#include "bench/verify/verify_trial.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    TRY(contestant_read_scene(&(struct settings){0}, path, scene, why));
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

/* --- Refinement. */

/* The runs of one subject. */
struct runs {
    const struct verify_trial_refine *r;
    const struct verify_subject *subject;
    struct verify_row scratch; /* of the runs that are no rows                          */
    double *field[2];          /* [times][n][3] of the last run and the one before      */
};

/* Net `net`, the finest step times 2^coarser; into field[0]. */
static bool run(struct runs *runs, struct verify_row *row, int net, int coarser)
{
    const struct verify_trial_refine *r = runs->r;
    struct verify_trial t = {row, runs->subject, r->scene, net};

    settings_list(&t.settings, INT_MAX, r->settings);
    settings_number(&t.settings, "time.step", r->step * (1 << coarser));
    return verify_trial_motion(&t, r->times, r->time, r->n, r->uvw, runs->field[0]);
}

static double error_of(const struct runs *runs)
{
    return runs->r->measure(runs->r->context, runs->field[0], runs->r->truth);
}

static void swap_fields(struct runs *runs)
{
    double *last = runs->field[0];

    runs->field[0] = runs->field[1];
    runs->field[1] = last;
}

/* The coarser nets, with the finest step: their errors into the row's note, its order from
 * the last two. Leaves the row's verdict as it is. */
static void refine_net(struct runs *runs, struct verify_row *row)
{
    double coarser = NAN;

    for (int n = 0; n + 1 < runs->subject->nets; n++) {
        coarser = run(runs, &runs->scratch, n, 0) ? error_of(runs) : NAN;
        verify_row_note(row, "error on %dx%d: %.2g", runs->subject->along[n],
                        runs->subject->across[n], coarser);
    }
    row->order = log2(coarser / row->error);
    row->seconds += runs->scratch.seconds;
}

/* The coarser steps; field[0] is the finest run's. */
static void refine_step(struct runs *runs, struct verify_row *row)
{
    const struct verify_trial_refine *r = runs->r;
    double change[VERIFY_TRIAL_STEPS] = {NAN, NAN, NAN};
    bool lived = true;

    runs->scratch.seconds = 0;
    for (int n = 1; n < r->steps && lived; n++) {
        swap_fields(runs);
        lived = run(runs, &runs->scratch, runs->subject->nets - 1, n);
        if (!lived)
            break;
        change[n - 1] = r->measure(r->context, runs->field[0], runs->field[1]);
        verify_row_note(row, "error with %g ms: %.2g", 1e3 * r->step * (1 << n),
                        error_of(runs));
    }
    if (lived)
        verify_row_judge_error(row, change[0], NAN);
    else
        verify_row_end(row, VERIFY_NOT_APPLICABLE, "a coarser step %s", runs->scratch.note);
    row->order = log2(change[1] / change[0]);
    row->seconds += runs->scratch.seconds;
}

/* The rows, once there is room. */
static bool add_rows(struct runs *runs, const char *quantity)
{
    const struct verify_trial_refine *r = runs->r;
    struct verify_subject unclaimed = *runs->subject;
    struct verify_row *row = verify_sheet_add(&unclaimed, "%s", quantity);

    if (!run(runs, row, unclaimed.nets - 1, 0))
        return false;
    verify_row_judge_error(row, error_of(runs), r->bar);
    if (r->field)
        memcpy(r->field, runs->field[0], 3 * sizeof(double) * (size_t)(r->times * r->n));
    if (r->beyond)
        verify_row_end(row, VERIFY_OUT_OF_RANGE, "%s", r->beyond);
    if (unclaimed.nets > 1) { /* they must leave the finest run's field */
        swap_fields(runs);
        refine_net(runs, row);
        swap_fields(runs);
    }
    if (r->steps > 1) {
        unclaimed.tolerance = NAN;
        unclaimed.reason = NULL;
        row = verify_sheet_add(&unclaimed, "%s: change by step %g to %g ms", quantity,
                               2e3 * r->step, 1e3 * r->step);
        refine_step(runs, row);
    }
    return true;
}

bool verify_trial_refine(const struct verify_subject *subject,
                         const struct verify_trial_refine *r, const char *quantity)
{
    const size_t size = 3 * (size_t)r->times * (size_t)r->n;
    double *room = malloc(2 * size * sizeof *room);
    struct runs runs = {r, subject, .field = {room, room + size}};
    const bool lived =
        verify_sheet_holds(subject->sheet, room ? STATUS_OK : STATUS_MEMORY) &&
        add_rows(&runs, quantity);

    free(room);
    return lived;
}
