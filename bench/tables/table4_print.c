/* The tables of Table 4; table4.csv: every measure of every run; the chart: labels over
 * E/rho and mu. */
#include <math.h>
#include <string.h>

#include "bench/tables/table4.h"
#include "bench/ui/chart.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* Labels and, before them, whether a row is feasible. */
enum { ANSWERS = PAPER_LABELS + 1 };

static const char *answer(int label)
{
    return label < 0 ? "feasible" : paper_label[label];
}

/* A time that did not come is no number for people. */
static double arrived(double value)
{
    return isfinite(value) ? value : NAN;
}

static void labels_cell(struct table *t, bool feasible, unsigned labels)
{
    char words[128];

    table_text(t, "%s%s%s", feasible ? "yes" : "no", labels ? ": " : "",
               labels ? table4_words(labels, words, sizeof words) : "");
}

static void row_cells(struct table *t, const struct table4_run *run, int row)
{
    static const struct {
        int measure, digits;
    } cell[] = {{MEASURE_YOUNG_OVER_DENSITY, 3}, {MEASURE_GAMMA, 3},
                {MEASURE_STRETCH_MAX, 4},        {MEASURE_DROP_MAX, 3},
                {MEASURE_ANGLE_MAX, 3},          {MEASURE_ROUGHNESS_MAX, 3},
                {MEASURE_SPEED_MAX, 3},          {MEASURE_INTERSECTION_TIME, 3},
                {MEASURE_BLOWUP_TIME, 3}};
    const struct paper_table4_row *p = &paper_table4[row];

    table_row(t);
    table_integer(t, row + 1);
    table_text(t, "%.0e", p->young);
    table_number(t, p->young, 1);
    table_number(t, p->density, 1);
    table_number(t, p->damping, 1);
    for (int n = 0; n < COUNT(cell); n++)
        table_number(t, arrived(run->result.value[cell[n].measure]), cell[n].digits);
    if (run_result_refused(&run->result))
        table_missing(t, "refused");
    else if (run->result.quick) /* which the caption says, once */
        table_dash(t);
    else if (!run->judged)
        table_text(t, "not judged");
    else
        labels_cell(t, run->feasible, run->labels);
    labels_cell(t, p->labels == 0, p->labels);
    if (run_result_refused(&run->result))
        table_note(t, "row %d: %s.", row + 1, run->result.sentence.text);
}

static void note_rules(struct table *t, const struct verdict_rules *rules)
{
    table_note(t, "Labels, by thresholds that are the same for every row, scene and model "
                  "and were not fitted to the paper's words:");
    for (int n = 0; n < rules->count; n++) {
        const struct verdict_rule *r = &rules->rule[n];
        const char *unit = measure_unit(r->measure);
        const bool pure = !strcmp(unit, "1");
        table_note(t, "%s: %s %s %g%s%s; %s.", r->label, measure_name(r->measure),
                   r->above ? "above" : "below", r->bound, pure ? "" : " ",
                   pure ? "" : unit, r->why);
    }
}

static enum status print_rows(const struct table4_data *d, int scene,
                              enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"row"},
        {"E", "Pa", .readers = TABLE_PEOPLE},
        {"E", "Pa", .key = "young_pa", .readers = TABLE_MACHINES},
        {"rho", "kg/m^3"},
        {"mu"},
        {"E/rho", "m^2/s^2"},
        {"Gamma"},
        {"stretch"},
        {"drop", "L"},
        {"angle", "degrees"},
        {"roughness"},
        {"speed", "m/s"},
        {"crosses itself", "s"},
        {"blows up", "s"},
        {"ours", NULL, TABLE_LEFT},
        {"paper", NULL, TABLE_LEFT}};
    const struct table4_run *run = d->run[TABLE4_PRINTED][scene];
    char caption[128];

    snprintf(caption, sizeof caption,
             "Table 4 on %s, %s, to %.3g s: largest values of each run%s",
             table4_scene[scene], table4_reading[TABLE4_PRINTED].title,
             run[0].result.value[MEASURE_END_TIME], d->quick ? "; not judged: quick" : "");
    struct table *t = table_create(COUNT(columns), columns, caption);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        row_cells(t, &run[row], row);
    if (scene == TABLE4_FLAG)
        note_rules(t, &d->rules);
    if (d->quick && scene == TABLE4_DROP)
        table4_text(d, t);
    return table_finish(t, format, file);
}

