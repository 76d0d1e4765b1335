/* mesh_file.h - bodies from Wavefront OBJ files: lines `v x y z` and `f a b c ...`, where a
 * is a vertex's number from 1, or from the last one back if negative, and may go on as in
 * a/b/c. Vertices stand above the faces that name them; a face of more than three is cut
 * into a fan; other lines are skipped. */
#ifndef MESH_FILE_H
#define MESH_FILE_H

#include "models/contact/contact_mesh.h"

/* Reads a mesh whose file's vertex x is at at[3] + scale x, freed by the receiver with
 * free. STATUS_INPUT with a sentence `path:line: ...` or `path: ...`, also where the file
 * cannot be read, or STATUS_MEMORY. */
enum status mesh_file_read(const char *path, const double at[3], double scale,
                           struct obstacle_mesh **mesh, struct message *why);

#endif
