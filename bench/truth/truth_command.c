#include "bench/truth/truth_command.h"

#include <math.h>
#include <stdlib.h>

#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_closed.h"
#include "bench/truth/truth_file.h"
#include "bench/truth/truth_frames.h"
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

/* What there is to say of truths that were made, and of all. */
static void add_notes(struct table *t, const struct truth_made *made, double length)
{
    table_note(t, "The truth: %s.", made->note);
    if (made->closed) {
        table_note(t, "Horizon: %s.", made->horizon);
        return;
    }
    table_note(
        t, "Orders are of the rms over the material grid, over three nets and over "
           "three steps; a dash: the differences do not shrink. A model's bar is what "
           "its orders leave, with a factor of safety. Growth: rms change after gravity "
           "was changed by 1e-6 in the direction (1,1,1), over 1e-6 of the length.");
    note_horizon(t, made, length);
    if (*made->commit)
        table_note(t, "Made at commit %s with %s changed files.", made->commit,
                   made->changed);
}

static enum status print(const struct job *j, const struct truth_made *made)
{
    const double length = j->scene.length;
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
    };
    char caption[128];

    snprintf(caption, sizeof caption, "Truth of %s: %serror bars", j->scene.name,
             made->closed ? "" : "observed orders and ");
    for (int n = 0; made->closed && n < TRUTH_ERROR; n++)
        columns[1 + n].readers = TABLE_NOBODY; /* nobody's run */
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < made->times; n++)
        add_row(t, made, n, length);
    add_notes(t, made, length);
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

/* By runs, which are kept in a folder of their own. */
static enum status make_by_runs(struct job *j, struct truth_runs *runs,
                                struct truth_made *made, struct message *why)
{
    struct truth_plan plan = truth_plan_of(j->scene.name, j->quick);
    char folder[PATH];
    double *time = NULL;
    enum status st;

    snprintf(folder, sizeof folder, "results/truth_%s%s", j->scene.name,
             j->quick ? "_quick" : "");
    TRY(folder_make(folder, why));
    runs->folder = folder;
    runs->times = truth_plan_times(&plan, &j->scene, &time);
    runs->time = time;
    if (runs->times < 0)
        TRY(STATUS_MEMORY);
    timing_alone();
    TRY(truth_make(&plan, runs, &j->scene, false, made, why));
    fprintf(stderr, "its runs are in %s\n", folder);
out:
    free(time);
    return st;
}

static enum status make_one(struct job *j, const char *out, struct message *why)
{
    struct truth_runs runs = {.path = j->path, .settings = &j->settings, .ours = true};
    struct truth_made made = {0};
    const char *all = j->quick ? "results/truths_quick" : "results/truths";
    struct provenance provenance;
    char file[PATH];
    enum status st;

    snprintf(file, sizeof file, "%s/%s.h5", all, j->scene.name);
    if (!out)
        TRY(folder_make(all, why));
    out = out ? out : file;
    provenance_collect(&provenance);
    TRY(truth_file_may_store(out, &provenance, why));
    st = truth_closed_make(&j->scene, &made);
    TRY(st == STATUS_UNSUPPORTED ? make_by_runs(j, &runs, &made, why) : st);
    TRY(truth_file_write(out, &runs, &made, why));
    TRY(print(j, &made));
    fprintf(stderr, "truth in %s\n", out);
out:
    truth_made_clear(&made);
    return st;
}

/* What is known without a run. */
static enum status print_known(const struct job *j, const int points[2],
                               struct message *why)
{
    struct truth_made made;
    enum status st = truth_closed_make(&j->scene, &made);

    if (st == STATUS_UNSUPPORTED)
        st = truth_file_find(j->scene.name, &j->scene, &made, why);
    if (st == STATUS_OK)
        st = *points ? truth_frames_print(&made, points, stdout) : print(j, &made);
    truth_made_clear(&made);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a name that is none */
}

static enum status run(const struct command_line *line, struct message *why)
{
    struct job j = {0};
    int points[2] = {0, 0};
    enum status st;

    TRY(prepare(&j, line, why));
    TRY(command_pair(line, "--points", 2, TRUTH_FRAMES_MOST, points, why));
    if (*points && !command_given(line, "--stored"))
        TRY(status_fail(
            why, STATUS_INPUT,
            "--points prints positions of a truth that is known: with --stored"));
    if (command_given(line, "--stored"))
        TRY(print_known(&j, points, why));
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
    {"--stored", NULL, false,
     "run nothing: the table of the truth that is stored,\nor is a closed form"},
    {"--points", "N,M", false,
     "with --stored: its positions as CSV t,u,v,x,y,z on a net of so many points"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--quick", NULL, false, "coarse nets, 0.2 s: for trying out"},
    {NULL, NULL, false, NULL},
};

const struct command truth_command = {
    .name = "truth",
    .summary = "what a scene's motion is, with an error bar, and until when",
    .arguments = "SCENE [OPTION]...",
    .text =
        "A scene that is a closed form (a free fall; nu = 0, hanging or clamped level, "
        "come\n"
        "to rest under mass damping) is known at once. Else:\n"
        "Runs the nonlinear solid, cured of locking, and the nonlinear shell, each on\n"
        "three nets and with three time steps, prints the orders observed, what they\n"
        "leave as error bars, the difference of the two models, and until which time the\n"
        "motion is predictable: one run is made again with gravity changed by 1e-6. The\n"
        "better model's motion is stored, with the larger of its bar and the difference.\n"
        "Truths of some scenes come with the program; `compare` and others use these and\n"
        "those in $CLOTHBENCH_TRUTHS. A scene damped by velocity_scale, which is no rate,\n"
        "has an undamped truth. Runs that this commit left are not made again.\n",
    .examples = "truth edge_drop --stored\ntruth edge_drop --stored --points 21,21\n"
                "truth sphere --quick\n"
                "truth flag --set material.young=1e5 --out flag.h5\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