/* Columns for programs, of numbers that people read in one cell. */
struct wide {
    int count;
    struct table_column column[2 + 4 * ANSWERS + 3 * TABLE4_READINGS];
    char header[4 * ANSWERS + 3 * TABLE4_READINGS][64];
};

/* One for people, and one for programs of each of `count` words. */
static void widen(struct wide *w, const char *header, int count, const char *const *word)
{
    w->column[w->count++] = (struct table_column){header, .readers = TABLE_PEOPLE};
    for (int n = 0; n < count; n++) {
        char *name = w->header[w->count];
        snprintf(name, sizeof w->header[0], "%s %s", header, word[n]);
        w->column[w->count++] = (struct table_column){name, .readers = TABLE_MACHINES};
    }
}

static enum status print_agreement(const struct table4_data *d, enum table_format format,
                                   FILE *file)
{
    static const char *const word[] = {"agree", "met", "extra"};
    struct wide w = {
        3, {{"physics", NULL, TABLE_LEFT}, {"scene", NULL, TABLE_LEFT}, {"died"}}, {""}};

    for (int label = -1; label < PAPER_LABELS; label++)
        widen(&w, answer(label), COUNT(word), word);
    struct table *t = table_create(w.count, w.column,
                                   "Agreement with the paper, of 18 rows (rows of the "
                                   "paper met / all it has, + rows only we have)");
    for (int r = 0; r < TABLE4_READINGS; r++) {
        if (r)
            table_rule(t);
        for (int s = 0; s < TABLE4_SCENES; s++) {
            int deaths = 0;
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
                deaths += status_is_death(d->run[r][s][row].result.outcome);
            table_row(t);
            table_text(t, "%s", table4_reading[r].title);
            table_text(t, "%s", table4_scene[s]);
            table_integer(t, deaths);
            for (int label = -1; label < PAPER_LABELS; label++) {
                const struct table4_agreement a = table4_agree(d, r, s, label);
                table_text(t, "%d (%d/%d +%d)", a.agree, a.hit, a.hit + a.missed, a.extra);
                table_integer(t, a.agree);
                table_integer(t, a.hit);
                table_integer(t, a.extra);
            }
        }
    }
    table_note(t,
               "All thresholds as above. mu as a rate: mass damping -ln(mu) / 5 ms, which "
               "slows a free motion as much in each frame of 5 ms as v <- mu v does. "
               "Undamped motions depend on E/rho alone: eight runs serve the 18 rows.");
    return table_finish(t, format, file);
}

/* The measure a label is judged by, for what a threshold on it could do at its best. Yes or
 * no is not the matter of one measure: stretch stands for all that grow with softness. */
struct judge {
    int measure;
    enum table4_bounds shape;
};
static struct judge judge_of(const struct table4_data *d, int label)
{
    for (int n = 0; n < d->rules.count && label >= 0; n++) {
        const struct verdict_rule *rule = &d->rules.rule[n];
        if (!strcmp(rule->label, paper_label[label]))
            return (struct judge){rule->measure, rule->above ? TABLE4_ABOVE : TABLE4_BELOW};
    }
    return (struct judge){MEASURE_STRETCH_MAX, TABLE4_ANY};
}

static void best_cell(struct table *t, const struct table4_data *d, int scene,
                      struct judge judge, const bool *yes)
{
    double value[PAPER_TABLE4_ROWS];

    table4_column(d, TABLE4_PRINTED, scene, judge.measure, value);
    table_integer(t, table4_best(PAPER_TABLE4_ROWS, value, yes, judge.shape).agree);
}

