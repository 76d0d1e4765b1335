#define _DEFAULT_SOURCE /* madvise */
#include "models/linalg/factor.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "models/linalg/blas_kernel.h"
#include "models/linalg/factor_part.h"
#include "models/linalg/tile_three.h"
#include "models/room.h"

/* The layout: parts one after the other, in the values (first_slot) and in the permuted
 * right-hand side (first_row). One slot behind all is the dump. */
struct factor {
    int n, part_count;
    void *room, *part_room;   /* memory of part_of and place, and of the parts' arrays */
    struct factor_part *part; /* [part_count]                                          */
    int *first_row;           /* [part_count + 1] multiples of 8                       */
    ptrdiff_t *first_slot;    /* [part_count + 1] multiples of 8                       */
    int *part_of;             /* [n]                                                   */
    int *place;               /* [n] row in the permuted right-hand side               */
    bool straight;            /* place[i] == i for all i                               */
    bool ready;               /* the last refactor succeeded                           */
    bool single;        /* value and work hold floats from the next refactor on        */
    int shift;          /* floats are those of 2^shift A; even, so that L has the same
                           digits                                                      */
    double *value;      /* [first_slot[part_count] + 1]                          */
    double *work;       /* [first_row[part_count]] permuted, padding kept zero    */
    bool ready_three;   /* prepared for three sides since the last refactor       */
    double *work_three; /* [3 first_row[part_count]] blocks, padding kept zero; NULL
                           until three sides are asked for                        */
};

/* --- components of a pattern ---------------------------------------------------------
 */

static int root_of(int *parent, int i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/* Finds the components, part_of[n], numbered by their first unknown; parent[n] is work.
 * Returns their number. */
static int find_parts(const struct factor_pattern *a, int *parent, int *part_of)
{
    for (int i = 0; i < a->n; i++)
        parent[i] = i;
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            int p = root_of(parent, j), q = root_of(parent, a->row[s]);
            if (p < q)
                parent[q] = p;
            else
                parent[p] = q;
        }
    int count = 0;
    for (int i = 0; i < a->n; i++) /* a root is the least of its component */
        part_of[i] = parent[i] == i ? count++ : part_of[root_of(parent, i)];
    return count;
}

/* Restricts to a part; unknown[n]: its unknowns, ascending; local: their inverse. *room is
 * the memory of *part's arrays, owned by the caller. */
static enum status restrict_to(const struct factor_pattern *a, const int *unknown, int n,
                               const int *local, const int *part_of,
                               struct factor_pattern *part, void **room)
{
    enum status st;
    long entries = 0, end = 0, *start;
    int *row, *order;
    for (int k = 0; k < n; k++)
        entries += a->start[unknown[k] + 1] - a->start[unknown[k]];
    TRY(room_cut(room, ROOM(start, n + 1), ROOM(row, entries),
                 ROOM(order, a->order ? n : 0)));
    for (int k = 0; k < n; k++) {
        start[k] = end;
        for (long s = a->start[unknown[k]]; s < a->start[unknown[k] + 1]; s++)
            row[end++] = local[a->row[s]];
    }
    start[n] = end;
    for (int k = 0, next = 0; a->order && k < a->n; k++)
        if (part_of[a->order[k]] == part_of[unknown[0]])
            order[next++] = local[a->order[k]];
    *part = (struct factor_pattern){n, start, row, order};
out:
    return st;
}

double *factor_numbers(ptrdiff_t count)
{
    /* From a few megabytes on, translating addresses of 4 kB pages limits a sweep. */
    const size_t huge = (size_t)1 << 21;
    size_t bytes = (count + 8) / 8 * 64, align = bytes < 2 * huge ? 64 : huge;
    double *x = aligned_alloc(align, (bytes + align - 1) / align * align);
    if (x && align == huge)
        madvise(x, bytes, MADV_HUGEPAGE); /* advice: no matter if refused */
    if (x)
        memset(x, 0, bytes);
    return x;
}

