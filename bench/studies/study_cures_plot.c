#include <math.h>
#include <stdio.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "bench/studies/study_cures.h"

/* A block for each law, nu and space, as gnuplot counts them. */
static enum status write_csv(const struct study_cures *s, const char *folder,
                             struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/errors.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "space,gamma,poisson,thickness,tip_over_truth,error\n");
    for (int law = 0; law < STUDY_CURES_LAWS; law++)
        for (int nu = 0; nu < STUDY_CURES_NUS; nu++)
            for (int space = 0; space < STUDY_CURES_SPACES; space++) {
                if (law || nu || space)
                    output_print(out, "\n\n");
                for (int n = 0; n < STUDY_CURES_THICKNESSES; n++) {
                    double error = study_cures_error(s, space, law, nu, n);
                    if (isnan(error))
                        continue;
                    output_print(out, "\"%s\",%g,%g,%g,%.9g,%.9g\n",
                                 study_cures_space[space].label, study_cures_gamma[law],
                                 study_cures_nu[nu], study_cures_thickness[n],
                                 s->tip[space][law][nu][n].z /
                                     s->tip[STUDY_CURES_TRUTH][law][nu][n].z,
                                 error);
                }
            }
    return output_close(out, why);
out:
    return st;
}

static void panel(struct output *out, int law, int nu)
{
    int first = (law * STUDY_CURES_NUS + nu) * STUDY_CURES_SPACES;
    bool keyed = law == STUDY_CURES_LAWS - 1 && nu == STUDY_CURES_NUS - 1; /* room there */

    output_print(
        out, "set title '%s, nu = %g (10x10x2)'\nplot %g with lines lc 'gray' dt 2 notitle",
        law ? law > 1 ? "Gamma = 100" : "Gamma = 10" : "linear", study_cures_nu[nu],
        study_cures_target);
    for (int space = 0; space < STUDY_CURES_SPACES; space++)
        output_print(out,
                     ", \\\n'errors.csv' index %d using 4:($6 > 1e-5 ? $6 : 1e-5) with "
                     "linespoints lc %d pt %d lw 1.5 %s \"%s\"",
                     first + space, space % 3 + 1, space < 3 ? 7 : 6,
                     keyed ? "title" : "notitle",
                     keyed ? study_cures_space[space].label : "");
    output_print(out, "\n");
}

static enum status write_script(const char *folder, struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/cures.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "set terminal pngcairo noenhanced size 1200,1100\n"
                      "set output 'cures.png'\nset datafile separator ','\n"
                      "set logscale xy\nset grid\nset format y '%%g'\nset format x '%%g'\n"
                      "set xrange [5e-6:0.2]\nset yrange [1e-5:2]\nset xlabel 'h/L'\n"
                      "set ylabel '|1 - tip / truth|'\nset key bottom right font ',8'\n"
                      "set multiplot layout 3,3\n");
    for (int law = 0; law < STUDY_CURES_LAWS; law++)
        for (int nu = 0; nu < STUDY_CURES_NUS; nu++)
            panel(out, law, nu);
    output_print(out, "unset multiplot\n");
    return output_close(out, why);
out:
    return st;
}

enum status study_cures_plot(const struct study_cures *s, const char *folder,
                             struct message *why)
{
    struct message plot = {""};
    enum status st;

    TRY(write_csv(s, folder, why));
    TRY(write_script(folder, why));
    st = plot_run(folder, "cures.gp", &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "plot in %s/cures.png beside errors.csv\n", folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    st = STATUS_OK;
out:
    return st;
}
