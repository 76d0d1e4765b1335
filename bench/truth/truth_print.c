#include "bench/truth/truth_print.h"

#include <math.h>

#include "bench/truth/truth_plan.h"

static void add_row(struct table *t, const struct truth_made *made, int n, double length)
{
    const double *v = made->value[n];

    table_row(t);
    table_number(t, made->time[n], 3);
    for (int c = 0; c < TRUTH_COLUMNS; c++)
        if (c == TRUTH_ERROR && n >= made->claimed)
            table_missing(t, "no claim");
        else if (c == TRUTH_GROWTH)
            table_number(t, v[c], 2);
        else if (c < TRUTH_DIFFERENCE && c % 3 != TRUTH_SOLID_BAR)
            table_fixed(t, v[c], 1);
        else
            table_number(t, v[c] / length, 2);
}

/* Until when it is claimed, and what ends it. */
static void note_horizon(struct table *t, const struct truth_made *made, double length)
{
    const int n = made->claimed;
    const double time = n < made->times ? made->time[n] : NAN, *v = made->value[n];

    if (n == made->times)
        table_note(t, "All of it is claimed.");
    else if (v[TRUTH_THIRD] > v[TRUTH_ERROR] + v[TRUTH_THIRD_BAR])
        table_note(t,
                   "Nothing is claimed from %.3g s on: a third mechanics, with a bar of "
                   "%.2g %%, is %.2g %% off there.",
                   time, 100 * v[TRUTH_THIRD_BAR] / length, 100 * v[TRUTH_THIRD] / length);
    else if (v[TRUTH_GROWTH] > TRUTH_MOST_GROWTH)
        table_note(t,
                   "Nothing is claimed from %.3g s on: the growth there, %.2g, is above "
                   "%g.",
                   time, v[TRUTH_GROWTH], TRUTH_MOST_GROWTH);
    else
        table_note(t,
                   "Nothing is claimed from %.3g s on: the error bar there, %.2g %%, is "
                   "above %g %%.",
                   time, 100 * v[TRUTH_ERROR] / length, 100 * TRUTH_MOST_ERROR);
    table_note(t, "Horizon: %s.", made->horizon);
}

/* What there is to say of truths that were made, and of all. */
static void add_notes(struct table *t, const struct truth_made *made, double length)
{
    table_note(t, "The truth: %s.", made->note);
    if (made->foreign)
        return;
    if (made->closed) {
        table_note(t, "Horizon: %s.", made->horizon);
        return;
    }
    table_note(
        t,
        "Orders are of the rms over the material grid, over three nets and over three "
        "steps, or over three runs of which both shrink; a dash: the differences do not "
        "shrink. A model's bar is what its orders leave, with a factor of safety. Growth: "
        "rms change after gravity was changed by 1e-6 in the direction (1,1,1), over 1e-6 "
        "of the length.");
    note_horizon(t, made, length);
    if (*made->third)
        table_note(t,
                   "The third mechanics: %s. Its distance is from the truth's middle "
                   "surface, its bar what its own order leaves.",
                   made->third);
    if (*made->commit)
        table_note(t, "Made at commit %s with %s changed files.", made->commit,
                   made->changed);
}

static bool has_third(const struct truth_made *made)
{
    for (int n = 0; n < made->times; n++)
        if (!isnan(made->value[n][TRUTH_THIRD]))
            return true;
    return false;
}

enum status truth_print(const struct truth_made *made, const struct scene *scene,
                        enum table_format format, FILE *file)
{
    const double length = scene->length;
    struct table_column columns[] = {
        {"time", "s"},
        {"solid: in space", .key = "solid_order_in_space"},
        {"in time", .key = "solid_order_in_time"},
        {"bar", "% L", .key = "solid_bar_over_length", .scale = 100, .key_unit = "L"},
        {"shell: in space", .key = "shell_order_in_space"},
        {"in time", .key = "shell_order_in_time"},
        {"bar", "% L", .key = "shell_bar_over_length", .scale = 100, .key_unit = "L"},
        {"difference", "% L", .key = "difference_over_length", .scale = 100,
         .key_unit = "L"},
        {"growth", "1"},
        {"error bar", "% L", .key = "error_bar_over_length", .scale = 100, .key_unit = "L"},
        {"third", "% L", .key = "third_over_length", .scale = 100, .key_unit = "L"},
        {"its bar", "% L", .key = "third_bar_over_length", .scale = 100, .key_unit = "L"},
    };
    char caption[128];

    snprintf(caption, sizeof caption, "%s of %s: %serror bars",
             made->foreign ? "The third mechanics" : "Truth", scene->name,
             made->closed ? "" : "observed orders and ");
    for (int n = 0; made->closed && n < TRUTH_ERROR; n++)
        columns[1 + n].readers = TABLE_NOBODY; /* nobody's run */
    for (int n = 0; made->foreign && n < TRUTH_ERROR; n++)
        if (n != TRUTH_SHELL_SPACE)
            columns[1 + n].readers = TABLE_NOBODY;
    for (int n = TRUTH_THIRD; !has_third(made) && n < TRUTH_COLUMNS; n++)
        columns[1 + n].readers = TABLE_NOBODY;
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < made->times; n++)
        if (made->closed || n == made->claimed - 1 ||
            truth_plan_judges(scene, made->time[n]))
            add_row(t, made, n, length);
    add_notes(t, made, length);
    const enum status st = table_print(t, format, file);
    table_destroy(t);
    return st;
}
