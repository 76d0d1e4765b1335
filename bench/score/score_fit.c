#include "bench/score/score_fit.h"

#include <math.h>
#include <stdlib.h>
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
    double noise;                  /* the same of what is not known, squared              */
    double shift[3]; /* of the frames [m]                                    */
    bool ladder;
};

/* One point at one time; each component is a row of the least squares. */
struct point {
    double column[COLUMNS][3];
};

static void add_point(struct sums *s, const struct point *p, double weight)
{
    for (int c = 0; c < 3; c++)
        for (int a = 0; a < COLUMNS; a++)
            for (int b = 0; b < COLUMNS; b++)
                s->gram[a][b] += weight * weight * p->column[a][c] * p->column[b][c];
}

static void add_noise(struct sums *s, int points, double weight, double noise)
{
    s->noise += points * weight * weight * noise * noise;
}

/* --- on the ladder ----------------------------------------------------------------------
 */

/* Fills the columns with the fields of one time, and Y with the base itself. */
static void fields_at(const struct score *s, int time, const double *rest,
                      double (*field)[3 * LADDER_POINTS])
{
    const struct score_ladder *l = &s->ladder;
    static const int flaws[LADDER_FLAWS] = {DAMPING, GRAVITY, STRETCH, HINGE};
    const int last = time + 1 < l->times ? time + 1 : time;
    const double *before = time ? score_ladder_rung(l, LADDER_BASE, time - 1) : rest,
                 *after = score_ladder_rung(l, LADDER_BASE, last);
    const double step = l->time[0], span = last == time ? step : 2 * step;
    double rate[3 * LADDER_POINTS];

    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        rate[n] = (after[n] - before[n]) / span;
    if (last == time) /* the end: half a step before it, and on by the acceleration */
        for (int n = 0; n < 3 * LADDER_POINTS; n++)
            rate[n] += .5 *
                       (after[n] - 2 * before[n] +
                        score_ladder_rung(l, LADDER_BASE, time - 2)[n]) /
                       step;
    score_seen(s, &s->coarse, score_ladder_rung(l, LADDER_BASE, time), field[Y]);
    score_seen(s, &s->coarse, rate, field[LEAD]);
    for (int f = 0; f < LADDER_FLAWS; f++)
        score_seen(s, &s->coarse, score_ladder_flaw(l, f, time), field[flaws[f]]);
    for (int r = 0; r < LADDER_RUNGS; r++)
        score_seen(s, &s->coarse, score_ladder_rung(l, r, time), field[RUNG + r]);
}

static void add_time(const struct score *s, int time, const double *rest,
                     double (*field)[3 * LADDER_POINTS], struct sums *sums)
{
    const struct score_ladder *l = &s->ladder;
    const double *base = field[Y], *got = s->coarse_field + 3L * LADDER_POINTS * time,
                 *truth = score_ladder_rung(l, LADDER_BASE, time),
                 length = s->truth.scene.length;
    const double size[LADDER_FLAWS] = {l->size[LADDER_DAMPING], l->size[LADDER_GRAVITY] - 1,
                                       1, 1};
    const double weight = 1 / (score_rms(LADDER_POINTS, truth, rest) + SMALL * length);

    for (int p = 0; p < LADDER_POINTS; p++) {
        struct point point = {{{0}}};
        const int edge = p / LADDER_U * LADDER_U;
        for (int c = 0; c < 3; c++) {
            const int n = 3 * p + c;
            double(*column)[3] = point.column;
            column[Y][c] = got[n] - sums->shift[c] - base[n];
            column[LEAD][c] = field[LEAD][n];
            column[DAMPING][c] = (field[DAMPING][n] - base[n]) / size[LADDER_DAMPING];
            column[GRAVITY][c] = (field[GRAVITY][n] - base[n]) / size[LADDER_GRAVITY];
            column[STRETCH][c] = field[STRETCH][n] - base[n];
            column[HINGE][c] = field[HINGE][n] - base[n];
            column[SCALE][c] = base[n] - base[3 * edge + c];
            for (int r = 0; r < LADDER_RUNGS; r++)
                column[RUNG + r][c] = field[RUNG + r][n] - base[n];
        }
        add_point(sums, &point, weight);
    }
    add_noise(sums, LADDER_POINTS, weight,
              (l->bar[LADDER_BASE * l->times + time] + ROUNDING) * length +
                  score_rms(LADDER_POINTS, base, truth));
}

