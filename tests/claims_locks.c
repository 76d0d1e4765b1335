/* Claims of the plans locking and cures on made-up tips (claims_fixture.h): a tip over
 * theory is minus the height of the sheet.
 *
 *   claims_locks FOLDER
 */
#include "tests/claims_fixture.h"

#define OF(study, space)                                                                   \
    {                                                                                      \
        {"study", study},                                                                  \
        {                                                                                  \
            "space", space                                                                 \
        }                                                                                  \
    }
#define AT(space, nu, h)                                                                   \
    {                                                                                      \
        {"space", space}, {"poisson", nu},                                                 \
        {                                                                                  \
            "thickness", h                                                                 \
        }                                                                                  \
    }
#define ROW(study, space, nu)                                                              \
    {                                                                                      \
        {"study", study}, {"space", space},                                                \
        {                                                                                  \
            "poisson", nu                                                                  \
        }                                                                                  \
    }

static void locking(void)
{
    static const char paper[] = "IGA (2,2,1) 10x10x2";
    static const struct change begin[] = {
        {PLACE, -1, {{"poisson", "0"}}},
        {PLACE, -0.83, {{"poisson", "0.3"}}},
        {PLACE, -0.98, AT("IGA (3,3,2) 10x10x3", "0.3", "1 mm")},
        {PLACE, -0.97, AT("hex 10x10x2 incompatible", "0.3", "1 mm")},
        {PLACE, -0.5, AT(paper, "0", "0.1 mm")},
        {PLACE, -0.6, AT(paper, "0", "1 mm")},
        {PLACE, -0.7, AT(paper, "0", "5 mm")},
        {PLACE, -0.8, AT(paper, "0", "20 mm")},
        {PLACE, -0.9, AT(paper, "0", "100 mm")},
    };
    static const struct turn turns[] = {
        {"higher degree", JUDGE_FAILS, "18.1 % farther", {{0}}},
        {"higher degree",
         JUDGE_HOLDS,
         "2.4 % farther",
         {{PLACE, -0.85, AT("IGA (3,3,2) 10x10x3", "0.3", "1 mm")}}},
        {"The paper's space", JUDGE_HOLDS, "0.500 at 0.1 mm, 0.600 at 1 mm,", {{0}}},
        {"The paper's space",
         JUDGE_FAILS,
         "0.550 at 100 mm",
         {{PLACE, -0.55, AT(paper, "0", "100 mm")}}},
        {"No degree", JUDGE_HOLDS, "0.830 for (4,4,1); theory has 0.846", {{0}}},
        {"No degree",
         JUDGE_FAILS,
         "0.950 for (4,4,1)",
         {{PLACE, -0.95, AT("IGA (4,4,1) 10x10x2", "0.3", "1 mm")}}},
        {"Degree 2", JUDGE_HOLDS, "0.980 for degree (3,3,2), 0.970 with", {{0}}},
        {"Degree 2",
         JUDGE_FAILS,
         "0.900 with",
         {{PLACE, -0.9, AT("hex 10x10x2 incompatible", "0.3", "1 mm")}}},
        {"Degree 2",
         JUDGE_OPEN,
         "nan for degree",
         {{PLACE, NAN, AT("IGA (3,3,2) 10x10x3", "0", "1 mm")}}},
    };

    check("locking", begin, COUNT(begin), turns, COUNT(turns));
}

static void cures(void)
{
    static const char plain[] = "IGA (2,2,1), none", last[] = "IGA (3,3,1), selective";
    static const struct change begin[] = {
        {PLACE, -1.01, {{"poisson", "0"}}},
        {PLACE, -1.01, {{"poisson", "0.3"}}},
        {PLACE, -1.01, {{"poisson", "0.49"}}},
        {PLACE, -1, {{"space", "truth"}}},
        {PLACE, -1.001, {{"space", "coarser"}}},
        {PLACE, -1.03, {{"space", "slit"}}},
        {PLACE, -0.7, {{"space", plain}, {"thickness", "1e-3"}}},
        {PLACE, -0.3, {{"space", plain}, {"thickness", "1e-5"}}},
        {COST, 1, {{"study", "frame"}}},
    };
    static const struct turn turns[] = {
        {"A cure is within 2 % of truth on",
         JUDGE_HOLDS,
         "selective 1 %; the truth on a coarser net by nan % (linear), 0.1 % (gamma_10)",
         {{0}}},
        {"A cure is within 2 % of truth on",
         JUDGE_FAILS,
         "reduced 3 %,",
         {{PLACE,
           -0.97,
           {{"study", "gamma_10"},
            {"space", "IGA (2,2,1), reduced"},
            {"poisson", "0.3"},
            {"thickness", "1e-5"}}}}},
        {"A cure is within 2 % of truth at", JUDGE_HOLDS, "selective 1 %; the", {{0}}},
        {"A cure is within 2 % of truth at",
         JUDGE_FAILS,
         "selective 5 %; the",
         {{PLACE, -1.05, OF("gamma_10_thick", last)}}},
        {"At h/L = 0.1",
         JUDGE_HOLDS,
         "falls 5 % too far",
         {{PLACE, -1.05, ROW("linear_thick", last, "0.49")}}},
        {"At h/L = 0.1",
         JUDGE_FAILS,
         "2 % farther than",
         {{PLACE, -1.05, ROW("linear_thick", last, "0.49")},
          {PLACE, -1.02, OF("linear_thick", "slit")}}},
        {"At Gamma", JUDGE_HOLDS, "IGA (2,2,1), none 30 % and 70 %.", {{0}}},
        {"At Gamma",
         JUDGE_FAILS,
         "1 % and 5 %;",
         {{PLACE,
           -1.05,
           {{"study", "gamma_100"}, {"space", last}, {"thickness", "1e-5"}}}}},
        {"A cure costs", JUDGE_HOLDS, "1.00 of the time with IGA (2,2,1), red", {{0}}},
        {"A cure costs", JUDGE_FAILS, "1.30 of", {{COST, 1.3, OF("frame", last)}}},
    };

    check("cures", begin, COUNT(begin), turns, COUNT(turns));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    locking();
    cures();
    return check_result();
}
