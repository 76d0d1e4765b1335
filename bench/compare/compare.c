#include "bench/compare/compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/compare/league.h"
#include "bench/experiment/batch.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/ui/show.h"
#include "models/clock.h"
#include "models/damping.h"
#include "models/reader/scene_file.h"

/* The time up to which scenes are compared: an edge drop's first quarter swing, before
 * motions part for good [s]. */
static const double UNTIL = 0.5;

/* --- one scene: its contest, from the ladder over the search to the limits --- */

/* Chooses how the truth is damped (truth.h), and all contestants but the paper's own
 * scheme. */
static void choose_damping(struct compare_job *j)
{
    const char *truth = truth_plan_damping(&j->scene);

    snprintf(j->contest.physics, sizeof j->contest.physics, "damping %s",
             damping_words[j->scene.damping.kind]);
    settings_append(&j->truth, &j->user);
    for (int n = 0; n < j->user.count; n++)
        if (!strncmp(j->user.text[n], "damping", 7))
            return;
    if (!truth)
        return;
    settings_set(&j->truth, truth);
    snprintf(j->contest.physics, sizeof j->contest.physics,
             "undamped, but for the paper's own scheme with velocity_scale %g",
             j->scene.damping.value);
}

static enum status spread_times(struct compare_job *j, double until, struct message *why)
{
    j->times = CONTEST_TIMES;
    for (int n = 0; n < j->times; n++)
        j->time[n] =
            fmax(1, round((n + 1) * until / j->times / j->scene.step)) * j->scene.step;
    for (int n = 1; n < j->times; n++)
        if (j->time[n] <= j->time[n - 1])
            return status_fail(why, STATUS_INPUT,
                               "--until %g: at least %d frames of %g s are needed", until,
                               j->times, j->scene.step);
    return STATUS_OK;
}

static enum status choose_times(struct compare_job *j, double until, struct message *why)
{
    const double most = fmin(UNTIL, j->scene.end);

    if (!isnan(until))
        return spread_times(j, until, why);
    /* late: known at rest, at the end */
    for (int late = 0; late < 2 && !j->times; late++)
        CALL(truth_stored_times(j->path, &j->truth, late ? j->scene.end : most,
                                CONTEST_TIMES, j->time, &j->times, why));
    return j->times ? STATUS_OK : spread_times(j, most, why);
}

enum status compare_job_open(struct compare_job *j, const char *scene, double until,
                             struct message *why)
{
    CALL(scene_file_find(scene, &j->path, why));
    CALL(contestant_read_scene(&j->user, j->path, &j->scene, why));
    j->contest.scene = &j->scene;
    choose_damping(j);
    return choose_times(j, until, why);
}

void compare_job_close(struct compare_job *j)
{
    contest_clear(&j->contest);
    settings_clear(&j->user);
    settings_clear(&j->truth);
    truth_destroy(j->found);
    scene_clear(&j->scene);
    free(j->path);
}

enum status compare_job_enter(struct compare_job *j, const char *models, int rungs,
                              bool paper_scheme, struct message *why)
{
    const struct model *model;
    struct contest_at at[CONTEST_RUNGS];

    CALL(contestant_check(models, why));
    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *who = contestant_table; who->name; who++) {
            if (who->model != model || !contestant_chosen(who, models, CONTESTANT_COMPARE))
                continue;
            if (!paper_scheme && contestant_is_paper_scheme(who))
                continue;
            const int count = contest_ladder(&j->contest, who, at);
            for (int n = 0; n < count && n < rungs; n++)
                contest_add(&j->contest, &at[n]);
        }
    return STATUS_OK;
}

enum status compare_job_truth(struct compare_job *j, const struct truth_wish *wish,
                              struct message *said, struct message *why)
{
    struct truth_wish by = *wish;

    by.until = j->until = clock_now() + wish->seconds;
    const enum status st = truth_find_or_make(j->path, &j->truth, j->times, j->time,
                                              j->folder, &by, &j->found, said);

    j->contest.truth = j->found;
    if (st == STATUS_UNSUPPORTED || st == STATUS_LATE || status_is_death(st))
        return STATUS_OK;
    return st ? status_fail(why, st, "%s", said->text) : STATUS_OK;
}

/* --- runs --- */

