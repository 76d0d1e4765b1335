#include "bench/experiment/judge.h"

#include <math.h>

#include "bench/data/printer.h"

double judge_most(double a, double b)
{
    return isnan(a) || isnan(b) ? NAN : fmax(a, b);
}

enum verdict judge_order(int count, const double *value, int sign, double bar)
{
    enum verdict turn = count > 1 ? VERDICT_HOLDS : VERDICT_OPEN;
    double before = NAN;

    for (int n = 0; n < count; n++) {
        const double step = sign * (value[n] - before);
        if (step < -bar || (step <= 0 && bar == 0))
            return VERDICT_FAILS;
        if (isnan(value[n]) || (n > 0 && !(step > bar)))
            turn = VERDICT_OPEN;
        before = isnan(value[n]) ? before : value[n];
    }
    return turn;
}

enum verdict judge_below(double value, double bound)
{
    return isnan(value) || isnan(bound) ? VERDICT_OPEN
           : value < bound              ? VERDICT_HOLDS
                                        : VERDICT_FAILS;
}

enum verdict judge_ratio(double ours, double paper)
{
    static const double ALIKE = 0.1, FACTOR = 2;
    const bool alike = fabs(paper - 1) <= ALIKE;

    if (!(ours > 0) || isnan(paper))
        return VERDICT_OPEN;
    return (alike || (ours > 1) == (paper > 1)) && ours <= FACTOR * paper &&
                   ours >= paper / FACTOR
               ? VERDICT_HOLDS
               : VERDICT_FAILS;
}

enum verdict judge_exponent(double ours, double paper)
{
    static const double BAR = 0.25;

    return isnan(ours) || isnan(paper) ? VERDICT_OPEN
           : fabs(ours - paper) <= BAR ? VERDICT_HOLDS
                                       : VERDICT_FAILS;
}

enum verdict judge_both(enum verdict a, enum verdict b)
{
    return a == VERDICT_FAILS || b == VERDICT_FAILS ? VERDICT_FAILS
           : a == VERDICT_HOLDS                     ? b
                                                    : a;
}

struct dataset *judge_table(const char *caption)
{
    static const struct dataset_column columns[] = {
        {"source"}, {"claim"}, {"reading"}, {"verdict"}, {"sentence"}, {"turns"}, {"ours"}};

    return DATASET_OF(columns, caption);
}

void judge_add(struct dataset *rows, const struct judge_told *told)
{
    dataset_row(rows);
    for (int n = 0; n < 7; n++)
        dataset_text(rows, "%s",
                     (const char *const[]){told->source, told->quote, told->reading,
                                           verdict_word(told->turn), told->here,
                                           told->turns, told->ours}[n]);
}

void judge_print(FILE *file, const struct judge_told *told)
{
    char text[4096];

    snprintf(text, sizeof text, "- %s%s%s: %s. %s%s%s%s%s%s%s\n", told->source,
             *told->source ? ": " : "", told->quote, verdict_word(told->turn), told->here,
             *told->turns ? " " : "", told->turns, *told->ours ? " " : "", told->ours,
             *told->reading ? " Reading: " : "", told->reading);
    wrap_print(text, file);
}
