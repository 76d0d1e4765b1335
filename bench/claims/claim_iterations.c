/* Claims on the number of iterations (plan iterations). */

#include "bench/claims/claim.h"

/* Material many times softer than the scene's, and like it. */
static const double SOFT = 0.25, ALIKE = 0.9;

/* Returns how stiff a hanging strip seems in steps of a frame, over what it seems after 64
 * iterations. */
static double softened(const struct study_results *d, const char *contestant,
                       const char *iterations)
{
    return results_ratio(d, QUANTITY_STIFFNESS,
                         WHERE({"study", "hanging"}, {"contestant", contestant},
                               {"substeps", "1"}, {"iterations", iterations}),
                         WHERE({"study", "hanging"}, {"contestant", contestant},
                               {"substeps", "1"}, {"iterations", "64"}));
}

static enum verdict few_soften(const struct study_results *d, FILE *because)
{
    const double vbd = softened(d, "VBD", "4"), xpbd = softened(d, "XPBD", "4");

    fprintf(because, "VBD %.2g and XPBD %.2g of the stiffness after 64.", vbd, xpbd);
    return judge_both(judge_below(vbd, SOFT), judge_below(xpbd, SOFT));
}

static enum verdict projective_does_not(const struct study_results *d, FILE *because)
{
    const double kept = softened(d, "PD", "4");

    fprintf(because, "%.2g of the stiffness after 64.", kept);
    return judge_below(ALIKE, kept);
}

static double error(const struct study_results *d, const char *contestant,
                    const char *substeps, const char *iterations)
{
    return results_at(d, QUANTITY_ERROR,
                      WHERE({"study", "edge_drop"}, {"contestant", contestant},
                            {"net", "11x11"}, {"substeps", substeps},
                            {"iterations", iterations}));
}

static enum verdict substeps_pay(const struct study_results *d, FILE *because)
{
    static const char *const all[] = {"VBD", "XPBD", "PD", "ADMM"};
    enum verdict turn = VERDICT_HOLDS;

    for (int n = 0; n < 4; n++) {
        const double steps = error(d, all[n], "16", "4"), one = error(d, all[n], "1", "64");
        turn = judge_both(turn, judge_below(steps, one));
        fprintf(because, "%s%s: %.2g L, %.2g L in one step", n ? "; " : "", all[n], steps,
                one);
    }
    fputs(".", because);
    return turn;
}

static enum verdict energy_is_won(const struct study_results *d, FILE *because)
{
    const double most =
        results_all_most(d, QUANTITY_LOSS,
                         WHERE({"study", "edge_drop"}, {"contestant", "!CG"},
                               {"net", "21x21"}, {"substeps", "1"}, {"iterations", "4"}));

    fprintf(because, "They lose at most %.2g of it a second.", most);
    return judge_below(most, 0);
}

const struct claim claim_iterations[] = {
    {"Frames of 5 ms: after 4 iterations VBD and XPBD are a material of less than a "
     "quarter "
     "of the stiffness",
     "", false, few_soften},
    {"Frames of 5 ms: projective dynamics is not", "", false, projective_does_not},
    {"16 substeps of 4 iterations are nearer to the truth than 64 iterations in one step",
     "", false, substeps_pay},
    {"Frames of 5 ms: 4 iterations win energy where none should be lost", "", true,
     energy_is_won},
    {0}};
