#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char DIED[] = "died";

struct point {
    double value, by;
    const char *lack; /* why the case has no value; NULL: it has one */
    bool grows;
};

struct sweep_falls {
    const struct plan *plan;
    const struct plan_axis *axis;
    long stride;         /* cases from one value of the axis to the next               */
    struct point *point; /* [cases]; owned                                             */
    struct table *table; /* NULL: not judged yet                                       */
    char *headers;       /* of its columns, owned                                      */
    long rows, grown;    /* rows with two values to compare; those in which one grows  */
};

enum status sweep_falls_create(struct sweep_falls **falls, const struct plan *plan)
{
    struct sweep_falls *f;

    *falls = NULL;
    if (!plan->falls.along)
        return STATUS_OK;
    f = calloc(1, sizeof *f);
    if (!f)
        return STATUS_MEMORY;
    f->plan = plan;
    f->stride = 1;
    for (int n = plan->axis_count - 1; n >= 0 && !f->axis; n--)
        if (!strcmp(plan->axes[n].key, plan->falls.along))
            f->axis = &plan->axes[n];
        else
            f->stride *= plan->axes[n].values.count;
    f->point = calloc((size_t)plan_case_count(plan), sizeof *f->point);
    if (!f->point) {
        sweep_falls_destroy(f);
        return STATUS_MEMORY;
    }
    *falls = f;
    return STATUS_OK;
}

void sweep_falls_destroy(struct sweep_falls *f)
{
    if (!f)
        return;
    table_destroy(f->table);
    free(f->headers);
    free(f->point);
    free(f);
}

void sweep_falls_row(struct sweep_falls *f, long number, const struct sweep_row *row)
{
    if (!f)
        return;
    const struct plan_falls *falls = &f->plan->falls;
    const struct run_result *r = &row->result;
    const bool ran = row->state == SWEEP_ROW_RAN;
    struct point *p = &f->point[number];

    *p = (struct point){.value = ran ? r->value[falls->measure] : NAN,
                        .by = ran && falls->by >= 0 ? r->value[falls->by] : 0};
    p->lack = !ran                              ? "no result"
              : status_is_death(r->outcome)     ? DIED
              : r->outcome                      ? "unsupported"
              : isnan(p->value) || isnan(p->by) ? "no value"
                                                : NULL;
}

/* Says if all listed cases have names, which then stand for their keys. */
static bool is_named(const struct plan *plan)
{
    for (int n = 0; n < plan->listed_count; n++)
        if (!plan->listed[n].name)
            return false;
    return plan->listed_count > 0;
}

/* Says if a key has a column: one of another axis or of listed cases without names. */
static bool is_shown(const struct plan *plan, const char *key)
{
    bool shown = false;

    for (int n = 0; n < plan->listed_count && !is_named(plan); n++)
        shown |= plan_settings_find(&plan->listed[n].settings, key) != NULL;
    for (int n = 0; n < plan->axis_count; n++)
        shown |= !strcmp(plan->axes[n].key, key);
    return shown && strcmp(key, plan->falls.along) != 0;
}

/* Columns: names, the other keys, the values of the axis (at_1, at_2, ... to machines), the
 * last bar, where it grows. */
static enum status create_table(struct sweep_falls *f)
{
    enum { KEY = 32 };
    const struct plan *plan = f->plan;
    const int values = f->axis->values.count;
    const int most = plan->key_count + values + 3;
    struct table_column *columns = calloc((size_t)most, sizeof *columns), *c = columns;
    char caption[256];

