#include "bench/studies/study_flag.h"

#include <math.h>

#include "bench/experiment/gallery.h"

/* The paper's scheme first, then what else the same sheet may do. mu is damping in the
 * paper's scheme only; all others move undamped. */
enum { PRINTED, COARSE, INCREMENTAL, SOLID, SHELL, SPRINGS, PROJECTIVE, CASES };

static void add(struct gallery *g, const char *label, const char *name, const char *model,
                const char *kinematics, const char *points)
{
    struct gallery_case *item = &g->item[g->count++];

    *item = (struct gallery_case){
        .label = label, .name = name, .scene = "flag", .model = model};
    gallery_set(item, "discretization.kinematics=%s", kinematics);
    gallery_set(item, "discretization.points=%s", points);
    if (g->count > COARSE + 1)
        gallery_set(item, "damping={kind: none}");
}

static struct gallery build(bool quick)
{
    struct gallery g = {.name = "flag", .times = 3, .time = {0.75, 1.0, 2.075}};
    const char *fine = quick ? "[6,6,2]" : "[15,15,2]",
               *coarse = quick ? "[5,5,2]" : "[10,10,2]",
               *surface = quick ? "[5,5]" : "[12,12]",
               *nodes = quick ? "[8,8,1]" : "[15,15,1]";

    add(&g, "printed (the paper's)", "printed", "iga", "printed", fine);
    add(&g, "printed, coarser net", "printed_coarse", "iga", "printed", coarse);
    add(&g, "incremental, undamped", "incremental", "iga", "incremental", fine);
    add(&g, "nonlinear solid, selective", "nonlinear", "iga", "nonlinear", coarse);
    gallery_set(&g.item[SOLID], "discretization.remedy=selective");
    add(&g, "nonlinear shell", "shell", "shell", "nonlinear", surface);
    add(&g, "mass-spring, matched", "mass_spring", "mass_spring", "nonlinear", nodes);
    add(&g, "projective dynamics, matched", "projective_dynamics", "projective_dynamics",
        "nonlinear", nodes);
    return g;
}

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    struct gallery g = build(options->quick);

    return gallery_measure(&g, options, why);
}

/* What the printed flag does, what the same sheet does as an elastic one. */
static void tell_flow(const struct gallery *g, const struct gallery_result *r, FILE *file)
{
    const int end = g->times - 1;
    const struct gallery_frame *printed = &r->frame[PRINTED][end];
    double angle = fmax(r->frame[SOLID][end].angle, r->frame[SHELL][end].angle);
    double stretch = fmax(r->frame[SOLID][end].stretch, r->frame[SHELL][end].stretch);

    fprintf(
        file,
        "- The printed scheme's flag sinks by %.3g degrees by %g s, stretched by a "
        "factor of %.3g%s.\n  As an elastic solid or shell with the same E, nu, rho and "
        "thickness (Gamma = %.4g) it sinks by %.2g degrees\n  at most, stretched by "
        "%.4g: %s.\n",
        printed->angle, g->time[end], printed->stretch,
        printed->intersections > 0 ? " and through itself" : "",
        r->result[PRINTED].value[CASE_GAMMA], angle, stretch,
        printed->angle > 2 * angle ? "most of the paper's fall is the flow of its "
                                     "scheme, not the bending of its material"
                                   : "the paper's fall is that of its material");
}

static void tell_nets(const struct gallery *g, const struct gallery_result *r, FILE *file)
{
    const int end = g->times - 1;
    double coarse = r->frame[COARSE][end].stretch, fine = r->frame[PRINTED][end].stretch;
    double rough = 0, smooth = 0;

    for (int t = 0; t < g->times; t++)
        for (int n = SOLID; n < CASES; n++) {
            double *most = n < SPRINGS ? &smooth : &rough;
            *most = fmax(*most, r->frame[n][t].roughness);
        }
    fprintf(file,
            "- The printed scheme %s: at %g s its stretch is %.3g on the coarser net and "
            "%.3g on the paper's.\n",
            fabs(fine / coarse - 1) > 0.1 ? "does not settle as the net is refined"
                                          : "hardly depends on the net",
            g->time[end], coarse, fine);
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
    struct gallery g = build(false);
    struct gallery_result r;
    enum status st;

    TRY(gallery_read(&g, folder, &r, why));
    st = gallery_print(&g, &r, "Fig. 15, a flag at the paper's times", format, file);
    if (st == STATUS_OK) {
        fputc('\n', file);
        tell_flow(&g, &r, file);
        tell_nets(&g, &r, file);
        st = gallery_files(&g, &r, folder, why);
    }
    gallery_clear(&r);
out:
    return st;
}

const struct exhibit study_flag_exhibit = {
    .item = {"flag", "Ren et al. 2024, Fig. 15: a flag sinks, by several models"},
    .measure = measure,
    .print = print,
};
