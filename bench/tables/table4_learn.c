#include "bench/tables/table4.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROWS = PAPER_TABLE4_ROWS, ANSWERS = PAPER_LABELS + 1 };

/* Half way to the next value, if there is one at a distance that can be halved. */
static double between(double bound, double next, bool has_next, double open)
{
    if (!isfinite(bound) || !has_next)
        return open;
    return isfinite(next) ? (bound + next) / 2 : bound;
}

/* Bounds on values become bounds between values. */
static struct table4_interval widen(int count, const double *value,
                                    struct table4_interval tight)
{
    double below = -INFINITY, above = INFINITY;
    bool has_below = false, has_above = false;

    if (tight.low > tight.high) /* always no */
        return tight;
    for (int n = 0; n < count; n++) {
        if (value[n] < tight.low)
            below = fmax(below, value[n]), has_below = true;
        if (value[n] > tight.high)
            above = fmin(above, value[n]), has_above = true;
    }
    tight.low = between(tight.low, below, has_below, -INFINITY);
    tight.high = between(tight.high, above, has_above, INFINITY);
    return tight;
}

static bool is_in(struct table4_interval i, double value)
{
    return value >= i.low && value <= i.high;
}

struct table4_lesson table4_learn(int count, const double *value, const bool *yes,
                                  enum table4_bounds shape)
{
    struct table4_lesson l;

    l.bounds = widen(count, value, table4_best(count, value, yes, shape));
    for (int out = 0; out < count; out++) {
        double others[ROWS];
        bool theirs[ROWS];
        int n = 0;
        for (int row = 0; row < count; row++)
            if (row != out)
                others[n] = value[row], theirs[n++] = yes[row];
        l.fitted[out] = is_in(l.bounds, value[out]);
        l.left_out[out] =
            is_in(widen(n, others, table4_best(n, others, theirs, shape)), value[out]);
    }
    return l;
}

/* --- what a scene or a number teaches ---------------------------------------------------
 */

/* Of each label and, first, of feasible: no label at all, or two bounds of its own. */
struct lessons {
    struct table4_lesson answer[ANSWERS];
};

static const struct verdict_rule *rule_of(const struct table4_data *d, int label)
{
    for (int n = 0; n < d->rules.count; n++)
        if (!strcmp(d->rules.rule[n].label, paper_label[label]))
            return &d->rules.rule[n];
    return NULL;
}

static void learn_scene(const struct table4_data *d, int scene, struct lessons *l)
{
    struct table4_lesson *feasible = &l->answer[0];

    for (int row = 0; row < ROWS; row++)
        feasible->fitted[row] = feasible->left_out[row] = true;
    for (int label = 0; label < PAPER_LABELS; label++) {
        const struct verdict_rule *rule = rule_of(d, label);
        struct table4_lesson *own = &l->answer[label + 1];
        double value[ROWS];
        bool yes[ROWS];
        for (int row = 0; row < ROWS; row++)
            value[row] = NAN;
        if (rule)
            table4_column(d, TABLE4_PRINTED, scene, rule->measure, value);
        table4_paper(label, yes);
        *own = table4_learn(ROWS, value, yes,
                            !rule || rule->above ? TABLE4_ABOVE : TABLE4_BELOW);
        for (int row = 0; row < ROWS; row++) {
            feasible->fitted[row] &= !own->fitted[row];
            feasible->left_out[row] &= !own->left_out[row];
        }
    }
}

static void learn_ratio(struct lessons *l)
{
    double ratio[ROWS];
    bool yes[ROWS];

    for (int row = 0; row < ROWS; row++)
        ratio[row] = paper_table4[row].young / paper_table4[row].density;
    for (int answer = 0; answer < ANSWERS; answer++) {
        table4_paper(answer - 1, yes);
        l->answer[answer] = table4_learn(ROWS, ratio, yes, TABLE4_ANY);
    }
}

static int right(int answer, const bool said[ROWS])
{
    bool yes[ROWS];
    int count = 0;

    table4_paper(answer - 1, yes);
    for (int row = 0; row < ROWS; row++)
        count += said[row] == yes[row];
    return count;
}

/* --- printing ---------------------------------------------------------------------------
 */

static void add_cells(struct table *t, const struct lessons *l, int answer)
{
    table_integer(t, right(answer, l->answer[answer].fitted));
    table_integer(t, right(answer, l->answer[answer].left_out));
}

