/* A motion is the same far away, turned, mirrored, and in other units: every contestant, on
 * scenes without contact. What is exactly alike:
 *
 *   moved     all places by the same way; a velocity at the start that is that of a turn
 *             about the scene's origin less what the way adds to it
 *   turned    all places and directions, the gravity's, too
 *   mirrored  the same across a plane; the axis of a turn is no arrow, and is turned round
 *             (a cloak would have v the other way round, and is left out)
 *   scaled    lengths by s, times by sqrt(s), the gravity as it is: then accelerations are
 *             as they were, velocities go with sqrt(s), rates with 1 / sqrt(s), forces with
 *             s^3 and stresses with s, at the same density
 *   heavier   masses, stiffnesses and forces by 7: accelerations are as they were
 *
 * And single precision falls for a hundred seconds as double does.
 *   similar [KINDS]    the first of the above only, and no long fall
 */
#include <float.h>

#include "tests/opened_run.h"
#include "tests/run_fixture.h"

enum { FRAMES = 20, SIDE = 7, NODES = SIDE * SIDE };

enum kind { MOVED, QUARTER, FLIPPED, TURNED, MIRRORED, HEAVIER, SMALLER, LARGER, KINDS };
static const char *const kind_name[KINDS] = {"moved",
                                             "turned by quarters",
                                             "mirrored across an axis",
                                             "turned",
                                             "mirrored",
                                             "heavier",
                                             "smaller",
                                             "larger"};

/* How far places may be from where they should be, over the length. In double precision a
 * velocity that is a way over a step gains a rounding of a place in each step, and after N
 * steps N^2 / 2 roundings, all one way, are in the place: 20000 of the 200 steps that
 * FRAMES frames of vertex block descent take. A place is rounded by DBL_EPSILON of how far
 * it is from the scene's origin. */
#define AWAY 1e4 /* [m] */
static const double ROUNDINGS = 20000;

/* In single precision: a hundred times its last digit. */
static const double SINGLE = 1e-5;

/* The fall, over the length. The first four lengths are counted from the scene's origin
 * (net_origin.h): within .9 s velocities come to 9 m/s, where rounding is 4.8e-7 m/s, in
 * 900 steps of a millisecond, and the fall goes on for a hundred seconds. */
static const double FALLEN = 0.05;

#define SHEET                                                                              \
    "sheet={length: 1, width: 0.8, thickness: 0.02};material={young: 2e4, poisson: 0.3, "  \
    "density: 20};time={step: 0.004, end: 0.1};snapshots=[];"
#define TUBE                                                                               \
    "sheet={length: 0.2, width: 0.6, thickness: 0.001};material={young: 1e6, poisson: "    \
    "0.3, density: 1000};pose={kind: cloak, origin: [0.5, 0.2, 0.1], u: [0, 0, -1], "      \
    "v: [0, 1, 0], opening: 360, flare: 0};snapshots=[];time={step: 0.004, end: 0.1};"
static const struct {
    const char *name, *settings, *file; /* NULL: edge_drop */
} scenes[] = {
    {"held", SHEET "damping={kind: mass, value: 1}"},
    {"loaded", SHEET "damping={kind: rayleigh, alpha: 0.5, beta: 0.001};"
                     "loads=[{at: {u: 1}, force: [0.2, 0.5, 1]}]"},
    {"thrown",
     SHEET "damping={kind: none};supports=[];drag={coefficient: 10, wind: [2, 1, 1]};"
           "motion={velocity: [1, 2, 3], spin: [0.5, -1, 2]}"},
    {"carried", SHEET
     "damping={kind: velocity_scale, value: 0.9};supports=[{at: {u: 0}, fix: xyz, path: "
     "[[0, 0, 0, 0], [0.03, 0.02, 0.01, 0.05]]}]"},
    {"turned by its clamp", SHEET
     "damping={kind: mass, value: 1};supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], "
     "[0.08, 0.02, 0.01, 0.05]], turn: {axis: [0.6, 0.8, 0], about: [0.1, 0, 0.2], angles: "
     "[[0, 0], [0.08, 10]]}}]"},
    {"woven",
     "sheet={length: 1, width: 0.8};material={membrane: [100, 50, 5, 10], bending: [2e-3, "
     "1e-3, 1e-4, 5e-4], areal_density: 0.1, warp: 30};snapshots=[];time={step: 0.004, "
     "end: 0.1};damping={kind: velocity_rate, value: 2}"},
    {"several",
     SHEET "obstacles=[];contact={self: false};sheets=[{origin: [0, 0, 0], v: [0, 1, 0]}, "
           "{origin: [0.1, 0.2, 0.3], u: "
           "[0, 1, 0], v: [0, 0, 1]}];damping={kind: none}",
     SCENES "stack.yaml"},
    {"tube", TUBE "damping={kind: mass, value: 20};pressure=-500;supports=[{at: {u: 0}, "
                  "fix: xyz}, {at: {u: 1}, fix: xyz}]"},
};

