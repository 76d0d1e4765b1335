/* Contact in projective dynamics: where its iterations end is a step of implicit Euler
 * under the scene's law; no node gets through a wall, in whatever variant. (Rest, falls and
 * slides of the variants: contact_truth.c.) */
#include "models/bodies/body_shape.h"
#include "models/vector.h"
#include "tests/pd_fixture.h"

/* Forces that are left where iterations end at 1e-12 of the length, of the largest force:
 * differences of the objective have eight digits. */
static const double BALANCED = 1e-5;

/* Distance of held nodes from where they are taken [m]. */
static const double TAKEN = 1e-9;

static const struct variant {
    const char *name;
    enum constraint constraint;
    bool chebyshev, split, second;
    bool middles; /* samples at cells' middles, of four nodes each */
} variants[] = {
    {"triangles", .constraint = CONSTRAINT_TRIANGLES},
    {"edges", .constraint = CONSTRAINT_EDGES},
    {"chebyshev", .constraint = CONSTRAINT_TRIANGLES, .chebyshev = true},
    {"admm", .constraint = CONSTRAINT_TRIANGLES, .split = true},
    {"bdf2", .constraint = CONSTRAINT_TRIANGLES, .second = true},
    {"middles", .constraint = CONSTRAINT_TRIANGLES, .middles = true},
};
enum { VARIANTS = sizeof variants / sizeof *variants };

static struct pd_options options_of(const struct variant *v, int iterations,
                                    double tolerance)
{
    struct pd_options o = pd_fixture_options(9, 8, v->constraint);

    o.chebyshev = v->chebyshev, o.split = v->split, o.second = v->second;
    o.iterations = iterations, o.tolerance = tolerance;
    return o;
}

static void ball_scene(struct scene *scene, double friction)
{
    struct scene_obstacle ball = {.kind = OBSTACLE_SPHERE,
                                  .radius = 0.3,
                                  .friction = friction,
                                  .point = {0.45, 0.55, -0.32}};
    struct scene_obstacle floor = {.kind = OBSTACLE_PLANE,
                                   .normal = {0.1, 0, 1},
                                   .friction = friction,
                                   .point = {0, 0, -0.35}};

    pd_fixture_scene(scene, 0.3);
    scene->gravity[2] = -9.81;
    REQUIRE(scene_add_obstacle(scene, &ball) == STATUS_OK);
    REQUIRE(scene_add_obstacle(scene, &floor) == STATUS_OK);
}

static void floor_scene(struct scene *scene, double friction)
{
    struct scene_obstacle floor = {.kind = OBSTACLE_PLANE,
                                   .normal = {0, 0, 1},
                                   .friction = friction,
                                   .point = {0, 0, -0.005}};

    pd_fixture_scene(scene, 0.3);
    scene->gravity[2] = -9.81;
    REQUIRE(scene_add_obstacle(scene, &floor) == STATUS_OK);
}

static void node_at(const struct pd_motion *m, const double *x, int k, double at[3])
{
    for (int c = 0; c < 3; c++)
        at[c] = x[c * pd_net_stride(&m->energy.net) + k];
}

/* Returns the least distance of m's free nodes from a wall [m]. */
static double clearance(const struct pd_motion *m)
{
    const struct contact_law law = contact_law_body(m->scene);
    double least = INFINITY, at[3];

    for (int k = 0; k < m->energy.net.nodes; k++)
        for (int o = 0; o < m->scene->obstacle_count; o++) {
            node_at(m, m->x, k, at);
            double D = body_shape_distance(&m->scene->obstacles[o], NULL, at, NULL);
            if (!m->system.held[k])
                least = fmin(least, D - law.start + law.range);
        }
    return least;
}

/* --- where iterations end ----------------------------------------------------------------
 */

/* Writes the law out: adds the force of obstacle o on node k; tells whether it slides. */
static bool add_law(const struct pd_motion *m, int k, int o, double force[3])
{
    const struct pd_net *net = &m->energy.net;
    const struct contact_law law = contact_law_body(m->scene);
    const struct scene_obstacle *body = &m->scene->obstacles[o];
    const int i = k / net->m, j = k % net->m;
    double at[3], from[3], way[3], normal[3];

    node_at(m, m->x, k, at);
    node_at(m, m->start, k, from);
    vector_between(from, at, way);
    const double area = net->du * net->dv * (i && i < net->n - 1 ? 1 : 0.5) *
                        (j && j < net->m - 1 ? 1 : 0.5),
                 before = body_shape_distance(body, NULL, from, NULL),
                 D = body_shape_distance(body, NULL, at, normal),
                 push = area * contact_law_push(&law, D, before, m->dt, NULL),
                 along = vector_dot(way, normal);
    for (int c = 0; c < 3; c++)
        way[c] -= along * normal[c];
    const double slip = vector_length(way),
                 rub = body->friction * push * contact_law_friction(&law, slip, m->dt);
    for (int c = 0; c < 3; c++)
        force[c] += push * normal[c] - (slip > 0 ? rub / slip * way[c] : 0);
    return push > 0 && slip > law.creep * m->dt;
}

