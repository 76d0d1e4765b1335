/* What is claimed of the paper's figures of falling sheets (plans drops, flag, artefacts).
 */
#include <math.h>

#include "bench/claims/claim.h"

/* --- drops -------------------------------------------------------------------------------
 */

/* Down along gravity [degrees]. */
static const double PLUMB = 90;

/* The largest angle of a level over its times, and the least one after it; NaN: it died
 * before its end. */
static void swing_of(const struct study_results *d, const char *study, const char *level,
                     double *most, double *after)
{
    double angle[PLAN_STUDY_TIMES];
    const int times = dataset_values(d, QUANTITY_ANGLE,
                                     WHERE({"study", study}, {"level", level}, {"at", "*"}),
                                     PLAN_STUDY_TIMES, angle);
    int top = 0;

    *most = *after = NAN;
    for (int t = 0; t < times; t++)
        if (isnan(angle[t]))
            return;
        else if (angle[t] > angle[top])
            top = t;
    for (int t = top; t < times; t++)
        *after = fmin(*after, angle[t]);
    *most = times ? angle[top] : NAN;
}

static enum judge swings(const struct study_results *d, const char *study, FILE *because)
{
    static const char *const levels[] = {"printed", "undamped shell"};
    double most, after, shell, unused, stretch[2];

    swing_of(d, study, levels[0], &most, &after);
    swing_of(d, study, levels[1], &shell, &unused);
    for (int n = 0; n < 2; n++)
        stretch[n] =
            dataset_at(d, QUANTITY_STRETCH, WHERE({"study", study}, {"level", levels[n]}));
    fprintf(
        because,
        "At the paper's six times the printed scheme's sheet is inclined by %.3g degrees "
        "at most, where %g is plumb, by %.3g at least after that, and in the end "
        "stretched by a factor of %.3g; an undamped shell with the same E, nu, rho and "
        "thickness: %.3g degrees, a factor of %.3g.",
        most, PLUMB, after, stretch[0], shell, stretch[1]);
    return judge_both(judge_below(PLUMB, most), judge_below(after, PLUMB));
}

static enum judge edge_swings(const struct study_results *d, FILE *because)
{
    return swings(d, "edge", because);
}

static enum judge corners_swing(const struct study_results *d, FILE *because)
{
    return swings(d, "corners", because);
}

const struct claim claim_drops[] = {
    {"Fig. 7, an edge held: the sheet falls, swings through, and back",
     "Ren et al. 2024, Fig. 7", true, edge_swings},
    {"Fig. 8, two corners held: the sheet falls, swings through, and back",
     "Ren et al. 2024, Fig. 8", true, corners_swing},
    {0}};

/* --- flag --------------------------------------------------------------------------------
 */

#define PRINTED WHERE({"level", "printed (the paper's)"})
#define SOLID   WHERE({"level", "nonlinear solid, selective"})
#define SHELL   WHERE({"level", "nonlinear shell"})

static enum judge fall_is_flow(const struct study_results *d, FILE *because)
{
    const double printed = dataset_at(d, QUANTITY_ANGLE, PRINTED);
    const double elastic = judge_most(dataset_at(d, QUANTITY_ANGLE, SOLID),
                                      dataset_at(d, QUANTITY_ANGLE, SHELL));

    fprintf(
        because,
        "The printed scheme's flag sinks by %.3g degrees, stretched by a factor of %.3g; "
        "as an elastic solid or shell with the same E, nu, rho and thickness it sinks by "
        "%.2g degrees at most, stretched by %.4g.",
        printed, dataset_at(d, QUANTITY_STRETCH, PRINTED), elastic,
        judge_most(dataset_at(d, QUANTITY_STRETCH, SOLID),
                   dataset_at(d, QUANTITY_STRETCH, SHELL)));
    return judge_below(2 * elastic, printed);
}

static enum judge net_decides(const struct study_results *d, FILE *because)
{
    const double fine = dataset_at(d, QUANTITY_STRETCH, PRINTED);
    const double coarse =
        dataset_at(d, QUANTITY_STRETCH, WHERE({"level", "printed, coarser net"}));

    fprintf(because,
            "In the end its stretch is %.3g on the coarser net and %.3g on the paper's.",
            coarse, fine);
    return judge_below(0.1, fabs(fine / coarse - 1));
}

/* The largest roughness of a level over all times; NaN: it died. */
static double roughest(const struct study_results *d, const char *level)
{
    double value[PLAN_STUDY_TIMES], most = 0;
    const int times =
        dataset_values(d, QUANTITY_ROUGHNESS, WHERE({"level", level}, {"at", "*"}),
                       PLAN_STUDY_TIMES, value);

    for (int t = 0; t < times; t++)
        most = judge_most(most, value[t]);
    return most;
}

static enum judge nets_crumple(const struct study_results *d, FILE *because)
{
    const double smooth = judge_most(roughest(d, "nonlinear solid, selective"),
                                     roughest(d, "nonlinear shell"));
    const double rough = judge_most(roughest(d, "mass-spring, matched"),
                                    roughest(d, "projective dynamics, matched"));

