#include "bench/score/score_turned.h"

#include <math.h>

/* Something else is better where it leaves less than this share of the error, which is more
 * than this share of the length. */
#define MUCH_BETTER 0.25
#define WORTH_IT    0.02

/* Of two that fit as well, the one that changes less. */
#define CHANGE_COSTS 0.02

static const double scales[] = {1, 1e-3, 1e-2, 1e3, 1e2, 0.0254, 0.3048};
enum {
    SCALES = sizeof scales / sizeof *scales,
    LAST = GRID_U - 1,
};
enum { PERMUTATIONS = 6, SIGNS = 8, ORDERS = 8 };
static const int permutation[PERMUTATIONS][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                                 {2, 1, 0}, {1, 2, 0}, {2, 0, 1}};

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

/* Squared error of all known times; ends early where it is no better than `least`. */
static double squared(const struct score *s, const struct score_turned *t, double least,
                      int *points)
{
    double sum = 0;

    *points = 0;
    for (int n = 0; n < s->truth.times; n++) {
        const double *truth = score_truth_field(&s->truth, n),
                     *got = s->field + 3L * SCORE_POINTS * n;
        if (!s->row[n].known)
            continue;
        for (int k = 0; k < SCORE_FEW; k++) {
            const int p = score_truth_few(k);
            const double *x = got + 3 * moved(p, t->order);
            for (int c = 0; c < 3; c++) {
                const double d = t->sign[c] * t->scale * x[t->axis[c]] - truth[3 * p + c];
                sum += d * d;
            }
        }
        *points += SCORE_FEW;
        if (sum > least)
            return INFINITY;
    }
    return sum;
}

static int changes(const struct score_turned *t)
{
    int count = (t->scale != 1) + (t->order != 0);

    for (int c = 0; c < 3; c++)
        count += (t->axis[c] != c) + (t->sign[c] < 0);
    return count;
}

static struct score_turned candidate(int n)
{
    struct score_turned t = {.order = n % ORDERS};
    const int signs = n / ORDERS % SIGNS,
              *axis = permutation[n / (ORDERS * SIGNS) % PERMUTATIONS];

    for (int c = 0; c < 3; c++) {
        t.axis[c] = axis[c];
        t.sign[c] = signs >> c & 1 ? -1 : 1;
    }
    t.scale = scales[n / (ORDERS * SIGNS * PERMUTATIONS)];
    return t;
}

double score_turned_nearest(const struct score *s, int n)
{
    const double *truth = score_truth_field(&s->truth, n),
                 *got = s->field + 3L * SCORE_POINTS * n;
    double sum = 0;

    for (int k = 0; k < SCORE_FEW; k++) {
        const double *a = got + 3 * score_truth_few(k);
        double least = INFINITY;
        for (const double *b = truth; b < truth + 3 * SCORE_POINTS; b += 3) {
            const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
            least = fmin(least, x * x + y * y + z * z);
        }
        sum += least;
    }
    return sqrt(sum / SCORE_FEW) / s->truth.scene.length;
}

bool score_turned_is_better(double error, double as_is)
{
    return as_is > WORTH_IT && error < MUCH_BETTER * as_is;
}

struct score_turned score_turned_best(const struct score *s)
{
    const double length = s->truth.scene.length;
    struct score_turned as_is = candidate(0), best = as_is;
    int points;
    const double all = squared(s, &as_is, INFINITY, &points);
    double least = all;

    as_is.error = as_is.as_is = points ? sqrt(all / points) / length : 0;
    if (!points || as_is.error < WORTH_IT)
        return as_is;
    for (int n = 1; n < ORDERS * SIGNS * PERMUTATIONS * SCALES; n++) {
        struct score_turned t = candidate(n);
        const double more = 1 + CHANGE_COSTS * changes(&t);
        int counted;
        const double sum = squared(s, &t, least / (more * more), &counted);
        if (sum * more * more < least) {
            least = sum * more * more;
            t.error = sqrt(sum / points) / length;
            best = t;
        }
    }
    best.as_is = as_is.as_is;
    return changes(&best) && score_turned_is_better(best.error, as_is.error) ? best : as_is;
}
