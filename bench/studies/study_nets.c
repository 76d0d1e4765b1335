#include "bench/studies/studies.h"

#include <math.h>

#include "bench/experiment/study.h"
#include "bench/studies/study_orders.h"

/* The paper's scheme on either scene, and the same sheet with a truth. */
struct sheets {
    const struct study *corners, *edge, *physics;
};

static struct sheets sheets_of(const struct study_results *r)
{
    return (struct sheets){study_find(r, "corners"), study_find(r, "edge"),
                           study_find(r, "physics")};
}

/* The roughness of the whole sheet, and beside it away from what holds it; the largest
 * stretch; how uneven the curvature is. */
struct look {
    struct study_trend rough, inner, stretch, uneven;
};

static struct look look_at(const struct study *s, int t)
{
    return (struct look){study_print_trend(s, t, offsetof(struct study_frame, roughness)),
                         study_print_trend(s, t, offsetof(struct study_frame, inner)),
                         study_print_trend(s, t, offsetof(struct study_frame, stretch)),
                         study_print_trend(s, t, offsetof(struct study_frame, unevenness))};
}

static const char *grows(const struct study_trend *trend)
{
    return trend->sign > 0 ? "grows, too" : "does not grow each time";
}

static double last_time(const struct study *s)
{
    return s->time[s->frames - 1];
}

/* Of the truth at the last time, over the length; NaN: there is no truth. */
static double last_bar(const struct study *s)
{
    return s->truth ? s->truth->error[s->frames - 1] / s->length : NAN;
}

static void judge_wrinkles(const struct study *s, const struct study *physics, FILE *file)
{
    const struct look look = look_at(s, s->frames - 1);
    const double next[] = {s->row[0].frame[0].next, s->row[1].frame[0].next,
                           s->row[2].frame[0].next};
    double true_stretch = 0;

    for (int t = 0; t < physics->frames; t++)
        true_stretch = fmax(true_stretch, physics->true_frame[t].stretch);
    study_print_verdict(
        file, "the denser the control net, the more wrinkles", look.rough.sign > 0,
        "%s at %g s: roughness %s; away from edges and corners it %s: %s. Largest stretch "
        "%s; of the undamped truth, up to %g s, %.4g. The motions %s each other: "
        "neighbouring levels differ by %.2g, %.2g and %.2g L.",
        s->row[0].run.scene.name, s->time[0], look.rough.text, grows(&look.inner),
        look.inner.text, look.stretch.text, last_time(physics), true_stretch,
        next[1] < next[0] && next[2] < next[1] ? "approach" : "do not approach", next[0],
        next[1], next[2]);
}

static enum status tell_mesh(const struct study_results *r, const char *folder,
                             enum table_format format, FILE *file, struct message *why)
{
    const struct sheets s = sheets_of(r);
    const struct study *physics = s.physics;
    enum status st;

    TRY(study_print_all(r, folder, format, file, why));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fprintf(file, "The paper's sentences (it does not say which scene Fig. 12 shows)\n\n");
    judge_wrinkles(s.corners, physics, file);
    judge_wrinkles(s.edge, physics, file);
    const struct study_trend error =
        study_print_last(physics, offsetof(struct study_frame, error));
    study_print_verdict(file, "refinement raises the accuracy", error.sign < 0,
                        "Undamped, at %g s: error %s L (error bar %.1g); roughness %s, of "
                        "the truth %.3g.",
                        last_time(physics), error.text, last_bar(physics),
                        look_at(physics, physics->frames - 1).rough.text,
                        physics->true_frame[physics->frames - 1].roughness);
out:
    return st;
}

static void judge_detail(const struct study *s, FILE *file)
{
    const struct look look = look_at(s, s->frames - 1);

    study_print_verdict(file, "the higher the degree, the more bending detail",
                        look.rough.sign > 0,
                        "%s, %g s: roughness %s; away from edges and corners it %s: %s. "
                        "Largest stretch %s.",
                        s->plan->name, last_time(s), look.rough.text, grows(&look.inner),
                        look.inner.text, look.stretch.text);
    study_print_verdict(
        file, "the higher the degree, the smoother", look.uneven.sign < 0,
        "%s, %g s: unevenness %s; the curvature is continuous from p = 3 on "
        "by construction.",
        s->plan->name, last_time(s), look.uneven.text);
}

static enum status tell_degree(const struct study_results *r, const char *folder,
                               enum table_format format, FILE *file, struct message *why)
{
    const struct sheets s = sheets_of(r);
    const struct study_row *row = s.physics->row;
    const struct study_frame *true_frame = &s.physics->true_frame[s.physics->frames - 1];
    enum status st;

