#include <math.h>
#include <stdio.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "bench/studies/study_locking.h"

static void csv_row(struct output *out, const struct study_locking *s, int space, int nu,
                    int n)
{
    const struct study_locking_space *sp = &study_locking_space[space];
    const struct study_locking_cell *c = &s->cell[space][nu][n];

    output_print(out, "\"%s\",%s,%g,%.9g,%.9g,%.9g,%.0f,%.9g,%.9g\n", sp->label, sp->model,
                 study_locking_nu[nu], s->thickness[n], c->tip, fabs(1 - c->tip),
                 c->run.unknowns, c->run.create.count ? c->run.create.median : NAN,
                 c->run.step.count ? c->run.step.median : NAN);
}

/* A block for each nu and space, nu = 0.3 first, as gnuplot counts them. */
static enum status write_csv(const struct study_locking *s, const char *folder,
                             struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/locking.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "space,model,poisson,thickness_m,tip_over_kirchhoff,error,unknowns,"
                      "setup_s,equilibrium_s\n");
    for (int nu = STUDY_LOCKING_NUS - 1; nu >= 0; nu--)
        for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
            if (space || nu < STUDY_LOCKING_NUS - 1)
                output_print(out, "\n\n");
            for (int n = 0; n < s->count; n++)
                csv_row(out, s, space, nu, n);
        }
    return output_close(out, why);
out:
    return st;
}

static void panel(struct output *out, const char *title, int first)
{
    output_print(out, "set title '%s'\nplot \\\n", title);
    for (int space = 0; space < STUDY_LOCKING_SPACES; space++)
        output_print(
            out,
            "%s'locking.csv' index %d using (1e3*$4):6 with linespoints lc %d pt %d "
            "dt %d lw 1.5 title \"%s\"",
            space ? ", \\\n" : "", first + space, space % 8 + 1, space + 1, space / 8 + 1,
            study_locking_space[space].label);
    output_print(out, "\n");
}

static enum status write_script(const char *folder, struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/locking.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "set terminal pngcairo noenhanced size 1100,1100\n"
                      "set output 'locking.png'\nset datafile separator ','\n"
                      "set datafile missing 'nan'\nset logscale xy\nset grid\n"
                      "set format y '%%g'\nset format x '%%g'\nset yrange [1e-4:1.2]\n"
                      "set xlabel 'thickness h [mm], length 1 m'\n"
                      "set ylabel '|1 - tip / Kirchhoff|'\nset key outside right\n"
                      "set multiplot layout 2,1\n");
    panel(out, "nu = 0.3: both kinds of locking", 0);
    panel(out, "nu = 0: transverse shear locking alone", STUDY_LOCKING_SPACES);
    output_print(out, "unset multiplot\n");
    return output_close(out, why);
out:
    return st;
}

enum status study_locking_plot(const struct study_locking *s, const char *folder,
                               struct message *why)
{
    struct message plot = {""};
    enum status st;

    TRY(write_csv(s, folder, why));
    TRY(write_script(folder, why));
    st = plot_run(folder, "locking.gp", &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "plot in %s/locking.png beside locking.csv\n", folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    st = STATUS_OK;
out:
    return st;
}
