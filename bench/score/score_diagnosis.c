#include "bench/score/score_diagnosis.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/score/score_fit.h"
#include "bench/score/score_pace.h"
#include "bench/score/score_stretch.h"
#include "bench/score/score_support.h"
#include "bench/score/score_turned.h"

/* Frames that move by less than this share of what the truth does are still. */
#define STILL_MOST 0.01

/* No cloth's neighbours lie so many times as far apart as the truth's. */
#define SCATTERED_LEAST 2

/* Another pace is said where it leaves so many times less than what was fitted: another
 * gravity differs from one by what bending does alone, which a net's own error hides. */
#define PACE_BETTER 3

/* And no more than this: a flag that is too stiff is slower, too, and leaves a quarter. */
#define PACE_MOST 0.1

/* A lead of half a step is a first-order step's. Frames come every step or more seldom. */
#define HALF_STEP 0.55

/* An edge that is less of a hinge than this is a clamp that gives way: springs and hinges
 * on 10 cells are .57 of one where the held row's count as the others do, .98 where it has
 * none. */
#define CLAMP_MOST 0.8

/* A hinge by so much more than one: without bending no edge is clamped, and no sheet stiff.
 */
#define NO_BENDING 1.15

/* Error within so many times floor or bar is theirs; what the sharper of our own
 * contestants reach is sound, too, unless it is more than a small share of all that the
 * truth moves. */
#define TIMES_FLOOR 2
#define SOUND_MOST  0.005
#define SOUND_SHARE 0.05

static const char *const names[SCORE_KINDS] = {
#define SCORE_NAME(code, name) name,
    SCORE_KIND_LIST(SCORE_NAME)
#undef SCORE_NAME
};

const char *score_diagnosis_name(enum score_kind kind)
{
    return names[kind];
}

static void __attribute__((format(printf, 4, 5)))
say(struct score_diagnosis *d, enum score_kind kind, double value, const char *format, ...)
{
    struct score_finding *f = &d->finding[d->count++];
    va_list args;

    f->kind = kind;
    f->value = value;
    va_start(args, format);
    vsnprintf(f->text, sizeof f->text, format, args);
    va_end(args);
}

/* --- before anything is fitted ----------------------------------------------------------
 */

static bool say_still(const struct score *s, struct score_diagnosis *d)
{
    const int last = score_last(s);
    const double *truth = score_truth_field(&s->truth, last),
                 *got = s->field + 3L * SCORE_POINTS * last, *rest = s->truth.rest;
    const double moved = score_rms(SCORE_POINTS, truth, rest),
                 theirs = score_rms(SCORE_POINTS, got, rest);

    if (moved < STILL_MOST * s->truth.scene.length || theirs > STILL_MOST * moved)
        return false;
    say(d, SCORE_STILL, theirs / moved,
        "Did not move: %.2g %% of the truth's way at %g s; are forces switched on, are all "
        "vertices held, do the frames come from the start?",
        100 * theirs / moved, s->row[last].time);
    return true;
}

static void axes_text(const struct score_turned *t, char text[32])
{
    char *at = text;

    for (int c = 0; c < 3; c++) {
        if (c)
            *at++ = ',', *at++ = ' ';
        if (t->sign[c] < 0)
            *at++ = '-';
        *at++ = "xyz"[t->axis[c]];
    }
    *at = '\0';
}

static bool say_turned(const struct score *s, struct score_diagnosis *d)
{
    const struct score_turned t = score_turned_best(s);
    const double now = 100 * t.as_is, then = 100 * t.error;
    char axes[32];

    axes_text(&t, axes);
    if (t.scale != 1)
        say(d, SCORE_UNITS, t.scale,
            "Positions are in another unit: they fit to %.2g %% in place of %.2g %% with "
            "--scale %g.",
            then, now, t.scale);
    if (strcmp(axes, "x, y, z") != 0)
        say(d, SCORE_AXES, t.error,
            "Axes are exchanged: frames fit to %.2g %% in place of %.2g %% if %s are taken "
            "for x, y, z%s.",
            then, now, axes,
            !strcmp(axes, "x, -z, y")   ? " (--up y)"
            : !strcmp(axes, "-z, y, x") ? " (--up x)"
                                        : "");
    if (t.order)
        say(d, SCORE_ORDER, t.error,
            "Vertices are in another order than their uv: frames fit to %.2g %% in place "
            "of "
            "%.2g %% with %s%s%s.",
            then, now, t.order & 1 ? "rows and columns exchanged" : "the same rows",
            t.order & 2 ? ", u reversed" : "", t.order & 4 ? ", v reversed" : "");
    return d->count > 0;
}