static enum status print_hindsight(const struct table4_data *d, enum table_format format,
                                   FILE *file)
{
    static const struct table_column columns[] = {{"answer", NULL, TABLE_LEFT},
                                                  {"paper's rows"},
                                                  {"always no"},
                                                  {"two bounds on E/rho"},
                                                  {"two bounds on mu"},
                                                  {"our measure", NULL, TABLE_LEFT},
                                                  {"flag"},
                                                  {"edge_drop"}};
    static const struct judge ratio = {MEASURE_YOUNG_OVER_DENSITY, TABLE4_ANY};
    struct table *t = table_create(COUNT(columns), columns,
                                   "What the agreement is worth: rows of 18 that simpler "
                                   "answers get right, bounds chosen in hindsight");
    double mu[PAPER_TABLE4_ROWS];

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        mu[row] = paper_table4[row].damping;
    for (int label = -1; label < PAPER_LABELS; label++) {
        const struct judge judge = judge_of(d, label);
        bool yes[PAPER_TABLE4_ROWS];
        const int count = table4_paper(label, yes);
        table_row(t);
        table_text(t, "%s", answer(label));
        table_integer(t, count);
        table_integer(t, PAPER_TABLE4_ROWS - count);
        best_cell(t, d, TABLE4_FLAG, ratio, yes);
        table_integer(t, table4_best(PAPER_TABLE4_ROWS, mu, yes, TABLE4_ANY).agree);
        table_text(t, "%s%s", measure_name(judge.measure),
                   judge.shape == TABLE4_ANY ? ", two bounds" : "");
        for (int s = 0; s < TABLE4_SCENES; s++)
            best_cell(t, d, s, judge, yes);
    }
    table_note(t, "Our measure: the best that a threshold on it could do, printed scheme. "
                  "Not used anywhere: it shows what fitting would buy.");
    return table_finish(t, format, file);
}

static enum status print_whose(const struct table4_data *d, enum table_format format,
                               FILE *file)
{
    struct wide w = {2, {{"", NULL, TABLE_LEFT, .key = "answer"}, {"paper"}}, {""}};

    for (int r = 0; r < TABLE4_READINGS; r++)
        widen(&w, table4_reading[r].name, TABLE4_SCENES, table4_scene);
    struct table *t = table_create(w.count, w.column,
                                   "Physics, or the scheme's? Rows of 18 that are called "
                                   "so, on flag and on edge_drop");
    for (int label = -1; label < PAPER_LABELS; label++) {
        bool yes[PAPER_TABLE4_ROWS];
        table_row(t);
        table_text(t, "%s", answer(label));
        table_integer(t, table4_paper(label, yes));
        for (int r = 0; r < TABLE4_READINGS; r++) {
            const struct table4_agreement flag = table4_agree(d, r, TABLE4_FLAG, label);
            const struct table4_agreement drop = table4_agree(d, r, TABLE4_DROP, label);
            table_text(t, "%d, %d", flag.hit + flag.extra, drop.hit + drop.extra);
            table_integer(t, flag.hit + flag.extra);
            table_integer(t, drop.hit + drop.extra);
        }
    }
    table4_text(d, t);
    return table_finish(t, format, file);
}

/* Every measure of every run. */
static enum status save(const struct table4_data *d, const char *folder,
                        struct message *why)
{
    enum { BEFORE = 6, AFTER = 5 };
    static const char *const key[] = {
        "physics", "scene",    "row",    "young",          "density",     "mu",
        "outcome", "feasible", "labels", "paper_feasible", "paper_labels"};
    struct table_column columns[BEFORE + MEASURES + AFTER];
    char words[128];

