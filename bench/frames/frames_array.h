/* frames_array.h - a file with named arrays of numbers: NumPy's .npz and .npy (of which the
 * one array is xyz), or HDF5. One of them is read at a time, from front to back. */
#ifndef FRAMES_ARRAY_H
#define FRAMES_ARRAY_H

#include <stddef.h>

#include "bench/files/scope.h"
#include "models/status.h"

struct frames_array;

/* Opens a file, NumPy's by the ending of its name, else HDF5. STATUS_FILE, or STATUS_INPUT
 * with a sentence. */
enum status frames_array_open(const char *path, struct frames_array **file,
                              struct message *why);
void frames_array_close(struct frames_array *file); /* NULL is allowed */
SCOPE_OF(frames_array_close, struct frames_array)

/* Begins to read an array; size[8] are its sizes, 0 behind the last. STATUS_UNSUPPORTED:
 * there is none of that name; STATUS_INPUT; with a sentence each. */
enum status frames_array_begin(struct frames_array *file, const char *name,
                               unsigned long long size[8], struct message *why);

/* Reads the next `count` numbers, whole rows of the first index; false: the file is cut off
 * or damaged. */
bool frames_array_read(struct frames_array *file, size_t count, double *values);

/* Reads all of an array of `rows` rows of `columns` numbers, at least one; *values is freed
 * by the receiver. STATUS_INPUT: it has other sizes. */
enum status frames_array_load(struct frames_array *file, const char *name, size_t rows,
                              size_t columns, double **values, struct message *why);

#endif
