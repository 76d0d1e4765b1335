/* pattern_file.h - flat patterns from Wavefront OBJ files (obj_file.h).
 *
 * Points are those that faces name, in the file's order, and so are triangles. Refusals are
 * STATUS_INPUT with a sentence `path:line: ...` or `path: ...`.
 */
#ifndef PATTERN_FILE_H
#define PATTERN_FILE_H

#include "models/pattern.h"

/* Reads triangles of a rectangle with these sides, which they must cover once. The plane is
 * vt times the sides, where faces name vt, else x and y in metres. */
enum status pattern_file_read(const char *path, const double side[2],
                              struct mesh_flat *flat, struct message *why);

/* Reads a sheet of any outline: its plane is vt in metres, or, where faces name none, x and
 * y. A point with several `vt` is on a seam of panels that lie beside each other in the
 * plane, and pair[pairs][2], numbers of `v` from 0, sew others together. Where there are
 * seams, or x, y and z are not the plane, the sheet starts at them, and what is sewn
 * together at their mean. The box's size goes to size[2] [m]; *pattern is the caller's. */
enum status pattern_file_outline(const char *path, int pairs, const int (*pair)[2],
                                 struct pattern **pattern, double size[2],
                                 struct message *why);

#endif
