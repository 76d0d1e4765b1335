/* report_json.h - writes a report's data as JSON inside of HTML: whatever text a file
 * contains, it can neither end the script that it is in nor become program text. */
#ifndef REPORT_JSON_H
#define REPORT_JSON_H

#include <stdio.h>

#include "bench/files/csv.h"

/* Writes a string in quotes. `<`, `>`, `&`, quotes and control characters become \u00XX;
 * bytes that are not UTF-8 stay, which browsers show as the replacement character. */
void report_json_string(FILE *file, const char *text);

/* Writes "KEY": "TEXT", and a comma. */
void report_json_pair(FILE *file, const char *key, const char *text);

/* Writes a number, or null where it is not finite. */
void report_json_number(FILE *file, double value);

/* Writes bytes in base64, in quotes. */
void report_json_bytes(FILE *file, const void *bytes, size_t size);

/* Writes {"caption", "keys", "rows", "notes", "left"}: the columns of `keys`, "|A|B|"
 * (NULL: all), numbers to six digits, 0 for a cell with the words of the one above, rows
 * until their words have so many bytes; `left` is the number of those that did not fit. */
void report_json_table(FILE *file, const struct csv_table *t, const char *keys,
                       size_t most);

#endif
