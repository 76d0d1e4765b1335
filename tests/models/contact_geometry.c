/* Distances and normals of bodies, and their poses. */
#include "models/contact/contact_rest.h"
#include "models/bodies/body_shape.h"

#include "tests/check.h"
#include "tests/noise.h"

/* A few roundings of numbers near 1. */
static const double rounding = 1e-15;
/* Second order of a central difference with steps of 1e-5 a tenth from a centre, and its
 * cancellation. */
static const double difference = 4e-9;

enum { BODIES = 4 };
/* Shapes with an edge, a face, an end each within reach of `near_body`. */
static const struct scene_obstacle body[BODIES] = {
    {.kind = OBSTACLE_PLANE, .point = {1, 2, 3}, .normal = {0, 3, 4}},
    {.kind = OBSTACLE_SPHERE, .point = {1, 0, -1}, .radius = 0.5},
    {.kind = OBSTACLE_CAPSULE, .point = {0, 0, -1}, .end = {1, 0.5, 0}, .radius = 0.3},
    {.kind = OBSTACLE_BOX,
     .point = {1, 0, -1},
     .size = {0.5, 1, 1.5},
     .axis = {{0.6, 0, 0.8}, {0, 1, 0}}},
};
static const struct scene_obstacle *const slope = &body[0], *const ball = &body[1];

/* A third of a turn about (1,1,1) through (1,0,0), from time 2 to 4, on the way up. */
static double turn_table[2][2] = {{2, 0}, {4, 120}};
static double path_table[2][4] = {{2, 0, 0, 0}, {4, 0, 0, 3}};
static const double turn_axis[3] = {0.57735026918962573, 0.57735026918962573,
                                    0.57735026918962573};

static struct scene_obstacle moving(const struct scene_obstacle *o)
{
    struct scene_obstacle m = *o;

    m.motion.path_count = m.motion.turn_count = 2, m.motion.path = path_table,
    m.motion.turn = turn_table;
    memcpy(m.motion.axis, turn_axis, sizeof m.motion.axis);
    memcpy(m.motion.about, (double[3]){1, 0, 0}, sizeof m.motion.about);
    return m;
}

/* That turn of 120 degrees sends x to y, y to z, z to x. */
static void move_point(const double x[3], double y[3])
{
    y[0] = x[2] + 1, y[1] = x[0] - 1, y[2] = x[1] + 3;
}

static void turn_direction(const double x[3], double y[3])
{
    y[0] = x[2], y[1] = x[0], y[2] = x[1];
}

static void near_body(int n, double x[3])
{
    for (int i = 0; i < 3; i++)
        x[i] = (double[3]){0.5, 0, -0.5}[i] + noise_at(3 * n + i);
}

/* The normal is the distance's gradient, of length one, the nearest point is on the
 * surface, and a convex body is behind the tangent plane: these make a distance exact. */
static void check_distance(const struct scene_obstacle *o,
                           const struct scene_placement *pose, const double x[3])
{
    double n[3], foot[3], step = 1e-5;
    const double distance = body_shape_distance(o, pose, x, n);

    CHECK_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, rounding);
    for (int i = 0; i < 3; i++) {
        double ahead[3] = {x[0], x[1], x[2]}, behind[3] = {x[0], x[1], x[2]};
        ahead[i] += step;
        behind[i] -= step;
        double slope_i = (body_shape_distance(o, pose, ahead, NULL) -
                          body_shape_distance(o, pose, behind, NULL));
        CHECK_NEAR(slope_i / (2 * step), n[i], difference);
        foot[i] = x[i] - distance * n[i];
    }
    CHECK_NEAR(body_shape_distance(o, pose, foot, NULL), 0, 8 * rounding);
    CHECK(body_shape_near(o, pose, x, distance + step, NULL) == distance);
    CHECK(body_shape_near(o, pose, x, distance - step, NULL) >= distance - step);
    for (int c = 0; c < 27; c++) {
        double s[3] = {0.4 * (c % 3 - 1), 0.4 * (c / 3 % 3 - 1), 0.4 * (c / 9 - 1)};
        double y[3] = {x[0] + s[0], x[1] + s[1], x[2] + s[2]};
        double tangent = distance + n[0] * s[0] + n[1] * s[1] + n[2] * s[2];
        CHECK(body_shape_distance(o, pose, y, NULL) >= tangent - 8 * rounding);
    }
}

