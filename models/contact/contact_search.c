#include "models/contact/contact_search.h"

#include <stdlib.h>

#include "models/contact/contact_foot.h"
#include "models/contact/contact_tree.h"
#include "models/each.h"
#include "models/room.h"
#include "models/vector.h"

/* A triangle near a sample, and how near it was when it was found, at least [m]. */
struct contact_near {
    int sample, triangle;
    float distance;
};

struct contact_pair {
    int cell, other;
};

/* Samples or pairs of cells from which threads are worth their start; of a piece. */
enum { PARALLEL = 1000, PIECE = 64, FIRST_ROOM = 1024 };

/* Margin over start: start and margin stay below the distance along the sheet from which
 * pairs count, so that flat parts have nothing near. */
static const double margin_share = 0.3;
/* A share of start that rounding can't reach. */
static const double rounding = 1e-9;
/* A share of a distance that is less than it in single precision, too. */
static const double less = 1 - 1e-7;
static const double half_pi = 1.5707963267948966;

void contact_search_clear(struct contact_search *s)
{
    contact_tree_clear(&s->tree);
    free(s->near);
    free(s->pair);
    free(s->room);
    memset(s, 0, sizeof *s);
}

static bool samples_are_nodes(const struct contact_surface *s)
{
    if (s->width != 1)
        return false;
    for (int n = 0; n < s->count; n++)
        if (s->node[n] != n || s->shape[n] != 1)
            return false;
    return true;
}

enum status contact_search_init(struct contact_search *s,
                                const struct contact_surface *surface, double start)
{
    enum status st = STATUS_OK;
    const size_t count = surface->count, width = contact_foot_width(surface);

    *s = (struct contact_search){.sheet = {.surface = surface, .start = start},
                                 .start = start,
                                 .margin = margin_share * start,
                                 .plain = samples_are_nodes(surface),
                                 .stale = true};
    TRY(contact_tree_init(&s->tree, surface, half_pi * start));
    s->sheet.tree = &s->tree;
    TRY(room_cut(&s->room, ROOM(s->own, s->plain ? 0 : 3 * count), ROOM(s->kept, 3 * count),
                 ROOM(s->normal, 3 * count), ROOM(s->wanted, count),
                 ROOM(s->first, count + 1), ROOM(s->active, count), ROOM(s->side, count),
                 ROOM(s->found, count / PIECE + 1), ROOM(s->foot, 2 * count),
                 ROOM(s->node, 2 * count * width), ROOM(s->weight, 2 * count * width)));
    s->sheet.normal = s->normal;
out:
    if (st)
        contact_search_clear(s);
    return st;
}

/* Makes room for `count` elements of an array that may move; `array` is the address of its
 * pointer. */
static enum status grow(void *array, size_t size, long count, long *room)
{
    const long more = 2 * count > FIRST_ROOM ? 2 * count : FIRST_ROOM;
    void *all;

    if (count <= *room)
        return STATUS_OK;
    memcpy(&all, array, sizeof all); /* a pointer of any type */
    all = realloc(all, more * size);
    if (!all)
        return STATUS_MEMORY;
    memcpy(array, &all, sizeof all);
    *room = more;
    return STATUS_OK;
}

/* A vector at the nodes, x, and at the samples. */
struct vectors {
    const struct contact_surface *surface;
    const double *x;
    double *own;
};

static void at_sample(void *self, long n)
{
    const struct vectors *v = self;

    contact_surface_at(v->surface, (int)n, v->x, v->own + 3 * n);
}

/* Computes a vector at the samples from the nodes'. */
static const double *at_samples(const struct contact_search *s, const double *x,
                                double *own)
{
    struct vectors v = {s->sheet.surface, x, own};

    if (s->plain)
        return x;
    each_turn(v.surface->count, v.surface->count >= PARALLEL, at_sample, &v);
    return own;
}

/* Returns how far samples have moved since triangles were found, at most, less a common
 * shift: half the diagonal of the box around their ways. NaN if a place is not finite. */
