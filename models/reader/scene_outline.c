#include "models/reader/scene_outline.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/pattern.h"
#include "models/reader/mesh_file.h"
#include "models/reader/pattern_file.h"
#include "models/reader/schema.h"

enum status scene_outline_later(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why)
{
    (void)key, (void)node, (void)target, (void)why;
    return STATUS_OK;
}

/* clang-format off */
const struct schema_key scene_outline_keys[] = {
    {"length", "L along u [m]", SCHEMA_NUMBER, .low = 1e-9, .high = 1e6,
     .offset = offsetof(struct scene, length)},
    {"width", "W along v [m]", SCHEMA_NUMBER, .low = 1e-9, .high = 1e6,
     .offset = offsetof(struct scene, width)},
    {"outline", "in place of these: corners of the flat pattern, one after the other [m]",
     SCHEMA_SPECIAL, .read = scene_outline_later, .want = "3 to 10000 points [x, y]"},
    {"holes", "closed lines in the outline [m]", SCHEMA_SPECIAL, .read = scene_outline_later,
     .want = "a list of lines of points [x, y]"},
    {"mesh", "in place of an outline: OBJ file, sought from the scene's folder, whose vt, "
     "or without them x and y, are the flat pattern [m]", SCHEMA_TEXT,
     .offset = offsetof(struct scene, pattern_file)},
    {"seams", "of a mesh: each two runs of numbers of its `v`, from 1, that are sewn "
     "together one by one", SCHEMA_SPECIAL, .read = scene_outline_later,
     .want = "a list of seams [[1, 2, 3], [7, 8, 9]]"},
    {"thickness", "h along w; fabrics have their own [m]", SCHEMA_NUMBER, .low = 1e-9,
     .high = 1e6, .offset = offsetof(struct scene, thickness)},
    {NULL}};
/* clang-format on */

/* So many times as long as wide an outline may be: its border has as many points as edges
 * of even triangles fit in. */
static const double SLENDER = 1e4;

/* Adds a closed line of rows [x, y] to a pattern. */
static enum status add_line(const struct yaml_tree *node, struct pattern *p,
                            struct message *why)
{
    static const struct schema_key place = {.key = "a point",
                                            .type = SCHEMA_VECTOR,
                                            .low = -1e6,
                                            .high = 1e6,
                                            .most = 2,
                                            .want = "two numbers [x, y] in metres"};
    enum status st = STATUS_OK;
    double(*at)[2];
    int count = 0;

    if (node->kind != YAML_TREE_LIST || node->count < 3 ||
        node->count + p->points > PATTERN_MOST)
        return yaml_tree_refuse(node, why,
                                "a line around the sheet must have 3 to %d points [x, y]",
                                PATTERN_MOST);
    at = calloc((size_t)node->count, sizeof *at);
    TRY(at ? STATUS_OK : STATUS_MEMORY);
    for (const struct yaml_tree *row = node->first; row; row = row->next)
        TRY(schema_value(&place, row, at[count++], why));
    TRY(pattern_add_line(p, count, (const double(*)[2])at));
out:
    free(at);
    return st;
}

static enum status refuse_lines(const struct yaml_tree *outline,
                                const struct yaml_tree *holes,
                                const struct pattern_blame *blame, struct message *why)
{
    static const char *const sentence[] = {
        [PATTERN_FEW] = "has less than three points",
        [PATTERN_DOUBLE] =
            "has a point twice; each once, without the first again at the end, would be "
            "right",
        [PATTERN_CROSSING] =
            "has a side that meets another one; sides that meet at their ends only would "
            "be right",
        [PATTERN_PIECES] = "has no area",
        [PATTERN_OUTSIDE] =
            "is a hole that is not inside the outline, or is in another hole; holes beside "
            "each other inside it would be right"};
    const struct yaml_tree *line = outline, *row;

    for (int n = 0; n < blame->line; n++)
        line = n ? line->next : holes->first;
    row = line->first;
    for (int n = 0; n < blame->point; n++)
        row = row->next;
    return yaml_tree_refuse(row, why, "the line %s", sentence[blame->fault]);
}

/* Makes the pattern of a sheet that has an outline. */
static enum status draw_pattern(const struct yaml_tree *outline,
                                const struct yaml_tree *holes, struct scene *scene,
                                struct message *why)
{
    double size[2];
    struct pattern_blame blame = {0};
    struct pattern *p = pattern_make();
    enum status st = p ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(add_line(outline, p, why));
    if (holes && holes->kind != YAML_TREE_LIST)
        TRY(yaml_tree_refuse(holes, why, "holes must be a list of lines of points [x, y]"));
    for (const struct yaml_tree *hole = holes ? holes->first : NULL; hole;
         hole = hole->next)
        TRY(add_line(hole, p, why));
    st = pattern_finish(p, size, &blame);
    if (st == STATUS_INPUT)
        st = refuse_lines(outline, holes, &blame, why);
    TRY(st);
    const double narrow = fmin(size[0], size[1]), wide = fmax(size[0], size[1]);
    if (narrow < 1e-9 || wide > SLENDER * narrow)
        TRY(yaml_tree_refuse(outline, why,
                             "the outline is %g by %g m; 1e-9 m at least, and not more "
                             "than %g times as long as wide, would be right",
                             size[0], size[1], SLENDER));
    pattern_free(scene->pattern);
    scene->pattern = p, p = NULL;
    scene->length = size[0], scene->width = size[1];
out:
    pattern_free(p);
    return st;
}

