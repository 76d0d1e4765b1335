/* A truth made: every number of its table anew from the runs it is made of, whose field it
 * is, and until when it is claimed; truths that need no making; and the same bits each
 * time. The nets are far too coarse for a truth. */
#include "bench/truth/truth.h"

#include "bench/files/folder.h"
#include "bench/files/store_read.h"
#include "bench/truth/truth_bar.h"
#include "bench/truth/truth_file.h"
#include "bench/truth/truth_make.h"
#include "bench/truth/truth_plate.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "tests/truth_fixture.h"

static const double SUM = 1e-14, DIGITS = 1e-12;
static const double LENGTH = 2;

static char folder[2048];

static const char *const long_sheet[] = {"damping={kind: none}", "sheet.length=2"};

static char *path_of(const char *scene)
{
    char *path = NULL;

    REQUIRE(scene_file_find(scene, &path, NULL) == STATUS_OK);
    return path;
}

static char *file_of(const char *name)
{
    static char file[4096];

    snprintf(file, sizeof file, "%s/%s", folder, name);
    return file;
}

static void copy(const char *from, const char *to)
{
    static char bytes[1 << 16];
    FILE *in = fopen(file_of(from), "rb"), *out = fopen(file_of(to), "wb");
    size_t count;

    REQUIRE(in && out);
    while ((count = fread(bytes, 1, sizeof bytes, in)) > 0)
        REQUIRE(fwrite(bytes, 1, count, out) == count);
    REQUIRE(!fclose(in) && !fclose(out));
}

/* --- The table. */

static const struct truth_plan tiny = {
    NULL, 0.04, 0.2, {{2, {5, 6, 8}, 5e-3}, {3, {5, 7, 8}, 5e-3}}};
enum { TIMES = 2 };
static const double times[TIMES] = {0.02, 0.04};

static struct truth_runs runs_of(const char *path, const struct settings *settings)
{
    return (struct truth_runs){path, settings, TIMES, times, folder, true};
}

/* The runs of one model, as its ladder says: coarse, middle, fine, twice the step, four
 * times. */
static void read_family(const struct truth_runs *runs, enum truth_model model,
                        struct run_result run[5])
{
    const struct truth_ladder *l = &tiny.ladder[model];
    static const int net[5] = {0, 1, 2, 1, 1}, step[5] = {1, 1, 1, 2, 4};

    for (int n = 0; n < 5; n++) {
        struct truth_level level = {model, l->degree, l->side[net[n]], step[n] * 5e-3,
                                    false};
        memset(&run[n], 0, sizeof run[n]);
        REQUIRE(truth_level_find(runs, &level, true, &run[n], NULL) == STATUS_OK);
    }
}

/* The rms of a pair's differences up to a time, and the one there. */
static double so_far(const struct run_result run[5], const int pair[2], int t, double *now)
{
    double sum = 0;

    for (int n = 0; n <= t; n++) {
        *now = metric_rmse(run[pair[0]].xyz[n], run[pair[1]].xyz[n]);
        sum += *now * *now / (t + 1);
    }
    return sqrt(sum);
}

/* Order and bar of three runs at a time, from their differences up to then. */
static struct truth_order of_three(const struct run_result run[5], const int pair[2][2],
                                   const double h[3], double promised, int t)
{
    double now;
    const double first = so_far(run, pair[0], t, &now),
                 second = so_far(run, pair[1], t, &now);
    struct truth_order o = truth_order(h, first, second, promised);

    o.bar *= fmax(1, now / second);
    return o;
}

/* Of a model at a time: promised is what its splines can do in bending. */
static void check_model(const struct run_result run[5], const double spans[3],
                        double promised, int t, const double *value)
{
    const double h[3] = {1 / spans[0], 1 / spans[1], 1 / spans[2]}, step[3] = {4, 2, 1};
    static const int nets[2][2] = {{0, 1}, {1, 2}}, steps[2][2] = {{4, 3}, {3, 1}};
    const struct truth_order space = of_three(run, nets, h, promised, t);
    const struct truth_order time = of_three(run, steps, step, 2, t);

    CHECK((isnan(value[0]) && isnan(space.order)) || fabs(value[0] - space.order) < 1e-9);
    CHECK_NEAR(value[1], time.order, 1e-9); /* of halving, in other units */
    CHECK_RELATIVE(value[2], space.bar + time.bar, 1e-9);
    CHECK(space.bar > 0 && time.bar > 0);
}

