#include "bench/score/score_net.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/metric/intersection.h"
#include "models/pattern.h"
#include "models/vector.h"

/* Coordinates of lines of a net that differ by less than SAME_LINE are one line; a net
 * reaches a sheet's edge to within EDGE. */
#define SAME_LINE 1e-6
#define EDGE      1e-3

/* One row may lie outside of the sheet, by a cell: half the sheet (and rounding) at most.
 */
#define OUTSIDE 0.501

/* A vertex lies on the rest shape to this share of the length. */
#define ON_REST 2e-3

/* Returns the first of four of the points low to high, and their weights, for the place s
 * in steps. */
static int cubic(int low, int high, double s, double weight[4])
{
    int first = (int)floor(s) - 1;

    first = first < low ? low : first > high - 3 ? high - 3 : first;
    const double r = s - first;
    weight[0] = -(r - 1) * (r - 2) * (r - 3) / 6;
    weight[1] = r * (r - 2) * (r - 3) / 2;
    weight[2] = -r * (r - 1) * (r - 3) / 2;
    weight[3] = r * (r - 1) * (r - 2) / 6;
    return first;
}

int score_net_cubic(int points, double x, double weight[4])
{
    return cubic(0, points - 1, x * (points - 1), weight);
}

void score_net_sample(int sheets, int nu, int nv, const double *field, const double uv[2],
                      double xyz[3])
{
    const double s = fmin(fmax(uv[0], 0), 1) * (nu - 1);
    int column[2] = {0, nu - 1};
    double a[4], b[4];

    if (sheets > 1)
        grid_columns(sheets, grid_sheet(sheets, (int)lround(s)), column);
    const int i = cubic(column[0], column[1], s, a),
              j = score_net_cubic(nv, fmin(fmax(uv[1], 0), 1), b);

    xyz[0] = xyz[1] = xyz[2] = 0;
    for (int n = 0; n < 16; n++) {
        const double *at = field + 3 * ((j + n / 4) * nu + i + n % 4);
        for (int c = 0; c < 3; c++)
            xyz[c] += b[n / 4] * a[n % 4] * at[c];
    }
}

/* --- material coordinates --- */

/* Projects a point on the flat rest shape of a sheet, uv are its coordinates there; returns
 * its distance. */
static double place_on(const struct scene *s, const struct scene_pose *pose,
                       const double xyz[3], double uv[2])
{
    double d[3], normal[3];

    vector_cross(pose->axis_u, pose->axis_v, normal);
    vector_between(pose->origin, xyz, d);
    uv[0] = vector_dot(d, pose->axis_u) / s->length;
    uv[1] = vector_dot(d, pose->axis_v) / s->width;
    const double above = vector_dot(d, normal);
    const double over_u = fmax(0, fmax(-uv[0], uv[0] - 1)) * s->length,
                 over_v = fmax(0, fmax(-uv[1], uv[1] - 1)) * s->width;
    return sqrt(above * above + over_u * over_u + over_v * over_v);
}

/* Does so on the nearest sheet; uv are the scene's. */
static double place(const struct scene *s, const double xyz[3], double uv[2])
{
    double least = INFINITY, at[2];

    for (int k = 0; k < scene_sheets(s); k++) {
        const double far = place_on(s, &s->pose[k], xyz, at);
        if (!(far < least))
            continue;
        least = far;
        uv[0] = scene_sheet_u(s, k, at[0]);
        uv[1] = at[1];
    }
    return least;
}

static enum status by_position(const struct scene *scene, const char *name,
                               const double *xyz, const char *whose, struct score_net *net,
                               struct message *why)
{
    net->by_position = true;
    for (int n = 0; n < net->vertices; n++) {
        const double far = place(scene, xyz + 3 * n, net->uv + 2 * n);
        if (scene->shape == SCENE_FLAT && far <= ON_REST * scene->length)
            continue;
        return status_fail(why, STATUS_INPUT,
                           "%s: has no uv, and vertex %d of %s lies %.3g m from the rest "
                           "shape of %s; uv (vt in OBJ), --rest FILE, or --scale and --up "
                           "would be right",
                           name, n + 1, whose, far, scene->name);
    }
    return STATUS_OK;
}

