/* Forces and Jacobians of a net of springs. */
#include "tests/derivative_fixture.h"
#include "tests/mass_spring.h"

/* A crumpled net: springs stretched and compressed by a tenth, hinges bent by all angles up
 * to a right one, no edge near zero. */
static void crumple(const struct spring_motion *m, double part, double *x)
{
    for (int t = 0; t < 3 * m->net.mesh.nodes; t++)
        x[t] = m->net.mesh.rest[t] + part * m->net.mesh.cell[0] * noise(t);
}

/* Along a direction d the force is -dE/dx and the Jacobian dF/dx, as h shrinks: the error
 * of central differences falls as h^2 until round-off meets it. */
static void check_derivatives(enum parameters parameters)
{
    /* truncation h^2 against round-off eps / h meet at eps^(2/3) = 4e-11; times a sum of
     * terms of curvature 1 / (edge / 2)^2 */
    const double swept = 1e-8;
    struct springs s;
    double best_force = INFINITY, best_jacobian = INFINITY;

    springs_init(&s, 6, 5, true);
    s.d.parameters = parameters;
    springs_start(&s);
    const struct spring_net *net = &s.m.springs;
    const size_t count = 3 * (size_t)net->mesh->nodes;
    double *x = calloc(7 * count, sizeof *x), *y = x + count, *f = y + count,
           *side[2] = {f + count, f + 2 * count}, *dir = f + 3 * count, *Kd = f + 4 * count;
    REQUIRE(x);
    crumple(&s.m, 0.25, x);
    for (size_t t = 0; t < count; t++) /* held points stay: a clamp knows nothing else */
        dir[t] = s.m.net.supports.free_index[t] < 0 ? 0 : noise(7 * t + 3);
    spring_force_add(net, x, f);
    spring_force_jacobian(net, x, s.m.march.K);
    blocks_multiply(&net->graph, (const double(*)[9])s.m.march.K, dir, Kd);
    double work = 0, size = 0, K_size = 0;
    for (size_t t = 0; t < count; t++) {
        work -= f[t] * dir[t];
        size += fabs(f[t] * dir[t]);
        if (dir[t] != 0)
            K_size = fmax(K_size, fabs(Kd[t]));
    }
    for (double h = 1e-3 * net->mesh->cell[0]; h > 1e-8 * net->mesh->cell[0]; h /= 4) {
        double energy[2], worst = 0;
        for (int k = 0; k < 2; k++) {
            for (size_t t = 0; t < count; t++)
                y[t] = x[t] + (k ? -h : h) * dir[t], side[k][t] = 0;
            energy[k] = spring_force_energy(net, y);
            spring_force_add(net, y, side[k]);
        }
        best_force = fmin(best_force, fabs((energy[0] - energy[1]) / (2 * h) - work));
        for (size_t t = 0; t < count; t++)
            if (dir[t] != 0)
                worst = fmax(worst, fabs((side[0][t] - side[1][t]) / (2 * h) + Kd[t]));
        best_jacobian = fmin(best_jacobian, worst);
    }
    const bool force = CHECK_NEAR(best_force / size, 0, swept),
               jacobian = CHECK_NEAR(best_jacobian / K_size, 0, swept);
    if (!force || !jacobian)
        printf("  parameters %d\n", (int)parameters);
    free(x);
    springs_clear(&s);
}

/* K y, and y K y over the sum of its terms' sizes. */
static double definite(const struct springs *s, const double (*K)[9], const double *y,
                       double *Ky)
{
    double product = 0, size = 0;

    blocks_multiply(&s->m.springs.graph, K, y, Ky);
    for (int t = 0; t < 3 * s->m.net.mesh.nodes; t++) {
        product += y[t] * Ky[t];
        size += fabs(y[t] * Ky[t]);
    }
    return product / size;
}

/* The clamped Jacobian is never negative, and is the true one where nothing is compressed
 * or bent. */
static void check_clamped(void)
{
    const double springs_round = 1e-9; /* k (1 - r/l), l rounded: eps k against P / a */
    struct springs s;
    double least = INFINITY, off = 0, most = 0;

    springs_init(&s, 6, 5, true);
    springs_start(&s);
    const struct spring_net *net = &s.m.springs;
    const double *hinges = s.m.lengths.hinges;
    double(*K)[9] = s.m.march.K;
    const double(*const constK)[9] = (const double(*)[9])K;
    int count = 3 * net->mesh->nodes;
    double *x = malloc(4 * (size_t)count * sizeof *x), *y = x + count, *Ky = y + count,
           *other = Ky + count;
    REQUIRE(x);
    crumple(&s.m, 0.25, x);
    for (int t = 0; t < count; t++) /* and compressed: the true one is negative here */
        x[t] *= 0.5;
    spring_force_clamped(net, x, hinges, K);
    for (int trial = 0; trial < 50; trial++) { /* half of them out of the plane */
        for (int t = 0; t < count; t++)
            y[t] = trial % 2 && t % 3 != 2 ? 0 : noise((trial + 2) * (t + 5));
        least = fmin(least, definite(&s, constK, y, Ky));
    }
    CHECK(least >= 0);
    spring_force_jacobian(net, x, K);
    CHECK(definite(&s, constK, y, Ky) < 0);
    for (int t = 0; t < count; t++) /* out of the plane: bending alone, the same in both */
        y[t] = t % 3 == 2 ? noise(t) : 0;
    spring_force_jacobian(net, net->mesh->rest, K);
    definite(&s, constK, y, Ky);
    spring_force_clamped(net, net->mesh->rest, hinges, K);
    definite(&s, constK, y, other);
    for (int t = 0; t < count; t++)
        if (s.m.net.supports.free_index[t] >= 0) {
            off = fmax(off, fabs(Ky[t] - other[t]));
            most = fmax(most, fabs(Ky[t]));
        }
    CHECK(most > 0);
    CHECK_NEAR(off / most, 0, springs_round);
    free(x);
    springs_clear(&s);
}

/* Checks a net as the march has it. softens: its law falls to a tenth within the net's
 * curvatures, which reach far beyond. */
static void check_body(enum integrator integrator, const char *mesh, bool softens)
{
    const double DIFFERENCE = 5e-9; /* derivative_fixture.h */
    struct springs s;

    springs_init(&s, 7, 6, true);
    s.d.integrator = integrator;
    s.d.mesh = mesh ? strdup(mesh) : NULL;
    if (softens) {
        s.scene.fabric = (struct law_fabric){
            {2000, 5000, 800, 300}, {1e-2, 4e-2, 4e-3, 6e-3}, 90, 0.1, {-1e-3, -3e-3}};
        scene_use_fabric(&s.scene);
    }
    springs_start(&s);
    const int count = 3 * s.m.net.mesh.nodes;
    double *x = malloc(2 * (size_t)count * sizeof *x), *along = x + count;
    REQUIRE(x);
    for (int t = 0; t < count; t++) {
        x[t] = 1.1 * s.m.net.mesh.rest[t] + 0.02 * noise(t);
        along[t] = noise(3 * t + 1);
    }
    derivative_check(&s.m.march.body, s.m.march.graph, x, along, DIFFERENCE);
    free(x);
    free(s.d.mesh);
    springs_clear(&s);
}

int main(void)
{
    check_body(INTEGRATOR_MOMENTUM, NULL, false);
    check_body(INTEGRATOR_MOMENTUM, NULL, true);
    check_body(INTEGRATOR_IMPLICIT, "irregular", false);
    check_derivatives(PARAMETERS_PAPER);
    check_derivatives(PARAMETERS_MATCHED);
    check_clamped();
    return check_result();
}
