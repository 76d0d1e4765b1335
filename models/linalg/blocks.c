#include "models/linalg/blocks.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* Lists the elements around each node: e of node a in list[first[a] .. first[a+1]). */
static enum status elements_of_nodes(int nodes, int elements, const long *start,
                                     const int *ien, long **first, int **list)
{
    const long total = start[elements];
    long *f = *first = calloc((size_t)nodes + 2, sizeof *f);
    int *l = *list = malloc((size_t)total * sizeof *l + 1);

    if (!f || !l)
        return STATUS_MEMORY;
    for (long t = 0; t < total; t++)
        f[ien[t] + 2]++;
    for (int a = 0; a < nodes; a++)
        f[a + 2] += f[a + 1];
    for (int e = 0; e < elements; e++)
        for (long t = start[e]; t < start[e + 1]; t++)
            l[f[ien[t] + 1]++] = e;
    return STATUS_OK;
}

static int ascending(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Collects the neighbours b >= a of one node; mark[b] == a says that b is there already. */
static int collect_row(int a, const long *start, const int *ien, const long *first,
                       const int *list, int *mark, int *row)
{
    int count = 0;

    for (long t = first[a]; t < first[a + 1]; t++)
        for (long s = start[list[t]]; s < start[list[t] + 1]; s++)
            if (ien[s] >= a && mark[ien[s]] != a)
                mark[row[count++] = ien[s]] = a;
    if (!count)
        row[count++] = a; /* a node of no element still has its diagonal */
    qsort(row, (size_t)count, sizeof *row, ascending);
    return count;
}

void blocks_clear(struct blocks *g)
{
    free(g->start);
    free(g->node);
    memset(g, 0, sizeof *g);
}

enum status blocks_init_uneven(struct blocks *g, int nodes, int elements, const long *start,
                               const int *ien)
{
    enum status st;
    long *first = NULL, capacity = 64L * nodes, pairs = 0;
    int *list = NULL, *mark, *row;
    void *work = NULL;
    struct blocks new = {.nodes = nodes};

    TRY(room_cut(&work, ROOM(mark, nodes), ROOM(row, nodes)));
    new.start = malloc(((size_t)nodes + 1) * sizeof *new.start);
    new.node = malloc((size_t)capacity * sizeof *new.node);
    TRY(new.start &&new.node ? STATUS_OK : STATUS_MEMORY);
    TRY(elements_of_nodes(nodes, elements, start, ien, &first, &list));
    memset(mark, -1, (size_t)nodes * sizeof *mark);
    for (int a = 0; a < nodes; a++) {
        int count = collect_row(a, start, ien, first, list, mark, row);
        if (pairs + count > capacity) {
            capacity = 2 * (pairs + count);
            int *more = realloc(new.node, (size_t)capacity * sizeof *more);
            TRY(more ? STATUS_OK : STATUS_MEMORY);
            new.node = more;
        }
        new.start[a] = pairs;
        memcpy(new.node + pairs, row, (size_t)count * sizeof *row);
        pairs += count;
    }
    new.start[nodes] = pairs;
    HAND_OVER(g, new);
out:
    blocks_clear(&new);
    free(first);
    free(list);
    free(work);
    return st;
}

enum status blocks_init(struct blocks *g, int nodes, int elements, int local,
                        const int *ien)
{
    enum status st = STATUS_MEMORY;
    long *start = malloc(((size_t)elements + 1) * sizeof *start);

    for (int e = 0; start && e <= elements; e++)
        start[e] = (long)e * local;
    if (start)
        st = blocks_init_uneven(g, nodes, elements, start, ien);
    free(start);
    return st;
}

long blocks_find(const struct blocks *g, int a, int b)
{
    long low = g->start[a], high = g->start[a + 1];

    assert(a <= b);
    while (low < high) {
        long middle = (low + high) / 2;
        if (g->node[middle] < b)
            low = middle + 1;
        else
            high = middle;
    }
    return low < g->start[a + 1] && g->node[low] == b ? low : -1;
}

enum status blocks_places(const struct blocks *g, int elements, int local, int run,
                          const int *ien, int **place)
{
    int runs = local / run;
    int *p = malloc((size_t)elements * (size_t)(local * runs) * sizeof *p);

    if (!(*place = p) || g->start[g->nodes] > INT_MAX / 9)
        return STATUS_MEMORY;
    for (int e = 0; e < elements; e++, ien += local, p += local * runs)
        for (int a = 0; a < local; a++)
            for (int r = a / run; r < runs; r++) {
                int first = r * run > a ? r * run : a;
                p[a * runs + r] = (int)blocks_find(g, ien[a], ien[first]);
            }
    return STATUS_OK;
}

enum status blocks_slabs(int elements, int per_column, int wide, int *slabs, int **slab)
{
    int columns = elements / per_column;

    *slabs = (columns + wide - 1) / wide;
    *slab = malloc(((size_t)*slabs + 1) * sizeof **slab);
    if (!*slab)
        return STATUS_MEMORY;
    for (int s = 0; s < *slabs; s++)
        (*slab)[s] = s * wide * per_column;
    (*slab)[*slabs] = elements;
    return STATUS_OK;
}

double blocks_longest(int nodes, const double *x)
{
    double most = 0;

    for (int a = 0; a < nodes; a++, x += 3) {
        double far = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
        if (!(far <= most))
            most = far;
    }
    return sqrt(most);
}

/* Three numbers of a node, the fourth idle; in memory they may lie anywhere. */
typedef double four __attribute__((vector_size(4 * sizeof(double))));
typedef double two_there __attribute__((vector_size(2 * sizeof(double)), aligned(8)));
typedef double four_there __attribute__((vector_size(4 * sizeof(double)), aligned(8)));
typedef double eight_there __attribute__((vector_size(8 * sizeof(double)), aligned(8)));

static inline four load(const double *x)
{
    const two_there low = *(const two_there *)x;

    return (four){low[0], low[1], x[2], x[2]};
}

static inline void store(four x, double *to)
{
    *(two_there *)to = __builtin_shufflevector(x, x, 0, 1);
    to[2] = x[2];
}

void blocks_multiply(const struct blocks *g, const double (*K)[9], const double *x,
                     double *y)
{
    memset(y, 0, 3 * (size_t)g->nodes * sizeof *y);
    for (int a = 0; a < g->nodes; a++) {
        const double *xa = x + 3 * (size_t)a;
        long n = g->start[a];
        four s = {0};

        for (; n < g->start[a + 1]; n++) {
            const double *xb = x + 3 * (size_t)g->node[n];
            double *yb = y + 3 * (size_t)g->node[n];
            const eight_there k = *(const eight_there *)K[n],
                              l = *(const eight_there *)(K[n] + 1);
            const four_there first = *(const four_there *)K[n],
                             second = *(const four_there *)(K[n] + 3);
#define PICK(from, i, j, k) __builtin_shufflevector(from, from, i, j, k, k)
            s += PICK(k, 0, 3, 6) * xb[0] + PICK(k, 1, 4, 7) * xb[1] +
                 PICK(l, 1, 4, 7) * xb[2];
            if (n > g->start[a])
                store(load(yb) +
                          (first * xa[0] + second * xa[1] + PICK(l, 5, 6, 7) * xa[2]),
                      yb);
#undef PICK
        }
        store(load(y + 3 * (size_t)a) + s, y + 3 * (size_t)a);
    }
}

void blocks_multiply_mass(const struct blocks *g, const double *M, const double *x,
                          double *y)
{
    memset(y, 0, 3 * (size_t)g->nodes * sizeof *y);
    for (int a = 0; a < g->nodes; a++) {
        const double *xa = x + 3 * (size_t)a;
        long n = g->start[a];
        double s[3] = {M[n] * xa[0], M[n] * xa[1], M[n] * xa[2]};

        for (n++; n < g->start[a + 1]; n++) {
            const double *xb = x + 3 * (size_t)g->node[n];
            double *yb = y + 3 * (size_t)g->node[n];
            for (int i = 0; i < 3; i++) {
                s[i] += M[n] * xb[i];
                yb[i] += M[n] * xa[i];
            }
        }
        for (int i = 0; i < 3; i++)
            y[3 * (size_t)a + i] += s[i];
    }
}

bool blocks_invert(const double A[9], const int place[3], double out[9])
{
    double l[3][6];

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            bool held = place[i] < 0;
            l[i][j] = held ? i == j : A[3 * i + j];
            l[i][3 + j] = !held && i == j;
        }
    for (int k = 0; k < 3; k++) {
        double pivot = l[k][k];
        if (!(pivot > 0 && pivot < INFINITY))
            return false;
        for (int j = 0; j < 6; j++)
            l[k][j] /= pivot;
        for (int i = 0; i < 3; i++) {
            double part = l[i][k];
            for (int j = 0; i != k && j < 6; j++)
                l[i][j] -= part * l[k][j];
        }
    }
    for (int t = 0; t < 9; t++)
        out[t] = l[t / 3][3 + t % 3];
    return true;
}
