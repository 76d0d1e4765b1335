/* mesh_flat_read.c - flat patterns from OBJ files. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mesh/mesh_flat.h"
#include "models/reader/named_file.h"
#include "models/reader/yaml_tree.h"

enum { MOST_BYTES = 1 << 28, MOST_NODES = 1 << 22 };
static const char BLANKS[] = " \t\r";

/* The shares of length and width by which numbers of a file may be off, and of the
 * rectangle that a triangle must have. */
static const double NEAR = 1e-5, LEAST = 1e-12;

static const struct named_file_kind kind = {.what = "mesh", .most = MOST_BYTES};

/* A list of pairs or triples that grows. */
struct list {
    int count, room;
    void *of;
};

struct reading {
    struct yaml_tree line; /* to blame                                                 */
    const struct scene *scene;
    struct list place, texture; /* double[2] of `v`, `vt`                              */
    struct list corner;         /* int[3]: v, vt (-1: none), line; three a triangle    */
};

/* Returns room behind a list for one more of `size` bytes, NULL without memory. */
static void *grow(struct list *list, size_t size)
{
    if (list->count == list->room) {
        void *more = realloc(list->of, (2 * (size_t)list->room + 64) * size);
        if (!more)
            return NULL;
        list->of = more, list->room = 2 * list->room + 64;
    }
    return (char *)list->of + (size_t)list->count++ * size;
}

static enum status take_pair(struct reading *r, struct list *list, char *text,
                             const char *want, struct message *why)
{
    double *pair = grow(list, 2 * sizeof *pair);

    if (!pair)
        return STATUS_MEMORY;
    if (list->count > MOST_NODES)
        return yaml_tree_refuse(&r->line, why, "more than %d points; fewer would be right",
                                MOST_NODES);
    for (int i = 0; i < 2; i++) {
        char *end = text;
        pair[i] = strtod(text, &end);
        if (end == text || !isfinite(pair[i]))
            return yaml_tree_refuse(&r->line, why, "a point needs numbers, as in `%s`",
                                    want);
        text = end;
    }
    return STATUS_OK;
}

/* Reads a number of a list, from 0; -1: none such. */
static int number_in(const struct list *list, const char *word, char **end)
{
    const long n = strtol(word, end, 10), at = n < 0 ? list->count + n : n - 1;

    return *end == word || at < 0 || at >= list->count ? -1 : (int)at;
}

static enum status read_corner(const struct reading *r, const char *word, int corner[3],
                               struct message *why)
{
    char *end;

    corner[0] = number_in(&r->place, word, &end), corner[1] = -1, corner[2] = r->line.line;
    bool good = corner[0] >= 0 && (!*end || *end == '/');
    if (good && *end == '/' && end[1] && end[1] != '/') {
        corner[1] = number_in(&r->texture, end + 1, &end);
        good = corner[1] >= 0 && (!*end || *end == '/');
    }
    return good ? STATUS_OK
                : yaml_tree_refuse(
                      &r->line, why,
                      "%s does not name one of the %d `v` and %d `vt` above it, "
                      "as in `f 1/1 2/2 3/3`",
                      yaml_tree_quote(word).text, r->place.count, r->texture.count);
}

static enum status take_face(struct reading *r, char *text, struct message *why)
{
    enum status st = STATUS_OK;
    int fan[3][3], count = 0;
    char *rest;

    for (char *word = strtok_r(text, BLANKS, &rest); word;
         word = strtok_r(NULL, BLANKS, &rest), count++) {
        const int at = count < 2 ? count : 2;
        if (count > 2)
            memcpy(fan[1], fan[2], sizeof *fan);
        TRY(read_corner(r, word, fan[at], why));
        for (int c = 0; count >= 2 && c < 3; c++) {
            int *corner = grow(&r->corner, sizeof *fan);
            if (!corner)
                TRY(STATUS_MEMORY);
            memcpy(corner, fan[c], sizeof *fan);
        }
        if (r->corner.count > 6 * MOST_NODES)
            return yaml_tree_refuse(&r->line, why,
                                    "more than %d triangles; fewer would be right",
                                    2 * MOST_NODES);
    }
    if (count < 3)
        return yaml_tree_refuse(
            &r->line, why, "a face has %d corners, but must have three at least", count);
out:
    return st;
}

