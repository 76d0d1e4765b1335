/* printer.h - where what a command has to tell goes: tables in one format to people or
 * programs, and as CSV into a folder. The one printer of datasets.
 */
#ifndef PRINTER_H
#define PRINTER_H

#include "bench/data/table.h"
#include "bench/data/wrap.h"

/* The values of --format, for tables of options. */
#define PRINTER_WORD(code, word) "|" #word
#define PRINTER_FORMATS          (TABLE_FORMATS(PRINTER_WORD) + 1)

struct printer {
    enum table_format format;
    FILE *file;         /* NULL: nothing is printed                        borrowed */
    const char *folder; /* of tables as CSV; NULL: none                    borrowed */
    FILE *copy;         /* gets all tables as CSV with their notes; NULL   borrowed */
    struct {            /* JSON, held back until the end (printer_close)      owned */
        FILE *stream;
        char *text;
        size_t size;
        int count;
    } json;
};

/* Reads a value of --format. STATUS_INPUT with a sentence that lists them. */
enum status printer_format(const char *word, enum table_format *format,
                           struct message *why);

/* Returns whether sentences may stand beside the tables (text, Markdown). CSV, JSON and
 * LaTeX, which other programs read, have tables with their captions and notes, and nothing
 * else. */
bool printer_is_prose(const struct printer *p);

/* Returns whether the format is CSV or JSON: one table with everything, where people get
 * several. */
bool printer_is_data(const struct printer *p);

/* Prints a dataset and an empty line, and destroys it in any case; with a name also as
 * FOLDER/NAME.csv (printer_save). STATUS_FILE. */
enum status printer_table(struct printer *p, struct dataset *t, const char *name,
                          struct message *why);

/* Writes FOLDER/NAME.csv, if there is a folder: a line of keys, a line each row, as many
 * cells in each; no caption and no notes. STATUS_FILE (as output.h). */
enum status printer_save(const struct printer *p, const struct dataset *t, const char *name,
                         struct message *why);

/* Returns the stream for the next object of JSON. */
FILE *printer_json(struct printer *p);

/* Prints what is held back: one object of JSON as it is, several as one array, so that the
 * whole is JSON. STATUS_FILE if the stream fails. */
enum status printer_close(struct printer *p);

#endif