enum status score_net_make(struct arena *arena, const struct frames_net *frames,
                           const struct scene *scene, const char *name, const double *rest,
                           const double *xyz, struct score_net *net, struct message *why)
{
    const size_t count = (size_t)frames->vertices;

    *net = (struct score_net){.vertices = frames->vertices,
                              .uv = arena_take(arena, 2 * count, sizeof *net->uv)};
    if (!frames->uv)
        return by_position(scene, name, rest ? rest : xyz,
                           rest ? "the rest mesh" : "the first frame", net, why);
    memcpy(net->uv, frames->uv, 2 * count * sizeof *net->uv);
    return STATUS_OK;
}

/* --- sheets with outlines --- */

/* Moves the places of corners, of vt in metres, into the box. */
static void scale_corners(const struct pattern *p, struct frames_net *net, double *place)
{
    double low[2] = {INFINITY, INFINITY};

    for (int n = 0; n < 6 * net->triangles; n++)
        low[n % 2] = fmin(low[n % 2], place[n]);
    for (int n = 0; n < 6 * net->triangles; n++)
        place[n] = (place[n] - low[n % 2]) / p->size[n % 2];
}

/* Takes the cells of the material grid that are on the sheet, each as two triangles. */
static void cut_grid(struct arena *arena, struct frames_net *net)
{
    net->triangle = arena_take(arena, 2 * (size_t)net->vertices, sizeof *net->triangle);
    for (int n = 0; n < 2 * (GRID_U - 1) * (GRID_V - 1); n++) {
        int *c = net->triangle[net->triangles];
        intersection_corners(GRID_U, n, c);
        net->triangles += !net->beside[c[0]] && !net->beside[c[1]] && !net->beside[c[2]];
    }
}

/* Takes the triangles of the scene's own mesh. */
static enum status take_own(struct arena *arena, const struct scene *scene,
                            const char *name, struct frames_net *net, struct message *why)
{
    const struct pattern *p = scene->pattern;
    const struct mesh_flat *own = &p->mesh;
    const int nodes = p->node ? p->nodes : own->nodes;
    const int(*given)[3] = (const int(*)[3])net->triangle;
    const int faces = net->triangles;
    char count[128] = "";

    if (own->triangles)
        snprintf(count, sizeof count,
                 ", and %d vertices, where the mesh of the scene has %d", net->vertices,
                 nodes);
    if (net->vertices != nodes || !own->triangles)
        return status_fail(why, STATUS_INPUT,
                           "%s: has no %s%s; --rest FILE, the rest.obj that export writes, "
                           "would be right",
                           name, p->node ? "places of corners (vt)" : "faces", count);
    net->triangles = own->triangles;
    net->triangle = arena_take(arena, (size_t)own->triangles, sizeof *net->triangle);
    net->corner = arena_take(arena, (size_t)own->triangles, sizeof *net->corner);
    for (int n = 0; n < 3 * own->triangles; n++) {
        const int a = own->triangle[n / 3][n % 3], vertex = p->node ? p->node[a] : a;
        double *place = net->corner[n / 3][n % 3],
               *uv = net->uv ? net->uv + 2L * vertex : NULL;
        net->triangle[n / 3][n % 3] = vertex;
        for (int c = 0; c < 2; c++)
            place[c] = own->at[a][c] / p->size[c];
        if (uv && !p->node && hypot(uv[0] - place[0], uv[1] - place[1]) > EDGE)
            return status_fail(
                why, STATUS_INPUT,
                "%s: vertex %d is at u, v = %g, %g, that of the mesh of %s at "
                "%g, %g; its order, or --rest FILE with faces, would be right",
                name, vertex + 1, uv[0], uv[1], scene->name, place[0], place[1]);
    }
    if (faces &&
        !frames_same_faces(faces, given, net->triangles, (const int(*)[3])net->triangle))
        return status_fail(why, STATUS_INPUT,
                           "%s: its faces are not those of the mesh of %s; these, or "
                           "--rest FILE with vt and the same faces, would be right",
                           name, scene->name);
    return STATUS_OK;
}

