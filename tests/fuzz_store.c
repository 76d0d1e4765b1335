/* Result files and truths from any contents, for libFuzzer or from files (fuzz.h).
 *
 * The input stands for what an HDF5 file has, a line each, and the library is played below:
 * it says of types, ranks, sizes and values what the line has, or fails. So our readers
 * meet what a file may hold and not the library's own faults, from which the seal keeps
 * them:
 *
 *     run                          or run+fields, or truth, or seal and any bytes, or
 *                                  frames: an HDF5 file of somebody else's
 *     @outcome s - done            an attribute: a text of fixed length
 *     time d 3 0 0.1 0.2           three doubles; fewer values are repeated
 *     xyz d 1,2,100,100,3 0        kinds: d double, s text, v text of any length, x
 * unreadable
 *     @scene s - name: a|...       | is a line break
 *
 * Beyond crashes, leaks and undefined behaviour it stops at: a refusal without a printable
 * sentence that names the file; a result that holds less than it says. */
#define _GNU_SOURCE /* memfd_create */
#include <hdf5.h>
#include <math.h>
#include <sys/mman.h>
#include <unistd.h>

#include "bench/files/seal.h"
#include "bench/frames/frames.h"
#include "bench/frames/frames_bytes.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"
#include "tests/fuzz.h"

enum { ITEMS = 64, VALUES = 16, RANK = 5, MEMORY_SPACE = 1 << 20 };

struct item {
    bool attribute;
    char kind, *name, *text;
    int rank, value_count;
    hsize_t size[RANK];
    double value[VALUES];
    size_t storage;
};
static struct item items[ITEMS];
static int item_count;
static long file_size;
static hsize_t memory_points; /* of the space that was made last */

/* --- the input -------------------------------------------------------------------------
 */

static char *take_word(char **at)
{
    char *word = *at;
    const size_t length = strcspn(word, " ");

    *at = word + length + (word[length] == ' ');
    word[length] = '\0';
    return word;
}

static void take_sizes(const char *sizes, struct item *item)
{
    char *end;

    for (item->rank = 0; item->rank < RANK; item->rank++, sizes = end + (*end == ',')) {
        item->size[item->rank] = strtoull(sizes, &end, 10);
        if (end == sizes)
            break;
    }
}

static void take_item(char *line)
{
    struct item *item = &items[item_count++];
    char *at = line, *end;

    *item = (struct item){.attribute = *line == '@', .storage = 8 * strlen(line)};
    at += item->attribute;
    item->name = take_word(&at);
    item->kind = *take_word(&at);
    take_sizes(take_word(&at), item);
    item->text = at;
    for (double x; item->value_count < VALUES && (x = strtod(at, &end), end != at);
         at = end)
        item->value[item->value_count++] = x;
    for (char *c = item->text; item->kind == 's' && *c; c++)
        *c = *c == '|' ? '\n' : *c;
}

static void take_items(char *text)
{
    item_count = 0;
    for (char *line = text, *end; line && *line && item_count < ITEMS; line = end) {
        end = strchr(line, '\n');
        if (end)
            *end++ = '\0';
        take_item(line);
    }
}

/* --- the library: objects are 4, 8, ..., their types and spaces one and two more -------
 */

static struct item *of(hid_t id)
{
    MUST(id >= 4 && id / 4 <= item_count);
    return &items[id / 4 - 1];
}

static hid_t find(const char *name, bool attribute)
{
    for (int n = 0; n < item_count; n++)
        if (items[n].attribute == attribute && !strcmp(items[n].name, name))
            return 4 * (n + 1);
    return H5I_INVALID_HID;
}

/* A group, as a beginning of names. */
static bool is_group(const char *name)
{
    for (int n = 0; n < item_count; n++)
        if (!items[n].attribute && !strncmp(items[n].name, name, strlen(name)) &&
            items[n].name[strlen(name)] == '/')
            return true;
    return false;
}

static hssize_t points(const struct item *item)
{
    hssize_t product = 1;

    for (int n = 0; n < item->rank; n++)
        product = (hssize_t)((hsize_t)product * item->size[n]);
    return product;
}

