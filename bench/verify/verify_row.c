#include "bench/verify/verify_sheet.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

const char *verify_verdict_name(int verdict)
{
    static const char *const words[] = {
#define VERIFY_WORD(code, word) word,
        VERIFY_VERDICT_LIST(VERIFY_WORD)
#undef VERIFY_WORD
    };

    return verdict >= 0 && verdict < VERIFY_VERDICTS ? words[verdict] : "unknown";
}

/* Whether `word` is one of a list divided by commas. */
static bool listed(const char *list, const char *word)
{
    const size_t length = strlen(word);

    for (const char *at = list; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
        if (!strncmp(at, word, length) && (at[length] == ',' || !at[length]))
            return true;
    return false;
}

bool verify_wanted(const struct verify_sheet *sheet, const struct verify_subject *subject)
{
    return !sheet->models || !strcmp(sheet->models, "all") ||
           listed(sheet->models, subject->model);
}

bool verify_quick(const struct verify_sheet *sheet)
{
    return sheet->quick;
}

/* A place for one more row. */
static struct verify_row *grow(struct verify_sheet *sheet)
{
    if (sheet->count == sheet->room) {
        int room = sheet->room ? 2 * sheet->room : 32;
        struct verify_row *rows = realloc(sheet->rows, (size_t)room * sizeof *rows);
        if (!rows) {
            sheet->failed = true;
            return &sheet->spare;
        }
        sheet->rows = rows;
        sheet->room = room;
    }
    return &sheet->rows[sheet->count++];
}

struct verify_row *verify_add(struct verify_sheet *sheet,
                              const struct verify_subject *subject, const char *quantity,
                              ...)
{
    struct verify_row *row = grow(sheet);
    va_list arguments;

    *row = (struct verify_row){.value = NAN,
                               .truth = NAN,
                               .bar = NAN,
                               .error = NAN,
                               .order = NAN,
                               .tolerance = subject->tolerance,
                               .verdict = VERIFY_NOT_APPLICABLE};
    va_start(arguments, quantity);
    vsnprintf(row->quantity, sizeof row->quantity, quantity, arguments);
    va_end(arguments);
    snprintf(row->subject, sizeof row->subject, "%s", subject->title);
    if (subject->reason)
        verify_note(row, "%s", subject->reason);
    return row;
}

void verify_judge_error(struct verify_row *row, double error, double bar)
{
    row->error = error;
    row->bar = bar;
    if (isnan(row->tolerance))
        row->verdict = VERIFY_NO_CLAIM;
    else /* written so that an error that is no number misses */
        row->verdict = error <= row->tolerance + bar ? VERIFY_MET : VERIFY_MISSED;
}

void verify_judge(struct verify_row *row, double value, double truth, double bar)
{
    row->value = value;
    row->truth = truth;
    verify_judge_error(row, fabs(value - truth) / fabs(truth), bar);
}

static void add_note(struct verify_row *row, const char *note, va_list arguments)
{
    size_t used = strlen(row->note);

    if (used && used < sizeof row->note)
        used += (size_t)snprintf(row->note + used, sizeof row->note - used, "; ");
    if (used < sizeof row->note)
        vsnprintf(row->note + used, sizeof row->note - used, note, arguments);
}

void verify_note(struct verify_row *row, const char *note, ...)
{
    va_list arguments;

    va_start(arguments, note);
    add_note(row, note, arguments);
    va_end(arguments);
}

void verify_out_of_range(struct verify_row *row, const char *note, ...)
{
    va_list arguments;

    row->verdict = VERIFY_OUT_OF_RANGE;
    va_start(arguments, note);
    add_note(row, note, arguments);
    va_end(arguments);
}

void verify_not_applicable(struct verify_row *row, const char *note, ...)
{
    va_list arguments;

    row->verdict = VERIFY_NOT_APPLICABLE;
    va_start(arguments, note);
    add_note(row, note, arguments);
    va_end(arguments);
}

void verify_died(struct verify_row *row, const char *note, ...)
{
    va_list arguments;

    row->verdict = VERIFY_DIED;
    va_start(arguments, note);
    add_note(row, note, arguments);
    va_end(arguments);
}

bool verify_failed(const struct verify_row *row)
{
    return row->verdict == VERIFY_MISSED ||
           (row->verdict == VERIFY_DIED && !isnan(row->tolerance));
}
