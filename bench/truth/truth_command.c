#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/files/provenance.h"
#include "bench/files/store.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_making.h"
#include "bench/ui/command.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"

/* --- One truth --- */

/* The columns of the table; `value` is one of TRUTH_COLUMNS, or one of these two. */
enum { TIME = -1, ERROR_BAR = -2 };
#define LENGTH(head, name)                                                                 \
    {                                                                                      \
        head, "% L", .key = name "_over_length", .scale = 100, .key_unit = "L"             \
    }
static const struct {
    struct dataset_column head;
    int value;
    int digits; /* 0: one decimal                                                       */
} columns[] = {
    {{"time", "s"}, TIME, 3},
    {{"solid: in space", .key = "solid_order_in_space"}, TRUTH_SOLID_SPACE},
    {{"in time", .key = "solid_order_in_time"}, TRUTH_SOLID_TIME},
    {LENGTH("bar", "solid_bar"), TRUTH_SOLID_BAR, 2},
    {{"shell: in space", .key = "shell_order_in_space"}, TRUTH_SHELL_SPACE},
    {{"in time", .key = "shell_order_in_time"}, TRUTH_SHELL_TIME},
    {LENGTH("bar", "shell_bar"), TRUTH_SHELL_BAR, 2},
    {LENGTH("difference", "difference"), TRUTH_DIFFERENCE, 2},
    {{"growth", "1"}, TRUTH_GROWTH, 2},
    {LENGTH("error bar", "error_bar"), ERROR_BAR, 2},
    {LENGTH("packing", "packing"), TRUTH_PACKING, 2},
    {LENGTH("third", "third"), TRUTH_THIRD, 2},
    {LENGTH("its bar", "third_bar"), TRUTH_THIRD_BAR, 2},
    {{"crossings", "pairs", .key = "crossing_pairs"}, TRUTH_CROSSINGS},
    {{"depth", "% L", .key = "crossing_depth_over_length", .scale = 100, .key_unit = "L",
      .readers = DATASET_MACHINES},
     TRUTH_CROSSING_DEPTH,
     2},
};
enum { COLUMNS = sizeof columns / sizeof *columns };

/* Returns whether a truth has such numbers at all: nobody ran a closed form, of somebody
 * else's runs an order and a bar are known, and few sheets pass through themselves. */
static bool has_column(const struct truth *made, int value)
{
    if (value < 0)
        return true;
    if (value < TRUTH_PACKING)
        return !made->closed && (!made->foreign || value == TRUTH_SHELL_SPACE);
    for (int n = 0; n < made->times; n++)
        if (!isnan(made->value[n][value]) &&
            (value < TRUTH_CROSSINGS || made->value[n][value] > 0))
            return true;
    return false;
}

static void add_row(struct dataset *t, const struct truth *made, int n, double length)
{
    dataset_row(t);
    for (int c = 0; c < COLUMNS; c++) {
        const int value = columns[c].value;
        const double number = value == TIME        ? made->time[n]
                              : value == ERROR_BAR ? made->error[n]
                                                   : made->value[n][value];
        if (value == ERROR_BAR && n >= made->claimed)
            dataset_missing(t, "no claim");
        else if (value == TRUTH_CROSSINGS)
            dataset_add(t, "%.0f", number);
        else if (!columns[c].digits)
            dataset_add(t, "%.1f", number);
        else
            dataset_add(t, "%.*g", columns[c].digits,
                        columns[c].head.scale > 0 ? number / length : number);
    }
}

