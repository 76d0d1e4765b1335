#include "bench/studies/studies.h"

#include <math.h>

#include "bench/experiment/judge.h"
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

/* Up (1) or down (-1) from each level to the next. */
static enum judge goes(const struct study_trend *trend, int sign)
{
    return judge_order(trend->count, trend->value, sign, 0);
}

static const char *grows(const struct study_trend *trend)
{
    return judge_words(goes(trend, 1), "grows, too", "does not grow each time",
                       "cannot be judged");
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

/* Errors fall from each to the next by more than the truth's bar leaves open, which may
 * bring two of them nearer to each other by its double. */
static enum judge falls(const struct study *s, int count, const double *error, bool quick)
{
    return judge_quick(judge_order(count, error, -1, 2 * last_bar(s)), quick);
}

static void judge_wrinkles(const struct study *s, const struct study *physics, FILE *file)
{
    const struct look look = look_at(s, s->frames - 1);
    const double next[] = {s->row[0].frame[0].next, s->row[1].frame[0].next,
                           s->row[2].frame[0].next};
    double true_stretch = 0;

    for (int t = 0; t < physics->frames; t++)
        true_stretch = fmax(true_stretch, physics->true_frame[t].stretch);
    judge_print(
        file, "the denser the control net, the more wrinkles", goes(&look.rough, 1),
        "%s at %g s: roughness %s; away from edges and corners it %s: %s. Largest stretch "
        "%s; of the undamped truth, up to %g s, %.4g. The motions %s: neighbouring levels "
        "differ by %.2g, %.2g and %.2g L.",
        s->row[0].run.scene.name, s->time[0], look.rough.text, grows(&look.inner),
        look.inner.text, look.stretch.text, last_time(physics), true_stretch,
        judge_words(judge_order(3, next, -1, 0), "approach each other",
                    "do not approach each other", "cannot be compared"),
        next[0], next[1], next[2]);
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
    judge_print(file, "refinement raises the accuracy",
                falls(physics, error.count, error.value, r->quick),
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

    judge_print(file, "the higher the degree, the more bending detail",
                goes(&look.rough, 1),
                "%s, %g s: roughness %s; away from edges and corners it %s: %s. "
                "Largest stretch %s.",
                s->plan->name, last_time(s), look.rough.text, grows(&look.inner),
                look.inner.text, look.stretch.text);
    judge_print(file, "the higher the degree, the smoother", goes(&look.uneven, -1),
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
    judge_print(file, "elevation raises the accuracy",
                falls(s.physics, error.count, error.value, r->quick),
                "Undamped, at %g s: error %s L (error bar %.1g) for %.3g, %.3g, "
                "%.3g ms a frame; the truth's roughness is %.3g, its unevenness "
                "%.3g.",
                last_time(s.physics), error.text, last_bar(s.physics), row[0].milliseconds,
                row[1].milliseconds, row[2].milliseconds, true_frame->roughness,
                true_frame->unevenness);
out:
    return st;
}

/* Levels of mesh-degree. */
enum { START, REFINED, ELEVATED, BOTH };

static void judge_at(const struct study *s, int t, FILE *file)
{
    const struct look look = look_at(s, t);
    const double *rough = look.rough.value, *uneven = look.uneven.value;

    judge_print(file, "refinement and elevation both add wrinkle detail",
                judge_both(judge_below(rough[START], rough[REFINED]),
                           judge_below(rough[START], rough[ELEVATED])),
                "%s, %g s, at first, refined, elevated, both: roughness %s; away "
                "from edges and corners %s; largest stretch %s.",
                s->plan->name, s->time[t], look.rough.text, look.inner.text,
                look.stretch.text);
    judge_print(file, "elevation makes the cloth smoother",
                judge_both(judge_below(uneven[ELEVATED], uneven[START]),
                           judge_below(uneven[BOTH], uneven[REFINED])),
                "%s, %g s, at first, refined, elevated, both: unevenness %s.",
                s->plan->name, s->time[t], look.uneven.text);
}

static void judge_cost(const struct study *s, bool quick, FILE *file)
{
    const struct study_row *row = s->row;
    const struct study_trend error =
        study_print_last(s, offsetof(struct study_frame, error));
    const double refined[] = {error.value[START], error.value[REFINED]};
    const double elevated[] = {error.value[START], error.value[ELEVATED]};

    judge_print(
        file, "refinement and elevation raise the accuracy",
        judge_both(falls(s, 2, refined, quick), falls(s, 2, elevated, quick)),
        "Undamped, at %g s: error %.2g L at first, refined %.2g at %.3g ms a frame, "
        "elevated %.2g at %.3g ms, both %.2g (error bar %.1g).",
        last_time(s), refined[0], refined[1], row[REFINED].milliseconds, elevated[1],
        row[ELEVATED].milliseconds, error.value[BOTH], last_bar(s));
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
    fprintf(file, "The paper's sentences (neither scene nor time of Fig. 14 is told)\n\n");
    for (int t = 0; t < s.corners->frames; t++)
        judge_at(s.corners, t, file);
    for (int t = 0; t < s.edge->frames; t++)
        judge_at(s.edge, t, file);
    judge_at(s.physics, s.physics->frames - 1, file);
    judge_cost(s.physics, r->quick, file);
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
