/* mesh_file.h - bodies from Wavefront OBJ files (obj_file.h). */
#ifndef MESH_FILE_H
#define MESH_FILE_H

#include "models/bodies/body_mesh.h"
#include "models/reader/yaml_tree.h"

enum { MESH_FILE_PATH = 4096 };

/* Finds the path of an OBJ file that `key` of a scene names, from the folder of the root's
 * origin. STATUS_INPUT with a sentence where it has another ending. */
enum status mesh_file_path(const struct yaml_tree *root, const struct yaml_tree *key,
                           const char *name, char path[MESH_FILE_PATH],
                           struct message *why);

/* Reads a mesh whose file's vertex x is at at[3] + scale x, freed by the receiver with
 * free. STATUS_INPUT with a sentence `path:line: ...` or `path: ...`, also where the file
 * cannot be read, or STATUS_MEMORY. */
enum status mesh_file_read(const char *path, const double at[3], double scale,
                           struct obstacle_mesh **mesh, struct message *why);

#endif
