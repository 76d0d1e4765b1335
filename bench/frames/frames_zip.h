/* frames_zip.h - members of a ZIP file (PKWARE, APPNOTE 6.3), stored or deflated, and the
 * arrays in them (NumPy's NPY, versions 1 to 3), read from front to end. */
#ifndef FRAMES_ZIP_H
#define FRAMES_ZIP_H

#include <zlib.h>

#include "bench/frames/frames_bytes.h"

/* Bytes one after the other; all-zero before. */
struct frames_zip_stream {
    const unsigned char *at, *end; /* of what is packed                                   */
    bool deflated;
    unsigned long long size; /* unpacked, as the directory has it                         */
    z_stream z;
};

/* The member `name`. STATUS_UNSUPPORTED: there is none; STATUS_INPUT with a sentence: the
 * file is damaged. Free with frames_zip_close. */
enum status frames_zip_open(const struct frames_bytes *b, const char *name,
                            struct frames_zip_stream *stream, struct message *why);
void frames_zip_close(struct frames_zip_stream *stream); /* all-zero is allowed */

/* `size` bytes into room; false: the member ends before, or is damaged. */
bool frames_zip_read(struct frames_zip_stream *stream, void *room, size_t size);

/* An array of floats whose numbers come from a stream. */
struct frames_array {
    int rank;
    unsigned long long size[5];
    int bytes; /* 4 or 8 a number */
};

/* Reads the header: little-endian floats in C order, of which the stream has as many as the
 * shape says. STATUS_INPUT with a sentence that begins `file: name`. */
enum status frames_array_open(const char *path, const char *name,
                              struct frames_zip_stream *stream, struct frames_array *array,
                              struct message *why);

/* The next `count` numbers. */
bool frames_array_read(struct frames_zip_stream *stream, const struct frames_array *array,
                       size_t count, double *values);

/* All numbers of the array `name` of a ZIP file, at most `most`; *values is freed by the
 * receiver. STATUS_UNSUPPORTED: there is none of that name; STATUS_INPUT with a sentence.
 */
enum status frames_array_load(const struct frames_bytes *b, const char *name, size_t most,
                              struct frames_array *array, double **values,
                              struct message *why);

/* The product of its sizes. */
size_t frames_array_count(const struct frames_array *array);

#endif