/* Returns by how much the objective grows with x, node k, component c [N]. */
static double slope_of(struct pd_motion *m, int k, int c)
{
    const double step = 1e-6;
    double *x = &m->x[c * pd_net_stride(&m->energy.net) + k], at = *x, value[2];

    for (int n = 0; n < 2; n++) {
        *x = at + (n ? step : -step);
        value[n] = pd_motion_objective(m);
    }
    *x = at;
    return (value[1] - value[0]) / (2 * step);
}

static int row_of_middle(const void *points, double u, double v, int *node, double *shape)
{
    const int *n = points, i = (int)(u * (n[0] - 1)), j = (int)(v * (n[1] - 1));

    for (int k = 0; k < 4; k++) {
        node[k] = (i + k / 2) * n[1] + j + k % 2;
        shape[k] = 0.25;
    }
    return 4;
}

/* Takes cells' middles for samples. */
static void use_middles(struct pd_motion *m)
{
    static double line[2][8];
    struct contact_surface surface;
    const int *n = m->options.points, count[2] = {n[0] - 1, n[1] - 1};

    for (int d = 0; d < 2; d++)
        for (int k = 0; k < count[d]; k++)
            line[d][k] = (k + 0.5) / count[d];
    contact_clear(&m->contact.law);
    REQUIRE(contact_surface_init(&surface, m->scene, m->options.points, row_of_middle, 4,
                                 m->energy.net.nodes,
                                 (const double *const[2]){line[0], line[1]},
                                 count) == STATUS_OK);
    REQUIRE(contact_init(&m->contact.law, m->scene, &surface) == STATUS_OK);
}

/* The forces of the law balance the objective of the step: plain implicit Euler. */
static void check_end(const struct variant *v, double friction)
{
    enum { FRAMES = 30, MOST = 100000 };
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = options_of(v, 2000, 1e-7);
    double moved = INFINITY, left = 0, most = 0, value = INFINITY;
    int touching = 0, sliding = 0, number = 0;

    ball_scene(&scene, friction);
    pd_fixture_motion(&m, &scene, &o);
    const int nodes = m.energy.net.nodes;
    double(*force)[3] = calloc((size_t)nodes, sizeof *force);
    REQUIRE(force);
    if (v->middles)
        use_middles(&m);
    pd_fixture_frames(&m, FRAMES);
    pd_motion_begin(&m);
    for (int n = 0; n < MOST && moved > 1e-12; n++) {
        REQUIRE(pd_motion_iterate(&m, number++, &moved) == STATUS_OK);
        if (v->chebyshev && pd_motion_take_back(&m, false, &number, &value))
            moved = INFINITY;
    }
    REQUIRE(pd_contact_find(&m.contact, m.x) == STATUS_OK);
    if (v->middles)
        contact_force(&m.contact.law, *force);
    for (int k = 0; k < nodes; k++) {
        for (int b = 0; b < scene.obstacle_count && !v->middles; b++)
            sliding += add_law(&m, k, b, force[k]);
        touching += force[k][2] > 0;
        for (int c = 0; c < 3; c++) {
            most = fmax(most, fabs(force[k][c]));
            left = fmax(left, fabs(slope_of(&m, k, c) - force[k][c]));
        }
    }
    printf("%s, friction %g: %d nodes touch, %d slide; %.1e of %.1e N left\n", v->name,
           friction, touching, sliding, left, most);
    CHECK(touching > 3);
    CHECK_NEAR(left / most, 0, BALANCED);
    free(force);
    pd_fixture_close(&m, &scene);
}

/* --- motions -----------------------------------------------------------------------------
 */

/* Held nodes go where they are taken, into an obstacle even; the others stay outside. */
static void check_held(void)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(6, 6, CONSTRAINT_EDGES);
    double path[2][4] = {{0, 0, 0, 0}, {0.05, 0, 0, -0.02}};
    struct scene_support edge = {
        .hi = {0, 1, 1}, .fix = FIX_XYZ, .motion = {.path = path, .path_count = 2}};

    floor_scene(&scene, 0);
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_frames(&m, 10);
    for (int k = 0; k < 6; k++)
        CHECK_NEAR(m.x[2 * pd_net_stride(&m.energy.net) + k], -0.02, TAKEN);
    CHECK(clearance(&m) > 0);
    pd_fixture_close(&m, &scene);
}

