#include "bench/truth/truth_command.h"

#include <math.h>
#include <stdlib.h>

#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_file.h"
#include "bench/ui/table.h"
#include "models/reader/scene_file.h"

enum { PATH = 4096 };

struct job {
    char *path;
    struct scene scene;
    bool quick;
    struct settings settings;
    enum table_format format;
};

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

static enum status print(const struct job *j, const struct truth_made *made)
{
    const double length = j->scene.length;
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

    snprintf(caption, sizeof caption, "Truth of %s: observed orders and error bars",
             j->scene.name);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < made->times; n++)
        add_row(t, made, n, length);
    table_note(t, "The truth: %s.", made->note);
    table_note(
        t, "Orders are of the rms over the material grid, over three nets and over "
           "three steps; a dash: the differences do not shrink. A model's bar is what "
           "its orders leave, with a factor of safety. Growth: rms change after gravity "
           "was changed by 1e-6 in the direction (1,1,1), over 1e-6 of the length.");
    note_horizon(t, made, length);
    if (*made->commit)
        table_note(t, "Made at commit %s with %s changed files.", made->commit,
                   made->changed);
    const enum status st = table_print(t, j->format, stdout);
    table_destroy(t);
    return st;
}

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    const char *word = command_value(line, "--format");
    int count;
    const char *const *given = command_values(line, "--set", &count);
    enum status st;

    j->quick = command_given(line, "--quick");
    if (word)
        TRY(table_format_parse(word, &j->format, why));
    settings_set_all(&j->settings, count, given);
    TRY(scene_file_find(line->words[0], &j->path, why));
    TRY(truth_plan_scene(j->path, &j->settings, &j->scene, why));
out:
    return st;
}

static enum status make_one(struct job *j, const char *out, struct message *why)
{
    struct truth_plan plan = truth_plan_of(j->scene.name, j->quick);
    struct truth_made made = {0};
    double *time = NULL;
    const char *all = j->quick ? "results/truths_quick" : "results/truths";
    struct provenance provenance;
    char folder[PATH], file[PATH];
    enum status st;

    snprintf(folder, sizeof folder, "results/truth_%s%s", j->scene.name,
             j->quick ? "_quick" : "");
    snprintf(file, sizeof file, "%s/%s.h5", all, j->scene.name);
    if (!out)
        TRY(folder_make(all, why));
    out = out ? out : file;
    provenance_collect(&provenance);
    TRY(truth_file_may_store(out, &provenance, why));
    TRY(folder_make(folder, why));
    struct truth_runs runs = {.path = j->path,
                              .settings = &j->settings,
                              .times = truth_plan_times(&plan, &j->scene, &time),
                              .folder = folder,
                              .ours = true};
    runs.time = time;
    if (runs.times < 0)
        TRY(STATUS_MEMORY);
    timing_alone();
    TRY(truth_make(&plan, &runs, &j->scene, false, &made, why));
    TRY(truth_file_write(out, &runs, &made, why));
    TRY(print(j, &made));
    fprintf(stderr, "truth in %s, its runs in %s\n", out, folder);
out:
    truth_made_clear(&made);
    free(time);
    return st;
}

static enum status print_stored(const struct job *j, struct message *why)
{
    struct truth_made made;
    enum status st = truth_file_find(j->scene.name, &j->scene, &made, why);

    if (st == STATUS_OK)
        st = print(j, &made);
    truth_made_clear(&made);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a name that is none */
}

static enum status run(const struct command_line *line, struct message *why)
{
    struct job j = {0};
    enum status st;

    TRY(prepare(&j, line, why));
    if (command_given(line, "--stored"))
        TRY(print_stored(&j, why));
    else
        TRY(make_one(&j, command_value(line, "--out"), why));
out:
    settings_clear(&j.settings);
    scene_clear(&j.scene);
    free(j.path);
    return st;
}

static const struct command_option options[] = {
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {"--out", "FILE", false, "where the truth goes (results/truths/SCENE.h5)"},
    {"--stored", NULL, false, "only print the table of the truth that is stored"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--quick", NULL, false, "coarse nets, 0.2 s: for trying out"},
    {NULL, NULL, false, NULL},
};

const struct command truth_command = {
    .name = "truth",
    .summary = "what a scene's motion is, with an error bar, and until when",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs the nonlinear solid, cured of locking, and the nonlinear shell, each on\n"
        "three nets and with three time steps, prints the orders observed, what they\n"
        "leave as error bars, the difference of the two models, and until which time the\n"
        "motion is predictable: one run is made again with gravity changed by 1e-6. The\n"
        "better model's motion is stored, with the larger of its bar and the difference.\n"
        "Truths of some scenes come with the program; `compare` and others use these and\n"
        "those in $CLOTHBENCH_TRUTHS. A scene damped by velocity_scale, which is no rate,\n"
        "has an undamped truth. Runs that this commit left are not made again.\n",
    .examples = "truth edge_drop --stored\ntruth sphere --quick\n"
                "truth flag --set material.young=1e5 --out flag.h5\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
