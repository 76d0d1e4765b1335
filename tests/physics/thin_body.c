/* Sheets that fall on what their nets' points pass on both sides: over a line of 1 cm, on a
 * knife's edge and on the tip of a cone. In each model that meets bodies they stay there.
 */
#include "bench/harness/run_file.h"
#include "models/vector.h"
#include "tests/opened_run.h"
#include "tests/run_fixture.h"

#define CASES SOURCE_DIR "/tests/cases/"

/* The middle at .2 s, by triangles_explicit on 121x81 points, whose samples meet the line
 * by themselves: their spacing is its radius. On 61x41 it is 2 mm away. */
static const double right[3] = {0.1923, 0.2, -0.0073};
/* A net bends at its lines only: the middle may be half a span from where the sheet bends.
 */
static const double HALF = 0.5;

static const struct {
    const char *contestant;
    int spans; /* along the sheet of .6 m                                              */
    const char *points;
} row[] = {
    {"position_based", 10, "[11,11]"},
    {"position_based", 20, "[21,21]"},
    {"projective_dynamics", 10, "[11,11]"},
    {"projective_dynamics_bdf2", 10, "[11,11]"},
    {"projective_dynamics_bdf2", 20, "[21,21]"},
    {"vbd", 10, "[11,11]"},
    {"vbd", 20, "[21,21]"},
    {"mass_spring_leapfrog", 10, "[11,11]"},
    {"mass_spring_leapfrog", 20, "[21,21]"},
    {"triangles_explicit", 10, "[11,11]"},
    {"triangles_explicit", 20, "[21,21]"},
    {"triangles", 10, "[11,11]"},
    {"shell", 3, "[6,6]"},
    {"shell", 6, "[9,9]"},
};

/* Follows a scene to its end; finds where a point is then. */
static void follow(const char *scene, const char *contestant, const char *points,
                   const char *more, const double uvw[3], double x[3])
{
    struct case_plan plan = {scene, named(contestant),
                             .keep = {.every = 1, .fields = RUN_FIELDS_NONE}};
    struct run run = {0};
    struct motion m = {0};
    struct run_file *f;
    struct run_result r;
    char net[64];

    snprintf(net, sizeof net, "discretization.points=%s", points);
    settings_set(&plan.settings, net);
    if (more)
        settings_set(&plan.settings, more);
    REQUIRE(run_read(&run, &plan, NULL) == STATUS_OK);
    REQUIRE(run_file_follow(&plan, &run, &m, &f, NULL) == STATUS_OK);
    run.model->probe(run.state, 1, uvw, x);
    REQUIRE(run_file_close(f, &m, &r, NULL) == STATUS_OK);
    const struct message told = r.distrust;
    printf("%-20s %s: (%.4f, %.4f, %.4f); %s\n", contestant, points, x[0], x[1], x[2],
           *told.text ? told.text : "trusted");
    CHECK(r.outcome == STATUS_OK && r.value[MEASURE_THROUGH_MAX] == 0);
    CHECK(!strstr(told.text, "came through"));
    motion_clear(&m);
    run_close(&run);
    settings_clear(&plan.settings);
}

static void check_row(const char *contestant, int spans, const char *points)
{
    static const double middle[3] = {0.5, 0.5, 0.5}, length = 0.6;
    double x[3];

    follow(CASES "line.yaml", contestant, points, "time.end=0.2", middle, x);
    CHECK_NEAR(vector_distance(x, right), 0, HALF * length / spans);
}

/* The point that begins over the knife, or the tip, is held there, to half a span: without
 * it, it would be 5 cm under it. */
static void check_sharp(const char *contestant, int spans, const char *points)
{
    static const double over[3] = {0.213 / 0.4, 0.187 / 0.4, 0.5}, length = 0.4;
    static const char *const scene[] = {CASES "knife.yaml", CASES "cone.yaml"};
    double x[3];

    for (int n = 0; n < 2; n++) {
        follow(scene[n], contestant, points, NULL, over, x);
        CHECK_NEAR(x[2], 0, HALF * length / spans);
    }
}

int main(int argc, char **argv)
{
    for (size_t n = 0; n < sizeof row / sizeof *row; n++)
        if (argc < 2 || !strcmp(argv[1], row[n].contestant))
            check_row(row[n].contestant, row[n].spans, row[n].points);
    if (argc < 2) {
        check_sharp("position_based", 10, "[11,11]");
        check_sharp("projective_dynamics", 10, "[11,11]");
        check_sharp("vbd", 10, "[11,11]");
        check_sharp("triangles", 10, "[11,11]");
        check_sharp("shell", 3, "[6,6]");
    }
    return check_result();
}