enum status score_net_complete(struct arena *arena, const struct scene *scene,
                               const char *name, struct frames_net *net,
                               struct message *why)
{
    if (!scene->pattern) {
        for (int n = 0; net->beside && n < net->vertices; n++)
            if (net->beside[n])
                return status_fail(why, STATUS_INPUT,
                                   "%s: its first frame has no numbers at u = %.3g, v = "
                                   "%.3g, and %s has no outline that leaves it out",
                                   name, net->uv[2 * n], net->uv[2 * n + 1], scene->name);
        return STATUS_OK;
    }
    if (net->beside)
        cut_grid(arena, net);
    else if (net->corner)
        scale_corners(scene->pattern, net, **net->corner);
    else if (!net->triangles || scene->pattern->node)
        CALL(take_own(arena, scene, name, net, why));
    if (net->corner) {
        net->uv = arena_take(arena, 2 * (size_t)net->vertices, sizeof *net->uv);
        for (int n = 3 * net->triangles - 1; n >= 0; n--) /* of several the first */
            memcpy(net->uv + 2L * net->triangle[n / 3][n % 3], net->corner[n / 3][n % 3],
                   sizeof net->corner[n / 3][n % 3]);
    }
    return STATUS_OK;
}

int score_net_grid(int nu, int nv, int n)
{
    return (int)lround((double)(n / nu) * (GRID_V - 1) / (nv - 1)) * GRID_U +
           (int)lround((double)(n % nu) * (GRID_U - 1) / (nu - 1));
}

/* Finds the place of a map's point, and tells whether it is on the sheet. */
static bool point_at(const struct scene *scene, const struct score_map *map, int n,
                     double uv[2])
{
    const int at = score_net_grid(map->nu, map->nv, n);

    uv[0] = scene_sheet_inside(scene, (double)(n % map->nu) / (map->nu - 1));
    uv[1] = (double)(n / map->nu) / (map->nv - 1);
    if (scene->pattern)
        uv[0] = at % GRID_U / (GRID_U - 1.), uv[1] = at / GRID_U / (GRID_V - 1.);
    return !scene_void(scene, at % GRID_U, at / GRID_U);
}

/* --- rows and columns --- */

/* A vertex at its material coordinates. */
struct point {
    double uv[2];
    int vertex;
};

/* Compares what begins with a number by it: points by u, faces by their place. */
static int compare_first(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;

    return (left > right) - (left < right);
}

static int compare_v(const void *a, const void *b)
{
    return compare_first(&((const struct point *)a)->uv[1],
                         &((const struct point *)b)->uv[1]);
}

/* Sorts points by u (d = 0) or v; returns how many distinct values they have. */
static int count_lines(struct point *p, int count, int d)
{
    double line = -INFINITY;
    int lines = 0;

    qsort(p, (size_t)count, sizeof *p, d ? compare_v : compare_first);
    for (int n = 0; n < count; n++)
        if (p[n].uv[d] - line > SAME_LINE) {
            line = p[n].uv[d];
            lines++;
        }
    return lines;
}

/* Sorts points into rows along u, one after another; checks that every crossing of rows and
 * columns has its vertex. */
static bool sort_rows(struct point *p, int columns, int rows, int count)
{
    if (columns < 2 || rows < 2 || (long)columns * rows != count)
        return false;
    qsort(p, (size_t)count, sizeof *p, compare_v);
    for (struct point *row = p; row < p + count; row += columns) {
        const double v = row->uv[1];
        for (int i = 0; i < columns; i++)
            if (row[i].uv[1] - v > SAME_LINE)
                return false;
        qsort(row, (size_t)columns, sizeof *row, compare_first);
        for (int i = 0; i < columns; i++)
            if (fabs(row[i].uv[0] - p[i].uv[0]) > SAME_LINE)
                return false;
    }
    return true;
}

