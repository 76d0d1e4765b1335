#include "peers/tinyvbd/strand.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "vertex_block/vb_body.h"

struct strand {
    int points;
    long taken; /* steps                                                               */
    double dt, gravity;
    struct vb_body body;
    void *room;
    double *x, *v, *before, *start, *target, *inertia; /* before: v of the last step    */
    double *force;
    int *place;
};

static enum status make_body(struct strand *s, const struct strand_plan *plan)
{
    enum status st = STATUS_MEMORY;
    const struct mesh mesh = {.nodes = plan->points, .vertices = plan->points};
    const struct spring_forms forms = {0};
    const double none[LAW_ENTRIES] = {0};
    struct spring_net net = {.spring_count = plan->springs};
    struct blocks graph = {0};

    net.springs = calloc((size_t)plan->springs, sizeof *net.springs);
    graph.start = calloc((size_t)plan->points + 1, sizeof *graph.start);
    if (!net.springs || !graph.start)
        goto out;
    for (int k = 0; k < plan->springs; k++)
        net.springs[k] = (struct spring){.a = plan->ends[k][0],
                                         .b = plan->ends[k][1],
                                         .stiffness = plan->stiffness[k],
                                         .length = plan->length[k]};
    TRY(vb_body_init(
        &s->body,
        &(struct vb_parts){
            .mesh = &mesh, .D = none, .forms = &forms, .graph = &graph, .springs = &net}));
    s->body.colours = plan->in_sequence ? plan->points : s->body.colours;
    for (int a = 0; plan->in_sequence && a <= plan->points; a++) {
        s->body.colours_from[a] = a;
        if (a < plan->points)
            s->body.order[a] = a;
    }
out:
    free(net.springs);
    free(graph.start);
    return st;
}

void strand_free(struct strand *s)
{
    if (!s)
        return;
    vb_body_clear(&s->body);
    free(s->room);
    free(s);
}

struct strand *strand_make(const struct strand_plan *plan)
{
    enum status st = STATUS_MEMORY;
    const size_t points = (size_t)plan->points;
    struct strand *s = calloc(1, sizeof *s);

    if (!s)
        return NULL;
    *s = (struct strand){.points = plan->points, .dt = plan->dt, .gravity = plan->gravity};
    TRY(room_cut(&s->room, ROOM(s->x, 3 * points), ROOM(s->v, 3 * points),
                 ROOM(s->before, 3 * points), ROOM(s->start, 3 * points),
                 ROOM(s->target, 3 * points), ROOM(s->inertia, points),
                 ROOM(s->force, 3 * points), ROOM(s->place, 3 * points)));
    TRY(make_body(s, plan));
    memcpy(s->x, plan->rest, 3 * points * sizeof *s->x);
    for (size_t a = 0; a < points; a++)
        s->inertia[a] = plan->mass[a] / (s->dt * s->dt);
    for (int i = 0; i < 3; i++)
        s->place[i] = -1;
out:
    if (st != STATUS_OK)
        strand_free(s), s = NULL;
    return s;
}

/* Starts a step as TinyVBD does: from the velocity that led to the last target, and that
 * part of gravity which the last change of velocity shows. */
static void predict(struct strand *s)
{
    for (int n = 3; n < 3 * s->points; n++) {
        const double fall = n % 3 == 1 ? -s->dt * s->gravity : 0;
        s->v[n] += fall;
        s->start[n] = s->x[n];
        s->target[n] = s->x[n] + s->dt * s->v[n];
        if (!s->taken) {
            s->x[n] = s->target[n];
            continue;
        }
        const double gain = n % 3 == 1 ? (s->before[n] - s->v[n]) / s->dt : 0;
        const double share = gain > 1e-5 ? fmin(gain, s->gravity) : 0;
        s->x[n] += s->dt * (s->before[n] - s->dt * share);
    }
}

void strand_step(struct strand *s, int sweeps)
{
    const struct vb_step step = {s->inertia, s->target, s->place};

    predict(s);
    for (int k = 0; k < sweeps; k++)
        vb_body_sweep(&s->body, &step, s->x);
    for (int n = 3; n < 3 * s->points; n++) {
        s->before[n] = s->v[n];
        s->v[n] = (s->x[n] - s->start[n]) / s->dt;
    }
    s->taken++;
}

const double *strand_places(const struct strand *s)
{
    return s->x;
}

double strand_left(const struct strand *s)
{
    const struct vb_step step = {s->inertia, s->target, s->place};

    double sum = 0;

    vb_body_force(&s->body, &step, s->x, s->force);
    for (int n = 3; n < 3 * s->points; n++)
        sum += s->force[n] * s->force[n];
    return sqrt(sum / (s->points - 1));
}
