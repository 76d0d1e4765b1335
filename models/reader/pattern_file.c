#include "models/reader/pattern_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/obj_file.h"
#include "models/reader/yaml_tree.h"
#include "models/room.h"

/* The share of length and width by which numbers of a file may be off; a triangle is as
 * high as that share of its longest side, or its shape is not known. */
static const double NEAR = 1e-5;

/* The share by which the sides of a seam may differ: what differs is strain from the start.
 */
static const double UNEQUAL = 0.01;

static const double FARTHEST = 1e6; /* as of a scene's places [m] */

struct reading {
    struct yaml_tree line; /* to blame                                                 */
    const double *side;    /* of the rectangle; NULL: any outline                [m]   */
    struct obj_file obj;   /*                                                      owned */
    int *node;   /* [vertices] the first place of each `v`, -1: no face names it   owned */
    int *of;     /* [points] the `v` of each place in the plane                    owned */
    int *next;   /* [points] another place of that, -1: none                       owned */
    int *root;   /* [vertices] the first that it is sewn to, itself if none        owned */
    bool raised; /* points have several places, or start elsewhere                       */
};

/* Returns what a sentence blames: the face of a triangle, or the whole file if it is -1. */
static const struct yaml_tree *face(struct reading *r, int triangle)
{
    r->line.line = triangle < 0 ? -1 : r->obj.corner[3 * triangle].line;
    return &r->line;
}

/* Finds where a corner is in the plane; false if it is not in the rectangle, or too far
 * away there or in space. What is near the rim lies on it. */
static bool place_of(const struct reading *r, const struct obj_file_corner *corner,
                     double at[2])
{
    const double *side = r->side, *v = r->obj.vertex[corner->v].at;
    const double *vt = corner->vt < 0 ? NULL : r->obj.texture[corner->vt];
    bool inside = side || fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2]))) <= FARTHEST;

    for (int i = 0; i < 2; i++) {
        at[i] = !vt ? v[i] : side ? vt[i] * side[i] : vt[i];
        inside &= fabs(at[i]) <= FARTHEST;
        if (!side)
            continue;
        if (fabs(at[i]) <= NEAR * side[i])
            at[i] = 0;
        if (fabs(at[i] - side[i]) <= NEAR * side[i])
            at[i] = side[i];
        inside &= at[i] >= 0 && at[i] <= side[i];
    }
    return inside;
}

/* Tells whether a corner's place in space is that of its pattern. */
static bool starts_flat(const struct reading *r, const struct obj_file_corner *corner)
{
    const double *v = r->obj.vertex[corner->v].at;
    const double *vt = corner->vt < 0 ? v : r->obj.texture[corner->vt];

    return hypot(v[0] - vt[0], v[1] - vt[1]) <= NEAR && (vt == v || fabs(v[2]) <= NEAR);
}

static bool is_at(const struct reading *r, const double known[2], const double at[2])
{
    return fabs(known[0] - at[0]) <= NEAR * (r->side ? r->side[0] : 1) &&
           fabs(known[1] - at[1]) <= NEAR * (r->side ? r->side[1] : 1);
}

/* Finds the place of a triangle's corner among those of its `v`; of a rectangle there is
 * one. */
