#include "bench/truth/truth_wish.h"

#include <math.h>
#include <stdio.h>

#include "bench/truth/truth_push.h"

/* Of the cured models with steps that shrink as their nets. */
static const double PROMISED = 2;

/* Three runs show an order, and one below this is none to rely on (truth_order). */
enum { SEEN = 3 };
static const double LEAST = 0.5;

/* No wish is so far that more runs would meet it. */
enum { FAR = 60 };

static double next_run(const struct truth_seen *m)
{
    return m->next > 0 ? m->seconds * pow(m->next, -m->dearer) : 0;
}

/* Seconds until its own bar is within the wish, if it falls with this order. */
static double needed(const struct truth_seen *m, double order, double wish)
{
    double bar = m->bar, run = m->seconds, all = 0;

    for (int n = 0; n < FAR && bar > wish && m->next > 0; n++) {
        bar *= pow(m->next, order);
        run *= pow(m->next, -m->dearer);
        all += run;
    }
    return all;
}

static bool has_order(const struct truth_seen *m)
{
    return m->runs >= SEEN && m->order >= LEAST;
}

/* Both models', at the orders seen, and the next run at the least. */
static double likely(const struct truth_wish *wish, const struct truth_outlook *o,
                     double run)
{
    double all = 0;

    for (int m = 0; m < TRUTH_MODELS; m++) {
        const struct truth_seen *s = &o->model[m];
        if (s->runs)
            all += has_order(s) ? needed(s, fmin(s->order, PROMISED), wish->error) : NAN;
    }
    return isnan(all) ? NAN : fmax(all, run);
}

/* At the promised order. A bar without an order may fall by far with the next run. */
static double needed_least(const struct truth_wish *wish, const struct truth_seen *m)
{
    return has_order(m) ? needed(m, PROMISED, wish->error) : next_run(m);
}

/* Until one of them is within the wish or, where one is, the other: there is no less. */
static double least(const struct truth_wish *wish, const struct truth_outlook *o,
                    double run)
{
    const struct truth_seen *solid = &o->model[TRUTH_SOLID],
                            *shell = &o->model[TRUTH_SHELL];
    const double a = needed_least(wish, solid), b = needed_least(wish, shell);

    if (!solid->runs || !shell->runs)
        return fmax(solid->runs ? a : b, run);
    if (solid->bar > wish->error && shell->bar > wish->error)
        return fmax(fmin(a, b), run);
    return fmax(solid->bar > shell->bar ? a : b, run);
}

/* Both models' own bars leave no room for their difference. */
static bool are_apart(const struct truth_wish *wish, const struct truth_outlook *o)
{
    const struct truth_seen *m = o->model;

    return m[0].runs && m[1].runs && o->difference > wish->error &&
           m[0].bar + m[1].bar <= wish->error;
}

/* Where both are too blunt, the one whose next run is the shorter; else the blunter one. */
static enum truth_model choose(const struct truth_wish *wish, const struct truth_outlook *o)
{
    const struct truth_seen *solid = &o->model[TRUTH_SOLID],
                            *shell = &o->model[TRUTH_SHELL];
    const bool both = solid->next > 0 && shell->next > 0 && solid->bar > wish->error &&
                      shell->bar > wish->error;

    if (!solid->runs || !shell->runs)
        return solid->runs ? TRUTH_SOLID : TRUTH_SHELL;
    if (both)
        return next_run(solid) < next_run(shell) ? TRUTH_SOLID : TRUTH_SHELL;
    return solid->bar > shell->bar ? TRUTH_SOLID : TRUTH_SHELL;
}

struct truth_verdict truth_wish_judge(const struct truth_wish *wish,
                                      const struct truth_outlook *o)
{
    struct truth_verdict v = {.next = choose(wish, o)};
    const struct truth_seen *next = &o->model[v.next];
    const double left = wish->seconds - o->spent;

    v.run = next_run(next);
    v.least = least(wish, o, v.run);
    v.likely = likely(wish, o, v.run);
    if (isfinite(o->lost) && (!o->blunt || !(next->next > 0)))
        v.answer = TRUTH_LOST;
    else if (o->error <= wish->error && !isfinite(o->lost))
        v.answer = TRUTH_MET;
    else if (are_apart(wish, o))
        v.answer = TRUTH_APART;
    else if (!(next->next > 0))
        v.answer = TRUTH_FINEST;
    else if (v.least > left)
        v.answer = TRUTH_DEAR;
    else
        v.answer = TRUTH_GO;
    return v;
}

