/* table_print.c - how a table looks to people, in each format. */
#define _GNU_SOURCE /* vasprintf */
#include "bench/ui/table_parts.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* Columns of the screen that a sentence, and that a line of anything takes at most; and
 * those that a cell of words may be wrapped to. */
enum { TEXT_WIDTH = 96, LINE_WIDTH = 120, CELL_WIDTH = 40 };

bool table_print_has(const struct table *t, int column, enum table_readers readers)
{
    return t->columns[column].readers == readers || t->columns[column].readers == TABLE_ALL;
}

void table_print_line(const struct table *t, const struct table_line *line, int row,
                      FILE *file)
{
    const char *before = line->before;

    for (int n = 0; n < t->column_count; n++)
        if (table_print_has(t, n, line->readers)) {
            fputs(before, file);
            line->print(t, row, n, file);
            before = line->between;
        }
    fputs(line->behind, file);
}

void table_print_escaped(const char *text, const char *const escaped[128], FILE *file)
{
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c < 128 && escaped[c])
            fputs(escaped[c], file);
        else
            fputc(c, file);
    }
}

static const char *text_at(const struct table *t, int row, int column)
{
    const struct table_column *c = &t->columns[column];
    const char *text = row == TABLE_HEADERS ? c->header
                       : row == TABLE_UNITS ? c->unit
                                            : table_cell(t, row, column)->text;
    return text ? text : "";
}

static bool is_right(const struct table *t, int column)
{
    return t->columns[column].align == TABLE_RIGHT;
}

/* --- text ---------------------------------------------------------------------------- */

/* Words in lines up to `width`, all but the first after `indent` blanks, which stand
 * already before the first. */
static void print_words(const char *text, int indent, int width, FILE *file)
{
    int column = indent;

    while (*text) {
        int size = (int)strcspn(text, " \n");
        if (column > indent && column + 1 + size > width)
            column = fprintf(file, "\n%*s", indent, "") - 1;
        column += fprintf(file, "%s%.*s", column > indent ? " " : "", size, text);
        text += size;
        if (*text == '\n')
            column = fprintf(file, "\n%*s", indent, "") - 1;
        text += *text != '\0';
    }
}

void table_print_wrapped(const char *text, FILE *file)
{
    print_words(text, 0, TEXT_WIDTH, file);
    fputc('\n', file);
}

void table_print_item(const char *name, int column, const char *text, FILE *file)
{
    const int blanks = column - table_width(name);

    fprintf(file, "%s%*s", name, blanks > 0 ? blanks : 2, "");
    print_words(text, blanks > 0 ? column : column - blanks + 2, LINE_WIDTH, file);
    fputc('\n', file);
}

void table_say(FILE *file, const char *format, ...)
{
    char *text = NULL;
    va_list words;

    va_start(words, format);
    if (vasprintf(&text, format, words) >= 0)
        table_print_wrapped(text, file);
    else
        fputs("out of memory\n", file);
    va_end(words);
    free(text);
}

/* Columns of a table that stand side by side: the first `keys` and [from, to). A table
 * wider than a line is printed in parts, one below the other, all of which begin with the
 * keys. */
struct part {
    int keys, from, to;
};

static bool is_shown(const struct table *t, const struct part *p, int n)
{
    return table_print_has(t, n, TABLE_PEOPLE) && (n < p->keys || n >= p->from) &&
           n < p->to;
}

/* Of its columns, with the blanks between them; the last may be wrapped. */
static int part_width(const struct table *t, const struct part *p)
{
    int total = -2;

    for (int n = 0; n < p->to; n++)
        total += is_shown(t, p, n) ? t->width[n] + 2 : 0;
    return total;
}

/* One line of cells. Blanks are printed only before something, none at the end. */
static void print_cells(const struct table *t, const struct part *p, int row, FILE *file)
{
    int pending = 0, column = 0;

    for (int n = 0; n < p->to; n++) {
        if (!is_shown(t, p, n))
            continue;
        const char *cell = text_at(t, row, n);
        int blanks = t->width[n] - table_width(cell);

        pending += is_right(t, n) ? blanks : 0;
        if (*cell) {
            column += fprintf(file, "%*s", pending, "");
            if (column + table_width(cell) > LINE_WIDTH)
                print_words(cell, column, LINE_WIDTH, file);
            else
                fputs(cell, file);
            column += table_width(cell);
            pending = 0;
        }
        pending += (is_right(t, n) ? 0 : blanks) + 2;
    }
    fputc('\n', file);
}