static double moved(const struct contact_search *s)
{
    const long count = s->sheet.surface->count;
    const double *y = s->sheet.y, *old = s->kept;
    double way[3], none = 0;

    vector_between(old, y, way);
    double la = way[0], lb = way[1], lc = way[2], ha = la, hb = lb, hc = lc;
#pragma omp simd reduction(min : la, lb, lc) reduction(max : ha, hb, hc) reduction(+ : none)
    for (long n = 0; n < count; n++) {
        const double a = y[3 * n] - old[3 * n];
        const double b = y[3 * n + 1] - old[3 * n + 1];
        const double c = y[3 * n + 2] - old[3 * n + 2];
        la = a < la ? a : la, ha = a > ha ? a : ha;
        lb = b < lb ? b : lb, hb = b > hb ? b : hb;
        lc = c < lc ? c : lc, hc = c > hc ? c : hc;
        none += 0 * (a + b + c);
    }
    way[0] = ha - la, way[1] = hb - lb, way[2] = hc - lc;
    return vector_length(way) / 2 + rounding * s->start + none;
}

/* Places the samples; computes how far they have moved. */
static enum status place_samples(struct contact_search *s, const double *x, double *way)
{
    s->sheet.x = x, s->sheet.y = at_samples(s, x, s->own);
    *way = moved(s);
    return isfinite(*way) ? STATUS_OK : STATUS_NAN;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static bool has_corner(const struct contact_search *s, int triangle, int sample)
{
    int corner[3];

    contact_foot_corners(s->sheet.surface, triangle, corner);
    return corner[0] == sample || corner[1] == sample || corner[2] == sample;
}

/* Tells whether a triangle is of no use to a sample: it is its corner, or all of the
 * triangle is too near along the sheet. */
static bool useless(const struct contact_search *s, int sample, const int corner[3])
{
    if (corner[0] == sample || corner[1] == sample || corner[2] == sample)
        return true;
    for (int k = 0; k < 3; k++) {
        double share[3] = {0};
        share[k] = 1;
        if (!contact_tree_near(&s->tree, s->tree.apart, sample, corner, share))
            return false;
    }
    return true;
}

/* Triangles that are near samples. */
struct sieve {
    int count;
    struct contact_near near[16 * PIECE]; /* of pairs of cells */
};

/* Keeps a triangle if it is near a sample. */
static void sift(const struct contact_search *s, int sample, int triangle,
                 const int corner[3], struct sieve *v)
{
    struct contact_face face = contact_foot_face(s->sheet.y, sample, corner);

    contact_face_nearest(&face);
    const double distance = sqrt(face.square);
    v->near[v->count] = (struct contact_near){sample, triangle, (float)(less * distance)};
    v->count += distance < s->start + s->margin;
}

/* Tells whether a sample is outside the box of a cell's corners by so much. */
static bool outside(const struct contact_search *s, int sample, const int corner[4],
                    double reach)
{
    const double *all = s->sheet.y, *y = all + 3 * (long)sample;
    const double *p = all + 3 * (long)corner[0], *q = all + 3 * (long)corner[1];
    const double *r = all + 3 * (long)corner[2], *t = all + 3 * (long)corner[3];
    for (int i = 0; i < 3; i++)
        if (y[i] < smaller(smaller(p[i], q[i]), smaller(r[i], t[i])) - reach ||
            y[i] > larger(larger(p[i], q[i]), larger(r[i], t[i])) + reach)
            return true;
    return false;
}

/* Looks at the triangles of a cell for the samples of another. */
static void look_at(const struct contact_search *s, int samples, int cell, struct sieve *v)
{
    int sample[4], end[4];
    const int many = contact_tree_samples(&s->tree, samples, sample);
    const int first = contact_tree_triangle(&s->tree, cell);
    const int triangles = contact_tree_triangles(&s->tree);

    contact_tree_corners(&s->tree, cell, end);
    for (int n = 0; n < many; n++)
        for (int k = 0; k < triangles && !outside(s, sample[n], end, s->start + s->margin);
             k++) {
            int corner[3];
            contact_foot_corners(s->sheet.surface, first + k, corner);
            if (!useless(s, sample[n], corner))
                sift(s, sample[n], first + k, corner, v);
        }
}

static enum status keep_pair(struct contact_tree_search *search, int cell, int other)
{
    struct contact_search *s = search->context;
    const enum status st =
        grow(&s->pair, sizeof *s->pair, s->pair_count + 1, &s->pair_room);

