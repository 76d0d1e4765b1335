/* The tables, sentences, CSV file and chart of study_timestep.h. */
#include <math.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/study.h"
#include "bench/harness/fit.h"
#include "bench/studies/studies.h"
#include "bench/studies/study_timestep.h"
#include "bench/ui/chart.h"
#include "models/metric/metric.h"

enum {
    KINDS = STUDY_TIMESTEP_KINDS,
    LEVELS = STUDY_TIMESTEP_LEVELS,
    TIMES = STUDY_TIMESTEP_TIMES,
    LAST = TIMES - 1,
    FINEST = LEVELS - 1
};

/* An exponent of the step above it is nearer to a first-order scheme's 1 than to none; what
 * theory may be missed by. */
static const double SETTLES = 0.5, VISCOUS = 0.01;

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static void motion_row(struct table *t, const struct study *study, int n)
{
    const struct study_row *row = &study->row[n];

    table_row(t);
    table_text(t, "%s", study->plan->caption);
    study_print_numbers(
        t, "333", (double[]){1e3 * row->level->size, row->milliseconds, row->seconds});
    for (int time = 0; time < TIMES; time++)
        table_number(t, row->frame[time].drop, 4);
    table_number(t, row->frame[LAST].stretch, 4);
    table_number(t, 100 * row->frame[LAST].next, 3);
    if (row->result.outcome)
        table_note(t, "%s, step %s: %s.", study->plan->caption, row->level->label,
                   row->result.sentence.text);
}

static struct table *motion_table(const struct study_timestep *s)
{
    static const struct table_column columns[] = {{"scheme", NULL, TABLE_LEFT},
                                                  {"step", "ms"},
                                                  {"a frame", "ms"},
                                                  {"stepping", "s"},
                                                  {"drop 0.1 s", "L"},
                                                  {"0.2 s", "L"},
                                                  {"0.3 s", "L"},
                                                  {"0.4 s", "L"},
                                                  {"stretch 0.4 s"},
                                                  {"to next step", "% L"}};
    struct table *t = table_create(COUNT(columns), columns,
                                   "edge_drop at ever shorter steps (IGA: remedy none)");

    for (int kind = 0; kind < KINDS; kind++) {
        if (kind)
            table_rule(t);
        for (int n = 0; n < LEVELS; n++)
            motion_row(t, &s->kind[kind], n);
    }
    table_note(
        t, "IGA 10x10x2, (2,2,1). drop: lowest point below the support; to next step: RMSE "
           "over the material grid between this step and the next shorter one at 0.4 s; a "
           "frame: median over repeats; stepping: all frames to 0.4 s at that price.");
    return t;
}

static struct table *limits_table(const struct study_timestep *s)
{
    static const struct table_column columns[] = {{"scheme", NULL, TABLE_LEFT},
                                                  {"largest difference", "% L"},
                                                  {"smallest", "% L"},
                                                  {"exponent of dt"}};
    struct table *t = table_create(
        COUNT(columns), columns,
        "Differences from step to half step at 0.4 s: a limit, and of what order");

    for (int kind = 0; kind < KINDS; kind++) {
        double most = NAN, least = NAN;
        for (int n = 0; n < LEVELS; n++) {
            most = fmax(most, study_timestep_frame(s, kind, n)->next);
            least = fmin(least, study_timestep_frame(s, kind, n)->next);
        }
        table_row(t);
        table_text(t, "%s", s->kind[kind].plan->caption);
        study_print_numbers(
            t, "333", (double[]){100 * most, 100 * least, study_timestep_order(s, kind)});
    }
    table_note(
        t, "A motion with a limit of order e has differences ~ dt^e; at e near or below 0 "
           "halving the step changes the motion as much as the halving before. With v <- "
           "mu v the limit of incremental and nonlinear is a sheet that does not move.");
    return t;
}

