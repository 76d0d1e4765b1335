#include "models/pattern.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

/* So near a side, in shares of the box's diagonal, a place is on it. */
static const double NEAR = 1e-12;

/* The round-off of weights in a triangle, and of places in cells of the grid. */
static const double ROUND_OFF = 1e-9;

struct pattern *pattern_make(void)
{
    return calloc(1, sizeof(struct pattern));
}

void pattern_free(struct pattern *p)
{
    if (!p)
        return;
    free(p->at);
    free(p->line);
    free(p->next);
    free(p->node);
    free(p->start);
    free(p->nearest);
    free(p->vertex);
    free(p->in);
    for (int n = 0; n < p->groups; n++)
        free(p->group[n]);
    free(p->group);
    mesh_flat_clear(&p->mesh);
    free(p);
}

enum status pattern_add_line(struct pattern *p, int count, const double (*at)[2])
{
    const size_t points = (size_t)(p->points + count) + 1;
    double(*all)[2] = realloc(p->at, points * sizeof *all);
    p->at = all ? all : p->at;
    int *next = realloc(p->next, points * sizeof *next);
    p->next = next ? next : p->next;
    int *line = realloc(p->line, (size_t)(p->lines + 2) * sizeof *line);
    p->line = line ? line : p->line;
    if (!all || !next || !line)
        return STATUS_MEMORY;
    memcpy(p->at + p->points, at, (size_t)count * sizeof *at);
    for (int n = 0; n < count; n++)
        p->next[p->points + n] = p->points + (n + 1) % count;
    p->line[p->lines++] = p->points;
    p->line[p->lines] = p->points += count;
    return STATUS_OK;
}

/* --- lines around triangles -------------------------------------------------------------
 */

static enum status add_lines(struct pattern *p, int *next, double (*at)[2])
{
    enum status st = STATUS_OK;

    for (int from = 0; st == STATUS_OK && from < p->mesh.nodes; from++) {
        int count = 0, here = from;
        while (next[here] >= 0) {
            const int there = next[here];
            memcpy(at[count++], p->mesh.at[here], sizeof *at);
            next[here] = -1, here = there;
        }
        if (count)
            st = pattern_add_line(p, count, (const double(*)[2])at);
    }
    return st;
}

enum status pattern_add_mesh(struct pattern *p, struct mesh_flat *mesh, int *triangle)
{
    struct mesh_edge *edge = NULL;
    int edges;
    int *next = malloc((size_t)mesh->nodes * sizeof *next);
    double(*at)[2] = malloc((size_t)mesh->nodes * sizeof *at);
    enum status st = next && at ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(mesh_flat_edges(mesh, &edge, &edges, NULL));
    *triangle = mesh_flat_rim(mesh, edge, edges, next);
    TRY(*triangle < 0 ? STATUS_OK : STATUS_INPUT);
    HAND_OVER(&p->mesh, *mesh);
    TRY(add_lines(p, next, at));
out:
    free(next);
    free(at);
    free(edge);
    return st;
}

/* --- what is wrong with lines -----------------------------------------------------------
 */

static double area_of(const struct pattern *p, int line)
{
    double sum = 0;

    for (int n = p->line[line]; n < p->line[line + 1]; n++)
        sum += mesh_flat_left(p->at[p->line[line]], p->at[n], p->at[p->next[n]]) / 2;
    return sum;
}

static void turn_round(struct pattern *p, int line)
{
    for (int n = p->line[line], m = p->line[line + 1] - 1; n < m; n++, m--) {
        const double keep[2] = {p->at[n][0], p->at[n][1]};
        memcpy(p->at[n], p->at[m], sizeof keep);
        memcpy(p->at[m], keep, sizeof keep);
    }
}

/* Tells whether c lies on the side from a to b, which it is in line with. */
static bool between(const double a[2], const double b[2], const double c[2])
{
    return fmin(a[0], b[0]) <= c[0] && c[0] <= fmax(a[0], b[0]) &&
           fmin(a[1], b[1]) <= c[1] && c[1] <= fmax(a[1], b[1]);
}

