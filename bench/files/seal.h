/* seal.h - a checksum in front of an HDF5 file, in its user block (512 bytes that the
 * format leaves to the application), so that a damaged file is told before the library,
 * which is not made for such, sees a byte of it.
 */
#ifndef SEAL_H
#define SEAL_H

#include <stddef.h>

#include "models/status.h"

enum { SEAL_BLOCK = 512 };

/* Writes the seal of all that follows the user block. STATUS_FILE with a sentence. */
enum status seal_write(const char *path, struct message *why);

/* Whether the file is as it was sealed; *size is its length [bytes]. STATUS_FILE: it cannot
 * be read; STATUS_INPUT: it is damaged, or no result file; with a sentence. */
enum status seal_check(const char *path, long *size, struct message *why);

/* Small text files that are read back: their last line is a checksum of what stands before
 * it, so that a damaged file is told and not believed. */

/* Of so many bytes, to tell texts and files apart: CRC-32 (ISO 3309), continued from that
 * of what stood before; 0 at first. */
unsigned long seal_text_sum(unsigned long before, const void *bytes, size_t size);

/* The sum of the program's own file: two builds of the same commit may differ.
 * STATUS_FILE. */
enum status seal_text_program(unsigned long *sum, struct message *why);

/* Written aside and renamed (output.h). The text ends in a line's end. STATUS_FILE. */
enum status seal_text_write(const char *path, const char *text, struct message *why);

/* *text, without the seal, is freed by the receiver. STATUS_FILE: it cannot be read;
 * STATUS_INPUT: it is damaged; with a sentence. */
enum status seal_text_read(const char *path, char **text, struct message *why);

#endif
