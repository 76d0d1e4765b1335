/* The plan of a truth: frames, nets, times at which tables judge; and what has no truth. */
#include "bench/truth/truth_making.h"

#include "tests/truth_fixture.h"

static const double SUM = 1e-12; /* of a few products */

static bool same(double a, double b)
{
    return isnan(a) || isnan(b) ? isnan(a) && isnan(b) : fabs(a - b) <= SUM * fabs(b);
}

/* Tables judge at some of many times; at the last that is claimed, if there is none. */
static void check_thin(void)
{
    static const double time[5] = {.06, .1, .16, .2, .22};
    double snapshot = .06;
    const struct scene scene = {.snapshot_count = 1, .snapshots = &snapshot}, plain = {0};
    static const struct {
        bool plain;
        int claimed, times, left;
        double last;
    } cases[] = {{false, 5, 3, 3, .2}, {true, 5, 2, 2, .2}, {false, 2, 3, 2, .2},
                 {false, 1, 3, 1, .2}, {true, 1, 3, 1, .2}, {true, 0, 2, 0, .2}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct truth made;
        truth_init(&made, 5, cases[n].claimed, time);
        for (int t = 0; t < 5; t++)
            made.error[t] = time[t];
        truth_thin(&made, cases[n].plain ? &plain : &scene);
        CHECK_SAY(made.times == cases[n].times && made.claimed == cases[n].left &&
                      made.time[made.times - 1] == cases[n].last,
                  "thin %zu: %d times, %d claimed", n, made.times, made.claimed);
        for (int t = 0; t < made.times; t++)
            CHECK(made.error[t] == made.time[t] &&
                  (made.xyz[t] != NULL) == (t < made.claimed));
        truth_clear(&made);
    }
}

/* --- Nets, frames, and what has no truth: by what is held. */

static const struct {
    double lo[2], hi[2];
    int side[3]; /* of the first nets                                                  */
    int pieces;  /* of the frame, of the first                                         */
    bool point;
} held[] = {
    {{0, 0}, {0, 1}, {9, 12, 15}, 2, false},      /* an edge: any net                  */
    {{0, 0}, {.1, .1}, {12, 15, 18}, 2, false},   /* three more points for an end      */
    {{0, .25}, {0, .75}, {15, 18, 21}, 2, false}, /* six for two                       */
    {{1, 0}, {1, .05}, {12, 15, 18}, 2, false},   {{0, 0}, {0, 0}, {9, 12, 15}, 2, true},
    {{.5, 1}, {.5, 1}, {11, 15, 19}, 2, true},
};

static void check_held(void)
{
    for (size_t n = 0; n < sizeof held / sizeof *held; n++) {
        struct scene_support s = {.hi = {0, 0, 1}, .fix = FIX_XYZ};
        struct truth_level level, last = {0};
        memcpy(s.lo, held[n].lo, sizeof held[n].lo);
        memcpy(s.hi, held[n].hi, sizeof held[n].hi);
        const struct scene scene = {
            .name = (char[]){"mine"}, .support_count = 1, .supports = &s};
        int k = 0;
        for (; truth_plan_rung(&scene, .005, k, &level); k++) {
            CHECK(level.degree == 3 && level.side > last.side &&
                  (k > 2 || level.side == held[n].side[k]));
            CHECK(k > 0 || same(level.step, .005 / held[n].pieces));
            /* both shrink alike */
            CHECK(k == 0 ||
                  same(last.step / level.step, (level.side - 3.0 - level.repeats) /
                                                   (last.side - 3 - last.repeats)));
            last = level;
        }
        CHECK(k >= 7);
        CHECK((truth_plan_check(&scene, NULL) == STATUS_UNSUPPORTED) == held[n].point);
    }
}

/* A ball under the middle of a sheet of 1 mm, so far from its lower side. */
static void check_drape(void)
{
    static const struct {
        double gap;
        int supports;
        bool laid;
    } cases[] = {{1e-5, 0, true},   {.9e-3, 0, true}, {1.1e-3, 0, false},
                 {-1e-12, 0, true}, {.05, 0, false},  {1e-5, 1, false}};
    struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct scene_obstacle ball = {.kind = OBSTACLE_SPHERE,
                                      .point = {.5, .5, -.5005 - cases[n].gap},
                                      .radius = .5};
        const struct scene scene = {.name = (char[]){"mine"},
                                    .length = 1,
                                    .width = 1,
                                    .thickness = .001,
                                    .axis_u = {1, 0, 0},
                                    .axis_v = {0, 1, 0},
                                    .support_count = cases[n].supports,
                                    .supports = &edge,
                                    .obstacle_count = 1,
                                    .obstacles = &ball};
        CHECK((truth_plan_check(&scene, NULL) == STATUS_UNSUPPORTED) == cases[n].laid);
    }
}

