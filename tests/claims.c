/* Claims turned round (claims_fixture.h).
 *
 *   claims FOLDER
 */
#include "tests/claims_fixture.h"

static void solvers(void)
{
    static const struct change begin[] = {
        {COST, 1, {{"net", "5x5x2"}}},
        {COST, 10, {{"net", "10x10x2"}}},
        {COST, 100, {{"net", "20x20x2"}}},
        {COST, 1000, {{"net", "40x40x2"}}},
        {COST, 0.5, {{"solver", "CG, last factor"}, {"net", "5x5x2"}}},
        {COST, 5, {{"solver", "CG, last factor"}, {"net", "10x10x2"}}},
        {COST, 50, {{"solver", "CG, last factor"}, {"net", "20x20x2"}}},
        {COST, 500, {{"solver", "GMRES, last factor"}, {"net", "40x40x2"}}},
        {COST, 2000, {{"solver", "direct, every tangent new"}}},
        {PLACE, 0, {{"study", "printed"}}},
        {PLACE, 0, {{"study", "nonlinear"}}},
    };
    static const struct turn turns[] = {
        {"Printed kinematics",
         JUDGE_HOLDS,
         "10x10x2: the best, CG, last factor, takes 0.5",
         {{0}}},
        {"Printed kinematics",
         JUDGE_HOLDS,
         "40x40x2: the best, GMRES, last factor, takes 0.5",
         {{0}}},
        {"Printed kinematics",
         JUDGE_FAILS,
         "20x20x2: the best, GMRES, Jacobi, takes 1",
         {{COST, 300, {{"solver", "CG, last factor"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "GMRES, last factor"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "CG, incomplete Cholesky"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "CG, Jacobi"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "GMRES, incomplete Cholesky"}, {"net", "20x20x2"}}}}},
        {"Nonlinear kinematics", JUDGE_HOLDS, "takes 0.5", {{0}}},
        {"Nonlinear kinematics",
         JUDGE_FAILS,
         "takes 1 ",
         {{COST,
           3,
           {{"study", "nonlinear"}, {"solver", "CG, last factor"}, {"net", "5x5x2"}}}}},
        {"Keeping tangents", JUDGE_HOLDS, "at least 2 of", {{0}}},
        {"Keeping tangents",
         JUDGE_FAILS,
         "at least 0.9 of",
         {{COST, 9, {{"solver", "direct, every tangent new"}, {"net", "10x10x2"}}}}},
        {"Keeping tangents", JUDGE_OPEN, "nan", {{COST, NAN, {{"solver", "direct"}}}}},
        {"The last factor", JUDGE_FAILS, "as ^", {{0}}}, /* 1000, 1001, 1002 unknowns */
        {"The last factor",
         JUDGE_HOLDS,
         "2.3e+03 with the direct solver",
         {{COST, 7, {{"study", "printed"}, {"solver", "CG, last factor"}}},
          {COST, 1e9, {{"solver", "CG, last factor"}, {"net", "40x40x2"}}}}},
        {"All solvers", JUDGE_HOLDS, "by 0 L", {{0}}},
        {"All solvers",
         JUDGE_FAILS,
         "by 0.002 L",
         {{PLACE,
           -0.002,
           {{"study", "printed"}, {"solver", "GMRES, Jacobi"}, {"net", "5x5x2"}}}}},
    };

    check("solvers", begin, COUNT(begin), turns, COUNT(turns));
}

