/* What limits a contestant (contest.h), and the words for it. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "bench/compare/contest.h"

static const char *const kind_name[CONTEST_KINDS] = {
    "net",   "net across", "step", "iterations", "truth",
    "model", "unknown",    "died", "refused",    "skipped"};

const char *const contest_rule = "Settings are the same on every scene: stiffnesses, "
                                 "compliances and stable steps follow "
                                 "from E, nu, rho, h and the net by each model's own rule; "
                                 "net, step and iterations alone "
                                 "are searched.";

const char *contest_kind_name(enum contest_kind kind)
{
    return kind_name[kind];
}

bool contest_is_finer(const struct contest *c, const struct contest_at *a,
                      const struct contest_at *than, enum contest_axis axis)
{
    const struct contest_at moved = contest_moved(c, than, axis, a->size[axis]);

    return a->size[axis] > than->size[axis] && contest_is_at(a, &moved);
}

/* The least refined of those that are finer than `at` in this alone. */
static const struct contest_row *
find_finer(const struct contest *c, const struct contest_at *at, enum contest_axis axis)
{
    const struct contest_row *next = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (contest_is_finer(c, &r->at, at, axis) &&
            (!next || r->at.size[axis] < next->at.size[axis]))
            next = r;
    return next;
}

/* Steps that a model divides further by itself are refined when their pieces are. */
static int pieces(const struct run_result *r)
{
    const long pieces =
        r->work.steps ? lround((double)r->work.substeps / (double)r->work.steps) : 1;

    return pieces > 1 ? (int)pieces : 1;
}

bool contest_probe(const struct contest *c, const struct contest_row *best,
                   enum contest_axis axis, struct contest_at *at)
{
    const int size = best->at.size[axis];
    const int finer = axis == CONTEST_NET || axis == CONTEST_ACROSS ? size + (size + 1) / 2
                      : axis == CONTEST_STEP ? 2 * size * pieces(&best->result)
                                             : 2 * size;

    *at =
        contest_moved(c, &best->at, axis, contest_fit(c, best->at.contestant, axis, finer));
    return size && !find_finer(c, &best->at, axis);
}

static bool within_bar(const struct contest *c, const struct contest_row *r)
{
    int worst = 0;

    while (r->error[worst] != r->worst)
        worst++;
    return r->worst <= contest_bar(c, worst);
}

/* Why none of its timed runs has an error. */
static enum contest_kind why_none(const struct contest *c, const struct contestant *who)
{
    bool refused = true, skipped = true;

    for (int n = 0; n < c->count; n++)
        if (c->rows[n].at.contestant == who) {
            refused &= run_result_refused(&c->rows[n].result);
            skipped &= c->rows[n].absent;
        }
    return skipped ? CONTEST_SKIPPED : refused ? CONTEST_REFUSED : CONTEST_DIED;
}

struct contest_limit contest_limit(const struct contest *c, const struct contestant *who)
{
    struct contest_limit l = {.kind = CONTEST_BY_MODEL, .best = contest_nearest(c, who)};
    double most = CONTEST_LEAST_GAIN;

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        l.gain[axis] = NAN;
    if (!l.best) {
        l.kind = why_none(c, who);
        return l;
    }
    for (int axis = 0; axis < CONTEST_AXES; axis++) {
        l.finer[axis] = find_finer(c, &l.best->at, axis);
        if (l.finer[axis])
            l.gain[axis] = 1 - l.finer[axis]->worst / l.best->worst;
        if (l.best->at.size[axis] && isnan(l.gain[axis]) && l.kind == CONTEST_BY_MODEL)
            l.kind = CONTEST_BY_UNKNOWN;
        if (l.gain[axis] >= most)
            most = l.gain[axis], l.kind = (enum contest_kind)axis;
    }
    if (within_bar(c, l.best))
        l.kind = CONTEST_BY_TRUTH;
    return l;
}

/* --- words -------------------------------------------------------------------------------
 */

__attribute__((format(printf, 3, 4))) static void append(char *text, size_t size,
                                                         const char *format, ...)
{
    const size_t used = strlen(text);
    va_list list;

    va_start(list, format);
    vsnprintf(text + used, size - used, format, list);
    va_end(list);
}

static void append_size(const struct contest *c, const struct contest_row *r,
                        enum contest_axis axis, char *text, size_t size)
{
    const int *n = r->at.size;

    if (axis == CONTEST_NET || axis == CONTEST_ACROSS)
        append(text, size, "%dx%d", n[CONTEST_NET], n[CONTEST_ACROSS]);
    else if (axis == CONTEST_STEP)
        append(text, size, "%.3g ms", 1e3 * c->scene->step / n[axis]);
    else
        append(text, size, "%d", n[axis]);
}

/* What could not be seen: "; step not tried", "; net 60x60 died". */
static void append_unseen(const struct contest *c, const struct contest_limit *l,
                          char *text, size_t size)
{
    for (int axis = 0; axis < CONTEST_AXES; axis++) {
        const struct contest_row *finer = l->finer[axis];
        if (!l->best->at.size[axis] || !isnan(l->gain[axis]))
            continue;
        append(text, size, "%s%s ", *text ? "; " : "", kind_name[axis]);
        if (!finer || finer->absent) {
            append(text, size, "not tried");
            continue;
        }
        append_size(c, finer, axis, text, size);
        append(text, size, run_result_refused(&finer->result) ? " refused" : " died");
    }
}

/* Those that were refined and did not help: "net, step". */
static void append_idle(const struct contest_limit *l, char *text, size_t size)
{
    const char *comma = "";

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (!isnan(l->gain[axis])) {
            append(text, size, "%s%s", comma, kind_name[axis]);
            comma = ", ";
        }
}

void contest_tell(const struct contest *c, const struct contest_limit *l, char *text,
                  size_t size)
{
    *text = '\0';
    switch (l->kind) {
    case CONTEST_BY_TRUTH:
        append(text, size, "the truth: within its error bar");
        return;
    case CONTEST_DIED:
        append(text, size, "every run died");
        return;
    case CONTEST_REFUSED:
        append(text, size, "not applicable");
        return;
    case CONTEST_SKIPPED:
        append(text, size, "skipped: the budget ended before its first run");
        return;
    case CONTEST_BY_MODEL:
        append(text, size, "the model: finer ");
        append_idle(l, text, size);
        append(text, size, " no nearer");
        return;
    case CONTEST_BY_UNKNOWN:
        append_idle(l, text, size);
        if (*text)
            append(text, size, " no nearer");
        break;
    default:
        append(text, size, "the %s: %.0f %% less at ", kind_name[l->kind],
               100 * l->gain[l->kind]);
        append_size(c, l->finer[l->kind], (enum contest_axis)l->kind, text, size);
    }
    append_unseen(c, l, text, size);
}

void contest_tell_size(const struct contest_row *row, char *text, size_t size)
{
    const int *n = row->at.size;

    *text = '\0';
    append(text, size, "%dx%d/%d", n[CONTEST_NET], n[CONTEST_ACROSS], n[CONTEST_STEP]);
    if (n[CONTEST_ITERATIONS])
        append(text, size, "/%d", n[CONTEST_ITERATIONS]);
}
