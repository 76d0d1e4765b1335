#include "bench/files/hdf5_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "models/reader/input_file.h"

/* The reason of the last failure. It is stored at once: the library forgets its error stack
 * when the next call begins. */
static char last_reason[256];

/* Takes the operating system's reason from the stack, else the innermost sentence. */
static herr_t find_reason(unsigned n, const H5E_error2_t *error, void *unused)
{
    static const char mark[] = "error message = '";
    const char *word = error->desc ? strstr(error->desc, mark) : NULL;

    (void)unused;
    if (word) {
        word += strlen(mark);
        snprintf(last_reason, sizeof last_reason, "%.*s", (int)strcspn(word, "'"), word);
    } else if (n == 0 && error->desc) {
        snprintf(last_reason, sizeof last_reason, "%s", error->desc);
    }
    return word != NULL;
}

static herr_t keep_reason(hid_t stack, void *unused)
{
    return H5Ewalk2(stack, H5E_WALK_UPWARD, find_reason, unused) < 0 ? -1 : 0;
}

void hdf5_file_start(void)
{
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, keep_reason, NULL);
}

enum status hdf5_file_fail(const char *path, const char *doing, struct message *why)
{
    status_fail(why, STATUS_FILE, "%s: %s: %s", path, doing,
                last_reason[0] ? last_reason : "the HDF5 library gives no reason");
    last_reason[0] = '\0';
    return STATUS_FILE;
}

/* Writes an attribute, or a dataset: attributes end at 64 kB. */
static herr_t put_scalar(hid_t object, const char *key, hid_t type, size_t size,
                         const void *value)
{
    enum { ATTRIBUTE_MOST = 60000 };
    const bool set = size > ATTRIBUTE_MOST;
    hid_t space = H5Screate(H5S_SCALAR);
    hid_t made =
        set ? H5Dcreate2(object, key, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)
            : H5Acreate2(object, key, type, space, H5P_DEFAULT, H5P_DEFAULT);
    herr_t result = made < 0 ? -1
                    : set    ? H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value)
                             : H5Awrite(made, type, value);

    if (made >= 0 && (set ? H5Dclose(made) : H5Aclose(made)) < 0)
        result = -1;
    H5Sclose(space);
    return result;
}

herr_t hdf5_file_put_text(hid_t object, const char *key, const char *text)
{
    const size_t length = strlen(text);
    hid_t type = H5Tcopy(H5T_C_S1);

    /* Fixed length: the library crashes on damaged texts of variable length. */
    H5Tset_size(type, length ? length : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    herr_t result = put_scalar(object, key, type, length, text);
    H5Tclose(type);
    return result;
}

herr_t hdf5_file_put_long(hid_t object, const char *key, long value)
{
    return put_scalar(object, key, H5T_NATIVE_LONG, sizeof value, &value);
}

herr_t hdf5_file_put_double(hid_t object, const char *key, double value)
{
    return put_scalar(object, key, H5T_NATIVE_DOUBLE, sizeof value, &value);
}

herr_t hdf5_file_put_meaning(hid_t set, struct hdf5_file_meaning meaning)
{
    return hdf5_file_put_text(set, "unit", meaning.unit) < 0
               ? -1
               : hdf5_file_put_text(set, "axes", meaning.axes);
}

static herr_t put_array(hid_t file, const char *name, struct hdf5_file_meaning meaning,
                        hid_t type, const void *values, int rows, int columns)
{
    hsize_t size[2] = {(hsize_t)rows, (hsize_t)columns};
    hid_t space = H5Screate_simple(columns ? 2 : 1, size, NULL);
    hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    hid_t set = H5Dcreate2(file, name, type, space, links, H5P_DEFAULT, H5P_DEFAULT);
    herr_t result = set < 0 ? -1 : hdf5_file_put_meaning(set, meaning);

    if (result >= 0 && rows > 0)
        result = H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    if (set >= 0 && H5Dclose(set) < 0)
        result = -1;
    H5Pclose(links);
    H5Sclose(space);
    return result;
}

herr_t hdf5_file_put_array(hid_t file, const char *name, struct hdf5_file_meaning meaning,
                           const double *values, int rows, int columns)
{
    return put_array(file, name, meaning, H5T_NATIVE_DOUBLE, values, rows, columns);
}

herr_t hdf5_file_put_whole(hid_t file, const char *name, struct hdf5_file_meaning meaning,
                           const int *values, int rows, int columns)
{
    return put_array(file, name, meaning, H5T_NATIVE_INT, values, rows, columns);
}

void hdf5_file_drop(hid_t id)
{
    if (id >= 0)
        H5Idec_ref(id);
}

hid_t hdf5_file_open(const char *path, struct message *why)
{
    const char *reason;
    FILE *probe = input_file_open(path, &reason);
    hid_t file = H5I_INVALID_HID;

    hdf5_file_start();
    if (!probe) {
        status_fail(why, STATUS_FILE, "%s: cannot be read: %s", path, reason);
        return file;
    }
    fclose(probe);
    file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0)
        hdf5_file_fail(path, "cannot be read", why);
    return file;
}

