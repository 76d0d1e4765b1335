/* solid_assembly.h - global stiffness, mass and volumes of a solid_space on a geometry.
 *
 * The pattern and every element's places in it are found once. Assembly runs over slabs in
 * parallel; sums are made in an order that does not depend on the number of threads.
 */
#ifndef SOLID_ASSEMBLY_H
#define SOLID_ASSEMBLY_H

#include "models/linalg/blocks.h"
#include "models/solid/solid_batch.h"
#include "models/solid/solid_element.h"

struct solid_assembly {
    const struct solid_space *space; /* borrowed                                       */
    struct solid_material material;
    struct blocks graph;
    void *room;     /* memory of the arrays but place                         owned   */
    double (*K)[9]; /* [pairs] stiffness blocks                  [N/m]                */
    double *M;      /* [pairs] mass                              [kg]                 */
    double *volume; /* [nodes] int N_a dV                        [m^3]                */

    int run;    /* element nodes come in runs of this many consecutive numbers    */
    int *place; /* [elements][local][local / run] blocks_places            owned   */
    int threads;
    struct solid_element *work; /* [threads]                                           */
    struct solid_batch **batch; /* [threads] NULL: element by element                  */
};

/* Prepares the assembly, with as many threads as OpenMP would give at this moment. */
enum status solid_assembly_init(struct solid_assembly *s, const struct solid_space *space,
                                const struct solid_material *material);
void solid_assembly_clear(struct solid_assembly *s);

/* Computes K, M and volume on the coefficients x[nodes][3]. On STATUS_INVERTED or
 * STATUS_NAN the matrices are unusable. */
enum status solid_assembly_compute(struct solid_assembly *s, const double *x);

/* Adds the tangent of an element, on the geometry of a thread's room e, to K: stress_share
 * times the material part, geometry_share times that of the stress of e->strain; 0: the
 * stiffness at rest. */
void solid_assembly_add(const struct solid_assembly *s, struct solid_green_element *e,
                        const struct solid_green_rest *rest, int element,
                        double stress_share, double geometry_share, double (*K)[9]);

#endif
