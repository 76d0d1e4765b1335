/* Table, sentences, CSV, plot and pictures of study_contact.h. */
#include <math.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/picture.h"
#include "bench/ui/plot.h"
#include "bench/studies/study_contact.h"

enum { PATH = 4096 };

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
    l.force /= mean;
    read_crossings(r, STUDY_CONTACT_CROSSINGS, &l.crossing, &l.crossings);
    read_crossings(r, STUDY_CONTACT_NET_CROSSINGS, &l.net_crossing, &l.net_crossings);
    return l;
}

static void existing(struct table *t, double value, int digits)
{
    if (isfinite(value))
        table_number(t, value, digits);
    else
        table_dash(t);
}

static enum status print_table(const struct study_contact_run *run,
                               const struct landing *landing, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT}, {"touches", "s", 0},    {"net gap", "m", 0},
        {"surface gap", "m", 0},     {"deepest", "m", 0},    {"apart", "m", 0},
        {"carried", NULL, 0},        {"force", "weight", 0}, {"crosses", "s", 0},
        {"crossings", "pairs", 0},   {"net crosses", "s", 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 9: a sheet falls onto the ground (scene ground)");
    enum status st;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        const struct landing *l = &landing[n];
        table_row(t);
        table_text(t, "%s", study_contact_case[n].label);
        existing(t, l->touch, 3);
        existing(t, l->net, 2);
        existing(t, l->surface, 2);
        table_number(t, fmax(0, -l->surface), 2);
        existing(t, l->apart, 2);
        table_integer(t, lround(l->carried));
        existing(t, l->force, 4);
        existing(t, l->crossing, 3);
        existing(t, l->crossings, 3);
        existing(t, l->net_crossing, 3);
        if (strcmp(run[n].outcome, "done"))
            table_note(t, "%s: %s.", study_contact_case[n].label, run[n].outcome);
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
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

/* Whether the paper's scheme comes through its own scene, and through itself. */
static void tell_printed(const struct study_contact_run *run, const struct landing *l,
                         FILE *file)
{
    fprintf(file, "- %s: %s, ", study_contact_case[0].label, run->outcome);
    if (!strcmp(run->outcome, "done") && fabs(l->force - 1) < UNREST)
        fprintf(file, "at rest on the ground: the paper's Fig. 9 is reproduced.\n");
    else
        fprintf(file,
                "not at rest on the ground (%.3g weights): in this reading the paper's "
                "Fig. 9 is not reproduced.\n  Its d acts as a velocity and its v as an "
                "acceleration, which average acceleration throws back at an impact.\n",
                l->force);
    if (isfinite(l->crossing))
        fprintf(file,
                "- It passes through itself: first seen at %.3g s, up to %.3g pairs of "
                "triangles.\n",
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
    fprintf(
        file,
        "\n- Contact is detected on the net, as in the paper: no surface reaches deeper "
        "than %.2g m into the ground,\n  but surfaces float by up to %.3g thicknesses "
        "while their nets touch.\n",
        deepest, apart);
    tell_printed(run, l, file);
    fprintf(file,
            "- Self-contact is detected, and reported above, but not answered: %d of %d "
            "sheets pass through themselves.\n",
            crossing, STUDY_CONTACT_CASES);
    for (int n = 1; n < STUDY_CONTACT_CASES; n++)
        if (fabs(l[n].force - 1) > UNREST)
            fprintf(file,
                    "- %s: the ground carries %.3g weights over the last %g s: the sheet "
                    "is still moving.\n",
                    study_contact_case[n].label, l[n].force, END);
}

static enum status write_csv(const struct study_contact_run *run, const char *folder,
                             struct message *why)
{
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/contact.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "case,time_s,net_gap_m,surface_gap_m,carried,force_n,crossings,"
                      "net_crossings\n");
    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        for (int k = 0; k < run[n].frames; k++) {
            output_print(out, "%s,%.17g", study_contact_case[n].name, run[n].time[k]);
            for (int s = 0; s < STUDY_CONTACT_SERIES; s++)
                output_print(out, ",%.17g", run[n].series[s][k]);
            output_print(out, "\n");
        }
        output_print(out, "\n\n"); /* gnuplot's blocks */
    }
    st = output_close(out, why);
out:
    return st;
}

static enum status write_plot(const char *folder, struct message *why)
{
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/contact_gap.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "set datafile separator ','\n"
                      "set terminal pngcairo size 1000,600\n"
                      "set output 'contact_gap.png'\n"
                      "set xlabel 'time [s]'\n"
                      "set ylabel 'least gap [m]; solid: surface, dashed: net'\n"
                      "set key outside right\nplot \\\n");
    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        output_print(out,
                     "  'contact.csv' skip 1 index %d using 2:4 with lines lt %d title "
                     "\"%s\", \\\n  '' skip 1 index %d using 2:3 with lines lt %d dt 2 "
                     "notitle%s\n",
                     n, n + 1, study_contact_case[n].label, n, n + 1,
                     n + 1 < STUDY_CONTACT_CASES ? ", \\" : "");
    st = output_close(out, why);
    if (st == STATUS_OK)
        st = plot_run(folder, "contact_gap.gp", why);
out:
    return st;
}

/* What is missing because gnuplot is, is told on standard error. */
static enum status write_pictures(const struct study_contact_run *run, const char *folder,
                                  struct message *why)
{
    struct picture_panel panels[STUDY_CONTACT_CASES * STUDY_CONTACT_TIMES];
    char title[STUDY_CONTACT_CASES * STUDY_CONTACT_TIMES][96];
    struct message plot = {""};
    int count = 0;
    enum status st;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        for (int t = 0; t < STUDY_CONTACT_TIMES; t++, count++) {
            if (run[n].xyz[t])
                snprintf(title[count], sizeof title[0], "%s\nt = %g s",
                         study_contact_case[n].label, run[n].at[t]);
            else
                snprintf(title[count], sizeof title[0], "%s\ndied",
                         study_contact_case[n].label);
            panels[count] = (struct picture_panel){title[count], run[n].xyz[t]};
        }
    TRY(write_csv(run, folder, why));
    st = write_plot(folder, &plot);
    if (st == STATUS_OK)
        st = picture_surfaces(folder, "contact_sheets", STUDY_CONTACT_TIMES, count, panels,
                              &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "contact.csv, contact_gap.png and contact_sheets.png in %s\n",
                folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    st = st == STATUS_MEMORY ? st : STATUS_OK;
out:
    return st;
}

enum status study_contact_print(const char *folder, enum table_format format, FILE *file,
                                struct message *why)
{
    struct study_contact_run run[STUDY_CONTACT_CASES] = {0};
    struct landing landing[STUDY_CONTACT_CASES];
    enum status st = STATUS_OK;

    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        TRY(study_contact_read(folder, n, &run[n], why));
        landing[n] = read_landing(&run[n]);
    }
    TRY(print_table(run, landing, format, file));
    tell(run, landing, file);
    TRY(write_pictures(run, folder, why));
out:
    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        study_contact_clear(&run[n]);
    return st;
}