    if (st == STATUS_OK)
        s->pair[s->pair_count++] = (struct contact_pair){cell, other};
    return st;
}

/* Finds near triangles of a piece of the pairs of cells. */
static void test_piece(void *search, long piece)
{
    struct contact_search *s = search;
    struct sieve v;

    v.count = 0;
    for (long n = piece * PIECE; n < (piece + 1) * PIECE && n < s->pair_count; n++) {
        const struct contact_pair *p = &s->pair[n];
        look_at(s, p->cell, p->other, &v);
        if (p->cell != p->other)
            look_at(s, p->other, p->cell, &v);
    }
    if (v.count)
#pragma omp critical
    {
        const enum status more =
            grow(&s->near, sizeof *s->near, s->near_count + v.count, &s->near_room);
        if (more == STATUS_OK)
            memcpy(s->near + s->near_count, v.near, v.count * sizeof *v.near);
        s->near_count += more == STATUS_OK ? v.count : 0;
        s->failed = s->failed ? s->failed : more;
    }
}

/* Finds near triangles of all pairs of cells, in no order. */
static enum status test_pairs(struct contact_search *s)
{
    s->near_count = 0;
    s->failed = STATUS_OK;
    each_turn((s->pair_count + PIECE - 1) / PIECE, s->pair_count >= PARALLEL, test_piece,
              s);
    return s->failed;
}

static bool nearer(const struct contact_near *a, const struct contact_near *b)
{
    return a->distance < b->distance ||
           (a->distance == b->distance && a->triangle < b->triangle);
}

/* Sorts near triangles by sample and then by distance: by counts, then by insertion. */
static enum status sort_near(struct contact_search *s)
{
    const int samples = s->sheet.surface->count;
    int *first = s->first;
    struct contact_near *sorted = malloc((s->near_count + 1) * sizeof *sorted);

    if (!sorted)
        return STATUS_MEMORY;
    memset(first, 0, (samples + 1L) * sizeof *first);
    for (long n = 0; n < s->near_count; n++)
        first[s->near[n].sample + 1]++;
    s->actives = 0;
    for (int n = 0; n < samples; n++) {
        if (first[n + 1])
            s->active[s->actives++] = n;
        first[n + 1] += first[n];
    }
    for (long n = 0; n < s->near_count; n++)
        sorted[first[s->near[n].sample]++] = s->near[n];
    memmove(first + 1, first, samples * sizeof *first); /* each is now the next one's */
    first[0] = 0;
    for (int n = 0; n < s->actives; n++)
        for (int k = first[s->active[n]] + 1; k < first[s->active[n] + 1]; k++) {
            const struct contact_near near = sorted[k];
            int to = k;
            for (; to > first[s->active[n]] && nearer(&near, &sorted[to - 1]); to--)
                sorted[to] = sorted[to - 1];
            sorted[to] = near;
        }
    free(s->near);
    s->near = sorted, s->near_room = s->near_count;
    return STATUS_OK;
}

/* Marks the samples whose normals are needed. */
static void mark_wanted(struct contact_search *s)
{
    memset(s->wanted, 0, s->sheet.surface->count * sizeof *s->wanted);
    for (long n = 0; n < s->near_count; n++) {
        int corner[3];
        contact_foot_corners(s->sheet.surface, s->near[n].triangle, corner);
        s->wanted[s->near[n].sample] = true;
        for (int k = 0; k < 3; k++)
            s->wanted[corner[k]] = true;
    }
}

static void find_row(void *search, long i)
{
    struct contact_search *s = search;

    contact_foot_normals(&s->sheet, (int)i, s->wanted, s->normal);
}

static void find_normals(struct contact_search *s)
{
    each_turn(s->sheet.surface->points[0], s->actives >= PARALLEL, find_row, s);
}

/* Returns by how much samples may move against each other, up to the margin, before a near
 * triangle of a sample can get to its other side, negative if the side is above; 0: it
 * isn't known. Then a way between samples is longer by as much, differences of neighbours,
 * too, which turns the normal, and the product of both changes by less than by `rate`. */
static double side_of(const struct contact_search *s, int sample)
{
    const struct contact_surface *f = s->sheet.surface;
    const int m = f->points[1], i = sample / m % f->rows, j = sample % m;
    const double *y = s->sheet.y + 3 * (long)sample, *n = s->normal + 3 * (long)sample;
    double u[3], v[3], low = INFINITY, high = -INFINITY, far = 0, turn;

    if (!f->mesh.count && (i == 0 || i + 1 == f->rows || j == 0 || j + 1 == m))
        return 0;
    for (int k = s->first[sample]; k < s->first[sample + 1]; k++) {
        int corner[3];
        contact_foot_corners(f, s->near[k].triangle, corner);
        for (int c = 0; c < 3; c++) {
            double way[3];
            vector_between(s->sheet.y + 3 * (long)corner[c], y, way);
            const double along = vector_dot(way, n);
            low = smaller(low, along), high = larger(high, along);
            far = larger(far, vector_dot(way, way));
        }
        if (low <= 0 && high >= 0)
            return 0;
    }
    if (f->mesh.count) {
        turn = mesh_cells_turn(&f->mesh, s->sheet.y, sample, s->margin);
    } else {
        vector_between(y - 3 * (long)m, y + 3 * (long)m, u);
        vector_between(y - 3, y + 3, v);
        turn = vector_length(u) + vector_length(v) + s->margin;
    }
    const double rate = (sqrt(far) + s->margin) * turn + vector_length(n);
    return (low > 0 ? low : high) / rate;
}

static void find_side(void *search, long n)
{
    struct contact_search *s = search;

    s->side[n] = (float)(less * side_of(s, s->active[n]));
}

/* Finds near triangles again. */
static enum status seek(struct contact_search *s)
{
    enum status st = STATUS_OK;
    struct contact_tree_search search = {s->start + s->margin, 0, s, keep_pair};

