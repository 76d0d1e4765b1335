#include "bench/study_mesh.h"

#include "bench/study_print.h"

/* Table 2 has the milliseconds. The size is the mesh width, one over the spans of a side.
 */
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
enum { LEVELS = sizeof levels / sizeof *levels, FINEST = LEVELS - 1 };

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
    .caption = "The sheet of Fig. 12, one edge held, undamped, large displacements",
    .scene = "edge_drop",
    .settings = {"material.young=5e4", "material.density=0.7", "damping={kind: none}"},
    .numerics = {"discretization.kinematics=nonlinear", "time.step=0.0025"},
    .count = LEVELS,
    .levels = levels,
    .times = sizeof early / sizeof *early,
    .time = early,
    .truth = true};

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    enum status st;

    TRY(study_measure(&corners, options, why));
    TRY(study_measure(&edge, options, why));
    TRY(study_measure(&physics, options, why));
out:
    return st;
}

static void judge_wrinkles(const struct study *study, const struct study_result *r,
                           FILE *file)
{
    bool rougher = true;

    for (int n = 1; n < LEVELS; n++)
        if (!(r->row[n].frame[0].roughness > r->row[n - 1].frame[0].roughness))
            rougher = false;
    study_print_verdict(
        file, "the denser the control net, the more wrinkles", rougher,
        "%s at %g s, from %s to %s: roughness %.3g, %.3g, %.3g, %.3g, largest stretch "
        "%.3g, "
        "%.3g, %.3g, %.3g. The motions do not %s: neighbouring levels differ by %.2g, %.2g "
        "and %.2g L.",
        study->scene, study->time[0], levels[0].label, levels[FINEST].label,
        r->row[0].frame[0].roughness, r->row[1].frame[0].roughness,
        r->row[2].frame[0].roughness, r->row[3].frame[0].roughness,
        r->row[0].frame[0].stretch, r->row[1].frame[0].stretch, r->row[2].frame[0].stretch,
        r->row[3].frame[0].stretch,
        r->row[2].frame[0].next < r->row[0].frame[0].next ? "part" : "approach each other",
        r->row[0].frame[0].next, r->row[1].frame[0].next, r->row[2].frame[0].next);
}

static void judge_truth(const struct study_result *r, FILE *file)
{
    const int last = physics.times - 1;
    const struct study_frame *truth = &r->true_frame[last];
    bool nearer = true;

    for (int n = 1; n < LEVELS; n++)
        if (!(r->row[n].frame[last].error < r->row[n - 1].frame[last].error))
            nearer = false;
    study_print_verdict(
        file, "refinement raises the accuracy", nearer,
        "Undamped, at %g s: error %.2g, %.2g, %.2g, %.2g L (error bar %.1g); roughness "
        "%.3g, %.3g, %.3g, %.3g, of the truth %.3g.",
        physics.time[last], r->row[0].frame[last].error, r->row[1].frame[last].error,
        r->row[2].frame[last].error, r->row[3].frame[last].error,
        r->truth->error[last] / r->length, r->row[0].frame[last].roughness,
        r->row[1].frame[last].roughness, r->row[2].frame[last].roughness,
        r->row[3].frame[last].roughness, truth->roughness);
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
    judge_wrinkles(&corners, &on_corners, file);
    judge_wrinkles(&edge, &on_edge, file);
    judge_truth(&undamped, file);
out:
    study_result_clear(&on_corners);
    study_result_clear(&on_edge);
    study_result_clear(&undamped);
    return st;
}

const struct exhibit study_mesh_exhibit = {
    .item = {"mesh", "Ren et al. 2024, Fig. 12: 5, 10, 15, 20 control points a side"},
    .measure = measure,
    .print = print,
};
