/* Where a contestant is tried next (contest.h). */
#include <math.h>

#include "bench/compare/contest.h"

/* Nets that differ by less than this share of the finer are as good as one. */
static const double CLOSE = 0.1;

/* Steps and iterations that differ by a factor up to this are. */
static const int NEAR = 2;

/* Seconds grow with points a side: as many more points, and shorter steps for some. */
static const double GROWTH = 3;

struct search {
    const struct contest *contest;
    const struct contest_wish *wish;
    struct contest_at *at;
    int count;
};

static bool is_at(const struct contest_at *a, const struct contest_at *b)
{
    bool same = a->contestant == b->contestant;

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        same &= a->size[axis] == b->size[axis];
    return same;
}

static bool is_known(const struct search *s, const struct contest_at *at)
{
    bool known = false;

    for (int n = 0; n < s->contest->count; n++)
        known |= is_at(&s->contest->rows[n].at, at);
    for (int n = 0; n < s->count; n++)
        known |= is_at(&s->at[n], at);
    return known;
}

static double expected(const struct contest_row *from, const struct contest_at *at)
{
    double seconds = from->seconds;

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (at->size[axis])
            seconds *= pow((double)at->size[axis] / from->at.size[axis],
                           axis == CONTEST_NET ? GROWTH : 1);
    return seconds;
}

static void propose(struct search *s, const struct contest_row *from,
                    const struct contest_at *at)
{
    if (!is_known(s, at) && expected(from, at) <= s->wish->longest)
        s->at[s->count++] = *at;
}

/* The finest of those that are coarser than `row` along an axis alone and miss the target;
 * NULL: none was tried. */
static const struct contest_row *coarser_miss(const struct contest *c,
                                              const struct contest_row *row,
                                              enum contest_axis axis, double target)
{
    const struct contest_row *miss = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (contest_is_finer(&row->at, &r->at, axis) && !(r->worst <= target) &&
            (!miss || r->at.size[axis] > miss->at.size[axis]))
            miss = r;
    return miss;
}

/* Between a size that misses and one that meets; the latter where they are close enough. */
static int between(enum contest_axis axis, int misses, int meets)
{
    if (axis == CONTEST_NET)
        return meets - misses > fmax(1, CLOSE * meets) ? (misses + meets) / 2 : meets;
    return meets > NEAR * misses ? (int)lround(sqrt((double)misses * meets)) : meets;
}

/* From the cheapest that meets a target towards what is coarser and may meet it, too. */
static void cheapen(struct search *s, const struct contestant *who, double target)
{
    const struct contest_row *row = contest_cheapest(s->contest, who, target);

    for (int axis = 0; row && axis < CONTEST_AXES; axis++) {
        struct contest_at at = row->at;
        const struct contest_row *miss =
            coarser_miss(s->contest, row, (enum contest_axis)axis, target);
        const int least = axis == CONTEST_NET ? contestant_least(who) : 1;
        if (at.size[axis] <= least)
            continue;
        at.size[axis] =
            miss ? between((enum contest_axis)axis, miss->at.size[axis], at.size[axis])
                 : (int)fmax(least, at.size[axis] / 2);
        propose(s, row, &at);
    }
}

/* From the nearest in every way, unless it is as near as anyone asks or can tell. */
static void sharpen(struct search *s, const struct contestant *who)
{
    const struct contest *c = s->contest;
    const struct contest_limit limit = contest_limit(c, who);
    struct contest_at at;

    if (!limit.best || limit.kind == CONTEST_BY_TRUTH ||
        limit.best->worst <= s->wish->target[s->wish->count - 1])
        return;
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (contest_probe(c, limit.best, (enum contest_axis)axis, &at))
            propose(s, limit.best, &at);
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
