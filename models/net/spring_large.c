#include "models/net/spring_large.h"

#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/linalg/order.h"
#include "models/room.h"

static enum status make_arrays(struct spring_large *l, const struct spring_large_plan *plan)
{
    const struct blocks *graph = plan->graph;
    size_t pairs = (size_t)graph->start[graph->nodes];
    enum status st = room_cut(&l->room, ROOM(l->M, pairs), ROOM(l->K, pairs),
                              ROOM(l->held, 4 * (size_t)plan->supports->held_count));

    for (int a = 0; st == STATUS_OK && a < graph->nodes; a++)
        l->M[graph->start[a]] = plan->load->mass[a];
    return st;
}

static enum status make_systems(struct spring_large *l,
                                const struct spring_large_plan *plan)
{
    enum status st;
    const int *points = plan->load->net->points;
    int *order = NULL;

    TRY(order_wide(points[0], points[1], 1, &order));
    TRY(system_init(&l->system, plan->graph, plan->supports, NULL, order, plan->d));
out:
    free(order);
    return st;
}

void spring_large_clear(struct spring_large *l)
{
    large_motion_clear(&l->motion);
    contact_clear(&l->contact);
    system_clear(&l->system);
    newmark_clear(&l->newmark);
    free(l->room);
    memset(l, 0, sizeof *l);
}

enum status spring_large_init(struct spring_large *l, const struct spring_large_plan *plan)
{
    enum status st;
    const struct scene *scene = plan->load->scene;
    struct contact_surface surface;
    bool euler = plan->d->integrator == INTEGRATOR_IMPLICIT;
    bool explicit = plan->d->integrator == INTEGRATOR_LEAPFROG; /* divides by itself */

    *l = (struct spring_large){.load = plan->load,
                               .substeps =
                                   plan->d->substeps && !explicit ? plan->d->substeps : 1};
    TRY(make_arrays(l, plan));
    TRY(newmark_init(&l->newmark, plan->load->net->nodes, scene->step / l->substeps,
                     damping_mass(scene) + damping_drag(scene), plan->load->beta));
    TRY(make_systems(l, plan));
    if (contact_wanted(scene)) {
        TRY(contact_surface_init_net(&surface, scene, plan->load->net->points));
        TRY(contact_init(&l->contact, scene, &surface));
    }
    l->motion = (struct large_motion){
        .body = *plan->body,
        .scene = scene,
        .graph = plan->graph,
        .M = l->M,
        .rest = plan->load->net->rest,
        .load = plan->load->load,
        .supports = plan->supports,
        .system = &l->system,
        .newmark = &l->newmark,
        .K = l->K,
        .x = plan->x,
        .held = l->held,
        .lag = euler ? 0 : large_motion_lag,
        .euler = euler,
        .enough = plan->d->iterations,
        .contact = contact_wanted(scene) ? &l->contact : NULL,
    };
    TRY(large_motion_init(&l->motion));
out:
    if (st != STATUS_OK)
        spring_large_clear(l);
    return st;
}

void spring_large_still(struct spring_large *l)
{
    memset(l->newmark.d, 0, 9 * (size_t)l->motion.graph->nodes * sizeof(double));
    l->motion.started = false;
    l->motion.factored = -1;
}

enum status spring_large_frame(struct spring_large *l, double t, struct counters *counters)
{
    enum status st = STATUS_OK;
    double push[3] = {0, 0, 0};

    for (int n = 0; n < l->substeps; n++) {
        TRY(large_motion_step(&l->motion, t + n * l->newmark.dt, counters));
        for (int i = 0; i < 3; i++)
            push[i] += l->motion.push[i] / l->substeps;
    }
    memcpy(l->motion.push, push, sizeof push);
    supports_damp(l->motion.supports, l->load->keep, l->newmark.v);
out:
    return st;
}