/* A node that would be beyond a small ball after one step stays before it, or goes round.
 */
static void check_small_ball(const struct variant *v)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = options_of(v, 10, 0);
    const double radius = 0.03, from[3] = {0.5, 3.0 / 7, -0.04};
    struct scene_obstacle ball = {.kind = OBSTACLE_SPHERE, .radius = radius};
    double at[3];

    memcpy(ball.point, from, sizeof from);
    pd_fixture_scene(&scene, 0.3);
    scene.velocity[2] = -20;
    REQUIRE(scene_add_obstacle(&scene, &ball) == STATUS_OK);
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_frames(&m, 1);
    node_at(&m, m.x, 4 * 8 + 3, at);
    CHECK(at[2] > from[2] || hypot(at[0] - from[0], at[1] - from[1]) > radius);
    pd_fixture_close(&m, &scene);
}

/* Returns the least distance of the sheet from its own wall, INFINITY if it meets itself
 * nowhere [m]; of samples over faces: rims press less, the less they face each other. */
static double own_clearance(const struct pd_motion *m)
{
    const struct contact *law = &m->contact.law;
    double least = INFINITY;

    for (int t = 0; t < law->count; t++)
        if (law->touch[t].obstacle < 0 && law->touch[t].sample >= 0)
            least = fmin(least, law->touch[t].D - law->self.start + law->self.range);
    return least;
}

/* An edge that is taken over the sheet and laid down folds it onto itself, not through. */
static void check_fold(const struct variant *v)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = options_of(v, 10, 0);
    double path[4][4] = {
        {0, 0, 0, 0}, {0.2, 0.3, 0, 0.3}, {0.6, 0.8, 0, 0.3}, {0.62, 0.8, 0, 0.06}};
    struct scene_support edge = {
        .hi = {0, 1, 1}, .fix = FIX_XYZ, .motion = {.path = path, .path_count = 4}};
    double least = INFINITY;

    floor_scene(&scene, 0.3);
    scene.contact.self = true;
    scene.contact.thickness = 0.06; /* half a cell: what is nearer, the net would miss */
    scene.obstacles[0].point[2] = -0.03;
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    pd_fixture_motion(&m, &scene, &o);
    for (int frame = 0; frame < 200; frame++) {
        pd_fixture_frames(&m, 1);
        least = fmin(least, own_clearance(&m));
        CHECK(clearance(&m) > 0);
    }
    printf("%s folded: %.1e of the range from its own wall\n", v->name,
           least / m.contact.law.self.range);
    CHECK(least > 0 && least < INFINITY);
    pd_fixture_close(&m, &scene);
}

/* A floor that rises at 4 m/s, two ranges of the law a step and more, lifts the sheet. */
static void check_lifted(const struct variant *v)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = options_of(v, 10, 0);
    double path[2][4] = {{0, 0, 0, 0}, {0.1, 0, 0, 0.4}};

    floor_scene(&scene, 0.3);
    scene.obstacles[0].motion.path = path;
    scene.obstacles[0].motion.path_count = 2;
    pd_fixture_motion(&m, &scene, &o);
    for (int frame = 1; frame <= 20; frame++) {
        pd_fixture_frames(&m, 1);
        const double lowest =
            0.02 * frame - 0.005 + m.contact.law.body.start - m.contact.law.body.range;
        for (int k = 0; k < m.energy.net.nodes; k++)
            CHECK(m.x[2 * pd_net_stride(&m.energy.net) + k] > lowest);
    }
    struct energy e;
    pd_motion_energy(&m, &e); /* what contact stores is told by itself */
    CHECK(m.contact.law.energy > 0 && e.elastic == pd_energy_value(&m.energy, m.x));
    pd_motion_clear(&m);
    scene.obstacles[0].motion.path = NULL;
    scene.obstacles[0].motion.path_count = 0;
    scene_clear(&scene);
}

int main(void)
{
    for (const struct variant *v = variants; v < variants + VARIANTS; v++) {
        check_end(v, 0);
        check_end(v, 0.3);
        if (v->middles)
            continue;
        if (v->constraint == CONSTRAINT_TRIANGLES) /* edges alone let it round the ball */
            check_small_ball(v);
        check_lifted(v);
        check_fold(v);
    }
    check_held();
    return check_result();
}