/* "above 1.67", or "never": always no agrees best. */
static void tell_bound(const struct table4_lesson *l, bool above, char text[32])
{
    const struct table4_interval b = l->bounds;

    if (b.low > b.high)
        snprintf(text, 32, "never");
    else
        snprintf(text, 32, "%s %.3g", above ? "above" : "below", above ? b.low : b.high);
}

/* What a label was given, beside the rule's own bound. */
static void note_bounds(struct table *t, const struct table4_data *d,
                        const struct lessons scene[TABLE4_SCENES])
{
    for (int label = 0; label < PAPER_LABELS; label++) {
        const struct verdict_rule *rule = rule_of(d, label);
        char bound[TABLE4_SCENES][32];
        if (!rule)
            continue;
        for (int s = 0; s < TABLE4_SCENES; s++)
            tell_bound(&scene[s].answer[label + 1], rule->above, bound[s]);
        table_note(t, "%s: %s %s on flag, %s on edge_drop; by the rule %s %.3g.",
                   paper_label[label], measure_name(rule->measure), bound[TABLE4_FLAG],
                   bound[TABLE4_DROP], rule->above ? "above" : "below", rule->bound);
    }
}

/* Of the bounds that maps draw, whether they still say what these runs teach. */
static void note_kept(struct table *t, const struct table4_data *d,
                      const struct lessons *flag)
{
    int same = 0;

    for (int row = 0; row < ROWS; row++) {
        const struct verdict v =
            verdict_of(&d->learnt, &d->run[TABLE4_PRINTED][TABLE4_FLAG][row].result);
        bool is = true;
        for (int label = 0; label < PAPER_LABELS; label++)
            is &= verdict_has(&d->learnt, v, paper_label[label]) ==
                  flag->answer[label + 1].fitted[row];
        same += is;
    }
    table_note(t,
               "Maps draw the bounds of flag as the plan table4 has them under `learnt`: "
               "they judge %d of 18 rows as those above do%s.",
               same, same == ROWS ? "" : "; the plan's are of other runs");
}

static void note_worth(struct table *t, const struct lessons scene[TABLE4_SCENES],
                       const struct lessons *ratio)
{
    const int ours = (int)fmax(right(0, scene[TABLE4_FLAG].answer[0].left_out),
                               right(0, scene[TABLE4_DROP].answer[0].left_out));
    const int rival = right(0, ratio->answer[0].left_out);
    bool yes[ROWS];
    const int no = ROWS - table4_paper(-1, yes);

    table_note(t,
               "Yes or no, of rows that were not learnt from: %d of 18 at best from what "
               "the runs show, %d from E/rho alone, %d by `no` to all: %s.",
               ours, rival, no,
               ours > no ? "the runs teach something, the two parameters as much"
                         : "the runs teach nothing about the paper's eye");
}

enum status table4_learn_print(const struct table4_data *d, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {{"answer", NULL, TABLE_LEFT},
                                                  {"paper's rows"},
                                                  {"always no"},
                                                  {"flag: learnt"},
                                                  {"left out", .key = "flag_left_out"},
                                                  {"edge_drop: learnt"},
                                                  {"left out", .key = "edge_drop_left_out"},
                                                  {"E/rho: learnt", .key = "ratio_learnt"},
                                                  {"left out", .key = "ratio_left_out"}};
    struct lessons scene[TABLE4_SCENES], ratio;
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns,
                     "A second verdict: bounds learnt from the paper's own words, printed "
                     "scheme; rows of 18 that they get right");

    for (int s = 0; s < TABLE4_SCENES; s++)
        learn_scene(d, s, &scene[s]);
    learn_ratio(&ratio);
    for (int answer = 0; answer < ANSWERS; answer++) {
        bool yes[ROWS];
        const int count = table4_paper(answer - 1, yes);
        table_row(t);
        table_text(t, "%s", answer ? paper_label[answer - 1] : "feasible");
        table_integer(t, count);
        table_integer(t, ROWS - count);
        for (int s = 0; s < TABLE4_SCENES; s++)
            add_cells(t, &scene[s], answer);
        add_cells(t, &ratio, answer);
    }
    table_note(t,
               "Left out: each row judged by bounds learnt from the 17 others. Feasible: "
               "no label; of E/rho, two bounds of its own.");
    note_bounds(t, d, scene);
    note_kept(t, d, &scene[TABLE4_FLAG]);
    note_worth(t, scene, &ratio);
    return table_finish(t, format, file);
}
