/* The tables of Table 4, from its case files. */
#include <math.h>
#include <string.h>

#include "bench/tables/interval.h"
#include "bench/tables/table4_data.h"
#include "bench/experiment/timed.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* A time that did not come, a number that does not exist: a dash. */
static void number(struct table *t, double value, int digits)
{
    if (isfinite(value))
        table_number(t, value, digits);
    else
        table_dash(t);
}

static void labels_cell(struct table *t, bool feasible, unsigned labels)
{
    char words[128];

    table_text(t, "%s%s%s", feasible ? "yes" : "no", labels ? ": " : "",
               labels ? table4_data_words(labels, words, sizeof words) : "");
}

static void row_cells(struct table *t, const struct table4_data *d, int scene, int row)
{
    const struct paper_table4_row *p = &paper_table4[row];
    const double *value = d->result[TABLE4_PRINTED][scene][row].value;

    table_row(t);
    table_integer(t, row + 1);
    table_text(t, "%.0e", p->young);
    table_text(t, "%g", p->density);
    table_text(t, "%g", p->damping);
    table_number(t, value[CASE_YOUNG_OVER_DENSITY], 3);
    table_number(t, value[CASE_GAMMA], 3);
    number(t, value[CASE_STRETCH_MAX], 4);
    number(t, value[CASE_DROP_MAX], 3);
    number(t, value[CASE_ANGLE_MAX], 3);
    number(t, value[CASE_ROUGHNESS_MAX], 3);
    number(t, value[CASE_SPEED_MAX], 3);
    number(t, value[CASE_INTERSECTION_TIME], 3);
    number(t, value[CASE_BLOWUP_TIME], 3);
    labels_cell(t, d->feasible[TABLE4_PRINTED][scene][row],
                d->labels[TABLE4_PRINTED][scene][row]);
    labels_cell(t, p->labels == 0, p->labels);
}

static void note_rules(struct table *t, const struct verdict_rules *rules)
{
    for (int n = 0; n < rules->count; n++) {
        const struct verdict_rule *r = &rules->rule[n];
        const char *unit = case_measure_unit(r->measure);
        bool pure = !strcmp(unit, "1");
        table_note(t, "%s: %s %s %g%s%s; %s.", r->label, case_measure_name(r->measure),
                   r->above ? "above" : "below", r->bound, pure ? "" : " ",
                   pure ? "" : unit, r->why);
    }
}

static enum status print_rows(const struct table4_data *d, int scene,
                              enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"row", NULL, 0},           {"E", "Pa", 0},
        {"rho", "kg/m^3", 0},       {"mu", NULL, 0},
        {"E/rho", "m^2/s^2", 0},    {"Gamma", NULL, 0},
        {"stretch", NULL, 0},       {"drop", "L", 0},
        {"angle", "degrees", 0},    {"roughness", NULL, 0},
        {"speed", "m/s", 0},        {"crosses itself", "s", 0},
        {"blows up", "s", 0},       {"ours", NULL, TABLE_LEFT},
        {"paper", NULL, TABLE_LEFT}};
    char caption[128];
    enum status st;

    snprintf(caption, sizeof caption,
             "Table 4 on %s, %s, to %.3g s: largest values of each run",
             table4_scene[scene], table4_reading[TABLE4_PRINTED].title,
             d->result[TABLE4_PRINTED][scene][0].value[CASE_END_TIME]);
    struct table *t = table_create(COUNT(columns), columns, caption);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        row_cells(t, d, scene, row);
    if (scene == TABLE4_FLAG) {
        table_note(t, "Labels, by thresholds that are the same for every row, scene and "
                      "model and were not fitted to the paper's words:");
        note_rules(t, &d->rules);
    }
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static void agreement_cell(struct table *t, const struct table4_data *d, int reading,
                           int scene, int label)
{
    struct table4_agreement a = table4_data_agree(d, reading, scene, label);

    table_text(t, "%d (%d/%d +%d)", a.agree, a.hit, a.hit + a.missed, a.extra);
}

