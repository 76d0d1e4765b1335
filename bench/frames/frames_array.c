#include "bench/frames/frames_array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "bench/files/hdf5_file.h"
#include "bench/frames/frames_file.h"

enum { RANK = 8 };

struct frames_array {
    char *path; /*                                               owned     */
    int rank;   /* of the array                                            */
    unsigned long long size[RANK];
    struct frames_file file; /* NumPy's: the array itself                               */
    zip_t *archive;          /* or NULL                                       owned     */
    zip_file_t *member;      /* the array in it, or NULL                      owned     */
    char type;               /* of its numbers: f, i (whole), u (without a sign), b      */
    int bytes;               /* of each                                                  */
    bool big, by_columns;    /* first byte highest; first index fastest (Fortran's order) */
    double *all;             /* all numbers in C's order; NULL: they are read on  owned */
    hid_t hdf5, set;         /* HDF5: the file, the array; negative: none     owned     */
    hsize_t row;             /* that is read next; of `all` the number                  */
};

/* Returns the product of the sizes; 1e15 where it is larger. */
static unsigned long long count_of(const struct frames_array *a)
{
    const unsigned long long most = 1000000000000000;
    unsigned long long count = 1;

    for (int n = 0; n < a->rank; n++)
        count = a->size[n] && count > most / a->size[n] ? most : count * a->size[n];
    return count;
}

static void end_array(struct frames_array *a)
{
    if (a->member)
        zip_fclose(a->member);
    if (a->set >= 0)
        H5Idec_ref(a->set);
    free(a->all);
    a->all = NULL;
    a->member = NULL;
    a->set = H5I_INVALID_HID;
    a->row = 0;
}

/* --- NumPy's: arrays of floats in a ZIP file, as numpy.savez writes them, or one bare
 * array (NPY, versions 1 to 3) --- */

static enum status open_zip(struct frames_array *a, struct message *why)
{
    zip_source_t *source;
    zip_error_t error;
    enum status st;

    zip_error_init(&error);
    source = zip_source_filep_create(a->file.file, 0, -1, &error);
    TRY(source ? STATUS_OK : STATUS_MEMORY);
    a->file.file = NULL; /* the source's */
    a->archive = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (!a->archive) {
        zip_source_free(source);
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: is cut off or no ZIP file (%s): a whole one, as numpy.savez "
                        "writes it, would be right",
                        a->path, zip_error_strerror(&error)));
    }
out:
    zip_error_fini(&error);
    return st;
}

/* Reads `size` bytes; false: the array ends before, or is damaged. */
static bool read_bytes(struct frames_array *a, void *bytes, size_t size)
{
    return a->member ? zip_fread(a->member, bytes, size) == (zip_int64_t)size
                     : frames_file_read(&a->file, bytes, size);
}

/* Finds an array, and how many bytes it has. */
static enum status find_member(struct frames_array *a, const char *name,
                               unsigned long long *size, struct message *why)
{
    struct zip_stat about;
    char member[64];

    *size = (unsigned long long)a->file.size;
    if (!a->archive) {
        frames_file_go(&a->file, 0, 1);
        return strcmp(name, "xyz") ? STATUS_UNSUPPORTED : STATUS_OK;
    }
    snprintf(member, sizeof member, "%s.npy", name);
    if (zip_stat(a->archive, member, 0, &about))
        return STATUS_UNSUPPORTED;
    *size = about.size;
    a->member = zip_fopen(a->archive, member, 0);
    if (!a->member)
        return status_fail(why, STATUS_INPUT, "%s: %s: cannot be unpacked: %s", a->path,
                           member, zip_strerror(a->archive));
    if (about.size / 1040 > about.comp_size) /* deflate packs a thousandfold at most */
        return status_fail(why, STATUS_INPUT, "%s: %s: announces an impossible size",
                           a->path, member);
    return STATUS_OK;
}

/* Reads the text of 'shape', such as (3, 4, 5). */
static bool take_shape(const char *text, struct frames_array *a)
{
    char *p = strstr(text, "'shape':");
    double x;

    p = p ? strchr(p, '(') : NULL;
    if (!p)
        return false;
    for (p++, a->rank = 0; *p != ')'; a->rank++) {
        if (a->rank == 5 || !frames_file_number(&p, &x) || !(x >= 0 && x <= 1e15))
            return false;
        a->size[a->rank] = (unsigned long long)x;
        p += strspn(p, " ,");
    }
    return true;
}

