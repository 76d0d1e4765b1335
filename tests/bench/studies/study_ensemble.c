/* Study ensemble: what is told of made-up distributions, and one small study from end to
 * end, which goes on with what is there.
 *
 *   study_ensemble FOLDER
 */
#include "bench/studies/studies.h"

#include <stdint.h>
#include <sys/stat.h>

#include "bench/truth/truth_parts.h"
#include "tests/study_fixture.h"

enum { LOOKS = 20, TIMES = 4, RUNS = 32, MODEL = STUDY_ENSEMBLE_TRUTHS, COUNT = MODEL + 1 };
enum { DROP, ANGLE, KINETIC = 4 };

/* From 0 to 1; the same every time. */
static double uniform(void)
{
    static uint64_t state = 1;

    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(state >> 11) * 0x1p-53;
}

static double noise(void) /* of standard deviation 1 */
{
    return (uniform() - 0.5) * sqrt(12);
}

/* A motion whose change has grown so far on the truth's two nets from .5 s on, and a number
 * of the coarse net and of the model that is not the fine net's. */
struct made {
    double growth[2];
    int number;
    double net, shift, spread; /* coarse net and model shifted; the model's sd         */
    int runs, died, truth_died;
    bool quick, late; /* late: the horizon is the end                                  */
    const char *want, *want_too;
};

static void fill(const struct made *k, struct study_ensemble *e)
{
    *e = (struct study_ensemble){.scene = "made",
                                 .quick = k->quick,
                                 .runs = k->runs,
                                 .looks = LOOKS,
                                 .fields = TIMES,
                                 .count = COUNT,
                                 .time = malloc(LOOKS * sizeof(double))};
    REQUIRE(e->time);
    for (int t = 0; t < LOOKS; t++)
        e->time[t] = 0.05 * (t + 1);
    for (int n = 0; n < COUNT; n++) {
        struct study_ensemble_one *one = &e->one[n];
        *one = (struct study_ensemble_one){.net = "9x9", .sentence = {""}};
        snprintf(one->title, sizeof one->title, "who %d", n);
        one->died = n == MODEL ? k->died : n ? k->truth_died : 0;
        if (one->died)
            snprintf(one->sentence.text, sizeof one->sentence.text, "died at noon");
        one->lived = k->runs - one->died;
        one->value =
            calloc((size_t)(STUDY_ENSEMBLE_NUMBERS * LOOKS * k->runs), sizeof(double));
        REQUIRE(one->value);
        for (int t = 0; t < TIMES; t++) {
            e->field_time[t] = 0.25 * (t + 1);
            one->growth[t] = t < (k->late ? TIMES - 1 : 1) ? 1 : k->growth[n % 2];
            one->points[t] = 0.01 * (t + 1);
        }
        for (int i = 0; i < STUDY_ENSEMBLE_NUMBERS * one->lived; i++) {
            const int number = i / one->lived, m = i % one->lived;
            const bool it = number == k->number;
            const double by = !it ? 0 : n == MODEL ? k->shift : n ? 0 : k->net;
            const double v = 10 + by + (it && n == MODEL ? k->spread : 1) * noise();
            for (int t = 0; t < LOOKS; t++)
                one->value[(number * LOOKS + t) * k->runs + m] = v + 0.01 * noise();
        }
    }
}

#define GROWN                                                                              \
    {                                                                                      \
        2e3, 2e4                                                                           \
    }
#define CLAIM "\"made: who 2 is right in distribution\": "