static bool cross(const double a[2], const double b[2], const double c[2],
                  const double d[2])
{
    const double ac = mesh_flat_left(a, b, c), ad = mesh_flat_left(a, b, d);
    const double ca = mesh_flat_left(c, d, a), cb = mesh_flat_left(c, d, b);

    return (ac * ad < 0 && ca * cb < 0) || (ac == 0 && between(a, b, c)) ||
           (ad == 0 && between(a, b, d)) || (ca == 0 && between(c, d, a)) ||
           (cb == 0 && between(c, d, b));
}

/* Tells whether two neighbouring sides, a b and b c, run back on each other. */
static bool folds_back(const double a[2], const double b[2], const double c[2])
{
    return mesh_flat_left(a, b, c) == 0 &&
           (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) < 0;
}

/* Compares all pairs of sides. */
static bool any_cross(const struct pattern *p, int *line, int *point)
{
    for (int k = 0; k < p->lines; k++)
        for (int n = p->line[k]; n < p->line[k + 1]; n++) {
            const int m = p->next[n];
            const double *a = p->at[n], *b = p->at[m];
            *line = k, *point = n - p->line[k];
            if (folds_back(a, b, p->at[p->next[m]]))
                return true;
            for (int l = k; l < p->lines; l++)
                for (int q = l == k ? n + 1 : p->line[l]; q < p->line[l + 1]; q++) {
                    const int r = p->next[q];
                    if (q != m && r != n && cross(a, b, p->at[q], p->at[r]))
                        return true;
                }
        }
    return false;
}

/* Tells whether the way from a place along u crosses the side from a to b. */
static bool passes(const double at[2], const double a[2], const double b[2])
{
    return (a[1] > at[1]) != (b[1] > at[1]) &&
           at[0] - a[0] < (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
}

/* Tells whether a place is inside one line, which it is not on. */
static bool inside(const struct pattern *p, int line, const double at[2])
{
    bool in = false;

    for (int n = p->line[line]; n < p->line[line + 1]; n++)
        in ^= passes(at, p->at[n], p->at[p->next[n]]);
    return in;
}

static enum pattern_fault fault_of(const struct pattern *p, int *line, int *point)
{
    int outline = 0;

    while (outline < p->lines && !(area_of(p, outline) > 0))
        outline++;
    for (int k = 0; k < p->lines; k++) {
        *line = k, *point = 0;
        if (p->line[k + 1] - p->line[k] < 3)
            return PATTERN_FEW;
        for (int n = p->line[k]; n < p->line[k + 1]; n++) {
            *point = n - p->line[k];
            if (!memcmp(p->at[n], p->at[p->next[n]], sizeof *p->at))
                return PATTERN_DOUBLE;
        }
    }
    if (any_cross(p, line, point))
        return PATTERN_CROSSING;
    for (int k = 0; k < p->lines; k++) {
        const bool hole = !(area_of(p, k) > 0);
        int outlines = 0, holes = 0; /* that it is in */
        *line = k, *point = 0;
        if (!hole && k != outline && !p->node)
            return PATTERN_PIECES;
        for (int l = 0; l < p->lines; l++)
            if (l != k && inside(p, l, p->at[p->line[k]]))
                *(area_of(p, l) > 0 ? &outlines : &holes) += 1;
        if (outlines != hole || holes)
            return PATTERN_OUTSIDE;
    }
    return PATTERN_SOUND;
}

/* --- the whole --------------------------------------------------------------------------
 */

static void move_to_zero(struct pattern *p, double size[2])
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

    for (int n = 0; n < p->points; n++)
        for (int i = 0; i < 2; i++) {
            low[i] = fmin(low[i], p->at[n][i]);
            high[i] = fmax(high[i], p->at[n][i]);
        }
    for (int i = 0; i < 2; i++) {
        p->corner[i] = low[i], size[i] = high[i] - low[i];
        for (int n = 0; n < p->points; n++)
            p->at[n][i] -= low[i];
        for (int n = 0; n < p->mesh.nodes; n++)
            p->mesh.at[n][i] -= low[i];
        for (int n = 0; p->start && n < p->nodes; n++)
            p->start[n][i] -= low[i];
    }
}

/* Tells whether a place is on the sheet, by `count` of its sides: all that its height
 * reaches. */