    s->sought++;
    s->pair_count = 0;
    contact_tree_fit(&s->tree, s->sheet.y, NULL);
    TRY(contact_tree_visit(&s->tree, &search));
    TRY(test_pairs(s));
    TRY(sort_near(s));
    mark_wanted(s);
    find_normals(s);
    each_turn(s->actives, s->actives >= PARALLEL, find_side, s);
    memcpy(s->kept, s->sheet.y, 3 * (size_t)s->sheet.surface->count * sizeof *s->kept);
out:
    s->stale = st != STATUS_OK;
    return st;
}

/* Refines what was found of `count` samples, those in use from the first on, into feet;
 * returns how many there are. */
static int finish(const struct contact_search *s, int first, int count,
                  const struct contact_place (*best)[2], struct contact_foot *foot)
{
    const int width = contact_foot_width(s->sheet.surface), from = 2 * first;
    const struct contact_place *found[2 * PIECE];
    int places = 0, feet = 0;

    for (int k = 0; k < 2 * count; k++)
        if (best[k / 2][k % 2].triangle >= 0)
            found[places++] = &best[k / 2][k % 2];
    contact_foot_refine(&s->sheet, places, found, foot, s->node + (long)from * width,
                        s->weight + (long)from * width);
    for (int k = 0; k < places; k++) {
        foot[k].first = (from + k) * width;
        if (feet != k)
            foot[feet] = foot[k];
        feet += foot[k].distance < s->start && foot[k].strength > 0;
    }
    return feet;
}

/* Considers all cells for a sample. */
static void consider_all(const struct contact_search *s, int sample,
                         struct contact_place best[2])
{
    const struct contact_surface *f = s->sheet.surface;
    const int *n = s->tree.level[0].n, cells = n[0] * n[1];

    for (int cell = 0; cell < cells; cell++) {
        const int triangle = contact_tree_triangle(&s->tree, cell);
        int end[4];
        contact_tree_corners(&s->tree, cell, end);
        if (outside(s, sample, end, s->start) || contact_surface_cut(f, cell / n[1]))
            continue;
        for (int k = triangle; k < triangle + contact_tree_triangles(&s->tree); k++)
            if (!has_corner(s, k, sample))
                contact_foot_consider(&s->sheet, sample, k, best);
    }
}

/* Considers the near triangles of a sample that may be the closest, the nearest first;
 * samples have moved by `way` at most. */
static void consider_near(const struct contact_search *s, int sample, double way,
                          struct contact_place best[2])
{
    const struct contact_near *near = s->near + s->first[sample];
    const struct contact_near *end = s->near + s->first[sample + 1];