/* Rounds scale times the numbers to floats, in place: in the first half of their room. */
static float *narrow_numbers(ptrdiff_t count, double scale, double *x)
{
    enum { AT_ONCE = 64 };
    double wide[AT_ONCE];
    float narrow[AT_ONCE];
    for (ptrdiff_t from = 0; from < count; from += AT_ONCE) {
        ptrdiff_t n = count - from < AT_ONCE ? count - from : AT_ONCE;
        memcpy(wide, x + from, n * sizeof *wide);
        for (ptrdiff_t i = 0; i < n; i++)
            narrow[i] = (float)(scale * wide[i]);
        memcpy((float *)x + from, narrow, n * sizeof *narrow);
    }
    return (float *)x;
}

/* --- which method -----------------------------------------------------------------------
 */

static double flops_of(const struct factor_part *part)
{
    struct factor_info info = {0};
    part->method->describe(part, &info);
    return info.flops;
}

/* The choice: the band, unless supernodes cost less. Measured, the least of many turns, on
 * one thread of an EPYC with AVX2: both run at some 18 to 20 Gflop/s, and CHOLMOD takes
 * 0.75 us more for each unknown, whose columns it gathers and scatters: as long as 13,500
 * operations.
 *
 *                          Mflop            factor [ms]        solve [ms]
 *   net         p      band  CHOLMOD       band  CHOLMOD       band  CHOLMOD
 *   10x10x2     2       9.7      7.7       0.45     0.96      0.018    0.048
 *   20x20x2     2       149      135        9.0      9.4       0.31     0.45
 *   32x32x2     2       954      675         47       39        1.7      2.5
 *   50x50x2     2      5600     3010        295      184        7.7      8.5
 *   16x16x2     1        18       11       0.86      1.8       0.05     0.11
 *   32x32x2     1       256      109       12.2     11.5       0.84     0.96
 *   p: reach of the couplings
 *
 * Other bands: whole frames by LAPACK's dpbtrf and dpbtrs on the same bands (OpenBLAS
 * 0.3.21) over frames by ours, and by CHOLMOD alone over ours, the least of turns on one
 * pinned core of an EPYC with AVX2:
 *
 *                                            LAPACK   CHOLMOD
 *   IGA 10x10x2, rebuilt                        1.7       2.6
 *   IGA 20x20x2, rebuilt                        2.0       3.4
 *   hexahedra 32x32x2, rebuilt                  2.1       2.5
 *   implicit springs 32x32                      2.1       3.5
 *   triangles 16x16                             1.4       1.6
 *   shell 10x10, p = 3                          1.2       1.3
 *   projective dynamics 20x20, three sides      3.1       2.3
 */
static const double operations_of_unknown = 13500;

/* A factor that others iterate on is a band up to so many times CHOLMOD's cost: it is made
 * seldom, and in single precision, which CHOLMOD has not, it solves in half the time.
 * Frames by conjugate gradients over those on CHOLMOD's factor: hexahedra 32x32x2 .56; IGA
 * 40x40x2 .51, 60x60x2 .65. */
static const double iterated = 3;

static const struct factor_method *method_of(enum solver method)
{
    return method == SOLVER_CHOLMOD ? &factor_cholmod : &factor_banded;
}

/* Creates by the method asked for, or the cheaper one; position[n], spare[n]: work. */
static enum status create_by_method(const struct factor_pattern *a, enum solver method,
                                    int *position, int *spare, struct factor_part *part)
{
    enum status st;
    struct factor_part other = {.method = &factor_cholmod, .n = part->n};
    part->method = method_of(method);
    st = part->method->create(a, position, part);
    const double gathering = operations_of_unknown * part->n;
    const bool iterates = solver_iterates(method);
    const double share = iterates ? iterated : 1;
    if (st != STATUS_OK || (method > SOLVER_DIRECT && !iterates) ||
        flops_of(part) < gathering)
        return st;
    st = other.method->create(a, spare, &other);
    if (st == STATUS_OK && flops_of(part) > share * (gathering + flops_of(&other))) {
        memcpy(position, spare, a->n * sizeof *position);
        const struct factor_part band = *part;
        *part = other, other = band;
    }
    other.method->destroy(&other);
    return st;
}

