#include "models/net/net.h"

#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_rest.h"
#include "models/damping.h"
#include "models/mechanics/reaction.h"
#include "models/mesh/mesh_air.h"
#include "models/net/spring_law.h"
#include "models/room.h"

const char *net_mesh_lacks(const struct scene *scene, const struct discretization *d,
                           bool springs)
{
    return scene->pattern && d->mesh && strcmp(d->mesh, "irregular")
               ? "mesh: a sheet with an outline has its own, or one that is made anew from "
                 "the outline, mesh=irregular"
           : mesh_is_grid(scene, d) ? ""
           : scene_sheets(scene) > 1 || scene->shape != SCENE_FLAT
               ? "a mesh: of one flat sheet only"
           : springs && scene->is_fabric ? "springs of a mesh: of an isotropic sheet only; "
                                           "with springs along edges in any direction no "
                                           "rule is known for a fabric's"
           : d->parameters == PARAMETERS_PAPER
               ? "parameters=paper: of a grid only, which is what they are printed for"
               : "";
}

enum status net_refuse(const struct scene *scene, const struct discretization *d,
                       const struct net_refusal *row, struct message *why)
{
    enum status st;

    TRY(model_refuse_net(scene, d, why));
    TRY(contact_rest_refuse(scene, d, why));
    if (mesh_is_grid(scene, d) && (d->seed || d->refine))
        return status_fail(why, STATUS_INPUT, "%s: of a mesh that is no grid",
                           d->seed ? "seed" : "refine");
    for (; row->sentence; row++)
        if (row->is_asked)
            return status_fail(why, STATUS_UNSUPPORTED, "%s", row->sentence);
out:
    return st;
}

static void set_points(struct net *net, enum parameters parameters, double alpha)
{
    const struct scene *s = net->scene;
    const double area_mass = spring_law_mass(s, parameters);
    const double drag = spring_law_drag(parameters);
    const int nodes = net->mesh.nodes;

    for (int a = 0; a < nodes; a++) {
        const struct scene_own *own = &s->own[scene_sheet_of(s, a, nodes)];
        double volume = net->mesh.area[a] * s->thickness;
        net->mass[a] =
            own->density > 0 ? own->density * volume : area_mass * net->mesh.area[a];
        net->drag[a] = alpha * net->mass[a] + drag + s->drag * volume;
        for (int i = 0; i < 3; i++)
            net->load[3 * a + i] =
                net->mass[a] * s->gravity[i] + s->drag * volume * s->wind[i];
    }
    for (int t = 0; net->dead && t < 3 * nodes; t++)
        net->load[t] += net->dead[t];
}

void net_clear(struct net *net)
{
    net_contact_free(net->contact);
    supports_clear(&net->supports);
    mesh_clear(&net->mesh);
    air_clear(&net->air);
    free(net->room);
    free(net->dead);
    free(net->order);
    memset(net, 0, sizeof *net);
}

static enum mesh_edges at_edges(const struct scene *scene, const struct discretization *d)
{
    return d->bending == BENDING_MIDEDGE                                ? MESH_TURNS
           : d->bending == BENDING_QUADRATIC && !mesh_is_grid(scene, d) ? MESH_SLOPES
                                                                        : MESH_NO_NODES;
}

enum status net_init(struct net *net, const struct scene *scene,
                     const struct discretization *d, struct message *why)
{
    enum status st;
    const bool scenes = d->parameters != PARAMETERS_PAPER, airy = scene->air.density > 0;
    const struct mesh *mesh = &net->mesh;

    *net = (struct net){.scene = scene,
                        .beta = scenes ? damping_stiffness(scene) : 0,
                        .keep = scenes ? damping_velocity(scene) : 1};
    TRY(mesh_make(&net->mesh, scene, d, at_edges(scene, d), why));
    TRY(supports_init(&net->supports, scene, mesh->nodes, mesh->uvw, mesh->rest, why));
    TRY(room_cut(&net->room, ROOM(net->mass, mesh->nodes), ROOM(net->drag, mesh->nodes),
                 ROOM(net->load, 3 * mesh->nodes), ROOM(net->x, 3 * mesh->nodes),
                 ROOM(net->v, 3 * mesh->nodes), ROOM(net->calm, airy * 3 * mesh->nodes),
                 ROOM(net->blow, airy * 3 * mesh->nodes),
                 ROOM(net->hold, airy * mesh->nodes),
                 ROOM(net->shift, supports_most(&net->supports))));
    TRY(mesh_loads(mesh, scene, &net->dead));
    set_points(net, d->parameters, scenes ? damping_mass(scene) : 0);
    memcpy(net->x, mesh->rest, 3 * (size_t)mesh->nodes * sizeof *net->x);
    supports_initial_velocity(&net->supports, scene, mesh->rest,
                              (const double(*)[3])mesh->uvw, net->v);
out:
    return st;
}

enum status net_meet(struct net *net)
{
    return net_contact_make(net->scene, &net->mesh, &net->supports, &net->contact);
}

enum status net_make_air(struct net *net)
{
    if (net->calm)
        memcpy(net->calm, net->load, 3 * (size_t)net->mesh.nodes * sizeof *net->calm);
    return net->calm ? mesh_air(&net->mesh, net->scene, &net->air) : STATUS_OK;
}

