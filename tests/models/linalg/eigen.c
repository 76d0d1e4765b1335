/* Lowest modes of chains and membranes of springs against their closed forms, on both sides
 * of EIGEN_DENSE_MAX. */
#include <float.h>

#include "models/linalg/eigen.h"
#include "tests/check.h"
#include "tests/net_matrix.h"

/* LAPACK and shift-invert leave an error of some eps times the largest lambda (8 for a
 * chain's 4 with consistent mass: 12), however small the wanted one is; measured 7 eps. */
#define TOL_LAMBDA (12 * 8 * DBL_EPSILON)
/* Orthonormal to round-off in dot products of 2500 terms; measured 61 eps. */
#define TOL_NORMAL (512 * DBL_EPSILON)
/* |K x - lambda M x|: as lambda's, for unit x; measured 10 eps. */
#define TOL_RESIDUAL TOL_LAMBDA

/* A net of n x m masses, springs between neighbours; held: a wall behind every edge. */
struct net {
    int n, m;
    bool held, consistent; /* consistent: mass (1/6, 2/3, 1/6), held chains only */
    double below;          /* this many masses are taken off the stiffness: a net that is
                              about to buckle has negative eigenvalues */
};

struct system {
    int n;
    long *start;
    int *row;
    double *k, *mass;
};

static struct system make(const struct net *net)
{
    struct system s = {.n = net->n * net->m};
    s.start = malloc((s.n + 1) * sizeof *s.start);
    s.row = malloc(3 * s.n * sizeof *s.row);
    s.k = malloc(3 * s.n * sizeof *s.k);
    s.mass = malloc(3 * s.n * sizeof *s.mass);
    long end = 0;
    for (int a = 0; a < s.n; a++) {
        int i = a / net->m, j = a % net->m;
        int inside = (i > 0) + (i < net->n - 1) + (j > 0) + (j < net->m - 1);
        s.start[a] = end;
        s.row[end] = a;
        s.k[end] = net->held ? (net->m > 1 ? 4.0 : 2.0) : inside;
        s.mass[end++] = net->consistent ? 2.0 / 3.0 : 1.0;
        for (int side = 0; side < 2; side++) {
            int b = side ? a + net->m : a + 1;
            if (side ? i == net->n - 1 : j == net->m - 1)
                continue;
            s.row[end] = b;
            s.k[end] = -1.0;
            s.mass[end++] = net->consistent ? 1.0 / 6.0 : 0.0;
        }
    }
    s.start[s.n] = end;
    for (int e = 0; e < end; e++)
        s.k[e] -= net->below * s.mass[e];
    return s;
}

