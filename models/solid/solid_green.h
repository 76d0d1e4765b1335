/* solid_green.h - strains, internal forces, tangents and energy of a whole solid at large
 * displacements (solid_green_element.h), on the pattern of its solid_assembly.
 *
 * What the rest shape gives each Gauss point is computed once. Assembly runs over slabs in
 * parallel; sums are made in an order that does not depend on the number of threads.
 */
#ifndef SOLID_GREEN_H
#define SOLID_GREEN_H

#include <stddef.h>

#include "models/mechanics/large_motion.h"
#include "models/solid/solid_assembly.h"
#include "models/solid/solid_green_element.h"

struct solid_green {
    const struct solid_assembly *assembly; /* pattern, places, material      borrowed  */
    /* of a space with a layer, g, n and dV are solid_layer_rest's q, t and dV         */
    double *g;    /* [elements][gauss][3][row]                               owned     */
    double *dV;   /* [elements][gauss]                                       owned     */
    int *points;  /* [elements][2] of the stiffness; of a layer              owned     */
    double *n;    /* [elements][gauss][3] or NULL                            owned     */
    double *mode; /* [elements][gauss][modes][3] or NULL                     owned     */
    double *A;    /* [elements][INTERNAL][INTERNAL] or NULL                  owned     */
    int threads;
    struct solid_green_element *work; /* [threads]                           owned     */
};

/* `assembly` stays where it is until solid_green_clear. STATUS_INVERTED if the rest shape
 * is folded. */
enum status solid_green_init(struct solid_green *s, const struct solid_assembly *assembly);
void solid_green_clear(struct solid_green *s);

/* Numbers in an array of strains. */
size_t solid_green_strains(const struct solid_green *s);

/* The parts of a large_body (large_motion.h), on coefficients x[nodes][3]; the lag is for
 * all strains. STATUS_NAN, or STATUS_INVERTED where det F <= 0; results are then of no use.
 */
enum status solid_green_strain(const struct solid_green *s, const double *x,
                               double *strain);
enum status solid_green_energy(const struct solid_green *s, const double *x,
                               double *energy);
enum status solid_green_force(const struct solid_green *s, const struct large_path *path,
                              const double *x, double *force);

enum status solid_green_tangent(const struct solid_green *s, const struct large_path *path,
                                const double *x, struct large_foresight foresight,
                                double (*K)[9]);

#endif
