/* Claims on the paper's figures of falling sheets (plans fig6,
 * drops, flag, artefacts, contact). */
#include <math.h>
#include <string.h>

#include "bench/claims/claim.h"

/* --- fig6 --------------------------------------------------------------------------------
 */

/* Over-stretched: beyond Provot's limit (1995), 10 %. Rough: more than half again as rough
 * as the IGA plate at its roughest. */
static const double OVER_STRETCHED = 1.1, ROUGH = 1.5;

static const char PLATE[] = "IGA, paper's";

/* Returns the largest value of a level over its times; INFINITY: it died before the last.
 */
static double most_of(const struct study_results *d, const char *level, enum quantity q)
{
    double value[PLAN_STUDY_TIMES], most = 0;
    const int times =
        dataset_values(d, q, WHERE({"level", level}, {"at", "*"}), PLAN_STUDY_TIMES, value);

    for (int t = 0; t < times; t++)
        most = fmax(most, isnan(value[t]) ? INFINITY : value[t]);
    return times ? most : NAN;
}

/* Judges a word on a level: over-stretched, rough, ... */
typedef enum judge word(const struct study_results *d, const char *level);

#define WORD(name, ...)                                                                    \
    static enum judge name(const struct study_results *d, const char *level)               \
    {                                                                                      \
        return judge_below(__VA_ARGS__);                                                   \
    }
WORD(over_stretches, OVER_STRETCHED, most_of(d, level, QUANTITY_STRETCH))
WORD(keeps_length, most_of(d, level, QUANTITY_STRETCH), OVER_STRETCHED)
WORD(crosses, 0, most_of(d, level, QUANTITY_CROSSINGS))
WORD(is_rough, ROUGH *most_of(d, PLATE, QUANTITY_ROUGHNESS),
     most_of(d, level, QUANTITY_ROUGHNESS))

static enum judge is_smooth(const struct study_results *d, const char *level)
{
    const double others =
        fmax(most_of(d, "mass-spring, paper's", QUANTITY_ROUGHNESS),
             most_of(d, "projective dynamics, paper's", QUANTITY_ROUGHNESS));
    const double own = most_of(d, level, QUANTITY_ROUGHNESS);

    return judge_both(judge_below(own, ROUGH * most_of(d, PLATE, QUANTITY_ROUGHNESS)),
                      judge_below(own * ROUGH, others));
}

/* Judges the first of all levels that begin with the word, the paper's, and names
 * those of its variants of which the opposite is true. */
static enum judge of_all(const struct study_results *d, const char *first, word *is,
                         FILE *because)
{
    const char *level[PLAN_STUDY_LEVELS];
    const int levels = dataset_labels(d, "level", PLAN_STUDY_LEVELS, level);
    const size_t size = strlen(first);
    enum judge turn = JUDGE_OPEN;
    int count = 0, others = 0;

    for (int n = 0; n < levels; n++) {
        if (strncmp(level[n], first, size))
            continue;
        const enum judge here = is(d, level[n]);
        if (!count++)
            turn = here;
        else if (here == turn)
            continue;
        else
            others++;
        fprintf(because, "%s%s: stretch up to %.4g, roughness %.3g, %.0f crossings",
                others ? (others > 1 ? "; " : ". The opposite is true of ") : "", level[n],
                most_of(d, level[n], QUANTITY_STRETCH),
                most_of(d, level[n], QUANTITY_ROUGHNESS),
                most_of(d, level[n], QUANTITY_CROSSINGS));
    }
    if (others)
        fputs(".", because);
    else
        fprintf(because, ". It is so in all %d variants.", count - 1);
    return turn;
}

CLAIM_JUDGE(springs_stretch, of_all(d, "mass-spring", over_stretches, because))
CLAIM_JUDGE(springs_cross, of_all(d, "mass-spring", crosses, because))
CLAIM_JUDGE(projective_keeps, of_all(d, "projective", keeps_length, because))
CLAIM_JUDGE(projective_is_rough, of_all(d, "projective", is_rough, because))
CLAIM_JUDGE(plate_is_smooth, of_all(d, "IGA", is_smooth, because))
CLAIM_JUDGE(plate_keeps, of_all(d, "IGA", keeps_length, because))

#define FIG6 "Ren et al. 2024, Fig. 6", false
const struct claim claim_fig6[] = {
    {"mass-spring over-stretches", FIG6, springs_stretch},
    {"mass-spring penetrates itself", FIG6, springs_cross},
    {"projective dynamics does not over-stretch", FIG6, projective_keeps},
    {"projective dynamics is rough at this resolution", FIG6, projective_is_rough},
    {"IGA is smooth (and the others are not)", FIG6, plate_is_smooth},
    {"IGA does not over-stretch", FIG6, plate_keeps},
    {0}};

/* --- drops -------------------------------------------------------------------------------
 */

/* Angle of a sheet that hangs along gravity [degrees]. */
static const double PLUMB = 90;

/* Finds the largest angle of a level over its times, and the least one after it; NaN: it
 * died before its end. */
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

CLAIM_JUDGE(edge_swings, swings(d, "edge", because))
CLAIM_JUDGE(corners_swing, swings(d, "corners", because))

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

/* Returns the largest roughness of a level over all times; NaN: it died. */
static double roughest(const struct study_results *d, const char *level)
{
    return dataset_all_most(d, QUANTITY_ROUGHNESS, WHERE({"level", level}, {"at", "*"}));
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

/* Judges whether the rules of Table 4 give the row the label; NULL: none at all. */
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

CLAIM_JUDGE(row_14_is_normal,
            shows(d, NULL, WHERE({"level", "normal: row 14, the paper's"}), because))
CLAIM_JUDGE(shell_is_normal,
            shows(d, NULL, WHERE({"level", "normal: row 4, shell"}), because))
CLAIM_JUDGE(row_4_elongates, shows(d, "over-stretched",
                                   WHERE({"level", "super-elongation: row 4"}), because))
CLAIM_JUDGE(row_13_floats,
            shows(d, "too light", WHERE({"level", "floating: row 13"}), because))
CLAIM_JUDGE(shell_floats,
            shows(d, "too light", WHERE({"level", "floating: row 13, shell"}), because))
CLAIM_JUDGE(row_2_penetrates,
            shows(d, "penetration", WHERE({"level", "penetration: row 2"}), because))

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

/* Share of its weight by which the load on the ground may be off for a sheet at rest. */
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

const struct claim claim_contact[] = {{"Fig. 9: the sheet comes to rest on the ground",
                                       "Ren et al. 2024, Fig. 9", true, comes_to_rest},
                                      {"Fig. 9: sheets do not pass through themselves",
                                       "Ren et al. 2024, Fig. 9", true, avoids_itself},
                                      {0}};
