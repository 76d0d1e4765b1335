#include "bench/score/score_diagnosis.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "models/vector.h"

/* --- the fit ----------------------------------------------------------------------------
 *
 * Finds the flaws, and their sizes, that turn the truth into the frames: least squares,
 * over all times and points, of the difference by each flaw's effect.
 *
 * On edge_drop what a flaw does is taken from the ladder: bending by
 * cubics in log D, the others in proportion. On a sheet that nothing holds it is known: a
 * fall by d(t) that begins with the velocity of half a step moves on by 2 d / t, and so on.
 * Elsewhere nothing is fitted.
 */

enum fit_kind {
    FIT_LEAD,    /* [s] frames show what the truth does so much later                     */
    FIT_GRAVITY, /* share of g too much                                                   */
    FIT_DAMPING, /* [1/s] of mass damping                                                 */
    FIT_HINGE,   /* 1: the edge is a hinge, 0: a clamp                                    */
    FIT_STRETCH, /* longer; no size is given, score_diagnosis.h measures it               */
    FIT_BENDING, /* D times so much                                                       */
    FIT_KINDS
};

struct score_fit {
    int count;               /* of flaws                                               */
    bool has[FIT_KINDS];     /* whether the frames have the flaw                       */
    double value[FIT_KINDS]; /* its size, if so                                        */
    bool at_end;             /* bending: off the ladder's end                          */
    double rest;             /* rms difference that is left, in the same unit of all fits */
    double left;             /* share of the rms difference; 1: no flaw                */
};

/* Columns of the least squares: the frames' difference, then the effect of each flaw.
 * Stretch has two: by the ladder, and in proportion to the distance from the held edge. */
enum {
    Y,
    LEAD,
    GRAVITY,
    DAMPING,
    HINGE,
    STRETCH,
    SCALE,
    RUNG,
    COLUMNS = RUNG + LADDER_RUNGS
};
static const int first_column[FIT_KINDS] = {LEAD, GRAVITY, DAMPING, HINGE, STRETCH, RUNG};

/* The weight of a time follows its displacement, with this share of the length added. */
#define SMALL 0.01

/* A difference is examined where it exceeds its uncertainty (the truth's bar, the net's
 * floor, and rounding to four digits of the length) this many times. */
#define TIMES_NOISE 2
#define ROUNDING    1e-4

/* Velocities are differences over two moments [s]. */
#define MOMENT 0.005

/* Flaws are believed where they leave at most LEFT_MOST of the squared difference, each of
 * them where MUST_MATTER times as much would be left without it; one more flaw than
 * explains most of it is believed where it halves the rms difference. */
#define LEFT_MOST   0.25
#define MUST_MATTER 1.5
#define LEFT_HALF   0.25

/* An edge is not a hinge where the fit makes it less than HINGE_LEAST or more than
 * HINGE_MOST of one. */
#define HINGE_LEAST 0.15
#define HINGE_MOST  2

/* The bending stiffness is searched at so many values between the ladder's ends. */
enum { TRIES = 121, SET_MOST = 3 };

struct sums {
    double gram[COLUMNS][COLUMNS]; /* sums over all rows of products of two columns      */
    double noise;                  /* the same of the uncertainty, squared                */
    bool ladder;
    double column[COLUMNS][3 * LADDER_POINTS]; /* of the time that is added              */
};

/* Adds a time at which the truth has moved from rest, with an uncertainty of `noise` [m].
 */
static void add_time(struct sums *s, const double *truth, const double *rest, double length,
                     double noise)
{
    const double weight = 1 / (score_rms(LADDER_POINTS, truth, rest) + SMALL * length);

    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        for (int a = 0; a < COLUMNS; a++)
            for (int b = 0; b < COLUMNS; b++)
                s->gram[a][b] += weight * weight * s->column[a][n] * s->column[b][n];
    s->noise += LADDER_POINTS * weight * weight * noise * noise;
}

/* --- on the ladder --- */

/* Fills a column with the effect of something that turns the base into `fields`. */
static void fill_effect(const struct score *s, const double *fields, const double *rest,
                        double t, const double *base, double size, double *column)
{
    const struct score_ladder *l = &s->truth->ladder;
    double field[3 * LADDER_POINTS];

    score_between(l->times, l->time, t, rest, fields, field);
    score_map_seen(&s->fine.map, LADDER_U, LADDER_V, field, column);
    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        column[n] = (column[n] - base[n]) / size;
}

static void add_ladder_time(const struct score *s, int frame, const double *rest,
                            const double shift[3], struct sums *sums)
{
    static const int flaws[LADDER_FLAWS] = {DAMPING, GRAVITY, STRETCH, HINGE};
    static const double none[3 * LADDER_POINTS];
    const struct score_ladder *l = &s->truth->ladder;
    const long motion = 3L * LADDER_POINTS * l->times; /* numbers of one */
    const double
        size[LADDER_FLAWS] = {l->size[LADDER_DAMPING], l->size[LADDER_GRAVITY] - 1, 1, 1},
        t = s->fine.when[frame], *got = score_view_field(&s->fine, frame),
        *fields = l->rung + LADDER_BASE * motion, length = s->truth->length,
        bar = l->bar[LADDER_BASE * l->times + (int)fmin(t / l->time[0], l->times - 1)];
    double truth[3 * LADDER_POINTS], base[3 * LADDER_POINTS], before[3 * LADDER_POINTS];

    score_between(l->times, l->time, t, rest, fields, truth);
    fill_effect(s, fields, rest, t, none, 1, base);
    fill_effect(s, fields, rest, t - MOMENT, none, 1, before);
    fill_effect(s, fields, rest, t + MOMENT, before, 2 * MOMENT, sums->column[LEAD]);
    for (int f = 0; f < LADDER_FLAWS; f++)
        fill_effect(s, l->flaw + f * motion, rest, t, base, size[f],
                    sums->column[flaws[f]]);
    for (int r = 0; r < LADDER_RUNGS; r++)
        fill_effect(s, l->rung + r * motion, rest, t, base, 1, sums->column[RUNG + r]);
    for (int n = 0; n < 3 * LADDER_POINTS; n++) {
        const int edge = n / (3 * LADDER_U) * 3 * LADDER_U + n % 3;
        sums->column[Y][n] = got[n] - shift[n % 3] - base[n];
        sums->column[SCALE][n] = base[n] - base[edge];
    }
    add_time(sums, truth, rest, length,
             (bar + ROUNDING) * length + score_rms(LADDER_POINTS, base, truth));
}

static void add_ladder(const struct score *s, const double shift[3], struct sums *sums)
{
    const double last = s->truth->ladder.time[s->truth->ladder.times - 1] + MOMENT;
    double rest[3 * LADDER_POINTS];

    score_coarse_rest(s, rest);
    sums->ladder = true;
    for (int n = 0; n < s->fine.times; n++)
        if (s->fine.when[n] > 0 && s->fine.when[n] <= last)
            add_ladder_time(s, n, rest, shift, sums);
}