/* --- life -------------------------------------------------------------------------------
 */

static enum status create_part(struct factor *f, int p, const struct factor_pattern *a,
                               enum solver method, const int *unknown, const int *local)
{
    enum status st;
    struct factor_pattern own;
    void *room = NULL;
    struct factor_part *part = &f->part[p];
    int *position = NULL;

    if (!(position = malloc(2 * (size_t)part->n * sizeof *position)))
        return STATUS_MEMORY;
    TRY(restrict_to(a, unknown, part->n, local, f->part_of, &own, &room));
    TRY(create_by_method(&own, method, position, position + part->n, part));
    f->first_slot[p + 1] = f->first_slot[p] + (part->slots + 7) / 8 * 8;
    f->first_row[p + 1] = f->first_row[p] + (part->rows + 7) / 8 * 8;
    for (int k = 0; k < part->n; k++)
        f->place[unknown[k]] = f->first_row[p] + position[k];
out:
    free(room);
    free(position);
    return st;
}

static enum status create_parts(struct factor *f, const struct factor_pattern *a,
                                enum solver method)
{
    enum status st;
    void *room;
    int *unknown, *local, *begin;
    TRY(room_cut(&room, ROOM(unknown, a->n), ROOM(local, a->n),
                 ROOM(begin, f->part_count + 1)));
    for (int i = 0; i < a->n; i++)
        begin[f->part_of[i] + 1]++;
    for (int p = 0; p < f->part_count; p++)
        begin[p + 1] += begin[p];
    for (int i = 0; i < a->n; i++) { /* counting sort; part[].n counts up meanwhile */
        int p = f->part_of[i];
        local[i] = f->part[p].n++;
        unknown[begin[p] + local[i]] = i;
    }
    for (int p = 0; p < f->part_count; p++)
        TRY(create_part(f, p, a, method, unknown + begin[p], local));
    f->straight = true;
    for (int i = 0; i < a->n; i++)
        f->straight = f->straight && f->place[i] == i;
out:
    free(room);
    return st;
}

void factor_destroy(struct factor *f)
{
    if (!f)
        return;
    for (int p = 0; f->part && p < f->part_count; p++)
        if (f->part[p].method)
            f->part[p].method->destroy(&f->part[p]);
    free(f->part_room);
    free(f->room);
    free(f->value);
    free(f->work);
    free(f->work_three);
    free(f);
}

enum status factor_create(const struct factor_pattern *a, enum solver method,
                          struct factor **out)
{
    enum status st;
    struct factor *f = calloc(1, sizeof *f);

    if (!f)
        return STATUS_MEMORY;
    blas_kernel_set_threads(1);
    f->n = a->n; /* 0: held everywhere */
    TRY(room_cut(&f->room, ROOM(f->part_of, a->n), ROOM(f->place, a->n)));
    f->part_count = find_parts(a, f->place, f->part_of);
    TRY(room_cut(&f->part_room, ROOM(f->part, f->part_count),
                 ROOM(f->first_row, f->part_count + 1),
                 ROOM(f->first_slot, f->part_count + 1)));
    TRY(create_parts(f, a, method));
    f->value = factor_numbers(f->first_slot[f->part_count] + 1);
    f->work = factor_numbers(f->first_row[f->part_count]);
    st = f->value && f->work ? STATUS_OK : STATUS_MEMORY;
out:
    if (st == STATUS_OK)
        *out = f;
    else
        factor_destroy(f);
    return st;
}

/* --- values -----------------------------------------------------------------------------
 */

ptrdiff_t factor_slot(const struct factor *f, int i, int j)
{
    assert(0 <= i && i < f->n && 0 <= j && j < f->n && f->part_of[i] == f->part_of[j]);
    int p = f->part_of[i];
    int a = f->place[i] - f->first_row[p], b = f->place[j] - f->first_row[p];
    return f->first_slot[p] +
           f->part[p].method->slot(&f->part[p], a > b ? a : b, a > b ? b : a);
}