static void clear(struct system *s)
{
    free(s->start);
    free(s->row);
    free(s->k);
    free(s->mass);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* All n m eigenvalues, sorted. Held: sines; free: cosines from zero on. */
static double *closed_form(const struct net *net)
{
    const double pi = acos(-1.0);
    double *lambda = malloc(net->n * net->m * sizeof *lambda);
    for (int i = 0; i < net->n; i++)
        for (int j = 0; j < net->m; j++) {
            double a = net->held ? (i + 1) * pi / (net->n + 1) : i * pi / net->n;
            double b = net->held ? (j + 1) * pi / (net->m + 1) : j * pi / net->m;
            double sum = 4.0 * pow(sin(0.5 * a), 2);
            if (net->m > 1)
                sum += 4.0 * pow(sin(0.5 * b), 2);
            lambda[i * net->m + j] =
                (net->consistent ? 3.0 * sum / (2.0 + cos(a)) : sum) - net->below;
        }
    qsort(lambda, net->n * net->m, sizeof *lambda, ascending);
    return lambda;
}

static void multiply(const struct system *s, double *value, const double *x, double *y)
{
    net_matrix_multiply(&(struct net_matrix){s->n, s->start, s->row, value}, x, y);
}

static void check_pairs(const struct system *s, int count, const double *lambda,
                        const double *vector)
{
    double *kx = malloc(s->n * sizeof *kx), *mx = malloc(s->n * sizeof *mx);
    for (int a = 0; a < count; a++) {
        double worst = 0.0;
        multiply(s, s->k, vector + (size_t)a * s->n, kx);
        multiply(s, s->mass, vector + (size_t)a * s->n, mx);
        for (int i = 0; i < s->n; i++)
            worst = fmax(worst, fabs(kx[i] - lambda[a] * mx[i]));
        CHECK_NEAR(worst, 0.0, TOL_RESIDUAL);
        for (int b = 0; b < count; b++) {
            double dot = 0.0;
            for (int i = 0; i < s->n; i++)
                dot += vector[(size_t)b * s->n + i] * mx[i];
            CHECK_NEAR(dot, a == b, TOL_NORMAL);
        }
    }
    free(kx);
    free(mx);
}

static void check_net(const struct net *net, int count)
{
    struct system s = make(net);
    const struct eigen_pair pair = {s.n, s.start, s.row, s.k, s.mass};
    struct message why = {""};
    double *want = closed_form(net), *lambda = malloc(count * sizeof *lambda);
    double *again = malloc(count * sizeof *again);
    double *vector = malloc((size_t)count * s.n * sizeof *vector);

    CHECK(eigen_lowest(&pair, count, lambda, vector, &why) == STATUS_OK);
    REQUIRE_SAY(!*why.text, "%s", why.text);
    for (int a = 0; a < count; a++)
        CHECK_NEAR(lambda[a], want[a], TOL_LAMBDA);
    check_pairs(&s, count, lambda, vector);
    if (s.n > EIGEN_DENSE_MAX) { /* the same bits every run */
        CHECK(eigen_lowest(&pair, count, again, vector, NULL) == STATUS_OK);
        CHECK(!memcmp(lambda, again, count * sizeof *lambda));
    }
    CHECK(eigen_lowest(&pair, count, again, NULL, NULL) == STATUS_OK);
    for (int a = 0; a < count; a++)
        CHECK_NEAR(again[a], want[a], TOL_LAMBDA);
    free(want);
    free(lambda);
    free(again);
    free(vector);
    clear(&s);
}

static void check_refusal(int n)
{
    const struct net net = {.n = n, .m = 1, .held = true};
    struct system s = make(&net);
    const struct eigen_pair pair = {s.n, s.start, s.row, s.k, s.mass};
    struct message why = {""};
    double lambda[2];
    s.mass[s.start[n / 2]] = -1e4;
    CHECK(eigen_lowest(&pair, 2, lambda, NULL, &why) == STATUS_INDEFINITE && *why.text);
    clear(&s);
}

int main(void)
{
    const int over = EIGEN_DENSE_MAX + 1;
    check_net(&(struct net){.n = 1, .m = 1, .held = true}, 1);
    check_net(&(struct net){.n = 12, .m = 1, .held = true}, 12);
    check_net(&(struct net){.n = 40, .m = 1, .held = true, .consistent = true}, 8);
    check_net(&(struct net){.n = 9, .m = 7, .held = true}, 10);
    check_net(&(struct net){.n = 700, .m = 1}, 6);
    check_net(&(struct net){.n = over, .m = 1, .held = true}, 6);
    check_net(&(struct net){.n = over, .m = 1}, 6);
    check_net(&(struct net){.n = over, .m = 1, .held = true, .consistent = true}, 12);
    check_net(&(struct net){.n = 53, .m = 41, .held = true}, 20);
    check_net(&(struct net){.n = 61, .m = 40}, 20);
    check_net(&(struct net){.n = 40, .m = 1, .held = true, .below = 0.1}, 8);
    check_net(&(struct net){.n = over, .m = 1, .held = true, .below = 1e-3}, 24);
    check_net(&(struct net){.n = 53, .m = 41, .held = true, .below = 0.5}, 20);
    check_refusal(20);
    check_refusal(over);
    return check_result();
}
