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
#define AT(method, count)                                                                  \
    {                                                                                      \
        {"time", "Euler"}, {"method", method},                                             \
        {                                                                                  \
            "iterations", count                                                            \
        }                                                                                  \
    }
static const struct change local_begin[] = {
    {PLACE, 0.5, AT("plain", "20")},
    {PLACE, 0.5, AT("plain", "50")},
    {PLACE, 0.05, AT("Chebyshev", "50")},
    {PLACE, 0.005, AT("ADMM", "20")},
    {PLACE, 0.01, {{"iterations", "end"}}},
    {PLACE, 0, AT("ADMM", "end")},
    {PLACE, 0.009, {{"time", "BDF2"}, {"step", "5 ms"}, {"iterations", "end"}}},
    {ERROR, 0.001, {{"iterations", "end"}}},
};
static const struct turn local_turns[] = {
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

static void local_global(void)
{
    check("local-global", local_begin, COUNT(local_begin), local_turns, COUNT(local_turns));
}

/* As they are made up, roughness grows from level to level, unevenness and errors fall. */
static const struct turn mesh[] = {
    {"the denser",
     JUDGE_HOLDS,
     "corners, 1.025 s, so: roughness 4, 4.1, 4.2, 4.3 (away from edges 5, 5.1, 5.2, 5.3), "
     "stretch 6, 6.1, 6.2, 6.3; edge, 1.025 s, so: roughness 8, 8.2, 8.4, 8.6 ",
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
     "physics, 0.5 s, so: roughness 12.1, ",
     {{0}}},
    {"the higher the degree, the more",
     JUDGE_FAILS,
     "edge, 1.7 s, not so: roughness 8, 9, 8.4 ",
     {{ROUGHNESS, 9, {{"study", "edge"}, {"level", "p = q = 3"}}}}},
    {"the higher the degree, the smoother",
     JUDGE_HOLDS,
     "corners, 1.7 s, so: unevenness 8, 7.9, 7.8; ",
     {{0}}},
    {"the higher the degree, the smoother",
     JUDGE_FAILS,
     "physics, 0.5 s, not so: unevenness 1, 23.8, 23.5.",
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
    {"refinement and elevation both",
     JUDGE_HOLDS,
     "edge, 1.7 s, so: roughness 8.02, ",
     {{0}}},
    {"refinement and elevation both",
     JUDGE_FAILS,
     "corners, 1.7 s, not so: roughness 4.01, 4, ",
     {{ROUGHNESS, 4, LEVEL("corners", "15x15x2, p = 2")}}},
    {"refinement and elevation both",
     JUDGE_FAILS,
     "roughness 4.01, 4.11, 4, ",
     {{ROUGHNESS, 4, LEVEL("corners", "10x10x2, p = 3")}}},
    {"refinement and elevation both", /* both at once need not be more */
     JUDGE_HOLDS,
     "roughness 4.01, 4.11, 4.21, 4 ",
     {{ROUGHNESS, 4, LEVEL("corners", "15x15x2, p = 3")}}},
    {"elevation makes", JUDGE_HOLDS, "edge, 1.7 s, so: unevenness 16, 15.8, 15.6, ", {{0}}},
    {"elevation makes",
     JUDGE_FAILS,
     "15.6, 15.9;",
     {{UNEVENNESS, 15.9, LEVEL("edge", "15x15x2, p = 3")}}},
    {"elevation makes", /* what refinement alone does is not its matter */
     JUDGE_HOLDS,
     "edge, 1.7 s, so: unevenness 16, 17, ",
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

#define SWINGS(by, name, label)                                                            \
    {                                                                                      \
        TURN, by,                                                                          \
        {                                                                                  \
            {"study", name}, {"thickness", label},                                         \
            {                                                                              \
                "at", "0.4"                                                                \
            }                                                                              \
        }                                                                                  \
    }
#define SHELL(by, label, with)                                                             \
    {                                                                                      \
        TURN, by,                                                                          \
        {                                                                                  \
            {"study", "nonlinear_shell"}, {"thickness", label}, {"net", with},             \
            {                                                                              \
                "at", "0.6"                                                                \
            }                                                                              \
        }                                                                                  \
    }
static const struct change cloak_begin[] = {
    SWINGS(10, "printed", "1 mm"),
    SWINGS(8, "printed", "5 mm"),
    SWINGS(16, "printed_better", "1 mm"),
    SWINGS(11, "printed_better", "5 mm"),
    SWINGS(30, "incremental", "1 mm"),
    SWINGS(28, "incremental", "5 mm"),
    SHELL(40.5, "1 mm", "coarse"),
    SHELL(42, "1 mm", "fine"),
    SHELL(35, "5 mm", "coarse"),
    SHELL(34, "5 mm", "fine"),
    {SUNK, 0.12, {{"study", "linear"}, {"thickness", "1 mm"}}},
    {SUNK, 0.012, {{"study", "linear"}, {"thickness", "5 mm"}}},
};

static const struct turn cloak[] = {
    {"the thinner",
     JUDGE_HOLDS,
     "printed, so: 10.0 degrees at 1 mm, 8.0 at 5 mm; printed_better, so: 16.0 degrees "
     "at 1 "
     "mm, 11.0 at 5 mm; incremental, so: 30.0 ",
     {{0}}},
    {"the thinner",
     JUDGE_FAILS,
     "incremental, not so: 27.0 degrees at 1 mm, 28.0 ",
     {SWINGS(27, "incremental", "1 mm")}},
    {"A thinner",
     JUDGE_HOLDS,
     "42.0 degrees at 1 mm, by 34.0 at 5 mm; its nets differ by up to 1.5.",
     {{0}}},
    {"A thinner",
     JUDGE_FAILS,
     "by 20.0 degrees at 1 mm",
     {SHELL(20, "1 mm", "fine"), SHELL(20, "1 mm", "coarse")}},
    {"A thinner", JUDGE_OPEN, "up to 4.5.", {SHELL(37.5, "1 mm", "coarse")}},
    {"The cloak", JUDGE_HOLDS, "10 times as far (0.12 m and 0.012 m)", {{0}}},
    {"The cloak",
     JUDGE_FAILS,
     "15 times as far",
     {{SUNK, 0.008, {{"study", "linear"}, {"thickness", "5 mm"}}}}},
    {"The paper's",
     JUDGE_HOLDS,
     "6.0 degrees farther and the thick one 3.0; on the paper's they differ by 2.0.",
     {{0}}},
    {"The paper's",
     JUDGE_FAILS,
     "1.0 degrees farther",
     {SWINGS(11, "printed_better", "1 mm")}},
};

static const struct change layers_begin[] = {
    {FINEST, 0.005, {{"study", "cloak"}, {"at", "0.4"}}},
    {FINEST, 0.001, {{"study", "cloak"}, {"at", "0.2"}}},
    {FINEST, 0.002, {{"study", "cloak"}, {"at", "0.6"}}},
    {FINEST, 0.003, {{"study", "cloak"}, {"at", "0.8"}}},
    {FINEST, 0.01, {{"study", "better"}, {"at", "0.2"}}},
    {FINEST, 0.02, {{"study", "better"}, {"at", "0.4"}}},
    {FINEST, 0.03, {{"study", "better"}, {"at", "0.6"}}},
    {FINEST, 0.02, {{"study", "better"}, {"at", "0.8"}}},
    {TIP, 0.85, {{"study", "plate"}, {"level", "r = 1"}}},
    {TIP, 0.98, {{"study", "plate"}, {"level", "r = 2"}}},
    {TIP, 0.99, {{"study", "plate"}, {"level", "r = 3"}}},
};

static const struct turn layers[] = {
    {"little",
     JUDGE_HOLDS,
     "up to 0.005 m apart (RMSE), of degree 4 in the plane r = 1 and r = 2 up to 0.03 "
     "m",
     {{0}}},
    {"little",
     JUDGE_FAILS,
     "up to 0.06 m",
     {{FINEST, 0.06, {{"study", "better"}, {"at", "0.4"}}}}},
    {"little",
     JUDGE_OPEN,
     "up to nan m",
     {{FINEST, NAN, {{"study", "better"}, {"at", "0.4"}}}}},
    {"considering", JUDGE_HOLDS, "10, 11, 12 ms", {{0}}},
    {"considering",
     JUDGE_FAILS,
     "10, 9, 12 ms",
     {{COST, 9, {{"study", "cloak"}, {"level", "r = 2"}}}}},
    {"Little", JUDGE_HOLDS, "15 % with r = 1, 2 % with r = 2 and 1 % with r = 3", {{0}}},
    {"Little",
     JUDGE_FAILS,
     "15 % with r = 3",
     {{TIP, 1.15, {{"study", "plate"}, {"level", "r = 3"}}}}},
};
#undef SWINGS
#undef SHELL

static void thickness(void)
{
    check("thickness", cloak_begin, COUNT(cloak_begin), cloak, COUNT(cloak));
    check("thickness-degree", layers_begin, COUNT(layers_begin), layers, COUNT(layers));
}

/* A thousandth more than in theory, of the creep two; orders 0 and 1. */
static int timestep_begin(struct change *change)
{
    static const char *const
        mu[] = {"0.2", "1/3", "0.5", "0.7"},
        *const dt[] = {"10 ms", "2.5 ms", "5 ms", "1.25 ms"},
        *const at[] = {"0.5", "0.75", "1"}, *const young[] = {"4e7 Pa", "2e7 Pa", "8e7 Pa"},
        *const step[] = {"10 ms", "5 ms", "2.5 ms", "1.25 ms", "0.625 ms"};
    static const double value[] = {0.2, 1 / 3., 0.5, 0.7};
    struct change *c = change;

    for (int n = 0; n < 24; n++) {
        const char *const m = mu[n / 6], *const s = dt[n / 3 % 2], *const t = at[n % 3];
        const double time = strtod(t, NULL), half = 0.5; /* sheets are 2 m long */
        const double a = (1 + value[n / 6]) / (2 * (1 - value[n / 6]));
        *c++ = (struct change){PLACE,
                               -half * (1.001 * a * time * time / 2 + 0.3 * time),
                               {{"scheme", "printed"}, {"mu", m}, {"dt", s}, {"at", t}}};
        *c++ =
            (struct change){PLACE,
                            -half * 1.001 * a * strtod(s, NULL) * 1e-3 * time,
                            {{"scheme", "incremental"}, {"mu", m}, {"dt", s}, {"at", t}}};
    }
    for (int n = 0; n < 6; n++) {
        const char *const e = young[n < 4 ? 0 : n - 3], *const s = dt[n < 4 ? n : 2];
        const double sag = 4e5 / strtod(e, NULL);
        *c++ = (struct change){PLACE, -sag / 2, {{"study", "sag"}, {"young", e}}};
        for (int t = 0; t < 2; t++)
            *c++ = (struct change){
                PLACE,
                -1.002 * sag / (strtod(s, NULL) * 1e-3) * strtod(at[t], NULL) / 2,
                {{"study", "creep"}, {"young", e}, {"dt", s}, {"at", at[t]}}};
    }
    for (int n = 0; n < 5; n++) {
        const double size = strtod(step[n], NULL);
        *c++ = (struct change){NEXT, 1, {{"step", step[n]}}};
        *c++ = (struct change){DROP, 0.5, {{"step", step[n]}}};
        *c++ =
            (struct change){NEXT, size, {{"study", "nonlinear_rate"}, {"step", step[n]}}};
        *c++ = (struct change){
            NEXT, pow(size, 1.5), {{"study", "nonlinear_mass"}, {"step", step[n]}}};
        *c++ = (struct change){DEATH, 0.1, {{"study", "printed_mass"}, {"step", step[n]}}};
    }
    *c++ = (struct change){PLACE, 0.1, {{"study", "nonlinear_rate"}, {"step", "0.625 ms"}}};
    return (int)(c - change);
}

static const struct turn steps[] = {
    {"one damping", JUDGE_HOLDS, "drops 0.500 L by 0.4 s at 10 ms and 0.5000 L", {{0}}},
    {"one damping",
     JUDGE_FAILS,
     "drops 8.000 L by 0.4 s at 10 ms and 0.5000 L at 0.625 ms, as dt^1.10; the "
     "incremental one as dt^0.00.",
     {{DROP, 8, {{"study", "nonlinear_scale"}, {"step", "10 ms"}}},
      {DROP, 4, {{"study", "nonlinear_scale"}, {"step", "5 ms"}}}}},
    {"implicit integration does",
     JUDGE_FAILS,
     "by 1, 1, 1, 1 L at 0.4 s, as dt^0.00; its largest stretch is ",
     {{0}}},
    {"implicit integration does",
     JUDGE_HOLDS,
     "by 8, 4, 1, 1 L at 0.4 s, as dt^",
     {{NEXT, 8, {{"study", "printed_scale"}, {"step", "10 ms"}}},
      {NEXT, 4, {{"study", "printed_scale"}, {"step", "5 ms"}}}}},
    {"implicit integration is",
     JUDGE_FAILS,
     "dies at 5 of 5 steps, after 0.1, 0.1, 0.1, 0.1, 0.1 s",
     {{0}}},
    {"implicit integration is",
     JUDGE_HOLDS,
     "dies at 0 of 5 steps.",
     {{DEATH, NAN, {{"study", "printed_mass"}}}}},
    {"The printed sheet",
     JUDGE_HOLDS,
     "(2 (1 - mu)) to 1.0e-03, whatever the step, and incremental with that times the "
     "step for a speed; a loaded cantilever creeps by its elastic sag every step to "
     "2.0e-03",
     {{0}}},
    {"The printed sheet",
     JUDGE_FAILS,
     "every step to 5.0e-01",
     {{PLACE, -0.02, {{"study", "sag"}, {"young", "2e7 Pa"}}}}},
    {"The printed sheet",
     JUDGE_FAILS,
     "(2 (1 - mu)) to ",
     {{PLACE, 0, {{"scheme", "incremental"}, {"mu", "0.7"}, {"at", "1"}}}}},
    {"An elastic",
     JUDGE_HOLDS,
     "has order 1.00, C = 2 M order 1.50, and at 0.625 ms their motions are 0.1 L",
     {{0}}},
    {"An elastic",
     JUDGE_FAILS,
     "are 3 L apart, where 2.5 L may be left",
     {{PLACE, 3, {{"study", "nonlinear_rate"}, {"step", "0.625 ms"}}}}},
    {"An elastic",
     JUDGE_FAILS,
     "C = 2 M order 0.00",
     {{NEXT, 1, {{"study", "nonlinear_mass"}}}}},
    {"An incremental", JUDGE_FAILS, "as dt^0.00, and its stretch", {{0}}},
    {"An incremental",
     JUDGE_HOLDS,
     "as dt^",
     {{NEXT, 8, {{"study", "incremental_mass"}, {"step", "10 ms"}}},
      {NEXT, 4, {{"study", "incremental_mass"}, {"step", "5 ms"}}}}},
};

static void timestep(void)
{
    static struct change first[128];

    check("timestep", first, timestep_begin(first), steps, COUNT(steps));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    solvers();
    local_global();
    nets();
    thickness();
    timestep();
    return check_result();
}
