/* What a reader should take away from Table 4, each sentence from the numbers. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "bench/tables/interval.h"
#include "bench/tables/table4.h"

enum { PRINTED = TABLE4_PRINTED, FLAG = TABLE4_FLAG, DROP = TABLE4_DROP };

/* rms speed of a sheet of 1 m whose weight has fallen by L/2, sqrt(g L) [m/s]. */
static const double FREE_FALL = 3.132;

/* Text that grows; cut where it does not fit. */
struct words {
    char text[512];
    size_t used;
};

__attribute__((format(printf, 2, 3))) static void add(struct words *w, const char *format,
                                                      ...)
{
    va_list args;

    va_start(args, format);
    if (w->used < sizeof w->text)
        w->used +=
            (size_t)vsnprintf(w->text + w->used, sizeof w->text - w->used, format, args);
    va_end(args);
}

static void yes_or_no(const struct table4_data *d, struct table *t)
{
    bool yes[PAPER_TABLE4_ROWS];
    double ratio[PAPER_TABLE4_ROWS];
    int feasible = table4_paper(-1, yes);

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        ratio[row] = paper_table4[row].young / paper_table4[row].density;
    struct interval best = interval_best(PAPER_TABLE4_ROWS, ratio, yes, INTERVAL_ANY);
    table_note(
        t,
        "Yes or no: the printed scheme is judged as the paper judges it in %d of 18 "
        "rows on flag and %d on edge_drop. That is weak evidence for anything: `no` "
        "to every row is right in %d, and any number that grows with E/rho, whatever "
        "it is, in %d, with two bounds chosen in hindsight (%.3g to %.3g m^2/s^2)%s.",
        table4_agree(d, PRINTED, FLAG, -1).agree, table4_agree(d, PRINTED, DROP, -1).agree,
        PAPER_TABLE4_ROWS - feasible, best.agree, best.low, best.high,
        best.agree == PAPER_TABLE4_ROWS
            ? ". The paper's yes or no is a function of E/rho, and mu plays no part "
              "in it"
            : "");
}

static void one_number(const struct table4_data *d, struct table *t)
{
    int same = 0;

    for (int n = 0; n < TABLE4_SCALED; n++)
        same += !memcmp(d->scaled[n].value,
                        d->run[PRINTED][FLAG][table4_scaled[n]].result.value,
                        sizeof d->scaled[n].value);
    table_note(
        t,
        "E and rho are one parameter: gravity is the only load, and so rho divides "
        "out of the printed scheme. Rows %d, %d and %d with four times the E and four "
        "times the rho gave the same numbers, bit for bit, in %d of %d runs%s.",
        table4_scaled[0] + 1, table4_scaled[1] + 1, table4_scaled[2] + 1, same,
        TABLE4_SCALED,
        same == TABLE4_SCALED ? ": the motion depends on E/rho and mu alone" : "");
}

static int rows_that_cross(const struct table4_data *d, int scene, struct words *w)
{
    double first = INFINITY, last = 0;
    int count = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        double time = d->run[PRINTED][scene][row].result.value[MEASURE_INTERSECTION_TIME];
        if (!isfinite(time))
            continue;
        first = fmin(first, time);
        last = fmax(last, time);
        count++;
    }
    add(w, "%s%d of 18 rows on %s", scene ? " and in " : "", count, table4_scene[scene]);
    if (count > 1)
        add(w, " (first at %.3g to %.3g s)", first, last);
    else if (count)
        add(w, " (at %.3g s)", first);
    return count;
}

/* Rows of `penetration` that a bound on the time of the first crossing gets right at best.
 */
static int best_time(const struct table4_data *d)
{
    bool yes[PAPER_TABLE4_ROWS];
    double time[PAPER_TABLE4_ROWS];

    table4_paper(PAPER_PENETRATION, yes);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        time[row] = d->run[PRINTED][FLAG][row].result.value[MEASURE_INTERSECTION_TIME];
    return interval_best(PAPER_TABLE4_ROWS, time, yes, INTERVAL_ANY).agree;
}

static void crossings(const struct table4_data *d, struct table *t)
{
    struct words w = {"", 0};
    bool blind = true, met = false, yes[PAPER_TABLE4_ROWS];
    const int paper = table4_paper(PAPER_PENETRATION, yes);

    for (int s = 0; s < TABLE4_SCENES; s++) {
        int count = rows_that_cross(d, s, &w);
        struct table4_agreement a = table4_agree(d, PRINTED, s, PAPER_PENETRATION);
        blind = blind && (count == 0 || count == PAPER_TABLE4_ROWS ||
                          a.agree <= PAPER_TABLE4_ROWS - paper); /* no better than `no` */
        met = met || a.agree == PAPER_TABLE4_ROWS;
    }
    table_note(t, "Penetration: the printed sheet passes through itself in %s. %s.", w.text,
               met ? "These are the paper's rows on one of the scenes"
               : blind
                   ? "That does not tell the paper's rows from the others, on either scene"
                   : "That meets the paper's rows in part");
    table_note(t,
               "How early it does so: the best bound on the time of the first crossing on "
               "flag, chosen in hindsight, gets %d of 18 rows right, `no` to all %d.",
               best_time(d), PAPER_TABLE4_ROWS - paper);
}

