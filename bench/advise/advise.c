#include "bench/advise/advise.h"

#include <math.h>
#include <stdio.h>

#include "bench/advise/advise_print.h"
#include "bench/files/folder.h"
#include "bench/harness/deadline.h"
#include "bench/harness/timing.h"

enum { FOLDER = 4096 };

static const double BUDGET = 240;

/* The share of the budget that runs for a truth may take. */
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

static enum status read_wish(const struct command_line *line, struct advise_wish *wish,
                             struct message *why)
{
    enum status st;

    *wish = (struct advise_wish){.error = NAN, .budget = BUDGET};
    TRY(command_number(line, "--error", true, &wish->error, why));
    if (!(wish->error < 1))
        return status_fail(why, STATUS_INPUT,
                           "advise needs --error, below 100%%, as in --error 2%%");
    TRY(command_number(line, "--budget", false, &wish->budget, why));
    TRY(read_rate(line, &wish->rate, why));
out:
    return st;
}

/* Where the truth does not tell. */
static bool is_undecidable(const struct advise_search *s, const struct message *said)
{
    const struct contest *c = &s->job->contest;

    if (!c->truth)
        table_say(stdout, "Cannot be decided: %s%s.", said->text,
                  deadline_left() < 0 ? " (a third of --budget is for the truth)" : "");
    else if (!(s->target > 0) && *c->truth->unresolved)
        table_say(stdout, "Cannot be decided: %s Truth: %s.", c->truth->unresolved,
                  c->truth->source);
    else if (!(s->target > 0))
        table_say(
            stdout,
            "Cannot be decided: the truth is known to %.2g %% of the length, and %.3g "
            "%% is asked for. A later --budget or an earlier --until may tell. Truth: "
            "%s.",
            100 * contest_largest_bar(c), 100 * s->wish.error, c->truth->source);
    return !c->truth || !(s->target > 0);
}

static enum status answer(struct advise_search *s, const char *models,
                          enum table_format format, struct message *why)
{
    struct message said = {""};
    const double start = clock_now();
    enum status st;

    TRY(folder_make(s->job->folder, why));
    timing_alone();
    deadline_set(FOR_TRUTH * s->wish.budget);
    TRY(advise_search_truth(s, FOR_TRUTH * s->wish.budget, &said, why));
    if (is_undecidable(s, &said))
        return STATUS_FAILED;
    s->wish.budget -= clock_now() - start;
    deadline_set(s->wish.budget);
    TRY(advise_search(s, models, why));
    TRY(advise_print(s, format, stdout, why));
out:
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    struct compare_job job = {.contest.quick = true};
    struct advise_search s = {.job = &job};
    const char *word = command_value(line, "--format"), *out = command_value(line, "--out");
    enum table_format format = TABLE_TEXT;
    char folder[FOLDER];
    double until = NAN;
    int given;
    enum status st;

    if (word)
        TRY(table_format_parse(word, &format, why));
    TRY(contestant_check(command_value(line, "--models"), why));
    TRY(read_wish(line, &s.wish, why));
    TRY(command_number(line, "--until", false, &until, why));
    const char *const *set = command_values(line, "--set", &given);
    settings_set_all(&job.user, given, set);
    TRY(compare_job_open(&job, line->words[0], until, why));
    snprintf(folder, sizeof folder, "results/advise_%s", job.scene.name);
    job.folder = out ? out : folder;
    TRY(answer(&s, command_value(line, "--models"), format, why));
out:
    compare_job_close(&job);
    return st;
}

static const struct command_option options[] = {
    {"--error", "PERCENT", false, "of the length, at every time: 2% or 0.02; needed"},
    {"--realtime", NULL, false, "a second of motion may take a second"},
    {"--seconds", "SECONDS", false, "a second of motion may take so many"},
    {"--models", "NAME,NAME,...", false,
     "which models or contestants (all that enter\n`compare`)"},
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {"--until", "SECONDS", false,
     "how much of the motion counts (0.5, or the stored\ntruth up to there)"},
    {"--budget", "SECONDS", false, "that the answer may take (240)"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where result files and CSV go (results/advise_SCENE)"},
    {NULL, NULL, false, NULL},
};

const struct command advise_command = {
    .name = "advise",
    .summary = "the cheapest model, net and step for a scene and an error",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Measures every contestant on your scene, from its coarsest net and longest step\n"
        "on, against the scene's truth: the stored one, or runs refined until its\n"
        "error bar is small beside the error that is asked for. Prints the `run` command\n"
        "to use, its error and its seconds for a second of motion, then everybody else:\n"
        "those that serve too, from cheap to dear, and those that do not, with the\n"
        "reason. To serve for sure a run has to be nearer than the error asked for less\n"
        "the truth's bar; where the bar is larger, nothing can be decided, and that is\n"
        "the answer (exit 1).\n",
    .examples = "advise edge_drop --error 2%\n"
                "advise my_flap.yaml --error 2% --realtime\n"
                "advise edge_drop --error 1% --models mass_spring,triangles --until 0.3\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
