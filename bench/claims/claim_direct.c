/* The claim on the solvers of the linear systems (plan direct). */
#include <math.h>

#include "bench/claims/claim.h"

enum { NETS = 4, METHODS = 8 };

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
