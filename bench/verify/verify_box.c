#include "bench/verify/verify_box.h"

#include "bench/files/arena.h"
#include "models/linalg/gauss.h"

/* The matrices of one direction. */
struct line {
    int n, below;  /* its functions; those of the directions behind it, all together */
    double *of[3]; /* [n][n] each: int N_a N_b, int N_a' N_b, int N_a' N_b'          */
};

static void add_point(struct line *line, const struct bspline *b, int span, const double *N,
                      double weight, double size)
{
    const double *slope = N + b->p + 1;

    for (int a = 0; a <= b->p; a++)
        for (int c = 0; c <= b->p; c++) {
            int at = (span - b->p + a) * line->n + span - b->p + c;
            line->of[0][at] += weight * size * N[a] * N[c];
            line->of[1][at] += weight * slope[a] * N[c];
            line->of[2][at] += weight / size * slope[a] * slope[c];
        }
}

static enum status line_init(struct arena *arena, struct line *line, int degree, int points,
                             double size, struct message *why)
{
    const int n = points ? points : 1;
    double x[GAUSS_MAX], w[GAUSS_MAX], N[2 * BSPLINE_MAX_ORDER];
    double *room = arena_take(arena, 3 * (size_t)(n * n), sizeof *room);
    struct bspline b SCOPED(bspline_clear) = {0};

    *line = (struct line){n, 1, {room, room + n * n, room + 2 * n * n}};
    if (!points) {
        *room = size;
        return STATUS_OK;
    }
    CALL(bspline_init_uniform(&b, degree, points, why));
    gauss_rule(degree + 3, x, w);
    for (int k = degree; k < n; k++) {
        const double edge = b.U[k + 1] - b.U[k];
        for (int q = 0; q < degree + 3; q++) {
            bspline_eval(&b, k, b.U[k] + edge * x[q], 1, N);
            add_point(line, &b, k, N, edge * w[q], size);
        }
    }
    return STATUS_OK;
}

/* Returns int N_a,i N_b,j dV; for i = j = 3 int N_a N_b dV. */
static double product(const struct line line[3], int a, int b, int i, int j)
{
    double value = 1;

    for (int d = 0; d < 3; d++) {
        const int n = line[d].n, p = a / line[d].below % n, q = b / line[d].below % n;
        const double *of = line[d].of[(d == i) + (d == j)];
        value *= d == j && d != i ? of[q * n + p] : of[p * n + q];
    }
    return value;
}

static double entry(const struct verify_box *box, bool mass, const struct line line[3],
                    int a, int b, int i, int j)
{
    if (mass)
        return i == j ? box->density * product(line, a, b, 3, 3) : 0;
    double value =
        box->lambda * product(line, a, b, i, j) + box->mu * product(line, a, b, j, i);
    for (int k = 0; i == j && k < 3; k++)
        value += box->mu * product(line, a, b, k, k);
    return value;
}

enum status verify_box_matrix(const struct verify_box *box, bool mass, double *full,
                              struct message *why)
{
    struct line line[3];
    struct arena own SCOPED(arena_clear) = {0};

    for (int d = 0; d < 3; d++)
        CALL(line_init(&own, &line[d], box->degree[d], box->points[d], box->size[d], why));
    line[1].below = line[2].n, line[0].below = line[1].n * line[2].n;
    const int rows = 3 * line[0].n * line[0].below;
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < rows; c++)
            *full++ = entry(box, mass, line, r / 3, c / 3, r % 3, c % 3);
    return STATUS_OK;
}