/* Says until when it is claimed, and what ends the claim. */
static void note_horizon(struct dataset *t, const struct truth *made,
                         const struct scene *scene)
{
    const double length = scene->length;
    const int n = made->claimed;
    const double percent = 100 / length, *v = made->value[n];
    char end[160], deep[48] = " of its finest run";

    if (n < made->times && !isnan(v[TRUTH_CROSSING_DEPTH]))
        snprintf(deep, sizeof deep, " of the material grid, %.2g mm deep",
                 1e3 * v[TRUTH_CROSSING_DEPTH]);
    if (n < made->times && v[TRUTH_CROSSINGS] > 0)
        snprintf(end, sizeof end,
                 "a sheet passes through %s there, on %g pairs of triangles%s",
                 scene_sheet_other(scene), v[TRUTH_CROSSINGS], deep);
    else if (n < made->times && v[TRUTH_THIRD] > made->error[n] + v[TRUTH_THIRD_BAR])
        snprintf(end, sizeof end,
                 "a third mechanics, with a bar of %.2g %%, is %.2g %% off there",
                 percent * v[TRUTH_THIRD_BAR], percent * v[TRUTH_THIRD]);
    else if (n < made->times && v[TRUTH_GROWTH] > TRUTH_MOST_GROWTH)
        snprintf(end, sizeof end, "the growth there, %.2g, is above %g", v[TRUTH_GROWTH],
                 TRUTH_MOST_GROWTH);
    else if (n < made->times)
        snprintf(end, sizeof end, "the error bar there, %.2g %%, is above %g %%",
                 percent * made->error[n], 100 * TRUTH_MOST_ERROR);
    if (n < made->times)
        dataset_note(t, "Nothing is claimed from %.3g s on: %s.", made->time[n], end);
    else
        dataset_note(t, "All of it is claimed.");
    if (n && !isnan(made->value[n - 1][TRUTH_CROSSINGS]) &&
        !(n < made->times && v[TRUTH_CROSSINGS] > 0))
        dataset_note(t,
                     "The sheet was searched up to %.3g s, and does not pass through %s.",
                     made->time[n - 1], scene_sheet_other(scene));
    dataset_note(t, "Horizon: %s.", made->horizon);
}

static void add_notes(struct dataset *t, const struct truth *made,
                      const struct scene *scene)
{
    dataset_note(t, "The truth: %s.", made->source);
    if (has_column(made, TRUTH_PACKING))
        dataset_note(t, "Packing: how far a point may have moved as positions were rounded "
                        "to be stored.");
    if (made->foreign)
        return;
    if (made->closed) {
        dataset_note(t, "Horizon: %s.", made->horizon);
        return;
    }
    dataset_note(t,
                 "Orders are of the rms over the material grid, over three nets and over "
                 "three steps, or over three runs of which both shrink; a dash means that "
                 "the differences do not shrink. A model's bar is the error that its "
                 "orders predict, times a factor of safety. Growth is the rms change "
                 "after gravity was changed by 1e-6 in the direction (1,1,1), over 1e-6 "
                 "of the length.");
    note_horizon(t, made, scene);
    if (*made->third)
        dataset_note(
            t,
            "The third mechanics is %s. Its distance is that from the truth's middle "
            "surface, and its bar is the error that its own order predicts.",
            made->third);
    if (*made->commit)
        dataset_note(t, "Made at commit %s with %s changed files.", made->commit,
                     made->changed);
}

/* Prints the times at which tables judge, of many frames, and the last claimed one. */
static enum status print(const struct truth *made, const struct scene *scene,
                         struct printer *p, struct message *why)
{
    struct dataset_column heads[COLUMNS];
    char caption[128];

    snprintf(caption, sizeof caption, "%s of %s: %serror bars",
             made->foreign ? "The third mechanics" : "Truth", scene->name,
             made->closed ? "" : "observed orders and ");
    for (int c = 0; c < COLUMNS; c++) {
        heads[c] = columns[c].head;
        if (scene->pattern && columns[c].value == TRUTH_SOLID_SPACE)
            heads[c].header = "turns: in space";
        if (scene->pattern && columns[c].value == TRUTH_SHELL_SPACE)
            heads[c].header = "slopes: in space";
        heads[c].readers =
            has_column(made, columns[c].value) ? columns[c].head.readers : DATASET_NOBODY;
    }
    struct dataset *t = dataset_create(COLUMNS, heads, caption);
    for (int n = 0; n < made->times; n++)
        if (made->closed || n == made->claimed - 1 ||
            truth_plan_judges(scene, made->time[n]))
            add_row(t, made, n, scene->length);
    add_notes(t, made, scene);
    return printer_table(p, t, NULL, why);
}

/* --- Positions --- */

/* Interpolates the mean of the two layers at (u, v). */
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

enum status truth_print_frames(const struct truth *made, const struct scene *scene,
                               const int points[2], FILE *file)
{
    fprintf(file, "# source: %s\n", made->source);
    for (int t = 0; t < made->claimed; t++)
        fprintf(file, "# bar: %.17g,%.17g\n", made->time[t], made->error[t]);
    fprintf(file, "t,u,v,x,y,z\n");
    for (int t = 0; t < made->claimed; t++)
        for (int n = 0; n < points[0] * points[1]; n++) {
            const double u = scene_sheet_inside(scene, n % points[0] / (points[0] - 1.0));
            const double v = n / points[0] / (points[1] - 1.0);
            double x[3];
            mid_surface(made->xyz[t], u, v, x);
            fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", made->time[t], u, v,
                    x[0], x[1], x[2]);
        }
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}

