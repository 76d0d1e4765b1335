/* What the study of iterations says of made-up errors, each sentence each way out.
 *
 *   study_local_global FOLDER
 */
#include "bench/files/folder.h"
#include "bench/studies/study_local_global.h"
#include "tests/said.h"

enum { COUNTS = STUDY_LOCAL_GLOBAL_COUNTS, METHODS = STUDY_LOCAL_GLOBAL_METHODS };

/* Iterations leave first, first / 10, ... of each method; steps take euler and bdf2. */
static struct study_local_global made(const double first[METHODS], double euler,
                                      double bdf2)
{
    struct study_local_global s;

    for (int scene = 0; scene < STUDY_LOCAL_GLOBAL_SCENES; scene++) {
        s.net[scene] = 1e-3, s.bar[scene] = 1e-4;
        for (int n = 0; n < STUDY_LOCAL_GLOBAL_SCHEMES * STUDY_LOCAL_GLOBAL_STEPS; n++) {
            const int scheme = n / STUDY_LOCAL_GLOBAL_STEPS;
            struct study_local_global_motion *m =
                &s.motion[scene][scheme][n % STUDY_LOCAL_GLOBAL_STEPS];
            m->step = scheme == STUDY_LOCAL_GLOBAL_EULER ? euler : bdf2;
            for (int t = 0; t < METHODS * COUNTS; t++) {
                m->left[t / COUNTS][t % COUNTS] =
                    first[t / COUNTS] * pow(10, -(t % COUNTS));
                m->frame[t / COUNTS][t % COUNTS] = 1e-3 * (1 + t % COUNTS);
            }
        }
    }
    return s;
}

static void check_said(const char *folder, const struct study_local_global *s, bool quick,
                       const char *const *sentence)
{
    struct message why = {""};
    struct said said;

    said_open(&said);
    CHECK(study_local_global_tell(s, quick, folder, TABLE_TEXT, said.file, &why) ==
          STATUS_OK);
    said_all(&said, "local_global", sentence);
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2 && folder_make(argv[1], &why) == STATUS_OK);
    const struct study_local_global holds = made((double[]){10, 1, 0.1}, 0.01, 1e-4),
                                    fails = made((double[]){0.1, 1, 1}, 0.01, 0.02),
                                    none = made((double[]){NAN, NAN, NAN}, NAN, NAN);
    check_said(argv[1], &holds, false,
               (const char *[]){
                   "edge_drop, 5 ms: iterations limit, not the step\": holds. 20 plain "
                   "iterations leave 0.1 L, Euler's step takes 0.01 L.",
                   "corners_patch, 5 ms: Chebyshev's acceleration pays\": holds. 50 "
                   "iterations leave 0.001 L for 0.01 L.",
                   "edge_drop, 5 ms: ADMM's weighting pays\": holds. 20 iterations leave "
                   "0.001 L for 0.1 L.",
                   "second order in time pays\": holds. BDF2's step takes 0.0001 L for "
                   "0.01 L.",
                   "  200     5.00", "   20     3.00", NULL});
    check_said(argv[1], &fails, false,
               (const char *[]){"limit, not the step\": does not hold",
                                "Chebyshev's acceleration pays\": does not hold",
                                "ADMM's weighting pays\": does not hold",
                                "second order in time pays\": does not hold", NULL});
    check_said(argv[1], &none, false,
               (const char *[]){"ADMM's weighting pays\": cannot be judged", NULL});
    check_said(argv[1], &holds, true,
               (const char *[]){"acceleration pays\": not judged: quick", NULL});
    return check_result();
}
