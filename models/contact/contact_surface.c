#include "models/contact/contact_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

void contact_surface_clear(struct contact_surface *s)
{
    free(s->room);
    memset(s, 0, sizeof *s);
}

static double distance_at_rest(const struct scene *scene, const double a[3],
                               const double b[3])
{
    double p[3], q[3], way[3];

    scene_rest_point(scene, a, p);
    scene_rest_point(scene, b, q);
    vector_between(p, q, way);
    return vector_length(way);
}

static void measure_lines(struct contact_surface *s, const struct scene *scene)
{
    for (int i = 1; i < s->points[0]; i++)
        if (!contact_surface_cut(s, i - 1))
            s->flat[0][i] = s->flat[0][i - 1] +
                            distance_at_rest(scene, (double[3]){s->line[0][i - 1], .5, .5},
                                             (double[3]){s->line[0][i], .5, .5});
    for (int j = 1; j < s->points[1]; j++)
        s->flat[1][j] = s->flat[1][j - 1] +
                        distance_at_rest(scene, (double[3]){0, s->line[1][j - 1], .5},
                                         (double[3]){0, s->line[1][j], .5});
}

/* Gives a quarter of each cell's area to its corners: half the product of the diagonals. */
static void share_areas(struct contact_surface *s, const struct scene *scene)
{
    const int m = s->points[1];

    for (int i = 0; i + 1 < s->points[0]; i++)
        for (int j = 0; j + 1 < m && !contact_surface_cut(s, i); j++) {
            double corner[4][3], d[2][3], normal[3];
            for (int k = 0; k < 4; k++)
                scene_rest_point(
                    scene, (double[3]){s->line[0][i + k / 2], s->line[1][j + k % 2], .5},
                    corner[k]);
            vector_between(corner[0], corner[3], d[0]);
            vector_between(corner[1], corner[2], d[1]);
            vector_cross(d[0], d[1], normal);
            for (int k = 0; k < 4; k++)
                s->area[(i + k / 2) * m + j + k % 2] += vector_length(normal) / 8;
        }
}

enum status contact_surface_init(struct contact_surface *s, const struct scene *scene,
                                 const void *self, contact_row *row, int width, int nodes,
                                 const double *const line[2], const int points[2])
{
    enum status st;
    const size_t count = (size_t)points[0] * points[1];

    *s = (struct contact_surface){.self = self,
                                  .row = row,
                                  .points = {points[0], points[1]},
                                  .rows = points[0] / scene_sheets(scene),
                                  .count = (int)count,
                                  .width = width,
                                  .smooth = width > 1,
                                  .nodes = nodes};
    TRY(room_cut(&s->room, ROOM(s->line[0], points[0]), ROOM(s->line[1], points[1]),
                 ROOM(s->flat[0], points[0]), ROOM(s->flat[1], points[1]),
                 ROOM(s->used, count), ROOM(s->node, count * width),
                 ROOM(s->shape, count * width), ROOM(s->area, count)));
    for (int d = 0; d < 2; d++)
        memcpy(s->line[d], line[d], (size_t)points[d] * sizeof *line[d]);
    for (int n = 0; n < s->count; n++)
        if (row)
            s->used[n] = row(self, line[0][n / points[1]], line[1][n % points[1]],
                             s->node + (size_t)n * width, s->shape + (size_t)n * width);
        else
            s->used[n] = 1, s->node[n] = n, s->shape[n] = 1;
    measure_lines(s, scene);
    s->around = scene_closed(scene) ? s->flat[1][points[1] - 1] : 0;
    for (int d = 0; d < 2; d++)
        for (int k = 0; k + 1 < s->points[d]; k++)
            s->spacing = fmax(s->spacing, s->flat[d][k + 1] - s->flat[d][k]);
    share_areas(s, scene);
out:
    return st;
}

enum status contact_surface_init_mesh(struct contact_surface *s, int nodes, int count,
                                      const struct mesh_cells *mesh, double spacing)
{
    enum status st;

    *s = (struct contact_surface){.points = {count, 1},
                                  .rows = count,
                                  .count = count,
                                  .width = 1,
                                  .nodes = nodes,
                                  .spacing = spacing,
                                  .mesh = *mesh};
    TRY(room_cut(&s->room, ROOM(s->used, count), ROOM(s->node, count),
                 ROOM(s->shape, count), ROOM(s->area, count)));
    for (int n = 0; n < count; n++)
        s->used[n] = 1, s->node[n] = n, s->shape[n] = 1;
    memcpy(s->area, mesh->area, (size_t)count * sizeof *s->area);
out:
    return st;
}

