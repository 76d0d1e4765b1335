#include "bench/truth/truth_print.h"

#include <math.h>
#include <stdlib.h>

#include "bench/truth/truth.h"
#include "bench/truth/truth_plan.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"

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

/* --- Positions -------------------------------------------------------------------------
 */

/* Mean of the two layers at (u, v). */
static void mid_surface(const double *field, double u, double v, double at[3])
{
    double across[2], along[2];
    const int i = grid_cell(GRID_U, u, along), j = grid_cell(GRID_V, v, across);

    at[0] = at[1] = at[2] = 0;
    for (int n = 0; n < 4 * GRID_W; n++) {
        const int di = n % 2, dj = n / 2 % 2, k = n / 4;
        const double *x = field + 3 * ((k * GRID_V + j + dj) * GRID_U + i + di);
        for (int c = 0; c < 3; c++)
            at[c] += along[di] * across[dj] * x[c] / GRID_W;
    }
}

enum status truth_print_frames(const struct truth_made *made, const int points[2],
                               FILE *file)
{
    fprintf(file, "# source: %s\n", made->note);
    for (int t = 0; t < made->claimed; t++)
        fprintf(file, "# bar: %.17g,%.17g\n", made->time[t], made->value[t][TRUTH_ERROR]);
    fprintf(file, "t,u,v,x,y,z\n");
    for (int t = 0; t < made->claimed; t++)
        for (int n = 0; n < points[0] * points[1]; n++) {
            const double u = n % points[0] / (points[0] - 1.0);
            const double v = n / points[0] / (points[1] - 1.0);
            double x[3];
            mid_surface(made->xyz[t], u, v, x);
            fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", made->time[t], u, v,
                    x[0], x[1], x[2]);
        }
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}

/* --- All scenes ------------------------------------------------------------------------
 */

static void add_known(struct table *t, const struct truth_made *made, double length)
{
    const int last = made->claimed - 1;

    table_text(t, "%s", made->closed ? "closed form" : "stored");
    table_number(t, made->time[last], 3);
    table_number(t, made->value[last][TRUTH_ERROR] / length, 2);
}

static enum status add_scene(struct table *t, const char *name, struct message *why)
{
    struct settings settings = {0};
    struct scene scene = {0};
    struct truth_made made = {0};
    struct message lack = {""};
    char *path = NULL;
    enum status st;

    TRY(scene_file_find(name, &path, why));
    TRY(truth_plan_scene(path, &settings, &scene, why));
    st = truth_known(&scene, &made, &lack);
    if (st != STATUS_OK && st != STATUS_UNSUPPORTED && st != STATUS_FILE)
        TRY(status_fail(why, st, "%s", lack.text));
    table_row(t);
    table_text(t, "%s", name);
    if (st == STATUS_OK && made.claimed) {
        add_known(t, &made, scene.length);
    } else {
        table_text(t, "none");
        table_note(t, "%s.", lack.text);
    }
    st = STATUS_OK;
out:
    truth_made_clear(&made);
    scene_clear(&scene);
    settings_clear(&settings);
    free(path);
    return st;
}

enum status truth_print_all(enum table_format format, FILE *file, struct message *why)
{
    static const struct table_column columns[] = {{"scene", NULL, TABLE_LEFT},
                                                  {"truth", NULL, TABLE_LEFT},
                                                  {"known to", "s", .key = "known_to_s"},
                                                  {"error bar there", "% L",
                                                   .key = "error_bar_over_length",
                                                   .scale = 100, .key_unit = "L"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "What is known of each scene");
    struct named_file_entry *scenes = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&scene_file_kind, &scenes, &count, why));
    for (int n = 0; n < count; n++)
        TRY(add_scene(t, scenes[n].name, why));
    TRY(table_print(t, format, file));
out:
    named_file_list_free(scenes, count);
    table_destroy(t);
    return st;
}
