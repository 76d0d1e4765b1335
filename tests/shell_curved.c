/* Curved rest shapes by rational splines, linear statics: the Scordelis-Lo roof (vertical
 * deflection 0.3006 at the middle of the free edge) and the pinched hemisphere (0.0924
 * under each of four alternating radial loads); Belytschko et al., CMAME 51 (1985) 221-258.
 */
#include "models/mechanics/system.h"
#include "tests/shell_fixture.h"

/* Asked: 1 %. Both references are given to three or four digits. */
static const double OBSTACLE_COURSE = 0.01;

static const double PI = 3.14159265358979323846;

/* A conic arc of `angle` < pi in the plane of a and b (orthonormal) as one rational
 * quadratic, raised to degree p and refined to n functions: homogeneous control values by
 * interpolation at Greville abscissae, exact since the arc lies in the space. */
struct arc {
    int n;
    struct bspline basis;
    double point[64][2], weight[64];
};

/* Solves the dense system A X = B (n x n, n x 3) in place by elimination with pivots. */
static void eliminate(int n, double A[64][64], double B[64][3])
{
    for (int k = 0; k < n; k++) {
        int top = k;
        for (int i = k; i < n; i++)
            if (fabs(A[i][k]) > fabs(A[top][k]))
                top = i;
        for (int j = 0; j < n; j++) {
            double t = A[k][j];
            A[k][j] = A[top][j], A[top][j] = t;
        }
        for (int j = 0; j < 3; j++) {
            double t = B[k][j];
            B[k][j] = B[top][j], B[top][j] = t;
        }
        for (int i = 0; i < n; i++) {
            if (i == k)
                continue;
            double f = A[i][k] / A[k][k];
            for (int j = k; j < n; j++)
                A[i][j] -= f * A[k][j];
            for (int j = 0; j < 3; j++)
                B[i][j] -= f * B[k][j];
        }
    }
    for (int k = 0; k < n; k++)
        for (int j = 0; j < 3; j++)
            B[k][j] /= A[k][k];
}

/* The unit arc from angle `from` to `from + angle`: point = (cos, sin). */
static void arc_init(struct arc *a, int p, int n, double from, double angle)
{
    static double A[64][64];
    double H[64][3], w = cos(angle / 2), N[BSPLINE_MAX_ORDER];
    struct message why;

    REQUIRE(n <= 64 && bspline_init_uniform(&a->basis, p, n, &why) == STATUS_OK);
    a->n = n;
    memset(A, 0, sizeof A);
    for (int i = 0; i < n; i++) {
        double t = bspline_greville(&a->basis, i);
        double b[3] = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
        int span = bspline_span(&a->basis, t);
        bspline_eval(&a->basis, span, t, 0, N);
        for (int k = 0; k <= p; k++)
            A[i][span - p + k] = N[k];
        H[i][0] =
            b[0] * cos(from) + b[1] * cos(from + angle / 2) + b[2] * cos(from + angle);
        H[i][1] =
            b[0] * sin(from) + b[1] * sin(from + angle / 2) + b[2] * sin(from + angle);
        H[i][2] = b[0] + b[1] * w + b[2];
    }
    eliminate(n, A, H);
    for (int i = 0; i < n; i++) {
        a->point[i][0] = H[i][0] / H[i][2];
        a->point[i][1] = H[i][1] / H[i][2];
        a->weight[i] = H[i][2];
    }
}

struct problem {
    struct shell_space space;
    struct shell_assembly s;
    struct supports held;
    double (*K)[9], *load;
};