static enum status add_corner(struct reading *r, struct mesh_flat *flat, int triangle,
                              int c, struct message *why)
{
    const struct obj_file_corner *corner = &r->obj.corner[3 * triangle + c];
    int at_node = r->node[corner->v];
    double at[2];

    r->raised |= !r->side && !starts_flat(r, corner);
    if (!place_of(r, corner, at))
        return r->side
                   ? yaml_tree_refuse(
                         face(r, triangle), why,
                         "the point at %g, %g m is not on the sheet of %g by %g m; vt from "
                         "0 to 1, or x and y in metres from a corner, would be right",
                         at[0], at[1], r->side[0], r->side[1])
                   : yaml_tree_refuse(face(r, triangle), why,
                                      "`v` %d is farther than %g m from 0, or its place in "
                                      "the plane is; nearer would be right",
                                      corner->v + 1, FARTHEST);
    if (isnan(flat->at[at_node][0]))
        memcpy(flat->at[at_node], at, sizeof at);
    while (!is_at(r, flat->at[at_node], at) && r->next[at_node] >= 0)
        at_node = r->next[at_node];
    if (!is_at(r, flat->at[at_node], at)) {
        const double *known = flat->at[at_node];
        if (r->side)
            return yaml_tree_refuse(
                face(r, triangle), why,
                "`v` %d has two places on the sheet, %g, %g and %g, %g m; one "
                "`vt` for each `v` would be right",
                corner->v + 1, known[0], known[1], at[0], at[1]);
        r->next[at_node] = flat->nodes, r->next[flat->nodes] = -1;
        r->of[flat->nodes] = corner->v, r->raised = true;
        at_node = flat->nodes++;
        memcpy(flat->at[at_node], at, sizeof at);
    }
    flat->triangle[triangle][c] = at_node;
    return STATUS_OK;
}

static enum status add_triangle(struct reading *r, struct mesh_flat *flat,
                                struct message *why)
{
    const int t = flat->triangles++;
    int *v = flat->triangle[t];
    const struct obj_file_corner *corner = &r->obj.corner[3 * t];
    double longest = 0;
    enum status st;

    if ((corner[0].vt < 0) != (corner[1].vt < 0) ||
        (corner[0].vt < 0) != (corner[2].vt < 0))
        return yaml_tree_refuse(face(r, t), why,
                                "a face names `vt` at some of its corners; at all or at "
                                "none would be right");
    for (int c = 0; c < 3; c++)
        TRY(add_corner(r, flat, t, c, why));
    const double area = mesh_flat_area2(flat, v[0], v[1], v[2]);
    for (int c = 0; c < 3; c++) {
        const double *a = flat->at[v[c]], *b = flat->at[v[(c + 1) % 3]];
        longest = fmax(longest, hypot(a[0] - b[0], a[1] - b[1]));
    }
    if (!(fabs(area) > NEAR * longest * longest))
        return yaml_tree_refuse(
            face(r, t), why,
            "a triangle without area, or 100,000 times as long as wide; "
            "one that its `vt` (or x, y) span would be right");
    if (area < 0) {
        const int keep = v[1];
        v[1] = v[2], v[2] = keep;
    }
out:
    return st;
}

/* Tells whether both ends of an edge lie on the same side of the rectangle. */
static bool on_rim(const struct mesh_flat *flat, const double side[2],
                   const struct mesh_edge *e)
{
    const double *a = flat->at[e->node[0]], *b = flat->at[e->node[1]];

    return (a[0] == 0 && b[0] == 0) || (a[1] == 0 && b[1] == 0) ||
           (a[0] == side[0] && b[0] == side[0]) || (a[1] == side[1] && b[1] == side[1]);
}

static enum status find_edges(struct reading *r, const struct mesh_flat *flat,
                              struct mesh_edge **edge, int *count, struct message *why)
{
    const enum status st = mesh_flat_edges(flat, edge, count, NULL);

    return st == STATUS_INPUT
               ? yaml_tree_refuse(face(r, *count), why,
                                  "three triangles meet at an edge or a seam; two at most "
                                  "would be right")
               : st;
}

/* Refuses what is not the whole rectangle, once, or what lies on itself. */
static enum status check(struct reading *r, const struct mesh_flat *flat,
                         struct message *why)
{
    struct mesh_edge *edge;
    int count;
    double area = 0;
    enum status st;

