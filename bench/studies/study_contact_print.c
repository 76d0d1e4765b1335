/* Table, sentences, CSV, chart and pictures of study_contact.h. */
#include <math.h>
#include <string.h>

#include "bench/experiment/gallery.h"
#include "bench/experiment/judge.h"
#include "bench/studies/study_contact.h"
#include "bench/ui/chart.h"

/* Over which the force at the end is averaged: impacts come one by one. */
static const double END = 0.1;

/* A sheet whose ground carries its weight to this share is at rest. */
static const double UNREST = 0.05;

/* What is read off a run. */
struct landing {
    double touch;               /* first frame with a force; INFINITY: none       [s] */
    double net, surface;        /* least gaps                                     [m] */
    double apart;               /* most that the surface keeps from the ground while
                                   the net touches it                             [m] */
    double carried, force;      /* at the end: points, force / weight                 */
    double crossing, crossings; /* first time [s], most pairs                         */
    double net_crossing, net_crossings;
};

static void read_crossings(const struct study_contact_run *r, int series, double *first,
                           double *most)
{
    *first = INFINITY, *most = NAN;
    for (int n = 0; n < r->frames; n++) {
        double count = r->series[series][n];
        *most = fmax(*most, count);
        if (count > 0)
            *first = fmin(*first, r->time[n]);
    }
}

static struct landing read_landing(const struct study_contact_run *r)
{
    struct landing l = {.touch = INFINITY, .net = INFINITY, .surface = INFINITY};
    double end = r->frames ? r->time[r->frames - 1] : 0;
    int mean = 0;

    for (int n = 0; n < r->frames; n++) {
        double net = r->series[STUDY_CONTACT_NET_GAP][n];
        double surface = r->series[STUDY_CONTACT_SURFACE_GAP][n];
        bool carried = r->series[STUDY_CONTACT_CARRIED][n] > 0;
        l.net = fmin(l.net, net);
        l.surface = fmin(l.surface, surface);
        if (carried) {
            l.touch = fmin(l.touch, r->time[n]);
            l.apart = fmax(l.apart, surface - net);
        }
        if (r->time[n] > end - END) {
            l.force += r->series[STUDY_CONTACT_FORCE][n] / r->weight;
            l.carried = r->series[STUDY_CONTACT_CARRIED][n];
            mean++;
        }
    }
    l.force = mean ? l.force / mean : NAN;
    read_crossings(r, STUDY_CONTACT_CROSSINGS, &l.crossing, &l.crossings);
    read_crossings(r, STUDY_CONTACT_NET_CROSSINGS, &l.net_crossing, &l.net_crossings);
    return l;
}

/* What did not happen is no number. */
static void add(struct table *t, double value, int digits)
{
    table_number(t, isfinite(value) ? value : NAN, digits);
}

static enum status print_table(const struct study_contact_run *run,
                               const struct landing *landing, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {{"model", NULL, TABLE_LEFT},
                                                  {"touches", "s"},
                                                  {"net gap", "m"},
                                                  {"surface gap", "m"},
                                                  {"deepest", "m"},
                                                  {"apart", "m"},
                                                  {"carried"},
                                                  {"force", "weight"},
                                                  {"crosses", "s"},
                                                  {"crossings", "pairs"},
                                                  {"net crosses", "s"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 9: a sheet falls onto the ground (scene ground)");

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        const struct landing *l = &landing[n];
        table_row(t);
        table_text(t, "%s", study_contact_case[n].label);
        add(t, l->touch, 3);
        add(t, l->net, 2);
        add(t, l->surface, 2);
        add(t, fmax(0, -l->surface), 2);
        add(t, l->apart, 2);
        table_integer(t, lround(l->carried));
        add(t, l->force, 4);
        add(t, l->crossing, 3);
        add(t, l->crossings, 3);
        add(t, l->net_crossing, 3);
        if (run[n].result.outcome)
            table_note(t, "%s: %s.", study_contact_case[n].label,
                       run[n].result.sentence.text);
    }
    table_note(
        t,
        "Gaps are the least of the whole run: of control points or nodes (of a mid-"
        "surface less h/2), and of the 100 x 100 x 2 material points; `deepest` is how "
        "far the latter reach into the ground. Apart: the most by which the surface "
        "keeps farther away than the net while the net touches. Force: of the ground, "
        "mean over the last %g s. Crosses: first look (every tenth frame) at which "
        "the mid-surface, or the middle of the control net, passes through itself; "
        "nothing here prevents that. Without friction, which the paper does not name.",
        END);
    return table_finish(t, format, file);
}

/* Whether the ground carries the sheet's weight at the end. */
static enum judge at_rest(const struct landing *l)
{
    return judge_below(fabs(l->force - 1), UNREST);
}

/* Whether the paper's scheme comes through its own scene, and through itself. */
static void tell_printed(const struct study_contact_run *run, const struct landing *l,
                         FILE *file)
{
    const enum judge rests =
        status_is_death(run->result.outcome) ? JUDGE_FAILS : at_rest(l);

    judge_say(file, "%s: %s, %s (%.3g weights): in this reading the paper's Fig. 9 %s",
              study_contact_case[0].label, run->result.sentence.text,
              judge_words(rests, "at rest on the ground", "not at rest on the ground",
                          "nothing is known of its rest"),
              l->force,
              judge_words(rests, "is reproduced.",
                          "is not reproduced. Its d acts as a velocity and its v as an "
                          "acceleration, which average acceleration throws back at an "
                          "impact.",
                          "cannot be judged."));
    if (isfinite(l->crossing))
        judge_say(file,
                  "It passes through itself: first seen at %.3g s, up to %.3g pairs of "
                  "triangles.",
                  l->crossing, l->crossings);
}

static void tell(const struct study_contact_run *run, const struct landing *l, FILE *file)
{
    double deepest = 0, apart = 0;
    int crossing = 0;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        deepest = fmax(deepest, -l[n].surface);
        apart = fmax(apart, l[n].apart / run[n].thickness);
        crossing += isfinite(l[n].crossing) || isfinite(l[n].net_crossing);
    }
    judge_say(file,
              "Contact is detected on the net, as in the paper: no surface reaches deeper "
              "than %.2g m into the ground, but surfaces float by up to %.3g thicknesses "
              "while their nets touch.",
              deepest, apart);
    tell_printed(run, l, file);
    judge_say(file,
              "Self-contact is detected, and reported above, but not answered: %d of %d "
              "sheets pass through themselves.",
              crossing, STUDY_CONTACT_CASES);
    for (int n = 1; n < STUDY_CONTACT_CASES; n++)
        if (at_rest(&l[n]) == JUDGE_FAILS)
            judge_say(
                file,
                "%s: the ground carries %.3g weights over the last %g s: the sheet %s.",
                study_contact_case[n].label, l[n].force, END,
                run[n].result.outcome ? "died" : "is still moving");
}

