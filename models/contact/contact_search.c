#include "models/contact/contact_search.h"

#include <stdlib.h>

#include "models/room.h"
#include "models/vector.h"

/* A triangle near a sample, and how near when it was found [m]. */
struct contact_near {
    int sample, triangle;
    double distance;
};

struct contact_pair {
    int cell, other;
};

/* Samples or pairs of cells from which threads are worth their start; of a piece. */
enum { PARALLEL = 1000, PIECE = 64, FIRST_ROOM = 1024 };

/* Margin over start: start and margin stay below the distance along the sheet from which
 * pairs count, so that flat parts have nothing near. */
static const double margin_share = 0.4;
/* A share of start that rounding can't reach. */
static const double rounding = 1e-9;
static const double half_pi = 1.5707963267948966, cos_steep = 0.7071067811865476;

void contact_search_clear(struct contact_search *s)
{
    contact_tree_clear(&s->tree);
    free(s->foot);
    free(s->node);
    free(s->weight);
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
    const size_t count = surface->count;

    *s = (struct contact_search){.sheet = {.surface = surface},
                                 .start = start,
                                 .margin = margin_share * start,
                                 .apart = half_pi * start,
                                 .plain = samples_are_nodes(surface)};
    TRY(contact_tree_init(&s->tree, surface, s->apart));
    TRY(room_cut(&s->room, ROOM(s->own, s->plain ? 0 : 3 * count), ROOM(s->kept, 3 * count),
                 ROOM(s->normal, 3 * count), ROOM(s->use, count), ROOM(s->ready, count),
                 ROOM(s->first, count + 1), ROOM(s->active, count)));
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

/* Computes a vector at the samples from the nodes'. */
static const double *at_samples(const struct contact_search *s, const double *x,
                                double *own)
{
    const int count = s->sheet.surface->count;

    if (s->plain)
        return x;
#pragma omp parallel for if (count >= PARALLEL)
    for (int n = 0; n < count; n++)
        contact_surface_at(s->sheet.surface, n, x, own + 3 * (long)n);
    return own;
}

/* Returns how far samples have moved since triangles were found, at most, less the shift of
 * the middle one; not finite if a place is not. */
static double moved(const struct contact_search *s)
{
    const long count = s->sheet.surface->count;
    const double *y = s->sheet.y, *old = s->kept;
    double shift[3], most = 0, all = 0;

    vector_between(old + 3 * (count / 2), y + 3 * (count / 2), shift);
#pragma omp simd reduction(max : most) reduction(+ : all)
    for (long n = 0; n < count; n++) {
        const double a = y[3 * n] - old[3 * n] - shift[0];
        const double b = y[3 * n + 1] - old[3 * n + 1] - shift[1];
        const double c = y[3 * n + 2] - old[3 * n + 2] - shift[2];
        const double square = a * a + b * b + c * c;
        most = square > most ? square : most;
        all += square;
    }
    return isfinite(all) ? sqrt(most) + rounding * s->start : NAN;
}

static double material(const struct contact_surface *s, int sample, double u, double v)
{
    const double du = u - s->flat[0][sample / s->points[1]];
    const double dv = v - s->flat[1][sample % s->points[1]];

    return sqrt(du * du + dv * dv);
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static bool has_corner(const int corner[3], int sample)
{
    return corner[0] == sample || corner[1] == sample || corner[2] == sample;
}

/* Tells whether a triangle is nearer to a sample than `apart` along the sheet as a whole.
 */
static bool all_near(const struct contact_search *s, int sample, const int corner[3])
{
    const struct contact_surface *f = s->sheet.surface;

    for (int k = 0; k < 3; k++)
        if (material(f, sample, f->flat[0][corner[k] / f->points[1]],
                     f->flat[1][corner[k] % f->points[1]]) >= s->apart)
            return false;
    return true;
}

/* Tells whether a point of a triangle is nearer to a sample than `apart`. */
static bool too_near(const struct contact_search *s, int sample, const int corner[3],
                     const double share[3])
{
    const struct contact_surface *f = s->sheet.surface;
    double u = 0, v = 0;

    for (int k = 0; k < 3; k++) {
        u += share[k] * f->flat[0][corner[k] / f->points[1]];
        v += share[k] * f->flat[1][corner[k] % f->points[1]];
    }
    return material(f, sample, u, v) < s->apart;
}

/* Lists the samples that a cell owns: its first corner, and those at the ends of the grid
 * that are no cell's first. Returns how many. */
static int owned(const struct contact_surface *s, int cell, int sample[4])
{
    const int m = s->points[1], i = cell / (m - 1), j = cell % (m - 1);
    const bool last_u = i + 2 == s->points[0], last_v = j + 2 == m;
    int count = 0;

    sample[count++] = i * m + j;
    if (last_u)
        sample[count++] = (i + 1) * m + j;
    if (last_v)
        sample[count++] = i * m + j + 1;
    if (last_u && last_v)
        sample[count++] = (i + 1) * m + j + 1;
    return count;
}

/* Finds the triangles of a cell near the samples of another; returns how many. */
static int near_of_cell(const struct contact_search *s, int samples, int cell,
                        struct contact_near *near)
{
    int sample[4], count = 0;
    const int many = owned(s->sheet.surface, samples, sample);
    const double reach = s->start + s->margin;

    for (int k = 0; k < 2; k++) {
        int corner[3];
        const double *p[3];
        double low[3], high[3], share[3];
        contact_foot_corners(s->sheet.surface, 2 * cell + k, corner);
        for (int c = 0; c < 3; c++)
            p[c] = s->sheet.y + 3 * (long)corner[c];
        for (int i = 0; i < 3; i++) {
            low[i] = smaller(smaller(p[0][i], p[1][i]), p[2][i]) - reach;
            high[i] = larger(larger(p[0][i], p[1][i]), p[2][i]) + reach;
        }
        for (int n = 0; n < many; n++) {
            const double *y = s->sheet.y + 3 * (long)sample[n];
            if (y[0] < low[0] || y[0] > high[0] || y[1] < low[1] || y[1] > high[1] ||
                y[2] < low[2] || y[2] > high[2] || has_corner(corner, sample[n]) ||
                all_near(s, sample[n], corner))
                continue;
            const double distance = contact_foot_nearest(y, p, share);
            if (distance < reach)
                near[count++] = (struct contact_near){sample[n], 2 * cell + k, distance};
        }
    }
    return count;
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

/* Finds near triangles of all pairs of cells, in no order. */
static enum status test_pairs(struct contact_search *s)
{
    const long pieces = (s->pair_count + PIECE - 1) / PIECE;
    enum status st = STATUS_OK;

    s->near_count = 0;
#pragma omp parallel for schedule(dynamic, 4) if (s->pair_count >= PARALLEL)
    for (long piece = 0; piece < pieces; piece++) {
        struct contact_near found[16 * PIECE];
        int count = 0;
        for (long n = piece * PIECE; n < (piece + 1) * PIECE && n < s->pair_count; n++) {
            const struct contact_pair *p = &s->pair[n];
            count += near_of_cell(s, p->cell, p->other, found + count);
            if (p->cell != p->other)
                count += near_of_cell(s, p->other, p->cell, found + count);
        }
        if (count)
#pragma omp critical(contact_search)
        {
            const enum status more =
                grow(&s->near, sizeof *s->near, s->near_count + count, &s->near_room);
            if (more == STATUS_OK)
                memcpy(s->near + s->near_count, found, count * sizeof *found);
            s->near_count += more == STATUS_OK ? count : 0;
            st = st ? st : more;
        }
    }
    return st;
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

static void use(struct contact_search *s, int sample)
{
    if (!s->ready[sample])
        s->use[s->uses++] = sample;
    s->ready[sample] = true;
}

/* Lists the samples whose normals are needed. */
static void list_used(struct contact_search *s)
{
    s->uses = 0;
    memset(s->ready, 0, s->sheet.surface->count * sizeof *s->ready);
    for (long n = 0; n < s->near_count; n++) {
        int corner[3];
        contact_foot_corners(s->sheet.surface, s->near[n].triangle, corner);
        use(s, s->near[n].sample);
        for (int k = 0; k < 3; k++)
            use(s, corner[k]);
    }
}

static void find_normals(struct contact_search *s)
{
    s->sheet.ready = NULL;
#pragma omp parallel for if (s->uses >= PARALLEL)
    for (int n = 0; n < s->uses; n++)
        contact_foot_normal(&s->sheet, s->use[n], s->normal + 3 * (long)s->use[n]);
    s->sheet.normal = s->normal, s->sheet.ready = s->ready;
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
    list_used(s);
    memcpy(s->kept, s->sheet.y, 3 * (size_t)s->sheet.surface->count * sizeof *s->kept);
out:
    if (st)
        s->sought = 0; /* to be found again */
    return st;
}

/* Tells whether the way from a point of a triangle to a sample is more than 45 degrees off
 * the sheet's normal there; in a face it is along the face's. */
static bool steep(const struct contact_search *s, const int corner[3],
                  const double share[3], const double way[3])
{
    double n[3] = {0};

    if (share[0] > 0 && share[1] > 0 && share[2] > 0)
        return false;
    for (int k = 0; k < 3; k++)
        if (share[k] > 0) {
            double at[3];
            contact_foot_normal(&s->sheet, corner[k], at);
            for (int i = 0; i < 3; i++)
                n[i] += share[k] * at[i];
        }
    return fabs(vector_dot(n, way)) < cos_steep * vector_length(n) * vector_length(way);
}

/* Takes a triangle for the closest on its side of a sample, if it is. */
static void consider(const struct contact_search *s, int sample, const double normal[3],
                     int triangle, struct contact_place best[2])
{
    const double *y = s->sheet.y + 3 * (long)sample, *p[3];
    struct contact_place here = {.triangle = triangle};
    double way[3];
    int corner[3];

    contact_foot_corners(s->sheet.surface, triangle, corner);
    if (has_corner(corner, sample))
        return;
    for (int k = 0; k < 3; k++)
        p[k] = s->sheet.y + 3 * (long)corner[k];
    here.distance = contact_foot_nearest(y, p, here.share);
    if (!(here.distance < s->start))
        return;
    for (int i = 0; i < 3; i++)
        way[i] = here.share[0] * p[0][i] + here.share[1] * p[1][i] +
                 here.share[2] * p[2][i] - y[i];
    struct contact_place *side = &best[vector_dot(way, normal) < 0];
    if (here.distance > side->distance ||
        (here.distance == side->distance && triangle > side->triangle))
        return;
    if (!too_near(s, sample, corner, here.share) && !steep(s, corner, here.share, way))
        *side = here;
}

/* Begins with nothing on either side of a sample. */
static void begin(const struct contact_search *s, int sample, double normal[3],
                  struct contact_place best[2])
{
    contact_foot_normal(&s->sheet, sample, normal);
    best[0] = best[1] = (struct contact_place){-1, {0}, s->start};
}

/* Refines what was found of a sample into feet at their place; returns how many. */
static int finish(struct contact_search *s, int sample, const struct contact_place best[2],
                  long at)
{
    const int width = contact_foot_width(s->sheet.surface);
    int count = 0;

    for (int k = 0; k < 2; k++) {
        struct contact_foot *foot = &s->foot[at + count];
        if (best[k].triangle < 0)
            continue;
        foot->side = k;
        foot->first = (int)(at + count) * width;
        contact_foot_refine(&s->sheet, sample, &best[k], foot, s->node + foot->first,
                            s->weight + foot->first);
        count += foot->distance < s->start;
    }
    return count;
}

static enum status make_feet(struct contact_search *s, long samples)
{
    const long width = contact_foot_width(s->sheet.surface), count = 2 * samples;
    enum status st = STATUS_OK;
    long foot = s->foot_room, node = width * foot, weight = node;

    TRY(grow(&s->foot, sizeof *s->foot, count, &foot));
    TRY(grow(&s->node, sizeof *s->node, width * count, &node));
    TRY(grow(&s->weight, sizeof *s->weight, width * count, &weight));
    s->foot_room = foot < node / width ? foot : node / width;
out:
    return st;
}

/* Moves the feet, found in two places a sample, together. */
static void gather(struct contact_search *s, long samples, const unsigned char *found)
{
    s->count = 0;
    for (long n = 0; n < samples; n++)
        for (int k = 0; k < found[n]; k++, s->count++)
            if (s->count != 2 * n + k)
                s->foot[s->count] = s->foot[2 * n + k];
}

enum status contact_search_find(struct contact_search *s, const double *x)
{
    enum status st = STATUS_OK;
    unsigned char *found = NULL;
    double way = 0;

    s->count = 0;
    s->sheet.x = x, s->sheet.y = at_samples(s, x, s->own);
    way = moved(s);
    if (!isfinite(way))
        return STATUS_NAN;
    if (!s->sought || 2 * way > s->margin) {
        TRY(seek(s));
        way = rounding * s->start;
    }
    if (!s->actives)
        goto out;
    find_normals(s);
    TRY(make_feet(s, s->actives));
    TRY(room_cut((void **)&found, ROOM(found, s->actives)));
#pragma omp parallel for schedule(dynamic, 64) if (s->actives >= PARALLEL)
    for (int n = 0; n < s->actives; n++) {
        const int sample = s->active[n];
        struct contact_place best[2];
        double normal[3];
        begin(s, sample, normal, best);
        for (int k = s->first[sample]; k < s->first[sample + 1]; k++) {
            if (s->near[k].distance - 2 * way > larger(best[0].distance, best[1].distance))
                break;
            consider(s, sample, normal, s->near[k].triangle, best);
        }
        found[n] = (unsigned char)finish(s, sample, best, 2L * n);
    }
    gather(s, s->actives, found);
out:
    free(found);
    return st;
}

/* Tells whether a point is outside the box of a cell by the start of contact. */
static bool outside(const struct contact_search *s, int cell, const double y[3])
{
    const int m = s->sheet.surface->points[1];
    const double *p = s->sheet.y + 3 * (long)(cell / (m - 1) * m + cell % (m - 1));
    const double *q = p + 3 * (long)m;

    for (int i = 0; i < 3; i++)
        if (y[i] < smaller(smaller(p[i], p[i + 3]), smaller(q[i], q[i + 3])) - s->start ||
            y[i] > larger(larger(p[i], p[i + 3]), larger(q[i], q[i + 3])) + s->start)
            return true;
    return false;
}

enum status contact_search_find_all(struct contact_search *s, const double *x)
{
    const int cells = (s->sheet.surface->points[0] - 1) * (s->sheet.surface->points[1] - 1);
    enum status st = STATUS_OK;

    s->count = 0;
    s->sheet.x = x, s->sheet.y = at_samples(s, x, s->own);
    s->sheet.ready = NULL;
    if (!isfinite(moved(s)))
        return STATUS_NAN;
    TRY(make_feet(s, s->sheet.surface->count));
    for (int sample = 0; sample < s->sheet.surface->count; sample++) {
        struct contact_place best[2];
        double normal[3];
        begin(s, sample, normal, best);
        for (int cell = 0; cell < cells; cell++)
            if (!outside(s, cell, s->sheet.y + 3 * (long)sample)) {
                consider(s, sample, normal, 2 * cell, best);
                consider(s, sample, normal, 2 * cell + 1, best);
            }
        s->count += finish(s, sample, best, s->count);
    }
out:
    return st;
}

/* A change of the sheet whose safe share is looked for. */
struct change {
    struct contact_tree_search search;
    const struct contact_search *s;
    const double *d; /* [samples][3]                                                 */
    double wall, share;
};

/* The part of a distance over the wall that may be used up, and the tenth that stays. */
static const double spent = 0.9;

/* Four samples: one and a triangle, or two edges. */
struct meeting {
    int sample[4];
    bool edges;
};

/* Returns their distance after a share of the change, and whether they are so near along
 * the sheet that contact leaves them out. */
static double distance_after(const struct change *c, const struct meeting *m, double share,
                             bool *near)
{
    const struct contact_surface *f = c->s->sheet.surface;
    double y[4][3], at[3];
    const double *p[4];

    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 3; i++)
            y[k][i] = c->s->sheet.y[3 * (long)m->sample[k] + i] +
                      share * c->d[3 * (long)m->sample[k] + i];
        p[k] = y[k];
    }
    if (!m->edges) {
        const double distance = contact_foot_nearest(y[0], p + 1, at);
        *near = too_near(c->s, m->sample[0], m->sample + 1, at);
        return distance;
    }
    const double distance = contact_foot_between(p, at);
    double way[2];
    for (int d = 0; d < 2; d++) {
        double flat[4];
        for (int k = 0; k < 4; k++)
            flat[k] =
                f->flat[d][d ? m->sample[k] % f->points[1] : m->sample[k] / f->points[1]];
        way[d] =
            flat[0] + at[0] * (flat[1] - flat[0]) - flat[2] - at[1] * (flat[3] - flat[2]);
    }
    *near = sqrt(way[0] * way[0] + way[1] * way[1]) < c->s->apart;
    return distance;
}

/* Returns how far points of both move relative to each other, at most. */
static double motion_between(const struct change *c, const struct meeting *m)
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

/* Cuts the share to one that is safe for two: a bound by their motion, from where it leads
 * to looked for again. */
static void cut(struct change *c, const struct meeting *m)
{
    bool near, ignored;
    const int split = m->edges ? 2 : 1;

    for (int k = 0; k < split; k++)
        for (int l = split; l < 4; l++)
            if (m->sample[k] == m->sample[l])
                return;
    const double distance = distance_after(c, m, 0, &near);
    if (near)
        return;
    const double floor = distance > c->wall ? c->wall : 0, clear = distance - floor;
    const double motion = motion_between(c, m);
    double at = 0, left = spent * clear;
    for (int turn = 0; turn < 16 && left > 0.01 * clear; turn++) {
        at += left / motion;
        if (!(at < c->share)) /* also of no motion */
            return;
        left = distance_after(c, m, at, &ignored) - floor - (1 - spent) * clear;
    }
    c->share = at;
    c->search.share = at / spent;
}

/* Lists the edges that a cell owns, the diagonal and those at its owned samples. */
static int edges_of(const struct contact_surface *s, int cell, int edge[5][2])
{
    const int m = s->points[1], i = cell / (m - 1), j = cell % (m - 1), c = i * m + j;
    const int all[5][2] = {
        {c, c + m}, {c, c + 1}, {c, c + m + 1}, {c + m, c + m + 1}, {c + 1, c + m + 1}};
    int count = 0;

    for (int k = 0; k < 5; k++)
        if (k < 3 || (k == 3 ? i + 2 == s->points[0] : j + 2 == m)) {
            edge[count][0] = all[k][0];
            edge[count++][1] = all[k][1];
        }
    return count;
}

static void cut_samples(struct change *c, int samples, int cell)
{
    struct meeting m = {.edges = false};
    int sample[4];
    const int count = owned(c->s->sheet.surface, samples, sample);

    for (int k = 0; k < 2; k++) {
        contact_foot_corners(c->s->sheet.surface, 2 * cell + k, m.sample + 1);
        for (int n = 0; n < count; n++) {
            m.sample[0] = sample[n];
            cut(c, &m);
        }
    }
}

static enum status cut_cells(struct contact_tree_search *search, int cell, int other)
{
    struct change *c = search->context;
    int of_cell[5][2], of_other[5][2];
    const int count = edges_of(c->s->sheet.surface, cell, of_cell);
    const int others = edges_of(c->s->sheet.surface, other, of_other);

    cut_samples(c, cell, other);
    if (cell != other)
        cut_samples(c, other, cell);
    for (int k = 0; k < count; k++)
        for (int l = cell == other ? k + 1 : 0; l < others; l++) {
            const struct meeting m = {
                {of_cell[k][0], of_cell[k][1], of_other[l][0], of_other[l][1]}, true};
            cut(c, &m);
        }
    return STATUS_OK;
}

enum status contact_search_limit(struct contact_search *s, const double *x, const double *d,
                                 double wall, double *share)
{
    const size_t count = s->sheet.surface->count;
    enum status st = STATUS_OK;
    double *own = NULL;
    struct change c = {{wall, 1 / spent, &c, cut_cells}, s, d, wall, 1};

    s->sheet.y = at_samples(s, x, s->own);
    if (!s->plain) {
        TRY(room_cut((void **)&own, ROOM(own, 3 * count)));
        c.d = at_samples(s, d, own);
    }
    for (size_t n = 0; n < 3 * count; n++)
        if (!isfinite(s->sheet.y[n]) || !isfinite(c.d[n]))
            TRY(STATUS_NAN);
    contact_tree_fit(&s->tree, s->sheet.y, c.d);
    TRY(contact_tree_visit(&s->tree, &c.search));
    *share = c.share;
out:
    free(own);
    return st;
}
