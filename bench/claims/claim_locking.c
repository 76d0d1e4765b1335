/* Claims on spaces that lock (plan locking). */
#include <math.h>

#include "bench/claims/claim.h"

/* Share of Kirchhoff's tip that a plate has in the thin limit if its strain cannot vary
 * through the thickness (r = 1), at nu = 0.3: bench/plans/locking.yaml. */
#define ONE_LAYER 0.8457

/* Share of a cured plate: more than halfway from there to all of it. */
static const double CURED = (1 + ONE_LAYER) / 2;

enum { MOST = 16 }; /* thicknesses */

static double tip(const struct study_results *d, const char *space, const char *poisson,
                  const char *thickness)
{
    return results_at(
        d, QUANTITY_TIP,
        WHERE({"space", space}, {"poisson", poisson}, {"thickness", thickness}));
}

/* Returns the tip at nu = 0.3 over that at nu = 0, where only shear locks, at 1 mm. */
static double through(const struct study_results *d, const char *space)
{
    return results_at(d, QUANTITY_TIP_OF_REFERENCE,
                      WHERE({"space", space}, {"poisson", "0.3"}, {"thickness", "1 mm"}));
}

static enum verdict degree_through(const struct study_results *d, FILE *because)
{
    const double more = tip(d, "IGA (3,3,2) 10x10x3", "0.3", "1 mm") /
                            tip(d, "IGA (3,3,1) 10x10x2", "0.3", "1 mm") -
                        1;

    fprintf(because,
            "From r = 1 to r = 2 the tip at h = 1 mm falls %.1f %% farther (degree 3; "
            "little: below 5 %%).",
            100 * more);
    return judge_below(fabs(more), 0.05);
}

static enum verdict thinner_locks(const struct study_results *d, FILE *because)
{
    static const char *const space = "IGA (2,2,1) 10x10x2";
    const char *thickness[MOST];
    const int count = results_labels(d, "thickness", MOST, thickness);
    double tips[MOST];

    fputs("At nu = 0 it has", because);
    for (int n = 0; n < count; n++) {
        tips[n] = tip(d, space, "0", thickness[n]);
        fprintf(because, "%s %.3f at %s", n ? "," : "", tips[n], thickness[n]);
    }
    fprintf(because,
            " of the tip; at 1 mm twice the points have %.3f, degree 3 %.3f, the paper's "
            "hexahedra %.4f.",
            tip(d, "IGA (2,2,1) 20x20x2", "0", "1 mm"),
            tip(d, "IGA (3,3,1) 10x10x2", "0", "1 mm"), tip(d, "hex 32x32x2", "0", "1 mm"));
    return judge_order(count, tips, 1, 0);
}

static enum verdict degree_in_plane(const struct study_results *d, FILE *because)
{
    fprintf(because,
            "At h = 1 mm the tip at nu = 0.3 over that at nu = 0 is %.3f for degree "
            "(3,3,1), %.3f for (4,4,1); theory has %.3f for one layer.",
            through(d, "IGA (3,3,1) 10x10x2"), through(d, "IGA (4,4,1) 10x10x2"),
            ONE_LAYER);
    return judge_below(through(d, "IGA (4,4,1) 10x10x2"), CURED);
}

static enum verdict thickness_cured(const struct study_results *d, FILE *because)
{
    fprintf(because, "That quotient is %.3f for degree (3,3,2), %.3f with the modes.",
            through(d, "IGA (3,3,2) 10x10x3"), through(d, "hex 10x10x2 incompatible"));
    return judge_both(judge_below(CURED, through(d, "IGA (3,3,2) 10x10x3")),
                      judge_below(CURED, through(d, "hex 10x10x2 incompatible")));
}

const struct claim claim_locking[] = {
    {"A higher degree through the thickness makes little difference", "", false,
     degree_through},
    {"The paper's space locks in shear, the more the thinner the sheet", "", false,
     thinner_locks},
    {"No degree in the plane helps against thickness locking", "", false, degree_in_plane},
    {"Degree 2 through the thickness and incompatible modes cure thickness locking", "",
     false, thickness_cured},
    {0}};
