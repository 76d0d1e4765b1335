/* output.h - writes text: files under a temporary name (atomic_file.h) with every write
 * checked, and the check of standard output at the end. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdio.h>

#include "bench/files/scope.h"
#include "models/status.h"

struct output;

/* Starts a text file that gets its name only when it is complete. STATUS_FILE as in
 * atomic_file_open; on failure *out is untouched. */
enum status output_create(const char *path, struct output **out, struct message *why);

/* Starts one whose name the program chose, by atomic_file_claim. folder NULL: the name has
 * it. */
enum status output_create_in(const char *folder, const char *name, struct output **out,
                             struct message *why);

/* Prints like printf; a failed write is remembered for output_close. */
void output_print(struct output *out, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Returns the fewest digits of %.*g, 15 to 17, that read back as the same number. */
int output_digits(double value);

/* Returns the stream behind output_print, for other functions that print; do not close
 * it. */
FILE *output_stream(struct output *out);

/* Writes what is left, checks every write since the start, syncs, renames, frees and
 * sets *out to NULL. On failure (a full disk) STATUS_FILE with a sentence, and nothing of
 * the file is left. */
enum status output_close(struct output **out, struct message *why);

/* Gives the file up: nothing of it is left. NULL is allowed. */
void output_discard(struct output *out);
SCOPE_OF(output_discard, struct output)

/* Makes a reader who goes away (`clothbench ... | head`) and a file that grows past the
 * user's limit (ulimit -f) failed writes with a sentence, instead of a silent end. Call
 * first in main. */
void output_keep_after_closed_pipe(void);

/* Flushes and closes standard output; call last in main. STATUS_FILE with a sentence for
 * standard error if any write to it failed; the program should then exit with 1. */
enum status output_close_standard(struct message *why);

#endif