static struct table *falls_table(const struct study_timestep *s)
{
    static const struct table_column columns[] = {{"mu"},
                                                  {"step", "ms"},
                                                  {"printed", "m/s^2"},
                                                  {"g (1+mu)/2(1-mu)", "m/s^2"},
                                                  {"ratio"},
                                                  {"incremental", "m/s"},
                                                  {"that dt", "m/s"},
                                                  {"ratio"}};
    struct table *t =
        table_create(COUNT(columns), columns,
                     "A free sheet, v <- mu v: acceleration under printed, speed under "
                     "incremental");

    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++) {
        const struct study_timestep_fall *f = &s->fall[n];
        table_row(t);
        study_print_numbers(t, "33556556",
                            (double[]){f->mu, 1e3 * f->step, f->acceleration, f->expected,
                                       f->acceleration / f->expected, f->speed,
                                       f->expected * f->step,
                                       f->speed / (f->expected * f->step)});
    }
    table_note(
        t, "From positions at 0.5, 0.75 and 1 s: printed falls with a constant "
           "acceleration that is not g, incremental with a constant speed that vanishes "
           "with the step.");
    return t;
}

static struct table *creeps_table(const struct study_timestep *s)
{
    static const struct table_column columns[] = {
        {"E", "Pa"},         {"step", "ms"},     {"tip's speed", "m/s"},
        {"static sag", "m"}, {"speed dt / sag"}, {"speed E dt", "Pa m"}};
    struct table *t =
        table_create(COUNT(columns), columns,
                     "A loaded cantilever under printed creeps: viscosity E dt");

    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const struct study_timestep_creep *c = &s->creep[n];
        table_row(t);
        study_print_numbers(t, "335565",
                            (double[]){c->young, 1e3 * c->step, c->speed, c->sag,
                                       c->speed * c->step / c->sag,
                                       c->speed * c->young * c->step});
    }
    table_note(
        t, "h = 20 mm, mu = 0.5, gravity 0.1 m/s^2, speed from 0.5 to 0.75 s. Each step "
           "adds the whole elastic sag of the load and forgets it: a sheet of viscosity "
           "E dt, which no elastic force holds up.");
    return t;
}

/* --- What a reader should take away. */

/* Drop at the last time ~ dt^e. */
static double drop_exponent(const struct study_timestep *s, enum study_timestep_kind kind)
{
    double size[LEVELS], drop[LEVELS];

    for (int n = 0; n < LEVELS; n++) {
        size[n] = s->kind[kind].row[n].level->size;
        drop[n] = study_timestep_frame(s, kind, n)->drop;
    }
    return fit_exponent(LEVELS, size, drop);
}

/* A rate gives the same motion at every step, up to an error that falls with the step. */
static void tell_scale(const struct study_timestep *s, FILE *file)
{
    const double e = drop_exponent(s, STUDY_TIMESTEP_SHEET);
    const enum judge turn = judge_below(fabs(e), SETTLES);

    judge_print(
        file, "one damping coefficient mu limits the velocity, v <- mu v", turn,
        "As a property of the cloth it would not depend on the step. An elastic sheet "
        "(nonlinear) drops %.3f L by 0.4 s at 10 ms and %.4f L at 0.625 ms, as "
        "dt^%.2f; the incremental one as dt^%.2f%s",
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET, 0)->drop,
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET, FINEST)->drop, e,
        drop_exponent(s, STUDY_TIMESTEP_INCREMENT),
        judge_words(turn, ".",
                    ": the shorter the step, the stiffer the air, and in the limit "
                    "nothing moves.",
                    "."));
}

static void tell_paper(const struct study_timestep *s, FILE *file)
{
    const struct study_row *row = s->kind[STUDY_TIMESTEP_PAPER].row;
    const double order = study_timestep_order(s, STUDY_TIMESTEP_PAPER);
    const enum judge turn = judge_below(SETTLES, order);

    judge_print(
        file, "implicit integration does not depend on the time step (the printed scheme)",
        turn,
        "Halving the step moves the sheet by %.2g, %.2g, %.2g and %.2g %% of L at 0.4 s, "
        "as "
        "dt^%.2f; its largest stretch is %.3f, %.3f, %.3f, %.3f and %.3f from 10 to 0.625 "
        "ms.%s",
        100 * row[0].frame[LAST].next, 100 * row[1].frame[LAST].next,
        100 * row[2].frame[LAST].next, 100 * row[3].frame[LAST].next, order,
        row[0].frame[LAST].stretch, row[1].frame[LAST].stretch, row[2].frame[LAST].stretch,
        row[3].frame[LAST].stretch, row[4].frame[LAST].stretch,
        judge_words(turn, "",
                    " A viscosity E dt changes with the step, and goes to nothing.", ""));
}

