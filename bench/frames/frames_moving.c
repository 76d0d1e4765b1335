/* Reads arrays xyz [frames][n][3] (or [frames][rows][columns][3]), uv [n][2], t [frames] of
 * NumPy's files and HDF5; and the program's own result files (bench/files/store.h), of
 * whose layers the middle is taken. */
#include <stdlib.h>
#include <string.h>

#include "bench/files/hdf5_file.h"
#include "bench/files/store.h"
#include "bench/frames/frames_array.h"
#include "bench/frames/frames_parts.h"
#include "models/grid.h"

struct moving {
    struct frames_array *file; /* owned, at the next frame of xyz                       */
    double *t;                 /* [frames]; NULL: none                          owned   */
};

static void close_moving(void *state)
{
    struct moving *m = state;

    frames_array_close(m->file);
    free(m->t);
    free(m);
}

static enum status next_moving(struct frames *f, double *t, struct message *why)
{
    const struct moving *m = f->state;

    if (m->t)
        *t = m->t[f->number - 1];
    if (frames_array_read(m->file, 3 * (size_t)f->net.vertices, f->xyz))
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: frame %d: xyz is cut off or damaged; %d whole frames would be "
                       "right",
                       f->path, f->number, f->count);
}

/* Begins to read xyz, and takes its sizes. */
static enum status begin_xyz(struct frames *f, struct frames_array *file,
                             struct message *why)
{
    unsigned long long size[8];
    int rank = 0;
    enum status st = frames_array_begin(file, "xyz", size, why);

    if (st == STATUS_UNSUPPORTED)
        st = status_fail(why, STATUS_INPUT,
                         "%s: has no array xyz; xyz [frames][n][3], uv [n][2] and t "
                         "[frames] would be right",
                         f->path);
    TRY(st);
    while (rank < 8 && size[rank])
        rank++;
    if (!rank)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: xyz has no frames; one or more would be right", f->path));
    if (rank < 3 || rank > 4 || size[rank - 1] != 3 || size[0] > FRAMES_MOST_TIMES ||
        size[1] > FRAMES_MOST_VERTICES || size[rank - 2] > FRAMES_MOST_VERTICES)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: xyz: has rank %d and ends in %llu; [frames][n][3] would be "
                        "right",
                        f->path, rank, size[rank - 1]));
    f->count = (int)size[0];
    f->net.vertices = (int)(size[1] * (rank == 4 ? size[2] : 1));
out:
    return st;
}

/* Reads a small array; *values stays NULL if there is none. */
static enum status take_small(struct frames_array *file, const char *name, int rows,
                              size_t columns, double **values, struct message *why)
{
    const enum status st =
        frames_array_load(file, name, (size_t)rows, columns, values, why);

    return st == STATUS_UNSUPPORTED ? STATUS_OK : st;
}

enum status frames_moving_open(struct frames *f, const char *path, struct message *why)
{
    static const struct frames_reader reader = {next_moving, close_moving};
    struct moving *m = calloc(1, sizeof *m);
    enum status st;

    if (!m)
        return STATUS_MEMORY;
    f->state = m;
    f->reader = &reader;
    TRY(frames_array_open(path, &m->file, why));
    TRY(begin_xyz(f, m->file, why));
    TRY(frames_room(f, f->net.vertices, why));
    TRY(take_small(m->file, "uv", f->net.vertices, 2, &f->net.uv, why));
    TRY(take_small(m->file, "t", f->count, 1, &m->t, why));
    TRY(begin_xyz(f, m->file, why));
    f->timed = m->t;
out:
    return st;
}

struct own {
    struct store_read *file;
    double *field, *t; /* owned */
};

static void close_own(void *state)
{
    struct own *o = state;

    store_read_close(o->file);
    free(o->field);
    free(o->t);
    free(o);
}

static enum status next_own(struct frames *f, double *t, struct message *why)
{
    struct own *o = f->state;
    enum status st;

    *t = o->t[f->number - 1];
    TRY(store_read_frame(o->file, f->number - 1, o->field, why));
    for (int n = 0; n < 3 * f->net.vertices; n++)
        f->xyz[n] = .5 * (o->field[n] + o->field[3 * f->net.vertices + n]);
out:
    return st;
}

static enum status open_own(struct frames *f, struct message *why)
{
    static const struct frames_reader reader = {next_own, close_own};
    struct own *o = calloc(1, sizeof *o);
    int rows, columns;
    enum status st;

    if (!o)
        return STATUS_MEMORY;
    f->state = o;
    f->reader = &reader;
    f->timed = true;
    TRY(store_read_open(f->path, &o->file, why));
    f->count = store_read_frames(o->file);
    TRY(store_read_array(o->file, "xyz_time", &o->t, &rows, &columns, why));
    if (rows != f->count || columns != 1)
        TRY(status_fail(why, STATUS_INPUT, "%s: xyz_time: has %d times of %d frames",
                        f->path, rows, f->count));
    TRY(frames_room(f, GRID_U * GRID_V, why));
    o->field = malloc(3 * GRID_POINTS * sizeof *o->field);
    f->net.uv = malloc(2 * GRID_U * GRID_V * sizeof *f->net.uv);
    TRY(o->field && f->net.uv ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < GRID_U * GRID_V; n++) {
        double uvw[3];
        grid_point(n, uvw);
        memcpy(f->net.uv + 2 * n, uvw, 2 * sizeof *uvw);
    }
out:
    return st;
}

/* Opens a file: the program's own is sealed; any other begins with HDF5's signature. */
enum status frames_hdf5_open(struct frames *f, const char *path, struct message *why)
{
    static const char signature[] = "\x89HDF\r\n\x1a\n";
    struct frames_file file;
    char head[8];
    enum status st;

    TRY(frames_file_open(path, &file, why));
    const bool foreign = frames_file_read(&file, head, 8) && !memcmp(head, signature, 8);
    frames_file_close(&file);
    hdf5_file_start();
    TRY(foreign ? frames_moving_open(f, path, why) : open_own(f, why));
out:
    return st;
}
