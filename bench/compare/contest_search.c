/* Where a contestant is tried next (contest.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/compare/contest.h"
#include "bench/harness/timing.h"

/* Points along or across that differ by less than this share of the more are as good as
 * one.
 */
static const double CLOSE = 0.1;

/* Steps and iterations that differ by a factor up to this are. */
static const int NEAR = 2;

/* Seconds grow with each size by itself: as many more points, iterations or steps; but with
 * points along u by the square, as of shorter cells some have to take shorter steps. Both
 * ways at once is the cube. */
static const double growth[CONTEST_AXES] = {
    [CONTEST_NET] = 2, [CONTEST_ACROSS] = 1, [CONTEST_STEP] = 1, [CONTEST_ITERATIONS] = 1};

/* Of points across, fewer tell nothing of what varies there. */
enum { LEAST_ACROSS = 3 };

struct search {
    const struct contest *contest;
    const struct contest_wish *wish;
    struct contest_at *at;
    int count;
};

static bool is_known(const struct search *s, const struct contest_at *at)
{
    bool known = false;

    for (int n = 0; n < s->contest->count; n++)
        known |= contest_is_at(&s->contest->rows[n].at, at);
    for (int n = 0; n < s->count; n++)
        known |= contest_is_at(&s->at[n], at);
    return known;
}

/* Of a run, from what another one took. */
static double expected(const struct contest_row *from, const struct contest_at *at)
{
    double seconds = from->seconds;

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (at->size[axis])
            seconds *= pow((double)at->size[axis] / from->at.size[axis], growth[axis]);
    return seconds;
}

static void propose(struct search *s, const struct contest_row *from,
                    const struct contest_at *at)
{
    if (!is_known(s, at) && expected(from, at) <= s->wish->longest)
        s->at[s->count++] = *at;
}

/* The finest of those that `row` becomes when it is made coarser along an axis, and that
 * miss the target; NULL: none was tried. */
static const struct contest_row *coarser_miss(const struct contest *c,
                                              const struct contest_row *row,
                                              enum contest_axis axis, double target)
{
    const struct contest_row *miss = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        const struct contest_at moved = contest_moved(c, &row->at, axis, r->at.size[axis]);
        if (r->at.size[axis] < row->at.size[axis] && contest_is_at(&r->at, &moved) &&
            !(r->worst <= target) && (!miss || r->at.size[axis] > miss->at.size[axis]))
            miss = r;
    }
    return miss;
}

/* Between a size that misses and one that meets; the latter where they are close enough. */
static int between(enum contest_axis axis, int misses, int meets)
{
    if (axis == CONTEST_NET || axis == CONTEST_ACROSS)
        return meets - misses > fmax(1, CLOSE * meets) ? (misses + meets) / 2 : meets;
    return meets > NEAR * misses ? (int)lround(sqrt((double)misses * meets)) : meets;
}

/* Of a contestant along an axis. */
static int least_size(const struct contestant *who, enum contest_axis axis)
{
    const int span = contestant_least(who);

    return axis == CONTEST_NET      ? span
           : axis == CONTEST_ACROSS ? (int)fmax(span, LEAST_ACROSS)
                                    : 1;
}

/* From the cheapest that meets a target towards what is coarser and may meet it, too. */
static void cheapen(struct search *s, const struct contestant *who, double target)
{
    const struct contest_row *row = contest_cheapest(s->contest, who, target);

    for (enum contest_axis axis = 0; row && axis < CONTEST_AXES; axis++) {
        const struct contest_row *miss = coarser_miss(s->contest, row, axis, target);
        const int size = row->at.size[axis], least = least_size(who, axis);
        if (size <= least)
            continue;
        const int less =
            miss ? between(axis, miss->at.size[axis], size) : (int)fmax(least, size / 2);
        const struct contest_at at = contest_moved(
            s->contest, &row->at, axis, contest_fit(s->contest, who, axis, less));
        propose(s, row, &at);
    }
}

/* Square cells across alone only when they were refined both ways: that is what they want.
 */
static void refine(struct search *s, const struct contest_row *row)
{
    const struct contest *c = s->contest;
    const int *size = row->at.size;
    const bool strip =
        size[CONTEST_ACROSS] < contest_across(c, row->at.contestant, size[CONTEST_NET]);
    struct contest_at at;

    for (enum contest_axis axis = 0; axis < CONTEST_AXES; axis++) {
        const bool early =
            axis == CONTEST_ACROSS && !strip && contest_probe(c, row, CONTEST_NET, &at);
        if (!early && contest_probe(c, row, axis, &at))
            propose(s, row, &at);
    }
}

