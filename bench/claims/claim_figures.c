/* Claims on the paper's figures of falling sheets (plans fig6,
 * plasticity, drops, flag, artefacts, contact). */
#include <math.h>

#include "bench/claims/claim.h"

/* --- fig6 --- */

/* Over-stretched: beyond Provot's limit (1995), 10 %. Rough: more than half again as rough
 * as the IGA plate at its roughest. */
static const double OVER_STRETCHED = 1.1, ROUGH = 1.5;

static const char PLATE[] = "IGA, paper's";

/* Returns the largest value of a level over the reading's times; NULL: of its level.
 * INFINITY: it died before the last. */
static double most_of(const struct study_results *d, const char *level, enum quantity q)
{
    double value[PLAN_STUDY_TIMES], most = 0;
    const struct where *rows = level ? WHERE({"level", level}) : WHERE({NULL, NULL});
    const int times = results_values(d, q, rows, PLAN_STUDY_TIMES, value);

    for (int t = 0; t < times; t++)
        most = fmax(most, isnan(value[t]) ? INFINITY : value[t]);
    return times ? most : NAN;
}

/* Writes what decides on a level's words. */
static void tell_level(const struct study_results *d, FILE *because)
{
    fprintf(because, "Stretch up to %.4g, roughness %.3g, %.0f crossings.",
            most_of(d, NULL, QUANTITY_STRETCH), most_of(d, NULL, QUANTITY_ROUGHNESS),
            most_of(d, NULL, QUANTITY_CROSSINGS));
}

/* A judge by one comparison of a level's numbers. */
#define WORD(name, ...)                                                                    \
    static enum verdict name(const struct study_results *d, FILE *because)                 \
    {                                                                                      \
        tell_level(d, because);                                                            \
        return judge_below(__VA_ARGS__);                                                   \
    }
WORD(over_stretches, OVER_STRETCHED, most_of(d, NULL, QUANTITY_STRETCH))
WORD(keeps_length, most_of(d, NULL, QUANTITY_STRETCH), OVER_STRETCHED)
WORD(crosses, 0, most_of(d, NULL, QUANTITY_CROSSINGS))
WORD(is_rough, ROUGH *most_of(d, PLATE, QUANTITY_ROUGHNESS),
     most_of(d, NULL, QUANTITY_ROUGHNESS))

/* The least rough of the others is more than ROUGH times as rough. */
static enum verdict is_smooth(const struct study_results *d, FILE *because)
{
    const double springs = most_of(d, "mass-spring, paper's", QUANTITY_ROUGHNESS);
    const double projective =
        most_of(d, "projective dynamics, paper's", QUANTITY_ROUGHNESS);
    const double own = most_of(d, NULL, QUANTITY_ROUGHNESS);

    fprintf(because,
            "Roughness up to %.3g, of the springs %.3g, of projective dynamics %.3g.", own,
            springs, projective);
    return judge_below(own * ROUGH, fmin(springs, projective));
}

static enum verdict stretches_less(const struct study_results *d, FILE *because)
{
    const double springs = most_of(d, "mass-spring, paper's", QUANTITY_STRETCH);
    const double own = most_of(d, NULL, QUANTITY_STRETCH);

    fprintf(because, "Stretch up to %.3g, of the springs up to %.3g.", own, springs);
    return judge_below(own, springs);
}

#define LEVEL(label) WHERE({"level", label})
#define ALL(label)   WHERE({"level", label}, {"at", "*"})
#define EARLY(label) WHERE({"level", label}, {"at", "0.5"})
#define SPRINGS                                                                            \
    CLAIM_READINGS(                                                                        \
        {"at all times to 2 s", ALL("mass-spring, paper's")},                              \
        {"at 0.5 s", EARLY("mass-spring, paper's")},                                       \
        {"on 20x20 points", ALL("mass-spring, paper's, 20x20"), .ours = true},             \
        {"springs matched to E, nu and h", ALL("mass-spring, matched"), .ours = true})