/* As texts, if the type is its own, else as doubles: the library makes none from a text. */
static herr_t fill(hid_t id, hid_t type, hsize_t count, void *to)
{
    const struct item *item = of(id);

    if (item->kind == 's' && type == id + 1) {
        for (hsize_t n = 0; n < count; n++)
            memcpy((char *)to + n * strlen(item->text), item->text, strlen(item->text));
        return 0;
    }
    if (item->kind != 'd')
        return -1;
    for (hsize_t n = 0; n < count; n++)
        ((double *)to)[n] = item->value_count ? item->value[n % item->value_count] : 0;
    return 0;
}

#define PLAYED(result, name, arguments)                                                    \
    result __wrap_##name arguments;                                                        \
    result __wrap_##name arguments

PLAYED(void, hdf5_file_start, (void))
{
}

PLAYED(enum status, seal_check, (const char *path, long *size, struct message *why))
{
    (void)path, (void)why;
    *size = file_size;
    return STATUS_OK;
}

/* Only its beginning is looked at: HDF5's own mark. */
PLAYED(enum status, frames_bytes_open,
       (const char *path, struct frames_bytes *b, struct message *why))
{
    (void)path, (void)why;
    *b = (struct frames_bytes){.byte = (const unsigned char *)"\x89HDF\r\n\x1a\n",
                               .size = 9};
    return STATUS_OK;
}

PLAYED(void, frames_bytes_close, (struct frames_bytes * b))
{
    *b = (struct frames_bytes){0};
}

PLAYED(hid_t, H5Fopen, (const char *name, unsigned flags, hid_t access))
{
    (void)name, (void)flags, (void)access;
    return 1;
}

PLAYED(herr_t, H5Fclose, (hid_t id))
{
    MUST(id == 1);
    return 0;
}

PLAYED(int, H5Idec_ref, (hid_t id))
{
    if (id != MEMORY_SPACE)
        of(id);
    return 0;
}

PLAYED(herr_t, H5Sclose, (hid_t id))
{
    (void)id;
    return 0;
}

PLAYED(htri_t, H5Lexists, (hid_t file, const char *name, hid_t access))
{
    (void)file, (void)access;
    return find(name, false) >= 0 || is_group(name);
}

PLAYED(hid_t, H5Dopen2, (hid_t file, const char *name, hid_t access))
{
    (void)file, (void)access;
    return find(name, false);
}

PLAYED(htri_t, H5Aexists_by_name,
       (hid_t file, const char *group, const char *name, hid_t access))
{
    (void)file, (void)group, (void)access;
    return find(name, true) >= 0;
}

PLAYED(hid_t, H5Aopen_by_name,
       (hid_t file, const char *group, const char *name, hid_t access, hid_t links))
{
    (void)file, (void)group, (void)access, (void)links;
    return find(name, true);
}

PLAYED(hid_t, H5Aopen, (hid_t file, const char *name, hid_t access))
{
    (void)file, (void)access;
    return find(name, true);
}

PLAYED(hid_t, H5Dget_type, (hid_t id))
{
    return id + 1;
}

PLAYED(hid_t, H5Aget_type, (hid_t id))
{
    return id + 1;
}

PLAYED(hid_t, H5Dget_space, (hid_t id))
{
    return id + 2;
}

PLAYED(hid_t, H5Aget_space, (hid_t id))
{
    return id + 2;
}

PLAYED(hsize_t, H5Dget_storage_size, (hid_t id))
{
    return of(id)->storage;
}

PLAYED(H5T_class_t, H5Tget_class, (hid_t id))
{
    return of(id)->kind == 'd' ? H5T_FLOAT : H5T_STRING;
}

PLAYED(htri_t, H5Tis_variable_str, (hid_t id))
{
    return of(id)->kind == 'v';
}

PLAYED(size_t, H5Tget_size, (hid_t id))
{
    return of(id)->kind == 's' ? strlen(of(id)->text) : 8;
}

PLAYED(int, H5Sget_simple_extent_ndims, (hid_t id))
{
    return of(id)->rank;
}

PLAYED(int, H5Sget_simple_extent_dims, (hid_t id, hsize_t *size, hsize_t *most))
{
    MUST(!most);
    memcpy(size, of(id)->size, (size_t)of(id)->rank * sizeof *size);
    return of(id)->rank;
}

PLAYED(hssize_t, H5Sget_simple_extent_npoints, (hid_t id))
{
    return points(of(id));
}

PLAYED(hid_t, H5Screate_simple, (int rank, const hsize_t *size, const hsize_t *most))
{
    (void)most;
    memory_points = 1;
    for (int n = 0; n < rank; n++)
        memory_points *= size[n];
    return MEMORY_SPACE;
}

