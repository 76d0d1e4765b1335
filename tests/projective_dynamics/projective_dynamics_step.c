/* The steps of projective dynamics: what each iteration lowers, what supports and
 * acceleration do to them. */
#include "tests/pd_fixture.h"

/* --- descent -----------------------------------------------------------------------------
 */

/* Every iteration lowers what the step minimises; from a wild start, all kinds of supports.
 */
static void check_descent(enum constraint constraint, double nu, unsigned fix)
{
    const double rounding = 1e-12; /* of sums of some hundred terms */
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(9, 7, constraint);

    pd_fixture_scene(&scene, nu);
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0, FIX_XYZ);
    pd_fixture_hold(&scene, 0, 0, 0, 1, fix);
    pd_fixture_motion(&m, &scene, &o);
    for (int frame = 0; frame < 8; frame++) {
        pd_fixture_shake(&m.energy.net, m.v, 4, 21 + (unsigned)frame);
        pd_motion_begin(&m);
        double last = pd_motion_objective(&m);
        for (int n = 0; n < 25; n++) {
            REQUIRE(pd_motion_iterate(&m, n, NULL) == STATUS_OK);
            double now = pd_motion_objective(&m);
            CHECK(now <= last * (1 + rounding));
            last = now;
        }
        pd_fixture_frames(&m, 1);
    }
    pd_fixture_close(&m, &scene);
}

/* --- supports ----------------------------------------------------------------------------
 */

/* Held nodes are where their path says; three supports of one component each are one of
 * three; single components leave the others free. */
static void check_supports(void)
{
    static double path[2][4] = {{0, 0, 0, 0}, {0.2, 0.05, 0, 0.1}};
    const double tol_held = 1e-15;
    struct scene scene, split;
    struct pd_motion m, s;
    struct pd_options o = pd_fixture_options(7, 6, CONSTRAINT_TRIANGLES);
    struct scene_support edge = {
        .hi = {0, 1, 1}, .fix = FIX_XYZ, .motion = {.path = path, .path_count = 2}};

    pd_fixture_scene(&scene, 0.3);
    pd_fixture_scene(&split, 0.3);
    scene.gravity[2] = split.gravity[2] = -9.81;
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    for (int c = 0; c < 3; c++) {
        edge.fix = 1u << c;
        REQUIRE(scene_add_support(&split, &edge) == STATUS_OK);
    }
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_motion(&s, &split, &o);
    CHECK(m.system.group_count == 1 && s.system.group_count == 1);
    pd_fixture_frames(&m, 20);
    pd_fixture_frames(&s, 20);
    CHECK(pd_fixture_distance(&m.energy.net, m.x, s.x) == 0);
    for (int j = 0; j < 6; j++)
        for (int c = 0; c < 3; c++) {
            ptrdiff_t at = c * pd_net_stride(&m.energy.net) + j;
            CHECK_NEAR(m.x[at], m.energy.rest[at] + path[1][1 + c] * 0.5, tol_held);
        }
    pd_motion_clear(&m);
    pd_motion_clear(&s);
    scene_clear(&split);

    pd_fixture_hold(&scene, 1, 1, 0, 1, FIX_Z);
    pd_fixture_motion(&m, &scene, &o);
    CHECK(m.system.group_count == 2);
    pd_fixture_frames(&m, 20);
    for (int k = 36; k < 42; k++) {
        CHECK(m.x[2 * pd_net_stride(&m.energy.net) + k] == 0);
        CHECK(m.x[k] != m.energy.rest[k]);
    }
    pd_fixture_close(&m, &scene);
}

/* --- acceleration ------------------------------------------------------------------------
 */

/* Iterations to 1e-6 of the length from the step's end, after some frames. */
static int iterations_to(struct pd_motion *m, const double *end, const double *x)
{
    const struct pd_net *net = &m->energy.net;
    int n = 0;

    memcpy(m->x - net->pad, x - net->pad, (size_t)(3 * pd_net_stride(net)) * sizeof *m->x);
    while (n < 20000 && pd_fixture_distance(net, m->x, end) > 1e-6)
        REQUIRE(pd_motion_iterate(m, n++, NULL) == STATUS_OK);
    return n;
}

