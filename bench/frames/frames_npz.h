/* frames_npz.h - arrays of floats in a ZIP file, as numpy.savez writes them (NumPy's NPY,
 * versions 1 to 3). */
#ifndef FRAMES_NPZ_H
#define FRAMES_NPZ_H

#include <zip.h>

#include "bench/frames/frames_bytes.h"

struct npz {
    struct frames_bytes bytes; /* of the file                                          */
    zip_t *archive;            /* NULL: the file is one bare array                      */
};

struct npz_array {
    int rank;
    unsigned long long size[5];
    int bytes; /* 4 or 8 a number */
};

/* Opens an archive or a bare array. STATUS_FILE, or STATUS_INPUT with a sentence; free with
 * npz_close. */
enum status npz_open(const char *path, struct npz *npz, struct message *why);
void npz_close(struct npz *npz); /* all-zero is allowed */

/* Reads all numbers of the array `name`, at most `most`; *values is freed by the receiver.
 * STATUS_UNSUPPORTED: there is none of that name; STATUS_INPUT with a sentence. */
enum status npz_load(const struct npz *npz, const char *name, size_t most,
                     struct npz_array *array, double **values, struct message *why);

/* Returns the product of the array's sizes. */
size_t npz_count(const struct npz_array *array);

#endif