/* Iterated to the end all are at 0, small steps .01 away with Euler, .001 with BDF2. */
static void local_global(void)
{
#define AT(method, count)                                                                  \
    {                                                                                      \
        {"time", "Euler"}, {"method", method},                                             \
        {                                                                                  \
            "iterations", count                                                            \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {PLACE, 0.5, AT("plain", "20")},
        {PLACE, 0.5, AT("plain", "50")},
        {PLACE, 0.05, AT("Chebyshev", "50")},
        {PLACE, 0.005, AT("ADMM", "20")},
        {PLACE, 0.01, {{"iterations", "end"}}},
        {PLACE, 0, AT("ADMM", "end")},
        {PLACE, 0.009, {{"time", "BDF2"}, {"step", "5 ms"}, {"iterations", "end"}}},
        {ERROR, 0.001, {{"iterations", "end"}}},
    };
    static const struct turn turns[] = {
        {"Frames of 5 ms: iterations",
         JUDGE_HOLDS,
         "edge_drop: 0.01 L is what Euler's step takes, 20 plain iterations leave 0.5 L",
         {{0}}},
        {"Frames of 5 ms: iterations",
         JUDGE_FAILS,
         "corners_patch: 0.01 L is what Euler's step takes, 20 plain iterations leave "
         "0.004 L",
         {{PLACE,
           0.004,
           {{"study", "corners_patch"}, {"method", "plain"}, {"iterations", "20"}}}}},
        {"Frames of 5 ms: Chebyshev",
         JUDGE_HOLDS,
         "0.05 L is what 50 iterations leave, without it 0.5 L",
         {{0}}},
        {"Frames of 5 ms: Chebyshev",
         JUDGE_FAILS,
         "edge_drop: 0.6 L",
         {{PLACE,
           0.6,
           {{"study", "edge_drop"},
            {"time", "Euler"},
            {"method", "Chebyshev"},
            {"iterations", "50"}}}}},
        {"Frames of 5 ms: ADMM",
         JUDGE_HOLDS,
         "0.005 L is what 20 iterations leave, without it 0.5 L",
         {{0}}},
        {"Frames of 5 ms: ADMM", JUDGE_FAILS, "0.7 L", {{PLACE, 0.7, AT("ADMM", "20")}}},
        {"Frames of 5 ms: 20",
         JUDGE_HOLDS,
         "0.005 L is what they leave, the worse of step and net takes 0.01 L",
         {{0}}},
        {"Frames of 5 ms: 20", JUDGE_FAILS, "0.7 L", {{PLACE, 0.7, AT("ADMM", "20")}}},
        {"Frames of 5 ms: 20",
         JUDGE_HOLDS,
         "takes 0.9 L",
         {{PLACE, 0.7, AT("ADMM", "20")},
          {ERROR, 0.9, {{"step", "small"}, {"iterations", "end"}}}}},
        {"Frames of 5 ms: second",
         JUDGE_HOLDS,
         "0.001 L is what BDF2's step takes, Euler's 0.01 L",
         {{0}}},
        {"Frames of 5 ms: second",
         JUDGE_FAILS,
         "Euler's 0.01 L",
         {{PLACE, 0.5, {{"time", "BDF2"}, {"step", "5 ms"}, {"iterations", "end"}}}}},
    };
#undef AT

    check("local-global", begin, COUNT(begin), turns, COUNT(turns));
}

/* As they are made up, roughness grows from level to level, unevenness and errors fall. */
static const struct turn mesh[] = {
    {"the denser",
     JUDGE_HOLDS,
     "corners, 1.025 s: roughness 4, 4.1, 4.2, 4.3 (away from edges 5, 5.1, 5.2, 5.3), "
     "stretch 6, 6.1, 6.2, 6.3; edge, 1.025 s: roughness 8, 8.2, 8.4, 8.6 ",
     {{0}}},
    {"the denser",
     JUDGE_FAILS,
     "roughness 8, 8.2, 8.4, 1 ",
     {{ROUGHNESS, 1, {{"study", "edge"}, {"level", "20x20x2"}}}}},
    {"the denser",
     JUDGE_OPEN,
     "roughness 4, nan, 4.2, 4.3 ",
     {{ROUGHNESS, NAN, {{"study", "corners"}, {"level", "10x10x2"}}}}},
    {"refinement",
     JUDGE_HOLDS,
     "error 9.12, 8.82, 8.52, 8.41 L (error bar 0.05) for 30, 31, 32, 33 ms",
     {{ERROR, 8.41, {{"study", "physics"}, {"level", "20x20x2"}}}}},
    {"refinement", /* by less than two bars */
     JUDGE_OPEN,
     "8.52, 8.43 L",
     {{ERROR, 8.43, {{"study", "physics"}, {"level", "20x20x2"}}}}},
    {"refinement",
     JUDGE_FAILS,
     "8.52, 9 L",
     {{ERROR, 9, {{"study", "physics"}, {"level", "20x20x2"}}}}},
};
static const struct turn degree[] = {
    {"the higher the degree, the more",
     JUDGE_HOLDS,
     "physics, 0.5 s: roughness 12.1, ",
     {{0}}},
    {"the higher the degree, the more",
     JUDGE_FAILS,
     "edge, 1.7 s: roughness 8, 9, 8.4 ",
     {{ROUGHNESS, 9, {{"study", "edge"}, {"level", "p = q = 3"}}}}},
    {"the higher the degree, the smoother",
     JUDGE_HOLDS,
     "corners, 1.7 s: unevenness 8, 7.9, 7.8; ",
     {{0}}},
    {"the higher the degree, the smoother",
     JUDGE_FAILS,
     "physics, 0.5 s: unevenness 1, 23.8, 23.5.",
     {{UNEVENNESS, 1, {{"study", "physics"}, {"level", "p = q = 2"}}}}},
    {"elevation", JUDGE_HOLDS, "error 9.12, 8.82, 8.52 L", {{0}}},
    {"elevation",
     JUDGE_FAILS,
     "error 9.12, 9.3, 8.52 L",
     {{ERROR, 9.3, {{"study", "physics"}, {"level", "p = q = 3"}}}}},
};
#define LEVEL(name, label)                                                                 \
    {                                                                                      \
        {"study", name},                                                                   \
        {                                                                                  \
            "level", label                                                                 \
        }                                                                                  \
    }
static const struct change begin[] = {
    {PLACE, 0.002, {{"level", "elevated, then refined"}, {"at", "0.05"}}},
    {PLACE, 0.003, {{"level", "elevated, then refined"}, {"at", "0.1"}}},
    {PLACE, 0.004, {{"level", "elevated, then refined"}, {"at", "0.2"}}},
};
static const struct turn both[] = {
    {"refinement and elevation both", JUDGE_HOLDS, "edge, 1.7 s: roughness 8.02, ", {{0}}},
    {"refinement and elevation both",
     JUDGE_FAILS,
     "corners, 1.7 s: roughness 4.01, 4, ",
     {{ROUGHNESS, 4, LEVEL("corners", "15x15x2, p = 2")}}},
    {"refinement and elevation both",
     JUDGE_FAILS,
     "roughness 4.01, 4.11, 4, ",
     {{ROUGHNESS, 4, LEVEL("corners", "10x10x2, p = 3")}}},
    {"refinement and elevation both", /* both at once need not be more */
     JUDGE_HOLDS,
     "roughness 4.01, 4.11, 4.21, 4 ",
     {{ROUGHNESS, 4, LEVEL("corners", "15x15x2, p = 3")}}},
    {"elevation makes", JUDGE_HOLDS, "edge, 1.7 s: unevenness 16, 15.8, 15.6, ", {{0}}},
    {"elevation makes",
     JUDGE_FAILS,
     "15.6, 15.9;",
     {{UNEVENNESS, 15.9, LEVEL("edge", "15x15x2, p = 3")}}},
    {"elevation makes", /* what refinement alone does is not its matter */
     JUDGE_HOLDS,
     "edge, 1.7 s: unevenness 16, 17, ",
     {{UNEVENNESS, 17, LEVEL("edge", "15x15x2, p = 2")}}},
    {"refinement and elevation raise", JUDGE_HOLDS, "(error bar 0.05)", {{0}}},
    {"refinement and elevation raise",
     JUDGE_FAILS,
     "error 9.12, 8.82, 9.3, ",
     {{ERROR, 9.3, LEVEL("physics", "10x10x2, p = 3")}}},
    {"refinement and elevation raise",
     JUDGE_OPEN,
     "error 9.12, 9.1, ",
     {{ERROR, 9.1, LEVEL("physics", "15x15x2, p = 2")}}},
    {"Refined",
     JUDGE_HOLDS,
     "4001 unknowns instead of 4000, and motions that differ by 0.002, 0.003, 0.004 L",
     {{0}}},
    {"Refined",
     JUDGE_FAILS,
     "0.002, 0, 0.004 L",
     {{PLACE, 0, {{"study", "orders"}, {"at", "0.1"}}}}},
};
#undef LEVEL

static void nets(void)
{
    check("mesh", NULL, 0, mesh, COUNT(mesh));
    check("degree", NULL, 0, degree, COUNT(degree));
    check("mesh-degree", begin, COUNT(begin), both, COUNT(both));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    solvers();
    local_global();
    nets();
    return check_result();
}
