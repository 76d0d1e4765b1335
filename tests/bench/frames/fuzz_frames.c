/* Frames from any bytes, for libFuzzer or from files (fuzz.h). The first byte says as what
 * kind the others are read: c .csv, o .obj, p .ply, z .npz, n .npy, m .mdd, 2 .pc2, h .h5;
 * lines that are `---` part the files of a sequence of meshes.
 *
 * .h5 goes through the HDF5 library, which is not made for damaged files: what stops in it
 * is its own (fuzz_store plays the library, and meets our reader alone). Beyond crashes,
 * leaks and undefined behaviour it stops at: a refusal without a printable sentence that
 * names the file; frames with fewer numbers than they say, numbers that are none, times
 * that do not grow. */
#define _GNU_SOURCE /* memfd_create, memmem */
#include <hdf5.h>
#include <math.h>
#include <sys/mman.h>

#include "bench/frames/frames.h"
#include "bench/frames/frames_file.h"
#include "tests/fuzz.h"

static const uint8_t *file_bytes;
static size_t file_size;

enum status __wrap_frames_file_open(const char *path, struct frames_file *f,
                                    struct message *why);

/* fuzz1.obj is the first part. */
enum status __wrap_frames_file_open(const char *path, struct frames_file *f,
                                    struct message *why)
{
    const uint8_t *at = file_bytes, *end = at + file_size, *stop;

    for (int part = path[4] - '1'; part > 0 && at; part--) {
        at = memmem(at, (size_t)(end - at), "---\n", 4);
        at = at ? at + 4 : NULL;
    }
    stop = at ? memmem(at, (size_t)(end - at), "---\n", 4) : NULL;
    const size_t size = at ? (size_t)((stop ? stop : end) - at) : 0;
    *f = (struct frames_file){NULL};
    if (!size)
        return status_fail(why, STATUS_INPUT, "%s: is empty", path);
    *f = (struct frames_file){.path = strdup(path),
                              .file = fdopen(memfd_create("fuzz", 0), "w+"),
                              .size = (long long)size};
    MUST(f->path && f->file && fwrite(at, 1, size, f->file) == size);
    rewind(f->file);
    return STATUS_OK;
}

hid_t __real_H5Fopen(const char *path, unsigned flags, hid_t access);
hid_t __wrap_H5Fopen(const char *path, unsigned flags, hid_t access);

/* The bytes in place of the file that is named. */
hid_t __wrap_H5Fopen(const char *path, unsigned flags, hid_t access)
{
    const hid_t memory = H5Pcreate(H5P_FILE_ACCESS);

    (void)access;
    MUST(memory >= 0 && H5Pset_fapl_core(memory, 1 << 16, false) >= 0);
    MUST(H5Pset_file_image(memory, (void *)(uintptr_t)file_bytes, file_size) >= 0);
    const hid_t file = __real_H5Fopen(path, flags, memory);
    H5Pclose(memory);
    return file;
}

static void check_net(const struct frames_net *net)
{
    MUST(net->vertices > 0 && net->vertices <= FRAMES_MOST_VERTICES);
    for (int n = 0; net->uv && n < 2 * net->vertices; n++)
        MUST(isfinite(net->uv[n]));
    for (int n = 0; n < net->triangles; n++)
        for (int c = 0; c < 3; c++)
            MUST(net->triangle[n][c] >= 0 && net->triangle[n][c] < net->vertices);
}

/* Frames of a file are many, and short: enough of them are read. */
enum { FRAMES_ENOUGH = 100 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char kinds[] = "copznm2h";
    static const char *const names[][2] = {{"fuzz1.csv"},
                                           {"fuzz1.obj", "fuzz2.obj"},
                                           {"fuzz1.ply", "fuzz2.ply"},
                                           {"fuzz1.npz"},
                                           {"fuzz1.npy"},
                                           {"fuzz1.mdd"},
                                           {"fuzz1.pc2"},
                                           {"fuzz1.h5"}};
    const char *kind = size ? memchr(kinds, data[0], sizeof kinds - 1) : NULL;
    struct frames *f = NULL;
    struct message why = {""};
    const double *xyz = NULL;
    double t, before = -INFINITY;

    if (!kind)
        return 0;
    file_bytes = data + 1, file_size = size - 1;
    const char *const *paths = names[kind - kinds];
    enum status st =
        frames_open(paths[1] ? 2 : 1, paths,
                    &(struct frames_look){strchr("opn2", *kind) ? 1 : 0, NULL}, &f, &why);
    if (st == STATUS_OK)
        check_net(frames_net(f));
    for (int n = 0; st == STATUS_OK && n < FRAMES_ENOUGH; n++) {
        st = frames_next(f, &t, &xyz, &why);
        if (st != STATUS_OK || !xyz)
            break;
        MUST(t > before && isfinite(t));
        before = t;
        for (int k = 0; k < 3 * frames_net(f)->vertices; k++)
            MUST(isfinite(xyz[k]));
    }
    if (st != STATUS_OK) {
        MUST(st == STATUS_INPUT || (*kind == 'h' && st == STATUS_FILE));
        fuzz_check_sentence(&why, "fuzz");
    }
    frames_close(f);
    return 0;
}
