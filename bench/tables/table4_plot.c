/* table4.csv: every measure of every run; table4.png: the labels over E/rho and mu. */
#include <math.h>
#include <stdio.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "bench/tables/table4_data.h"

static enum status write_csv(const struct table4_data *d, const char *folder,
                             struct message *why)
{
    enum status st;
    struct output *out = NULL;
    char path[4096], words[128];

    snprintf(path, sizeof path, "%s/table4.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "physics,scene,row,young,density,mu");
    for (int n = 0; n < CASE_MEASURES; n++)
        output_print(out, ",%s", case_measure_name(n));
    output_print(out, ",outcome,feasible,labels,paper_feasible,paper_labels\n");
    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
                const struct paper_table4_row *p = &paper_table4[row];
                const struct case_result *c = &d->result[r][s][row];
                output_print(out, "%s,%s,%d,%.17g,%.17g,%.17g", table4_reading[r].name,
                             table4_scene[s], row + 1, p->young, p->density, p->damping);
                for (int n = 0; n < CASE_MEASURES; n++)
                    output_print(out, ",%.17g", c->value[n]);
                output_print(out, ",\"%s\",%s,", c->sentence.text,
                             d->feasible[r][s][row] ? "yes" : "no");
                table4_data_words(d->labels[r][s][row], words, sizeof words);
                output_print(out, "\"%s\",%s,", words, p->labels ? "no" : "yes");
                table4_data_words(p->labels, words, sizeof words);
                output_print(out, "\"%s\"\n", words);
            }
    struct output *whole = out;
    out = NULL;
    TRY(output_close(whole, why));
out:
    output_discard(out);
    return st;
}

/* Squares side by side from the row's place, one a label; class 0: feasible; PAPER_LABELS +
 * 1: infeasible without a label. */
static void squares(struct output *out, int row, double shift, bool feasible,
                    unsigned labels)
{
    const double apart = 1.075, ratio = paper_table4[row].young / paper_table4[row].density;
    const double mu = paper_table4[row].damping + shift;
    int count = 0;

    if (!labels)
        output_print(out, "%g %g %d\n", ratio, mu, feasible ? 0 : PAPER_LABELS + 1);
    for (int n = 0; n < PAPER_LABELS; n++)
        if (labels >> n & 1)
            output_print(out, "%g %g %d\n", ratio * pow(apart, count++), mu, n + 1);
}

/* A block of data: ours (reading, scene), or the paper's (reading < 0). */
static void block(struct output *out, const struct table4_data *d, const char *name,
                  int reading, int scene)
{
    const double up = 0.015;

    output_print(out, "$%s << EOD\n", name);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        if (reading < 0)
            squares(out, row, up, !paper_table4[row].labels, paper_table4[row].labels);
        else
            squares(out, row, -up, d->feasible[reading][scene][row],
                    d->labels[reading][scene][row]);
    output_print(out, "EOD\n");
}

static enum status write_script(const struct table4_data *d, const char *folder,
                                struct message *why)
{
    static const int shown[] = {TABLE4_PRINTED, TABLE4_SHELL};
    enum status st;
    struct output *out = NULL;
    char path[4096], name[32];

    snprintf(path, sizeof path, "%s/table4.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out,
                 "set terminal pngcairo noenhanced size 1300,950\n"
                 "set output 'table4.png'\nset logscale x\n"
                 "set xrange [2.5e4:1.6e6]\nset yrange [-0.02:1.02]\n"
                 "set xlabel 'E/rho [m^2/s^2]'\nset ylabel 'mu'\nset grid\n"
                 "unset colorbox\nunset key\nset cbrange [0:%d]\n"
                 "set palette maxcolors %d defined (0 '#2ca02c', 1 '#d62728', "
                 "2 '#1f77b4', 3 '#e6b800', 4 '#9467bd', 5 '#17becf', 6 '#444444')\n",
                 PAPER_LABELS + 1, PAPER_LABELS + 2);
    block(out, d, "paper", -1, 0);
    output_print(out, "$words << EOD\n0.5 0 0 feasible\n");
    for (int n = 0; n < PAPER_LABELS; n++)
        output_print(out, "0.5 %g %d \"%s\"\n", 1.4 * (n + 1), n + 1, paper_label[n]);
    output_print(out, "0.5 %g %d \"not named\"\nEOD\n", 1.4 * (PAPER_LABELS + 1),
                 PAPER_LABELS + 1);
    output_print(out, "set multiplot\nset size 0.5,0.46\n");
    for (int r = 0; r < 2; r++)
        for (int s = 0; s < TABLE4_SCENES; s++) {
            snprintf(name, sizeof name, "ours%d%d", r, s);
            block(out, d, name, shown[r], s);
            output_print(out,
                         "set origin %g,%g\nset title \"%s, %s: paper above, ours below\"\n"
                         "plot $paper using 1:2:3 with points pt 5 ps 1.6 lc palette, "
                         "$%s using 1:2:3 with points pt 5 ps 1.6 lc palette\n",
                         0.5 * s, 0.54 - 0.46 * r, table4_scene[s],
                         table4_reading[shown[r]].title, name);
        }
    output_print(out, "unset logscale\nunset title\nunset xlabel\nunset ylabel\n"
                      "unset tics\nunset border\nunset grid\nset size 1,0.08\n"
                      "set origin 0,0\nset xrange [-0.7:10]\nset yrange [0:1]\n"
                      "plot $words using 2:1:3 with points pt 5 ps 2 lc palette, "
                      "$words using ($2+0.12):1:4 with labels left\nunset multiplot\n");
    struct output *whole = out;
    out = NULL;
    TRY(output_close(whole, why));
out:
    output_discard(out);
    return st;
}

enum status table4_plot(const struct table4_data *d, const char *folder,
                        struct message *why)
{
    struct message plot = {""};
    enum status st;

    TRY(write_csv(d, folder, why));
    TRY(write_script(d, folder, why));
    st = plot_run(folder, "table4.gp", &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "every number in %s/table4.csv; plot in %s/table4.png\n", folder,
                folder);
    else
        fprintf(stderr, "every number in %s/table4.csv; %s\n", folder, plot.text);
    st = STATUS_OK;
out:
    return st;
}