static enum status sum_ladder(const struct score *s, struct sums *sums)
{
    double rest[3 * LADDER_POINTS];
    double(*field)[3 * LADDER_POINTS] = malloc(COLUMNS * sizeof *field);

    if (!field)
        return STATUS_MEMORY;
    score_coarse_rest(s, rest);
    sums->ladder = true;
    for (int time = 0; time < s->ladder.times; time++)
        if (s->coarse_tells[time]) {
            fields_at(s, time, rest, field);
            add_time(s, time, rest, field, sums);
        }
    free(field);
    return STATUS_OK;
}

/* --- in free fall -----------------------------------------------------------------------
 */

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

static void sum_fall(const struct score *s, struct sums *sums)
{
    const double length = s->truth.scene.length;

    for (int time = 0; time < s->truth.times; time++) {
        const double *truth = score_truth_field(&s->truth, time), t = s->truth.time[time],
                     *got = s->field + 3L * SCORE_POINTS * time, *rest = s->truth.rest;
        const double weight = 1 / (score_rms(SCORE_POINTS, truth, rest) + SMALL * length);
        if (!s->row[time].known || t <= 0)
            continue;
        for (int p = 0; p < SCORE_FEW; p++) {
            const int at = 3 * score_truth_few(p);
            struct point point = {{{0}}};
            for (int c = 0; c < 3; c++) {
                const double fall = truth[at + c] - rest[at + c];
                point.column[Y][c] = got[at + c] - sums->shift[c] - truth[at + c];
                point.column[LEAD][c] = 2 * fall / t;
                point.column[GRAVITY][c] = fall;
                point.column[DAMPING][c] = -fall * t / 3;
                point.column[SCALE][c] =
                    rest[at + c] - .5 * (rest[c] + rest[3 * (SCORE_POINTS - 1) + c]);
            }
            add_point(sums, &point, weight);
        }
        add_noise(sums, SCORE_FEW, weight,
                  s->truth.bar[time] + ROUNDING * length + s->row[time].floor * length);
    }
}

/* --- least squares ----------------------------------------------------------------------
 */

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

/* Fits a set of flaws with given bending, rung[]. */
static struct trial try_set(const struct sums *s, unsigned set,
                            const double rung[LADDER_RUNGS])
{
    int column[COLUMNS], kind[COLUMNS], count = 0;
    double a[COLUMNS][COLUMNS], b[COLUMNS], right[COLUMNS];
    struct trial t = {.left = s->gram[Y][Y]};

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
    struct trial best = {.left = INFINITY};
    const bool bends = set >> FIT_BENDING & 1;

    for (int n = 0; n < (bends ? TRIES : 1); n++) {
        const double x = bends ? n / (TRIES - 1.) : .5;
        double rung[LADDER_RUNGS] = {0};
        const int first = score_net_cubic(LADDER_RUNGS, x, rung);
        double four[4];
        memcpy(four, rung, sizeof four);
        memset(rung, 0, sizeof rung);
        for (int k = 0; k < 4 && bends; k++)
            rung[first + k] = four[k];
        struct trial t = try_set(s, set, rung);
        t.stiffness = x;
        if (t.left < best.left)
            best = t;
    }
    best.left = fmax(best.left, 0);
    return best;
}

static int size_of(unsigned set)
{
    int size = 0;

    for (; set; set &= set - 1)
        size++;
    return size;
}

/* Whether each flaw is needed to leave little, and a fitted hinge has a plausible size. */
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
            if (size_of(set) != size)
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

enum status score_fit_make(const struct score *score, const double shift[3],
                           struct score_fit *fit)
{
    struct sums sums = {.shift = {shift[0], shift[1], shift[2]}};
    enum status st = STATUS_OK;

    memset(fit, 0, sizeof *fit);
    if (score->ladder.times > 2)
        TRY(sum_ladder(score, &sums));
    else if (falls_free(&score->truth.scene))
        sum_fall(score, &sums);
    const unsigned set = choose(&sums);
    const struct trial t = best_of(&sums, set);
    fit->count = size_of(set);
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
out:
    return st;
}
