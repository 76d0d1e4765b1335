/* remedy=selective leaves no motion without energy, whatever the sheet has become: of the
 * strain energy's stiffness at rest, bent, compressed, and twisted, six eigenvalues are
 * those of rigid motions, and the next is the stiffness of a bend. Shells and solids of
 * degrees 2 to 5, on one to five spans a side. At rest no motion in the plane is much
 * softer than without the cure, on up to nine spans.
 *
 * A cured membrane alone can't have so many: it has one point a function, so that at bent
 * states what satisfies it are the functions of the net's two borders. Bending has to hold
 * them, and with too few points did not.
 */
#include <float.h>

#include "models/solid/solid_green.h"
#include "tests/shell_fixture.h"
#include "tests/solid_fixture.h"

static const struct large_path statics = {.s1 = 1, .g1 = 1};
static const double LENGTH = 1, WIDTH = 0.8, THICKNESS = 0.01;

/* Eigenvalues of round-off, in parts of the largest: n eps, n < 600. */
static const double ZERO = 600 * DBL_EPSILON;
/* So much is left, at any of these states, of the lowest frequency squared of the free
 * plate on the same net uncured. Measured .75 and more of solids, .9 of shells; of a shape
 * that is not seen it is nothing. */
static const double LEAST = 0.5;

/* So much is left, at rest, of each frequency squared of motions in the plane, by degree.
 * Measured: shells .75, .81, .75, .65; solids .95, .73, .30, .20. */
static const double SHELL_IN_PLANE[] = {[2] = 0.7, [3] = 0.7, [4] = 0.7, [5] = 0.6};
static const double SOLID_IN_PLANE[] = {[2] = 0.9, [3] = 0.7, [4] = 0.25, [5] = 0.15};

enum state { REST, BENT, COMPRESSED, TWISTED, STATES };
static const char *const state_name[STATES] = {"at rest", "bent", "compressed", "twisted"};

/* Where the material point (s, t) [m] of the mid-surface is, and the normal there. */
static void surface(enum state state, double s, double t, double x[3], double n[3])
{
    const double radius = 1, twist = 0.8;

    x[0] = s, x[1] = t, x[2] = 0;
    n[0] = n[1] = 0, n[2] = 1;
    if (state == BENT) {
        x[0] = radius * sin(s / radius), x[2] = radius * (1 - cos(s / radius));
        n[0] = -sin(s / radius), n[2] = cos(s / radius);
    } else if (state == COMPRESSED) {
        x[0] *= 0.99, x[1] *= 0.99;
    } else if (state == TWISTED) {
        const double size = sqrt(1 + twist * twist * (s * s + t * t));
        x[2] = twist * s * t;
        n[0] = -twist * t / size, n[1] = -twist * s / size, n[2] = 1 / size;
    }
}

/* K v = omega^2 M v: the lowest elastic omega^2; the six below it are rigid. */
static double lowest(const struct large_body *body, const struct blocks *graph,
                     const double *M, const double *x, double *rigid)
{
    const size_t n = 3 * (size_t)graph->nodes;
    double *a = calloc(2 * n * n + n, sizeof *a), *b = a + n * n, *lambda = b + n * n;
    double(*K)[9] = malloc((size_t)graph->start[graph->nodes] * sizeof *K);

    REQUIRE(a && K);
    CHECK(large_body_tangent(body, &statics, x, (struct large_foresight){.none = true},
                             K) == STATUS_OK);
    for (int i = 0; i < graph->nodes; i++)
        for (long t = graph->start[i]; t < graph->start[i + 1]; t++)
            for (size_t k = 0; k < 9; k++) { /* upper triangle by rows */
                const size_t at =
                    (3 * (size_t)i + k / 3) * n + 3 * (size_t)graph->node[t] + k % 3;
                a[at] = K[t][k];
                b[at] = k % 4 ? 0 : M[t];
            }
    REQUIRE(!LAPACKE_dsygvd(LAPACK_ROW_MAJOR, 1, 'N', 'U', (int)n, a, (int)n, b, (int)n,
                            lambda));
    *rigid = 0;
    for (int k = 0; k < 6; k++)
        *rigid = fmax(*rigid, fabs(lambda[k]) / lambda[n - 1]);
    const double found = lambda[6];
    free(a);
    free(K);
    return found;
}

