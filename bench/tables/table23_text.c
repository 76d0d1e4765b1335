/* What a reader should take away from Tables 2 and 3, each sentence from the numbers. Where
 * a number is missing, or a quick run ended too early for it, nothing is concluded. */
#include <math.h>

#include "bench/tables/table23.h"
#include "bench/truth/paper.h"

enum { FIRST = TABLE23_GROWTH, LAST = FIRST + TABLE23_GROWTH_ROWS - 1 };

/* Milliseconds, or exponents, that differ by less are said to be the same. */
static const double NEAR = 0.1;

struct range {
    double low, high;
};

static void widen(struct range *r, double value)
{
    r->low = fmin(r->low, value); /* a NaN is left out */
    r->high = fmax(r->high, value);
}

/* How much more of a quantity one row has than another. */
static double over(const struct table23 *d, int row, int other, enum table23_quantity q)
{
    return table23_value(d, row, q) / table23_value(d, other, q);
}

/* Of the rows that differ in their net alone, from `first` on. */
static double exponent(const struct table23 *d, int first, enum table23_quantity q)
{
    return table23_exponent(d, first, LAST - first + 1, q);
}

/* What contact costs by a kinematics, over the flag on the same net. */
static double contact_ratio(const struct table23 *d, enum table23_kind kind)
{
    return over(d, TABLE23_CONTACT, TABLE23_FLAG, TABLE23_PRINTED_MS + kind);
}

static void headline_second(const struct table23 *d, FILE *file)
{
    const double growth = exponent(d, FIRST, TABLE23_PRINTED_MS);
    char frame[64] = "was not timed", contact[64] = "was not measured";

    if (isfinite(growth))
        snprintf(frame, sizeof frame, "grows as (control points)^%.2f", growth);
    if (table23_quick(d, TABLE23_CONTACT))
        snprintf(contact, sizeof contact, "is not judged: quick");
    else if (isfinite(contact_ratio(d, TABLE23_PRINTED)))
        snprintf(contact, sizeof contact, "costs %.2f times the flag, the paper's %.2f",
                 contact_ratio(d, TABLE23_PRINTED),
                 over(d, TABLE23_CONTACT, TABLE23_FLAG, TABLE23_PAPER_MS));
    table_say(file,
              "Table 2: a rebuilt frame %s, the paper's as ^%.2f; contact with the ground "
              "%s.\n",
              frame, exponent(d, FIRST, TABLE23_PAPER_MS), contact);
}

static void headline_third(const struct table23 *d, FILE *file)
{
    const double first = over(d, 2, 0, TABLE23_PRINTED_MS);
    const double second = over(d, 3, 1, TABLE23_PRINTED_MS);
    char words[64] = "was not timed";

    if (isfinite(first + second))
        snprintf(words, sizeof words, "costs %.2f and %.2f times (1,2,2) on the two nets",
                 first, second);
    table_say(file, "Table 3: degree (1,3,3) %s; the paper's %.2f and %.2f.\n", words,
              over(d, 2, 0, TABLE23_PAPER_MS), over(d, 3, 1, TABLE23_PAPER_MS));
}

void table23_headline(const struct table23 *d, FILE *file)
{
    if (d->second)
        headline_second(d, file);
    else
        headline_third(d, file);
}

static void tell_machine(const struct table23 *d, FILE *file)
{
    struct range ratio = {INFINITY, 0};

    for (int n = 0; n < d->r->count; n++)
        widen(&ratio, table23_value(d, n, TABLE23_PAPER_MS) /
                          table23_value(d, n, TABLE23_PRINTED_MS));
    if (ratio.high == 0) {
        table_say(file, "- Milliseconds. Not judged: no rebuilt frame was timed.");
        return;
    }
    table_say(
        file,
        "- Milliseconds. The paper's frames take %.3g to %.3g times ours. That number "
        "is a machine (an i7-7700 of 2017, assembly on its 4 cores; one thread here), "
        "a compiler, a linear algebra library and a code in one, and nothing in the "
        "paper separates them. Ratios between rows are free of the machine's speed: "
        "only they are compared below.",
        ratio.low, ratio.high);
}

/* Per cent of a rebuilt frame's three phases. */
static double share(const struct table23 *d, int row, enum table23_quantity phase)
{
    double sum = 0;

    for (int p = TABLE23_ASSEMBLE_MS; p <= TABLE23_SOLVE_MS; p++)
        sum += table23_value(d, row, p);
    return 100 * table23_value(d, row, phase) / sum;
}