/* Finds the cell, and the place within it from 0 to 1, of x among `count` lines u (d = 0)
 * or v, of which each is `step` points after the one before; outside of them in the cell
 * nearest to it. */
static int cell_of(const struct point *p, int step, int count, int d, double x, double *s)
{
    int low = 0, high = count - 1;

    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (p[(long)middle * step].uv[d] <= x + SAME_LINE)
            low = middle;
        else
            high = middle;
    }
    const double from = p[(long)low * step].uv[d], to = p[(long)(low + 1) * step].uv[d];
    *s = (x - from) / (to - from);
    return low;
}

/* Tells whether two u belong to different sheets. */
static bool is_cut(const struct scene *scene, double u, double other)
{
    double s;

    return scene_sheet_at(scene, u, &s) != scene_sheet_at(scene, other, &s);
}

/* Finds the cell along u as cell_of; of several sheets that of the sheet which has u. */
static int column_of(const struct scene *scene, const struct point *p, int columns,
                     double u, double *s)
{
    int i = cell_of(p, 1, columns, 0, u, s);

    if (!is_cut(scene, p[i].uv[0], p[i + 1].uv[0]))
        return i;
    i += is_cut(scene, p[i].uv[0], u) ? 1 : -1;
    *s = (u - p[i].uv[0]) / (p[i + 1].uv[0] - p[i].uv[0]);
    return i;
}

static void map_rows(const struct scene *scene, const struct point *p, int columns,
                     int rows, struct score_map *map)
{
    for (int n = 0; n < map->nu * map->nv; n++) {
        const double u = scene_sheet_inside(scene, (n % map->nu) / (map->nu - 1.));
        double s, t;
        const int i = column_of(scene, p, columns, u, &s),
                  j = cell_of(p, columns, rows, 1, (n / map->nu) / (map->nv - 1.), &t);
        for (int k = 0; k < 4; k++) {
            map->place[n][k] = p[(long)(j + k / 2) * columns + i + k % 2].vertex;
            map->weight[n][k] = (k % 2 ? s : 1 - s) * (k / 2 ? t : 1 - t);
        }
    }
}

/* --- triangles --- */

