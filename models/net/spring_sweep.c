#include "models/net/spring_sweep.h"

#include <omp.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "models/clones.h"
#include "models/room.h"

/* The most points of a vector: of single precision in AVX-512; rooms begin with one. */
enum { SWEEP_PAD = 16 };

/* The points of a strip: fewer are not worth a call, coefficients of more leave the first
 * cache. */
enum { STRIP_LEAST = 256, STRIP_MOST = 512 };

/* The rows around the net that neighbours reach. */
enum { SWEEP_REACH = 2 };

enum { SWEEP_V = 2, SWEEP_SETS = 3 };

/* Threads share a step of at least so many points: it then takes much longer than they wait
 * for each other. */
enum { SWEEP_SHARED = 3600 };

/* Parts of the room for cells, a stride each: tensions along their sides and diagonals, of
 * which the rising one begins at their first point, and only one is there. */
enum {
    CELL_BOTTOM,
    CELL_TOP,
    CELL_LEFT,
    CELL_RIGHT,
    CELL_RISING,
    CELL_FALLING,
    CELL_SIDES
};

/* Masks of a strip's cells: which there are, and which begin where four diagonals meet. */
enum { CELL_THERE, CELL_HUB, CELL_MASKS };

struct spring_sweep {
    int n, m;         /* rows, points of a row                                         */
    int sheet;        /* rows of a sheet                                               */
    int rows, strips; /* rows of a strip, strips                                       */
    int kinds;        /* different strips                                              */
    enum precision precision;
    ptrdiff_t pitch, count, first; /* from row to row, from strip to strip, to point 0 */
    double lag;                    /* beta                                       [s]   */
    int now; /* which of the sets 0 and 1 holds the positions                          */
    struct net_origin origin; /* of places and velocities in the fields                */
    size_t strip_bytes;
    void *field[SWEEP_SETS][3]; /* arrays by component; positions, positions, velocities */
    void **strip;               /* [strips] coefficients of a strip                    */
    char *table;                /* [strips] of them, the first `kinds` in use          */
    void *room;
    bool celled;               /* cells pull in place of springs                       */
    struct spring_cells cells; /* with cells only, as what follows                     */
    ptrdiff_t stride;
    char *cell_room;  /* [CELL_SIDES][stride]; NULL: springs                            */
    void **mask;      /* [strips] of [CELL_MASKS][count]                               */
    char *mask_table; /* [strips] of them, as `table`                                   */
    size_t mask_bytes;
};

static ptrdiff_t whole_vectors(ptrdiff_t points)
{
    return (points + SWEEP_PAD - 1) / SWEEP_PAD * SWEEP_PAD;
}

/* Returns the points of strip i, whole vectors; fewer in the last strip. */
static ptrdiff_t points_of(const struct spring_sweep *s, int i)
{
    ptrdiff_t rows = s->n - i * s->rows;

    return whole_vectors((rows < s->rows ? rows : s->rows) * s->pitch);
}

static ptrdiff_t place_of(const struct spring_sweep *s, int node)
{
    return s->first + node / s->m * s->pitch + node % s->m;
}

/* Returns the first of the table's entries that equals entry *kinds, which counts as one of
 * them if it is the first of its kind. */
static void *shared(char *table, size_t bytes, int *kinds)
{
    char *new = table + (size_t)*kinds *bytes, *same = table;

    while (memcmp(same, new, bytes))
        same += bytes;
    *kinds += same == new;
    return same;
}

#define REAL    float
#define ROOT    sqrtf
#define NAME(x) single_##x
#include "models/net/spring_sweep_cell.h"
#include "models/net/spring_sweep_row.h"
#undef REAL
#undef ROOT
#undef NAME
#define REAL    double
#define ROOT    sqrt
#define NAME(x) double_##x
#include "models/net/spring_sweep_cell.h"
#include "models/net/spring_sweep_row.h"

/* Calls the function of the sweep's precision. */
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

/* Lays out rows one behind the other without gaps, so that vectors run on from row to
 * row and a narrow net costs no more than its points. A small net is one strip; strips
 * of larger ones are whole vectors, to which rows are lengthened if it takes too many of
 * them. */
static void lay_out(struct spring_sweep *s)
{
    int rows = s->n;

    s->pitch = s->m;
    if (s->n * s->m > STRIP_MOST) {
        for (;; s->pitch++) {
            for (rows = 1; rows * s->pitch % SWEEP_PAD; rows++)
                ;
            if (rows == 1 || rows * s->pitch <= STRIP_MOST)
                break;
        }
        rows *= (int)((STRIP_LEAST + rows * s->pitch - 1) / (rows * s->pitch));
    }
    s->rows = rows, s->strips = (s->n + rows - 1) / rows;
    s->count = whole_vectors(rows * s->pitch);
    s->first = whole_vectors(SWEEP_REACH * (s->pitch + 1));
}