/* "40 s", "12 min", "3.4 h". */
static const char *lasting(double seconds, char text[24])
{
    if (seconds < 100)
        snprintf(text, 24, "%.2g s", seconds);
    else if (seconds < 6000)
        snprintf(text, 24, "%.0f min", seconds / 60);
    else
        snprintf(text, 24, "%.3g h", seconds / 3600);
    return text;
}

/* What it will still take. */
static void tell_needed(const struct truth_verdict *v, char text[96])
{
    char likely[24], least[24];

    lasting(v->least, least);
    if (isnan(v->likely))
        snprintf(text, 96, "%s more at best (no order is seen yet)", least);
    else
        snprintf(text, 96, "%s more at the orders seen, %s at best",
                 lasting(v->likely, likely), least);
}

/* Until when it is known so well. */
static void tell_known(const struct truth_wish *wish, const struct truth_outlook *o,
                       char text[96])
{
    if (o->known > 0)
        snprintf(text, 96, "known to %.3g %% up to %.3g s", 100 * wish->error, o->known);
    else
        snprintf(text, 96, "known to %.3g %% at none of its times", 100 * wish->error);
}

void truth_wish_tell(const struct truth_wish *wish, const struct truth_outlook *o,
                     const struct truth_verdict *v, char text[TRUTH_WISH_TEXT])
{
    static const char *const names[] = {"the solid", "the shell"};
    const double wanted = 100 * wish->error, found = 100 * o->error;
    char known[96], needed[96], other[24], run[24];

    tell_known(wish, o, known);
    tell_needed(v, needed);
    lasting(v->run, run);
    switch (v->answer) {
    case TRUTH_MET:
        snprintf(text, TRUTH_WISH_TEXT, "%s: the error bar is %.2g %% at most", known,
                 found);
        break;
    case TRUTH_GO:
        snprintf(text, TRUTH_WISH_TEXT,
                 "after %s the bar is %.2g %%; %.3g %% will take %s; next: %s, %s",
                 lasting(o->spent, other), found, wanted, needed, names[v->next], run);
        break;
    case TRUTH_LOST:
        snprintf(text, TRUTH_WISH_TEXT,
                 "no: a change of gravity by %g has grown %.2g-fold at %.3g s, from where "
                 "on nothing can be claimed; %s (--until asks for an earlier end)",
                 TRUTH_PERTURBATION, o->growth, o->lost, known);
        break;
    case TRUTH_APART:
        snprintf(text, TRUTH_WISH_TEXT,
                 "no: solid and shell differ by %.2g %%, and their own bars, %.2g %% and "
                 "%.2g %%, do not explain it: this thickness makes them two sheets; %s",
                 100 * o->difference, 100 * o->model[TRUTH_SOLID].bar,
                 100 * o->model[TRUTH_SHELL].bar, known);
        break;
    case TRUTH_DEAR:
        snprintf(text, TRUTH_WISH_TEXT,
                 "no: the bar is %.2g %%, and %.3g %% up to %.3g s will take %s; the next "
                 "run takes %s, and the budget leaves %s; %s (a larger --budget goes on "
                 "from here)",
                 found, wanted, o->until, needed, run,
                 lasting(fmax(0, wish->seconds - o->spent), other), known);
        break;
    case TRUTH_FINEST:
        snprintf(text, TRUTH_WISH_TEXT, "no: the finest nets leave %.2g %%; %s", found,
                 known);
        break;
    }
}

double truth_wish_known(const struct truth_made *made, double error)
{
    double known = 0;

    for (int n = 0; n < made->times && made->value[n][TRUTH_ERROR] <= error &&
                    made->value[n][TRUTH_GROWTH] <= TRUTH_MOST_GROWTH;
         n++)
        known = made->time[n];
    return known;
}
