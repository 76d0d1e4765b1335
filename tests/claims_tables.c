/* Claims of the paper's tables turned round (claims_fixture.h).
 *
 *   claims_tables FOLDER
 */
#include "tests/claims_fixture.h"

#define OF(study_, model_, net_)                                                           \
    {                                                                                      \
        {"study", study_}, {"model", model_},                                              \
        {                                                                                  \
            "net", net_                                                                    \
        }                                                                                  \
    }
static const struct change of_table1[] = {
    {PLACE, 0.3, OF("printed", "hex", "10x10x2")},
    {PLACE, 0.2, OF("printed", "hex", "16x16x2")},
    {PLACE, 0.1, OF("printed", "hex", "24x24x2")},
    {PLACE, 0.03, OF("printed", "hex", "32x32x2")},
    {PLACE, 0.02, OF("printed", "hex incompatible", "10x10x2")},
    {COST, 1, {{"study", "printed"}}},
    {COST, 170, OF("printed", "hex", "32x32x2")},
    {COST, 1.5, OF("printed", "shell", "10x10")},
    {COST, 2, OF("printed", "hex incompatible", "10x10x2")},
    {PAPER, 91, OF("printed", "iga", "10x10x2")},
    {PAPER, 16048, OF("printed", "hex", "32x32x2")},
    {PAPER, 130, OF("printed", "shell", "10x10")},
    {ERROR, 0.03, {{"study", "static"}}},
    {ERROR, 0.05, OF("static", "iga", "10x10x2")},
};

static void table1(void)
{
    static const struct turn turns[] = {
        {"Hexahedra come", JUDGE_HOLDS, "first at 32x32x2; 32x32x2 is up to 0.03 L", {{0}}},
        {"Hexahedra come",
         JUDGE_FAILS,
         "first at 24x24x2",
         {{PLACE, 0.01, OF("printed", "hex", "24x24x2")}}},
        {"Hexahedra come",
         JUDGE_FAILS,
         "first at no net; 32x32x2 is up to 0.05 L away",
         {{PLACE, 0.05, {{"study", "printed"}, {"model", "hex"}}}}},
        {"Hexahedra come",
         JUDGE_OPEN,
         "up to nan L",
         {{PLACE, NAN, OF("printed", "hex", "32x32x2")}}},
        {"That mesh costs", JUDGE_HOLDS, "170 times here, 176 in the paper", {{0}}},
        {"That mesh costs",
         JUDGE_FAILS,
         "10 times here",
         {{COST, 10, OF("printed", "hex", "32x32x2")}}},
        {"IGA is cheaper", JUDGE_HOLDS, "1.5 times here, 1.43 in the paper", {{0}}},
        {"IGA is cheaper",
         JUDGE_FAILS,
         "0.9 times here",
         {{COST, 0.9, OF("printed", "shell", "10x10")}}},
        {"Hexahedra of the same",
         JUDGE_HOLDS,
         "0.03 off at rest, for 2 times the cost of IGA, which is 0.05 off",
         {{0}}},
        {"Hexahedra of the same",
         JUDGE_FAILS,
         "for 0.6 times",
         {{COST, 0.6, OF("printed", "hex incompatible", "10x10x2")}}},
        {"Hexahedra of the same",
         JUDGE_OPEN,
         "0.09 off",
         {{ERROR, 0.09, OF("static", "hex incompatible", "10x10x2")}}},
        {"Both meshes", JUDGE_HOLDS, "IGA 10x10x2 is 0.05 off", {{0}}},
        {"Both meshes",
         JUDGE_FAILS,
         "hexahedra 32x32x2 0.996",
         {{ERROR, 0.996, OF("static", "hex", "32x32x2")}}},
        {"Hexahedra that do not lock",
         JUDGE_HOLDS,
         "10x10x2 is up to 0.02 L away, 40x40x2 up to 0 L",
         {{0}}},
        {"Hexahedra that do not lock",
         JUDGE_FAILS,
         "40x40x2 up to 0.13 L",
         {{PLACE, 0.13, OF("printed", "hex incompatible", "40x40x2")}}},
    };

    check("table1", of_table1, COUNT(of_table1), turns, COUNT(turns));
}
#undef OF

