/* The text of a scene's physics, which says for whom a truth holds: all that moves the
 * sheet and nothing else, and what differs told in words. */
#include "tests/truth_fixture.h"

/* Pairs of settings of a scene: what moves the sheet differs in the text; times, names and
 * numerics do not. NULL: the scene as it is. */
#define HELD(at)    "supports=[{at: {" at "}, fix: xyz}]"
#define LED(path)   "supports=[{at: {u: 0}, fix: xyz, path: [" path "]}]"
#define PULL(rest)  "loads=[{at: {" rest "]}]"
#define PLANE(rest) "obstacles=[{plane: {" rest "}}]"
static const struct pair {
    const char *scene, *a, *b;
    bool same;
} pairs[] = {
    {"sphere", NULL, "sheet.length=1.1"},
    {"sphere", NULL, "sheet.width=1.1"},
    {"sphere", NULL, "sheet.thickness=2e-3"},
    {"sphere", NULL, "pose.origin=[0,0,1e-3]"},
    {"edge_drop", NULL, "pose={origin: [0,0,0], u: [0,1,0], v: [1,0,0]}"},
    {"edge_drop", NULL, "pose.v=[0,0,1]"},
    {"sphere", NULL, "material.young=1.1e5"},
    {"sphere", NULL, "material.poisson=0.2"},
    {"sphere", NULL, "material.density=0.6"},
    {"sphere", NULL, "gravity=[0,1e-6,-9.81]"},
    {"sphere", NULL, "damping.value=2.1"},
    {"sphere", NULL, "damping={kind: none}"},
    {"sphere", "damping={kind: rayleigh, alpha: 1, beta: 1e-3}",
     "damping={kind: rayleigh, alpha: 2, beta: 1e-3}"},
    {"sphere", "damping={kind: rayleigh, alpha: 1, beta: 1e-3}",
     "damping={kind: rayleigh, alpha: 1, beta: 2e-3}"},
    {"edge_drop", NULL, "time.step=0.0025"}, /* a factor each step */
    {"edge_drop", NULL, "damping.value=0.4"},
    {"sphere", NULL, "drag={coefficient: 1, wind: [0,0,0]}"},
    {"sphere", "drag={coefficient: 1, wind: [0,0,1]}",
     "drag={coefficient: 1, wind: [0,0,2]}"},
    {"sphere", "drag={coefficient: 0, wind: [0,0,1]}",
     "drag={coefficient: 0, wind: [0,0,2]}", true},
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
    {"sphere", NULL, HELD("u: 0")},
    {"edge_drop", NULL, HELD("u: 1")},
    {"edge_drop", NULL, HELD("v: 0")},
    {"edge_drop", HELD("u: [0,0.1]"), HELD("u: [0,0.2]")},
    {"edge_drop", HELD("u: [0,0.2]"), HELD("u: [0.1,0.2]")},
    {"edge_drop", HELD("u: 0, v: [0,0.5]"), HELD("u: 0, v: [0,0.6]")},
    {"edge_drop", HELD("u: 0, w: 0.5"), HELD("u: 0, w: 0")},
    {"edge_drop", NULL, "supports=[{at: {u: 0}, fix: xz}]"},
    {"edge_drop", NULL, "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]"},
    {"moving_edge", NULL, HELD("u: 0")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[2,0,0,1]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,1,0,1]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,0,1,1]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,0,0,2]")},
    {"moving_edge", LED("[0,0,0,0],[1,0,0,1]"), LED("[0,0,0,0],[1,0,0,1],[2,0,0,0]")},
    {"edge_drop", NULL, PULL("u: 1}, force: [0,0,1")},
    {"edge_drop", PULL("u: 1}, force: [0,0,1"), PULL("u: 1}, force: [0,1,0")},
    {"edge_drop", PULL("u: 1}, force: [0,0,1"), PULL("v: 1}, force: [0,0,1")},
    {"edge_drop", PULL("u: [0.5,1]}, force: [0,0,1"), PULL("u: [0.4,1]}, force: [0,0,1")},
    {"edge_drop", PULL("u: [0.5,1]}, force: [0,0,1"), PULL("u: [0.5,0.9]}, force: [0,0,1")},
    {"cloak", NULL, "pose.opening=61"},
    {"cloak", NULL, "pose.flare=11"},
    {"sphere", NULL, "time.step=0.0025", true},
    {"sphere", NULL, "time.end=0.3", true},
    {"sphere", NULL, "snapshots=[0.1]", true},
    {"sphere", NULL, "discretization.degree=[4,4]", true},
    {"sphere", NULL, "name=other", true},
    {"sphere", NULL, "pose.origin=[-0.0,0,0]", true},
};