/* --- in free fall --- */

static bool falls_free(const struct scene *scene)
{
    const double *g = scene->gravity, *v = scene->velocity, *w = scene->spin;
    bool moves = false, thrown = false;

    for (int c = 0; c < 3; c++) {
        moves = moves || g[c] != 0;
        thrown = thrown || v[c] != 0 || w[c] != 0;
    }
    return moves && !thrown && !scene->pattern && !scene->support_count &&
           !scene->obstacle_count && !scene->load_count && scene->drag == 0 &&
           scene->air.density == 0 && scene->damping.kind == DAMPING_NONE;
}

static void add_fall(const struct score *s, const double shift[3], struct sums *sums)
{
    const double length = s->truth->length, *rest = s->path;
    double truth[3 * LADDER_POINTS];

    for (int frame = 0; frame < s->fine.times; frame++) {
        const double t = s->fine.when[frame], *got = score_view_field(&s->fine, frame);
        if (!(t > 0))
            continue;
        score_path(s, t, truth);
        for (int n = 0; n < 3 * LADDER_POINTS; n++) {
            const double fall = truth[n] - rest[n];
            sums->column[Y][n] = got[n] - shift[n % 3] - truth[n];
            sums->column[LEAD][n] = 2 * fall / t;
            sums->column[GRAVITY][n] = fall;
            sums->column[DAMPING][n] = -fall * t / 3;
            sums->column[SCALE][n] =
                rest[n] - .5 * (rest[n % 3] + rest[3 * (LADDER_POINTS - 1) + n % 3]);
        }
        add_time(sums, truth, rest, length, ROUNDING * length);
    }
}

/* --- least squares --- */

struct trial {
    double left; /* squared difference */
    double value[FIT_KINDS], stiffness;
};

/* Solves a x = b, a symmetric and positive, by elimination; skips zero diagonals. */
static void solve(int count, double a[][COLUMNS], double *b)
{
    for (int k = 0; k < count; k++) {
        if (!(a[k][k] > 0))
            continue;
        for (int i = k + 1; i < count; i++) {
            const double by = a[i][k] / a[k][k];
            for (int j = k; j < count; j++)
                a[i][j] -= by * a[k][j];
            b[i] -= by * b[k];
        }
    }
    for (int k = count - 1; k >= 0; k--) {
        for (int j = k + 1; j < count; j++)
            b[k] -= a[k][j] * b[j];
        b[k] = a[k][k] > 0 ? b[k] / a[k][k] : 0;
    }
}

/* Fits a set of flaws with a given bending stiffness, from 0 to 1 along the ladder. */
static struct trial try_set(const struct sums *s, unsigned set, double stiffness)
{
    int column[COLUMNS], kind[COLUMNS], count = 0;
    double a[COLUMNS][COLUMNS], b[COLUMNS], right[COLUMNS];
    double rung[LADDER_RUNGS] = {0}, four[4];
    struct trial t = {.left = s->gram[Y][Y], .stiffness = stiffness};

    if (set >> FIT_BENDING & 1)
        memcpy(rung + score_net_cubic(LADDER_RUNGS, stiffness, four), four, sizeof four);
    for (int k = 0; k < FIT_BENDING; k++)
        for (int n = 0; (set >> k & 1) && n < (k == FIT_STRETCH ? 2 : 1); n++)
            if (s->gram[first_column[k] + n][first_column[k] + n] > 0)
                column[count] = first_column[k] + n, kind[count++] = k;
    for (int q = 0; q < LADDER_RUNGS; q++) {
        t.left -= 2 * rung[q] * s->gram[Y][RUNG + q];
        for (int r = 0; r < LADDER_RUNGS; r++)
            t.left += rung[q] * rung[r] * s->gram[RUNG + q][RUNG + r];
    }
    for (int i = 0; i < count; i++) {
        b[i] = s->gram[Y][column[i]];
        for (int q = 0; q < LADDER_RUNGS; q++)
            b[i] -= rung[q] * s->gram[RUNG + q][column[i]];
        right[i] = b[i];
        for (int j = 0; j < count; j++)
            a[i][j] = s->gram[column[i]][column[j]];
    }
    solve(count, a, b);
    for (int i = 0; i < count; i++) {
        t.left -= b[i] * right[i];
        t.value[kind[i]] = b[i];
    }
    return t;
}

/* Fits a set of flaws and, if it contains bending, its stiffness. */
static struct trial best_of(const struct sums *s, unsigned set)
{
    const bool bends = set >> FIT_BENDING & 1;
    struct trial best = try_set(s, set, bends ? 0 : .5);

    for (int n = 1; bends && n < TRIES; n++) {
        const struct trial t = try_set(s, set, n / (TRIES - 1.));
        best = t.left < best.left ? t : best;
    }
    best.left = fmax(best.left, 0);
    return best;
}

/* Checks that each flaw is needed to leave little and that a fitted hinge has a plausible
 * size. */
static bool all_matter(const struct sums *s, unsigned set, const struct trial *t)
{
    const double hinge = t->value[FIT_HINGE], left = t->left;

    if ((set >> FIT_HINGE & 1) && !(hinge > HINGE_LEAST && hinge < HINGE_MOST))
        return false;
    for (int k = 0; k < FIT_KINDS; k++)
        if ((set >> k & 1) &&
            best_of(s, set & ~(1U << k)).left < MUST_MATTER * left + TIMES_NOISE * s->noise)
            return false;
    return true;
}

/* Returns the smallest set of flaws that explains most of the difference and that no larger
 * one improves by half; 0: none. */
static unsigned choose(const struct sums *s)
{
    const double all = s->gram[Y][Y];
    const unsigned most = s->ladder ? 1U << FIT_KINDS : 1U << FIT_HINGE;
    unsigned chosen = 0;
    double least = fmax(LEFT_MOST * all, TIMES_NOISE * TIMES_NOISE * s->noise);

    if (all <= TIMES_NOISE * TIMES_NOISE * s->noise)
        return 0;
    for (int size = 1; size <= SET_MOST; size++) {
        const double before = least;
        for (unsigned set = 1; set < most; set++) {
            if (__builtin_popcount(set) != size)
                continue;
            const struct trial t = best_of(s, set);
            if (t.left < least && all_matter(s, set, &t)) {
                least = t.left;
                chosen = set;
            }
        }
        if (least < before)
            least *= LEFT_HALF;
    }
    return chosen;
}

/* Fits flaws to the frames, moved back by `shift` [m]. *fit has none where nothing can be
 * fitted, the difference is within the bars and the net's floor, or no three flaws explain
 * most of it. */
