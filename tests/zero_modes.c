/* A free solid has exactly six zero modes: its stiffness has six eigenvalues at round-off,
 * then a gap of many decades; and rigid motions need no force. One missing Gauss point, one
 * dropped coupling or one wrong sign breaks this.
 *
 *   zero_modes iga|reduced|selective|hex|incompatible
 */
#include <float.h>

#include "tests/solid_fixture.h"

/* Backward error of the eigenvalues: some n eps |K|, n <= 432, of which a tenth is seen. */
#define TOL_ZERO (100 * DBL_EPSILON)
/* The softest mode of these boxes, bending, against the stiffest, one span through the
 * thickness: (thickness / length)^2 = 1e-2 times (span through / span along)^2 = 1e-2, and
 * a tenth to a thousandth of that for more functions a span; measured 4e-7 or more. */
static const double LEAST_STIFFNESS = 1e-7;
/* "Many decades". */
static const double GAP = 1e6;
/* Rigid motions: sums over up to 3 * 9^2 * 4 neighbours, relative to the row of K. */
#define TOL_RIGID (20 * DBL_EPSILON)

static void check_eigenvalues(const struct solid *s, const char *name)
{
    int n = 3 * s->space.nodes;
    double *K = solid_dense(&s->assembly.graph, s->assembly.K);
    double *lambda = malloc((size_t)n * sizeof *lambda), zero = 0;

    REQUIRE(lambda && !LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'N', 'U', n, K, n, lambda));
    for (int k = 0; k < 6; k++)
        zero = fmax(zero, fabs(lambda[k]) / lambda[n - 1]);
    bool good = CHECK_NEAR(zero, 0, TOL_ZERO);
    good &= CHECK(lambda[6] > LEAST_STIFFNESS * lambda[n - 1]);
    good &= CHECK(lambda[6] > GAP * zero * lambda[n - 1]);
    if (!good)
        printf("  %s: zero %.1e, next %.1e of the largest\n", name, zero,
               lambda[6] / lambda[n - 1]);
    free(K);
    free(lambda);
}

/* Motion k of the rest shape: three translations, three rotations about the origin. In the
 * thickness basis a translation moves the first coefficient of a column only. */
static void rigid(const struct solid *s, int k, double *d)
{
    int l = s->patch.basis[2].n;

    for (int a = 0; a < s->space.nodes; a++) {
        const double *x = s->space.rest + 3 * a;
        int i = (k + 1) % 3, j = (k + 2) % 3;
        d[3 * a] = d[3 * a + 1] = d[3 * a + 2] = 0;
        if (k < 3)
            d[3 * a + k] = !s->space.thickness_basis || a % l == 0;
        else
            d[3 * a + i] = -x[j], d[3 * a + j] = x[i];
    }
}

static void check_rigid(const struct solid *s)
{
    size_t n = 3 * (size_t)s->space.nodes;
    double *K = solid_dense(&s->assembly.graph, s->assembly.K);
    double *d = malloc(n * sizeof *d), worst = 0;

    REQUIRE(d);
    for (int k = 0; k < 6; k++) {
        rigid(s, k, d);
        for (size_t r = 0; r < n; r++) { /* |d| <= 1 here */
            double f = 0, scale = 0;
            for (size_t c = 0; c < n; c++) {
                f += K[r * n + c] * d[c];
                scale += fabs(K[r * n + c]);
            }
            worst = fmax(worst, fabs(f) / scale);
        }
    }
    CHECK_NEAR(worst, 0, TOL_RIGID);
    free(K);
    free(d);
}

static void check_case(const struct solid_case *c, bool distorted, bool thickness)
{
    struct solid_material material = solid_element_material(3.0, 0.3, 1.0);
    struct patch patch = {0};
    struct solid s;
    uint64_t state = 5;
    char name[64];

    solid_box(c, &patch);
    if (distorted) {
        solid_skew(&patch);
        solid_shake(&patch, c->size, 0.4, &state);
    }
    solid_make(&s, c->kind, &patch, (const int[3]){0}, thickness, &material);
    snprintf(name, sizeof name, "degrees %d %d %d, %s, %s", c->degree[0], c->degree[1],
             c->degree[2], distorted ? "distorted" : "box",
             thickness ? "thickness unknowns" : "control points");
    check_eigenvalues(&s, name);
    check_rigid(&s);
    solid_clear(&s);
}

static void check_all(const struct solid_case *c)
{
    for (int distorted = 0; distorted < 2; distorted++)
        for (int thickness = 0; thickness < 2; thickness++)
            if (!thickness || c->points[2] == c->degree[2] + 1)
                check_case(c, distorted, thickness);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    enum solid_kind kind = solid_kind(argv[1]);
    struct solid_case c = {kind, {1, 1, 1}, {5, 4, 2}, {1, 0.8, 0.1}};

    if (kind > SOLID_SELECTIVE) {
        check_all(&c);
        c.points[2] = 3;
        check_all(&c);
        return check_result();
    }
    for (int p = kind == SOLID_IGA ? 1 : 2; p <= 4; p++)
        for (int r = 1; r <= (kind == SOLID_SELECTIVE ? 1 : 3); r++)
            for (int more = 2; more <= 5; more += 3) {
                c = (struct solid_case){
                    kind, {p, p, r}, {p + more, p + 2, r + 1}, {1, 0.8, 0.1}};
                check_all(&c);
            }
    c = (struct solid_case){kind, {2, 3, 2}, {4, 4, 5}, {1, 0.8, 0.1}};
    if (kind != SOLID_SELECTIVE)
        check_all(&c);
    return check_result();
}
