/* What the folder of `stress` holds, as tables. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/stress/stress.h"

const char *stress_truth_text(enum stress_truth truth)
{
    static const char *const text[STRESS_TRUTHS] = {
        [STRESS_PLATE] = "tip at rest against the Kirchhoff plate (Ritz), relative",
        [STRESS_ELASTICA] = "tip at rest against the heavy elastica, over L",
        [STRESS_VIBRATION] =
            "tip in time against the Kirchhoff plate's modal solution, over "
            "its greatest deflection",
        [STRESS_SIMILAR] =
            "against the model's own motion in metres, kilograms and seconds, "
            "RMSE over L",
        [STRESS_ENERGY] = "drift of the sum of energies, over the energy in play",
        [STRESS_BUCKLED] = "middle against Euler's elastica, over L",
        [STRESS_STILL] = "motion where there should be none, RMSE over L",
        [STRESS_STILL_REST] = "motion away from the model's own equilibrium, RMSE over L",
        [STRESS_SHIFTED] = "where it comes to rest, RMSE over L",
        [STRESS_SHELL] = "against a finer nonlinear shell, RMSE over L",
    };

    return text[truth];
}

/* Where the results are, and how they are printed. */
struct print {
    const char *folder;
    const struct stress_choice *choice;
    enum table_format format;
    FILE *file;
};

/* A case's results, those there are and that were asked for. */
struct line {
    int count;
    const struct stress_model *model[STRESS_MODELS];
    struct stress_result result[STRESS_MODELS];
};

static int read_line(const struct print *p, const struct stress_case *c, struct line *line)
{
    char name[256];

    line->count = 0;
    for (int m = 0; m < STRESS_MODELS && stress_choice_case(p->choice, c); m++) {
        stress_name(c, &stress_models[m], name, sizeof name);
        if (stress_choice_model(p->choice, &stress_models[m]) &&
            stress_read(p->folder, name, &line->result[line->count], NULL) == STATUS_OK)
            line->model[line->count++] = &stress_models[m];
    }
    return line->count;
}

static void add_overview_cell(struct table *t, const struct stress_case *c,
                              const struct stress_result *r)
{
    const enum stress_end end = stress_classify(r, c->bound);

    if (end == STRESS_ACCURATE || end == STRESS_DEGRADED)
        table_text(t, "%s %.0e", end == STRESS_ACCURATE ? "ok" : "off", r->error);
    else if (end == STRESS_DIED && isfinite(r->time))
        table_text(t, "died %.2g s", r->time);
    else
        table_text(t, "%s", stress_end_name(end));
}

static void add_overview(struct table *t, const struct print *p,
                         const struct stress_case *c, int count[4])
{
    struct line line;

    if (!read_line(p, c, &line))
        return;
    table_row(t);
    table_text(t, "%s", c->item.name);
    for (int m = 0, n = 0; m < STRESS_MODELS; m++) {
        if (n == line.count || line.model[n] != &stress_models[m]) {
            table_dash(t);
            continue;
        }
        count[stress_classify(&line.result[n], c->bound)]++;
        add_overview_cell(t, c, &line.result[n++]);
    }
}

static enum status print_overview(const struct print *p, bool *some)
{
    struct table_column columns[STRESS_MODELS + 1] = {{"case", NULL, TABLE_LEFT}};
    int count[4] = {0};
    enum status st = STATUS_OK;

    for (int m = 0; m < STRESS_MODELS; m++)
        columns[m + 1] = (struct table_column){stress_models[m].title, NULL, TABLE_LEFT};
    struct table *t = table_create(STRESS_MODELS + 1, columns, "Hard cases");
    for (int n = 0; stress_case_at(n); n++)
        add_overview(t, p, stress_case_at(n), count);
    const int all = count[0] + count[1] + count[2] + count[3];
    *some = all > 0;
    if (!*some)
        goto out;
    table_note(t,
               "ok: accurate, the error is within the case's bound; off: degraded, beyond "
               "it. %d runs: %d accurate, %d degraded, %d refused, %d died.",
               all, count[0], count[1], count[2], count[3]);
    st = table_print(t, p->format, p->file);
out:
    table_destroy(t);
    return st;
}

static enum status print_truths(const struct print *p)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT},   {"what is hard", NULL, TABLE_LEFT},
        {"bound", NULL, TABLE_RIGHT}, {"its reason", NULL, TABLE_LEFT},
        {"error", NULL, TABLE_LEFT},
    };
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "What each case is held against");
    struct line line;

    for (int n = 0; stress_case_at(n); n++) {
        const struct stress_case *c = stress_case_at(n);
        if (!read_line(p, c, &line))
            continue;
        table_row(t);
        table_text(t, "%s", c->item.name);
        table_text(t, "%s", c->item.text);
        table_number(t, c->bound, 1);
        table_text(t, "%s", c->why);
        table_text(t, "%s", stress_truth_text(c->truth));
    }
    const enum status st = table_print(t, p->format, p->file);
    table_destroy(t);
    return st;
}

static void add_detail(struct table *t, const struct stress_case *c,
                       const struct stress_model *m, const struct stress_result *r)
{
    const enum stress_end end = stress_classify(r, c->bound);

    table_row(t);
    table_text(t, "%s", c->item.name);
    table_text(t, "%s", m->name);
    table_text(t, "%s", stress_end_name(end));
    if (isfinite(r->error))
        table_number(t, r->error, 3);
    else
        table_dash(t);
    if (isfinite(r->time))
        table_number(t, r->time, 3);
    else
        table_dash(t);
    table_fixed(t, r->seconds, 2);
    table_text(t, "%s", r->sentence.text);
}

static enum status print_details(const struct print *p)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT},     {"model", NULL, TABLE_LEFT},
        {"end", NULL, TABLE_LEFT},      {"error", "1", TABLE_RIGHT},
        {"until", "s", TABLE_RIGHT},    {"took", "s", TABLE_RIGHT},
        {"in words", NULL, TABLE_LEFT},
    };
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns, "How each run ended");
    struct line line;

    for (int n = 0; stress_case_at(n); n++) {
        if (!read_line(p, stress_case_at(n), &line))
            continue;
        for (int m = 0; m < line.count; m++)
            add_detail(t, stress_case_at(n), line.model[m], &line.result[m]);
        table_rule(t);
    }
    table_note(t,
               "Until: the time in the scene at which the run died, or at which its error "
               "first went beyond the bound.");
    const enum status st = table_print(t, p->format, p->file);
    table_destroy(t);
    return st;
}

enum status stress_print(const char *folder, const struct stress_choice *choice,
                         enum table_format format, FILE *file, struct message *why)
{
    const struct print p = {folder, choice, format, file};
    bool some, map = false;
    enum status st;

    TRY(print_overview(&p, &some));
    if (some) {
        fputc('\n', file);
        TRY(print_truths(&p));
        fputc('\n', file);
        TRY(print_details(&p));
    }
    if (stress_choice_map(choice))
        TRY(stress_map_print(folder, format, file, &map, why));
    if (!some && !map)
        st = status_fail(why, STATUS_INPUT, "%s holds no such results of `stress`", folder);
out:
    return st;
}