static void score_fit_make(const struct score *score, const double shift[3],
                           struct score_fit *fit)
{
    struct sums sums = {.noise = 0};

    memset(fit, 0, sizeof *fit);
    if (score->truth->ladder.times > 2)
        add_ladder(score, shift, &sums);
    else if (falls_free(&score->truth->scene) && score->truth->moves)
        add_fall(score, shift, &sums);
    const unsigned set = choose(&sums);
    const struct trial t = best_of(&sums, set);
    fit->count = __builtin_popcount(set);
    for (int k = 0; k < FIT_KINDS; k++) {
        fit->has[k] = set >> k & 1;
        fit->value[k] = t.value[k];
    }
    fit->at_end = t.stiffness <= 0 || t.stiffness >= 1;
    if (fit->has[FIT_BENDING]) {
        const double *scale = score->truth->ladder.scale;
        fit->value[FIT_BENDING] =
            scale[0] * pow(scale[LADDER_RUNGS - 1] / scale[0], t.stiffness);
    }
    fit->rest = sqrt(t.left);
    fit->left = set ? sqrt(t.left / sums.gram[Y][Y]) : 1;
}

/* A sheet begins turned from this angle on [degrees]. */
#define TURNED_LEAST 0.5

/* Frames that move by less than this share of what the truth does are still. */
#define STILL_MOST 0.01

/* Neighbours so many times as far apart as the truth's are none in any cloth. */
#define SCATTERED_LEAST 2

/* Another pace is reported where it leaves this many times less than the fitted flaws
 * do: another gravity differs from it only by what bending does, which a net's own error
 * hides. */
#define PACE_BETTER 3

/* Another pace must also leave no more than this share: a flag that is too stiff is slower,
 * too, and leaves a quarter. */
#define PACE_MOST 0.1

/* A lead of up to half a step is a first-order step's; frames come every step or less
 * often. */
#define HALF_STEP 0.55

/* An edge that is less of a hinge than this is a clamp that gives way: springs and hinges
 * on 10 cells reach 0.57 where the held row's hinges count like the others, 0.98 where it
 * has none. */
#define CLAMP_MOST 0.8

/* An edge that is this much more than a hinge shows that the sheet has no bending at all:
 * without bending no edge is clamped, and no sheet stiff. */
#define NO_BENDING 1.15

/* An error within this many times the floor or the bar is explained by them. What the
 * better ones of our own contestants reach is sound, too, unless it is more than a small
 * share of the truth's displacement. */
#define TIMES_FLOOR 2
#define SOUND_MOST  0.005
#define SOUND_SHARE 0.05

/* --- other axes, units or orders --- */

struct turned {
    int axis[3];    /* the scene's x, y, z are the frames' so many-th */
    double sign[3]; /* 1 or -1 of it                                  */
    double scale;   /* and times this                                 */
    int order;    /* bits: 1: u and v exchanged, 2: u, 4: v runs the other way           */
    double error; /* rms over all known times, over the length                           */
    double as_is; /* the same of the frames as they are                                  */
};

/* Other axes, units or orders are reported where they leave less than this share of an
 * error that is itself more than WORTH_IT of the length. */
#define MUCH_BETTER 0.25
#define WORTH_IT    0.02

/* Each change that a candidate makes counts as this much more error, so that of two which
 * fit equally well the simpler one is chosen. */
#define CHANGE_COSTS 0.02

static const double scales[] = {1, 1e-3, 1e-2, 1e3, 1e2, 0.0254, 0.3048};
enum {
    SCALES = sizeof scales / sizeof *scales,
    LAST = GRID_U - 1,
};
enum { PERMUTATIONS = 6, SIGNS = 8, ORDERS = 8 };
static const int permutation[PERMUTATIONS][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                                 {2, 1, 0}, {1, 2, 0}, {2, 0, 1}};

/* A few of the grid's points, every ninth each way, for trying many motions. */
enum { EVERY = 9, SIDE = LAST / EVERY + 1, FEW = SIDE * SIDE };

/* Returns the grid's index of the n-th of the few points. */
static int few(int n)
{
    return n / SIDE * EVERY * GRID_U + n % SIDE * EVERY;
}

static int moved(int n, int order)
{
    int i = n % GRID_U, j = n / GRID_U;

    if (order & 1) {
        const int other = i;
        i = j, j = other;
    }
    i = order & 2 ? LAST - i : i;
    j = order & 4 ? LAST - j : j;
    return j * GRID_U + i;
}

/* Returns the squared error, summed over all times and few points; stops early where it
 * exceeds `least`. */
static double squared(const struct score *s, const struct turned *t, double least)
{
    double sum = 0;

    for (int n = 0; n < s->times && sum <= least; n++)
        for (int k = 0; k < FEW; k++) {
            const int p = few(k);
            const double *x = s->row[n].got + 3 * moved(p, t->order),
                         *truth = s->row[n].truth + 3 * p;
            for (int c = 0; c < 3; c++) {
                const double d = t->sign[c] * t->scale * x[t->axis[c]] - truth[c];
                sum += isnan(d) ? 0 : d * d; /* beside the sheet */
            }
        }
    return sum;
}

static int changes(const struct turned *t)
{
    int count = (t->scale != 1) + (t->order != 0);

    for (int c = 0; c < 3; c++)
        count += (t->axis[c] != c) + (t->sign[c] < 0);
    return count;
}

static struct turned candidate(int n)
{
    struct turned t = {.order = n % ORDERS};
    const int signs = n / ORDERS % SIGNS,
              *axis = permutation[n / (ORDERS * SIGNS) % PERMUTATIONS];

    for (int c = 0; c < 3; c++) {
        t.axis[c] = axis[c];
        t.sign[c] = signs >> c & 1 ? -1 : 1;
    }
    t.scale = scales[n / (ORDERS * SIGNS * PERMUTATIONS)];
    return t;
}

/* Returns the rms distance, over the length, of a few of the frames' points from the
 * truth's nearest points. */
static double nearest(const struct score_time *row, double length)
{
    double sum = 0;
    int count = 0;

    for (int k = 0; k < FEW; k++) {
        const double *a = row->got + 3 * few(k);
        double least = INFINITY;
        if (isnan(a[0]))
            continue;
        count++;
        for (int p = 0; p < SCORE_POINTS; p++)
            least = fmin(least, vector_distance(a, row->truth + 3 * p));
        sum += least * least;
    }
    return sqrt(sum / count) / length;
}

/* Returns whether an error is so much smaller than that of the frames as they are that
 * something else must be meant, and that one large enough to matter; both over the length.
 */
static bool is_better(double error, double as_is)
{
    return as_is > WORTH_IT && error < MUCH_BETTER * as_is;
}