/* With half the points across, unless that was found to be too few. */
static void narrow(struct search *s, const struct contest_row *row, double target)
{
    const enum contest_axis across = CONTEST_ACROSS;
    const int size = row->at.size[across], least = least_size(row->at.contestant, across);

    if (size <= least || coarser_miss(s->contest, row, across, target))
        return;
    const int less =
        contest_fit(s->contest, row->at.contestant, across, (int)fmax(least, size / 2));
    const struct contest_at at = contest_moved(s->contest, &row->at, across, less);
    propose(s, row, &at);
}

/* From the nearest in every way, unless it is as near as anyone asks or can tell: but first
 * from the cheapest that is as near but for what counts as no gain, and before that with
 * fewer points across, so that nobody pays for those on the way where they show nothing. */
static void sharpen(struct search *s, const struct contestant *who)
{
    const struct contest *c = s->contest;
    const struct contest_limit limit = contest_limit(c, who);
    const int before = s->count;

    if (!limit.best || limit.kind == CONTEST_BY_TRUTH ||
        limit.best->worst <= s->wish->target[s->wish->count - 1])
        return;
    const double target = limit.best->worst / (1 - CONTEST_LEAST_GAIN);
    const struct contest_row *cheap = contest_cheapest(c, who, target);
    narrow(s, cheap, target);
    if (s->count == before)
        refine(s, cheap);
    if (s->count == before)
        refine(s, limit.best);
}

int contest_search(const struct contest *c, const struct contestant *who,
                   const struct contest_wish *wish, struct contest_at at[CONTEST_PROPOSALS])
{
    struct search s = {c, wish, at, 0};

    for (int t = 0; t < wish->count; t++)
        cheapen(&s, who, wish->target[t]);
    sharpen(&s, who);
    return s.count;
}

/* --- all contestants, and a budget -------------------------------------------------------
 */

/* Share of a budget that is for the search; the rest tells what limits each. */
static const double SHARE = 0.8;

/* Runs within a budget are tried up to so much of the longest, then so many times more. */
static const double FIRST = 1.0 / 256, DEARER = 4;

enum { MOST_ROUNDS = 60 };

/* A run that may be made. */
struct contest_try {
    struct contest_at at;
    double seconds; /* expected of one repeat */
    int order;
};

struct tries {
    struct contest_try *list;
    int count;
};

double contest_spent(const struct contest *c)
{
    double spent = 0;

    for (int n = 0; n < c->count; n++) {
        const struct run_result *r = &c->rows[n].result;
        const int timed = c->rows[n].probe ? 0 : r->create.count;
        spent += r->create_seconds + r->step_seconds + r->look_seconds;
        if (timed)
            spent += timed * c->rows[n].seconds;
    }
    return spent;
}

/* What a run takes by the run of its contestant that is least unlike it; all of them
 * refused: nothing. */
static double expected_of(const struct contest *c, const struct contest_at *at)
{
    double least = INFINITY, seconds = 0;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != at->contestant || !(r->seconds > 0))
            continue;
        const double unlike = fabs(log(expected(r, at) / r->seconds));
        if (unlike < least)
            least = unlike, seconds = expected(r, at);
    }
    return seconds;
}

static void add_try(const struct contest *c, struct tries *t, const struct contest_at *at)
{
    t->list[t->count] = (struct contest_try){*at, expected_of(c, at), t->count};
    t->count++;
}

/* All that a contestant may still try: rungs up to `dearest`, and what the search wants. */
static void add_tries(const struct contest *c, const struct contestant *who, double longest,
                      double dearest, struct tries *t)
{
    struct contest_at at[CONTEST_RUNGS + CONTEST_PROPOSALS];
    const struct search known = {.contest = c};
    const int rungs = contest_ladder(c, who, at);

    for (int n = 0; n < rungs; n++)
        if (!is_known(&known, &at[n]) && expected_of(c, &at[n]) <= dearest)
            add_try(c, t, &at[n]);
    const struct contest_wish wish = {CONTEST_TARGETS, contest_target, longest};
    const int count = contest_search(c, who, &wish, at);
    for (int n = 0; n < count; n++) {
        bool twice = false;
        for (int k = 0; k < t->count; k++)
            twice |= contest_is_at(&t->list[k].at, &at[n]);
        if (!twice)
            add_try(c, t, &at[n]);
    }
}

static enum status find_tries(const struct contest *c, double longest, double dearest,
                              struct tries *t)
{
    const struct contestant *who;
    int entrants = 0;

    while (contest_entrant(c, entrants))
        entrants++;
    *t = (struct tries){calloc((size_t)entrants * (CONTEST_RUNGS + CONTEST_PROPOSALS) + 1,
                               sizeof *t->list)};
    if (!t->list)
        return STATUS_MEMORY;
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        add_tries(c, who, longest, dearest, t);
    return STATUS_OK;
}

