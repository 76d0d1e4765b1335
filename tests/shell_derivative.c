/* The shell's forces are the derivative of its energy and its tangent that of its forces,
 * by central differences at swept steps; rigid motions cost nothing; tables of functions
 * that are kept change no bit. For flat, curved and rational sheets of every degree, by the
 * full rule and by the cured one. */
#include "tests/shell_fixture.h"

static const struct large_path statics = {.s1 = 1, .g1 = 1};

/* Best of a sweep of steps: truncation falls as step^2, rounding grows as eps/step. For
 * values of size 1 and smooth functions the minimum is some 1e-10 to 1e-11; a wrong term is
 * 1e-3 and more. */
static const double DIFFERENCE = 2e-9;
/* Energy and forces of a moved rest shape against those of a deformed one: squares of
 * strains that are a few hundred roundings. */
static const double RIGID_ENERGY = 1e-24, RIGID_FORCE = 1e-10;
/* A sum of a few hundred products in either order. */
static const double SYMMETRIC = 1e-12;

static double energy_at(const struct shell_assembly *s, const double *x)
{
    double energy = 0;
    CHECK(shell_assembly_energy(s, x, &energy) == STATUS_OK);
    return energy;
}

static double norm(size_t count, const double *a)
{
    return sqrt(shell_dot(count, a, a));
}

/* Smallest relative misfit over the sweep of (g(x + t d) - g(x - t d)) / 2t against want.
 */
static void check_force(const struct shell_assembly *s, const double *x, const double *d)
{
    size_t count = 3 * (size_t)s->space->nodes;
    double *f = malloc(2 * count * sizeof *f), *moved = f + count, best = 1;

    REQUIRE(f);
    CHECK(large_body_force(&s->body, &statics, x, f) == STATUS_OK);
    double want = shell_dot(count, f, d), scale = norm(count, f) * norm(count, d);
    for (double step = 1e-3; step > 1e-8; step /= 4) {
        double energy[2];
        for (int side = 0; side < 2; side++) {
            for (size_t t = 0; t < count; t++)
                moved[t] = x[t] + (side ? step : -step) * d[t];
            energy[side] = energy_at(s, moved);
        }
        best = fmin(best, fabs((energy[1] - energy[0]) / (2 * step) - want) / scale);
    }
    CHECK_NEAR(best, 0, DIFFERENCE);
    free(f);
}

static void check_tangent(const struct shell_assembly *s, const double *x, const double *d)
{
    size_t count = 3 * (size_t)s->space->nodes;
    double *want = malloc(4 * count * sizeof *want), best = 1;
    double *moved = want + count, *f[2] = {moved + count, moved + 2 * count};
    double(*K)[9] = malloc((size_t)s->graph.start[s->graph.nodes] * sizeof *K);

    REQUIRE(want && K);
    CHECK(large_body_tangent(&s->body, &statics, x, (struct large_foresight){0}, K) ==
          STATUS_OK);
    blocks_multiply(&s->graph, (const double(*)[9])K, d, want);
    for (double step = 1e-3; step > 1e-8; step /= 4) {
        for (int side = 0; side < 2; side++) {
            for (size_t t = 0; t < count; t++)
                moved[t] = x[t] + (side ? step : -step) * d[t];
            CHECK(large_body_force(&s->body, &statics, moved, f[side]) == STATUS_OK);
        }
        for (size_t t = 0; t < count; t++)
            moved[t] = (f[1][t] - f[0][t]) / (2 * step) - want[t];
        best = fmin(best, norm(count, moved) / norm(count, want));
    }
    CHECK_NEAR(best, 0, DIFFERENCE);
    for (int a = 0; a < s->graph.nodes; a++) { /* diagonal blocks: K itself is symmetric */
        const double *k = K[s->graph.start[a]];
        double scale = fabs(k[0]) + fabs(k[4]) + fabs(k[8]);
        CHECK_NEAR((fabs(k[1] - k[3]) + fabs(k[2] - k[6]) + fabs(k[5] - k[7])) / scale, 0,
                   SYMMETRIC);
    }
    free(want);
    free(K);
}

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

/* Turn by 2.1 rad about (1,2,2)/3 and shift. */
static void check_rigid(const struct shell_assembly *s, double deformed)
{
    const double axis[3] = {1 / 3., 2 / 3., 2 / 3.}, c = cos(2.1), n = sin(2.1);
    size_t count = 3 * (size_t)s->space->nodes;
    double *x = malloc(2 * count * sizeof *x), *f = x + count;

    REQUIRE(x);
    for (int a = 0; a < s->space->nodes; a++) {
        const double *r = s->space->rest + 3 * a;
        double along = shell_dot(3, axis, r);
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            x[3 * a + i] = c * r[i] + (1 - c) * along * axis[i] +
                           n * (axis[j] * r[k] - axis[k] * r[j]) + 0.7;
        }
    }
    CHECK_NEAR(energy_at(s, x) / deformed, 0, RIGID_ENERGY);
    CHECK(large_body_force(&s->body, &statics, x, f) == STATUS_OK);
    CHECK_NEAR(norm(count, f) / deformed, 0, RIGID_FORCE);
    free(x);
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
        CHECK(large_body_force(&s->body, &statics, x, f[made]) == STATUS_OK);
        space->table = NULL;
    }
    CHECK(!memcmp(f[0], f[1], count * sizeof *f[0]));
    free(f[0]);
    free(f[1]);
}

static void check_shell(int p, int n, int q, int m, bool weights, bool selective,
                        double thickness)
{
    struct shell_space space = {0};
    struct shell_assembly s = {0};
    const struct shell_material material = {
        .young = 3.0, .poisson = 0.3, .density = 2, .thickness = thickness};

    shell_curved(&space, p, n, q, m, weights, selective);
    REQUIRE(shell_assembly_init(&s, &space, &material, NULL) == STATUS_OK);
    double *x = shell_moved(&space, 0.05, 3), *d = shell_moved(&space, 0.5, 11);
    for (int t = 0; t < 3 * space.nodes; t++)
        d[t] -= space.rest[t];
    check_force(&s, x, d);
    check_tangent(&s, x, d);
    for (int t = 0; t < 3 * space.nodes; t++)
        d[t] *= 0.1; /* a surface on either side */
    check_foreseen(&s, x, d);
    check_rigid(&s, energy_at(&s, x));
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
            check_shell(p, p + 3, p, p + 2, false, cured, 0.1);
            check_shell(p, p + 2, p, p + 3, true, cured, 0.1);
        }
        check_shell(2, 6, 3, 5, true, cured, 1.0);   /* bending rules */
        check_shell(3, 5, 2, 5, false, cured, 1e-3); /* membrane rules */
    }
    return check_result();
}
