#include "bench/compare/compare.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/league.h"
#include "bench/files/folder.h"
#include "bench/harness/deadline.h"
#include "bench/harness/timing.h"
#include "models/clock.h"

/* Seconds that a run which the search proposes may take. */
static const double LONGEST = 3;

enum { MOST_SCENES = 16, MOST_THREADS = 256 };

/* The least number above 0. */
static const double ABOVE_0 = DBL_TRUE_MIN;

/* An option of seconds from `least` to `most`, which `want` says in words. */
static enum status read_seconds(const struct command_line *line, const char *option,
                                double otherwise, double least, double most,
                                const char *want, double *seconds, struct message *why)
{
    const char *word = command_value(line, option);
    char *end = NULL;

    *seconds = word ? strtod(word, &end) : otherwise;
    if (word && (end == word || *end || !(*seconds >= least && *seconds <= most)))
        return status_fail(why, STATUS_INPUT, "%s %s: %s", option, word, want);
    return STATUS_OK;
}

/* "1,2,4": one is what all is timed with. */
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

static enum status prepare(struct compare_job *j, const struct command_line *line,
                           const char *scene, struct message *why)
{
    enum status st;
    int given;
    double until;
    const char *const *set = command_values(line, "--set", &given);

    j->contest.quick = command_given(line, "--quick");
    settings_set_all(&j->user, given, set);
    TRY(read_seconds(line, "--until", NAN, ABOVE_0, INFINITY, "a time in seconds, above 0",
                     &until, why));
    TRY(compare_job_open(j, scene, until, why));
    TRY(read_seconds(line, "--longest", j->contest.quick ? 0 : LONGEST, 0, INFINITY,
                     "seconds, or 0 for no search beyond the ladder", &j->contest.longest,
                     why));
    TRY(read_seconds(line, "--budget", 0, ABOVE_0, DBL_MAX, "seconds for a scene, above 0",
                     &j->contest.budget, why));
    TRY(read_threads(&j->contest, line, why));
out:
    return st;
}

/* Times that nobody asked for and at which the truth can tell none of the targets decide
 * nothing: they are left, and that is said where the truth is named. */
static void leave_blunt_times(struct compare_job *j)
{
    struct truth *t = j->found;
    const double most = contest_target[0] * j->scene.length;
    const size_t used = strlen(t->source);
    const int all = t->times;

    while (t->times > 1 && t->error[t->times - 1] > most)
        t->times--;
    if (t->times < all)
        snprintf(t->source + used, sizeof t->source - used,
                 "; compared up to %.3g s, as its error bar at %.3g s is %.2g %% of L",
                 t->time[t->times - 1], t->time[t->times],
                 100 * t->error[t->times] / j->scene.length);
    j->times = t->times;
}

/* So long the coarsest run of each contestant is tried under any budget [s]. */
static const double LEAST_BUDGET = 10;

/* Returns what runs for a truth are to reach, the least target, and how long they may take;
 * a quick call and one with a budget ask for less. */
static struct truth_wish wish_of(const struct contest *c)
{
    const double seconds = c->quick ? 30 : 240;

    return (struct truth_wish){contest_target[c->quick ? 2 : CONTEST_TARGETS - 1],
                               c->budget > 0 ? fmin(seconds, c->budget / 3) : seconds,
                               .alone = true};
}

/* Where what was to be the truth refuses the scene or dies, the others run nevertheless. */
static enum status find_truth(struct compare_job *j, bool all_times, struct message *why)
{
    const struct truth_wish wish = wish_of(&j->contest);
    const double start = clock_now();
    struct message said = {""};

    deadline_set(wish.seconds);
    enum status st = truth_find_or_make(j->path, &j->truth, j->times, j->time, j->folder,
                                        &wish, &j->found, &said);
    if (j->contest.budget > 0)
        deadline_set(fmax(j->contest.budget - (clock_now() - start), LEAST_BUDGET));
    else
        deadline_set(INFINITY);
    j->contest.truth = j->found;
    if (st == STATUS_OK && !all_times)
        leave_blunt_times(j);
    if (st == STATUS_OK)
        return st;
    if (st != STATUS_UNSUPPORTED && st != STATUS_LATE && !status_is_death(st))
        return status_fail(why, st, "%s", said.text);
    fprintf(stderr, "compare: no truth, and so no errors: %s\n", said.text);
    j->none = (struct truth){.times = j->times, .time = j->time};
    snprintf(j->none.source, sizeof j->none.source, "none; %.500s", said.text);
    j->contest.truth = &j->none;
    return STATUS_OK;
}

/* What all scenes of a call have in common. */
struct call {
    const struct command_line *line;
    const char *out, *from; /* of one scene the folder, of several that of theirs; NULL  */
    enum table_format format;
    struct league league;
};

/* --out DIR of several scenes has a folder for each. */
static const char *choose_folder(const struct call *call, const char *scene, char *room,
                                 size_t size)
{
    const char *given = call->from ? call->from : call->out;

    if (given && call->line->word_count == 1)
        return given;
    if (given)
        snprintf(room, size, "%s/%s", given, scene);
    else
        snprintf(room, size, "results/compare_%s", scene);
    return room;
}

/* Before anything is run: every scene can be read, and each has a name of its own. */
static enum status check_scenes(const struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;
    char name[MOST_SCENES][sizeof((struct league_scene *)NULL)->name];

    for (int n = 0; n < line->word_count; n++) {
        struct compare_job j = {0};
        st = prepare(&j, line, line->words[n], why);
        if (st == STATUS_OK)
            snprintf(name[n], sizeof name[n], "%s", j.scene.name);
        compare_job_close(&j);
        TRY(st);
        for (int k = 0; k < n; k++)
            if (!strcmp(name[k], name[n]))
                TRY(status_fail(why, STATUS_INPUT, "%s: two scenes of the name %s",
                                line->words[n], name[n]));
    }
out:
    return st;
}

static enum status run_scene(struct call *call, const char *word, struct message *why)
{
    enum status st;
    struct compare_job j = {0};
    char folder[4096];

    TRY(prepare(&j, call->line, word, why));
    j.folder = choose_folder(call, j.scene.name, folder, sizeof folder);
    j.read_only = call->from != NULL;
    TRY(compare_job_ladder(&j, command_value(call->line, "--models"), why));
    if (!j.read_only)
        TRY(folder_make(j.folder, why));
    timing_alone();
    TRY(find_truth(&j, command_value(call->line, "--until"), why));
    if (*j.contest.truth->unresolved && table_format_is_prose(call->format))
        table_say(stdout, "%s", j.contest.truth->unresolved);
    TRY(compare_job_measure(&j, why));
    TRY(compare_print(&j.contest, j.folder, call->format, stdout, why));
    TRY(league_add(&call->league, &j.contest));
out:
    compare_job_close(&j);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;
    struct call call = {.line = line,
                        .out = command_value(line, "--out"),
                        .from = command_value(line, "--from")};
    const char *word = command_value(line, "--format");

    if (word)
        TRY(table_format_parse(word, &call.format, why));
    if (call.out && call.from)
        return status_fail(
            why, STATUS_INPUT,
            "--from reads result files and --out writes them; give one of the two");
    TRY(check_scenes(line, why));
    for (int n = 0; n < line->word_count; n++)
        TRY(run_scene(&call, line->words[n], why));
    if (line->word_count > 1)
        TRY(league_print(&call.league,
                         call.from  ? call.from
                         : call.out ? call.out
                                    : "results",
                         call.format, stdout, why));
out:
    league_clear(&call.league);
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
