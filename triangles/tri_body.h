/* tri_body.h - strains, internal forces and tangents of a whole net of triangles: constant
 * strain (tri_strain.h) in each, and bending (tri_net.h). The elements of the large body
 * are the net's strips.
 */
#ifndef TRI_BODY_H
#define TRI_BODY_H

#include "models/mechanics/large_body.h"
#include "triangles/tri_net.h"
#include "triangles/tri_strain.h"

struct tri_body {
    const struct tri_net *net; /* borrowed                                             */
    enum membrane membrane;
    double D[SCENE_MAX_SHEETS][LAW_ENTRIES]; /* tri_strain_stiffness of sheets [N/m]   */
    double area; /* of a triangle                                              [m^2]   */
    int forms_from, hinges_from; /* where a strip's strains of bending start             */
    struct large_body body;      /* the lag is for the membrane                        */
    int *slab;                   /*                                            owned   */
    struct tri_body_room *work;  /* [threads]                                  owned   */
};

/* Prepares; `net`, *b must stay where they are. Threads: as many as OpenMP would give
 * now. */
enum status tri_body_init(struct tri_body *b, const struct scene *scene,
                          const struct tri_net *net, enum membrane membrane);
void tri_body_clear(struct tri_body *b);

/* Returns elastic energy at x[nodes][3] [J]: NaN where a triangle has no area. */
double tri_body_energy(const struct tri_body *b, const double *x);

#endif
