/* Patch tests: fields of constant strain on every net, pure twist and pure bending where
 * the space holds them.
 *
 * Twist u = (-k y z, -k x z, k x y) has the one stress xy = -2 mu k z; bending
 * u = (k x z, -nu k y z, -k (x^2 - nu y^2 + nu z^2) / 2) the one stress xx = E k z. Neither
 * needs a body force, so that K d must equal the sums int sigma grad N_a, integrated here
 * from the patch's own gradients, and must vanish at every node inside.
 *
 *   patch_test iga|hex|incompatible
 */
#include <float.h>

#include "models/linalg/gauss.h"
#include "tests/solid_fixture.h"

/* Forces are sums over up to 3 * 9^3 neighbours of products whose errors are those of the
 * entries of K (216 Gauss points, gradients a dozen roundings old) and of the interpolated
 * coefficients (collocation matrices of condition below 100): relative to the sum of
 * |K| |d| less than a hundred roundings. */
#define TOL_FORCE (100 * DBL_EPSILON)
/* A field the space does not hold misses by (element size / curvature's reach)^2 at least:
 * far above round-off, so that a test which cannot fail would be seen. */
#define LEAST_MISS 1e-4

static const double young = 3.0, curvature = 0.7;
static double nu; /* of the case at hand */

static void bending(const double x[3], double u[3])
{
    u[0] = curvature * x[0] * x[2];
    u[1] = -nu * curvature * x[1] * x[2];
    u[2] = -curvature * (x[0] * x[0] - nu * x[1] * x[1] + nu * x[2] * x[2]) / 2;
}

static void bending_stress(const double x[3], double s[3][3])
{
    memset(s, 0, 9 * sizeof(double));
    s[0][0] = young * curvature * x[2];
}

static void twist(const double x[3], double u[3])
{
    u[0] = -curvature * x[1] * x[2];
    u[1] = -curvature * x[0] * x[2];
    u[2] = curvature * x[0] * x[1];
}

static void twist_stress(const double x[3], double s[3][3])
{
    memset(s, 0, 9 * sizeof(double));
    s[0][1] = s[1][0] = -young / (1 + nu) * curvature * x[2];
}

static const double slope[3][3] = {{0.3, -0.7, 0.2}, {0.5, -0.4, 0.9}, {-0.1, 0.6, 0.8}};

static void linear(const double x[3], double u[3])
{
    for (int i = 0; i < 3; i++)
        u[i] = 0.1 * (i + 1) + slope[i][0] * x[0] + slope[i][1] * x[1] + slope[i][2] * x[2];
}

/* Hooke's law as sigma = E / (1 + nu) (strain + nu / (1 - 2 nu) trace). */
static void linear_stress(const double x[3], double s[3][3])
{
    double trace = slope[0][0] + slope[1][1] + slope[2][2];

    (void)x;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            s[i][j] =
                young / (1 + nu) *
                ((slope[i][j] + slope[j][i]) / 2 + (i == j) * nu / (1 - 2 * nu) * trace);
}

struct field {
    const char *name;
    solid_field *displacement;
    void (*stress)(const double x[3], double s[3][3]);
};

static const struct field constant_strain = {"constant strain", linear, linear_stress},
                          pure_twist = {"twist", twist, twist_stress},
                          pure_bending = {"bending", bending, bending_stress};

/* Gradients of the functions at a point times det J: returns det J. */
static double gradients(const struct patch *patch, const double uvw[3], double x[3],
                        double (*g)[3], int *node)
{
    int span[3], local = patch_local(patch);
    double dR[3 * PATCH_MAX_LOCAL], J[3][3], C[3][3];

    patch_point(patch, uvw, x, J);
    patch_basis(patch, uvw, span, NULL, dR);
    patch_local_nodes(patch, span, node);
    for (int i = 0; i < 3; i++) { /* cofactors: columns of the inverse by cross products */
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        for (int j = 0; j < 3; j++) {
            int c = (j + 1) % 3, d = (j + 2) % 3;
            C[i][j] = J[a][c] * J[b][d] - J[b][c] * J[a][d];
        }
    }
    for (int t = 0; t < local; t++)
        for (int i = 0; i < 3; i++)
            g[t][i] =
                C[i][0] * dR[t] + C[i][1] * dR[local + t] + C[i][2] * dR[2 * local + t];
    return J[0][0] * C[0][0] + J[0][1] * C[0][1] + J[0][2] * C[0][2];
}

