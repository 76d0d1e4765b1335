#include "bench/studies/study_degree.h"

#include "bench/experiment/study_print.h"

/* The paper speaks of k-refinement, but Table 2 has 200 control points at every degree: the
 * net stays, and with it the spans become fewer. */
static const struct study_level levels[] = {
    {"p = q = 2",
     "2",
     NULL,
     {"discretization.degree=[2,2,1]"},
     0,
     &paper_table2[PAPER_DEGREE2]},
    {"p = q = 3",
     "3",
     NULL,
     {"discretization.degree=[3,3,1]"},
     0,
     &paper_table2[PAPER_DEGREE3]},
    {"p = q = 4",
     "4",
     NULL,
     {"discretization.degree=[4,4,1]"},
     0,
     &paper_table2[PAPER_DEGREE4]},
};
enum { LEVELS = sizeof levels / sizeof *levels };

static const double picture_time[] = {1.7}, early[] = {0.1, 0.2, 0.3, 0.4, 0.5};

static const struct study corners = {
    .name = "corners",
    .caption = "Fig. 13, two corners held, 10x10x2, the paper's scheme",
    .scene = "corners_drop",
    .settings = {"material.young=5e4", "material.density=0.7"},
    .numerics = {"discretization.kinematics=printed", "discretization.points=[10,10,2]"},
    .count = LEVELS,
    .levels = levels,
    .times = 1,
    .time = picture_time};

static const struct study edge = {
    .name = "edge",
    .caption = "Fig. 13, one edge held, 10x10x2, the paper's scheme",
    .scene = "edge_drop",
    .settings = {"material.young=5e4", "material.density=0.7"},
    .numerics = {"discretization.kinematics=printed", "discretization.points=[10,10,2]"},
    .count = LEVELS,
    .levels = levels,
    .times = 1,
    .time = picture_time};

static const struct study physics = {
    .name = "physics",
    .caption =
        "The sheet of Fig. 13, one edge held, undamped, large displacements, remedy none",
    .scene = "edge_drop",
    .settings = {"material.young=5e4", "material.density=0.7", "damping={kind: none}"},
    .numerics = {"discretization.kinematics=nonlinear", "discretization.points=[10,10,2]",
                 "time.step=0.0025"},
    .count = LEVELS,
    .levels = levels,
    .times = sizeof early / sizeof *early,
    .time = early,
    .truth = true};

static enum status measure(const struct experiment_options *options, struct message *why)
{
    enum status st;

    TRY(study_measure(&corners, options, why));
    TRY(study_measure(&edge, options, why));
    TRY(study_measure(&physics, options, why));
out:
    return st;
}

static struct study_trend trend(const struct study *study, const struct study_result *r,
                                size_t member)
{
    return study_print_trend(study, r, study->times - 1, member);
}

/* By the roughness of the whole sheet; away from what holds it is told beside it. */
static void judge(const struct study *study, const struct study_result *r, FILE *file)
{
    const double t = study->time[study->times - 1];
    struct study_trend rough = trend(study, r, offsetof(struct study_frame, roughness));
    struct study_trend inner = trend(study, r, offsetof(struct study_frame, inner));
    struct study_trend stretch = trend(study, r, offsetof(struct study_frame, stretch));
    struct study_trend uneven = trend(study, r, offsetof(struct study_frame, unevenness));

    study_print_verdict(file, "the higher the degree, the more bending detail",
                        rough.sign > 0,
                        "%s, %g s: roughness %s; away from edges and corners it %s: %s. "
                        "Largest stretch %s.",
                        study->name, t, rough.text,
                        inner.sign > 0 ? "grows, too" : "does not grow each time",
                        inner.text, stretch.text);
    study_print_verdict(
        file, "the higher the degree, the smoother", uneven.sign < 0,
        "%s, %g s: unevenness %s; the curvature is continuous from p = 3 on "
        "by construction.",
        study->name, t, uneven.text);
}

static void judge_truth(const struct study_result *r, FILE *file)
{
    const int last = physics.times - 1;
    struct study_trend error = trend(&physics, r, offsetof(struct study_frame, error));

    study_print_verdict(file, "elevation raises the accuracy", error.sign < 0,
                        "Undamped, at %g s: error %s L (error bar %.1g) for %.3g, %.3g, "
                        "%.3g ms a frame; the "
                        "truth's roughness is %.3g, its unevenness %.3g.",
                        physics.time[last], error.text, r->truth->error[last] / r->length,
                        r->row[0].milliseconds, r->row[1].milliseconds,
                        r->row[2].milliseconds, r->true_frame[last].roughness,
                        r->true_frame[last].unevenness);
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_result on_corners = {0}, on_edge = {0}, undamped = {0};
    enum status st;

    TRY(study_print_all(&corners, folder, format, file, &on_corners, why));
    TRY(study_print_all(&edge, folder, format, file, &on_edge, why));
    TRY(study_print_all(&physics, folder, format, file, &undamped, why));
    fprintf(file, "The paper's sentences (it does not say which scene Fig. 13 shows)\n\n");
    judge(&corners, &on_corners, file);
    judge(&edge, &on_edge, file);
    judge(&physics, &undamped, file);
    judge_truth(&undamped, file);
out:
    study_result_clear(&on_corners);
    study_result_clear(&on_edge);
    study_result_clear(&undamped);
    return st;
}

const struct experiment study_degree_experiment = {
    .item = {"degree", "Ren et al. 2024, Fig. 13: p = q = 2, 3, 4 on 10x10x2 points"},
    .measure = measure,
    .print = print,
};