static void map(const double M[3][3], double x[3])
{
    const double old[3] = {x[0], x[1], x[2]};

    for (int i = 0; i < 3; i++)
        x[i] = M[i][0] * old[0] + M[i][1] * old[1] + M[i][2] * old[2];
}

/* Maps all that has a direction; `mirror`: M turns it round. */
static void direct(struct scene *s, const double M[3][3], double mirror)
{
    for (int n = 0; n < scene_sheets(s); n++)
        map(M, s->pose[n].origin), map(M, s->pose[n].axis_u), map(M, s->pose[n].axis_v);
    map(M, s->gravity), map(M, s->wind), map(M, s->velocity), map(M, s->spin);
    for (int i = 0; i < 3; i++)
        s->spin[i] *= mirror;
    for (int n = 0; n < s->load_count; n++)
        map(M, s->loads[n].force);
    for (int n = 0; n < s->support_count; n++) {
        struct scene_motion *motion = &s->supports[n].motion;
        for (int k = 0; k < motion->path_count; k++)
            map(M, motion->path[k] + 1);
        map(M, motion->axis), map(M, motion->about);
        for (int i = 0; i < 3; i++)
            motion->axis[i] *= mirror;
    }
}

static void scale(struct scene *s, double by)
{
    const double time = sqrt(by);

    s->length *= by, s->width *= by, s->thickness *= by, s->young *= by;
    s->step *= time, s->end *= time;
    s->drag /= time, s->damping.alpha /= time, s->damping.beta *= time;
    if (s->damping.kind != DAMPING_VELOCITY_SCALE)
        s->damping.value /= time;
    s->pressure *= by;
    for (int n = 0; n < LAW_MODULI; n++)
        s->fabric.membrane[n] *= by * by, s->fabric.bending[n] *= by * by * by * by;
    s->fabric.areal_density *= by;
    for (int n = 0; n < 3 * scene_sheets(s); n++)
        s->pose[n / 3].origin[n % 3] *= by;
    for (int i = 0; i < 3; i++) {
        s->wind[i] *= time, s->velocity[i] *= time, s->spin[i] /= time;
        for (int n = 0; n < s->load_count; n++)
            s->loads[n].force[i] *= by * by * by;
        for (int n = 0; n < s->support_count; n++)
            for (int k = 0; k < s->supports[n].motion.path_count; k++)
                s->supports[n].motion.path[k][1 + i] *= by;
    }
    for (int n = 0; n < s->support_count; n++) {
        struct scene_motion *motion = &s->supports[n].motion;
        for (int k = 0; k < motion->path_count; k++)
            motion->path[k][0] *= time;
        for (int k = 0; k < motion->turn_count; k++)
            motion->turn[k][0] *= time;
        for (int i = 0; i < 3; i++)
            motion->about[i] *= by;
    }
}

static void make_heavier(struct scene *s)
{
    const double by = 7;

    s->young *= by, s->density *= by, s->drag *= by, s->pressure *= by;
    for (int n = 0; n < LAW_MODULI; n++)
        s->fabric.membrane[n] *= by, s->fabric.bending[n] *= by;
    s->fabric.areal_density *= by;
    for (int n = 0; n < 3 * s->load_count; n++)
        s->loads[n / 3].force[n % 3] *= by;
}

static const double way[3] = {AWAY, -AWAY, AWAY};
static const double matrix[KINDS][3][3] = {
    [QUARTER] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
    [FLIPPED] = {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    [TURNED] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}},
    [MIRRORED] = {{0.28, -0.96, 0}, {-0.96, -0.28, 0}, {0, 0, 1}},
};
static const double scales[2] = {1e-3, 1e3};

static void change(struct scene *s, enum kind kind)
{
    if (kind == MOVED) {
        const double *w = s->spin;
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            for (int n = 0; n < scene_sheets(s); n++)
                s->pose[n].origin[i] += way[i];
            for (int n = 0; n < s->support_count; n++)
                s->supports[n].motion.about[i] += way[i];
            s->velocity[i] -= w[j] * way[k] - w[k] * way[j];
        }
    } else if (kind == HEAVIER) {
        make_heavier(s);
    } else if (kind < SMALLER) {
        direct(s, matrix[kind], kind == TURNED || kind == QUARTER ? 1 : -1);
    } else {
        scale(s, scales[kind - SMALLER]);
    }
}

