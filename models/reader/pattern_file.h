/* pattern_file.h - flat patterns from Wavefront OBJ files: lines `v x y z`, `vt u v` and
 * `f a b c ...`, a may go on as in a/b/c; other lines are skipped.
 *
 * Points are those that faces name, in the file's order; triangles the file's. Refusals are
 * STATUS_INPUT with a sentence `path:line: ...` or `path: ...`.
 */
#ifndef PATTERN_FILE_H
#define PATTERN_FILE_H

#include "models/pattern.h"

/* Reads triangles of a rectangle with these sides, which they must cover once. The plane is
 * vt times the sides, where faces name vt, else x and y in metres. */
enum status pattern_file_read(const char *path, const double side[2],
                              struct mesh_flat *flat, struct message *why);

/* Reads a sheet of any outline, in one piece: its plane is x and y in metres, and so is vt,
 * where faces name it; size[2]: of its box [m]. *pattern is the caller's. */
enum status pattern_file_outline(const char *path, struct pattern **pattern, double size[2],
                                 struct message *why);

#endif
