/* Claims on a cloak's thickness and on the degree through it (plans thickness,
 * thickness-shell and thickness-degree; Ren et al. 2024, Figs. 10 and 11). The cloak's
 * shape, size and pose are ours, as the paper does not give them. */
#include <math.h>

#include "bench/claims/claim.h"

/* --- thickness */

#define STUDY(name) WHERE({"study", name})

/* Returns the swing of a study, NULL: the reading's. */
static double swing(const struct study_results *d, const char *study, const char *thickness)
{
    return results_at(d, QUANTITY_SWING,
                      study ? WHERE({"study", study}, {"thickness", thickness})
                            : WHERE({"thickness", thickness}));
}

static enum verdict thin_swings(const struct study_results *d, FILE *because)
{
    const double thin = swing(d, NULL, "1 mm"), thick = swing(d, NULL, "5 mm");

    fprintf(because, "%.3g degrees at 1 mm, %.3g at 5 mm.", thin, thick);
    return judge_below(thick, thin);
}

/* A sheet that only bends sinks at rest as 1/h^2, one that only stretches as far at any h.
 */
static enum verdict cloak_stretches(const struct study_results *d, FILE *because)
{
    const double thin = results_at(d, QUANTITY_EDGE_MOVED,
                                   WHERE({"study", "linear"}, {"thickness", "1 mm"}));
    const double thick = results_at(d, QUANTITY_EDGE_MOVED,
                                    WHERE({"study", "linear"}, {"thickness", "5 mm"}));

    fprintf(because,
            "At rest and in linear theory, what only bends would sink 25 times as far at "
            "1 mm as at 5 mm, what only stretches just as far; this cloak's hem sinks %.3g "
            "times as far (%.3g m and %.3g m).",
            thin / thick, thin, thick);
    return judge_below(2 * thin / thick, 25);
}

static enum verdict net_locks(const struct study_results *d, FILE *because)
{
    const double thin = swing(d, "printed", "1 mm"), thick = swing(d, "printed", "5 mm");
    const double more = swing(d, "printed_better", "1 mm") - thin;

    fprintf(because,
            "A better net lets the thin cloak swing %.1f degrees farther and the thick one "
            "%.1f; on the paper's they differ by %.1f.",
            more, swing(d, "printed_better", "5 mm") - thick, fabs(thin - thick));
    return judge_below(fabs(thin - thick), more);
}

const struct claim claim_thickness[] = {
    {"the thinner cloak swings wider than the thicker one", "4.2, Fig. 10", false,
     thin_swings,
     .readings = CLAIM_READINGS(
         {"printed, on the net of Fig. 6", STUDY("printed")},
         {"incremental, undamped", STUDY("incremental")},
         {"printed, on (3,3,2) 16x16x3", STUDY("printed_better"), .ours = true}),
     .reason = "the paper's text, eq. 18 to 22; it gives the cloak no net"},
    {"The cloak's curvature makes it stretch rather than bend", "", false, cloak_stretches},
    {"The paper's net locks by more than its two thicknesses differ", "", false, net_locks},
    {0}};

/* --- thickness-shell */

static double shell(const struct study_results *d, const char *thickness, const char *net)
{
    return results_at(d, QUANTITY_SWING, WHERE({"thickness", thickness}, {"net", net}));
}

/* The difference of its nets is the error bar of each. */
static enum verdict thin_shell_swings(const struct study_results *d, FILE *because)
{
    const double thin = shell(d, "1 mm", "fine"), thick = shell(d, "5 mm", "fine");
    const double apart = judge_most(fabs(thin - shell(d, "1 mm", "coarse")),
                                    fabs(thick - shell(d, "5 mm", "coarse")));

    fprintf(because,
            "The nonlinear shell swings by %.1f degrees at 1 mm, by %.1f at 5 mm; its nets "
            "differ by up to %.1f.",
            thin, thick, apart);
    return judge_order(2, (double[]){thick, thin}, 1, 2 * apart);
}

const struct claim claim_thickness_shell[] = {
    {"A thinner cloak swings more as a nonlinear shell, too", "", true, thin_shell_swings},
    {0}};

/* --- thickness-degree */

/* Returns how far r = 1 and the highest r are apart at most [m], NULL: of the reading's
 * study; the cloak is 1 m long. */
static double farthest(const struct study_results *d, const char *study)
{
    return results_all_most(d, QUANTITY_FINEST,
                            study ? WHERE({"study", study}, {"level", "r = 1"}, {"at", "*"})
                                  : WHERE({"level", "r = 1"}, {"at", "*"}));
}

static enum verdict looks_alike(const struct study_results *d, FILE *because)
{
    static const double ALIKE = 0.04; /* m: what the paper's Table 1 takes for one look */
    const double apart = farthest(d, NULL);

    fprintf(because,
            "r = 1 and the highest r are up to %.3g m apart (RMSE); Table 1 takes %g m for "
            "the same look.",
            apart, ALIKE);
    return judge_below(apart, ALIKE);
}

static enum verdict linear_is_cheaper(const struct study_results *d, FILE *because)
{
    const struct where *cloak = WHERE({"study", "cloak"});
    double ms[3];
    const int count = results_values(d, QUANTITY_FRAME, cloak, 3, ms);

    fputs("A frame costs ", because);
    results_write(d, QUANTITY_FRAME, cloak, because);
    fputs(" ms with r = 1, 2, 3.", because);
    return judge_order(count, ms, 1, 0);
}

/* With a strain that cannot vary through the thickness, the sheet cannot narrow where it is
 * stretched and widen where it is pressed. A degree helps if it more than halves the
 * error. */
static enum verdict degree_helps(const struct study_results *d, FILE *because)
{
    double off[3] = {NAN, NAN, NAN};

    results_values(d, QUANTITY_TIP, WHERE({"study", "plate"}), 3, off);
    for (int n = 0; n < 3; n++)
        off[n] = fabs(off[n] - 1);
    fprintf(
        because,
        "On a plate whose answer is known, the tip is off by %.3g %% with r = 1, %.3g "
        "%% with r = 2 and %.3g %% with r = 3; the cloak moves %.2g m (the paper's net) "
        "or %.2g m (degree 4) for it.",
        100 * off[0], 100 * off[1], 100 * off[2], farthest(d, "cloak"),
        farthest(d, "better"));
    return judge_both(judge_below(2 * off[1], off[0]), judge_below(2 * off[2], off[0]));
}

const struct claim claim_thickness_degree[] = {
    {"degrees 2 and 3 through the thickness differ little from degree 1", "4.2, Fig. 11",
     false, looks_alike,
     .readings =
         CLAIM_READINGS({"over the swing, on 10x10 points of degree 2", STUDY("cloak")},
                        {"degree 4 in the plane, r = 1 and 2", STUDY("better")}),
     .reason = "the net of the paper's other sheets; it gives the cloak none"},
    {"the linear basis is the cheaper one", "4.2, Fig. 11", false, linear_is_cheaper,
     .timed = true},
    {"Little difference is not accuracy: a higher degree halves the error of a plate", "",
     false, degree_helps},
    {0}};