static double cross(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Finds the map's points between the triangle's least and greatest u (d = 0) or v, and next
 * to them. */
static void span(const double *const corner[3], int d, int count, int *from, int *to)
{
    const double low = fmin(corner[0][d], fmin(corner[1][d], corner[2][d])),
                 high = fmax(corner[0][d], fmax(corner[1][d], corner[2][d]));

    *from = (int)ceil(fmin(fmax(low - EDGE, 0), 1) * (count - 1));
    *to = (int)floor(fmin(fmax(high + EDGE, 0), 1) * (count - 1));
}

/* Fills the points that lie in the triangle and not deeper in an earlier one. */
static void map_triangle(const struct scene *scene, const double *const corner[3],
                         const int *vertex, double *inside, struct score_map *map)
{
    double height[3];
    int i0, i1, j0, j1;

    const double area = cross(corner[0], corner[1], corner[2]);
    if (fabs(area) < SAME_LINE * SAME_LINE)
        return;
    for (int k = 0; k < 3; k++) {
        const double *a = corner[(k + 1) % 3], *b = corner[(k + 2) % 3];
        height[k] = fabs(area) / hypot(b[0] - a[0], b[1] - a[1]);
    }
    span(corner, 0, map->nu, &i0, &i1);
    span(corner, 1, map->nv, &j0, &j1);
    if (scene->sheets > 1 || scene->pattern) /* those in the void beside it, or moved */
        i0 = i0 > 0 ? i0 - 1 : 0, i1 = i1 < map->nu - 1 ? i1 + 1 : i1;
    if (scene->pattern)
        j0 = j0 > 0 ? j0 - 1 : 0, j1 = j1 < map->nv - 1 ? j1 + 1 : j1;
    for (int j = j0; j <= j1; j++)
        for (int i = i0; i <= i1; i++) {
            const int n = j * map->nu + i;
            double x[2];
            if (!point_at(scene, map, n, x))
                continue;
            const double w[3] = {cross(x, corner[1], corner[2]) / area,
                                 cross(corner[0], x, corner[2]) / area,
                                 cross(corner[0], corner[1], x) / area};
            double least = INFINITY; /* distance from the nearest side, inside */
            for (int k = 0; k < 3; k++)
                least = fmin(least, w[k] * height[k]);
            if (!(least > inside[n]))
                continue;
            inside[n] = least;
            for (int k = 0; k < 4; k++) {
                map->place[n][k] = vertex[k % 3];
                map->weight[n][k] = k < 3 ? w[k] : 0;
            }
        }
}

static enum status map_triangles(const struct score_net *net,
                                 const struct frames_net *frames, const struct scene *scene,
                                 const char *name, struct score_map *map,
                                 struct message *why)
{
    const int points = map->nu * map->nv;
    struct arena own SCOPED(arena_clear) = {0};
    double *inside = arena_take(&own, (size_t)points, sizeof *inside);
    double at[2];
    int bare = -1;

    for (int n = 0; n < points; n++) {
        inside[n] = -EDGE; /* a point may lie so far out of a triangle, in u and v */
        if (frames->beside && !frames->beside[score_net_grid(map->nu, map->nv, n)]) {
            inside[n] = INFINITY; /* it is a vertex */
            for (int k = 0; k < 4; k++)
                map->place[n][k] = score_net_grid(map->nu, map->nv, n);
            map->weight[n][0] = 1;
        }
    }
    for (int n = 0; n < frames->triangles; n++) {
        const int *vertex = frames->triangle[n];
        const double *corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = frames->corner ? frames->corner[n][k] : net->uv + 2L * vertex[k];
        map_triangle(scene, corner, vertex, inside, map);
    }
    for (int n = 0; n < points; n++) {
        const bool on = point_at(scene, map, n, at);
        bare = bare < 0 && on && !(inside[n] > -EDGE) ? n : bare;
        for (int k = 0; !on && k < 4; k++)
            map->weight[n][k] = NAN;
    }
    if (bare < 0)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: its faces leave u = %.3g, v = %.3g of the sheet bare; all of "
                       "%s would be right",
                       name, (double)(bare % map->nu) / (map->nu - 1),
                       (double)(bare / map->nu) / (map->nv - 1),
                       scene->pattern ? "its outline" : "u and v from 0 to 1");
}

/* Checks that each of several sheets has columns from edge to edge. */
static enum status check_sheets(const struct score_net *net, const struct scene *scene,
                                const char *name, struct message *why)
{
    for (int k = 0; k < scene_sheets(scene) && scene->sheets > 1; k++) {
        const double from = scene_sheet_u(scene, k, 0), to = scene_sheet_u(scene, k, 1);
        double first = INFINITY, last = -INFINITY, s;
        for (int n = 0; n < net->vertices; n++)
            if (scene_sheet_at(scene, net->uv[2L * n], &s) == k) {
                first = fmin(first, net->uv[2L * n]);
                last = fmax(last, net->uv[2L * n]);
            }
        if (!(fabs(first - from) <= EDGE && fabs(last - to) <= EDGE))
            return status_fail(why, STATUS_INPUT,
                               "%s: u of sheet %d runs from %.6g to %.6g; from %.6g to "
                               "%.6g, as export writes it, would be right",
                               name, k + 1, first, last, from, to);
    }
    return STATUS_OK;
}

static enum status check_span(const struct score_net *net, const struct frames_net *frames,
                              const struct scene *scene, const char *name,
                              struct message *why)
{
    const double *place = frames->corner ? **frames->corner : net->uv;
    const int places = frames->corner ? 3 * frames->triangles : net->vertices;

