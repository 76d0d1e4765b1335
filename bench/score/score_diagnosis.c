#include "bench/score/score_diagnosis.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/score/score_fit.h"
#include "bench/score/score_turned.h"

/* Frames that move by less than this share of what the truth does are still. */
#define STILL_MOST 0.01

/* Lines of the net longer, or shorter, than the truth's by this share are said: chords of a
 * coarse net and what lies between two frames are too short, never too long. */
#define STRETCH_LEAST 0.005
#define SHRINK_LEAST  0.01

/* Where the truth itself stretches by more than this, its stretch is the measure: frames
 * whose differs by this share of it have a sentence. */
#define STRAIN_LEAST 1e-3
#define STRAIN_OFF   0.1

/* A lead of half a step is a first-order step's. Frames come every step or more seldom. */
#define HALF_STEP 0.55

/* A hinge by so much more than one: without bending no edge is clamped, and no sheet stiff.
 */
#define NO_BENDING 1.15

/* Error within so many times floor or bar is theirs; what the sharper of our own
 * contestants reach is sound, too, unless it is more than a small share of all that the
 * truth moves. */
#define TIMES_FLOOR 2
#define SOUND_MOST  0.005
#define SOUND_SHARE 0.05

/* What is held is where the truth has it, to this share of the length: penalties give way.
 */
#define HELD_MOST 0.01

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

/* Lines along u, or along v: lengths, and how unlike each other the frames' pieces are. */
struct lines {
    double rest, truth, got;
    double spread; /* standard deviation of got over truth, a piece */
    double floor;  /* share of the truth's length by which got may be off */
};

static double piece(const double *field, int point, int to)
{
    const double *a = field + 3L * point, *b = field + 3L * to;
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];

    return sqrt(x * x + y * y + z * z);
}

static double share_off(const struct lines *l)
{
    return l->got / l->truth - 1;
}

/* Of the truth's stretch. */
static bool is_stretched(const struct lines *l)
{
    return l->truth / l->rest - 1 > STRAIN_LEAST && l->got > l->rest;
}

/* A share of the truth's own stretch, where it has one; and what chords of this net cut off
 * the truth's lines, which are `whole` long. */
static double floor_of(const struct lines *l, double whole)
{
    const double cut = fabs(whole / l->truth - 1);

    if (is_stretched(l))
        return cut + STRAIN_OFF * (1 - l->rest / l->truth);
    return cut + (share_off(l) > 0 ? STRETCH_LEAST : SHRINK_LEAST);
}

/* `truth` as the net sees it; `whole` as it is. */
static struct lines lines_of(const double *rest, const double *whole, const double *truth,
                             const double *got, bool along_v)
{
    double length = 0;
    struct lines l = {0};
    double sum = 0, squares = 0;
    int pieces = 0;

    for (int j = 0; j < GRID_V - along_v; j++)
        for (int i = 0; i < GRID_U - !along_v; i++) {
            const int a = j * GRID_U + i, b = a + (along_v ? GRID_U : 1);
            const double wanted = piece(truth, a, b), there = piece(got, a, b);
            l.rest += piece(rest, a, b);
            length += piece(whole, a, b);
            l.truth += wanted;
            l.got += there;
            sum += there / wanted;
            squares += there / wanted * (there / wanted);
            pieces++;
        }
    l.spread = sqrt(fmax(0, squares / pieces - sum / pieces * (sum / pieces)));
    l.floor = floor_of(&l, length);
    return l;
}