/* --- All scenes --- */

static void add_known(struct dataset *t, const struct truth *made, double length)
{
    const int last = made->claimed - 1;

    dataset_add(t, "%s|%.3g|%.2g", made->closed ? "closed form" : "stored",
                made->time[last], made->error[last] / length);
}

static enum status add_scene(struct dataset *t, const char *name, struct message *why)
{
    struct settings settings SCOPED(settings_clear) = {0};
    struct scene scene SCOPED(scene_clear) = {0};
    struct truth made SCOPED(truth_clear) = {0};
    struct message lack = {""};
    char *path SCOPED(scope_free) = NULL;
    enum status st;

    CALL(scene_file_find(name, &path, why));
    CALL(truth_plan_scene(path, &settings, &scene, why));
    st = truth_known(&scene, &made, &lack);
    if (st != STATUS_OK && st != STATUS_UNSUPPORTED && st != STATUS_FILE)
        return status_fail(why, st, "%s", lack.text);
    dataset_line(t, "%s", name);
    if (st == STATUS_OK && made.claimed) {
        add_known(t, &made, scene.length);
    } else {
        dataset_add(t, "none");
        dataset_note(t, "%s.", lack.text);
    }
    return STATUS_OK;
}

enum status truth_print_all(struct printer *p, struct message *why)
{
    static const struct dataset_column heads[] = {{"scene"},
                                                  {"truth"},
                                                  {"known to", "s", .key = "known_to_s"},
                                                  {"error bar there", "% L",
                                                   .key = "error_bar_over_length",
                                                   .scale = 100, .key_unit = "L"}};
    struct dataset *t = DATASET_OF(heads, "What is known of each scene");
    struct named_file_entry *scenes = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&scene_file_kind, &scenes, &count, why));
    for (int n = 0; n < count; n++)
        TRY(add_scene(t, scenes[n].name, why));
    st = printer_table(p, t, NULL, why), t = NULL;
out:
    named_file_list_free(scenes, count);
    dataset_destroy(t);
    return st;
}

/* --- The command --- */

enum { PATH = 4000, FRAMES_MOST = 1000 /* points a direction */ };

/* The error over the length that is requested without --error; the seconds that all runs
 * may take. */
static const double ERROR = 0.01, BUDGET = 3600;

/* The end of the motion with --quick, and what its runs may take [s]. */
static const double QUICK_UNTIL = 0.2, QUICK_BUDGET = 60;

struct job {
    char *path;
    struct scene scene;
    bool quick;
    struct settings settings;
    struct printer *printer;
    double until;
    bool must; /* the error was requested: exit 1 where it can't be had                */
    struct truth_wish wish;
    struct truth_end end;
};

static enum status read_wish(struct job *j, const struct command_line *line,
                             struct message *why)
{
    j->quick = command_given(line, "--quick");
    j->must = command_given(line, "--error");
    j->wish.error = j->quick ? TRUTH_MOST_ERROR : ERROR;
    j->wish.seconds = j->quick ? QUICK_BUDGET : BUDGET;
    j->until = j->quick ? QUICK_UNTIL : INFINITY;
    CALL(command_number(line, "--error", true, &j->wish.error, why));
    CALL(command_number(line, "--budget", false, &j->wish.seconds, why));
    CALL(command_number(line, "--until", false, &j->until, why));
    if (j->must && j->wish.error >= TRUTH_MOST_ERROR)
        return status_fail(
            why, STATUS_INPUT,
            "--error %s: less than %g%% would be right, as no truth is claimed "
            "beyond",
            command_value(line, "--error"), 100 * TRUTH_MOST_ERROR);
    if (j->quick && j->must)
        return status_fail(why, STATUS_INPUT,
                           "truth takes --quick or --error, one of the two");
    return STATUS_OK;
}

/* Makes a truth by runs, which are kept in a folder of their own. */
static enum status make_by_runs(struct job *j, const char *own, struct truth_runs *runs,
                                struct truth *made, struct message *why)
{
    const double until = isfinite(j->until) ? j->until : j->scene.end;
    char folder[PATH];
    double *time SCOPED(scope_free) = NULL;

