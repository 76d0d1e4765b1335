#include "bench/advise/advise.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/export/export.h"
#include "bench/files/folder.h"
#include "bench/harness/deadline.h"
#include "bench/harness/timing.h"
#include "models/clock.h"
#include "models/pattern.h"

/* --- the search --- */

/* The truth's error bar is requested to be so many times smaller than the error. */
static const double SHARPER = 5;

/* The seconds of a run in the first round, and the factor of each further round. */
static const double FIRST = 0.02, LONGER = 3;

/* A run is not worth a try that takes so many times the cheapest that serves, and longer
 * than anybody waits [s]. */
static const double DEARER = 30, SHORT = 0.2;

/* Share of the budget left that a run may take, with its judging and its repeats. */
static const double SHARE = 1.0 / 20;

/* Returns the seconds that a row takes for a second of motion. */
static double rate_of(const struct advise_search *s, const struct contest_row *row)
{
    return row->seconds / s->job->time[s->job->times - 1];
}

/* Tells whether the least error is wanted for so many seconds a frame. */
static bool is_for_frames(const struct advise_search *s)
{
    return isnan(s->wish.error);
}

/* Returns the seconds that a run may take where the least error is wanted. */
static double affordable(const struct advise_search *s)
{
    const struct compare_job *j = s->job;

    return s->wish.frame * j->time[j->times - 1] / j->scene.step;
}

/* Finds the row of a contestant that serves best: the cheapest within the target, or the
 * nearest of those that can be afforded; NULL: none is. */
static const struct contest_row *finest(const struct advise_search *s,
                                        const struct contestant *who)
{
    const struct contest *c = &s->job->contest;

    return is_for_frames(s) ? contest_within(c, who, affordable(s))
                            : contest_cheapest(c, who, s->target);
}

/* Tells whether the first of two rows is the better answer. */
static bool is_better(const struct advise_search *s, const struct contest_row *a,
                      const struct contest_row *b)
{
    return is_for_frames(s) ? a->worst < b->worst : a->seconds < b->seconds;
}

enum { MOST = 128 };

/* Seconds that differ by less than this factor are as good as equal: a clock says others
 * when it is asked again. */
static const double EQUAL = 1.5;

/* Puts the first contestant of the contest whose seconds are as good as the least before
 * those that are sorted by them. */
static void prefer(const struct advise_search *s, int count,
                   const struct contest_row *row[MOST])
{
    const struct contestant *who;

    for (int k = 0; count && (who = contest_entrant(&s->job->contest, k)); k++)
        for (int n = 0; n < count && row[n]->seconds < EQUAL * row[0]->seconds; n++)
            if (row[n]->at.contestant == who) {
                const struct contest_row *first = row[n];
                memmove(row + 1, row, (size_t)n * sizeof *row);
                row[0] = first;
                return;
            }
}

/* Fills row[] with the row of each contestant that serves best, the best one first; returns
 * how many. */
static int rank(const struct advise_search *s, const struct contest_row *row[MOST])
{
    const struct contestant *who;
    int count = 0;

    for (int k = 0; (who = contest_entrant(&s->job->contest, k)); k++) {
        const struct contest_row *r = finest(s, who);
        if (!r || count == MOST)
            continue;
        int n = count++;
        for (; n > 0 && is_better(s, r, row[n - 1]); n--)
            row[n] = row[n - 1];
        row[n] = r;
    }
    if (!is_for_frames(s))
        prefer(s, count, row);
    return count;
}

/* Returns the seconds of the longest run that is still worth a try. */
static double most_seconds(const struct advise_search *s, double left)
{
    const struct contest_row *ranked[MOST];
    double most = fmax(0, SHARE * left);

    if (is_for_frames(s))
        most = fmin(most, affordable(s));
    else if (rank(s, ranked))
        most = fmin(most, fmax(SHORT, DEARER * ranked[0]->seconds));
    return most;
}

