/* obj_file.h - reads Wavefront OBJ files (1995): lines `v x y z`, `vt u v`, `g name` and
 * `f v/vt/vn ...`. A face names points by their number from 1, or from the last one above
 * it back if negative; points may stand below the faces that name them. A face of more than
 * three is cut into a fan; other lines are skipped. */
#ifndef OBJ_FILE_H
#define OBJ_FILE_H

#include "models/status.h"

struct obj_file_vertex {
    double at[3]; /* finite, in the file's unit */
    int line;
};

struct obj_file_corner {
    int v, vt; /* from 0; vt is -1 where the face names none                           */
    int line;
    int group; /* -1: before the first `g` */
};

struct obj_file {
    int vertices, textures, corners, groups;
    struct obj_file_vertex *vertex; /* [vertices]                                owned */
    double (*texture)[2];           /* [textures], finite                        owned */
    struct obj_file_corner *corner; /* [corners], three a triangle               owned */
    char **group;                   /* [groups] names, each once                 owned */
};

/* Reads a file. *o is overwritten, also by a refusal; free with obj_file_clear.
 * STATUS_INPUT with a sentence `path:line: ...` or `path: ...`, also where the file cannot
 * be read, or STATUS_MEMORY. */
enum status obj_file_read(const char *path, struct obj_file *o, struct message *why);
void obj_file_clear(struct obj_file *o); /* all-zero is allowed */

#endif
