/* What a reader should take away from Table 4, each sentence from the numbers. */
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "bench/tables/table4.h"

enum { PRINTED = TABLE4_PRINTED, FLAG = TABLE4_FLAG, DROP = TABLE4_DROP };
enum { ROWS = PAPER_TABLE4_ROWS, WORDS = 512 };

/* rms speed of a sheet of 1 m whose weight has fallen by L/2, sqrt(g L) [m/s]. */
static const double FREE_FALL = 3.132;

/* Words behind a text; cut where they do not fit. */
__attribute__((format(printf, 2, 3))) static void add(char text[WORDS], const char *format,
                                                      ...)
{
    const size_t used = strlen(text);
    va_list args;

    va_start(args, format);
    vsnprintf(text + used, WORDS - used, format, args);
    va_end(args);
}

/* The least and the largest of the rows' numbers that exist; how many do. */
struct span {
    double low, high;
    int count;
};
static struct span span_of(const struct table4_data *d, int reading, int scene, int measure)
{
    struct span span = {INFINITY, 0, 0};
    double value[ROWS];

    table4_column(d, reading, scene, measure, value);
    for (int row = 0; row < ROWS; row++)
        if (isfinite(value[row])) {
            span.low = fmin(span.low, value[row]);
            span.high = fmax(span.high, value[row]);
            span.count++;
        }
    return span;
}

/* Rows that two bounds on a measure of the printed scheme get right at best. */
static struct table4_interval best(const struct table4_data *d, int measure, int label)
{
    double value[ROWS];
    bool yes[ROWS];

    table4_column(d, PRINTED, FLAG, measure, value);
    table4_paper(label, yes);
    return table4_best(ROWS, value, yes, TABLE4_ANY);
}

/* Of a reading's rows on a scene, those that are called so. */
static int called(const struct table4_data *d, int reading, int scene, int label)
{
    const struct table4_agreement a = table4_agree(d, reading, scene, label);

    return a.hit + a.extra;
}

/* How long the runs are, those that lived [s]. */
static double length(const struct table4_data *d)
{
    return span_of(d, PRINTED, FLAG, MEASURE_END_TIME).high;
}

void table4_headline(const struct table4_data *d, FILE *file)
{
    bool yes[ROWS];
    const int no = ROWS - table4_paper(-1, yes);
    const int flag = table4_agree(d, PRINTED, FLAG, -1).agree;
    const int drop = table4_agree(d, PRINTED, DROP, -1).agree;

    if (d->quick)
        table_say(file, "Table 4: not judged: quick, runs of %.2g s.\n", length(d));
    else
        table_say(file,
                  "Table 4: yes or no as in the paper in %d of 18 rows on flag and %d on "
                  "edge_drop%s `no` to all, %d; over-stretched are %d and %d, the paper's "
                  "%d.\n",
                  flag, drop,
                  flag > no && drop > no ? ", more than by" : ", no more than by", no,
                  called(d, PRINTED, FLAG, PAPER_OVER_STRETCHED),
                  called(d, PRINTED, DROP, PAPER_OVER_STRETCHED),
                  table4_paper(PAPER_OVER_STRETCHED, yes));
}

static void tell_yes_or_no(const struct table4_data *d, struct table *t)
{
    const struct table4_interval ratio = best(d, MEASURE_YOUNG_OVER_DENSITY, -1);
    bool yes[ROWS];

    table_note(
        t,
        "Yes or no: the printed scheme is judged as the paper judges it in %d of 18 rows "
        "on flag and %d on edge_drop. That is weak evidence for anything: `no` to every "
        "row is right in %d, and any number that grows with E/rho, whatever it is, in %d, "
        "with two bounds chosen in hindsight (%.3g to %.3g m^2/s^2)%s.",
        table4_agree(d, PRINTED, FLAG, -1).agree, table4_agree(d, PRINTED, DROP, -1).agree,
        ROWS - table4_paper(-1, yes), ratio.agree, ratio.low, ratio.high,
        ratio.agree == ROWS
            ? ". The paper's yes or no is a function of E/rho, and mu plays no part in it"
            : "");
}

