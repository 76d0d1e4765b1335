/* shell_assembly.h - mass, strains, internal forces and tangents of a whole shell.
 *
 * The pattern and every element's places in it are found once, the mass and what the rest
 * shape gives each Gauss point too. Assembly runs over slabs in parallel; sums are made in
 * an order that does not depend on the number of threads.
 */
#ifndef SHELL_ASSEMBLY_H
#define SHELL_ASSEMBLY_H

#include <stddef.h>

#include "models/mechanics/large_motion.h"
#include "shell_ref/shell_element.h"

struct shell_assembly {
    const struct shell_space *space; /* borrowed                                       */
    struct shell_material material;
    struct blocks graph;
    double *M;    /* [pairs] consistent mass rho h                [kg]         owned   */
    double *area; /* [nodes] int N_a dA at rest                   [m^2]        owned   */
    double *rest; /* [elements][SHELL_REST_ROWS][padded]                       owned   */
    int *place;   /* [elements][local][order u] pair of (node, first of run)   owned   */
    int threads;
    struct shell_element *work; /* [threads]                                   owned   */
};

/* Threads: as many as OpenMP would give at this moment. STATUS_INPUT with a sentence if the
 * rest shape has no normal somewhere. */
enum status shell_assembly_init(struct shell_assembly *s, const struct shell_space *space,
                                const struct shell_material *material, struct message *why);
void shell_assembly_clear(struct shell_assembly *s);

/* Numbers in an array of strains, [elements][SHELL_STRAINS][padded]. */
size_t shell_assembly_strains(const struct shell_assembly *s);

/* The parts of a large_body; the lag is for the membrane strains. STATUS_NAN, or
 * STATUS_INVERTED where the surface has no normal; results are then of no use. */
enum status shell_assembly_strain(const struct shell_assembly *s, const double *x,
                                  double *strain);
enum status shell_assembly_energy(const struct shell_assembly *s, const double *x,
                                  double *energy);
enum status shell_assembly_force(const struct shell_assembly *s,
                                 const struct large_path *path, const double *x,
                                 double *force);

/* K[pairs], symmetric: exact in statics without foresight; in time, where the derivative of
 * the force is not symmetric, with the geometry's strain variations on both sides. */
enum status shell_assembly_tangent(const struct shell_assembly *s,
                                   const struct large_path *path, const double *x,
                                   struct large_foresight foresight, double (*K)[9]);

#endif
