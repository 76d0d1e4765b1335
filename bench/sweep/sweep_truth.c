#include "bench/sweep/sweep_truth.h"

#include <math.h>

#include "bench/truth/truth.h"
#include "models/metric/metric.h"

enum status sweep_truth_open(struct sweep_truth *truth, const struct scene *scene,
                             struct message *why)
{
    *truth = (struct sweep_truth){.length = scene->length};
    /* A factor a step is no physics that a truth could have: nothing needs to be read. */
    return truth_plan_damping(scene) ? STATUS_OK : truth_judged(scene, &truth->made, why);
}

void sweep_truth_close(struct sweep_truth *truth)
{
    truth_clear(&truth->made);
}

/* Fills in the distance and the bar where the truth is known at this time. */
static enum status look(void *context, const struct motion *m, const double *xyz,
                        double *value)
{
    const struct sweep_truth *truth = context;
    const struct truth *made = &truth->made;
    const int n = truth_index(made, made->claimed, m->time);

    value[LOOKS_TRUTH_ERROR] = n < 0 ? NAN : metric_rmse(xyz, made->xyz[n]) / truth->length;
    value[LOOKS_TRUTH_BAR] = n < 0 ? NAN : made->error[n] / truth->length;
    return STATUS_OK;
}

void sweep_truth_keep(struct sweep_truth *truth, struct run_keep *keep)
{
    if (!truth->made.claimed)
        return;
    for (int n = 0; n < LOOKS_TRUTH; n++)
        truth->own[n] = (struct run_own){looks_truth[n], "1"};
    keep->own_count = LOOKS_TRUTH;
    keep->own = truth->own;
    keep->own_look = look;
    keep->context = truth;
}
