#include "bench/harness/motion.h"

#include <math.h>
#include <stdlib.h>

#include "bench/harness/deadline.h"
#include "bench/ui/progress.h"
#include "models/clock.h"
#include "models/contact/contact.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/option.h"

/* The points examined after every frame: sampling the whole grid would cost more than many
 * a frame. A sheet that flies apart passes `suspicious` lengths frames before the 10 of
 * metric_blowup, which then decides on the whole grid. */
enum { NET = 6, NET_POINTS = NET * NET };
static const double suspicious = 4;

void motion_init(struct motion *m, const struct model *model, const struct scene *scene,
                 void *state)
{
    *m =
        (struct motion){.model = model, .scene = scene, .state = state, .clock = clock_now};
    m->frame_count = (int)lround(scene->end / scene->step);
    m->seconds = arena_take(&m->arena, (size_t)m->frame_count + 1, sizeof *m->seconds);
}

void motion_clear(struct motion *m)
{
    arena_clear(&m->arena);
    *m = (struct motion){0};
}

/* Places the points of the net; of a sheet with an outline those of the material grid next
 * to them that are on it. Returns how many there are. */
static int place_net(const struct scene *scene, double uvw[NET_POINTS][3])
{
    int count = 0;

    for (int n = 0; n < NET_POINTS; n++) {
        double *at = uvw[count];
        at[0] = (double)(n % NET) / (NET - 1);
        at[1] = (double)(n / NET) / (NET - 1);
        at[2] = 0.5;
        if (scene->pattern) {
            const int i = (int)(at[0] * (GRID_U - 1)), j = (int)(at[1] * (GRID_V - 1));
            at[0] = i / (GRID_U - 1.0), at[1] = j / (GRID_V - 1.0);
            count -= scene_void(scene, i, j);
        }
        count++;
    }
    return count;
}

static bool looks_well(const struct motion *m)
{
    double uvw[NET_POINTS][3], xyz[NET_POINTS][3], carried[3];
    const int count = place_net(m->scene, uvw);

    m->model->probe(m->state, count, uvw[0], xyz[0]);
    metric_carried(m->scene, m->steps * m->scene->step, count, uvw[0], xyz[0], carried);
    for (int n = 0; n < count; n++) {
        double rest[3], far = 0;
        scene_rest_point(m->scene, uvw[n], rest);
        for (int i = 0; i < 3; i++)
            far += pow(xyz[n][i] - rest[i] - carried[i], 2);
        if (!(sqrt(far) < suspicious * m->scene->length)) /* NaN too */
            return false;
    }
    return count > 0;
}

/* Examines the state: STATUS_OK, STATUS_NAN, STATUS_ESCAPED or STATUS_MEMORY. */
static enum status look(const struct motion *m)
{
    if (looks_well(m))
        return STATUS_OK;
    double *xyz SCOPED(scope_free) = malloc(GRID_POINTS * 3 * sizeof *xyz);
    if (!xyz)
        return STATUS_MEMORY;
    model_sample(m->model, m->state, xyz);
    return metric_blowup(m->scene, m->steps * m->scene->step, xyz);
}

static enum status advance(struct motion *m)
{
    double start = m->clock();
    enum status st = m->model->advance(m->state, &m->counters);

    m->seconds[m->steps++] = m->clock() - start;
    if (st == STATUS_OK && !m->judged)
        st = look(m);
    if (!status_is_death(st))
        return st;
    m->death = st;
    m->death_time = m->steps * m->scene->step;
    return STATUS_OK;
}

enum status motion_run(struct motion *m, motion_watcher *watch, void *context, bool quiet,
                       struct message *why)
{
    struct progress progress SCOPED(progress_end) =
        progress_start(m->model->name, m->frame_count, quiet);

    if (watch)
        CALL(watch(context, m, why));
    while (m->frames < m->frame_count) {
        if (deadline_left(m->until) < 0)
            return status_fail(why, STATUS_LATE,
                               "%s on %s was stopped at t = %.3g s, as the budget is over",
                               m->model->name, m->scene->name, m->time);
        CALL(advance(m));
        if (m->death)
            break;
        m->time = ++m->frames * m->scene->step;
        if (watch)
            CALL(watch(context, m, why));
        progress_update(&progress, m->frames);
    }
    return STATUS_OK;
}

/* Tells whether a model has explicit steps of a length that serves: those of a body with
 * layers are a hundred times shorter than a shell's, and a hinge refuses them. */
static bool goes_explicit(const struct model *model)
{
    const struct schema_key *steps = option_find(model->options, "integrator");

    return steps && (!steps->only || (steps->only & OPTION(INTEGRATOR_LEAPFROG))) &&
           model->defaults.points[2] < 2;
}

/* Returns what to try against a death. */
static const char *cure(const struct motion *m)
{
    if (m->death != STATUS_DIVERGED && m->death != STATUS_INVERTED)
        return "";
    return !contact_wanted(m->scene) ? "; try half the step (time.step)"
           : goes_explicit(m->model) ? "; try half the step (time.step), more points where "
                                       "it bends most (discretization.points), or explicit "
                                       "steps (discretization.integrator=leapfrog)"
                                     : "; try half the step (time.step), or more points "
                                       "where it bends most (discretization.points)";
}

enum status motion_tell_death(const struct motion *m, struct message *why)
{
    return status_fail(why, m->death, "%s on %s died at t = %.6g s: %s%s", m->model->name,
                       m->scene->name, m->death_time, status_text(m->death), cure(m));
}