    for (; near < end; near++) {
        const double least = larger(near->distance - 2 * way, 0);
        if (least * least > larger(best[0].square, best[1].square))
            break;
        contact_foot_consider(&s->sheet, sample, near->triangle, best);
    }
}

/* A search for the feet of samples in use, which have moved by `way` at most, or of all. */
struct feet {
    struct contact_search *s;
    double way;
    bool all;
};

/* Finds the feet of a piece of them. */
static void find_piece(void *self, long piece)
{
    const struct feet *f = self;
    const struct contact_search *s = f->s;
    const int first = (int)piece * PIECE, left = s->actives - first;
    const int count = left < PIECE ? left : PIECE, *active = s->active + first;
    struct contact_place best[PIECE][2];

    for (int n = 0; n < count; n++) {
        const double side = f->all ? 0 : s->side[first + n];
        contact_foot_begin(s->start, best[n]);
        if (fabs(side) > 2 * f->way)
            best[n][side < 0].square = -1; /* nothing is there */
    }
    for (int n = 0; f->all && n < count; n++)
        consider_all(s, active[n], best[n]);
    for (int n = 0; !f->all && n < count; n++)
        consider_near(s, active[n], f->way, best[n]);
    s->found[piece] = finish(s, first, count, (const struct contact_place(*)[2])best,
                             s->foot + 2 * (long)first);
}

/* Finds the feet of the samples in use, and joins those of all pieces. */
static void find_feet(struct contact_search *s, double way, bool all)
{
    const int pieces = (s->actives + PIECE - 1) / PIECE;

    if (!pieces)
        return;
    find_normals(s);
    each_turn(pieces, s->actives >= PARALLEL, find_piece, &(struct feet){s, way, all});
    for (int n = 0; n < pieces; s->count += s->found[n++])
        if (s->count < 2 * n * PIECE)
            memmove(s->foot + s->count, s->foot + 2L * n * PIECE,
                    s->found[n] * sizeof *s->foot);
}

enum status contact_search_find(struct contact_search *s, const double *x)
{
    enum status st = STATUS_OK;
    double way;

    s->count = 0;
    TRY(place_samples(s, x, &way));
    if (s->stale || 2 * way > s->margin) {
        TRY(seek(s));
        way = rounding * s->start;
    }
    find_feet(s, way, false);
out:
    return st;
}

bool contact_search_cells(const struct contact_search *s, long n, int cell[2])
{
    if (n >= s->pair_count)
        return false;
    cell[0] = s->pair[n].cell, cell[1] = s->pair[n].other;
    return true;
}

void contact_search_forget(struct contact_search *s)
{
    s->stale = true;
}

enum status contact_search_find_all(struct contact_search *s, const double *x)
{
    enum status st = STATUS_OK;
    double way;