    for (int d = 0; d < 2; d++) {
        double first = INFINITY, last = -INFINITY, beyond = INFINITY, before = -INFINITY;
        for (int n = 0; n < places; n++) {
            const double x = place[2 * n + d];
            first = fmin(first, x);
            last = fmax(last, x);
            beyond = x > 1 + EDGE ? fmin(beyond, x) : beyond;
            before = x < -EDGE ? fmax(before, x) : before;
        }
        if (frames->corner && fabs(last - first - 1) > EDGE)
            return status_fail(why, STATUS_INPUT,
                               "%s: its vt span %.4g m along %c; the %.4g m of the pattern "
                               "of %s, as rest.obj of export has them, would be right",
                               name, (last - first) * scene->pattern->size[d], "uv"[d],
                               scene -> pattern -> size[d], scene -> name);
        if (first < -OUTSIDE || last > 1 + OUTSIDE || last > beyond + SAME_LINE ||
            first < before - SAME_LINE)
            return status_fail(
                why, STATUS_INPUT,
                "%s: %c runs from %.6g to %.6g; uv of the sheet must run from "
                "0 to 1, not in metres, pixels or per cent",
                name, "uv"[d], first, last);
        if (first > EDGE || last < 1 - EDGE ||
            (scene->pattern && (first < -EDGE || last > 1 + EDGE)))
            return status_fail(why, STATUS_INPUT,
                               "%s: %c runs from %.6g to %.6g; from 0 to 1, from edge to "
                               "edge of the sheet, would be right",
                               name, "uv"[d], first, last);
    }
    return STATUS_OK;
}

/* Returns the net's vertices at their material coordinates. */
static struct point *points_of(struct arena *arena, const struct score_net *net)
{
    struct point *p = arena_take(arena, (size_t)net->vertices, sizeof *p);

    for (int n = 0; n < net->vertices; n++)
        p[n] = (struct point){{net->uv[2 * n], net->uv[2 * n + 1]}, n};
    return p;
}

/* Lists the vertices that have a weight, and replaces them by their places in the list. */
static void list_used(struct arena *arena, const struct score_net *net,
                      struct score_map *map)
{
    const int count = 4 * map->nu * map->nv;
    struct arena own SCOPED(arena_clear) = {0};
    int *place = arena_take(&own, (size_t)net->vertices, sizeof *place),
        *each = *map->place;

    map->vertex = arena_take(arena, (size_t)count, sizeof *map->vertex);
    for (int n = 0; n < count; n++) {
        if (!place[each[n]]) /* from 1 */
            map->vertex[map->used++] = each[n], place[each[n]] = map->used;
        each[n] = place[each[n]] - 1;
    }
    map->uv = arena_take(arena, (size_t)map->used, sizeof *map->uv);
    for (int n = 0; n < map->used; n++)
        memcpy(map->uv[n], net->uv + 2L * map->vertex[n], sizeof *map->uv);
}

enum status score_net_map(struct arena *arena, struct score_net *net,
                          const struct frames_net *frames, const struct scene *scene,
                          const char *name, int nu, int nv, struct score_map *map,
                          struct message *why)
{
    const size_t points = (size_t)nu * (size_t)nv;
    struct point *p = points_of(arena, net);

    *map = (struct score_map){nu, nv, .sheets = scene->sheets,
                              .place = arena_take(arena, points, sizeof *map->place),
                              .weight = arena_take(arena, points, sizeof *map->weight)};
    CALL(check_span(net, frames, scene, name, why));
    CALL(check_sheets(net, scene, name, why));
    const int columns = count_lines(p, net->vertices, 0),
              rows = count_lines(p, net->vertices, 1);
    if (!scene->pattern && sort_rows(p, columns, rows, net->vertices)) {
        net->columns = columns, net->rows = rows;
        map_rows(scene, p, columns, rows, map);
    } else if (frames->triangles)
        CALL(map_triangles(net, frames, scene, name, map, why));
    else
        return status_fail(why, STATUS_INPUT,
                           "%s: %d vertices are on %d lines u and %d lines v; one at each "
                           "crossing, or faces (OBJ, PLY, --rest), would be right",
                           name, net->vertices, columns, rows);
    list_used(arena, net, map);
    return STATUS_OK;
}