static const struct made mades[] = {
    /* clang-format off */
    {GROWN, DROP, 0, 0, 1, RUNS, 0, 0, false, false, CLAIM
     "holds. 0 of 32 runs died; points are 2 % of L off at the horizon, 0.5 s.",
     "| 1.6 | right |"},
    {GROWN, DROP, 0, 1.5, 1, RUNS, 0, 0, false, false, CLAIM "does not hold.", "| wrong |"},
    {GROWN, KINETIC, 0, 0, 3, RUNS, 0, 0, false, false, CLAIM "does not hold.",
     "| wrong |"},
    {GROWN, ANGLE, 0, 0, 0.2, RUNS, 0, 0, false, false, CLAIM "does not hold.",
     "| wrong |"},
    /* The nets differ: near the one is no more right, far from both still wrong. */
    {GROWN, DROP, 2, 0, 1, RUNS, 0, 0, false, false, CLAIM "cannot be judged.",
     "| not told apart |"},
    {GROWN, DROP, 2, 20, 1, RUNS, 0, 0, false, false, CLAIM "does not hold.", "| wrong |"},
    {GROWN, DROP, 0, 0, 1, RUNS, 3, 0, false, false, CLAIM
     "does not hold. 3 of 32 runs died, the first died at noon;", "| died |"},
    {GROWN, DROP, 0, 0, 1, RUNS, 0, 0, true, false,
     "made: distributions are not judged: quick.", "| not judged: quick |"},
    {GROWN, DROP, 0, 0, 1, 1, 0, 0, false, false,
     "made: nothing can be judged: one run has no spread.", "| not judged |"},
    {GROWN, DROP, 0, 0, 1, RUNS, 0, 1, false, false,
     "made: nothing can be judged: the truth died.", "| not judged |"},
    {GROWN, DROP, 0, 0, 1, RUNS, 0, 0, false, true,
     "made: nothing can be judged: the motion ends at its horizon.", "| not judged |"},
    {{400, 300}, DROP, 0, 0, 1, RUNS, 0, 0, false, false,
     "the motion is still predictable, and its points can be compared. By 1 s a change of "
     "1e-06 has grown 4e+02-fold on the truth's 9x9 net and 3e+02-fold on the 9x9 one.",
     "| not judged |"},
    {{400, 3e3}, DROP, 0, 0, 1, RUNS, 0, 0, false, false,
     "made: the truth is not known in distribution: its nets differ about whether the "
     "motion can be predicted.", "| not judged |"},
    /* clang-format on */
};

static void free_made(struct study_ensemble *e)
{
    for (int n = 0; n < e->count; n++)
        free(e->one[n].value);
    free(e->time);
}

static void test_tell(void)
{
    for (size_t n = 0; n < sizeof mades / sizeof *mades; n++) {
        struct study_ensemble e;
        struct study_printed p;
        struct message why = {""};
        fill(&mades[n], &e);
        REQUIRE(study_ensemble_tell(&e, study_folder, TABLE_MARKDOWN, study_print_to(&p),
                                    &why) == STATUS_OK);
        char *text = study_squeeze(study_printed_text(&p));
        study_wants(text, mades[n].want);
        study_wants(text, mades[n].want_too);
        free(text);
        free_made(&e);
    }
}

/* Three windows from the horizon on share the looks behind it, and of each number the worst
 * of them is told: the model is off in the last alone, in four of its looks. */
static void test_windows(void)
{
    struct study_ensemble e;
    struct study_printed p;

    fill(&mades[0], &e);
    for (int k = 0; k < COUNT; k++)
        for (int m = 0; m < RUNS; m++)
            for (int t = 0; t < LOOKS; t++) /* of 32 runs 1 and -1: an error of .1796 */
                e.one[k].value[t * RUNS + m] =
                    (m % 2 ? 1 : -1) + (k == MODEL && t >= 16 ? 2 : 0);
    REQUIRE(study_ensemble_tell(&e, study_folder, TABLE_CSV, study_print_to(&p), NULL) ==
            STATUS_OK);
    char *text = study_printed_text(&p);
    const char *row = strstr(text, "\nmade,who 2,9x9,");
    double n[4] = {0}; /* lived, points, growth, drop */
    CHECK(row &&
          sscanf(row, "\nmade,who 2,9x9,%lf,%lf,%lf,%lf", n, n + 1, n + 2, n + 3) == 4);
    CHECK(n[0] == 32 && n[2] == 2e3);
    CHECK_RELATIVE(n[3], 2 / sqrt(2 * 32.0 / 31 / 32), 1e-5);
    study_wants(text, "3 windows from 0.5 to 1 s");
    free(text);
    free_made(&e);
}

/* Discs have a table of their shadow at the end, with the difference of the truth's nets in
 * its bars: drape coefficients of 60 % +- 1 % in halves, 2 % more on the coarse net, 7 or 8
 * folds. */
static void test_drape(void)
{
    enum { DRAPE = STUDY_ENSEMBLE_NUMBERS - 2, FOLDS };

    for (int disc = 1; disc >= 0; disc--) {
        struct study_ensemble e;
        struct study_printed p;
        fill(&mades[0], &e);
        for (int k = 0; k < COUNT; k++)
            for (int m = 0; m < RUNS; m++)
                for (int t = 0; t < LOOKS; t++) {
                    double *value = e.one[k].value + t * RUNS + m;
                    value[DRAPE * LOOKS * RUNS] =
                        disc ? 0.6 + 0.02 * (k == 0) + (m % 2 ? 0.01 : -0.01) : NAN;
                    value[FOLDS * LOOKS * RUNS] = disc ? 7 + m % 2 : NAN;
                }
        REQUIRE(study_ensemble_tell(&e, study_folder, TABLE_MARKDOWN, study_print_to(&p),
                                    NULL) == STATUS_OK);
        char *text = study_squeeze(study_printed_text(&p));
        if (disc) {
            study_wants(text, "they are 60 +- 2 % and 7.5 +- 0.09 folds.");
            study_wants(text, "| 7: 16, 8: 16 |");
            study_wants(text, "which 66 comparisons");
        } else {
            CHECK(!strstr(text, "folds"));
            study_wants(text, "which 54 comparisons");
        }
        free(text);
        free_made(&e);
    }
}

