/* Contact in projective dynamics: each global step is the right minimum, dense or not. */
#include "tests/pd_fixture.h"

/* Systems are solved to round-off, a little worse for stiff sheets. */
static const double SOLVED = 1e-10;

/* Conjugate gradients stop at gaps of PD_CONTACT_CLOSED in each iteration. */
static const double SAME = 1e-8;

/* Excess of friction over mu times a normal force that still changes: after ten
 * iterations a step, and where they went on to the end. */
static const double FEW = 0.3, CONVERGED = 1e-3;

/* Gap of a node that bears force: planes are those of the iterate before, so that the gap
 * to a ball is the square of the last iteration's way over its diameter. */
static const double CLOSED = 1e-9;

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

/* Entries of S against solves with A: S x = C A^-1 C^T x, and the other way round. */
static void check_dual(int dense)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_dual dual;
    struct pd_options options = pd_fixture_options(7, 6, CONSTRAINT_TRIANGLES);
    enum { ROWS = 9 };
    struct pd_push row[ROWS];
    double force[ROWS], gap[ROWS];
    unsigned seed = 5;

    pd_fixture_scene(&scene, 0.3);
    pd_fixture_hold(&scene, 0, 0, 0, 1, FIX_X | FIX_Z); /* two matrices */
    pd_fixture_motion(&m, &scene, &options);
    REQUIRE(pd_dual_init(&dual, &m.system) == STATUS_OK);
    dual.dense = dense;
    double *z = pd_net_fields(&m.energy.net, 3);
    REQUIRE(z);
    for (int n = 0; n < ROWS; n++) {
        double size = 0;
        row[n].node = 3 + 4 * n; /* one of them held */
        force[n] = pd_fixture_random(&seed);
        for (int c = 0; c < 3; c++)
            row[n].direction[c] = pd_fixture_random(&seed);
        for (int c = 0; c < 3; c++)
            size += row[n].direction[c] * row[n].direction[c];
        for (int c = 0; c < 3; c++)
            row[n].direction[c] /= sqrt(size);
    }
    REQUIRE(pd_dual_push(&dual, row, ROWS, force, z) == STATUS_OK);
    for (int n = 0; n < ROWS; n++) {
        gap[n] = 0;
        for (int c = 0; c < 3; c++)
            gap[n] +=
                row[n].direction[c] * z[c * pd_net_stride(&m.energy.net) + row[n].node];
    }
    double near = 1e-14;
    REQUIRE(pd_dual_solve(&dual, PD_DUAL_NORMALS, row, ROWS, near, gap) == STATUS_OK);
    for (int n = 0; n < ROWS; n++)
        CHECK_NEAR(gap[n], force[n], SOLVED);
    pd_net_free_fields(&m.energy.net, z);
    pd_dual_clear(&dual);
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* After an iteration: no node inside, no force that pulls and none where there is a gap;
 * friction within its cone, which is that of the iteration before. */
static void check_conditions(const struct pd_motion *m, double cone)
{
    const struct pd_contact *c = &m->contact;

    CHECK(pd_contact_gap(c, m->x) >= -2 * PD_CONTACT_CLOSED);
    for (int t = 0; t < c->count; t++) {
        const struct pd_touch *touch = &c->touch[t];
        double across = 0;
        for (int i = 0; i < 3; i++)
            across += touch->tangent[i] * touch->tangent[i];
        CHECK(touch->closed ? touch->press >= 0 : touch->press == 0 && across == 0);
        CHECK(sqrt(across) <=
              (1 + cone) * pd_contact_obstacle(c, t)->friction * touch->press + SOLVED);
    }
}

/* Few rows at a time leave the dense matrix for conjugate gradients, or forget nodes again
 * and again: the same motion. */
static void check_same_motion(double friction)
{
    static const int dense[3] = {PD_DUAL_DENSE, 12, 0};
    struct scene scene;
    struct pd_motion m[3];
    struct pd_options options = pd_fixture_options(9, 8, CONSTRAINT_TRIANGLES);

    ball_scene(&scene, friction);
    for (int k = 0; k < 3; k++) {
        pd_fixture_motion(&m[k], &scene, &options);
        m[k].contact.dual.dense = dense[k];
    }
    for (int frame = 0; frame < 50; frame++)
        for (int k = 0; k < 3; k++) {
            pd_fixture_frames(&m[k], 1);
            if (k == 0)
                check_conditions(&m[k], FEW);
        }
    CHECK(m[0].contact.pressed > 3);
    for (int k = 1; k < 3; k++)
        for (int n = 0; n < m[0].energy.net.nodes; n++)
            for (int c = 0; c < 3; c++) {
                ptrdiff_t at = c * pd_net_stride(&m[0].energy.net) + n;
                CHECK_NEAR(m[k].x[at], m[0].x[at], SAME);
            }
    for (int k = 0; k < 3; k++)
        pd_motion_clear(&m[k]);
    scene_clear(&scene);
}

static void check_converged(void)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options options = pd_fixture_options(9, 8, CONSTRAINT_TRIANGLES);

    options.iterations = 3000;
    options.tolerance = 1e-8;
    ball_scene(&scene, 0.3);
    pd_fixture_motion(&m, &scene, &options);
    for (int frame = 0; frame < 30; frame++) {
        pd_fixture_frames(&m, 1);
        check_conditions(&m, CONVERGED);
        for (int t = 0; t < m.contact.count; t++)
            if (m.contact.touch[t].press > 0)
                CHECK_NEAR(pd_contact_normal(&m.contact, t, m.x, NULL), 0, CLOSED);
    }
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* Held nodes go where they are taken, into an obstacle even; the same obstacle twice
 * carries the sheet as one does; a sheet that starts in an obstacle is refused. */
static void check_held_and_twice(void)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options options = pd_fixture_options(6, 6, CONSTRAINT_EDGES);
    struct scene_obstacle floor = {
        .kind = OBSTACLE_PLANE, .normal = {0, 0, 1}, .point = {0, 0, -0.005}};
    double path[2][4] = {{0, 0, 0, 0}, {0.05, 0, 0, -0.02}};
    struct scene_support edge = {
        .hi = {0, 1, 1}, .fix = FIX_XYZ, .path = path, .path_count = 2};
    struct message why;

    pd_fixture_scene(&scene, 0.3);
    scene.gravity[2] = -9.81;
    REQUIRE(scene_add_obstacle(&scene, &floor) == STATUS_OK);
    REQUIRE(scene_add_obstacle(&scene, &floor) == STATUS_OK);
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    pd_fixture_motion(&m, &scene, &options);
    pd_fixture_frames(&m, 10);
    CHECK_NEAR(pd_contact_gap(&m.contact, m.x), -0.02, SAME);
    CHECK_NEAR(m.x[2 * pd_net_stride(&m.energy.net) + 20], 0, 2 * PD_CONTACT_CLOSED);
    CHECK(m.push[2] > 0.8 * 9.81 * scene.density * scene.thickness);
    pd_motion_clear(&m);
    scene.obstacles[0].point[2] = 0;
    CHECK(pd_motion_init(&m, &scene, &options, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "into an obstacle"));
    scene_clear(&scene);
}

int main(void)
{
    check_dual(PD_DUAL_DENSE);
    check_dual(0);
    check_same_motion(0);
    check_same_motion(0.3);
    check_converged();
    check_held_and_twice();
    return check_result();
}