    TRY(find_edges(r, flat, &edge, &count, why));
    for (const struct mesh_edge *e = edge; e < edge + count; e++) {
        const double *a = flat->at[e->node[0]], *b = flat->at[e->node[1]];
        const double x = (a[0] + b[0]) / 2, y = (a[1] + b[1]) / 2;
        if (e->node[3] >= 0) {
            if (!(mesh_flat_left(a, b, flat->at[e->node[3]]) < 0))
                TRY(yaml_tree_refuse(face(r, e->triangle[1]), why,
                                     "two triangles lie on the same side of the edge they "
                                     "share at %g, %g m; one on each would be right",
                                     x, y));
        } else if (r->side && !on_rim(flat, r->side, e)) {
            TRY(yaml_tree_refuse(face(r, e->triangle[0]), why,
                                 "the triangles end at %g, %g m, inside the sheet; "
                                 "triangles that cover the whole rectangle would be right",
                                 x, y));
        }
    }
    for (int t = 0; r->side && t < flat->triangles; t++) {
        const int *v = flat->triangle[t];
        area += mesh_flat_area2(flat, v[0], v[1], v[2]) / 2;
    }
    const double whole = r->side ? r->side[0] * r->side[1] : 0;
    if (fabs(area - whole) > NEAR * whole)
        st = yaml_tree_refuse(face(r, -1), why,
                              "the triangles have %.6g m^2 together, and the sheet %.6g; "
                              "triangles that do not overlap would be right",
                              area, whole);
out:
    free(edge);
    return st;
}

static enum status make(struct reading *r, struct mesh_flat *flat, struct message *why)
{
    const size_t corners = (size_t)r->obj.corners, vertices = (size_t)r->obj.vertices;
    enum status st;

    if (!corners)
        return yaml_tree_refuse(face(r, -1), why, "no faces, as in `f 1 2 3`");
    TRY(mesh_flat_make(flat, r->obj.corners, r->obj.corners / 3));
    r->node = malloc(vertices * sizeof *r->node);
    r->of = malloc(corners * sizeof *r->of);
    r->next = malloc(corners * sizeof *r->next);
    TRY(r->node && r->of && r->next ? STATUS_OK : STATUS_MEMORY);
    memset(r->node, -1, vertices * sizeof *r->node);
    for (size_t n = 0; n < corners; n++)
        r->node[r->obj.corner[n].v] = 0;
    for (size_t v = 0; v < vertices; v++) { /* those of faces, in the file's order */
        if (r->node[v] < 0)
            continue;
        flat->at[flat->nodes][0] = NAN, r->of[flat->nodes] = (int)v;
        r->next[flat->nodes] = -1, r->node[v] = flat->nodes++;
    }
    while (flat->triangles < r->obj.corners / 3)
        TRY(add_triangle(r, flat, why));
    st = check(r, flat, why);
out:
    return st;
}

static enum status refuse_point(struct reading *r, int triangle, struct message *why)
{
    return yaml_tree_refuse(face(r, triangle), why,
                            "pieces of the sheet meet in a point of this triangle; pieces "
                            "that share edges, or seams along edges, would be right");
}

/* Says where the triangles meet in a point only, or what is wrong with their outline. */
static enum status refuse_outline(struct reading *r, int triangle, const struct pattern *p,
                                  const struct pattern_blame *blame, struct message *why)
{
    if (triangle >= 0)
        return refuse_point(r, triangle, why);
    const double *at = p->at[p->line[blame->line] + blame->point];
    return blame->fault == PATTERN_OUTSIDE
               ? yaml_tree_refuse(face(r, -1), why,
                                  "the panel at %g, %g m lies on another one; panels side "
                                  "by side in the plane would be right",
                                  at[0], at[1])
           : blame->fault == PATTERN_CROSSING
               ? yaml_tree_refuse(
                     face(r, -1), why,
                     "the sheet's edge meets itself at %g, %g m; a pattern that "
                     "lies flat without folds would be right",
                     at[0], at[1])
               : yaml_tree_refuse(face(r, -1), why,
                                  "the triangles are two pieces that nothing joins, one at "
                                  "%g, %g m; one piece would be right",
                                  at[0], at[1]);
}

