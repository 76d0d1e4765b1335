/* remedy=selective of the shell: constant strain is in balance inside. (Motions without
 * energy: cure_states.c and `clothbench verify matrices`; bending and falls: `elastica`,
 * `truths`.) */
#include "tests/shell_fixture.h"

/* Forces that balance: sums of some hundred products, against the largest of them. */
static const double BALANCE = 1e-12;

/* A flat sheet of degrees p and q whose knots are `grade`d (1: even), its points as affine
 * as they come. */
static void flat(struct shell_space *space, int p, int q, int n, int m, double grade)
{
    struct bspline basis[2];
    const int gauss[2] = {0, 0};
    double point[3 * 100];

    shell_bases(basis, p, n, q, m);
    for (int d = 0; d < 2; d++)
        for (int k = 0; k <= basis[d].n + basis[d].p; k++)
            basis[d].U[k] = pow(basis[d].U[k], grade);
    for (int a = 0; a < n * m; a++) {
        double u = bspline_greville(&basis[0], a / m),
               v = bspline_greville(&basis[1], a % m);
        point[3 * a] = 1.3 * u + 0.2 * v;
        point[3 * a + 1] = 0.9 * v;
        point[3 * a + 2] = 0;
    }
    CHECK(shell_space_init(space, basis, point, NULL, gauss, true, NULL) == STATUS_OK);
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
}

static void assemble(struct shell_assembly *s, const struct shell_space *space)
{
    const struct shell_material material = {.law = law_isotropic(3, 0.3, 0.1),
                                            .density = 2};

    REQUIRE(shell_assembly_init(s, space, 1, &material, NULL) == STATUS_OK);
}

/* Moved by a linear field in its plane, a sheet has constant strain: nothing acts on points
 * whose functions vanish on the border; its energy knows no knots, and is returned. */
static double check_patch(const struct shell_space *space)
{
    struct shell_assembly s = {0};
    size_t count = 3 * (size_t)space->nodes;
    double *x = malloc(2 * count * sizeof *x), *f = x + count, inside = 0, border = 0;
    int n = space->basis[0].n, m = space->basis[1].n;

    REQUIRE(x);
    assemble(&s, space);
    for (int a = 0; a < space->nodes; a++) {
        const double *r = space->rest + 3 * a;
        x[3 * a] = 1.1 * r[0] - 0.07 * r[1];
        x[3 * a + 1] = 0.04 * r[0] + 0.95 * r[1];
        x[3 * a + 2] = r[2];
    }
    CHECK(large_body_force(&s.body, &large_path_statics, x, f) == STATUS_OK);
    for (int a = 0; a < space->nodes; a++) {
        bool in = a / m > 0 && a / m < n - 1 && a % m > 0 && a % m < m - 1;
        double *worst = in ? &inside : &border;
        for (int i = 0; i < 3; i++)
            *worst = fmax(*worst, fabs(f[3 * a + i]));
    }
    CHECK(border > 0);
    CHECK(inside / border < BALANCE);
    double energy = NAN;
    CHECK(s.body.energy(s.body.self, x, &energy) == STATUS_OK);
    free(x);
    shell_assembly_clear(&s);
    return energy;
}

int main(void)
{
    static const double grades[] = {1, 1.5, 3};

    for (int n = 0; n < 4 * 4 * 3; n++) {
        static double energy[3];
        struct shell_space space = {0};
        const int p = 2 + n / 12, q = 2 + n / 3 % 4, k = n % 3;
        flat(&space, p, q, p + 4, q + 3, grades[k]);
        energy[k] = check_patch(&space);
        CHECK_RELATIVE(energy[k], energy[0], BALANCE);
        shell_space_clear(&space);
    }
    return check_result();
}