ptrdiff_t factor_dump(const struct factor *f)
{
    return f->first_slot[f->part_count];
}

double *factor_values(struct factor *f)
{
    return f->value;
}

void factor_clear_values(struct factor *f)
{
    memset(f->value, 0, (f->first_slot[f->part_count] + 1) * sizeof *f->value);
}

/* --- numbers ----------------------------------------------------------------------------
 */

/* Chooses the shift that makes floats of A large: products of what is only round-off, as
 * the couplings of a flat sheet's bending are, would take three times as long as denormals.
 */
static void choose_shift(struct factor *f)
{
    const int large = 60; /* exponent of the first pivot; floats reach 127 */
    int exponent = 0;

    frexp(isfinite(f->value[0]) ? f->value[0] : 0, &exponent);
    f->shift = (large - exponent) / 2 * 2;
}

enum status factor_refactor(struct factor *f)
{
    enum status st = STATUS_OK;
    float *narrow = NULL;
    f->ready = f->ready_three = false;
    if (f->single) {
        choose_shift(f);
        narrow = narrow_numbers(f->first_slot[f->part_count], ldexp(1, f->shift), f->value);
    }
    for (int p = 0; p < f->part_count; p++)
        TRY(narrow
                ? f->part[p].method->refactor_single(&f->part[p], narrow + f->first_slot[p])
                : f->part[p].method->refactor(&f->part[p], f->value + f->first_slot[p]));
    f->ready = true;
out:
    return st;
}

void factor_single(struct factor *f, bool single)
{
    f->single = single;
    for (int p = 0; p < f->part_count; p++)
        f->single = f->single && f->part[p].method->solve_single;
    f->ready = f->ready_three = false;
    memset(f->work, 0, f->first_row[f->part_count] * sizeof *f->work);
}

/* Solves in single precision. A power of two scales the right-hand side to the root of that
 * of A, so that floats represent it and the solution whatever their scales. */
static enum status solve_single(struct factor *f, double *b)
{
    enum status st = STATUS_OK;
    float *x = (float *)f->work;
    double most = 0;
    int scale = 0;
#pragma omp simd reduction(max : most)
    for (int i = 0; i < f->n; i++)
        most = fabs(b[i]) > most ? fabs(b[i]) : most;
    frexp(isfinite(most) ? most : 0, &scale);
    const double down = ldexp(1, f->shift / 2 - scale);
    const double up = ldexp(1, f->shift / 2 + scale);
    for (int i = 0; i < f->n; i++)
        x[f->straight ? i : f->place[i]] = (float)(b[i] * down);
    for (int p = 0; p < f->part_count; p++) {
        const struct factor_part *part = &f->part[p];
        float *own = x + f->first_row[p];
        TRY(part->method->solve_single(&f->part[p], (float *)f->value + f->first_slot[p],
                                       own));
        for (int i = part->n; i < f->first_row[p + 1] - f->first_row[p]; i++)
            own[i] = 0;
    }
    for (int i = 0; i < f->n; i++)
        b[i] = up * (double)x[f->straight ? i : f->place[i]];
out:
    return st;
}

enum status factor_solve(struct factor *f, double *b)
{
    enum status st = STATUS_OK;
    double *x = f->work;
    assert(f->ready);
    if (f->single)
        return solve_single(f, b);
    if (f->straight && f->n)
        memcpy(x, b, f->n * sizeof *x);
    for (int i = 0; !f->straight && i < f->n; i++)
        x[f->place[i]] = b[i];
    for (int p = 0; p < f->part_count; p++) {
        const struct factor_part *part = &f->part[p];
        double *own = x + f->first_row[p];
        TRY(part->method->solve(&f->part[p], f->value + f->first_slot[p], own));
        for (int i = part->n; i < f->first_row[p + 1] - f->first_row[p]; i++)
            own[i] = 0.0;
    }
    if (f->straight && f->n)
        memcpy(b, x, f->n * sizeof *x);
    for (int i = 0; !f->straight && i < f->n; i++)
        b[i] = x[f->place[i]];
out:
    return st;
}