/* Lists the cells' triangles of a net in rows and columns; returns how many, 0: it has
 * none. */
static int cut_cells(struct point *p, const struct score_net *net,
                     const struct scene *scene, int (*corner)[3])
{
    int count = 0;

    const int columns = count_lines(p, net->vertices, 0),
              rows = count_lines(p, net->vertices, 1);
    if (!sort_rows(p, columns, rows, net->vertices))
        return 0;
    for (int n = 0; n < 2 * (columns - 1) * (rows - 1); n++) {
        int *c = corner[count];
        intersection_corners(columns, n, c);
        if (is_cut(scene, p[c[0]].uv[0], p[c[0] + 1].uv[0]))
            continue;
        for (int k = 0; k < 3; k++)
            c[k] = p[c[k]].vertex;
        count++;
    }
    return count;
}

/* A face, and its place among all: in strips along u, from one end of each to the other. */
struct face {
    double place;
    int corner[3];
};

/* Copies faces in the order of their places. */
static void sort_faces(struct face *face, const struct score_net *net,
                       const struct frames_net *frames, int (*corner)[3])
{
    const int count = frames->triangles;
    const double strips = ceil(sqrt(count / 2.));

    for (int n = 0; n < count; n++) {
        double u = 0, v = 0;
        memcpy(face[n].corner, frames->triangle[n], sizeof face[n].corner);
        for (int k = 0; k < 3; k++) {
            u += net->uv[2L * face[n].corner[k]] / 3;
            v += net->uv[2L * face[n].corner[k] + 1] / 3;
        }
        face[n].place = 2 * floor(strips * v) + u;
    }
    qsort(face, (size_t)count, sizeof *face, compare_first);
    for (int n = 0; n < count; n++)
        memcpy(corner[n], face[n].corner, sizeof corner[n]);
}

int (*score_net_triangles(struct arena *arena, const struct score_net *net,
                          const struct frames_net *frames, const struct scene *scene,
                          int *count))[3]
{
    const int faces = frames->triangles;
    const size_t room = (size_t)(faces ? faces : 2 * net->vertices);
    int(*corner)[3] = arena_take(arena, room, sizeof *corner);

    *count = faces ? faces : cut_cells(points_of(arena, net), net, scene, corner);
    if (faces)
        sort_faces(arena_take(arena, room, sizeof(struct face)), net, frames, corner);
    return corner;
}

/* Fills field[nu nv][3] from the values x[used][3] of a map's vertices. */
static void weigh(const struct score_map *map, const double *x, double *field)
{
    for (int n = 0; n < map->nu * map->nv; n++)
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += map->weight[n][k] * x[3 * map->place[n][k] + c];
            field[3 * n + c] = sum;
        }
}

void score_map_apply(const struct score_map *map, const double *xyz, double *field)
{
    struct arena own SCOPED(arena_clear) = {0};
    double *x = arena_take(&own, 3 * (size_t)map->used, sizeof *x);

    for (int n = 0; n < map->used; n++)
        memcpy(x + 3L * n, xyz + 3L * map->vertex[n], 3 * sizeof *x);
    weigh(map, x, field);
}

void score_map_seen(const struct score_map *map, int nu, int nv, const double *field,
                    double *seen)
{
    struct arena own SCOPED(arena_clear) = {0};
    double *x = arena_take(&own, 3 * (size_t)map->used, sizeof *x);

    for (int n = 0; n < map->used; n++)
        score_net_sample(map->sheets, nu, nv, field, map->uv[n], x + 3L * n);
    weigh(map, x, seen);
}
