/* Study ensemble: what is told of made-up distributions; which runs it makes, that it goes
 * on, and that the number of processes does not reach the results.
 *
 *   study_ensemble FOLDER
 */
#include "bench/studies/study_ensemble.h"

#include <stdint.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/truth/truth_level.h"
#include "tests/study_fixture.h"

enum {
    LOOKS = 20,
    FIELDS = 4,
    RUNS = 32,
    MODEL = STUDY_ENSEMBLE_TRUTHS,
    COUNT = MODEL + 1
};

/* Of a uniform distribution of standard deviation 1; the same every time. */
static double noise(void)
{
    static uint64_t state = 1;

    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return ((double)(state >> 11) * 0x1p-53 - 0.5) * sqrt(12);
}

/* A motion beyond its horizon from .5 s on, and a model that is as given. */
struct made {
    double growth[STUDY_ENSEMBLE_TRUTHS]; /* at .5 s                                   */
    int number;                           /* that is changed:                          */
    double net, shift, spread; /* coarse net and model shifted, the model's sd         */
    int runs, died, truth_died;
    bool quick;
    const char *want, *want_too;
};

static void fill(const struct made *k, struct study_ensemble *e)
{
    *e = (struct study_ensemble){.name = "made",
                                 .quick = k->quick,
                                 .runs = k->runs,
                                 .looks = LOOKS,
                                 .fields = FIELDS,
                                 .count = COUNT,
                                 .time = malloc(LOOKS * sizeof(double))};
    for (int t = 0; t < LOOKS; t++)
        e->time[t] = 0.05 * (t + 1);
    for (int n = 0; n < COUNT; n++) {
        struct study_ensemble_one *one = &e->one[n];
        *one = (struct study_ensemble_one){.lived = k->runs, .net = "9x9"};
        snprintf(one->title, sizeof one->title, "who %d", n);
        one->died = n == MODEL ? k->died : n == STUDY_ENSEMBLE_FINE ? k->truth_died : 0;
        one->lived -= one->died;
        snprintf(one->sentence.text, sizeof one->sentence.text, "died at noon");
        one->value =
            calloc((size_t)(STUDY_ENSEMBLE_NUMBERS * LOOKS * k->runs), sizeof *one->value);
        for (int t = 0; t < FIELDS; t++) {
            e->field_time[t] = 0.25 * (t + 1);
            one->growth[t] = t < 1 ? 1 : t < 2 || n >= MODEL ? k->growth[n % 2] : 2e4;
            if (k->growth[n % 2] < 1e3)
                one->growth[t] = k->growth[n % 2];
            one->points[t] = 0.01 * (t + 1);
        }
        for (int i = 0; i < STUDY_ENSEMBLE_NUMBERS * one->lived; i++) {
            const int number = i / one->lived, m = i % one->lived;
            const bool it = number == k->number;
            const double by = it && n == MODEL                   ? k->shift
                              : it && n == STUDY_ENSEMBLE_COARSE ? k->net
                                                                 : 0;
            const double v = 10 + by + (it && n == MODEL ? k->spread : 1) * noise();
            for (int t = 0; t < LOOKS; t++)
                study_ensemble_values(e, one, number, t)[m] = v + 0.01 * noise();
        }
    }
}

#define GROWN                                                                              \
    {                                                                                      \
        2e3, 2e3                                                                           \
    }

static const struct made mades[] = {
    {GROWN, 0, 0, 0, 1, RUNS, 0, 0, false,
     "beyond its horizon at 0.5 s: of 1 models 1 is right in distribution: who 2, 0 are "
     "not",
     "\"made: who 2 is right in distribution\": holds. Its points are 2 % of L off"},
    {GROWN, STUDY_ENSEMBLE_DROP, 0, 1.5, 1, RUNS, 0, 0, false,
     "0 are right in distribution, 1 is not: who 2",
     "does not hold. Its points are 2 % of L off at the horizon; farthest off: the mean of "
     "drop, +"},
    {GROWN, STUDY_ENSEMBLE_KINETIC, 0, 0, 3, RUNS, 0, 0, false,
     "0 are right in distribution, 1 is not: who 2",
     "farthest off: the spread of kinetic energy, +"},
    {GROWN, STUDY_ENSEMBLE_ANGLE, 0, 0, 0.2, RUNS, 0, 0, false,
     "0 are right in distribution, 1 is not: who 2", "the spread of angle, -"},
    /* The nets differ: near the one is no more right, far from both still wrong. */
    {GROWN, STUDY_ENSEMBLE_DROP, 2, 0, 1, RUNS, 0, 0, false,
     "0 are not, 1 cannot be told from a truth that is itself not sharp: who 2",
     "\"made: who 2 is right in distribution\": cannot be judged."},
    {GROWN, STUDY_ENSEMBLE_DROP, 2, 20, 1, RUNS, 0, 0, false,
     "0 are right in distribution, 1 is not: who 2", "does not hold."},
    {GROWN, 0, 0, 0, 1, RUNS, 3, 0, false, "1 is not: who 2",
     "does not hold. 3 of 32 runs died; the first died at noon."},
    {GROWN, 0, 0, 0, 1, RUNS, 0, 0, true, "made: distributions are not judged: quick.",
     "not judged: quick"},
    {GROWN, 0, 0, 0, 1, 1, 0, 0, false, "one run has no spread", "not judged"},
    {GROWN, 0, 0, 0, 1, RUNS, 0, 1, false, "nothing can be judged: the truth died at noon.",
     "not judged"},
    {{400, 300},
     0,
     0,
     0,
     1,
     RUNS,
     0,
     0,
     false,
     "the motion is still predictable, by 1 s a change of 1e-06 has grown 3e+02-fold; its "
     "points can be compared, as far as its nets agree: to 4 % of L. made: ensembles",
     "not judged"},
    {{400, 3e3},
     0,
     0,
     0,
     1,
     RUNS,
     0,
     0,
     false,
     "not known in distribution: by 1 s a change of 1e-06 has grown 4e+02-fold on the 9x9 "
     "net and 2e+04-fold on the 9x9 one",
     "not judged"},
};

