/* spring_load.h - the mass of a net's points, and forces on them that do not depend on
 * their places. The paper's set has a drag on points of its own, which replaces the scene's
 * damping. */
#ifndef SPRING_LOAD_H
#define SPRING_LOAD_H

#include "models/net/spring_net.h"
#include "models/model.h"

struct spring_load {
    const struct scene *scene;    /*                                          borrowed */
    const struct spring_net *net; /*                                          borrowed */
    void *room;
    double *mass; /* [nodes]                                                  [kg]     */
    double *drag; /* [nodes] force against velocity, mass damping in it       [N s/m]  */
    double *load; /* [nodes][3] gravity, wind and loads                       [N]      */
    double *dead; /* [nodes][3] of which the scene's loads, or NULL           [N]      */
    double beta;  /* stiffness damping                                        [s]      */
    double keep;  /* factor on velocities after each frame                    [1]      */
};

/* Initialises, after spring_net_init; scene and net must stay where they are. */
enum status spring_load_init(struct spring_load *l, const struct scene *scene,
                             const struct spring_net *net, enum parameters parameters);
void spring_load_clear(struct spring_load *l);

/* Computes kinetic and potential energy of x and v [nodes][3]; leaves the elastic one. */
void spring_load_energy(const struct spring_load *l, const double *x, const double *v,
                        struct energy *energy);

#endif
