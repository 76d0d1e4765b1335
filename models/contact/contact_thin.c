#include "models/contact/contact_thin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_foot.h"
#include "models/contact/contact_limit.h"
#include "models/bodies/body_mesh.h"
#include "models/room.h"
#include "models/vector.h"

/* The share of its radius to which a ball in a thick body reaches the face behind it. */
static const double THICK = 0.8;
/* How far beside a triangle a feature may seem to pass it, over its way across: what turns
 * in a step moves along curves. */
static const double BESIDE = 0.02;
/* How far a smooth surface is off the triangles between its samples, over s, where it bends
 * to the radius s. */
static const double BULGE = 0.125;

void contact_thin_clear(struct contact_thin *t)
{
    free(t->feature);
    free(t->room);
    free(t->pair);
    memset(t, 0, sizeof *t);
}

/* --- features ---------------------------------------------------------------------------
 */

static enum status add_feature(struct contact_thin *t, struct contact_feature f)
{
    if (t->count == t->most) {
        const int most = 2 * t->most + 64;
        struct contact_feature *all = realloc(t->feature, (size_t)most * sizeof *all);
        if (!all)
            return STATUS_MEMORY;
        t->feature = all, t->most = most;
    }
    t->feature[t->count++] = f;
    return STATUS_OK;
}

/* Adds the points of a segment, both ends included. */
static enum status add_segment(struct contact_thin *t, int obstacle, const double a[3],
                               const double b[3], double radius)
{
    struct contact_feature f = {.obstacle = obstacle, .radius = radius};
    const double length = vector_distance(a, b), s = t->spacing;
    const int parts = (int)fmin(ceil(2 * length / s), 1e6); /* of a body of any length */
    enum status st = STATUS_OK;

    memcpy(f.end[0], a, sizeof f.end[0]);
    memcpy(f.end[1], b, sizeof f.end[1]);
    for (int k = 0; k <= parts; k++) {
        const double on = parts ? (double)k / parts : 0;
        const double part = parts ? length / parts : s;
        for (int i = 0; i < 3; i++)
            f.at[i] = (1 - on) * a[i] + on * b[i];
        f.area = s * (parts && (k == 0 || k == parts) ? part / 2 : part);
        TRY(add_feature(t, f));
    }
out:
    return st;
}

static enum status add_box(struct contact_thin *t, int obstacle)
{
    const struct scene_obstacle *o = &t->scene->obstacles[obstacle];
    double axis[3][3], corner[8][3];
    enum status st = STATUS_OK;

    if (fmin(fmin(o->size[0], o->size[1]), o->size[2]) >= 2 * t->spacing)
        return STATUS_OK;
    memcpy(axis, o->axis, sizeof o->axis);
    vector_cross(axis[0], axis[1], axis[2]);
    for (int n = 0; n < 8; n++)
        for (int i = 0; i < 3; i++) {
            corner[n][i] = o->point[i];
            for (int k = 0; k < 3; k++)
                corner[n][i] += (n >> k & 1 ? 0.5 : -0.5) * o->size[k] * axis[k][i];
        }
    for (int n = 0; n < 8; n++)
        for (int k = 0; k < 3; k++)
            if (!(n >> k & 1))
                TRY(add_segment(t, obstacle, corner[n], corner[n | 1 << k], 0));
out:
    return st;
}

/* Tells whether a mesh is thin under a point of it with this normal; without one it is on a
 * rim. */
static bool is_thin(const struct contact_thin *t, const struct obstacle_mesh *mesh,
                    const double at[3], const double normal[3])
{
    const double size = vector_length(normal);
    double inside[3];

    if (size == 0)
        return true;
    for (int i = 0; i < 3; i++)
        inside[i] = at[i] - t->spacing * normal[i] / size;
    return body_mesh_distance(mesh, inside, INFINITY, NULL) > -THICK * t->spacing;
}

static enum status add_mesh(struct contact_thin *t, int obstacle)
{
    const struct obstacle_mesh *mesh = t->scene->obstacles[obstacle].mesh;
    enum status st = STATUS_OK;
    bool *thin = NULL, *seen;

