/* table_print.c - how a table looks to people, in each format. */
#include "bench/ui/table_parts.h"

#include <stdlib.h>
#include <string.h>

enum { TEXT_WIDTH = 96 };

static bool is_wanted(const struct table *t, int column)
{
    return table_has(t, column, TABLE_PEOPLE);
}

static const char *text_at(const struct table *t, int row, int column)
{
    const char *text = t->cells[(long)row * t->column_count + column].text;
    return text ? text : "";
}

/* Columns on a screen: bytes that do not continue a UTF-8 character. */
static int screen_width(const char *text)
{
    int width = 0;
    for (; *text; text++)
        width += (*text & 0xC0) != 0x80;
    return width;
}

/* --- text ---------------------------------------------------------------------------- */

void table_print_wrapped(const char *text, FILE *file)
{
    int column = 0;

    while (*text) {
        int size = (int)strcspn(text, " \n");
        if (column && column + 1 + size > TEXT_WIDTH) {
            fputc('\n', file);
            column = 0;
        }
        column += fprintf(file, "%s%.*s", column ? " " : "", size, text);
        text += size;
        if (*text == '\n') {
            fputc('\n', file);
            column = 0;
        }
        text += *text != '\0';
    }
    fputc('\n', file);
}

/* One line of cells. Blanks are printed only before something, none at the end. */
static void print_cells(const struct table *t, const int *width,
                        const char *(*text)(const struct table *t, int row, int column),
                        int row, FILE *file)
{
    int pending = 0;

    for (int n = 0; n < t->column_count; n++) {
        if (!is_wanted(t, n))
            continue;
        const char *cell = text(t, row, n);
        int blanks = width[n] - screen_width(cell);
        bool right = t->columns[n].align == TABLE_RIGHT;

        pending += right ? blanks : 0;
        if (*cell) {
            fprintf(file, "%*s%s", pending, "", cell);
            pending = 0;
        }
        pending += (right ? 0 : blanks) + 2;
    }
    fputc('\n', file);
}

static const char *header_at(const struct table *t, int row, int column)
{
    (void)row;
    return t->columns[column].header;
}

static const char *unit_at(const struct table *t, int row, int column)
{
    (void)row;
    return t->columns[column].unit ? t->columns[column].unit : "";
}

static void print_line(const struct table *t, const int *width, FILE *file)
{
    int total = -2;
    for (int n = 0; n < t->column_count; n++)
        total += is_wanted(t, n) ? width[n] + 2 : 0;
    for (int n = 0; n < total; n++)
        fputc('-', file);
    fputc('\n', file);
}

static int widest(const struct table *t, int column)
{
    const struct table_column *c = &t->columns[column];
    int width = screen_width(c->header), unit = c->unit ? screen_width(c->unit) : 0;

    if (unit > width)
        width = unit;
    for (int row = 0; row < t->row_count; row++) {
        int cell = screen_width(text_at(t, row, column));
        if (cell > width)
            width = cell;
    }
    return width;
}

static enum status print_text(const struct table *t, FILE *file)
{
    int count = t->column_count;
    bool units = false;
    int *width = calloc((size_t)count, sizeof *width);

    if (!width)
        return STATUS_MEMORY;
    for (int n = 0; n < count; n++) {
        width[n] = widest(t, n);
        units = units || (is_wanted(t, n) && t->columns[n].unit);
    }
    if (t->caption) {
        table_print_wrapped(t->caption, file);
        fputc('\n', file);
    }
    print_cells(t, width, header_at, 0, file);
    if (units)
        print_cells(t, width, unit_at, 0, file);
    print_line(t, width, file);
    for (int row = 0; row < t->row_count; row++) {
        if (row && t->ruled[row])
            print_line(t, width, file);
        print_cells(t, width, text_at, row, file);
    }
    for (int n = 0; n < t->note_count; n++) {
        fputc('\n', file);
        table_print_wrapped(t->notes[n], file);
    }
    free(width);
    return STATUS_OK;
}

/* --- Markdown ---------------------------------------------------------------------------
 */

static void print_markdown_cell(const char *text, FILE *file)
{
    for (; *text; text++) {
        if (*text == '|' || *text == '*' || *text == '_')
            fputc('\\', file);
        fputc(*text == '\n' ? ' ' : *text, file);
    }
}