/* f_a = int sigma grad N_a dV over one element, corner and edges of its span given. */
static void add_element(const struct patch *patch, const struct field *field,
                        const double corner[3], const double edge[3], const int gauss[3],
                        double *f)
{
    double at[3][GAUSS_MAX], w[3][GAUSS_MAX], g[PATCH_MAX_LOCAL][3], s[3][3], x[3];
    int node[PATCH_MAX_LOCAL];

    for (int d = 0; d < 3; d++)
        gauss_rule(gauss[d], at[d], w[d]);
    for (int i = 0; i < gauss[0]; i++)
        for (int j = 0; j < gauss[1]; j++)
            for (int k = 0; k < gauss[2]; k++) {
                const double uvw[3] = {corner[0] + edge[0] * at[0][i],
                                       corner[1] + edge[1] * at[1][j],
                                       corner[2] + edge[2] * at[2][k]};
                double weight = w[0][i] * edge[0] * w[1][j] * edge[1] * w[2][k] * edge[2];
                gradients(patch, uvw, x, g, node);
                field->stress(x, s);
                for (int t = 0; t < patch_local(patch); t++)
                    for (int c = 0; c < 3; c++)
                        f[3 * node[t] + c] +=
                            weight *
                            (s[c][0] * g[t][0] + s[c][1] * g[t][1] + s[c][2] * g[t][2]);
            }
}

static void exact_forces(const struct patch *patch, const struct field *field,
                         const int gauss[3], double *f)
{
    int span[3][64], count[3];

    memset(f, 0, 3 * (size_t)patch_nodes(patch) * sizeof *f);
    for (int d = 0; d < 3; d++)
        count[d] = bspline_spans(&patch->basis[d], span[d]);
    for (int e = 0; e < count[0] * count[1] * count[2]; e++) {
        const int at[3] = {e / (count[1] * count[2]), e / count[2] % count[1],
                           e % count[2]};
        double corner[3], edge[3];
        for (int d = 0; d < 3; d++) {
            const double *U = patch->basis[d].U + span[d][at[d]];
            corner[d] = U[0], edge[d] = U[1] - U[0];
        }
        add_element(patch, field, corner, edge, gauss, f);
    }
}

static bool inside(const struct patch *patch, int node)
{
    int m = patch->basis[1].n, l = patch->basis[2].n, n = patch->basis[0].n;
    int i = node / (m * l), j = node / l % m, k = node % l;

    return i > 0 && i < n - 1 && j > 0 && j < m - 1 && k > 0 && k < l - 1;
}

/* K d and the sums of |K| |d| beside it. */
static void forces(const struct solid *s, const double *d, double *f, double *scale)
{
    size_t count = 3 * (size_t)s->space.nodes;
    long pairs = s->assembly.graph.start[s->space.nodes];
    double(*K)[9] = malloc((size_t)pairs * sizeof *K), *size = malloc(count * sizeof *size);

    REQUIRE(K && size);
    for (long n = 0; n < pairs; n++)
        for (int t = 0; t < 9; t++)
            K[n][t] = fabs(s->assembly.K[n][t]);
    for (size_t t = 0; t < count; t++)
        size[t] = fabs(d[t]);
    blocks_multiply(&s->assembly.graph, (const double(*)[9])s->assembly.K, d, f);
    blocks_multiply(&s->assembly.graph, (const double(*)[9])K, size, scale);
    free(K);
    free(size);
}

/* Compares K d with the forces of the field and, if the quadrature is `exact`, with zero
 * inside. */
static void check_field(const struct solid *s, const struct field *field,
                        const int gauss[3], bool holds, bool exact, const char *shape)
{
    size_t count = 3 * (size_t)s->space.nodes;
    double *d = calloc(4 * count, sizeof *d), *f = d + count, *scale = d + 2 * count,
           *want = d + 3 * count, worst = 0, worst_inside = 0;
    const struct bspline *b = s->patch.basis;

    REQUIRE(d);
    solid_interpolate(&s->patch, field->displacement, d);
    forces(s, d, f, scale);
    exact_forces(&s->patch, field, gauss, want);
    for (size_t t = 0; t < count; t++) {
        worst = fmax(worst, fabs(f[t] - want[t]) / scale[t]);
        if (exact && inside(&s->patch, (int)t / 3))
            worst_inside = fmax(worst_inside, fabs(f[t]) / scale[t]);
    }
    if (!holds)
        CHECK(worst > LEAST_MISS);
    else if (CHECK_NEAR(worst, 0, TOL_FORCE) + CHECK_NEAR(worst_inside, 0, TOL_FORCE) < 2)
        printf("  %s, %s net, degrees %d %d %d, nu %g\n", field->name, shape, b[0].p,
               b[1].p, b[2].p, nu);
    free(d);
}

enum shape { BOX, SKEWED, DISTORTED, RATIONAL };
static const char *const shape_name[] = {"box", "skewed", "distorted", "rational"};

static void make(const struct solid_case *c, enum shape shape, const int gauss[3],
                 struct solid *s)
{
    const struct law law = law_isotropic(young, nu, 1);
    struct solid_material material = solid_element_material(&law, 1);
    struct patch patch = {0};
    uint64_t state = 7;