static enum status allocate(struct spring_sweep *s)
{
    size_t size = s->precision == PRECISION_SINGLE ? sizeof(float) : sizeof(double);
    size_t bytes = size * (size_t)(2 * s->first + s->count * s->strips);
    char *field[SWEEP_SETS][3];

    s->stride = 2 * SWEEP_PAD + whole_vectors(s->pitch) + s->count;
    s->strip_bytes = size * (size_t)(SWEEP_COUNT * s->count);
    s->mask_bytes = s->celled ? size * (size_t)(CELL_MASKS * s->count) : 0;
    enum status st = room_cut(
        &s->room, ROOM(field[0][0], bytes), ROOM(field[0][1], bytes),
        ROOM(field[0][2], bytes), ROOM(field[1][0], bytes), ROOM(field[1][1], bytes),
        ROOM(field[1][2], bytes), ROOM(field[2][0], bytes), ROOM(field[2][1], bytes),
        ROOM(field[2][2], bytes), ROOM(s->strip, (size_t)s->strips),
        ROOM(s->table, (size_t)s->strips * s->strip_bytes),
        ROOM(s->mask, (size_t)s->strips),
        ROOM(s->mask_table, (size_t)s->strips * s->mask_bytes),
        ROOM(s->cell_room, s->celled ? size * CELL_SIDES * (size_t)s->stride : 0));
    for (int n = 0; st == STATUS_OK && n < 3 * SWEEP_SETS; n++)
        s->field[n / 3][n % 3] = field[n / 3][n % 3];
    return st;
}

enum status spring_sweep_make(const struct spring_sweep_plan *plan,
                              struct spring_sweep **sweep)
{
    enum status st;
    struct spring_sweep *s = calloc(1, sizeof *s);

    if (!s)
        return STATUS_MEMORY;
    s->n = plan->n, s->m = plan->m, s->precision = plan->precision, s->lag = plan->lag;
    s->celled = plan->cells, s->sheet = plan->sheet, s->origin = plan->origin;
    lay_out(s);
    TRY(allocate(s));
    if (s->celled) {
        s->cells = *plan->cells;
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
    for (int i = 0; i < s->strips; i++) {
        BY_PRECISION(s, coefficients, s, i, c,
                     s->table + (size_t)s->kinds * s->strip_bytes);
        s->strip[i] = shared(s->table, s->strip_bytes, &s->kinds);
    }
}

void spring_sweep_put(struct spring_sweep *s, const double *x, const double *v)
{
    if (x)
        BY_PRECISION(s, put, s, s->now, s->origin.at, x);
    if (v)
        BY_PRECISION(s, put, s, SWEEP_V, s->origin.velocity, v);
}

void spring_sweep_get(const struct spring_sweep *s, double *x, double *v)
{
    if (x)
        BY_PRECISION(s, get, s, s->now, s->origin.at, x);
    if (v)
        BY_PRECISION(s, get, s, SWEEP_V, s->origin.velocity, v);
}

bool spring_sweep_follow(struct spring_sweep *s, const double *x, const double *v)
{
    if (!net_origin_follow(&s->origin, s->n * s->m, x, v))
        return false;
    spring_sweep_put(s, x, v);
    return true;
}

const struct net_origin *spring_sweep_origin(const struct spring_sweep *s)
{
    return &s->origin;
}

void spring_sweep_hold(struct spring_sweep *s, int node, int component, double x, double v)
{
    ptrdiff_t at = place_of(s, node);
    void *place = s->field[s->now][component], *velocity = s->field[SWEEP_V][component];

    x -= s->origin.at[component], v -= s->origin.velocity[component];
    if (s->precision == PRECISION_SINGLE)
        ((float *)place)[at] = (float)x, ((float *)velocity)[at] = (float)v;
    else
        ((double *)place)[at] = x, ((double *)velocity)[at] = v;
}

/* Runs a share of the strips, step by step; threads wait for each other after each. */
static void run_share(struct spring_sweep *s, double dt, int count, int share, int shares)
{
    const int from = s->strips * share / shares, to = s->strips * (share + 1) / shares;

    for (int n = 0; n < count; n++) {
        BY_PRECISION(s, strips, s, dt, s->now ^ (n & 1), from, to);
        if (shares > 1) {
#pragma omp barrier
        }
    }
}

/* Strips of cells depend on the one before, and run in one thread. */
void spring_sweep_run(struct spring_sweep *s, double dt, int count)
{
    if (s->n * s->m < SWEEP_SHARED || s->celled || omp_get_max_threads() == 1)
        run_share(s, dt, count, 0, 1);
    else
#pragma omp parallel
        run_share(s, dt, count, omp_get_thread_num(), omp_get_num_threads());
    s->now ^= count & 1;
    for (int i = 0; i < 3; i++)
        s->origin.at[i] += count * dt * s->origin.velocity[i];
}