static void stretch_text(const struct score_lines *l, double when,
                         struct score_diagnosis *d)
{
    const double more = score_stretch_share(l), strain = l->truth / l->rest - 1;

    if (score_stretch_has(l))
        say(d, SCORE_STRETCH, more,
            "Stretches %.2g times as much as the truth (its lines, on average, by %.2g %% "
            "in "
            "place of %.2g %% at %g s): %s",
            (l->got / l->rest - 1) / strain, 100 * (l->got / l->rest - 1), 100 * strain,
            when,
            more > 0 ? "too soft in the plane, or too few iterations."
                     : "too stiff in the plane, or not yet at rest.");
    else
        say(d, SCORE_STRETCH, more,
            "%s by %.2g %% more than the truth (its lines, on average, at %g s): %s",
            more > 0 ? "Stretches" : "Shrinks", 100 * fabs(more), when,
            more > 0            ? "too soft in the plane, or too few iterations."
            : l->spread > -more ? "some parts far more than others, so it is pressed "
                                  "together or crumpled."
                                : "is the rest shape the sheet's?");
}

static enum status say_stretch(const struct score *s, struct score_diagnosis *d)
{
    struct score_lines most;
    double when;
    enum status st;

    TRY(score_stretch_find(s, &most, &when));
    if (when > 0)
        stretch_text(&most, when, d);
out:
    return st;
}

/* Neighbours on the net lie far apart, and all points on the truth's surface. */
static bool say_scattered(const struct score *s, struct score_diagnosis *d)
{
    int n = 0;

    while (!s->row[n].known)
        n++;
    const double *truth = score_truth_field(&s->truth, n),
                 *got = s->field + 3L * SCORE_POINTS * n;
    const struct score_lines u = score_stretch_lines(s, truth, truth, got, false),
                             v = score_stretch_lines(s, truth, truth, got, true);
    const double apart = fmax(u.got / u.truth, v.got / v.truth);
    if (apart < SCATTERED_LEAST)
        return false;
    const double off = score_turned_nearest(s, n);
    if (!score_turned_is_better(off, s->row[n].error))
        return false;
    say(d, SCORE_ORDER, off,
        "Vertices are in another order than their uv: neighbours lie %.2g times as far "
        "apart "
        "as the truth's at %g s, yet all of them on its surface, to %.2g %%; does each "
        "vertex "
        "have its own uv?",
        apart, s->row[n].time, 100 * off);
    return true;
}

/* --- what was fitted ---------------------------------------------------------------------
 */

/* Frames that lead from their very first one show a later time; those that begin at rest
 * and lead by half a step or less were begun with g dt for the first velocity. */
static void say_lead(const struct score *s, double lead, const double shift[3],
                     struct score_diagnosis *d)
{
    const double *g = s->truth.scene.gravity,
                 fall = .5 * lead * lead * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const double far =
        sqrt(shift[0] * shift[0] + shift[1] * shift[1] + shift[2] * shift[2]);
    const bool ahead = fabs(s->start - far) > .5 * fall; /* NaN, no frame at 0: not known */

    if (lead > 0 && !ahead && lead < HALF_STEP * s->interval)
        say(d, SCORE_FIRST_ORDER_STEP, 2 * lead,
            "Falls as g t^2/2 (1 + dt/t) with dt = %.3g ms: the step is of first order; "
            "half of it takes half of this away.",
            2e3 * lead);
    else
        say(d, SCORE_LAG, -lead, "%s the truth by %.3g ms: %s",
            lead > 0 ? "Is ahead of" : "Lags behind", 1e3 * fabs(lead),
            lead > 0 ? "does frame 0 show the start?"
                     : "frames before the start, or a first-order step that begins at rest "
                       "(explicit Euler).");
}

static double left_by(const struct score_pace *pace)
{
    return pace->speed == 1 ? 1 : pace->error / pace->as_is;
}

/* Another multiple of the time puts far more right than all that was fitted: nothing else
 * is said, as all that was is held against other times. */
