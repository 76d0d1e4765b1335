#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Makes the columns: the other axes, the values of the axis (at_1, at_2, ... to machines),
 * the last bar, where it grows. */
static enum status create_table(struct sweep_falls *f, const struct plan *plan,
                                const struct plan_axis *along)
{
    enum { KEY = 32 };
    const struct plan_study *study = plan->studies;
    const int most = study->axis_count + along->count + 2;
    struct dataset_column *columns = calloc((size_t)most, sizeof *columns), *c = columns;
    char caption[256];

    f->keys = calloc((size_t)along->count, KEY);
    if (columns && f->keys) {
        for (int n = 0; n < study->axis_count; n++)
            if (&study->axis[n] != along)
                *c++ = (struct dataset_column){study->axis[n].name,
                                               .key = study->axis[n].name};
        for (int n = 0; n < along->count; n++) {
            char *key = f->keys + n * KEY;
            snprintf(key, KEY, "at_%d", n + 1);
            *c++ = (struct dataset_column){along->levels[n].label, .key = key};
        }
        *c++ = (struct dataset_column){"may grow by", .key = "by"};
        *c++ = (struct dataset_column){"grows at"};
        snprintf(caption, sizeof caption, "%s along %s", measure_name(plan->falls.measure),
                 plan->falls.along);
        f->table = dataset_create((int)(c - columns), columns, caption);
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

/* Judges the cases that differ from `first` along the axis alone; adds their cells, the
 * last bar, and where the measure grows. */
static void judge(struct sweep_falls *f, const struct sweep_rows *rows,
                  const struct plan_axis *along, long first)
{
    const struct plan_falls *falls = &rows->plan->falls;
    double least = INFINITY, bar = NAN;
    char grows_at[512] = "";
    int judged = 0;

    for (int n = 0; n < along->count; n++) {
        struct plan_setting label = {along->name, along->levels[n].label, 0};
        const long at =
            sweep_rows_with(rows->plan, first, &(struct plan_settings){1, &label});
        if (at < 0) {
            dataset_missing(f->table, "left out");
            continue;
        }
        const struct sweep_row *row = &rows->row[at];
        const double value = row->value[falls->measure];
        const double by = falls->by >= 0 ? row->value[falls->by] : 0;
        const char *lack = lack_of(row, value, by);
        const bool died = status_is_death(row->outcome) && isfinite(least);
        if (died || (!lack && value > least + by))
            TEXT_JOIN(grows_at, " ", "%s", label.value);
        judged += !lack || died;
        if (lack) {
            dataset_missing(f->table, "%s", lack);
            continue;
        }
        dataset_add(f->table, "%.3g", value);
        least = fmin(least, value);
        bar = by;
    }
    dataset_add(f->table, "%.3g|%s", bar, grows_at);
    f->rows += judged > 1;
    f->grown += *grows_at != '\0';
}

enum status sweep_falls_judge(struct sweep_falls *f, const struct sweep_rows *rows)
{
    const struct plan *plan = rows->plan;
    const struct plan_study *study = plan->studies;
    const struct plan_axis *along = study->axis;
    enum status st = STATUS_OK;

    *f = (struct sweep_falls){0};
    if (!plan->falls.along)
        return st;
    while (strcmp(along->name, plan->falls.along) != 0)
        along++;
    TRY(create_table(f, plan, along));
    for (int n = 0; n < study->level_count; n++) {
        const struct plan_level *level = &study->levels[n];
        if (level->part[along - study->axis] != along->levels)
            continue;
        dataset_row(f->table);
        for (int a = 0; a < study->axis_count; a++)
            if (&study->axis[a] != along)
                dataset_text(f->table, "%s", level->part[a]->label);
        judge(f, rows, along, n);
    }
out:
    return st;
}

void sweep_falls_clear(struct sweep_falls *f)
{
    dataset_destroy(f->table);
    free(f->keys);
    *f = (struct sweep_falls){0};
}

enum status sweep_falls_print(struct sweep_falls *f, struct printer *p, struct message *why)
{
    struct dataset *t = f->table;

    if (!t)
        return STATUS_OK;
    f->table = NULL;
    dataset_note(t, "It grows in %ld of %ld rows with two values to compare.", f->grown,
                 f->rows);
    return printer_table(p, t, "falls", why);
}
