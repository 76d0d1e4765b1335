#include "models/reader/scene_outline.h"

#include <stdlib.h>

#include "models/pattern.h"
#include "models/reader/mesh_file.h"
#include "models/reader/pattern_file.h"
#include "models/reader/schema.h"

/* Leaves to scene_outline_check what takes several keys. */
static enum status read_later(const struct schema_key *key, const struct yaml_tree *node,
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
     SCHEMA_SPECIAL, .read = read_later, .want = "3 to 10000 points [x, y]"},
    {"holes", "closed lines in the outline [m]", SCHEMA_SPECIAL, .read = read_later,
     .want = "a list of lines of points [x, y]"},
    {"mesh", "in place of an outline: OBJ file, sought from the scene's folder, whose x "
     "and y are the flat pattern [m]", SCHEMA_TEXT, .offset = offsetof(struct scene, pattern_file)},
    {"thickness", "h along w; fabrics have their own [m]", SCHEMA_NUMBER, .low = 1e-9,
     .high = 1e6, .offset = offsetof(struct scene, thickness)},
    {NULL}};
/* clang-format on */

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
            "has a point twice; each once, without the first again at the end, "
            "would be right",
        [PATTERN_CROSSING] =
            "has a side that meets another one; sides that meet at their ends "
            "only would be right",
        [PATTERN_PIECES] = "has no area",
        [PATTERN_OUTSIDE] =
            "is a hole that is not inside the outline, or is in another hole"};
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
    pattern_free(scene->pattern);
    scene->pattern = p, p = NULL;
    scene->length = size[0], scene->width = size[1];
out:
    pattern_free(p);
    return st;
}

/* Reads the mesh that is the sheet, if `files`. */
static enum status load_pattern(const struct yaml_tree *root, const struct yaml_tree *mesh,
                                bool files, struct scene *scene, struct message *why)
{
    double size[2];
    struct message inner = {""};
    char path[MESH_FILE_PATH];
    enum status st = mesh_file_path(root, mesh, scene->pattern_file, path, why);

    scene->length = scene->width = 1;
    if (st != STATUS_OK || !files)
        return st;
    st = pattern_file_outline(path, &scene->pattern, size, &inner);
    if (st == STATUS_OK)
        scene->length = size[0], scene->width = size[1];
    return st == STATUS_INPUT ? yaml_tree_refuse(mesh, why, "%s", inner.text) : st;
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
                "%s follows from the outline or mesh of the sheet; leave "
                "it out",
                size[i]);
        if (!given && !outline && !mesh)
            return schema_lacks(key, sheet, "sheet", why);
    }
    if (outline && mesh)
        return yaml_tree_refuse(mesh, why, "a sheet has an outline or a mesh, not both");
    if (holes && !outline)
        return yaml_tree_refuse(holes, why, "holes are of a sheet with an outline");
    if (!outline && !mesh)
        return STATUS_OK;
    if (scene->sheets > 1 || scene->shape != SCENE_FLAT)
        return yaml_tree_refuse(
            outline ? outline : mesh, why,
            "a sheet with an outline or a mesh must be flat, and the only "
            "one");
    if (outline)
        TRY(draw_pattern(outline, holes, scene, why));
    else
        TRY(load_pattern(root, mesh, files, scene, why));
    for (int c = 0; c < 3 && scene->pattern; c++)
        scene->origin[c] += scene->pattern->corner[0] * scene->axis_u[c] +
                            scene->pattern->corner[1] * scene->axis_v[c];
out:
    return st;
}