/* Adds a row's run to a batch. Its file is named after the points along u, the steps and
 * the iterations; after the points across, too, where cells are not about square. */
static void plan_row(struct compare_job *j, const struct contest_row *row,
                     struct batch *batch)
{
    const struct contest_at *at = &row->at;
    const int along = at->size[CONTEST_NET], across = at->size[CONTEST_ACROSS];
    char name[128], more[16] = "";

    if (across != contest_across(&j->contest, at->contestant, along))
        snprintf(more, sizeof more, "x%d", across);
    snprintf(name, sizeof name, "%s_%d%s_%d_%d", at->contestant->name, along, more,
             at->size[CONTEST_STEP], at->size[CONTEST_ITERATIONS]);
    struct case_plan *c = batch_add(batch, j->path, at->contestant, name);
    c->end = j->time[j->times - 1];
    c->keep.times = j->times;
    c->keep.time = j->time;
    c->keep.fields = RUN_FIELDS_TIMES;
    c->keep.intersections = j->contest.advises;
    c->timed = row->probe ? CASE_UNTIMED : CASE_WHOLE;
    settings_append(&c->settings,
                    contestant_is_paper_scheme(at->contestant) ? &j->user : &j->truth);
    /* again: the user's settings do not change what defines it */
    contestant_settings(at->contestant, &c->settings);
    contest_settings(&j->contest, at, &c->settings);
}

enum status compare_job_rows(void *job, int first, struct message *why)
{
    struct compare_job *j = job;
    struct contest *c = &j->contest;
    const bool needed = first == 0 && !(c->budget > 0); /* no budget cut the ladder short */
    const struct measurement_options options = {
        .what = "compare", .quick = c->quick, .until = j->until, .taken = &j->taken};
    struct batch batch SCOPED(batch_clear) = {0};
    struct message said = {""};
    enum status late = STATUS_OK;

    batch_init(&batch, j->folder, c->count - first);
    for (int n = first; n < c->count; n++)
        plan_row(j, &c->rows[n], &batch);
    if (!j->read_only)
        late = batch_run(&batch, &options, &said);
    if (late != STATUS_LATE && late != STATUS_OK)
        return status_fail(why, late, "%s", said.text);
    for (int n = first; n < c->count; n++) {
        const struct case_plan *of = &batch.cases[n - first];
        struct run_result r = {0};
        if ((late && !of->done) ||
            (!needed && j->read_only && access(of->keep.file, F_OK) != 0)) {
            contest_set_absent(&c->rows[n]);
            continue;
        }
        CALL(run_result_read(of->keep.file, true, &r, why));
        contest_fill(c, &r, &c->rows[n]);
        run_result_clear(&r);
    }
    return late ? status_fail(why, late, "%s", said.text) : late;
}

static enum status measure_all(struct compare_job *j, struct message *why)
{
    struct contest *c = &j->contest;

    CALL(compare_job_rows(j, 0, why));
    CALL(contest_search_all(c, compare_job_rows, j, why));
    const int searched = c->count;
    contest_search_limits(c);
    if (c->count > searched)
        CALL(compare_job_rows(j, searched, why));
    return STATUS_OK;
}

/* Runs and times the ladder, the rows that it makes worth a try (contest_search_all), then,
 * untimed, those that tell the limits of each; or as much of that as the budget has time
 * for. */
static enum status compare_job_measure(struct compare_job *j, struct message *why)
{
    struct contest *c = &j->contest;
    struct message said = {""};
    enum status st = measure_all(j, &said);
    const int all = c->count;

    contest_drop_absent(c);
    if (st == STATUS_LATE) {
        fprintf(stderr, "compare: %s; %d of %d runs were skipped\n", said.text,
                all - c->count, all);
        contest_tell_unsearched(c);
        st = STATUS_OK;
    }
    measurement_tell("compare", &j->taken, j->folder);
    return st ? status_fail(why, st, "%s", said.text) : st;
}

/* --- all runs --- */

enum { FIXED = 15, MOST_COLUMNS = FIXED + CONTEST_TIMES + 4 };

/* Strings that the columns of the table of runs borrow. */
struct words {
    char header[CONTEST_TIMES][32], key[CONTEST_TIMES][48], caption[256];
};

