#include "bench/verify/verify_refine.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The runs of one subject. */
struct runs {
    const struct verify_refine *r;
    const struct verify_subject *subject;
    struct verify_row scratch; /* of the runs that are no rows                          */
    double *field[2];          /* [times][n][3] of the last run and the one before      */
};

static enum status runs_init(struct runs *runs, const struct verify_refine *r,
                             const struct verify_subject *subject)
{
    *runs = (struct runs){.r = r, .subject = subject};
    for (int k = 0; k < 2; k++) {
        runs->field[k] = malloc(3 * sizeof(double) * (size_t)r->times * (size_t)r->n);
        if (!runs->field[k])
            return STATUS_MEMORY;
    }
    return STATUS_OK;
}

/* Net `net`, the finest step times 2^coarser; into field[0]. */
static enum status run(struct runs *runs, struct verify_row *row, int net, int coarser,
                       bool *lived, struct message *why)
{
    const struct verify_refine *r = runs->r;
    struct verify_trial t = {row, runs->subject, r->scene, net};

    settings_list(&t.settings, INT_MAX, r->settings);
    settings_number(&t.settings, "time.step", r->step * (1 << coarser));
    enum status st =
        verify_trial_motion(&t, r->times, r->time, r->n, r->uvw, runs->field[0], why);
    *lived = t.lived;
    return st;
}

static double error_of(const struct runs *runs)
{
    return runs->r->measure(runs->r->context, runs->field[0], runs->r->truth);
}

/* The coarser nets, with the finest step: their errors into the row's note, its order from
 * the last two. Leaves the row's verdict as it is. */
static enum status refine_net(struct runs *runs, struct verify_row *row,
                              struct message *why)
{
    enum status st = STATUS_OK;
    double coarser = NAN;
    bool lived;

    for (int n = 0; n + 1 < runs->subject->nets; n++) {
        TRY(run(runs, &runs->scratch, n, 0, &lived, why));
        coarser = lived ? error_of(runs) : NAN;
        verify_row_note(row, "error on %dx%d: %.2g", runs->subject->along[n],
                        runs->subject->across[n], coarser);
    }
    row->order = log2(coarser / row->error);
    row->seconds += runs->scratch.seconds;
out:
    return st;
}

/* The coarser steps; field[0] is the finest run's. */
static enum status refine_step(struct runs *runs, struct verify_row *row,
                               struct message *why)
{
    enum status st = STATUS_OK;
    const struct verify_refine *r = runs->r;
    double change[VERIFY_REFINE_STEPS] = {NAN, NAN, NAN};
    bool lived = true;

    runs->scratch.seconds = 0;
    for (int n = 1; n < r->steps && lived; n++) {
        double *last = runs->field[0];
        runs->field[0] = runs->field[1], runs->field[1] = last;
        TRY(run(runs, &runs->scratch, runs->subject->nets - 1, n, &lived, why));
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
out:
    return st;
}

enum status verify_refine(struct verify_sheet *sheet, const struct verify_subject *subject,
                          const struct verify_refine *r, const char *quantity, bool *lived,
                          struct message *why)
{
    enum status st;
    struct runs runs;
    struct verify_subject unclaimed = *subject;
    struct verify_row *row = verify_sheet_add(sheet, subject, "%s", quantity);

    unclaimed.tolerance = NAN;
    unclaimed.reason = NULL;
    TRY(runs_init(&runs, r, subject));
    TRY(run(&runs, row, subject->nets - 1, 0, lived, why));
    if (!*lived)
        goto out;
    verify_row_judge_error(row, error_of(&runs), r->bar);
    if (r->field)
        memcpy(r->field, runs.field[0], 3 * sizeof(double) * (size_t)(r->times * r->n));
    if (r->beyond)
        verify_row_end(row, VERIFY_OUT_OF_RANGE, "%s", r->beyond);
    if (subject->nets > 1) { /* they must leave the finest run's field */
        double *finest = runs.field[0];
        runs.field[0] = runs.field[1];
        TRY(refine_net(&runs, row, why));
        runs.field[1] = runs.field[0];
        runs.field[0] = finest;
    }
    if (r->steps > 1) {
        row = verify_sheet_add(sheet, &unclaimed, "%s: change by step %g to %g ms",
                               quantity, 2e3 * r->step, 1e3 * r->step);
        TRY(refine_step(&runs, row, why));
    }
out:
    free(runs.field[0]);
    free(runs.field[1]);
    return st;
}
