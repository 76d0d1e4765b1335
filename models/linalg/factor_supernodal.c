/* Multifrontal Cholesky on supernodes. CHOLMOD orders and analyses; the numbers are ours:
 * its kernels are made for columns longer than a cloth's, and its OpenMP loops ask for four
 * threads whatever the machine has.
 *
 * L lies supernode by supernode in tiles (struct front), in the values themselves: the
 * caller fills A in, the factorisation overwrites it. Pivots and rows are padded to whole
 * tiles, with ones on the diagonal. Updates on their way to the parent lie in one arena,
 * planned at set-up.
 */
#include <assert.h>
#include <cholmod.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/cholmod_status.h"
#include "models/linalg/factor.h"
#include "models/linalg/factor_part.h"
#include "models/linalg/tile.h"
#include "models/room.h"

struct supernode {
    int first, count;      /* its columns: positions first .. first + count            */
    int below;             /* rows below them                                          */
    int parent;            /* supernode of the first row below, or -1                  */
    int pivots, tiles;     /* tiles of columns, of columns and rows                    */
    const int *row;        /* [below] positions, ascending                   borrowed  */
    const int *place;      /* [below] places in the parent's front, see front_add      */
    ptrdiff_t lower;       /* where its L starts in the values                         */
    ptrdiff_t update;      /* where its update starts in the arena                     */
    ptrdiff_t update_size; /* numbers                                                  */
    int first_child, next; /* lists, -1 at the end                                     */
};

struct supernodal {
    void *room;             /* memory of nodes, rows and places                        */
    int count;              /* supernodes, children before parents                     */
    struct supernode *node; /* [count]                                                 */
    int *of_column;         /* [n]                                                     */
    int *row, *place;       /* all nodes' rows and places                              */
    double *arena;
    ptrdiff_t arena_size;
    double *inverse; /* [rows padded, node by node at inverse_start]                   */
    ptrdiff_t *inverse_start; /* [count]                                               */
    void **column; /* [most tiles of a front]                                        */
    double *x;     /* [most tiles * TILE]                                            */
    double flops;
    int most_tiles;
};

/* --- CHOLMOD: order and symbolic factorisation ------------------------------------------
 */

/* Returns the pattern with unknown i moved to position[i]; lower triangle. */
static cholmod_sparse *permuted_pattern(const struct factor_pattern *a, const int *position,
                                        cholmod_common *c)
{
    long entries = a->start[a->n];
    cholmod_triplet *t =
        cholmod_allocate_triplet(a->n, a->n, entries, -1, CHOLMOD_PATTERN, c);
    cholmod_sparse *lower = NULL;
    if (t) {
        int *i = t->i, *j = t->j;
        long end = 0;
        for (int col = 0; col < a->n; col++)
            for (long s = a->start[col]; s < a->start[col + 1]; s++, end++) {
                int p = position[a->row[s]], q = position[col];
                i[end] = p > q ? p : q;
                j[end] = p > q ? q : p;
            }
        t->nnz = entries;
        lower = cholmod_triplet_to_sparse(t, entries, c);
    }
    cholmod_free_triplet(&t, c);
    return lower;
}

static cholmod_factor *analyse_by(cholmod_sparse *lower, const int *order, int first,
                                  int second, cholmod_common *c)
{
    c->nmethods = 2; /* CHOLMOD takes the one with fewer entries in L */
    c->method[0].ordering = first;
    c->method[1].ordering = second;
    return cholmod_analyze_p(lower, (int *)order, NULL, 0, c);
}

/* Finds position[n] and the supernodes *l: the best of AMD's order, METIS's and the given
 * one; METIS, which takes longest, is not tried where the given one beats AMD. */