/* Measures the contestants of the job, round by round, until the budget is over or nothing
 * is worth a try. */
static enum status search(struct advise_search *s, struct message *why)
{
    struct contest *c = &s->job->contest;
    const double start = clock_now();
    int first = 0;
    enum status st = STATUS_OK;

    s->longest = FIRST;
    for (;;) {
        if (c->count > first) {
            fprintf(stderr, "advise: %d runs%s, %.0f s of the budget are left\n",
                    c->count - first, first ? "" : ", the coarsest of each contestant",
                    fmax(0, deadline_left(s->job->until)));
            st = compare_job_rows(s->job, first, why);
        }
        if (st == STATUS_LATE) {
            s->end = ADVISE_BUDGET;
            return STATUS_OK;
        }
        CALL(st);
        first = c->count;
        const double left = s->wish.budget - (clock_now() - start);
        const double most = most_seconds(s, left);
        const struct contest_wish wish = {1, &s->target, fmin(s->longest, most)};
        contest_propose(c, &wish);
        if (c->count > first)
            continue;
        if (s->longest >= most) {
            s->end = most < SHARE * left ? ADVISE_DONE : ADVISE_BUDGET;
            s->longest = most;
            break;
        }
        s->longest *= LONGER;
    }
    return STATUS_OK;
}

/* --- the table --- */

enum { TEXT = 256 };

static const struct scene *scene_of(const struct advise_search *s)
{
    return s->job->contest.scene;
}

/* Writes the reason for which a contestant does not serve. */
static void tell_reason(const struct advise_search *s, const struct contestant *who,
                        struct message *reason)
{
    const struct contest *c = &s->job->contest;
    const struct contest_limit limit = contest_limit(c, who);
    struct message what;

    contest_tell(c, &limit, &what);
    reason->text[0] = '\0';
    if (limit.kind == CONTEST_SKIPPED || limit.kind == CONTEST_DISTRUSTED) {
        message_add(reason, "%s", what.text);
    } else if (limit.kind == CONTEST_REFUSED || limit.kind == CONTEST_DIED) {
        const struct contest_row *row = c->rows;
        while (row->at.contestant != who)
            row++;
        message_add(reason, "%.200s", row->result.sentence.text);
    } else if (limit.kind == CONTEST_BY_UNKNOWN && s->longest > 0) {
        message_add(reason, "runs of more than %.2g s were not tried", s->longest);
    } else if (limit.kind == CONTEST_BY_UNKNOWN) {
        message_add(reason, "the budget ended with its coarsest run");
    } else {
        message_add(reason, "limited by %s", what.text);
    }
}

static bool is_fast(const struct advise_search *s, const struct contest_row *row)
{
    return rate_of(s, row) <= s->wish.rate;
}

static void add_row(struct dataset *t, const struct advise_search *s,
                    const struct contestant *who, const struct contest_row *r)
{
    const int *size = r ? r->at.size : (const int[CONTEST_AXES]){0};
    const bool serves = r && r == finest(s, who);
    struct message reason = {""};

    dataset_line(t, "%s|%s|%s", who->title, who->name,
                 !serves         ? "no"
                 : is_fast(s, r) ? "yes"
                                 : "too slow");
    if (r)
        dataset_add(t, "%dx%d", size[CONTEST_NET], size[CONTEST_ACROSS]);
    else
        dataset_add(t, "-");
    dataset_add(t, "%.3g|%.0f|%.2g|%.2g|%.2g",
                r ? scene_of(s)->step / size[CONTEST_STEP] : NAN,
                size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : NAN,
                r ? r->worst : NAN, r ? rate_of(s, r) : NAN, r ? r->result.bytes : NAN);
    if (!serves)
        tell_reason(s, who, &reason);
    dataset_add(t, "%s", reason.text);
}

