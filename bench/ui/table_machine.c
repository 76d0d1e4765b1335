/* table_machine.c - tables for machines: keys, CSV (RFC 4180), JSON. */
#include "bench/ui/table_parts.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"

enum { KEY = 128, PATH = 4096 };

/* --- keys ----------------------------------------------------------------------------- */

/* Letters, digits and _ of words, behind what `key` has. */
static void add_words(char key[KEY], const char *words)
{
    for (; *words; words++) {
        const size_t used = strlen(key);
        const char *as = *words == '%' ? "percent" : *words == '/' ? "_per_" : NULL;
        if (used + 8 > KEY)
            return;
        if (as)
            strcpy(key + used, as + (*as == '_' && used && key[used - 1] == '_'));
        else if (isalnum((unsigned char)*words))
            key[used] = (char)tolower((unsigned char)*words);
        else if (*words != '^' && used && key[used - 1] != '_')
            key[used] = '_';
    }
}

static void add_unit(char key[KEY], const char *unit)
{
    const size_t used = strlen(key);
    const bool length = !strcmp(unit, "L"), share = !strcmp(unit, "% L");

    if (used + 24 > KEY || !strcmp(unit, "1"))
        return;
    strcpy(key + used, length || share ? "_over_length" : "_");
    if (share)
        strcat(key, "_percent");
    else if (!length)
        add_words(key, unit);
}

char *table_machine_key(const struct table_column *columns, int n)
{
    const struct table_column *c = &columns[n];
    char key[KEY] = "";
    int twins = 1;

    add_words(key, c->header);
    if (c->unit)
        add_unit(key, c->unit);
    for (char *end = key + strlen(key); end > key && end[-1] == '_';)
        *--end = '\0';
    for (int k = 0; k < n; k++) {
        const size_t size = strlen(key);
        const char *other = columns[k].key;
        twins += !strncmp(other, key, size) && (!other[size] || other[size] == '_') &&
                 strspn(other + size, "_0123456789") == strlen(other + size);
    }
    if (twins > 1)
        snprintf(key + strlen(key), KEY - strlen(key), "_%d", twins);
    return strdup(*key ? key : "column");
}

/* --- CSV ------------------------------------------------------------------------------ */

static void print_comment(const char *text, FILE *file)
{
    static const char *const escaped[128] = {['\n'] = "\n# "};

    fputs("# ", file);
    table_print_escaped(text, escaped, file);
    fputc('\n', file);
}

static void print_field(const char *text, FILE *file)
{
    static const char *const escaped[128] = {['"'] = "\"\""};
    const char *quote = text[strcspn(text, ",\"\n\r")] || *text == '#' ? "\"" : "";

    fputs(quote, file);
    table_print_escaped(text, escaped, file);
    fputs(quote, file);
}

static void print_cell(const struct table *t, int row, int column, FILE *file)
{
    const struct table_cell *cell =
        row == TABLE_HEADERS ? NULL : table_cell(t, row, column);

    if (!cell)
        print_field(t->columns[column].key, file);
    else if (cell->kind == TABLE_CELL_TEXT)
        print_field(cell->text, file);
    else if (cell->kind == TABLE_CELL_NUMBER && !isnan(cell->value))
        fprintf(file, "%.17g", cell->value);
}

static void print_lines(const struct table *t, bool keys, FILE *file)
{
    static const struct table_line line = {TABLE_MACHINES, "", ",", "\n", print_cell};

    for (int row = keys ? TABLE_HEADERS : 0; row < t->row_count; row++)
        table_print_line(t, &line, row, file);
}

void table_machine_csv(const struct table *t, FILE *file)
{
    if (t->caption)
        print_comment(t->caption, file);
    print_lines(t, true, file);
    for (int n = 0; n < t->note_count; n++)
        print_comment(t->notes[n], file);
}

enum status table_flush(struct table *t, FILE *file)
{
    if (!t || t->failed)
        return STATUS_MEMORY;
    print_lines(t, !t->flushed, file);
    for (long n = 0; n < (long)t->row_count * t->column_count; n++)
        free(t->cells[n].text);
    if (t->cells)
        memset(t->cells, 0, (size_t)t->room * (size_t)t->column_count * sizeof *t->cells);
    t->flushed = true;
    t->row_count = t->filled = 0;
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}

enum status table_save(const struct table *t, const char *folder, const char *name,
                       struct message *why)
{
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    if (!t || t->failed)
        return STATUS_MEMORY;
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    TRY(output_create(path, &out, why));
    print_lines(t, true, output_stream(out));
    st = output_close(out, why);
out:
    return st;
}

/* --- JSON ----------------------------------------------------------------------------- */

static struct {
    FILE *stream;
    char *text;
    size_t size;
    int count;
    bool failed;
} held;

FILE *table_json_open(FILE *file)
{
    if (file != stdout)
        return file;
    if (!held.stream)
        held.stream = open_memstream(&held.text, &held.size);
    held.failed = !held.stream;
    if (held.stream && held.count++)
        fputc(',', held.stream);
    return held.stream;
}

enum status table_json_close(void)
{
    bool failed = held.failed;

    if (held.stream) {
        failed = ferror(held.stream) || fclose(held.stream) != 0;
        if (!failed)
            printf(held.count > 1 ? "[%s]\n" : "%s", held.text);
        free(held.text);
        memset(&held, 0, sizeof held);
    }
    return failed ? STATUS_MEMORY : STATUS_OK;
}

void table_json_string(const char *text, FILE *file)
{
    fputc('"', file);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fprintf(file, "\\%c", c);
        else if (c < ' ' || c == 127)
            fprintf(file, "\\u%04x", c);
        else
            fputc(c, file);
    }
    fputc('"', file);
}

static void print_pair(const char *key, const char *text, FILE *file)
{
    table_json_string(key, file);
    fputs(": ", file);
    table_json_string(text, file);
}

static void print_value(const struct table *t, int row, int column, FILE *file)
{
    const struct table_cell *cell = table_cell(t, row, column);

    table_json_string(t->columns[column].key, file);
    fputs(": ", file);
    if (cell->kind == TABLE_CELL_TEXT)
        table_json_string(cell->text, file);
    else if (cell->kind == TABLE_CELL_MISSING || isnan(cell->value))
        fputs("null", file);
    else if (isinf(cell->value))
        fputs(cell->value > 0 ? "\"inf\"" : "\"-inf\"", file);
    else
        fprintf(file, "%.17g", cell->value);
}

static void print_units(const struct table *t, FILE *file)
{
    const char *comma = "";

    for (int n = 0; n < t->column_count; n++) {
        const struct table_column *c = &t->columns[n];
        const char *unit = c->key_unit ? c->key_unit : c->unit;
        if (!unit || !table_print_has(t, n, TABLE_MACHINES))
            continue;
        fputs(comma, file);
        print_pair(c->key, unit, file);
        comma = ", ";
    }
}

void table_machine_json(const struct table *t, FILE *to)
{
    static const struct table_line object = {TABLE_MACHINES, "{", ", ", "}", print_value};
    FILE *file = table_json_open(to);

    if (!file)
        return;
    fputc('{', file);
    print_pair("caption", t->caption ? t->caption : "", file);
    fputs(", \"units\": {", file);
    print_units(t, file);
    fputs("}, \"rows\": [", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row ? ", " : "", file);
        table_print_line(t, &object, row, file);
    }
    fputs("], \"notes\": [", file);
    for (int n = 0; n < t->note_count; n++) {
        fputs(n ? ", " : "", file);
        table_json_string(t->notes[n], file);
    }
    fputs("]}\n", file);
}
