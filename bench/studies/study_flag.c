#include "bench/studies/studies.h"

#include <math.h>

#include "bench/experiment/gallery.h"

/* The paper's scheme first, then what else the same sheet may do. mu is damping in the
 * paper's scheme only; all others move undamped. */
enum { PRINTED, COARSE, INCREMENTAL, SOLID, SHELL, SPRINGS, PROJECTIVE, CASES };

static const struct {
    int side, quick; /* points or nodes                                                  */
} net[CASES] = {{15, 6}, {10, 5}, {15, 6}, {10, 5}, {12, 5}, {15, 8}, {15, 8}};

static void add_settings(int n, bool quick, struct settings *s)
{
    const int side = quick ? net[n].quick : net[n].side;

    settings_integers(s, "discretization.points", 2, (int[]){side, side});
    if (n > COARSE)
        settings_set(s, "damping={kind: none}");
}

static const struct gallery gallery = {
    .name = "flag",
    .times = 3,
    .time = {0.75, 1.0, 2.075},
    .count = CASES,
    .item = {{"printed (the paper's)", "printed", "flag", "iga_paper"},
             {"printed, coarser net", "printed_coarse", "flag", "iga_paper"},
             {"incremental, undamped", "incremental", "flag", "iga_incremental"},
             {"nonlinear solid, selective", "nonlinear", "flag", "iga_selective"},
             {"nonlinear shell", STUDIES_SHELL, "flag", STUDIES_SHELL},
             {"mass-spring, matched", STUDIES_SPRINGS, "flag", STUDIES_SPRINGS},
             {"projective dynamics, matched", STUDIES_PROJECTIVE, "flag",
              STUDIES_PROJECTIVE}},
    .settings = add_settings};

static enum status measure(const struct experiment_options *options, struct message *why)
{
    return gallery_measure(&gallery, options, why);
}

/* What the printed flag does, what the same sheet does as an elastic one. */
static void tell_flow(const struct gallery_result *r, FILE *file)
{
    const int end = gallery.times - 1;
    const struct gallery_frame *printed = &r->frame[PRINTED][end];
    double angle = fmax(r->frame[SOLID][end].angle, r->frame[SHELL][end].angle);
    double stretch = fmax(r->frame[SOLID][end].stretch, r->frame[SHELL][end].stretch);

    fprintf(
        file,
        "- The printed scheme's flag sinks by %.3g degrees by %g s, stretched by a factor "
        "of %.3g%s.\n  As an elastic solid or shell with the same E, nu, rho and thickness "
        "(Gamma = %.4g) it sinks by %.2g degrees\n  at most, stretched by %.4g: %s.\n",
        printed->angle, gallery.time[end], printed->stretch,
        printed->intersections > 0 ? " and through itself" : "",
        r->run[PRINTED].value[MEASURE_GAMMA], angle, stretch,
        printed->angle > 2 * angle ? "most of the paper's fall is the flow of its "
                                     "scheme, not the bending of its material"
                                   : "the paper's fall is that of its material");
}

static void tell_nets(const struct gallery_result *r, FILE *file)
{
    const int end = gallery.times - 1;
    double coarse = r->frame[COARSE][end].stretch, fine = r->frame[PRINTED][end].stretch;
    double rough = 0, smooth = 0;

    for (int t = 0; t < gallery.times; t++)
        for (int n = SOLID; n < CASES; n++) {
            double *most = n < SPRINGS ? &smooth : &rough;
            *most = fmax(*most, r->frame[n][t].roughness);
        }
    fprintf(file,
            "- The printed scheme %s: at %g s its stretch is %.3g on the coarser net and "
            "%.3g on the paper's.\n",
            fabs(fine / coarse - 1) > 0.1 ? "does not settle as the net is refined"
                                          : "hardly depends on the net",
            gallery.time[end], coarse, fine);
    fprintf(
        file,
        "- The nets of springs and constraints, matched to the same E, nu and h, have a "
        "roughness of up to %.3g against %.3g\n  of solid and shell%s.\n",
        rough, smooth,
        rough > 2 * smooth ? ": they crumple where the sheet would stand" : "");
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct gallery_result r;
    enum status st;

    TRY(gallery_read(&gallery, folder, &r, why));
    st = gallery_print(&gallery, &r, "Fig. 15, a flag at the paper's times", folder, format,
                       file, why);
    if (st == STATUS_OK && table_format_is_prose(format)) {
        fputc('\n', file);
        tell_flow(&r, file);
        tell_nets(&r, file);
    }
    gallery_clear(&r);
out:
    return st;
}

const struct experiment study_flag_experiment = {
    .item = {"flag", "Ren et al. 2024, Fig. 15: a flag sinks, by several models"},
    .measure = measure,
    .print = print,
};