static enum status print_agreement(const struct table4_data *d, enum table_format format,
                                   FILE *file)
{
    static const struct table_column columns[] = {{"physics", NULL, TABLE_LEFT},
                                                  {"scene", NULL, TABLE_LEFT},
                                                  {"died", NULL, 0},
                                                  {"feasible", NULL, 0},
                                                  {"over-stretched", NULL, 0},
                                                  {"penetration", NULL, 0},
                                                  {"too light", NULL, 0},
                                                  {"chaotic", NULL, 0},
                                                  {"wrinkles too fine", NULL, 0}};
    struct table *t = table_create(
        COUNT(columns), columns,
        "Agreement with the paper, of 18 rows (rows of the paper met / all it has, "
        "+ rows only we have)");
    enum status st;

    for (int r = 0; r < TABLE4_READINGS; r++) {
        if (r)
            table_rule(t);
        for (int s = 0; s < TABLE4_SCENES; s++) {
            table_row(t);
            table_text(t, "%s", table4_reading[r].title);
            table_text(t, "%s", table4_scene[s]);
            table_integer(t, table4_data_deaths(d, r, s));
            for (int label = -1; label < PAPER_LABELS; label++)
                agreement_cell(t, d, r, s, label);
        }
    }
    table_note(t,
               "All thresholds as above. mu as a rate: mass damping -ln(mu) / 5 ms, which "
               "slows a free motion as much in each frame of 5 ms as v <- mu v does. "
               "Undamped motions depend on E/rho alone: eight runs serve the 18 rows.");
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

/* The measure a label is judged by, for what a threshold on it could do at its best. Yes or
 * no is not the matter of one measure: stretch stands for all that grow with softness. */
struct judge {
    int measure;
    enum interval_shape shape;
};
static struct judge judge_of(const struct table4_data *d, int label)
{
    for (int n = 0; n < d->rules.count && label >= 0; n++) {
        const struct verdict_rule *rule = &d->rules.rule[n];
        if (!strcmp(rule->label, paper_label[label]))
            return (struct judge){rule->measure,
                                  rule->above ? INTERVAL_ABOVE : INTERVAL_BELOW};
    }
    return (struct judge){CASE_STRETCH_MAX, INTERVAL_ANY};
}

static void best_cell(struct table *t, const struct table4_data *d, int scene, int measure,
                      enum interval_shape shape, const bool *yes)
{
    double value[PAPER_TABLE4_ROWS];

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        value[row] = d->result[TABLE4_PRINTED][scene][row].value[measure];
    table_integer(t, interval_best(PAPER_TABLE4_ROWS, value, yes, shape).agree);
}

static enum status print_hindsight(const struct table4_data *d, enum table_format format,
                                   FILE *file)
{
    static const struct table_column columns[] = {{"answer", NULL, TABLE_LEFT},
                                                  {"paper's rows", NULL, 0},
                                                  {"always no", NULL, 0},
                                                  {"two bounds on E/rho", NULL, 0},
                                                  {"two bounds on mu", NULL, 0},
                                                  {"our measure", NULL, TABLE_LEFT},
                                                  {"flag", NULL, 0},
                                                  {"edge_drop", NULL, 0}};
    struct table *t = table_create(COUNT(columns), columns,
                                   "What the agreement is worth: rows of 18 that simpler "
                                   "answers get right, bounds chosen in hindsight");
    enum status st;

    for (int label = -1; label < PAPER_LABELS; label++) {
        bool yes[PAPER_TABLE4_ROWS];
        double mu[PAPER_TABLE4_ROWS];
        int count = table4_data_paper(label, yes);
        table_row(t);
        table_text(t, "%s", label < 0 ? "feasible" : paper_label[label]);
        table_integer(t, count);
        table_integer(t, PAPER_TABLE4_ROWS - count);
        best_cell(t, d, TABLE4_FLAG, CASE_YOUNG_OVER_DENSITY, INTERVAL_ANY, yes);
        for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
            mu[row] = paper_table4[row].damping;
        table_integer(t, interval_best(PAPER_TABLE4_ROWS, mu, yes, INTERVAL_ANY).agree);
        struct judge judge = judge_of(d, label);
        table_text(t, "%s%s", case_measure_name(judge.measure),
                   judge.shape == INTERVAL_ANY ? ", two bounds" : "");
        for (int s = 0; s < TABLE4_SCENES; s++)
            best_cell(t, d, s, judge.measure, judge.shape, yes);
    }
    table_note(
        t,
        "Our measure: the best that a threshold on it could do, printed scheme. Not used "
        "anywhere: it shows what fitting would buy.");
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static enum status print_whose(const struct table4_data *d, enum table_format format,
                               FILE *file)
{
    struct table_column columns[TABLE4_READINGS + 2] = {{"", NULL, TABLE_LEFT},
                                                        {"paper", NULL, 0}};
    enum status st;

    for (int r = 0; r < TABLE4_READINGS; r++)
        columns[r + 2] = (struct table_column){table4_reading[r].name, NULL, 0};
    struct table *t =
        table_create(COUNT(columns), columns,
                     "Physics, or the scheme's? Rows of 18 that are called so, on flag and "
                     "on edge_drop");
    for (int label = -1; label < PAPER_LABELS; label++) {
        bool yes[PAPER_TABLE4_ROWS];
        table_row(t);
        table_text(t, "%s", label < 0 ? "feasible" : paper_label[label]);
        table_integer(t, table4_data_paper(label, yes));
        for (int r = 0; r < TABLE4_READINGS; r++) {
            struct table4_agreement flag = table4_data_agree(d, r, 0, label);
            struct table4_agreement drop = table4_data_agree(d, r, 1, label);
            table_text(t, "%d, %d", flag.hit + flag.extra, drop.hit + drop.extra);
        }
    }
    table4_text(d, t);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

enum status table4_print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct table4_data *d = NULL;
    enum status st;

    TRY(table4_data_load(folder, &d, why));
    for (int s = 0; s < TABLE4_SCENES; s++) {
        TRY(print_rows(d, s, format, file));
        fputc('\n', file);
    }
    TRY(print_agreement(d, format, file));
    fputc('\n', file);
    TRY(print_hindsight(d, format, file));
    fputc('\n', file);
    TRY(print_whose(d, format, file));
    fputc('\n', file);
    if (table_format_is_prose(format)) {
        char path[TIMED_PATH];
        table4_path(folder, TABLE4_PRINTED, TABLE4_FLAG, 0, path, sizeof path);
        timed_machine(path, file);
    }
    TRY(table4_plot(d, folder, why));
out:
    table4_data_clear(d);
    return st;
}