static bool say_pace(const struct score *s, const struct score_pace *pace,
                     const struct score_fit *fit, struct score_diagnosis *d)
{
    const bool slow = pace->speed < 1;
    char repeats[64] = "", gravity[64] = "";

    if (left_by(pace) > PACE_MOST || PACE_BETTER * left_by(pace) > fit->left)
        return false;
    if (s->repeats)
        snprintf(repeats, sizeof repeats, " (%d are as the one before)", s->repeats);
    if (!s->ladder.times) /* nothing was fitted that could tell them apart */
        snprintf(gravity, sizeof gravity, ", or is gravity %.3g times the scene's",
                 pace->speed * pace->speed);
    say(d, SCORE_TIME, pace->speed,
        "Runs %.2f times as %s as the truth: at t frames show what happens at %.4g t, and "
        "fit to %.2g %% in place of %.2g %%; do frames stand twice%s, are some left out, "
        "or "
        "is the time from one to the next another%s?",
        slow ? 1 / pace->speed : pace->speed, slow ? "slow" : "fast", pace->speed,
        100 * pace->error, 100 * pace->as_is, repeats, gravity);
    return true;
}

/* A free fall cannot tell another gravity from another pace, other scenes hardly. */
static void say_gravity(const struct score *s, double g, const struct score_pace *pace,
                        const struct score_fit *fit, struct score_diagnosis *d)
{
    const double speed = !s->truth.motions ? sqrt(fmax(g, 0))
                         : left_by(pace) < PACE_BETTER * fit->left && fit->count == 1
                             ? pace->speed
                             : 1;
    char other[64] = "";

    if (speed > 0 && speed != 1)
        snprintf(other, sizeof other, ", or does it run %.3g times as %s",
                 speed < 1 ? 1 / speed : speed, speed < 1 ? "slow" : "fast");
    say(d, SCORE_GRAVITY, g, "Moves as under gravity x %.3f: is g the scene's%s?", g,
        other);
}

static void say_fit(const struct score *s, const struct score_fit *fit,
                    const struct score_support *support, const struct score_pace *pace,
                    struct score_diagnosis *d)
{
    const double *value = fit->value;

    if (fit->has[FIT_LEAD])
        say_lead(s, value[FIT_LEAD], support->shift, d);
    if (fit->has[FIT_GRAVITY])
        say_gravity(s, 1 + value[FIT_GRAVITY], pace, fit, d);
    if (fit->has[FIT_DAMPING])
        say(d, SCORE_DAMPING, value[FIT_DAMPING],
            value[FIT_DAMPING] > 0
                ? "Is damped like by %.2g 1/s of mass damping, which the truth has not: "
                  "drag, or a step of first order."
                : "Gains energy, like by %.2g 1/s of mass damping.",
            value[FIT_DAMPING]);
    if (fit->has[FIT_HINGE] && value[FIT_HINGE] < CLAMP_MOST)
        say(d, SCORE_CLAMP, value[FIT_HINGE],
            "The clamp gives way, by %.0f %% of what a hinge does: where bending is an "
            "angle "
            "between elements, that over the held row stands for half a cell and needs "
            "twice the stiffness of the others.",
            100 * value[FIT_HINGE]);
    else if (fit->has[FIT_HINGE])
        say(d, SCORE_HINGE, value[FIT_HINGE],
            "The edge is held as a hinge, not a clamp (%.0f %% of the way to a hinge%s): "
            "where bending is an angle between elements, a second row outside the sheet "
            "must "
            "be held.",
            100 * value[FIT_HINGE],
            value[FIT_HINGE] > NO_BENDING ? ": hardly anything resists bending" : "");
    if (fit->has[FIT_BENDING])
        say(d, SCORE_BENDING, value[FIT_BENDING],
            "Bends like D x %.2f%s (D = E h^3 / 12 (1 - nu^2)).", value[FIT_BENDING],
            fit->at_end ? ", or beyond: the ladder of truths ends there" : "");
}

static void say_support(const struct score *s, const struct score_support *off,
                        struct score_diagnosis *d)
{
    const struct scene *scene = &s->truth.scene;
    const double *by = off->by;
    char what[192] = "Begins off the scene's rest shape, as a whole";

