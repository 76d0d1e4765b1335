/* frames.h - somebody else's frames: where the vertices of a moving net are, frame by
 * frame.
 *
 *     struct frames *f;
 *     TRY(frames_open(1, &path, &(struct frames_look){.dt = 0.01}, &f, why));
 *     do TRY(frames_next(f, &t, &xyz, why)); while (xyz);
 *     out: frames_close(f);
 *
 * One frame is in memory at a time. What is read, by the end of the name:
 *
 *   .csv         lines t,u,v,x,y,z, or in the order of a line of these names (others are
 *                passed over), rows in any order; lines that begin with # are comments
 *   .obj .ply    a file a frame: a folder, or several files, in the order of the numbers in
 *                their names. uv from `vt`, or from properties u,v, s,t, texture_u, ...
 *   .npz         xyz [frames][n][3], uv [n][2], t [frames], faces [m][3 or 4], of floats or
 *                whole numbers, stored or deflated (Fortran's order: as a whole in memory);
 *                .npy: xyz alone
 *   .h5 .hdf5    data sets of the same names; or the program's own result files and truths
 *   .mdd .pc2    point caches
 *
 * Positions are as the file has them: units and axes are the caller's business. What is
 * wrong is a sentence `file: frame or line: what, and what would be right`: STATUS_INPUT,
 * or STATUS_FILE where it cannot be read.
 */
#ifndef FRAMES_H
#define FRAMES_H

#include <stdbool.h>

#include "bench/files/arena.h"
#include "models/status.h"

struct frames;

struct frames_look {
    double dt; /* interval [s]; 0: not given. Overrides the file's times         */
    const char
        *rest;  /* a mesh (.obj, .ply) with the vertices' uv or rest positions; NULL */
    bool seams; /* vt of OBJ are places of corners, of which a vertex may have several   */
};

/* The net that moves; owned by the frames. */
struct frames_net {
    int vertices;
    int points[2]; /* of the net of whose surface a result file has so many places; 0  */
    bool linear;   /* between these points, which stand evenly                         */
    bool *beside;  /* [vertices] of a result file: points of the material grid that are
                      beside the sheet, and lie where another is; NULL: of others       */
    double *uv;    /* [vertices][2] material coordinates; NULL: unknown              */
    double *rest;  /* [vertices][3] of --rest; NULL: none                            */
    int triangles; /* 0: no faces                                                    */
    int (*triangle)[3]; /* [triangles] of vertices, from 0                                */
    double (*corner)[3][2]; /* [triangles] places of their corners, as vt has them, where
                               seams are looked for; NULL: those of the vertices          */
};

/* Tells whether two lists have the same triangles of vertices, in any order. */
bool frames_same_faces(int count, const int (*a)[3], int other, const int (*b)[3]);

/* The most vertices of a net and times of a file: a larger count is taken for damage. */
enum {
    FRAMES_MOST_VERTICES = 4000000,
    FRAMES_MOST_TIMES = 10000000,
    FRAMES_MOST_FACES = 8000000
};

/* Opens paths[count]: one file or folder, or several files, each a frame. */
enum status frames_open(int count, const char *const *paths, const struct frames_look *look,
                        struct frames **frames, struct message *why);
void frames_close(struct frames *f); /* NULL is allowed */
SCOPE_OF(frames_close, struct frames)

/* Returns the name of the file that the frames come from; of a sequence the first. */
const char *frames_name(const struct frames *f);

const struct frames_net *frames_net(const struct frames *f);

/* Returns the name of the scene that a result file is of; NULL: it is nobody's run here. */
const char *frames_scene(const struct frames *f);

/* Reads the next frame: its time [s], later than the one before, and positions
 * [vertices][3], all finite, borrowed until the next call; *xyz is NULL after the last. */
enum status frames_next(struct frames *f, double *t, const double **xyz,
                        struct message *why);

/* The files of a folder, in the order of the numbers in their names: s2 before s10. */
struct frames_folder {
    int count;
    char **path;        /* [count] FOLDER/NAME, hidden ones left out                */
    struct arena arena; /* of these                                      owned */
};

/* Lists a folder. STATUS_FILE with a sentence; *folder is overwritten; free with
 * frames_folder_clear. */
enum status frames_folder_read(const char *path, struct frames_folder *folder,
                               struct message *why);
void frames_folder_clear(struct frames_folder *folder);

/* Removes the files for which keep() is false from the list. */
void frames_folder_keep(struct frames_folder *folder, bool (*keep)(const char *path));

/* Returns whether a name has the ending of one of the file types above. */
bool frames_is_name(const char *name);

#endif
