#include "mass_spring/spring_sweep.h"

#include <omp.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "models/clones.h"
#include "models/room.h"

/* Points that rows are padded to: a vector of single precision in AVX2, two or one of
 * double. */
enum { SWEEP_PAD = 8 };

/* Room in front of a part of the cells', so that all begin with a cache line. */
enum { CELL_PAD = 16 };

/* Rows around the net that neighbours reach. */
enum { SWEEP_REACH = 2 };

enum { SWEEP_V = 2, SWEEP_SETS = 3 };

/* Points from which on a step takes so much longer than threads wait for each other that
 * they share it. */
enum { SWEEP_SHARED = 3600 };

/* Parts of the room for cells, a stride each: what they pull with, by edge and component,
 * of three rows and of none; the sum on a row of points; which cells there are. */
enum {
    CELL_ROWS = 3,
    CELL_EDGES = 12,
    CELL_NOTHING = CELL_ROWS * CELL_EDGES,
    CELL_SUM = CELL_NOTHING + CELL_EDGES,
    CELL_THERE = CELL_SUM + 3,
    CELL_EVEN,
    CELL_ODD,
    CELL_PARTS
};

struct spring_sweep {
    int n, m, kinds; /* rows, points of a row, different rows                          */
    enum precision precision;
    ptrdiff_t pitch, first; /* from row to row, to point 0                             */
    double lag;             /* beta                                              [s]   */
    int now;                /* which of the sets 0 and 1 holds the positions           */
    size_t row_bytes;
    void *field[SWEEP_SETS][3]; /* by component; positions, positions, velocities      */
    void **row;                 /* [n] coefficients of a row                           */
    char *table;                /* [n] of them, the first `kinds` in use               */
    void *room;
    struct spring_cells cells; /* with cells only, as what follows                     */
    ptrdiff_t stride;
    char *cell_room; /* [CELL_PARTS][stride]; NULL: springs                            */
};

#define REAL    float
#define ROOT    sqrtf
#define NAME(x) single_##x
#include "mass_spring/spring_sweep_cell.h"
#include "mass_spring/spring_sweep_row.h"
#undef REAL
#undef ROOT
#undef NAME
#define REAL    double
#define ROOT    sqrt
#define NAME(x) double_##x
#include "mass_spring/spring_sweep_cell.h"
#include "mass_spring/spring_sweep_row.h"

/* The function of the sweep's precision. */
#define BY_PRECISION(s, name, ...)                                                         \
    ((s)->precision == PRECISION_SINGLE ? single_##name(__VA_ARGS__)                       \
                                        : double_##name(__VA_ARGS__))

void spring_sweep_free(struct spring_sweep *s)
{
    if (!s)
        return;
    free(s->room);
    free(s);
}

static enum status allocate(struct spring_sweep *s, bool cells)
{
    size_t size = s->precision == PRECISION_SINGLE ? sizeof(float) : sizeof(double);
    size_t bytes = size * (size_t)(s->pitch * (s->n + 2 * SWEEP_REACH));
    char *field[SWEEP_SETS][3];

    s->stride = (s->pitch + 2 * CELL_PAD - 1) / CELL_PAD * CELL_PAD;
    s->row_bytes = size * SWEEP_COUNT * (size_t)s->pitch;
    enum status st = room_cut(
        &s->room, ROOM(field[0][0], bytes), ROOM(field[0][1], bytes),
        ROOM(field[0][2], bytes), ROOM(field[1][0], bytes), ROOM(field[1][1], bytes),
        ROOM(field[1][2], bytes), ROOM(field[2][0], bytes), ROOM(field[2][1], bytes),
        ROOM(field[2][2], bytes), ROOM(s->row, (size_t)s->n),
        ROOM(s->table, (size_t)s->n * s->row_bytes),
        ROOM(s->cell_room, cells ? size * CELL_PARTS * (size_t)s->stride : 0));
    for (int n = 0; st == STATUS_OK && n < 3 * SWEEP_SETS; n++)
        s->field[n / 3][n % 3] = field[n / 3][n % 3];
    return st;
}

enum status spring_sweep_make(int n, int m, enum precision precision, double lag,
                              const struct spring_cells *cells, struct spring_sweep **sweep)
{
    enum status st;
    struct spring_sweep *s = calloc(1, sizeof *s);

    if (!s)
        return STATUS_MEMORY;
    s->n = n, s->m = m, s->precision = precision, s->lag = lag;
    s->pitch = (m + SWEEP_PAD - 1) / SWEEP_PAD * SWEEP_PAD;
    s->first = SWEEP_REACH * s->pitch;
    TRY(allocate(s, cells));
    if (cells) {
        s->cells = *cells;
        BY_PRECISION(s, cells_set, s);
    }
    *sweep = s, s = NULL;
out:
    spring_sweep_free(s);
    return st;
}

void spring_sweep_set(struct spring_sweep *s, const double (*c)[SWEEP_COUNT])
{
    s->kinds = 0;
    for (int i = 0; i < s->n; i++) {
        char *new = s->table + (size_t)s->kinds * s->row_bytes, *same = s->table;
        BY_PRECISION(s, coefficients, s, c + (ptrdiff_t)i * s->m, new);
        while (memcmp(same, new, s->row_bytes))
            same += s->row_bytes;
        s->row[i] = same;
        s->kinds += same == new;
    }
}

void spring_sweep_put(struct spring_sweep *s, const double *x, const double *v)
{
    if (x)
        BY_PRECISION(s, put, s, s->now, x);
    if (v)
        BY_PRECISION(s, put, s, SWEEP_V, v);
}

void spring_sweep_get(const struct spring_sweep *s, double *x, double *v)
{
    if (x)
        BY_PRECISION(s, get, s, s->now, x);
    if (v)
        BY_PRECISION(s, get, s, SWEEP_V, v);
}

void spring_sweep_hold(struct spring_sweep *s, int node, int component, double x, double v)
{
    ptrdiff_t at = s->first + node / s->m * s->pitch + node % s->m;
    void *place = s->field[s->now][component], *velocity = s->field[SWEEP_V][component];

    if (s->precision == PRECISION_SINGLE)
        ((float *)place)[at] = (float)x, ((float *)velocity)[at] = (float)v;
    else
        ((double *)place)[at] = x, ((double *)velocity)[at] = v;
}

/* A share of the rows, step by step; all wait for each other after each. */
static void run_share(struct spring_sweep *s, double dt, int count, int share, int shares)
{
    const int from = s->n * share / shares, to = s->n * (share + 1) / shares;

    for (int n = 0; n < count; n++) {
        BY_PRECISION(s, rows, s, dt, s->now ^ (n & 1), from, to);
        if (shares > 1) {
#pragma omp barrier
        }
    }
}

/* Rows of cells are made one from the other, in one thread. */
void spring_sweep_run(struct spring_sweep *s, double dt, int count)
{
    if (s->n * s->m < SWEEP_SHARED || s->cell_room || omp_get_max_threads() == 1)
        run_share(s, dt, count, 0, 1);
    else
#pragma omp parallel
        run_share(s, dt, count, omp_get_thread_num(), omp_get_num_threads());
    s->now ^= count & 1;
}