/* The same of the sheet at rest moved in its plane alone, all layers alike: all omega^2,
 * lambda[2 nodes / layers]. */
static void in_plane(const struct large_body *body, const struct blocks *graph,
                     const double *M, int layers, const double *x, double *lambda)
{
    const size_t n = 2 * (size_t)(graph->nodes / layers);
    double *a = calloc(2 * n * n, sizeof *a), *b = a + n * n;
    double(*K)[9] = malloc((size_t)graph->start[graph->nodes] * sizeof *K);

    REQUIRE(a && K);
    CHECK(large_body_tangent(body, &statics, x, (struct large_foresight){.none = true},
                             K) == STATUS_OK);
    for (int i = 0; i < graph->nodes; i++)
        for (long t = graph->start[i]; t < graph->start[i + 1]; t++)
            for (size_t k = 0; k < 4; k++) {
                const size_t from = 2 * (size_t)(i / layers) + k / 2,
                             to = 2 * (size_t)(graph->node[t] / layers) + k % 2;
                const double mass = k % 3 ? 0 : M[t], *block = K[t];
                a[from * n + to] += block[k / 2 * 3 + k % 2], b[from * n + to] += mass;
                if (graph->node[t] == i)
                    continue;
                a[to * n + from] += block[k / 2 * 3 + k % 2], b[to * n + from] += mass;
            }
    REQUIRE(!LAPACKE_dsygvd(LAPACK_ROW_MAJOR, 1, 'N', 'U', (int)n, a, (int)n, b, (int)n,
                            lambda));
    free(a);
    free(K);
}

/* x[nodes] of a shell (layers 1) or of a solid of two layers. */
static void place(enum state state, const struct bspline *u, const struct bspline *v,
                  int layers, double *x)
{
    for (int a = 0; a < u->n * v->n * layers; a++) {
        const double s = LENGTH * bspline_greville(u, a / layers / v->n);
        const double t = WIDTH * bspline_greville(v, a / layers % v->n);
        const double w = layers == 2 ? (a % 2 - 0.5) * THICKNESS : 0;
        double n[3];
        surface(state, s, t, x + 3 * a, n);
        for (int i = 0; i < 3; i++)
            x[3 * a + i] += w * n[i];
    }
}

/* All states against `bend`; returns the lowest at rest. */
static void check(const char *what, const int degree, const int spans[2], double bend,
                  const double found[STATES], const double rigid[STATES])
{
    for (int k = 0; k < STATES; k++) {
        bool good = CHECK_NEAR(rigid[k], 0, ZERO);
        good &= CHECK(found[k] > LEAST * bend);
        if (!good)
            printf("%s, degree %d, %d x %d spans, %s: rigid %.1e, lowest %.3g of a bend\n",
                   what, degree, spans[0], spans[1], state_name[k], rigid[k],
                   found[k] / bend);
    }
}

static void find_shell(int p, const int spans[2], bool selective, double found[STATES],
                       double rigid[STATES])
{
    const struct shell_material material = {
        .young = 3, .poisson = 0.3, .density = 2, .thickness = THICKNESS};
    struct bspline basis[2];
    struct shell_space space = {0};
    struct shell_assembly s = {0};
    double x[3 * 100];

    shell_bases(basis, p, p + spans[0], p, p + spans[1]);
    place(REST, &basis[0], &basis[1], 1, x);
    REQUIRE(shell_space_init(&space, basis, x, NULL, (int[]){0, 0}, selective, NULL) ==
            STATUS_OK);
    REQUIRE(shell_assembly_init(&s, &space, &material, NULL) == STATUS_OK);
    for (enum state k = REST; k < STATES; k++) {
        place(k, &basis[0], &basis[1], 1, x);
        found[k] = lowest(&s.body, &s.graph, s.M, x, &rigid[k]);
    }
    shell_assembly_clear(&s);
    shell_space_clear(&space);
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
}