    solid_box(c, &patch);
    if (shape != BOX)
        solid_skew(&patch);
    if (shape == DISTORTED || shape == RATIONAL)
        solid_shake(&patch, c->size, 0.4, &state);
    if (shape == RATIONAL) {
        patch.weight = malloc((size_t)patch_nodes(&patch) * sizeof *patch.weight);
        REQUIRE(patch.weight);
        for (int a = 0; a < patch_nodes(&patch); a++)
            patch.weight[a] = 0.8 + 0.4 * random_unit(&state);
    }
    solid_make(s, c->kind, &patch, gauss, false, &material);
}

static bool bends(const struct solid_case *c, enum shape shape)
{
    bool flat = c->degree[0] > 1 && c->degree[1] > 1;

    if (shape == BOX)
        return c->kind == SOLID_INCOMPATIBLE || (flat && (c->degree[2] > 1 || nu == 0));
    return flat && c->degree[2] > 1;
}

/* The quadratic fields, on a net where parameters are affine. */
static void check_affine(const struct solid_case *c, enum shape shape)
{
    const int gauss[3] = {c->degree[0] + 1, c->degree[1] + 1, c->degree[2] + 1};
    bool quadratic = c->degree[0] > 1 && c->degree[1] > 1 && c->degree[2] > 1;
    struct solid s;

    make(c, shape, gauss, &s);
    check_field(&s, &constant_strain, gauss, true, true, shape_name[shape]);
    check_field(&s, &pure_twist, gauss, shape == BOX || quadratic, true, shape_name[shape]);
    check_field(&s, &pure_bending, gauss, bends(c, shape), true, shape_name[shape]);
    solid_clear(&s);
}

/* Constant strain on a net of any shape. The forces inside vanish only if the cofactors of
 * the map times a gradient, of degree 3 p - 1, are integrated: p + 1 points do so up to
 * p = 2. Rational maps are never integrated exactly; RATIONAL_GAUSS reaches round-off. */
enum { RATIONAL_GAUSS = 16 };

static void check_distorted(const struct solid_case *c, enum shape shape)
{
    int gauss[3], more[3];
    struct solid s;

    for (int i = 0; i < 3; i++) {
        gauss[i] = c->degree[i] + 1;
        more[i] = shape == RATIONAL ? RATIONAL_GAUSS : 3 * c->degree[i] / 2 + 1;
    }
    make(c, shape, gauss, &s);
    check_field(&s, &constant_strain, gauss, true, false, shape_name[shape]);
    solid_clear(&s);
    make(c, shape, more, &s);
    check_field(&s, &constant_strain, c->kind == SOLID_IGA ? more : gauss, true, true,
                shape_name[shape]);
    solid_clear(&s);
}

static void check_case(const struct solid_case *c)
{
    static const double poissons[] = {0, 0.3, 0.45};

    for (size_t n = 0; n < sizeof poissons / sizeof *poissons; n++) {
        nu = poissons[n];
        check_affine(c, BOX);
        check_affine(c, SKEWED);
    }
    nu = 0.3;
    check_distorted(c, DISTORTED);
    if (c->kind == SOLID_IGA)
        check_distorted(c, RATIONAL);
}

/* clang-format off */
static const struct solid_case iga[] = { /* one span through w, or several */
    {SOLID_IGA, {1, 1, 1}, {4, 4, 2}, {1, 0.8, 0.1}},
    {SOLID_IGA, {1, 1, 1}, {4, 5, 3}, {1, 0.8, 0.1}},
    {SOLID_IGA, {2, 2, 1}, {5, 4, 2}, {1, 0.8, 0.1}},
    {SOLID_IGA, {3, 2, 1}, {5, 4, 3}, {1, 0.8, 0.1}},
    {SOLID_IGA, {1, 2, 2}, {4, 4, 3}, {1, 0.8, 0.1}},
    {SOLID_IGA, {2, 2, 2}, {5, 4, 3}, {1, 0.8, 0.1}},
    {SOLID_IGA, {2, 3, 2}, {4, 5, 4}, {1, 0.8, 0.1}},
    {SOLID_IGA, {3, 3, 3}, {6, 5, 4}, {1, 0.8, 0.1}},
    {SOLID_IGA, {4, 4, 2}, {6, 7, 3}, {1, 0.8, 0.1}},
    {SOLID_IGA, {4, 4, 4}, {6, 6, 5}, {1, 0.8, 0.1}},
};
static const struct solid_case hexahedra[] = {
    {SOLID_HEX, {1, 1, 1}, {5, 6, 2}, {1, 0.8, 0.1}},
    {SOLID_HEX, {1, 1, 1}, {4, 5, 4}, {1, 0.8, 0.1}},
};
/* clang-format on */

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    enum solid_kind kind = solid_kind(argv[1]);

    for (size_t n = 0; kind == SOLID_IGA && n < sizeof iga / sizeof *iga; n++)
        check_case(&iga[n]);
    for (size_t n = 0; kind != SOLID_IGA && n < sizeof hexahedra / sizeof *hexahedra; n++) {
        struct solid_case c = hexahedra[n];
        c.kind = kind;
        check_case(&c);
    }
    return check_result();
}