static void problem_init(struct problem *p, const struct bspline basis[2],
                         const double *point, const double *weight,
                         const struct shell_material *material)
{
    const struct large_path statics = {.s1 = 1, .g1 = 1};
    const int gauss[2] = {0, 0};
    struct message why = {{0}};

    memset(p, 0, sizeof *p);
    if (!CHECK(shell_space_init(&p->space, basis, point, weight, gauss, &why) ==
               STATUS_OK) ||
        !CHECK(shell_assembly_init(&p->s, &p->space, material, &why) == STATUS_OK))
        printf("%s\n", why.text);
    p->K = malloc((size_t)p->s.graph.start[p->space.nodes] * sizeof *p->K);
    p->load = calloc(3 * (size_t)p->space.nodes, sizeof *p->load);
    p->held.nodes = p->space.nodes;
    p->held.free_index = calloc(3 * (size_t)p->space.nodes, sizeof(int));
    REQUIRE(p->K && p->load && p->held.free_index);
    CHECK(large_body_tangent(&p->s.body, &statics, p->space.rest,
                             (struct large_foresight){0}, p->K) == STATUS_OK);
}

static int node_of(const struct problem *p, int i, int j)
{
    return i * p->space.basis[1].n + j;
}

static void hold(struct problem *p, int node, int component)
{
    p->held.free_index[3 * node + component] = -1;
}

/* Component of two nodes made equal by a spring far stiffer than the shell. */
static void tie(struct problem *p, int a, int b, int component, double stiffness)
{
    int low = a < b ? a : b, high = a < b ? b : a, t = 4 * component;

    p->K[blocks_find(&p->s.graph, a, a)][t] += stiffness;
    p->K[blocks_find(&p->s.graph, b, b)][t] += stiffness;
    p->K[blocks_find(&p->s.graph, low, high)][t] -= stiffness;
}

/* load becomes the displacement. */
static void solve(struct problem *p)
{
    struct system system = {0};

    for (int t = 0; t < 3 * p->space.nodes; t++)
        if (p->held.free_index[t] == 0)
            p->held.free_index[t] = p->held.free_count++;
    REQUIRE(system_init(&system, &p->s.graph, &p->held, NULL, NULL, NULL) == STATUS_OK);
    CHECK(system_factor(&system, 1, (const double(*)[9])p->K, 0, NULL) == STATUS_OK);
    CHECK(system_solve(&system, p->load) == STATUS_OK);
    system_clear(&system);
}

static void problem_clear(struct problem *p)
{
    shell_assembly_clear(&p->s);
    shell_space_clear(&p->space);
    supports_clear(&p->held);
    free(p->K);
    free(p->load);
}

static double displacement(const struct problem *p, double u, double v, int component)
{
    double T[SHELL_DERIVATIVES * SHELL_MAX_LOCAL], sum = 0;
    int node[SHELL_MAX_LOCAL];

    shell_space_at(&p->space, u, v, node, T);
    for (int a = 0; a < p->space.local; a++)
        sum += T[a] * p->load[3 * node[a] + component];
    return sum;
}

/* R = 25, L = 50, h = 0.25, E = 4.32e8, nu = 0, 90 per area; 80 degrees of arc along u, the
 * axis y along v; diaphragms at both ends hold x and z. The whole roof, one corner held
 * along y. */
static double roof(int degree, int n)
{
    const struct shell_material material = {
        .young = 4.32e8, .poisson = 0, .density = 1, .thickness = 0.25};
    const double R = 25, L = 50, load = 90;
    struct problem p;
    struct arc arc;
    struct bspline basis[2];
    double *point = malloc(3 * (size_t)(n * n) * sizeof *point);
    double *weight = malloc((size_t)(n * n) * sizeof *weight);

    REQUIRE(point && weight);
    arc_init(&arc, degree, n, PI / 2 + 40 * PI / 180, -80 * PI / 180);
    basis[0] = arc.basis;
    REQUIRE(bspline_copy(&arc.basis, &basis[1]) == STATUS_OK);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double *x = point + 3 * (i * n + j);
            x[0] = R * arc.point[i][0];
            x[1] = L * bspline_greville(&basis[1], j);
            x[2] = R * arc.point[i][1];
            weight[i * n + j] = arc.weight[i];
        }
    problem_init(&p, basis, point, weight, &material);
    for (int i = 0; i < n; i++)
        for (int end = 0; end < 2; end++) {
            hold(&p, node_of(&p, i, end * (n - 1)), 0);
            hold(&p, node_of(&p, i, end * (n - 1)), 2);
        }
    hold(&p, node_of(&p, 0, 0), 1);
    for (int a = 0; a < p.space.nodes; a++)
        p.load[3 * a + 2] = -load * p.s.area[a];
    solve(&p);
    double answer = -displacement(&p, 0, 0.5, 2);
    problem_clear(&p);
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
    free(point);
    free(weight);
    return answer;
}

