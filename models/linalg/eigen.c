#include "models/linalg/eigen.h"

#include <assert.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/blas_kernel.h"
#include "models/linalg/factor.h"
#include "models/room.h"

/* --- dense ------------------------------------------------------------------------------
 */

static void spread(const struct eigen_pair *a, const double *value, double *full)
{
    memset(full, 0, (size_t)a->n * a->n * sizeof *full);
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++)
            full[(size_t)j * a->n + a->row[s]] = value[s];
}

static enum status lowest_dense(const struct eigen_pair *pair, int count, double *lambda,
                                double *vector, struct message *why)
{
    enum status st = STATUS_OK;
    int n = pair->n, found = 0, info;
    size_t square = (size_t)n * n;
    void *room;
    double *k, *m, *all; /* dsygvx needs room for all n */
    int *failed;
    TRY(room_cut(&room, ROOM(k, square), ROOM(m, square), ROOM(all, n), ROOM(failed, n)));
    spread(pair, pair->K, k);
    spread(pair, pair->M, m);
    info = LAPACKE_dsygvx(LAPACK_COL_MAJOR, 1, vector ? 'V' : 'N', 'I', 'L', n, k, n, m, n,
                          0.0, 0.0, 1, count, 2.0 * LAPACKE_dlamch('S'), &found, all,
                          vector, n, failed);
    if (info > n)
        st = status_fail(why, STATUS_INDEFINITE,
                         "eigenvalues: the mass matrix is not positive definite");
    else if (info != 0 || found != count)
        st = status_fail(why, STATUS_DIVERGED,
                         "eigenvalues: LAPACK's dsygvx stopped with info %d", info);
    else
        memcpy(lambda, all, count * sizeof *lambda);
out:
    free(room);
    return st;
}

/* --- sparse -----------------------------------------------------------------------------
 */

/* These are ARPACK's Fortran symbols; the last arguments are the lengths of the strings. */
void dsaupd_(int *ido, const char *bmat, const int *n, const char *which, const int *nev,
             double *tol, double *resid, const int *ncv, double *v, const int *ldv,
             int *iparam, int *ipntr, double *workd, double *workl, const int *lworkl,
             int *info, size_t bmat_length, size_t which_length);
void dseupd_(const int *rvec, const char *howmny, int *select, double *d, double *z,
             const int *ldz, const double *sigma, const char *bmat, const int *n,
             const char *which, const int *nev, double *tol, double *resid, const int *ncv,
             double *v, const int *ldv, int *iparam, int *ipntr, double *workd,
             double *workl, const int *lworkl, int *info, size_t howmny_length,
             size_t bmat_length, size_t which_length);

/* Computes y = M x. */
static void multiply(const struct eigen_pair *a, const double *x, double *y)
{
    memset(y, 0, a->n * sizeof *y);
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            y[a->row[s]] += a->M[s] * x[j];
            if (a->row[s] != j)
                y[j] += a->M[s] * x[a->row[s]];
        }
}

/* Returns the sum of the diagonal's magnitudes. */
static double magnitude(const struct eigen_pair *a, const double *value)
{
    double sum = 0.0;
    for (int j = 0; j < a->n; j++)
        sum += fabs(value[a->start[j]]);
    return sum;
}

static bool positive_diagonal(const struct eigen_pair *a)
{
    for (int j = 0; j < a->n; j++)
        if (!(a->M[a->start[j]] > 0.0))
            return false;
    return true;
}

struct shifting {
    const struct eigen_pair *pair;
    double mean; /* |k_ii| / m_ii */
    struct factor *f;
};

/* Factors K + part mean M. */
static enum status factor_at(const struct shifting *s, double part)
{
    const struct eigen_pair *a = s->pair;
    const double shift = part * s->mean;
    double *value = factor_values(s->f);

    factor_clear_values(s->f);
    for (int j = 0; j < a->n; j++)
        for (long t = a->start[j]; t < a->start[j + 1]; t++)
            value[factor_slot(s->f, a->row[t], j)] = a->K[t] + shift * a->M[t];
    return factor_refactor(s->f);
}

/* Factors K - sigma M for the smallest -sigma that leaves it positive definite, searched by
 * factors of a hundred, closer where lambdas are negative, as modes far above the shift
 * converge slowly. */
static enum status factor_shifted(const struct shifting *s, double *sigma,
                                  struct message *why)
{
    const double first = 1e-12, most = 1e4, close = 3;
    double part = first, below = 0;
    enum status st = factor_at(s, part);

    for (; st == STATUS_INDEFINITE && part < most; part *= 100, st = factor_at(s, part))
        below = part;
    while (st == STATUS_OK && below > 0 && part / below > close) {
        double between = sqrt(part * below);
        st = factor_at(s, between);
        *(st == STATUS_OK ? &part : &below) = between;
        if (st == STATUS_INDEFINITE)
            st = factor_at(s, part);
    }
    *sigma = -part * s->mean;
    if (st != STATUS_OK)
        status_fail(why, st, "eigenvalues: no shift makes stiffness and mass definite");
    return st;
}

