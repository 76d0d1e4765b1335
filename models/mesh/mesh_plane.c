/* mesh_plane.c - meshes of a flat sheet: from triangles in its plane. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mesh/mesh.h"
#include "models/mesh/mesh_irregular.h"
#include "models/pattern_mesh.h"
#include "models/reader/pattern_file.h"
#include "models/room.h"

/* Where a load acts along a line that may run along edges: so far, in shares of the sheet,
 * beside it. */
static const double BESIDE = 1e-9;

bool mesh_is_grid(const struct scene *scene, const struct discretization *d)
{
    return !scene->pattern && (!d->mesh || !strcmp(d->mesh, "grid"));
}

static const double *at(const struct mesh *mesh, int triangle, int corner)
{
    return mesh_flat_place(&mesh->flat, triangle, corner);
}

struct mesh_plane mesh_plane_of(const struct mesh *mesh, int triangle)
{
    struct mesh_plane p;

    for (int i = 0; i < 3; i++) {
        const double *a = at(mesh, triangle, (i + 1) % 3);
        const double *b = at(mesh, triangle, (i + 2) % 3);
        const double d[2] = {b[0] - a[0], b[1] - a[1]};
        p.length[i] = hypot(d[0], d[1]);
        p.along[i][0] = d[0] / p.length[i], p.along[i][1] = d[1] / p.length[i];
        p.out[i][0] = p.along[i][1], p.out[i][1] = -p.along[i][0];
    }
    p.area = p.length[0] * p.length[1] / 2 *
             (p.along[0][0] * p.along[1][1] - p.along[0][1] * p.along[1][0]);
    return p;
}

/* Returns the place of an edge's end in one of its triangles. */
static const double *end_in(const struct mesh *mesh, int edge, int beside, int end)
{
    const int t = mesh->edge[edge].triangle[beside], *v = mesh->flat.triangle[t];

    return at(mesh, t, mesh_flat_corner(v, mesh->edge[edge].node[end]));
}

bool mesh_edge_ends(const struct mesh *mesh, int edge)
{
    bool ends = mesh->edge[edge].triangle[1] < 0;

    for (int end = 0; !ends && mesh->flat.corner && end < 2; end++)
        ends |= memcmp(end_in(mesh, edge, 0, end), end_in(mesh, edge, 1, end),
                       2 * sizeof(double)) != 0;
    return ends;
}

double mesh_edge_length(const struct mesh *mesh, int edge)
{
    const int sides = mesh->edge[edge].triangle[1] < 0 ? 1 : 2;
    double sum = 0;

    for (int s = 0; s < sides; s++) {
        const double *a = end_in(mesh, edge, s, 0), *b = end_in(mesh, edge, s, 1);
        sum += hypot(b[0] - a[0], b[1] - a[1]) / sides;
    }
    return sum;
}

double mesh_plane_rise(const struct mesh_plane *p, int i, int j)
{
    return -(p->out[i][0] * p->out[j][0] + p->out[i][1] * p->out[j][1]) * p->length[j] /
           (2 * p->area);
}

/* --- lists of triangles: around points, and in bins --------------------------------------
 */

/* Visits the bins that a triangle reaches. */
static void visit_bins(const struct mesh *mesh, const double size[2], int t, bool fill)
{
    int from[2], to[2];

    for (int i = 0; i < 2; i++) {
        double low = INFINITY, high = -INFINITY;
        for (int c = 0; c < 3; c++) {
            low = fmin(low, at(mesh, t, c)[i]);
            high = fmax(high, at(mesh, t, c)[i]);
        }
        from[i] = (int)fmax(floor(low / size[i] * mesh->bins[i] - BESIDE), 0);
        to[i] =
            (int)fmin(floor(high / size[i] * mesh->bins[i] + BESIDE), mesh->bins[i] - 1);
    }
    for (int i = from[0]; i <= to[0]; i++)
        for (int j = from[1]; j <= to[1]; j++) {
            const int b = i * mesh->bins[1] + j;
            if (fill)
                mesh->bin[mesh->bin_at[b + 1]++] = t;
            else
                mesh->bin_at[b + 2]++;
        }
}

