/* table.c - writes a dataset for machines (CSV after RFC 4180, JSON) and for people (text,
 * Markdown, LaTeX). */
#include "bench/data/table.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "bench/data/json.h"
#include "bench/data/wrap.h"

/* The most columns of the screen for a wrapped cell. */
enum { CELL_WIDTH = 40 };

static const struct dataset_cell *cell_at(const struct dataset *t, int row, int column)
{
    return &t->rows[row]->cell[column];
}

/* --- lines of any format -------------------------------------------------------------- */

/* The form of a row for these readers, people or machines: its cells, with what stands
 * before, between and behind them. The row of headers or keys comes first. */
enum { TABLE_UNITS = -2, TABLE_HEADERS = -1 };
struct table_line {
    enum dataset_readers readers;
    const char *before, *between, *behind;
    void (*print)(const struct dataset *t, const struct table_line *line, int row,
                  int column, FILE *file);
    const char *const *escaped; /* [128] what is printed in place of a character; or NULL */
};

static bool has(const struct dataset *t, int column, enum dataset_readers readers)
{
    return t->columns[column].readers == readers ||
           t->columns[column].readers == DATASET_ALL;
}

static void print_line(const struct dataset *t, const struct table_line *line, int row,
                       FILE *file)
{
    const char *before = line->before;

    for (int n = 0; n < t->column_count; n++)
        if (has(t, n, line->readers)) {
            fputs(before, file);
            line->print(t, line, row, n, file);
            before = line->between;
        }
    fputs(line->behind, file);
}

/* Prints text with characters replaced, between two strings as they are. */
static void print_escaped(const char *before, const char *text, const char *behind,
                          const char *const escaped[128], FILE *file)
{
    fputs(before, file);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c < 128 && escaped[c])
            fputs(escaped[c], file);
        else
            wrap_put(c, file);
    }
    fputs(behind, file);
}

static const char *text_at(const struct dataset *t, int row, int column)
{
    const struct dataset_column *c = &t->columns[column];
    const char *text = row == TABLE_HEADERS ? c->header
                       : row == TABLE_UNITS ? c->unit
                                            : cell_at(t, row, column)->text;
    return text ? text : "";
}

/* Prints a cell as people see it; a header with its unit. */
static void print_shown(const struct dataset *t, const struct table_line *line, int row,
                        int column, FILE *file)
{
    const char *unit = row == TABLE_HEADERS ? t->columns[column].unit : NULL;

    print_escaped("", text_at(t, row, column), "", line->escaped, file);
    if (unit)
        print_escaped(" [", unit, "]", line->escaped, file);
}

/* --- CSV ------------------------------------------------------------------------------ */

static void print_comment(const char *text, FILE *file)
{
    static const char *const escaped[128] = {['\n'] = "\n# "};

    print_escaped("# ", text, "\n", escaped, file);
}

/* Returns whether a spreadsheet would run a text instead of showing it: it may come from a
 * file of somebody else. */
static bool is_formula(const char *text)
{
    return strchr("=@\t\r", *text)
               ? *text != '\0'
               : strchr("+-", *text) &&
                     (isalpha((unsigned char)text[1]) || strpbrk(text, "|("));
}

static void print_field(const char *text, FILE *file)
{
    static const char *const escaped[128] = {['"'] = "\"\""};
    const char *quote = text[strcspn(text, ",\"\n\r")] || *text == '#' ? "\"" : "";

    fputs(quote, file);
    print_escaped(is_formula(text) ? "'" : "", text, quote, escaped, file);
}

static void print_cell(const struct dataset *t, const struct table_line *line, int row,
                       int column, FILE *file)
{
    const struct dataset_cell *cell = row == TABLE_HEADERS ? NULL : cell_at(t, row, column);

    (void)line;
    if (!cell)
        print_field(t->columns[column].key, file);
    else if (cell->kind == DATASET_CELL_TEXT)
        print_field(cell->text, file);
    else if (cell->kind == DATASET_CELL_NUMBER && !isnan(cell->value))
        fprintf(file, "%.17g", cell->value);
}

void table_lines(const struct dataset *t, FILE *file)
{
    static const struct table_line line = {DATASET_MACHINES, "", ",", "\n", print_cell};

    for (int row = TABLE_HEADERS; row < t->row_count; row++)
        print_line(t, &line, row, file);
}

static void print_csv(const struct dataset *t, FILE *file)
{
    if (t->caption)
        print_comment(t->caption, file);
    table_lines(t, file);
    for (int n = 0; n < t->note_count; n++)
        print_comment(t->notes[n], file);
}