static void check_frames(void)
{
    /* frames and snapshots that all steps meet; of these, those that are judged */
    double snapshots[] = {0, 0.05, 0.06, 0.1, 0.14, 0.3, 0.32}, *time = NULL;
    const struct scene scene = {.snapshot_count = 7, .snapshots = snapshots};
    const double judged[] = {0.06, 0.1, 0.14, 0.2, 0.3};
    const int count = truth_plan_times(0.31, 0.02, &scene, &time);
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

    static const double step[][2] = {{.005, .005}, {.001, .001}, {1 / 60.0, .01},
                                     {.03, .02},   {.02, .02},   {.003, .02 / 7}};

    for (size_t n = 0; n < sizeof step / sizeof *step; n++)
        CHECK_RELATIVE(truth_plan_frame(&(struct scene){.step = step[n][0]}), step[n][1],
                       SUM);
}

/* --- The text of a scene's physics, which says for whom a truth holds. */

/* Pairs of settings of a scene: what moves the sheet differs in the text; times, names and
 * numerics do not. NULL: the scene as it is. */
#define HELD(at)  "supports=[{at: {" at "}, fix: xyz}]"
#define LED(path) "supports=[{at: {u: 0}, fix: xyz, path: [" path "]}]"
#define TURNED(axis, angles)                                                               \
    "supports=[{at: {u: 0}, fix: xyz, turn: {axis: " axis                                  \
    ", about: [1,0,0], angles: " angles "}}]"