static void deaths(const struct table4_data *d, struct table *t)
{
    struct words w = {"", 0};

    for (int s = 0; s < TABLE4_SCENES; s++) {
        int count = 0;
        add(&w, "%s on %s ", s ? ";" : "", table4_scene[s]);
        for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
            if (status_is_death(d->run[PRINTED][s][row].result.outcome))
                add(&w, "%srow %d at %.3g s", count++ ? ", " : "", row + 1,
                    d->run[PRINTED][s][row].result.value[MEASURE_BLOWUP_TIME]);
        add(&w, "%s", count ? "" : "none");
    }
    int fast = 0;
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        fast += d->run[PRINTED][DROP][row].result.value[MEASURE_SPEED_MAX] > FREE_FALL;
    table_note(
        t,
        "Chaos: blow-ups of the printed scheme:%s. The paper calls row 7 chaotic. On "
        "edge_drop %d rows move faster than the sheet could by falling: under "
        "v <- mu v the scheme falls with g (1 + mu) / 2 (1 - mu), which is 9.5 g at "
        "mu = 0.9.",
        w.text, fast);
}

/* 5e4: the least Gamma of the fabrics that the plan's thresholds are from. */
static void stiffness(const struct table4_data *d, struct table *t)
{
    const double fabric = 5e4;
    double low = INFINITY, high = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        double gamma = d->run[PRINTED][FLAG][row].result.value[MEASURE_GAMMA];
        low = fmin(low, gamma);
        high = fmax(high, gamma);
    }
    table_note(t,
               "Boards, not cloth: Gamma, weight against bending, is %.3g to %.3g in these "
               "rows and %.0e or more in measured fabrics of 1 m. An elastic sheet with "
               "these numbers stands out of its support, as the undamped shell does: its "
               "middle line sinks by %.2g degrees at most on flag in row %d, the printed "
               "one's by %.3g: the printed scheme has no elastic memory, and flows.",
               low, high, fabric,
               d->run[TABLE4_SHELL][FLAG][3].result.value[MEASURE_ANGLE_MAX], 4,
               d->run[PRINTED][FLAG][3].result.value[MEASURE_ANGLE_MAX]);
}

/* Whose failure a label is, from the rows that have it; `lawful`: at most, in a reading and
 * scene with a law that holds. */
static const char *whose(int paper, int printed, int lawful, int lawful_hits)
{
    if (printed == 0 && lawful == 0)
        return "nobody shows it by this threshold: not reproduced";
    if (lawful == 0)
        return "the scheme's: neither the nonlinear solid nor the shell shows it in any "
               "row, "
               "with the same E, nu, rho and thickness";
    if (lawful == PAPER_TABLE4_ROWS)
        return "physics, but of no use as a verdict: on one of the scenes the nonlinear "
               "models show it in all 18 rows, the paper's feasible ones among them";
    return lawful_hits == paper
               ? "physics: the nonlinear models show it in all of the paper's rows"
               : "in part physics: the nonlinear models show it in some rows";
}

static const char *hanging(const struct table4_data *d, struct words *w)
{
    double most = 0, shell = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        most = fmax(most, d->run[PRINTED][FLAG][row].result.value[MEASURE_HANGING_STRAIN]);
        for (int s = 0; s < TABLE4_SCENES; s++)
            shell =
                fmax(shell, d->run[TABLE4_SHELL][s][row].result.value[MEASURE_STRETCH_MAX]);
    }
    add(w,
        " A strip that hangs by its end stretches by rho g L / E, %.2g at most in these "
        "rows; the undamped shell's largest stretch, in motion, is %.3f.",
        most, shell);
    return w->text;
}

static void physics(const struct table4_data *d, int label, struct table *t)
{
    bool yes[PAPER_TABLE4_ROWS];
    int paper = table4_paper(label, yes), printed = 0, lawful = 0, hits = 0;
    struct words w = {"", 0};

    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++) {
            struct table4_agreement a = table4_agree(d, r, s, label);
            if (r == PRINTED)
                printed += a.hit + a.extra;
            if (!table4_reading[r].lawful)
                continue;
            lawful = a.hit + a.extra > lawful ? a.hit + a.extra : lawful;
            hits = a.hit > hits ? a.hit : hits;
        }
    table_note(t, "%s: %s.%s", paper_label[label], whose(paper, printed, lawful, hits),
               label == PAPER_OVER_STRETCHED ? hanging(d, &w) : "");
}

void table4_text(const struct table4_data *d, struct table *t)
{
    for (int label = 0; label < PAPER_LABELS; label++)
        physics(d, label, t);
    yes_or_no(d, t);
    one_number(d, t);
    crossings(d, t);
    deaths(d, t);
    stiffness(d, t);
}
