#include "bench/compare/contest.h"

#include <math.h>
#include <stdlib.h>

#include "bench/harness/fit.h"
#include "bench/harness/timing.h"
#include "models/metric/metric.h"
#include "models/support_lines.h"

const double contest_target[CONTEST_TARGETS] = {0.03, 0.02, 0.01, 0.005, 0.002};

const char *const contest_rule = "Settings are the same on every scene: stiffnesses, "
                                 "compliances and stable steps follow from E, nu, rho, h "
                                 "and the net by each model's own rule; only net, step and "
                                 "iterations are searched.";

/* --- refinements --- */

/* The least spans across: fewer show nothing that varies there. */
enum { LEAST_ACROSS = 3 };

int contest_across(const struct contest *c, const struct contestant *who, int along)
{
    const double shape = c->scene->width / c->scene->length;
    const long cells = lround((along - who->degree) * shape);

    return (int)fmin(along, who->degree + fmax(LEAST_ACROSS, (double)cells));
}

/* Returns whether cells are longer one way than c->cells times the other. */
static bool has_long_cells(const struct contest *c, const struct contest_at *at)
{
    const int degree = at->contestant->degree, across = at->size[CONTEST_ACROSS] - degree;
    const double square =
        (at->size[CONTEST_NET] - degree) * c->scene->width / c->scene->length;

    return across > fmax(LEAST_ACROSS, c->cells * square) || c->cells * across < square;
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
    if (c->cells > 0 && has_long_cells(c, &moved))
        *across = there;
    return moved;
}

static bool is_same(const struct contest_at *a, const struct contest_at *b)
{
    return a->contestant == b->contestant && !memcmp(a->size, b->size, sizeof a->size);
}

/* Returns whether `a` is what `from` becomes when it is moved along one axis. */
static bool is_along(const struct contest *c, const struct contest_at *a,
                     const struct contest_at *from, enum contest_axis axis)
{
    const struct contest_at moved = contest_moved(c, from, axis, a->size[axis]);

    return is_same(a, &moved);
}

/* Fits a net along u where its square cells' points across fit, too. */
static int fit_net(const struct contest *c, const struct contestant *who, int along)
{
    for (int n = along; n - who->degree <= 2 * (along - who->degree); n++) {
        const int across = contest_across(c, who, n);
        if (support_lines_points(c->scene, 0, n, who->degree) == n &&
            support_lines_points(c->scene, 1, across, who->degree) == across)
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
        axis == CONTEST_ACROSS ? support_lines_points(c->scene, 1, size, who->degree) : 0;
    return fit ? fit : size;
}

/* Returns `at` with the least size along an axis, `size` or more, that fits. */
static struct contest_at moved_to_fit(const struct contest *c, const struct contest_at *at,
                                      enum contest_axis axis, int size)
{
    return contest_moved(c, at, axis, contest_fit(c, at->contestant, axis, size));
}

void contest_settings(const struct contest *c, const struct contest_at *at,
                      struct settings *s)
{
    const int *size = at->size;

    contestant_points(at->contestant, size[CONTEST_NET], size[CONTEST_ACROSS], s);
    settings_number(s, "time.step", c->scene->step / size[CONTEST_STEP]);
    if (size[CONTEST_ITERATIONS])
        settings_integer(s, "discretization.iterations", size[CONTEST_ITERATIONS]);
}

/* Returns the length of a list that zeros end, `most` at most. */
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
        const int side = contest_fit(c, who, CONTEST_NET, who->points[s]),
                  across = contest_across(c, who, side);
        for (int d = 0; d < divisors && side != last; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                at[count++] = (struct contest_at){
                    who, {side, across, who->divisors[d], who->iterations[i]}};
        last = side;
    }
    return count;
}

/* Exponents with which seconds grow with each size by itself: as many more points,
 * iterations or steps; but with points along u by the square, as some shorter cells have to
 * take shorter steps. Both ways at once is the cube. */