/* Accelerated or split iterations end where the plain ones do, and sooner. */
static void check_sooner(char *mesh, enum constraint constraint, double nu, bool split)
{
    const double tol_end = 1e-9; /* of iterations that shrink by 0.999 until 1e-14 */
    struct scene scene;
    struct pd_motion m, plain;
    struct pd_options o = pd_fixture_options(15, 15, constraint);
    double moved = 1;

    o.mesh = mesh;
    pd_fixture_scene(&scene, nu);
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0, FIX_XYZ);
    pd_fixture_hold(&scene, 0, 0, 1, 1, FIX_XYZ);
    pd_fixture_motion(&plain, &scene, &o);
    pd_fixture_frames(&plain, 40);
    o.split = split, o.chebyshev = !split;
    pd_fixture_motion(&m, &scene, &o);
    const struct pd_net *net = &m.energy.net;
    const size_t size = (size_t)(3 * pd_net_stride(net)) * sizeof *m.x;
    memcpy(m.x - net->pad, plain.x - net->pad, size);
    memcpy(m.v - net->pad, plain.v - net->pad, size);
    m.time = plain.time;
    pd_motion_begin(&m);
    pd_motion_begin(&plain);
    double *start = pd_net_fields(net, 3);
    memcpy(start - net->pad, plain.x - net->pad, size);
    for (int n = 0; n < 50000 && moved > 1e-14; n++)
        REQUIRE(pd_motion_iterate(&plain, n, &moved) == STATUS_OK);
    int sooner = iterations_to(&m, plain.x, m.x);
    for (int n = 0; n < 20 * sooner; n++)
        REQUIRE(pd_motion_iterate(&m, sooner + n, NULL) == STATUS_OK);
    CHECK(pd_fixture_distance(net, m.x, plain.x) < tol_end);
    memcpy(m.x - net->pad, plain.x - net->pad, size);
    int usual = iterations_to(&plain, m.x, start);
    printf("to 1e-6 of the length: %d iterations plain, %d %s, nu = %g\n", usual, sooner,
           split ? "split" : "accelerated", nu);
    CHECK(sooner < usual);
    pd_net_free_fields(net, start);
    pd_motion_clear(&m);
    pd_motion_clear(&plain);
    scene_clear(&scene);
}

/* A swing with few accelerated iterations stays a sheet: before they were held back, ten
 * and fifty of them stretched it to several lengths, and twenty threw it away. Plain ones
 * end within 2e-4 of its length, whatever their number. */
static const double MOST_STRETCH = 1.005;

static void check_acceleration_holds(int iterations, double young)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(10, 10, CONSTRAINT_TRIANGLES);
    double most = 0;

    pd_fixture_scene(&scene, 0.3);
    scene.gravity[2] = -9.81;
    scene.thickness = 1e-3;
    scene.young = young;
    scene.density = 0.5;
    scene.step = 0.005;
    pd_fixture_hold(&scene, 0, 0, 0, 1, FIX_XYZ);
    o.chebyshev = true;
    o.iterations = iterations;
    pd_fixture_motion(&m, &scene, &o);
    for (int frame = 0; frame < 100; frame++) {
        pd_fixture_frames(&m, 1);
        most = fmax(most, pd_fixture_longest(&m));
    }
    printf("%d accelerated iterations, E = %g: stretch %.5f\n", iterations, young, most);
    CHECK(most < MOST_STRETCH);
    pd_fixture_close(&m, &scene);
}

int main(void)
{
    for (enum constraint c = CONSTRAINT_TRIANGLES; c <= CONSTRAINT_EDGES; c++) {
        check_descent(c, 0.3, FIX_XYZ);
        check_descent(c, 0.45, FIX_Z);
        check_descent(c, -0.4, FIX_X | FIX_Z);
        check_sooner(NULL, c, 0.3, false);
    }
    for (int n = 10; n <= 50; n += 5) {
        check_acceleration_holds(n, 1e5);
        check_acceleration_holds(n, 1e6);
    }
    check_sooner(NULL, CONSTRAINT_TRIANGLES, 0.3, true);
    check_sooner(NULL, CONSTRAINT_TRIANGLES, -0.3, true);
    check_sooner("irregular", CONSTRAINT_TRIANGLES, 0.3, true);
    check_sooner("irregular", CONSTRAINT_EDGES, 0.3, false);
    check_supports();
    return check_result();
}
