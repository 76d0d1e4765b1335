/* net.h - a net of points in time, without what holds it together: the mesh, the masses,
 * the forces that do not depend on places, supports, contact, places and velocities. It is
 * the first member of each such model's state, and answers what model.h asks of all.
 */
#ifndef NET_H
#define NET_H

#include "models/mechanics/air.h"
#include "models/mechanics/arrival.h"
#include "models/mechanics/march.h"
#include "models/mesh/mesh.h"
#include "models/model.h"
#include "models/net/net_contact.h"

struct net {
    const struct scene *scene; /*                                             borrowed */
    struct mesh mesh;
    struct supports supports;
    struct net_contact *contact; /* NULL before net_meet, or where the scene has none  */
    void *room;
    double *mass;   /* [nodes]                                                [kg]     */
    double *drag;   /* [nodes] force against velocity, mass damping in it     [N s/m]  */
    double *load;   /* [nodes][3] gravity, wind and loads                     [N]      */
    int *order;     /* of a mesh's nodes, for a march's factors, or NULL       owned   */
    double *dead;   /* [nodes][3] the scene's loads in it, or NULL     [N]     owned   */
    double *x, *v;  /* [nodes][3] of now                                      [m, m/s] */
    double *shift;  /* [held_count] work                                      [m]      */
    struct air air; /* of sweeps; density 0: none                                */
    double *calm, *blow; /* [nodes][3] load without air; that of air       [N]      */
    double (*hold)[9];   /* [nodes] work of air_ahead                               */
    double beta; /* stiffness damping                                      [s]      */
    double keep; /* factor on velocities after each frame                  [1]      */
    double rest_energy; /* round-off of a march's elastic energy at rest     [J]      */
};

/* The scene's needs that every net serves; bits of scene_need. */
#define NET_SERVES                                                                         \
    (SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |          \
     SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_PATCH_SUPPORTS |           \
     SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_INITIAL_MOTION |         \
     SCENE_NEED_SHEETS | SCENE_NEED_FABRIC | SCENE_NEED_OUTLINE | SCENE_NEED_AIR |         \
     SCENE_NEED_GRIPPERS)

/* A refusal names what a net cannot do with the scene and choices at hand. */
struct net_refusal {
    bool is_asked;
    const char *sentence; /* NULL ends a table */
};

/* Returns what models of springs (spring_net.h has those of edges) or of constraints cannot
 * do on a mesh that is no grid; "" if there is nothing. */
const char *net_mesh_lacks(const struct scene *scene, const struct discretization *d,
                           bool springs);

/* Refuses what model_refuse_net and contact_rest_refuse do, then the first row that is
 * asked: STATUS_UNSUPPORTED with its sentence. */
enum status net_refuse(const struct scene *scene, const struct discretization *d,
                       const struct net_refusal *row, struct message *why);

/* Makes the net at rest, with its initial velocity. d: points and parameters; the paper's
 * have a mass and a drag of points of their own, which replaces the scene's damping. *net
 * must stay where it is. */
enum status net_init(struct net *net, const struct scene *scene,
                     const struct discretization *d, struct message *why);
void net_clear(struct net *net);

/* Makes the contact, if the scene has any. */
enum status net_meet(struct net *net);

/* Makes the air of a net that is swept, if the scene has any. */
enum status net_make_air(struct net *net);

/* Puts the air's force in a step of dt from time t [s], of shape x and velocities v, into
 * net->load (air_ahead). */
void net_blow(struct net *net, double t, double dt, const double *x, const double *v);

/* Moves held points of net->x to where they are at time t. */
void net_hold(struct net *net, double t);

/* Prepares to judge steps (arrival.h) of dt [s] by the forces that are left. */
void net_arrive(const struct net *net, int iterations, int most, double dt,
                struct arrival *arrival);

/* Initialises a march of the net, whose owner has set the body, its graph and what no net
 * knows. Substeps, iterations and Euler's steps are choices. */
enum status net_march(struct net *net, struct march *m, const struct discretization *d,
                      struct message *why);

/* Compute the energy at net->x: kinetic and potential of v, without the elastic one, which
 * stays; all of a net that a march moves. */
void net_energy(const struct net *net, const double *v, struct energy *energy);
void net_march_energy(const struct net *net, const struct march *m, struct energy *energy);

/* Adds the forces of supports at net->x, at time t of steps of dt [s], to support[]; slope
 * [nodes][3]: that of the elastic energy, in which it leaves work. shift[held_count] is
 * work. */
void net_weigh(const struct net *net, double t, double dt, double *slope, double *shift,
               double (*support)[6]);

/* Fills in the forces that model.h asks for, of supports and bodies, where no march moves
 * the net. */
void net_forces(struct net *net, double t, double dt, double *slope, double (*support)[6],
                double (*body)[6]);

/* Implement model.h's entries for a state that begins with a net: the bilinear surface; the
 * free unknowns, which no system solves for; the contact of the last frame. */
void net_probe(const void *state, int n, const double *uvw, double *xyz);
void net_size(const void *state, struct model_size *size);
void net_touches(const void *state, struct model_contact *contact);

#endif