static const double growth[CONTEST_AXES] = {
    [CONTEST_NET] = 2, [CONTEST_ACROSS] = 1, [CONTEST_STEP] = 1, [CONTEST_ITERATIONS] = 1};

/* --- rows --- */

struct contest_row *contest_add(struct contest *c, const struct contest_at *at)
{
    c->rows = arena_more(&c->arena, c->rows, (size_t)c->count, sizeof *c->rows);
    struct contest_row *row = &c->rows[c->count++];

    *row = (struct contest_row){.at = *at};
    return row;
}

void contest_clear(struct contest *c)
{
    arena_clear(&c->arena);
    c->rows = NULL;
    c->count = 0;
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
    row->seconds = row->probe   ? NAN
                   : c->advises ? r->create.min + r->step.min * (double)r->steps
                                : r->create.median + r->step.median * (double)r->steps;
    row->result = *r;
    row->result.xyz = NULL,
    row->result.time = NULL; /* and what owns these is the caller's */
    row->result.scene = (struct scene){0}, row->result.arena = (struct arena){0};
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

/* Returns the cost of a row by which the cheapest of its contestant is chosen: its seconds
 * or, for who wants advice, a number that they grow with, of which no clock decides. */
static double cost_of(const struct contest *c, const struct contest_row *row)
{
    double cost = 1;

    if (!c->advises)
        return row->seconds;
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        cost *= pow(fmax(1, row->at.size[axis]), growth[axis]);
    return cost;
}

/* Finds the least error, or the least cost, among a contestant's timed rows within a
 * target and a time. */
static const struct contest_row *least(const struct contest *c,
                                       const struct contestant *who, bool of_error,
                                       double target, double seconds)
{
    const struct contest_row *best = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != who || r->probe || !(r->worst <= target) ||
            !(r->seconds <= seconds) || (c->advises && *r->result.distrust.text))
            continue;
        if (!best || (of_error ? r->worst < best->worst : cost_of(c, r) < cost_of(c, best)))
            best = r;
    }
    return best;
}

const struct contest_row *contest_nearest(const struct contest *c,
                                          const struct contestant *who)
{
    return least(c, who, true, INFINITY, INFINITY);
}

const struct contest_row *contest_cheapest(const struct contest *c,
                                           const struct contestant *who, double target)
{
    return least(c, who, false, target, INFINITY);
}

const struct contest_row *contest_within(const struct contest *c,
                                         const struct contestant *who, double seconds)
{
    return least(c, who, true, INFINITY, seconds);
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
    struct arena own SCOPED(arena_clear) = {0};
    double *error = arena_take(&own, (size_t)c->count, sizeof *error);
    double *seconds = arena_take(&own, (size_t)c->count, sizeof *seconds);
    int count = 0;

    for (int n = 0; n < c->count; n++)
        if (c->rows[n].at.contestant == who && contest_on_front(c, &c->rows[n])) {
            error[count] = c->rows[n].worst;
            seconds[count++] = c->rows[n].seconds;
        }
    return count >= 3 ? -fit_exponent(count, error, seconds) : NAN;
}

/* --- what limits a contestant --- */

const char *const contest_kind_name[CONTEST_KINDS] = {
    "net",     "net across", "step", "iterations", "truth",  "model",
    "unknown", "distrusted", "died", "refused",    "skipped"};

/* Finds the least refined row of those that are finer than `at` in one axis alone; NULL:
 * none is. */
static const struct contest_row *
find_finer(const struct contest *c, const struct contest_at *at, enum contest_axis axis)
{
    const struct contest_row *next = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (r->at.size[axis] > at->size[axis] && is_along(c, &r->at, at, axis) &&
            (!next || r->at.size[axis] < next->at.size[axis]))
            next = r;
    return next;
}

/* Returns the pieces into which a model divided each step by itself: these are refined. */
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

    *at = moved_to_fit(c, &best->at, axis, finer);
    return size && !find_finer(c, &best->at, axis);
}