static void tell_why(const struct table23 *d, FILE *file)
{
    const double frame = exponent(d, FIRST, TABLE23_PRINTED_MS);
    const double paper = exponent(d, FIRST + 1, TABLE23_PAPER_MS);
    struct range parts = {INFINITY, 0};

    widen(&parts, exponent(d, FIRST, TABLE23_ASSEMBLE_MS));
    widen(&parts, exponent(d, FIRST, TABLE23_FACTOR_MS));
    table_say(
        file,
        "- Why. A frame is K and M, which cost a fixed sum an element (elements grow "
        "as ^%.2f here), and the factor, whose multiplications grow as ^%.2f (2 for a "
        "band in the limit). K and M are %.0f %% of the work at 5x5 and %.0f %% at "
        "20x20, the factor %.0f and %.0f %%: a frame's exponent %s between those of "
        "its parts. The paper's %.2f is %s that of a band factorisation alone; where "
        "its frames spend their time it does not say.",
        exponent(d, FIRST, TABLE23_ELEMENTS), exponent(d, FIRST, TABLE23_FACTOR_WORK),
        share(d, FIRST, TABLE23_ASSEMBLE_MS), share(d, LAST, TABLE23_ASSEMBLE_MS),
        share(d, FIRST, TABLE23_FACTOR_MS), share(d, LAST, TABLE23_FACTOR_MS),
        parts.low <= frame && frame <= parts.high ? "lies" : "does not lie", paper,
        fabs(paper - 2) < NEAR ? "near" : "not");
}

static void tell_prefactored(const struct table23 *d, FILE *file)
{
    const double gain = table23_value(d, LAST, TABLE23_PRINTED_MS) /
                        table23_value(d, LAST, TABLE23_PREFACTORED_MS);

    if (gain > 1)
        table_say(
            file,
            "- Prefactored. One factorisation for all frames makes a frame %.0f times "
            "cheaper at 20x20 than a rebuilt one; the paper's scheme rebuilds because "
            "its matrices follow the sheet.",
            gain);
    else
        table_say(
            file,
            "- Prefactored. One factorisation for all frames makes a frame no cheaper "
            "at 20x20 than a rebuilt one, %.2f times.",
            1 / gain);
}

static void tell_growth(const struct table23 *d, FILE *file)
{
    const double frame = exponent(d, FIRST, TABLE23_PRINTED_MS);
    const double assemble = exponent(d, FIRST, TABLE23_ASSEMBLE_MS);
    const double factor = exponent(d, FIRST, TABLE23_FACTOR_MS);
    const double linear = exponent(d, FIRST, TABLE23_PREFACTORED_MS);

    if (isnan(frame + assemble + factor + linear)) {
        table_say(file, "- Growth. Not judged: not all nets of Fig. 12 were timed.");
        return;
    }
    table_say(
        file,
        "- Growth. The paper's frames grow as (control points)^%.2f over 5, 10, 15 and "
        "20 points a side, ^%.2f over the last three; ours as ^%.2f rebuilt (K and M "
        "alone ^%.2f, factor alone ^%.2f) and ^%.2f prefactored.",
        exponent(d, FIRST, TABLE23_PAPER_MS), exponent(d, FIRST + 1, TABLE23_PAPER_MS),
        frame, assemble, factor, linear);
    tell_why(d, file);
    tell_prefactored(d, file);
}

/* Rows of one net and degree differ in nothing that costs: how far apart are they? */
static void tell_same(const struct table23 *d, FILE *file)
{
    struct range printed = {INFINITY, 0}, ours = {INFINITY, 0};
    const int same[] = {0, 1, TABLE23_GROWTH + 1};
    double all = 0;

    for (int n = 0; n < 3; n++) {
        widen(&printed, table23_value(d, same[n], TABLE23_PAPER_MS));
        widen(&ours, table23_value(d, same[n], TABLE23_PRINTED_MS));
        all += table23_value(d, same[n], TABLE23_PRINTED_MS);
    }
    if (isnan(all)) {
        table_say(file,
                  "- Scatter. Not judged: a row of 10x10x2 and (2,2,1) was not timed.");
        return;
    }
    table_say(
        file,
        "- Scatter. Three rows of Table 2 are one net and degree, 10x10x2 and (2,2,1): "
        "the paper has %.0f to %.0f ms for them (%.0f %% apart), we have %.3g to %.3g "
        "(%.0f %%). Differences below that say nothing.",
        printed.low, printed.high, 100 * (printed.high / printed.low - 1), ours.low,
        ours.high, 100 * (ours.high / ours.low - 1));
}

/* Farther from the ground than any sheet that lies on it [m]. */
static const double CLEAR = 0.05;

static double factors(const struct table23 *d, enum table23_kind kind)
{
    const struct counters *work = &table23_result(d, TABLE23_CONTACT, kind)->work;

    return (double)work->factorisations / (double)work->steps;
}

/* What is said of ours, of `size` characters. */
static void contact_words(const struct table23 *d, char *words, size_t size)
{
    const struct run_result *printed = table23_result(d, TABLE23_CONTACT, TABLE23_PRINTED);
    const double gap = table23_gap(d, TABLE23_CONTACT);
    const double ratio = contact_ratio(d, TABLE23_PRINTED);
    char lowest[128] = "";

    if (isfinite(gap))
        snprintf(lowest, sizeof lowest,
                 "; after %ld frames its lowest point is %.2g m above the ground%s",
                 printed->work.steps, gap,
                 gap > CLEAR ? ": the scheme has thrown it up again" : "");
    if (table23_quick(d, TABLE23_CONTACT))
        snprintf(words, size, "Here it is not judged: quick, the run ends as it lands.");
    else if (isnan(ratio))
        snprintf(words, size, "Here it was not run, for the reason noted above.");
    else if (printed->work.steps)
        snprintf(words, size,
                 "Here it costs %.2f times the flag, fall and landing together, at %.2f "
                 "factorisations a frame%s.",
                 ratio, factors(d, TABLE23_PRINTED), lowest);
    else
        snprintf(
            words, size,
            "Here it costs %.2f times the flag, fall and landing together, up to the "
            "death noted above: the printed scheme throws it up again (study contact). "
            "Incremental kinematics: %.2f times, at %.2f factorisations a frame.",
            ratio, contact_ratio(d, TABLE23_INCREMENTAL), factors(d, TABLE23_INCREMENTAL));
}