/* Turns counts of lists, two places on, into their starts one place on, which filling them
 * moves to their ends: the starts of the next. */
static void sum_up(int *from, int count)
{
    for (int n = 0; n < count; n++)
        from[n + 1] += from[n];
}

static enum status make_lists(struct mesh *mesh, const double size[2])
{
    const int triangles = mesh->flat.triangles, vertices = mesh->vertices;
    const int bins = (int)fmax(1, sqrt(triangles / 2.));
    enum status st;

    mesh->bins[0] = mesh->bins[1] = bins;
    mesh->ring_at = calloc((size_t)vertices + 2, sizeof *mesh->ring_at);
    mesh->bin_at = calloc((size_t)bins * (size_t)bins + 2, sizeof *mesh->bin_at);
    if (!mesh->ring_at || !mesh->bin_at)
        return STATUS_MEMORY;
    for (int t = 0; t < triangles; t++) {
        visit_bins(mesh, size, t, false);
        for (int c = 0; c < 3; c++)
            mesh->ring_at[mesh->flat.triangle[t][c] + 2]++;
    }
    sum_up(mesh->bin_at, bins * bins + 1);
    sum_up(mesh->ring_at, vertices + 1);
    TRY(room_cut(&mesh->lists, ROOM(mesh->ring, 3 * triangles),
                 ROOM(mesh->bin, mesh->bin_at[bins * bins + 1])));
    for (int t = 0; t < triangles; t++) {
        visit_bins(mesh, size, t, true);
        for (int c = 0; c < 3; c++)
            mesh->ring[mesh->ring_at[mesh->flat.triangle[t][c] + 1]++] = t;
    }
out:
    return st;
}

int mesh_find(const struct mesh *mesh, const double uv[2], double weight[3])
{
    const double p[2] = {uv[0] * mesh->size[0], uv[1] * mesh->size[1]};
    double best = -INFINITY, now[3];
    int cell[2], found = -1;

    for (int i = 0; i < 2; i++)
        cell[i] = (int)fmin(fmax(floor(uv[i] * mesh->bins[i]), 0), mesh->bins[i] - 1);
    const int b = cell[0] * mesh->bins[1] + cell[1];
    for (int n = mesh->bin_at[b]; n < mesh->bin_at[b + 1]; n++) {
        const double least = mesh_flat_weigh(&mesh->flat, mesh->bin[n], p, now);
        if (least <= best)
            continue;
        best = least, found = mesh->bin[n];
        memcpy(weight, now, sizeof now);
    }
    return found;
}

/* --- making one -------------------------------------------------------------------------
 */

static void set_points(struct mesh *mesh, const struct scene *scene)
{
    for (int a = 0; a < mesh->vertices; a++) {
        mesh->uvw[a][0] = mesh->flat.at[a][0] / scene->length;
        mesh->uvw[a][1] = mesh->flat.at[a][1] / scene->width;
        mesh->uvw[a][2] = 0.5;
        if (mesh->flat.start)
            scene_pose_point(scene, mesh->flat.start[a], mesh->rest + 3 * (size_t)a);
        else
            scene_rest_point(scene, mesh->uvw[a], mesh->rest + 3 * (size_t)a);
    }
    for (int t = 0; t < mesh->flat.triangles; t++)
        for (int c = 0; c < 3; c++)
            mesh->area[mesh->flat.triangle[t][c]] +=
                mesh_flat_left(at(mesh, t, 0), at(mesh, t, 1), at(mesh, t, 2)) / 6;
}

/* Adds the slope across an edge where the sheet starts in space: the mean of those of both
 * triangles. */
static void slope_in_space(const struct mesh *mesh, const struct mesh_edge *e,
                           double slope[3])
{
    const int sides = e->triangle[1] < 0 ? 1 : 2;

    for (int s = 0; s < sides; s++) {
        const int t = e->triangle[s], *v = mesh->flat.triangle[t];
        const int c = mesh_flat_corner(v, e->node[2 + s]);
        const struct mesh_plane p = mesh_plane_of(mesh, t);
        for (int n = 0; n < 9; n++)
            slope[n % 3] += (s ? -1 : 1) * mesh->scale / sides *
                            mesh_plane_rise(&p, c, n / 3) *
                            mesh->rest[3 * (size_t)v[n / 3] + (size_t)(n % 3)];
    }
}