static bool is_near_bar(const struct contest *c, const struct contest_row *r)
{
    int worst = 0;

    while (r->error[worst] != r->worst)
        worst++;
    return r->worst <= CONTEST_NEAR_BAR * contest_bar(c, worst);
}

/* Returns the reason for which none of a contestant's timed runs has an error. */
static enum contest_kind why_none(const struct contest *c, const struct contestant *who)
{
    bool refused = true, skipped = true, distrusted = false;

    for (int n = 0; n < c->count; n++)
        if (c->rows[n].at.contestant == who) {
            refused &= run_result_refused(&c->rows[n].result);
            skipped &= c->rows[n].absent;
            distrusted |= *c->rows[n].result.distrust.text != 0;
        }
    return distrusted ? CONTEST_DISTRUSTED
           : skipped  ? CONTEST_SKIPPED
           : refused  ? CONTEST_REFUSED
                      : CONTEST_DIED;
}

struct contest_limit contest_limit(const struct contest *c, const struct contestant *who)
{
    struct contest_limit l = {.kind = CONTEST_BY_MODEL,
                              .best = contest_nearest(c, who),
                              .gain = {NAN, NAN, NAN, NAN}};
    double most = CONTEST_LEAST_GAIN;

    if (!l.best) {
        l.kind = why_none(c, who);
        return l;
    }
    for (enum contest_axis axis = 0; axis < CONTEST_AXES; axis++) {
        l.finer[axis] = find_finer(c, &l.best->at, axis);
        if (l.finer[axis])
            l.gain[axis] = 1 - l.finer[axis]->worst / l.best->worst;
        if (l.best->at.size[axis] && isnan(l.gain[axis]) && l.kind == CONTEST_BY_MODEL)
            l.kind = CONTEST_BY_UNKNOWN;
        if (l.gain[axis] >= most)
            most = l.gain[axis], l.kind = (enum contest_kind)axis;
    }
    if (is_near_bar(c, l.best))
        l.kind = CONTEST_BY_TRUTH;
    return l;
}

static void add_size(const struct contest *c, const struct contest_row *r,
                     enum contest_axis axis, struct message *words)
{
    const int *n = r->at.size;

    if (axis == CONTEST_NET || axis == CONTEST_ACROSS)
        message_add(words, "%dx%d", n[CONTEST_NET], n[CONTEST_ACROSS]);
    else if (axis == CONTEST_STEP)
        message_add(words, "%.3g ms", 1e3 * c->scene->step / n[axis]);
    else
        message_add(words, "%d", n[axis]);
}

/* Adds the refinements that tell nothing: "; step not tried", "; net 60x60 died". */
static void add_unseen(const struct contest *c, const struct contest_limit *l,
                       struct message *words)
{
    for (enum contest_axis axis = 0; axis < CONTEST_AXES; axis++) {
        const struct contest_row *finer = l->finer[axis];
        if (!l->best->at.size[axis] || !isnan(l->gain[axis]))
            continue;
        message_add(words, "%s%s ", *words->text ? "; " : "", contest_kind_name[axis]);
        if (!finer || finer->absent) {
            message_add(words, "not tried");
            continue;
        }
        add_size(c, finer, axis, words);
        message_add(words, run_result_refused(&finer->result) ? " refused" : " died");
    }
}

/* Adds the refinements that did not help: "net, step no nearer"; nothing if there are
 * none. */
static void add_idle(const struct contest_limit *l, struct message *words)
{
    struct message idle = {""};

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (!isnan(l->gain[axis]))
            TEXT_JOIN(idle.text, ", ", "%s", contest_kind_name[axis]);
    if (*idle.text)
        message_add(words, "%s no nearer", idle.text);
}

void contest_tell(const struct contest *c, const struct contest_limit *l,
                  struct message *words)
{
    static const char *const begin[CONTEST_KINDS] = {
        [CONTEST_BY_TRUTH] = "the truth: within 1.5 of its error bars",
        [CONTEST_BY_MODEL] = "the model: finer ",
        [CONTEST_DISTRUSTED] = "no run can be trusted",
        [CONTEST_DIED] = "every run died",
        [CONTEST_REFUSED] = "not applicable",
        [CONTEST_SKIPPED] = "skipped: the budget ended before its first run"};

