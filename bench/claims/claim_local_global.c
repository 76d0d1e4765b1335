/* Claims on projective dynamics' iterations (plan local-global). */
#include <math.h>

#include "bench/claims/claim.h"

/* Returns how far so many iterations are from the end of a frame of 5 ms, Euler's. */
static double left(const struct study_results *d, const char *study, const char *method,
                   const char *iterations)
{
    return results_at(d, QUANTITY_APART,
                      WHERE({"study", study}, {"time", "Euler"}, {"step", "5 ms"},
                            {"method", method}, {"iterations", iterations}));
}

/* Returns how far frames of 5 ms, iterated to their end, are from small steps. */
static double step_takes(const struct study_results *d, const char *study, const char *time)
{
    return results_apart(
        d, WHERE({"study", study}, {"time", time}, {"step", "5 ms"}, {"iterations", "end"}),
        WHERE({"study", study}, {"step", "small"}, {"iterations", "end"}));
}

/* Judges whether the first number is below the second in both scenes. */
static enum verdict in_both(const double value[2], const double bound[2], const char *words,
                            FILE *because)
{
    static const char *const scenes[] = {"edge_drop", "corners_patch"};
    enum verdict turn = VERDICT_HOLDS;

    for (int n = 0; n < 2; n++) {
        turn = judge_both(turn, judge_below(value[n], bound[n]));
        fprintf(because, "%s%s: %.2g L %s %.2g L", n ? "; " : "", scenes[n], value[n],
                words, bound[n]);
    }
    fputs(".", because);
    return turn;
}

/* Numbers of both scenes. */
#define BOTH(of, ...)                                                                      \
    (double[])                                                                             \
    {                                                                                      \
        of(d, "edge_drop", __VA_ARGS__), of(d, "corners_patch", __VA_ARGS__)               \
    }

CLAIM_JUDGE(iterations_limit,
            in_both(BOTH(step_takes, "Euler"), BOTH(left, "plain", "20"),
                    "is what Euler's step takes, 20 plain iterations leave", because))
CLAIM_JUDGE(chebyshev_pays,
            in_both(BOTH(left, "Chebyshev", "50"), BOTH(left, "plain", "50"),
                    "is what 50 iterations leave, without it", because))
CLAIM_JUDGE(admm_pays, in_both(BOTH(left, "ADMM", "20"), BOTH(left, "plain", "20"),
                               "is what 20 iterations leave, without it", because))
CLAIM_JUDGE(second_order_pays, in_both(BOTH(step_takes, "BDF2"), BOTH(step_takes, "Euler"),
                                       "is what BDF2's step takes, Euler's", because))

/* Returns the worse of what the step takes and how far the net is from truth: small steps,
 * iterated to their end. */
static double step_or_net(const struct study_results *d, const char *study,
                          const char *time)
{
    return fmax(
        step_takes(d, study, time),
        results_at(d, QUANTITY_ERROR,
                   WHERE({"study", study}, {"step", "small"}, {"iterations", "end"})));
}

CLAIM_JUDGE(twenty_do,
            in_both(BOTH(left, "ADMM", "20"), BOTH(step_or_net, "Euler"),
                    "is what they leave, the worse of step and net takes", because))

const struct claim claim_local_global[] = {
    {"Frames of 5 ms: iterations limit, not the step", "", false, iterations_limit},
    {"Frames of 5 ms: Chebyshev's acceleration (Wang 2015) pays", "", true, chebyshev_pays},
    {"Frames of 5 ms: ADMM's weighting pays", "", false, admm_pays},
    {"Frames of 5 ms: 20 iterations with ADMM's weighting are enough", "", false,
     twenty_do},
    {"Frames of 5 ms: second order in time pays", "", false, second_order_pays},
    {0}};