/* Returns the best of all candidates; the frames as they are, if nothing is much better. */
static struct turned best_turn(const struct score *s)
{
    const double length = s->truth->length;
    int points = 0;
    struct turned as_is = candidate(0), best = as_is;
    double least = squared(s, &as_is, INFINITY);

    for (int k = 0; k < FEW; k++)
        points += s->times * !isnan(s->truth->rest[3 * few(k)]);
    as_is.error = as_is.as_is = sqrt(least / points) / length;
    if (as_is.error < WORTH_IT)
        return as_is;
    for (int n = 1; n < ORDERS * SIGNS * PERMUTATIONS * SCALES; n++) {
        struct turned t = candidate(n);
        if (t.order && s->truth->scene.pattern) /* it has no rows to take for columns */
            continue;
        const double more = 1 + CHANGE_COSTS * changes(&t);
        const double sum = squared(s, &t, least / (more * more));
        if (sum * more * more < least) {
            least = sum * more * more;
            t.error = sqrt(sum / points) / length;
            best = t;
        }
    }
    best.as_is = as_is.as_is;
    return changes(&best) && is_better(best.error, as_is.error) ? best : as_is;
}

/* --- another clock --- */

/* Frames show at t what the truth does at `speed` t + `shift`. */
struct clock {
    double speed, shift;
    double error; /* rms over the frames for which both are known, over the length       */
    double as_is; /* the same of the frames as they are                                  */
};

/* The speed is searched in steps of one per cent, then between two of them. */
enum { STEPS = 210, HALVINGS = 20 };
#define STEP 1.01

/* A single time would be met by many speeds. */
enum { TIMES_LEAST = 2 };

/* Returns the squared rms distance of a frame from the truth at a time. */
static double square_off(const struct score *s, int frame, double time)
{
    double field[3 * LADDER_POINTS];

    score_path(s, time, field);
    return pow(score_rms(LADDER_POINTS, score_view_field(&s->fine, frame), field), 2);
}

/* Returns the clock with its errors, which stay NaN where too few frames have a truth;
 * as_is[fine.times]: squared distances of the frames as they are. */
static struct clock compare(const struct score *s, const double *as_is, double speed,
                            double shift)
{
    const double last = s->fine.time[s->fine.times - 1], length = s->truth->length;
    struct clock clock = {speed, shift, NAN, NAN};
    double sum[2] = {0, 0};
    int times = 0;

    for (int n = 0; n < s->fine.times; n++) {
        const double t = s->fine.when[n], then = fmax(speed * t + shift, 0);
        if (!(t >= 0 && then <= last)) /* NaN: no frame */
            continue;
        times++;
        sum[0] += square_off(s, n, then);
        sum[1] += as_is[n];
    }
    if (times < TIMES_LEAST)
        return clock;
    clock.error = sqrt(sum[0] / times) / length;
    clock.as_is = sqrt(sum[1] / times) / length;
    return clock;
}

/* Returns the share of the error that another clock leaves; 1: there is none. */
static double share(const struct clock *c)
{
    return c->as_is > 0 ? c->error / c->as_is : 1;
}

/* Returns the best speed between an eighth and eight. */
static struct clock best_pace(const struct score *s, const double *as_is)
{
    struct clock best = {1, 0, 0, 0};
    double step = STEP;

    for (int n = -STEPS; n <= STEPS; n++) {
        const struct clock p = compare(s, as_is, pow(STEP, n), 0);
        best = share(&p) < share(&best) ? p : best;
    }
    for (int n = 0; n < HALVINGS; n++, step = sqrt(step)) {
        const struct clock less = compare(s, as_is, best.speed / step, 0),
                           more = compare(s, as_is, best.speed * step, 0);
        best = share(&less) < share(&best) ? less : best;
        best = share(&more) < share(&best) ? more : best;
    }
    return best;
}

/* --- how far each frame leads ---
 *
 * A frame leads by the time at which the truth comes nearest to it. A lost frame makes all
 * behind it lead by as much, one that stands twice makes them lag: the lead jumps between
 * two frames. What else is wrong changes it little from frame to frame, whatever their
 * interval.
 */

/* A jump is so many times what is left of the distance, and so many times as fast as the
 * lead changes before and after it; it moves the sheet by this share of the length. */
#define JUMP_TIMES 3
#define JUMP_LEAST 1e-3

enum { NEWTON = 20, LEADS_LEAST = 4 };

struct lead {
    double time, lead, speed; /* [s]; rms [m/s] of the truth then                        */
    double left;              /* rms distance from the truth then [m]                    */
    bool on;                  /* the truth's way: it comes near                         */
};

/* Finds how far a frame leads, by Newton's iterations from `lead`; NaN: beyond the truth.
 */
static struct lead find_lead(const struct score *s, int frame, double lead)
{
    const double t = s->fine.when[frame], *got = score_view_field(&s->fine, frame),
                 last = s->fine.time[s->fine.times - 1];
    double at[3 * LADDER_POINTS], ahead[3 * LADDER_POINTS], dot = 0, square = 0;
    int count = 0; /* of coordinates, without those beside the sheet */

    for (int k = 0; k < NEWTON && t + lead <= last + MOMENT; k++) {
        dot = square = 0, count = 0;
        score_path(s, t + lead, at);
        score_path(s, t + lead + MOMENT, ahead);
        for (int n = 0; n < 3 * LADDER_POINTS; n++) {
            const double v = (ahead[n] - at[n]) / MOMENT;
            if (isnan(v * got[n]))
                continue;
            count++;
            dot += v * (got[n] - at[n]);
            square += v * v;
        }
        if (square == 0)
            break;
        lead = fmax(lead + dot / square, -t);
    }
    const double left = score_rms(LADDER_POINTS, got, at),
                 way = score_rms(LADDER_POINTS, got, s->path);
    return (struct lead){t, lead, count ? sqrt(square / (count / 3)) : 0, left,
                         t + lead <= last &&
                             left <= SOUND_MOST * s->truth->length + SOUND_SHARE * way};
}

/* Fills lead[fine.times] with those of the frames on the truth's way; returns how many. */
static int find_leads(const struct score *s, struct lead *lead)
{
    int count = 0;

    for (int n = 0; n < s->fine.times; n++) {
        if (!(s->fine.when[n] > 0))
            continue;
        lead[count] = find_lead(s, n, count ? lead[count - 1].lead : 0);
        count += lead[count].on;
    }
    return count;
}

/* Returns by how much the lead changes in a second from frame n - 1 to n; 0: there is none.
 */
static double drift(const struct lead *lead, int count, int n)
{
    return n < 1 || n >= count
               ? 0
               : fabs(lead[n].lead - lead[n - 1].lead) / (lead[n].time - lead[n - 1].time);
}

