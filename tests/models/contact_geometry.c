/* Gaps and normals of obstacles. */
#include "models/contact/contact_shape.h"

#include <math.h>
#include <string.h>

#include "tests/check.h"

/* A few roundings of numbers near 1. */
static const double rounding = 1e-15;
/* Second order of a central difference with steps of 1e-5, and its cancellation. */
static const double difference = 1e-9;

static const struct scene_obstacle slope = {
    .kind = OBSTACLE_PLANE, .point = {1, 2, 3}, .normal = {0, 3, 4}};
static const struct scene_obstacle ball = {
    .kind = OBSTACLE_SPHERE, .point = {1, 0, -1}, .radius = 0.5};

/* The normal is the gap's gradient, of length one. */
static void check_gradient(const struct scene_obstacle *o, const double x[3])
{
    double n[3], step = 1e-5;

    contact_shape_distance(o, NULL, x, n);
    CHECK_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, rounding);
    for (int i = 0; i < 3; i++) {
        double ahead[3] = {x[0], x[1], x[2]}, behind[3] = {x[0], x[1], x[2]};
        ahead[i] += step;
        behind[i] -= step;
        double slope_i = (contact_shape_distance(o, NULL, ahead, NULL) -
                          contact_shape_distance(o, NULL, behind, NULL));
        CHECK_NEAR(slope_i / (2 * step), n[i], difference);
    }
}

/* Outside a convex body the tangent plane underestimates the gap. */
static void check_convex(const struct scene_obstacle *o, const double x[3])
{
    double n[3], gap = contact_shape_distance(o, NULL, x, n);

    for (int c = 0; c < 27; c++) {
        double s[3] = {0.4 * (c % 3 - 1), 0.4 * (c / 3 % 3 - 1), 0.4 * (c / 9 - 1)};
        double y[3] = {x[0] + s[0], x[1] + s[1], x[2] + s[2]};
        double tangent = gap + n[0] * s[0] + n[1] * s[1] + n[2] * s[2];
        CHECK(contact_shape_distance(o, NULL, y, NULL) >= tangent - rounding);
    }
}

static void check_least(void)
{
    struct scene scene;
    double x[3][3] = {{1, 2, 4}, {1, 0, 0}, {5, 5, 5}};

    REQUIRE(scene_init(&scene) == STATUS_OK);
    CHECK(contact_least_gap(&scene, 0, 3, x[0]) == INFINITY);
    REQUIRE(scene_add_obstacle(&scene, &slope) == STATUS_OK);
    CHECK_NEAR(contact_least_gap(&scene, 0, 1, x[0]), 0.8, rounding);
    CHECK_NEAR(contact_least_gap(&scene, 0, 3, x[0]), -3.6, 4 * rounding); /* (1,0,0) */
    REQUIRE(scene_add_obstacle(&scene, &ball) == STATUS_OK);
    CHECK_NEAR(contact_least_gap(&scene, 0, 1, x[1]), -3.6, 4 * rounding);
    CHECK(contact_least_gap(&scene, 0, 0, x[0]) == INFINITY);
    x[2][1] = NAN;
    CHECK(isnan(contact_least_gap(&scene, 0, 3, x[0])));
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
        struct scene_obstacle o = {.kind = n % 2 ? OBSTACLE_SPHERE : OBSTACLE_PLANE,
                                   .radius = n % 2 ? 0.02 + 0.01 * (n % 7) : 0};
        double least = INFINITY;
        for (int i = 0; i < 3; i++) {
            o.point[i] = sin(1 + 7 * n + 3 * i);
            o.normal[i] = cos(2 + 5 * n + 4 * i);
        }
        if (n % 3 == 0)
            scene_rest_point(&s, (double[3]){0.5 + 0.49 * sin(n), 0.5 + 0.49 * cos(n), 0.5},
                             o.point);
        for (int k = 0; k <= N; k++)
            for (int j = 0; j <= N; j++) {
                double x[3];
                scene_rest_point(&s, (double[3]){(double)k / N, (double)j / N, 0.5}, x);
                least = fmin(least, contact_shape_distance(&o, NULL, x, NULL));
            }
        const double want = fmax(s.thickness / 2 - least, 0);
        const double depth = contact_rest_depth(&s, &o);
        CHECK(depth >= want - 1e-12 && depth <= want + 4.0 / N); /* the points' spacing */
        inside += depth > 0;
    }
    CHECK(inside > 20 && inside < 55);
    scene_clear(&s);
}

int main(void)
{
    const double near[3] = {1.2, 0.6, -0.3}, centre[3] = {1, 0, -1};
    double n[3];

    CHECK_NEAR(contact_shape_distance(&slope, NULL, (double[3]){7, 2, 3}, n), 0, rounding);
    CHECK_NEAR(n[1], 0.6, rounding);
    CHECK_NEAR(n[2], 0.8, rounding);
    CHECK_NEAR(contact_shape_distance(&slope, NULL, (double[3]){0, 2, 2}, NULL), -0.8,
               rounding);
    CHECK_NEAR(contact_shape_distance(&ball, NULL, (double[3]){4, 4, -1}, n), 4.5,
               rounding);
    CHECK_NEAR(n[0], 0.6, rounding);
    CHECK_NEAR(contact_shape_distance(&ball, NULL, centre, n), -0.5, 0);
    CHECK(n[0] == 0 && n[1] == 0 && n[2] == 1);
    check_gradient(&slope, near);
    check_gradient(&ball, near);
    check_convex(&slope, near);
    check_convex(&ball, near);
    check_least();
    check_depth(false);
    check_depth(true);
    return check_result();
}
