/* seal.h - a checksum in front of an HDF5 file, in its user block (512 bytes that the
 * format leaves to the application), so that a damaged file is found before the library,
 * which may crash on one, sees a byte of it. */
#ifndef SEAL_H
#define SEAL_H

#include <stddef.h>

#include "models/status.h"

enum { SEAL_BLOCK = 512 };

/* Writes the seal of all bytes that follow the user block. STATUS_FILE with a sentence. */
enum status seal_write(const char *path, struct message *why);

/* Checks that the file is as it was sealed; *size is its length [bytes]. STATUS_FILE: it
 * cannot be read; STATUS_INPUT: it is damaged, or no result file; with a sentence. */
enum status seal_check(const char *path, long *size, struct message *why);

/* Returns the CRC-32 (ISO 3309) of so many bytes, which identifies texts and files;
 * `before` is that of the preceding bytes, 0 at first. */
unsigned long seal_sum(unsigned long before, const void *bytes, size_t size);

#endif
