#include "bench/files/store_read.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "models/grid.h"

struct store_read {
    char *path;
    hid_t file, xyz;
    int frames;
    long size; /* [bytes]: nothing in a sound file is larger */
};

/* Any identifier of the library's, valid or not. */
static void drop(hid_t id)
{
    if (id >= 0)
        H5Idec_ref(id);
}

enum { FRAME_LEAST = GRID_POINTS * 3 * 4 }; /* of 32-bit numbers [bytes] */
enum { TEXT_MOST = 1 << 24 };

static enum status fail(const struct store_read *f, const char *what, struct message *why)
{
    char doing[128] = "cannot read ";
    strncat(doing, what, sizeof doing - strlen(doing) - 1);
    return hdf5_file_fail(f->path, doing, why);
}

/* The positions have the shape of store.h. */
static bool open_xyz(struct store_read *f)
{
    hsize_t size[5] = {0};

    if (H5Lexists(f->file, "xyz", H5P_DEFAULT) <= 0)
        return false;
    f->xyz = H5Dopen2(f->file, "xyz", H5P_DEFAULT);
    hid_t space = f->xyz < 0 ? H5I_INVALID_HID : H5Dget_space(f->xyz);
    bool good = space >= 0 && H5Sget_simple_extent_ndims(space) == 5 &&
                H5Sget_simple_extent_dims(space, size, NULL) == 5 && size[1] == GRID_W &&
                size[2] == GRID_V && size[3] == GRID_U && size[4] == 3;
    drop(space);
    /* Deflate packs a thousandfold at most. */
    good = good && size[0] <= INT_MAX &&
           size[0] * FRAME_LEAST <= 1032 * H5Dget_storage_size(f->xyz);
    f->frames = good ? (int)size[0] : 0;
    return good;
}

enum status store_read_open(const char *path, struct store_read **file, struct message *why)
{
    enum status st = STATUS_OK;
    struct store_read *f = calloc(1, sizeof *f);

    if (!f)
        return STATUS_MEMORY;
    hdf5_file_start();
    f->file = f->xyz = H5I_INVALID_HID;
    f->path = strdup(path);
    TRY(f->path ? STATUS_OK : STATUS_MEMORY);
    TRY(seal_check(path, &f->size, why));
    f->file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (f->file < 0)
        TRY(hdf5_file_fail(path, "cannot be read", why));
    if (!open_xyz(f))
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: is not a result file (no xyz [frame][2][100][100][3])", path));
    *file = f, f = NULL;
out:
    store_read_close(f);
    return st;
}

void store_read_close(struct store_read *f)
{
    if (!f)
        return;
    drop(f->xyz);
    if (f->file >= 0)
        H5Fclose(f->file);
    free(f->path);
    free(f);
}

int store_read_frames(const struct store_read *f)
{
    return f->frames;
}

enum status store_read_frame(const struct store_read *f, int n, double *xyz,
                             struct message *why)
{
    hsize_t start[5] = {(hsize_t)n, 0, 0, 0, 0}, count[5] = {1, GRID_W, GRID_V, GRID_U, 3};
    assert(0 <= n && n < f->frames);

    hid_t memory = H5Screate_simple(5, count, NULL), space = H5Dget_space(f->xyz);
    bool good = H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, count, NULL) >= 0 &&
                H5Dread(f->xyz, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, xyz) >= 0;
    H5Sclose(space);
    H5Sclose(memory);
    return good ? STATUS_OK : fail(f, "a frame of xyz", why);
}

/* Every link on the way must exist: the library errs on a missing group. */
bool store_read_has(const struct store_read *f, const char *name)
{
    char part[128];
    size_t length = strlen(name);

    if (length >= sizeof part)
        return false;
    for (size_t i = 1; i <= length; i++) {
        if (name[i] != '/' && name[i] != '\0')
            continue;
        memcpy(part, name, i);
        part[i] = '\0';
        if (H5Lexists(f->file, part, H5P_DEFAULT) <= 0)
            return false;
    }
    return true;
}

