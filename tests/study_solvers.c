/* What the study of solvers says of made-up costs, each sentence each way out.
 *
 *   study_solvers FOLDER
 */
#include "bench/files/folder.h"
#include "bench/studies/study_solvers.h"
#include "tests/said.h"

static const struct study_solvers_cost none = {NAN, NAN, NAN, NAN, NAN, NAN};

/* Frames of the direct solver cost unknowns^1.5; of the others `times` that on the first
 * net, growing as unknowns^power. */
static struct study_solvers made(double times, double power, double apart)
{
    static const double unknowns[STUDY_SOLVERS_NETS] = {100, 400, 1600, 6400};
    struct study_solvers s;

    for (int k = 0; k < STUDY_SOLVERS_KINDS; k++)
        for (int m = 0; m < STUDY_SOLVERS_METHODS; m++)
            for (int n = 0; n < STUDY_SOLVERS_NETS; n++) {
                const double u = unknowns[n], first = unknowns[0];
                s.cost[k][m][n] = (struct study_solvers_cost){
                    u,
                    1e-3,
                    m ? times * pow(first, 1.5 - power) * pow(u, power) : pow(u, 1.5),
                    1,
                    5,
                    m ? apart : NAN};
            }
    return s;
}

static void check_said(const char *folder, const struct study_solvers *s, bool quick,
                       const char *const *sentence)
{
    struct message why = {""};
    struct said said;

    said_open(&said);
    CHECK(study_solvers_tell(s, quick, folder, TABLE_TEXT, said.file, &why) == STATUS_OK);
    said_all(&said, "solvers", sentence);
}

int main(int argc, char **argv)
{
    struct message why = {""};
    struct study_solvers s = made(0.5, 1.2, 1e-7);

    REQUIRE(argc == 2 && folder_make(argv[1], &why) == STATUS_OK);
    CHECK_NEAR(study_solvers_growth(&s, STUDY_SOLVERS_PRINTED, STUDY_SOLVERS_DIRECT), 1.5,
               1e-12);
    s.cost[STUDY_SOLVERS_NONLINEAR][STUDY_SOLVERS_FULL][1].step = 1e6;
    check_said(
        argv[1], &s, false,
        (const char *const[]){
            "\"printed, 5x5x2: an iterative solver pays\": holds. The best, CG, last "
            "factor, takes 0.5 of",
            "\"nonlinear, 40x40x2: an iterative solver pays\": holds.",
            "growth of a rebuilt frame below 1.25\": holds. Up to 20x20x2: direct it grows "
            "as "
            "unknowns^1.5,",
            "and with them K and M, as ^1.29.", /* 9, 64, 324 elements */
            "every net\": does not hold.", "the same motion\": holds.", NULL});
    s = made(2, 1.5, 1e-4);
    s.cost[STUDY_SOLVERS_PRINTED][STUDY_SOLVERS_GMRES_ICHOL][2].step = 1;
    check_said(
        argv[1], &s, false,
        (const char *const[]){
            "\"printed, 5x5x2: an iterative solver pays\": does not hold.",
            "\"printed, 20x20x2: an iterative solver pays\": holds. The best, GMRES, "
            "incomplete Cholesky",
            "below 1.25\": does not hold.", "every net\": holds.",
            "the same motion\": does not hold. They differ from the direct one by "
            "0.0001 L",
            NULL});
    check_said(argv[1], &s, true, (const char *const[]){"1.25\": not judged: quick", NULL});
    for (int m = 0; m < STUDY_SOLVERS_METHODS; m++)
        for (int n = 0; n < STUDY_SOLVERS_NETS; n++)
            s.cost[STUDY_SOLVERS_PRINTED][m][n] = s.cost[STUDY_SOLVERS_NONLINEAR][m][n] =
                none;
    check_said(argv[1], &s, false,
               (const char *const[]){"1.25\": cannot be judged.",
                                     "the same motion\": cannot be judged.",
                                     "every net\": cannot be judged.", NULL});
    return check_result();
}