#define PROJECTIVE                                                                         \
    CLAIM_READINGS(                                                                        \
        {"triangles, 10 iterations, at all times to 2 s",                                  \
         ALL("projective dynamics, paper's")},                                             \
        {"edges in place of triangles", ALL("projective dynamics, paper's, edges")},       \
        {"100 iterations", ALL("projective dynamics, 100 iterations")},                    \
        {"at 0.5 s", EARLY("projective dynamics, paper's")},                               \
        {"on 20x20 points", ALL("projective dynamics, paper's, 20x20"), .ours = true},     \
        {"constraints matched to E, nu and h", ALL("projective dynamics, matched"),        \
         .ours = true})
#define THE_PLATE                                                                          \
    CLAIM_READINGS({"printed, at all times to 2 s", ALL(PLATE)},                           \
                   {"printed, at 0.5 s", EARLY(PLATE)},                                    \
                   {"incremental, undamped", ALL("IGA, incremental, undamped")},           \
                   {"on 20x20 points", ALL("IGA, 20x20"), .ours = true},                   \
                   {"an elastic shell, C = M", ALL("shell, nonlinear"), .ours = true})
#define FIG6  "4.1, Fig. 6", false
#define TIMES "Fig. 6 has no time"
#define MODEL "Bouaziz et al. 2014, whom section 4.1 names, have triangles; " TIMES
#define TEXT  "the paper's text, eq. 18 to 22"
const struct claim claim_fig6[] = {
    {"mass-spring over-stretches", FIG6, over_stretches, .readings = SPRINGS,
     .reason = TIMES},
    {"mass-spring crosses itself", FIG6, crosses, .readings = SPRINGS, .reason = TIMES},
    {"projective dynamics does not over-stretch", FIG6, keeps_length,
     .readings = PROJECTIVE, .reason = MODEL},
    {"projective dynamics is rough at this resolution", FIG6, is_rough,
     .readings = PROJECTIVE, .reason = MODEL},
    {"the plate is smoother than both", FIG6, is_smooth, .readings = THE_PLATE,
     .reason = TEXT},
    {"the plate stretches less than the springs", "4.2, Fig. 8", false, stretches_less,
     .readings = THE_PLATE, .reason = TEXT "; " TIMES},
    {0}};

/* --- plasticity --- */

/* The share of its largest deflection below which a sheet has returned. */
static const double RETURNED = 0.05;

static enum verdict some_stays(const struct study_results *d, FILE *because)
{
    double depth[PLAN_STUDY_TIMES], most = 0;
    const int times =
        results_values(d, QUANTITY_DEPTH, WHERE({"at", "*"}), PLAN_STUDY_TIMES, depth);
    const double end = results_at(d, QUANTITY_DEPTH, WHERE({NULL, NULL}));

    for (int t = 0; t < times; t++)
        most = judge_most(most, fabs(depth[t]));
    fprintf(
        because,
        "The free edge of a sheet that was struck was up to %.3g m away from its place, "
        "and is %.2g m away in the end.",
        most, fabs(end));
    return judge_below(RETURNED * most, fabs(end));
}

const struct claim claim_plasticity[] = {
    {"the deformation partly stays when the force is gone", "4.1", true, some_stays,
     .readings = CLAIM_READINGS(
         {"printed", LEVEL("printed")}, {"incremental", LEVEL("incremental")},
         {"linear, C = M", LEVEL("linear")},
         {"an elastic shell, C = M", LEVEL("elastic shell"), .ours = true}),
     .reason = TEXT},
    {0}};

/* --- drops --- */

/* Angle of a sheet that hangs along gravity [degrees]. */
static const double PLUMB = 90;

/* Finds the largest angle of a study over its times, and the least one after it; NaN: it
 * died before its end. */
