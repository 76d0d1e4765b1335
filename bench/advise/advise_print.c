#include "bench/advise/advise_print.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/export/export_numbers.h"
#include "bench/harness/distrust.h"

enum { MOST = 64, TEXT = 256 };

static const struct scene *scene_of(const struct advise_search *s)
{
    return s->job->contest.scene;
}

/* What kept a contestant from serving, for people. */
static void tell_reason(const struct advise_search *s, const struct contestant *who,
                        char text[TEXT])
{
    const struct contest *c = &s->job->contest;
    const struct contest_limit limit = contest_limit(c, who);
    char what[TEXT / 2];

    contest_tell(c, &limit, what, sizeof what);
    if (limit.kind == CONTEST_SKIPPED) {
        snprintf(text, TEXT, "%s", what);
    } else if (limit.kind == CONTEST_REFUSED || limit.kind == CONTEST_DIED) {
        const struct contest_row *row = c->rows;
        while (row->at.contestant != who)
            row++;
        snprintf(text, TEXT, "%.200s", row->result.sentence.text);
    } else if (limit.kind == CONTEST_BY_UNKNOWN) {
        if (s->longest > 0)
            snprintf(text, TEXT, "runs of more than %.2g s were not tried", s->longest);
        else
            snprintf(text, TEXT, "the budget ended with its coarsest run");
    } else {
        snprintf(text, TEXT, "limited by %s", what);
    }
}

static bool is_fast(const struct advise_search *s, const struct contest_row *row)
{
    return advise_search_rate(s, row) <= s->wish.rate;
}

static void add_size(struct table *t, const struct contest *c, const struct contest_row *r)
{
    const int *size = r ? r->at.size : NULL;

    if (r)
        table_text(t, "%dx%d", size[CONTEST_NET], size[CONTEST_ACROSS]);
    else
        table_dash(t);
    table_number(t, r ? c->scene->step / size[CONTEST_STEP] : NAN, 3);
    table_fixed(t, r && size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : NAN, 0);
}

static void add_row(struct table *t, const struct advise_search *s,
                    const struct contestant *who, const struct contest_row *r)
{
    const bool serves = r && r->worst <= s->target;
    char reason[TEXT];

    table_row(t);
    table_text(t, "%s", who->title);
    table_text(t, "%s", who->name);
    table_text(t, "%s", !serves ? "no" : is_fast(s, r) ? "yes" : "too slow");
    add_size(t, &s->job->contest, r);
    table_number(t, r ? r->worst : NAN, 2);
    table_number(t, r ? advise_search_rate(s, r) : NAN, 2);
    table_number(t, r ? r->result.bytes : NAN, 2);
    tell_reason(s, who, reason);
    table_text(t, "%s", serves ? "" : reason);
}

static struct table *create(const struct advise_search *s, char caption[TEXT])
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT, .key = "title"},
        {"contestant", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"serves", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"step", "ms", .key = "step_s", .key_unit = "s", .scale = 1e3},
        {"iterations"},
        {"error", "% L", .key = "error_over_length", .key_unit = "L", .scale = 100},
        {"time for 1 s", "s", .key = "seconds_per_second", .key_unit = "1"},
        {"memory", "MB", .key = "model_bytes", .key_unit = "B", .scale = 1e-6},
        {"why not", NULL, TABLE_LEFT, .key = "reason"}};

    snprintf(caption, TEXT, "Who serves %s within %.3g %% of its length, to %.3g s",
             scene_of(s)->name, 100 * s->wish.error, s->job->time[s->job->times - 1]);
    return table_create(sizeof columns / sizeof *columns, columns, caption);
}

/* Those that serve from cheap to dear, then the others in the order of the contest. */
static void fill(struct table *t, const struct advise_search *s)
{
    const struct contest_row *best[MOST];
    const struct contest *c = &s->job->contest;
    const struct contestant *who;
    const int serving = advise_search_ranking(s, MOST, best);

    for (int n = 0; n < serving; n++)
        add_row(t, s, best[n]->at.contestant, best[n]);
    if (serving)
        table_rule(t);
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        if (!advise_search_row(s, who))
            add_row(t, s, who, contest_nearest(c, who));
}

static void note_method(struct table *t, const struct advise_search *s)
{
    const double bar = contest_largest_bar(&s->job->contest);

    table_note(t,
               "Error: rms over the sheet at the worst of %d times, over the length. To "
               "serve for sure, %.3g %% is asked of a run: %.3g %% less the %s, %.2g %%. "
               "Truth: %s.",
               s->job->times, 100 * s->target, 100 * s->wish.error,
               truth_bar_name(s->job->contest.truth), 100 * bar,
               s->job->contest.truth->source);
    table_note(t, "Time: set-up and stepping, one thread. Runs up to %.2g s were tried%s.",
               s->longest,
               s->end == ADVISE_BUDGET ? "; there the budget (--budget) ended"
                                       : ", far dearer ones than the best are not");
}

