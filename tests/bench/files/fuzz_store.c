/* Result files and truths from any contents, for libFuzzer or from files (fuzz.h).
 *
 * The input stands for what an HDF5 file has, a line each, and a file in memory is made of
 * it: so our readers meet what a file may hold and not the library's own faults, from which
 * the seal keeps them:
 *
 *     run                          or run+fields, or truth, or frames: an HDF5 file of
 *                                  somebody else's
 *     @outcome s - done            an attribute: a text of fixed length
 *     time d 3 0 0.1 0.2           three doubles; fewer values are repeated
 *     xyz d 1,2,100,100,3 0        kinds: d double, s text, v text of any length, x bytes
 *     @scene s - name: a|...       | is a line break
 *
 * Input of which the library makes no file is left out. Beyond crashes, leaks (of what is
 * open in a file, too) and undefined behaviour it stops at: a refusal without a printable
 * sentence that names the file; a result that holds less than it says. */
#define _GNU_SOURCE /* strsep */
#include <hdf5.h>
#include <math.h>

#include "bench/files/hdf5_file.h"
#include "bench/frames/frames.h"
#include "bench/frames/frames_file.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"
#include "tests/fuzz.h"

enum { VALUES = 16, RANK = 5, WRITTEN = 1 << 17 /* values; what is more is not there */ };

static hid_t played; /* the file in memory */
static long file_size;

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

/* Returns H5I_INVALID_HID for what no space has. *count: its values, at most WRITTEN + 1.
 */
static hid_t take_space(const char *sizes, hid_t create, hsize_t *count)
{
    hsize_t size[RANK], chunk[RANK] = {1, 1, 1, 1, 1};
    char *end;
    int rank = 0;

    for (*count = 1; rank < RANK; rank++, sizes = end + (*end == ',')) {
        size[rank] = strtoull(sizes, &end, 10);
        if (end == sizes)
            break;
        *count = size[rank] > WRITTEN ? WRITTEN + 1 : *count * size[rank];
        *count = *count > WRITTEN ? WRITTEN + 1 : *count;
    }
    if (rank && *count > WRITTEN)
        H5Pset_chunk(create, rank, chunk);
    return rank ? H5Screate_simple(rank, size, NULL) : H5Screate(H5S_SCALAR);
}

/* Texts, or doubles; as many as the space has. */
static void *take_values(char kind, char *text, hsize_t count)
{
    double value[VALUES] = {0};
    const size_t length = strlen(text);
    size_t values = 0;
    char *end, *bytes = malloc((size_t)count * (length + 8) + 8);

    MUST(bytes);
    for (const char *at = text; values < VALUES; at = end) {
        value[values] = strtod(at, &end);
        if (end == at)
            break;
        values++;
    }
    for (hsize_t n = 0; n < count; n++)
        if (kind == 'd')
            ((double *)(void *)bytes)[n] = value[values ? n % values : 0];
        else if (kind == 'v')
            ((char **)(void *)bytes)[n] = text;
        else
            memcpy(bytes + n * length, text, length);
    return bytes;
}

static void put_item(char *line)
{
    const bool attribute = *line == '@';
    char *at = line + attribute, *name = take_word(&at);
    const char kind = *take_word(&at);
    const hid_t create = H5Pcreate(H5P_DATASET_CREATE), groups = H5Pcreate(H5P_LINK_CREATE);
    hsize_t count;
    const hid_t space = take_space(take_word(&at), create, &count);
    const hid_t type = H5Tcopy(kind == 'd'   ? H5T_NATIVE_DOUBLE
                               : kind == 'x' ? H5T_NATIVE_OPAQUE
                                             : H5T_C_S1);

    for (char *c = at; kind == 's' && *c; c++)
        *c = *c == '|' ? '\n' : *c;
    if (kind != 'd')
        H5Tset_size(type, kind == 'v' ? H5T_VARIABLE : strlen(at) ? strlen(at) : 1);
    H5Pset_create_intermediate_group(groups, 1);
    if (space >= 0 && attribute && count <= WRITTEN) {
        void *values = take_values(kind, at, count);
        hid_t made = H5Acreate2(played, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
        if (made >= 0)
            H5Awrite(made, type, values), H5Aclose(made);
        free(values);
    } else if (space >= 0 && !attribute) {
        hid_t made = H5Dcreate2(played, name, type, space, groups, create, H5P_DEFAULT);
        if (made >= 0 && count <= WRITTEN) {
            void *values = take_values(kind, at, count);
            H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
            free(values);
        }
        if (made >= 0)
            H5Dclose(made);
    }
    if (space >= 0)
        H5Sclose(space);
    H5Tclose(type);
    H5Pclose(groups);
    H5Pclose(create);
}

static void play(char *text)
{
    const hid_t memory = H5Pcreate(H5P_FILE_ACCESS);

    hdf5_file_start();
    MUST(H5Pset_fapl_core(memory, 1 << 16, false) >= 0);
    played = H5Fcreate("fuzz", H5F_ACC_TRUNC, H5P_DEFAULT, memory);
    MUST(played >= 0);
    H5Pclose(memory);
    for (char *line; (line = strsep(&text, "\n"));)
        put_item(line);
}

static void end_play(void)
{
    MUST(H5Fget_obj_count(played, H5F_OBJ_ALL) == 1);
    H5Fclose(played);
}

/* --- what the linker sends here (CMakeLists.txt) ---------------------------------------
 */

#define PLAYED(result, name, arguments)                                                    \
    result __wrap_##name arguments;                                                        \
    result __wrap_##name arguments

PLAYED(hid_t, H5Fopen, (const char *name, unsigned flags, hid_t access))
{
    (void)name, (void)flags, (void)access;
    return H5Freopen(played);
}

PLAYED(enum status, seal_check, (const char *path, long *size, struct message *why))
{
    (void)path, (void)why;
    *size = file_size;
    return STATUS_OK;
}

/* Only its beginning is looked at: HDF5's own mark. */
PLAYED(enum status, frames_file_open,
       (const char *path, struct frames_file *f, struct message *why))
{
    static char signature[] = "\x89HDF\r\n\x1a\n";

    (void)path, (void)why;
    *f = (struct frames_file){.file = fmemopen(signature, 8, "r")};
    MUST(f->file);
    return STATUS_OK;
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

    if (truth_file_read("fuzz", &made, &why) != STATUS_OK)
        fuzz_check_sentence(&why, "fuzz: ");
    else
        truth_clear(&made);
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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *copy = malloc(size + 1), *text = copy, *what;

    MUST(copy);
    if (size)
        memcpy(copy, data, size);
    copy[size] = '\0';
    what = strsep(&text, "\n");
    file_size = 8 * (long)size;
    if (text && !strncmp(what, "run", 3))
        play(text), check_run(!strcmp(what, "run+fields")), end_play();
    else if (text && !strcmp(what, "truth"))
        play(text), check_truth(), end_play();
    else if (text && !strcmp(what, "frames"))
        play(text), check_frames(), end_play();
    free(copy);
    return 0;
}