static enum status take_line(struct reading *r, char *line, struct message *why)
{
    char *rest;
    const char *word = strtok_r(line, BLANKS, &rest);

    if (!word)
        return STATUS_OK;
    return !strcmp(word, "v")    ? take_pair(r, &r->place, rest, "v .5 .25 0", why)
           : !strcmp(word, "vt") ? take_pair(r, &r->texture, rest, "vt .5 .25", why)
           : !strcmp(word, "f")  ? take_face(r, rest, why)
                                 : STATUS_OK;
}

/* Reads bytes[size], behind which there is room for one more. */
static enum status take_lines(struct reading *r, char *bytes, size_t size,
                              struct message *why)
{
    enum status st = STATUS_OK;
    char *const end = bytes + size, *next;

    *end = '\n';
    for (char *line = bytes; line < end; line = next) {
        char *stop = memchr(line, '\n', (size_t)(end - line) + 1);
        next = stop + 1, *stop = '\0';
        r->line.line++;
        if (memchr(line, '\0', (size_t)(stop - line)))
            return yaml_tree_refuse(&r->line, why,
                                    "a NUL byte; write the mesh as OBJ text");
        TRY(take_line(r, line, why));
    }
out:
    return st;
}

/* --- what was read becomes the sheet's plane
 * ----------------------------------------------
 */

/* Finds where a corner is in the plane; false if it is not in the rectangle. What is near
 * the rim lies on it. */
static bool place_of(const struct reading *r, const int corner[3], double at[2])
{
    const double side[2] = {r->scene->length, r->scene->width};
    const double *v = (const double *)r->place.of + 2 * corner[0];
    const double *vt = corner[1] < 0 ? NULL : (const double *)r->texture.of + 2 * corner[1];
    bool inside = true;

    for (int i = 0; i < 2; i++) {
        at[i] = vt ? vt[i] * side[i] : v[i];
        if (fabs(at[i]) <= NEAR * side[i])
            at[i] = 0;
        if (fabs(at[i] - side[i]) <= NEAR * side[i])
            at[i] = side[i];
        inside &= at[i] >= 0 && at[i] <= side[i];
    }
    return inside;
}

static enum status add_corner(struct reading *r, struct mesh_flat *flat, int *node,
                              const int corner[3], int *into, struct message *why)
{
    double at[2];

    r->line.line = corner[2];
    if (!place_of(r, corner, at))
        return yaml_tree_refuse(
            &r->line, why,
            "the point at %g, %g m is not on the sheet of %g by %g m; vt from 0 to 1, or x "
            "and y in metres from a corner, would be right",
            at[0], at[1], r->scene->length, r->scene->width);
    if (node[corner[0]] < 0) {
        memcpy(flat->at[flat->nodes], at, sizeof at);
        node[corner[0]] = flat->nodes++;
    }
    *into = node[corner[0]];
    const double *known = flat->at[*into];
    if (fabs(known[0] - at[0]) > NEAR * r->scene->length ||
        fabs(known[1] - at[1]) > NEAR * r->scene->width)
        return yaml_tree_refuse(
            &r->line, why,
            "`v` %d has two places on the sheet, %g, %g and %g, %g m; one "
            "`vt` for each `v` would be right",
            corner[0] + 1, known[0], known[1], at[0], at[1]);
    return STATUS_OK;
}

static enum status add_triangle(struct reading *r, struct mesh_flat *flat, int *node,
                                const int corner[9], struct message *why)
{
    const double least = LEAST * r->scene->length * r->scene->width;
    int *v = flat->triangle[flat->triangles++];
    enum status st;

    for (int c = 0; c < 3; c++)
        TRY(add_corner(r, flat, node, corner + 3 * c, &v[c], why));
    const double(*at)[2] = (const double(*)[2])flat->at;
    const double area = (at[v[1]][0] - at[v[0]][0]) * (at[v[2]][1] - at[v[0]][1]) -
                        (at[v[1]][1] - at[v[0]][1]) * (at[v[2]][0] - at[v[0]][0]);
    if (!(fabs(area) / 2 > least))
        return yaml_tree_refuse(&r->line, why,
                                "a triangle without area; one that its `vt` (or x, y) span "
                                "would be right");
    if (area < 0) {
        const int keep = v[1];
        v[1] = v[2], v[2] = keep;
    }
out:
    return st;
}