static void check_table(const struct truth_runs *runs, const struct truth_made *made)
{
    struct run_result solid[5], shell[5], pushed = {0};
    struct truth_level push = {TRUTH_SOLID, 2, 6, 0.01, true};

    read_family(runs, TRUTH_SOLID, solid);
    read_family(runs, TRUTH_SHELL, shell);
    REQUIRE(truth_level_find(runs, &push, true, &pushed, NULL) == STATUS_OK);
    for (int t = 0; t < TIMES; t++) {
        const double *v = made->value[t];
        check_model(solid, (double[]){3, 4, 6}, 2, t, v + TRUTH_SOLID_SPACE);
        check_model(shell, (double[]){2, 4, 5}, 4, t, v + TRUTH_SHELL_SPACE);
        CHECK_RELATIVE(v[TRUTH_DIFFERENCE], metric_rmse(solid[2].xyz[t], shell[2].xyz[t]),
                       SUM);
        CHECK_RELATIVE(v[TRUTH_GROWTH],
                       metric_rmse(solid[3].xyz[t], pushed.xyz[t]) / (1e-6 * LENGTH), SUM);
        const double bar =
            v[made->level.model == TRUTH_SOLID ? TRUTH_SOLID_BAR : TRUTH_SHELL_BAR];
        CHECK(v[TRUTH_ERROR] == fmax(bar, v[TRUTH_DIFFERENCE]) &&
              made->time[t] == times[t]);
        const struct run_result *whose =
            made->level.model == TRUTH_SOLID ? &solid[2] : &shell[2];
        CHECK(!memcmp(made->xyz[t], whose->xyz[t], 3 * GRID_POINTS * sizeof(double)));
    }
    for (int n = 0; n < 5; n++)
        run_result_clear(&solid[n]), run_result_clear(&shell[n]);
    run_result_clear(&pushed);
}

static void make(const struct truth_runs *runs, struct truth_made *made)
{
    struct scene scene = {0};
    struct message why = {""};

    REQUIRE(settings_read_scene(runs->settings, runs->path, &scene, NULL) == STATUS_OK);
    if (!CHECK(truth_make(&tiny, runs, &scene, &(struct truth_make_how){0}, made, &why) ==
               STATUS_OK))
        printf("%s\n", why.text);
    scene_clear(&scene);
}

/* How far the watched change grew: the coarse solid, twice the step, two tenths. */
static double watched(const struct truth_runs *runs)
{
    struct truth_level level = {TRUTH_SOLID, 2, 5, 0.01, false};
    struct truth_runs far = *runs;
    struct run_result run[2] = {{0}};
    double most = 0;

    far.time = (const double[]){0.1, 0.2};
    for (int n = 0; n < 2; n++) {
        level.perturbed = n;
        REQUIRE(truth_level_find(&far, &level, true, &run[n], NULL) == STATUS_OK);
    }
    for (int t = 0; t < 2; t++)
        most = fmax(most, metric_rmse(run[0].xyz[t], run[1].xyz[t]) / (1e-6 * LENGTH));
    run_result_clear(&run[0]);
    run_result_clear(&run[1]);
    return most;
}

/* A budget that ends between the runs: what was made is kept, and the next is named. */
static void check_budget(const struct truth_runs *runs)
{
    struct scene scene = {0};
    struct truth_made made;
    struct message why = {""};
    const struct truth_make_how how = {NULL, 1e-9};

    REQUIRE(settings_read_scene(runs->settings, runs->path, &scene, NULL) == STATUS_OK);
    CHECK(truth_make(&tiny, runs, &scene, &how, &made, &why) == STATUS_FAILED && !made.xyz);
    if (!CHECK(strstr(why.text, "no: after 2 of 10 runs in ") &&
               strstr(why.text, "p = 2, 6x6, 10 ms, takes some ")))
        printf("%s\n", why.text);
    scene_clear(&scene);
}