static const struct schema_key NUMBER = {.key = "a point of the mesh",
                                         .type = SCHEMA_COUNT,
                                         .low = 1,
                                         .high = INT_MAX,
                                         .want = "the number of a `v`"};

/* Adds the pairs of a seam, numbers from 0, to pair[*count][2]. */
static enum status read_seam(const struct yaml_tree *seam, int *count, int (*pair)[2],
                             struct message *why)
{
    const struct yaml_tree *run[2] = {seam->first, seam->first ? seam->first->next : NULL};
    bool apart = false;
    enum status st = STATUS_OK;

    if (seam->kind != YAML_TREE_LIST || seam->count != 2 ||
        run[0]->kind != YAML_TREE_LIST || run[1]->kind != YAML_TREE_LIST ||
        run[0]->count != run[1]->count || run[0]->count < 2)
        return yaml_tree_refuse(seam, why,
                                "a seam has two runs of as many points, at least two, as "
                                "in [[1, 2, 3], [7, 8, 9]]");
    for (const struct yaml_tree *a = run[0]->first, *b = run[1]->first; a;
         a = a->next, b = b->next) {
        int *v = pair[(*count)++];
        TRY(schema_value(&NUMBER, a, &v[0], why));
        TRY(schema_value(&NUMBER, b, &v[1], why));
        apart |= v[0] != v[1];
        v[0]--, v[1]--;
    }
    if (!apart)
        st = yaml_tree_refuse(seam, why,
                              "a seam joins a run of points to itself; two runs that "
                              "differ would be right");
out:
    return st;
}

/* Makes the list of pairs that seams join, owned by the caller. */
static enum status read_seams(const struct yaml_tree *seams, int *count, int (**pair)[2],
                              struct message *why)
{
    enum status st = STATUS_OK;
    int most = 1;

    if (!seams)
        return st;
    if (seams->kind != YAML_TREE_LIST)
        return yaml_tree_refuse(seams, why, "seams must be a list of seams, each two runs");
    for (const struct yaml_tree *seam = seams->first; seam; seam = seam->next)
        most += seam->first ? seam->first->count : 0;
    *pair = malloc((size_t)most * sizeof **pair);
    TRY(*pair ? STATUS_OK : STATUS_MEMORY);
    for (const struct yaml_tree *seam = seams->first; seam; seam = seam->next)
        TRY(read_seam(seam, count, *pair, why));
out:
    return st;
}

/* Reads the mesh that is the sheet, if `files`. */
static enum status load_pattern(const struct yaml_tree *root, const struct yaml_tree *mesh,
                                bool files, struct scene *scene, struct message *why)
{
    const struct yaml_tree *seams = yaml_tree_find(yaml_tree_find(root, "sheet"), "seams");
    int pairs = 0, (*pair)[2] = NULL;
    double size[2];
    struct message inner = {""};
    char path[MESH_FILE_PATH];
    enum status st = mesh_file_path(root, mesh, scene->pattern_file, path, why);

    scene->length = scene->width = 1;
    TRY(st);
    TRY(read_seams(seams, &pairs, &pair, why));
    if (!files)
        goto out;
    st = pattern_file_outline(path, pairs, (const int(*)[2])pair, &scene->pattern, size,
                              &inner);
    if (st == STATUS_OK)
        scene->length = size[0], scene->width = size[1];
    if (st == STATUS_INPUT)
        yaml_tree_refuse(mesh, why, "%s", inner.text);
out:
    free(pair);
    return st;
}

/* --- supports by vertices and groups ----------------------------------------------------
 */

/* Marks nodes that a list names by the numbers of their `v`, or that are of a group. */
static enum status mark(const struct yaml_tree *node, const struct pattern *p, bool *marked,
                        struct message *why)
{
    enum status st = STATUS_OK;
    int group = 0, v;

    for (const struct yaml_tree *at = node->first; at; at = at->next) {
        bool named = false;
        TRY(schema_value(&NUMBER, at, &v, why));
        for (int n = 0; n < p->mesh.nodes; n++)
            if (p->vertex[n] == v - 1)
                named = marked[pattern_node(p, n)] = true;
        if (!named)
            return yaml_tree_refuse(at, why, "no face of the sheet's mesh names `v` %d", v);
    }
    if (node->kind == YAML_TREE_LIST)
        return st;
    while (group < p->groups && strcmp(p->group[group], node->text))
        group++;
    if (group == p->groups)
        return yaml_tree_refuse(node, why, "the sheet's mesh has no group (`g`) %s",
                                yaml_tree_quote(node->text).text);
    for (int n = 0; n < 3 * p->mesh.triangles; n++)
        if (p->in[n / 3] == group)
            marked[pattern_node(p, p->mesh.triangle[n / 3][n % 3])] = true;
out:
    return st;
}

