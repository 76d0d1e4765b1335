#include "bench/sweep/sweep.h"

#include <math.h>
#include <string.h>

/* Makes the columns: the other axes, the values of the axis (at_1, at_2, ... to machines),
 * the last bar, where it grows. */
static struct dataset *create_table(const struct plan *plan, const struct plan_axis *along)
{
    const struct plan_study *study = plan->studies;
    const size_t most = (size_t)(study->axis_count + along->count + 2);
    struct arena own = {0};
    struct dataset_column *columns = arena_take(&own, most, sizeof *columns), *c = columns;

    for (int n = 0; n < study->axis_count; n++)
        if (&study->axis[n] != along)
            *c++ = (struct dataset_column){study->axis[n].name, .key = study->axis[n].name};
    for (int n = 0; n < along->count; n++)
        *c++ = (struct dataset_column){along->levels[n].label,
                                       .key = arena_print(&own, "at_%d", n + 1)};
    *c++ = (struct dataset_column){"may grow by", .key = "by"};
    *c++ = (struct dataset_column){"grows at"};
    struct dataset *t =
        dataset_create((int)(c - columns), columns,
                       arena_print(&own, "%s along %s", measure_name(plan->falls.measure),
                                   plan->falls.along));
    arena_clear(&own);
    return t;
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
static void judge(struct sweep_falls *f, struct dataset *t, const struct sweep_rows *rows,
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
            dataset_missing(t, "left out");
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
            dataset_missing(t, "%s", lack);
            continue;
        }
        dataset_add(t, "%.3g", value);
        least = fmin(least, value);
        bar = by;
    }
    dataset_add(t, "%.3g|%s", bar, grows_at);
    f->rows += judged > 1;
    f->grown += *grows_at != '\0';
}

enum status sweep_falls_print(const struct sweep_rows *rows, struct printer *p,
                              struct sweep_falls *f, struct message *why)
{
    const struct plan *plan = rows->plan;
    const struct plan_study *study = plan->studies;
    const struct plan_axis *along = study->axis;

    *f = (struct sweep_falls){0};
    if (!plan->falls.along)
        return STATUS_OK;
    while (strcmp(along->name, plan->falls.along) != 0)
        along++;
    struct dataset *t = create_table(plan, along);
    for (int n = 0; n < study->level_count; n++) {
        const struct plan_level *level = &study->levels[n];
        if (level->part[along - study->axis] != along->levels)
            continue;
        dataset_row(t);
        for (int a = 0; a < study->axis_count; a++)
            if (&study->axis[a] != along)
                dataset_text(t, "%s", level->part[a]->label);
        judge(f, t, rows, along, n);
    }
    dataset_note(t, "It grows in %ld of %ld rows with two values to compare.", f->grown,
                 f->rows);
    return printer_table(p, t, "falls", why);
}