static void check_made(const struct truth_runs *runs)
{
    struct truth_made made;
    char want[256];

    make(runs, &made);
    check_table(runs, &made);
    CHECK(made.times == TIMES && made.claimed == TIMES);
    const bool solid = made.level.model == TRUTH_SOLID;
    CHECK(made.level.side == 8 && made.level.degree == (solid ? 2 : 3));
    CHECK(strstr(made.note, solid ? "p = 2, 8x8, step 5 ms; error bar: its own"
                                  : "p = 3, 8x8, step 5 ms; error bar: its own"));
    CHECK(strstr(made.note, solid ? "shell, p = 3, 8x8, 5 ms" : "solid, p = 2, 8x8, 5 ms"));
    snprintf(
        want, sizeof want,
        "a change of gravity by 1e-06 grows at most %.2g-fold up to 0.2 s: so long the "
        "motion can be predicted (solid, 5x5, step 10 ms)",
        watched(runs));
    if (!CHECK(!strcmp(made.horizon, want)))
        printf("%s\n%s\n", made.horizon, want);
    truth_made_clear(&made);
}

/* The changed runs exchanged for those of another net: a change that has grown at once. */
static void check_lost(const struct truth_runs *runs)
{
    struct truth_made made;

    remove(file_of("truth_iga_p2_6_10000us_perturbed.h5"));
    remove(file_of("truth_iga_p2_5_10000us_perturbed.h5"));
    struct truth_level level = {TRUTH_SOLID, 2, 4, 0.01, true};
    struct run_result run = {0};
    struct truth_runs far = *runs;
    far.time = (const double[]){0.1, 0.2};
    REQUIRE(truth_level_find(runs, &level, false, &run, NULL) == STATUS_OK);
    run_result_clear(&run);
    copy("truth_iga_p2_4_10000us_perturbed.h5", "truth_iga_p2_6_10000us_perturbed.h5");
    REQUIRE(truth_level_find(&far, &level, false, &run, NULL) == STATUS_OK);
    run_result_clear(&run);
    copy("truth_iga_p2_4_10000us_perturbed.h5", "truth_iga_p2_5_10000us_perturbed.h5");
    make(runs, &made);
    CHECK(made.value[1][TRUTH_GROWTH] > 1e3 &&
          made.claimed == 0 + (made.value[0][TRUTH_GROWTH] <= 1e3));
    if (!CHECK(strstr(made.horizon, "has grown") &&
               strstr(made.horizon, "-fold at 0.1 s: from there on the motion cannot be")))
        printf("%s\n", made.horizon);
    truth_made_clear(&made);
}

/* --- The same bits, made elsewhere at another time. */

static void read_sum(const char *file, const struct truth_runs *runs,
                     const struct truth_made *made, char sum[17])
{
    struct store_read *f = NULL;
    char *text = NULL;

    REQUIRE(truth_file_write(file, runs, made, NULL) == STATUS_OK);
    REQUIRE(store_read_open(file, &f, NULL) == STATUS_OK);
    REQUIRE(store_read_text(f, "/", "checksum", &text, NULL) == STATUS_OK);
    snprintf(sum, 17, "%s", text);
    free(text);
    store_read_close(f);
}

static void check_bits(const struct truth_runs *runs)
{
    struct truth_runs again = *runs;
    struct truth_made made;
    char sum[3][17], other[4096];

    make(runs, &made);
    read_sum(file_of("one.h5"), runs, &made, sum[0]);
    truth_made_clear(&made);
    snprintf(other, sizeof other, "%s/again", folder);
    REQUIRE(folder_make(other, NULL) == STATUS_OK);
    again.folder = other;
    make(&again, &made);
    read_sum(file_of("two.h5"), runs, &made, sum[1]);
    made.xyz[0][4711] += 1e-6;
    read_sum(file_of("two.h5"), runs, &made, sum[2]);
    truth_made_clear(&made);
    CHECK(strlen(sum[0]) == 16 && !strcmp(sum[0], sum[1]) && strcmp(sum[0], sum[2]));
}

/* --- Truths that nothing is made for. */

