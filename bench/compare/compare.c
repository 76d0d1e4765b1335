#include "bench/compare/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/compare/fig6.h"
#include "bench/experiment/batch.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth_plan.h"
#include "bench/ui/progress.h"
#include "models/damping.h"
#include "models/reader/scene_file.h"

/* Half a second: an edge drop's first quarter swing, before motions part for good. */
static const double UNTIL = 0.5;

/* Seconds that a run which the search proposes may take. */
static const double LONGEST = 3;

enum { MOST_ROUNDS = 20 };

struct job {
    struct contest contest;
    struct scene scene;
    char *path;
    const char *folder;
    int times;
    double time[CONTEST_TIMES];
    struct settings user;  /* the user's                                               */
    struct settings truth; /* these, and how the truth is damped                       */
    struct truth *found;   /* owned                                                    */
    struct truth none;     /* stands in for a truth that could not be had              */
    double longest; /* of the search [s]; 0: it is left out                            */
    bool quick, read_only;
};

/* Those given by --until; else those of the stored truth up to UNTIL; else up to UNTIL. */
static enum status read_times(struct job *j, const struct command_line *line,
                              struct message *why)
{
    const char *word = command_value(line, "--until");
    char *end = NULL;
    double until = word ? strtod(word, &end) : fmin(UNTIL, j->scene.end);

    if (word && (*end || !(until > 0)))
        return status_fail(why, STATUS_INPUT, "--until %s: a time in seconds, above 0",
                           word);
    if (!word) {
        enum status st = truth_stored_times(j->path, &j->truth, until, CONTEST_TIMES,
                                            j->time, &j->times, why);
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

static enum status read_longest(struct job *j, const struct command_line *line,
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
static void choose_damping(struct job *j)
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

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    enum status st;
    int given;
    const char *const *set = command_values(line, "--set", &given);

    j->quick = command_given(line, "--quick");
    settings_set_all(&j->user, given, set);
    TRY(scene_file_find(line->words[0], &j->path, why));
    TRY(settings_read_scene(&j->user, j->path, &j->scene, why));
    choose_damping(j);
    TRY(read_times(j, line, why));
    TRY(read_longest(j, line, why));
    j->contest.scene = &j->scene;
out:
    return st;
}

static int length(const int *list, int most)
{
    int n = 0;

    while (n < most && list[n])
        n++;
    return n;
}

/* Nets, time steps and iterations of a contestant, from cheap to dear; `quick` leaves out
 * the dear half. */
static enum status add_rows(struct contest *c, const struct contestant *who, bool quick)
{
    const int sides = length(who->points, quick ? 2 : CONTESTANT_STEPS);
    const int divisors = length(who->divisors, quick ? 1 : CONTESTANT_STEPS);
    const int iterations = length(who->iterations, CONTESTANT_STEPS);
    struct contest_row *unused;
    enum status st = STATUS_OK;

    for (int s = 0; s < sides; s++)
        for (int d = 0; d < divisors; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                TRY(contest_add(c,
                                &(struct contest_at){who,
                                                     {who->points[s], who->divisors[d],
                                                      iterations ? who->iterations[i] : 0}},
                                &unused));
out:
    return st;
}

/* All of a choice (contestant_chosen), model by model. */
static enum status add_ladder(struct job *j, const char *models, struct message *why)
{
    const struct model *model;
    enum status st;

    TRY(contestant_check(models, why));
    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *who = contestant_table; who->name; who++)
            if (who->model == model && contestant_chosen(who, models, CONTESTANT_COMPARE))
                TRY(add_rows(&j->contest, who, j->quick));
out:
    return st;
}

/* One more of each thing from the nearest of each contestant that may come nearer. */
static enum status add_probes(struct job *j)
{
    struct contest *c = &j->contest;
    const struct contestant *who;
    enum status st = STATUS_OK;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const struct contest_limit limit = contest_limit(c, who);
        struct contest_at at[CONTEST_AXES];
        struct contest_row *row;
        int count = 0;
        if (!limit.best || limit.kind == CONTEST_BY_TRUTH)
            continue;
        for (int axis = 0; axis < CONTEST_AXES; axis++)
            count += contest_probe(c, limit.best, (enum contest_axis)axis, &at[count]);
        for (int n = 0; n < count; n++) {
            TRY(contest_add(c, &at[n], &row));
            row->probe = true;
        }
    }
out:
    return st;
}

static void refine(const struct contest_at *at, double frame, struct settings *s)
{
    const int *size = at->size;

    contestant_settings(at->contestant, s); /* again: what the user set may not change it */
    contestant_points(at->contestant, size[CONTEST_NET], size[CONTEST_NET], s);
    settings_number(s, "time.step", frame / size[CONTEST_STEP]);
    if (size[CONTEST_ITERATIONS])
        settings_integer(s, "discretization.iterations", size[CONTEST_ITERATIONS]);
}

static void plan_row(struct job *j, const struct contest_row *row, struct batch *batch)
{
    const struct contest_at *at = &row->at;
    char name[128];

    snprintf(name, sizeof name, "%s_%d_%d_%d", at->contestant->name, at->size[CONTEST_NET],
             at->size[CONTEST_STEP], at->size[CONTEST_ITERATIONS]);
    struct measurement_case *c = batch_add(batch, j->path, at->contestant, name);
    c->plan.end = j->time[j->times - 1];
    c->keep.times = j->times;
    c->keep.time = j->time;
    c->keep.fields = RUN_FIELDS_TIMES;
    c->timed = row->probe ? MEASUREMENT_UNTIMED : MEASUREMENT_WHOLE;
    settings_append(batch_settings(batch),
                    contestant_is_paper_scheme(at->contestant) ? &j->user : &j->truth);
    refine(at, j->scene.step, batch_settings(batch));
}

static void show(void *context, const char *what, int done, int total)
{
    struct progress *bar = context;

    (void)what;
    bar->total = total;
    progress_update(bar, done);
}

static enum status run_batch(const struct job *j, struct batch *batch, struct message *why)
{
    struct progress bar = progress_start("compare", 1, false);
    const struct measurement_options options = {
        .what = "compare", .quick = j->quick, .progress = show, .context = &bar};
    const enum status st = batch_run(batch, &options, why);

