/* frames_reader.h - a reader of one format of frames, and what all of them use; private to
 * frames.h.
 *
 * A reader's `open` fills count, net.vertices (by frames_room), uv and faces as far as the
 * file has them, and timed; its `next` fills xyz of frame `number`, and *t where the file
 * has times. What all have in common (counting, times, finite numbers, --rest) frames.c
 * sees to.
 */
#ifndef FRAMES_READER_H
#define FRAMES_READER_H

#include "bench/frames/frames.h"
#include "bench/frames/frames_file.h"

struct frames_reader {
    size_t state; /* bytes of f->state, all zero before `open`                          */
    enum status (*open)(struct frames *f, struct message *why);
    enum status (*next)(struct frames *f, double *t, struct message *why);
    void (*close)(void *state); /* frees what it holds; NULL: nothing                   */
};

struct frames {
    struct arena arena;         /* of all that is below                         owned   */
    const char *path;           /* for sentences; the file, or the folder               */
    struct frames_folder files; /* one, or those of a sequence in their order           */
    struct frames_look look;
    struct frames_net net;
    double *xyz; /* [vertices][3]                                                       */
    int count;   /* of frames                                                           */
    int number;  /* number of the frame last read, from 1                               */
    double time; /* of it                                                               */
    const char *scene; /* frames_scene                                                  */
    bool timed; /* the file has times                                                  */
    const struct frames_reader *reader;
    void *state;
};

/* Makes room for the vertices of the net. STATUS_INPUT: too many, none. */
enum status frames_room(struct frames *f, long vertices, struct message *why);

/* One mesh: all of a net, and where it is. All-zero before, but for its memory. */
struct frames_mesh {
    struct arena *arena; /* borrowed */
    int vertices, triangles;
    double *xyz;        /* [vertices][3]                                                */
    double *uv;         /* [vertices][2]; NULL: none                                    */
    int (*triangle)[3]; /* polygons are fans of them                                    */
    bool seams;         /* set by the caller: vt of OBJ are those of corners            */
    double (*corner)[3][2]; /* [triangles] these, in place of uv; NULL: there are none  */
};
enum status frames_mesh_read(const char *path, bool seams, struct arena *arena,
                             struct frames_mesh *mesh, struct message *why);
enum status frames_mesh_obj(const char *path, struct frames_mesh *mesh,
                            struct message *why);
enum status frames_mesh_ply(const char *path, struct frames_mesh *mesh,
                            struct message *why);

/* Adds a polygon's vertices [count], counted from 0, as triangles. */
void frames_mesh_face(struct frames_mesh *mesh, int count, const long *vertex);

#endif
