#include "bench/studies/study_ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/studies/distribution.h"
#include "bench/truth/truth_made.h"
#include "bench/truth/truth_level.h"

enum { TRUTHS = STUDY_ENSEMBLE_TRUTHS, NUMBERS = STUDY_ENSEMBLE_NUMBERS, LINE = 512 };

/* --- sentences ---------------------------------------------------------------------------
 */

static double last_growth(const struct study_ensemble *e, int ensemble)
{
    return e->fields ? e->one[ensemble].growth[e->fields - 1] : NAN;
}

static double last_time(const struct study_ensemble *e)
{
    return e->looks ? e->time[e->looks - 1] : NAN;
}

/* Whom of the contestants this is true of, and how many. */
static int list(const struct study_ensemble *e, const struct study_ensemble_verdict *v,
                enum judge turn, char text[LINE])
{
    int count = 0;

    *text = '\0';
    for (int n = TRUTHS; n < e->count; n++)
        if (v->turn[n] == turn)
            snprintf(text + strlen(text), LINE - strlen(text), "%s%s", count++ ? "; " : "",
                     e->one[n].title);
    return count;
}

/* Whose motion cannot be predicted where the truth's can. */
static void list_lost(const struct study_ensemble *e, char text[LINE])
{
    *text = '\0';
    for (int n = TRUTHS; n < e->count; n++)
        if (last_growth(e, n) >= TRUTH_MOST_GROWTH)
            snprintf(text + strlen(text), LINE - strlen(text), "%s%s (%.2g-fold)",
                     *text ? "; " : " Not so of ", e->one[n].title, last_growth(e, n));
    if (*text)
        snprintf(text + strlen(text), LINE - strlen(text),
                 ": what grows there is their own, not the sheet's.");
}

static void tell_predictable(const struct study_ensemble *e, FILE *file)
{
    char lost[LINE];

    list_lost(e, lost);
    table_say(
        file,
        "%s: nothing to judge in distribution: the motion is still predictable, by "
        "%.3g s a change of %g has grown %.2g-fold; its points can be compared, as far "
        "as its nets agree: to %.2g %% of L.%s",
        e->name, last_time(e), TRUTH_PERTURBATION, last_growth(e, STUDY_ENSEMBLE_FINE),
        100 * e->one[STUDY_ENSEMBLE_COARSE].points[e->fields - 1], lost);
}

/* Why nothing is judged; false: it is. */
static bool tell_unjudged(const struct study_ensemble *e,
                          const struct study_ensemble_verdict *v, FILE *file)
{
    const struct study_ensemble_one *coarse = &e->one[STUDY_ENSEMBLE_COARSE],
                                    *fine = &e->one[STUDY_ENSEMBLE_FINE];

    if (e->quick)
        table_say(file, "%s: distributions are not judged: quick.", e->name);
    else if (coarse->died || fine->died)
        table_say(file, "%s: nothing can be judged: the truth %s.", e->name,
                  (fine->died ? fine : coarse)->sentence.text);
    else if (e->runs < 2)
        table_say(file, "%s: nothing can be judged: one run has no spread.", e->name);
    else if (v->doubted)
        table_say(file,
                  "%s: the truth is not known in distribution: by %.3g s a change of %g "
                  "has grown %.2g-fold on the %s net and %.2g-fold on the %s one, so "
                  "whether the motion can be predicted hangs on the net.",
                  e->name, last_time(e), TRUTH_PERTURBATION,
                  last_growth(e, STUDY_ENSEMBLE_COARSE), coarse->net,
                  last_growth(e, STUDY_ENSEMBLE_FINE), fine->net);
    else if (v->horizon < 0)
        tell_predictable(e, file);
    else if (!v->windows)
        table_say(file,
                  "%s: nothing can be judged: the motion ends at its horizon, %.3g s.",
                  e->name, v->begin);
    else
        return false;
    return true;
}

static void tell_head(const struct study_ensemble *e,
                      const struct study_ensemble_verdict *v, FILE *file)
{
    char right[LINE], wrong[LINE], open[LINE];

    if (tell_unjudged(e, v, file))
        return;
    const int r = list(e, v, JUDGE_HOLDS, right), w = list(e, v, JUDGE_FAILS, wrong),
              o = list(e, v, JUDGE_OPEN, open);
    table_say(file,
              "%s, beyond its horizon at %.3g s: of %d models %d %s right in "
              "distribution%s%s, %d %s not%s%s, %d cannot be told from a truth that is "
              "itself not sharp%s%s.",
              e->name, v->begin, e->count - TRUTHS, r, r == 1 ? "is" : "are", r ? ": " : "",
              right, w, w == 1 ? "is" : "are", w ? ": " : "", wrong, o, o ? ": " : "",
              open);
}

