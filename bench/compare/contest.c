#include "bench/compare/contest.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/net_fit.h"
#include "bench/harness/timing.h"
#include "models/metric/metric.h"

const double contest_target[CONTEST_TARGETS] = {0.03, 0.02, 0.01, 0.005, 0.002};

enum status contest_add(struct contest *c, const struct contest_at *at,
                        struct contest_row **row)
{
    if (c->count == c->room) {
        const int room = 2 * c->room + 16;
        struct contest_row *rows = realloc(c->rows, (size_t)room * sizeof *rows);
        if (!rows)
            return STATUS_MEMORY;
        c->rows = rows, c->room = room;
    }
    *row = &c->rows[c->count++];
    **row = (struct contest_row){.at = *at};
    return STATUS_OK;
}

/* Fewer cells across a strip show nothing that varies there. */
enum { LEAST_ACROSS = 3 };

int contest_across(const struct contest *c, const struct contestant *who, int along)
{
    const double shape = c->scene->width / c->scene->length;
    const long cells = lround((along - who->degree) * shape);

    return (int)fmin(along, who->degree + fmax(LEAST_ACROSS, (double)cells));
}

struct contest_at contest_square(const struct contest *c, const struct contestant *who,
                                 int along, int step, int iterations)
{
    return (struct contest_at){who,
                               {along, contest_across(c, who, along), step, iterations}};
}

struct contest_at contest_moved(const struct contest *c, const struct contest_at *at,
                                enum contest_axis axis, int size)
{
    struct contest_at moved = *at;
    int *across = &moved.size[CONTEST_ACROSS];

    moved.size[axis] = size;
    if (axis != CONTEST_NET)
        return moved;
    const int here = contest_across(c, at->contestant, at->size[CONTEST_NET]);
    const int there = contest_across(c, at->contestant, size);
    *across = *across == here  ? there
              : *across < here ? (int)fmin(*across, there)
                               : (int)fmax(*across, there);
    return moved;
}

bool contest_is_at(const struct contest_at *a, const struct contest_at *b)
{
    return a->contestant == b->contestant && !memcmp(a->size, b->size, sizeof a->size);
}

/* The same along u, where the square net's points across fit, too. */
static int fit_net(const struct contest *c, const struct contestant *who, int along)
{
    for (int n = along; n - who->degree <= 2 * (along - who->degree); n++) {
        const int across = contest_across(c, who, n);
        if (net_fit_points(c->scene, 0, n, who->degree) == n &&
            net_fit_points(c->scene, 1, across, who->degree) == across)
            return n;
    }
    return along;
}

int contest_fit(const struct contest *c, const struct contestant *who,
                enum contest_axis axis, int size)
{
    if (axis == CONTEST_NET)
        return fit_net(c, who, size);
    const int fit =
        axis == CONTEST_ACROSS ? net_fit_points(c->scene, 1, size, who->degree) : 0;
    return fit ? fit : size;
}

static int length(const int *list, int most)
{
    int n = 0;

    while (n < most && list[n])
        n++;
    return n;
}

int contest_ladder(const struct contest *c, const struct contestant *who,
                   struct contest_at at[CONTEST_RUNGS])
{
    const int sides = length(who->points, c->quick ? 2 : CONTESTANT_STEPS);
    const int divisors = length(who->divisors, c->quick ? 1 : CONTESTANT_STEPS);
    const int iterations = length(who->iterations, CONTESTANT_STEPS);
    int count = 0;

    for (int s = 0, last = 0; s < sides; s++) {
        const int side = contest_fit(c, who, CONTEST_NET, who->points[s]);
        for (int d = 0; d < divisors && side != last; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                at[count++] = contest_square(c, who, side, who->divisors[d],
                                             iterations ? who->iterations[i] : 0);
        last = side;
    }
    return count;
}

void contest_clear(struct contest *c)
{
    free(c->rows);
    c->rows = NULL;
    c->count = c->room = 0;
}

void contest_set_absent(struct contest_row *row)
{
    row->absent = true;
    row->seconds = row->worst = NAN;
    for (int t = 0; t < CONTEST_TIMES; t++)
        row->error[t] = NAN;
}

void contest_drop_absent(struct contest *c)
{
    int kept = 0;

    for (int n = 0; n < c->count; n++)
        if (!c->rows[n].absent)
            c->rows[kept++] = c->rows[n];
    c->count = kept;
}

void contest_fill(const struct contest *c, const struct run_result *r,
                  struct contest_row *row)
{
    const struct truth *truth = c->truth;