static void test_tell(void)
{
    for (size_t n = 0; n < sizeof mades / sizeof *mades; n++) {
        struct study_ensemble e;
        struct study_printed p;
        struct message why = {""};
        fill(&mades[n], &e);
        REQUIRE(study_ensemble_tell(&e, study_folder, TABLE_TEXT, study_print_to(&p),
                                    &why) == STATUS_OK);
        char *text = study_squeeze(study_printed_text(&p));
        study_wants(text, mades[n].want);
        study_wants(text, mades[n].want_too);
        CHECK(!strncmp(text, "made", 4)); /* the verdict first */
        free(text);
        study_ensemble_clear(&e);
    }
}

/* Nothing comes behind a horizon at the end. */
static void test_late(void)
{
    struct study_ensemble e;
    struct study_printed p;

    fill(&mades[0], &e);
    for (int n = 0; n < COUNT; n++)
        for (int t = 0; t < FIELDS - 1; t++)
            e.one[n].growth[t] = 999;
    REQUIRE(study_ensemble_tell(&e, study_folder, TABLE_TEXT, study_print_to(&p), NULL) ==
            STATUS_OK);
    study_printed_wants(&p,
                        "made: nothing can be judged: the motion ends at its horizon, 1 s");
    study_ensemble_clear(&e);
}

/* A model that is chaotic where the truth is not is named. */
static void test_lost(void)
{
    struct study_ensemble e;
    struct study_printed p;

    fill(&mades[sizeof mades / sizeof *mades - 2], &e);
    e.one[MODEL].growth[FIELDS - 1] = 5e3;
    REQUIRE(study_ensemble_tell(&e, study_folder, TABLE_TEXT, study_print_to(&p), NULL) ==
            STATUS_OK);
    study_printed_wants(&p, "to 4 % of L. Not so of who 2 (5e+03-fold)");
    study_ensemble_clear(&e);
}

/* Three windows from the horizon on share the looks behind it; a mean is of its window. */
static void test_windows(void)
{
    struct study_ensemble_verdict *v = malloc(sizeof *v);
    double mean[RUNS];
    struct study_ensemble e;

    REQUIRE(v);
    fill(&mades[0], &e);
    for (int t = 0; t < LOOKS; t++)
        for (int m = 0; m < RUNS; m++)
            study_ensemble_values(&e, &e.one[MODEL], 0, t)[m] = t + 100.0 * m;
    study_ensemble_judge(&e, v);
    CHECK(v->windows == STUDY_ENSEMBLE_WINDOWS && v->horizon == 1);
    CHECK(v->begin == 0.5 && v->end == e.time[LOOKS - 1]);
    /* looks 11 ... 20: the ends of windows are .6667, .8333 and 1 s */
    static const double want[] = {(10 + 11 + 12) / 3.0, (13 + 14 + 15) / 3.0,
                                  (16 + 17 + 18 + 19) / 4.0};
    for (int w = 0; w < v->windows; w++) {
        CHECK(study_ensemble_window(&e, v, MODEL, 0, w, mean) == RUNS);
        CHECK_NEAR(mean[0], want[w], 1e-12);
        CHECK_NEAR(mean[2], want[w] + 200, 1e-12);
    }
    study_ensemble_clear(&e);
    free(v);
}

/* --- runs --------------------------------------------------------------------------------
 */

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

static enum status choose(const char *folder, const char *scene, const char *models,
                          double until, struct study_ensemble_job *job, struct message *why)
{
    const char *scenes[] = {scene, scene};

    return study_ensemble_choose(
        &(struct experiment_options){.folder = folder,
                                     .quick = true,
                                     .scene_count = strcmp(scene, "flag") ? 1 : 2,
                                     .scene = scenes,
                                     .models = models,
                                     .runs = 2,
                                     .until = until},
        job, why);
}