void net_blow(struct net *net, double t, double dt, const double *x, const double *v)
{
    if (!net->calm)
        return;
    air_blow(&net->air, net->scene, t + dt);
    air_ahead(&net->air, &(struct air_step){.nodes = net->mesh.nodes,
                                            .dt = dt,
                                            .mass = net->mass,
                                            .drag = net->drag,
                                            .load = net->calm,
                                            .x = x,
                                            .v = v,
                                            .from = v,
                                            .force = net->blow,
                                            .hold = net->hold});
    for (int k = 0; k < 3 * net->mesh.nodes; k++)
        net->load[k] = net->calm[k] + net->blow[k];
}

void net_hold(struct net *net, double t)
{
    const struct supports *s = &net->supports;

    supports_shift(s, net->scene, t, net->shift);
    for (int h = 0; h < s->held_count; h++)
        net->x[s->held[h]] = net->mesh.rest[s->held[h]] + net->shift[h];
}

void net_arrive(const struct net *net, int iterations, int most, double dt,
                struct arrival *arrival)
{
    const int nodes = net->mesh.nodes;
    double mass = 0;

    for (int a = 0; a < nodes; a++)
        mass += net->mass[a];
    arrival_init(arrival, iterations, most,
                 arrival_sum(nodes, net->supports.free_index, true, NULL, net->load), mass,
                 nodes, net->scene, dt);
}

static enum status surface_of(const void *mesh, const struct scene *scene,
                              struct contact_surface *surface)
{
    return mesh_contact(mesh, scene, surface);
}

enum status net_march(struct net *net, struct march *m, const struct discretization *d,
                      struct message *why)
{
    enum status st;
    const struct mesh *mesh = &net->mesh;
    const int points[] = {mesh->points[0], mesh->points[1], 1};

    m->scene = net->scene;
    m->mass = net->mass;
    m->rest = mesh->rest;
    m->uvw = (const double(*)[3])mesh->uvw;
    m->x = net->x;
    m->load = net->load;
    memcpy(m->net, points, sizeof m->net);
    if (mesh->flat.triangles)
        TRY(mesh_order(mesh, &net->order));
    m->order = net->order;
    m->surface = surface_of, m->sheet = mesh;
    m->supports = &net->supports;
    m->clamps = true;
    m->unknowns = mesh->nodes > mesh->vertices ? "mid-surface points and turns of edges"
                                               : "mid-surface points";
    m->euler = d->integrator == INTEGRATOR_IMPLICIT;
    m->lag = m->euler ? 0 : march_lag;
    m->enough = m->euler ? d->iterations : 0;
    m->substeps = march_explicit(d) ? 1 : d->substeps; /* divides by itself */
    TRY(march_init(m, d, why));
    TRY(mesh_air(mesh, net->scene, &m->air));
    if (!net->mesh.flat.start)
        m->body.energy(m->body.self, net->x, &net->rest_energy);
out:
    return st;
}

void net_energy(const struct net *net, const double *v, struct energy *energy)
{
    double kinetic = 0, potential = 0;

    for (size_t n = 0; n < 3 * (size_t)net->mesh.nodes; n++) {
        double mass = net->mass[n / 3];
        kinetic += mass * v[n] * v[n] / 2;
        double weight = mass * net->scene->gravity[n % 3] + (net->dead ? net->dead[n] : 0);
        potential -= weight * (net->x[n] - net->mesh.rest[n]);
    }
    energy->kinetic = kinetic;
    energy->potential = potential;
}

void net_march_energy(const struct net *net, const struct march *m, struct energy *energy)
{
    net_energy(net, march_velocity(m), energy);
    m->body.energy(m->body.self, net->x, &energy->elastic);
    energy->elastic -= net->rest_energy;
}

void net_weigh(const struct net *net, double t, double dt, double *slope, double *shift,
               double (*support)[6])
{
    reaction_clamps(net->scene, net->mesh.nodes, slope, net->x, 1, support);
    for (size_t n = 0; n < 3 * (size_t)net->mesh.nodes; n++)
        slope[n] = net->load[n] - slope[n];
    if (net->contact)
        contact_force(&net->contact->law, slope);
    reaction_inertia(&net->supports, net->scene, t, dt, net->mass, net->drag, shift, slope);
    reaction_add(&net->supports, slope, net->x, 1, support);
}

void net_forces(struct net *net, double t, double dt, double *slope, double (*support)[6],
                double (*body)[6])
{
    memset(support, 0, (size_t)net->scene->support_count * sizeof *support);
    net_weigh(net, t, dt, slope, net->shift, support);
    if (net->contact)
        memcpy(body, net->contact->push, (size_t)net->scene->obstacle_count * sizeof *body);
}

void net_probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct net *net = state;

    mesh_sample(&net->mesh, net->scene, &(struct mesh_field){net->x, 3, 1, 0}, n, uvw, xyz);
}

void net_size(const void *state, struct model_size *size)
{
    const struct net *net = state;

    *size = (struct model_size){.nodes = net->mesh.nodes,
                                .unknowns = net->supports.free_count,
                                .solver = "none",
                                .unknown_basis = "mid-surface points"};
}

void net_touches(const void *state, struct model_contact *contact)
{
    const struct net *net = state;

    *contact = net_contact_report(net->contact);
}
