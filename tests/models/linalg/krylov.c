/* Conjugate gradients, GMRES and incomplete Cholesky on made-up matrices: residuals, what
 * they say of matrices that are not positive definite and of too few iterations. */
#include "models/linalg/ichol.h"
#include "models/linalg/krylov.h"
#include "tests/check.h"
#include "tests/net_matrix.h"

enum { MOST = 400 };

/* The iterations' tolerance; the residual of the net's dominant matrices is not far above.
 */
#define TOLERANCE 1e-10
#define SLACK     100

struct problem {
    struct net_matrix a;
    struct ichol *ichol; /* NULL: no preconditioner                                    */
    double *work, *b, *x;
    struct krylov krylov;
};

static void multiply(void *self, const double *x, double *y)
{
    net_matrix_multiply(&((struct problem *)self)->a, x, y);
}

static enum status precondition(void *self, const double *x, double *y)
{
    struct problem *p = self;

    memcpy(y, x, p->a.n * sizeof *y);
    if (p->ichol)
        ichol_solve(p->ichol, y);
    return STATUS_OK;
}

static void open(struct problem *p)
{
    size_t n = p->a.n;

    p->work = malloc((krylov_cg_work(p->a.n) + krylov_gmres_work(p->a.n)) * sizeof(double));
    p->b = malloc(n * sizeof *p->b), p->x = calloc(n, sizeof *p->x);
    REQUIRE(p->work && p->b && p->x);
    for (size_t t = 0; t < n; t++)
        p->b[t] = 1 + sin(1.0 + t * t);
    p->krylov = (struct krylov){.n = p->a.n,
                                .self = p,
                                .multiply = multiply,
                                .precondition = precondition,
                                .tolerance = TOLERANCE,
                                .most = MOST,
                                .work = p->work};
}

static struct ichol *factor(const struct net_matrix *a, enum status want)
{
    const struct factor_pattern pattern = {.n = a->n, .start = a->start, .row = a->row};
    struct ichol *f = NULL;

    REQUIRE(ichol_create(&pattern, &f) == STATUS_OK);
    memcpy(ichol_values(f), a->value, a->start[a->n] * sizeof *a->value);
    CHECK(ichol_refactor(f) == want);
    return f;
}

static void close(struct problem *p)
{
    ichol_destroy(p->ichol);
    free(p->work);
    free(p->b);
    free(p->x);
    net_matrix_clear(&p->a);
}

static double residual(const struct problem *p)
{
    double *y = malloc(p->a.n * sizeof *y), worst = 0;

    net_matrix_multiply(&p->a, p->x, y);
    for (int t = 0; t < p->a.n; t++)
        worst = fmax(worst, fabs(p->b[t] - y[t]));
    free(y);
    return worst;
}

typedef enum status method(struct krylov *k, const double *b, double *x, bool *done);

static void check_net(method *solve, bool ichol, int *iterations)
{
    const struct net_shape shape = {.points_u = 7, .points_v = 6, .reach = 2};
    struct problem p = {0};
    bool done = false;

    REQUIRE(net_matrix_create(&shape, &p.a) == STATUS_OK);
    p.ichol = ichol ? factor(&p.a, STATUS_OK) : NULL;
    open(&p);
    CHECK(solve(&p.krylov, p.b, p.x, &done) == STATUS_OK && done);
    CHECK(residual(&p) < SLACK * TOLERANCE);
    *iterations = p.krylov.iterations;
    p.krylov.most = 3; /* too few: told, and what was reached is better than nothing */
    memset(p.x, 0, p.a.n * sizeof *p.x);
    CHECK(solve(&p.krylov, p.b, p.x, &done) == STATUS_OK && !done);
    CHECK(residual(&p) < 2);
    p.b[0] = NAN;
    CHECK(solve(&p.krylov, p.b, p.x, &done) == STATUS_NAN);
    close(&p);
}

static void check_nets(method *solve)
{
    int plain, better;

    check_net(solve, false, &plain);
    check_net(solve, true, &better);
    CHECK(better < plain && better > 1);
}

/* A tridiagonal matrix: of `low` at the first unknown, 2 elsewhere, `beside` next to it. */
static struct net_matrix line(int n, double low, double beside)
{
    struct net_matrix a = {.n = n,
                           .start = malloc((n + 1) * sizeof *a.start),
                           .row = malloc(2 * n * sizeof *a.row),
                           .value = malloc(2 * n * sizeof *a.value)};

    REQUIRE(a.start && a.row && a.value);
    a.start[0] = 0;
    for (int j = 0; j < n; j++) {
        long s = a.start[j];
        a.row[s] = j, a.value[s] = j ? 2 : low;
        if (j + 1 < n)
            a.row[s + 1] = j + 1, a.value[s + 1] = beside;
        a.start[j + 1] = s + 1 + (j + 1 < n);
    }
    return a;
}

/* Without fill-in to leave out it is Cholesky's factor: one product solves. */
static void check_exact(void)
{
    struct problem p = {.a = line(40, 2, -1)};
    bool done = false;

    p.ichol = factor(&p.a, STATUS_OK);
    open(&p);
    CHECK(krylov_cg(&p.krylov, p.b, p.x, &done) == STATUS_OK && done);
    CHECK(p.krylov.iterations == 2); /* and one to see it */
    close(&p);
}

/* Near enough is left there: without a preconditioner what it makes of a residual is that.
 */
static void check_enough(void)
{
    const double near = 1e-3, rounding = 1e-10;
    const struct net_shape shape = {.points_u = 7, .points_v = 6, .reach = 2};
    struct problem p = {0};
    bool done = false;

    REQUIRE(net_matrix_create(&shape, &p.a) == STATUS_OK);
    open(&p);
    p.krylov.near = near;
    CHECK(krylov_cg(&p.krylov, p.b, p.x, &done) == STATUS_OK && done);
    CHECK(residual(&p) <= near + rounding);
    CHECK(residual(&p) > SLACK * TOLERANCE);
    close(&p);
}

/* Not positive definite: conjugate gradients and the factor say so, GMRES solves. The
 * shift saves a factor of what is not far from it, and not one of a zero diagonal. */
static void check_indefinite(void)
{
    struct problem p = {.a = line(40, -2, -1)};
    struct net_matrix shifted = line(40, 2, -1.02), zero = line(40, 0, -1);
    bool done = false;

    open(&p);
    CHECK(krylov_cg(&p.krylov, p.b, p.x, &done) == STATUS_INDEFINITE);
    memset(p.x, 0, p.a.n * sizeof *p.x);
    CHECK(krylov_gmres(&p.krylov, p.b, p.x, &done) == STATUS_OK && done);
    CHECK(residual(&p) < SLACK * TOLERANCE);
    ichol_destroy(factor(&p.a, STATUS_INDEFINITE));
    ichol_destroy(factor(&zero, STATUS_INDEFINITE));
    ichol_destroy(factor(&shifted, STATUS_OK));
    net_matrix_clear(&shifted);
    net_matrix_clear(&zero);
    close(&p);
}

int main(void)
{
    check_nets(krylov_cg);
    check_nets(krylov_gmres);
    check_exact();
    check_enough();
    check_indefinite();
    return check_result();
}