    words->text[0] = '\0';
    if (begin[l->kind])
        message_add(words, "%s", begin[l->kind]);
    if (l->kind == CONTEST_BY_MODEL || l->kind == CONTEST_BY_UNKNOWN)
        add_idle(l, words);
    if (l->kind < CONTEST_BY_TRUTH) {
        message_add(words, "the %s: %.0f %% less at ", contest_kind_name[l->kind],
                    100 * l->gain[l->kind]);
        add_size(c, l->finer[l->kind], (enum contest_axis)l->kind, words);
    }
    if (l->kind < CONTEST_BY_TRUTH || l->kind == CONTEST_BY_UNKNOWN)
        add_unseen(c, l, words);
}

/* --- where to look next --- */

/* Points along or across that differ by less than this share of the more are as good as
 * one. */
static const double CLOSE = 0.1;

/* Steps and iterations that differ by a factor up to this are, too. */
static const int NEAR = 2;

/* Runs that may be made, in the order in which they were found. */
struct tries {
    const struct contest *contest; /* borrowed */
    const struct contest_wish *wish;
    int count;
    struct
    try {
        struct contest_at at;
        double seconds; /* expected of one repeat */
        bool rung;      /* of a ladder: comes first among those of equal seconds */
        int order;
    }
    *list;
    struct arena arena; /* of the list                                          owned */
};

static bool is_known(const struct tries *t, const struct contest_at *at)
{
    bool known = false;

    for (int n = 0; n < t->contest->count; n++)
        known |= is_same(&t->contest->rows[n].at, at);
    for (int n = 0; n < t->count; n++)
        known |= is_same(&t->list[n].at, at);
    return known;
}

/* Predicts the seconds of a run by scaling those of a measured run. */
static double scaled(const struct contest_row *from, const struct contest_at *at)
{
    double seconds = from->seconds;

    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (at->size[axis])
            seconds *= pow((double)at->size[axis] / from->at.size[axis], growth[axis]);
    return seconds;
}

/* Predicts the seconds of a run by the run of its contestant that is least unlike it; 0:
 * all of them were refused. */
static double predicted(const struct contest *c, const struct contest_at *at)
{
    double least = INFINITY, seconds = 0;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != at->contestant || !(r->seconds > 0))
            continue;
        const double unlike = fabs(log(scaled(r, at) / r->seconds));
        if (unlike < least)
            least = unlike, seconds = scaled(r, at);
    }
    return seconds;
}

static void add_try(struct tries *t, const struct contest_at *at, bool rung)
{
    t->list = arena_more(&t->arena, t->list, (size_t)t->count, sizeof *t->list);
    t->list[t->count] = (struct try){*at, predicted(t->contest, at), rung, t->count};
    t->count++;
}

static void propose(struct tries *t, const struct contest_row *from,
                    const struct contest_at *at)
{
    const struct contest *c = t->contest;

    if (!is_known(t, at) && scaled(from, at) <= t->wish->longest &&
        !(c->cells > 0 && has_long_cells(c, at)))
        add_try(t, at, false);
}

/* Finds the finest of the rows that `row` becomes when it is made coarser along an axis,
 * and that miss the target; NULL: none was tried. */
static const struct contest_row *coarser_miss(const struct contest *c,
                                              const struct contest_row *row,
                                              enum contest_axis axis, double target)
{
    const struct contest_row *miss = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (r->at.size[axis] < row->at.size[axis] && is_along(c, &r->at, &row->at, axis) &&
            !(r->worst <= target) && (!miss || r->at.size[axis] > miss->at.size[axis]))
            miss = r;
    return miss;
}

/* Returns a size between one that misses and one that meets; the latter where they are
 * close enough. */
