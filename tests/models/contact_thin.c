/* Features of thin bodies that meet the triangles between a net's points: which bodies have
 * any, force against the energy's gradient, and steps and changes that would carry a
 * feature through. */
#include "models/contact/contact.h"
#include "models/bodies/body_mesh.h"
#include "models/vector.h"
#include "tests/check.h"

enum { N = 5, NODES = N * N };
static const double spacing = 0.1, start = 0.001;

/* Sums of products of numbers near 1 N, or 1 m. */
static const double rounding = 1e-13;
/* Central differences of the energy at 1e-7 m, over the largest force. */
static const double differences = 1e-5;

static struct scene scene;

/* Makes the contact of a flat net of .4 m, at height 0, with one body. */
static void make(struct contact *c, const struct scene_obstacle *body, double (*x)[3])
{
    struct contact_surface s;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = scene.width = (N - 1) * spacing;
    scene.thickness = 2 * start, scene.density = 100;
    scene.gravity[2] = -10;
    scene.contact =
        (struct scene_contact){.thickness = 2 * start, .range = start, .stiffness = 1000};
    REQUIRE(scene_add_obstacle(&scene, body) == STATUS_OK);
    REQUIRE(contact_surface_init_net(&s, &scene, (int[2]){N, N}) == STATUS_OK);
    REQUIRE(contact_init(c, &scene, &s) == STATUS_OK);
    for (int n = 0; n < NODES; n++)
        x[n][0] = n / N * spacing, x[n][1] = n % N * spacing, x[n][2] = 0;
}

static void clear(struct contact *c)
{
    contact_clear(c);
    scene_clear(&scene);
}

static struct scene_obstacle ball(double x, double y, double z, double radius)
{
    return (struct scene_obstacle){
        .kind = OBSTACLE_SPHERE, .point = {x, y, z}, .radius = radius};
}

/* Returns a closed wedge or cone: a base of `corners` points around the origin, at depth
 * -height below the tips at 0: one, or two that are `edge` apart along y. */
static struct scene_obstacle cone(int corners, double radius, double height, double edge)
{
    double vertex[16][3];
    int triangle[32][3], count = 0;
    struct scene_obstacle o = {.kind = OBSTACLE_MESH, .scale = 1};

    if (edge > 0) { /* a ridge from vertex 4 to 5 over a rectangle */
        static const int wedge[8][3] = {{0, 1, 4}, {1, 2, 5}, {1, 5, 4}, {2, 3, 5},
                                        {3, 0, 4}, {3, 4, 5}, {2, 1, 0}, {3, 2, 0}};
        for (int n = 0; n < 6; n++) {
            vertex[n][0] = n > 3 ? 0 : n == 0 || n == 3 ? -radius : radius;
            vertex[n][1] = (n == 0 || n == 1 || n == 4 ? -edge : edge) / 2;
            vertex[n][2] = n > 3 ? 0 : -height;
        }
        memcpy(triangle, wedge, sizeof wedge);
        count = 8, corners = 5;
    } else {
        const double turn = 2 * 3.14159265358979 / corners;
        for (int n = 0; n < corners; n++) {
            vertex[n][0] = radius * cos(n * turn), vertex[n][1] = radius * sin(n * turn);
            vertex[n][2] = -height;
            memcpy(triangle[count++], (int[3]){n, (n + 1) % corners, corners},
                   sizeof *triangle);
            if (n > 1)
                memcpy(triangle[count++], (int[3]){0, n, n - 1}, sizeof *triangle);
        }
        memset(vertex[corners], 0, sizeof *vertex);
    }
    REQUIRE(body_mesh_make(corners + 1, (const double(*)[3])vertex, count,
                           (const int(*)[3])triangle, &o.mesh, NULL) == STATUS_OK);
    return o;
}

