#define _GNU_SOURCE /* vasprintf */
#include "bench/verify/verify_check.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"
#include "models/clock.h"

void verify_trial_set(struct verify_trial *t, const char *settings, ...)
{
    va_list arguments;
    char *text = NULL, *rest = NULL;

    va_start(arguments, settings);
    if (vasprintf(&text, settings, arguments) < 0)
        text = NULL, t->settings.status = STATUS_MEMORY;
    va_end(arguments);
    for (char *one = text ? strtok_r(text, ";", &rest) : NULL; one;
         one = strtok_r(NULL, ";", &rest))
        settings_set(&t->settings, one + strspn(one, " "));
    free(text);
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

bool verify_trial_open(struct verify_trial *t)
{
    struct verify_sheet *sheet = t->subject->sheet;
    struct message sentence = {""};

    t->lived = false;
    verify_subject_settings(t->subject, t->net, &t->settings);
    if (verify_sheet_sound(sheet) &&
        verify_sheet_holds(sheet,
                           run_read(&t->run,
                                    &(struct run_plan){t->scene, t->subject->contestant,
                                                       &t->settings, t->end},
                                    &sheet->why))) {
        enum status built = run_build(&t->run, &sentence);
        t->row->seconds += t->run.create_seconds;
        if (built == STATUS_INPUT && isnan(t->row->tolerance))
            built =
                STATUS_UNSUPPORTED; /* one that the check does not know has no such net */
        tell(t, built, &sentence);
    }
    settings_clear(&t->settings);
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

double *verify_trial_matrix(struct verify_trial *t, bool mass, int *rows)
{
    struct verify_sheet *sheet = t->subject->sheet;
    struct matrix sparse[2] = {{0}};
    double *full = NULL;

    *rows = 0;
    if (t->subject->layers) /* solids may have other unknowns than control points */
        settings_set(&t->settings, "discretization.unknowns=points");
    if (!verify_trial_open(t))
        return NULL;
    const struct model *model = t->run.model;
    const enum status st = model->matrices
                               ? model->matrices(t->run.state, &sparse[0], &sparse[1])
                               : STATUS_UNSUPPORTED;
    if (st == STATUS_UNSUPPORTED)
        verify_row_end(t->row, VERIFY_NOT_APPLICABLE,
                       model->matrices ? "it has none for control points as unknowns"
                                       : "it has no constant matrices");
    else if (verify_sheet_holds(sheet, st)) {
        const struct matrix *m = &sparse[mass];
        const size_t n = (size_t)m->rows;
        *rows = m->rows;
        full = calloc(n * n, sizeof *full);
        verify_sheet_holds(sheet, full ? STATUS_OK : STATUS_MEMORY);
        for (long i = 0; full && i < m->entries; i++) /* of a lower triangle */
            full[(size_t)m->row[i] * n + (size_t)m->column[i]] =
                full[(size_t)m->column[i] * n + (size_t)m->row[i]] = m->value[i];
    }
    matrix_clear(&sparse[0]);
    matrix_clear(&sparse[1]);
    return full;
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
        if (!t->lived) {
            t->row->value = t->row->truth = t->row->bar = NAN;
            return false;
        }
        error[t->net] = isnan(truth) ? value : fabs(value - truth) / fabs(truth);
    }
    if (isnan(bar))
        bar = t->row->bar;
    if (isnan(truth))
        verify_row_judge_error(t->row, value, bar);
    else
        verify_row_judge(t->row, value, truth, bar);
    t->row->order = verify_subject_order(t->subject, error, bar);
    return true;
}

bool verify_trial_worst(struct verify_trial *t, double value, double truth,
                        const double *error, double bar)
{
    const double fine = error[t->subject->nets - 1];

    if (fine <= t->row->error)
        return false;
    t->row->value = value;
    t->row->truth = truth;
    t->row->order = verify_subject_order(t->subject, error, bar);
    verify_row_judge_error(t->row, fine, bar);
    return true;
}

/* --- Refinement. */

/* Net `net`, the finest step times 2^coarser. */
static bool move(const struct verify_subject *s, const struct verify_trial_refine *r,
                 struct verify_row *row, int net, int coarser, double *field)
{
    struct verify_trial t = {row, s, r->scene, net};

    settings_list(&t.settings, INT_MAX, r->settings);
    settings_number(&t.settings, "time.step", r->step * (1 << coarser));
    return verify_trial_motion(&t, r->times, r->time, r->n, r->uvw, field);
}

/* Of halves: by the error (or change) before and after. */
static double order_of(double before, double after)
{
    return fit_exponent(2, (double[]){2, 1}, (double[]){before, after});
}

/* The coarser nets, with the finest step: their errors into the row's note, its order from
 * the last two. Leaves the row's verdict as it is. */
static void refine_net(const struct verify_subject *s, const struct verify_trial_refine *r,
                       struct verify_row *row, double *field)
{
    struct verify_row scratch = {.seconds = 0}; /* of the runs that are no rows           */
    double coarser = NAN;

    for (int n = 0; n + 1 < s->nets; n++) {
        const bool lived = move(s, r, &scratch, n, 0, field);
        coarser = lived ? r->measure(r->context, field, r->truth) : NAN;
        verify_row_note(row, "error on %dx%d: %.2g", s->along[n], s->across[n], coarser);
    }
    if (s->nets > 1)
        row->order = order_of(coarser, row->error);
    row->seconds += scratch.seconds;
}

/* The coarser steps, each against the one before; field[0] is the finest run's. */
static void refine_step(const struct verify_subject *s, const struct verify_trial_refine *r,
                        struct verify_row *row, double *const field[3])
{
    struct verify_row scratch = {.seconds = 0};
    double change[VERIFY_TRIAL_STEPS] = {NAN, NAN, NAN};
    bool lived = true;

    for (int n = 1; n < r->steps && lived; n++) {
        double *now = field[2 - n % 2], *before = field[n == 1 ? 0 : 1 + n % 2];
        lived = move(s, r, &scratch, s->nets - 1, n, now);
        if (lived) {
            change[n - 1] = r->measure(r->context, now, before);
            verify_row_note(row, "error with %g ms: %.2g", 1e3 * r->step * (1 << n),
                            r->measure(r->context, now, r->truth));
        }
    }
    if (lived)
        verify_row_judge_error(row, change[0], NAN);
    else
        verify_row_end(row, VERIFY_NOT_APPLICABLE, "a coarser step %s", scratch.note);
    row->order = order_of(change[1], change[0]);
    row->seconds += scratch.seconds;
}

bool verify_trial_refine(const struct verify_subject *subject,
                         const struct verify_trial_refine *r, const char *quantity)
{
    const size_t size = 3 * (size_t)r->times * (size_t)r->n;
    double *room = malloc(3 * size * sizeof *room);
    double *const field[] = {room, room + size, room + 2 * size};
    struct verify_subject unclaimed = *subject;
    struct verify_row *row = verify_sheet_add(subject, "%s", quantity);
    const bool lived =
        verify_sheet_holds(subject->sheet, room ? STATUS_OK : STATUS_MEMORY) &&
        move(subject, r, row, subject->nets - 1, 0, room);

    if (lived) {
        verify_row_judge_error(row, r->measure(r->context, room, r->truth), r->bar);
        if (r->field)
            memcpy(r->field, room, size * sizeof *room);
        if (r->beyond)
            verify_row_end(row, VERIFY_OUT_OF_RANGE, "%s", r->beyond);
        refine_net(subject, r, row, field[1]);
    }
    if (lived && r->steps > 1) {
        unclaimed.tolerance = NAN;
        unclaimed.reason = NULL;
        row = verify_sheet_add(&unclaimed, "%s: change by step %g to %g ms", quantity,
                               2e3 * r->step, 1e3 * r->step);
        refine_step(&unclaimed, r, row, field);
    }
    free(room);
    return lived;
}