static void find_solid(int p, const int spans[2], double found[STATES],
                       double rigid[STATES])
{
    const struct solid_material material = solid_element_material(3, 0.3, 2);
    const struct solid_case box = {SOLID_SELECTIVE,
                                   {p, p, 1},
                                   {p + spans[0], p + spans[1], 2},
                                   {LENGTH, WIDTH, THICKNESS}};
    struct patch patch;
    struct solid s;
    struct solid_green g = {0};
    double x[3 * 200];

    solid_box(&box, &patch);
    solid_make(&s, box.kind, &patch, (int[]){0, 0, 0}, false, &material);
    REQUIRE(solid_green_init(&g, &s.assembly) == STATUS_OK);
    for (enum state k = REST; k < STATES; k++) {
        place(k, &s.patch.basis[0], &s.patch.basis[1], 2, x);
        found[k] = lowest(&g.body, &s.assembly.graph, s.assembly.M, x, &rigid[k]);
    }
    solid_green_clear(&g);
    solid_clear(&s);
}

static void shell_in_plane(const struct bspline basis[2], bool cured, const double *x,
                           double *lambda)
{
    const struct shell_material material = {
        .young = 3, .poisson = 0.3, .density = 2, .thickness = THICKNESS};
    struct shell_space space = {0};
    struct shell_assembly s = {0};

    REQUIRE(shell_space_init(&space, basis, x, NULL, (int[]){0, 0}, cured, NULL) ==
            STATUS_OK);
    REQUIRE(shell_assembly_init(&s, &space, &material, NULL) == STATUS_OK);
    in_plane(&s.body, &s.graph, s.M, 1, x, lambda);
    shell_assembly_clear(&s);
    shell_space_clear(&space);
}

static void solid_in_plane(int p, int n, int m, const double *x, double *lambda)
{
    const struct solid_material material = solid_element_material(3, 0.3, 2);
    const struct solid_case box = {
        SOLID_SELECTIVE, {p, p, 1}, {p + n, p + m, 2}, {LENGTH, WIDTH, THICKNESS}};
    struct patch patch;
    struct solid s;
    struct solid_green g = {0};

    solid_box(&box, &patch);
    solid_make(&s, box.kind, &patch, (int[]){0, 0, 0}, false, &material);
    REQUIRE(solid_green_init(&g, &s.assembly) == STATUS_OK);
    in_plane(&g.body, &s.assembly.graph, s.assembly.M, 2, x, lambda);
    solid_green_clear(&g);
    solid_clear(&s);
}

/* Motions in the plane: each omega^2 against that of the net uncured. */
static void check_in_plane(int p, int n, int m)
{
    enum { RIGID = 3 };
    const size_t count = 2 * (size_t)((p + n) * (p + m));
    double *lambda = malloc(3 * count * sizeof *lambda), least[2] = {INFINITY, INFINITY};
    struct bspline basis[2];
    double x[3 * 800];

    REQUIRE(lambda);
    shell_bases(basis, p, p + n, p, p + m);
    place(REST, &basis[0], &basis[1], 1, x);
    for (int cured = 0; cured < 2; cured++)
        shell_in_plane(basis, cured, x, lambda + (size_t)cured * count);
    place(REST, &basis[0], &basis[1], 2, x);
    solid_in_plane(p, n, m, x, lambda + 2 * count);
    for (int k = 0; k < 2; k++)
        for (size_t t = RIGID; t < count; t++)
            least[k] = fmin(least[k], lambda[(size_t)(k + 1) * count + t] / lambda[t]);
    bool good = CHECK(least[0] > SHELL_IN_PLANE[p]);
    good &= CHECK(least[1] > SOLID_IN_PLANE[p]);
    if (!good)
        printf("degree %d, %d x %d spans, in the plane: shell %.3g, solid %.3g\n", p, n, m,
               least[0], least[1]);
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
    free(lambda);
}

int main(void)
{
    for (int p = 2; p <= 5; p++)
        for (int n = 1; n <= 9; n += 2)
            for (int m = 1; m <= n; m += 4)
                check_in_plane(p, n, m);
    for (int p = 2; p <= 5; p++)
        for (int n = 1; n <= 5; n++)
            for (int m = 1; m <= n; m++) {
                double uncured[STATES], found[STATES], rigid[STATES];
                find_shell(p, (int[]){n, m}, false, uncured, rigid);
                find_shell(p, (int[]){n, m}, true, found, rigid);
                check("shell", p, (int[]){n, m}, uncured[REST], found, rigid);
                if (n == m || m == 1) {
                    find_solid(p, (int[]){n, m}, found, rigid);
                    check("solid", p, (int[]){n, m}, uncured[REST], found, rigid);
                }
            }
    return check_result();
}