/* The number that is farthest off, in words. */
static void find_worst(const struct study_ensemble_verdict *v, int n, char text[LINE])
{
    double most = 0;

    snprintf(text, LINE, "nothing was compared");
    for (int k = 0; k < NUMBERS; k++)
        for (int spread = 0; spread < 2; spread++) {
            const double z = study_ensemble_worst(v, n, k, k + 1, spread);
            if (!(fabs(z) > most))
                continue;
            most = fabs(z);
            snprintf(text, LINE, "farthest off: the %s of %s, %+.2g standard errors",
                     spread ? "spread" : "mean", study_ensemble_words[k], z);
        }
}

static void tell_one(const struct study_ensemble *e, const struct study_ensemble_verdict *v,
                     int n, FILE *file)
{
    const struct study_ensemble_one *one = &e->one[n];
    char quote[LINE], worst[LINE];

    snprintf(quote, sizeof quote, "%s: %s is right in distribution", e->name, one->title);
    find_worst(v, n, worst);
    if (one->died)
        judge_print(file, quote, v->turn[n], "%d of %d runs died; the first %s.", one->died,
                    e->runs, one->sentence.text);
    else
        judge_print(file, quote, v->turn[n],
                    "Its points are %.2g %% of L off at the horizon; %s, of %.2g allowed.",
                    100 * one->points[v->horizon], worst, v->bound);
}

/* --- tables ------------------------------------------------------------------------------
 */

static const char *word_of(const struct study_ensemble *e,
                           const struct study_ensemble_verdict *v, int n)
{
    if (n < TRUTHS)
        return "truth";
    if (e->one[n].died)
        return "died";
    if (e->quick)
        return "not judged: quick";
    return v->windows ? judge_words(v->turn[n], "right", "wrong", "not told apart")
                      : "not judged";
}

static void add_model(struct table *t, const struct study_ensemble *e,
                      const struct study_ensemble_verdict *v, int n)
{
    const struct study_ensemble_one *one = &e->one[n];
    const int at = v->horizon < 0 ? e->fields - 1 : v->horizon;

    table_row(t);
    table_text(t, "%s", e->name);
    table_text(t, "%s", one->title);
    table_text(t, "%s", one->net);
    table_integer(t, one->lived);
    table_number(t, e->fields ? one->points[at] : NAN, 2);
    table_number(t, last_growth(e, n), 2);
    for (int k = 0; k < NUMBERS; k++)
        table_number(t, n < TRUTHS ? NAN : study_ensemble_worst(v, n, k, k + 1, false), 2);
    table_number(t, n < TRUTHS ? NAN : study_ensemble_worst(v, n, 0, NUMBERS, true), 2);
    table_text(t, "%s", word_of(e, v, n));
}

static struct table *fill_models(const struct study_ensemble *e,
                                 const struct study_ensemble_verdict *v)
{
    const enum table_readers judged = v->windows ? TABLE_ALL : TABLE_MACHINES;
    const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"lived"},
        {"points", "% L", .key = "points", .key_unit = "L", .scale = 100},
        {"growth"},
        {"drop", .readers = judged},
        {"angle", .readers = judged},
        {"stretch", .readers = judged},
        {"rough", .readers = judged},
        {"kinetic", .readers = judged},
        {">L", .key = "waves_long", .readers = judged},
        {">L/2", .key = "waves_half", .readers = judged},
        {">L/4", .key = "waves_quarter", .readers = judged},
        {">L/8", .key = "waves_eighth", .readers = judged},
        {"spread", .readers = judged},
        {"verdict", NULL, TABLE_LEFT}};
    char caption[LINE];

    snprintf(caption, sizeof caption, "%s: ensembles of %d runs, gravity changed by %g",
             e->name, e->runs, TRUTH_PERTURBATION);
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < e->count; n++)
        add_model(t, e, v, n);
    table_note(t,
               "Points: of the mean positions from the truth's, rms over L, at the horizon "
               "(without one, at the end). Growth: rms spread of points at the end over "
               "%g L; the horizon is where it passes %g on both of the truth's nets.",
               TRUTH_PERTURBATION, TRUTH_MOST_GROWTH);
    if (v->windows)
        table_note(
            t,
            "Drop (of the mean height), angle, stretch, roughness, kinetic energy, and the "
            "heights of waves longer than L, from there to L/2, L/4 and L/8: how far their "
            "means are from the truth's in standard errors, those of the worst of %d "
            "windows from %.3g to %.3g s; spread: the worst of their spreads. What the "
            "truth's two nets differ by counts as an error of its own where it is more "
            "than chance. Right: none beyond %.3g, which %d comparisons with a right one "
            "pass in 5 of 100 cases.",
            v->windows, v->begin, v->end, v->bound, 2 * NUMBERS * v->windows);
    return t;
}

