/* HDF5: data sets xyz [frames][n][3], uv [n][2], t [frames]; or a result file of the
 * program's (bench/files/store.h), whose layers' middle is taken. */
#include "bench/files/hdf5_file.h"
#include "bench/files/store.h"
#include "bench/frames/frames_parts.h"
#include "models/grid.h"

#include <stdlib.h>
#include <string.h>

struct foreign {
    hid_t file, xyz;
    hsize_t frames;
    double *t; /* owned */
};

static void close_foreign(void *state)
{
    struct foreign *h = state;

    hdf5_file_drop(h->xyz);
    if (h->file >= 0)
        H5Fclose(h->file);
    free(h->t);
    free(h);
}

static enum status next_foreign(struct frames *f, double *t, bool *more,
                                struct message *why)
{
    struct foreign *h = f->state;

    *more = (hsize_t)f->number <= h->frames;
    if (!*more)
        return STATUS_OK;
    *t = h->t ? h->t[f->number - 1] : f->number - 1;
    return hdf5_file_read_entry(h->xyz, f->number - 1, f->xyz)
               ? STATUS_OK
               : hdf5_file_fail(f->path, "cannot read a frame of xyz", why);
}

/* Reads a data set of `count` numbers of any rank; NULL stays NULL if there is none. */
static enum status take_small(struct frames *f, hid_t file, const char *name, hsize_t count,
                              double **values, struct message *why)
{
    hsize_t size[HDF5_FILE_RANK], held = 1;
    int rank;
    hid_t set = hdf5_file_open_set(file, name, &rank, size);
    double *array = NULL;
    enum status st = STATUS_OK;

    if (set < 0)
        return STATUS_OK;
    for (int n = 0; n < rank; n++) /* too much stays too much: the product does not wrap */
        held = held > count || size[n] > count ? count + 1 : held * size[n];
    if (!rank || held != count)
        TRY(status_fail(why, STATUS_INPUT, "%s: %s: has %llu numbers; %llu would be right",
                        f->path, name, rank ? (unsigned long long)held : 0,
                        (unsigned long long)count));
    array = malloc((size_t)count * sizeof *array);
    TRY(array ? STATUS_OK : STATUS_MEMORY);
    if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array) < 0)
        TRY(hdf5_file_fail(f->path, "cannot read its numbers", why));
    *values = array, array = NULL;
out:
    free(array);
    hdf5_file_drop(set);
    return st;
}

static enum status open_foreign(struct frames *f, struct message *why)
{
    static const struct frames_reader reader = {next_foreign, close_foreign};
    struct foreign *h = calloc(1, sizeof *h);
    hsize_t size[HDF5_FILE_RANK] = {0};
    int rank;
    enum status st = STATUS_OK;

    if (!h)
        return STATUS_MEMORY;
    h->file = h->xyz = H5I_INVALID_HID;
    f->state = h;
    f->reader = &reader;
    h->file = H5Fopen(f->path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (h->file < 0)
        TRY(hdf5_file_fail(f->path, "cannot be read", why));
    h->xyz = hdf5_file_open_set(h->file, "xyz", &rank, size);
    if (rank && !size[0])
        TRY(frames_none(f, why));
    if (rank != 3 || size[2] != 3 || size[0] > FRAMES_MOST_TIMES ||
        size[1] > FRAMES_MOST_VERTICES)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: xyz: is not there, or of rank %d; a data set xyz "
                        "[frames][n][3] would be right",
                        f->path, rank));
    h->frames = size[0];
    TRY(frames_room(f, (long)size[1], why));
    TRY(take_small(f, h->file, "uv", 2 * size[1], &f->net.uv, why));
    TRY(take_small(f, h->file, "t", h->frames, &h->t, why));
    f->timed = h->t != NULL;
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

static enum status next_own(struct frames *f, double *t, bool *more, struct message *why)
{
    struct own *o = f->state;
    enum status st = STATUS_OK;

    *more = f->number <= store_read_frames(o->file);
    if (!*more)
        return STATUS_OK;
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
    TRY(store_read_array(o->file, "xyz_time", &o->t, &rows, &columns, why));
    if (rows != store_read_frames(o->file) || columns != 1)
        TRY(status_fail(why, STATUS_INPUT, "%s: xyz_time: has %d times of %d frames",
                        f->path, rows, store_read_frames(o->file)));
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
    struct frames_bytes b = {0};
    enum status st;

    TRY(frames_bytes_open(path, &b, why));
    const bool foreign = b.size > 8 && !memcmp(b.byte, "\x89HDF\r\n\x1a\n", 8);
    frames_bytes_close(&b);
    hdf5_file_start();
    TRY(foreign ? open_foreign(f, why) : open_own(f, why));
out:
    return st;
}
