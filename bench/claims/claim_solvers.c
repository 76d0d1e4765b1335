/* Claims on the solvers of the linear systems (plans direct and solvers). */
#include <math.h>

#include "bench/claims/claim.h"

enum { NETS = 4, METHODS = 8 };

/* Largest distance to the direct solver's frame, over the length: Newton's method leaves
 * 1e-7 in each frame, and the motion lets it grow. */
static const double SAME = 1e-5;

/* Judges whether the cheapest iterative solver is cheaper than the direct one on every net.
 */
static enum verdict iterations_pay(const struct study_results *d, const char *study,
                                   FILE *because)
{
    const char *net[NETS], *solver[METHODS];
    const int nets = results_labels(d, "net", NETS, net);
    const int solvers = results_labels(d, "solver", METHODS, solver);
    enum verdict turn = nets ? VERDICT_HOLDS : VERDICT_OPEN;

    for (int n = 0; n < nets; n++) {
        double best = NAN;
        const char *name = "none";
        for (int m = 0; m < solvers; m++) {
            const double ratio =
                results_at(d, QUANTITY_OF_REFERENCE,
                           WHERE({"study", study}, {"net", net[n]}, {"solver", solver[m]}));
            if (solver[m][0] != 'd' && (ratio < best || isnan(best)))
                best = ratio, name = isnan(ratio) ? name : solver[m];
        }
        turn = judge_both(turn, judge_below(best, 1));
        fprintf(because, "%s%s: the best, %s, takes %.3g of the direct solver's time",
                n ? "; " : "", net[n], name, best);
    }
    fputs(".", because);
    return turn;
}

CLAIM_JUDGE(printed_iterations_pay, iterations_pay(d, "printed", because))
CLAIM_JUDGE(nonlinear_iterations_pay, iterations_pay(d, "nonlinear", because))

static enum verdict keeping_pays(const struct study_results *d, FILE *because)
{
    const double least = results_least(d, QUANTITY_OF_REFERENCE,
                                       WHERE({"solver", "direct, every tangent new"}));

    fprintf(because, "New ones in each iteration take at least %.3g of the time.", least);
    return judge_below(1, least);
}

/* Growth up to 20x20x2: beyond, a factor runs near the processor's peak. Elements, and with
 * them K and M, grow faster than unknowns (less so in lanes, which small nets leave empty),
 * so little of the aim is left for the rest: solving with an earlier factor reads
 * unknowns^1.5 numbers, and takes more iterations on larger nets; a new factor costs
 * unknowns^1.9. */
static enum verdict growth_is_small(const struct study_results *d, FILE *because)
{
    static const double AIM = 1.25;
    static const char *const solvers[] = {"direct", "CG, last factor"};
    double growth[2];

    for (int n = 0; n < 2; n++)
        growth[n] = results_exponent(
            d, QUANTITY_UNKNOWNS, QUANTITY_FRAME,
            WHERE({"study", "printed"}, {"solver", solvers[n]}, {"net", "!40x40x2"}));
    fprintf(
        because,
        "Up to 20x20x2 a frame grows as unknowns^%.3g with the direct solver, as ^%.3g by "
        "conjugate gradients with the last factor.",
        growth[0], growth[1]);
    return judge_below(growth[1], AIM);
}

static enum verdict motion_is_one(const struct study_results *d, FILE *because)
{
    const double most = results_most(d, QUANTITY_APART, WHERE({NULL, NULL}));

    fprintf(because, "They differ from the direct one by %.2g L at most (%.2g L allowed).",
            most, SAME);
    return judge_below(most, SAME);
}

const struct claim claim_solvers[] = {
    {"Printed kinematics: an iterative solver pays on every net", "", false,
     printed_iterations_pay, .timed = true},
    {"Nonlinear kinematics: an iterative solver pays on every net", "", false,
     nonlinear_iterations_pay, .timed = true},
    {"Keeping tangents of Newton's method pays on every net", "", false, keeping_pays,
     .timed = true},
    {"The last factor keeps the growth of a rebuilt frame below 1.25", "", true,
     growth_is_small, .timed = true},
    {"All solvers give the same motion", "", false, motion_is_one},
    {0}};

/* --- direct ------------------------------------------------------------------------------
 */

/* A direct solver suffices if no iterative one that the paper names takes less than half of
 * its time on a net of the paper: the factor that other ratios of time have, too. */
static const double SUFFICES = 0.5;

/* Returns the least time on a net over the direct solver's, of solvers whose label begins
 * with a word; writes them. */
static enum verdict best_of(const struct study_results *d, const char *net, FILE *because)
{
    const char *solver[METHODS], *name = "none";
    const int solvers = results_labels(d, "solver", METHODS, solver);
    double best = NAN;

    for (int m = 0; m < solvers; m++) {
        const double ratio = results_at(d, QUANTITY_OF_REFERENCE,
                                        WHERE({"net", net}, {"solver", solver[m]}));
        if ((solver[m][0] == 'C' || solver[m][0] == 'G') && !isnan(ratio) &&
            !(ratio >= best))
            best = ratio, name = solver[m];
    }
    fprintf(because, "%s: %s takes %.3g of the direct solver's time, ours %.3g", net, name,
            best,
            results_at(d, QUANTITY_OF_REFERENCE,
                       WHERE({"net", net}, {"solver", "ours: CG, last factor"})));
    return judge_below(SUFFICES, best);
}

static enum verdict direct_suffices(const struct study_results *d, FILE *because)
{
    const char *net[NETS];
    const int nets = results_labels(d, "net", NETS, net);
    enum verdict turn = nets ? VERDICT_HOLDS : VERDICT_OPEN;

    fputs("The best of those that it names, ", because);
    for (int n = 0; n < nets; n++) {
        fputs(n ? "; " : "", because);
        turn = judge_both(turn, best_of(d, net[n], because));
    }
    fputs(".", because);
    return turn;
}

const struct claim claim_direct[] = {
    {"few unknowns, symmetric and positive definite: a direct solver suffices", "3.3",
     false, direct_suffices, .timed = true},
    {0}};
