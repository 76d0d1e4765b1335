#include "bench/score/score_pace.h"

#include <math.h>

#include "bench/score/score_turned.h"

/* Looked for in steps of one per cent, then between two of them. */
enum { STEPS = 210, HALVINGS = 20 };
#define STEP 1.01

/* One time alone would be met by many a speed. */
enum { TIMES_LEAST = 2 };

/* The truth at one of the few points at any time up to its last frame: the cubic through
 * four frames, the first at rest. */
static void truth_at(const struct score_truth *t, double time, double (*xyz)[3])
{
    const double *at = t->motion_time;
    int first = 0;

    while (first + 4 < t->motions && at[first + 2] < time)
        first++;
    for (int p = 0; p < SCORE_FEW; p++)
        xyz[p][0] = xyz[p][1] = xyz[p][2] = 0;
    for (int a = first; a < first + 4; a++) {
        double weight = 1;
        for (int b = first; b < first + 4; b++)
            weight *= a == b ? 1 : (time - at[b]) / (at[a] - at[b]);
        for (int p = 0; p < SCORE_FEW; p++)
            for (int c = 0; c < 3; c++)
                xyz[p][c] += weight * t->motion[a][p][c];
    }
}

/* rms of the frames off the truth at another speed and at its own, at the same times; both
 * stay NaN where these are too few. */
static struct score_pace compare(const struct score *s, double speed)
{
    const struct score_truth *t = &s->truth;
    struct score_pace pace = {speed, NAN, NAN};
    double sum[2] = {0, 0}, there[SCORE_FEW][3];
    int times = 0;

    for (int n = 0; n < t->times; n++) {
        const double *got = s->field + 3L * SCORE_POINTS * n,
                     *truth = score_truth_field(t, n);
        const double time = speed * t->time[n];
        if (!s->row[n].known || time > t->motion_time[t->motions - 1])
            continue;
        times++;
        truth_at(t, time, there);
        for (int p = 0; p < SCORE_FEW; p++)
            for (int c = 0; c < 3; c++) {
                const int at = 3 * score_truth_few(p) + c;
                sum[0] += (got[at] - there[p][c]) * (got[at] - there[p][c]);
                sum[1] += (got[at] - truth[at]) * (got[at] - truth[at]);
            }
    }
    if (times < TIMES_LEAST)
        return pace;
    pace.error = sqrt(sum[0] / (times * SCORE_FEW)) / t->scene.length;
    pace.as_is = sqrt(sum[1] / (times * SCORE_FEW)) / t->scene.length;
    return pace;
}

static double share(const struct score_pace *p)
{
    return p->as_is > 0 ? p->error / p->as_is : 1;
}

struct score_pace score_pace_best(const struct score *s)
{
    struct score_pace best = {1, 0, 0};
    double step = STEP;

    if (s->truth.motions < 4)
        return best;
    for (int n = -STEPS; n <= STEPS; n++) {
        const struct score_pace p = compare(s, pow(STEP, n));
        best = share(&p) < share(&best) ? p : best;
    }
    for (int n = 0; n < HALVINGS; n++, step = sqrt(step)) {
        const struct score_pace less = compare(s, best.speed / step),
                                more = compare(s, best.speed * step);
        best = share(&less) < share(&best) ? less : best;
        best = share(&more) < share(&best) ? more : best;
    }
    return score_turned_is_better(best.error, best.as_is)
               ? best
               : (struct score_pace){1, best.as_is, best.as_is};
}