    TRY(study_print_all(r, folder, format, file, why));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fprintf(file, "The paper's sentences (it does not say which scene Fig. 13 shows)\n\n");
    judge_detail(s.corners, file);
    judge_detail(s.edge, file);
    judge_detail(s.physics, file);
    const struct study_trend error =
        study_print_last(s.physics, offsetof(struct study_frame, error));
    study_print_verdict(file, "elevation raises the accuracy", error.sign < 0,
                        "Undamped, at %g s: error %s L (error bar %.1g) for %.3g, %.3g, "
                        "%.3g ms a frame; the truth's roughness is %.3g, its unevenness "
                        "%.3g.",
                        last_time(s.physics), error.text, last_bar(s.physics),
                        row[0].milliseconds, row[1].milliseconds, row[2].milliseconds,
                        true_frame->roughness, true_frame->unevenness);
out:
    return st;
}

/* Levels of mesh-degree. */
enum { START, REFINED, ELEVATED, BOTH };

static void judge_at(const struct study *s, int t, FILE *file)
{
    const struct study_frame *start = &s->row[START].frame[t];
    const struct study_frame *refined = &s->row[REFINED].frame[t];
    const struct study_frame *elevated = &s->row[ELEVATED].frame[t];
    const struct study_frame *both = &s->row[BOTH].frame[t];
    const struct look look = look_at(s, t);

    study_print_verdict(
        file, "refinement and elevation both add wrinkle detail",
        refined->roughness > start->roughness && elevated->roughness > start->roughness,
        "%s, %g s, at first, refined, elevated, both: roughness %s; away "
        "from edges and corners %s; largest stretch %s.",
        s->plan->name, s->time[t], look.rough.text, look.inner.text, look.stretch.text);
    study_print_verdict(file, "elevation makes the cloth smoother",
                        elevated->unevenness < start->unevenness &&
                            both->unevenness < refined->unevenness,
                        "%s, %g s, at first, refined, elevated, both: unevenness %s.",
                        s->plan->name, s->time[t], look.uneven.text);
}

static void judge_cost(const struct study *s, FILE *file)
{
    const struct study_row *row = s->row;
    double error[BOTH + 1];

    for (int n = START; n <= BOTH; n++)
        error[n] = row[n].frame[s->frames - 1].error;
    study_print_verdict(file, "refinement and elevation raise the accuracy",
                        error[REFINED] < error[START] && error[ELEVATED] < error[START],
                        "Undamped, at %g s: error %.2g L at first, refined %.2g at %.3g ms "
                        "a frame, elevated %.2g at %.3g ms, both %.2g (error bar %.1g).",
                        last_time(s), error[START], error[REFINED],
                        row[REFINED].milliseconds, error[ELEVATED],
                        row[ELEVATED].milliseconds, error[BOTH], last_bar(s));
}

/* Equal knots give equal spaces and then motions equal to round-off, which the steps of a
 * thin solid magnify: at most a millionth of what another space makes, at every time. */
static void judge_orders(const struct study_orders_result *r, FILE *file)
{
    const double *same = r->motion[STUDY_ORDERS_ELEVATE_FIRST],
                 *k = r->motion[STUDY_ORDERS_K];
    bool equal = true;

    for (int t = 0; t < STUDY_ORDERS_TIMES; t++)
        equal &= same[t] <= 1e-6 * k[t];
    study_print_verdict(
        file,
        "the mixed operations in either order give the same knots, so the same motion",
        r->knots == 0 && equal,
        "When the second order is made to give the first one's knots: they differ by %.2g, "
        "control points by %.2g m, motions by %.2g, %.2g, %.2g L. Not of itself: degree "
        "elevation doubles the knots that are there, and a new knot inserted after it is "
        "single: %d points a side instead of %d, and motions that differ by %.2g, %.2g, "
        "%.2g L. The paper makes its nets anew at each density and degree, with uniform "
        "knots, and so has no order of operations.",
        r->knots, r->net, same[0], same[1], same[2], r->points[STUDY_ORDERS_K],
        r->points[STUDY_ORDERS_REFINE_FIRST], k[0], k[1], k[2]);
}

static enum status tell_both(const struct study_results *r, const char *folder,
                             enum table_format format, FILE *file, struct message *why)
{
    const struct sheets s = sheets_of(r);
    struct study_orders_result orders;
    enum status st;

    TRY(study_print_all(r, folder, format, file, why));
    TRY(study_orders_read(folder, &orders, why));
    TRY(study_orders_print(&orders, format, file));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fprintf(file,
            "\nThe paper's sentences (neither scene nor time of Fig. 14 is told)\n\n");
    for (int t = 0; t < s.corners->frames; t++)
        judge_at(s.corners, t, file);
    for (int t = 0; t < s.edge->frames; t++)
        judge_at(s.edge, t, file);
    judge_at(s.physics, s.physics->frames - 1, file);
    judge_cost(s.physics, file);
    judge_orders(&orders, file);
out:
    return st;
}

const struct experiment study_nets_mesh = {
    .item = {"mesh", NULL}, .plan = "mesh", .tell = tell_mesh};
const struct experiment study_nets_degree = {
    .item = {"degree", NULL}, .plan = "degree", .tell = tell_degree};
const struct experiment study_nets_both = {.item = {"mesh-degree", NULL},
                                           .plan = "mesh-degree",
                                           .measure = study_orders_measure,
                                           .tell = tell_both};