enum status contact_surface_init_even(struct contact_surface *s, const struct scene *scene,
                                      const void *self, contact_row *row, int width,
                                      int nodes, const int points[2])
{
    enum status st;
    const int sheets = scene_sheets(scene), rows = points[0] / sheets;
    double *line[2];
    void *room;

    TRY(room_cut(&room, ROOM(line[0], points[0]), ROOM(line[1], points[1])));
    for (int k = 0; k < sheets; k++) {
        const double ends[2] = {scene_sheet_u(scene, k, 0), scene_sheet_u(scene, k, 1)};
        contact_surface_line(2, ends, rows - 1, line[0] + k * rows);
    }
    contact_surface_line(2, (const double[2]){0, 1}, points[1] - 1, line[1]);
    st = contact_surface_init(s, scene, self, row, width, nodes,
                              (const double *const *)line, points);
    free(room);
out:
    return st;
}

enum status contact_surface_init_net(struct contact_surface *s, const struct scene *scene,
                                     const int points[2])
{
    return contact_surface_init_even(s, scene, NULL, NULL, 1, points[0] * points[1],
                                     points);
}

int contact_surface_line(int breaks, const double *at, int per, double *line)
{
    int count = 0;

    for (int k = 0; k + 1 < breaks; k++)
        for (int n = 0; n < per; n++)
            line[count++] = at[k] + (at[k + 1] - at[k]) * n / per;
    line[count++] = at[breaks - 1];
    return count;
}

int contact_surface_mix(const struct contact_surface *s, int count, const int *sample,
                        const double *share, int *node, double *weight)
{
    int used = 0;

    for (int k = 0; k < count; k++) {
        const size_t first = (size_t)sample[k] * s->width;
        for (int n = 0, at; n < s->used[sample[k]]; n++) {
            for (at = 0; s->width > 1 && at < used && node[at] != s->node[first + n];)
                at++;
            if (s->width == 1 || at == used)
                node[at = used++] = s->node[first + n], weight[at] = 0;
            weight[at] += share[k] * s->shape[first + n];
        }
    }
    return used;
}

void contact_surface_at(const struct contact_surface *s, int sample, const double *x,
                        double y[3])
{
    const int *node = s->node + (size_t)sample * s->width;
    const double *shape = s->shape + (size_t)sample * s->width;

    y[0] = y[1] = y[2] = 0;
    for (int k = 0; k < s->used[sample]; k++)
        for (int i = 0; i < 3; i++)
            y[i] += shape[k] * x[3 * (size_t)node[k] + i];
}

const double *contact_surface_sheet(const struct contact_surface *s, double u)
{
    const double *line = s->line[0];

    while (line + s->rows < s->line[0] + s->points[0] &&
           u > (line[s->rows - 1] + line[s->rows]) / 2)
        line += s->rows;
    return line;
}

struct contact_ends contact_surface_ends(const struct contact_surface *s, double u)
{
    /* Two samples beyond the ends of the line, and never as far as the next sheet. */
    const double spread = 0x1p-13, beyond = 2;
    const double *end = contact_surface_sheet(s, u);
    struct contact_ends e = {.high = {1, 1}};

    e.low[0] = end[0], e.high[0] = end[s->rows - 1];
    for (int d = 0; d < 2; d++) {
        const int cells = (d ? s->points[1] : s->rows) - 1;
        const bool ends = s->width > CONTACT_SURFACE_NODES || (d && s->around > 0);
        double on = ends ? 0 : beyond * (e.high[d] - e.low[d]) / cells;
        if (d == 0 && s->rows < s->points[0])
            on = fmin(on, (s->line[0][s->rows] - s->line[0][s->rows - 1]) / 2);
        e.least[d] = e.low[d] - on, e.most[d] = e.high[d] + on;
        e.step[d] = spread * (e.high[d] - e.low[d]);
    }
    return e;
}

