/* report_json.h - what a report holds, as JSON that stands inside of HTML: whatever a file
 * had in it, nothing of it can end the script that it is in, and nothing is program text.
 */
#ifndef REPORT_JSON_H
#define REPORT_JSON_H

#include <stdio.h>

#include "bench/files/csv.h"

/* In quotes. `<`, `>`, `&` and control characters become \u00XX; what is no UTF-8 becomes
 * the replacement character. */
void report_json_string(FILE *file, const char *text);

/* "KEY": "TEXT", with a comma behind it. */
void report_json_pair(FILE *file, const char *key, const char *text);

/* A number, null for what is none. */
void report_json_number(FILE *file, double value);

/* Bytes in base64, in quotes. */
void report_json_bytes(FILE *file, const void *bytes, size_t size);

/* {"caption", "keys", "rows", "notes", "left"}: the columns of `keys`, "|A|B|" (NULL: all),
 * numbers to six digits, 0 for a cell with the words of the one above, rows until their
 * words have so many bytes; `left` is the number of those that did not fit. */
void report_json_table(FILE *file, const struct csv_table *t, const char *keys,
                       size_t most);

#endif