/* Gives the pattern the file's numbers and groups. */
static enum status hand_over(struct reading *r, struct pattern *p)
{
    p->in = malloc(((size_t)p->mesh.triangles + 1) * sizeof *p->in);
    if (!p->in)
        return STATUS_MEMORY;
    for (int t = 0; t < p->mesh.triangles; t++)
        p->in[t] = r->obj.corner[3 * t].group;
    p->vertex = r->of, r->of = NULL;
    p->group = r->obj.group, p->groups = r->obj.groups;
    r->obj.group = NULL, r->obj.groups = 0;
    return STATUS_OK;
}

static void clear(struct reading *r)
{
    obj_file_clear(&r->obj);
    free(r->node);
    free(r->of);
    free(r->next);
    free(r->root);
}

enum status pattern_file_read(const char *path, const double side[2],
                              struct mesh_flat *flat, struct message *why)
{
    enum status st;
    struct mesh_flat new = {0};
    struct reading r = {.line = {.origin = path}, .side = side};

    TRY(obj_file_read(path, &r.obj, why));
    TRY(make(&r, &new, why));
    HAND_OVER(flat, new);
out:
    clear(&r);
    mesh_flat_clear(&new);
    return st;
}

/* --- seams ------------------------------------------------------------------------------
 */

static int root_of(const struct reading *r, int v)
{
    while (r->root[v] != v)
        v = r->root[v];
    return v;
}

static enum status join(struct reading *r, int pairs, const int (*pair)[2],
                        struct message *why)
{
    r->root = malloc((size_t)r->obj.vertices * sizeof *r->root);
    if (!r->root)
        return STATUS_MEMORY;
    for (int v = 0; v < r->obj.vertices; v++)
        r->root[v] = v;
    for (int n = 0; n < 2 * pairs; n++) {
        const int v = pair[n / 2][n % 2];
        if (v >= r->obj.vertices || r->node[v] < 0)
            return yaml_tree_refuse(face(r, -1), why,
                                    "a seam joins `v` %d, which no face names; corners of "
                                    "faces would be right",
                                    v + 1);
    }
    for (int n = 0; n < pairs; n++) {
        const int a = root_of(r, pair[n][0]), b = root_of(r, pair[n][1]);
        r->root[a > b ? a : b] = a > b ? b : a;
    }
    r->raised |= pairs > 0;
    return STATUS_OK;
}

/* Numbers what is sewn together, in the file's order; it starts at the mean place. */
static enum status sew(struct reading *r, int points, struct pattern *p)
{
    const int vertices = r->obj.vertices;
    int *number, *count;
    void *room = NULL;
    enum status st;

    TRY(room_cut(&room, ROOM(number, vertices), ROOM(count, vertices)));
    p->node = malloc((size_t)points * sizeof *p->node);
    p->start = calloc((size_t)points, sizeof *p->start);
    TRY(p->node && p->start ? STATUS_OK : STATUS_MEMORY);
    for (int v = 0; v < vertices; v++) {
        const int root = root_of(r, v); /* the first of what is sewn */
        if (r->node[v] < 0)
            continue;
        number[v] = root == v ? p->nodes++ : number[root];
        double *start = p->start[number[v]];
        count[number[v]]++;
        for (int i = 0; i < 3; i++) /* the mean so far */
            start[i] += (r->obj.vertex[v].at[i] - start[i]) / count[number[v]];
    }
    for (int n = 0; n < points; n++)
        p->node[n] = number[r->of[n]];
out:
    free(room);
    return st;
}

/* Refuses an edge whose two triangles do not fit. */
static enum status check_edge(struct reading *r, const struct pattern *p,
                              const struct mesh_flat *sewn, const struct mesh_edge *e,
                              struct message *why)
{
    double length[2], mean[2] = {0};
    bool same = false; /* the order of its ends in both */