static struct dataset *create_runs(const struct contest *c, struct words *w)
{
    struct dataset_column columns[MOST_COLUMNS] = {
        {"title", .readers = DATASET_MACHINES},
        {"model", .key = "column", .readers = DATASET_PEOPLE},
        {"contestant", .readers = DATASET_MACHINES},
        {"model", .key = "model", .readers = DATASET_MACHINES},
        {"side", .readers = DATASET_MACHINES},
        {"across", .readers = DATASET_MACHINES},
        {"net", .readers = DATASET_PEOPLE},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"unknowns"},
        {"set-up", "ms", .key = "setup_s", .key_unit = "s", .scale = 1e3},
        {"stepping", "s"},
        {"repeats"},
        {"memory", "MB", .key = "model_bytes", .key_unit = "B", .scale = 1e-6},
        {"set-up and stepping", "s", .key = "seconds", .readers = DATASET_MACHINES}};
    const struct dataset_column more[] = {
        {"RMSE / L at the worst time", .key = "worst_rmse_over_length",
         .readers = DATASET_MACHINES},
        {"bar", .key = "bar_over_length", .readers = DATASET_MACHINES},
        {"front", .readers = DATASET_MACHINES},
        {"outcome", .readers = DATASET_MACHINES}};
    int count = FIXED;

    for (int n = 0; n < c->truth->times; n++) {
        snprintf(w->header[n], sizeof w->header[n], "%.3g s", c->truth->time[n]);
        snprintf(w->key[n], sizeof w->key[n], "rmse_over_length_%.3g_s", c->truth->time[n]);
        columns[count++] = (struct dataset_column){w->header[n], "%", .key = w->key[n],
                                                   .key_unit = "1", .scale = 100};
    }
    for (size_t n = 0; n < sizeof more / sizeof *more; n++)
        columns[count++] = more[n];
    snprintf(w->caption, sizeof w->caption,
             "Every run on %s (Gamma = %.4g, %s): RMSE/L at %d times", c->scene->name,
             scene_gamma(c->scene), c->physics, c->truth->times);
    return dataset_create(count, columns, w->caption);
}

static void note_end(struct dataset *t, const struct contest *c,
                     const struct contest_row *r)
{
    const char *title = r->at.contestant->title;
    const int side = r->at.size[CONTEST_NET], across = r->at.size[CONTEST_ACROSS];

    if (run_result_refused(&r->result))
        dataset_note(t, "%s, %dx%d: %s.", title, side, across, r->result.sentence.text);
    else if (r->result.outcome || run_result_missed(&r->result))
        dataset_note(t, "%s, %dx%d, step %.3g ms: %s.", title, side, across,
                     1e3 * c->scene->step / r->at.size[CONTEST_STEP],
                     r->result.sentence.text);
}

static void add_run(struct dataset *t, const struct contest *c, const struct contest_row *r)
{
    const struct contestant *who = r->at.contestant;
    const bool ran = !run_result_refused(&r->result), timed = ran && !r->probe;
    const int *size = r->at.size, along = size[CONTEST_NET], across = size[CONTEST_ACROSS];

    dataset_line(t, "%s|%s|%s|%s|%d|%d|%dx%d|%.3g|%.0f", who->title, who->column, who->name,
                 who->model->name, along, across, along, across,
                 c->scene->step / size[CONTEST_STEP],
                 size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : NAN);
    dataset_add(t, "%.0f|%.3g|%.3g|%.0f|%.2g|%.3g", ran ? r->result.unknowns : NAN,
                timed ? r->result.create.median : NAN,
                timed ? r->result.step.median * (double)r->result.steps : NAN,
                timed ? r->result.step.count : NAN, timed ? r->result.bytes : NAN,
                timed ? r->seconds : NAN);
    for (int n = 0; n < c->truth->times; n++)
        dataset_add(t, "%.3g", r->error[n]);
    dataset_add(t, "%.3g|%.3g|%d|%s", r->worst, contest_largest_bar(c),
                contest_on_front(c, r), r->result.sentence.text);
    note_end(t, c, r);
}

