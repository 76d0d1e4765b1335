#include "bench/compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/league.h"
#include "bench/experiment/judge.h"
#include "bench/files/folder.h"
#include "bench/harness/deadline.h"
#include "bench/harness/timing.h"
#include "models/clock.h"

enum { MOST_SCENES = 16, MOST_THREADS = 256 };

/* Seconds that a run which the search proposes may take, unless --longest says another. */
static const double LONGEST = 3;

/* Reads --longest, the only option of seconds that may be 0. */
static enum status read_longest(struct contest *c, const struct command_line *line,
                                struct message *why)
{
    const char *word = command_value(line, "--longest");
    char *end = NULL;

    c->longest = word ? strtod(word, &end) : c->quick ? 0 : LONGEST;
    if (word && (end == word || *end || !(c->longest >= 0)))
        return status_fail(why, STATUS_INPUT,
                           "--longest %s: seconds, or 0 for no search beyond the ladder",
                           word);
    return STATUS_OK;
}

/* Reads --threads, as "1,2,4"; all is timed with one thread anyway. */
static enum status read_threads(struct contest *c, const struct command_line *line,
                                struct message *why)
{
    const char *word = command_value(line, "--threads");
    char *end = NULL;

    for (const char *at = word; at; at = *end ? end + 1 : NULL) {
        const long count = strtol(at, &end, 10);
        bool good = end > at && (!*end || *end == ',') && count >= 1;
        for (int t = 0; t < c->teams; t++)
            good &= c->team[t] != count;
        if (!good || count > MOST_THREADS || (count > 1 && c->teams == CONTEST_TEAMS))
            return status_fail(why, STATUS_INPUT,
                               "--threads %s: up to %d different numbers from 1 to %d, as "
                               "1,2,4",
                               word, CONTEST_TEAMS, MOST_THREADS);
        if (count > 1)
            c->team[c->teams++] = (int)count;
    }
    return STATUS_OK;
}

/* Reads a scene and the options; nothing is run. */
static enum status prepare(struct compare_job *j, const struct command_line *line,
                           const char *scene, struct message *why)
{
    enum status st;
    int given;
    double until = NAN;
    const char *const *set = command_values(line, "--set", &given);

    j->contest.quick = command_given(line, "--quick");
    j->read_only = command_given(line, "--from");
    settings_set_all(&j->user, given, set);
    TRY(command_number(line, "--until", false, &until, why));
    TRY(compare_job_open(j, scene, until, why));
    TRY(read_longest(&j->contest, line, why));
    TRY(command_number(line, "--budget", false, &j->contest.budget, why));
    TRY(read_threads(&j->contest, line, why));
out:
    return st;
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

    deadline_set(budget > 0 ? fmax(budget - (clock_now() - start), LEAST_BUDGET)
                            : INFINITY);
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

/* Writes the folder of a scene's files: that of --from or --out, `given`, in which several
 * scenes have a folder each. */
static void choose_folder(const struct command_line *line, const char *given,
                          const char *scene, size_t size, char *folder)
{
    if (given && line->word_count == 1)
        snprintf(folder, size, "%s", given);
    else if (given)
        snprintf(folder, size, "%s/%s", given, scene);
    else
        snprintf(folder, size, "results/compare_%s", scene);
}

static enum status run_scene(struct compare_job *j, const struct command_line *line,
                             const char *given, enum table_format format,
                             struct message *why)
{
    enum status st;
    char folder[4096];

    choose_folder(line, given, j->scene.name, sizeof folder, folder);
    j->folder = folder;
    TRY(compare_job_enter(j, command_value(line, "--models"),
                          j->contest.budget > 0 ? 1 : CONTEST_RUNGS, true, why));
    if (!j->read_only) {
        TRY(folder_make(folder, why));
        judge_mark(folder, j->contest.quick);
    }
    timing_alone();
    TRY(find_truth(j, command_value(line, "--until"), why));
    if (*j->contest.truth->unresolved && table_format_is_prose(format))
        table_say(stdout, "%s", j->contest.truth->unresolved);
    TRY(compare_job_measure(j, why));
    TRY(compare_print(&j->contest, folder, format, stdout, why));
out:
    j->folder = NULL;
    return st;
}

/* Reads all scenes, before the first is run: each has a name of its own. */
static enum status prepare_all(const struct command_line *line, struct compare_job *jobs,
                               struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < line->word_count; n++) {
        TRY(prepare(&jobs[n], line, line->words[n], why));
        for (int k = 0; k < n; k++)
            if (!strcmp(jobs[k].scene.name, jobs[n].scene.name))
                TRY(status_fail(why, STATUS_INPUT, "%s: two scenes of the name %s",
                                line->words[n], jobs[n].scene.name));
    }
out:
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *given = NULL, *from;
    const struct contest *contests[MOST_SCENES];
    struct compare_job *jobs = calloc(MOST_SCENES, sizeof *jobs);
    enum table_format format = TABLE_TEXT;
    enum status st = jobs ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(command_format(line, &format, why));
    TRY(command_folder(line, &given, &from, why));
    TRY(prepare_all(line, jobs, why));
    for (int n = 0; n < line->word_count; n++) {
        TRY(run_scene(&jobs[n], line, given, format, why));
        contests[n] = &jobs[n].contest;
    }
    if (line->word_count > 1)
        TRY(league_print(line->word_count, contests, given ? given : "results", format,
                         stdout, why));
out:
    for (int n = 0; jobs && n < MOST_SCENES; n++)
        compare_job_close(&jobs[n]);
    free(jobs);
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
    {"--threads", "N,N,...", false, "time the best runs again with so many threads (1)"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false,
     "folder of result files, CSV and plot\n"
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
        "the truth where the error is within its bar. Seconds are those of set-up and\n"
        "stepping, as medians of the repeats beside them. With several scenes a last\n"
        "table compares the contestants on all of them.\n",
    .examples = "compare edge_drop\ncompare edge_drop corners_patch flag\ncompare "
                "corners_drop --models iga,shell_3\n"
                "compare edge_drop --from results/compare_edge_drop --format csv\n",
    .least = 1,
    .most = MOST_SCENES,
    .options = options,
    .run = run,
};