static struct table *fill_series(const struct study_contact_run *run)
{
    static const struct table_column columns[] = {{"case", NULL, TABLE_LEFT},
                                                  {"time", "s"},
                                                  {"net gap", "m"},
                                                  {"surface gap", "m"},
                                                  {"carried"},
                                                  {"force", "N", .key = "force_n"},
                                                  {"crossings"},
                                                  {"net crossings"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, NULL);

    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        for (int k = 0; k < run[n].frames; k++) {
            table_row(t);
            table_text(t, "%s", study_contact_case[n].name);
            table_number(t, run[n].time[k], 6);
            for (int s = 0; s < STUDY_CONTACT_SERIES; s++)
                table_number(t, run[n].series[s][k], 6);
        }
    return t;
}

/* Surface and net side by side; first the solids, then the sheets without thickness. */
static struct chart *make_chart(const struct table *t)
{
    static const char *const kind[] = {"solids", "mid-surfaces"};
    static const char *const key[] = {"surface_gap_m", "net_gap_m"};
    const struct chart_axis time = {"time", "s"},
                            gap[] = {{"least gap of the surface", "m"},
                                     {"least gap of the net", "m"}};
    struct chart *c = chart_create("Fig. 9: a sheet falls onto the ground");

    chart_columns(c, 2);
    for (int panel = 0; panel < 4; panel++) {
        chart_panel(c, kind[panel / 2]);
        chart_axes(c, &time, &gap[panel % 2]);
        for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
            const struct chart_where where = {"case", study_contact_case[n].name};
            if ((n < STUDY_CONTACT_SOLIDS) != (panel < 2))
                continue;
            chart_series(c,
                         &(struct chart_series){study_contact_case[n].label, CHART_LINE});
            chart_rows(c, t, "time_s", key[panel % 2], 1, &where);
        }
    }
    return c;
}

enum status study_contact_tell(const struct study_contact_run *run, bool quick,
                               const char *folder, enum table_format format, FILE *file,
                               struct message *why)
{
    const struct run_result *result[STUDY_CONTACT_CASES];
    const char *label[STUDY_CONTACT_CASES];
    struct landing landing[STUDY_CONTACT_CASES];
    struct table *series = fill_series(run);
    enum status st;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        landing[n] = read_landing(&run[n]);
        result[n] = &run[n].result;
        label[n] = study_contact_case[n].label;
    }
    TRY(print_table(run, landing, format, file));
    if (table_format_is_prose(format) && quick)
        judge_say(file, "What the ground carries, and Fig. 9: not judged: quick.");
    else if (table_format_is_prose(format))
        tell(run, landing, file);
    TRY(table_save(series, folder, "contact", why));
    TRY(chart_save(make_chart(series), folder, "contact_gap", why));
    TRY(gallery_picture(folder, "contact_sheets", STUDY_CONTACT_TIMES, STUDY_CONTACT_CASES,
                        label, result, why));
out:
    table_destroy(series);
    return st;
}
