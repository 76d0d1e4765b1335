/* The shell's forces are the derivative of its energy and its tangent that of its forces,
 * by central differences at swept steps; rigid motions cost nothing; tables of functions
 * that are kept change no bit. For flat, curved and rational sheets of every degree, by the
 * full rule and by the cured one. */
#include "tests/derivative_fixture.h"
#include "tests/shell_fixture.h"

/* derivative_fixture.h */
static const double DIFFERENCE = 2e-9;
/* Energy and forces of a moved rest shape against those of a deformed one: squares of
 * strains that are a few hundred roundings. */
static const double RIGID_ENERGY = 1e-24, RIGID_FORCE = 1e-10;
/* A sum of a few hundred products in either order. */
static const double SYMMETRIC = 1e-12;

/* Strains that a mid-point's tangent foresaw, from x to x + d in a step from rest: the
 * membrane's are quadratic, their differences about its geometry exact. */
static void check_foreseen(const struct shell_assembly *s, const double *x, const double *d)
{
    const struct large_body *b = &s->body;
    size_t count = 3 * (size_t)s->space->nodes;
    double *at = malloc(5 * count * sizeof *at), *want = calloc(b->lagged, sizeof *want);

    REQUIRE(at && want);
    for (size_t t = 0; t < count; t++) {
        double middle = (s->space->rest[t] + x[t]) / 2;
        at[t] = x[t], at[count + t] = middle + d[t] / 2;
        at[2 * count + t] = middle - d[t] / 2;
        at[3 * count + t] = x[t] + d[t];
        at[4 * count + t] = x[t] + d[t] - s->space->rest[t];
    }
    for (int k = 0; k < 3; k++) {
        const double *e = b->strain(b->self, 0, 0, at + (size_t)k * count, NULL);
        for (size_t n = 0; e && n < b->lagged; n++)
            want[n] += k < 2 ? e[n] : -e[n];
    }
    const double *e =
        b->strain(b->self, 0, 0, at + 3 * count,
                  &(struct large_foresight){.change = d, .beside = at + 4 * count});
    for (size_t n = 0; e && n < b->lagged; n++)
        CHECK_NEAR(e[n], want[n], SYMMETRIC);
    CHECK(e);
    free(at);
    free(want);
}

/* The same bits by tables of functions that are kept, and made each time: *space is s's. */
static void check_kept(const struct shell_assembly *s, struct shell_space *space,
                       const double *x)
{
    size_t count = 3 * (size_t)space->nodes;
    double *f[2] = {malloc(count * sizeof *f[0]), malloc(count * sizeof *f[1])};

    REQUIRE(f[0] && f[1]);
    CHECK(space->table);
    for (int made = 0; made < 2; made++) {
        CHECK(large_body_force(&s->body, &large_path_statics, x, f[made]) == STATUS_OK);
        space->table = NULL;
    }
    CHECK(!memcmp(f[0], f[1], count * sizeof *f[0]));
    free(f[0]);
    free(f[1]);
}

/* Makes a law soften along two directions, some points within its range, some beyond. */
static void soften(struct shell_material *m)
{
    const double B = m->law.matrix[LAW_BENDING][LAW_11];

    m->law.softens = true;
    for (int i = 0; i < 2; i++) {
        m->law.soft[i] = (struct law_soft){-0.02 * B, 0.5 + i};
        memcpy(m->along[i], (double[]){0.4 + i, 1.3 - i, 0.7}, sizeof m->along[i]);
    }
}

static void check_shell(int p, int n, int q, int m, bool weights, bool selective,
                        double thickness, bool softens)
{
    struct shell_space space = {0};
    struct shell_assembly s = {0};
    struct shell_material material = {.law = law_isotropic(3, 0.3, thickness),
                                      .density = 2};

    if (softens)
        soften(&material);

    shell_curved(&space, p, n, q, m, weights, selective);
    REQUIRE(shell_assembly_init(&s, &space, 1, &material, NULL) == STATUS_OK);
    double *x = shell_moved(&space, 0.05, 3), *d = shell_moved(&space, 0.5, 11);
    for (int t = 0; t < 3 * space.nodes; t++)
        d[t] -= space.rest[t];
    derivative_check(&s.body, &s.graph, x, d, DIFFERENCE);
    for (int t = 0; t < 3 * space.nodes; t++)
        d[t] *= 0.1; /* a surface on either side */
    check_foreseen(&s, x, d);
    derivative_rigid(&s.body, space.rest, 0.7, derivative_energy(&s.body, x), RIGID_ENERGY,
                     RIGID_FORCE);
    check_kept(&s, &space, x);
    free(x);
    free(d);
    shell_assembly_clear(&s);
    shell_space_clear(&space);
}

int main(void)
{
    for (int cured = 0; cured < 2; cured++) {
        for (int p = 2; p <= 5; p++) {
            check_shell(p, p + 3, p, p + 2, false, cured, 0.1, p == 3);
            check_shell(p, p + 2, p, p + 3, true, cured, 0.1, false);
        }
        check_shell(2, 6, 3, 5, true, cured, 1.0, true);    /* bending rules */
        check_shell(3, 5, 2, 5, false, cured, 1e-3, false); /* membrane rules */
    }
    return check_result();
}