static int cheaper(const void *a, const void *b)
{
    const struct contest_try *left = a, *right = b;

    return left->seconds != right->seconds
               ? (left->seconds > right->seconds) - (left->seconds < right->seconds)
               : left->order - right->order;
}

/* Rows of those that can be paid, cheap first. */
static enum status add_payable(struct contest *c, struct tries *t, double most, bool probe)
{
    double spent = contest_spent(c);
    enum status st = STATUS_OK;
    struct contest_row *row;

    if (c->budget > 0)
        qsort(t->list, (size_t)t->count, sizeof *t->list, cheaper);
    for (int n = 0; n < t->count; n++) {
        const double seconds = t->list[n].seconds;
        spent += seconds * (1 + (probe ? 0 : timing_repeats(seconds, c->quick)));
        if (c->budget > 0 && spent > most)
            break;
        TRY(contest_add(c, &t->list[n].at, &row));
        row->probe = probe;
    }
out:
    return st;
}

/* Rounds of runs up to `longest`. */
static enum status search_to(struct contest *c, double longest, double dearest,
                             contest_measure *measure, void *context, struct message *why)
{
    struct tries t = {0};
    enum status st = STATUS_OK;

    for (int round = 0; round < MOST_ROUNDS; round++) {
        const int first = c->count;
        free(t.list);
        TRY(find_tries(c, longest, dearest, &t));
        TRY(add_payable(c, &t, SHARE * c->budget, false));
        if (c->count == first)
            break;
        TRY(measure(context, first, why));
    }
out:
    free(t.list);
    return st;
}

enum status contest_tell_unsearched(struct contest *c)
{
    const struct contestant *who;
    struct tries t;
    size_t used = 0;
    const enum status st = find_tries(c, c->longest, INFINITY, &t);

    c->unsearched[0] = '\0';
    for (int k = 0; st == STATUS_OK && (who = contest_entrant(c, k)); k++) {
        int count = 0;
        for (int n = 0; n < t.count; n++)
            count += t.list[n].at.contestant == who;
        if (count && used < sizeof c->unsearched)
            used += (size_t)snprintf(c->unsearched + used, sizeof c->unsearched - used,
                                     "%s%s %d", used ? ", " : "", who->name, count);
    }
    free(t.list);
    return st;
}

enum status contest_search_all(struct contest *c, contest_measure *measure, void *context,
                               struct message *why)
{
    double longest = c->budget > 0 ? FIRST * c->longest : c->longest;
    enum status st = STATUS_OK;

    for (; longest < c->longest; longest *= DEARER)
        TRY(search_to(c, longest, longest, measure, context, why));
    TRY(search_to(c, c->longest, INFINITY, measure, context, why));
    if (c->budget > 0)
        TRY(contest_tell_unsearched(c));
out:
    return st;
}

enum status contest_search_limits(struct contest *c)
{
    const struct contestant *who;
    struct tries t = {0};
    enum status st;

    TRY(find_tries(c, 0, 0, &t)); /* room */
    t.count = 0;
    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const struct contest_limit limit = contest_limit(c, who);
        struct contest_at at;
        for (int axis = 0; limit.best && axis < CONTEST_AXES; axis++)
            if (limit.kind != CONTEST_BY_TRUTH &&
                contest_probe(c, limit.best, (enum contest_axis)axis, &at))
                add_try(c, &t, &at);
    }
    TRY(add_payable(c, &t, c->budget, true));
out:
    free(t.list);
    return st;
}

static int ascending(const void *a, const void *b)
{
    const double *left = a, *right = b;

    return (*left > *right) - (*left < *right);
}

/* Seconds of the best rows, as many as fit. */
static int list_best(const struct contest *c, int most, double *seconds)
{
    int count = 0;

    for (int n = 0; n < c->count && count < most; n++)
        if (contest_is_best(c, &c->rows[n]))
            seconds[count++] = c->rows[n].seconds;
    return count;
}

void contest_choose_best(struct contest *c)
{
    enum { MOST = 1024 };
    double seconds[MOST], spent = 0, longest = 0;

    c->team_longest = INFINITY;
    if (!(c->budget > 0))
        return;
    const int count = list_best(c, MOST, seconds);
    qsort(seconds, (size_t)count, sizeof *seconds, ascending);
    for (int n = 0; n < count; n++) {
        spent += seconds[n] * (1 + timing_repeats(seconds[n], c->quick));
        if (spent > (1 - SHARE) * c->budget)
            break;
        longest = seconds[n];
    }
    c->team_longest = longest;
}