    if (!mesh)
        return STATUS_OK;
    const struct body_mesh_view view = body_mesh_view(mesh);
    TRY(room_cut((void **)&thin, ROOM(thin, view.vertices), ROOM(seen, view.vertices)));
    for (int n = 0; n < 3 * view.triangles; n++) {
        const int vertex = view.triangle[n / 3][n % 3];
        const double *at = view.vertex[vertex];
        if (seen[vertex])
            continue;
        seen[vertex] = true;
        thin[vertex] = is_thin(t, mesh, at, view.bend[vertex]);
        if (thin[vertex])
            TRY(add_segment(t, obstacle, at, at, 0));
    }
    for (int n = 0; n < 3 * view.triangles; n++) {
        const int *corner = view.triangle[n / 3], a = corner[n % 3],
                  b = corner[(n + 1) % 3];
        double middle[3], normal[3];
        if (!thin[a] || !thin[b] || !body_mesh_edge(mesh, n, normal))
            continue;
        for (int i = 0; i < 3; i++)
            middle[i] = (view.vertex[a][i] + view.vertex[b][i]) / 2;
        if (is_thin(t, mesh, middle, normal))
            TRY(add_segment(t, obstacle, view.vertex[a], view.vertex[b], 0));
    }
out:
    free(thin);
    return st;
}

static enum status add_body(struct contact_thin *t, int obstacle)
{
    const struct scene_obstacle *o = &t->scene->obstacles[obstacle];
    const bool slim = o->radius < t->spacing;

    if (o->kind == OBSTACLE_SPHERE && slim)
        return add_segment(t, obstacle, o->point, o->point, o->radius);
    if (o->kind == OBSTACLE_CAPSULE && slim)
        return add_segment(t, obstacle, o->point, o->end, o->radius);
    if (o->kind == OBSTACLE_BOX)
        return add_box(t, obstacle);
    return o->kind == OBSTACLE_MESH ? add_mesh(t, obstacle) : STATUS_OK;
}

enum status contact_thin_init(struct contact_thin *t, const struct scene *scene,
                              const struct contact_surface *surface, double start)
{
    enum status st = STATUS_OK;
    const size_t values = 3 * (size_t)surface->count;

    *t = (struct contact_thin){
        .surface = surface, .scene = scene, .start = start, .spacing = surface->spacing};
    for (int o = 0; o < scene->obstacle_count; o++)
        TRY(add_body(t, o));
    if (t->count)
        TRY(room_cut(&t->room, ROOM(t->q, t->count), ROOM(t->q_old, t->count),
                     ROOM(t->passed, t->count), ROOM(t->least, t->count),
                     ROOM(t->least_old, t->count), ROOM(t->box, t->count),
                     ROOM(t->y, values), ROOM(t->y_old, values),
                     ROOM(t->weight, contact_foot_width(surface) + 3),
                     ROOM(t->node, contact_foot_width(surface) + 3)));
out:
    if (st)
        contact_thin_clear(t);
    return st;
}

/* --- pairs that come near each other ----------------------------------------------------
 */

static void include(struct contact_thin_box *b, const double x[3], double reach)
{
    for (int i = 0; i < 3; i++) {
        b->low[i] = x[i] - reach < b->low[i] ? x[i] - reach : b->low[i];
        b->high[i] = x[i] + reach > b->high[i] ? x[i] + reach : b->high[i];
    }
}

/* Returns the box of a way, with a reach around it. */
static struct contact_thin_box box_of(const double a[3], const double b[3], double reach)
{
    struct contact_thin_box box = {{a[0] - reach, a[1] - reach, a[2] - reach},
                                   {a[0] + reach, a[1] + reach, a[2] + reach}};

    include(&box, b, reach);
    return box;
}

static bool meets(const struct contact_thin_box *a, const struct contact_thin_box *b)
{
    for (int i = 0; i < 3; i++)
        if (a->low[i] > b->high[i] || a->high[i] < b->low[i])
            return false;
    return true;
}

static enum status add_pair(struct contact_thin *t, int feature, int triangle)
{
    if (t->pairs == t->pair_room) {
        const int room = 2 * t->pair_room + 64;
        struct contact_thin_pair *pair = realloc(t->pair, (size_t)room * sizeof *pair);
        if (!pair)
            return STATUS_MEMORY;
        t->pair = pair, t->pair_room = room;
    }
    t->pair[t->pairs++] =
        (struct contact_thin_pair){.feature = feature, .triangle = triangle};
    return STATUS_OK;
}

