#include "bench/score/score_fit.h"

#include <math.h>
#include <string.h>

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

/* Adds a time, of so many points, whose uncertainty is `noise` [m]. */
static void add_time(struct sums *s, int points, double weight, double noise)
{
    for (int n = 0; n < 3 * points; n++)
        for (int a = 0; a < COLUMNS; a++)
            for (int b = 0; b < COLUMNS; b++)
                s->gram[a][b] += weight * weight * s->column[a][n] * s->column[b][n];
    s->noise += points * weight * weight * noise * noise;
}

/* --- on the ladder --- */

/* Fills rate[LADDER_POINTS][3] with the velocity of the ladder's base [m/s]. */
static void find_rate(const struct score_ladder *l, int time, const double *rest,
                      double *rate)
{
    const int last = time + 1 < l->times ? time + 1 : time;
    const double *before = time ? score_ladder_rung(l, LADDER_BASE, time - 1) : rest,
                 *after = score_ladder_rung(l, LADDER_BASE, last);
    const double step = l->time[0], span = last == time ? step : 2 * step;

    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        rate[n] = (after[n] - before[n]) / span;
    if (last == time) /* the end: half a step before it, and on by the acceleration */
        for (int n = 0; n < 3 * LADDER_POINTS; n++)
            rate[n] += .5 *
                       (after[n] - 2 * before[n] +
                        score_ladder_rung(l, LADDER_BASE, time - 2)[n]) /
                       step;
}

/* Fills a column with the effect of something that turns the base into `field`. */
static void fill_effect(const struct score *s, const double *field, const double *base,
                        double size, double *column)
{
    score_seen(s, &s->coarse.map, field, column);
    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        column[n] = (column[n] - base[n]) / size;
}

static void add_ladder_time(const struct score *s, int time, const double *rest,
                            const double shift[3], struct sums *sums)
{
    static const int flaws[LADDER_FLAWS] = {DAMPING, GRAVITY, STRETCH, HINGE};
    const struct score_ladder *l = &s->ladder;
    const double size[LADDER_FLAWS] = {l->size[LADDER_DAMPING], l->size[LADDER_GRAVITY] - 1,
                                       1, 1};
    const double *truth = score_ladder_rung(l, LADDER_BASE, time),
                 *got = score_view_field(&s->coarse, time), length = s->truth.scene.length;
    double base[3 * LADDER_POINTS], rate[3 * LADDER_POINTS];

    score_seen(s, &s->coarse.map, truth, base);
    find_rate(l, time, rest, rate);
    score_seen(s, &s->coarse.map, rate, sums->column[LEAD]);
    for (int f = 0; f < LADDER_FLAWS; f++)
        fill_effect(s, score_ladder_flaw(l, f, time), base, size[f],
                    sums->column[flaws[f]]);
    for (int r = 0; r < LADDER_RUNGS; r++)
        fill_effect(s, score_ladder_rung(l, r, time), base, 1, sums->column[RUNG + r]);
    for (int n = 0; n < 3 * LADDER_POINTS; n++) {
        const int edge = n / (3 * LADDER_U) * 3 * LADDER_U + n % 3;
        sums->column[Y][n] = got[n] - shift[n % 3] - base[n];
        sums->column[SCALE][n] = base[n] - base[edge];
    }
    add_time(sums, LADDER_POINTS,
             1 / (score_rms(LADDER_POINTS, truth, rest) + SMALL * length),
             (l->bar[LADDER_BASE * l->times + time] + ROUNDING) * length +
                 score_rms(LADDER_POINTS, base, truth));
}

static void add_ladder(const struct score *s, const double shift[3], struct sums *sums)
{
    double rest[3 * LADDER_POINTS];

    score_coarse_rest(s, rest);
    sums->ladder = true;
    for (int time = 0; time < s->ladder.times; time++)
        if (s->coarse.tells[time])
            add_ladder_time(s, time, rest, shift, sums);
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
    return moves && !thrown && !scene->support_count && !scene->obstacle_count &&
           !scene->load_count && scene->drag == 0 && scene->damping.kind == DAMPING_NONE;
}

static void add_fall(const struct score *s, const double shift[3], struct sums *sums)
{
    const double length = s->truth.scene.length, *rest = s->truth.rest;

    for (const struct score_time *row = s->row; row < s->row + s->times; row++) {
        const double t = row->time;
        if (t <= 0)
            continue;
        for (int n = 0; n < 3 * SCORE_FEW; n++) {
            const int at = 3 * score_truth_few(n / 3) + n % 3;
            const double fall = row->truth[at] - rest[at];
            sums->column[Y][n] = row->got[at] - shift[n % 3] - row->truth[at];
            sums->column[LEAD][n] = 2 * fall / t;
            sums->column[GRAVITY][n] = fall;
            sums->column[DAMPING][n] = -fall * t / 3;
            sums->column[SCALE][n] =
                rest[at] - .5 * (rest[n % 3] + rest[3 * (SCORE_POINTS - 1) + n % 3]);
        }
        add_time(sums, SCORE_FEW,
                 1 / (score_rms(SCORE_POINTS, row->truth, rest) + SMALL * length),
                 row->bar * length + ROUNDING * length + row->floor * length);
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

void score_fit_make(const struct score *score, const double shift[3], struct score_fit *fit)
{
    struct sums sums = {.noise = 0};

    memset(fit, 0, sizeof *fit);
    if (score->ladder.times > 2)
        add_ladder(score, shift, &sums);
    else if (falls_free(&score->truth.scene))
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
        const double *scale = score->ladder.scale;
        fit->value[FIT_BENDING] =
            scale[0] * pow(scale[LADDER_RUNGS - 1] / scale[0], t.stiffness);
    }
    fit->rest = sqrt(t.left);
    fit->left = set ? sqrt(t.left / sums.gram[Y][Y]) : 1;
}
