#include "bench/verify/verify_file.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "fem_ref/reference.h"

/* Numbers of a row, in the order of their columns. */
static const struct number {
    const char *name;
    size_t place;
} numbers[] = {
    {"value", offsetof(struct verify_row, value)},
    {"truth", offsetof(struct verify_row, truth)},
    {"bar", offsetof(struct verify_row, bar)},
    {"error", offsetof(struct verify_row, error)},
    {"tolerance", offsetof(struct verify_row, tolerance)},
    {"order", offsetof(struct verify_row, order)},
    {"seconds", offsetof(struct verify_row, seconds)},
};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

static double *number_of(struct verify_row *row, int n)
{
    return (double *)((char *)row + numbers[n].place);
}

static void path_of(const char *name, const char *folder, char *path, int size)
{
    snprintf(path, (size_t)size, "%s/%s.csv", folder, name);
}

/* A cell holds neither comma nor line end, nor blanks at its ends: written as in addresses
 * of the web, %2C. */
static bool is_plain(const char *text, const char *c)
{
    return !strchr(",%\n", *c) && (*c != ' ' || (c > text && c[1]));
}

static void print_text(struct output *file, const char *text)
{
    for (const char *c = text; *c; c++)
        if (is_plain(text, c))
            output_print(file, "%c", *c);
        else
            output_print(file, "%%%02X", (unsigned char)*c);
}

/* The text of a cell into text[size]. */
static void read_text(const char *cell, char *text, size_t size)
{
    size_t length = 0;
    unsigned code;

    for (; *cell && length + 1 < size; cell++)
        if (*cell == '%' && sscanf(cell, "%%%2X", &code) == 1) {
            text[length++] = (char)code;
            cell += 2;
        } else
            text[length++] = *cell;
    text[length] = '\0';
}

static void print_row(struct output *file, struct verify_row *row)
{
    print_text(file, row->quantity);
    output_print(file, ",");
    print_text(file, row->subject);
    for (int n = 0; n < NUMBERS; n++) {
        double x = *number_of(row, n);
        if (isnan(x))
            output_print(file, ",");
        else
            output_print(file, ",%.17g", x);
    }
    output_print(file, ",");
    print_text(file, verify_verdict_name((int)row->verdict));
    output_print(file, ",");
    print_text(file, row->note);
    output_print(file, "\n");
}

enum status verify_file_write(const struct verify_sheet *sheet, const char *name,
                              const char *folder, struct message *why)
{
    enum status st;
    struct output *file = NULL;
    struct provenance provenance;
    char path[4096];

    path_of(name, folder, path, sizeof path);
    TRY(output_create(path, &file, why));
    provenance_collect(&provenance);
    output_print(file, "# clothbench verify %s\n", name);
    for (int n = 0; n < provenance.count; n++)
        output_print(file, "# %s: %s\n", provenance.entry[n].key,
                     provenance.entry[n].value);
    output_print(file, "quantity,subject");
    for (int n = 0; n < NUMBERS; n++)
        output_print(file, ",%s", numbers[n].name);
    output_print(file, ",verdict,note\n");
    for (int n = 0; n < sheet->count; n++)
        print_row(file, &sheet->rows[n]);
    struct output *whole = file;
    file = NULL;
    TRY(output_close(whole, why));
out:
    output_discard(file);
    return st;
}

/* STATUS_INPUT for a word that is none. */
static enum status read_verdict(const char *word, enum verify_verdict *verdict,
                                const char *path, struct message *why)
{
    for (int n = 0; n < VERIFY_VERDICTS; n++)
        if (!strcmp(word, verify_verdict_name(n))) {
            *verdict = (enum verify_verdict)n;
            return STATUS_OK;
        }
    return status_fail(why, STATUS_INPUT, "%s: '%s' is no verdict", path, word);
}

static enum status require_columns(const struct reference *table, const char *path,
                                   struct message *why)
{
    static const char *const words[] = {"quantity", "subject", "verdict", "note"};

    for (int n = 0; n < 4 + NUMBERS; n++) {
        const char *name = n < 4 ? words[n] : numbers[n - 4].name;
        if (reference_column(table, name) < 0)
            return status_fail(why, STATUS_INPUT, "%s: no column '%s'", path, name);
    }
    return STATUS_OK;
}

enum status verify_file_read(const char *name, const char *folder,
                             struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    const struct verify_subject nobody = {
        .contestant = contestant_table, .tolerance = NAN, .nets = 1};
    char path[4096];

    *sheet = (struct verify_sheet){0};
    path_of(name, folder, path, sizeof path);
    TRY(reference_open(path, &table, why));
    TRY(require_columns(table, path, why));
    for (int n = 0; n < reference_rows(table); n++) {
        struct verify_row *row = verify_sheet_add(sheet, &nobody, "%s", "");
        read_text(reference_text(table, n, "quantity"), row->quantity,
                  sizeof row->quantity);
        read_text(reference_text(table, n, "subject"), row->subject, sizeof row->subject);
        read_text(reference_text(table, n, "note"), row->note, sizeof row->note);
        for (int i = 0; i < NUMBERS; i++)
            *number_of(row, i) = reference_number(table, n, numbers[i].name);
        TRY(read_verdict(reference_text(table, n, "verdict"), &row->verdict, path, why));
    }
    TRY(sheet->status);
out:
    reference_close(table);
    if (st != STATUS_OK)
        verify_sheet_clear(sheet);
    return st;
}
