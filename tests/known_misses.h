/* known_misses.h - the rows of a check that failed against the list of those that are known
 * to: both must name the same, so that neither a new miss nor a miss that is none any more
 * goes unseen. */
#ifndef KNOWN_MISSES_H
#define KNOWN_MISSES_H

#include "bench/verify/verify_check.h"
#include "tests/check.h"

/* A line of the list: check | row | model | why; # begins a remark. */
enum { KNOWN_CHECK, KNOWN_ROW, KNOWN_MODEL, KNOWN_WHY, KNOWN_CELLS };

/* Cuts the line at its bars; false if it is none of the list. */
static inline bool known_misses_cut(char *line, char *cell[KNOWN_CELLS])
{
    int count = 0;

    line[strcspn(line, "\n")] = '\0';
    for (char *bar; (bar = strstr(line, " | ")) && count < KNOWN_CELLS - 1; line = bar + 3)
        *bar = '\0', cell[count++] = line;
    cell[count++] = line;
    return count == KNOWN_CELLS && *line;
}

/* Marks the row that a line names; how often the line is wrong: 0 or 1. A row that --quick
 * leaves out is nobody's fault. */
static inline int known_misses_mark(const struct verify_sheet *sheet,
                                    char *const cell[KNOWN_CELLS], bool quick, bool *marked)
{
    for (int n = 0; n < sheet->count; n++) {
        const struct verify_row *row = &sheet->rows[n];
        if (strcmp(row->quantity, cell[KNOWN_ROW]) ||
            strcmp(row->subject, cell[KNOWN_MODEL]))
            continue;
        marked[n] = true;
        if (verify_row_failed(row))
            return 0;
        printf("known as missed, but %s: %s | %s\n", verdict_word(row->verdict),
               row->quantity, row->subject);
        return 1;
    }
    if (!quick)
        printf("known as missed, but there is none: %s | %s\n", cell[KNOWN_ROW],
               cell[KNOWN_MODEL]);
    return !quick;
}

/* What is wrong with the rows of a check, or with the list; printed, too. */
static inline int known_misses_wrong(const struct verify_sheet *sheet, const char *check,
                                     FILE *list, bool quick)
{
    bool *marked = calloc((size_t)sheet->count + 1, sizeof *marked);
    char line[1024], *cell[KNOWN_CELLS];
    int wrong = 0;

    REQUIRE(marked);
    while (fgets(line, sizeof line, list)) {
        if (*line == '#' || *line == '\n')
            continue;
        if (!known_misses_cut(line, cell)) {
            printf("not a line of the list: %s\n", line);
            wrong++;
        } else if (!strcmp(cell[KNOWN_CHECK], check))
            wrong += known_misses_mark(sheet, cell, quick, marked);
    }
    for (int n = 0; n < sheet->count; n++)
        if (verify_row_failed(&sheet->rows[n]) && !marked[n]) {
            printf("%s, and not known: %s | %s | %s | error %.2g\n",
                   verdict_word(sheet->rows[n].verdict), check, sheet->rows[n].quantity,
                   sheet->rows[n].subject, sheet->rows[n].error);
            wrong++;
        }
    free(marked);
    return wrong;
}

#endif