    for (int n = 0; n < COUNT(columns); n++) {
        const int measure = n - BEFORE;
        columns[n] =
            (struct table_column){.header = measure < 0          ? key[n]
                                            : measure < MEASURES ? measure_name(measure)
                                                                 : key[n - MEASURES]};
    }
    struct table *t = table_create(COUNT(columns), columns, NULL);
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
                const struct paper_table4_row *p = &paper_table4[row];
                const struct table4_run *run = &d->run[r][s][row];
                table_row(t);
                table_text(t, "%s", table4_reading[r].name);
                table_text(t, "%s", table4_scene[s]);
                table_integer(t, row + 1);
                table_number(t, p->young, 1);
                table_number(t, p->density, 1);
                table_number(t, p->damping, 1);
                for (int n = 0; n < MEASURES; n++)
                    table_number(t, run->result.value[n], 9);
                table_text(t, "%s", run->result.sentence.text);
                table_text(t, "%s", !run->judged ? "" : run->feasible ? "yes" : "no");
                table_text(t, "%s", table4_words(run->labels, words, sizeof words));
                table_text(t, "%s", p->labels ? "no" : "yes");
                table_text(t, "%s", table4_words(p->labels, words, sizeof words));
            }
    const enum status st = table_save(t, folder, "table4", why);
    table_destroy(t);
    return st;
}

/* Squares from a row's place, side by side where it has several labels. */
static void squares(struct chart *c, int label, int row, double up, bool feasible,
                    unsigned labels)
{
    const double apart = 1.1, ratio = paper_table4[row].young / paper_table4[row].density;
    int before = 0;

    for (int n = 0; n < label; n++)
        before += labels >> n & 1;
    if (label < 0              ? feasible
        : label < PAPER_LABELS ? labels >> label & 1
                               : !feasible && !labels)
        chart_point(c, ratio * pow(apart, before), paper_table4[row].damping + up);
}

/* What is called so, by the paper above, by us below: label -1: feasible; PAPER_LABELS:
 * neither feasible nor named. */
static void draw_label(struct chart *c, const struct table4_run *run, int label)
{
    static const char *const rgb[] = {"#2ca02c", "#d62728", "#1f77b4", "#e6b800",
                                      "#9467bd", "#17becf", "#444444"};
    const double up = 0.015;

    chart_series(c,
                 &(struct chart_series){label < PAPER_LABELS ? answer(label) : "not named",
                                        CHART_SQUARES, .rgb = rgb[label + 1]});
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const unsigned paper = paper_table4[row].labels;
        squares(c, label, row, up, !paper, paper);
        squares(c, label, row, -up, run[row].feasible, run[row].labels);
    }
}

static enum status draw(const struct table4_data *d, const char *folder,
                        struct message *why)
{
    static const int shown[] = {TABLE4_PRINTED, TABLE4_SHELL};
    struct chart *c = chart_create("Table 4: the paper's words above, ours below");
    char title[128];

    chart_axes(c, &(struct chart_axis){"E/rho", "m^2/s^2", true, 2.5e4, 1.6e6},
               &(struct chart_axis){"mu", NULL, false, -0.02, 1.02});
    for (int r = 0; r < COUNT(shown); r++)
        for (int s = 0; s < TABLE4_SCENES; s++) {
            snprintf(title, sizeof title, "%s, %s", table4_scene[s],
                     table4_reading[shown[r]].title);
            chart_panel(c, title);
            for (int label = -1; label <= PAPER_LABELS; label++)
                draw_label(c, d->run[shown[r]][s], label);
        }
    return chart_save(c, folder, "table4", why);
}

enum status table4_print(const struct table4_data *d, const char *folder,
                         enum table_format format, FILE *file, struct message *why)
{
    enum status st = STATUS_OK;

    if (table_format_is_prose(format))
        table4_headline(d, file);
    for (int s = 0; s < TABLE4_SCENES; s++)
        TRY(print_rows(d, s, format, file));
    TRY(save(d, folder, why));
    fprintf(stderr, "every number in %s/table4.csv\n", folder);
    if (d->quick) /* what follows counts verdicts */
        return st;
    TRY(print_agreement(d, format, file));
    TRY(print_hindsight(d, format, file));
    TRY(table4_learn_print(d, format, file));
    TRY(print_whose(d, format, file));
    TRY(draw(d, folder, why));
out:
    return st;
}