static void add_bar(struct dataset *t, const struct contest *c)
{
    const bool known = c->truth->xyz;

    dataset_rule(t);
    dataset_line(t, "-|%s", c->truth->alone ? truth_bar_name(c->truth) : "truth's bar");
    for (int n = 2; n < FIXED; n++)
        dataset_add(t, "-");
    for (int n = 0; n < c->truth->times; n++)
        dataset_add(t, "%.3g", contest_bar(c, n));
    dataset_note(t,
                 "Truth: %s. All runs used one thread, and seconds are medians of the "
                 "repeats%s.",
                 c->truth->source,
                 known
                     ? ". Runs without repeats were not timed; they only show what limits "
                       "the error"
                     : "");
    dataset_note(
        t, "Memory is what the model holds after its last step, counted by malloc. %s",
        contest_rule);
    if (c->budget > 0)
        dataset_note(
            t,
            "The budget was %g s of runs, cheap ones first, and %.3g s were used. It "
            "left out (contestant, runs): %s.",
            c->budget, contest_spent(c), *c->unsearched ? c->unsearched : "nothing");
}

static enum status print_runs(const struct contest *c, struct printer *p,
                              struct message *why)
{
    struct words words;
    struct dataset *t = create_runs(c, &words);
    const struct contestant *who;
    enum status st;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        if (k)
            dataset_rule(t);
        for (int n = 0; n < c->count; n++)
            if (c->rows[n].at.contestant == who)
                add_run(t, c, &c->rows[n]);
    }
    TRY(printer_save(p, t, "compare", why));
    add_bar(t, c);
    return printer_table(p, t, NULL, why);
out:
    dataset_destroy(t);
    return st;
}

/* --- for errors, and limits --- */

/* A run in five columns for machines, after one for people: "0.078 20x12/4". */
enum { RUN_COLUMNS = 6 };

/* Strings that the columns of a run borrow. */
struct run_words {
    char header[16], key[RUN_COLUMNS - 1][32];
};

/* Fills the columns of a run; a key is `before`, the word for what it holds, `after`. */
static void set_columns(struct dataset_column *column, struct run_words *w,
                        const char *unit, const char *value, const char *before,
                        const char *after)
{
    const char *const what[] = {value, "side", "across", "step_s", "iterations"};

    *column++ = (struct dataset_column){w->header, unit, .readers = DATASET_PEOPLE};
    for (int n = 0; n < RUN_COLUMNS - 1; n++) {
        snprintf(w->key[n], sizeof w->key[n], "%s%s%s", before, what[n], after);
        *column++ = (struct dataset_column){w->key[n], .key = w->key[n],
                                            .readers = DATASET_MACHINES};
    }
}

/* Fills the cells of a run, with a value that people see `scale` times as large; r NULL:
 * there is no such run, `none`. */
static void add_shown(struct dataset *t, const struct contest *c,
                      const struct contest_row *r, double value, double scale,
                      const char *none)
{
    if (!r) {
        dataset_missing(t, "%s", none);
        for (int n = 1; n < RUN_COLUMNS; n++)
            dataset_add(t, "-");
        return;
    }
    const int *size = r->at.size, iterations = size[CONTEST_ITERATIONS];
    char last[16] = "";
    if (iterations)
        snprintf(last, sizeof last, "/%d", iterations);
    dataset_text(t, scale * value < 99.5 ? "%.2g %dx%d/%d%s" : "%.0f %dx%d/%d%s",
                 scale * value, size[CONTEST_NET], size[CONTEST_ACROSS], size[CONTEST_STEP],
                 last);
    dataset_add(t, "%.3g|%d|%d|%.3g|%.0f", value, size[CONTEST_NET], size[CONTEST_ACROSS],
                c->scene->step / size[CONTEST_STEP], iterations ? iterations : NAN);
}

static enum status print_targets(const struct contest *c, struct printer *p,
                                 struct message *why)
{
    enum { WHO = 2, COLUMNS = WHO + CONTEST_TARGETS * RUN_COLUMNS + 1 };
    struct dataset_column columns[COLUMNS] = {{"model", .key = "title"},
                                              {"contestant", .readers = DATASET_MACHINES},
                                              [COLUMNS - 1] = {"growth", .key = "growth"}};
    struct run_words words[CONTEST_TARGETS];
    const struct contestant *who;