/* Returns whether each part of a name, a/b/c, is in the file itself: other links may lead
 * into any file. */
static bool is_inside(hid_t file, const char *name)
{
    char part[256];
    H5L_info_t link;

    if (strlen(name) >= sizeof part)
        return false;
    strcpy(part, name);
    for (char *end = part; end; *end++ = '/') {
        end = strchr(end, '/');
        if (end)
            *end = '\0';
        if (H5Lexists(file, part, H5P_DEFAULT) <= 0 ||
            H5Lget_info(file, part, &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD)
            return false;
        if (!end)
            break;
    }
    return true;
}

/* Returns whether pieces are not much more than an entry, and all are there. */
static bool has_pieces(hid_t set, hid_t space, hid_t list, int rank, const hsize_t *size)
{
    static const double MOST = 1 << 20;      /* numbers of a piece */
    double entry = 1, piece = 1, pieces = 1; /* products of any sizes */
    hsize_t chunk[HDF5_FILE_RANK], there = 0;

    if (H5Pget_chunk(list, HDF5_FILE_RANK, chunk) != rank)
        return false;
    for (int n = 0; n < rank; n++) {
        entry *= n ? (double)size[n] : 1;
        piece *= (double)chunk[n];
        pieces *= ceil((double)size[n] / (double)chunk[n]);
    }
    return (piece <= entry || piece <= MOST) &&
           H5Dget_num_chunks(set, space, &there) >= 0 && (double)there == pieces;
}

/* Returns whether a dataset's numbers stand in its own file, all of them. What was never
 * written is read as zeros. */
static bool is_whole(hid_t set, hid_t space, int rank, const hsize_t *size)
{
    const hid_t list = H5Dget_create_plist(set);
    const H5D_layout_t layout = H5Pget_layout(list);
    H5D_space_status_t written = H5D_SPACE_STATUS_ALLOCATED;
    bool good = H5Pget_external_count(list) == 0, some = true;

    for (int n = 0; n < rank; n++)
        some = some && size[n];
    if (layout == H5D_CHUNKED)
        good = good && has_pieces(set, space, list, rank, size);
    else if (layout == H5D_CONTIGUOUS && some)
        good = good && H5Dget_space_status(set, &written) >= 0;
    else
        good = good && (layout == H5D_COMPACT || layout == H5D_CONTIGUOUS);
    hdf5_file_drop(list);
    return good && written == H5D_SPACE_STATUS_ALLOCATED;
}

hid_t hdf5_file_open_set(hid_t file, const char *name, int *rank,
                         hsize_t size[HDF5_FILE_RANK])
{
    hid_t set = is_inside(file, name) ? H5Dopen2(file, name, H5P_DEFAULT) : H5I_INVALID_HID;
    hid_t space = H5Dget_space(set);

    *rank = H5Sget_simple_extent_ndims(space);
    if (*rank < 0 || *rank > HDF5_FILE_RANK ||
        H5Sget_simple_extent_dims(space, size, NULL) < 0 ||
        !is_whole(set, space, *rank, size)) {
        hdf5_file_drop(set);
        set = H5I_INVALID_HID;
        *rank = 0;
    }
    hdf5_file_drop(space);
    return set;
}

enum status hdf5_file_refuse_set(const char *path, const char *name, struct message *why)
{
    return status_fail(
        why, STATUS_INPUT,
        "%s: %s: is no array that can be read: its numbers must stand in this "
        "file, all of them, in one piece or in pieces of a frame",
        path, name);
}

/* Selects entry n in the dataset's space, and makes the space of that entry in memory. */
static bool select_entry(hid_t set, int n, hid_t *space, hid_t *memory)
{
    hsize_t start[HDF5_FILE_RANK] = {(hsize_t)n}, count[HDF5_FILE_RANK];

    *space = H5Dget_space(set);
    const int rank = H5Sget_simple_extent_dims(*space, count, NULL);
    count[0] = 1;
    *memory = H5Screate_simple(rank, count, NULL);
    return H5Sselect_hyperslab(*space, H5S_SELECT_SET, start, NULL, count, NULL) >= 0;
}

bool hdf5_file_read_entry(hid_t set, int n, double *values)
{
    hid_t space, memory;
    const bool good =
        select_entry(set, n, &space, &memory) &&
        H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values) >= 0;

    hdf5_file_drop(space);
    hdf5_file_drop(memory);
    return good;
}

bool hdf5_file_write_entry(hid_t set, int n, const double *values)
{
    hid_t space, memory;
    const bool good =
        select_entry(set, n, &space, &memory) &&
        H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values) >= 0;

    hdf5_file_drop(space);
    hdf5_file_drop(memory);
    return good;
}
