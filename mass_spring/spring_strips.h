/* spring_strips.h - a net of springs (spring_stencil.h) as a body at large displacements.
 * Its elements are the net's rows, each with the springs and the bending that its points
 * feel. Strains: (l^2 - r^2) / 2 of springs [m^2], quadratic in the positions, so that
 * energy-momentum steps keep the energy; of bending, which is linear in them, the force at
 * each point [N], and the values of what softens [m].
 */
#ifndef SPRING_STRIPS_H
#define SPRING_STRIPS_H

#include "models/net/spring_stencil.h"
#include "models/mechanics/large_body.h"

enum { SPRING_STRIPS_AHEAD = SPRING_STENCIL_ALL / 2 };

struct spring_strips {
    const struct spring_stencil *stencil; /* borrowed                                  */
    struct large_body body;               /* the lag is for the springs                */
    int *slab;                            /*                                   owned   */
    long (*pair)[SPRING_STRIPS_AHEAD];    /* [nodes] with neighbours ahead        owned   */
    size_t room;                          /* numbers a thread                          */
    double *work;                         /* [threads][room]                   owned   */
};

/* Prepares; stencil, *s must stay where they are. Threads: as many as OpenMP would give
 * now. */
enum status spring_strips_init(struct spring_strips *s,
                               const struct spring_stencil *stencil);
void spring_strips_clear(struct spring_strips *s);

#endif
