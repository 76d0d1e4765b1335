/* Samples that are put back on bodies: control points and points of a face, what moves with
 * them and what their rates keep; by hand-made surfaces of columns of two nodes. */
#include "models/contact/contact_outside.h"

#include "models/bodies/body_shape.h"
#include "models/vector.h"
#include "tests/check.h"

/* Sums of a few products of numbers near 1. */
static const double rounding = 1e-14;

enum { SIDE = 3, COLUMNS = SIDE * SIDE, LAYERS = 2, NODES = COLUMNS * LAYERS, MOST = 2 };
static const double DT = 0.01, TIME = 0.5, THICK = 0.1;

/* The state of a sheet of 1 m, and what it meets. */
struct fixture {
    struct scene scene;
    struct contact_outside outside;
    double x[NODES][3], d[NODES][3], v[NODES][3];
    int held[3 * NODES];
    double v_way;
    struct counters work;
};
static struct fixture f, before;
static const int lower = 0, upper = 1;
static bool legendre; /* nodes of a column: its middle, and half its thickness */

static int column_of(double u, double v)
{
    return (int)lround(u * (SIDE - 1)) * SIDE + (int)lround(v * (SIDE - 1));
}

/* The control point of a face; self: which. */
static int row_of_point(const void *self, double u, double v, int *node, double *shape)
{
    const bool top = *(const int *)self;

    for (int k = 0; k < LAYERS; k++) {
        node[k] = LAYERS * column_of(u, v) + k;
        shape[k] = legendre ? (k && !top ? -1 : 1) : k == top;
    }
    return LAYERS;
}

/* A point between two columns, 3/4 of the one and 1/4 of the next. */
static int row_of_face(const void *self, double u, double v, int *node, double *shape)
{
    const int column = column_of(u, v), next = (column + 1) % COLUMNS;

    node[0] = LAYERS * column + *(const int *)self, shape[0] = 0.75;
    node[1] = LAYERS * next + *(const int *)self, shape[1] = 0.25;
    return 2;
}

/* Makes a sheet at z = 0.5, thick along z, with a plain motion. */
static void make(contact_row *row, double sinks)
{
    const double line[SIDE] = {0, 0.5, 1};
    const double *const lines[2] = {line, line};

    memset(&f, 0, sizeof f);
    REQUIRE(scene_init(&f.scene) == STATUS_OK);
    f.scene.length = f.scene.width = 1, f.scene.thickness = THICK;
    f.outside.layers = LAYERS, f.outside.first_only = legendre;
    for (int k = 0; k < LAYERS; k++)
        REQUIRE(contact_surface_init(&f.outside.face[k], &f.scene, k ? &upper : &lower, row,
                                     MOST, NODES, lines, (int[]){SIDE, SIDE}) == STATUS_OK);
    for (int a = 0; a < NODES; a++) {
        const int column = a / LAYERS, top = a % LAYERS;
        const double x[3] = {column / SIDE / 2., column % SIDE / 2., 0.5},
                     v[3] = {0.3, 0.2, -sinks};
        memcpy(f.x[a], x, sizeof x);
        memcpy(f.v[a], v, sizeof v);
        for (int i = 0; i < 3; i++)
            f.d[a][i] = v[i] * DT;
        f.x[a][2] += (top ? 0.5 : -0.5) * THICK;
        if (legendre && top) { /* its slope across, which does not move */
            const double half[3] = {0, 0, THICK / 2}, none[3] = {0};
            memcpy(f.x[a], half, sizeof half);
            memcpy(f.d[a], none, sizeof none);
            memcpy(f.v[a], none, sizeof none);
        } else if (legendre)
            f.x[a][2] = 0.5;
    }
    for (int u = 0; u < 3 * NODES; u++)
        f.held[u] = u;
    f.v_way = 1 / DT;
}

static void clear(void)
{
    contact_outside_clear(&f.outside);
    scene_clear(&f.scene);
}