/* R = 10, h = 0.04, E = 6.825e7, nu = 0.3, loads of 2 (1 on the quarter's edge). A quarter:
 * u along the equator from x to y, v from the equator to the pole, where a row of points
 * falls together. On the planes y = 0 and x = 0 nothing moves across, and slopes across
 * stay: the second row follows the first one (tie). */
static double hemisphere(int degree, int n)
{
    const struct shell_material material = {
        .young = 6.825e7, .poisson = 0.3, .density = 1, .thickness = 0.04};
    const double R = 10;
    struct problem p;
    struct arc equator, meridian;
    struct bspline basis[2];
    double *point = malloc(3 * (size_t)(n * n) * sizeof *point);
    double *weight = malloc((size_t)(n * n) * sizeof *weight);

    REQUIRE(point && weight);
    arc_init(&equator, degree, n, 0, PI / 2);
    arc_init(&meridian, degree, n, 0, PI / 2);
    basis[0] = equator.basis;
    basis[1] = meridian.basis;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double *x = point + 3 * (i * n + j), r = R * meridian.point[j][0];
            x[0] = r * equator.point[i][0];
            x[1] = r * equator.point[i][1];
            x[2] = R * meridian.point[j][1];
            weight[i * n + j] = equator.weight[i] * meridian.weight[j];
        }
    problem_init(&p, basis, point, weight, &material);
    double stiff = 1e3 * material.young * material.thickness;
    for (int side = 0; side < 2; side++) /* i = 0: y = 0; i = n - 1: x = 0 */
        for (int j = 0; j < n; j++) {
            int edge = node_of(&p, side * (n - 1), j);
            int inner = node_of(&p, side ? n - 2 : 1, j), across = side ? 0 : 1;
            hold(&p, edge, across);
            for (int k = 0; k < 3 && j < n - 1; k++)
                if (k != across)
                    tie(&p, edge, inner, k, stiff);
        }
    for (int i = 0; i < n; i++) { /* the pole stays on its axis; and its slope, level */
        int pole = node_of(&p, i, n - 1);
        hold(&p, pole, 0);
        hold(&p, pole, 1);
        tie(&p, pole, node_of(&p, i, n - 2), 2, stiff);
        if (i > 0)
            tie(&p, pole, node_of(&p, i - 1, n - 1), 2, stiff);
    }
    hold(&p, node_of(&p, 0, n - 1), 2);
    p.load[3 * node_of(&p, 0, 0)] = 1;
    p.load[3 * node_of(&p, n - 1, 0) + 1] = -1;
    solve(&p);
    double inward = displacement(&p, 0, 0, 0), outward = -displacement(&p, 1, 0, 1);
    CHECK_RELATIVE(inward, outward, 1e-6); /* the same but for its sign, by symmetry */
    problem_clear(&p);
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
    free(point);
    free(weight);
    return inward;
}

int main(void)
{
    double answer = 0;

    for (int degree = 2; degree <= 5; degree++) {
        for (int n = 8; n <= 32; n *= 2)
            printf("p = %d, %d x %d: roof %.6f\n", degree, n, n, answer = roof(degree, n));
        CHECK_RELATIVE(answer, 0.3006, OBSTACLE_COURSE);
    }
    for (int degree = 2; degree <= 5; degree++) {
        int coarsest = degree == 2 ? 16 : 8; /* quadratics lock longer */
        for (int n = coarsest; n <= 4 * coarsest; n *= 2)
            printf("p = %d, %d x %d: hemisphere %.6f\n", degree, n, n,
                   answer = hemisphere(degree, n));
        CHECK_RELATIVE(answer, 0.0924, OBSTACLE_COURSE);
    }
    return check_result();
}
