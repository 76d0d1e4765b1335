/* The truths that come with the program hold: models that had no part in them lie
 * within their error bars and the models' own errors. (truth_make.c: how they are made.) */
#include <dirent.h>

#include "bench/truth/truth.h"
#include "bench/truth/truth_making.h"
#include "fem_ref/reference.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"
#include "tests/fresh.h"
#include "tests/said.h"
#include "tests/truth_fixture.h"

static const char *folder;

/* The rounding of a point in 32-bit floats, whose coordinates are below 2 m [m]. */
static const double FLOAT = 1.04e-7;

/* The round-off of a depth, which another CPU adds up otherwise [m]. */
static const double DEPTH_ROUNDING = 1e-9;

enum { TIMES = 2 };
static const double times[TIMES] = {0.1, 0.2};

/* Returns the error of the finer of two nets, if it falls at least in proportion to the
 * spans. */
static double own_error(const struct truth_level *fine, const struct truth_level *coarse,
                        double difference)
{
    double ratio = (double)(fine->side - fine->degree) / (coarse->side - coarse->degree);

    return difference / (ratio - 1);
}

/* Degrees and nets that no truth is made of. */
static void mid_size(const char *scene, enum truth_model model, int degree)
{
    struct truth_level level[2] = {{model, degree, 14, 0.005, false},
                                   {model, degree, 10, 0.005, false}};
    struct run_result run[2] = {{0}};
    struct truth *truth = NULL;
    struct asked a;

    asked_open(&a, scene, 0, NULL, TIMES, times, folder);
    REQUIRE(truth_find(a.path, &a.settings, TIMES, times, NULL, &truth, NULL) == STATUS_OK);
    for (int n = 0; n < 2; n++)
        REQUIRE(truth_level_find(&a.runs, &level[n], &run[n], NULL) == STATUS_OK);
    for (int n = 0; n < TIMES; n++) {
        double error = metric_rmse(run[0].xyz[n], truth->xyz[n]);
        double own =
            own_error(&level[0], &level[1], metric_rmse(run[0].xyz[n], run[1].xyz[n]));
        CHECK_SAY(error <= truth->error[n] + own, "%s, %s at %g s: %g m, bar %g, own %g",
                  scene,
                  truth_level_contestant(&(struct truth_level){.model = model})->name,
                  times[n], error, truth->error[n], own);
        CHECK(own < 0.1); /* else it says nothing */
    }
    run_result_clear(&run[0]);
    run_result_clear(&run[1]);
    truth_destroy(truth);
    asked_close(&a);
}

/* A truth that comes with the program was made by a commit with no file changed, and packed
 * below a tenth of its bars, or as sharply as 32-bit floats of a metre are. */
static void check_origin(const char *name, const struct scene *s)
{
    struct truth made;

    REQUIRE(truth_file_find(name, s, &made, NULL) == STATUS_OK);
    CHECK_SAY(strlen(made.commit) == 40 && !strcmp(made.changed, "0"),
              "%s: commit %s, %s changed files", name, made.commit, made.changed);
    for (int n = 0; n < made.claimed; n++)
        CHECK_SAY(made.value[n][TRUTH_PACKING] <= fmax(made.error[n] / 10, FLOAT),
                  "%s at %g s: packing %g m, bar %g m", name, made.time[n],
                  made.value[n][TRUTH_PACKING], made.error[n]);
    truth_clear(&made);
}

/* A truth is claimed up to its sheet's first crossing, which is found here among all its
 * frames by exact predicates alone; 0: it has none. */
static void claim_ends_at_crossing(const char *name, double first)
{
    struct asked a;
    struct truth all, claimed, *truth = NULL;
    struct message why = {""};
    char *path = NULL;
    int n = 0;

    asked_open(&a, name, 0, NULL, 0, NULL, NULL);
    REQUIRE(named_file_find(&truth_file_kind, name, &path, NULL) == STATUS_OK);
    REQUIRE(truth_file_find(path, &a.scene, &all, &why) == STATUS_OK); /* not searched */
    REQUIRE(truth_file_find(name, &a.scene, &claimed, &why) == STATUS_OK);
    while (n < all.claimed && metric_intersections(&a.scene, all.xyz[n]) == 0)
        n++;
    CHECK(claimed.claimed == n && (n < all.claimed) == (first > 0));
    if (first > 0) {
        CHECK_NEAR(all.time[n], first, 1e-9);
        CHECK(!claimed.xyz[n] && claimed.value[n][TRUTH_CROSSINGS] > 0 &&
              claimed.value[n][TRUTH_CROSSING_DEPTH] > 0);
        CHECK(truth_find(a.path, &a.settings, 1, &first, NULL, &truth, &why) ==
              STATUS_UNSUPPORTED);
    }
    /* what the file says was found is found again */
    const int searched = all.claimed;
    for (n = 0; n < searched; n++)
        all.value[n][TRUTH_CROSSINGS] = NAN;
    REQUIRE(truth_crossing_judge(&all, 1) == STATUS_OK);
    CHECK(all.claimed == claimed.claimed);
    for (n = 0; n < searched; n++) {
        CHECK(all.value[n][TRUTH_CROSSINGS] == claimed.value[n][TRUTH_CROSSINGS]);
        CHECK_NEAR(all.value[n][TRUTH_CROSSING_DEPTH],
                   claimed.value[n][TRUTH_CROSSING_DEPTH], DEPTH_ROUNDING);
    }
    truth_clear(&all);
    truth_clear(&claimed);
    free(path);
    asked_close(&a);
}

