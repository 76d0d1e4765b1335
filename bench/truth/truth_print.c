#include <stdio.h>

#include "bench/truth/truth_command.h"

static void row_cells(struct table *t, const struct truth_made *made, int n, double length)
{
    const double *v = made->value[n];

    table_row(t);
    table_number(t, made->time[n], 3);
    for (int c = TRUTH_SOLID_SPACE; c <= TRUTH_SHELL_SPACE; c += 3) {
        table_fixed(t, v[c], 1);
        table_fixed(t, v[c + 1], 1);
        table_number(t, v[c + 2] / length, 2);
    }
    table_number(t, v[TRUTH_DIFFERENCE] / length, 2);
    table_number(t, v[TRUTH_GROWTH], 2);
    if (n < made->claimed)
        table_number(t, v[TRUTH_ERROR] / length, 2);
    else
        table_missing(t, "no claim");
}

/* Until when it is claimed, and what ends it. */
static void horizon_note(struct table *t, const struct truth_made *made, double length)
{
    int n = made->claimed;

    if (n == made->times)
        table_note(t, "All of it is claimed.");
    else if (made->value[n][TRUTH_GROWTH] > TRUTH_MOST_GROWTH)
        table_note(
            t, "Nothing is claimed from %.3g s on: the growth there, %.2g, is above %g.",
            made->time[n], made->value[n][TRUTH_GROWTH], TRUTH_MOST_GROWTH);
    else
        table_note(
            t,
            "Nothing is claimed from %.3g s on: the error bar there, %.2g %%, is above "
            "%g %%.",
            made->time[n], 100 * made->value[n][TRUTH_ERROR] / length,
            100 * TRUTH_MOST_ERROR);
    table_note(t, "Horizon: %s.", made->horizon);
}

enum status truth_print(const struct truth_made *made, const char *scene, double length,
                        enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
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
    };
    char caption[128];

    snprintf(caption, sizeof caption, "Truth of %s: observed orders and error bars", scene);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < made->times; n++)
        row_cells(t, made, n, length);
    table_note(t, "The truth: %s.", made->note);
    table_note(
        t, "Orders are of the rms over the material grid, over three nets and over "
           "three steps; a dash: the differences do not shrink. A model's bar is what "
           "its orders leave, with a factor of safety. Growth: rms change after gravity "
           "was changed by 1e-6 in the direction (1,1,1), over 1e-6 of the length.");
    horizon_note(t, made, length);
    enum status st = table_print(t, format, file);
    table_destroy(t);
    return st;
}
