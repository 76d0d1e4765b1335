/* Solids among obstacles, beside contact_truth: what their kinematics promise each. */
#include "fem_ref/hex_model.h"
#include "iga/plate_model.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/check.h"

/* Positions near 1 m, closed to 1e-13 of the scene's size. */
static const double closed = 1e-12;
/* Two forms of the same step, 30 of them, on systems of condition 1e5. */
static const double two_forms = 1e-10;

static double field[2][3 * GRID_POINTS];

/* A sheet of 0.5 x 0.4 m, turned by `tilt` about an oblique axis, a corner at the height
 * given. */
static void make_scene(struct scene *scene, double height, double tilt)
{
    double c = cos(tilt), s = sin(tilt);

    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 0.5;
    scene->width = 0.4;
    scene->thickness = 0.01;
    scene->origin[2] = height;
    memcpy(scene->axis_u, (double[3]){0.8 * c, 0.6, 0.8 * s}, sizeof scene->axis_u);
    memcpy(scene->axis_v, (double[3]){-0.6 * c, 0.8, -0.6 * s}, sizeof scene->axis_v);
    scene->young = 1e5;
    scene->poisson = 0.3;
    scene->density = 0.5;
    scene->gravity[2] = -9.81;
}

static void add_plane(struct scene *scene, double x, double z, double friction)
{
    struct scene_obstacle plane = {
        .kind = OBSTACLE_PLANE, .normal = {x, 0, z}, .friction = friction};
    REQUIRE(scene_add_obstacle(scene, &plane) == STATUS_OK);
}

static void add_ball(struct scene *scene, double x, double z, double friction)
{
    struct scene_obstacle ball = {
        .kind = OBSTACLE_SPHERE, .radius = 0.15, .friction = friction};
    ball.point[0] = x, ball.point[1] = 0.25, ball.point[2] = z;
    REQUIRE(scene_add_obstacle(scene, &ball) == STATUS_OK);
}

/* The paper's scheme lives by its damping. */
static void damp(struct scene *scene, enum kinematics kinematics)
{
    if (kinematics == KINEMATICS_PRINTED)
        scene->damping =
            (struct scene_damping){.kind = DAMPING_VELOCITY_SCALE, .value = 0.4};
}

static void *build(const struct model *model, const struct scene *scene,
                   enum kinematics kinematics)
{
    struct discretization d;
    struct message why = {{0}};
    void *state = NULL;

    model_defaults(model, &d);
    d.points[0] = 8;
    d.points[1] = 7;
    d.kinematics = kinematics;
    d.unknowns = UNKNOWNS_POINTS;
    if (!CHECK(model->create(scene, &d, &state, &why) == STATUS_OK))
        printf("%s\n", why.text);
    REQUIRE(state);
    return state;
}

/* No control point goes in, at no frame; the most that touched at once. */
static int check_gaps(const struct model *model, const struct scene *scene,
                      enum kinematics kinematics, int frames)
{
    void *state = build(model, scene, kinematics);
    struct counters counters = {0};
    int most = 0;

    for (int n = 0; n < frames; n++) {
        struct model_contact c;
        REQUIRE(CHECK(model->advance(state, &counters) == STATUS_OK));
        model->contact(state, &c);
        CHECK(c.least_gap >= -closed);
        most = c.nodes > most ? c.nodes : most;
    }
    model->sample(state, field[0]);
    CHECK(metric_blowup(scene, 0, field[0]) == STATUS_OK);
    model->destroy(state);
    return most;
}

/* On a floor, into a groove, and on a ball above a floor, with friction and without. */
static void check_falls(const struct model *model, enum kinematics kinematics)
{
    for (int n = 0; n < 6; n++) {
        struct scene scene;
        double friction = n < 3 ? 0 : 0.4;
        make_scene(&scene, n % 3 == 1 ? 0.4 : 0.06, 0.2);
        damp(&scene, kinematics);
        if (n % 3 == 1) {
            add_plane(&scene, 0.6, 0.8, friction);
            add_plane(&scene, -0.6, 0.8, friction);
            scene.origin[0] = -0.15;
        } else if (n % 3 == 2) {
            add_ball(&scene, 0.15, -0.22, friction);
            add_plane(&scene, 0, 1, friction);
            scene.obstacles[1].point[2] = -0.17;
        } else {
            add_plane(&scene, 0, 1, friction);
        }
        CHECK(check_gaps(model, &scene, kinematics, 50) > 0);
        scene_clear(&scene);
    }
}

/* An obstacle that is never reached changes nothing: not a bit where the step is the same,
 * round-off where it has another form. */
static void check_far(const struct model *model, enum kinematics kinematics)
{
    double worst = 0;

    for (int far = 0; far < 2; far++) {
        struct scene scene;
        struct counters counters = {0};
        make_scene(&scene, 0, 0.2);
        damp(&scene, kinematics);
        struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};
        REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
        if (far)
            add_ball(&scene, 0, -4, 0.5);
        void *state = build(model, &scene, kinematics);
        for (int n = 0; n < 30; n++)
            if (!CHECK(model->advance(state, &counters) == STATUS_OK))
                printf("%s, kinematics %d, far %d, frame %d\n", model->name, kinematics,
                       far, n);
        model->sample(state, field[far]);
        CHECK(kinematics != KINEMATICS_LINEAR || counters.factorisations == 2 - far);
        model->destroy(state);
        scene_clear(&scene);
    }
    for (int t = 0; t < 3 * GRID_POINTS; t++)
        worst = fmax(worst, fabs(field[0][t] - field[1][t]));
    if (kinematics != KINEMATICS_PRINTED)
        CHECK_NEAR(worst, 0, two_forms);
    else
        CHECK(worst == 0);
}

/* A flat sheet that meets the floor at the end of a frame, at the speed V, and whose
 * thickness is stiff: the next one would throw it back at V, and the impact then stops the
 * lower points. The two linear functions through the thickness, M = m/6 (2 1; 1 2), keep
 * momentum of what is free: 3/2 V above, 3/4 of the energy. */
static void check_impact(const struct model *model)
{
    struct scene scene;
    struct counters counters = {0};
    struct model_contact c;
    struct energy before, after;
    enum { FALL = 10 };
    /* of a frame's elastic give: rho h^2 / (E dt^2 / 4) = 1/12500, and Poisson's */
    const double give = 1e-3;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.thickness = 0.01;
    scene.young = 1e5;
    scene.density = 0.5;
    scene.gravity[2] = -9.81;
    scene.origin[2] =
        scene.thickness / 2 + 9.81 / 2 * pow(FALL * scene.step, 2) * (1 + 1e-9);
    add_plane(&scene, 0, 1, 0);
    void *state = build(model, &scene, KINEMATICS_LINEAR);
    for (int n = 0; n < FALL; n++)
        CHECK(model->advance(state, &counters) == STATUS_OK);
    model->energy(state, &before);
    model->contact(state, &c);
    CHECK(c.nodes == 0);
    CHECK(model->advance(state, &counters) == STATUS_OK);
    model->energy(state, &after);
    model->contact(state, &c);
    CHECK(c.nodes == 8 * 7);
    CHECK_NEAR(after.kinetic / before.kinetic, 0.75, give);
    model->destroy(state);
    scene_clear(&scene);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    const struct model *model = !strcmp(argv[1], "hex") ? &hex_model : &plate_model;

    for (int k = KINEMATICS_LINEAR; k <= KINEMATICS_INCREMENTAL; k++) {
        check_far(model, (enum kinematics)k);
        check_falls(model, (enum kinematics)k);
    }
    check_impact(model);
    return check_result();
}
