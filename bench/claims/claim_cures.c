/* Claims on the cures for locking (plan cures). */
#include <math.h>

#include "bench/claims/claim.h"

static const double TARGET = 0.02; /* how far from truth a cured tip may be */

static const char *const cures[] = {"IGA (2,2,1), selective", "IGA (3,3,1), selective"};
enum { CURES = sizeof cures / sizeof *cures };

/* Returns how far the worst of a space's tips in a study is from truth. */
static double worst(const struct study_results *d, const char *study, const char *space)
{
    const struct where *where = WHERE({"study", study}, {"space", space});

    return fmax(results_most(d, QUANTITY_TIP_OF_REFERENCE, where) - 1,
                1 - results_least(d, QUANTITY_TIP_OF_REFERENCE, where));
}

/* Judges all cures in the studies, and writes what a coarser net of the truth moves. */
static enum verdict within(const struct study_results *d, int count,
                           const char *const *studies, FILE *because)
{
    enum verdict turn = VERDICT_HOLDS;

    fputs("Off by, at most:", because);
    for (int c = 0; c < CURES; c++) {
        double most = NAN;
        for (int n = 0; n < count; n++)
            most = fmax(most, worst(d, studies[n], cures[c]));
        fprintf(because, "%s %s %.2g %%", c ? "," : "", cures[c], 100 * most);
        turn = judge_both(turn, judge_below(most, TARGET));
    }
    fputs("; the truth on a coarser net by", because);
    for (int n = 0; n < count; n++)
        fprintf(because, "%s %.2g %% (%s)", n ? "," : "",
                100 * worst(d, studies[n], "coarser"), studies[n]);
    fputs(".", because);
    return turn;
}

CLAIM_JUDGE(thin_within,
            within(d, 3, (const char *const[]){"linear", "gamma_10", "gamma_100"}, because))
CLAIM_JUDGE(thick_within,
            within(d, 2, (const char *const[]){"linear_thick", "gamma_10_thick"}, because))

/* Judges whether most of the error comes from the clamp, which, where nu is large, keeps a
 * solid from changing its thickness. */
static enum verdict clamp_is_why(const struct study_results *d, FILE *because)
{
    double off[2];

    for (int n = 0; n < 2; n++)
        off[n] = results_at(d, QUANTITY_TIP_OF_REFERENCE,
                            WHERE({"study", "linear_thick"}, {"poisson", "0.49"},
                                  {"space", n ? "slit" : cures[1]})) -
                 1;
    fprintf(because,
            "At nu = 0.49 one linear layer with plane stress falls %.2g %% too far; a 3-D "
            "solid whose clamp leaves the thickness free (x and y held on the face, z on "
            "its lower edge) %.2g %% farther than the clamped one.",
            100 * off[0], 100 * off[1]);
    return judge_both(judge_below(0, off[0]), judge_below(off[0], 2 * off[1]));
}

/* Returns the growth of the error at Gamma = 100 from h/L 1e-3 to 1e-5. */
static double growth(const struct study_results *d, const char *space, FILE *because)
{
    double off[2];

    for (int n = 0; n < 2; n++)
        off[n] =
            fabs(results_at(d, QUANTITY_TIP_OF_REFERENCE,
                            WHERE({"study", "gamma_100"}, {"poisson", "0"},
                                  {"space", space}, {"thickness", n ? "1e-5" : "1e-3"})) -
                 1);
    fprintf(because, " %s %.2g %% and %.2g %%", space, 100 * off[0], 100 * off[1]);
    return off[1] / off[0];
}

static enum verdict is_resolution(const struct study_results *d, FILE *because)
{
    double most = 0;

    fputs("The sheet bends within 0.22 L of its clamp, on 1.7 spans of eight. Off at h/L = "
          "1e-3 and 1e-5, nu = 0, by:",
          because);
    for (int n = 0; n < CURES; n++) {
        most = judge_most(most, growth(d, cures[n], because));
        fputs(n < CURES - 1 ? "," : ";", because);
    }
    fputs(" without a cure", because);
    const double none = growth(d, "IGA (2,2,1), none", because);
    fputs(".", because);
    return judge_both(judge_below(most, 2), judge_below(2, none));
}

/* A tenth more lies within the scatter of repeats. */
static enum verdict costs_no_more(const struct study_results *d, FILE *because)
{
    double most = 0;

    fputs("A rebuilt frame takes", because);
    for (int n = 0; n < CURES; n++) {
        const char *none = n < 1 ? "IGA (2,2,1), none" : "IGA (3,3,1), none";
        const double ratio =
            results_at(d, QUANTITY_FRAME, WHERE({"study", "frame"}, {"space", cures[n]})) /
            results_at(d, QUANTITY_FRAME, WHERE({"study", "frame"}, {"space", none}));
        fprintf(because, "%s %.2f of the time with %s", n ? "," : "", ratio, cures[n]);
        most = judge_most(most, ratio);
    }
    fputs(".", because);
    return judge_below(most, 1.1);
}

const struct claim claim_cures[] = {
    {"A cure is within 2 % of truth on thin sheets", "", true, thin_within},
    {"A cure is within 2 % of truth at h/L = 0.1", "", true, thick_within},
    {"At h/L = 0.1 the clamp's hold on the thickness is most of a cure's error", "", true,
     clamp_is_why},
    {"At Gamma = 100 a cure's error is one of resolution and does not grow on thinner "
     "sheets",
     "", false, is_resolution},
    {"A cure costs nothing", "", true, costs_no_more},
    {0}};
