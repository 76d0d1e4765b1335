/* Tests the tangent of a smooth sheet's contact with itself, with the turning of its
 * normals, against differences of its forces; and the stiffness of friction. */
#include "models/mechanics/contact_system.h"

#include "tests/check.h"

/* A Bezier curve of six points, twice: lines along v between both. */
enum { POINTS = 6, NODES = 2 * POINTS, COUNT = 3 * NODES };

/* Differences of slopes and curvatures, seen 5e-6. */
static const double step = 1e-5, near_enough = 1e-5;
/* The least share that the turning has of the tangent in this shape, seen .09. */
static const double turns = 0.01;

static int row(const void *self, double u, double v, int *node, double *shape)
{
    static const double binomial[POINTS] = {1, 5, 10, 10, 5, 1};

    (void)self;
    for (int k = 0; k < NODES; k++) {
        const int i = k / 2;
        node[k] = k;
        shape[k] =
            binomial[i] * pow(u, i) * pow(1 - u, POINTS - 1 - i) * (k % 2 ? v : 1 - v);
    }
    return NODES;
}

/* A loop whose ends lie on one another, somewhat askew: a hairpin. */
static void lay(double x[COUNT])
{
    static const double curve[POINTS][2] = {{0, -0.05}, {1.2, -0.09}, {2.4, -1.1},
                                            {2.4, 1.1}, {1.3, 0.06},  {0.05, 0.08}};

    for (int k = 0; k < NODES; k++) {
        x[3 * k + 0] = curve[k / 2][0] + 0.03 * (k % 2);
        x[3 * k + 1] = 0.6 * (k % 2);
        x[3 * k + 2] = curve[k / 2][1] * (1 + 0.1 * (k % 2));
    }
}

/* Finds the touches of samples; those of rims have no turning. */
static void find(struct contact *c, const double x[COUNT])
{
    int kept = 0;

    contact_begin_rest(c, 0, 1, x);
    REQUIRE(contact_find(c, x) == STATUS_OK);
    for (int n = 0; n < c->count; n++)
        if (c->touch[n].sample >= 0)
            c->touch[kept++] = c->touch[n];
    c->count = kept;
}

/* Returns |a - b| / |a|. */
static double apart(const double *a, const double *b)
{
    double difference = 0, size = 0;

    for (int k = 0; k < COUNT; k++) {
        difference += pow(a[k] - b[k], 2);
        size += pow(a[k], 2);
    }
    return sqrt(difference / size);
}

static void open_contact(struct contact *c, struct scene *scene)
{
    static const double line[2][21] = {{0,   .05, .1,  .15, .2,  .25, .3,
                                        .35, .4,  .45, .5,  .55, .6,  .65,
                                        .7,  .75, .8,  .85, .9,  .95, 1},
                                       {0, 0.5, 1}};
    struct contact_surface s;

    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 4, scene->width = 0.6;
    scene->contact.self = true;
    scene->contact.thickness = 0.2, scene->contact.stiffness = 50;
    REQUIRE(contact_surface_init(&s, scene, NULL, row, NODES, NODES,
                                 (const double *const[]){line[0], line[1]},
                                 (const int[]){21, 3}) == STATUS_OK);
    REQUIRE(contact_init(c, scene, &s) == STATUS_OK);
}

/* Returns d K d. */
static double along(const double K[9], const double d[3])
{
    double sum = 0;

    for (int k = 0; k < 9; k++)
        sum += d[k / 3] * K[k] * d[k % 3];
    return sum;
}

/* Friction of the normal z that slips along x is Newton's tangent where the last change
 * foretold it, only stiffer where that foretold another way, and never negative. */
static void test_grip(void)
{
    const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1}, exact = 1e-14;
    struct contact_touch t = {
        .normal = {0, 0, 1}, .rub = {-6, 0, 0}, .drag = 2, .grip = 0.5, .share = 0.75};
    double K[9];

    t.foretold[0] = t.share;
    contact_grip(&t, K);
    CHECK_NEAR(along(K, x), t.grip, exact);
    CHECK_NEAR(along(K, y), t.drag, exact);
    CHECK_NEAR(along(K, z), 0, exact);
    t.foretold[0] = -1;
    contact_grip(&t, K);
    CHECK(along(K, x) > t.drag);
    t.grip = 0;
    for (int n = 0; n < 12; n++) {
        t.foretold[0] = cos(n), t.foretold[1] = sin(n);
        contact_grip(&t, K);
        CHECK(K[0] + K[4] >= 0 && K[0] * K[4] - K[1] * K[3] >= -exact);
    }
}

int main(void)
{
    double x[COUNT], moved[COUNT], force[2][COUNT], K[NODES * (NODES + 1) / 2][9];
    double plain[COUNT], turned[COUNT], change[COUNT], d[COUNT];
    int ien[NODES];
    struct blocks graph;
    struct contact c;
    struct scene scene;

    test_grip();
    for (int k = 0; k < NODES; k++)
        ien[k] = k;
    REQUIRE(blocks_init(&graph, NODES, 1, NODES, ien) == STATUS_OK);
    open_contact(&c, &scene);
    lay(x);
    for (int k = 0; k < COUNT; k++)
        d[k] = sin(7.0 * k + 1);
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < COUNT; k++)
            moved[k] = x[k] + (side ? step : -step) * d[k];
        find(&c, moved);
        memset(force[side], 0, sizeof force[side]);
        contact_force(&c, force[side]);
    }
    for (int k = 0; k < COUNT; k++)
        change[k] = (force[0][k] - force[1][k]) / (2 * step);
    find(&c, x);
    CHECK(c.count > 9);
    memset(K, 0, sizeof K);
    CHECK(contact_system_tangent(&c, NULL, &graph, K));
    blocks_multiply(&graph, K, d, plain);
    memset(K, 0, sizeof K);
    CHECK(contact_system_tangent(&c, x, &graph, K));
    blocks_multiply(&graph, K, d, turned);
    CHECK_NEAR(apart(change, turned), 0, near_enough);
    CHECK(apart(change, plain) > turns);
    contact_clear(&c);
    scene_clear(&scene);
    blocks_clear(&graph);
    return check_result();
}
