#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* Makes the columns: names, the other keys, the values of the axis (at_1, at_2, ... to
 * machines), the last bar, where it grows. */
static enum status create_table(struct sweep_falls *f, const struct plan *plan,
                                const struct plan_settings *values)
{
    enum { KEY = 32 };
    const int most = plan->key_count + values->count + 3;
    struct table_column *columns = calloc((size_t)most, sizeof *columns), *c = columns;
    char caption[256];

    f->keys = calloc((size_t)values->count, KEY);
    if (columns && f->keys) {
        if (is_named(plan))
            *c++ = (struct table_column){"name", .align = TABLE_LEFT};
        for (int k = 0; k < plan->key_count; k++)
            if (is_shown(plan, plan->keys[k]))
                *c++ = (struct table_column){plan->keys[k], .align = TABLE_LEFT,
                                             .key = plan->keys[k]};
        for (int n = 0; n < values->count; n++) {
            char *key = f->keys + n * KEY;
            snprintf(key, KEY, "at_%d", n + 1);
            *c++ = (struct table_column){values->list[n].value, .key = key};
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

/* Returns why a case has no value, or NULL if it has one. */
static const char *lack_of(const struct sweep_row *row, double value, double by)
{
    return row->state != SWEEP_RAN         ? "no result"
           : status_is_death(row->outcome) ? "died"
           : row->outcome                  ? "unsupported"
           : isnan(value) || isnan(by)     ? "no value"
                                           : NULL;
}

/* Judges the cases first, first + stride, ...; adds their cells, the last bar, and where
 * the measure grows. */
static void judge(struct sweep_falls *f, const struct sweep_rows *rows,
                  const struct plan_settings *values, long first, long stride)
{
    const struct plan_falls *falls = &rows->plan->falls;
    double least = INFINITY, bar = NAN;
    char grows_at[512] = "";
    int judged = 0;

    for (int n = 0; n < values->count; n++) {
        const struct sweep_row *row = &rows->row[first + n * stride];
        const double value = row->value[falls->measure];
        const double by = falls->by >= 0 ? row->value[falls->by] : 0;
        const char *lack = lack_of(row, value, by);
        const bool died = status_is_death(row->outcome) && isfinite(least);
        if (died || (!lack && value > least + by))
            TEXT_JOIN(grows_at, " ", "%s", values->list[n].value);
        judged += !lack || died;
        if (lack) {
            table_missing(f->table, "%s", lack);
            continue;
        }
        table_add(f->table, "%.3g", value);
        least = fmin(least, value);
        bar = by;
    }
    table_add(f->table, "%.3g|%s", bar, grows_at);
    f->rows += judged > 1;
    f->grown += *grows_at != '\0';
}

static enum status add_row(struct sweep_falls *f, const struct sweep_rows *rows,
                           const struct plan_settings *values, long first, long stride)
{
    const struct plan *plan = rows->plan;
    struct plan_case c = {0};
    enum status st;

    TRY(plan_case_given(plan, first, &c));
    table_row(f->table);
    if (is_named(plan))
        table_add(f->table, "%s", c.name);
    for (int k = 0; k < plan->key_count; k++)
        if (is_shown(plan, plan->keys[k]))
            table_add(f->table, "%s", c.given[k] ? c.given[k]->value : "");
    judge(f, rows, values, first, stride);
out:
    plan_case_clear(&c);
    return st;
}

enum status sweep_falls_judge(struct sweep_falls *f, const struct sweep_rows *rows)
{
    const struct plan *plan = rows->plan;
    const struct plan_axis *axis = plan->axes + plan->axis_count;
    long stride = 1; /* cases from one value of the axis to the next */
    enum status st = STATUS_OK;

    *f = (struct sweep_falls){0};
    if (!plan->falls.along)
        return st;
    while (strcmp((--axis)->key, plan->falls.along) != 0)
        stride *= axis->values.count;
    TRY(create_table(f, plan, &axis->values));
    for (long n = 0; n < rows->count; n++)
        if (n / stride % axis->values.count == 0)
            TRY(add_row(f, rows, &axis->values, n, stride));
out:
    return st;
}

void sweep_falls_clear(struct sweep_falls *f)
{
    table_destroy(f->table);
    free(f->keys);
    *f = (struct sweep_falls){0};
}

enum status sweep_falls_print(const struct sweep_falls *f, FILE *file)
{
    if (!f->table)
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