/* Adds the pairs of these features with the triangles of a mesh. */
static enum status pair_triangles(struct contact_thin *t, int first, int end,
                                  const struct contact_thin_box *all)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < t->surface->mesh.count; n++) {
        const int *corner = t->surface->mesh.corner[n];
        struct contact_thin_box box =
            box_of(t->y + 3L * corner[0], t->y_old + 3L * corner[0], 0);
        for (int k = 1; k < 3; k++) {
            include(&box, t->y + 3L * corner[k], 0);
            include(&box, t->y_old + 3L * corner[k], 0);
        }
        for (int f = first; f < end && meets(&box, all); f++)
            if (meets(&box, &t->box[f]))
                TRY(add_pair(t, f, n));
    }
out:
    return st;
}

/* Adds the pairs of the features from `first` up to `end`, which `all` holds. */
static enum status pair_cells(struct contact_thin *t, int first, int end,
                              const struct contact_thin_box *all)
{
    const struct contact_surface *s = t->surface;
    const int m = s->points[1];
    enum status st = STATUS_OK;

    if (s->mesh.count)
        return pair_triangles(t, first, end, all);
    for (int n = 0; n < s->count - m; n++) {
        const double *y = t->y + 3L * n, *old = t->y_old + 3L * n;
        if (n % m == m - 1 || contact_surface_cut(s, n / m))
            continue;
        struct contact_thin_box cell = box_of(y, old, 0);
        for (int k = 1; k < 4; k++) {
            include(&cell, y + 3L * (k / 2 * m + k % 2), 0);
            include(&cell, old + 3L * (k / 2 * m + k % 2), 0);
        }
        for (int f = first; f < end && meets(&cell, all); f++)
            for (int k = 0; k < 2 && meets(&cell, &t->box[f]); k++)
                TRY(add_pair(t, f, 2 * n + k));
    }
out:
    return st;
}

/* Lists the pairs near each other between two times, at which features and samples are
 * placed. */
static enum status list_pairs(struct contact_thin *t)
{
    const double slack = t->surface->width > 1 ? BULGE * t->spacing : 0;
    const struct contact_feature *f = t->feature;
    enum status st = STATUS_OK;

    t->pairs = 0;
    for (int n = 0; n < t->count; n++)
        t->box[n] = box_of(t->q[n], t->q_old[n], f[n].radius + t->start + slack);
    for (int first = 0, end; first < t->count; first = end) {
        struct contact_thin_box all = t->box[first];
        for (end = first; end < t->count && f[end].obstacle == f[first].obstacle; end++) {
            include(&all, t->box[end].low, 0);
            include(&all, t->box[end].high, 0);
        }
        TRY(pair_cells(t, first, end, &all));
    }
out:
    return st;
}

static void place_features(const struct contact_thin *t, const struct scene_placement *pose,
                           double (*q)[3])
{
    for (int f = 0; f < t->count; f++)
        scene_placement_point(&pose[t->feature[f].obstacle], t->feature[f].at, q[f]);
}

static void place_samples(const struct contact_thin *t, const double *x, double *y)
{
    for (int n = 0; n < t->surface->count; n++)
        contact_surface_at(t->surface, n, x, y + 3L * n);
}

/* --- a feature and a triangle -----------------------------------------------------------
 */

/* The corners of a triangle at a share of the way from y_old to y. */
struct corners {
    double y[3][3], normal[3]; /* [m]; of length 1, 0: there is none                    */
    double share[3];           /* of the place that find_place found                    */
};

static struct corners corners_at(const struct contact_thin *t, int triangle, double share)
{
    struct corners c;
    double e[2][3];
    int sample[3];

    contact_foot_corners(t->surface, triangle, sample);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            c.y[k][i] = (1 - share) * t->y_old[3L * sample[k] + i] +
                        share * t->y[3L * sample[k] + i];
    for (int k = 0; k < 2; k++)
        vector_between(c.y[0], c.y[k + 1], e[k]);
    vector_cross(e[0], e[1], c.normal);
    const double size = vector_length(c.normal);
    for (int i = 0; i < 3 && size > 0; i++)
        c.normal[i] /= size;
    return c;
}

