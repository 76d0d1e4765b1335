/* The engine of studies: plans with levels, differences, errors, orders and metrics from
 * result files, levels that die or are refused, truth found again. */
#include "bench/experiment/dataset.h"
#include "bench/experiment/batch.h"
#include "bench/experiment/judge.h"
#include "bench/experiment/study.h"
#include "bench/experiment/plan.h"

#include "bench/files/folder.h"
#include "bench/files/store.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"
#include "tests/fresh.h"

/* Files keep positions as 32-bit floats: 6e-8 of 1 m. */
static const double TOL_STORED = 1e-7;

static const char *folder;

/* A plan of this text, written where results go. */
static struct plan plan_of(const char *name, const char *text)
{
    struct message why = {""};
    struct plan plan;
    char path[4096];

    snprintf(path, sizeof path, "%s/%s.yaml", folder, name);
    FILE *file = fopen(path, "w");
    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
    if (!CHECK(plan_read(path, &plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
    return plan;
}

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

/* A study by its name; NULL: there is none. */
static const struct study *study_of(const struct study_results *r, const char *name)
{
    for (int n = 0; n < r->count; n++)
        if (!strcmp(r->study[n].plan->name, name))
            return &r->study[n];
    return NULL;
}

static void measure(const struct plan *plan)
{
    const struct measurement_options options = {.quick = true};
    struct message why = {""};

    if (!CHECK(study_measure(plan, folder, &options, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
}

/* A plate so light that the truth is Kirchhoff's; the shell converges to it. */
static const char *const light =
    "name: light\nsource: a light plate\nscene: cantilever_transient\nmodel: shell\n"
    "settings: {material.density: 1e-4, discretization.kinematics: linear,\n"
    "           time.step: 0.0005}\n"
    "levels:\n"
    "  - {label: 6x6, name: \"6\", size: 0.25, settings: {discretization.points: [6,6]}}\n"
    "  - {label: 10x10, name: \"10\", size: 0.125,\n"
    "     settings: {discretization.points: [10,10]}}\n"
    "  - {label: 18x18, name: \"18\", size: 0.0625,\n"
    "     settings: {discretization.points: [18,18]}}\n"
    "times: [0.05, 0.1]\ntruth: true\ntimed: 1\n";

static void against_truth(void)
{
    struct plan plan = plan_of("light", light);
    struct study_results all;
    struct message why = {""};

    measure(&plan);
    REQUIRE(study_read(&plan, folder, &all, &why) == STATUS_OK);
    const struct study *s = study_of(&all, "light");
    REQUIRE(s && all.count == 1 && !study_of(&all, "heavy"));
    CHECK(s->length == 1 && s->gamma < TRUTH_GAMMA);
    REQUIRE(s->truth && strstr(s->truth->source, "Kirchhoff"));
    for (int t = 0; t < 2; t++) {
        const struct study_frame *a = &s->row[0].frame[t], *b = &s->row[1].frame[t];
        const struct study_frame *c = &s->row[2].frame[t];
        CHECK_NEAR(a->next, rmse("light_6", "light_10", t), TOL_STORED);
        CHECK_NEAR(b->next, rmse("light_10", "light_18", t), TOL_STORED);
        CHECK_NEAR(a->finest, rmse("light_6", "light_18", t), TOL_STORED);
        CHECK(b->finest == b->next && isnan(c->finest) && isnan(c->next));
        CHECK(c->error < b->error && b->error < a->error);
        CHECK(study_order(s, t) > 1); /* p = 2: two, once waves are resolved */
        CHECK(s->row[3].frame[t].drop > 0 && s->row[3].frame[t].roughness > 0);
        CHECK_RELATIVE(c->drop, s->row[3].frame[t].drop, 0.05); /* as the errors above */
    }
    CHECK(s->row[0].result.unknowns == 3 * (36 - 12)); /* two rows of six are held */
    CHECK(s->row[1].milliseconds > 0);
    CHECK_RELATIVE(s->row[1].seconds, s->row[1].milliseconds * 1e-3 * 200, 1e-9);
    study_clear(&all);
    plan_clear(&plan);
}

/* The second: Ren et al. 2024, Table 4 row 7, which dies. No truth is claimed so late for
 * the flag. */
static const char *const rough =
    "name: rough\nsource: levels that end badly\nscene: edge_drop\n"
    "model: iga_paper\nlevels:\n"
    "  - {label: calm, settings: {discretization.points: [5,5,2]}}\n"
    "  - {label: wild, settings: {material.density: 0.1, material.young: 5e4,\n"
    "                             damping.value: 0.9}}\n"
    "  - {label: odd, settings: {discretization.remedy: incompatible}}\n"
    "times: [0.05, 0.35]\ntimed: 1\n"
    "studies:\n"
    "  - {name: rough, caption: levels that end badly}\n"
    "  - {name: late, scene: flag, settings: {damping: {kind: none}},\n"
    "     truth: true, times: [0.5],\n"
    "     levels: [{label: Flat Sheet, settings: {discretization.points: [4,4,2]}}]}\n"
    "  - {name: scaled, truth: true, times: [0.05],\n"
    "     levels: [{label: coarse, settings: {discretization.points: [4,4,2]}}]}\n";

static void deaths_and_refusals(void)
{
    struct plan plan = plan_of("rough", rough);
    struct study_results all;
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    measure(&plan);
    REQUIRE(file && study_read(&plan, folder, &all, NULL) == STATUS_OK);
    REQUIRE(dataset_print(&all, folder, TABLE_TEXT, file, NULL) == STATUS_OK);
    fclose(file);
    const struct study *s = study_of(&all, "rough"), *late = study_of(&all, "late");
    const struct study_row *row = s->row;
    CHECK(!s->truth && isnan(row[0].frame[0].error));
    CHECK(row[1].frame[0].xyz && !row[1].frame[1].xyz && row[1].milliseconds > 0);
    CHECK(run_result_refused(&row[2].result) && !row[2].frame[0].xyz);
    CHECK_NEAR(row[0].frame[0].next, rmse("rough_calm", "rough_wild", 0), TOL_STORED);
    CHECK(isnan(row[0].frame[1].next)); /* nobody else lives */
    CHECK(isnan(study_order(s, 0)));
    CHECK(strstr(text, "died at t = 0.265 s") && strstr(text, "remedy=incompatible: "));
    CHECK(!late->truth && strstr(text, "Truth of late: none; no truth is claimed"));
    CHECK(!strcmp(late->plan->levels[0].name, "flat_sheet"));
    /* A factor a step has no limit: the shell's own steps would be damped otherwise. */
    CHECK(!study_of(&all, "scaled")->truth && strstr(text, "scaled by a factor each"));
    free(text);
    study_clear(&all);
    CHECK(study_read(&plan, "/proc/nowhere", &all, NULL) == STATUS_FILE);
    CHECK(!all.study); /* all clear after a failure */
    plan_clear(&plan);
}

/* Three levels without a run. */
static struct study bare(const struct plan *plan)
{
    static struct study_row row[3];
    struct study s = {.plan = &plan->studies[0], .frames = 2, .row = row};

    memset(row, 0, sizeof row);

    for (int n = 0; n < 3; n++)
        s.row[n].level = &plan->studies[0].levels[n];
    return s;
}

/* Orders of errors C h^2 and of differences from the finest C h^3. */
static void orders(void)
{
    struct plan plan = plan_of("light", light);
    struct study s = bare(&plan);
    struct truth truth = {0};

    for (int n = 0; n < 3; n++) {
        const double h = s.row[n].level->size;
        s.row[n].frame[0].error = 0.3 * pow(h, 2);
        s.row[n].frame[0].finest = n < 2 ? 0.2 * pow(h, 3) : NAN;
    }
    CHECK_NEAR(study_order(&s, 0), 3, 1e-12);
    s.truth = &truth;
    CHECK_NEAR(study_order(&s, 0), 2, 1e-12);
    s.row[1].frame[0].error = NAN; /* two points are no evidence of an order */
    CHECK(isnan(study_order(&s, 0)));
    plan_clear(&plan);
}

static void writes(const struct study_results *d, const char *at, const char *want)
{
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    REQUIRE(file);
    dataset_write(d, QUANTITY_DROP, WHERE({"at", at}), file);
    fclose(file);
    CHECK(!strcmp(text, want));
    free(text);
}

/* Words for sentences: a number of every level. */
static void words(void)
{
    struct plan plan = plan_of("light", light);
    struct study s = bare(&plan);
    s.time = s.plan->times;
    const struct study_results d = {.plan = &plan, .count = 1, .study = &s};

    for (int n = 0; n < 3; n++) {
        s.row[n].frame[1].drop = 0.5 + n;
        s.row[n].frame[0].drop = 7 - n;
    }
    writes(&d, "*", "7, 0.5, 6, 1.5, 5, 2.5");
    s.row[0].frame[1].drop = s.row[1].frame[1].drop = NAN;
    s.row[0].result.outcome = STATUS_UNSUPPORTED;
    s.row[1].frame[0].xyz = &s.length; /* lives, and has a number */
    writes(&d, "0.1", "refused, died, 2.5");
    s.row[1].frame[1].xyz = &s.length; /* lives, without this number */
    writes(&d, "0.1", "refused, nan, 2.5");
    writes(&d, "0.3", "");
    plan_clear(&plan);
}

/* At rest: a flat plate only bends, as 1/h^2 under its own weight. A quick run of a plan
 * with times for it is read as such, also where a level is refused. */
static void rest_and_quick(void)
{
    struct plan plan =
        plan_of("statics",
                "name: statics\nsource: statics\nscene: cantilever\nmodel: shell_linear\n"
                "settings: {discretization.points: [6,6]}\n"
                "levels:\n"
                "  - {label: thin, settings: {sheet.thickness: 0.001}}\n"
                "  - {label: thick, settings: {sheet.thickness: 0.005},\n"
                "     quick: {sheet.thickness: 0.004}}\n"
                "  - {label: odd, settings: {discretization.points: [2,2]}}\n"
                "studies:\n"
                "  - {name: rest}\n"
                "  - {name: motion, times: [0.01, 0.02], quick_times: [0.005]}\n");
    struct study_results all;

    judge_mark(folder, true);
    measure(&plan);
    REQUIRE(study_read(&plan, folder, &all, NULL) == STATUS_OK);
    const struct study *rest = study_of(&all, "rest"), *moved = study_of(&all, "motion");
    CHECK(all.quick && rest->frames == 1 && !rest->time &&
          isnan(rest->row[0].milliseconds));
    REQUIRE(rest->row[0].frame[0].xyz && rest->row[1].frame[0].xyz);
    CHECK(!rest->row[0].frame[1].xyz && run_result_refused(&moved->row[2].result));
    CHECK_RELATIVE(rest->row[0].frame[0].drop / rest->row[1].frame[0].drop, 16.0, 1e-4);
    CHECK(moved->frames == 1 && moved->time[0] == 0.005 && moved->row[0].frame[0].xyz);
    study_clear(&all);
    plan_clear(&plan);
}

/* Cases put together one by one: each its own file, settings and result. */
static void batches(void)
{
    static const char *const name[] = {"small", "large"};
    static const char *const net[] = {"discretization.points=[3,3,2]",
                                      "discretization.points=[4,4,2]"};
    static const double unknowns[] = {3 * (18 - 6), 3 * (32 - 8)}; /* less the held row */
    const struct measurement_options options = {.quick = true};
    const struct contestant *who;
    struct batch b;
    struct message why;
    char files[4096];

    snprintf(files, sizeof files, "%s/batch/of/two", folder);
    REQUIRE(contestant_find("iga_linear", &who, &why) == STATUS_OK);
    REQUIRE(batch_init(&b, files, 2) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        struct measurement_case *c =
            batch_add(&b, SOURCE_DIR "/models/scenes/edge_drop.yaml", who, name[n]);
        CHECK(c == &b.cases[n] && c->timed == MEASUREMENT_UNTIMED && !c->repeats);
        CHECK(c->plan.contestant == who && c->plan.settings == batch_settings(&b));
        CHECK(c->keep.fields == RUN_FIELDS_NONE && !strcmp(c->keep.file, b.files[n]));
        settings_set(batch_settings(&b), net[n]);
        c->plan.end = 0.005;
    }
    CHECK(b.count == 2 && batch_run(&b, &options, &why) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        struct run_result r;
        char path[8192];
        snprintf(path, sizeof path, "%s/%s.h5", files, name[n]);
        CHECK(!strcmp(b.files[n], path));
        REQUIRE(batch_read(&b, n, true, &r, &why) == STATUS_OK);
        CHECK(r.unknowns == unknowns[n] && r.frames == 0 && r.quick);
        run_result_clear(&r);
    }
    free(b.files[0]); /* memory did not last for its name */
    b.files[0] = NULL;
    CHECK(batch_run(&b, &options, &why) == STATUS_MEMORY);
    batch_clear(&b);
    CHECK(!b.count && !b.cases);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    fresh_folder(folder);
    batches();
    orders();
    words();
    rest_and_quick();
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", SOURCE_DIR "/tests/truths", 1));
    deaths_and_refusals(); /* by a truth that ends early */
    REQUIRE(!unsetenv("CLOTHBENCH_TRUTHS"));
    against_truth();
    return check_result();
}