/* Far from the ridges inside, where the gradient jumps. */
static bool is_smooth(const struct scene_obstacle *o, const double x[3])
{
    double n[3], m[3], y[3], most = 0;

    body_shape_distance(o, NULL, x, n);
    for (int i = 0; i < 3; i++) {
        memcpy(y, x, sizeof y);
        y[i] += 1e-4;
        body_shape_distance(o, NULL, y, m);
        for (int k = 0; k < 3; k++)
            most = fmax(most, fabs(m[k] - n[k]));
    }
    return most < 0.01;
}

static void check_shapes(void)
{
    for (int k = 0; k < BODIES; k++) {
        int inside = 0, outside = 0;
        for (int n = 0; n < 200; n++) {
            double x[3], y[3];
            struct scene_placement pose;
            const struct scene_obstacle o = moving(&body[k]);
            near_body(n, x);
            if (!is_smooth(&o, x))
                continue;
            check_distance(&o, NULL, x);
            scene_motion_at(&o.motion, 4, &pose);
            move_point(x, y);
            check_distance(&o, &pose, y);
            inside += body_shape_distance(&o, NULL, x, NULL) < 0;
            outside += body_shape_distance(&o, NULL, x, NULL) > 0;
        }
        CHECK(inside > 3 && (outside > 50 || k == 0));
    }
}

/* A body in a pose is the body whose own places and directions are turned. */
static void check_pose(void)
{
    for (int k = 0; k < BODIES; k++) {
        struct scene_obstacle o = moving(&body[k]), other = body[k];
        struct scene_placement pose, early, middle;
        double y[3], back[3], n[3], m[3];
        move_point(o.point, other.point);
        move_point(o.end, other.end);
        turn_direction(o.normal, other.normal);
        turn_direction(o.axis[0], other.axis[0]);
        turn_direction(o.axis[1], other.axis[1]);
        scene_motion_at(&o.motion, 9, &pose);
        scene_motion_at(&o.motion, 1, &early);
        scene_motion_at(&o.motion, 3, &middle);
        for (int c = 0; c < 60; c++) {
            double x[3];
            near_body(c, x);
            move_point(x, y);
            CHECK_NEAR(body_shape_distance(&o, &pose, y, n),
                       body_shape_distance(&other, NULL, y, m), 8 * rounding);
            for (int i = 0; i < 3 && is_smooth(&o, x); i++)
                CHECK_NEAR(n[i], m[i], 8 * rounding);
            CHECK(body_shape_distance(&o, &early, x, NULL) ==
                  body_shape_distance(&o, NULL, x, NULL));
            body_shape_carry(&pose, &early, y, back);
            for (int i = 0; i < 3; i++)
                CHECK_NEAR(back[i], x[i], 8 * rounding);
            body_shape_carry(&early, &middle, x, back);
            CHECK_NEAR(body_shape_distance(&o, &middle, back, NULL),
                       body_shape_distance(&o, NULL, x, NULL), 8 * rounding);
        }
    }
}

static void check_least(void)
{
    struct scene scene;
    struct scene_obstacle lift = moving(slope);
    double x[3][3] = {{1, 2, 4}, {1, 0, 0}, {5, 5, 5}};

    REQUIRE(scene_init(&scene) == STATUS_OK);
    CHECK(body_shape_least_gap(&scene, 0, 3, x[0]) == INFINITY);
    REQUIRE(scene_add_obstacle(&scene, slope) == STATUS_OK);
    CHECK_NEAR(body_shape_least_gap(&scene, 0, 1, x[0]), 0.8, rounding);
    CHECK_NEAR(body_shape_least_gap(&scene, 0, 3, x[0]), -3.6, 4 * rounding); /* (1,0,0) */
    REQUIRE(scene_add_obstacle(&scene, ball) == STATUS_OK);
    CHECK_NEAR(body_shape_least_gap(&scene, 0, 1, x[1]), -3.6, 4 * rounding);
    CHECK(body_shape_least_gap(&scene, 0, 0, x[0]) == INFINITY);
    lift.motion.turn_count = 0;
    REQUIRE(scene_add_obstacle(&scene, &lift) == STATUS_OK);
    CHECK_NEAR(body_shape_least_gap(&scene, 3, 1, x[0]), 0.8 - 1.5 * 0.8, 4 * rounding);
    x[2][1] = NAN;
    CHECK(isnan(body_shape_least_gap(&scene, 0, 3, x[0])));
    scene_clear(&scene);
}