/* Returns the first lead behind the jump that stands out most; -1: none does. */
static int find_jump(const struct score *s, const struct lead *lead, int count)
{
    const double least = JUMP_LEAST * s->truth->length;
    double most = JUMP_TIMES;
    int at = -1;

    for (int n = 1; n < count && count >= LEADS_LEAST; n++) {
        const double moved = fabs(lead[n].lead - lead[n - 1].lead) * lead[n].speed,
                     over = moved / fmax(lead[n].left, lead[n - 1].left),
                     beside = fmax(drift(lead, count, n - 1), drift(lead, count, n + 1));
        if (moved >= least && over >= most && drift(lead, count, n) >= JUMP_TIMES * beside)
            most = over, at = n;
    }
    return at;
}

/* These functions find what frames say of their times. */
struct times {
    double jump, from;      /* [s] the lead jumps at this time; 0: it does not           */
    bool own;               /* it is the lead before their own way, not the truth's      */
    struct clock lag, pace; /* one lead of all, one speed                                */
};

static struct times find_times(const struct score *s)
{
    struct times times = {.lag = {1, 0, 0, 0}, .pace = {1, 0, 0, 0}};
    struct arena own SCOPED(arena_clear) = {0};

    if (!s->truth->moves)
        return times;
    struct lead *lead = arena_take(&own, (size_t)s->fine.times, sizeof *lead);
    double *as_is = arena_take(&own, (size_t)s->fine.times, sizeof *as_is);
    for (int n = 0; n < s->fine.times; n++)
        as_is[n] = isnan(s->fine.when[n]) ? 0 : square_off(s, n, s->fine.when[n]);
    const int count = find_leads(s, lead), at = find_jump(s, lead, count);
    if (at > 0)
        times.jump = lead[at].lead - lead[at - 1].lead, times.from = lead[at].time;
    else if (s->repeats < 2) /* where many stand twice, it is another pace */
        times.jump = s->own.jump, times.from = s->own.from, times.own = true;
    if (count)
        times.lag = compare(s, as_is, 1, lead[count / 2].lead);
    if (!s->truth->known.closed) /* in a free fall it is another gravity */
        times.pace = best_pace(s, as_is);
    return times;
}

/* --- lengths of lines --- */

/* Lines along u or along v: their lengths, and how much the frames' pieces differ. */
struct lines {
    double rest, truth, got;
    double spread; /* standard deviation of got over truth, a piece */
    double floor;  /* share of the truth's length by which got may be off */
};

/* Lines of the net are reported where they are longer, or shorter, than the truth's by this
 * share: chords of a coarse net and interpolation between two frames make them too short,
 * never too long. */
#define STRETCH_LEAST 0.005
#define SHRINK_LEAST  0.01

/* Where the truth itself stretches by more than STRAIN_LEAST, the frames' stretch is
 * compared with it: a difference of STRAIN_OFF of it is reported. */
#define STRAIN_LEAST 1e-3
#define STRAIN_OFF   0.1

static double piece(const double *field, int point, int to)
{
    return vector_distance(field + 3L * point, field + 3L * to);
}

/* Returns the share by which lines are longer than the truth's. */
static double longer_by(const struct lines *l)
{
    return l->got / l->truth - 1;
}

/* Returns whether the truth itself stretches, so that the frames' stretch is compared with
 * it. */
static bool truth_stretches(const struct lines *l)
{
    return l->truth / l->rest - 1 > STRAIN_LEAST && l->got > l->rest;
}

/* Returns the share by which lines may be off: a share of the truth's own stretch, where
 * it has one, and what chords of this net cut off the truth's lines, which are `whole`
 * long. */
static double floor_of(const struct lines *l, double whole)
{
    const double cut = fabs(whole / l->truth - 1);

    if (truth_stretches(l))
        return cut + STRAIN_OFF * (1 - l->rest / l->truth);
    return cut + (longer_by(l) > 0 ? STRETCH_LEAST : SHRINK_LEAST);
}

/* Measures the grid's lines at a time against the truth as the net sees it. */
static struct lines lines_of(const struct score *s, const struct score_time *row,
                             bool along_v)
{
    struct lines l = {0};
    double whole = 0, sum = 0, squares = 0;
    int pieces = 0;

    for (int j = 0; j < GRID_V - along_v; j++)
        for (int i = 0; i < GRID_U - !along_v; i++) {
            const int a = j * GRID_U + i, b = a + (along_v ? GRID_U : 1);
            if (!along_v && grid_cut(s->truth->scene.sheets, i))
                continue;
            const double wanted = piece(row->seen, a, b), there = piece(row->got, a, b);
            if (isnan(wanted * there)) /* beside the sheet */
                continue;
            l.rest += piece(s->truth->rest, a, b);
            whole += piece(row->truth, a, b);
            l.truth += wanted;
            l.got += there;
            sum += there / wanted;
            squares += there / wanted * (there / wanted);
            pieces++;
        }
    l.spread = sqrt(fmax(0, squares / pieces - sum / pieces * (sum / pieces)));
    l.floor = floor_of(&l, whole);
    return l;
}

/* Finds, over both directions and all times, the lines that are farthest beyond their own
 * floor; returns when [s], 0: none are. */
static double find_stretch(const struct score *s, struct lines *most)
{
    double far = 1, when = 0;

    for (int n = 0; n < s->times; n++)
        for (int k = 0; k < 2; k++) {
            const struct lines l = lines_of(s, &s->row[n], k);
            if (fabs(longer_by(&l)) > far * l.floor) {
                far = fabs(longer_by(&l)) / l.floor;
                *most = l;
                when = s->row[n].time;
            }
        }
    return when;
}

/* --- supports --- */

struct held_off {
    int which;   /* the support that is farthest off:                                    */
    double most; /* rms over its points in what it fixes, over the length; 0: no more   */
                 /* than penalties give way                                             */
    double time, by[3]; /* then [s]; so much on average [m] */
    bool steady; /* all supports are off by the same, `shift`, at all times             */
    double shift[3]; /* [m]; else zero */
};

/* Held points may be off by this share of the length: penalties yield. */
#define HELD_MOST 0.01

/* Reported displacements are rounded to this [m]. */
#define DIGIT 1e-6

/* The sheet is shifted as a whole where offsets vary by less than this share of their
 * mean. */
#define SAME 0.25

/* Sums over points, of the components that their supports fix [m]. */
struct offsets {
    int points;
    double off[3], square;
};

static void add_points(const struct score *s, const struct scene_support *held,
                       const struct score_time *row, struct offsets *offsets)
{
    const double NEAR = 1e-9, *wanted = s->truth->scene.pattern ? row->truth : row->seen;

    for (int p = 0; p < SCORE_POINTS; p++) {
        const double uv[2] = {p % GRID_U / (GRID_U - 1.), p / GRID_U / (GRID_V - 1.)};
        if (uv[0] < held->lo[0] - NEAR || uv[0] > held->hi[0] + NEAR ||
            uv[1] < held->lo[1] - NEAR || uv[1] > held->hi[1] + NEAR ||
            isnan(wanted[3 * p]) || !scene_support_has(held, uv[0], uv[1]))
            continue;
        offsets->points++;
        for (int c = 0; c < 3; c++)
            if (held->fix & 1u << c) {
                const double off = row->got[3 * p + c] - wanted[3 * p + c];
                offsets->off[c] += off;
                offsets->square += off * off;
            }
    }
}