    snprintf(folder, sizeof folder, "results/truth_%s%s", j->scene.name,
             j->quick ? "_quick" : "");
    runs->folder = own ? own : folder;
    runs->frame = truth_plan_frame(&j->scene);
    runs->times = truth_plan_times(until, runs->frame, &j->scene, &time);
    runs->time = time;
    if (runs->times < 0)
        CALL(STATUS_MEMORY);
    if (!runs->times)
        return status_fail(why, STATUS_INPUT, "--until %g: a frame is %g s long", until,
                           TRUTH_PLAN_FRAME);
    CALL(folder_make(runs->folder, why));
    timing_alone();
    CALL(truth_make(runs, &j->scene, &j->wish, made, &j->end, why));
    fprintf(stderr, "its runs are in %s\n", runs->folder);
    return STATUS_OK;
}

/* Refuses to store what a program makes that is not that of a commit. */
static enum status check_program(const char *path, struct message *why)
{
    struct provenance program;

    provenance_collect(&program);
    const char *commit = provenance_value(&program, "commit");
    const char *changed = provenance_value(&program, "changed_files");
    if (strcmp(commit, "unknown") != 0 && strcmp(changed, "0") == 0)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: truths that come with the program are made from a commit with "
                       "no file changed; this is commit %s with %s changed",
                       path, commit, changed);
}

/* Chooses FILE, the folder of those that come with the program, or the results. */
static enum status choose_file(const struct job *j, const struct command_line *line,
                               char file[PATH], struct message *why)
{
    const char *out = command_value(line, "--out");
    const bool store = command_given(line, "--store");
    const char *all = j->quick ? TRUTH_FILE_LEFT "_quick" : TRUTH_FILE_LEFT;
    enum status st = STATUS_OK;

    if (out && store)
        return status_fail(why, STATUS_INPUT,
                           "truth takes --out or --store, one of the two");
    if (!out && !store)
        CALL(folder_make(all, why));
    if (out)
        snprintf(file, PATH, "%s", out);
    else
        snprintf(file, PATH, "%s/%s.h5", store ? truth_file_kind.in_source : all,
                 j->scene.name);
    if (store)
        CALL(check_program(file, why));
    st = store_try(file, why); /* is said before all runs, not after them */
    return st;
}

/* Makes the truth, by closed forms or runs; or beside it, in third/, what --third has. */
static enum status make(struct job *j, const struct command_line *line, struct message *why)
{
    struct truth_runs runs = {.path = j->path, .settings = &j->settings, .say = stderr};
    const char *third = command_value(line, "--third");
    struct truth made SCOPED(truth_clear) = {0};
    char truth[PATH], file[PATH + 8];
    enum status st;

    if (!third)
        CALL(truth_plan_check(&j->scene, why));
    CALL(choose_file(j, line, truth, why));
    if (third) {
        CALL(truth_file_third(truth, file, sizeof file, why));
        CALL(truth_third_make(third, j->scene.length, &made, why));
        char *slash = strrchr(file, '/');
        *slash = '\0';
        CALL(folder_make(file, why));
        *slash = '/';
    } else {
        snprintf(file, sizeof file, "%s", truth);
        st = truth_closed_make(&j->scene, &made);
        CALL(st == STATUS_UNSUPPORTED
                 ? make_by_runs(j, command_value(line, "--runs"), &runs, &made, why)
                 : st);
    }
    truth_pack(&made, j->scene.length);
    CALL(truth_file_write(file, &runs, &made, why));
    if (!third) {
        CALL(truth_crossing_judge(&made, j->scene.sheets));
        truth_crossing_tell(&made, &j->scene, &j->end);
    }
    CALL(print(&made, &j->scene, j->printer, why));
    fprintf(stderr, "%s in %s\n", third ? "third mechanics" : "truth", file);
    if (j->must && j->end.answer != TRUTH_MET)
        return status_fail(why, STATUS_FAILED, "%s", j->end.text);
    if (*j->end.text)
        fprintf(stderr, "truth: %s\n", j->end.text);
    return STATUS_OK;
}

/* Prints what is known without a run. */
static enum status print_known(const struct job *j, const int points[2],
                               struct message *why)
{
    struct truth made;
    enum status st = truth_known(&j->scene, &made, why);