PLAYED(herr_t, H5Sselect_hyperslab,
       (hid_t id, H5S_seloper_t how, const hsize_t *start, const hsize_t *stride,
        const hsize_t *count, const hsize_t *block))
{
    (void)how, (void)stride, (void)count, (void)block;
    return *start < *of(id)->size ? 0 : -1;
}

PLAYED(herr_t, H5Dread,
       (hid_t id, hid_t type, hid_t memory, hid_t space, hid_t access, void *to))
{
    const struct item *item = of(id);
    hsize_t count = 1; /* sizes whose product wraps are more than any memory has */

    (void)space, (void)access;
    for (int n = 0; n < item->rank; n++)
        count = item->size[n] && count > UINT64_MAX / item->size[n] ? UINT64_MAX
                                                                    : count * item->size[n];
    return fill(id, type, memory == MEMORY_SPACE ? memory_points : count, to);
}

PLAYED(herr_t, H5Aread, (hid_t id, hid_t type, void *to))
{
    return fill(id, type, (hsize_t)points(of(id)), to);
}

/* --- the target ------------------------------------------------------------------------
 */

static void check_run(bool fields)
{
    struct run_result r = {0};
    struct message why = {""};

    if (run_result_read("fuzz", fields, &r, &why) != STATUS_OK) {
        fuzz_check_sentence(&why, strncmp(why.text, "--set ", 6) ? "fuzz" : "--set ");
    } else {
        double sum = 0;
        for (int n = 0; n < r.frames; n++)
            sum += r.time[n] + (fields ? r.xyz[n][59999] : 0);
        MUST(sum == sum || sum != sum); /* they are there */
        MUST(fuzz_is_line(r.sentence.text));
    }
    run_result_clear(&r);
}

static void check_truth(void)
{
    struct truth made;
    struct message why = {""};
    char *physics = NULL;

    if (truth_file_read("fuzz", &made, &physics, &why) != STATUS_OK)
        fuzz_check_sentence(&why, "fuzz: ");
    else
        truth_clear(&made);
    free(physics);
}

/* Frames are as many as the input says, and all the same: a few are read. */
static void check_frames(void)
{
    static const char *const path = "fuzz.h5";
    struct frames *f = NULL;
    struct message why = {""};
    const double *xyz = NULL;
    double t, before = -INFINITY;
    enum status st = frames_open(1, &path, &(struct frames_look){0}, &f, &why);

    for (int n = 0; st == STATUS_OK && n < 5; n++) {
        const struct frames_net *net = frames_net(f);
        for (int k = 0; net->uv && k < 2 * net->vertices; k++)
            MUST(isfinite(net->uv[k]));
        st = frames_next(f, &t, &xyz, &why);
        if (st != STATUS_OK || !xyz)
            break;
        MUST(t > before && isfinite(t));
        before = t;
        for (int k = 0; k < 3 * net->vertices; k++)
            MUST(isfinite(xyz[k]));
    }
    if (st != STATUS_OK)
        fuzz_check_sentence(&why, path);
    frames_close(f);
}

enum status __real_seal_check(const char *path, long *size, struct message *why);

static void check_seal(const char *bytes, size_t size)
{
    static int file = -1;
    static char path[64];
    struct message why = {""};
    long sealed;

    if (file < 0)
        file = memfd_create("fuzz", 0);
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    MUST(file >= 0 && ftruncate(file, 0) == 0);
    MUST(pwrite(file, bytes, size, 0) == (ssize_t)size);
    if (__real_seal_check(path, &sealed, &why) != STATUS_OK)
        fuzz_check_sentence(&why, path);
    else
        MUST(sealed == (long)size);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *copy = malloc(size + 1), *text = copy, *what;

    MUST(copy);
    if (size)
        memcpy(copy, data, size);
    copy[size] = '\0';
    what = strsep(&text, "\n");
    file_size = 8 * (long)size;
    if (text && !strcmp(what, "seal"))
        check_seal(text, (size_t)(copy + size - text));
    else if (text && !strncmp(what, "run", 3))
        take_items(text), check_run(!strcmp(what, "run+fields"));
    else if (text && !strcmp(what, "truth"))
        take_items(text), check_truth();
    else if (text && !strcmp(what, "frames"))
        take_items(text), check_frames();
    free(copy);
    return 0;
}
