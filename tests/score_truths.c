/* Diagnoses of truths that are frames: as they are they are sound, on a coarse net at its
 * floor, and changed they get the sentence of what was changed, where nothing is fitted.
 *
 *   score_truths FOLDER
 */
#include "bench/files/folder.h"
#include "models/grid.h"
#include "tests/check.h"
#include "tests/score_said.h"

/* What somebody made of a truth: so many times its displacement, then its width, then more.
 */
struct change {
    double way, wide;
    void (*more)(double xyz[3]); /* may be NULL */
};

static void write_changed(const struct score_truth *t, const char *name, int side,
                          struct change make)
{
    char path[4096];

    file_of(name, path);
    FILE *file = fopen(path, "w");
    REQUIRE(file);
    for (int k = 0; k < t->times; k++)
        for (int n = 0; n < side * side; n++) {
            const double uv[2] = {n % side / (side - 1.), n / side / (side - 1.)};
            double x[3], rest[3];
            score_net_sample(GRID_U, GRID_V, score_truth_field(t, k), uv, x);
            score_net_sample(GRID_U, GRID_V, t->rest, uv, rest);
            for (int c = 0; c < 3; c++)
                x[c] = rest[c] + make.way * (x[c] - rest[c]);
            x[1] *= make.wide;
            if (make.more)
                make.more(x);
            fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", t->time[k], uv[0], uv[1], x[0],
                    x[1], x[2]);
        }
    REQUIRE(fclose(file) == 0);
}

static void write_truth(const struct score_truth *t, const char *name, int side)
{
    write_changed(t, name, side, (struct change){1, 1, NULL});
}

/* All that is beyond 0.7 of the sheet's width lies there. */
static void heap(double xyz[3])
{
    xyz[1] = fmin(xyz[1], .7);
}

static void aside(double xyz[3])
{
    xyz[1] += .006;
}

/* All, with the edge that is held: more than penalties give. */
static void far_aside(double xyz[3])
{
    xyz[1] += .012;
}

static void far_along(double xyz[3])
{
    xyz[0] += .012;
}

static void hair_aside(double xyz[3])
{
    xyz[0] += .001;
}

/* Narrower by a share that is no flaw: less than 1 %, but many times more of a length than
 * the floor of the stretch along u. */
#define NARROWER .996

/* What is said where nothing is fitted: by the truth's own stretch, by the shape of what
 * shrank, by the bar that hides it. */
static void unfitted(void)
{
    static const struct {
        const char *scene, *name;
        struct change make;
        enum score_kind kind;
        double value, tolerance;
        const char *words;
    } row[] = {
        {"hanging", "twice.csv", {2, 1}, SCORE_STRETCH, .005, 2e-4, "2 times as much"},
        {"hanging", "half.csv", {.5, 1}, SCORE_STRETCH, -.0025, 2e-4, "too stiff"},
        {"hanging", "more.csv", {1.02, 1}, SCORE_SOUND, 0, 1e-3, "Nothing wrong"},
        {"hanging", "u_120.csv", {1.2, NARROWER}, SCORE_STRETCH, .001, 1e-4, "1.2 times"},
        {"hanging", "u_100.csv", {1, NARROWER}, SCORE_KINDS, 0, 0, ""},
        {"hanging", "u.csv", {.25, NARROWER}, SCORE_STRETCH, -.00375, 1e-4, "0.25 "},
        {"hanging", "zero.csv", {0, 1}, SCORE_KINDS, 0, 0, ""},
        {"hanging", "hair.csv", {1, 1, hair_aside}, SCORE_KINDS, 0, 0, ""},
        {"rest_small", "narrow.csv", {1, .7}, SCORE_STRETCH, -.3, .01, "rest shape"},
        {"rest_small", "heap.csv", {1, 1, heap}, SCORE_STRETCH, -.3, .02, "crumpled"},
        {"flag", "far.csv", {1, 1, far_aside}, SCORE_SUPPORT, .012, 1e-5, "support 0 ("},
        /* its edges along v are free to */
        {"navier",
         "along.csv",
         {1, 1, far_along},
         SCORE_SUPPORT,
         .012,
         1e-5,
         "support 2 ("},
        {"flag", "aside.csv", {1, 1, aside}, SCORE_SOUND, .006, 1e-4, "bar of up to 4.4 %"},
    };
    struct score_truth t;

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        REQUIRE(score_truth_read(row[n].scene, &t, NULL) == STATUS_OK);
        write_changed(&t, row[n].name, 20, row[n].make);
        score_truth_clear(&t);
        *last_said = '\0';
        check_said(row[n].scene, row[n].name, &plain, row[n].kind, row[n].value,
                   row[n].tolerance);
        check_words(row[n].name, row[n].words);
    }
}

/* All frames that are stored, as 24 a second that were taken for 25. */
static void paced(void)
{
    struct score_truth t;
    char path[4096];

    REQUIRE(score_truth_read("edge_drop", &t, NULL) == STATUS_OK);
    file_of("pace.csv", path);
    FILE *file = fopen(path, "w");
    REQUIRE(file);
    for (int k = 0; k < t.motions; k++)
        for (int n = 0; n < SCORE_FEW; n++)
            fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", t.motion_time[k] * 24 / 25,
                    n % SCORE_SIDE / (SCORE_SIDE - 1.), n / SCORE_SIDE / (SCORE_SIDE - 1.),
                    t.motion[k][n][0], t.motion[k][n][1], t.motion[k][n][2]);
    REQUIRE(fclose(file) == 0);
    score_truth_clear(&t);
    check_said("edge_drop", "pace.csv", &plain, SCORE_TIME, 25 / 24., 1e-3);
}

static void truths(void)
{
    static const char *const scene[] = {"edge_drop",  "flag",      "corners_patch",
                                        "sphere",     "free_fall", "hanging",
                                        "rest_small", "rest_large"};
    struct score_truth t;
    struct message why = {""};

    for (size_t n = 0; n < sizeof scene / sizeof *scene; n++) {
        char name[64];
        snprintf(name, sizeof name, "truth_%s.csv", scene[n]);
        if (!CHECK(score_truth_read(scene[n], &t, &why) == STATUS_OK)) {
            printf("%s\n", why.text);
            continue;
        }
        write_truth(&t, name, 20);
        check_said(scene[n], name, &plain, SCORE_SOUND, 0, .02);
        if (n == 0) {
            write_truth(&t, "coarse.csv", 7);
            check_said(scene[n], "coarse.csv", &plain, SCORE_FLOOR, .013, .002);
        }
        score_truth_clear(&t);
    }
    CHECK(score_truth_read("corners_drop", &t, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "corners_drop has no truth: support 0 holds a point"));
}
int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    truths();
    paced();
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", SOURCE_DIR "/tests/truths", 1));
    unfitted(); /* beside a blunt truth, too */
    return check_result();
}
