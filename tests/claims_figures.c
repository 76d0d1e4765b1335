/* Claims turned round (claims_fixture.h).
 *
 *   claims_figures FOLDER
 */
#include "tests/claims_fixture.h"

/* Springs stretch, cross and are rough; projective dynamics is rough; the plate is smooth.
 */
static void fig6(void)
{
#define ALL(label)                                                                         \
    {                                                                                      \
        {"level", label},                                                                  \
        {                                                                                  \
            "at", "*"                                                                      \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {STRETCH, 1.01, {{"at", "*"}}},
        {ROUGHNESS, 10, {{"at", "*"}}},
        {ROUGHNESS, 1, ALL("IGA, paper's")},
        {ROUGHNESS, 1.2, ALL("IGA, 20x20")},
        {ROUGHNESS, 1.2, ALL("IGA, incremental, undamped")},
    };
    static const struct turn turns[] = {
        {"mass-spring over",
         JUDGE_FAILS,
         "mass-spring, paper's: stretch up to 1.01, roughness 10, 0 crossings. It is so in "
         "all 2 variants.",
         {{0}}},
        {"mass-spring over",
         JUDGE_FAILS,
         "The opposite is true of mass-spring, matched: stretch up to 1.2,",
         {{STRETCH, 1.2, ALL("mass-spring, matched")}}},
        {"mass-spring over",
         JUDGE_HOLDS,
         "stretch up to inf, roughness 10, 0 crossings. The opposite is true of "
         "mass-spring, paper's, 20x20: ",
         {{STRETCH, NAN, {{"level", "mass-spring, paper's"}, {"at", "2"}}}}},
        {"mass-spring penetrates", JUDGE_FAILS, "0 crossings", {{0}}},
        {"mass-spring penetrates",
         JUDGE_HOLDS,
         "inf crossings",
         {{LOST, 0, ALL("mass-spring, paper's")}}},
        {"projective dynamics does", JUDGE_HOLDS, "It is so in all 4 variants", {{0}}},
        {"projective dynamics does",
         JUDGE_FAILS,
         "paper's: stretch up to 1.3,",
         {{STRETCH, 1.3, {{"at", "*"}}}}},
        {"projective dynamics is", JUDGE_HOLDS, "roughness 10, 0", {{0}}},
        {"projective dynamics is",
         JUDGE_FAILS,
         "roughness 1.4,",
         {{ROUGHNESS, 1.4, {{"at", "*"}}}, {ROUGHNESS, 1, ALL("IGA, paper's")}}},
        {"IGA is", JUDGE_HOLDS, "roughness 1, 0 crossings. It is so in all 2", {{0}}},
        {"IGA is",
         JUDGE_HOLDS,
         "The opposite is true of IGA, 20x20: stretch up to 1.01, roughness 1.6,",
         {{ROUGHNESS, 1.6, ALL("IGA, 20x20")}}},
        {"IGA is", JUDGE_FAILS, "roughness 9,", {{ROUGHNESS, 9, {{"at", "*"}}}}},
        {"IGA does", JUDGE_HOLDS, "stretch up to 1.01", {{0}}},
        {"IGA does", JUDGE_FAILS, "stretch up to 1.3,", {{STRETCH, 1.3, {{"at", "*"}}}}},
    };
#undef ALL

    check("fig6", begin, COUNT(begin), turns, COUNT(turns));
}

/* Both sheets hang at 80 degrees, swing to 120 at the third time, and back to 70. */
static void drops(void)
{
    static const struct change begin[] = {
        {ANGLE, 80, {{"at", "*"}}},
        {ANGLE, 120, {{"level", "printed"}, {"at", "2"}}},
        {ANGLE, 70, {{"level", "printed"}, {"at", "3.5"}}},
        {STRETCH, 1.5, {{"level", "printed"}, {"at", "4.25"}}},
        {ANGLE, 60, {{"level", "undamped shell"}, {"at", "*"}}},
        {ANGLE, 65, {{"level", "undamped shell"}, {"at", "1.5"}}},
    };
    static const struct turn turns[] = {
        {"Fig. 7",
         JUDGE_HOLDS,
         "by 120 degrees at most, where 90 is plumb, by 70 at least after that, and in the "
         "end stretched by a factor of 1.5; an undamped shell with the same E, nu, rho and "
         "thickness: 65 degrees",
         {{0}}},
        {"Fig. 7",
         JUDGE_FAILS,
         "by 89 degrees",
         {{ANGLE, 89, {{"study", "edge"}, {"level", "printed"}, {"at", "2"}}}}},
        {"Fig. 7",
         JUDGE_FAILS,
         "by 91 at least after",
         {{ANGLE, 91, {{"study", "edge"}, {"level", "printed"}, {"at", "3.25"}}},
          {ANGLE, 91, {{"study", "edge"}, {"level", "printed"}, {"at", "3.5"}}},
          {ANGLE, 91, {{"study", "edge"}, {"level", "printed"}, {"at", "4.25"}}}}},
        {"Fig. 7",
         JUDGE_OPEN,
         "nan",
         {{ANGLE, NAN, {{"study", "edge"}, {"level", "printed"}, {"at", "4.25"}}}}},
        {"Fig. 8",
         JUDGE_HOLDS,
         "by 70 at least",
         {{ANGLE, 10, {{"study", "edge"}, {"level", "printed"}, {"at", "*"}}}}},
        {"Fig. 8",
         JUDGE_FAILS,
         "by 89 degrees",
         {{ANGLE, 89, {{"study", "corners"}, {"level", "printed"}, {"at", "2"}}}}},
    };

    check("drops", begin, COUNT(begin), turns, COUNT(turns));
}

static void flag(void)
{
    static const struct change begin[] = {
        {ANGLE, 4, {{"at", "*"}}},
        {ANGLE, 40, {{"level", "printed (the paper's)"}, {"at", "2.075"}}},
        {STRETCH, 1.5, {{"level", "printed (the paper's)"}, {"at", "2.075"}}},
        {STRETCH, 1.8, {{"level", "printed, coarser net"}, {"at", "2.075"}}},
        {ROUGHNESS, 1, {{"at", "*"}}},
        {ROUGHNESS, 19, {{"level", "mass-spring, matched"}, {"at", "1"}}},
    };
    static const struct turn turns[] = {
        {"Fig. 15: most of",
         JUDGE_HOLDS,
         "sinks by 40 degrees, stretched by a factor of 1.5; as an elastic solid or shell "
         "with the same E, nu, rho and thickness it sinks by 4 degrees",
         {{0}}},
        {"Fig. 15: most of",
         JUDGE_FAILS,
         "by 21 degrees",
         {{ANGLE, 21, {{"level", "nonlinear shell"}, {"at", "2.075"}}}}},
        {"Fig. 15: most of",
         JUDGE_FAILS,
         "by 22 degrees",
         {{ANGLE, 22, {{"level", "nonlinear solid, selective"}, {"at", "2.075"}}}}},
        {"Fig. 15: most of",
         JUDGE_OPEN,
         "nan",
         {{ANGLE, NAN, {{"level", "nonlinear shell"}, {"at", "2.075"}}}}},
        {"Fig. 15: the printed",
         JUDGE_HOLDS,
         "is 1.8 on the coarser net and 1.5 on",
         {{0}}},
        {"Fig. 15: the printed",
         JUDGE_FAILS,
         "is 1.6 on the coarser",
         {{STRETCH, 1.6, {{"level", "printed, coarser net"}, {"at", "2.075"}}}}},
        {"Fig. 15: nets", JUDGE_HOLDS, "of up to 19, solid and shell one of 1.", {{0}}},
        {"Fig. 15: nets",
         JUDGE_FAILS,
         "one of 9.6.",
         {{ROUGHNESS, 9.6, {{"level", "nonlinear shell"}, {"at", "0.75"}}}}},
        {"Fig. 15: nets",
         JUDGE_HOLDS,
         "of up to 30",
         {{ROUGHNESS, 30, {{"level", "projective dynamics, matched"}, {"at", "0.75"}}}}},
    };

    check("flag", begin, COUNT(begin), turns, COUNT(turns));
}

/* Everything feasible by the rules of Table 4, then one measure beyond one bound. */
static void artefacts(void)
{
#define ROW(label)                                                                         \
    {                                                                                      \
        {                                                                                  \
            "level", label                                                                 \
        }                                                                                  \
    }
#define TURN(quote, label, measure, beyond, number)                                        \
    {quote, JUDGE_HOLDS, number, {{MEASURE + MEASURE_##measure, beyond, ROW(label)}}},     \
        {quote, JUDGE_FAILS, "stretch is 1,", {{0}}},                                      \
    {                                                                                      \
        quote, JUDGE_OPEN, "stretch",                                                      \
        {                                                                                  \
            {                                                                              \
                MEASURE + MEASURE_##measure, NAN, ROW(label)                               \
            }                                                                              \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {MEASURE + MEASURE_STRETCH_MAX, 1, {{"at", "*"}}},
        {MEASURE + MEASURE_ANGLE_MAX, 85, {{"at", "*"}}},
        {MEASURE + MEASURE_INTERSECTIONS_MAX, 0, {{"at", "*"}}},
        {MEASURE + MEASURE_INTERSECTION_TIME, INFINITY, {{"at", "*"}}},
        {MEASURE + MEASURE_BLOWUP_TIME, INFINITY, {{"at", "*"}}},
        {MEASURE + MEASURE_SPEED_MAX, 1, {{"at", "*"}}},
        {MEASURE + MEASURE_ROUGHNESS_MAX, 1, {{"at", "*"}}},
    };
    static const struct turn turns[] = {
        {"Fig. 16, normal: row 14", JUDGE_HOLDS, "does not cross itself", {{0}}},
        {"Fig. 16, normal: row 14",
         JUDGE_FAILS,
         "stretch is 1.2,",
         {{MEASURE + MEASURE_STRETCH_MAX, 1.2, ROW("normal: row 14, the paper's")}}},
        {"Fig. 16, normal: row 4", JUDGE_HOLDS, "angle 85 degrees", {{0}}},
        {"Fig. 16, normal: row 4",
         JUDGE_FAILS,
         "crosses itself at 0.7 s",
         {{MEASURE + MEASURE_INTERSECTIONS_MAX, 3, ROW("normal: row 4, shell")},
          {MEASURE + MEASURE_INTERSECTION_TIME, 0.7, ROW("normal: row 4, shell")}}},
        TURN("Fig. 16, super", "super-elongation: row 4", STRETCH_MAX, 1.2, "is 1.2,"),
        TURN("Fig. 16, floating: row 13 as", "floating: row 13, shell", ANGLE_MAX, 70,
             "angle 70 "),
        TURN("Fig. 16, floating: row 13", "floating: row 13", ANGLE_MAX, 71, "angle 71 "),
        TURN("Fig. 16, penetration", "penetration: row 2", INTERSECTIONS_MAX, 3, "stretch"),
    };
#undef TURN
#undef ROW

    check("artefacts", begin, COUNT(begin), turns, COUNT(turns));
}

static void contact(void)
{
    static const struct change begin[] = {
        {MEASURE + MEASURE_LOAD_END, 1.04, {{"at", "*"}}},
        {MEASURE + MEASURE_PENETRATION_MAX, 1e-13, {{"at", "*"}}},
        {MEASURE + MEASURE_INTERSECTION_TIME, INFINITY, {{"at", "*"}}},
    };
    static const struct turn turns[] = {
        {"Fig. 9: the sheet", JUDGE_HOLDS, "carries 1.04 of", {{0}}},
        {"Fig. 9: the sheet",
         JUDGE_FAILS,
         "carries 0.94 of",
         {{MEASURE + MEASURE_LOAD_END, 0.94, {{"level", "IGA, printed (the paper's)"}}}}},
        {"Fig. 9: it suffices", JUDGE_HOLDS, "than 1e-13 m", {{0}}},
        {"Fig. 9: it suffices",
         JUDGE_FAILS,
         "than 0.002 m",
         {{MEASURE + MEASURE_PENETRATION_MAX, 0.002, {{"level", "shell, nonlinear"}}}}},
        {"Fig. 9: sheets", JUDGE_HOLDS, "No sheet", {{0}}},
        {"Fig. 9: sheets",
         JUDGE_FAILS,
         "at 0.6 s",
         {{MEASURE + MEASURE_INTERSECTION_TIME, 0.6, {{"level", "IGA, linear"}}},
          {MEASURE + MEASURE_INTERSECTION_TIME, 0.9, {{"level", "shell, nonlinear"}}}}},
    };

    check("contact", begin, COUNT(begin), turns, COUNT(turns));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    fig6();
    drops();
    flag();
    artefacts();
    contact();
    return check_result();
}