static void tell_contact(const struct table23 *d, FILE *file)
{
    const double paper = over(d, TABLE23_CONTACT, TABLE23_FLAG, TABLE23_PAPER_MS);
    char words[512];

    contact_words(d, words, sizeof words);
    table_say(
        file,
        "- Contact. In the paper the sheet on the ground costs %.2f times the flag on "
        "the same net%s. %s",
        paper, fabs(paper - 1) < NEAR ? ": contact costs nothing there" : "", words);
}

static void tell_degree(const struct table23 *d, int low, FILE *file)
{
    const int high = low + 2, side = table23_net(d, low)->points[0];
    const double paper = over(d, high, low, TABLE23_PAPER_MS);
    const double ours = over(d, high, low, TABLE23_PRINTED_MS);
    const double assembly = over(d, high, low, TABLE23_ASSEMBLY_WORK);
    const double factor = over(d, high, low, TABLE23_FACTOR_WORK);

    if (isnan(ours + factor)) {
        table_say(file, "- Degree, 2x%dx%d. Not judged: one of the two was not timed.",
                  side, side);
        return;
    }
    table_say(
        file,
        "- Degree, 2x%dx%d. From (1,2,2) to (1,3,3) the paper's frame costs %.2f times "
        "as much, ours %.2f times. Plain quadrature has %.2f times the "
        "multiplications, a band factor %.2f times: the paper's %.2f is %s.",
        side, side, paper, ours, assembly, factor, paper,
        paper < fmin(assembly, factor)
            ? "below both, so that a good part of its frame does not depend on the "
              "degree"
        : paper <= fmax(assembly, factor) ? "between the two"
                                          : "more than either");
}

/* Table 3 against Table 2, both the paper's. */
static void tell_consistency(const struct table23 *d, FILE *file)
{
    const double second[] = {paper_table2_ms[TABLE23_GROWTH + 1],
                             paper_table2_ms[TABLE23_GROWTH + 2],
                             paper_table2_ms[TABLE23_GROWTH + 4]};
    double third[4], apart = 0;

    for (int n = 0; n < 4; n++)
        third[n] = table23_value(d, n, TABLE23_PAPER_MS);
    for (int n = 0; n < 3; n++)
        apart = fmax(apart, fabs(third[n] / second[n] - 1));
    table_say(file,
              "- Consistency. Table 3 has %.0f, %.0f and %.0f ms where Table 2 has %.0f, "
              "%.0f and %.0f for the same net and degree with the thickness in w: %s %.1f "
              "%%. Only %.0f ms is new.",
              third[0], third[1], third[2], second[0], second[1], second[2],
              apart < NEAR ? "one measurement told twice, or two that agree to"
                           : "two measurements that differ by",
              100 * apart, third[3]);
}

static void tell_growths(const struct table23 *d, FILE *file)
{
    static const enum table23_quantity of[] = {TABLE23_PRINTED_MS, TABLE23_ASSEMBLE_MS,
                                               TABLE23_FACTOR_MS};
    double e[3][2], all = 0;

    for (int q = 0; q < 3; q++)
        for (int p = 0; p < 2; p++)
            all += e[q][p] = table23_exponent(d, 2 * p, 2, of[q]);
    if (isnan(all)) {
        table_say(file, "- Growth. Not judged: not all rows were timed.");
        return;
    }
    table_say(
        file,
        "- Growth. From 200 to 450 control points the paper's frames grow as ^%.2f at "
        "(1,2,2) and ^%.2f at (1,3,3), ours as ^%.2f and ^%.2f (K and M alone ^%.2f "
        "and ^%.2f, factor alone ^%.2f and ^%.2f).",
        table23_exponent(d, 0, 2, TABLE23_PAPER_MS),
        table23_exponent(d, 2, 2, TABLE23_PAPER_MS), e[0][0], e[0][1], e[1][0], e[1][1],
        e[2][0], e[2][1]);
}

void table23_text(const struct table23 *d, FILE *file)
{
    table_say(file, "What was reproduced, and what not\n");
    tell_machine(d, file);
    if (d->second) {
        tell_growth(d, file);
        tell_same(d, file);
        tell_contact(d, file);
    } else {
        tell_consistency(d, file);
        tell_growths(d, file);
        for (int low = 0; low < 2; low++)
            tell_degree(d, low, file);
    }
    fputc('\n', file);
}