double contact_surface_middle(const struct contact_ends *e, int d, double at)
{
    if (at < e->low[d])
        return fmin(at, e->low[d] - e->step[d]);
    if (at > e->high[d])
        return fmax(at, e->high[d] + e->step[d]);
    return fmin(fmax(at, e->low[d] + e->step[d]), e->high[d] - e->step[d]);
}

/* Fills the places within the ends, and their shares, that amount to a place which may lie
 * beyond; returns how many. */
static int go_on(const struct contact_ends *e, int d, double at, double place[3],
                 double share[3])
{
    const double border = fmin(fmax(at, e->low[d]), e->high[d]);
    /* Longer steps than those of differences: shares are round-off times their number. */
    const double step = 8 * e->step[d], inward = at > border ? -step : step;
    const double t = (at - border) / inward;

    for (int n = 0; n < 3; n++)
        place[n] = border + n * inward;
    share[0] = 1 - 1.5 * t, share[1] = 2 * t, share[2] = -0.5 * t;
    return t != 0 ? 3 : 1;
}

/* Adds a row, times `share`, to that of `used` nodes; returns how many there are then. */
static int add_row(const struct contact_surface *s, double u, double v, double share,
                   int used, int *node, double *shape)
{
    double more[CONTACT_SURFACE_NODES];
    int own[CONTACT_SURFACE_NODES];
    const int count = s->row(s->self, u, v, own, more);

    for (int k = 0, n; k < count; k++) {
        for (n = 0; n < used && node[n] != own[k]; n++)
            ;
        if (n == used)
            node[used] = own[k], shape[used++] = 0;
        shape[n] += share * more[k];
    }
    return used;
}

int contact_surface_row(const struct contact_surface *s, const struct contact_ends *e,
                        double u, double v, int *node, double *shape)
{
    double place[2][3], share[2][3];
    const int along = go_on(e, 0, u, place[0], share[0]),
              across = go_on(e, 1, v, place[1], share[1]);
    int used = 0;

    if (along * across == 1)
        return s->row(s->self, u, v, node, shape);
    for (int i = 0; i < along; i++)
        for (int j = 0; j < across; j++)
            used = add_row(s, place[0][i], place[1][j], share[0][i] * share[1][j], used,
                           node, shape);
    return used;
}

int contact_surface_point(const struct contact_surface *s, const struct contact_ends *e,
                          const double *x, double u, double v, int *node, double *shape,
                          double y[3])
{
    const int count = contact_surface_row(s, e, u, v, node, shape);

    y[0] = y[1] = y[2] = 0;
    for (int k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            y[i] += shape[k] * x[3 * (long)node[k] + i];
    return count;
}

void contact_surface_bend(const struct contact_surface *s, const struct contact_ends *e,
                          const double *x, double u, double v, int *node, double *shape,
                          struct contact_bend *b)
{
    const double step = e->step[0], spread = e->step[1];
    double p[3][3][3];

    b->u = contact_surface_middle(e, 0, u);
    b->v = contact_surface_middle(e, 1, v);
    for (int k = 0; k < 9; k++)
        contact_surface_point(s, e, x, b->u + (k / 3 - 1) * step,
                              b->v + (k % 3 - 1) * spread, node, shape, p[k / 3][k % 3]);
    for (int i = 0; i < 3; i++) {
        b->y[i] = p[1][1][i];
        b->d[0][i] = (p[2][1][i] - p[0][1][i]) / (2 * step);
        b->d[1][i] = (p[1][2][i] - p[1][0][i]) / (2 * spread);
        b->dd[0][i] = (p[2][1][i] - 2 * p[1][1][i] + p[0][1][i]) / (step * step);
        b->dd[1][i] =
            (p[2][2][i] - p[2][0][i] - p[0][2][i] + p[0][0][i]) / (4 * step * spread);
        b->dd[2][i] = (p[1][2][i] - 2 * p[1][1][i] + p[1][0][i]) / (spread * spread);
    }
}

void contact_bend_rounds(const struct contact_bend *b, const double way[3], double A[3])
{
    for (int k = 0; k < 3; k++)
        A[k] = vector_dot(b->d[k / 2], b->d[(k + 1) / 2]) - vector_dot(way, b->dd[k]);
}