static void test_directions(void)
{
    double sum[3] = {0}, d[3];

    truth_level_direction(0, d);
    CHECK(d[0] == 1 && d[1] == 1 && d[2] == 1);
    for (int n = 1; n <= 1000; n++) {
        truth_level_direction(n, d);
        CHECK_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 3, 1e-15 * 3 * 4);
        for (int i = 0; i < 3; i++)
            sum[i] += d[i] / 1000;
    }
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(sum[i], 0, 4 / sqrt(1000)); /* components of variance 1: four sigma  */
}

static enum status study(const char *scene, const char *models, double until,
                         struct message *why)
{
    return study_ensemble_measure(&(struct study_ensemble_options){.folder = study_folder,
                                                                   .quick = true,
                                                                   .scene_count = 1,
                                                                   .scene = &scene,
                                                                   .models = models,
                                                                   .runs = 5,
                                                                   .until = until},
                                  why);
}

static ino_t file_of(const char *name)
{
    char path[4096];
    struct stat s;

    snprintf(path, sizeof path, "%s/%s", study_folder, name);
    return stat(path, &s) ? 0 : s.st_ino;
}

/* Differences of 1e-9 m of positions that are rounded to 1e-16 m. */
#define TOL_GROWTH 1e-6

/* Growth of the change at the first time, from the files of four runs on a sheet of 1 m. */
static double growth_of(const char *who)
{
    enum { FIELD = 3 * GRID_POINTS, FEW = 4 };
    static double x[FEW][FIELD];
    double sum = 0;

    for (int m = 0; m < FEW; m++) {
        struct run_result r;
        char path[4096];
        snprintf(path, sizeof path, "%s/edge_drop_%s_%03d.h5", study_folder, who, m);
        REQUIRE(run_result_read(path, true, &r, NULL) == STATUS_OK);
        memcpy(x[m], r.xyz[0], sizeof x[m]);
        run_result_clear(&r);
    }
    for (int a = 0; a < FEW;
         a++) /* of n numbers: half the mean of all squared differences */
        for (int b = 0; b < a; b++)
            for (int n = 0; n < FIELD; n++)
                sum += pow(x[a][n] - x[b][n], 2) / (FEW * (FEW - 1));
    return sqrt(sum / GRID_POINTS) / 1e-6;
}

/* A motion that is still predictable is run four times, pushed by different ways; what is
 * gone is run again, and nothing else. */
static void test_runs(void)
{
    struct message why = {""};
    struct study_printed p;
    char path[4096];

    REQUIRE(study("edge_drop", "triangles", 0.1, &why) == STATUS_OK);
    const ino_t kept = file_of("edge_drop_truth_fine_003.h5");
    CHECK(kept && !file_of("edge_drop_truth_fine_004.h5"));
    snprintf(path, sizeof path, "%s/edge_drop_triangles_000.h5", study_folder);
    REQUIRE(!remove(path));
    REQUIRE(study("edge_drop", "triangles", 0.1, &why) == STATUS_OK);
    CHECK(file_of("edge_drop_truth_fine_003.h5") == kept);
    CHECK(file_of("edge_drop_triangles_000.h5"));
    REQUIRE(study_ensemble_print(study_folder, TABLE_TEXT, study_print_to(&p), &why) ==
            STATUS_OK);
    study_printed_wants(&p, "edge_drop: distributions are not judged: quick.");
    REQUIRE(study_ensemble_print(study_folder, TABLE_CSV, study_print_to(&p), &why) ==
            STATUS_OK);
    char *text = study_printed_text(&p);
    const char *row = strstr(text, "scene,model,time_s,growth,points_over_length\n");
    REQUIRE(row && (row = strstr(row, "\nedge_drop,triangles,0.02,")));
    CHECK_RELATIVE(strtod(row + strlen("\nedge_drop,triangles,0.02,"), NULL),
                   growth_of("triangles"), TOL_GROWTH);
    free(text);
    REQUIRE(study("edge_drop", "triangles", 0.08, &why) == STATUS_OK);
    CHECK(file_of("edge_drop_truth_fine_003.h5") != kept); /* other times are other runs */
}