    if (st == STATUS_OK)
        st = *points ? truth_print_frames(&made, &j->scene, points, stdout)
                     : print(&made, &j->scene, j->printer, why);
    truth_clear(&made);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a name that is none */
}

static enum status run(struct command_line *line, struct message *why)
{
    const bool stored = command_given(line, "--stored");
    struct job j = {.printer = &line->printer};
    int points[2] = {0, 0}, count;
    const char *const *given = command_values(line, "--set", &count);
    enum status st;

    if (!line->word_count && (!stored || command_given(line, "--points")))
        TRY(status_fail(why, STATUS_INPUT,
                        "truth SCENE; without one --stored alone, what is known of all"));
    if (!line->word_count)
        return truth_print_all(j.printer, why);
    settings_set_all(&j.settings, count, given);
    TRY(read_wish(&j, line, why));
    TRY(scene_file_find(line->words[0], &j.path, why));
    TRY(truth_plan_scene(j.path, &j.settings, &j.scene, why));
    TRY(command_pair(line, "--points", 2, FRAMES_MOST, points, why));
    if (*points && !stored)
        TRY(status_fail(
            why, STATUS_INPUT,
            "--points prints positions of a truth that is known: with --stored"));
    TRY(stored ? print_known(&j, points, why) : make(&j, line, why));
out:
    settings_clear(&j.settings);
    scene_clear(&j.scene);
    free(j.path);
    return st;
}

static const struct command_option options[] = {
    {"--set", "KEY=VALUE", true, "change a key of the scene"},
    {"--error", "PERCENT", false,
     "largest error bar, of the length, below 5% (1%); exit\n"
     "code 1 if it is not reached"},
    {"--budget", "SECONDS", false, "time for all runs together (3600)"},
    {"--until", "SECONDS", false, "end of the motion (the scene's)"},
    {"--out", "FILE", false, "file of the truth (results/truths/SCENE.h5)"},
    {"--store", NULL, false, "store the truth among those that come with the program"},
    {"--runs", "FOLDER", false, "folder of the runs (results/truth_SCENE)"},
    {"--stored", NULL, false,
     "run nothing: print the table of the stored truth or\n"
     "closed form; without SCENE, of all scenes"},
    {"--third", "FOLDER", false,
     "run nothing: extrapolate somebody else's frames on three\n"
     "nets and store them beside the truth, in third/ of its\n"
     "folder"},
    {"--points", "N,M", false,
     "with --stored: print positions as CSV t,u,v,x,y,z on a\n"
     "net of so many points"},
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {"--quick", NULL, false, "coarse nets to 0.2 s, for trying out"},
    {NULL, NULL, false, NULL},
};

const struct command truth_command = {
    .name = "truth",
    .summary = "compute a scene's motion with an error bar, or print what is known of it",
    .arguments = "[SCENE] [OPTION]...",
    .text =
        "If the scene is a closed form (a free fall; nu = 0 and hanging or clamped\n"
        "level, at rest under mass damping), its truth is known at once. Otherwise the\n"
        "command runs the nonlinear solid and the nonlinear shell, both cured of\n"
        "locking, on finer and finer nets with shorter and shorter steps (of a sheet with\n"
        "an outline triangles of two kinds, on two meshes), until the\n"
        "error bar is as small as requested. It stops earlier, and says so, at the\n"
        "horizon, at the end of the budget, or where the two models contradict each\n"
        "other. It prints the observed orders, the error bars that follow from them, the\n"
        "difference of the two models, and the time until which the motion is\n"
        "predictable: one run is repeated with gravity changed by 1e-6. At each time it\n"
        "stores the field of the model with the smaller bar; the truth's bar is that bar\n"
        "or, if larger, the difference. Nothing is claimed from the time on at which the\n"
        "sheet passes through itself or another one.\n"
        "\n"
        "Truths of some scenes come with the program; `compare` and other commands use\n"
        "these, those in $CLOTHBENCH_TRUTHS and those in results/truths. A scene with\n"
        "velocity_scale, a damping that is not a rate, has an undamped truth. Runs are "
        "stored, and a command that\n"
        "was killed continues where it was.\n",
    .examples =
        "truth edge_drop --stored\ntruth edge_drop --stored --points 21,21\n"
        "truth --stored\ntruth sphere --quick\ntruth mine.yaml --error 0.5% --until 0.3\n"
        "truth flag --set material.young=1e5 --out flag.h5\n",
    .most = 1,
    .options = options,
    .run = run,
};
