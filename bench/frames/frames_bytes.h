/* frames_bytes.h - maps a file into memory, and reads numbers in it. */
#ifndef FRAMES_BYTES_H
#define FRAMES_BYTES_H

#include <stdbool.h>
#include <stddef.h>

#include "models/status.h"

struct frames_bytes {
    char *path;                /* owned */
    const unsigned char *byte; /* [size], read-only */
    size_t size, forgotten;
};

/* Maps a regular file. STATUS_FILE with a sentence; an empty one is STATUS_INPUT. */
enum status frames_bytes_open(const char *path, struct frames_bytes *b,
                              struct message *why);
void frames_bytes_close(struct frames_bytes *b); /* all-zero is allowed, and left */

/* Lets go of the memory pages before `until`, which will not be read soon. */
void frames_bytes_forget(struct frames_bytes *b, size_t until);

/* Returns the array of *room items of `size` bytes, enlarged if it cannot hold one more
 * than `count`. NULL: no memory, and the array is as it was. */
void *frames_bytes_grow(void *array, int *room, int count, size_t size);

/* Return the number of `size` bytes at p (4 or 8 of a float, 1, 2, 4 of a whole number). */
double frames_bytes_float(const unsigned char *p, int size, bool big);
unsigned long frames_bytes_whole(const unsigned char *p, int size, bool big);

/* A text read line by line: *line [*end) is without its line end; false: no more. */
struct frames_text {
    const char *at, *end;
    long line; /* number of the line last read, from 1 */
};
struct frames_text frames_text_of(const struct frames_bytes *b);
bool frames_text_line(struct frames_text *text, const char **line, const char **end);

/* Reads a number, after blanks, as strtod does; *p moves behind it. False: none. */
bool frames_text_number(const char **p, const char *end, double *x);

/* Skips blanks and finds the next word, up to a blank; returns its length, 0 at the end. */
int frames_text_word(const char **p, const char *end, const char **word);

#endif
