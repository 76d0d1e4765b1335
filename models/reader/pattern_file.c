#include "models/reader/pattern_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/obj_file.h"
#include "models/reader/yaml_tree.h"

/* The share of length and width by which numbers of a file may be off; a triangle is as
 * high as that share of its longest side, or its shape is not known. */
static const double NEAR = 1e-5;

static const double FARTHEST = 1e6; /* as of a scene's places [m] */

struct reading {
    struct yaml_tree line; /* to blame                                                 */
    const double *side;    /* of the rectangle; NULL: any outline                [m]   */
    struct obj_file obj;   /*                                                      owned */
};

/* Finds where a corner is in the plane; false if it is not in the rectangle. What is near
 * the rim lies on it. */
static bool place_of(const struct reading *r, const struct obj_file_corner *corner,
                     double at[2])
{
    const double *side = r->side, *v = r->obj.vertex[corner->v].at;
    const double *vt = corner->vt < 0 ? NULL : r->obj.texture[corner->vt];
    bool inside = true;

    for (int i = 0; i < 2; i++) {
        at[i] = !vt ? v[i] : side ? vt[i] * side[i] : vt[i];
        if (!side) {
            inside &= fabs(at[i]) <= FARTHEST;
            continue;
        }
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

static enum status add_corner(struct reading *r, struct mesh_flat *flat, int *node,
                              const struct obj_file_corner *corner, int *into,
                              struct message *why)
{
    double at[2];

    r->line.line = corner->line;
    if (!r->side && !starts_flat(r, corner))
        return yaml_tree_refuse(
            &r->line, why,
            "`v` %d is not where its `vt` is: a start that is not the flat pattern is not "
            "there yet; x and y as vt, and z = 0, would be right",
            corner->v + 1);
    const bool inside = place_of(r, corner, at);
    if (!inside && !r->side)
        return yaml_tree_refuse(&r->line, why,
                                "the point at %g, %g m is farther than %g m from 0; nearer "
                                "would be right",
                                at[0], at[1], FARTHEST);
    if (!inside)
        return yaml_tree_refuse(
            &r->line, why,
            "the point at %g, %g m is not on the sheet of %g by %g m; vt from 0 to 1, or x "
            "and y in metres from a corner, would be right",
            at[0], at[1], r->side[0], r->side[1]);
    if (isnan(flat->at[node[corner->v]][0]))
        memcpy(flat->at[node[corner->v]], at, sizeof at);
    *into = node[corner->v];
    const double *known = flat->at[*into];
    if (fabs(known[0] - at[0]) > NEAR * (r->side ? r->side[0] : 1) ||
        fabs(known[1] - at[1]) > NEAR * (r->side ? r->side[1] : 1))
        return yaml_tree_refuse(
            &r->line, why,
            "`v` %d has two places on the sheet, %g, %g and %g, %g m; one "
            "`vt` for each `v` would be right",
            corner->v + 1, known[0], known[1], at[0], at[1]);
    return STATUS_OK;
}

/* Returns how far c lies to the left of the way from a to b, times its length. */
static double left(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static enum status add_triangle(struct reading *r, struct mesh_flat *flat, int *node,
                                const struct obj_file_corner corner[3], struct message *why)
{
    double longest = 0;
    int *v = flat->triangle[flat->triangles++];
    enum status st;

    for (int c = 0; c < 3; c++)
        TRY(add_corner(r, flat, node, corner + c, &v[c], why));
    const double(*at)[2] = (const double(*)[2])flat->at;
    const double area = left(at[v[0]], at[v[1]], at[v[2]]);
    for (int c = 0; c < 3; c++)
        longest = fmax(longest, hypot(at[v[c]][0] - at[v[(c + 1) % 3]][0],
                                      at[v[c]][1] - at[v[(c + 1) % 3]][1]));
    if (!(fabs(area) > NEAR * longest * longest))
        return yaml_tree_refuse(
            &r->line, why,
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

/* Refuses what is not the whole rectangle, once, or what lies on itself. */
static enum status check(struct reading *r, const struct mesh_flat *flat,
                         struct message *why)
{
    struct mesh_edge *edge = NULL;
    int count, (*side)[3] = NULL;
    const struct obj_file_corner *corner = r->obj.corner;
    double area = 0;
    enum status st = mesh_flat_edges(flat, &edge, &count, &side);

    if (st == STATUS_INPUT) {
        r->line.line = corner[3 * count].line;
        yaml_tree_refuse(&r->line, why,
                         "three triangles meet at an edge; two at most would be right");
    }
    for (int e = 0; st == STATUS_OK && e < count; e++) {
        const double *a = flat->at[edge[e].node[0]], *b = flat->at[edge[e].node[1]];
        const bool inner = edge[e].node[3] >= 0;
        if (inner ? left(a, b, flat->at[edge[e].node[3]]) < 0
                  : !r->side || on_rim(flat, r->side, &edge[e]))
            continue;
        r->line.line = corner[3 * edge[e].triangle[inner]].line;
        st = inner ? yaml_tree_refuse(&r->line, why,
                                      "two triangles lie on the same side of the edge they "
                                      "share at %g, %g m; one on each would be right",
                                      (a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
                   : yaml_tree_refuse(
                         &r->line, why,
                         "the triangles end at %g, %g m, inside the sheet; triangles "
                         "that cover the whole rectangle would be right",
                         (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    }
    for (int t = 0; t < flat->triangles; t++) {
        const int *v = flat->triangle[t];
        area += left(flat->at[v[0]], flat->at[v[1]], flat->at[v[2]]) / 2;
    }
    const double whole = r->side ? r->side[0] * r->side[1] : area;
    r->line.line = -1;
    if (st == STATUS_OK && fabs(area - whole) > NEAR * whole)
        st = yaml_tree_refuse(&r->line, why,
                              "the triangles have %.6g m^2 together, and the sheet %.6g; "
                              "triangles that do not overlap would be right",
                              area, whole);
    free(edge);
    free(side);
    return st;
}

static enum status make(struct reading *r, struct mesh_flat *flat, struct message *why)
{
    const int triangles = r->obj.corners / 3;
    int *node = malloc(((size_t)r->obj.vertices + 1) * sizeof *node);
    enum status st = STATUS_MEMORY;

    flat->at = malloc(((size_t)r->obj.vertices + 1) * sizeof *flat->at);
    flat->triangle = malloc(((size_t)triangles + 1) * sizeof *flat->triangle);
    if (!node || !flat->at || !flat->triangle)
        goto out;
    for (int n = 0; n < r->obj.vertices; n++)
        node[n] = -1;
    for (int n = 0; n < r->obj.corners; n++)
        node[r->obj.corner[n].v] = 0;
    for (int n = 0; n < r->obj.vertices; n++) /* those of faces, in the file's order */
        if (node[n] == 0)
            flat->at[flat->nodes][0] = NAN, node[n] = flat->nodes++;
    r->line.line = -1;
    if (!triangles)
        TRY(yaml_tree_refuse(&r->line, why, "no faces, as in `f 1 2 3`"));
    for (int t = 0; t < triangles; t++)
        TRY(add_triangle(r, flat, node, r->obj.corner + 3 * t, why));
    TRY(check(r, flat, why));
out:
    free(node);
    return st;
}

/* Says where the triangles meet in a point only, or what is wrong with their outline. */
static enum status refuse_outline(struct reading *r, int triangle, const struct pattern *p,
                                  const struct pattern_blame *blame, struct message *why)
{
    if (triangle >= 0) {
        r->line.line = r->obj.corner[3 * triangle].line;
        return yaml_tree_refuse(
            &r->line, why,
            "pieces of the sheet meet in a point of this triangle; pieces "
            "that share edges would be right");
    }
    const double *at = p->at[p->line[blame->line] + blame->point];
    r->line.line = -1;
    return blame->fault == PATTERN_CROSSING
               ? yaml_tree_refuse(
                     &r->line, why,
                     "the sheet's edge meets itself at %g, %g m; a pattern that "
                     "lies flat without folds would be right",
                     at[0], at[1])
               : yaml_tree_refuse(&r->line, why,
                                  "the triangles are two pieces that nothing joins, one at "
                                  "%g, %g m; one piece would be right",
                                  at[0], at[1]);
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
    obj_file_clear(&r.obj);
    mesh_flat_clear(&new);
    return st;
}

enum status pattern_file_outline(const char *path, struct pattern **pattern, double size[2],
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
    st = pattern_add_mesh(p, &flat, &triangle);
    if (st == STATUS_OK)
        st = pattern_finish(p, size, &blame);
    if (st == STATUS_INPUT)
        st = refuse_outline(&r, triangle, p, &blame, why);
out:
    obj_file_clear(&r.obj);
    mesh_flat_clear(&flat);
    if (st == STATUS_OK)
        *pattern = p;
    else
        pattern_free(p);
    return st;
}