static struct dataset *create(const struct advise_search *s)
{
    static const struct dataset_column columns[] = {
        {"model", .key = "title"},
        {"contestant", .readers = DATASET_MACHINES},
        {"serves"},
        {"net"},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"error", "% L", .key = "error_over_length", .key_unit = "L", .scale = 100},
        {"time for 1 s", "s", .key = "seconds_per_second", .key_unit = "1"},
        {"memory", "MB", .key = "model_bytes", .key_unit = "B", .scale = 1e-6},
        {"why not", .key = "reason"}};
    char caption[TEXT];

    if (is_for_frames(s))
        snprintf(caption, TEXT, "Contestants on %s at %.3g ms a frame, to %.3g s",
                 scene_of(s)->name, 1e3 * s->wish.frame, s->job->time[s->job->times - 1]);
    else
        snprintf(caption, TEXT, "Contestants on %s within %.3g %% of its length, to %.3g s",
                 scene_of(s)->name, 100 * s->wish.error, s->job->time[s->job->times - 1]);
    return DATASET_OF(columns, caption);
}

/* Adds those that serve from cheap to dear, then the others in the order of the
 * contest. */
static void fill(struct dataset *t, const struct advise_search *s)
{
    const struct contest_row *best[MOST];
    const struct contest *c = &s->job->contest;
    const struct contestant *who;
    const int serving = rank(s, best);

    for (int n = 0; n < serving; n++)
        add_row(t, s, best[n]->at.contestant, best[n]);
    if (serving)
        dataset_rule(t);
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        if (!finest(s, who))
            add_row(t, s, who, contest_nearest(c, who));
}

static void note_method(struct dataset *t, const struct advise_search *s)
{
    const double bar = contest_largest_bar(&s->job->contest);

    if (is_for_frames(s))
        dataset_note(
            t,
            "The error is the rms over the sheet at the worst of %d times, over the "
            "length; the truth leaves it uncertain by %.2g %%. Truth: %s.",
            s->job->times, 100 * bar, s->job->contest.truth->source);
    else
        dataset_note(
            t,
            "The error is the rms over the sheet at the worst of %d times, over the "
            "length. A run is accurate enough below %.3g %%: that is %.3g %% less the "
            "%s, %.2g %%. Truth: %s.",
            s->job->times, 100 * s->target, 100 * s->wish.error,
            truth_bar_name(s->job->contest.truth), 100 * bar,
            s->job->contest.truth->source);
    dataset_note(t,
                 "The time is that of set-up and stepping on one thread. Runs up to %.2g s "
                 "were tried%s.",
                 s->longest,
                 s->end == ADVISE_BUDGET
                     ? "; then the budget (--budget) ended"
                     : "; much more expensive ones than the best were not");
}

/* --- the answer --- */

static void say_needs(const struct advise_search *s, FILE *file)
{
    const struct scene *scene = scene_of(s);
    const unsigned needs = scene_needs(scene);
    char text[TEXT];

    scene_needs_text(needs, text, sizeof text);
    wrap_say(file,
             "%s: a sheet of %g x %g m, %g mm thick; Gamma = %.3g, weight against bending; "
             "what it requires of a model beyond bending and stretching: %s. Motion: %s.",
             scene->name, scene->length, scene->width, 1e3 * scene->thickness,
             scene_gamma(scene), needs ? text : "nothing", s->job->contest.physics);
}

static void say_command(const struct advise_search *s, const struct contest_row *r,
                        FILE *file)
{
    const struct compare_job *j = s->job;
    struct settings all SCOPED(settings_clear) = {0};

    contest_settings(&j->contest, &r->at, &all);
    settings_append(&all, &j->truth);
    fprintf(file, "    clothbench run %s --model %s", j->path, r->at.contestant->name);
    for (int n = 0; n < all.count; n++)
        fprintf(file, " --set '%s'", all.text[n]);
    fputs("\n\n", file);
}