/* --- the answer --------------------------------------------------------------------------
 */

static void say_needs(const struct advise_search *s, FILE *file)
{
    const struct scene *scene = scene_of(s);
    const unsigned needs = scene_needs(scene);
    char text[TEXT];

    scene_needs_text(needs, text, sizeof text);
    table_say(
        file,
        "%s: a sheet of %g x %g m, %g mm thick; Gamma = %.3g, weight against bending; "
        "what it asks of a model beyond bending and stretching: %s. Motion: %s.",
        scene->name, scene->length, scene->width, 1e3 * scene->thickness,
        scene_gamma(scene), needs ? text : "nothing", s->job->contest.physics);
}

static void say_command(const struct advise_search *s, const struct contest_row *r,
                        FILE *file)
{
    const struct compare_job *j = s->job;
    const struct contestant *who = r->at.contestant;
    struct settings all = {0};
    const int along = r->at.size[CONTEST_NET], across = r->at.size[CONTEST_ACROSS];

    contestant_points(who, along, across, &all);
    settings_number(&all, "time.step", scene_of(s)->step / r->at.size[CONTEST_STEP]);
    if (r->at.size[CONTEST_ITERATIONS])
        settings_integer(&all, "discretization.iterations", r->at.size[CONTEST_ITERATIONS]);
    settings_append(&all, &j->truth);
    fprintf(file, "    clothbench run %s --model %s", j->path, who->name);
    for (int n = 0; n < all.count; n++)
        fprintf(file, " --set '%s'", all.text[n]);
    fputs("\n\n", file);
    settings_clear(&all);
}

/* What the net is made of, if it is one of points; advise_net.csv in the folder. */
static enum status say_net(const struct advise_search *s, const struct contest_row *r,
                           enum table_format format, FILE *file, struct message *why)
{
    const struct contestant *who = r->at.contestant;
    const struct export_sheet sheet = {
        .scene = scene_of(s),
        .points = {r->at.size[CONTEST_NET], r->at.size[CONTEST_ACROSS]}};
    struct table *t = NULL;
    enum status st = STATUS_OK;

    if (who->layers || who->degree != 1)
        return st;
    TRY(export_numbers_table(&sheet, &t));
    TRY(table_save(t, s->job->folder, "advise_net", why));
    if (!table_format_is_prose(format))
        goto out;
    st = table_finish(t, format, file), t = NULL;
    fprintf(file,
            "Every vertex and spring of it:\n\n    clothbench export %s "
            "--points %d,%d --out DIR\n\n",
            s->job->path, sheet.points[0], sheet.points[1]);
out:
    table_destroy(t);
    return st;
}

static void say_answer(const struct advise_search *s, const struct contest_row *best,
                       FILE *file)
{
    const double bar = contest_largest_bar(&s->job->contest);
    struct message doubt;

    if (!best) {
        table_say(file, "No contestant came within %.3g %% (%.3g %% less the %s).",
                  100 * s->target, 100 * s->wish.error,
                  truth_bar_name(s->job->contest.truth));
        return;
    }
    if (!is_fast(s, best))
        table_say(file,
                  "None of those within %.3g %% is as fast as was asked, %.3g s for a "
                  "second of motion; the fastest:",
                  100 * s->wish.error, s->wish.rate);
    if (distrust(scene_of(s), best->result.value, &doubt))
        table_say(file, "%s", doubt.text);
    table_say(file,
              "%s: error %.2g %% of the length, of which the truth leaves %.2g %% open; "
              "%.2g s for a second of motion; %.2g MB.",
              best->at.contestant->title, 100 * best->worst, 100 * bar,
              advise_search_rate(s, best), 1e-6 * best->result.bytes);
    say_command(s, best, file);
}

enum status advise_print(const struct advise_search *s, enum table_format format,
                         FILE *file, struct message *why)
{
    char caption[TEXT];
    struct table *t = create(s, caption);
    const struct contest_row *best = NULL;
    enum status st;

    advise_search_ranking(s, 1, &best);
    if (table_format_is_prose(format)) {
        say_needs(s, file);
        say_answer(s, best, file);
    }
    if (best)
        TRY(say_net(s, best, format, file, why));
    fill(t, s);
    note_method(t, s);
    return table_publish(t, s->job->folder, "advise", format, file, why);
out:
    table_destroy(t);
    return st;
}
