#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/truth/truth_making.h"
#include "models/grid.h"
#include "models/metric/metric.h"

static const double SAFETY = 1.25, UNSAFE = 3, LEAST = 0.5;

/* The factor on the difference of two runs, which show no order. */
static const double UNSEEN = 3;

/* The order that theory promises: splines of degree 2 and more bend with errors of that
 * order in the mean square, and steps that shrink alike have it. */
static const double PROMISED = 2;

/* --- Three runs --- */

/* Returns first / second for errors c h^p. */
static double ratio(const double h[3], double p)
{
    return (pow(h[0], p) - pow(h[1], p)) / (pow(h[1], p) - pow(h[2], p));
}

/* Solves ratio(h, p) = wanted for p by halving, as the ratio grows with p. */
static double solve(const double h[3], double wanted)
{
    double low = 1e-3, high = 20;

    if (!(wanted > ratio(h, low)))
        return NAN;
    for (int n = 0; n < 60; n++) {
        const double middle = (low + high) / 2;
        if (ratio(h, middle) < wanted)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Returns the finest run's error by order p, as a part of the second difference. */
static double left_by(const double h[3], double p)
{
    return pow(h[2], p) / (pow(h[1], p) - pow(h[2], p));
}

struct truth_order truth_order(const double h[3], double first, double second,
                               double promised)
{
    struct truth_order o = {.order = NAN};

    if (!(second > 0))
        return o;
    o.order = solve(h, first / second);
    const double p = o.order >= LEAST ? fmin(o.order, promised) : LEAST;
    o.bar = (o.order >= LEAST ? SAFETY : UNSAFE) * second * left_by(h, p);
    return o;
}

/* --- A family --- */

void truth_family_clear(struct truth_family *f)
{
    for (int n = 0; n < TRUTH_FAMILY_MOST; n++)
        run_result_clear(&f->run[n]);
}

static double between(const struct truth_family *f, int a, int b, int time)
{
    return metric_rmse(f->run[a].xyz[time], f->run[b].xyz[time]);
}

/* Three successive runs: sizes, and sums of squares of both differences from time to time.
 */
struct three {
    double h[3];
    double first, second;
};

/* Judges three runs, the last of them number `last`, at a time. Differences that cross zero
 * would show any order, and none of an error: the order is that of their rms up to now, and
 * no difference counts for less than that. */
static struct truth_order judge_three(const struct truth_family *f, int last, int time,
                                      struct three *t)
{
    const double first = between(f, last - 2, last - 1, time);
    const double second = between(f, last - 1, last, time);

    for (int k = 0; k < 3; k++) {
        const struct truth_level *l = &f->level[last - 2 + k];
        t->h[k] = 1.0 / (l->side - l->degree - l->repeats);
    }
    t->first += first * first;
    t->second += second * second;
    const double rms = sqrt(t->second / (time + 1));
    struct truth_order o = truth_order(t->h, sqrt(t->first), sqrt(t->second), PROMISED);
    o.bar *= rms > 0 ? fmax(second, rms) / sqrt(t->second) : 1;
    return o;
}

/* A field at one time: fine + left (fine - middle). */
struct field {
    const double *fine, *middle;
    double left;
};

/* Returns where three runs are going, if their order is believed, else the finest. */
static struct field limit_of(const struct truth_family *f, int last, const double h[3],
                             double order, int time)
{
    const double left = order >= LEAST ? left_by(h, fmin(order, PROMISED)) : 0;

    return (struct field){f->run[last].xyz[time], f->run[last - 1].xyz[time], left};
}

static double at(const struct field *f, int n)
{
    return f->fine[n] + f->left * (f->fine[n] - f->middle[n]);
}

static void evaluate(const struct field *f, double *xyz)
{
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        xyz[n] = at(f, n);
}

/* Returns metric_rmse of two fields. */
static double apart(const struct field *a, const struct field *b)
{
    double sum = 0;
    int beside = 0; /* coordinates that neither has */

    if (!(a->left > 0) && !(b->left > 0))
        return metric_rmse(a->fine, b->fine);
    for (int n = 0; n < 3 * GRID_POINTS; n++) {
        const double d = at(a, n) - at(b, n);
        if (isnan(a->fine[n]) && isnan(b->fine[n]))
            beside++;
        else
            sum += d * d;
    }
    return sqrt(sum / (GRID_POINTS - beside / 3));
}

/* The number of runs from which on a family shows whether its limits have settled. */
enum { SETTLED = 4 };

/* The results of a family at a time, and sums that it carries on to the next. */
struct judged {
    double moved;             /* sum of squares of how far the limit moved            */
    struct three now, before; /* the last three runs, and the three before them       */
    double order, bar;        /* NaN: none is seen; bar [m], INFINITY: no two runs    */
    struct field field;
};

/* Returns the bar by an order that the three runs before did or did not show. One that they
 * did not show may be luck: as of two runs, the last difference counts three times. One
 * that they showed lower is believed no higher. */
static double confirm(const double h[3], const struct truth_order *o,
                      const struct truth_order *before)
{
    const double now = left_by(h, fmin(o->order, PROMISED));

    if (!(o->order >= LEAST))
        return o->bar;
    if (!(before->order >= LEAST))
        return fmax(o->bar, UNSEEN * o->bar / (SAFETY * now));
    return o->bar / now * left_by(h, fmin(fmin(o->order, before->order), PROMISED));
}

/* Settles bar and field. Where the last three runs show an order, and the three before one
 * that goes the same way, the limit hardly moved: how far it did bars it, and where that is
 * the smaller bar, the limit is the family's field. Errors that are not yet of an order
 * move it by more than they are (wrinkles, contact). */
static void settle(const struct truth_family *f, int time, struct judged *j)
{
    const int last = f->count - 1;
    const struct truth_order o = {j->order, j->bar},
                             before = judge_three(f, last - 1, time, &j->before);
    const struct field limit = limit_of(f, last, j->now.h, o.order, time),
                       coarse = limit_of(f, last - 1, j->before.h, before.order, time);
    const double moved = apart(&limit, &coarse);

    j->moved += moved * moved;
    const double bar = SAFETY * fmax(moved, sqrt(j->moved / (time + 1)));
    j->bar = confirm(j->now.h, &o, &before);
    if (!(o.order >= LEAST) || !(bar < o.bar))
        return;
    j->bar = bar;
    j->field = limit;
}

static void judge_family(const struct truth_family *f, int time, struct judged *j)
{
    const int last = f->count - 1;

    j->order = NAN;
    j->bar = f->count == 2 ? UNSEEN * between(f, 0, 1, time) : INFINITY;
    if (f->count)
        j->field = (struct field){f->run[last].xyz[time], f->run[last].xyz[time], 0};
    if (f->count < 3)
        return;
    const struct truth_order o = judge_three(f, last, time, &j->now);
    j->order = o.order;
    j->bar = o.bar;
    if (f->goes_on)
        j->field = limit_of(f, last, j->now.h, o.order, time);
    else if (f->count >= SETTLED)
        settle(f, time, j);
}

/* --- A truth --- */

static double growth(const struct truth_push *p, int time, double length)
{
    return metric_rmse(p->plain->xyz[time], p->pushed->xyz[time]) /
           (TRUTH_PERTURBATION * length);
}

/* The numbers of times at which a model's field is the truth, and its limit is. */
struct share {
    int times, limits;
};

enum { SHARE = 256 };

/* Describes a model's finest run and, if the truth is somewhere its limit, what that is
 * made of. */
static void tell_share(const struct truth_family *f, int limits, bool own, char text[SHARE])
{
    char level[TRUTH_BAR_LEVEL];

    truth_bar_level(&f->level[f->count - 1], own, level);
    const int used = snprintf(text, SHARE, "%s", level);
    if (limits && f->count >= SETTLED) { /* a third's limit is described in its note */
        const struct truth_level *l = &f->level[f->count - SETTLED];
        snprintf(text + used, SHARE - (size_t)used,
                 ", %d times extrapolated from %dx%d, %dx%d, %dx%d and that", limits,
                 l[0].side, l[0].side, l[1].side, l[1].side, l[2].side, l[2].side);
    }
}

/* Takes over what a run counted on its own triangles: of a garment, whose material grid is
 * too coarse for creases and seams. */
static void take_crossings(const struct run_result *run, double time, double *value)
{
    const double begin = run->value[MEASURE_INTERSECTION_TIME];

    if (!isnan(begin))
        value[TRUTH_CROSSINGS] = begin > time ? 0 : run->value[MEASURE_INTERSECTIONS_MAX];
}

static void tell(const struct truth_family family[TRUTH_MODELS],
                 const struct share share[TRUTH_MODELS], enum truth_model most,
                 struct truth *made)
{
    const struct share *more = &share[most], *less = &share[!most];
    char first[SHARE], other[SHARE] = "other", at[64] = "";

    tell_share(&family[most], more->limits, true, first);
    if (family[!most].count)
        tell_share(&family[!most], less->limits, false, other);
    if (less->times)
        snprintf(at, sizeof at, "; at %d of %d times the ", less->times,
                 less->times + more->times);
    const int length = snprintf(
        made->source, sizeof made->source, "nonlinear %s%s%s; error bar: its own by %s%s%s",
        first, at, less->times ? other : "",
        more->limits + less->limits ? "how far its limit moved, and observed orders"
        : family[most].count < 3    ? "the difference of two runs, three times"
                                    : "observed orders",
        family[!most].count ? " or, if larger, its difference from the " : "",
        less->times           ? "other"
        : family[!most].count ? other
                              : "");
    assert(length < (int)sizeof made->source); /* nets have at most four digits a side */
}

void truth_bar_judge(const struct truth_family family[TRUTH_MODELS],
                     const struct truth_push *push, double length, struct truth *made)
{
    struct judged judged[TRUTH_MODELS] = {{0}}, *solid = &judged[TRUTH_SOLID],
                  *shell = &judged[TRUTH_SHELL];
    struct share all[TRUTH_MODELS] = {{0}}, claimed[TRUTH_MODELS] = {{0}};
    bool claims = true;

    made->claimed = 0;
    for (int t = 0; t < made->times; t++) {
        double *v = made->value[t];
        for (int m = 0; m < TRUTH_MODELS; m++)
            judge_family(&family[m], t, &judged[m]);
        v[TRUTH_SOLID_SPACE] = v[TRUTH_SOLID_TIME] = solid->order;
        v[TRUTH_SHELL_SPACE] = v[TRUTH_SHELL_TIME] = shell->order;
        v[TRUTH_SOLID_BAR] = solid->bar;
        v[TRUTH_SHELL_BAR] = shell->bar;
        v[TRUTH_DIFFERENCE] = family[TRUTH_SOLID].count && family[TRUTH_SHELL].count
                                  ? apart(&solid->field, &shell->field)
                                  : 0;
        v[TRUTH_GROWTH] = growth(push, t, length);
        made->error[t] = fmax(fmin(solid->bar, shell->bar), v[TRUTH_DIFFERENCE]);
        claims = claims && made->error[t] <= TRUTH_MOST_ERROR * length &&
                 v[TRUTH_GROWTH] <= TRUTH_MOST_GROWTH;
        made->claimed += claims;
        const enum truth_model whose = solid->bar <= shell->bar ? TRUTH_SOLID : TRUTH_SHELL;
        evaluate(&judged[whose].field, made->xyz[t]);
        take_crossings(&family[whose].run[family[whose].count - 1], made->time[t], v);
        all[whose].times++;
        all[whose].limits += judged[whose].field.left > 0;
        if (claims)
            claimed[whose] = all[whose];
    }
    const struct share *share = made->claimed ? claimed : all;
    const enum truth_model most =
        share[TRUTH_SOLID].times >= share[TRUTH_SHELL].times ? TRUTH_SOLID : TRUTH_SHELL;
    made->level = family[most].level[family[most].count - 1];
    tell(family, share, most, made);
}

/* --- Words --- */

void truth_bar_level(const struct truth_level *l, bool own, char text[TRUTH_BAR_LEVEL])
{
    char degree[16] = "";

    if (!l->net)
        snprintf(degree, sizeof degree, "p = %d, ", l->degree);
    snprintf(text, TRUTH_BAR_LEVEL, "%s, %s%dx%d, %s%.4g ms",
             truth_level_word(l->model, l->net, own ? TRUTH_FORM_WHOLE : TRUTH_FORM_OTHER),
             degree, l->side, l->side, own ? "step " : "", 1e3 * l->step);
}

void truth_bar_horizon(const struct truth_push *push, bool blunt, int count,
                       const double *time, double length, char text[TRUTH_WATCH_TEXT])
{
    const struct truth_level *level = &push->level;
    double most = 0;
    int n = 0;

    for (; n < count && most <= TRUTH_MOST_GROWTH; n++)
        most = fmax(most, growth(push, n, length));
    const bool lost = most > TRUTH_MOST_GROWTH;
    snprintf(text, TRUTH_WATCH_TEXT,
             "a change of gravity by %g %s %.2g-fold %s %.3g s: %s (%s, "
             "%dx%d, step %.3g ms)",
             TRUTH_PERTURBATION, lost ? "has grown" : "grows at most", most,
             lost ? "at" : "up to", time[n - 1],
             lost && blunt ? "on a net too coarse to know the motion, which says nothing"
             : lost        ? "from there on the motion cannot be predicted"
                           : "so long the motion can be predicted",
             truth_level_word(level->model, level->net, TRUTH_FORM_WORD), level->side,
             level->side, 1e3 * level->step);
}