/* Says the masses and stiffnesses of the net, if it is a grid of points; they are
 * advise_net.csv in the folder, too. Of any other net of points it says who writes them. */
static enum status say_net(const struct advise_search *s, const struct contest_row *r,
                           struct printer *p, struct message *why)
{
    const struct contestant *who = r->at.contestant;
    const struct pattern *own = scene_of(s)->pattern;
    const struct export_sheet sheet = {
        .scene = scene_of(s),
        .points = {r->at.size[CONTEST_NET], r->at.size[CONTEST_ACROSS]}};
    char points[64] = "";

    if (who->layers || who->degree != 1)
        return STATUS_OK;
    if (!printer_is_prose(p)) {
        struct dataset *t SCOPED(dataset_destroy_scope) =
            own ? NULL : export_numbers_table(&sheet);
        return t ? printer_save(p, t, "advise_net", why) : STATUS_OK;
    }
    if (!own)
        CALL(printer_table(p, export_numbers_table(&sheet), "advise_net", why));
    if (!own || !own->mesh.nodes)
        snprintf(points, sizeof points, " --points %d,%d", sheet.points[0],
                 sheet.points[1]);
    fprintf(
        p->file,
        "This command writes every vertex and spring of it:\n\n    clothbench export %s%s "
        "--out DIR\n\n",
        s->job->path, points);
    return STATUS_OK;
}

static void say_answer(const struct advise_search *s, const struct contest_row *best,
                       FILE *file)
{
    const double bar = contest_largest_bar(&s->job->contest);

    if (!best && is_for_frames(s)) {
        wrap_say(file, "No contestant takes %.3g ms a frame or less.", 1e3 * s->wish.frame);
        return;
    }
    if (!best) {
        wrap_say(file, "No contestant came within %.3g %% (%.3g %% less the %s).",
                 100 * s->target, 100 * s->wish.error,
                 truth_bar_name(s->job->contest.truth));
        return;
    }
    if (!is_fast(s, best))
        wrap_say(file,
                 "None of the contestants within %.3g %% is as fast as required, %.3g s "
                 "for a second of motion; this is the fastest:",
                 100 * s->wish.error, s->wish.rate);
    wrap_say(
        file,
        "%s: error %.2g %% of the length, which the truth leaves uncertain by %.2g %%; "
        "%.2g s for a second of motion, %.2g ms a frame; %.2g MB.",
        best->at.contestant->title, 100 * best->worst, 100 * bar, rate_of(s, best),
        1e3 * rate_of(s, best) * scene_of(s)->step, 1e-6 * best->result.bytes);
    const struct counters *work = &best->result.work;
    const double steps = (double)work->steps;
    wrap_say(file,
             "Net %dx%d, steps of %.3g ms, each in %.3g substeps with %.3g iterations in "
             "all.",
             best->at.size[CONTEST_NET], best->at.size[CONTEST_ACROSS],
             1e3 * scene_of(s)->step / best->at.size[CONTEST_STEP],
             fmax(1, (double)work->substeps / steps), (double)work->iterations / steps);
    say_command(s, best, file);
}

enum status advise_print(const struct advise_search *s, struct printer *p,
                         struct message *why)
{
    const struct contest_row *ranked[MOST];
    const struct contest_row *best = rank(s, ranked) ? ranked[0] : NULL;

    if (printer_is_prose(p)) {
        say_needs(s, p->file);
        say_answer(s, best, p->file);
    }
    if (best)
        CALL(say_net(s, best, p, why));
    struct dataset *t = create(s);
    fill(t, s);
    note_method(t, s);
    return printer_table(p, t, "advise", why);
}

/* --- the command --- */

/* Seconds that the answer may take, unless --budget says another number. */
static const double BUDGET = 240;

/* The error for which a truth is made where none was given, and the one below which no run
 * is tried then, however sharp the truth. */
static const double UNASKED = 0.01, LEAST = 1e-5;