/* --- JSON ----------------------------------------------------------------------------- */

static void print_pair(const char *key, const char *text, FILE *file)
{
    json_string(key, file);
    fputs(": ", file);
    json_string(text, file);
}

static void print_value(const struct dataset *t, const struct table_line *line, int row,
                        int column, FILE *file)
{
    const struct dataset_cell *cell = cell_at(t, row, column);

    (void)line;
    json_string(t->columns[column].key, file);
    fputs(": ", file);
    if (cell->kind == DATASET_CELL_TEXT)
        json_string(cell->text, file);
    else if (cell->kind == DATASET_CELL_MISSING || isnan(cell->value))
        fputs("null", file);
    else if (isinf(cell->value))
        fputs(cell->value > 0 ? "\"inf\"" : "\"-inf\"", file);
    else
        fprintf(file, "%.17g", cell->value);
}

static void print_units(const struct dataset *t, FILE *file)
{
    const char *comma = "";

    for (int n = 0; n < t->column_count; n++) {
        const struct dataset_column *c = &t->columns[n];
        const char *unit = c->key_unit ? c->key_unit : c->unit;
        if (!unit || !has(t, n, DATASET_MACHINES))
            continue;
        fputs(comma, file);
        print_pair(c->key, unit, file);
        comma = ", ";
    }
}

static void print_json(const struct dataset *t, FILE *file)
{
    static const struct table_line object = {DATASET_MACHINES, "{", ", ", "}", print_value};

    fputc('{', file);
    print_pair("caption", t->caption ? t->caption : "", file);
    fputs(", \"units\": {", file);
    print_units(t, file);
    fputs("}, \"rows\": [", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row ? ", " : "", file);
        print_line(t, &object, row, file);
    }
    fputs("], \"notes\": [", file);
    for (int n = 0; n < t->note_count; n++) {
        fputs(n ? ", " : "", file);
        json_string(t->notes[n], file);
    }
    fputs("]}\n", file);
}

/* --- text ---------------------------------------------------------------------------- */

/* Columns of a table that stand side by side: the first `keys` and [from, to). A table
 * wider than a line is printed in parts, one below the other, all of which begin with the
 * keys. */
struct part {
    int keys, from, to;
};

static bool is_shown(const struct dataset *t, const struct part *p, int n)
{
    return has(t, n, DATASET_PEOPLE) && (n < p->keys || n >= p->from) && n < p->to;
}

/* Returns the width of a part's columns with blanks between; the last may be wrapped. */
static int part_width(const struct dataset *t, const struct part *p)
{
    int total = -2;

    for (int n = 0; n < p->to; n++)
        total += is_shown(t, p, n) ? t->width[n] + 2 : 0;
    return total;
}

/* Prints one line of cells. Blanks are printed only before something, none at the end. */
static void print_cells(const struct dataset *t, const struct part *p, int row, FILE *file)
{
    static const char *const none[128] = {NULL};
    int pending = 0, column = 0;

    for (int n = 0; n < p->to; n++) {
        if (!is_shown(t, p, n))
            continue;
        const char *cell = text_at(t, row, n);
        int blanks = t->width[n] - wrap_width(cell);

        pending += t->numeric[n] ? blanks : 0;
        if (*cell) {
            column += fprintf(file, "%*s", pending, "");
            if (column + wrap_width(cell) > WRAP_LINE)
                wrap_words(cell, column, WRAP_LINE, file);
            else
                print_escaped("", cell, "", none, file);
            column += wrap_width(cell);
            pending = 0;
        }
        pending += (t->numeric[n] ? 0 : blanks) + 2;
    }
    fputc('\n', file);
}

static void print_rule(const struct dataset *t, const struct part *p, FILE *file)
{
    const int total = part_width(t, p);

    for (int n = 0; n < total && n < WRAP_LINE; n++)
        fputc('-', file);
    fputc('\n', file);
}

static void print_part(const struct dataset *t, const struct part *p, FILE *file)
{
    bool units = false;

    for (int n = 0; n < p->to; n++)
        units = units || (is_shown(t, p, n) && t->columns[n].unit);
    print_cells(t, p, TABLE_HEADERS, file);
    if (units)
        print_cells(t, p, TABLE_UNITS, file);
    print_rule(t, p, file);
    for (int row = 0; row < t->row_count; row++) {
        if (row && t->rows[row]->ruled)
            print_rule(t, p, file);
        print_cells(t, p, row, file);
    }
}