static bool has(const struct pattern *p, int count, const int *side, double x, double y)
{
    const double at[2] = {x, y};
    bool in = false;

    for (int n = 0; n < count; n++) {
        const int m = side ? side[n] : n;
        const double *a = p->at[m], *b = p->at[p->next[m]];
        if (mesh_flat_off2(a, b, at) <= p->near * p->near)
            return true;
        in ^= passes(at, a, b);
    }
    return in;
}

bool pattern_has(const struct pattern *p, double x, double y)
{
    return has(p, p->points, NULL, x, y);
}

/* Marks the grid's points that are on the sheet, row by row. */
static enum status mark(struct pattern *p, const double size[2])
{
    int *side = malloc((size_t)p->points * sizeof *side);

    if (!side)
        return STATUS_MEMORY;
    for (int j = 0; j < GRID_V; j++) {
        const double y = j / (GRID_V - 1.) * size[1];
        int count = 0;
        for (int n = 0; n < p->points; n++) {
            const double a = p->at[n][1], b = p->at[p->next[n]][1];
            if (fmin(a, b) <= y + p->near && fmax(a, b) >= y - p->near)
                side[count++] = n;
        }
        for (int i = 0; i < GRID_U; i++)
            p->on[j][i] = has(p, count, side, i / (GRID_U - 1.) * size[0], y);
    }
    free(side);
    return STATUS_OK;
}

/* --- panels in space --------------------------------------------------------------------
 */

/* Takes the points off the material grid that lie in a cell with one of another panel. */
static enum status part_panels(struct pattern *p)
{
    int *panel = malloc((size_t)p->mesh.nodes * sizeof *panel);

    if (!panel)
        return STATUS_MEMORY;
    mesh_flat_pieces(&p->mesh, panel);
    for (int n = 0; n < 4 * GRID_U * GRID_V; n++) {
        const int i = n / 4 % GRID_U, j = n / 4 / GRID_U,
                  k = n % 4; /* (1,0) (0,1) (1,1) (-1,1) */
        const int to_i = i + (k == 3 ? -1 : k != 1), to_j = j + (k > 0);
        if (to_i < 0 || to_i >= GRID_U || to_j >= GRID_V || !p->on[j][i] ||
            !p->on[to_j][to_i])
            continue;
        const int s = p->nearest[j * GRID_U + i], t = p->nearest[to_j * GRID_U + to_i];
        if (s < 0 || t < 0 ||
            panel[p->mesh.triangle[s][0]] == panel[p->mesh.triangle[t][0]])
            continue;
        p->on[to_j][to_i] = false;
    }
    free(panel);
    return STATUS_OK;
}

/* Finds the triangles at the points of the material grid that are on the sheet. */
static enum status find_nearest(struct pattern *p, const double size[2])
{
    double weight[3];

    p->nearest = malloc((size_t)GRID_U * GRID_V * sizeof *p->nearest);
    if (!p->nearest)
        return STATUS_MEMORY;
    for (int n = 0; n < GRID_U * GRID_V; n++)
        p->nearest[n] = -1;
    for (int t = 0; t < p->mesh.triangles; t++) {
        int low[2], high[2];
        for (int i = 0; i < 2; i++) {
            const double scale = ((i ? GRID_V : GRID_U) - 1) / size[i];
            const int *v = p->mesh.triangle[t];
            const double a = p->mesh.at[v[0]][i] * scale, b = p->mesh.at[v[1]][i] * scale,
                         c = p->mesh.at[v[2]][i] * scale;
            low[i] = (int)ceil(fmin(a, fmin(b, c)) - ROUND_OFF);
            high[i] = (int)floor(fmax(a, fmax(b, c)) + ROUND_OFF);
        }
        for (int j = low[1]; j <= high[1]; j++)
            for (int i = low[0]; i <= high[0]; i++)
                if (mesh_flat_weigh(&p->mesh, t,
                                    (double[]){i / (GRID_U - 1.) * size[0],
                                               j / (GRID_V - 1.) * size[1]},
                                    weight) > -ROUND_OFF)
                    p->nearest[j * GRID_U + i] = t;
    }
    return part_panels(p);
}

