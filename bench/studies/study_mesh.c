#include "bench/studies/study_mesh.h"

#include <math.h>

#include "bench/experiment/study_print.h"

/* Table 2 has the milliseconds. Size: the mesh width, one over the spans of a side. */
static const struct study_level levels[] = {
    {"5x5x2",
     "5",
     NULL,
     {"discretization.points=[5,5,2]"},
     1 / 3.,
     &paper_table2[PAPER_GROWTH]},
    {"10x10x2",
     "10",
     NULL,
     {"discretization.points=[10,10,2]"},
     1 / 8.,
     &paper_table2[PAPER_GROWTH + 1]},
    {"15x15x2",
     "15",
     NULL,
     {"discretization.points=[15,15,2]"},
     1 / 13.,
     &paper_table2[PAPER_GROWTH + 2]},
    {"20x20x2",
     "20",
     NULL,
     {"discretization.points=[20,20,2]"},
     1 / 18.,
     &paper_table2[PAPER_GROWTH + 3]},
};
enum { LEVELS = sizeof levels / sizeof *levels };

static const double picture_time[] = {1.025}, early[] = {0.1, 0.2, 0.3, 0.4, 0.5};

/* The paper does not say which of its scenes Fig. 12 is: both. */
static const struct study corners = {
    .name = "corners",
    .caption = "Fig. 12, two corners held, the paper's scheme",
    .scene = "corners_drop",
    .settings = {"material.young=5e4", "material.density=0.7"},
    .numerics = {"discretization.kinematics=printed"},
    .count = LEVELS,
    .levels = levels,
    .times = 1,
    .time = picture_time};

static const struct study edge = {
    .name = "edge",
    .caption = "Fig. 12, one edge held, the paper's scheme",
    .scene = "edge_drop",
    .settings = {"material.young=5e4", "material.density=0.7"},
    .numerics = {"discretization.kinematics=printed"},
    .count = LEVELS,
    .levels = levels,
    .times = 1,
    .time = picture_time};

/* The scheme's own viscosity has no truth; the same sheet without damping has, for a while.
 */
static const struct study physics = {
    .name = "physics",
    .caption =
        "The sheet of Fig. 12, one edge held, undamped, large displacements, remedy none",
    .scene = "edge_drop",
    .settings = {"material.young=5e4", "material.density=0.7", "damping={kind: none}"},
    .numerics = {"discretization.kinematics=nonlinear", "time.step=0.0025"},
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
static void judge_wrinkles(const struct study *study, const struct study_result *r,
                           const struct study_result *undamped, FILE *file)
{
    struct study_trend rough = trend(study, r, offsetof(struct study_frame, roughness));
    struct study_trend inner = trend(study, r, offsetof(struct study_frame, inner));
    struct study_trend stretch = trend(study, r, offsetof(struct study_frame, stretch));
    const double next[] = {r->row[0].frame[0].next, r->row[1].frame[0].next,
                           r->row[2].frame[0].next};
    double true_stretch = 0;

    for (int t = 0; t < physics.times; t++)
        true_stretch = fmax(true_stretch, undamped->true_frame[t].stretch);
    study_print_verdict(
        file, "the denser the control net, the more wrinkles", rough.sign > 0,
        "%s at %g s: roughness %s; away from edges and corners it %s: %s. Largest stretch "
        "%s; of the undamped truth, up to %g s, %.4g. The motions %s each other: "
        "neighbouring levels differ by %.2g, %.2g and %.2g L.",
        study->scene, study->time[0], rough.text,
        inner.sign > 0 ? "grows, too" : "does not grow each time", inner.text, stretch.text,
        physics.time[physics.times - 1], true_stretch,
        next[1] < next[0] && next[2] < next[1] ? "approach" : "do not approach", next[0],
        next[1], next[2]);
}

static void judge_truth(const struct study_result *r, FILE *file)
{
    const int last = physics.times - 1;
    struct study_trend error = trend(&physics, r, offsetof(struct study_frame, error));
    struct study_trend rough = trend(&physics, r, offsetof(struct study_frame, roughness));

    study_print_verdict(file, "refinement raises the accuracy", error.sign < 0,
                        "Undamped, at %g s: error %s L (error bar %.1g); roughness %s, of "
                        "the truth %.3g.",
                        physics.time[last], error.text, r->truth->error[last] / r->length,
                        rough.text, r->true_frame[last].roughness);
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_result on_corners = {0}, on_edge = {0}, undamped = {0};
    enum status st;

    TRY(study_print_all(&corners, folder, format, file, &on_corners, why));
    TRY(study_print_all(&edge, folder, format, file, &on_edge, why));
    TRY(study_print_all(&physics, folder, format, file, &undamped, why));
    fprintf(file, "The paper's sentences (it does not say which scene Fig. 12 shows)\n\n");
    judge_wrinkles(&corners, &on_corners, &undamped, file);
    judge_wrinkles(&edge, &on_edge, &undamped, file);
    judge_truth(&undamped, file);
out:
    study_result_clear(&on_corners);
    study_result_clear(&on_edge);
    study_result_clear(&undamped);
    return st;
}

const struct experiment study_mesh_experiment = {
    .item = {"mesh", "Ren et al. 2024, Fig. 12: 5, 10, 15, 20 control points a side"},
    .measure = measure,
    .print = print,
};