    for (int n = 0; n < CONTEST_TARGETS; n++) {
        char target[16];
        snprintf(words[n].header, sizeof words[n].header, "%g %%", 100 * contest_target[n]);
        snprintf(target, sizeof target, "_%g", contest_target[n]);
        set_columns(&columns[WHO + n * RUN_COLUMNS], &words[n], "s", "seconds", "", target);
    }
    struct dataset *t = dataset_create(
        COLUMNS, columns,
        "Least seconds (set-up and stepping) to an RMSE/L at the worst of the "
        "times, and what reaches it");
    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        dataset_line(t, "%s|%s", who->title, who->name);
        for (int n = 0; n < CONTEST_TARGETS; n++) {
            const struct contest_row *r = contest_cheapest(c, who, contest_target[n]);
            add_shown(t, c, r, r ? r->seconds : NAN, 1, "not reached");
        }
        dataset_add(t, "%.2g", contest_growth(c, who));
    }
    dataset_note(
        t,
        "40x12/16 means 40 points along u and 12 across, and 16 steps to the scene's frame "
        "of %.3g ms; a third number counts iterations.",
        1e3 * c->scene->step);
    dataset_note(
        t, "Growth is the power p with which seconds grow as error^-p along the best runs "
           "(three or more).");
    return printer_table(p, t, "compare_targets", why);
}

static void add_limit(struct dataset *t, const struct contest *c,
                      const struct contestant *who)
{
    const struct contest_row *best = contest_nearest(c, who);
    const struct contest_row *real =
        contest_within(c, who, c->truth->time[c->truth->times - 1]);
    const struct contest_limit limit = contest_limit(c, who);
    struct message words;

    dataset_line(t, "%s|%s", who->title, who->name);
    add_shown(t, c, real, real ? real->worst : NAN, 100, "none");
    add_shown(t, c, best, best ? best->worst : NAN, 100, "none");
    contest_tell(c, &limit, &words);
    dataset_add(t, "%s|%s", words.text, contest_kind_name[limit.kind]);
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        dataset_add(t, "%.3g", limit.gain[axis]);
}

static enum status print_limits(const struct contest *c, struct printer *p,
                                struct message *why)
{
    enum { REAL = 2, LOWEST = REAL + RUN_COLUMNS, LIMIT = LOWEST + RUN_COLUMNS };
    static const struct dataset_column limit[] = {
        {"limited by", .key = "sentence"},
        {"limit", .readers = DATASET_MACHINES},
        {"net_gain", .key = "net_gain", .readers = DATASET_MACHINES},
        {"across_gain", .key = "across_gain", .readers = DATASET_MACHINES},
        {"step_gain", .key = "step_gain", .readers = DATASET_MACHINES},
        {"iterations_gain", .key = "iterations_gain", .readers = DATASET_MACHINES}};
    struct dataset_column columns[LIMIT + sizeof limit / sizeof *limit] = {
        {"model", .key = "title"}, {"contestant", .readers = DATASET_MACHINES}};
    struct run_words real = {"in real time"}, lowest = {"lowest"};
    const struct contestant *who;

    set_columns(&columns[REAL], &real, "% L", "rmse_over_length", "real_time_", "");
    set_columns(&columns[LOWEST], &lowest, "% L", "rmse_over_length", "lowest_", "");
    memcpy(&columns[LIMIT], limit, sizeof limit);
    struct dataset *t =
        DATASET_OF(columns, "Lowest RMSE/L at the worst of the times, and why");
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        add_limit(t, c, who);
    dataset_note(
        t,
        "The column `in real time` is the lowest error of runs that took no longer, set-up "
        "included, than the %.3g s that they simulate. The column `limited by` follows "
        "from repeating the most accurate run with half as many points more (in both "
        "directions if its cells are about square, else along u), with half as many more "
        "across, with half the step, or with twice the iterations, one at a time: it names "
        "the change that lowers the error most, by %.0f %% at least. `The truth` means "
        "that the error is %g bars of the truth or less, each %.2g %% at most.",
        c->truth->time[c->truth->times - 1], 100 * CONTEST_LEAST_GAIN, CONTEST_NEAR_BAR,
        100 * contest_largest_bar(c));
    return printer_table(p, t, "compare_limits", why);
}

enum status compare_print(const struct contest *c, struct printer *p, struct message *why)
{
    CALL(print_runs(c, p, why));
    if (!c->truth->xyz)
        return STATUS_OK;
    CALL(print_targets(c, p, why));
    return print_limits(c, p, why);
}

enum { MOST_SCENES = 16 };

