/* The engine of studies: differences, errors, orders and metrics from result files, levels
 * that die or are refused, truth found again. */
#include "bench/experiment/study_print.h"

#include "bench/files/folder.h"
#include "bench/files/store_read.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"

/* Files keep positions as 32-bit floats: 6e-8 of 1 m. */
static const double TOL_STORED = 1e-7;

static const char *folder;

static double *field(const char *name, int frame)
{
    struct store_read *file = NULL;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    char path[4096];

    snprintf(path, sizeof path, "%s/%s.h5", folder, name);
    REQUIRE(xyz && store_read_open(path, &file, NULL) == STATUS_OK);
    REQUIRE(store_read_frame(file, frame, xyz, NULL) == STATUS_OK);
    store_read_close(file);
    return xyz;
}

static double rmse(const char *a, const char *b, int frame)
{
    double *x = field(a, frame), *y = field(b, frame), value = metric_rmse(x, y);

    free(x);
    free(y);
    return value;
}

static void measure(const struct study *study)
{
    const struct experiment_options options = {
        .folder = folder, .quick = true, .repeats = 1};
    struct message why = {""};

    if (!CHECK(study_measure(study, &options, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
}

/* A plate so light that the truth is Kirchhoff's; the shell converges to it. */
static const struct study_level light_levels[] = {
    {"6x6", "6", "shell", {"discretization.points=[6,6]"}, 1 / 4.},
    {"10x10", "10", "shell", {"discretization.points=[10,10]"}, 1 / 8.},
    {"18x18", "18", "shell", {"discretization.points=[18,18]"}, 1 / 16.},
};
static const double light_times[] = {0.05, 0.1};
static const struct study light = {
    .name = "light",
    .caption = "a light plate",
    .scene = "cantilever_transient",
    .settings = {"material.density=1e-4"},
    .numerics = {"discretization.kinematics=linear", "time.step=0.0005"},
    .count = 3,
    .levels = light_levels,
    .times = 2,
    .time = light_times,
    .truth = true};

static void against_truth(void)
{
    struct study_result r;
    struct message why = {""};

    measure(&light);
    REQUIRE(study_read(&light, folder, &r, &why) == STATUS_OK);
    CHECK(r.length == 1 && r.gamma < TRUTH_GAMMA && strstr(r.truth->source, "Kirchhoff"));
    for (int t = 0; t < 2; t++) {
        const struct study_frame *a = &r.row[0].frame[t], *b = &r.row[1].frame[t];
        const struct study_frame *c = &r.row[2].frame[t];
        CHECK_NEAR(a->next, rmse("light_6", "light_10", t), TOL_STORED);
        CHECK_NEAR(b->next, rmse("light_10", "light_18", t), TOL_STORED);
        CHECK_NEAR(a->finest, rmse("light_6", "light_18", t), TOL_STORED);
        CHECK(b->finest == b->next && isnan(c->finest) && isnan(c->next));
        CHECK(c->error < b->error && b->error < a->error);
        CHECK(study_order(&light, &r, t) > 1); /* p = 2: two, once waves are resolved */
        CHECK(r.true_frame[t].drop > 0 && r.true_frame[t].roughness > 0);
        CHECK_RELATIVE(c->drop, r.true_frame[t].drop, 0.05); /* as the errors above */
    }
    CHECK(r.row[0].unknowns == 3 * (36 - 12)); /* two rows of six are held */
    CHECK(r.row[1].milliseconds > 0);
    CHECK_RELATIVE(r.row[1].seconds, r.row[1].milliseconds * 1e-3 * 200, 1e-9);
    study_result_clear(&r);
}

static const struct study_level rough_levels[] = {
    {"calm", "calm", NULL, {"discretization.points=[5,5,2]"}, 1 / 3.},
    {"wild",
     "wild", /* Ren et al. 2024, Table 4 row 7: over at 0.28 s */
     NULL,
     {"material.density=0.1", "material.young=5e4", "damping.value=0.9"},
     1 / 8.},
    {"odd", "odd", NULL, {"discretization.remedy=incompatible"}, 1 / 8.},
};
static const double rough_times[] = {0.05, 0.35};
static const struct study rough = {.name = "rough",
                                   .caption = "levels that end badly",
                                   .scene = "edge_drop",
                                   .count = 3,
                                   .levels = rough_levels,
                                   .times = 2,
                                   .time = rough_times};

static void deaths_and_refusals(void)
{
    struct study_result r;
    char text[8192] = "";
    FILE *file = tmpfile();

    measure(&rough);
    REQUIRE(file &&
            study_print_all(&rough, folder, TABLE_TEXT, file, &r, NULL) == STATUS_OK);
    CHECK(!r.truth && isnan(r.row[0].frame[0].error));
    CHECK(r.row[1].frame[0].xyz && !r.row[1].frame[1].xyz);
    CHECK(strstr(r.row[2].refused, "no remedy") && !r.row[2].frame[0].xyz);
    CHECK_NEAR(r.row[0].frame[0].next, rmse("rough_calm", "rough_wild", 0), TOL_STORED);
    CHECK(isnan(r.row[0].frame[1].next)); /* nobody else lives */
    CHECK(isnan(study_order(&rough, &r, 0)));
    rewind(file);
    REQUIRE(fread(text, 1, sizeof text - 1, file) > 0);
    CHECK(strstr(text, r.row[1].outcome) && strstr(text, "no remedy"));
    fclose(file);
    study_result_clear(&r);
    CHECK(study_read(&rough, "/nowhere", &r, NULL) == STATUS_FILE);
    CHECK(!r.row[0].frame[0].xyz); /* all clear after a failure */
}

/* Orders of errors C h^2 and of differences from the finest C h^3. */
static void orders(void)
{
    struct study_result r = {0};
    struct truth truth = {0};
    struct study study = {.count = 3, .levels = light_levels, .times = 1};

    for (int n = 0; n < 3; n++) {
        r.row[n].frame[0].error = 0.3 * pow(light_levels[n].size, 2);
        r.row[n].frame[0].finest = n < 2 ? 0.2 * pow(light_levels[n].size, 3) : NAN;
    }
    CHECK_NEAR(study_order(&study, &r, 0), 3, 1e-12);
    r.truth = &truth;
    CHECK_NEAR(study_order(&study, &r, 0), 2, 1e-12);
    r.row[1].frame[0].error = NAN; /* two points are no evidence of an order */
    CHECK(isnan(study_order(&study, &r, 0)));
}

/* What a quick shell left is found again without running; an empty folder says so. */
static void truth_again(void)
{
    static const char *const settings[] = {"damping={kind: none}"};
    const double time[] = {0.01};
    struct truth *first = NULL, *again = NULL;
    struct message why = {""};
    char kept[4096], *path = NULL;

    snprintf(kept, sizeof kept, "%s/kept", folder);
    REQUIRE(folder_make(kept, NULL) == STATUS_OK);
    for (int n = 0; n < 2; n++) { /* of an earlier run of this test */
        snprintf(kept, sizeof kept, "%s/kept/truth_shell_%s.h5", folder,
                 n ? "p3_16_1250us" : "p3_36_625us");
        remove(kept);
    }
    snprintf(kept, sizeof kept, "%s/kept", folder);
    REQUIRE(scene_file_find("edge_drop", &path, NULL) == STATUS_OK);
    CHECK(truth_find(path, 1, settings, 1, time, kept, TRUTH_READ, &again, &why) ==
          STATUS_FILE);
    CHECK(strstr(why.text, "truth_shell") && !again);
    REQUIRE(truth_find(path, 1, settings, 1, time, kept, TRUTH_QUICK, &first, &why) ==
            STATUS_OK);
    REQUIRE(truth_find(path, 1, settings, 1, time, kept, TRUTH_READ, &again, &why) ==
            STATUS_OK);
    CHECK(!memcmp(first->xyz[0], again->xyz[0], 3 * GRID_POINTS * sizeof(double)));
    CHECK(first->error[0] == again->error[0] && !strcmp(first->source, again->source));
    truth_destroy(first);
    truth_destroy(again);
    free(path);
}

/* Words for verdicts: a number of every level, and whether it rises or falls throughout. */
static void trends(void)
{
    struct study_result r = {0};
    struct study study = {.count = 3, .levels = light_levels, .times = 2};
    const size_t drop = offsetof(struct study_frame, drop);
    struct study_trend trend;

    for (int n = 0; n < 3; n++) {
        r.row[n].frame[1].drop = 0.5 + n;
        r.row[n].frame[0].drop = n == 1 ? 7 : 2 - n;
    }
    trend = study_print_trend(&study, &r, 1, drop);
    CHECK(trend.sign == 1 && !strcmp(trend.text, "0.5, 1.5, 2.5"));
    CHECK(study_print_trend(&study, &r, 0, drop).sign == 0);
    r.row[1].frame[0].drop = 1;
    CHECK(study_print_trend(&study, &r, 0, drop).sign == -1);
    r.row[1].frame[1].drop = NAN; /* a level that died proves nothing */
    trend = study_print_trend(&study, &r, 1, drop);
    CHECK(trend.sign == 0 && !strcmp(trend.text, "0.5, died, 2.5"));
}

static void verdicts(void)
{
    char text[256] = "";
    FILE *file = tmpfile();

    REQUIRE(file);
    study_print_verdict(file, "more is more", false, "%d is less than %d.", 1, 2);
    rewind(file);
    REQUIRE(fread(text, 1, sizeof text - 1, file) > 0);
    CHECK(!strncmp(text, "- \"more is more\": does not hold. 1 is less than 2.\n", 50));
    fclose(file);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    orders();
    verdicts();
    trends();
    truth_again();
    deaths_and_refusals();
    against_truth();
    return check_result();
}