/* Those at edges are unknowns, but for edges of which both ends are clamped. */
static void set_edges(struct mesh *mesh, const struct scene *scene, bool slopes)
{
    for (int a = mesh->vertices; a < mesh->nodes; a++) {
        const int *end = mesh->edge[a - mesh->vertices].node;
        const double *from = mesh->flat.at[end[0]], *to = mesh->flat.at[end[1]];
        const double length = hypot(to[0] - from[0], to[1] - from[1]);
        const double out[2] = {(to[1] - from[1]) / length, (from[0] - to[0]) / length};
        const struct scene_pose *pose = &scene->pose[0];
        mesh->uvw[a][2] = mesh->clamped[end[0]] && mesh->clamped[end[1]] ? SUPPORTS_NONE
                          : slopes                                       ? SUPPORTS_THREE
                                                                         : SUPPORTS_ONE;
        if (slopes && mesh->flat.start)
            slope_in_space(mesh, &mesh->edge[a - mesh->vertices],
                           mesh->rest + 3 * (size_t)a);
        for (int i = 0; slopes && !mesh->flat.start && i < 3; i++)
            mesh->rest[3 * (size_t)a + (size_t)i] =
                mesh->scale * (out[0] * pose->axis_u[i] + out[1] * pose->axis_v[i]);
    }
}

void mesh_weigh_edges(const struct mesh *mesh, double areal, double *mass)
{
    for (int t = 0; mesh->nodes > mesh->vertices && t < mesh->flat.triangles; t++) {
        const struct mesh_plane p = mesh_plane_of(mesh, t);
        for (int i = 0; i < 3; i++) {
            const double height = 2 * p.area / p.length[i] / mesh->scale;
            mass[mesh->vertices + mesh->side[t][i]] +=
                areal * p.area * height * height / 30;
        }
    }
}

/* Takes the scene's own triangles, or makes some: as many points in the box as a grid of
 * d->points would have. */
static enum status make_outline(struct mesh_flat *flat, const struct scene *scene,
                                const struct discretization *d, struct message *why)
{
    const double cells = (d->points[0] - 1.) * (d->points[1] - 1.);

    if (d->mesh && scene->pattern->node)
        return status_fail(
            why, STATUS_INPUT,
            "mesh=%s: the sheet is sewn together or starts in space, and has "
            "a mesh of its own, which refine=1 makes finer; leave it out",
            d->mesh);
    if (!scene->pattern->mesh.nodes || d->mesh)
        return pattern_mesh(scene, sqrt(scene->length * scene->width / cells / sqrt(0.75)),
                            d->seed, flat);
    return pattern_sewn(scene->pattern, flat);
}

static enum status make_flat(struct mesh_flat *flat, const struct scene *scene,
                             const struct discretization *d, struct message *why)
{
    const bool irregular = d->mesh && !strcmp(d->mesh, "irregular");
    const bool diagonal = d->mesh && !strcmp(d->mesh, "diagonal");
    const double side[2] = {scene->length, scene->width};
    enum status st;

    if (scene->pattern)
        TRY(make_outline(flat, scene, d, why));
    else if (mesh_is_grid(scene, d) || irregular || diagonal)
        TRY(mesh_flat_grid(flat, side, d->points, !diagonal));
    else
        TRY(pattern_file_read(d->mesh, side, flat, why));
    if (irregular && !scene->pattern)
        TRY(mesh_irregular(flat, scene, d->points, d->seed));
    for (int n = 0; n < d->refine; n++)
        TRY(mesh_flat_refine(flat));
out:
    return st;
}