/* Maps a point as the scene was changed. */
static void follow(double x[3], enum kind kind)
{
    if (kind != MOVED && kind < HEAVIER)
        map(matrix[kind], x);
    for (int i = 0; i < 3; i++)
        x[i] = kind == MOVED     ? x[i] + way[i]
               : kind >= SMALLER ? x[i] * scales[kind - SMALLER]
                                 : x[i];
}

/* Returns whether a contestant has a setting. */
static bool has(const struct contestant *c, const char *setting)
{
    for (int n = 0; n < CONTESTANT_SETTINGS && c->settings[n]; n++)
        if (strstr(c->settings[n], setting))
            return true;
    return false;
}

/* Moves a contestant through a scene with settings, changed so or as it is (KINDS), for so
 * many frames. Returns false where it does not serve it; ends the test where it dies. */
static bool move(const struct contestant *c, const char *scene, const char *settings,
                 enum kind kind, int frames, double (*x)[3])
{
    struct case_plan plan = {scene, c, {0}, 0};
    struct message why = {""};
    struct run run;

    set_words(&plan.settings, settings);
    contestant_points(c, 6, 5, &plan.settings);
    REQUIRE_SAY(run_read(&run, &plan, &why) == STATUS_OK, "%s: %s", c->name, why.text);
    settings_clear(&plan.settings);
    if (kind < KINDS)
        change(&run.scene, kind);
    const enum status st = run_build(&run, &why);
    CHECK_SAY(st == STATUS_OK || (st == STATUS_UNSUPPORTED && kind == KINDS), "%s: %s",
              c->name, why.text);
    if (st == STATUS_OK)
        opened_steps(&run, frames);
    for (int n = 0; st == STATUS_OK && n < NODES; n++) {
        const double uvw[3] = {n / SIDE / (SIDE - 1.), n % SIDE / (SIDE - 1.), 0.5};
        run.model->probe(run.state, 1, uvw, x[n]);
    }
    run_close(&run);
    return st == STATUS_OK;
}

static double apart(double (*x)[3], double (*y)[3])
{
    double most = 0;

    for (int n = 0; n < 3 * NODES; n++)
        if (!(fabs(x[n / 3][n % 3] - y[n / 3][n % 3]) <= most))
            most = fabs(x[n / 3][n % 3] - y[n / 3][n % 3]);
    return most;
}

/* The paper's set has the same numbers of stiffness and mass for every sheet: in other
 * units they are others. */
static void check_scene(const struct contestant *c, int scene, int kinds)
{
    static double x[NODES][3], y[NODES][3];
    const char *file = scenes[scene].file ? scenes[scene].file : DROP;
    const bool single = has(c, "precision=single");

    if (!move(c, file, scenes[scene].settings, KINDS, FRAMES, x))
        return;
    for (int k = 0; k < (has(c, "parameters=paper") ? HEAVIER : KINDS) && k < kinds; k++) {
        if ((k == MIRRORED || k == FLIPPED) && strstr(scenes[scene].settings, "cloak"))
            continue;
        double want[NODES][3];
        move(c, file, scenes[scene].settings, (enum kind)k, FRAMES, y);
        memcpy(want, x, sizeof want);
        for (int n = 0; n < NODES; n++)
            follow(want[n], (enum kind)k);
        const double off = apart(y, want) / (k >= SMALLER ? scales[k - SMALLER] : 1);
        const double far = k == MOVED ? AWAY : 1;
        const double allowed = single ? SINGLE : ROUNDINGS * DBL_EPSILON * far;
        SAY_UNLESS(CHECK_NEAR(off, 0, allowed), "%s, %s, %s", c->name, scenes[scene].name,
                   kind_name[k]);
    }
}

static void check_fall(const struct contestant *c)
{
    static double x[NODES][3], y[NODES][3];
    static const char fall[] = SHEET "damping={kind: none};supports=[];"
                                     "time={step: 0.05, end: 100}";
    char twice[sizeof fall + 64];

    snprintf(twice, sizeof twice, "%s;discretization.precision=double", fall);
    REQUIRE(move(c, DROP, fall, KINDS, 2000, x) && move(c, DROP, twice, KINDS, 2000, y));
    SAY_UNLESS(CHECK_NEAR(apart(x, y), 0, FALLEN), "%s falls", c->name);
}

int main(int argc, char **argv)
{
    const int kinds = argc > 1 ? atoi(argv[1]) : KINDS;

    for (const struct contestant *c = contestant_table; c->name; c++) {
        for (int s = 0; s < LENGTH(scenes); s++)
            check_scene(c, s, kinds);
        if (has(c, "precision=single") && kinds == KINDS)
            check_fall(c);
    }
    return check_result();
}