static void tell_one_number(const struct table4_data *d, struct table *t)
{
    const int *row = table4_scaled;
    int same = 0;

    for (int n = 0; n < TABLE4_SCALED; n++)
        same += !run_result_refused(&d->scaled[n]) &&
                !memcmp(d->scaled[n].value, d->run[PRINTED][FLAG][row[n]].result.value,
                        sizeof d->scaled[n].value);
    table_note(t,
               "E and rho are one parameter: gravity is the only load, and so rho divides "
               "out of the printed scheme. Rows %d, %d and %d with four times the E and "
               "four times the rho gave the same numbers to %.2g s, bit for bit, in %d of "
               "%d runs%s.",
               row[0] + 1, row[1] + 1, row[2] + 1, length(d), same, TABLE4_SCALED,
               same == TABLE4_SCALED ? ": the motion depends on E/rho and mu alone" : "");
}

/* Whether anybody looked for crossings: a time that did not come is infinite, not NaN. */
static bool looked(const struct table4_data *d)
{
    bool all = true;

    for (int s = 0; s < TABLE4_SCENES; s++)
        for (int row = 0; row < ROWS; row++)
            all = all &&
                  !isnan(d->run[PRINTED][s][row].result.value[MEASURE_INTERSECTION_TIME]);
    return all;
}

static void tell_crossings(const struct table4_data *d, struct table *t)
{
    char words[WORDS] = "";
    bool blind = true, met = false, yes[ROWS];
    const int no = ROWS - table4_paper(PAPER_PENETRATION, yes);

    if (!looked(d)) {
        table_note(t, "Penetration: not judged: the runs were not searched for crossings.");
        return;
    }
    for (int s = 0; s < TABLE4_SCENES; s++) {
        const struct span at = span_of(d, PRINTED, s, MEASURE_INTERSECTION_TIME);
        const int agree = table4_agree(d, PRINTED, s, PAPER_PENETRATION).agree;
        add(words, "%s%d of 18 rows on %s", s ? " and in " : "", at.count, table4_scene[s]);
        if (at.count > 1)
            add(words, " (first at %.3g to %.3g s)", at.low, at.high);
        else if (at.count)
            add(words, " (at %.3g s)", at.low);
        /* no better than `no` to all */
        blind = blind && agree <= no;
        met = met || agree == ROWS;
    }
    table_note(t, "Penetration: the printed sheet passes through itself in %s. %s.", words,
               met ? "These are the paper's rows on one of the scenes"
               : blind
                   ? "That does not tell the paper's rows from the others, on either scene"
                   : "That meets the paper's rows in part");
    table_note(t,
               "How early it does so: the best bound on the time of the first crossing on "
               "flag, chosen in hindsight, gets %d of 18 rows right, `no` to all %d.",
               best(d, MEASURE_INTERSECTION_TIME, PAPER_PENETRATION).agree, no);
}

static void tell_deaths(const struct table4_data *d, struct table *t)
{
    char words[WORDS] = "";
    int fast = 0;

    for (int s = 0; s < TABLE4_SCENES; s++) {
        int count = 0;
        add(words, "%s on %s ", s ? ";" : "", table4_scene[s]);
        for (int row = 0; row < ROWS; row++) {
            const struct run_result *r = &d->run[PRINTED][s][row].result;
            if (status_is_death(r->outcome))
                add(words, "%srow %d at %.3g s", count++ ? ", " : "", row + 1,
                    r->death_time);
            fast += s == DROP && r->value[MEASURE_SPEED_MAX] > FREE_FALL;
        }
        add(words, "%s", count ? "" : "none");
    }
    table_note(
        t,
        "Chaos: blow-ups of the printed scheme:%s. The paper calls row 7 chaotic. On "
        "edge_drop %d rows move faster than the sheet could by falling: under v <- mu v "
        "the scheme falls with g (1 + mu) / 2 (1 - mu), which is 9.5 g at mu = 0.9.",
        words, fast);
}

/* The row with the largest Gamma: of the softest, heaviest sheet. */
enum { SOFT = 3 };

