#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/truth/truth_parts.h"
#include "models/grid.h"
#include "models/metric/metric.h"

static const double SAFETY = 1.25, UNSAFE = 3, LEAST = 0.5;

/* Two runs show no order: their difference counts so many times. */
static const double UNSEEN = 3;

/* first / second, if errors were c h^p. */
static double ratio(const double h[3], double p)
{
    return (pow(h[0], p) - pow(h[1], p)) / (pow(h[1], p) - pow(h[2], p));
}

/* The ratio grows with p: halving. */
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

/* Of the second difference, by order p: the finest run's error. */
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
    double p = o.order >= LEAST ? fmin(o.order, promised) : LEAST;
    o.bar = (o.order >= LEAST ? SAFETY : UNSAFE) * second * left_by(h, p);
    return o;
}

void truth_family_clear(struct truth_family *f)
{
    for (int n = 0; n < TRUTH_FAMILY_MOST; n++)
        run_result_clear(&f->run[n]);
}

/* What theory promises: splines of degree 2 and more bend with errors of that order in the
 * mean square, and steps that shrink alike are of it. */
static const double PROMISED = 2;

static double between(const struct truth_family *f, int a, int b, int time)
{
    return metric_rmse(f->run[a].xyz[time], f->run[b].xyz[time]);
}

/* Sums of squares of both differences of three runs, from time to time. */
struct chain {
    double first, second;
};

/* Sizes of the last three of the first `count` runs. */
static void sizes(const struct truth_family *f, int count, double h[3])
{
    for (int k = 0; k < 3; k++) {
        const struct truth_level *l = &f->level[count - 3 + k];
        h[k] = 1.0 / (l->side - l->degree - l->repeats);
    }
}

/* Judges these up to a time. Differences that cross zero would show any order, and none of
 * an error: the order is that of their rms up to now, and no difference counts for less
 * than that. */
static struct truth_order judge(const struct truth_family *f, int count, int time,
                                struct chain *up_to_now, double h[3])
{
    const double first = between(f, count - 3, count - 2, time);
    const double second = between(f, count - 2, count - 1, time);

    sizes(f, count, h);
    up_to_now->first += first * first;
    up_to_now->second += second * second;
    const double rms = sqrt(up_to_now->second / (time + 1));
    struct truth_order o =
        truth_order(h, sqrt(up_to_now->first), sqrt(up_to_now->second), PROMISED);
    o.bar *= rms > 0 ? fmax(second, rms) / sqrt(up_to_now->second) : 1;
    return o;
}

/* A field: of two runs, fine + left (fine - middle). */
struct field {
    const double *fine, *middle;
    double left;
};

static struct field limit_of(const struct truth_family *f, int count, const double h[3],
                             double order, int time)
{
    const double left = order >= LEAST ? left_by(h, fmin(order, PROMISED)) : 0;

    return (struct field){f->run[count - 1].xyz[time], f->run[count - 2].xyz[time], left};
}

static double at(const struct field *f, int n)
{
    return f->fine[n] + f->left * (f->fine[n] - f->middle[n]);
}

/* As metric_rmse. */
static double apart(const struct field *a, const struct field *b)
{
    double sum = 0;

    if (!(a->left > 0) && !(b->left > 0))
        return metric_rmse(a->fine, b->fine);
    for (int n = 0; n < 3 * GRID_POINTS; n++) {
        const double d = at(a, n) - at(b, n);
        sum += d * d;
    }
    return sqrt(sum / GRID_POINTS);
}

/* What is carried from time to time: of three runs, of the three before, of their limits.
 */
struct judged {
    struct chain now, before;
    double moved;
};

/* From here on a family shows whether its limits have settled. */
enum { SETTLED = 4 };

/* An order that the three runs before did not show may be luck: as of two runs, the last
 * difference counts three times. One that they showed lower is believed no higher. */
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

/* Where the last three runs show an order, and the three before one that goes the same way,
 * the limit hardly moved: how far it did bars it, and where that is the sharper bar, the
 * limit is the family's field. Errors that are not yet of an order move it by more than
 * they are (wrinkles, contact). */
static void settle(const struct truth_family *f, int time, struct truth_order *o,
                   const double h[3], struct judged *so_far, struct field *field)
{
    double coarser[3];
    const struct truth_order before =
        judge(f, f->count - 1, time, &so_far->before, coarser);
    const struct field limit = limit_of(f, f->count, h, o->order, time),
                       last = limit_of(f, f->count - 1, coarser, before.order, time);
    const double moved = apart(&limit, &last), three = o->bar;

    so_far->moved += moved * moved;
    const double bar = SAFETY * fmax(moved, sqrt(so_far->moved / (time + 1)));
    o->bar = confirm(h, o, &before);
    if (!(o->order >= LEAST) || !(bar < three))
        return;
    o->bar = bar;
    *field = limit;
}

static struct field judge_family(const struct truth_family *f, int time,
                                 struct judged *so_far, double *value)
{
    const int n = f->count;
    struct field field = {0};
    double h[3];

    value[0] = value[1] = NAN;
    value[2] = INFINITY;
    if (n)
        field.fine = field.middle = f->run[n - 1].xyz[time];
    if (n == 2)
        value[2] = UNSEEN * between(f, 0, 1, time);
    if (n < 3)
        return field;
    struct truth_order both = judge(f, n, time, &so_far->now, h);
    if (n >= SETTLED)
        settle(f, time, &both, h, so_far, &field);
    value[0] = value[1] = both.order;
    value[2] = both.bar;
    return field;
}