static bool same_keys(const struct dataset *t, int keys, int row, int other)
{
    for (int n = 0; n < keys; n++)
        if (has(t, n, DATASET_PEOPLE) &&
            strcmp(text_at(t, row, n), text_at(t, other, n)) != 0)
            return false;
    return true;
}

/* Returns how many of the first columns distinguish all rows; if none do within half a
 * line, how many hold names. */
static int key_columns(const struct dataset *t)
{
    struct part p = {.to = 0};

    while (++p.to < t->column_count && part_width(t, &p) <= WRAP_LINE / 2) {
        bool distinct = true;
        for (int row = 0; row < t->row_count && distinct; row++)
            for (int other = 0; other < row && distinct; other++)
                distinct = !same_keys(t, p.to, row, other);
        if (distinct && part_width(t, &p) > 0)
            return p.to;
    }
    for (p.to = 1; p.to < t->column_count && !t->numeric[p.to];)
        p.to++;
    return part_width(t, &p) <= WRAP_LINE / 2 ? p.to : 1;
}

/* Takes the columns that a line has room for, one at least; a long one of words, wrapped,
 * is the last. */
static void fill_part(const struct dataset *t, struct part *p)
{
    bool wrapped = false, begins = true;

    for (p->to = p->from; p->to < t->column_count; p->to++) {
        struct part more = {p->keys, p->from, p->to + 1};
        const int over = part_width(t, &more) - WRAP_LINE, width = t->width[p->to];
        if (!has(t, p->to, DATASET_PEOPLE))
            continue;
        if (wrapped ||
            (over > 0 && !begins && (t->numeric[p->to] || width - over < CELL_WIDTH)))
            return;
        wrapped = over > 0;
        begins = false;
    }
}

static void print_text(const struct dataset *t, FILE *file)
{
    struct part p = {0, 0, t->column_count};

    if (t->caption) {
        wrap_print(t->caption, file);
        fputc('\n', file);
    }
    if (part_width(t, &p) > WRAP_LINE)
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
        wrap_print(t->notes[n], file);
    }
}

/* --- Markdown ------------------------------------------------------------------------- */

static void print_markdown(const struct dataset *t, FILE *file)
{
    static const char *const escaped[128] = {
        ['|'] = "\\|", ['*'] = "\\*", ['_'] = "\\_", ['\n'] = " "};
    static const struct table_line line = {DATASET_PEOPLE, "| ",        " | ",
                                           " |\n",         print_shown, escaped};

    if (t->caption)
        fprintf(file, "**%s**\n\n", t->caption);
    print_line(t, &line, TABLE_HEADERS, file);
    for (int n = 0; n < t->column_count; n++)
        if (has(t, n, DATASET_PEOPLE))
            fputs(t->numeric[n] ? "|---:" : "|:---", file);
    fputs("|\n", file);
    for (int row = 0; row < t->row_count; row++)
        print_line(t, &line, row, file);
    for (int n = 0; n < t->note_count; n++)
        fprintf(file, "\n%s\n", t->notes[n]);
}

/* --- LaTeX: plain tabular, no packages ------------------------------------------------ */

static void print_latex(const struct dataset *t, FILE *file)
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
    static const struct table_line line = {DATASET_PEOPLE, "",          " & ",
                                           " \\\\\n",      print_shown, escaped};

    fputs("\\begin{table}\n\\centering\n", file);
    if (t->caption)
        print_escaped("\\caption{", t->caption, "}\n", escaped, file);
    fputs("\\begin{tabular}{", file);
    for (int n = 0; n < t->column_count; n++)
        if (has(t, n, DATASET_PEOPLE))
            fputc(t->numeric[n] ? 'r' : 'l', file);
    fputs("}\n\\hline\n", file);
    print_line(t, &line, TABLE_HEADERS, file);
    fputs("\\hline\n", file);
    for (int row = 0; row < t->row_count; row++) {
        fputs(row && t->rows[row]->ruled ? "\\hline\n" : "", file);
        print_line(t, &line, row, file);
    }
    fputs("\\hline\n\\end{tabular}\n", file);
    for (int n = 0; n < t->note_count; n++)
        print_escaped("\n\\smallskip\\footnotesize ", t->notes[n], "\n", escaped, file);
    fputs("\\end{table}\n", file);
}

enum status table_print(const struct dataset *t, enum table_format format, FILE *file)
{
#define PRINT(code, word) print_##word,
    static void (*const print[])(const struct dataset *, FILE *) = {TABLE_FORMATS(PRINT)};

    print[format](t, file);
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}