static int between(enum contest_axis axis, int misses, int meets)
{
    if (axis == CONTEST_NET || axis == CONTEST_ACROSS)
        return meets - misses > fmax(1, CLOSE * meets) ? (misses + meets) / 2 : meets;
    return meets > NEAR * misses ? (int)lround(sqrt((double)misses * meets)) : meets;
}

static int least_size(const struct contestant *who, enum contest_axis axis)
{
    const int span = contestant_least(who);

    return axis == CONTEST_NET      ? span
           : axis == CONTEST_ACROSS ? (int)fmax(span, LEAST_ACROSS)
                                    : 1;
}

/* Proposes a row that meets a target with half its size along an axis; where a coarser one
 * is known to miss, a size between, or, without `bisect`, nothing. */
static void coarsen(struct tries *t, const struct contest_row *row, enum contest_axis axis,
                    double target, bool bisect)
{
    const struct contest_row *miss = coarser_miss(t->contest, row, axis, target);
    const int size = row->at.size[axis], least = least_size(row->at.contestant, axis);

    if (size <= least || (miss && !bisect))
        return;
    const int less =
        miss ? between(axis, miss->at.size[axis], size) : (int)fmax(least, size / 2);
    const struct contest_at at = moved_to_fit(t->contest, &row->at, axis, less);
    propose(t, row, &at);
}

/* Proposes from the cheapest that meets a target what is coarser and may meet it, too. */
static void cheapen(struct tries *t, const struct contestant *who, double target)
{
    const struct contest_row *row = contest_cheapest(t->contest, who, target);

    for (enum contest_axis axis = 0; row && axis < CONTEST_AXES; axis++)
        coarsen(t, row, axis, target, true);
}

/* Proposes what is finer along each axis; square cells are refined across alone only after
 * both ways. */
static void refine(struct tries *t, const struct contest_row *row)
{
    const struct contest *c = t->contest;
    const int *size = row->at.size;
    const bool strip =
        size[CONTEST_ACROSS] < contest_across(c, row->at.contestant, size[CONTEST_NET]);
    struct contest_at at;

    for (enum contest_axis axis = 0; axis < CONTEST_AXES; axis++) {
        const bool early =
            axis == CONTEST_ACROSS && !strip && contest_probe(c, row, CONTEST_NET, &at);
        if (!early && contest_probe(c, row, axis, &at))
            propose(t, row, &at);
    }
}

/* Refines the nearest in every way, unless it is as near as is wished or can be told: but
 * first the cheapest that is as near but for what counts as no gain, and before that with
 * fewer points across, so that nobody pays for those on the way where they show nothing. */
static void come_nearer(struct tries *t, const struct contestant *who)
{
    const struct contest *c = t->contest;
    const struct contest_limit limit = contest_limit(c, who);
    const int before = t->count;

    if (!limit.best || limit.kind == CONTEST_BY_TRUTH ||
        limit.best->worst <= t->wish->target[t->wish->count - 1])
        return;
    const double target = limit.best->worst / (1 - CONTEST_LEAST_GAIN);
    const struct contest_row *cheap = contest_cheapest(c, who, target);
    coarsen(t, cheap, CONTEST_ACROSS, target, false);
    if (t->count == before)
        refine(t, cheap);
    if (t->count == before)
        refine(t, limit.best);
}

/* Finds what the search proposes for all contestants and, of their ladders, the rungs up to
 * `dearest` seconds (negative: none). */
static void find_tries(const struct contest *c, const struct contest_wish *wish,
                       double dearest, struct tries *t)
{
    const struct contestant *who;
    struct contest_at rung[CONTEST_RUNGS];

    *t = (struct tries){.contest = c, .wish = wish};
    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        for (int n = 0; n < wish->count; n++)
            cheapen(t, who, wish->target[n]);
        come_nearer(t, who);
        const int rungs = contest_ladder(c, who, rung);
        for (int n = 0; n < rungs; n++)
            if (!is_known(t, &rung[n]) && predicted(c, &rung[n]) <= dearest)
                add_try(t, &rung[n], true);
    }
}