/* Each file holds for the scene whose name it has, as it comes with the program. */
static void each_has_its_scene(void)
{
    struct named_file_entry *entries = NULL;
    int count = 0;

    REQUIRE(named_file_list(&truth_file_kind, &entries, &count, NULL) == STATUS_OK);
    CHECK(count >= 1);
    for (int n = 0; n < count; n++) {
        struct asked a;
        double time[1];
        int found = 0;

        asked_open(&a, entries[n].name, 0, NULL, 0, NULL, NULL);
        CHECK(truth_stored_times(a.path, &a.settings, a.scene.end, 1, time, &found, NULL) ==
              STATUS_OK);
        CHECK_SAY(found == 1, "%s: %s", entries[n].name, entries[n].text);
        check_origin(entries[n].name, &a.scene);
        asked_close(&a);
    }
    named_file_list_free(entries, count);
}

/* Every scene that comes with the program is a closed form, has a stored truth, or is told
 * why it can have none. */
static void each_scene_is_known(void)
{
    static const char *const ways[] = {",closed form,", ",stored,", ",none,"};
    struct named_file_entry *scenes = NULL;
    struct said said;
    char row[64];
    int count = 0;

    REQUIRE(truth_print_all(&(struct printer){TABLE_CSV, said_open(&said)}, NULL) ==
            STATUS_OK);
    char *text = said_text(&said);
    REQUIRE(named_file_names(&scene_file_kind, &scenes, &count, NULL) == STATUS_OK);
    CHECK(count > 20);
    for (int n = 0; n < count; n++) {
        int found = 0;
        for (size_t w = 0; w < sizeof ways / sizeof *ways; w++) {
            snprintf(row, sizeof row, "\n%s%s", scenes[n].name, ways[w]);
            found += strstr(text, row) != NULL;
        }
        snprintf(row, sizeof row, "# %s has no truth: ", scenes[n].name);
        const bool never = strstr(text, row);
        snprintf(row, sizeof row, "\n%s,none,", scenes[n].name);
        CHECK_SAY(found == 1 && (strstr(text, row) != NULL) == never,
                  "%s: neither known nor told why not", scenes[n].name);
    }
    named_file_list_free(scenes, count);
    free(text);
}

/* An error that grows along the strip as s^2, as a bend at its clamp makes it, is at the
 * tip so many times its rms. */
static const double TIP = 2.2360679774997896;

/* The strip is a beam that somebody else has solved. */
static void strip_is_the_beam(void)
{
    struct truth made = {0};
    char *file = NULL;
    struct reference *beam = NULL;

    REQUIRE(named_file_find(&truth_file_kind, "strip_swing", &file, NULL) == STATUS_OK);
    REQUIRE(truth_file_read(file, &made, NULL) == STATUS_OK);
    REQUIRE(reference_open(SOURCE_DIR "/tests/reference/pendulum_C0_E1e5_h5mm_undamped.csv",
                           &beam, NULL) == STATUS_OK);
    CHECK(made.claimed == 25);
    for (int n = 0; n < made.claimed; n++) {
        const int row = (int)lround(made.time[n] / 0.005); /* the beam's step */
        const double *low = made.xyz[n] + 3 * (GRID_U - 1);
        const double *high = low + 3 * GRID_U * GRID_V;
        const double apart =
            hypot((low[0] + high[0]) / 2 - reference_number(beam, row, "x1"),
                  (low[2] + high[2]) / 2 - reference_number(beam, row, "z1"));
        CHECK_NEAR(reference_number(beam, row, "t"), made.time[n], 1e-9);
        CHECK_SAY(apart <= TIP * made.error[n],
                  "strip_swing at %g s: %g m from the beam, bar %g m", made.time[n], apart,
                  made.error[n]);
    }
    reference_close(beam);
    truth_clear(&made);
    free(file);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    fresh_folder(
        folder); /* runs of an earlier call would say nothing on models as they are */
    each_has_its_scene();
    each_scene_is_known();
    strip_is_the_beam();
    claim_ends_at_crossing("flap", 0);
    claim_ends_at_crossing("flag", 0);
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", SOURCE_DIR "/tests/truths", 1));
    claim_ends_at_crossing("flap", 0.34);
    REQUIRE(!unsetenv("CLOTHBENCH_TRUTHS"));
    mid_size("edge_drop", TRUTH_SOLID, 2);
    mid_size("edge_drop", TRUTH_SHELL, 4);
    return check_result();
}