static struct table *fill_growth(const struct study_ensemble *e)
{
    static const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT, .key = "model"},
        {"time", "s"},
        {"growth"},
        {"points", "L"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Growth of the change, points against the truth");

    for (int n = 0; n < e->count; n++)
        for (int k = 0; k < e->fields; k++) {
            table_row(t);
            table_text(t, "%s", e->name);
            table_text(t, "%s", e->one[n].title);
            table_fixed(t, e->field_time[k], 2);
            table_number(t, e->one[n].growth[k], 3);
            table_number(t, e->one[n].points[k], 3);
        }
    return t;
}

static struct table *fill_series(const struct study_ensemble *e)
{
    static const struct table_column columns[] = {{"model", NULL, TABLE_LEFT},
                                                  {"net", NULL, TABLE_LEFT},
                                                  {"number", NULL, TABLE_LEFT},
                                                  {"unit", NULL, TABLE_LEFT},
                                                  {"time", "s"},
                                                  {"mean"},
                                                  {"mean error"},
                                                  {"sd"},
                                                  {"sd error"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, NULL);

    for (int n = 0; n < e->count; n++)
        for (int k = 0; e->one[n].lived && k < NUMBERS; k++)
            for (int look = 0; look < e->looks; look++) {
                const struct study_ensemble_one *one = &e->one[n];
                const struct distribution d =
                    distribution_of(one->lived, study_ensemble_values(e, one, k, look));
                table_row(t);
                table_text(t, "%s", one->title);
                table_text(t, "%s", one->net);
                table_text(t, "%s", study_ensemble_name[k]);
                table_text(t, "%s", study_ensemble_unit[k]);
                table_fixed(t, e->time[look], 2);
                table_number(t, d.mean, 4);
                table_number(t, d.mean_error, 2);
                table_number(t, d.sd, 3);
                table_number(t, d.sd_error, 2);
            }
    return t;
}

/* How well the truth is known: each number in each window, on both nets. */
static struct table *fill_truth(const struct study_ensemble *e,
                                const struct study_ensemble_verdict *v)
{
    static const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"number", NULL, TABLE_LEFT},
        {"unit", NULL, TABLE_LEFT},
        {"window"},
        {"mean"},
        {"its error"},
        {"sd"},
        {"its error", .key = "sd_error"},
        {"nets apart"},
        {"spreads apart"},
        {"known", NULL, TABLE_LEFT}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "The truth's distribution, and its nets apart");
    double value[DISTRIBUTION_RUNS];

    for (int k = 0; e->count > TRUTHS && k < NUMBERS; k++)
        for (int w = 0; w < v->windows; w++) {
            const struct study_ensemble_apart *a = &v->apart[TRUTHS][k][w];
            const int count = study_ensemble_window(e, v, STUDY_ENSEMBLE_FINE, k, w, value);
            const struct distribution d = distribution_of(count, value);
            table_row(t);
            table_text(t, "%s", e->name);
            table_text(t, "%s", study_ensemble_words[k]);
            table_text(t, "%s", study_ensemble_unit[k]);
            table_integer(t, w + 1);
            table_number(t, d.mean, 4);
            table_number(t, d.mean_error, 2);
            table_number(t, d.sd, 3);
            table_number(t, d.sd_error, 2);
            table_number(t, a->net_mean, 2);
            table_number(t, a->net_spread, 2);
            table_text(t, "%s", a->known == JUDGE_HOLDS ? "yes" : "no");
        }
    table_note(t,
               "Of the finer net, %s; apart: of the coarser one, %s, in standard errors; "
               "known: both within %.3g.",
               e->one[STUDY_ENSEMBLE_FINE].net, e->one[STUDY_ENSEMBLE_COARSE].net,
               v->bound);
    return t;
}

enum status study_ensemble_tell(const struct study_ensemble *e, const char *folder,
                                enum table_format format, FILE *file, struct message *why)
{
    const bool prose = table_format_is_prose(format);
    struct study_ensemble_verdict *v = malloc(sizeof *v);
    struct table *series = NULL;
    char name[LINE];
    enum status st;

    TRY(v ? STATUS_OK : STATUS_MEMORY);
    study_ensemble_judge(e, v);
    if (prose)
        tell_head(e, v, file);
    snprintf(name, sizeof name, "%s_models", e->name);
    TRY(table_publish(fill_models(e, v), folder, name, format, file, why));
    if (v->windows)
        TRY(table_finish(fill_truth(e, v), format, file));
    if (table_format_is_data(format)) /* people have the chart */
        TRY(table_finish(fill_growth(e), format, file));
    series = fill_series(e);
    snprintf(name, sizeof name, "%s_series", e->name);
    TRY(table_save(series, folder, name, why));
    for (int n = TRUTHS; prose && v->windows && !e->quick && n < e->count; n++)
        tell_one(e, v, n, file);
    st = study_ensemble_chart(e, folder, why);
out:
    table_destroy(series);
    free(v);
    return st;
}
