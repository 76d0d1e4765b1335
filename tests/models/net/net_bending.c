/* Tests the bending of a grid by itself: the energy of a sheet that is bent without a
 * moment across, and twisted, in closed form; hinges by the equations that their rule
 * solves. */
#include "models/net/hinge_rule.h"
#include "models/net/net.h"
#include "models/net/spring_plate.h"
#include "tests/check.h"

enum { ROWS = 9, COLUMNS = 6 };
static const double LENGTH = 2, WIDTH = 0.7, BEND = 0.1, ROUND_OFF = 1e-11;

/* Energy of z = k (u^2 - nu v^2) / 2 + t u v. Along u there are no forms on the first and
 * last row of points, along v none on the outer columns. */
static double bent(const struct scene *s, const struct mesh *mesh, double k, double t)
{
    struct spring_forms forms;
    double *x = malloc(3 * (size_t)mesh->nodes * sizeof *x);

    REQUIRE(x && spring_plate_make(s, mesh, PARAMETERS_MATCHED, &forms) == STATUS_OK);
    memcpy(x, mesh->rest, 3 * (size_t)mesh->nodes * sizeof *x);
    for (int a = 0; a < mesh->nodes; a++) {
        const double u = LENGTH * mesh->uvw[a][0], v = WIDTH * mesh->uvw[a][1];
        x[3 * a + 2] += k * (u * u - s->poisson * v * v) / 2 + t * u * v;
    }
    const double energy = spring_forms_energy(&forms, x, 0);
    spring_forms_clear(&forms);
    free(x);
    return energy;
}

static void check_plate(double poisson)
{
    static const struct model model = {.name = "net"};
    const struct discretization d = {.model = &model, .points = {ROWS, COLUMNS, 1}};
    struct scene s;
    struct net net;

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.length = LENGTH, s.width = WIDTH, s.poisson = poisson;
    REQUIRE(net_init(&net, &s, &d, NULL) == STATUS_OK);
    const double B = scene_bending_stiffness(&s), *cell = net.mesh.cell,
                 beam = B * (1 - poisson * poisson) / 2 * BEND * BEND,
                 along = (LENGTH - cell[0]) * WIDTH,
                 across = poisson * poisson * (WIDTH - cell[1]) * cell[0],
                 twist = B * (1 - poisson) * BEND * BEND * LENGTH * WIDTH;
    CHECK_RELATIVE(bent(&s, &net.mesh, BEND, 0), beam * (along + across), ROUND_OFF);
    CHECK_RELATIVE(bent(&s, &net.mesh, 0, BEND), twist, ROUND_OFF);
    net_clear(&net);
    scene_clear(&s);
}

/* Cells are a by 1; `everywhere`: the third equation has a solution. */
static void check_hinges(const double B[LAW_ENTRIES], double a, bool everywhere)
{
    const struct hinge_rule k = hinge_rule_of(B, a, 1);
    const double P = k.v * a, Q = k.u * a * a * a, R = k.diagonal * a * (a * a + 1),
                 S = P + Q + R, G = (2 * B[LAW_12] + 4 * B[LAW_33]) * a * a;

    CHECK(k.everywhere == everywhere);
    CHECK(P > 0 && Q > 0 && R > 0 && k.held_u > 0 && k.held_v > 0);
    CHECK_RELATIVE(P - P * P / S, B[LAW_11], ROUND_OFF);
    CHECK_RELATIVE(Q - Q * Q / S, B[LAW_22] * a * a * a * a, ROUND_OFF);
    CHECK(everywhere == (fabs(R - 2 * P * Q / S - G) < ROUND_OFF * G));
}

int main(void)
{
    const struct law plain = law_isotropic(1e5, 0.3, 1e-3);
    const struct law woven =
        law_of_fabric(&(struct law_fabric){{380, 250, 90, 60}, {4e-4, 3e-4, 1e-4, 5e-5}});

    check_plate(0.3);
    check_plate(0);
    check_plate(-0.4);
    check_hinges(plain.matrix[LAW_BENDING], 1, true);
    check_hinges(plain.matrix[LAW_BENDING], 1.5, true);
    check_hinges(plain.matrix[LAW_BENDING], 0.5, false);
    check_hinges(plain.matrix[LAW_BENDING], 4, false);
    check_hinges(woven.matrix[LAW_BENDING], 1, true);
    return check_result();
}
