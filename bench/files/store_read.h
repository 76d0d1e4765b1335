/* store_read.h - reads result files (store.h): tables, plots and scores are made from them.
 */
#ifndef STORE_READ_H
#define STORE_READ_H

#include <stdbool.h>

#include "models/status.h"

struct store_read;

/* Opens FILE.h5 for reading. STATUS_FILE: cannot be read; STATUS_INPUT: HDF5, but not a
 * run. *file is freed with store_read_close. */
enum status store_read_open(const char *path, struct store_read **file,
                            struct message *why);
void store_read_close(struct store_read *file); /* NULL is allowed */

/* Frames with a field in the file; their times are its array "xyz_time". */
int store_read_frames(const struct store_read *file);

/* The n-th field, 0 <= n < frames, into xyz (grid.h) [m]. */
enum status store_read_frame(const struct store_read *file, int n, double *xyz,
                             struct message *why);

bool store_read_has(const struct store_read *file, const char *name);

/* Array of doubles by its name in the file ("time", "metrics/drop", "seconds/advance"):
 * *values [rows][columns], freed by the receiver; columns >= 1, 1 for one number a row. */
enum status store_read_array(const struct store_read *file, const char *name,
                             double **values, int *rows, int *columns, struct message *why);

/* Text attribute `key` of `group` ("/", "provenance", "metrics/drop"); *text is freed by
 * the receiver. */
enum status store_read_text(const struct store_read *file, const char *group,
                            const char *key, char **text, struct message *why);

/* Number attribute `key` of "/" ("length", "unknowns"). */
enum status store_read_number(const struct store_read *file, const char *key,
                              double *number, struct message *why);

#endif