/* Fills by[3] with the mean offset; returns its length. */
static double mean(const struct offsets *offsets, double by[3])
{
    for (int c = 0; c < 3; c++)
        by[c] = offsets->points ? offsets->off[c] / offsets->points : 0;
    return vector_length(by);
}

/* Reports, for a sheet that nothing holds, a shift that it begins with. */
static void begins_off(const struct score *s, struct held_off *support)
{
    const double *by = s->begin, length = s->truth->length, far = vector_length(by);

    support->steady = far > HELD_MOST * length && s->start - far < SAME * far;
    support->most = support->steady ? far / length : 0;
    memcpy(support->by, by, sizeof support->by);
    memcpy(support->shift, by, sizeof support->shift);
}

/* Finds the support that is farthest from the truth as the net sees it. */
static struct held_off find_support(const struct score *s)
{
    const struct scene *scene = &s->truth->scene;
    struct held_off support = {0};
    struct offsets all = {0};
    double square = 0;

    for (int n = 0; n < s->times; n++)
        for (int k = 0; k < scene->support_count; k++) {
            struct offsets one = {0};
            add_points(s, &scene->supports[k], &s->row[n], &one);
            add_points(s, &scene->supports[k], &s->row[n], &all);
            if (one.points && one.square / one.points > square) {
                square = one.square / one.points;
                support.which = k;
                support.time = s->row[n].time;
                mean(&one, support.by);
            }
        }
    support.most = sqrt(square) / s->truth->length;
    const double shift = mean(&all, support.shift);
    support.steady = shift > HELD_MOST * s->truth->length &&
                     all.square / all.points - shift * shift < SAME * SAME * shift * shift;
    if (!scene->support_count)
        begins_off(s, &support);
    if (!support.steady)
        memset(support.shift, 0, sizeof support.shift);
    if (support.most <= HELD_MOST)
        support.most = 0;
    for (int c = 0; c < 3; c++)
        support.by[c] = round(support.by[c] / DIGIT) * DIGIT + 0.0;
    return support;
}

/* --- sentences --- */

const char *score_diagnosis_name(enum score_kind kind)
{
    static const char *const names[SCORE_KINDS] = {SCORE_KIND_LIST(LIST_WORD)};

    return names[kind];
}

bool score_diagnosis_has_place(const struct score_diagnosis *d)
{
    for (int n = 0; n < d->count; n++)
        if (d->finding[n].kind == SCORE_AXES || d->finding[n].kind == SCORE_UNITS ||
            d->finding[n].kind == SCORE_ORDER || d->finding[n].kind == SCORE_TURNED)
            return false;
    return true;
}

/* Evidence holds what is known of frames while hypotheses are tried, and what was found. */
struct evidence {
    struct score_diagnosis *d;
    struct held_off support;
    struct score_fit fit;
    struct times times;
};

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

/* --- before anything is fitted --- */

static bool say_still(const struct score *s, struct evidence *e)
{
    const struct score_time *last = &s->row[s->times - 1];
    const double moved = score_rms(SCORE_POINTS, last->truth, s->truth->rest),
                 theirs = score_rms(SCORE_POINTS, last->got, s->truth->rest);

    if (moved < STILL_MOST * s->truth->length || theirs > STILL_MOST * moved)
        return false;
    say(e->d, SCORE_STILL, theirs / moved,
        "Did not move: %.2g %% of the truth's way at %g s; are forces switched on, are "
        "all vertices held, do the frames come from the start?",
        100 * theirs / moved, last->time);
    return true;
}

/* Reports two vertices in each other's place, or some elsewhere. */
static bool say_strays(const struct score *s, struct evidence *e)
{
    const struct score_strays *w = &s->strays;

    if (!w->count)
        return false;
    if (w->exchanged)
        say(e->d, SCORE_ORDER, w->off,
            "%d vertices stand in each other's place, vertices %d and %d to begin with: "
            "does each have its own uv?",
            w->count, w->vertex[0] + 1, w->vertex[1] + 1);
    else
        say(e->d, SCORE_ORDER, w->off,
            "%d of %d vertices begin elsewhere than their uv say: vertex %d is %.2g %% of "
            "the length off, where most are %.2g %% off.",
            w->count, s->net.vertices, w->vertex[0] + 1, 100 * w->off, 100 * w->others);
    return true;
}

/* A component of a direction, in two digits: less than half of the last is none. */
static double component(double x)
{
    return fabs(x) < 0.005 ? 0 : x;
}

/* Reports that the first frame is the sheet at rest, but turned. */
static bool say_turn(const struct score *s, struct evidence *e)
{
    const struct score_turn *t = &s->turn;

    if (!(t->angle > TURNED_LEAST))
        return false;
    say(e->d, SCORE_TURNED, t->angle,
        "Begins turned by %.3g degrees about (%.2g, %.2g, %.2g): is the sheet's pose the "
        "scene's, and gravity along -z?",
        t->angle, component(t->axis[0]), component(t->axis[1]), component(t->axis[2]));
    return true;
}

static bool say_turned(const struct score *s, struct evidence *e)
{
    const struct turned t = best_turn(s);
    const bool axes_fit = changes(&t) && t.error < WORTH_IT;

    if (!axes_fit && say_turn(s, e))
        return true;
    const double now = 100 * t.as_is, then = 100 * t.error;
    char axes[32] = "";

    for (int c = 0; c < 3; c++)
        TEXT_JOIN(axes, ", ", "%s%c", t.sign[c] < 0 ? "-" : "", "xyz"[t.axis[c]]);
    if (t.scale != 1)
        say(e->d, SCORE_UNITS, t.scale,
            "Positions are in another unit: they fit to %.2g %% in place of %.2g %% with "
            "--scale %g.",
            then, now, t.scale);
    if (strcmp(axes, "x, y, z") != 0)
        say(e->d, SCORE_AXES, t.error,
            "Axes are exchanged: frames fit to %.2g %% in place of %.2g %% if %s are "
            "taken for x, y, z%s.",
            then, now, axes,
            !strcmp(axes, "x, -z, y")   ? " (--up y)"
            : !strcmp(axes, "-z, y, x") ? " (--up x)"
                                        : "");
    if (t.order)
        say(e->d, SCORE_ORDER, t.error,
            "Vertices are in another order than their uv: frames fit to %.2g %% in place "
            "of %.2g %% with %s%s%s.",
            then, now, t.order & 1 ? "rows and columns exchanged" : "the same rows",
            t.order & 2 ? ", u reversed" : "", t.order & 4 ? ", v reversed" : "");
    return e->d->count > 0;
}