static bool solves_three(const struct factor *f)
{
    bool can = !f->single;
    for (int p = 0; p < f->part_count; p++)
        can = can && f->part[p].method->solve_three;
    return can;
}

static enum status prepare_three(struct factor *f)
{
    enum status st = STATUS_OK;
    if (!f->work_three)
        f->work_three = factor_numbers((ptrdiff_t)SIDES * f->first_row[f->part_count]);
    if (!f->work_three)
        return STATUS_MEMORY;
    for (int p = 0; p < f->part_count; p++)
        TRY(f->part[p].method->prepare_three(&f->part[p], f->value + f->first_slot[p]));
    f->ready_three = true;
out:
    return st;
}

/* Copies to blocks: whole ones of eight rows at once, as far as no unknown moves. */
static void into_blocks(const struct factor *f, const double *b, ptrdiff_t stride,
                        double *x)
{
    int whole = f->straight ? f->n / TILE : 0;
    for (int t = 0; t < whole; t++)
        for (int c = 0; c < SIDES; c++)
            memcpy(x + t * BLOCK + c * TILE, b + c * stride + t * TILE, TILE * sizeof *x);
    for (int i = whole * TILE; i < f->n; i++)
        for (int c = 0; c < SIDES; c++)
            x[block_place(f->place[i]) + c * TILE] = b[c * stride + i];
}

static void from_blocks(const struct factor *f, const double *x, double *b,
                        ptrdiff_t stride)
{
    int whole = f->straight ? f->n / TILE : 0;
    for (int t = 0; t < whole; t++)
        for (int c = 0; c < SIDES; c++)
            memcpy(b + c * stride + t * TILE, x + t * BLOCK + c * TILE, TILE * sizeof *x);
    for (int i = whole * TILE; i < f->n; i++)
        for (int c = 0; c < SIDES; c++)
            b[c * stride + i] = x[block_place(f->place[i]) + c * TILE];
}

static void clear_padding(const struct factor *f, int p, double *own)
{
    for (int i = f->part[p].n; i < f->first_row[p + 1] - f->first_row[p]; i++)
        for (int c = 0; c < SIDES; c++)
            own[block_place(i) + c * TILE] = 0.0;
}

static enum status solve_three(struct factor *f, double *b, ptrdiff_t stride)
{
    enum status st = STATUS_OK;
    if (!f->ready_three)
        TRY(prepare_three(f));
    into_blocks(f, b, stride, f->work_three);
    for (int p = 0; p < f->part_count; p++) {
        double *own = f->work_three + (ptrdiff_t)SIDES * f->first_row[p];
        TRY(f->part[p].method->solve_three(&f->part[p], f->value + f->first_slot[p], own));
        clear_padding(f, p, own);
    }
    from_blocks(f, f->work_three, b, stride);
out:
    return st;
}

enum status factor_solve_many(struct factor *f, int count, double *b, ptrdiff_t stride)
{
    enum status st = STATUS_OK;
    assert(f->ready && count >= 0);
    for (; count >= SIDES && solves_three(f); count -= SIDES, b += SIDES * stride)
        TRY(solve_three(f, b, stride));
    for (; count > 0; count--, b += stride)
        TRY(factor_solve(f, b));
out:
    return st;
}

void factor_describe(const struct factor *f, struct factor_info *info)
{
    memset(info, 0, sizeof *info);
    info->parts = f->part_count;
    for (int p = 0; p < f->part_count; p++) {
        const char *name = f->part[p].method->name;
        info->method = !info->method || info->method == name ? name : "mixed";
        f->part[p].method->describe(&f->part[p], info);
    }
    info->bytes += (long)(f->n * (2 * sizeof(int) + sizeof(double)));
    info->bytes += (long)(f->first_slot[f->part_count] * sizeof(double));
}