static void check_features(void)
{
    static const struct {
        double radius;
        int features;
    } balls[] = {{1.01 * 0.1, 0}, {0.99 * 0.1, 1}};
    const double tip[3] = {0, 0, 0};
    double x[NODES][3];
    struct contact c;

    for (int n = 0; n < 2; n++) {
        const struct scene_obstacle body = ball(0, 0, -1, balls[n].radius);
        make(&c, &body, x);
        CHECK(c.thin.count == balls[n].features);
        clear(&c);
    }
    struct scene_obstacle line = {
        .kind = OBSTACLE_CAPSULE, .point = {0, 0, -1}, .end = {0.4, 0, -1}, .radius = 0.01};
    make(&c, &line, x);
    CHECK(c.thin.count == 9); /* half a spacing apart */
    double area = 0;
    for (int n = 0; n < c.thin.count; n++)
        area += c.thin.feature[n].area;
    CHECK_NEAR(area, 0.4 * spacing, rounding);
    clear(&c);
    struct scene_obstacle box = {
        .kind = OBSTACLE_BOX, .size = {1, 1, 0.21}, .axis = {{1, 0, 0}, {0, 1, 0}}};
    make(&c, &box, x);
    CHECK(c.thin.count == 0);
    clear(&c);
    box.size[2] = 0.19;
    make(&c, &box, x);
    CHECK(c.thin.count > 8);
    clear(&c);
    struct scene_obstacle sharp = cone(8, 3, 5, 0);
    make(&c, &sharp, x); /* its flanks, 3 m thick, are none */
    bool has_tip = false;
    for (int n = 0; n < c.thin.count; n++)
        has_tip |= vector_distance(c.thin.feature[n].at, tip) == 0;
    CHECK(has_tip);
    clear(&c);
}

/* Compares forces with central differences of the energy on a bent net over a body. */
static void check_gradient(struct scene_obstacle body)
{
    const double step = 1e-7;
    double x[NODES][3], force[NODES][3] = {{0}}, most = 0, worst = 0;
    struct contact c;

    make(&c, &body, x);
    for (int n = 0; n < NODES; n++)
        x[n][2] = 1e-3 * sin(7. * n);
    contact_begin(&c, 0, INFINITY, x[0]);
    REQUIRE(contact_find(&c, x[0]) == STATUS_OK);
    CHECK(c.count > 0 && c.touch[0].sample < 0);
    contact_force(&c, force[0]);
    for (int k = 0; k < 3 * NODES; k++) {
        double energy[2];
        for (int side = 0; side < 2; side++) {
            (&x[0][0])[k] += side ? 2 * step : -step;
            REQUIRE(contact_find(&c, x[0]) == STATUS_OK);
            energy[side] = c.energy;
        }
        (&x[0][0])[k] -= step;
        most = fmax(most, fabs((&force[0][0])[k]));
        worst = fmax(worst, fabs((energy[0] - energy[1]) / (2 * step) - (&force[0][0])[k]));
    }
    CHECK(most > 0);
    CHECK_NEAR(worst / most, 0, differences);
    clear(&c);
}

/* Finds the foot in the middle of a triangle, and nothing from farther off. */
static void check_foot(void)
{
    const double z[] = {0.0108, 0.0111}, place[3] = {0.13, 0.16, 0};
    double x[NODES][3], at[3] = {0};

    for (int n = 0; n < 2; n++) {
        const struct scene_obstacle body = ball(place[0], place[1], z[n], 0.01);
        struct contact c;
        make(&c, &body, x);
        contact_begin(&c, 0, INFINITY, x[0]);
        REQUIRE(contact_find(&c, x[0]) == STATUS_OK);
        CHECK(c.count == (n == 0));
        if (c.count) {
            CHECK_NEAR(c.touch->D, z[0] - 0.01, rounding);
            CHECK_NEAR(c.touch->normal[2], -1, rounding);
            for (int k = 0; k < c.touch->count; k++)
                for (int i = 0; i < 3; i++)
                    at[i] += c.weight[k] * x[c.node[k]][i];
            CHECK_NEAR(vector_distance(at, place), 0, rounding);
        }
        clear(&c);
    }
}

/* Fills a row of the net, linear along u between its lines. */
static int row_between(const void *self, double u, double v, int *node, double *shape)
{
    const int i = (int)fmin(floor((N - 1) * u), N - 2), j = (int)lround((N - 1) * v);

    (void)self;
    node[0] = i * N + j, node[1] = node[0] + N;
    shape[1] = (N - 1) * u - i, shape[0] = 1 - shape[1];
    return 2;
}

/* A ball under a sample between the points of a net, as those of any mesh and of a smooth
 * surface are, meets this sample and none of the triangles around it. */