    for (int s = 0; s < 2; s++) {
        const int t = e->triangle[s], *v = sewn->triangle[t];
        const int c = mesh_flat_corner(v, e->node[2 + s]);
        const int b = (c + 1) % 3, d = (c + 2) % 3;
        const double *from = mesh_flat_place(sewn, t, b), *to = mesh_flat_place(sewn, t, d);
        length[s] = hypot(to[0] - from[0], to[1] - from[1]);
        same |= s && v[b] == e->node[0];
        for (int i = 0; i < 2; i++)
            mean[i] += (from[i] + to[i]) / 4 + p->corner[i] / 2;
    }
    if (same)
        return yaml_tree_refuse(
            face(r, e->triangle[1]), why,
            "this triangle and its neighbour at %g, %g m have their faces on opposite "
            "sides: one panel lies upside down in the plane, or the seams make a Moebius "
            "strip; the panel's `vt` mirrored would be right",
            mean[0], mean[1]);
    if (fabs(length[0] - length[1]) > UNEQUAL * fmax(length[0], length[1]))
        return yaml_tree_refuse(face(r, e->triangle[1]), why,
                                "a seam joins this triangle's edge of %g m to one of %g m; "
                                "equal lengths, to %g %%, would be right",
                                length[1], length[0], 100 * UNEQUAL);
    return STATUS_OK;
}

/* Refuses what sewing makes no surface, or several. */
static enum status check_sewn(struct reading *r, const struct pattern *p,
                              struct message *why)
{
    struct mesh_flat sewn = {0};
    struct mesh_edge *edge = NULL;
    int edges, *work = NULL;
    enum status st;

    TRY(pattern_sewn(p, &sewn));
    for (int t = 0; t < sewn.triangles; t++) {
        const int *v = sewn.triangle[t];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            TRY(yaml_tree_refuse(face(r, t), why,
                                 "a seam joins two points of this triangle; points of "
                                 "different triangles would be right"));
    }
    TRY(find_edges(r, &sewn, &edge, &edges, why));
    for (int n = 0; n < edges; n++)
        if (edge[n].triangle[1] >= 0)
            TRY(check_edge(r, p, &sewn, &edge[n], why));
    work = malloc((size_t)sewn.nodes * sizeof *work);
    TRY(work ? STATUS_OK : STATUS_MEMORY);
    mesh_flat_pieces(&sewn, work);
    for (int t = 0; t < sewn.triangles; t++)
        if (work[sewn.triangle[t][0]])
            TRY(yaml_tree_refuse(face(r, t), why,
                                 "nothing joins this panel to the first; a seam, or points "
                                 "that both name, would be right"));
    const int triangle = mesh_flat_rim(&sewn, edge, edges, work);
    if (triangle >= 0)
        st = refuse_point(r, triangle, why);
out:
    free(work);
    free(edge);
    mesh_flat_clear(&sewn);
    return st;
}

enum status pattern_file_outline(const char *path, int pairs, const int (*pair)[2],
                                 struct pattern **pattern, double size[2],
                                 struct message *why)
{
    enum status st;
    int triangle = -1;
    struct mesh_flat flat = {0};
    struct pattern_blame blame = {0};
    struct reading r = {.line = {.origin = path}};
    struct pattern *p = pattern_make();

    TRY(p ? STATUS_OK : STATUS_MEMORY);
    TRY(obj_file_read(path, &r.obj, why));
    TRY(make(&r, &flat, why));
    TRY(join(&r, pairs, pair, why));
    if (r.raised)
        TRY(sew(&r, flat.nodes, p));
    st = pattern_add_mesh(p, &flat, &triangle);
    if (st == STATUS_OK)
        st = pattern_finish(p, size, &blame);
    if (st == STATUS_INPUT)
        st = refuse_outline(&r, triangle, p, &blame, why);
    if (st == STATUS_OK && r.raised)
        st = check_sewn(&r, p, why);
    if (st == STATUS_OK)
        st = hand_over(&r, p);
out:
    clear(&r);
    mesh_flat_clear(&flat);
    if (st == STATUS_OK)
        *pattern = p;
    else
        pattern_free(p);
    return st;
}