/* 5e4: the least Gamma of the fabrics that the plan's thresholds are from. */
static void tell_stiffness(const struct table4_data *d, struct table *t)
{
    const double fabric = 5e4;
    const struct span gamma = span_of(d, PRINTED, FLAG, MEASURE_GAMMA);

    const double shell = d->run[TABLE4_SHELL][FLAG][SOFT].result.value[MEASURE_ANGLE_MAX];
    const double printed = d->run[PRINTED][FLAG][SOFT].result.value[MEASURE_ANGLE_MAX];

    if (!gamma.count || isnan(shell + printed)) {
        table_note(t, "Boards or cloth: not judged: row %d was not run.", SOFT + 1);
        return;
    }
    table_note(
        t,
        "%s: Gamma, weight against bending, is %.3g to %.3g in these rows and %.0e or "
        "more in measured fabrics of 1 m. The undamped shell, an elastic sheet with "
        "these numbers, sinks with its middle line by %.2g degrees at most on flag in "
        "row %d, the printed one's by %.3g%s.",
        gamma.high < fabric ? "Boards, not cloth" : "Boards and cloth", gamma.low,
        gamma.high, fabric, shell, SOFT + 1, printed,
        shell < printed ? ": the printed scheme has no elastic memory, and flows" : "");
}

/* Whose failure a label is, from the rows that have it; `lawful`: at most, in a reading and
 * scene with a law that holds; `others`: of further schemes. */
static const char *whose(int paper, int printed, int others, int lawful, int lawful_hits)
{
    if (printed == 0 && lawful == 0)
        return others
                   ? "other schemes than the printed one show it, the nonlinear models do "
                     "not: not reproduced"
                   : "nobody shows it by this threshold: not reproduced";
    if (lawful == 0)
        return "the scheme's: neither the nonlinear solid nor the shell shows it in any "
               "row, with the same E, nu, rho and thickness";
    if (lawful == ROWS)
        return "physics, but of no use as a verdict: on one of the scenes the nonlinear "
               "models show it in all 18 rows, the paper's feasible ones among them";
    return lawful_hits == paper
               ? "physics: the nonlinear models show it in all of the paper's rows"
               : "in part physics: the nonlinear models show it in some rows";
}

static void tell_label(const struct table4_data *d, int label, struct table *t)
{
    bool yes[ROWS];
    int printed = 0, others = 0, lawful = 0, hits = 0;
    char words[WORDS] = "";

    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++) {
            const struct table4_agreement a = table4_agree(d, r, s, label);
            const int ours = a.hit + a.extra;
            if (r == PRINTED)
                printed += ours;
            else if (!table4_reading[r].lawful)
                others += ours;
            else {
                lawful = ours > lawful ? ours : lawful;
                hits = a.hit > hits ? a.hit : hits;
            }
        }
    if (label == PAPER_OVER_STRETCHED)
        add(words,
            " A strip that hangs by its end stretches by rho g L / E, %.2g at most in "
            "these rows; the undamped shell's largest stretch, in motion, is %.3f.",
            span_of(d, PRINTED, FLAG, MEASURE_HANGING_STRAIN).high,
            fmax(span_of(d, TABLE4_SHELL, FLAG, MEASURE_STRETCH_MAX).high,
                 span_of(d, TABLE4_SHELL, DROP, MEASURE_STRETCH_MAX).high));
    table_note(t, "%s: %s.%s", paper_label[label],
               whose(table4_paper(label, yes), printed, others, lawful, hits), words);
}

void table4_text(const struct table4_data *d, struct table *t)
{
    if (d->quick) {
        table_note(
            t,
            "Not judged: quick: these runs are of %.2g s, most on coarser nets. What is "
            "said of rows, their labels and the paper's words takes whole ones.",
            length(d));
        tell_one_number(d, t);
        return;
    }
    for (int label = 0; label < PAPER_LABELS; label++)
        tell_label(d, label, t);
    tell_yes_or_no(d, t);
    tell_one_number(d, t);
    tell_crossings(d, t);
    tell_deaths(d, t);
    tell_stiffness(d, t);
}