enum status store_read_array(const struct store_read *f, const char *name, double **values,
                             int *rows, int *columns, struct message *why)
{
    enum status st = STATUS_OK;
    hsize_t size[2] = {0, 1};
    hid_t set = H5I_INVALID_HID, space = H5I_INVALID_HID;
    double *array = NULL;

    if (!store_read_has(f, name))
        return status_fail(why, STATUS_INPUT, "%s: has no %s", f->path, name);
    set = H5Dopen2(f->file, name, H5P_DEFAULT);
    space = set < 0 ? H5I_INVALID_HID : H5Dget_space(set);
    int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
    if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space, size, NULL) < 0)
        TRY(fail(f, name, why));
    if (size[1] == 0) /* who reads rows looks for a number in them */
        TRY(status_fail(why, STATUS_INPUT, "%s: %s has rows of nothing", f->path, name));
    const hsize_t most = (hsize_t)(f->size < INT_MAX ? f->size : INT_MAX);
    if (size[0] > most || size[1] > most || size[0] * size[1] > most)
        TRY(status_fail(why, STATUS_INPUT, "%s: %s is larger than the file", f->path,
                        name));
    array = malloc((size_t)(size[0] * size[1] + 1) * sizeof *array);
    TRY(array ? STATUS_OK : STATUS_MEMORY);
    if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array) < 0)
        TRY(fail(f, name, why));
    *values = array, array = NULL;
    *rows = (int)size[0];
    *columns = (int)size[1];
out:
    free(array);
    drop(space);
    drop(set);
    return st;
}

/* One text of fixed length, as an attribute or, if long, a dataset: its type and room. */
static bool is_text(hid_t type, hid_t space, size_t *size)
{
    *size = type < 0 ? 0 : H5Tget_size(type);
    return type >= 0 && space >= 0 && H5Tget_class(type) == H5T_STRING &&
           H5Tis_variable_str(type) == 0 && H5Sget_simple_extent_npoints(space) == 1 &&
           *size <= TEXT_MOST;
}

enum status store_read_text(const struct store_read *f, const char *group, const char *key,
                            char **text, struct message *why)
{
    const bool short_one = H5Aexists_by_name(f->file, group, key, H5P_DEFAULT) > 0;
    hid_t object = H5I_INVALID_HID;
    size_t size;

    if (short_one)
        object = H5Aopen_by_name(f->file, group, key, H5P_DEFAULT, H5P_DEFAULT);
    else if (!strcmp(group, "/") && store_read_has(f, key))
        object = H5Dopen2(f->file, key, H5P_DEFAULT);
    hid_t type = object < 0  ? H5I_INVALID_HID
                 : short_one ? H5Aget_type(object)
                             : H5Dget_type(object);
    hid_t space = object < 0  ? H5I_INVALID_HID
                  : short_one ? H5Aget_space(object)
                              : H5Dget_space(object);
    bool good = is_text(type, space, &size);
    *text = good ? calloc(size + 1, 1) : NULL;
    if (*text)
        good =
            (short_one ? H5Aread(object, type, *text)
                       : H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, *text)) >= 0;
    drop(space);
    drop(type);
    drop(object);
    if (good)
        return *text ? STATUS_OK : STATUS_MEMORY;
    free(*text);
    *text = NULL;
    return status_fail(why, STATUS_INPUT, "%s: has no text %s", f->path, key);
}

enum status store_read_number(const struct store_read *f, const char *key, double *number,
                              struct message *why)
{
    hid_t attribute = H5Aopen(f->file, key, H5P_DEFAULT);
    hid_t space = attribute < 0 ? H5I_INVALID_HID : H5Aget_space(attribute);
    bool good = space >= 0 && H5Sget_simple_extent_npoints(space) == 1 &&
                H5Aread(attribute, H5T_NATIVE_DOUBLE, number) >= 0;

    drop(space);
    drop(attribute);
    return good ? STATUS_OK
                : status_fail(why, STATUS_INPUT, "%s: has no number %s", f->path, key);
}