static void tell_stability(const struct study_timestep *s, FILE *file)
{
    double death[LEVELS];
    int dead = 0;

    for (int n = 0; n < LEVELS; n++) {
        const struct study_row *row = &s->kind[STUDY_TIMESTEP_PAPER_MASS].row[n];
        dead += !row->frame[LAST].xyz;
        death[n] = row->result.death_time;
    }
    judge_print(
        file, "implicit integration is unconditionally stable",
        dead ? JUDGE_FAILS : JUDGE_HOLDS,
        "With mass damping instead of v <- mu v the printed scheme dies at %d of %d "
        "steps%s%s",
        dead, LEVELS,
        judge_words(judge_order(LEVELS, death, -1, 0), ", sooner at shorter ones (above)",
                    "", ""),
        dead ? ": its d, never reset, is added to the sheet again every step, and "
               "only the scaling of v keeps it down."
             : ".");
}

/* What has a limit is led there by a halving as far as all later ones together. */
static void tell_limits(const struct study_timestep *s, FILE *file)
{
    const double rate = study_timestep_order(s, STUDY_TIMESTEP_SHEET_RATE);
    const double mass = study_timestep_order(s, STUDY_TIMESTEP_SHEET_MASS);
    const double increment = study_timestep_order(s, STUDY_TIMESTEP_INCREMENT_MASS);
    const struct study_frame *a =
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET_RATE, FINEST);
    const struct study_frame *b =
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET_MASS, FINEST);
    const double apart =
        a->xyz && b->xyz ? metric_rmse(a->xyz, b->xyz) / s->kind[0].length : NAN;
    const double left =
        2 * study_timestep_frame(s, STUDY_TIMESTEP_SHEET_RATE, FINEST - 1)->next;

    judge_say(
        file,
        "An elastic sheet with a damping that is a rate %s: v <- (1 - 2 dt) v has order "
        "%.2f, C = 2 M order %.2f, and their motions %s: at 0.625 ms they are %.2g %% of L "
        "apart.",
        judge_words(judge_both(judge_below(SETTLES, rate), judge_below(SETTLES, mass)),
                    "has a limit", "has no limit in sight", "has a limit or not"),
        rate, mass,
        judge_words(judge_below(apart, left), "are the same", "are not the same",
                    "cannot be compared"),
        100 * apart);
    judge_say(
        file,
        "incremental with C = 2 M forgets its strain every step, a viscosity E dt again: "
        "halving the step changes its motion as dt^%.2f, %s, and its stretch at 0.4 s goes "
        "from %.3f at 10 ms to %.3f at 0.625 ms.",
        increment,
        judge_words(judge_below(increment, SETTLES), "no limit in sight",
                    "so it has a limit", "which tells nothing"),
        study_timestep_frame(s, STUDY_TIMESTEP_INCREMENT_MASS, 0)->stretch,
        study_timestep_frame(s, STUDY_TIMESTEP_INCREMENT_MASS, FINEST)->stretch);
}

static void tell_viscous(const struct study_timestep *s, FILE *file)
{
    double step[STUDY_TIMESTEP_CREEPS], speed[STUDY_TIMESTEP_CREEPS], fall = 0, creep = 0;

    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++)
        fall = judge_most(fall, fabs(s->fall[n].acceleration / s->fall[n].expected - 1));
    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const struct study_timestep_creep *c = &s->creep[n];
        step[n] = c->young * c->step;
        speed[n] = c->speed;
        creep = judge_most(creep, fabs(c->speed * c->step / c->sag - 1));
    }
    judge_say(
        file,
        "The printed sheet %s. A free one falls with g (1 + mu) / (2 (1 - mu)) to %.1e, "
        "whatever the step; a loaded cantilever creeps by its elastic sag every step to "
        "%.1e, so that its speed goes as (E dt)^%.3f.",
        judge_words(judge_both(judge_below(fall, VISCOUS), judge_below(creep, VISCOUS)),
                    "is viscous", "is not viscous", "may be viscous"),
        fall, creep, fit_exponent(STUDY_TIMESTEP_CREEPS, step, speed));
}