/* Adds a plane through (0.5, 0, z). */
static void add_plane(double x, double z)
{
    struct scene_obstacle plane = {
        .kind = OBSTACLE_PLANE, .normal = {x, 0, 1}, .point = {0.5, 0, z}};

    REQUIRE(scene_add_obstacle(&f.scene, &plane) == STATUS_OK);
}

/* Adds a ball that rises at a speed, to where it is given at the step's end. */
static void add_ball(double x, double y, double z, double radius, double rises)
{
    double path[2][4] = {{TIME - 1, 0, 0, -rises * (1 + DT)},
                         {TIME + 1, 0, 0, rises * (1 - DT)}};
    struct scene_obstacle ball = {
        .kind = OBSTACLE_SPHERE, .point = {x, y, z}, .radius = radius};

    if (rises != 0)
        ball.motion.path_count = 2, ball.motion.path = path;
    REQUIRE(scene_add_obstacle(&f.scene, &ball) == STATUS_OK);
}

static void put(void)
{
    const struct contact_outside_rate rate[] = {{&f.d[0][0], 1}, {&f.v[0][0], f.v_way}};

    before = f;
    contact_outside_put(&f.outside, &f.scene, TIME, DT, f.held, &f.x[0][0], rate, &f.work);
}

static bool is_same(void)
{
    return !memcmp(f.x, before.x, sizeof f.x) && !memcmp(f.d, before.d, sizeof f.d) &&
           !memcmp(f.v, before.v, sizeof f.v);
}

static const struct scene_placement *pose_at(const struct scene_obstacle *o, double t)
{
    static struct scene_placement pose;

    scene_motion_at(&o->motion, t, &pose);
    return &pose;
}

/* Computes a sample's distance from a body at the step's end. */
static double distance(int face, int sample, int body, double n[3])
{
    const struct scene_obstacle *o = &f.scene.obstacles[body];
    double y[3];

    contact_surface_at(&f.outside.face[face], sample, &f.x[0][0], y);
    return body_shape_distance(o, pose_at(o, TIME + DT), y, n);
}

/* What was inside is on the surface, without speed into it along n relative to `drift`, and
 * with the same speed across; the columns have kept their thickness. */
static void check_put(int face, int sample, int body, double drift)
{
    double n[3], r[2][3], d[3], across[2][3];

    CHECK_NEAR(distance(face, sample, body, n), 0, rounding);
    contact_surface_at(&f.outside.face[face], sample, &before.v[0][0], r[0]);
    contact_surface_at(&f.outside.face[face], sample, &f.v[0][0], r[1]);
    contact_surface_at(&f.outside.face[face], sample, &f.d[0][0], d);
    CHECK_NEAR(vector_dot(r[1], n), drift * f.v_way, rounding / DT);
    CHECK_NEAR(vector_dot(d, n), drift, rounding);
    for (int k = 0; k < 2; k++)
        vector_cross(r[k], n, across[k]);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(across[0][i], across[1][i], rounding);
    for (int c = 0; c < COLUMNS && !legendre; c++)
        for (int i = 0; i < 3; i++)
            CHECK_NEAR(f.x[LAYERS * c + 1][i] - f.x[LAYERS * c][i],
                       before.x[LAYERS * c + 1][i] - before.x[LAYERS * c][i], rounding);
}

/* All but one column lie as they lay, bit by bit. */
static void check_others(int column)
{
    for (int a = 0; a < NODES; a++)
        CHECK(a / LAYERS == column || (!memcmp(f.x[a], before.x[a], sizeof f.x[a]) &&
                                       !memcmp(f.v[a], before.v[a], sizeof f.v[a]) &&
                                       !memcmp(f.d[a], before.d[a], sizeof f.d[a])));
}

static void clear_ball(int face, double drift)
{
    check_put(face, COLUMNS - 1, 0, drift);
    check_others(COLUMNS - 1);
    clear();
}

/* A ball has come into the corner (1, 1), askew, so that its lower face is inside, or both,
 * or from above its upper face; with the two kinds of columns. */