/* Seconds that a run which the search proposes may take, unless --longest says another. */
static const double LONGEST = 3;

/* --- the command --- */

/* Reads --longest, the only option of seconds that may be 0. */
static enum status read_longest(struct contest *c, const struct command_line *line,
                                struct message *why)
{
    const char *word = command_value(line, "--longest");
    char *end = NULL;

    c->longest = word ? strtod(word, &end) : c->quick ? 0 : LONGEST;
    if (word && (end == word || *end || !(c->longest >= 0)))
        return status_fail(
            why, STATUS_INPUT,
            "--longest %s: seconds, or 0 for no search beyond the ladder, would be right",
            word);
    return STATUS_OK;
}

/* Reads a scene and the options; nothing is run. */
static enum status prepare(struct compare_job *j, const struct command_line *line,
                           const char *scene, struct message *why)
{
    int given;
    double until = NAN;
    const char *const *set = command_values(line, "--set", &given);

    j->contest.quick = command_given(line, "--quick");
    j->read_only = command_given(line, "--from");
    settings_set_all(&j->user, given, set);
    CALL(command_number(line, "--until", false, &until, why));
    CALL(compare_job_open(j, scene, until, why));
    CALL(read_longest(&j->contest, line, why));
    return command_number(line, "--budget", false, &j->contest.budget, why);
}

/* Leaves times out at which the truth can tell none of the targets, and says so where the
 * truth is named. */
static void leave_vague_times(struct compare_job *j)
{
    struct truth *t = j->found;
    const double most = contest_target[0] * j->scene.length;
    const int all = t->times;

    while (t->times > 1 && t->error[t->times - 1] > most)
        t->times--;
    if (t->times < all)
        TEXT_ADD(t->source,
                 "; compared up to %.3g s, as its error bar at %.3g s is %.2g %% of L",
                 t->time[t->times - 1], t->time[t->times],
                 100 * t->error[t->times] / j->scene.length);
    j->times = t->times;
}

/* Seconds that remain for runs under any budget: enough for the coarsest of each
 * contestant. */
static const double LEAST_BUDGET = 10;

/* Returns the error bar that runs for a truth should reach, the least target, and how long
 * they may take; less of both for a quick call and one with a budget. */
static struct truth_wish wish_of(const struct contest *c)
{
    const double seconds = c->quick ? 30 : 240;

    return (struct truth_wish){contest_target[c->quick ? 2 : CONTEST_TARGETS - 1],
                               c->budget > 0 ? fmin(seconds, c->budget / 3) : seconds,
                               .alone = true};
}

/* Finds the truth, and the deadline of what follows. Without a truth the contestants run
 * nevertheless. */
static enum status find_truth(struct compare_job *j, bool all_times, struct message *why)
{
    const struct truth_wish wish = wish_of(&j->contest);
    const double start = clock_now(), budget = j->contest.budget;
    struct message said = {""};
    const enum status st = compare_job_truth(j, &wish, &said, why);

    j->until = budget > 0 ? fmax(start + budget, clock_now() + LEAST_BUDGET) : 0;
    if (j->found && !all_times)
        leave_vague_times(j);
    if (st || j->found)
        return st;
    fprintf(stderr, "compare: no truth, and so no errors: %s\n", said.text);
    j->none = (struct truth){.times = j->times, .time = j->time};
    snprintf(j->none.source, sizeof j->none.source, "none; %.500s", said.text);
    j->contest.truth = &j->none;
    return STATUS_OK;
}

/* Runs a scene and prints what came of it; its files are in the folder of --from or --out,
 * `given`, in which several scenes have a folder each. */
static enum status run_scene(struct compare_job *j, struct command_line *line,
                             const char *given, struct message *why)
{
    struct arena *arena = &j->contest.arena;
    const char *scene = j->scene.name;

    j->folder = !given                  ? arena_print(arena, "results/compare_%s", scene)
                : line->word_count == 1 ? given
                                        : arena_print(arena, "%s/%s", given, scene);
    CALL(compare_job_enter(j, command_value(line, "--models"),
                           j->contest.budget > 0 ? 1 : CONTEST_RUNGS, true, why));
    if (!j->read_only)
        CALL(folder_make(j->folder, why));
    timing_alone();
    CALL(find_truth(j, command_value(line, "--until"), why));
    if (*j->contest.truth->unresolved && printer_is_prose(&line->printer))
        wrap_say(stdout, "%s", j->contest.truth->unresolved);
    CALL(compare_job_measure(j, why));
    line->printer.folder = j->folder;
    CALL(compare_print(&j->contest, &line->printer, why));
    show_tell(j->folder);
    return STATUS_OK;
}