void truth_bar_limit(const struct truth_family *f, double order, int time, double *xyz)
{
    double h[3];

    sizes(f, f->count, h);
    const struct field limit = limit_of(f, f->count, h, order, time);
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        xyz[n] = at(&limit, n);
}

const struct run_result *truth_bar_finest(const struct truth_family *f)
{
    return &f->run[f->count - 1];
}

static double growth(const struct truth_push *p, int time, double length)
{
    return metric_rmse(p->plain->xyz[time], p->pushed->xyz[time]) /
           (TRUTH_PERTURBATION * length);
}

void truth_bar_compare(const struct truth_family family[TRUTH_MODELS],
                       const struct truth_push *push, double length, struct truth *made)
{
    const struct truth_family *solid = &family[TRUTH_SOLID], *shell = &family[TRUTH_SHELL];
    struct judged so_far[TRUTH_MODELS] = {{{0}}};

    for (int n = 0; n < made->times; n++) {
        double *v = made->value[n];
        const struct field a =
            judge_family(solid, n, &so_far[TRUTH_SOLID], v + TRUTH_SOLID_SPACE);
        const struct field b =
            judge_family(shell, n, &so_far[TRUTH_SHELL], v + TRUTH_SHELL_SPACE);
        v[TRUTH_DIFFERENCE] = solid->count && shell->count ? apart(&a, &b) : 0;
        v[TRUTH_GROWTH] = growth(push, n, length);
    }
}

void truth_bar_level(const struct truth_level *l, bool own, char text[TRUTH_BAR_LEVEL])
{
    static const char *const first[] = {"selective solid, cured of locking",
                                        "Kirchhoff-Love shell, cured of locking"},
                             *const other[] = {"selective solid",
                                               "cured Kirchhoff-Love shell"};

    snprintf(text, TRUTH_BAR_LEVEL, "%s, p = %d, %dx%d, %s%.4g ms",
             (own ? first : other)[l->model], l->degree, l->side, l->side,
             own ? "step " : "", 1e3 * l->step);
}

void truth_bar_claim(struct truth *made, double length)
{
    int n = 0;

    for (int t = 0; t < made->times; t++) {
        const double *v = made->value[t];
        made->error[t] =
            fmax(fmin(v[TRUTH_SOLID_BAR], v[TRUTH_SHELL_BAR]), v[TRUTH_DIFFERENCE]);
    }
    while (n < made->times && made->error[n] <= TRUTH_MOST_ERROR * length &&
           made->value[n][TRUTH_GROWTH] <= TRUTH_MOST_GROWTH)
        n++;
    made->claimed = n;
}

/* At how many times that are claimed (of all, if none is) a model's field is the truth, and
 * at how many of these its limit is. */
struct share {
    int times, limits;
};

static void fill(const struct truth_family family[TRUTH_MODELS], struct truth *made,
                 struct share share[TRUTH_MODELS])
{
    struct judged so_far[TRUTH_MODELS] = {{{0}}};
    struct field field[TRUTH_MODELS];
    double value[3];

    for (int t = 0; t < made->times; t++) {
        const double *v = made->value[t];
        const enum truth_model whose =
            v[TRUTH_SOLID_BAR] <= v[TRUTH_SHELL_BAR] ? TRUTH_SOLID : TRUTH_SHELL;
        for (int m = 0; m < TRUTH_MODELS; m++)
            field[m] = judge_family(&family[m], t, &so_far[m], value);
        for (int n = 0; n < 3 * GRID_POINTS; n++)
            made->xyz[t][n] = at(&field[whose], n);
        if (t < made->claimed || !made->claimed) {
            share[whose].times++;
            share[whose].limits += field[whose].left > 0;
        }
    }
}

enum { SHARE = 256 };

/* A model's finest run and, if the truth is somewhere its limit, what that is made of. */
static void tell_share(const struct truth_family *f, int limits, bool own, char text[SHARE])
{
    const struct truth_level *l = &f->level[f->count - (limits ? SETTLED : 1)];
    char level[TRUTH_BAR_LEVEL];

    truth_bar_level(&f->level[f->count - 1], own, level);
    const int used = snprintf(text, SHARE, "%s", level);
    if (limits)
        snprintf(text + used, SHARE - (size_t)used,
                 ", %d times extrapolated from %dx%d, %dx%d, %dx%d and that", limits,
                 l[0].side, l[0].side, l[1].side, l[1].side, l[2].side, l[2].side);
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

void truth_bar_choose(const struct truth_family family[TRUTH_MODELS], double length,
                      struct truth *made)
{
    struct share share[TRUTH_MODELS] = {{0}};

    truth_bar_claim(made, length);
    fill(family, made, share);
    const enum truth_model most =
        share[TRUTH_SOLID].times >= share[TRUTH_SHELL].times ? TRUTH_SOLID : TRUTH_SHELL;
    const struct truth_family *f = &family[most];
    made->level = f->level[truth_bar_finest(f) - f->run];
    tell(family, share, most, made);
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
             "a change of gravity by %g %s %.2g-fold %s %.3g s: %s (%s "
             "%dx%d, step %.3g ms)",
             TRUTH_PERTURBATION, lost ? "has grown" : "grows at most", most,
             lost ? "at" : "up to", time[n - 1],
             lost && blunt ? "on a net too coarse to know the motion, which says nothing"
             : lost        ? "from there on the motion cannot be predicted"
                           : "so long the motion can be predicted",
             level->model == TRUTH_SOLID ? "solid," : "shell,", level->side, level->side,
             1e3 * level->step);
}