static void stretch_text(const struct lines *l, double when, struct score_diagnosis *d)
{
    const double more = share_off(l), strain = l->truth / l->rest - 1;

    if (is_stretched(l))
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

/* Of both directions at all times, the one that is farthest beyond its own floor. */
static enum status say_stretch(const struct score *s, struct score_diagnosis *d)
{
    double *seen = malloc(3 * SCORE_POINTS * sizeof *seen), when = 0, far = 1;
    struct lines most = {0};

    for (int n = 0; seen && n < s->truth.times; n++) {
        if (!s->row[n].known)
            continue;
        score_seen(s, n, seen);
        for (int k = 0; k < 2; k++) {
            const struct lines l = lines_of(s->truth.rest, score_truth_field(&s->truth, n),
                                            seen, s->field + 3L * SCORE_POINTS * n, k);
            if (fabs(share_off(&l)) > far * l.floor) {
                far = fabs(share_off(&l)) / l.floor;
                most = l;
                when = s->row[n].time;
            }
        }
    }
    free(seen);
    if (!seen)
        return STATUS_MEMORY;
    if (far > 1)
        stretch_text(&most, when, d);
    return STATUS_OK;
}

/* --- what was fitted ---------------------------------------------------------------------
 */

/* Frames that lead from their very first one show a later time; those that begin at rest
 * and lead by half a step or less were begun with g dt for the first velocity. */
static void say_lead(const struct score *s, double lead, struct score_diagnosis *d)
{
    const double *g = s->truth.scene.gravity,
                 fall = .5 * lead * lead * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const bool ahead = s->start > .5 * fall; /* NaN, no frame at 0: not known */

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

static void say_fit(const struct score *s, const struct score_fit *fit,
                    struct score_diagnosis *d)
{
    const double *value = fit->value;

    if (fit->has[FIT_LEAD])
        say_lead(s, value[FIT_LEAD], d);
    if (fit->has[FIT_GRAVITY])
        say(d, SCORE_GRAVITY, 1 + value[FIT_GRAVITY],
            "Moves as under gravity x %.3f: is g the scene's?", 1 + value[FIT_GRAVITY]);
    if (fit->has[FIT_DAMPING])
        say(d, SCORE_DAMPING, value[FIT_DAMPING],
            value[FIT_DAMPING] > 0
                ? "Is damped like by %.2g 1/s of mass damping, which the truth has not: "
                  "drag, or a step of first order."
                : "Gains energy, like by %.2g 1/s of mass damping.",
            value[FIT_DAMPING]);
    if (fit->has[FIT_HINGE])
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

/* rms over the points of a support, in what it fixes, of how far frames are from what their
 * net sees of the truth [m]; 0: the grid has none of them. */
static double support_off(const struct scene_support *held, const double *seen,
                          const double *got)
{
    const double NEAR = 1e-9;
    double sum = 0;
    int points = 0;

    for (int p = 0; p < SCORE_POINTS; p++) {
        const double uv[2] = {p % GRID_U / (GRID_U - 1.), p / GRID_U / (GRID_V - 1.)};
        if (uv[0] < held->lo[0] - NEAR || uv[0] > held->hi[0] + NEAR ||
            uv[1] < held->lo[1] - NEAR || uv[1] > held->hi[1] + NEAR)
            continue;
        points++;
        for (int c = 0; c < 3; c++)
            if (held->fix & 1u << c) {
                const double off = got[3 * p + c] - seen[3 * p + c];
                sum += off * off;
            }
    }
    return points ? sqrt(sum / points) : 0;
}

/* Of all supports at all times, the one that is farthest off. */
static enum status say_support(const struct score *s, struct score_diagnosis *d)
{
    const struct scene *scene = &s->truth.scene;
    double *seen = malloc(3 * SCORE_POINTS * sizeof *seen), most = 0, when = 0;
    int which = 0;

    for (int n = 0; seen && n < s->truth.times; n++) {
        if (!s->row[n].known)
            continue;
        score_seen(s, n, seen);
        for (int k = 0; k < scene->support_count; k++) {
            const double off =
                support_off(&scene->supports[k], seen, s->field + 3L * SCORE_POINTS * n);
            if (off > most)
                most = off, when = s->row[n].time, which = k;
        }
    }
    free(seen);
    if (!seen)
        return STATUS_MEMORY;
    most /= scene->length;
    if (most > HELD_MOST)
        say(d, SCORE_SUPPORT, most,
            "Is not held where the scene holds it: support %d (u %g to %g, v %g to %g) is "
            "%.2g %% off at %g s; are its vertices fixed, or moved by its path?",
            which, scene->supports[which].lo[0], scene->supports[which].hi[0],
            scene->supports[which].lo[1], scene->supports[which].hi[1], 100 * most, when);
    return STATUS_OK;
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
    struct score_fit fit;
    enum status st = STATUS_OK;

    memset(d, 0, sizeof *d);
    if (score_last(s) < 0 || say_still(s, d) || say_turned(s, d))
        goto out;
    TRY(score_fit_make(s, &fit));
    TRY(say_stretch(s, d));
    say_fit(s, &fit, d);
    d->left = fit.after < fit.before ? fit.after / fit.before : 0;
    if (!d->count)
        TRY(say_support(s, d));
    if (!d->count)
        say_sound(s, d);
out:
    return st;
}