    row->worst = 0;
    for (int t = 0; t < truth->times; t++) {
        const bool known = truth->xyz && t < r->frames;
        row->error[t] =
            known ? metric_rmse(r->xyz[t], truth->xyz[t]) / c->scene->length : NAN;
        row->worst = isnan(row->error[t]) || isnan(row->worst)
                         ? NAN /* and stays it */
                         : fmax(row->worst, row->error[t]);
    }
    row->seconds = row->probe ? NAN : r->create.median + r->step.median * (double)r->steps;
    row->result = *r;
    row->result.xyz = NULL, row->result.time = NULL;
}

void contest_fill_team(const struct contest *c, int team, const struct run_result *r,
                       struct contest_row *row)
{
    struct contest_row other = *row;

    contest_fill(c, r, &other);
    row->team_seconds[team] = other.seconds;
    row->parted |= memcmp(other.error, row->error, sizeof row->error) != 0;
}

const struct contestant *contest_entrant(const struct contest *c, int k)
{
    for (int n = 0; n < c->count; n++) {
        const struct contestant *who = c->rows[n].at.contestant;
        int before = 0;
        while (c->rows[before].at.contestant != who)
            before++;
        if (before == n && k-- == 0)
            return who;
    }
    return NULL;
}

double contest_bar(const struct contest *c, int time)
{
    return c->truth->xyz ? c->truth->error[time] / c->scene->length : NAN;
}

double contest_largest_bar(const struct contest *c)
{
    double bar = contest_bar(c, 0);

    for (int n = 1; n < c->truth->times; n++)
        bar = fmax(bar, contest_bar(c, n));
    return bar;
}

/* The least of `what` among a contestant's timed rows within a target and a time. */
enum least { LEAST_ERROR, LEAST_SECONDS };

static const struct contest_row *least(const struct contest *c,
                                       const struct contestant *who, enum least what,
                                       double target, double seconds)
{
    const struct contest_row *best = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != who || r->probe || !(r->worst <= target) ||
            !(r->seconds <= seconds))
            continue;
        if (!best ||
            (what == LEAST_ERROR ? r->worst < best->worst : r->seconds < best->seconds))
            best = r;
    }
    return best;
}

const struct contest_row *contest_nearest(const struct contest *c,
                                          const struct contestant *who)
{
    return least(c, who, LEAST_ERROR, INFINITY, INFINITY);
}

const struct contest_row *contest_cheapest(const struct contest *c,
                                           const struct contestant *who, double target)
{
    return least(c, who, LEAST_SECONDS, target, INFINITY);
}

const struct contest_row *contest_real_time(const struct contest *c,
                                            const struct contestant *who)
{
    return least(c, who, LEAST_ERROR, INFINITY, c->truth->time[c->truth->times - 1]);
}

bool contest_is_best(const struct contest *c, const struct contest_row *row)
{
    const struct contestant *who = row->at.contestant;
    bool best = row == contest_nearest(c, who);

    if (!(row->seconds <= c->team_longest))
        return false;
    for (int n = 0; n < CONTEST_TARGETS; n++)
        best |= row == contest_cheapest(c, who, contest_target[n]);
    return best;
}

bool contest_on_front(const struct contest *c, const struct contest_row *row)
{
    if (row->probe || isnan(row->worst))
        return false;
    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (r->at.contestant == row->at.contestant && !r->probe && r->worst <= row->worst &&
            r->seconds < row->seconds)
            return false;
    return true;
}

double contest_growth(const struct contest *c, const struct contestant *who)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != who || !contest_on_front(c, r))
            continue;
        const double a = -log(r->worst), b = log(r->seconds);
        n++, x += a, y += b, xx += a * a, xy += a * b;
    }
    return n >= 3 ? (n * xy - x * y) / (n * xx - x * x) : NAN;
}

/* --- what limits a contestant --- */

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

/* --- words --- */

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

/* Says what could not be seen: "; step not tried", "; net 60x60 died". */
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

/* --- where to look next --- */

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

/* --- all contestants, and a budget --- */

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