    progress_end(&bar);
    return st;
}

/* Of rows that an earlier call may not have had those from the first one missing are not
 * read. */
static int there(const struct job *j, const struct batch *batch)
{
    int n = 0;

    while (n < batch->count && (!j->read_only || access(batch->files[n], F_OK) == 0))
        n++;
    return n;
}

/* Runs all rows from the first one given on, unless an earlier call has left their files,
 * and fills them. If they are not `needed`, those that it did not leave go. */
static enum status measure(struct job *j, int first, bool needed, struct message *why)
{
    struct contest *c = &j->contest;
    struct batch batch;
    enum status st;

    TRY(batch_init(&batch, j->folder, c->count - first));
    for (int n = first; n < c->count; n++)
        plan_row(j, &c->rows[n], &batch);
    if (!j->read_only)
        TRY(run_batch(j, &batch, why));
    if (!needed)
        c->count = first + there(j, &batch);
    for (int n = first; n < c->count; n++) {
        struct run_result r = {0};
        TRY(batch_read(&batch, n - first, true, &r, why));
        contest_fill(c, &r, &c->rows[n]);
        run_result_clear(&r);
    }
out:
    batch_clear(&batch);
    return st;
}

static enum status add_proposals(struct job *j)
{
    struct contest *c = &j->contest;
    const struct contestant *who;
    struct contest_at at[CONTEST_PROPOSALS];
    struct contest_row *unused;
    enum status st = STATUS_OK;

    for (int k = 0; (who = contest_entrant(c, k)); k++) {
        const int count = contest_search(c, who, j->longest, at);
        for (int n = 0; n < count; n++)
            TRY(contest_add(c, &at[n], &unused));
    }
out:
    return st;
}

/* Each contestant's best for each target, from what its ladder showed. */
static enum status search(struct job *j, struct message *why)
{
    enum status st = STATUS_OK;

    for (int round = 0; round < MOST_ROUNDS && j->longest > 0; round++) {
        const int first = j->contest.count;
        TRY(add_proposals(j));
        const int proposed = j->contest.count;
        if (proposed > first)
            TRY(measure(j, first, false, why));
        if (proposed == first || j->contest.count < proposed)
            break;
    }
out:
    return st;
}

/* The ladder, what it makes worth a try, and then what tells the limits of each. */
static enum status measure_all(struct job *j, struct message *why)
{
    enum status st;

    TRY(measure(j, 0, true, why));
    TRY(search(j, why));
    const int searched = j->contest.count;
    TRY(add_probes(j));
    if (j->contest.count > searched)
        TRY(measure(j, searched, true, why));
out:
    return st;
}

/* Where what was to be the truth refuses the scene or dies, the others run nevertheless. */
static enum status find_truth(struct job *j, struct message *why)
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

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st;
    struct job j = {0};
    const char *word = command_value(line, "--format");
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    enum table_format format = TABLE_TEXT;
    char folder[4096];

    if (word)
        TRY(table_format_parse(word, &format, why));
    if (out && from)
        return status_fail(
            why, STATUS_INPUT,
            "--from reads result files and --out writes them; give one of the two");
    TRY(prepare(&j, line, why));
    snprintf(folder, sizeof folder, "results/compare_%s", j.scene.name);
    j.folder = from ? from : out ? out : folder;
    j.read_only = from != NULL;
    TRY(add_ladder(&j, command_value(line, "--models"), why));
    if (!from)
        TRY(folder_make(j.folder, why));
    timing_alone();
    if (!strcmp(j.scene.name, "corners_drop"))
        TRY(fig6_compare(j.path, &j.user, j.folder, j.read_only, format, stdout, why));
    TRY(find_truth(&j, why));
    TRY(measure_all(&j, why));
    TRY(compare_print(&j.contest, j.folder, format, stdout, why));
out:
    contest_clear(&j.contest);
    settings_clear(&j.user);
    settings_clear(&j.truth);
    truth_destroy(j.found);
    scene_clear(&j.scene);
    free(j.path);
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
    .summary = "speed against error, all models, one scene",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs each contestant over nets, time steps and iterations from cheap to dear,\n"
        "holds every run against the scene's truth on the material grid, times all in\n"
        "turn, and searches from there: for the least net, the longest step and the\n"
        "fewest iterations that reach 3, 2, 1, 0.5 and 0.2 %, and for what comes nearer.\n"
        "It prints the error beside the seconds; the least time for each of these; how\n"
        "seconds grow with accuracy; the least error in real time and the least of all, "
        "each with the net, the\n"
        "step and the iterations that reach it; and what limits the last: from there net,\n"
        "step and iterations are refined once more, one at a time, and what takes most\n"
        "off is named, or the truth, where the error is within its bar. Seconds are "
        "set-up\n"
        "and stepping, medians of the repeats that stand beside them.\n",
    .examples = "compare edge_drop\ncompare corners_drop --models iga,shell_3\n"
                "compare edge_drop --from results/compare_edge_drop --format csv\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