void contest_propose(struct contest *c, const struct contest_wish *wish)
{
    struct tries t;

    find_tries(c, wish, -1, &t);
    for (int n = 0; n < t.count; n++)
        contest_add(c, &t.list[n].at);
    arena_clear(&t.arena);
}

/* --- a budget --- */

/* Share of a budget that is for the search; the rest tells what limits each. */
static const double SHARE = 0.8;

/* Share of the longest run up to which runs within a budget are tried first, and the factor
 * by which it then grows. */
static const double FIRST = 1.0 / 256, DEARER = 4;

enum { MOST_ROUNDS = 60 };

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

static int compare_seconds(const void *a, const void *b)
{
    const struct try *left = a, *right = b;

    if (left->seconds != right->seconds)
        return left->seconds > right->seconds ? 1 : -1;
    return left->rung == right->rung ? left->order - right->order
                                     : right->rung - left->rung;
}

/* Adds rows of the tries that can be paid, cheap ones first. */
static void add_payable(struct contest *c, struct tries *t, double most, bool probe)
{
    double spent = contest_spent(c);

    if (c->budget > 0 && t->count)
        qsort(t->list, (size_t)t->count, sizeof *t->list, compare_seconds);
    for (int n = 0; n < t->count; n++) {
        const double seconds = t->list[n].seconds;
        spent += seconds * (1 + (probe ? 0 : timing_repeats(seconds, c->quick)));
        if (c->budget > 0 && spent > most)
            break;
        contest_add(c, &t->list[n].at)->probe = probe;
    }
}

/* Makes rounds of runs up to `longest` seconds, with rungs up to `dearest`. */
static enum status search_to(struct contest *c, double longest, double dearest,
                             contest_measure *measure, void *context, struct message *why)
{
    const struct contest_wish wish = {CONTEST_TARGETS, contest_target, longest};
    struct tries t;

    for (int round = 0; round < MOST_ROUNDS; round++) {
        const int first = c->count;
        find_tries(c, &wish, dearest, &t);
        add_payable(c, &t, SHARE * c->budget, false);
        arena_clear(&t.arena);
        if (c->count == first)
            break;
        CALL(measure(context, first, why));
    }
    return STATUS_OK;
}

void contest_tell_unsearched(struct contest *c)
{
    const struct contest_wish wish = {CONTEST_TARGETS, contest_target, c->longest};
    const struct contestant *who;
    struct tries t;

    find_tries(c, &wish, INFINITY, &t);
    c->unsearched[0] = '\0';
    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        int count = 0;
        for (int n = 0; n < t.count; n++)
            count += t.list[n].at.contestant == who;
        if (count)
            TEXT_JOIN(c->unsearched, ", ", "%s %d", who->name, count);
    }
    arena_clear(&t.arena);
}

enum status contest_search_all(struct contest *c, contest_measure *measure, void *context,
                               struct message *why)
{
    double longest = c->budget > 0 ? FIRST * c->longest : c->longest;

    for (; longest < c->longest; longest *= DEARER)
        CALL(search_to(c, longest, longest, measure, context, why));
    CALL(search_to(c, c->longest, INFINITY, measure, context, why));
    if (c->budget > 0)
        contest_tell_unsearched(c);
    return STATUS_OK;
}

void contest_search_limits(struct contest *c)
{
    const struct contestant *who;
    struct tries t = {.contest = c};

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const struct contest_limit limit = contest_limit(c, who);
        struct contest_at at;
        if (!limit.best || limit.kind == CONTEST_BY_TRUTH)
            continue;
        for (enum contest_axis axis = 0; axis < CONTEST_AXES; axis++)
            if (contest_probe(c, limit.best, axis, &at))
                add_try(&t, &at, false);
    }
    add_payable(c, &t, c->budget, true);
    arena_clear(&t.arena);
}