/* Share of the budget that runs for a truth may take. */
static const double FOR_TRUTH = 1.0 / 3;

static enum status read_rate(const struct command_line *line, double *rate,
                             struct message *why)
{
    *rate = command_given(line, "--realtime") ? 1 : INFINITY;
    if (command_given(line, "--realtime") && command_given(line, "--seconds"))
        return status_fail(why, STATUS_INPUT,
                           "--realtime is --seconds 1; give one of the two");
    return command_number(line, "--seconds", false, rate, why);
}

/* The largest error that is believed to be meant as a share, without a per cent sign. */
static const double MOST_PLAIN = 0.1;

static enum status read_wish(const struct command_line *line, struct advise_wish *wish,
                             struct message *why)
{
    const char *budget = command_value(line, "--budget");
    double frame = 0;
    char end;

    *wish = (struct advise_wish){.error = NAN, .budget = BUDGET};
    CALL(command_number(line, "--error", true, &wish->error, why));
    if (budget && sscanf(budget, "%lfm%c", &frame, &end) == 2 && end == 's')
        wish->frame = frame / 1e3;
    else
        CALL(command_number(line, "--budget", false, &wish->budget, why));
    if ((wish->frame > 0) == (wish->error < 1))
        return status_fail(why, STATUS_INPUT,
                           "advise needs either --error, below 100%%, as in --error 2%%, "
                           "or milliseconds a frame, as in --budget 4ms");
    const char *error = command_value(line, "--error");
    if (wish->error > MOST_PLAIN && !strchr(error, '%'))
        return status_fail(
            why, STATUS_INPUT,
            "--error %s is %g %% of the length; write --error %s%% or --error "
            "%g%%, whichever is meant",
            error, 100 * wish->error, error, 100 * wish->error);
    return read_rate(line, &wish->rate, why);
}

/* Returns whether the truth cannot tell who serves, and says so. */
static bool is_undecidable(const struct advise_search *s, const struct message *said)
{
    const struct contest *c = &s->job->contest;
    const bool decidable = c->truth && s->target > 0;

    if (!c->truth)
        wrap_say(stdout, "Cannot be decided: %s%s.", said->text,
                 deadline_left(s->job->until) < 0
                     ? " (a third of --budget is for the truth)"
                     : "");
    else if (!decidable && *c->truth->unresolved)
        wrap_say(stdout, "Cannot be decided: %s Truth: %s.", c->truth->unresolved,
                 c->truth->source);
    else if (!decidable)
        wrap_say(stdout,
                 "Nothing can be decided: the truth is known to %.2g %% of the length "
                 "only, and an error of %.3g %% is required. A larger --budget or an "
                 "earlier --until may help. Truth: %s.",
                 100 * contest_largest_bar(c), 100 * s->wish.error, c->truth->source);
    return !decidable;
}

/* Enters contestants with the coarsest rung of their ladders; where what a frame may take
 * is given, with all, and with half the coarsest net for those whose ladder is too dear. */
static enum status enter(struct advise_search *s, const char *models, struct message *why)
{
    struct contest *c = &s->job->contest;

    if (!is_for_frames(s))
        return compare_job_enter(s->job, models, 1, false, why);
    CALL(compare_job_enter(s->job, models, CONTEST_RUNGS, false, why));
    const struct contestant *who;
    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        struct contest_at rung[CONTEST_RUNGS];
        contest_ladder(c, who, rung);
        const struct contest_at half =
            contest_moved(c, &rung[0], CONTEST_NET,
                          (int)fmax(contestant_least(who), rung[0].size[CONTEST_NET] / 2));
        if (half.size[CONTEST_NET] < rung[0].size[CONTEST_NET])
            contest_add(c, &half);
    }
    return STATUS_OK;
}