static void print_rule(const struct table *t, const struct part *p, FILE *file)
{
    const int total = part_width(t, p);

    for (int n = 0; n < total && n < LINE_WIDTH; n++)
        fputc('-', file);
    fputc('\n', file);
}

static void print_part(const struct table *t, const struct part *p, FILE *file)
{
    bool units = false;

    for (int n = 0; n < p->to; n++)
        units = units || (is_shown(t, p, n) && t->columns[n].unit);
    print_cells(t, p, TABLE_HEADERS, file);
    if (units)
        print_cells(t, p, TABLE_UNITS, file);
    print_rule(t, p, file);
    for (int row = 0; row < t->row_count; row++) {
        if (row && t->ruled[row])
            print_rule(t, p, file);
        print_cells(t, p, row, file);
    }
}

static bool same_keys(const struct table *t, int keys, int row, int other)
{
    for (int n = 0; n < keys; n++)
        if (table_print_has(t, n, TABLE_PEOPLE) &&
            strcmp(text_at(t, row, n), text_at(t, other, n)) != 0)
            return false;
    return true;
}

/* The first columns that tell every row from the others; those of names, if none do within
 * half a line. */
static int key_columns(const struct table *t)
{
    struct part p = {.to = 0};

    while (++p.to < t->column_count && part_width(t, &p) <= LINE_WIDTH / 2) {
        bool distinct = true;
        for (int row = 0; row < t->row_count && distinct; row++)
            for (int other = 0; other < row && distinct; other++)
                distinct = !same_keys(t, p.to, row, other);
        if (distinct && part_width(t, &p) > 0)
            return p.to;
    }
    for (p.to = 1; p.to < t->column_count && !is_right(t, p.to);)
        p.to++;
    return part_width(t, &p) <= LINE_WIDTH / 2 ? p.to : 1;
}

/* Takes the columns that a line has room for, one at least; a long one of words, wrapped,
 * is the last. */
static void fill_part(const struct table *t, struct part *p)
{
    bool wrapped = false, begins = true;

    for (p->to = p->from; p->to < t->column_count; p->to++) {
        struct part more = {p->keys, p->from, p->to + 1};
        const int over = part_width(t, &more) - LINE_WIDTH, width = t->width[p->to];
        if (!table_print_has(t, p->to, TABLE_PEOPLE))
            continue;
        if (wrapped ||
            (over > 0 && !begins && (is_right(t, p->to) || width - over < CELL_WIDTH)))
            return;
        wrapped = over > 0;
        begins = false;
    }
}

static void print_text(const struct table *t, FILE *file)
{
    struct part p = {0, 0, t->column_count};

    if (t->caption) {
        table_print_wrapped(t->caption, file);
        fputc('\n', file);
    }
    if (part_width(t, &p) > LINE_WIDTH)
        fill_part(t, &p);
    print_part(t, &p, file);
    while (p.to < t->column_count) {
        fputc('\n', file);
        p = (struct part){p.keys ? p.keys : key_columns(t), p.to, p.to};
        fill_part(t, &p);
        print_part(t, &p, file);
    }
    for (int n = 0; n < t->note_count; n++) {
        fputc('\n', file);
        table_print_wrapped(t->notes[n], file);
    }
}

/* --- Markdown ------------------------------------------------------------------------- */

static void print_markdown_cell(const struct table *t, int row, int column, FILE *file)
{
    static const char *const escaped[128] = {
        ['|'] = "\\|", ['*'] = "\\*", ['_'] = "\\_", ['\n'] = " "};

    table_print_escaped(text_at(t, row, column), escaped, file);
    if (row == TABLE_HEADERS && t->columns[column].unit)
        fprintf(file, " [%s]", t->columns[column].unit);
}

static void print_markdown_side(const struct table *t, int row, int column, FILE *file)
{
    (void)row;
    fputs(is_right(t, column) ? "---:" : ":---", file);
}