    fprintf(because, "They have a roughness of up to %.3g, solid and shell one of %.3g.",
            rough, smooth);
    return judge_below(2 * smooth, rough);
}

const struct claim claim_flag[] = {
    {"Fig. 15: most of the flag's fall is the flow of the printed scheme, not the bending "
     "of "
     "its material",
     "", true, fall_is_flow},
    {"Fig. 15: the printed scheme does not settle as the net is refined", "", true,
     net_decides},
    {"Fig. 15: nets of springs and constraints, matched to the same E, nu and h, crumple "
     "where the sheet would stand",
     "", true, nets_crumple},
    {0}};

/* --- artefacts ---------------------------------------------------------------------------
 */

/* By the rules of Table 4 the row has the label; NULL: none at all. */
static enum judge shows(const struct study_results *d, const char *label,
                        const struct where *row, FILE *because)
{
    const double crosses = dataset_at(d, QUANTITY_INTERSECTION_TIME, row);

    fprintf(because, "Its largest stretch is %.4g, its largest angle %.3g degrees, ",
            dataset_at(d, QUANTITY_STRETCH_MAX, row),
            dataset_at(d, QUANTITY_ANGLE_MAX, row));
    if (isnan(crosses))
        fputs("and it does not cross itself.", because);
    else
        fprintf(because, "and it crosses itself at %.3g s.", crosses);
    return dataset_verdict(d, label, row);
}

static enum judge row_14_is_normal(const struct study_results *d, FILE *because)
{
    return shows(d, NULL, WHERE({"level", "normal: row 14, the paper's"}), because);
}

static enum judge shell_is_normal(const struct study_results *d, FILE *because)
{
    return shows(d, NULL, WHERE({"level", "normal: row 4, shell"}), because);
}

static enum judge row_4_elongates(const struct study_results *d, FILE *because)
{
    return shows(d, "over-stretched", WHERE({"level", "super-elongation: row 4"}), because);
}

static enum judge row_13_floats(const struct study_results *d, FILE *because)
{
    return shows(d, "too light", WHERE({"level", "floating: row 13"}), because);
}

static enum judge shell_floats(const struct study_results *d, FILE *because)
{
    return shows(d, "too light", WHERE({"level", "floating: row 13, shell"}), because);
}

static enum judge row_2_penetrates(const struct study_results *d, FILE *because)
{
    return shows(d, "penetration", WHERE({"level", "penetration: row 2"}), because);
}

const struct claim claim_artefacts[] = {
    {"Fig. 16, normal: row 14 of Table 4", "Ren et al. 2024, Fig. 16", true,
     row_14_is_normal},
    {"Fig. 16, normal: row 4 as an undamped shell", "", true, shell_is_normal},
    {"Fig. 16, super-elongation: row 4", "Ren et al. 2024, Fig. 16", true, row_4_elongates},
    {"Fig. 16, floating: row 13", "Ren et al. 2024, Fig. 16", true, row_13_floats},
    {"Fig. 16, floating: row 13 as an undamped shell", "", true, shell_floats},
    {"Fig. 16, penetration: row 2", "Ren et al. 2024, Fig. 16", true, row_2_penetrates},
    {0}};

/* --- contact -----------------------------------------------------------------------------
 */

/* A sheet whose ground carries its weight to this share is at rest. */
static const double UNREST = 0.05;

static enum judge comes_to_rest(const struct study_results *d, FILE *because)
{
    const double load =
        dataset_at(d, QUANTITY_LOAD_END, WHERE({"level", "IGA, printed (the paper's)"}));

    fprintf(
        because,
        "In the end the ground carries %.3g of the printed scheme's weight. Its d acts as "
        "a velocity and its v as an acceleration, which average acceleration throws back "
        "at an impact.",
        load);
    return judge_below(fabs(load - 1), UNREST);
}

static enum judge stays_above(const struct study_results *d, FILE *because)
{
    static const double GRID = 1e-11; /* contact is closed to 1e-13 of the size [m] */
    const double deepest = dataset_most(d, QUANTITY_PENETRATION_MAX, WHERE({NULL, NULL}));

    fprintf(because, "No surface reaches deeper than %.2g m into the ground.", deepest);
    return judge_below(deepest, GRID);
}

static enum judge avoids_itself(const struct study_results *d, FILE *because)
{
    const double first = dataset_least(d, QUANTITY_INTERSECTION_TIME, WHERE({NULL, NULL}));

    if (isnan(first)) {
        fputs("No sheet passes through itself.", because);
        return JUDGE_HOLDS;
    }
    fprintf(because, "The first sheet passes through itself at %.3g s.", first);
    return JUDGE_FAILS;
}

const struct claim claim_contact[] = {
    {"Fig. 9: the sheet comes to rest on the ground", "Ren et al. 2024, Fig. 9", true,
     comes_to_rest},
    {"Fig. 9: it suffices to detect contact at control points: no surface reaches into the "
     "ground",
     "Ren et al. 2024", false, stays_above},
    {"Fig. 9: sheets do not pass through themselves", "Ren et al. 2024, Fig. 9", true,
     avoids_itself},
    {0}};
