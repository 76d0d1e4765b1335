/* Forces and Jacobians of a net of springs. */
#include "tests/derivative_fixture.h"
#include "tests/mass_spring.h"

/* A crumpled net: springs stretched and compressed by a tenth, hinges bent by all angles up
 * to a right one, no edge near zero. */
static void crumple(const struct spring_motion *m, double part, double *x)
{
    for (int t = 0; t < 3 * m->net.nodes; t++)
        x[t] = m->net.rest[t] + part * m->net.cell[0] * noise(t);
}

static double difference(double h, double plus, double minus)
{
    return (plus - minus) / (2 * h);
}

/* Along a direction d the force is -dE/dx and the Jacobian dF/dx, as h shrinks: the error
 * of central differences falls as h^2 until round-off meets it. */
static void check_derivatives(const char *set, enum parameters parameters)
{
    struct scene scene;
    struct spring_motion m;
    struct discretization d = net_of(6, 5);
    double best_force = INFINITY, best_jacobian = INFINITY;

    printf("derivatives, %s\n", set);
    fill_scene(&scene, true);
    d.parameters = parameters;
    start(&m, &scene, &d);
    int count = 3 * m.net.nodes;
    double *x = malloc(7 * (size_t)count * sizeof *x), *y = x + count, *f = y + count,
           *plus = f + count, *minus = plus + count, *dir = minus + count,
           *Kd = dir + count;
    REQUIRE(x);
    crumple(&m, 0.25, x);
    for (int t = 0; t < count; t++) /* held points stay: a clamp knows nothing else */
        dir[t] = m.newton.supports.free_index[t] < 0 ? 0 : noise(7 * t + 3);
    memset(f, 0, (size_t)count * sizeof *f);
    spring_force_add(&m.net, x, f);
    spring_force_jacobian(&m.net, x, m.newton.K);
    blocks_multiply(&m.net.graph, (const double(*)[9])m.newton.K, dir, Kd);
    double work = 0, size = 0, K_size = 0;
    for (int t = 0; t < count; t++) {
        work -= f[t] * dir[t];
        size += fabs(f[t] * dir[t]);
        if (dir[t] != 0)
            K_size = fmax(K_size, fabs(Kd[t]));
    }
    for (double h = 1e-3 * m.net.cell[0]; h > 1e-8 * m.net.cell[0]; h /= 4) {
        double energy[2], worst = 0;
        for (int side = 0; side < 2; side++) {
            double *force = side ? minus : plus;
            for (int t = 0; t < count; t++)
                y[t] = x[t] + (side ? -h : h) * dir[t];
            energy[side] = spring_force_energy(&m.net, y);
            memset(force, 0, (size_t)count * sizeof *force);
            spring_force_add(&m.net, y, force);
        }
        best_force = fmin(best_force, fabs(difference(h, energy[0], energy[1]) - work));
        for (int t = 0; t < count; t++)
            if (dir[t] != 0)
                worst = fmax(worst, fabs(difference(h, plus[t], minus[t]) + Kd[t]));
        best_jacobian = fmin(best_jacobian, worst);
    }
    /* truncation h^2 against round-off eps / h meet at eps^(2/3) = 4e-11; times a sum of
     * terms of curvature 1 / (edge / 2)^2 */
    const double swept = 1e-8;
    CHECK_NEAR(best_force / size, 0, swept);
    CHECK_NEAR(best_jacobian / K_size, 0, swept);
    free(x);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

/* The clamped Jacobian is never negative, and is the true one where nothing is compressed
 * or bent. */
static void check_clamped(void)
{
    struct scene scene;
    struct spring_motion m;
    struct discretization d = net_of(6, 5);
    double least = INFINITY;

    fill_scene(&scene, true);
    start(&m, &scene, &d);
    int count = 3 * m.net.nodes;
    long pairs = m.net.graph.start[m.net.nodes];
    double *x = malloc(4 * (size_t)count * sizeof *x), *y = x + count, *Ky = y + count;
    double(*K)[9] = malloc((size_t)pairs * sizeof *K);
    REQUIRE(x && K);
    crumple(&m, 0.25, x);
    for (int t = 0; t < count; t++) /* and compressed: the true one is negative here */
        x[t] *= 0.5;
    const double *hinges = m.newton.hinges;
    spring_force_clamped(&m.net, x, hinges, m.newton.K);
    for (int trial = 0; trial < 50; trial++) { /* half of them out of the plane */
        double product = 0, size = 0;
        for (int t = 0; t < count; t++)
            y[t] = trial % 2 && t % 3 != 2 ? 0 : noise((trial + 2) * (t + 5));
        blocks_multiply(&m.net.graph, (const double(*)[9])m.newton.K, y, Ky);
        for (int t = 0; t < count; t++) {
            product += y[t] * Ky[t];
            size += fabs(y[t] * Ky[t]);
        }
        least = fmin(least, product / size);
    }
    CHECK(least >= 0);
    spring_force_jacobian(&m.net, x, m.newton.K);
    blocks_multiply(&m.net.graph, (const double(*)[9])m.newton.K, y, Ky);
    double negative = 0;
    for (int t = 0; t < count; t++)
        negative += y[t] * Ky[t];
    CHECK(negative < 0);
    memcpy(x, m.net.rest, (size_t)count * sizeof *x);
    spring_force_jacobian(&m.net, x, m.newton.K);
    spring_force_clamped(&m.net, x, hinges, K);
    double off = 0, most = 0;
    for (int t = 0; t < count; t++) /* out of the plane: bending alone, the same in both */
        y[t] = t % 3 == 2 ? noise(t) : 0;
    blocks_multiply(&m.net.graph, (const double(*)[9])m.newton.K, y, Ky);
    blocks_multiply(&m.net.graph, (const double(*)[9])K, y, x);
    for (int t = 0; t < count; t++)
        if (m.newton.supports.free_index[t] >= 0) {
            off = fmax(off, fabs(Ky[t] - x[t]));
            most = fmax(most, fabs(Ky[t]));
        }
    const double springs_round = 1e-9; /* k (1 - r/l), l rounded: eps k against P / a */
    CHECK(most > 0);
    CHECK_NEAR(off / most, 0, springs_round);
    free(x);
    free(K);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

/* What the momentum scheme moves: the stencil's energy and force, element by element. */
static const struct spring_stencil *stencil;

static enum status stencil_energy(const void *self, const double *x, double *energy)
{
    (void)self;
    *energy = spring_stencil_energy(stencil, x);
    return STATUS_OK;
}

static void check_strips(void)
{
    enum { COUNT = 3 * 7 * 6 };
    const double DIFFERENCE = 5e-9,
                 ALIKE = 1e-12; /* derivative_fixture.h; sums reordered */
    struct scene scene;
    struct spring_motion m;
    struct discretization d = net_of(7, 6);
    double x[COUNT], along[COUNT], f[COUNT], apart[COUNT] = {0};

    d.integrator = INTEGRATOR_MOMENTUM;
    fill_scene(&scene, true);
    start(&m, &scene, &d);
    stencil = &m.stencil;
    struct large_body body = m.strips.body;
    body.energy = stencil_energy;
    for (int t = 0; t < COUNT; t++) {
        x[t] = 1.1 * m.net.rest[t] + 0.02 * noise(t);
        along[t] = noise(3 * t + 1);
    }
    derivative_check(&body, &m.net.graph, x, along, DIFFERENCE);
    CHECK(large_body_force(&body, &derivative_statics, x, f) == STATUS_OK);
    spring_stencil_force_add(stencil, x, apart);
    for (int t = 0; t < COUNT; t++)
        apart[t] += f[t];
    CHECK_NEAR(derivative_norm(COUNT, apart) / derivative_norm(COUNT, f), 0, ALIKE);
    /* and the stencil's own matrix, for who seeks rest */
    double(*K)[9] = m.newton.K ? m.newton.K : m.large.K;
    CHECK(large_body_tangent(&body, &derivative_statics, x, (struct large_foresight){0},
                             K) == STATUS_OK);
    blocks_multiply(&m.net.graph, (const double(*)[9])K, along, f);
    spring_stencil_jacobian(stencil, x, false, K);
    blocks_multiply(&m.net.graph, (const double(*)[9])K, along, apart);
    for (int t = 0; t < COUNT; t++)
        apart[t] -= f[t];
    CHECK_NEAR(derivative_norm(COUNT, apart) / derivative_norm(COUNT, f), 0, ALIKE);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

int main(void)
{
    check_strips();
    check_derivatives("paper", PARAMETERS_PAPER);
    check_derivatives("matched", PARAMETERS_MATCHED);
    check_clamped();
    return check_result();
}