static void swing_of(const struct study_results *d, const char *study, double *most,
                     double *after)
{
    double angle[PLAN_STUDY_TIMES];
    const int times = results_values(
        d, QUANTITY_ANGLE, WHERE({"study", study}, {"at", "*"}), PLAN_STUDY_TIMES, angle);
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

static enum verdict swings(const struct study_results *d, const char *study, FILE *because)
{
    double most, after;

    swing_of(d, study, &most, &after);
    fprintf(because,
            "At the paper's six times the sheet is inclined by %.3g degrees at most, where "
            "%g is plumb, by %.3g at least after that, and in the end it is stretched by a "
            "factor of %.3g.",
            most, PLUMB, after, results_at(d, QUANTITY_STRETCH, WHERE({"study", study})));
    return judge_both(judge_below(PLUMB, most), judge_below(after, PLUMB));
}

/* Judges whether the sheet is rougher at each later time than at the first. */
static enum verdict wrinkles(const struct study_results *d, const char *study,
                             FILE *because)
{
    const struct where *rows = WHERE({"study", study}, {"at", "*"});
    double rough[PLAN_STUDY_TIMES];
    const int times = results_values(d, QUANTITY_ROUGHNESS, rows, PLAN_STUDY_TIMES, rough);
    enum verdict turn = times > 1 ? VERDICT_HOLDS : VERDICT_OPEN;

    for (int t = 1; t < times; t++)
        turn = judge_both(turn, judge_below(rough[0], rough[t]));
    fputs("Roughness ", because);
    results_write(d, QUANTITY_ROUGHNESS, rows, because);
    fputs(" at the paper's six times.", because);
    return turn;
}

CLAIM_JUDGE(edge_swings, swings(d, "edge", because))
CLAIM_JUDGE(corners_swing, swings(d, "corners", because))
CLAIM_JUDGE(edge_wrinkles, wrinkles(d, "edge", because))
CLAIM_JUDGE(corners_wrinkle, wrinkles(d, "corners", because))

#define DROPS                                                                              \
    .readings = CLAIM_READINGS(                                                            \
        {"printed", LEVEL("printed")}, {"incremental", LEVEL("incremental")},              \
        {"an undamped elastic shell", LEVEL("undamped shell"), .ours = true}),             \
    .reason = TEXT
const struct claim claim_drops[] = {
    {"a sheet held at an edge falls, swings through, and back", "4.2, Fig. 7", true,
     edge_swings, DROPS},
    {"it has more wrinkles on the way", "4.2, Fig. 7", true, edge_wrinkles, DROPS},
    {"a sheet held at two corners falls, swings through, and back", "4.2, Fig. 8", true,
     corners_swing, DROPS},
    {"the sheet at two corners has more wrinkles on the way", "4.2, Fig. 8", true,
     corners_wrinkle, DROPS},
    {0}};

/* --- flag --- */

#define PRINTED WHERE({"level", "printed (the paper's)"})
#define SOLID   WHERE({"level", "nonlinear solid, selective"})
#define SHELL   WHERE({"level", "nonlinear shell"})

static enum verdict fall_is_flow(const struct study_results *d, FILE *because)
{
    const double printed = results_at(d, QUANTITY_ANGLE, PRINTED);
    const double elastic = judge_most(results_at(d, QUANTITY_ANGLE, SOLID),
                                      results_at(d, QUANTITY_ANGLE, SHELL));

    fprintf(
        because,
        "The printed scheme's flag sinks by %.3g degrees, stretched by a factor of %.3g; "
        "as an elastic solid or shell with the same E, nu, rho and thickness it sinks by "
        "%.2g degrees at most, stretched by %.4g.",
        printed, results_at(d, QUANTITY_STRETCH, PRINTED), elastic,
        judge_most(results_at(d, QUANTITY_STRETCH, SOLID),
                   results_at(d, QUANTITY_STRETCH, SHELL)));
    return judge_below(2 * elastic, printed);
}

static enum verdict net_decides(const struct study_results *d, FILE *because)
{
    const double fine = results_at(d, QUANTITY_STRETCH, PRINTED);
    const double coarse =
        results_at(d, QUANTITY_STRETCH, WHERE({"level", "printed, coarser net"}));

    fprintf(because,
            "In the end its stretch is %.3g on the coarser net and %.3g on the paper's.",
            coarse, fine);
    return judge_below(0.1, fabs(fine / coarse - 1));
}

/* Returns the largest roughness of a level over all times; NaN: it died. */
static double roughest(const struct study_results *d, const char *level)
{
    return results_all_most(d, QUANTITY_ROUGHNESS, WHERE({"level", level}, {"at", "*"}));
}

static enum verdict nets_crumple(const struct study_results *d, FILE *because)
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
     "of its material",
     "", true, fall_is_flow},
    {"Fig. 15: the printed scheme does not settle as the net is refined", "", true,
     net_decides},
    {"Fig. 15: nets of springs and constraints, matched to the same E, nu and h, crumple "
     "where the sheet would stand",
     "", true, nets_crumple},
    {0}};

