/* frames_file.h - a file that is read from front to back, by lines or by bytes. */
#ifndef FRAMES_FILE_H
#define FRAMES_FILE_H

#include <stdio.h>

#include "models/status.h"

struct frames_file {
    char *path; /*                                                              owned   */
    FILE *file; /*                                                              owned   */
    long long size; /* [bytes]                                                          */
    char *text;     /* the line last read, without its end                      owned   */
    size_t room;    /* of text [bytes]                                                  */
    long line;      /* its number, from 1                                               */
    long long at;   /* where it begins [bytes]                                          */
    long long next; /* where what is read next begins [bytes]                           */
};

/* Opens a regular file. STATUS_FILE with a sentence; an empty one is STATUS_INPUT. Free
 * with frames_file_close. */
enum status frames_file_open(const char *path, struct frames_file *f, struct message *why);
void frames_file_close(struct frames_file *f); /* all-zero is allowed, and left */

/* Reads a line, without a byte-order mark; *more is false at the end. Bytes 0 become '?',
 * which no reader takes. STATUS_MEMORY, or STATUS_FILE with a sentence. */
enum status frames_file_line(struct frames_file *f, bool *more, struct message *why);

/* Goes to a place where a line begins, so that the next one has the number `line`. */
void frames_file_go(struct frames_file *f, long long at, long line);

/* Reads `size` bytes; false: there are fewer. */
bool frames_file_read(struct frames_file *f, void *bytes, size_t size);

/* Reads a number, after blanks, as strtod does; *p moves behind it. False: there is none
 * left in the line. */
bool frames_file_number(char **p, double *x);

/* Return the number of `size` bytes at p (2, 4 or 8 of a float, 1 to 8 of a whole number).
 */
double frames_file_float(const unsigned char *p, int size, bool big);
unsigned long frames_file_whole(const unsigned char *p, int size, bool big);

#endif