void pattern_begin(const struct pattern *p, double x, double y, double begin[3],
                   double normal[3])
{
    const int i = (int)fmin(fmax(round(x / p->size[0] * (GRID_U - 1)), 0), GRID_U - 1),
              j = (int)fmin(fmax(round(y / p->size[1] * (GRID_V - 1)), 0), GRID_V - 1);
    const double at[2] = {x, y};
    double weight[3], sum = 0, e[2][3], best = -INFINITY;
    int t = p->nearest[j * GRID_U + i];

    if (t < 0 || mesh_flat_weigh(&p->mesh, t, at, weight) < -ROUND_OFF) {
        t = 0;
        for (int s = 0; s < p->mesh.triangles; s++) {
            const double least = mesh_flat_weigh(&p->mesh, s, at, weight);
            if (least > best)
                best = least, t = s;
        }
        mesh_flat_weigh(&p->mesh, t, at, weight);
    }
    for (int k = 0; k < 3; k++)
        sum += weight[k] = fmax(weight[k], 0);
    const int *v = p->mesh.triangle[t];
    const double *q = p->start[p->node[v[0]]];
    for (int c = 0; c < 3; c++) {
        begin[c] = 0;
        for (int k = 0; k < 3; k++)
            begin[c] += weight[k] / sum * p->start[p->node[v[k]]][c];
        for (int k = 0; k < 2; k++)
            e[k][c] = p->start[p->node[v[1 + k]]][c] - q[c];
    }
    vector_cross(e[0], e[1], normal);
    const double length = vector_length(normal);
    for (int c = 0; c < 3 && length > 0; c++)
        normal[c] /= length;
}

enum status pattern_sewn(const struct pattern *p, struct mesh_flat *flat)
{
    const struct mesh_flat *own = &p->mesh;
    const int nodes = p->node ? p->nodes : own->nodes;
    enum status st;

    TRY(mesh_flat_make(flat, nodes, own->triangles));
    flat->nodes = nodes, flat->triangles = own->triangles;
    if (p->node) {
        TRY(mesh_flat_raise(flat));
        memcpy(flat->start, p->start, (size_t)nodes * sizeof *flat->start);
    }
    for (int a = own->nodes - 1; a >= 0; a--) /* of several places the first */
        memcpy(flat->at[pattern_node(p, a)], own->at[a], sizeof *own->at);
    for (int n = 0; n < 3 * own->triangles; n++) {
        const int a = own->triangle[n / 3][n % 3];
        flat->triangle[n / 3][n % 3] = pattern_node(p, a);
        if (p->node)
            memcpy(flat->corner[n / 3][n % 3], own->at[a], sizeof *own->at);
    }
out:
    return st;
}

enum status pattern_finish(struct pattern *p, double size[2], struct pattern_blame *blame)
{
    const bool drawn = !p->mesh.nodes;

    for (int k = 0; drawn && k < p->lines; k++)
        if ((area_of(p, k) > 0) != (k == 0))
            turn_round(p, k);
    blame->fault = fault_of(p, &blame->line, &blame->point);
    if (blame->fault != PATTERN_SOUND)
        return STATUS_INPUT;
    move_to_zero(p, size);
    memcpy(p->size, size, sizeof p->size);
    p->near = NEAR * hypot(size[0], size[1]);
    for (int k = 0; k < p->lines; k++)
        p->area += area_of(p, k);
    const enum status st = mark(p, size);
    return st == STATUS_OK && p->node ? find_nearest(p, size) : st;
}

/* FNV-1a, 64 bits. */
static unsigned long long add_bytes(unsigned long long sum, const void *bytes, size_t count)
{
    for (const unsigned char *b = bytes; count--; b++)
        sum = (sum ^ *b) * 1099511628211u;
    return sum;
}

unsigned long long pattern_sum(const struct pattern *p)
{
    const struct mesh_flat *m = &p->mesh;
    unsigned long long sum =
        add_bytes(14695981039346656037u, m->at, (size_t)m->nodes * sizeof *m->at);

    if (p->node) {
        sum = add_bytes(sum, p->node, (size_t)m->nodes * sizeof *p->node);
        sum = add_bytes(sum, p->start, (size_t)p->nodes * sizeof *p->start);
    }
    return add_bytes(sum, m->triangle, (size_t)m->triangles * sizeof *m->triangle);
}