static void test_refusals(void)
{
    static const struct {
        const char *scene, *models;
        double until;
        const char *want;
    } bad[] = {{"nowhere", "shell_3", 1, "nowhere"},
               {"flag", "shell_3", 1, "flag is given twice"},
               {"edge_drop", "shell_3,nobody", 1, "nobody"},
               {"edge_drop", "shell_3,shell_3", 1, "shell_3 is given twice"},
               {"edge_drop", "shell_3", 0.05, "an ensemble takes 0.08 s at least"},
               {"strip_swing_still", "shell_3", 1, "strip_swing_still"}};
    struct study_ensemble_job job;

    for (size_t n = 0; n < sizeof bad / sizeof *bad; n++) {
        struct message why = {""};
        CHECK(choose(study_folder, bad[n].scene, bad[n].models, bad[n].until, &job, &why) ==
              STATUS_INPUT);
        study_wants(why.text, bad[n].want);
    }
}

/* All numbers and growths of two folders are the same bits. */
static void check_same(const struct study_ensemble_job *a,
                       const struct study_ensemble_job *b)
{
    struct study_ensemble x, y;

    REQUIRE(study_ensemble_read(a, 0, &x, NULL) == STATUS_OK);
    REQUIRE(study_ensemble_read(b, 0, &y, NULL) == STATUS_OK);
    REQUIRE(x.looks == y.looks && x.count == y.count && x.count == COUNT);
    for (int n = 0; n < x.count; n++) {
        const size_t size = (size_t)(STUDY_ENSEMBLE_NUMBERS * x.looks * x.one[n].lived);
        CHECK(x.one[n].lived == 2 && y.one[n].lived == 2);
        CHECK(!memcmp(x.one[n].value, y.one[n].value, size * sizeof(double)));
        CHECK(!memcmp(x.one[n].growth, y.one[n].growth, (size_t)x.fields * sizeof(double)));
        /* pushed, by different ways */
        CHECK(x.one[n].growth[x.fields - 1] > 1e-3 && x.one[n].growth[x.fields - 1] < 1);
    }
    study_ensemble_clear(&x);
    study_ensemble_clear(&y);
}

static void test_runs(void)
{
    struct study_ensemble_job one, two, found;
    struct message why = {""};
    char a[4096], b[4096], path[STUDY_ENSEMBLE_PATH];
    long ran;

    snprintf(a, sizeof a, "%s/one", study_folder);
    snprintf(b, sizeof b, "%s/two", study_folder);
    REQUIRE(choose(a, "edge_drop", "triangles", 0.1, &one, &why) == STATUS_OK);
    REQUIRE(choose(b, "edge_drop", "triangles", 0.1, &two, &why) == STATUS_OK);
    CHECK(study_ensemble_run(&one, 1, &ran, &why) == STATUS_OK && ran == 2 * COUNT);
    CHECK(study_ensemble_run(&two, 3, &ran, &why) == STATUS_OK && ran == 2 * COUNT);
    check_same(&one, &two);

    /* What is gone or damaged is run again, and nothing else. */
    study_ensemble_file(&two, 0, STUDY_ENSEMBLE_FINE, 1, path);
    REQUIRE(!remove(path));
    study_ensemble_file(&two, 0, MODEL, 0, path);
    REQUIRE(!truncate(path, 5000));
    CHECK(study_ensemble_run(&two, 2, &ran, &why) == STATUS_OK && ran == 2);
    check_same(&one, &two);
    CHECK(study_ensemble_run(&two, 2, &ran, &why) == STATUS_OK && ran == 0);

    /* A motion that is still predictable is not run more often than it takes to see so. */
    one.runs = 40;
    REQUIRE(study_ensemble_run_all(&one, 2, &why) == STATUS_OK && one.scene[0].runs == 4);
    one.runs = one.scene[0].runs = 2;
    check_same(&one, &two);

    /* Other times are other runs. */
    REQUIRE(study_ensemble_find(b, &found, &why) == STATUS_OK);
    CHECK(found.runs == 2 && found.scenes == 1 && found.models == 1 && found.quick);
    CHECK(found.model[0] == two.model[0] && found.scene[0].until == two.scene[0].until);
    found.scene[0].until = 0.08;
    found.runs = found.scene[0].runs = 1;
    CHECK(study_ensemble_run(&found, 2, &ran, &why) == STATUS_OK && ran == COUNT);

    struct study_printed p;
    REQUIRE(experiment_print(&study_ensemble_experiment, b, TABLE_TEXT, study_print_to(&p),
                             &why) == STATUS_OK);
    study_printed_wants(&p, "edge_drop: distributions are not judged: quick.");
}

int main(int count, char **arguments)
{
    study_begin(count, arguments);
    test_tell();
    test_late();
    test_lost();
    test_windows();
    test_directions();
    test_refusals();
    test_runs();
    return check_result();
}