/* Reads all scenes, before the first is run: each has a name of its own. */
static enum status prepare_all(const struct command_line *line, struct compare_job *jobs,
                               struct message *why)
{
    for (int n = 0; n < line->word_count; n++) {
        CALL(prepare(&jobs[n], line, line->words[n], why));
        for (int k = 0; k < n; k++)
            if (!strcmp(jobs[k].scene.name, jobs[n].scene.name))
                return status_fail(why, STATUS_INPUT, "%s: two scenes of the name %s",
                                   line->words[n], jobs[n].scene.name);
    }
    return STATUS_OK;
}

static enum status run(struct command_line *line, struct message *why)
{
    const char *given = NULL, *from;
    const struct contest *contests[MOST_SCENES];
    struct arena arena = {0};
    struct compare_job *jobs = arena_take(&arena, MOST_SCENES, sizeof *jobs);
    enum status st;

    TRY(command_folder(line, &given, &from, why));
    TRY(prepare_all(line, jobs, why));
    for (int n = 0; n < line->word_count; n++) {
        TRY(run_scene(&jobs[n], line, given, why));
        contests[n] = &jobs[n].contest;
    }
    line->printer.folder = given ? given : "results";
    if (line->word_count > 1)
        TRY(league_print(line->word_count, contests, &line->printer, why));
out:
    for (int n = 0; n < MOST_SCENES; n++)
        compare_job_close(&jobs[n]);
    arena_clear(&arena);
    return st;
}

static const struct command_option options[] = {
    {"--models", "NAME,NAME,...", false,
     "models or contestants (those that take part here;\n"
     "`clothbench list contestants`)"},
    {"--set", "KEY=VALUE", true, "change a key of the scene"},
    {"--until", "SECONDS", false,
     "compare at five times up to this one (0.5, or those of\n"
     "the stored truth before it that it knows to 3 %)"},
    {"--longest", "SECONDS", false,
     "longest run that the search for the best net, points\n"
     "across it, step and iterations may try (3; 0: no search)"},
    {"--budget", "SECONDS", false,
     "time for all runs of a scene together (no limit); cheap\n"
     "ones go first, and what is left out is printed"},
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false,
     "folder of result files and CSV\n"
     "(results/compare_SCENE)"},
    {"--from", "DIR", false, "print again from the result files of an earlier run"},
    {"--quick", NULL, false, "the cheap half of the nets, no search, three repeats"},
    {NULL, NULL, false, NULL},
};

const struct command compare_command = {
    .name = "compare",
    .summary = "measure speed against error of all models, on a scene or several",
    .arguments = "SCENE... [OPTION]...",
    .text =
        "Runs each contestant over nets, time steps and iterations from cheap to\n"
        "expensive, compares every run with the scene's truth on the material grid, and\n"
        "times all in turn. From there it searches the smallest net, the fewest points\n"
        "across it, the longest step and the fewest iterations that reach an error of 3,\n"
        "2, 1, 0.5 and 0.2 %, and more accurate runs. Nets start with cells about as\n"
        "long as wide.\n"
        "\n"
        "It prints the error beside the seconds, the least time for each of these\n"
        "errors, how seconds grow with accuracy, and the lowest error in real time and\n"
        "of all, each with its net, step and iterations. It also says what limits the\n"
        "lowest error: the net, the net across, the step and the iterations are refined\n"
        "once more, one at a time, and the one that lowers the error most is named, or\n"
        "the truth where the error is 1.5 of its bars or less. Seconds are those of\n"
        "set-up and stepping, as medians of the repeats beside them. With several scenes\n"
        "a last table compares the contestants on all of them.\n",
    .examples = "compare edge_drop\ncompare edge_drop corners_patch flag\ncompare "
                "corners_drop --models iga,shell_3\n"
                "compare edge_drop --from results/compare_edge_drop --format csv\n",
    .least = 1,
    .most = MOST_SCENES,
    .options = options,
    .run = run,
};