/* --- artefacts --- */

/* Judges whether the rules of Table 4 give the row the label; NULL: none at all. */
static enum verdict shows(const struct study_results *d, const char *label,
                          const struct where *row, FILE *because)
{
    const double crosses = results_at(d, QUANTITY_INTERSECTION_TIME, row);

    fprintf(because, "Its largest stretch is %.4g, its largest angle %.3g degrees, ",
            results_at(d, QUANTITY_STRETCH_MAX, row),
            results_at(d, QUANTITY_ANGLE_MAX, row));
    if (isnan(crosses))
        fputs("and it does not cross itself.", because);
    else
        fprintf(because, "and it crosses itself at %.3g s.", crosses);
    return results_verdict(d, label, row);
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
    {"normal: row 14 of Table 4", "4.3, Fig. 16", true, row_14_is_normal},
    {"Fig. 16, normal: row 4 as an undamped shell", "", true, shell_is_normal},
    {"super-elongation: row 4", "4.3, Fig. 16", true, row_4_elongates},
    {"floating: row 13", "4.3, Fig. 16", true, row_13_floats},
    {"Fig. 16, floating: row 13 as an undamped shell", "", true, shell_floats},
    {"penetration: row 2", "4.3, Fig. 16", true, row_2_penetrates},
    {0}};

/* --- contact --- */

/* Judges whether the sheet has come to rest. There it is slower than what gravity gives in
 * a step: the scheme has no other speed for what it puts back on the ground in each step.
 */
static enum verdict comes_to_rest(const struct study_results *d, FILE *because)
{
    const struct scene *s = &d->study[0].row[0].result.scene;
    const double least =
        sqrt(s->gravity[0] * s->gravity[0] + s->gravity[1] * s->gravity[1] +
             s->gravity[2] * s->gravity[2]) *
        s->step;
    const double speed =
        results_at(d, QUANTITY_SPEED_END, WHERE({"level", "IGA, printed (the paper's)"}));

    fprintf(because,
            "In the end the printed sheet moves at %.3g m/s on average; gravity gives %.3g "
            "m/s in a step.",
            speed, least);
    return judge_below(speed, least);
}

static enum verdict avoids_itself(const struct study_results *d, FILE *because)
{
    const double first = results_least(d, QUANTITY_INTERSECTION_TIME, WHERE({NULL, NULL}));

    if (isnan(first)) {
        fputs("No sheet passes through itself.", because);
        return VERDICT_HOLDS;
    }
    fprintf(because, "The first sheet passes through itself at %.3g s.", first);
    return VERDICT_FAILS;
}

const struct claim claim_contact[] = {
    {"the sheet comes to rest on the ground", "4.2, Fig. 9", true, comes_to_rest},
    {"sheets do not pass through themselves", "4.2, Fig. 9", true, avoids_itself},
    {0}};