static enum status analyse(const struct factor_pattern *a, int *position,
                           cholmod_factor **l, cholmod_common *c)
{
    for (int k = 0; k < a->n; k++)
        position[k] = k;
    cholmod_sparse *lower = permuted_pattern(a, position, c);
    c->postorder = 1;
    c->supernodal = CHOLMOD_SUPERNODAL;
    /* Supernodes merge up to these widths while at most this share of them is zeros: tiles
     * of 8 like wider ones than CHOLMOD's defaults (4, 16, 48; 0.8, 0.1, 0.05). */
    c->nrelax[0] = 12, c->nrelax[1] = 32, c->nrelax[2] = 64;
    c->zrelax[0] = 0.8, c->zrelax[1] = 0.2, c->zrelax[2] = 0.05;
    if (lower && a->order)
        *l = analyse_by(lower, a->order, CHOLMOD_GIVEN, CHOLMOD_AMD, c);
    if (*l && (*l)->ordering != CHOLMOD_GIVEN)
        cholmod_free_factor(l, c);
    if (lower && !*l)
        *l = analyse_by(lower, NULL, CHOLMOD_AMD, CHOLMOD_METIS, c);
    for (int k = 0; *l && k < a->n; k++)
        position[((int *)(*l)->Perm)[k]] = k;
    cholmod_free_sparse(&lower, c);
    return *l ? cholmod_status(c) : STATUS_MEMORY;
}

/* --- our own analysis -------------------------------------------------------------------
 */

static void link_node(struct supernodal *s, int k)
{
    struct supernode *node = &s->node[k];
    node->parent = node->below ? s->of_column[node->row[0]] : -1;
    node->first_child = node->next = -1;
    node->pivots = (node->count + TILE - 1) / TILE;
    node->tiles = node->pivots + (node->below + TILE - 1) / TILE;
    ptrdiff_t rest = node->tiles - node->pivots;
    node->update_size = rest * (rest + 1) / 2 * TILE_SIZE;
    s->most_tiles = node->tiles > s->most_tiles ? node->tiles : s->most_tiles;
    for (int i = 0; i < node->count; i++)
        s->flops += (double)(node->below + i + 1) * (node->below + i + 1);
}

/* Returns the row of a position in the front of `node`; binary search below the pivots. */
static int row_in_front(const struct supernode *node, int position)
{
    if (position < node->first + node->count)
        return position - node->first;
    int low = 0, high = node->below;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (node->row[middle] <= position)
            low = middle;
        else
            high = middle;
    }
    assert(node->below > 0 && node->row[low] == position);
    return node->pivots * TILE + low;
}

static void place_in_parents(struct supernodal *s)
{
    for (int k = s->count - 1; k >= 0; k--) { /* backwards: child lists come ascending */
        struct supernode *node = &s->node[k];
        int *place = s->place + (node->row - s->row);
        node->place = place;
        if (node->parent < 0)
            continue;
        struct supernode *parent = &s->node[node->parent];
        node->next = parent->first_child;
        parent->first_child = k;
        for (int i = 0; i < node->below; i++) {
            int row = row_in_front(parent, node->row[i]);
            place[i] = row / TILE * TILE_SIZE + row % TILE;
        }
    }
}

/* Places updates in the arena; each lives from its node's turn to its parent's. First fit:
 * live[] holds the nodes whose updates are in the arena, by place. */
static void plan_arena(struct supernodal *s, int *live)
{
    int count = 0;
    for (int k = 0; k < s->count; k++) {
        struct supernode *node = &s->node[k];
        ptrdiff_t place = 0;
        int at = 0;
        for (; at < count; at++) {
            const struct supernode *other = &s->node[live[at]];
            if (other->update - place >= node->update_size)
                break;
            place = other->update + other->update_size;
        }
        node->update = place;
        if (place + node->update_size > s->arena_size)
            s->arena_size = place + node->update_size;
        memmove(live + at + 1, live + at, (count - at) * sizeof *live);
        live[at] = k;
        int kept = 0;
        for (int i = 0; i <= count; i++) /* its children are read by now */
            if (s->node[live[i]].parent != k && s->node[live[i]].update_size > 0)
                live[kept++] = live[i];
        count = kept;
    }
}

static enum status take_supernodes(struct supernodal *s, const cholmod_factor *l)
{
    enum status st;
    const int *super = l->super, *pi = l->pi;
    s->count = (int)l->nsuper;
    TRY(room_cut(&s->room, ROOM(s->node, s->count), ROOM(s->of_column, l->n),
                 ROOM(s->row, l->ssize), ROOM(s->place, l->ssize),
                 ROOM(s->inverse_start, s->count)));
    memcpy(s->row, l->s, l->ssize * sizeof *s->row);
    for (int k = 0; k < s->count; k++) {
        struct supernode *node = &s->node[k];
        node->first = super[k];
        node->count = super[k + 1] - super[k];
        node->below = pi[k + 1] - pi[k] - node->count;
        node->row = s->row + pi[k] + node->count;
        for (int i = 0; i < node->count; i++)
            s->of_column[node->first + i] = k;
    }
out:
    return st;
}

