/* hdf5_file.h - the few HDF5 calls that result files need, with errors as sentences. The
 * library is not thread-safe: one thread at a time. */
#ifndef HDF5_FILE_H
#define HDF5_FILE_H

#include <hdf5.h>
#include <stdbool.h>

#include "models/status.h"

/* Prepares the library; call before any other function here (more often is allowed). It
 * prints no error stacks and does nothing at exit (where it would close again what could
 * not be closed). */
void hdf5_file_start(void);

/* Fails with STATUS_FILE and `path: doing: reason`, the reason taken from the library's
 * last error, the system's word for it where there is one. */
enum status hdf5_file_fail(const char *path, const char *doing, struct message *why);

/* Write attributes of an open group, dataset or file; text is UTF-8. A text of more than
 * 60,000 bytes becomes a dataset of that name. Negative: failed. */
herr_t hdf5_file_put_text(hid_t object, const char *key, const char *text);
herr_t hdf5_file_put_long(hid_t object, const char *key, long value);
herr_t hdf5_file_put_double(hid_t object, const char *key, double value);

/* The unit of a dataset's numbers ("m", "1", ...) and what its axes count, in order. */
struct hdf5_file_meaning {
    const char *unit, *axes;
};
herr_t hdf5_file_put_meaning(hid_t set, struct hdf5_file_meaning meaning);

/* Writes the dataset `name` of doubles [rows] (columns = 0) or [rows][columns]; makes
 * missing groups on the way. */
herr_t hdf5_file_put_array(hid_t file, const char *name, struct hdf5_file_meaning meaning,
                           const double *values, int rows, int columns);

/* Does so with whole numbers. */
herr_t hdf5_file_put_whole(hid_t file, const char *name, struct hdf5_file_meaning meaning,
                           const int *values, int rows, int columns);

/* Releases any identifier of the library's; an invalid one is allowed. */
void hdf5_file_drop(hid_t id);

/* Opens a file for reading, which must be a regular one; the receiver drops it. Negative,
 * with a sentence: it cannot. */
hid_t hdf5_file_open(const char *path, struct message *why);

/* Opens a dataset and gets its sizes. *rank is 0 if there is none of that name, if it has
 * no axis or too many, or if it is not one that a reader may trust: reached by links out of
 * the file, with numbers that stand elsewhere or nowhere, or in pieces of more than an
 * entry of its first axis and a megabyte of numbers. The receiver drops what is returned.
 */
enum { HDF5_FILE_RANK = 8 };
hid_t hdf5_file_open_set(hid_t file, const char *name, int *rank,
                         hsize_t size[HDF5_FILE_RANK]);

/* Fails with STATUS_INPUT and a sentence on a dataset that may not be trusted. */
enum status hdf5_file_refuse_set(const char *path, const char *name, struct message *why);

/* Read and write the n-th entry of a dataset's first axis, all doubles of its other axes.
 * False: failed. */
bool hdf5_file_read_entry(hid_t set, int n, double *values);
bool hdf5_file_write_entry(hid_t set, int n, const double *values);

#endif