static enum status answer(struct advise_search *s, const char *models, struct printer *p,
                          struct message *why)
{
    struct compare_job *j = s->job;
    const bool frames = is_for_frames(s);
    const struct truth_wish wish = {(frames ? UNASKED : s->wish.error) / SHARPER,
                                    FOR_TRUTH * s->wish.budget, .alone = true};
    const double start = clock_now();
    struct message said = {""};

    CALL(folder_make(j->folder, why));
    timing_alone();
    CALL(compare_job_truth(j, &wish, &said, why));
    if (j->found)
        s->target = frames ? fmax(contest_largest_bar(&j->contest), LEAST)
                           : s->wish.error - contest_largest_bar(&j->contest);
    if (is_undecidable(s, &said))
        return STATUS_FAILED;
    s->wish.budget -= clock_now() - start;
    j->until = clock_now() + s->wish.budget;
    CALL(enter(s, models, why));
    CALL(search(s, why));
    return advise_print(s, p, why);
}

/* Cells of a net may be so many times as long as wide where the motion has no direction of
 * its own. */
static const double CELLS = 3;

static enum status run(struct command_line *line, struct message *why)
{
    struct compare_job job SCOPED(compare_job_close) = {
        .contest = {.quick = true, .advises = true}};
    struct advise_search s = {.job = &job};
    const char *out = command_value(line, "--out");
    const char *one = command_value(line, "--contestant"),
               *models = one ? one : command_value(line, "--models");
    double until = NAN;
    int given;

    CALL(contestant_check(models, why));
    CALL(read_wish(line, &s.wish, why));
    CALL(command_number(line, "--until", false, &until, why));
    const char *const *set = command_values(line, "--set", &given);
    settings_set_all(&job.user, given, set);
    CALL(compare_job_open(&job, line->words[0], until, why));
    job.folder =
        out ? out : arena_print(&job.contest.arena, "results/advise_%s", job.scene.name);
    job.contest.cells = scene_same_across(&job.scene) ? 0 : CELLS;
    line->printer.folder = job.folder;
    return answer(&s, models, &line->printer, why);
}

static const struct command_option options[] = {
    {"--error", "PERCENT", false,
     "largest error at any time, of the length: 2% or 0.02\n"
     "(required, unless --budget is for a frame)"},
    {"--realtime", NULL, false, "a second of motion may take at most a second"},
    {"--seconds", "SECONDS", false, "a second of motion may take at most this long"},
    {"--contestant", "NAME", false, "this one alone"},
    {"--models", "NAME,NAME,...", false,
     "models or contestants (those that take part in\n"
     "`compare`)"},
    {"--set", "KEY=VALUE", true, "change a key of the scene"},
    {"--until", "SECONDS", false,
     "end of the motion that counts (0.5, or the end of the\n"
     "stored truth before that)"},
    {"--budget", "SECONDS|MS", false,
     "time for the answer (240); or, as in 4ms, that of a frame:\n"
     "the least error for it"},
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of result files and CSV (results/advise_SCENE)"},
    {NULL, NULL, false, NULL},
};

const struct command advise_command = {
    .name = "advise",
    .summary = "find the cheapest model, net and step for a scene and an error",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Measures every contestant on your scene, starting from its coarsest net and\n"
        "longest step, against the scene's truth: the stored one, or runs that are\n"
        "refined until its error bar is small beside the required error. Prints the\n"
        "`run` command to use, with its error and its seconds for a second of motion.\n"
        "Then it lists the other contestants: those that are accurate enough, from cheap\n"
        "to expensive, and those that are not, with the reason. A run is accurate enough\n"
        "if its error is below the required one minus the truth's error bar. If the bar\n"
        "is larger than the required error, nothing can be decided: that is the answer\n"
        "(exit code 1).\n",
    .examples = "advise edge_drop --error 2%\n"
                "advise my_flap.yaml --error 2% --realtime\n"
                "advise edge_drop --contestant vbd --budget 4ms\n"
                "advise edge_drop --error 1% --models mass_spring,triangles --until 0.3\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
