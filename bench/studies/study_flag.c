#include "bench/studies/studies.h"

#include <math.h>
#include <stddef.h>

#include "bench/experiment/gallery.h"
#include "bench/experiment/judge.h"

/* The paper's scheme first, then what else the same sheet may do. mu is damping in the
 * paper's scheme only; all others move undamped. */
enum { PRINTED, COARSE, INCREMENTAL, SOLID, SHELL, SPRINGS, PROJECTIVE, CASES };
enum { TIMES = 3, END = TIMES - 1 };

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
    .times = TIMES,
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
    .settings = add_settings,
    .tell = study_flag_tell};

/* The most of cases from `first` to before `end` at the last time, of a gallery_frame's
 * member; NaN: one of them died. */
static double most_of(const struct gallery_result *r, int first, int end, int t,
                      size_t member)
{
    double most = 0;

    for (int n = first; n < end; n++)
        most = judge_most(most, *(const double *)((const char *)&r->frame[n][t] + member));
    return most;
}

/* What the printed flag does, what the same sheet does as an elastic one. */
static void tell_flow(const struct gallery_result *r, FILE *file)
{
    const struct gallery_frame *printed = &r->frame[PRINTED][END];
    const double angle =
        most_of(r, SOLID, SPRINGS, END, offsetof(struct gallery_frame, angle));
    const double stretch =
        most_of(r, SOLID, SPRINGS, END, offsetof(struct gallery_frame, stretch));

    judge_say(file,
              "The printed scheme's flag sinks by %.3g degrees by %g s, stretched by a "
              "factor of %.3g%s. As an elastic solid or shell with the same E, nu, rho and "
              "thickness (Gamma = %.4g) it sinks by %.2g degrees at most, stretched by "
              "%.4g: %s.",
              printed->angle, gallery.time[END], printed->stretch,
              printed->intersections > 0 ? " and through itself" : "",
              r->run[PRINTED].value[MEASURE_GAMMA], angle, stretch,
              judge_words(judge_below(2 * angle, printed->angle),
                          "most of the paper's fall is the flow of its scheme, not the "
                          "bending of its material",
                          "the paper's fall is that of its material",
                          "whose fall it is cannot be judged"));
}

static void tell_nets(const struct gallery_result *r, FILE *file)
{
    const double coarse = r->frame[COARSE][END].stretch;
    const double fine = r->frame[PRINTED][END].stretch;
    const size_t roughness = offsetof(struct gallery_frame, roughness);
    double rough = 0, smooth = 0;

    for (int t = 0; t < TIMES; t++) {
        smooth = judge_most(smooth, most_of(r, SOLID, SPRINGS, t, roughness));
        rough = judge_most(rough, most_of(r, SPRINGS, CASES, t, roughness));
    }
    judge_say(file,
              "The printed scheme %s: at %g s its stretch is %.3g on the coarser net and "
              "%.3g on the paper's.",
              judge_words(judge_below(0.1, fabs(fine / coarse - 1)),
                          "does not settle as the net is refined",
                          "hardly depends on the net", "died on one of its nets"),
              gallery.time[END], coarse, fine);
    judge_say(
        file,
        "The nets of springs and constraints, matched to the same E, nu and h, have a "
        "roughness of up to %.3g against %.3g of solid and shell%s.",
        rough, smooth,
        judge_words(judge_below(2 * smooth, rough),
                    ": they crumple where the sheet would stand", "",
                    ", which cannot be judged"));
}

enum status study_flag_tell(const struct gallery_result *r, const char *folder,
                            enum table_format format, FILE *file, struct message *why)
{
    enum status st;

    TRY(gallery_print(&gallery, r, "Fig. 15, a flag at the paper's times", folder, format,
                      file, why));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fputc('\n', file);
    if (r->quick) {
        judge_say(file, "Whose fall it is, and what nets do to it: not judged: quick.");
        return STATUS_OK;
    }
    tell_flow(r, file);
    tell_nets(r, file);
out:
    return st;
}

const struct experiment study_flag_experiment = {
    .item = {"flag", "Ren et al. 2024, Fig. 15: a flag sinks, by several models"},
    .gallery = &gallery,
};