#define BODY(text)  "obstacles=[{" text "}}]"
#define SPUN(text)  "obstacles[0].turn={axis: " text "}"
#define OCTAHEDRON  SOURCE_DIR "/tests/bad_scenes/mesh_inside.obj"
#define PULL(rest)  "loads=[{at: {" rest "]}]"
#define AIR(text)   "air={density: " text "}"
#define PLANE(rest) "obstacles=[{plane: {" rest "}}]"
static const struct pair {
    const char *scene, *a, *b;
    bool same;
} pairs[] = {
    /* clang-format off */
    {"sphere", NULL, "sheet.length=1.1"}, {"sphere", NULL, "sheet.width=1.1"},
    {"sphere", NULL, "sheet.thickness=2e-3"}, {"sphere", NULL, "pose.origin=[0,0,1e-3]"},
    {"edge_drop", NULL, "pose={origin: [0,0,0], u: [0,1,0], v: [1,0,0]}"},
    {"edge_drop", NULL, "pose.v=[0,0,1]"}, {"sphere", NULL, "material.young=1.1e5"},
    {"sphere", NULL, "material.poisson=0.2"}, {"sphere", NULL, "material.density=0.6"},
    {"sphere", NULL, "gravity=[0,1e-6,-9.81]"}, {"sphere", NULL, "damping.value=2.1"},
    {"sphere", NULL, "damping={kind: none}"},
    {"sphere", "damping={kind: rayleigh, alpha: 1, beta: 1e-3}",
     "damping={kind: rayleigh, alpha: 2, beta: 1e-3}"},
    {"sphere", "damping={kind: rayleigh, alpha: 1, beta: 1e-3}",
     "damping={kind: rayleigh, alpha: 1, beta: 2e-3}"},
    {"edge_drop", NULL, "time.step=0.0025"}, /* a factor each step */
    {"edge_drop", NULL, "damping.value=0.4"},
    {"sphere", NULL, "drag={coefficient: 1, wind: [0,0,0]}"}, {"drape", NULL, "pressure=0.1"},
    {"sphere", "drag={coefficient: 1, wind: [0,0,1]}",
     "drag={coefficient: 1, wind: [0,0,2]}"},
    {"sphere", "drag={coefficient: 0, wind: [0,0,1]}",
     "drag={coefficient: 0, wind: [0,0,2]}", true},
    {"sphere", NULL, AIR("1, drag: [2, 0]")},
    {"sphere", AIR("1, drag: [2, 0]"), AIR("2, drag: [2, 0]")},
    {"sphere", AIR("1, drag: [2, 0]"), AIR("1, drag: [1, 0]")},
    {"sphere", AIR("1, drag: [2, 0]"), AIR("1, drag: [2, 1]")},
    {"sphere", AIR("1, drag: [2, 0]"), AIR("1, drag: [2, 0], wind: [0, 0, 1]")},
    {"sphere", AIR("1, drag: [2, 0], wind: [0, 0, 1]"),
     AIR("1, drag: [2, 0], wind: [[0, 0, 0, 1], [1, 0, 0, 2]]")},
    {"sphere", AIR("0, drag: [2, 0]"), AIR("0, drag: [3, 0], wind: [0, 0, 1]"), true},
    {"sphere", NULL, "obstacles[0].sphere.center=[0.5,0.5,-0.36]"},
    {"sphere", NULL, "obstacles[0].sphere.radius=0.31"},
    {"sphere", NULL, "obstacles[0].sphere.friction=0.2"},
    {"sphere", PLANE("point: [0,0,-1], normal: [0,0,1]"),
     PLANE("point: [0,0,-2], normal: [0,0,1]")},
    {"sphere", PLANE("point: [0,0,-1], normal: [0,0,1]"),
     PLANE("point: [0,0,-1], normal: [0,1,1]")},
    {"sphere", PLANE("point: [0,0,-1], normal: [0,0,1]"),
     PLANE("point: [0,0,-1], normal: [0,0,1], friction: 0.1")},
    {"sphere", NULL, "motion={velocity: [0,0,0.1]}"},
    {"sphere", NULL, "motion={spin: [0.1,0,0]}"},
    {"sphere", "motion={velocity: [0.1,0,0]}", "motion={velocity: [0,0.1,0]}"},
    {"sphere", "motion={velocity: [0,0.1,0], spin: [0,1,0]}",
     "motion={velocity: [0,0.1,0], spin: [0,0,1]}"},
    {"sphere", NULL, HELD("u: 0")}, {"edge_drop", NULL, HELD("u: 1")},
    {"edge_drop", NULL, HELD("v: 0")},
    {"edge_drop", HELD("u: [0,0.1]"), HELD("u: [0,0.2]")},
    {"edge_drop", HELD("u: [0,0.2]"), HELD("u: [0.1,0.2]")},
    {"edge_drop", HELD("u: 0, v: [0,0.5]"), HELD("u: 0, v: [0,0.6]")},
    {"edge_drop", HELD("u: 0, w: 0.5"), HELD("u: 0, w: 0")},
    {"edge_drop", NULL, "supports=[{at: {u: 0}, fix: xz}]"},
    {"edge_drop", NULL, "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]"},
    {"edge_drop", HELD("u: 0"), "supports=[{at: {u: 0}, fix: xyz, from: 0.1}]"},
    {"edge_drop", "supports=[{at: {u: 0}, fix: xyz, from: 0.1}]",
     "supports=[{at: {u: 0}, fix: xyz, from: 0.1, until: 0.2}]"},
    {"moving_edge", NULL, HELD("u: 0")},
    {"disc", HELD("vertices: [632, 677]"), HELD("vertices: [1, 632, 677]")}, /* one box */
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[2,0,0,1]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,1,0,1]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,0,1,1]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,0,0,2]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,0,0,1],[2,0,0,0]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), TURNED("[0,0,1]", "[[0,0],[1,9]]")},
    {"moving_edge", TURNED("[0,0,1]", "[[0,0],[1,9]]"), TURNED("[0,1,0]", "[[0,0],[1,9]]")},
    {"moving_edge", TURNED("[0,0,1]", "[[0,0],[1,9]]"), TURNED("[0,0,1]", "[[0,0],[1,8]]")},
    {"edge_drop", NULL, PULL("u: 1}, force: [0,0,1")},
    {"edge_drop", PULL("u: 1}, force: [0,0,1"), PULL("u: 1}, force: [0,1,0")},
    {"edge_drop", PULL("u: 1}, force: [0,0,1"), PULL("v: 1}, force: [0,0,1")},
    {"edge_drop", PULL("u: [0.5,1]}, force: [0,0,1"), PULL("u: [0.4,1]}, force: [0,0,1")},
    {"edge_drop", PULL("u: [0.5,1]}, force: [0,0,1"), PULL("u: [0.5,0.9]}, force: [0,0,1")},
    {"ground", NULL, "contact={}"},
    {"ground", "contact.stiffness=2", "contact.stiffness=3"},
    {"ground", "contact.range=1e-4", "contact.range=2e-4"},
    {"edge_drop", BODY("capsule: {from: [0,0,9], to: [0,0,8], radius: 1"),
     BODY("capsule: {from: [0,0,9], to: [0,1,8], radius: 1")},
    {"edge_drop", BODY("capsule: {from: [0,0,9], to: [0,0,8], radius: 1"),
     BODY("capsule: {from: [0,0,9], to: [0,0,8], radius: 2")},
    {"edge_drop", BODY("box: {center: [0,0,9], size: [1,1,1]"),
     BODY("box: {center: [0,0,9], size: [1,1,2]")},
    {"edge_drop", BODY("box: {center: [0,0,9], size: [1,1,1]"),
     BODY("box: {center: [0,0,9], size: [1,1,1], u: [0.6,0.8,0], v: [-0.8,0.6,0]")},
    {"edge_drop", BODY("mesh: {file: " OCTAHEDRON ", at: [0,0,9]"),
     BODY("mesh: {file: " OCTAHEDRON ", at: [0,0,8]")},
    {"edge_drop", BODY("mesh: {file: " OCTAHEDRON ", at: [0,0,9]"),
     BODY("mesh: {file: " OCTAHEDRON ", at: [0,0,9], scale: 2")},
    {"sphere", "obstacles[0].path=[[0,0,0,0],[1,0,0,1]]",
     "obstacles[0].path=[[0,0,0,0],[1,0,0,2]]"},
    {"sphere", SPUN("[0,0,1], about: [1,0,0], angles: [[0,0],[1,9]]"),
     SPUN("[0,0,1], about: [1,1,0], angles: [[0,0],[1,9]]")},
    {"sphere", SPUN("[0,0,1], about: [1,0,0], angles: [[0,0],[1,9]]"),
     SPUN("[0,1,0], about: [1,0,0], angles: [[0,0],[1,9]]")},
    {"sphere", SPUN("[0,0,1], about: [1,0,0], angles: [[0,0],[1,9]]"),
     SPUN("[0,0,1], about: [1,0,0], angles: [[0,0],[1,8]]")},
    {"sphere", NULL, "contact={self: false}", true},
    {"edge_drop", BODY("mesh: {file: " OCTAHEDRON ", at: [0,0,9]"),
     BODY("mesh: {at: [0.0,0,9], file: " OCTAHEDRON), true},
    {"cloak", NULL, "pose.opening=61"}, {"cloak", NULL, "pose.flare=11"},
    {"sphere", NULL, "time.step=0.0025", true}, {"sphere", NULL, "time.end=0.3", true},
    {"sphere", NULL, "snapshots=[0.1]", true},
    {"sphere", NULL, "discretization.degree=[4,4]", true},
    {"sphere", NULL, "name=other", true}, {"sphere", NULL, "pose.origin=[-0.0,0,0]", true},
    /* clang-format on */
};

