/* What the folder of `stress` holds, as tables. */
#include <math.h>
#include <stdlib.h>

#include "bench/stress/stress.h"

/* Where the results are, and how they are printed. */
struct print {
    const char *folder;
    const struct stress_choice *choice;
    enum table_format format;
    FILE *file;
};

/* Whether a run that was asked for left a result. */
static bool has_result(const struct print *p, const struct stress_case *c,
                       const struct contestant *contestant, struct stress_result *r)
{
    char name[256];

    stress_result_name(c, contestant, name, sizeof name);
    return stress_choice_case(p->choice, c) &&
           stress_result_read(p->folder, name, r, NULL) == STATUS_OK;
}

static bool has_any(const struct print *p, const struct stress_case *c)
{
    const struct contestant *at = NULL;
    struct stress_result r;

    while ((at = stress_choice_next(p->choice, at)))
        if (has_result(p, c, at, &r))
            return true;
    return false;
}

static void add_overview_cell(struct table *t, const struct stress_case *c,
                              const struct stress_result *r)
{
    const enum stress_end end = stress_result_end(r, c->bound);

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
    const struct contestant *at = NULL;
    struct stress_result r;

    table_row(t);
    table_text(t, "%s", c->item.name);
    while ((at = stress_choice_next(p->choice, at)))
        if (has_result(p, c, at, &r)) {
            count[stress_result_end(&r, c->bound)]++;
            add_overview_cell(t, c, &r);
        } else {
            table_dash(t);
        }
}

static enum status print_overview(const struct print *p)
{
    struct table_column *columns = NULL;
    const struct contestant *at = NULL;
    int count[4] = {0}, all = 1;

    while ((at = stress_choice_next(p->choice, at)))
        all++;
    columns = calloc((size_t)all, sizeof *columns);
    if (!columns)
        return STATUS_MEMORY;
    columns[0] = (struct table_column){"case", NULL, TABLE_LEFT};
    for (int n = 1; (at = stress_choice_next(p->choice, at)); n++)
        columns[n] = (struct table_column){at->column, NULL, TABLE_LEFT};
    struct table *t = table_create(all, columns, "Hard cases");
    free(columns);
    for (int n = 0; stress_case_at(n); n++)
        if (has_any(p, stress_case_at(n)))
            add_overview(t, p, stress_case_at(n), count);
    table_note(t,
               "ok: accurate, the error is within the case's bound; off: degraded, beyond "
               "it. %d runs: %d accurate, %d degraded, %d refused, %d died.",
               count[0] + count[1] + count[2] + count[3], count[0], count[1], count[2],
               count[3]);
    return table_finish(t, p->format, p->file);
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

    for (int n = 0; stress_case_at(n); n++) {
        const struct stress_case *c = stress_case_at(n);
        if (!has_any(p, c))
            continue;
        table_row(t);
        table_text(t, "%s", c->item.name);
        table_text(t, "%s", c->item.text);
        table_number(t, c->bound, 1);
        table_text(t, "%s", c->why);
        table_text(t, "%s", stress_truth_text(c->truth));
    }
    return table_finish(t, p->format, p->file);
}

static void add_detail(struct table *t, const struct stress_case *c,
                       const struct contestant *contestant, const struct stress_result *r)
{
    table_row(t);
    table_text(t, "%s", c->item.name);
    table_text(t, "%s", contestant->name);
    table_number(t, c->bound, 1);
    table_text(t, "%s", stress_end_name(stress_result_end(r, c->bound)));
    table_number(t, isfinite(r->error) ? r->error : NAN, 3);
    table_number(t, r->time, 3);
    table_fixed(t, r->seconds, 2);
    table_text(t, "%s", r->sentence.text);
}

static enum status print_details(const struct print *p)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT},
        {"model", NULL, TABLE_LEFT},
        {"bound", "1", TABLE_RIGHT, .readers = TABLE_MACHINES},
        {"end", NULL, TABLE_LEFT},
        {"error", "1", TABLE_RIGHT},
        {"until", "s", TABLE_RIGHT},
        {"took", "s", TABLE_RIGHT},
        {"in words", NULL, TABLE_LEFT},
    };
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns, "How each run ended");
    struct stress_result r;

    for (int n = 0; stress_case_at(n); n++) {
        const struct stress_case *c = stress_case_at(n);
        const struct contestant *at = NULL;
        while ((at = stress_choice_next(p->choice, at)))
            if (has_result(p, c, at, &r))
                add_detail(t, c, at, &r);
        if (has_any(p, c))
            table_rule(t);
    }
    table_note(t,
               "Until: the time in the scene at which the run died, or at which its error "
               "first went beyond the bound.");
    return table_finish(t, p->format, p->file);
}

enum status stress_print(const char *folder, const struct stress_choice *choice,
                         enum table_format format, FILE *file, struct message *why)
{
    const struct print p = {folder, choice, format, file};
    const bool prose = table_format_is_prose(format);
    bool some = false, map = false;
    enum status st = STATUS_OK;

    for (int n = 0; stress_case_at(n) && !some; n++)
        some = has_any(&p, stress_case_at(n));
    if (some && prose) {
        TRY(print_overview(&p));
        TRY(print_truths(&p));
    }
    if (some) /* a machine gets one table: this one has everything */
        TRY(print_details(&p));
    if (stress_choice_map(choice))
        TRY(stress_map_print(folder, format, some && !prose ? NULL : file, &map, why));
    if (!some && !map)
        st = status_fail(why, STATUS_INPUT, "%s holds no such results of `stress`", folder);
out:
    return st;
}
