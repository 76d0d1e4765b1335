/* On a box every integral in K and M is a product of three integrals of one variable:
 *   int N_a,i N_b,j dV = A_0 A_1 A_2, with A_d the mass matrix of direction d, its
 * stiffness (d = i = j), or int N_a' N_b (d = i) and its transpose (d = j). The matrices
 * here are made from bspline_eval alone, so that K and M are checked by code they do not
 * share.
 *
 *   kronecker iga|hex
 */
#include "models/linalg/gauss.h"
#include "tests/solid_fixture.h"

/* Of the largest entry. Each entry is a sum over up to 5^3 spans of 5^3 points of a dozen
 * roundings each, random in sign: 1e-14; no cancellation on a box beyond that of lambda and
 * mu terms. */
static const double TOL_KRONECKER = 1e-13;

/* mass, int N_a' N_b, stiffness of one direction, [n][n] each, functions of length `size`.
 */
struct line {
    int n;
    double *mass, *mixed, *stiffness;
};

static void line_init(struct line *line, const struct bspline *b, double size)
{
    int span[64], spans = bspline_spans(b, span), n = b->n, gauss = b->p + 3;
    double x[GAUSS_MAX], w[GAUSS_MAX], N[2][BSPLINE_MAX_ORDER];

    line->n = n;
    line->mass = calloc(3 * (size_t)(n * n), sizeof(double));
    REQUIRE(line->mass);
    line->mixed = line->mass + n * n;
    line->stiffness = line->mixed + n * n;
    gauss_rule(gauss, x, w);
    for (int e = 0; e < spans * gauss; e++) {
        int k = span[e / gauss], q = e % gauss;
        double edge = b->U[k + 1] - b->U[k], weight = edge * w[q];
        double value[2 * BSPLINE_MAX_ORDER];
        bspline_eval(b, k, b->U[k] + edge * x[q], 1, value);
        for (int a = 0; a <= b->p; a++)
            N[0][a] = value[a], N[1][a] = value[b->p + 1 + a];
        for (int a = 0; a <= b->p; a++)
            for (int c = 0; c <= b->p; c++) {
                int at = (k - b->p + a) * n + k - b->p + c;
                line->mass[at] += weight * size * N[0][a] * N[0][c];
                line->mixed[at] += weight * N[1][a] * N[0][c];
                line->stiffness[at] += weight / size * N[1][a] * N[1][c];
            }
    }
}

/* int N_a,i N_b,j dV; i = j = 3: int N_a N_b dV. */
static double product(const struct line line[3], const int a[3], const int b[3], int i,
                      int j)
{
    double value = 1;

    for (int d = 0; d < 3; d++) {
        const struct line *l = &line[d];
        value *= d == i && d == j ? l->stiffness[a[d] * l->n + b[d]]
                 : d == i         ? l->mixed[a[d] * l->n + b[d]]
                 : d == j         ? l->mixed[b[d] * l->n + a[d]]
                                  : l->mass[a[d] * l->n + b[d]];
    }
    return value;
}

static double stiffness_entry(const struct line line[3], const struct solid_material *m,
                              const int a[3], const int b[3], int i, int j)
{
    double value =
        m->lambda * product(line, a, b, i, j) + m->mu * product(line, a, b, j, i);

    for (int k = 0; i == j && k < 3; k++)
        value += m->mu * product(line, a, b, k, k);
    return value;
}

static void split(const struct patch *patch, int node, int at[3])
{
    int m = patch->basis[1].n, l = patch->basis[2].n;

    at[0] = node / (m * l), at[1] = node / l % m, at[2] = node % l;
}

/* All of K [3 nodes][3 nodes] and M [nodes][nodes] by products. */
static void kronecker(const struct patch *patch, const double size[3],
                      const struct solid_material *m, double *K, double *M)
{
    int nodes = patch_nodes(patch), at[3], bt[3];
    struct line line[3];

    for (int d = 0; d < 3; d++)
        line_init(&line[d], &patch->basis[d], size[d]);
    for (int a = 0; a < nodes; a++)
        for (int b = 0; b < nodes; b++) {
            split(patch, a, at);
            split(patch, b, bt);
            M[a * nodes + b] = m->density * product(line, at, bt, 3, 3);
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    K[(3 * a + i) * 3 * nodes + 3 * b + j] =
                        stiffness_entry(line, m, at, bt, i, j);
        }
    for (int d = 0; d < 3; d++)
        free(line[d].mass);
}

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
    static const double origin[3] = {0.3, -0.4, 0.1}, size[3] = {1.1, 0.7, 0.05};
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
    kronecker(&s.patch, size, &material, want_K, want_M);
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
