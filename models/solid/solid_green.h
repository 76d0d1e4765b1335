/* solid_green.h - strains, internal forces, tangents and energy of a whole solid at large
 * displacements (solid_green_element.h), on the pattern of its solid_assembly.
 *
 * What the rest shape gives each Gauss point is computed once. Assembly runs over slabs in
 * parallel; sums are made in an order that does not depend on the number of threads.
 */
#ifndef SOLID_GREEN_H
#define SOLID_GREEN_H

#include "models/mechanics/large_body.h"
#include "models/solid/solid_assembly.h"

struct solid_green {
    const struct solid_assembly *assembly; /* pattern, places, material      borrowed  */
    struct large_body body; /* the lag is for all strains                              */
    void *room;             /* memory of the arrays                          owned     */
    /* In a space with a layer, g, n and dV are solid_layer_rest's q, t and dV. */
    double *g;    /* [elements][gauss][3][row]                                         */
    double *dV;   /* [elements][gauss]                                                 */
    int *points;  /* [elements][SOLID_KINDS] of a layer, or NULL                       */
    double *n;    /* of a layer, or NULL                                               */
    double *mode; /* [elements][gauss][modes][3] or NULL                               */
    double *A;    /* [elements][INTERNAL][INTERNAL] or NULL                            */
};

/* Prepares; `assembly` and *s must stay where they are until solid_green_clear.
 * STATUS_INVERTED if the rest shape is folded. */
enum status solid_green_init(struct solid_green *s, const struct solid_assembly *assembly);
void solid_green_clear(struct solid_green *s);

/* Finds the elastic energy of a struct solid_green at x[nodes][3] [J]. STATUS_INVERTED
 * where x is no valid shape. */
enum status solid_green_energy(const void *self, const double *x, double *energy);

#endif