static void test_faces(void)
{
    for (int basis = 0; basis < 2; basis++) {
        legendre = basis;
        make(row_of_point, 0.7);
        add_ball(0.97, 1.02, 0.3, 0.2, 0);
        put();
        CHECK(f.outside.put == 1);
        clear_ball(lower, 0);
        make(row_of_point, 0.7);
        add_ball(0.97, 1.02, 0.3, 0.3, 0);
        put();
        CHECK(f.outside.put == 1); /* the lower one takes the upper one out */
        clear_ball(lower, 0);
        make(row_of_point, -0.7);
        add_ball(0.97, 1.02, 0.75, 0.22, 0);
        put();
        CHECK(f.outside.put == 1);
        clear_ball(upper, 0);
    }
    legendre = false;
}

/* Returns the way of the ball, s . n, as it is met. */
static double drift(int face, double rises)
{
    double n[3];

    distance(face, COLUMNS - 1, 0, n);
    return rises * DT * n[2];
}

/* A body that moves pushes; one that goes away faster than the sheet comes takes nothing.
 */
static void test_moving(void)
{
    for (int printed = 0; printed < 2; printed++) {
        make(row_of_point, 0.7);
        f.v_way = printed ? 0 : 1 / DT;
        add_ball(0.97, 1.02, 0.3, 0.2, 2);
        put();
        clear_ball(lower, drift(lower, 2));
    }
    make(row_of_point, 0.7);
    add_ball(0.97, 1.02, 0.3, 0.2, -5);
    put();
    CHECK(f.outside.put == 1 && memcmp(f.x, before.x, sizeof f.x) != 0);
    CHECK(!memcmp(f.v, before.v, sizeof f.v) && !memcmp(f.d, before.d, sizeof f.d));
    clear();
}

/* Columns move by their weights over the sum of squares, here 0.75 and 0.25 over 0.625. */
static void test_weights(void)
{
    enum { MIDDLE = 4 };

    make(row_of_face, 0.7);
    add_ball(0.5, 0.625, 0.3, 0.17, 0);
    put();
    CHECK(f.outside.put == 1);
    for (int a = 0; a < NODES; a++) {
        const int column = a / LAYERS;
        const double way = column == MIDDLE ? 0.024 : column == MIDDLE + 1 ? 0.008 : 0;
        CHECK_NEAR(f.x[a][2] - before.x[a][2], way, rounding);
        CHECK_NEAR(f.v[a][2] - before.v[a][2], 0.7 / 0.02 * way, rounding / DT);
    }
    check_put(lower, MIDDLE, 0, 0);
    clear();
}

static void test_held(void)
{
    make(row_of_point, 0.7);
    add_ball(0.97, 1.02, 0.3, 0.2, 0);
    for (int u = 3 * LAYERS * (COLUMNS - 1); u < 3 * NODES; u++)
        f.held[u] = -1;
    put();
    CHECK(f.outside.put == 1 && is_same());
    CHECK(f.work.tested == LAYERS * COLUMNS); /* it is not tried again */
    clear();
}

/* Nobody is left inside of bodies that share columns: two planes with an edge between. */
static void test_wedge(void)
{
    const double left = 1e-12;
    double n[3];

    make(row_of_face, 0.7);
    add_plane(0.5, 0.5);
    add_plane(-0.5, 0.5);
    put();
    CHECK(f.outside.put > COLUMNS / 2);
    for (int b = 0; b < 2; b++)
        for (int k = 0; k < LAYERS; k++)
            for (int s = 0; s < COLUMNS; s++)
                CHECK(distance(k, s, b, n) >= -left);
    clear();
}

static void test_far(void)
{
    struct model_contact report;

    make(row_of_point, 0.7);
    add_ball(0.5, 0.5, -2, 0.3, 1);
    add_plane(0, 0.449);
    put();
    CHECK(is_same() && f.outside.put == 0);
    CHECK(f.work.tested == 2 * LAYERS * COLUMNS);
    contact_outside_report(&f.outside, &report);
    CHECK(report.nodes == 0 && isinf(report.least_gap) && isnan(report.force[2]));
    clear();
}

int main(void)
{
    test_faces();
    test_moving();
    test_weights();
    test_held();
    test_wedge();
    test_far();
    return check_result();
}
