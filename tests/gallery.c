/* Galleries: fields and numbers of a few runs at given times (study_gallery.c: the studies
 * made of them). */
#include "bench/experiment/gallery.h"

#include <float.h>

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/fresh.h"
#include "tests/said.h"

static const char *folder;

/* Positions are kept as 32-bit floats of at most 1 m or so: half a unit of the 24th bit. */
#define TOL_SINGLE FLT_EPSILON

/* Row 7 of Table 4, which dies at 0.265 s, and the same kept calm. */
static void add_settings(int n, bool quick, struct settings *s)
{
    (void)quick;
    settings_set(s, "material.young=5e4");
    settings_set(s, "material.density=0.1");
    settings_number(s, "damping.value", n ? 0.9 : 0.3);
}

static const struct gallery pair = {.name = "pair",
                                    .times = 2,
                                    .time = {0.15, 0.4},
                                    .count = 2,
                                    .item = {{"calm", "calm", "edge_drop", "iga_paper"},
                                             {"wild", "wild", "edge_drop", "iga_paper"}},
                                    .settings = add_settings};

static void test_frames(void)
{
    const struct measurement_options how = {.quick = false};
    struct gallery_result r;
    struct message why = {""};
    struct settings settings = {0};
    struct run_plan plan = {.path = SOURCE_DIR "/models/scenes/edge_drop.yaml",
                            .settings = &settings,
                            .end = 0.4};
    struct run run;
    struct motion m;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz), far = 0;

    REQUIRE(xyz && gallery_measure(&pair, folder, &how, &why) == STATUS_OK);
    REQUIRE(gallery_read(&pair, folder, &r, &why) == STATUS_OK);
    add_settings(0, false, &settings);
    REQUIRE(contestant_find("iga_paper", &plan.contestant, &why) == STATUS_OK);
    REQUIRE(run_open(&run, &plan, &why) == STATUS_OK);
    REQUIRE(motion_init(&m, run.model, &run.scene, run.state) == STATUS_OK);
    REQUIRE(motion_run(&m, NULL, NULL, true, &why) == STATUS_OK);
    run.model->sample(run.state, xyz);
    REQUIRE(r.run[0].frames == 2);
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        far = fmax(far, fabs(xyz[n] - r.run[0].xyz[1][n]));
    CHECK_NEAR(far, 0, TOL_SINGLE);
    CHECK(r.frame[0][1].drop == metric_drop(&run.scene, r.run[0].xyz[1]));
    CHECK(r.frame[0][1].angle > r.frame[0][0].angle);
    CHECK(r.run[0].unknowns == 540);
    /* the other lived to see the first time only */
    CHECK(status_is_death(r.run[1].outcome));
    CHECK(r.run[1].frames == 1 && isnan(r.frame[1][1].stretch));
    motion_clear(&m);
    run_close(&run);
    settings_clear(&settings);
    gallery_clear(&r);
    free(xyz);
}

/* Made-up numbers: every cell with its digits; who died has none later, and says why. */
static void test_cells(void)
{
    static const char *const rows[] = {
        "| 0.150 | calm | 540 | 1.235 | 0.124 | 12.3 | 2.35 | 7 |",
        "| 0.150 | wild | 660 | 2.235 | 0.224 | 22.3 | 3.35 | 10 |",
        "| 0.400 | calm | 540 | 1.335 | 0.134 | 13.3 | 2.45 | 8 |",
        "| 0.400 | wild | 660 | - | - | - | - | - |", "\nwild: died of it.\n"};
    static struct gallery_result r;
    struct message why;
    struct said s;

    for (int n = 0; n < 2; n++) {
        r.run[n].unknowns = n ? 660 : 540;
        for (int t = 0; t < 2; t++)
            r.frame[n][t] = (struct gallery_frame){
                1.2346 + n + t / 10., 0.12351 + n / 10. + t / 100., 12.346 + 10 * n + t,
                2.3456 + n + t / 10., 7 + 3 * n + t};
    }
    r.run[1].outcome = STATUS_NAN;
    r.run[1].sentence = (struct message){"died of it"};
    r.frame[1][1] = (struct gallery_frame){NAN, NAN, NAN, NAN, NAN};
    REQUIRE(!setenv("PATH", "/proc/nowhere", 1)); /* no picture */
    said_open(&s);
    CHECK(gallery_print(&pair, &r, "a pair", folder, TABLE_MARKDOWN, s.file, &why) ==
          STATUS_OK);
    said_close(&s, true);
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        said_has(&s, "cells", rows[n]);
    said_lacks(&s, "cells", "calm: ");
    said_clear(&s);
    said_read(&s, folder, "pair.csv");
    said_has(&s, "csv", "0002,wild,660,,,,,\n");
    said_clear(&s);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    fresh_folder(folder);
    test_frames();
    test_cells();
    return check_result();
}