/* Finds the place of a triangle that is closest to q; fills t->node and t->weight, and
 * returns how many there are. */
static int find_place(struct contact_thin *t, int triangle, struct corners *c,
                      const double q[3])
{
    const struct contact_surface *s = t->surface;
    double u, v;
    int sample[3];

    contact_foot_nearest(q, (const double *const[]){c->y[0], c->y[1], c->y[2]}, c->share);
    if (s->smooth) {
        contact_foot_place(s, triangle, c->share, &u, &v);
        return s->row(s->self, u, v, t->node, t->weight);
    }
    contact_foot_corners(s, triangle, sample);
    return contact_surface_mix(s, 3, sample, c->share, t->node, t->weight);
}

/* Computes at = the sum of weights times x[nodes][3]. */
static void sum_up(const struct contact_thin *t, int count, const double *x, double at[3])
{
    at[0] = at[1] = at[2] = 0;
    for (int k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            at[i] += t->weight[k] * x[3L * t->node[k] + i];
}

/* Computes the way from the segment of a feature to a place, and returns its length. */
static double way_from(const struct contact_thin *t, int feature,
                       const struct scene_placement *pose, const double at[3],
                       double way[3])
{
    const struct contact_feature *f = &t->feature[feature];
    double end[2][3], e[3];

    for (int k = 0; k < 2; k++)
        scene_placement_point(&pose[f->obstacle], f->end[k], end[k]);
    vector_between(end[0], end[1], e);
    vector_between(end[0], at, way);
    const double square = vector_dot(e, e);
    const double on = square > 0 ? fmin(fmax(vector_dot(way, e) / square, 0), 1) : 0;
    for (int i = 0; i < 3; i++)
        way[i] -= on * e[i];
    return vector_length(way);
}

/* Returns the distance of a pair from the axis at the start of a step (end 0) or its end,
 * 1; *height: that of its feature over the plane through the place. */
static double measure(struct contact_thin *t, const struct contact_thin_pair *p,
                      const struct contact_thin_step *step, int end, double *height)
{
    const double *q = end ? t->q[p->feature] : t->q_old[p->feature];
    struct corners c = corners_at(t, p->triangle, end);
    double at[3], way[3];

    sum_up(t, find_place(t, p->triangle, &c, q), end ? step->x : step->x_old, at);
    vector_between(at, q, way);
    *height = vector_dot(way, c.normal);
    return way_from(t, p->feature, end ? step->pose : step->pose_old, at, way);
}

/* Tells whether the feature is within the triangle when it is in its plane: at the share of
 * the step at which its height, from one to the other, is 0. */
static bool passes(const struct contact_thin *t, const struct contact_thin_pair *p)
{
    const double on = p->before / (p->before - p->after);
    const double most = BESIDE * fabs(p->before - p->after);
    const struct corners c = corners_at(t, p->triangle, on);
    double q[3], share[3], way[3];

    for (int i = 0; i < 3; i++)
        q[i] = (1 - on) * t->q_old[p->feature][i] + on * t->q[p->feature][i];
    contact_foot_nearest(q, (const double *const[]){c.y[0], c.y[1], c.y[2]}, share);
    for (int i = 0; i < 3; i++)
        way[i] = q[i] - share[0] * c.y[0][i] - share[1] * c.y[1][i] - share[2] * c.y[2][i];
    const double along = vector_dot(way, c.normal);
    return vector_dot(way, way) - along * along <= most * most;
}

/* Returns -1 for a pair whose feature the step has carried through it, else 1. */
static int side_of(const struct contact_thin *t, const struct contact_thin_pair *p)
{
    return t->passed[p->feature] && p->before * p->after < 0 ? -1 : 1;
}

enum status contact_thin_look(struct contact_thin *t, const struct contact_thin_step *step,
                              int *passed)
{
    enum status st = STATUS_OK;

    *passed = 0;
    if (!t->count)
        return STATUS_OK;
    place_features(t, step->pose_old, t->q_old);
    place_features(t, step->pose, t->q);
    place_samples(t, step->x_old, t->y_old);
    place_samples(t, step->x, t->y);
    TRY(list_pairs(t));
    for (int f = 0; f < t->count; f++)
        t->passed[f] = false, t->least[f] = t->least_old[f] = INFINITY;
    for (struct contact_thin_pair *p = t->pair; p < t->pair + t->pairs; p++) {
        const int f = p->feature;
        t->least_old[f] = fmin(t->least_old[f], measure(t, p, step, 0, &p->before));
        p->distance = measure(t, p, step, 1, &p->after);
        if (!t->passed[f] && p->before * p->after < 0 && passes(t, p))
            t->passed[f] = true, ++*passed;
    }
    for (struct contact_thin_pair *p = t->pair; p < t->pair + t->pairs; p++) {
        p->distance *= side_of(t, p);
        t->least[p->feature] = fmin(t->least[p->feature], p->distance);
    }
out:
    return st;
}

bool contact_thin_foot(struct contact_thin *t, int n, const struct contact_thin_step *step,
                       struct contact_thin_foot *foot)
{
    const struct contact_thin_pair *p = &t->pair[n];
    const struct contact_feature *f = &t->feature[p->feature];
    double at[3], way[3];

    foot->distance = p->distance - f->radius;
    if (!(foot->distance < t->start))
        return false;
    struct corners c = corners_at(t, p->triangle, 1);
    foot->count = find_place(t, p->triangle, &c, t->q[p->feature]);
    for (int k = 0; k < 3; k++)
        if (c.share[k] == 1) /* a sample, which meets the body by itself */
            return false;
    sum_up(t, foot->count, step->x, at);
    const double far = way_from(t, p->feature, step->pose, at, way);
    for (int i = 0; i < 3; i++)
        foot->normal[i] =
            far > 0 ? side_of(t, p) * way[i] / far : (p->before > 0 ? -1 : 1) * c.normal[i];
    foot->before = foot->distance - (t->least[p->feature] - t->least_old[p->feature]);
    foot->obstacle = f->obstacle, foot->area = f->area;
    foot->node = t->node, foot->weight = t->weight;
    return true;
}

/* --- changes that stay outside ----------------------------------------------------------
 */

enum status contact_thin_near(struct contact_thin *t, const struct scene_placement *pose,
                              const double *x, const double *d)
{
    t->pairs = 0;
    if (!t->count)
        return STATUS_OK;
    place_features(t, pose, t->q);
    memcpy(t->q_old, t->q, (size_t)t->count * sizeof *t->q);
    place_samples(t, x, t->y_old);
    place_samples(t, d, t->y);
    for (long k = 0; k < 3L * t->surface->count; k++)
        t->y[k] += t->y_old[k];
    return list_pairs(t);
}

/* A pair on the way of a change, and the distance of which half is left. */
struct approach {
    struct contact_thin *t;
    const struct contact_thin_pair *pair;
    const double *x, *d;
    double floor;
};

static double distance_over(void *self, double share, double *slope)
{
    const struct approach *a = self;
    struct contact_thin *t = a->t;
    const double *q = t->q[a->pair->feature];
    struct corners c = corners_at(t, a->pair->triangle, share);
    const int count = find_place(t, a->pair->triangle, &c, q);
    double at[3], by[3], way[3];

    sum_up(t, count, a->x, at);
    sum_up(t, count, a->d, by);
    for (int i = 0; i < 3; i++)
        way[i] = at[i] + share * by[i] - q[i];
    const double distance = vector_length(way);
    *slope = vector_dot(way, by) / distance;
    return distance - a->floor;
}

double contact_thin_limit(struct contact_thin *t, int n, const double *x, const double *d,
                          double wall, double range, double share, int samples[3])
{
    struct approach a = {t, &t->pair[n], x, d, 0};
    const double over = t->feature[a.pair->feature].radius + wall;
    double slope;

    contact_foot_corners(t->surface, a.pair->triangle, samples);
    if (t->passed[a.pair->feature]) /* it has to come back */
        return share;
    a.floor = distance_over(&a, 0, &slope) > over ? over : 0;
    return contact_limit_share(&a, distance_over, range, share);
}