static void physics(void)
{
    for (size_t n = 0; n < sizeof pairs / sizeof *pairs; n++) {
        const struct pair *p = &pairs[n];
        char *a = physics_of(p->scene, p->a != NULL, &p->a);
        char *b = physics_of(p->scene, 1, &p->b);
        CHECK_SAY((strcmp(a, b) == 0) == p->same, "%s: %s and %s", p->scene,
                  p->a ? p->a : "", p->b);
        free(a);
        free(b);
    }
}

/* Another scene than a text is of is told. */
static void physics_checked(void)
{
    static const char *const patch = HELD("u: 0, v: [0.25,0.75]");
    char *text = NULL;
    struct message why = {""};
    struct asked a;

    asked_open(&a, "edge_drop", 1, &patch, 0, NULL, NULL);
    REQUIRE(truth_physics(&a.scene, &text) == STATUS_OK);
    CHECK(truth_physics_check(text, &a.scene, &why) == STATUS_OK && !*why.text);
    a.scene.supports[0].hi[1] = 0.5;
    CHECK(truth_physics_check(text, &a.scene, &why) == STATUS_UNSUPPORTED);
    CHECK(strstr(why.text, "0.75 1") && strstr(why.text, "0.5 1")); /* what differs first */
    asked_close(&a);
    free(text);
}

int main(void)
{
    physics();
    physics_checked();
    check_thin();
    check_held();
    check_drape();
    check_frames();
    return check_result();
}