/* --- What ensembles of numbers say: errors, distances, bounds, against tables and by lot.
 */

/* Tables have so many digits. */
#define TOL_TABLE 1e-6
/* A few operations. */
#define TOL_ROUND 1e-14

enum { LOTS = 400 };

static void test_numbers(void)
{
    static const double value[] = {1, 2, 3, 4, 100};
    static const double want[] = {2, 1, 0, 1, 97};
    double deviation[5];
    double error;

    CHECK_NEAR(distribution_mean(4, value, &error), 2.5, TOL_ROUND);
    CHECK_NEAR(error, sqrt(5.0 / 12), TOL_ROUND);
    CHECK(distribution_mean(1, value, &error) == 1 && isnan(error));
    CHECK(isnan(distribution_mean(0, value, &error)) && isnan(error));
    distribution_deviations(5, value, deviation);
    for (int n = 0; n < 5; n++)
        CHECK(deviation[n] == want[n]);
    distribution_deviations(4, value, deviation); /* the median of four is 2.5 */
    CHECK(deviation[0] == 1.5 && deviation[2] == 0.5);
}

/* Student's t, two-sided (Abramowitz, Stegun 1964, table 26.10, and the normal's). */
static void test_bound(void)
{
    CHECK_NEAR(distribution_bound(1, 2), 12.7062047, TOL_TABLE);
    CHECK_NEAR(distribution_bound(1, 3), 4.3026527, TOL_TABLE);
    CHECK_NEAR(distribution_bound(1, 11), 2.2281389, TOL_TABLE);
    CHECK_NEAR(distribution_bound(1, 32), 2.0395134, TOL_TABLE);
    CHECK_NEAR(distribution_bound(10, 11), 3.5814062, TOL_TABLE);
    CHECK_NEAR(distribution_bound(5, 10001), 2.5763, 1e-3);
    CHECK(isinf(distribution_bound(1, 1)));
}

static void test_apart(void)
{
    static const double a[] = {1, 2, 3, 4}, b[] = {11, 12, 13, 14}, c[] = {5, 5};
    const double error = sqrt(5.0 / 6);

    CHECK_NEAR(distribution_apart(4, a, 4, b, 0), -10 / error, TOL_ROUND);
    CHECK_NEAR(distribution_apart(4, b, 4, a, 0), 10 / error, TOL_ROUND);
    CHECK_NEAR(distribution_apart(4, a, 4, b, 3), -10 / sqrt(5.0 / 6 + 9), TOL_ROUND);
    CHECK(distribution_apart(2, c, 2, c, 0) == 0);
    CHECK(distribution_apart(2, c, 4, a, 0) > 0);
    CHECK(isnan(distribution_apart(1, a, 4, b, 0)));
}

/* Counts how many of LOTS pairs are told apart, whose second is shifted and spread; by
 * means, or by spreads. */
static int told(double shift, double spread, bool by_spread)
{
    const double bound = distribution_bound(1, RUNS);
    double a[RUNS], b[RUNS], da[RUNS], db[RUNS];
    int count = 0;

    for (int lot = 0; lot < LOTS; lot++) {
        for (int n = 0; n < RUNS; n++) {
            a[n] = uniform();
            b[n] = shift + spread * uniform();
        }
        distribution_deviations(RUNS, a, da);
        distribution_deviations(RUNS, b, db);
        count += fabs(by_spread ? distribution_apart(RUNS, da, RUNS, db, 0)
                                : distribution_apart(RUNS, a, RUNS, b, 0)) > bound;
    }
    return count;
}

/* 5 of 100 pairs of one distribution are told apart, four sigma of 400 about that; a mean
 * that is one standard deviation off, and a spread that is twice as wide, nearly always. */
static void test_power(void)
{
    const double sigma = sqrt(LOTS * 0.05 * 0.95);

    for (int by_spread = 0; by_spread < 2; by_spread++)
        CHECK_NEAR(told(0, 1, by_spread), LOTS * 0.05, 4 * sigma);
    CHECK(told(sqrt(1 / 12.0), 1, false) > 0.9 * LOTS);
    CHECK(told(-0.5, 2, true) > 0.9 * LOTS);
    CHECK(told(-0.5, 2, false) < 0.15 * LOTS);
}

int main(int count, char **arguments)
{
    study_begin(count, arguments);
    test_tell();
    test_windows();
    test_drape();
    test_directions();
    test_numbers();
    test_bound();
    test_apart();
    test_power();
    test_runs();
    return check_result();
}