static void stretch_text(const struct lines *l, double when, struct score_diagnosis *d)
{
    const double more = longer_by(l), strain = l->truth / l->rest - 1;

    if (truth_stretches(l))
        say(d, SCORE_STRETCH, more,
            "Stretches %.2g times as much as the truth (its lines, on average, by %.2g %% "
            "in place of %.2g %% at %g s): %s",
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

static bool say_stretch(const struct score *s, struct evidence *e)
{
    struct lines most = {0};
    const double when = find_stretch(s, &most);

    if (when > 0)
        stretch_text(&most, when, e->d);
    return when > 0;
}

/* Reports vertices in a wrong order: neighbours on the net lie far apart, yet all points
 * lie on the truth's surface. */
static bool say_scattered(const struct score *s, struct evidence *e)
{
    const struct score_time *row = s->row;
    double apart = 0;

    for (int k = 0; k < 2; k++) {
        const struct lines l = lines_of(s, row, k);
        apart = fmax(apart, l.got / l.truth);
    }
    if (apart < SCATTERED_LEAST)
        return false;
    const double off = nearest(row, s->truth->length);
    if (!is_better(off, row->error))
        return false;
    say(e->d, SCORE_ORDER, off,
        "Vertices are in another order than their uv: neighbours lie %.2g times as far "
        "apart as the truth's at %g s, yet all of them on its surface, to %.2g %%; does "
        "each vertex have its own uv?",
        apart, row->time, 100 * off);
    return true;
}

/* --- what was fitted --- */

/* Reports a lead or a lag. Frames that lead from the very first one show a later time;
 * those that begin at rest and lead by half a step or less had g dt as their first
 * velocity. */
static void say_lead(const struct score *s, double lead, const double shift[3],
                     struct score_diagnosis *d)
{
    const double fall = .5 * lead * lead * vector_length(s->truth->scene.gravity);
    const bool ahead = fabs(s->start - vector_length(shift)) >
                       .5 * fall; /* NaN, no frame at 0: not known */

    if (lead > 0 && !ahead && lead < HALF_STEP * s->interval)
        say(d, SCORE_FIRST_ORDER_STEP, 2 * lead,
            "Falls as g t^2/2 (1 + dt/t) with dt = %.3g ms: the step is of first order; "
            "half of it takes half of this away.",
            2e3 * lead);
    else
        say(d, SCORE_LAG, -lead, "%s the truth by %.3g ms: %s",
            lead > 0 ? "Is ahead of" : "Lags behind", 1e3 * fabs(lead),
            lead > 0 ? "does frame 0 show the start?"
                     : "frames before the start, or a first-order step that begins at "
                       "rest (explicit Euler).");
}

/* Returns the error that sound frames may have, over the length, beside bar and floor. */
static double sound_most(const struct score *s)
{
    double way = 0;

    for (int n = 0; n < s->times; n++)
        way = fmax(way, score_rms(SCORE_POINTS, s->row[n].truth, s->truth->rest));
    return fmin(SOUND_MOST, SOUND_SHARE * way / s->truth->length);
}

/* Returns whether another clock explains the error, and far better than the fit does, or
 * better than its own lead: another pace leaves a small share, or no more than sound frames
 * may have. */
static bool is_clock(const struct score *s, const struct clock *c,
                     const struct score_fit *fit)
{
    const bool lag = c->speed == 1;
    const double better = lag && fit->has[FIT_LEAD] ? 1 : PACE_BETTER;

    return c->as_is > JUMP_LEAST && share(c) <= MUCH_BETTER &&
           better * share(c) <= fit->left &&
           (lag || share(c) <= PACE_MOST ||
            (c->as_is > WORTH_IT && c->error <= sound_most(s)));
}

/* Reports a jump of the lead, another pace or another start. Nothing else is then reported,
 * as the fit compared the frames with wrong times. */
static bool say_times(const struct score *s, struct evidence *e)
{
    const struct times *times = &e->times;
    const struct score_fit *fit = &e->fit;
    struct score_diagnosis *d = e->d;
    const struct clock *pace = &times->pace;
    const bool slow = pace->speed < 1;
    char repeats[64] = "", gravity[64] = "";

    if (times->jump != 0) {
        say(d, times->jump > 0 ? SCORE_LOST_FRAME : SCORE_DOUBLED_FRAME, times->from,
            "From %.4g s on it %s %s by %.3g ms more than before: %s there?", times->from,
            times->jump > 0 ? "is ahead of" : "lags behind",
            times->own ? "its own way" : "the truth", 1e3 * fabs(times->jump),
            times->jump > 0 ? "is a frame missing" : "does a frame stand twice");
        return true;
    }
    if (s->repeats)
        snprintf(repeats, sizeof repeats, " (%d are as the one before)", s->repeats);
    if (!s->truth->ladder.times) /* no fit distinguishes them */
        snprintf(gravity, sizeof gravity, ", or is gravity %.3g times the scene's",
                 pace->speed * pace->speed);
    if (is_clock(s, pace, fit) && !(PACE_BETTER * share(&times->lag) < share(pace))) {
        say(d, SCORE_TIME, pace->speed,
            "Runs %.2f times as %s as the truth: at t frames show what happens at %.4g t, "
            "and fit to %.2g %% in place of %.2g %%; do frames stand twice%s, are some "
            "left out, or is the time from one to the next another%s?",
            slow ? 1 / pace->speed : pace->speed, slow ? "slow" : "fast", pace->speed,
            100 * pace->error, 100 * pace->as_is, repeats, gravity);
        return true;
    }
    if (!is_clock(s, &times->lag, fit))
        return false;
    say_lead(s, times->lag.shift, (double[3]){0}, d);
    return true;
}

/* Reports another gravity, which in a free fall looks like another pace, elsewhere
 * hardly. */
static void say_gravity(const struct score *s, double g, const struct clock *pace,
                        const struct score_fit *fit, struct score_diagnosis *d)
{
    const double speed = s->truth->known.closed ? sqrt(fmax(g, 0))
                         : share(pace) < PACE_BETTER * fit->left && fit->count == 1
                             ? pace->speed
                             : 1;
    char other[64] = "";

    if (speed > 0 && speed != 1)
        snprintf(other, sizeof other, ", or does it run %.3g times as %s",
                 speed < 1 ? 1 / speed : speed, speed < 1 ? "slow" : "fast");
    say(d, SCORE_GRAVITY, g, "Moves as under gravity x %.3f: is g the scene's%s?", g,
        other);
}

static bool say_support(const struct score *s, struct evidence *e)
{
    const struct held_off *off = &e->support;
    const struct scene *scene = &s->truth->scene;
    const double *by = off->by;
    char what[192] = "Begins off the scene's rest shape, as a whole";

    if (!off->steady && !(off->most > 0))
        return false;
    if (scene->support_count) {
        const struct scene_support *held = &scene->supports[off->which];
        snprintf(
            what, sizeof what,
            "Is not held where the scene holds it: support %d (u %g to %g, v %g to %g) is "
            "%.2g %% off at %g s",
            off->which, held->lo[0], held->hi[0], held->lo[1], held->hi[1], 100 * off->most,
            off->time);
    }
    say(e->d, SCORE_SUPPORT, off->most, "%s, by (%.3g, %.3g, %.3g) m%s", what, by[0], by[1],
        by[2],
        off->steady ? ", and at all other times: is the sheet's pose the scene's?"
                    : "; are its vertices fixed, or moved by its path?");
    return true;
}

/* A shift at all times is told before what was fitted beside it. */
static bool say_shift(const struct score *s, struct evidence *e)
{
    return e->support.steady && say_support(s, e);
}

/* Fits the flaws to the frames as they are, or moved back where what is held is off by the
 * same at all times. A sheet that nothing holds may begin off because its frames are ahead:
 * there the fit that leaves less is taken. */
static bool measure(const struct score *s, struct evidence *e)
{
    struct held_off *off = &e->support;
    struct score_fit back;

    *off = find_support(s);
    e->times = find_times(s);
    score_fit_make(s, (double[3]){0}, &e->fit);
    if (!off->steady)
        return false;
    score_fit_make(s, off->shift, &back);
    off->steady = s->truth->scene.support_count || back.rest < e->fit.rest;
    if (off->steady)
        e->fit = back;
    else
        memset(off->shift, 0, sizeof off->shift);
    return false;
}

/* Returns whether all errors are within those of sound frames. */
static bool is_sound(const struct score *s)
{
    const double most = sound_most(s);

    for (const struct score_time *row = s->row; row < s->row + s->times; row++)
        if (!(row->error <= most + TIMES_FLOOR * (row->bar + fmax(row->floor, 0))))
            return false;
    return true;
}

/* Reports the fitted flaws. Of a lead that stands alone, and is no first-order step's, the
 * frames' own is told: what their net costs grows along the way, and the fit over all of it
 * takes a part of it for time. */
static bool say_fit(const struct score *s, struct evidence *e)
{
    const struct score_fit *fit = &e->fit;
    struct score_diagnosis *d = e->d;
    const double *value = fit->value, own = e->times.lag.shift;
    const bool alone = fit->count == 1 && own * value[FIT_LEAD] > 0,
               step = value[FIT_LEAD] > 0 && value[FIT_LEAD] < HALF_STEP * s->interval;

    if (is_sound(s) && !d->count && fit->left > MUCH_BETTER)
        return false;

    if (fit->has[FIT_LEAD])
        say_lead(s, alone && !step ? own : value[FIT_LEAD], e->support.shift, d);
    if (fit->has[FIT_GRAVITY])
        say_gravity(s, 1 + value[FIT_GRAVITY], &e->times.pace, fit, d);
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
            "angle between elements, that over the held row stands for half a cell and "
            "needs twice the stiffness of the others.",
            100 * value[FIT_HINGE]);
    else if (fit->has[FIT_HINGE])
        say(d, SCORE_HINGE, value[FIT_HINGE],
            "The edge is held as a hinge, not a clamp (%.0f %% of the way to a hinge%s): "
            "where bending is an angle between elements, a second row outside the sheet "
            "must be held.",
            100 * value[FIT_HINGE],
            value[FIT_HINGE] > NO_BENDING ? ": hardly anything resists bending" : "");
    if (fit->has[FIT_BENDING])
        say(d, SCORE_BENDING, value[FIT_BENDING],
            "Bends like D x %.2f%s (D = E h^3 / 12 (1 - nu^2)).", value[FIT_BENDING],
            fit->at_end ? ", or beyond: the ladder of truths ends there" : "");
    d->left = fit->left < 1 ? fit->left : 0;
    return fit->count > 0;
}

static bool say_sound(const struct score *s, struct evidence *e)
{
    const struct score_time *worst = s->row;

    if (!is_sound(s))
        return false;
    for (const struct score_time *row = s->row; row < s->row + s->times; row++)
        worst = row->error > worst->error ? row : worst;
    if (worst->floor > worst->bar && worst->error < TIMES_FLOOR * worst->floor)
        say(e->d, SCORE_FLOOR, worst->floor,
            "Is at its net's floor: the truth itself between these vertices is off by "
            "%.2g %% at %g s, which explains the error; only a finer net can do better.",
            100 * worst->floor, worst->time);
    if (worst->bar > SOUND_MOST && worst->error > SOUND_MOST)
        say(e->d, SCORE_SOUND, worst->error,
            "Nothing can be said against it: at most %.2g %% off, where the truth itself "
            "has an error bar of up to %.2g %%.",
            100 * worst->error, 100 * worst->bar);
    else if (isnan(worst->floor))
        say(e->d, SCORE_SOUND, worst->error,
            "Nothing wrong was found: at most %.2g %% off.", 100 * worst->error);
    else
        say(e->d, SCORE_SOUND, worst->error,
            "Nothing wrong was found: at most %.2g %% off, the net's floor there %.2g %%.",
            100 * worst->error, 100 * worst->floor);
    return true;
}

/* The table has what may be wrong with frames, the plain before the subtle: place (turned,
 * axes, units, order), time (a lost frame, another clock), then physics. Each is told by
 * how much of the error it leaves, and displaces what was found before it where it leaves a
 * third of that. Frames are sound where their errors are those of good simulators, and a
 * flaw is then believed only if it leaves a quarter. */
static const struct {
    bool (*say)(const struct score *s, struct evidence *e); /* returns whether it holds */
    enum {
        ALONE,
        BESIDE,
        ELSE
    } how; /* nothing comes after it; if nothing came before it  */
} hypotheses[] = {{say_still, ALONE},     {say_turned, ALONE},   {say_strays, ALONE},
                  {say_scattered, ALONE}, {measure, BESIDE},     {say_times, ALONE},
                  {say_shift, BESIDE},    {say_stretch, BESIDE}, {say_fit, BESIDE},
                  {say_support, ELSE},    {say_sound, ELSE}};

void score_diagnosis_make(const struct score *s, struct score_diagnosis *d)
{
    struct evidence e = {d};
    bool told = !s->times;

    memset(d, 0, sizeof *d);
    for (size_t n = 0; n < sizeof hypotheses / sizeof *hypotheses && !told; n++)
        if (hypotheses[n].how != ELSE || !d->count)
            told = hypotheses[n].say(s, &e) && hypotheses[n].how == ALONE;
}
