#include "bench/compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/compare_job.h"
#include "bench/compare/fig6.h"
#include "bench/compare/league.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_plan.h"
#include "models/damping.h"
#include "models/reader/scene_file.h"

/* Half a second: an edge drop's first quarter swing, before motions part for good. */
static const double UNTIL = 0.5;

/* Seconds that a run which the search proposes may take. */
static const double LONGEST = 3;

enum { MOST_SCENES = 16 };

/* Those given by --until; else those of the truth that is known up to UNTIL, or later; else
 * up to UNTIL. */
static enum status read_times(struct compare_job *j, const struct command_line *line,
                              struct message *why)
{
    const char *word = command_value(line, "--until");
    char *end = NULL;
    double until = word ? strtod(word, &end) : fmin(UNTIL, j->scene.end);

    if (word && (*end || !(until > 0)))
        return status_fail(why, STATUS_INPUT, "--until %s: a time in seconds, above 0",
                           word);
    for (int late = 0; !word && late < 2; late++) { /* late: known at rest, at the end */
        enum status st = truth_stored_times(j->path, &j->truth, late ? j->scene.end : until,
                                            CONTEST_TIMES, j->time, &j->times, why);
        if (st != STATUS_OK || j->times)
            return st;
    }
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

static enum status read_longest(struct compare_job *j, const struct command_line *line,
                                struct message *why)
{
    const char *word = command_value(line, "--longest");
    char *end = NULL;

    j->longest = word ? strtod(word, &end) : j->quick ? 0 : LONGEST;
    if (word && (end == word || *end || !(j->longest >= 0)))
        return status_fail(why, STATUS_INPUT,
                           "--longest %s: seconds, or 0 for no search beyond the ladder",
                           word);
    return STATUS_OK;
}

/* All but the paper's own scheme move as the truth does (truth_plan.h). */
static void choose_damping(struct compare_job *j)
{
    const char *truth = truth_plan_damping(&j->scene);

    snprintf(j->contest.physics, sizeof j->contest.physics, "damping %s",
             damping_name((int)j->scene.damping.kind));
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

static enum status prepare(struct compare_job *j, const struct command_line *line,
                           const char *scene, struct message *why)
{
    enum status st;
    int given;
    const char *const *set = command_values(line, "--set", &given);

    j->quick = command_given(line, "--quick");
    settings_set_all(&j->user, given, set);
    TRY(scene_file_find(scene, &j->path, why));
    TRY(settings_read_scene(&j->user, j->path, &j->scene, why));
    choose_damping(j);
    TRY(read_times(j, line, why));
    TRY(read_longest(j, line, why));
    j->contest.scene = &j->scene;
out:
    return st;
}

/* Where what was to be the truth refuses the scene or dies, the others run nevertheless. */
static enum status find_truth(struct compare_job *j, struct message *why)
{
    const enum truth_effort effort = j->quick ? TRUTH_QUICK : TRUTH_FULL;
    struct message said = {""};
    enum status st = truth_find(j->path, &j->truth, j->times, j->time, j->folder, effort,
                                &j->found, &said);

    j->contest.truth = j->found;
    if (st == STATUS_OK)
        return st;
    if (st != STATUS_UNSUPPORTED && !status_is_death(st))
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

static void clear(struct compare_job *j)
{
    contest_clear(&j->contest);
    settings_clear(&j->user);
    settings_clear(&j->truth);
    truth_destroy(j->found);
    scene_clear(&j->scene);
    free(j->path);
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
        clear(&j);
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
    if (!strcmp(j.scene.name, "corners_drop"))
        TRY(fig6_compare(j.path, &j.user, j.folder, j.read_only, call->format, stdout,
                         why));
    TRY(find_truth(&j, why));
    TRY(compare_job_measure(&j, why));
    TRY(compare_print(&j.contest, j.folder, call->format, stdout, why));
    TRY(league_add(&call->league, &j.contest));
out:
    clear(&j);
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
     "which models or contestants (all that enter here;\nclothbench list contestants)"},
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {"--until", "SECONDS", false,
     "compare five times up to this one (0.5, or those of\nthe stored truth before it)"},
    {"--longest", "SECONDS", false,
     "of a run that the search for the best net, step and\niterations may try (3; 0: no "
     "search)"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where result files, CSV and plot go (results/compare_SCENE)"},
    {"--from", "DIR", false, "tables and plot from result files of an earlier run"},
    {"--quick", NULL, false, "the cheap half of each ladder, no search, three\nrepeats"},
    {NULL, NULL, false, NULL},
};

const struct command compare_command = {
    .name = "compare",
    .summary = "speed against error, all models, a scene or several",
    .arguments = "SCENE... [OPTION]...",
    .text =
        "Runs each contestant over nets, time steps and iterations from cheap to dear,\n"
        "holds every run against the scene's truth on the material grid, times all in\n"
        "turn, and searches from there: for the least net, the longest step and the\n"
        "fewest iterations that reach 3, 2, 1, 0.5 and 0.2 %, and for what comes nearer.\n"
        "It prints the error beside the seconds; the least time for each of these; how\n"
        "seconds grow with accuracy; the least error in real time and the least of all,\n"
        "each with the net, the step and the iterations that reach it; and what limits\n"
        "the last: from there net, step and iterations are refined once more, one at a\n"
        "time, and what takes most off is named, or the truth, where the error is within\n"
        "its bar. Seconds are set-up and stepping, medians of the repeats that stand "
        "beside them. After several\n"
        "scenes a table over all of them tells who wins where.\n",
    .examples = "compare edge_drop\ncompare edge_drop corners_patch flag\ncompare "
                "corners_drop --models iga,shell_3\n"
                "compare edge_drop --from results/compare_edge_drop --format csv\n",
    .least = 1,
    .most = MOST_SCENES,
    .options = options,
    .run = run,
};