    s->count = 0;
    TRY(place_samples(s, x, &way));
    s->stale = true; /* the lists are used */
    s->actives = s->sheet.surface->count;
    for (int n = 0; n < s->actives; n++)
        s->active[n] = n, s->wanted[n] = true;
    find_feet(s, way, true);
out:
    return st;
}

/* --- how much of a change of the sheet keeps it from coming through itself
 * ----------------
 *
 * Each sample and triangle, and each two edges of triangles, keep half of their distance
 * over the wall, or half of the range where that is less; those already nearer than the
 * wall half of their distance. Where they move by w relative to each other, their distance
 * changes by at most w: what may be used up, over w, is a safe share, and from where it
 * leads it is looked for again (conservative advancement: Mirtich, Impulse-based dynamic
 * simulation, 1996, section 2.3). No root is looked for, and rounding does no harm. Left
 * out are pairs with a common sample, and those whose closest points are nearer along the
 * sheet than the tree's `apart`, as in contact; on a smooth surface two cells more.
 */

/* A change of the sheet whose safe share is looked for. */
struct change {
    struct contact_tree_search search;
    const struct contact_tree *tree;
    const double *y, *d; /* [samples][3]                                             */
    double apart;        /* pairs nearer along the sheet are left out             [m] */
    double wall, range, share;
    struct contact_meeting met; /* allows no more                                    */
};

/* The least part that is used up of a distance over the wall, or of the range above it:
 * more is taken of what is farther off, down to the middle of the range. */
static const double spent = 0.5;

/* Pairs are left out so many cells farther along the sheet than contact leaves them out:
 * the closest point of a cell next to a sharp bend is its corner at the bend, which no law
 * pushes off. */
enum { CELLS = 2 };

/* Returns their length along the sheet, of the longest cells; 0 for a net [m]. */
static double beside_bends(const struct contact_surface *s)
{
    double most[2] = {0, 0};

    for (int d = 0; s->smooth && d < 2; d++)
        for (int k = 0; k + 1 < s->points[d]; k++)
            most[d] = fmax(most[d], s->flat[d][k + 1] - s->flat[d][k]);
    return s->smooth ? CELLS * hypot(most[0], most[1]) : 0;
}

/* Returns their distance after a share of the change, and whether they are so near along
 * the sheet that contact leaves them out. */
static double distance_after(const struct change *c, const struct contact_meeting *m,
                             double share, bool *near)
{
    double y[4][3], at[3];
    const double *p[4];

    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 3; i++)
            y[k][i] =
                c->y[3 * (long)m->sample[k] + i] + share * c->d[3 * (long)m->sample[k] + i];
        p[k] = y[k];
    }
    if (!m->edges) {
        const double distance = sqrt(contact_foot_nearest(y[0], p + 1, at));
        *near = contact_tree_near(c->tree, c->apart, m->sample[0], m->sample + 1, at);
        return distance;
    }
    const double distance = contact_foot_between(p, at);
    double way[3];
    for (int d = 0; d < 3; d++) {
        double flat[4];
        for (int k = 0; k < 4; k++)
            flat[k] = c->tree->flat[m->sample[k]][d];
        way[d] =
            flat[0] + at[0] * (flat[1] - flat[0]) - flat[2] - at[1] * (flat[3] - flat[2]);
    }
    way[1] = contact_tree_across(c->tree, way[1]);
    *near = way[0] * way[0] + way[1] * way[1] + way[2] * way[2] < c->apart * c->apart &&
            !contact_surface_apart(c->tree->surface, m->sample[0], m->sample[2]);
    return distance;
}

/* Returns how far points of both move relative to each other, at most. */
static double motion_between(const struct change *c, const struct contact_meeting *m)
{
    const int split = m->edges ? 2 : 1;
    double most = 0;

    for (int k = 0; k < split; k++)
        for (int l = split; l < 4; l++) {
            double way[3];
            vector_between(c->d + 3 * (long)m->sample[k], c->d + 3 * (long)m->sample[l],
                           way);
            most = fmax(most, vector_dot(way, way));
        }
    return sqrt(most);
}

/* Tells whether both have a sample in common. */
static bool joined(const struct contact_meeting *m)
{
    const int split = m->edges ? 2 : 1;

    for (int k = 0; k < split; k++)
        for (int l = split; l < 4; l++)
            if (m->sample[k] == m->sample[l])
                return true;
    return false;
}

/* Cuts the share to one that is safe for two at a distance: a bound by their motion, from
 * where it leads to looked for again. */
static void cut(struct change *c, const struct contact_meeting *m, double distance)
{
    bool ignored;
    const double floor = distance > c->wall ? c->wall : 0, clear = distance - floor;
    const double motion = motion_between(c, m);
    const double kept = (1 - spent) * fmin(clear, c->range);
    double at = 0, left = clear - kept;
    for (int turn = 0; turn < 16 && left > 0.01 * clear; turn++) {
        at += left / motion;
        if (!(at < c->share)) /* also of no motion */
            return;
        left = distance_after(c, m, at, &ignored) - floor - kept;
    }
    c->met = *m;
    c->share = at;
    c->search.share = at / spent;
}