static void print_markdown(const struct table *t, FILE *file)
{
    static const struct table_line cells = {TABLE_PEOPLE, "| ", " | ", " |\n",
                                            print_markdown_cell},
                                   sides = {TABLE_PEOPLE, "|", "|", "|\n",
                                            print_markdown_side};

    if (t->caption)
        fprintf(file, "**%s**\n\n", t->caption);
    table_print_line(t, &cells, TABLE_HEADERS, file);
    table_print_line(t, &sides, 0, file);
    for (int row = 0; row < t->row_count; row++)
        table_print_line(t, &cells, row, file);
    for (int n = 0; n < t->note_count; n++)
        fprintf(file, "\n%s\n", t->notes[n]);
}

/* --- LaTeX: plain tabular, no packages ------------------------------------------------ */

/* `text` with what TeX takes for its own told apart, between two that TeX reads. */
static void print_latex_text(const char *before, const char *text, const char *behind,
                             FILE *file)
{
    static const char *const escaped[128] = {['&'] = "\\&",
                                             ['%'] = "\\%",
                                             ['$'] = "\\$",
                                             ['#'] = "\\#",
                                             ['_'] = "\\_",
                                             ['{'] = "\\{",
                                             ['}'] = "\\}",
                                             ['<'] = "$<$",
                                             ['~'] = "\\~{}",
                                             ['>'] = "$>$",
                                             ['^'] = "\\^{}",
                                             ['|'] = "$|$",
                                             ['\\'] = "\\textbackslash{}"};

    fputs(before, file);
    table_print_escaped(text, escaped, file);
    fputs(behind, file);
}

static void print_latex_cell(const struct table *t, int row, int column, FILE *file)
{
    print_latex_text("", text_at(t, row, column), "", file);
    if (row == TABLE_HEADERS && t->columns[column].unit)
        print_latex_text(" [", t->columns[column].unit, "]", file);
}

static void print_latex_side(const struct table *t, int row, int column, FILE *file)
{
    (void)row;
    fputc(is_right(t, column) ? 'r' : 'l', file);
}

static void print_latex(const struct table *t, FILE *file)
{
    static const struct table_line cells = {TABLE_PEOPLE, "", " & ", " \\\\\n",
                                            print_latex_cell},
                                   sides = {TABLE_PEOPLE, "", "", "", print_latex_side};

    fputs("\\begin{table}\n\\centering\n", file);
    if (t->caption)
        print_latex_text("\\caption{", t->caption, "}\n", file);
    fputs("\\begin{tabular}{", file);
    table_print_line(t, &sides, 0, file);
    fputs("}\n\\hline\n", file);
    table_print_line(t, &cells, TABLE_HEADERS, file);
    fputs("\\hline\n", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row && t->ruled[row] ? "\\hline\n" : "", file);
        table_print_line(t, &cells, row, file);
    }
    fputs("\\hline\n\\end{tabular}\n", file);
    for (int n = 0; n < t->note_count; n++)
        print_latex_text("\n\\smallskip\\footnotesize ", t->notes[n], "\n", file);
    fputs("\\end{table}\n", file);
}

static FILE *kept;

void table_keep(FILE *copy)
{
    kept = copy;
}

enum status table_print(const struct table *t, enum table_format format, FILE *file)
{
    static void (*const print[])(const struct table *, FILE *) = {
        [TABLE_TEXT] = print_text,         [TABLE_CSV] = table_machine_csv,
        [TABLE_MARKDOWN] = print_markdown, [TABLE_LATEX] = print_latex,
        [TABLE_JSON] = table_machine_json,
    };

    if (!t || t->failed)
        return STATUS_MEMORY;
    print[format](t, file);
    if (kept) {
        table_machine_csv(t, kept);
        fputc('\n', kept);
    }
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}

enum status table_finish(struct table *t, enum table_format format, FILE *file)
{
    enum status st = table_print(t, format, file);

    table_destroy(t);
    if (st == STATUS_OK && format != TABLE_JSON)
        fputc('\n', file);
    return st;
}

enum status table_publish(struct table *t, const char *folder, const char *name,
                          enum table_format format, FILE *file, struct message *why)
{
    const enum status st = table_save(t, folder, name, why);

    if (st == STATUS_OK)
        return table_finish(t, format, file);
    table_destroy(t);
    return st;
}