/* Nets of 50, 200, 450 and 800 points: at first all grows as their square. */
static void table2(void)
{
#define OF(study_)                                                                         \
    {                                                                                      \
        {"study", study_},                                                                 \
        {                                                                                  \
            "kinematics", "printed"                                                        \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {COST, 1, OF("fig12a")},     {COST, 16, OF("fig12b")},
        {COST, 81, OF("fig12c")},    {COST, 256, OF("fig12d")},
        {PAPER, 10, OF("fig12a")},   {PAPER, 82, OF("fig12b")},
        {PAPER, 408, OF("fig12c")},  {PAPER, 1281, OF("fig12d")},
        {ASSEMBLE, 1, OF("fig12a")}, {ASSEMBLE, 4, OF("fig12b")},
        {ASSEMBLE, 9, OF("fig12c")}, {ASSEMBLE, 16, OF("fig12d")},
        {FACTOR, 1, OF("fig12a")},   {FACTOR, 64, OF("fig12b")},
        {FACTOR, 729, OF("fig12c")}, {FACTOR, 4096, OF("fig12d")},
        {COST, 55, OF("fig13c")},    {PAPER, 276, OF("fig13c")},
        {COST, 10, OF("fig9")},      {PAPER, 403, OF("fig9")},
        {COST, 10, OF("fig15")},     {PAPER, 405, OF("fig15")},
        {COST, 0.6, OF("fig7")},
    };
    static const struct turn turns[] = {
        {"A frame grows as", JUDGE_HOLDS, "Exponent 2 here, 1.98 in the paper", {{0}}},
        {"A frame grows as",
         JUDGE_FAILS,
         "with the smallest net 1.5",
         {{COST, 8, OF("fig12b")}, {COST, 27, OF("fig12c")}, {COST, 64, OF("fig12d")}}},
        {"A frame grows faster", JUDGE_HOLDS, "K and M 1, a frame 2, the factor 3", {{0}}},
        {"A frame grows faster",
         JUDGE_FAILS,
         "the factor 1.5",
         {{FACTOR, 8, OF("fig12b")},
          {FACTOR, 27, OF("fig12c")},
          {FACTOR, 64, OF("fig12d")}}},
        {"A frame grows faster",
         JUDGE_FAILS,
         "K and M 2.5",
         {{ASSEMBLE, 32, OF("fig12b")},
          {ASSEMBLE, 243, OF("fig12c")},
          {ASSEMBLE, 1024, OF("fig12d")}}},
        {"Contact", JUDGE_HOLDS, "1 times here, 0.995 in the paper", {{0}}},
        {"Contact", JUDGE_FAILS, "5.2 times here", {{COST, 52, OF("fig9")}}},
        {"Degree 4", JUDGE_HOLDS, "3.44 times here, 3.37 in the paper", {{0}}},
        {"Degree 4", JUDGE_FAILS, "4 times here", {{COST, 64, OF("fig13c")}}},
        {"A frame of Fig. 7", JUDGE_OPEN, "0.6 ms here", {{0}}},
    };
#undef OF

    check("table2", begin, COUNT(begin), turns, COUNT(turns));
}

static void table3(void)
{
#define OF(degree_, net_)                                                                  \
    {                                                                                      \
        {"degree", degree_}, {"net", net_},                                                \
        {                                                                                  \
            "kinematics", "printed"                                                        \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {COST, 10, {{"degree", "(1,2,2)"}}},    {COST, 21, OF("(1,3,3)", "2x10x10")},
        {COST, 17, OF("(1,3,3)", "2x15x15")},   {PAPER, 83, OF("(1,2,2)", "2x10x10")},
        {PAPER, 408, OF("(1,2,2)", "2x15x15")}, {PAPER, 173, OF("(1,3,3)", "2x10x10")},
        {PAPER, 680, OF("(1,3,3)", "2x15x15")},
    };
    static const struct turn turns[] = {
        {"Degree (1,3,3) costs 2.1", JUDGE_HOLDS, "2.1 times here, 2.08 in the", {{0}}},
        {"Degree (1,3,3) costs 2.1",
         JUDGE_FAILS,
         "3 times here",
         {{COST, 30, OF("(1,3,3)", "2x10x10")}}},
        {"Degree (1,3,3) costs 1.7", JUDGE_HOLDS, "1.7 times here, 1.67 in the", {{0}}},
        {"Degree (1,3,3) costs 1.7",
         JUDGE_FAILS,
         "2.2 times here",
         {{COST, 22, OF("(1,3,3)", "2x15x15")}}},
    };
#undef OF

    check("table3", begin, COUNT(begin), turns, COUNT(turns));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    table1();
    table2();
    table3();
    return check_result();
}
