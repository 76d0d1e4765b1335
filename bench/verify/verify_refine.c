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

/* Net `net`, the finest step times 2^coarser; into field[0]. */
static bool run(struct runs *runs, struct verify_row *row, int net, int coarser)
{
    const struct verify_refine *r = runs->r;
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
    const struct verify_refine *r = runs->r;
    double change[VERIFY_REFINE_STEPS] = {NAN, NAN, NAN};
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
    const struct verify_refine *r = runs->r;
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

bool verify_refine(const struct verify_subject *subject, const struct verify_refine *r,
                   const char *quantity)
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
