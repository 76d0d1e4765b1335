#include "bench/studies/study_ensemble.h"

#include <math.h>

#include "bench/studies/distribution.h"
#include "bench/truth/truth_made.h"

enum { TRUTHS = STUDY_ENSEMBLE_TRUTHS, NUMBERS = STUDY_ENSEMBLE_NUMBERS };

int study_ensemble_horizon(const struct study_ensemble *e, int ensemble)
{
    for (int t = 0; t < e->fields; t++)
        if (e->one[ensemble].growth[t] >= TRUTH_MOST_GROWTH)
            return t;
    return -1;
}

/* Begins and ends of the windows: as many as have a look each. */
static void choose_windows(const struct study_ensemble *e, struct study_ensemble_verdict *v)
{
    int looks = 0;

    if (v->horizon < 0 || e->runs < 2)
        return;
    v->begin = e->field_time[v->horizon];
    v->end = e->time[e->looks - 1];
    for (int t = 0; t < e->looks; t++)
        looks += e->time[t] > v->begin;
    v->windows = looks < STUDY_ENSEMBLE_WINDOWS ? looks : STUDY_ENSEMBLE_WINDOWS;
}

int study_ensemble_window(const struct study_ensemble *e,
                          const struct study_ensemble_verdict *v, int ensemble, int number,
                          int window, double *mean)
{
    const struct study_ensemble_one *one = &e->one[ensemble];
    const double size = (v->end - v->begin) / v->windows;
    int looks = 0;

    for (int m = 0; m < one->lived; m++)
        mean[m] = 0;
    for (int t = 0; t < e->looks; t++) {
        /* a look at the end of a window is of it */
        if (ceil((e->time[t] - v->begin) / size - 1e-9) - 1 != window)
            continue;
        looks++;
        for (int m = 0; m < one->lived; m++)
            mean[m] += study_ensemble_values(e, one, number, t)[m];
    }
    for (int m = 0; m < one->lived; m++)
        mean[m] /= looks;
    return one->lived;
}

/* Of means, and of spreads about the median. */
struct sample {
    int count;
    double value[DISTRIBUTION_RUNS], deviation[DISTRIBUTION_RUNS];
};

static void take(const struct study_ensemble *e, const struct study_ensemble_verdict *v,
                 int ensemble, int number, int window, struct sample *s)
{
    s->count = study_ensemble_window(e, v, ensemble, number, window, s->value);
    distribution_deviations(s->count, s->value, s->deviation);
}

static double mean_of(int n, const double *value)
{
    return distribution_of(n, value).mean;
}

/* What the truth's nets say of a number differs: that far it is not known. */
static struct study_ensemble_apart compare(const struct sample *coarse,
                                           const struct sample *fine,
                                           const struct sample *own, double bound)
{
    struct study_ensemble_apart a;
    double bar = 0, spread_bar = 0;

    a.net_mean =
        distribution_apart(coarse->count, coarse->value, fine->count, fine->value, 0);
    a.net_spread = distribution_apart(coarse->count, coarse->deviation, fine->count,
                                      fine->deviation, 0);
    a.known = judge_both(judge_below(fabs(a.net_mean), bound),
                         judge_below(fabs(a.net_spread), bound));
    if (a.known != JUDGE_HOLDS) {
        bar = mean_of(coarse->count, coarse->value) - mean_of(fine->count, fine->value);
        spread_bar = mean_of(coarse->count, coarse->deviation) -
                     mean_of(fine->count, fine->deviation);
    }
    a.mean = distribution_apart(own->count, own->value, fine->count, fine->value, bar);
    a.spread = distribution_apart(own->count, own->deviation, fine->count, fine->deviation,
                                  spread_bar);
    a.turn =
        judge_both(judge_below(fabs(a.mean), bound), judge_below(fabs(a.spread), bound));
    /* Near a truth that is not known is not right yet. */
    if (a.turn == JUDGE_HOLDS && a.known != JUDGE_HOLDS)
        a.turn = JUDGE_OPEN;
    return a;
}

/* A contestant is right if all is; a run that died is of no distribution of the truth's. A
 * number that the model does not have is not held against it. */
static enum judge judge_one(const struct study_ensemble *e,
                            const struct study_ensemble_verdict *v, int ensemble)
{
    enum judge turn = v->windows ? JUDGE_HOLDS : JUDGE_OPEN;

    if (e->one[ensemble].died)
        return v->windows ? JUDGE_FAILS : JUDGE_OPEN;
    for (int n = 0; n < NUMBERS; n++)
        for (int w = 0; w < v->windows; w++) {
            const struct study_ensemble_apart *a = &v->apart[ensemble][n][w];
            if (!isnan(a->mean))
                turn = judge_both(turn, a->turn);
        }
    return turn;
}

void study_ensemble_judge(const struct study_ensemble *e, struct study_ensemble_verdict *v)
{
    const int coarse = study_ensemble_horizon(e, STUDY_ENSEMBLE_COARSE),
              fine = study_ensemble_horizon(e, STUDY_ENSEMBLE_FINE);
    const bool whole =
        !e->one[STUDY_ENSEMBLE_COARSE].died && !e->one[STUDY_ENSEMBLE_FINE].died;
    struct sample truth[TRUTHS], own;

    *v = (struct study_ensemble_verdict){.horizon = -1};
    v->doubted = (coarse < 0) != (fine < 0);
    if (coarse >= 0 && fine >= 0 && whole)
        v->horizon = coarse > fine ? coarse : fine;
    choose_windows(e, v);
    v->bound = distribution_bound(2 * NUMBERS * (v->windows ? v->windows : 1), e->runs);
    for (int n = 0; n < NUMBERS; n++)
        for (int w = 0; w < v->windows; w++) {
            for (int k = 0; k < TRUTHS; k++)
                take(e, v, k, n, w, &truth[k]);
            for (int k = TRUTHS; k < e->count; k++) {
                take(e, v, k, n, w, &own);
                v->apart[k][n][w] = compare(&truth[STUDY_ENSEMBLE_COARSE],
                                            &truth[STUDY_ENSEMBLE_FINE], &own, v->bound);
            }
        }
    for (int k = TRUTHS; k < e->count; k++)
        v->turn[k] = e->quick ? JUDGE_QUICK : judge_one(e, v, k);
}

double study_ensemble_worst(const struct study_ensemble_verdict *v, int ensemble,
                            int number, int end, bool spread)
{
    double worst = NAN;

    for (; number < end; number++)
        for (int w = 0; w < v->windows; w++) {
            const struct study_ensemble_apart *a = &v->apart[ensemble][number][w];
            const double z = spread ? a->spread : a->mean;
            if (!isnan(z) && !(fabs(z) <= fabs(worst)))
                worst = z;
        }
    return worst;
}
