#include "bench/verify/verify_row.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
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

void verify_row_judge_error(struct verify_row *row, double error, double bar)
{
    row->error = error;
    row->bar = bar;
    if (isnan(row->tolerance))
        row->verdict = VERIFY_NO_CLAIM;
    else /* written so that an error that is no number misses */
        row->verdict = error <= row->tolerance + bar ? VERIFY_MET : VERIFY_MISSED;
}

void verify_row_judge(struct verify_row *row, double value, double truth, double bar)
{
    row->value = value;
    row->truth = truth;
    verify_row_judge_error(row, fabs(value - truth) / fabs(truth), bar);
}

double verify_row_worse(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

static void add_note(struct verify_row *row, const char *note, va_list arguments)
{
    size_t used = strlen(row->note);

    if (used && used < sizeof row->note)
        used += (size_t)snprintf(row->note + used, sizeof row->note - used, "; ");
    if (used < sizeof row->note)
        vsnprintf(row->note + used, sizeof row->note - used, note, arguments);
}

void verify_row_note(struct verify_row *row, const char *note, ...)
{
    va_list arguments;

    va_start(arguments, note);
    add_note(row, note, arguments);
    va_end(arguments);
}

void verify_row_end(struct verify_row *row, enum verify_verdict verdict, const char *note,
                    ...)
{
    va_list arguments;

    row->verdict = verdict;
    va_start(arguments, note);
    add_note(row, note, arguments);
    va_end(arguments);
}

bool verify_row_claims(const struct verify_row *row)
{
    return row->verdict == VERIFY_MET || row->verdict == VERIFY_MISSED ||
           (row->verdict == VERIFY_DIED && !isnan(row->tolerance));
}

bool verify_row_failed(const struct verify_row *row)
{
    return verify_row_claims(row) && row->verdict != VERIFY_MET;
}
