/* K and M of boxes against products of matrices of one variable (verify_box.h), code they
 * do not share, in both bases through the thickness.
 *
 *   kronecker iga|hex
 */
#include "bench/verify/verify_box.h"
#include "tests/solid_fixture.h"

/* Of the largest entry. Each entry is a sum over up to 5^3 spans of 5^3 points of a dozen
 * roundings each, random in sign: 1e-14; no cancellation on a box beyond that of lambda and
 * mu terms. */
static const double TOL_KRONECKER = 1e-13;

/* T[l][l]: control points of the Legendre polynomials P_k(2 w - 1), column k, k <= 4;
 * Bernstein coefficients (Farouki 2000) for one span of degree k, raised to degree l - 1.
 */
static void legendre_points(int l, double *T)
{
    static const double bernstein[5][5] = {
        {1}, {-1, 1}, {1, -2, 1}, {-1, 3, -3, 1}, {1, -4, 6, -4, 1}};

    for (int k = 0; k < l; k++) {
        double c[6];
        memcpy(c, bernstein[k], sizeof bernstein[k]);
        for (int p = k + 1; p < l; p++) { /* degree elevation */
            c[p] = c[p - 1];
            for (int i = p - 1; i > 0; i--)
                c[i] = (i * c[i - 1] + (p - i) * c[i]) / p;
        }
        for (int i = 0; i < l; i++)
            T[i * l + k] = c[i];
    }
}

/* A <- T^T A T by columns of l nodes with `parts` components each; A [n][n]. */
static void to_thickness(int n, int l, int parts, double *A)
{
    double T[25], *row = malloc((size_t)n * sizeof *row);

    REQUIRE(row && l <= 5);
    legendre_points(l, T);
    for (int side = 0; side < 2; side++) {
        for (int r = 0; r < n; r++) {
            double *x = A + (size_t)r * (size_t)n;
            for (int c = 0; c < n; c++) {
                int k = c / parts % l, first = c - k * parts;
                row[c] = 0;
                for (int i = 0; i < l; i++)
                    row[c] += x[first + i * parts] * T[i * l + k];
            }
            memcpy(x, row, (size_t)n * sizeof *row);
        }
        for (int r = 0; r < n; r++) /* A T is done; transpose, and once more */
            for (int c = 0; c < r; c++) {
                double swap = A[r * n + c];
                A[r * n + c] = A[c * n + r], A[c * n + r] = swap;
            }
    }
    free(row);
}

static double largest_difference(int n, const double *A, const double *B)
{
    double worst = 0, most = 0;

    for (int t = 0; t < n * n; t++) {
        worst = fmax(worst, fabs(A[t] - B[t]));
        most = fmax(most, fabs(B[t]));
    }
    return worst / most;
}

/* The model's M as [nodes][nodes]. */
static double *dense_mass(const struct solid *s)
{
    const struct blocks *g = &s->assembly.graph;
    double *full = calloc((size_t)(g->nodes * g->nodes), sizeof *full);

    REQUIRE(full);
    for (int a = 0; a < g->nodes; a++)
        for (long t = g->start[a]; t < g->start[a + 1]; t++)
            full[a * g->nodes + g->node[t]] = full[g->node[t] * g->nodes + a] =
                s->assembly.M[t];
    return full;
}

static void check_matrices(enum solid_kind kind, const struct bspline basis[3],
                           bool thickness)
{
    static const double origin[3] = {0.3, -0.4, 0.1};
    static const double edge[3][3] = {{1.1, 0, 0}, {0, 0.7, 0}, {0, 0, 0.05}};
    struct solid_material material = solid_element_material(3.0, 0.3, 1.7);
    struct patch patch = {0};
    struct solid s;

    REQUIRE(patch_init(&patch, basis) == STATUS_OK);
    patch_set_box(&patch, origin, edge[0], edge[1], edge[2]);
    solid_make(&s, kind, &patch, (const int[3]){0}, thickness, &material);
    int nodes = s.space.nodes, n = 3 * nodes, l = basis[2].n;
    double *K = solid_dense(&s.assembly.graph, s.assembly.K), *M = dense_mass(&s);
    double *want_K = malloc((size_t)(n * n) * sizeof *K);
    double *want_M = malloc((size_t)(nodes * nodes) * sizeof *M);
    REQUIRE(want_K && want_M);
    const struct verify_box box = {.basis = {&basis[0], &basis[1], &basis[2]},
                                   .size = {edge[0][0], edge[1][1], edge[2][2]},
                                   .lambda = material.lambda,
                                   .mu = material.mu,
                                   .density = material.density};
    REQUIRE(verify_box_matrices(&box, want_K, want_M) == STATUS_OK);
    if (thickness) {
        to_thickness(n, l, 3, want_K);
        to_thickness(nodes, l, 1, want_M);
    }
    bool good = CHECK_NEAR(largest_difference(n, K, want_K), 0, TOL_KRONECKER);
    if (!(CHECK_NEAR(largest_difference(nodes, M, want_M), 0, TOL_KRONECKER) && good))
        printf("  degrees %d %d %d, %d %d %d functions, thickness unknowns: %d\n",
               basis[0].p, basis[1].p, basis[2].p, basis[0].n, basis[1].n, l, thickness);
    free(K);
    free(M);
    free(want_K);
    free(want_M);
    solid_clear(&s);
}

static void check_uniform(enum solid_kind kind, const int p[3], const int n[3])
{
    struct bspline basis[3];

    for (int d = 0; d < 3; d++)
        REQUIRE(bspline_init_uniform(&basis[d], p[d], n[d], NULL) == STATUS_OK);
    check_matrices(kind, basis, false);
    if (n[2] == p[2] + 1)
        check_matrices(kind, basis, true);
    for (int d = 0; d < 3; d++)
        bspline_clear(&basis[d]);
}

/* Uneven and repeated knots, down to C^0. */
static void check_random_knots(void)
{
    uint64_t state = 11;

    for (int round = 0; round < 12; round++) {
        struct bspline basis[3];
        for (int d = 0; d < 3; d++)
            random_bspline(&state, random_int(&state, 1, d < 2 ? 3 : 2), &basis[d]);
        check_matrices(SOLID_IGA, basis, false);
        for (int d = 0; d < 3; d++)
            bspline_clear(&basis[d]);
    }
}

int main(int argc, char **argv)
{
    static const int mixed[][2][3] = {{{2, 2, 1}, {5, 6, 2}}, {{3, 3, 2}, {5, 4, 3}},
                                      {{4, 2, 3}, {6, 4, 4}}, {{1, 4, 2}, {4, 6, 4}},
                                      {{2, 1, 4}, {4, 3, 5}}, {{1, 1, 3}, {3, 4, 4}}};
    REQUIRE(argc == 2);
    enum solid_kind kind = solid_kind(argv[1]);

    if (kind == SOLID_HEX) {
        check_uniform(kind, (int[]){1, 1, 1}, (int[]){6, 5, 2});
        check_uniform(kind, (int[]){1, 1, 1}, (int[]){4, 5, 4});
        return check_result();
    }
    for (int p = 1; p <= 4; p++)
        check_uniform(kind, (int[]){p, p, p}, (int[]){p + 2, p + 3, p + 1});
    for (size_t n = 0; n < sizeof mixed / sizeof *mixed; n++)
        check_uniform(kind, mixed[n][0], mixed[n][1]);
    check_random_knots();
    return check_result();
}