/* Reads the text of 'descr', such as '<f8', and of 'fortran_order'. */
static bool take_type(const char *text, struct frames_array *a)
{
    const char *p = strstr(text, "'descr':");
    char order, end;

    a->by_columns = strstr(text, "'fortran_order': True");
    p = p ? strchr(p + 8, '\'') : NULL;
    if (!p || sscanf(p, "'%c%c%1d%c", &order, &a->type, &a->bytes, &end) != 4)
        return false;
    a->big = order == '>';
    return end == '\'' && strchr("<>|=", order) && strchr("fiub", a->type) &&
           (a->bytes == 8 || a->bytes == 4 || a->bytes == 2 ||
            (a->bytes == 1 && a->type != 'f'));
}

/* Reads all of an array whose first index is fastest, so that it can be had by rows. */
static enum status turn_numpy(struct frames_array *a, const char *name,
                              struct message *why);

/* Reads the header of an array of numbers, of which there are as many as its shape says. */
static enum status begin_numpy(struct frames_array *a, const char *name,
                               struct message *why)
{
    unsigned char start[12];
    char text[4097];
    unsigned long long size;
    enum status st = STATUS_OK;

    CALL(find_member(a, name, &size, why));
    if (!read_bytes(a, start, 10) || memcmp(start, "\x93NUMPY", 6) != 0 ||
        (start[6] > 1 && !read_bytes(a, start + 10, 2)))
        return status_fail(why, STATUS_INPUT, "%s: %s.npy: is no array of NumPy's", a->path,
                           name);
    const size_t head = frames_file_whole(start + 8, start[6] > 1 ? 4 : 2, false);
    if (head >= sizeof text || !read_bytes(a, text, head))
        return status_fail(why, STATUS_INPUT, "%s: %s.npy: its header is damaged", a->path,
                           name);
    text[head] = '\0';
    if (!take_type(text, a) || !take_shape(text, a))
        return status_fail(why, STATUS_INPUT,
                           "%s: %s.npy: is %.100s; floats of 16, 32 or 64 bits or whole "
                           "numbers (x.astype('<f8')) would be right",
                           a->path, name, text);
    if (size < 10 + head || count_of(a) > (size - 10 - head) / (unsigned)a->bytes)
        return status_fail(
            why, STATUS_INPUT,
            "%s: %s.npy: is cut off: its shape needs more numbers than there are", a->path,
            name);
    if (a->by_columns && a->rank > 1)
        st = turn_numpy(a, name, why);
    return st;
}

static double number_of(const struct frames_array *a, const unsigned char *p)
{
    const double size = (double)frames_file_whole(p, a->bytes, a->big);

    if (a->type == 'f')
        return frames_file_float(p, a->bytes, a->big);
    return a->type == 'i' && p[a->big ? 0 : a->bytes - 1] >> 7
               ? size - ldexp(1, 8 * a->bytes)
               : size;
}

static bool read_numpy(struct frames_array *a, size_t count, double *values)
{
    const size_t bytes = (size_t)a->bytes;

    if (a->all) {
        memcpy(values, a->all + a->row, count * sizeof *values);
        a->row += count;
        return true;
    }
    /* The bytes go to the array's end, so that widening from its front does not
     * overtake. */
    unsigned char *at = (unsigned char *)values + count * (8 - bytes);

    if (!read_bytes(a, at, count * bytes))
        return false;
    for (size_t n = 0; n < count; n++)
        values[n] = number_of(a, at + n * bytes);
    return true;
}

static enum status turn_numpy(struct frames_array *a, const char *name, struct message *why)
{
    const size_t count = (size_t)count_of(a);
    double *by_rows SCOPED(scope_free) = malloc((count + 1) * sizeof *by_rows);
    double *by_columns SCOPED(scope_free) = malloc((count + 1) * sizeof *by_columns);

    CALL(by_columns && by_rows ? STATUS_OK : STATUS_MEMORY);
    if (!read_numpy(a, count, by_columns))
        return status_fail(why, STATUS_INPUT, "%s: %s.npy: is cut off or damaged", a->path,
                           name);
    for (size_t n = 0; n < count; n++) { /* n counts by rows, `at` by columns */
        size_t left = n, step = count, at = 0;
        for (int k = a->rank - 1; k >= 0; k--) {
            step /= a->size[k];
            at += left % a->size[k] * step;
            left /= a->size[k];
        }
        by_rows[n] = by_columns[at];
    }
    a->all = by_rows, by_rows = NULL;
    return STATUS_OK;
}