static void check_sample(bool smooth)
{
    const struct scene_obstacle body = ball(spacing / 2, spacing, -0.0105, 0.01);
    double x[NODES][3];
    struct contact c;

    make(&c, &body, x);
    contact_clear(&c);
    struct contact_surface s;
    REQUIRE(contact_surface_init_even(&s, &scene, NULL, row_between, 2, NODES,
                                      (int[2]){2 * N - 1, N}) == STATUS_OK);
    s.smooth = smooth;
    REQUIRE(contact_init(&c, &scene, &s) == STATUS_OK);
    REQUIRE(c.thin.count == 1);
    contact_begin(&c, 0, INFINITY, x[0]);
    REQUIRE(contact_find(&c, x[0]) == STATUS_OK);
    CHECK(c.count == 1 && c.touch[0].sample >= 0);
    clear(&c);
}

/* A change, and a step, that would carry the net 5 cm down through a body whose highest
 * point is at 0, 4 mm under it; and two steps that do, of which one is counted. */
static void check_passage(struct scene_obstacle body)
{
    static const double gap = 0.004, fall = 0.05, dt = 0.01;
    double x[NODES][3], d[NODES][3] = {{0}}, end[NODES][3], compliance[NODES];
    int held[3 * NODES] = {0};
    struct contact c;
    struct model_contact report;

    make(&c, &body, x);
    for (int n = 0; n < NODES; n++) {
        x[n][0] -= 0.13, x[n][1] -= 0.16, x[n][2] = gap;
        d[n][2] = -fall;
        compliance[n] = dt * dt / (scene.density * scene.thickness * c.area[n]);
    }
    contact_begin(&c, 0, dt, x[0]);
    REQUIRE(contact_find(&c, x[0]) == STATUS_OK);
    double cut[NODES][3];
    memcpy(cut, d, sizeof cut);
    const double share = contact_limit(&c, x[0], cut[0]);
    CHECK(share > 0 && gap - share * fall > 0);
    CHECK_NEAR(cut[NODES / 2][2], -share * fall, 1e-15);
    for (int k = 0; k < 3 * NODES; k++)
        (&end[0][0])[k] = (&x[0][0])[k] + (&d[0][0])[k];
    REQUIRE(contact_project(&c, compliance, held, end[0]) == STATUS_OK);
    CHECK(c.count > 0);
    contact_begin(&c, dt, dt, end[0]); /* it was held */
    contact_report(&c, &report);
    CHECK(report.crossed == 0);
    for (int k = 0; k < 3 * NODES; k++)
        (&end[0][0])[k] = (&x[0][0])[k] + (&d[0][0])[k];
    contact_begin(&c, 0, INFINITY, x[0]);
    contact_begin(&c, dt, dt, x[0]);
    contact_begin(&c, 2 * dt, dt, end[0]);
    contact_begin(&c, 3 * dt, dt, end[0]);
    contact_report(&c, &report);
    CHECK(report.crossed == 1);
    clear(&c);
}

/* A body that comes up through the net in a step pushes it on, from below. */
static void check_mover(void)
{
    static const double dt = 0.01;
    double path[2][4] = {{0, 0, 0, 0}, {dt, 0, 0, 0.1}}, x[NODES][3];
    struct scene_obstacle body = ball(0.13, 0.16, -0.03, 0.005);
    struct contact c;

    body.motion.path_count = 2, body.motion.path = path;
    make(&c, &body, x);
    contact_begin(&c, 0, dt, x[0]);
    REQUIRE(contact_find(&c, x[0]) == STATUS_OK);
    CHECK(c.count > 0);
    const struct contact_touch *over = c.touch; /* of the triangle over its middle */
    for (int n = 1; n < c.count; n++)
        over = c.touch[n].D > over->D ? &c.touch[n] : over;
    if (c.count) {
        CHECK_NEAR(over->D, -0.07 - 0.005, rounding);
        CHECK_NEAR(over->normal[2], 1, rounding);
        CHECK(over->push > 0);
    }
    clear(&c);
}

int main(void)
{
    const struct scene_obstacle line = {.kind = OBSTACLE_CAPSULE,
                                        .point = {-1, 0, -0.005},
                                        .end = {1, 0, -0.005},
                                        .radius = 0.005};

    check_features();
    check_foot();
    check_sample(false);
    check_sample(true);
    check_gradient(ball(0.13, 0.16, 0.0105, 0.01));
    check_mover();
    check_passage(ball(0, 0, -0.005, 0.005));
    check_passage(line);
    check_passage(cone(8, 0.03, 0.1, 0));
    check_passage(cone(0, 0.01, 0.1, 0.6));
    return check_result();
}