static void print_markdown(const struct table *t, FILE *file)
{
    if (t->caption)
        fprintf(file, "**%s**\n\n", t->caption);
    for (int n = 0; n < t->column_count; n++) {
        if (!is_wanted(t, n))
            continue;
        fputs("| ", file);
        print_markdown_cell(t->columns[n].header, file);
        if (t->columns[n].unit)
            fprintf(file, " [%s]", t->columns[n].unit);
        fputc(' ', file);
    }
    fputs("|\n", file);
    for (int n = 0; n < t->column_count; n++)
        if (is_wanted(t, n))
            fputs(t->columns[n].align == TABLE_RIGHT ? "|---:" : "|:---", file);
    fputs("|\n", file);
    for (int row = 0; row < t->row_count; row++) {
        for (int n = 0; n < t->column_count; n++)
            if (is_wanted(t, n)) {
                fputs("| ", file);
                print_markdown_cell(text_at(t, row, n), file);
                fputc(' ', file);
            }
        fputs("|\n", file);
    }
    for (int n = 0; n < t->note_count; n++)
        fprintf(file, "\n%s\n", t->notes[n]);
}

/* --- LaTeX: plain tabular, no packages ---------------------------------------------------
 */

static void print_latex_text(const char *text, FILE *file)
{
    static const char *const escaped[] = {['&'] = "\\&",   ['%'] = "\\%",
                                          ['$'] = "\\$",   ['#'] = "\\#",
                                          ['_'] = "\\_",   ['{'] = "\\{",
                                          ['}'] = "\\}",   ['~'] = "\\~{}",
                                          ['^'] = "\\^{}", ['\\'] = "\\textbackslash{}",
                                          ['<'] = "$<$",   ['>'] = "$>$",
                                          ['|'] = "$|$"};

    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c < sizeof escaped / sizeof *escaped && escaped[c])
            fputs(escaped[c], file);
        else
            fputc(c, file);
    }
}

static void print_latex(const struct table *t, FILE *file)
{
    const char *between = "";

    fputs("\\begin{table}\n\\centering\n", file);
    if (t->caption) {
        fputs("\\caption{", file);
        print_latex_text(t->caption, file);
        fputs("}\n", file);
    }
    fputs("\\begin{tabular}{", file);
    for (int n = 0; n < t->column_count; n++)
        if (is_wanted(t, n))
            fputc(t->columns[n].align == TABLE_RIGHT ? 'r' : 'l', file);
    fputs("}\n\\hline\n", file);
    for (int n = 0; n < t->column_count; n++) {
        if (!is_wanted(t, n))
            continue;
        fputs(between, file);
        between = " & ";
        print_latex_text(t->columns[n].header, file);
        if (t->columns[n].unit) {
            fputs(" [", file);
            print_latex_text(t->columns[n].unit, file);
            fputc(']', file);
        }
    }
    fputs(" \\\\\n\\hline\n", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row && t->ruled[row] ? "\\hline\n" : "", file);
        between = "";
        for (int n = 0; n < t->column_count; n++)
            if (is_wanted(t, n)) {
                fputs(between, file);
                between = " & ";
                print_latex_text(text_at(t, row, n), file);
            }
        fputs(" \\\\\n", file);
    }
    fputs("\\hline\n\\end{tabular}\n", file);
    for (int n = 0; n < t->note_count; n++) {
        fputs("\n\\smallskip\\footnotesize ", file);
        print_latex_text(t->notes[n], file);
        fputc('\n', file);
    }
    fputs("\\end{table}\n", file);
}

enum status table_print(const struct table *t, enum table_format format, FILE *file)
{
    enum status st = STATUS_OK;

    if (!t || t->failed)
        return STATUS_MEMORY;
    switch (format) {
    case TABLE_TEXT:
        st = print_text(t, file);
        break;
    case TABLE_CSV:
        table_machine_csv(t, file);
        break;
    case TABLE_JSON:
        table_machine_json(t, file);
        break;
    case TABLE_MARKDOWN:
        print_markdown(t, file);
        break;
    case TABLE_LATEX:
        print_latex(t, file);
        break;
    }
    if (st == STATUS_OK && ferror(file))
        st = STATUS_FILE;
    return st;
}

enum status table_finish(struct table *t, enum table_format format, FILE *file)
{
    enum status st = table_print(t, format, file);

    table_destroy(t);
    if (st == STATUS_OK)
        fputc('\n', file);
    return st;
}
