#include "bench/studies/study_mesh_degree.h"

#include <math.h>

#include "bench/studies/study_orders.h"
#include "bench/experiment/study_print.h"

/* The paper's nets are 2 x n x n with the thickness in u; ours have it in w. Table 3 has
 * the milliseconds. */
enum { START, REFINED, ELEVATED, BOTH, LEVELS };
static const struct study_level levels[LEVELS] = {
    {"10x10x2, p = 2",
     "10_2",
     NULL,
     {"discretization.points=[10,10,2]", "discretization.degree=[2,2,1]"},
     0,
     &paper_table3[0]},
    {"15x15x2, p = 2",
     "15_2",
     NULL,
     {"discretization.points=[15,15,2]", "discretization.degree=[2,2,1]"},
     0,
     &paper_table3[1]},
    {"10x10x2, p = 3",
     "10_3",
     NULL,
     {"discretization.points=[10,10,2]", "discretization.degree=[3,3,1]"},
     0,
     &paper_table3[2]},
    {"15x15x2, p = 3",
     "15_3",
     NULL,
     {"discretization.points=[15,15,2]", "discretization.degree=[3,3,1]"},
     0,
     &paper_table3[3]},
};

static const double picture_times[] = {1.025, 1.7}, early[] = {0.1, 0.2, 0.3, 0.4, 0.5};

static const struct study corners = {
    .name = "corners",
    .caption = "Fig. 14, two corners held, the paper's scheme",
    .scene = "corners_drop",
    .settings = {"material.young=5e4", "material.density=0.7"},
    .numerics = {"discretization.kinematics=printed"},
    .count = LEVELS,
    .levels = levels,
    .times = 2,
    .time = picture_times};

static const struct study edge = {
    .name = "edge",
    .caption = "Fig. 14, one edge held, the paper's scheme",
    .scene = "edge_drop",
    .settings = {"material.young=5e4", "material.density=0.7"},
    .numerics = {"discretization.kinematics=printed"},
    .count = LEVELS,
    .levels = levels,
    .times = 2,
    .time = picture_times};

static const struct study physics = {
    .name = "physics",
    .caption =
        "The sheet of Fig. 14, one edge held, undamped, large displacements, remedy none",
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
    TRY(study_orders_measure(options, why));
out:
    return st;
}

/* By the roughness of the whole sheet; away from what holds it is told beside it. */
static void judge_at(const struct study *study, const struct study_result *r, int t,
                     FILE *file)
{
    const struct study_frame *start = &r->row[START].frame[t];
    const struct study_frame *refined = &r->row[REFINED].frame[t];
    const struct study_frame *elevated = &r->row[ELEVATED].frame[t];
    const struct study_frame *both = &r->row[BOTH].frame[t];
    struct study_trend rough =
        study_print_trend(study, r, t, offsetof(struct study_frame, roughness));
    struct study_trend inner =
        study_print_trend(study, r, t, offsetof(struct study_frame, inner));
    struct study_trend stretch =
        study_print_trend(study, r, t, offsetof(struct study_frame, stretch));
    struct study_trend uneven =
        study_print_trend(study, r, t, offsetof(struct study_frame, unevenness));

    study_print_verdict(file, "refinement and elevation both add wrinkle detail",
                        refined->roughness > start->roughness &&
                            elevated->roughness > start->roughness,
                        "%s, %g s, at first, refined, elevated, both: roughness %s; away "
                        "from edges and corners %s; largest stretch %s.",
                        study->name, study->time[t], rough.text, inner.text, stretch.text);
    study_print_verdict(file, "elevation makes the cloth smoother",
                        elevated->unevenness < start->unevenness &&
                            both->unevenness < refined->unevenness,
                        "%s, %g s, at first, refined, elevated, both: unevenness %s.",
                        study->name, study->time[t], uneven.text);
}

static void judge_cost(const struct study_result *r, FILE *file)
{
    const int last = physics.times - 1;
    const struct study_row *refined = &r->row[REFINED], *elevated = &r->row[ELEVATED];
    double error_h = refined->frame[last].error, error_p = elevated->frame[last].error;

    study_print_verdict(file, "refinement and elevation raise the accuracy",
                        error_h < r->row[START].frame[last].error &&
                            error_p < r->row[START].frame[last].error,
                        "Undamped, at %g s: error %.2g L at first, refined %.2g at %.3g ms "
                        "a frame, elevated "
                        "%.2g at %.3g ms, both %.2g (error bar %.1g).",
                        physics.time[last], r->row[START].frame[last].error, error_h,
                        refined->milliseconds, error_p, elevated->milliseconds,
                        r->row[BOTH].frame[last].error, r->truth->error[last] / r->length);
}

/* Equal knots give equal spaces and then motions equal to round-off, which the steps of a
 * thin solid magnify: at most a millionth of what another space makes, at every time. */
static void judge_orders(const struct study_orders_result *r, FILE *file)
{
    const double *same = r->motion[STUDY_ORDERS_ELEVATE_FIRST],
                 *k = r->motion[STUDY_ORDERS_K];

    bool equal = true;

    for (int t = 0; t < STUDY_ORDERS_TIMES; t++)
        if (!(same[t] <= 1e-6 * k[t]))
            equal = false;
    study_print_verdict(
        file,
        "the mixed operations in either order give the same knots, so the same motion",
        r->knots == 0 && equal,
        "When the second order is made to give the first one's knots: they differ by %.2g, "
        "control points by %.2g m, motions by %.2g, %.2g, %.2g L. Not of itself: degree "
        "elevation doubles the knots that are there, and a new knot inserted after it is "
        "single: %d points a side instead of %d, and motions that differ by %.2g, %.2g, "
        "%.2g "
        "L. The paper makes its nets anew at each density and degree, with uniform knots, "
        "and "
        "so has no order of operations.",
        r->knots, r->net, same[0], same[1], same[2], r->points[STUDY_ORDERS_K],
        r->points[STUDY_ORDERS_REFINE_FIRST], k[0], k[1], k[2]);
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_result on_corners = {0}, on_edge = {0}, undamped = {0};
    struct study_orders_result orders;
    enum status st;

    TRY(study_print_all(&corners, folder, format, file, &on_corners, why));
    TRY(study_print_all(&edge, folder, format, file, &on_edge, why));
    TRY(study_print_all(&physics, folder, format, file, &undamped, why));
    TRY(study_orders_read(folder, &orders, why));
    TRY(study_orders_print(&orders, format, file));
    fprintf(file,
            "\nThe paper's sentences (neither scene nor time of Fig. 14 is told)\n\n");
    for (int t = 0; t < corners.times; t++)
        judge_at(&corners, &on_corners, t, file);
    for (int t = 0; t < edge.times; t++)
        judge_at(&edge, &on_edge, t, file);
    judge_at(&physics, &undamped, physics.times - 1, file);
    judge_cost(&undamped, file);
    judge_orders(&orders, file);
out:
    study_result_clear(&on_corners);
    study_result_clear(&on_edge);
    study_result_clear(&undamped);
    return st;
}

const struct experiment study_mesh_degree_experiment = {
    .item = {"mesh-degree",
             "Ren et al. 2024, Fig. 14: refined, elevated, and in which order"},
    .measure = measure,
    .print = print,
};
