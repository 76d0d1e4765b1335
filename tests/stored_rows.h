/* stored_rows.h - the rows of a check against those that are stored: who is judged, by what
 * truth and bar, what is claimed and how it ended must be the same, and the error what it
 * was. So no claim, no truth and no way to measure changes unseen. */
#ifndef STORED_ROWS_H
#define STORED_ROWS_H

#include "bench/verify/verify_sheet.h"
#include "tests/check.h"

/* Errors below are round-off, or what iterations leave, and another machine's are others.
 */
static const double STORED_ROWS_NOISE = 1e-5;

enum { STORED_ROWS_LINE = 1024 };

/* KEY | quantity | model | truth | bar | tolerance | error | order | verdict | note */
static inline void stored_rows_line(const char *key, const struct verify_row *row,
                                    char line[STORED_ROWS_LINE])
{
    snprintf(
        line, STORED_ROWS_LINE, "%s | %s | %s | %.6g | %.2g | %.6g | %.3g | %.2f | %s | %s",
        key, row->quantity, row->subject, row->truth, row->bar, row->tolerance, row->error,
        row->order, verify_verdict_name((int)row->verdict), *row->note ? row->note : "-");
}

static inline bool stored_rows_near(double a, double b, double relative, double absolute)
{
    return (isnan(a) && isnan(b)) || a == b ||
           fabs(a - b) <= fmax(relative * fmax(fabs(a), fabs(b)), absolute);
}

/* The same words, whatever the numbers in them. */
static inline bool stored_rows_words(const char *a, const char *b)
{
    static const char numbers[] = "0123456789.+-";

    for (;; a++, b++) {
        a += strspn(a, numbers);
        b += strspn(b, numbers);
        if (*a != *b || !*a)
            return *a == *b;
    }
}

/* Numbers of a line from `text` on, after the model's cell. An error is `0.004~0.003` where
 * it is so much another one on a CPU that sums in another order. */
static inline bool stored_rows_same(const char *text, const struct verify_row *row)
{
    double truth, bar, tolerance, error, order, noise = STORED_ROWS_NOISE;
    char end[STORED_ROWS_LINE];
    int head = 0, used = 0;

    if (sscanf(text, "%lf | %lf | %lf | %lf%n", &truth, &bar, &tolerance, &error, &head) !=
        4)
        return false;
    text += head;
    if (sscanf(text, "~%lf%n", &noise, &head) == 1)
        text += head;
    if (sscanf(text, " | %lf | %n", &order, &used) != 1 || !used)
        return false;
    snprintf(end, sizeof end, "%s | %s", verify_verdict_name((int)row->verdict), row->note);
    return stored_rows_near(truth, row->truth, 1e-5, 0) &&
           stored_rows_near(bar, row->bar, 0.06, 1e-12) &&
           stored_rows_near(tolerance, row->tolerance, 1e-5, 0) &&
           stored_rows_near(error, row->error, 0.01, noise) &&
           (row->error < 10 * noise || stored_rows_near(order, row->order, 0, 0.1)) &&
           stored_rows_words(text + used, end);
}

/* Rows that differ, or are not there; each is printed as it would be stored. */
static inline int stored_rows_wrong(const struct verify_sheet *sheet, const char *key,
                                    FILE *list)
{
    char line[STORED_ROWS_LINE], names[STORED_ROWS_LINE], now[STORED_ROWS_LINE];
    int n = 0, wrong = 0;

    while (fgets(line, sizeof line, list)) {
        const size_t length = strlen(key);
        if (strncmp(line, key, length) || line[length] != ' ')
            continue;
        line[strcspn(line, "\n")] = '\0';
        if (n == sheet->count) {
            printf("there is no such row now: %s\n", line);
            wrong++;
            continue;
        }
        const struct verify_row *row = &sheet->rows[n++];
        snprintf(names, sizeof names, "%s | %s | %s | ", key, row->quantity, row->subject);
        if (!strncmp(line, names, strlen(names)) &&
            stored_rows_same(line + strlen(names), row))
            continue;
        stored_rows_line(key, row, now);
        printf("was: %s\nrow: %s\n", line, now);
        wrong++;
    }
    for (; n < sheet->count; n++, wrong++) {
        stored_rows_line(key, &sheet->rows[n], now);
        printf("row: %s\n", now);
    }
    return wrong;
}

#endif