/* --- HDF5 --- */

static enum status begin_hdf5(struct frames_array *a, const char *name, struct message *why)
{
    hsize_t size[HDF5_FILE_RANK] = {0};

    if (H5Lexists(a->hdf5, name, H5P_DEFAULT) <= 0)
        return STATUS_UNSUPPORTED;
    a->set = hdf5_file_open_set(a->hdf5, name, &a->rank, size);
    if (a->rank < 1 || a->rank > RANK)
        return hdf5_file_refuse_set(a->path, name, why);
    for (int n = 0; n < RANK; n++)
        a->size[n] = size[n];
    return STATUS_OK;
}

static bool read_hdf5(struct frames_array *a, size_t count, double *values)
{
    hsize_t start[RANK] = {a->row}, size[RANK], all = count, row = 1;

    for (int n = 1; n < a->rank; n++) {
        size[n] = a->size[n];
        row *= a->size[n];
    }
    size[0] = count / row;
    a->row += size[0];
    const hid_t memory = H5Screate_simple(1, &all, NULL), space = H5Dget_space(a->set);
    const bool good =
        H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, size, NULL) >= 0 &&
        H5Dread(a->set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values) >= 0;
    if (space >= 0)
        H5Idec_ref(space);
    if (memory >= 0)
        H5Idec_ref(memory);
    return good;
}

/* --- either --- */

enum status frames_array_open(const char *path, struct frames_array **file,
                              struct message *why)
{
    const char *ending = strrchr(path, '.');
    const bool zip = ending && !strcmp(ending, ".npz"),
               bare = ending && !strcmp(ending, ".npy");
    struct frames_array *a SCOPED(frames_array_close_scope) = calloc(1, sizeof *a);

    if (!a)
        return STATUS_MEMORY;
    a->hdf5 = a->set = H5I_INVALID_HID;
    a->path = strdup(path);
    CALL(a->path ? STATUS_OK : STATUS_MEMORY);
    if (zip || bare) {
        CALL(frames_file_open(path, &a->file, why));
        CALL(zip ? open_zip(a, why) : STATUS_OK);
    } else {
        a->hdf5 = hdf5_file_open(path, why);
        CALL(a->hdf5 < 0 ? STATUS_FILE : STATUS_OK);
    }
    *file = a, a = NULL;
    return STATUS_OK;
}

void frames_array_close(struct frames_array *a)
{
    if (!a)
        return;
    end_array(a);
    if (a->archive)
        zip_discard(a->archive);
    if (a->hdf5 >= 0)
        H5Fclose(a->hdf5);
    frames_file_close(&a->file);
    free(a->path);
    free(a);
}

enum status frames_array_begin(struct frames_array *a, const char *name,
                               unsigned long long size[8], struct message *why)
{
    end_array(a);
    memset(a->size, 0, sizeof a->size);
    const enum status st =
        a->hdf5 < 0 ? begin_numpy(a, name, why) : begin_hdf5(a, name, why);
    memcpy(size, a->size, sizeof a->size);
    if (st == STATUS_UNSUPPORTED)
        status_fail(why, st, "%s: has no array %s", a->path, name);
    return st;
}

bool frames_array_read(struct frames_array *a, size_t count, double *values)
{
    return a->hdf5 < 0 ? read_numpy(a, count, values) : read_hdf5(a, count, values);
}

enum status frames_array_load(struct frames_array *a, const char *name, size_t rows,
                              size_t columns, double **values, struct message *why)
{
    const size_t count = rows * columns;
    unsigned long long size[RANK];
    double *numbers SCOPED(scope_free) = NULL;

    CALL(frames_array_begin(a, name, size, why));
    if (count_of(a) != count || (columns > 1 && size[a->rank - 1] != columns))
        return status_fail(why, STATUS_INPUT,
                           "%s: %s: has %llu numbers; %zu, %zu rows of %zu, would be right",
                           a->path, name, count_of(a), count, rows, columns);
    numbers = malloc(count * sizeof *numbers);
    CALL(numbers ? STATUS_OK : STATUS_MEMORY);
    if (!frames_array_read(a, count, numbers))
        return status_fail(why, STATUS_INPUT, "%s: %s: is cut off or damaged", a->path,
                           name);
    *values = numbers, numbers = NULL;
    return STATUS_OK;
}