static void physics(void)
{
    for (size_t n = 0; n < sizeof pairs / sizeof *pairs; n++) {
        const struct pair *p = &pairs[n];
        char *a = physics_of(p->scene, p->a != NULL, &p->a);
        char *b = physics_of(p->scene, 1, &p->b);
        if (!CHECK((strcmp(a, b) == 0) == p->same))
            printf("%s: %s and %s\n", p->scene, p->a ? p->a : "", p->b);
        free(a);
        free(b);
    }
}

/* All of a text, of a scene that has two of each thing. */
static void physics_whole(void)
{
    static const char *const all[] = {
        "damping={kind: rayleigh, alpha: 1, beta: 2}",
        "drag={coefficient: 3, wind: [4,5,6]}",
        "motion={velocity: [7,8,9], spin: [10,11,12]}",
        "supports=[{at: {u: 0, v: [0,0.5]}, fix: xyz, path: [[0,0,0,0],[1,2,3,4]]}, "
        "{at: {u: 1, w: [0.5,1]}, fix: xz}]",
        "loads=[{at: {u: [0.5,1]}, force: [1,2,3]}, {at: {v: 1}, force: [4,5,6]}]",
        "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1], friction: 0.5}}, "
        "{sphere: {center: [0,0,-2], radius: 0.25, friction: 0.75}}]"};
    static const char want[] = "sheet 1 1 0.0011770000000000001\n"
                               "shape flat\n"
                               "origin 0 0 0\n"
                               "u 1 0 0\n"
                               "v 0 1 0\n"
                               "material 100000 0.29999999999999999 0.5\n"
                               "gravity 0 0 -9.8100000000000005\n"
                               "drag 3\n"
                               "wind 4 5 6\n"
                               "velocity 7 8 9\n"
                               "spin 10 11 12\n"
                               "damping rayleigh\n"
                               "rayleigh 1 2\n"
                               "support fix 7\n"
                               "support from 0 0 0\n"
                               "support to 0 0.5 1\n"
                               "support path 0 0 0 0\n"
                               "support path 1 2 3 4\n"
                               "support fix 5\n"
                               "support from 1 0 0.5\n"
                               "support to 1 1 1\n"
                               "load from 0.5 0 0\n"
                               "load to 1 1 1\n"
                               "load force 1 2 3\n"
                               "load from 0 1 0\n"
                               "load to 1 1 1\n"
                               "load force 4 5 6\n"
                               "plane 0 0 -1\n"
                               "normal 0 0 1\n"
                               "friction 0.5\n"
                               "sphere 0 0 -2\n"
                               "radius 0.25\n"
                               "friction 0.75\n";
    char *text = physics_of("edge_drop", sizeof all / sizeof *all, all);

    if (!CHECK(!strcmp(text, want)))
        printf("%s", text);
    free(text);
}

/* Another scene than a text is of is told by what differs first. */
static void physics_told(void)
{
    static const char *const held = HELD("u: 0, v: [0.25,0.75]");
    char *text = physics_of("edge_drop", 1, &held);
    struct scene s = {0};
    struct settings settings = {0};
    struct message why = {""};
    char *path = NULL;

    REQUIRE(scene_file_find("edge_drop", &path, NULL) == STATUS_OK);
    settings_set(&settings, held);
    REQUIRE(contestant_read_scene(&settings, path, &s, NULL) == STATUS_OK);
    CHECK(truth_physics_check(text, &s, &why) == STATUS_OK && !*why.text);
    s.poisson = 0.25;
    CHECK(truth_physics_check(text, &s, &why) == STATUS_UNSUPPORTED);
    CHECK(!strcmp(why.text, "of other physics: material 100000 0.3 0.5, not "
                            "material 100000 0.25 0.5"));
    s.poisson = 0.3, s.supports[0].hi[1] = 0.5;
    CHECK(truth_physics_check(text, &s, &why) == STATUS_UNSUPPORTED);
    CHECK(!strcmp(why.text, "of other physics: support to 0 0.75 1, not "
                            "support to 0 0.5 1"));
    s.supports[0].hi[1] = 0.75, s.support_count = 0;
    CHECK(truth_physics_check(text, &s, &why) == STATUS_UNSUPPORTED);
    CHECK(!strcmp(why.text, "of other physics: support fix 7, not nothing"));
    s.support_count = 1;
    scene_clear(&s);
    settings_clear(&settings);
    free(path);
    free(text);
}

int main(void)
{
    physics();
    physics_whole();
    physics_told();
    return check_result();
}