static void print_text(const struct study_timestep *s, FILE *file)
{
    fprintf(file, "What the step does\n\n");
    tell_scale(s, file);
    tell_paper(s, file);
    tell_stability(s, file);
    tell_viscous(s, file);
    tell_limits(s, file);
}

/* --- Files. */

/* A row for each scheme, time and step. */
static struct table *motions(const struct study_timestep *s)
{
    static const struct table_column columns[] = {
        {"scheme", NULL, TABLE_LEFT},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"time", "s"},
        {"drop", "L", .key = "drop"},
        {"stretch"},
        {"to half the step", "L", .key = "rmse_to_next_over_length"},
        {"a frame", "ms", .key = "frame_ms"}};
    struct table *t = table_create(COUNT(columns), columns, NULL);

    for (int kind = 0; kind < KINDS; kind++)
        for (int time = 0; time < TIMES; time++)
            for (int n = 0; n < LEVELS; n++) {
                const struct study_row *row = &s->kind[kind].row[n];
                const struct study_frame *f = &row->frame[time];
                table_row(t);
                table_text(t, "%s", s->kind[kind].plan->caption);
                study_print_numbers(t, "334433",
                                    (double[]){row->level->size, s->kind[kind].time[time],
                                               f->drop, f->stretch, f->next,
                                               row->milliseconds});
            }
    return t;
}

/* A line for each scheme that lives, of a column at the last time. */
static void panel(struct chart *c, const struct table *t, const struct study_timestep *s,
                  const char *column)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const struct study *study = &s->kind[kind];
        const struct chart_where where[] = {{"scheme", study->plan->caption},
                                            {"time_s", .number = study->time[LAST]}};
        bool lives = false;
        for (int n = 0; n < LEVELS; n++)
            lives |= study->row[n].frame[LAST].xyz != NULL;
        if (!lives)
            continue;
        chart_series(c, &(struct chart_series){study->plan->caption});
        chart_rows(c, t, "step_s", column, 2, where);
    }
}

static enum status save(const struct study_timestep *s, const char *folder,
                        struct message *why)
{
    static const struct chart_tic tics[] = {{0.625}, {1.25}, {2.5}, {5}, {10}};
    const struct chart_axis step = {"step",      "ms",       .log = true,
                                    .low = 0.5,  .high = 12, .tic_count = COUNT(tics),
                                    .tics = tics};
    const struct chart_axis drop = {"drop / L at 0.4 s"};
    const struct chart_axis next = {"RMSE / L to half the step", .log = true};
    struct table *t = motions(s);
    struct chart *c = chart_create("edge_drop at ever shorter steps");
    enum status st;

    chart_columns(c, 1);
    chart_axes(c, &step, &drop);
    chart_panel(c, "the motion against the step");
    panel(c, t, s, "drop");
    chart_panel(c, "does halving the step still change it?");
    chart_axes(c, &step, &next);
    panel(c, t, s, "rmse_to_next_over_length");
    TRY(chart_save(c, folder, "timestep", why));
    TRY(table_save(t, folder, "timestep", why));
out:
    table_destroy(t);
    return st;
}

static enum status tell(const struct study_results *r, const char *folder,
                        enum table_format format, FILE *file, struct message *why)
{
    static const enum study_timestep_kind shown[] = {
        STUDY_TIMESTEP_PAPER, STUDY_TIMESTEP_SHEET, STUDY_TIMESTEP_SHEET_MASS};
    struct study_timestep s;
    enum status st;

    study_timestep_read(r, &s);
    TRY(table_finish(motion_table(&s), format, file));
    TRY(table_finish(limits_table(&s), format, file));
    TRY(table_finish(falls_table(&s), format, file));
    TRY(table_finish(creeps_table(&s), format, file));
    if (table_format_is_prose(format))
        print_text(&s, file);
    TRY(save(&s, folder, why));
    for (int n = 0; n < COUNT(shown); n++)
        TRY(study_print_files(&s.kind[shown[n]], folder, why));
out:
    return st;
}

const struct experiment study_timestep_experiment = {
    .item = {"timestep", NULL}, .plan = "timestep", .tell = tell};