    if (scene->support_count) {
        const struct scene_support *held = &scene->supports[off->which];
        snprintf(
            what, sizeof what,
            "Is not held where the scene holds it: support %d (u %g to %g, v %g to %g) "
            "is %.2g %% off at %g s",
            off->which, held->lo[0], held->hi[0], held->lo[1], held->hi[1], 100 * off->most,
            off->time);
    }
    say(d, SCORE_SUPPORT, off->most, "%s, by (%.3g, %.3g, %.3g) m%s", what, by[0], by[1],
        by[2],
        off->steady ? ", and at all other times: is the sheet's pose the scene's?"
                    : "; are its vertices fixed, or moved by its path?");
}

/* Fits the flaws to the frames as they are, or put back where what is held is off by the
 * same at all times. A sheet that nothing holds may begin off because its frames are ahead:
 * there the fit that leaves less is taken. */
static enum status fit_either(const struct score *s, struct score_support *off,
                              struct score_fit *fit)
{
    struct score_fit back;
    enum status st;

    TRY(score_fit_make(s, (double[3]){0}, fit));
    if (!off->steady)
        goto out;
    TRY(score_fit_make(s, off->shift, &back));
    off->steady = s->truth.scene.support_count || back.rest < fit->rest;
    if (off->steady)
        *fit = back;
    else
        memset(off->shift, 0, sizeof off->shift);
out:
    return st;
}

static double largest(const struct score *s, bool floor)
{
    double most = 0;

    for (int n = 0; n < s->truth.times; n++)
        if (s->row[n].known)
            most = fmax(most, floor ? s->row[n].floor : s->row[n].error);
    return most;
}

/* What sound frames may be off by, over the length. */
static double sound_most(const struct score *s)
{
    double way = 0;

    for (int n = 0; n < s->truth.times; n++)
        if (s->row[n].known)
            way = fmax(way, score_rms(SCORE_POINTS, score_truth_field(&s->truth, n),
                                      s->truth.rest));
    return fmin(SOUND_MOST, SOUND_SHARE * way / s->truth.scene.length);
}

static bool is_sound(const struct score *s)
{
    const double most = sound_most(s);

    for (int n = 0; n < s->truth.times; n++)
        if (s->row[n].known &&
            s->row[n].error > most + TIMES_FLOOR * (s->row[n].bar + s->row[n].floor))
            return false;
    return true;
}

static void say_sound(const struct score *s, struct score_diagnosis *d)
{
    const struct score_time *last = &s->row[score_last(s)];
    const double error = largest(s, false), floor = largest(s, true);

    if (last->floor > last->bar && last->error < TIMES_FLOOR * last->floor)
        say(d, SCORE_FLOOR, last->floor,
            "Is at its net's floor: the truth itself between these vertices is off by %.2g "
            "%% at %g s; only a finer net can do better.",
            100 * last->floor, last->time);
    if (!is_sound(s))
        return;
    if (last->bar > SOUND_MOST && error > SOUND_MOST)
        say(d, SCORE_SOUND, error,
            "Nothing can be said against it: at most %.2g %% off, where the truth itself "
            "has "
            "an error bar of up to %.2g %%.",
            100 * error, 100 * last->bar);
    else
        say(d, SCORE_SOUND, error,
            "Nothing wrong was found: at most %.2g %% off, the net's floor at most %.2g "
            "%%.",
            100 * error, 100 * floor);
}

enum status score_diagnosis_make(const struct score *s, struct score_diagnosis *d)
{
    struct score_support support;
    struct score_pace pace;
    struct score_fit fit;
    enum status st = STATUS_OK;

    memset(d, 0, sizeof *d);
    if (score_last(s) < 0 || say_still(s, d) || say_turned(s, d) || say_scattered(s, d))
        goto out;
    TRY(score_support_find(s, &support));
    TRY(fit_either(s, &support, &fit));
    pace = score_pace_best(s);
    if (say_pace(s, &pace, &fit, d))
        goto out;
    if (support.steady)
        say_support(s, &support, d);
    TRY(say_stretch(s, d));
    say_fit(s, &fit, &support, &pace, d);
    d->left = fit.left < 1 ? fit.left : 0;
    if (!d->count && support.most > 0)
        say_support(s, &support, d);
    if (!d->count)
        say_sound(s, d);
out:
    return st;
}
