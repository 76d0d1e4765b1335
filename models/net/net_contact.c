#include "models/net/net_contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void net_contact_free(struct net_contact *c)
{
    if (!c)
        return;
    contact_clear(&c->law);
    free(c->compliance);
    free(c->push);
    free(c);
}

enum status net_contact_make(const struct scene *scene, const struct mesh *mesh,
                             const struct supports *supports, struct net_contact **contact)
{
    enum status st;
    struct contact_surface surface = {0};
    struct net_contact *c = NULL;

    *contact = NULL;
    if (!contact_wanted(scene))
        return STATUS_OK;
    c = calloc(1, sizeof *c);
    if (!c)
        return STATUS_MEMORY;
    c->supports = supports;
    TRY(mesh_contact(mesh, scene, &surface));
    TRY(contact_init(&c->law, scene, &surface));
    c->compliance = calloc((size_t)mesh->nodes, sizeof *c->compliance);
    c->push = calloc((size_t)scene->obstacle_count + 1, sizeof *c->push);
    if (!c->compliance || !c->push)
        TRY(STATUS_MEMORY);
    contact_begin(&c->law, 0, INFINITY, mesh->rest);
    TRY(contact_find(&c->law, mesh->rest));
    contact_report(&c->law, &c->frame);
    contact_force_bodies(&c->law, mesh->rest, 1, c->push);
    *contact = c, c = NULL;
out:
    net_contact_free(c);
    return st;
}

void net_contact_frame(struct net_contact *c)
{
    for (int o = 0; c && o < c->law.scene->obstacle_count; o++)
        memset(c->push[o], 0, sizeof *c->push);
}

enum status net_contact_project(struct net_contact *c, double t, const double *start,
                                double *x)
{
    enum status st = STATUS_OK;

    if (!c)
        return st;
    contact_begin(&c->law, t - c->dt, c->dt, start);
    TRY(contact_project(&c->law, c->compliance, c->supports->free_index, x));
    contact_report(&c->law, &c->frame);
    contact_force_bodies(&c->law, x, 1.0 / c->steps, c->push);
out:
    return st;
}

struct model_contact net_contact_report(const struct net_contact *c)
{
    struct model_contact now = {.least_gap = INFINITY};

    if (!c)
        return now;
    now = c->frame;
    contact_force_sum(&c->law, (const double(*)[6])c->push, now.force);
    return now;
}