static enum status shifting_init(const struct eigen_pair *pair, struct shifting *s,
                                 struct message *why)
{
    *s = (struct shifting){pair, magnitude(pair, pair->K) / magnitude(pair, pair->M), NULL};
    if (!positive_diagonal(pair) || !(s->mean > 0.0))
        return status_fail(why, STATUS_INDEFINITE,
                           "eigenvalues: a mass on the diagonal is not positive, or no "
                           "stiffness is there");
    return factor_create(
        &(struct factor_pattern){.n = pair->n, .start = pair->start, .row = pair->row},
        SOLVER_AUTO, &s->f);
}

struct lanczos {
    int n, nev, ncv, lworkl, iparam[11], ipntr[11], *select;
    double tol; /* 0: round-off; dsaupd writes here what it took */
    double *resid, *v, *workd, *workl;
    void *room; /* memory of the arrays */
};

static enum status lanczos_init(struct lanczos *l, int n, int nev)
{
    enum status st;
    /* ARPACK advises twice the wanted ones; a few more save restarts if few are wanted. */
    *l = (struct lanczos){.n = n, .nev = nev, .ncv = 2 * nev + 20 < n ? 2 * nev + 20 : n};
    l->lworkl = l->ncv * (l->ncv + 8);
    l->iparam[0] = 1;    /* exact shifts  */
    l->iparam[2] = 1000; /* restarts      */
    l->iparam[3] = 1;    /* block size    */
    l->iparam[6] = 3;    /* shift-invert  */
    TRY(room_cut(&l->room, ROOM(l->select, l->ncv), ROOM(l->resid, n),
                 ROOM(l->v, (size_t)n * l->ncv), ROOM(l->workd, 3 * n),
                 ROOM(l->workl, l->lworkl)));
    /* The start vector is hardly orthogonal to any mode, and the same every run. */
    unsigned long state = 1;
    for (int i = 0; i < n; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        l->resid[i] = (double)(state >> 11) * 0x1p-53 - 0.5;
    }
out:
    return st;
}

/* Runs ARPACK's reverse communication: it asks, we multiply or solve. */
static enum status lanczos_run(struct lanczos *l, const struct eigen_pair *pair,
                               struct factor *f, struct message *why)
{
    enum status st = STATUS_OK;
    int ido = 0, info = 1; /* info 1: start from resid */
    for (;;) {
        dsaupd_(&ido, "G", &l->n, "LM", &l->nev, &l->tol, l->resid, &l->ncv, l->v, &l->n,
                l->iparam, l->ipntr, l->workd, l->workl, &l->lworkl, &info, 1, 2);
        double *x = l->workd + l->ipntr[0] - 1, *y = l->workd + l->ipntr[1] - 1;
        if (ido == -1 || ido == 2)
            multiply(pair, x, y);
        else if (ido == 1)
            memcpy(y, l->workd + l->ipntr[2] - 1, l->n * sizeof *y);
        else
            break;
        if (ido != 2)
            TRY(factor_solve(f, y));
    }
    if (info != 0)
        st =
            status_fail(why, STATUS_DIVERGED,
                        "eigenvalues: ARPACK's dsaupd stopped with info %d, %d of %d found",
                        info, l->iparam[4], l->nev);
out:
    return st;
}

/* Extracts Ritz pairs; dseupd returns them ascending. */
static enum status lanczos_take(struct lanczos *l, double sigma, double *lambda,
                                double *vector, struct message *why)
{
    int info = 0, want = vector != NULL;
    double *z = vector ? vector : l->v;
    dseupd_(&want, "A", l->select, lambda, z, &l->n, &sigma, "G", &l->n, "LM", &l->nev,
            &l->tol, l->resid, &l->ncv, l->v, &l->n, l->iparam, l->ipntr, l->workd,
            l->workl, &l->lworkl, &info, 1, 1, 2);
    if (info != 0)
        return status_fail(why, STATUS_DIVERGED,
                           "eigenvalues: ARPACK's dseupd gave info %d", info);
    return STATUS_OK;
}

static enum status lowest_sparse(const struct eigen_pair *pair, int count, double *lambda,
                                 double *vector, struct message *why)
{
    enum status st;
    struct shifting s = {0};
    struct lanczos l = {0};
    double sigma = 0.0;
    TRY(shifting_init(pair, &s, why));
    TRY(factor_shifted(&s, &sigma, why));
    TRY(lanczos_init(&l, pair->n, count));
    TRY(lanczos_run(&l, pair, s.f, why));
    TRY(lanczos_take(&l, sigma, lambda, vector, why));
out:
    free(l.room);
    factor_destroy(s.f);
    return st;
}

enum status eigen_lowest(const struct eigen_pair *pair, int count, double *lambda,
                         double *vector, struct message *why)
{
    assert(1 <= count && count <= pair->n);
    blas_kernel_set_threads(1);
    /* Lanczos pays while the wanted modes are few. */
    if (pair->n <= EIGEN_DENSE_MAX || count > pair->n / 4)
        return lowest_dense(pair, count, lambda, vector, why);
    return lowest_sparse(pair, count, lambda, vector, why);
}