enum status mesh_make(struct mesh *mesh, const struct scene *scene,
                      const struct discretization *d, enum mesh_edges at_edges,
                      struct message *why)
{
    const bool turns = at_edges != MESH_NO_NODES;
    struct mesh new = {.size = {scene->length, scene->width}};
    enum status st;

    if (mesh_is_grid(scene, d) && !turns)
        return mesh_init(mesh, scene, d->points);
    TRY(make_flat(&new.flat, scene, d, why));
    TRY(mesh_flat_edges(&new.flat, &new.edge, &new.edges, &new.side));
    new.vertices = new.flat.nodes;
    new.nodes = new.vertices + (turns ? new.edges : 0);
    new.scale = sqrt(scene_area(scene) / new.vertices);
    new.points[0] = 1, new.points[1] = new.nodes;
    new.cell[0] = new.cell[1] = new.scale;
    if (mesh_is_grid(scene, d) && !d->refine) {
        new.rows = new.points[0] = d->points[0], new.points[1] = d->points[1];
        new.cell[0] = scene->length / (d->points[0] - 1);
        new.cell[1] = scene->width / (d->points[1] - 1);
    }
    TRY(room_cut(&new.room, ROOM(new.uvw, new.nodes), ROOM(new.rest, 3 * new.nodes),
                 ROOM(new.area, new.nodes), ROOM(new.clamped, new.nodes)));
    set_points(&new, scene);
    mesh_clamp(&new, scene);
    set_edges(&new, scene, at_edges == MESH_SLOPES);
    TRY(make_lists(&new, new.size));
    HAND_OVER(mesh, new);
out:
    mesh_clear(&new);
    return st;
}

/* --- order ------------------------------------------------------------------------------
 */

struct place {
    double along;
    int node;
};

static int compare(const void *a, const void *b)
{
    const struct place *p = a, *q = b;

    return p->along != q->along ? (p->along < q->along ? -1 : 1)
                                : (p->node > q->node) - (p->node < q->node);
}

enum status mesh_order_plane(const struct mesh *mesh, int **order)
{
    const int i = mesh->size[0] >= mesh->size[1] ? 0 : 1;
    struct place *place = malloc((size_t)mesh->nodes * sizeof *place);
    enum status st = STATUS_OK;

    *order = malloc((size_t)mesh->nodes * sizeof **order);
    TRY(place && *order ? STATUS_OK : STATUS_MEMORY);
    for (int a = 0; a < mesh->nodes; a++) {
        const int *end = a < mesh->vertices ? NULL : mesh->edge[a - mesh->vertices].node;
        place[a].node = a;
        place[a].along = end ? (mesh->flat.at[end[0]][i] + mesh->flat.at[end[1]][i]) / 2
                             : mesh->flat.at[a][i];
    }
    qsort(place, (size_t)mesh->nodes, sizeof *place, compare);
    for (int k = 0; k < mesh->nodes; k++)
        (*order)[k] = place[k].node;
out:
    free(place);
    if (st != STATUS_OK)
        free(*order), *order = NULL;
    return st;
}

/* --- loads ------------------------------------------------------------------------------
 */

enum { MOST_CORNERS = 8 };

/* A convex polygon. */
struct polygon {
    int count;
    double at[MOST_CORNERS][2];
};

/* Cuts off what lies beyond a line across `along`: below it, or above. */
static void cut(struct polygon *p, int along, double line, bool below)
{
    struct polygon left = {0};

    for (int n = 0; n < p->count; n++) {
        const double *a = p->at[n], *b = p->at[(n + 1) % p->count];
        const double da = below ? a[along] - line : line - a[along];
        const double db = below ? b[along] - line : line - b[along];
        if (da >= 0)
            memcpy(left.at[left.count++], a, sizeof *left.at);
        if (da * db < 0)
            for (int i = 0; i < 2; i++)
                left.at[left.count][i] = a[i] + da / (da - db) * (b[i] - a[i]);
        left.count += da * db < 0;
    }
    *p = left;
}

/* Adds to `share` the integrals of a triangle's hat functions over what a load's place,
 * lo[2] to hi[2], has of it: over an area, along a line, or at a point. */