/* Adds a triangle's marked corners to the parts, the first in place of those that are not.
 */
static void add_part(const struct pattern *p, int triangle, const bool *marked,
                     struct scene_support *s)
{
    const int *v = p->mesh.triangle[triangle];
    int first = 0;

    while (first < 3 && !marked[pattern_node(p, v[first])])
        first++;
    for (int k = 0; first < 3 && k < 3; k++) {
        const double *at = p->mesh.at[v[marked[pattern_node(p, v[k])] ? k : first]];
        for (int i = 0; i < 2; i++) {
            const double place = at[i] / p->size[i];
            s->part[s->part_count][k][i] = place;
            s->lo[i] = fmin(s->lo[i], place), s->hi[i] = fmax(s->hi[i], place);
        }
    }
    s->part_count += first < 3;
}

static enum status place_support(const struct yaml_tree *node, const struct pattern *p,
                                 struct scene_support *s, struct message *why)
{
    enum status st;
    bool *marked = calloc((size_t)p->mesh.nodes, sizeof *marked);

    s->part = malloc((size_t)p->mesh.triangles * sizeof *s->part);
    TRY(marked && s->part ? STATUS_OK : STATUS_MEMORY);
    TRY(mark(node, p, marked, why));
    s->lo[0] = s->lo[1] = 1, s->hi[0] = s->hi[1] = 0;
    for (int t = 0; t < p->mesh.triangles; t++)
        add_part(p, t, marked, s);
    if (!s->part_count)
        st = yaml_tree_refuse(node, why, "no face is in this group");
out:
    free(marked);
    return st;
}

/* Places the supports that name vertices or a group. */
static enum status place_supports(const struct yaml_tree *root, struct scene *scene,
                                  struct message *why)
{
    const struct yaml_tree *node = yaml_tree_first(root, "supports");
    enum status st = STATUS_OK;

    for (struct scene_support *s = scene->supports; node; s++, node = node->next) {
        const struct yaml_tree *at = yaml_tree_find(node, "at"),
                               *vertices = yaml_tree_find(at, "vertices"),
                               *group = yaml_tree_find(at, "group"),
                               *names = vertices ? vertices : group;
        if (!names)
            continue;
        if (vertices ? vertices->kind != YAML_TREE_LIST || !vertices->count
                     : group->kind != YAML_TREE_SCALAR)
            return yaml_tree_refuse(names, why, "%s must be %s",
                                    vertices ? "vertices" : "group",
                                    vertices ? "a list of numbers" : "a name");
        if ((vertices && group) || yaml_tree_find(at, "u") || yaml_tree_find(at, "v"))
            return yaml_tree_refuse(names, why,
                                    "a support lies at u and v, at vertices or at a group; "
                                    "one of these would be right");
        if (!scene->pattern_file)
            return yaml_tree_refuse(names, why,
                                    "vertices and groups are of a sheet with a mesh");
        if (scene->pattern)
            TRY(place_support(names, scene->pattern, s, why));
    }
out:
    return st;
}

enum status scene_outline_check(const struct yaml_tree *root, bool files,
                                struct scene *scene, struct message *why)
{
    const struct yaml_tree *sheet = yaml_tree_find(root, "sheet");
    const struct yaml_tree *outline = yaml_tree_find(sheet, "outline"),
                           *mesh = yaml_tree_find(sheet, "mesh"),
                           *holes = yaml_tree_find(sheet, "holes");
    const char *const size[2] = {"length", "width"};
    enum status st = STATUS_OK;

    for (int i = 0; i < 2; i++) {
        const struct yaml_tree *given = yaml_tree_find(sheet, size[i]);
        const struct schema_key *key = &scene_outline_keys[i];
        if (given && (outline || mesh))
            return yaml_tree_refuse(
                given, why,
                "%s follows from the outline or mesh of the sheet; leave it out", size[i]);
        if (!given && !outline && !mesh)
            return schema_lacks(key, sheet, "sheet", why);
    }
    if (outline && mesh)
        return yaml_tree_refuse(mesh, why, "a sheet has an outline or a mesh, not both");
    if (holes && !outline)
        return yaml_tree_refuse(holes, why, "holes are of a sheet with an outline");
    const struct yaml_tree *seams = yaml_tree_find(sheet, "seams");
    if (seams && !mesh)
        return yaml_tree_refuse(seams, why, "seams are of a sheet with a mesh");
    if (!outline && !mesh)
        return place_supports(root, scene, why);
    if (scene->sheets > 1 || scene->shape != SCENE_FLAT)
        return yaml_tree_refuse(
            outline ? outline : mesh, why,
            "a sheet with an outline or a mesh must be flat, and the only one");
    if (outline)
        TRY(draw_pattern(outline, holes, scene, why));
    else
        TRY(load_pattern(root, mesh, files, scene, why));
    for (int c = 0; c < 3 && scene->pattern; c++)
        scene->origin[c] += scene->pattern->corner[0] * scene->axis_u[c] +
                            scene->pattern->corner[1] * scene->axis_v[c];
    TRY(place_supports(root, scene, why));
out:
    return st;
}
