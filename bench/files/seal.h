/* seal.h - a checksum in front of an HDF5 file, in its user block (512 bytes that the
 * format leaves to the application), so that a damaged file is told before the library,
 * which is not made for such, sees a byte of it.
 */
#ifndef SEAL_H
#define SEAL_H

#include "models/status.h"

enum { SEAL_BLOCK = 512 };

/* Writes the seal of all that follows the user block. STATUS_FILE with a sentence. */
enum status seal_write(const char *path, struct message *why);

/* Whether the file is as it was sealed; *size is its length [bytes]. STATUS_FILE: it cannot
 * be read; STATUS_INPUT: it is damaged, or no result file; with a sentence. */
enum status seal_check(const char *path, long *size, struct message *why);

#endif
