/* sealed_text.h - small text files that are read back: their last line is a checksum of
 * what stands before it, so that a damaged file is told and not believed. (seal.h: the same
 * of HDF5 files.)
 */
#ifndef SEALED_TEXT_H
#define SEALED_TEXT_H

#include <stddef.h>

#include "models/status.h"

/* Of so many bytes, to tell texts and files apart: CRC-32 (ISO 3309), continued from that
 * of what stood before; 0 at first. */
unsigned long sealed_text_sum(unsigned long before, const void *bytes, size_t size);

/* The sum of the program's own file: two builds of the same commit may differ.
 * STATUS_FILE. */
enum status sealed_text_program(unsigned long *sum, struct message *why);

/* Written aside and renamed (output.h). The text ends in a line's end. STATUS_FILE. */
enum status sealed_text_write(const char *path, const char *text, struct message *why);

/* *text, without the seal, is freed by the receiver. STATUS_FILE: it cannot be read;
 * STATUS_INPUT: it is damaged; with a sentence. */
enum status sealed_text_read(const char *path, char **text, struct message *why);

#endif