static enum status find(const char *scene, int count, const char *const *text, int n,
                        const double *time, enum truth_effort effort, struct truth **t)
{
    char *path = path_of(scene);
    struct settings s = settings_of(count, text);
    const enum status st = truth_find(path, &s, n, time, folder, effort, t, NULL);

    settings_clear(&s);
    free(path);
    return st;
}

/* The plate, where the load is light: what linear theory and Kirchhoff leave is its bar. */
static void check_plate(void)
{
    static const char *const light[] = {"gravity=[0,0,-0.001]", "damping={kind: none}"};
    static const char *const heavy[] = {"gravity=[0,0,-0.03]", "damping={kind: none}"};
    struct truth *t = NULL;
    struct truth_plate plate;
    struct scene scene;
    struct settings s = settings_of(2, light);
    char *path = path_of("cantilever_transient");

    REQUIRE(settings_read_scene(&s, path, &scene, NULL) == STATUS_OK);
    const double gamma = scene_gamma(&scene), ratio = scene.thickness / scene.length;
    REQUIRE(truth_plate_init(&plate, &scene, TIMES, times, NULL) == STATUS_OK);
    CHECK(gamma > 0.001 && gamma < 0.09);
    REQUIRE(find("cantilever_transient", 2, light, TIMES, times, TRUTH_READ, &t) ==
            STATUS_OK);
    for (int n = 0; n < TIMES; n++) {
        CHECK(metric_rmse(t->xyz[n], plate.xyz[n]) == 0 && t->time[n] == times[n]);
        CHECK_RELATIVE(t->error[n],
                       (1e-5 + 0.0125 * gamma * gamma + 2 * ratio * ratio) *
                           metric_rmse(plate.xyz[n], plate.rest),
                       DIGITS);
    }
    CHECK(strstr(t->source, "Kirchhoff plate"));
    truth_destroy(t), t = NULL;
    CHECK(30 * gamma > 0.09); /* of the heavy one: beyond linear theory */
    CHECK(find("cantilever_transient", 2, heavy, TIMES, times, TRUTH_READ, &t) ==
          STATUS_FILE);
    truth_plate_clear(&plate);
    scene_clear(&scene);
    settings_clear(&s);
    free(path);
}

/* The shell elsewhere: its bar is the difference of two runs; who only reads gets the finer
 * pair, if an earlier call left it. */
static void check_shell(void)
{
    static const double time[1] = {0.005};
    struct settings s = settings_of(2, long_sheet);
    char *path = path_of("edge_drop");
    struct truth_runs runs = {path, &s, 1, time, folder};
    struct truth_level level[2] = {{TRUTH_SHELL, 3, 16, 0.00125, false},
                                   {TRUTH_SHELL, 3, 12, 0.0025, false}};
    struct run_result run[2] = {{0}};
    struct truth *t = NULL;

    CHECK(find("edge_drop", 2, long_sheet, 1, time, TRUTH_READ, &t) == STATUS_FILE);
    REQUIRE(find("edge_drop", 2, long_sheet, 1, time, TRUTH_QUICK, &t) == STATUS_OK);
    for (int n = 0; n < 2; n++)
        REQUIRE(truth_level_find(&runs, &level[n], true, &run[n], NULL) == STATUS_OK);
    CHECK(metric_rmse(t->xyz[0], run[0].xyz[0]) == 0);
    CHECK(t->error[0] > 0 && t->error[0] == metric_rmse(run[0].xyz[0], run[1].xyz[0]));
    CHECK(strstr(t->source, "16x16, step 1.25 ms; error bar: its difference from 12x12, "
                            "2.5 ms"));
    truth_destroy(t), t = NULL;
    copy("truth_shell_p3_16_1250us.h5", "truth_shell_p3_36_625us.h5");
    copy("truth_shell_p3_12_2500us.h5", "truth_shell_p3_24_1250us.h5");
    REQUIRE(find("edge_drop", 2, long_sheet, 1, time, TRUTH_READ, &t) == STATUS_OK);
    CHECK(strstr(t->source, "36x36, step 0.625 ms") && strstr(t->source, "24x24, 1.25 ms"));
    truth_destroy(t), t = NULL;
    REQUIRE(find("edge_drop", 2, long_sheet, 1, time, TRUTH_FULL, &t) == STATUS_OK);
    CHECK(strstr(t->source, "36x36"));
    truth_destroy(t);
    for (int n = 0; n < 2; n++)
        run_result_clear(&run[n]);
    settings_clear(&s);
    free(path);
}

