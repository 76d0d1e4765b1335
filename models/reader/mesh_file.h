/* mesh_file.h - bodies from Wavefront OBJ files (obj_file.h). */
#ifndef MESH_FILE_H
#define MESH_FILE_H

#include "models/contact/contact_mesh.h"

/* Reads a mesh whose file's vertex x is at at[3] + scale x, freed by the receiver with
 * free. STATUS_INPUT with a sentence `path:line: ...` or `path: ...`, also where the file
 * cannot be read, or STATUS_MEMORY. */
enum status mesh_file_read(const char *path, const double at[3], double scale,
                           struct obstacle_mesh **mesh, struct message *why);

#endif
