/* Galleries: fields and numbers of a few runs at given times; and the two studies made of
 * them, on quick runs. */
#include "bench/experiment/gallery.h"

#include <float.h>

#include "bench/files/folder.h"
#include "bench/harness/motion.h"
#include "bench/studies/study_artefacts.h"
#include "bench/studies/study_flag.h"
#include "bench/harness/trial.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/check.h"

static const char *folder;

/* Positions are kept as 32-bit floats of at most 1 m or so: half a unit of the 24th bit. */
#define TOL_SINGLE FLT_EPSILON

/* Row 7 of Table 4, which dies at 0.265 s, and the same kept calm. */
static struct gallery fixture(void)
{
    struct gallery g = {.name = "pair", .times = 2, .time = {0.15, 0.4}, .count = 2};

    for (int n = 0; n < 2; n++) {
        g.item[n] = (struct gallery_case){.label = n ? "wild" : "calm",
                                          .name = n ? "wild" : "calm",
                                          .scene = "edge_drop",
                                          .model = "iga"};
        gallery_set(&g.item[n], "material.young=5e4");
        gallery_set(&g.item[n], "material.density=0.1");
        gallery_set(&g.item[n], "damping.value=%g", n ? 0.9 : 0.3);
    }
    return g;
}

static void test_frames(void)
{
    struct gallery g = fixture();
    struct gallery_result r;
    struct exhibit_options options = {.folder = folder};
    struct message why = {""};
    struct trial trial;
    struct motion m;
    const char *settings[4] = {g.item[0].setting[0], g.item[0].setting[1],
                               g.item[0].setting[2], "time.end=0.4"};
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz), far = 0;

    REQUIRE(xyz && gallery_measure(&g, &options, &why) == STATUS_OK);
    REQUIRE(gallery_read(&g, folder, &r, &why) == STATUS_OK);
    REQUIRE(trial_open(&trial, SOURCE_DIR "/models/scenes/edge_drop.yaml", 4, settings,
                       "iga", &why) == STATUS_OK);
    REQUIRE(motion_init(&m, trial.model, &trial.scene, trial.state) == STATUS_OK);
    REQUIRE(motion_run(&m, NULL, NULL, true, &why) == STATUS_OK);
    trial.model->sample(trial.state, xyz);
    REQUIRE(r.frame[0][0].xyz && r.frame[0][1].xyz);
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        far = fmax(far, fabs(xyz[n] - r.frame[0][1].xyz[n]));
    CHECK_NEAR(far, 0, TOL_SINGLE);
    CHECK(r.frame[0][1].drop == metric_drop(&trial.scene, r.frame[0][1].xyz));
    CHECK(r.frame[0][1].angle > r.frame[0][0].angle);
    CHECK(r.unknowns[0] == 540);
    /* the other lived to see the first time only */
    CHECK(status_is_death(r.result[1].outcome));
    CHECK(r.frame[1][0].xyz && !r.frame[1][1].xyz && isnan(r.frame[1][1].stretch));
    motion_clear(&m);
    trial_close(&trial);
    gallery_clear(&r);
    free(xyz);
}

/* Runs an exhibit, quick, and returns what it prints; freed by the caller. */
static char *printed(const struct exhibit *exhibit)
{
    struct exhibit_options options = {.folder = folder, .quick = true};
    struct message why = {""};
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);

    REQUIRE(file);
    if (exhibit->measure(&options, &why) || exhibit->print(folder, TABLE_TEXT, file, &why))
        printf("%s\n", why.text);
    fclose(file);
    return text;
}

/* The line that begins so. */
static bool has_line(const char *text, const char *start, const char *part)
{
    const char *line = strstr(text, start), *end = line ? strchr(line, '\n') : NULL;
    const char *found = line ? strstr(line, part) : NULL;

    return found && found < end;
}

static void test_artefacts(void)
{
    char *text = printed(&study_artefacts_exhibit);

    CHECK(has_line(text, "super-elongation  row 4, iga", "yes    over-stretched"));
    CHECK(has_line(text, "floating          row 13, shell", "yes    too light"));
    CHECK(has_line(text, "penetration       row 2, iga", "yes    "));
    CHECK(has_line(text, "penetration       row 2, iga", "penetration"));
    CHECK(strstr(text, "floating: row 13: shown, but not alone"));
    CHECK(strstr(text, "row 14, the paper's: not reproduced"));
    free(text);
}

static void test_flag(void)
{
    struct message why = {""};
    char *text = printed(&study_flag_exhibit);

    CHECK(has_line(text, "0.750  printed (the paper's)", "1."));
    CHECK(has_line(text, "2.075  projective dynamics, matched", "1."));
    CHECK(strstr(text, "not the bending of its material"));
    CHECK(study_flag_exhibit.print("/nowhere", TABLE_TEXT, stdout, &why) == STATUS_FILE);
    CHECK(strstr(why.text, "/nowhere/"));
    free(text);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    test_frames();
    test_artefacts();
    test_flag();
    return check_result();
}