static enum status lay_out(struct supernodal *s, ptrdiff_t *slots)
{
    int *live = malloc((s->count + 1) * sizeof *live);
    ptrdiff_t end = 0, inverse_end = 0;
    if (!live)
        return STATUS_MEMORY;
    for (int k = 0; k < s->count; k++) {
        struct supernode *node = &s->node[k];
        link_node(s, k);
        ptrdiff_t p = node->pivots;
        node->lower = end;
        end += (p * node->tiles - p * (p - 1) / 2) * TILE_SIZE;
        s->inverse_start[k] = inverse_end;
        inverse_end += p * TILE;
    }
    *slots = end;
    place_in_parents(s);
    plan_arena(s, live);
    free(live);
    s->arena = factor_numbers(s->arena_size);
    s->inverse = factor_numbers(inverse_end);
    s->x = factor_numbers((ptrdiff_t)s->most_tiles * TILE);
    s->column = malloc(s->most_tiles * sizeof *s->column);
    return s->arena && s->inverse && s->x && s->column ? STATUS_OK : STATUS_MEMORY;
}

static enum status create(const struct factor_pattern *a, int *position,
                          struct factor_part *part)
{
    enum status st;
    cholmod_common common;
    cholmod_factor *l = NULL;
    struct supernodal *s = part->state = calloc(1, sizeof *s);
    if (!s)
        return STATUS_MEMORY;
    cholmod_start(&common);
    common.print = 0;
    TRY(analyse(a, position, &l, &common));
    TRY(take_supernodes(s, l));
    TRY(lay_out(s, &part->slots));
    part->rows = part->n;
out:
    cholmod_free_factor(&l, &common);
    cholmod_finish(&common);
    return st;
}

/* --- numbers ----------------------------------------------------------------------------
 */

static ptrdiff_t tile_start(const struct supernode *node, int row, int column)
{
    ptrdiff_t k = column;
    return node->lower + (k * node->tiles - k * (k - 1) / 2 + row - column) * TILE_SIZE;
}

static ptrdiff_t slot(const struct factor_part *part, int i, int j)
{
    const struct supernodal *s = part->state;
    const struct supernode *node = &s->node[s->of_column[j]];
    int row = row_in_front(node, i), column = j - node->first;
    return tile_start(node, row / TILE, column / TILE) + column % TILE * TILE + row % TILE;
}

/* A dense front: a lower triangle of tiles x tiles tiles, of which the first `pivots`
 * columns of tiles are factored and the rest (the update, for the parent) gets minus their
 * product. Tile (i,j), i >= j, lies at column[j] + i * TILE_SIZE. Tiles on the diagonal
 * hold anything above it. */
struct front {
    int pivots, tiles;
    void **column; /* [tiles] to doubles, or floats                                    */
    void *inverse; /* [pivots * 8] reciprocals of the diagonal of L, written           */
};

/* Pivot tiles a panel: three of its tile rows (18 kB) and one more fit the first cache. */
enum { PANEL = 12 };

#define REAL       double
#define NAME(name) name
#include "models/linalg/front_kernel.h"
#include "models/linalg/factor_supernodal_kernel.h"
#undef REAL
#undef NAME
#define REAL       float
#define NAME(name) name##_single
#include "models/linalg/front_kernel.h"
#include "models/linalg/factor_supernodal_kernel.h"
#undef REAL
#undef NAME

static void describe(const struct factor_part *part, struct factor_info *info)
{
    const struct supernodal *s = part->state;
    info->entries += (long)part->slots;
    info->flops += s->flops;
    info->bytes += (long)(s->arena_size * sizeof *s->arena + s->count * sizeof *s->node +
                          part->n * (sizeof(int) + sizeof(double)));
}

static void destroy(struct factor_part *part)
{
    struct supernodal *s = part->state;
    if (!s)
        return;
    free(s->room);
    free(s->arena);
    free(s->inverse);
    free(s->column);
    free(s->x);
    free(s);
    part->state = NULL;
}

const struct factor_method factor_supernodal = {
    "supernodal", create,          slot,         refactor, solve,  NULL,
    NULL,         refactor_single, solve_single, describe, destroy};