/* The depth of a sheet is that of the deepest of many of its points: flat and on a cloak,
 * beside and across planes and balls, a ball between the lines of any net, too. */
static void check_depth(bool cloak)
{
    enum { N = 400 };
    struct scene s;
    int inside = 0;

    REQUIRE(scene_init(&s) == STATUS_OK);
    memcpy(s.axis_u, (double[3]){0.6, 0, 0.8}, sizeof s.axis_u);
    memcpy(s.origin, (double[3]){0.2, -0.1, 0.3}, sizeof s.origin);
    if (cloak)
        s.shape = SCENE_CLOAK, s.opening = 200, s.flare = 15;
    for (int n = 0; n < 60; n++) {
        struct scene_obstacle o = {.kind = n % OBSTACLE_MESH,
                                   .radius = n % OBSTACLE_MESH ? 0.02 + 0.01 * (n % 7) : 0,
                                   .size = {0.03, 0.2, 0.1},
                                   .axis = {{0, 0, 1}, {0.8, 0.6, 0}}};
        const bool exact = o.kind == OBSTACLE_PLANE || o.kind == OBSTACLE_SPHERE;
        double least = INFINITY;
        for (int i = 0; i < 3; i++) {
            o.point[i] = sin(1 + 7 * n + 3 * i);
            o.normal[i] = cos(2 + 5 * n + 4 * i);
            o.end[i] = o.point[i] + 0.2 * o.normal[i];
        }
        if (n % 3 == 0)
            scene_rest_point(&s, (double[3]){0.5 + 0.49 * sin(n), 0.5 + 0.49 * cos(n), 0.5},
                             o.point);
        for (int k = 0; k <= N; k++)
            for (int j = 0; j <= N; j++) {
                double x[3];
                scene_rest_point(&s, (double[3]){(double)k / N, (double)j / N, 0.5}, x);
                least = fmin(least, body_shape_distance(&o, NULL, x, NULL));
            }
        const double want = fmax(s.thickness / 2 - least, 0);
        const double depth = contact_rest_depth(&s, &o);
        CHECK(depth >= want - (exact ? 1e-12 : 0.01)); /* half a cell's diagonal */
        CHECK(depth <= want + 4.0 / N);                /* the points' spacing */
        inside += depth > 0;
    }
    CHECK(inside > 20 && inside < 50);
    scene_clear(&s);
}

/* Numbers by hand: on, off and in each shape, and a normal where many are right. */
static void check_values(void)
{
    static const struct {
        int body;
        double x[3], distance, normal[3];
    } row[] = {
        {0, {0, 2, 2}, -0.8, {0, 0.6, 0.8}},
        {1, {4, 4, -1}, 4.5, {0.6, 0.8, 0}},
        {1, {1, 0, -1}, -0.5, {0, 0, 1}},
        {2,
         {0, -2, -1.5},
         1.7615528128088303,
         {0, -0.97014250014533188, -0.24253562503633297}},
        {3, {1.6, 0, -0.2}, 0.75, {0.6, 0, 0.8}},
        {3, {1.12, 0, -0.84}, -0.05, {0.6, 0, 0.8}},
        {3,
         {1.39, 0.9, -0.48},
         0.56568542494923801,
         {0.42426406871192851, 0.70710678118654757, 0.56568542494923801}},
    };
    double n[3];

    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const double distance = body_shape_distance(&body[row[k].body], NULL, row[k].x, n);
        CHECK_NEAR(distance, row[k].distance, 2 * rounding);
        for (int i = 0; i < 3; i++)
            CHECK_NEAR(n[i], row[k].normal[i], 2 * rounding);
    }
    /* on a capsule's axis: across it */
    CHECK_NEAR(body_shape_distance(&body[2], NULL, (double[3]){0.5, 0.25, -0.5}, n), -0.3,
               rounding);
    CHECK_NEAR(n[0] + 0.5 * n[1] + n[2], 0, rounding);
    for (int k = 0; k < BODIES; k++)
        CHECK(isnan(body_shape_distance(&body[k], NULL, (double[3]){0, NAN, 0}, n)));
}

int main(void)
{
    check_values();
    check_shapes();
    check_pose();
    check_least();
    check_depth(false);
    check_depth(true);
    return check_result();
}