static void add_integrals(const struct mesh *mesh, int t, const double lo[2],
                          const double hi[2], double *share)
{
    const bool flat[2] = {hi[0] <= lo[0], hi[1] <= lo[1]};
    struct polygon p = {3};
    double w[3], middle[2];

    for (int c = 0; c < 3; c++)
        memcpy(p.at[c], at(mesh, t, c), sizeof *p.at);
    for (int i = 0; i < 2; i++) {
        if (flat[i])
            continue;
        cut(&p, i, lo[i], true);
        cut(&p, i, hi[i], false);
    }
    for (int n = 0; !flat[0] && !flat[1] && n + 2 < p.count; n++) {
        const double part = mesh_flat_left(p.at[0], p.at[n + 1], p.at[n + 2]) / 2;
        for (int i = 0; i < 2; i++)
            middle[i] = (p.at[0][i] + p.at[n + 1][i] + p.at[n + 2][i]) / 3;
        mesh_flat_weigh(&mesh->flat, t, middle, w);
        for (int c = 0; c < 3; c++)
            share[mesh->flat.triangle[t][c]] += part * w[c];
    }
    if (flat[0] == flat[1])
        return;
    const int across = flat[0] ? 0 : 1;
    double end[2] = {INFINITY, -INFINITY}; /* of the line in the polygon */
    for (int n = 0; n < p.count; n++) {
        const double *a = p.at[n], *b = p.at[(n + 1) % p.count];
        const double da = a[across] - lo[across], db = b[across] - lo[across];
        if (da * db >= 0)
            continue;
        const double cross =
            a[1 - across] + da / (da - db) * (b[1 - across] - a[1 - across]);
        end[0] = fmin(end[0], cross), end[1] = fmax(end[1], cross);
    }
    if (!(end[1] > end[0]))
        return;
    middle[across] = lo[across], middle[1 - across] = (end[0] + end[1]) / 2;
    mesh_flat_weigh(&mesh->flat, t, middle, w);
    for (int c = 0; c < 3; c++)
        share[mesh->flat.triangle[t][c]] += (end[1] - end[0]) * w[c];
}

/* Adds a load's force, shared by its integrals of the hat functions; false: it lies beside
 * the sheet. */
static bool add_load(const struct mesh *mesh, const struct scene_load *load, double *share,
                     double *f)
{
    double lo[2], hi[2], sum = 0, w[3];

    memset(share, 0, (size_t)mesh->vertices * sizeof *share);
    for (int i = 0; i < 2; i++) {
        const bool flat = load->hi[i] <= load->lo[i];
        const double beside = fmin(load->lo[i] + BESIDE, 1 - BESIDE);
        lo[i] = (flat ? beside : load->lo[i]) * mesh->size[i];
        hi[i] = flat ? lo[i] : load->hi[i] * mesh->size[i];
    }
    if (hi[0] <= lo[0] && hi[1] <= lo[1]) {
        const int t = mesh_find(mesh, load->lo, w);
        const bool within = t >= 0 && fmin(w[0], fmin(w[1], w[2])) >= -BESIDE;
        for (int c = 0; within && c < 3; c++)
            share[mesh->flat.triangle[t][c]] = w[c];
    } else {
        for (int t = 0; t < mesh->flat.triangles; t++)
            add_integrals(mesh, t, lo, hi, share);
    }
    for (int a = 0; a < mesh->vertices; a++)
        sum += share[a];
    for (int n = 0; sum > 0 && n < 3 * mesh->vertices; n++)
        f[n] += share[n / 3] / sum * load->force[n % 3];
    return sum > 0;
}

enum status mesh_add_loads(const struct mesh *mesh, const struct scene *scene, double *f)
{
    double *share = malloc((size_t)mesh->vertices * sizeof *share);

    enum status st = share ? STATUS_OK : STATUS_MEMORY;

    for (int n = 0; st == STATUS_OK && n < scene->load_count; n++)
        st = add_load(mesh, &scene->loads[n], share, f) ? STATUS_OK : STATUS_INPUT;
    free(share);
    return st;
}