/* --- Plans. */

/* Frames and snapshots that all steps meet; of these, those that are judged. */
static void check_plans(void)
{
    double snapshots[] = {0, 0.05, 0.06, 0.1, 0.14, 0.3, 0.32};
    const struct scene scene = {.snapshot_count = 7, .snapshots = snapshots};
    const double judged[] = {0.06, 0.1, 0.14, 0.2, 0.3};
    struct truth_plan plan = {NULL, 0.3, 1, {{2, {5}, 5e-3}, {2, {5}, 2.5e-3}}};
    double *time = NULL;
    const int count = truth_plan_times(0.31, truth_plan_longest(&plan), &scene, &time);
    int found = 0;

    CHECK(count == 15);
    for (int n = 0; n < count; n++) {
        CHECK_NEAR(time[n], 0.02 * (n + 1), SUM);
        if (truth_plan_judges(&scene, time[n]) && CHECK(found < 5))
            CHECK_NEAR(time[n], judged[found++], SUM);
    }
    CHECK(found == 5);
    free(time);
    CHECK(truth_plan_times(0.31, 0.01, &scene, &time) == 16); /* 0.05, too */
    free(time);
}

/* How the truths that are stored were made: another plan is another truth. */
static void check_plan(const char *scene, bool quick, const char *want)
{
    const struct truth_plan p = truth_plan_of(scene, quick);
    const struct truth_ladder *a = &p.ladder[TRUTH_SOLID], *b = &p.ladder[TRUTH_SHELL];
    char got[256];

    snprintf(got, sizeof got, "%g s, %g s, %d: %d %d %d, %g ms, %d: %d %d %d, %g ms",
             p.until, p.watch, a->degree, a->side[0], a->side[1], a->side[2], 1e3 * a->step,
             b->degree, b->side[0], b->side[1], b->side[2], 1e3 * b->step);
    if (!CHECK(!strcmp(got, want)))
        printf("%s: %s\n", scene, got);
}

static void check_stored_plans(void)
{
    check_plan("edge_drop", false, "2 s, 2 s, 3: 16 24 36, 2.5 ms, 5: 16 24 32, 2.5 ms");
    check_plan("flag", false, "0.6 s, 0.8 s, 3: 12 18 27, 5 ms, 5: 10 14 18, 5 ms");
    check_plan("corners_patch", false, "0.3 s, 1 s, 3: 13 23 33, 5 ms, 3: 13 23 33, 5 ms");
    check_plan("sphere", false, "0.3 s, 0.3 s, 2: 8 11 15, 2.5 ms, 3: 9 12 16, 2.5 ms");
    for (int n = 0; n < 3; n++)
        check_plan((const char *[]){"strip_swing", "thick", "stiff"}[n], false,
                   "0.5 s, 1 s, 3: 12 18 27, 2.5 ms, 3: 12 18 27, 2.5 ms");
    check_plan("mine", false, "0.5 s, 5 s, 3: 12 18 27, 2.5 ms, 4: 12 18 27, 2.5 ms");
    check_plan("flag", true, "0.2 s, 0.2 s, 3: 8 12 16, 2.5 ms, 3: 8 12 16, 2.5 ms");
}

int main(int argc, char **argv)
{
    char *path = path_of("edge_drop"), command[4200];
    struct settings s = settings_of(2, long_sheet);

    REQUIRE(argc == 2);
    snprintf(folder, sizeof folder, "%s", argv[1]);
    snprintf(command, sizeof command, "rm -rf '%s'", folder); /* of an earlier run */
    REQUIRE(system(command) == 0 && folder_make(folder, NULL) == STATUS_OK);
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", folder, 1));
    const struct truth_runs runs = runs_of(path, &s);
    check_plans();
    check_stored_plans();
    check_budget(&runs);
    check_made(&runs);
    check_bits(&runs);
    check_lost(&runs);
    check_plate();
    check_shell();
    settings_clear(&s);
    free(path);
    return check_result();
}