static void cut_samples(struct change *c, int samples, int cell)
{
    int sample[4];
    const int count = contact_tree_samples(c->tree, samples, sample);

    for (int k = 0; k < contact_tree_triangles(c->tree); k++) {
        int corner[3];
        contact_foot_corners(c->tree->surface, contact_tree_triangle(c->tree, cell) + k,
                             corner);
        for (int n = 0; n < count; n++) {
            const struct contact_meeting m = {
                .sample = {sample[n], corner[0], corner[1], corner[2]}};
            struct contact_face face = contact_foot_face(c->y, sample[n], corner);
            contact_face_nearest(&face);
            if (!joined(&m) &&
                !contact_tree_near(c->tree, c->apart, sample[n], corner, face.share))
                cut(c, &m, sqrt(face.square));
        }
    }
}

static enum status cut_cells(struct contact_tree_search *search, int cell, int other)
{
    struct change *c = search->context;
    int of_cell[5][2], of_other[5][2];
    const int count = contact_tree_edges(c->tree, cell, of_cell);
    const int others = contact_tree_edges(c->tree, other, of_other);

    cut_samples(c, cell, other);
    if (cell != other)
        cut_samples(c, other, cell);
    for (int k = 0; k < count; k++)
        for (int l = cell == other ? k + 1 : 0; l < others; l++) {
            const struct contact_meeting m = {
                {of_cell[k][0], of_cell[k][1], of_other[l][0], of_other[l][1]}, true};
            bool near;
            if (joined(&m))
                continue;
            const double distance = distance_after(c, &m, 0, &near);
            if (!near)
                cut(c, &m, distance);
        }
    return STATUS_OK;
}

/* Computes the share, 0 to 1, of the change d[samples][3] of y[samples][3]; wall >= 0 [m].
 * Fits the tree. STATUS_NAN. */
static enum status safe_share(struct contact_tree *tree, const double *y, const double *d,
                              double wall, double range, double *share,
                              struct contact_meeting *met)
{
    struct change c = {{wall, 1 / spent, &c, cut_cells},
                       tree,
                       y,
                       d,
                       .apart = tree->apart + beside_bends(tree->surface),
                       .wall = wall,
                       .range = range,
                       .share = 1,
                       .met = {.sample = {-1}}};
    enum status st = STATUS_OK;

    for (long n = 0; n < 3L * tree->surface->count; n++)
        if (!isfinite(y[n]) || !isfinite(d[n]))
            return STATUS_NAN;
    contact_tree_fit(tree, y, d);
    TRY(contact_tree_visit(tree, &c.search));
    *share = c.share;
    if (met)
        *met = c.met;
out:
    return st;
}

enum status contact_search_limit(struct contact_search *s, const double *x, const double *d,
                                 double wall, double range, double *share,
                                 struct contact_meeting *met)
{
    enum status st = STATUS_OK;
    double *own = NULL, way;

    TRY(place_samples(s, x, &way));
    if (!s->plain)
        TRY(room_cut((void **)&own, ROOM(own, 3 * (size_t)s->sheet.surface->count)));
    st = safe_share(&s->tree, s->sheet.y, at_samples(s, d, own), wall, range, share, met);
out:
    free(own);
    return st;
}

double contact_search_between(const struct contact_search *s, const double *x,
                              const struct contact_meeting *m, double weight[4],
                              double normal[3])
{
    double y[4][3], at[3];
    const double *const p[4] = {y[0], y[1], y[2], y[3]};

    for (int k = 0; k < 4; k++)
        contact_surface_at(s->sheet.surface, m->sample[k], x, y[k]);
    if (m->edges) {
        contact_foot_between(p, at);
        weight[0] = 1 - at[0], weight[1] = at[0], weight[2] = at[1] - 1, weight[3] = -at[1];
    } else {
        contact_foot_nearest(p[0], p + 1, at);
        weight[0] = 1, weight[1] = -at[0], weight[2] = -at[1], weight[3] = -at[2];
    }
    for (int i = 0; i < 3; i++)
        normal[i] = weight[0] * y[0][i] + weight[1] * y[1][i] + weight[2] * y[2][i] +
                    weight[3] * y[3][i];
    const double distance = vector_length(normal);
    for (int i = 0; i < 3; i++)
        normal[i] = distance > 0 ? normal[i] / distance : i == 2;
    return distance;
}
