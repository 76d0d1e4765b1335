#include "models/reader/mesh_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/obj_file.h"
#include "models/reader/yaml_tree.h"

static const double FARTHEST = 1e6; /* as of a scene's places [m] */

/* Writes where the file's vertices are in the scene. */
static enum status place(const struct obj_file *o, const char *path, const double at[3],
                         double scale, double (*xyz)[3], struct message *why)
{
    for (int n = 0; n < o->vertices; n++)
        for (int i = 0; i < 3; i++) {
            const struct yaml_tree line = {.origin = path, .line = o->vertex[n].line};
            xyz[n][i] = at[i] + scale * o->vertex[n].at[i];
            if (!(fabs(xyz[n][i]) <= FARTHEST))
                return yaml_tree_refuse(&line, why,
                                        "a vertex is farther than %g m from 0 in the "
                                        "scene; nearer would be right",
                                        FARTHEST);
        }
    return STATUS_OK;
}

enum status mesh_file_path(const struct yaml_tree *root, const struct yaml_tree *key,
                           const char *name, char path[MESH_FILE_PATH], struct message *why)
{
    const char *slash = *name == '/' ? NULL : strrchr(root->origin, '/');
    const int folder = slash ? (int)(slash - root->origin) + 1 : 0;
    const size_t length = strlen(name);

    if (length < 5 || strcmp(name + length - 4, ".obj") != 0)
        return yaml_tree_refuse(key, why,
                                "%s is %s, but must name an OBJ file, as body.obj",
                                key->key, yaml_tree_quote(name).text);
    if (snprintf(path, MESH_FILE_PATH, "%.*s%s", folder, root->origin, name) >=
        MESH_FILE_PATH)
        return yaml_tree_refuse(key, why, "the path of the mesh is too long");
    return STATUS_OK;
}

enum status mesh_file_read(const char *path, const double at[3], double scale,
                           struct obstacle_mesh **mesh, struct message *why)
{
    const struct yaml_tree whole = {.origin = path, .line = -1};
    struct obj_file o;
    struct message inner = {""};
    double(*xyz)[3] = NULL;
    int(*triangle)[3] = NULL;
    enum status st;

    *mesh = NULL;
    TRY(obj_file_read(path, &o, why));
    if (o.vertices > BODY_MESH_MOST_VERTICES || o.corners / 3 > BODY_MESH_MOST)
        TRY(yaml_tree_refuse(&whole, why,
                             "has %d vertices and %d triangles; %d and %d at most would "
                             "be right",
                             o.vertices, o.corners / 3, BODY_MESH_MOST_VERTICES,
                             BODY_MESH_MOST));
    xyz = malloc(((size_t)o.vertices + 1) * sizeof *xyz);
    triangle = malloc(((size_t)o.corners / 3 + 1) * sizeof *triangle);
    TRY(xyz && triangle ? STATUS_OK : STATUS_MEMORY);
    TRY(place(&o, path, at, scale, xyz, why));
    for (int n = 0; n < o.corners; n++)
        triangle[n / 3][n % 3] = o.corner[n].v;
    st = body_mesh_make(o.vertices, (const double(*)[3])xyz, o.corners / 3,
                        (const int(*)[3])triangle, mesh, &inner);
    if (st == STATUS_INPUT)
        yaml_tree_refuse(&whole, why, "%s", inner.text);
out:
    obj_file_clear(&o);
    free(xyz);
    free(triangle);
    return st;
}