/* Tells whether both ends of an edge lie on the same side of the rectangle. */
static bool on_rim(const struct mesh_flat *flat, const struct scene *scene,
                   const struct mesh_edge *e)
{
    const double *a = flat->at[e->node[0]], *b = flat->at[e->node[1]];

    return (a[0] == 0 && b[0] == 0) || (a[1] == 0 && b[1] == 0) ||
           (a[0] == scene->length && b[0] == scene->length) ||
           (a[1] == scene->width && b[1] == scene->width);
}

/* Refuses what is not the whole rectangle, once. */
static enum status check(struct reading *r, const struct mesh_flat *flat,
                         struct message *why)
{
    struct mesh_edge *edge = NULL;
    int count, (*side)[3] = NULL;
    const int *corner = r->corner.of;
    double area = 0;
    enum status st = mesh_flat_edges(flat, &edge, &count, &side);

    if (st == STATUS_INPUT) {
        r->line.line = corner[9 * count + 2];
        yaml_tree_refuse(&r->line, why,
                         "three triangles meet at an edge; two at most would be right");
    }
    for (int e = 0; st == STATUS_OK && e < count; e++) {
        const double *a = flat->at[edge[e].node[0]], *b = flat->at[edge[e].node[1]];
        if (edge[e].node[3] >= 0 || on_rim(flat, r->scene, &edge[e]))
            continue;
        r->line.line = corner[9 * edge[e].triangle[0] + 2];
        st = yaml_tree_refuse(&r->line, why,
                              "the triangles end at %g, %g m, inside the sheet; triangles "
                              "that cover the whole rectangle would be right",
                              (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    }
    for (int t = 0; t < flat->triangles; t++) {
        const int *v = flat->triangle[t];
        const double *a = flat->at[v[0]], *b = flat->at[v[1]], *c = flat->at[v[2]];
        area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    const double whole = r->scene->length * r->scene->width;
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
    const int triangles = r->corner.count / 3;
    int *node = malloc(((size_t)r->place.count + 1) * sizeof *node);
    enum status st = STATUS_MEMORY;

    flat->at = malloc(((size_t)r->place.count + 1) * sizeof *flat->at);
    flat->triangle = malloc(((size_t)triangles + 1) * sizeof *flat->triangle);
    if (!node || !flat->at || !flat->triangle)
        goto out;
    for (int n = 0; n < r->place.count; n++)
        node[n] = -1;
    r->line.line = -1;
    if (!triangles)
        TRY(yaml_tree_refuse(&r->line, why, "no faces, as in `f 1 2 3`"));
    for (int t = 0; t < triangles; t++)
        TRY(add_triangle(r, flat, node, (const int *)r->corner.of + 9 * t, why));
    TRY(check(r, flat, why));
out:
    free(node);
    return st;
}

enum status mesh_flat_read(struct mesh_flat *flat, const struct scene *scene,
                           const char *path, struct message *why)
{
    enum status st;
    struct mesh_flat new = {0};
    struct reading r = {.line = {.origin = path}, .scene = scene};
    char *bytes = NULL;
    size_t size;

    st = named_file_read(&kind, path, &bytes, &size, why);
    if (st != STATUS_OK)
        return st == STATUS_FILE ? STATUS_INPUT : st;
    if (size > MOST_BYTES) {
        r.line.line = -1;
        TRY(yaml_tree_refuse(
            &r.line, why, "more than %d bytes; a smaller mesh would be right", MOST_BYTES));
    }
    TRY(take_lines(&r, bytes, size, why));
    TRY(make(&r, &new, why));
    HAND_OVER(flat, new);
out:
    free(bytes);
    free(r.place.of);
    free(r.texture.of);
    free(r.corner.of);
    mesh_flat_clear(&new);
    return st;
}