    f->headers = calloc((size_t)values + 1, KEY);
    if (columns && f->headers) {
        if (is_named(plan))
            *c++ = (struct table_column){"name", .align = TABLE_LEFT};
        for (int k = 0; k < plan->key_count; k++)
            if (is_shown(plan, plan->keys[k]))
                *c++ = (struct table_column){plan->keys[k], .align = TABLE_LEFT,
                                             .key = plan->keys[k]};
        for (int n = 0; n < values; n++) {
            char *key = f->headers + n * KEY;
            snprintf(key, KEY, "at_%d", n + 1);
            *c++ = (struct table_column){f->axis->values.list[n].value, .key = key};
        }
        *c++ = (struct table_column){"may grow by", .key = "by"};
        *c++ = (struct table_column){"grows at", .align = TABLE_LEFT};
        snprintf(caption, sizeof caption, "%s along %s", measure_name(plan->falls.measure),
                 plan->falls.along);
        f->table = table_create((int)(c - columns), columns, caption);
    }
    free(columns);
    return f->table ? STATUS_OK : STATUS_MEMORY;
}

/* Judges a row; returns its last `by`. */
static double judge_row(struct sweep_falls *f, long first)
{
    double least = INFINITY, by = NAN;
    int judged = 0;
    bool grows = false;

    for (int n = 0; n < f->axis->values.count; n++) {
        struct point *p = &f->point[first + n * f->stride];
        const bool has = !p->lack;
        const bool died = p->lack == DIED && isfinite(least);
        p->grows = died || (has && p->value > least + p->by);
        grows |= p->grows;
        judged += has || died;
        least = has ? fmin(least, p->value) : least;
        by = has ? p->by : by;
    }
    f->rows += judged > 1;
    f->grown += grows;
    return by;
}

/* Adds the cells of a row that was judged: its values, `by`, and where it grows. */
static void add_values(struct sweep_falls *f, long first, double by)
{
    char text[512] = "";

    for (int n = 0; n < f->axis->values.count; n++) {
        const struct point *p = &f->point[first + n * f->stride];
        const size_t used = strlen(text);
        if (p->lack)
            table_missing(f->table, "%s", p->lack);
        else
            table_number(f->table, p->value, 3);
        if (p->grows)
            snprintf(text + used, sizeof text - used, "%s%s", used ? " " : "",
                     f->axis->values.list[n].value);
    }
    table_number(f->table, by, 3);
    table_text(f->table, "%s", text);
}

static enum status add_row(struct sweep_falls *f, long first)
{
    const struct plan *plan = f->plan;
    struct plan_case c = {0};
    const enum status st = plan_case_given(plan, first, &c);

    if (st == STATUS_OK) {
        table_row(f->table);
        if (is_named(plan))
            table_text(f->table, "%s", c.name);
        for (int k = 0; k < plan->key_count; k++)
            if (is_shown(plan, plan->keys[k]))
                table_text(f->table, "%s", c.given[k] ? c.given[k]->value : "");
        add_values(f, first, judge_row(f, first));
    }
    plan_case_clear(&c);
    return st;
}

enum status sweep_falls_judge(struct sweep_falls *f, const char *folder,
                              struct message *why)
{
    enum status st = STATUS_OK;

    if (!f)
        return st;
    TRY(create_table(f));
    for (long n = 0; n < plan_case_count(f->plan); n++)
        if (n / f->stride % f->axis->values.count == 0)
            TRY(add_row(f, n));
    TRY(table_save(f->table, folder, "falls", why));
out:
    return st;
}

enum status sweep_falls_print(const struct sweep_falls *f, FILE *file)
{
    if (!f || !f->table)
        return STATUS_OK;
    const enum status st = table_print(f->table, TABLE_TEXT, file);

    if (f->grown)
        table_say(file, "\nIt grows in %ld of %ld rows with two values to compare.\n",
                  f->grown, f->rows);
    else
        table_say(file, "\nIt grows in none of %ld rows with two values to compare.\n",
                  f->rows);
    return st;
}

enum status sweep_falls_check(const struct sweep_falls *f, struct message *why)
{
    if (!f || !f->grown)
        return STATUS_OK;
    return status_fail(why, STATUS_FAILED, "%s grows along %s in %ld of %ld rows",
                       measure_name(f->plan->falls.measure), f->plan->falls.along, f->grown,
                       f->rows);
}
