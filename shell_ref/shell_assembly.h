/* shell_assembly.h - mass, strains, internal forces and tangents of a whole shell.
 *
 * The pattern and every element's places in it are found once, the mass and what the rest
 * shape gives each Gauss point too. Assembly runs over slabs in parallel; sums are made in an
 * order that does not depend on the number of threads.
 */
#ifndef SHELL_ASSEMBLY_H
#define SHELL_ASSEMBLY_H

#include <stddef.h>

#include "models/linalg/blocks.h"
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

/* Where stress and geometry of an equation come from (struct shell_rule). */
struct shell_path {
    struct shell_rule rule;
    const double *x_old;      /* [nodes][3]; NULL if g1 == 1                  borrowed */
    const double *strain_old; /* as above; NULL if s0 == 0                    borrowed */
};

/* All on control points x[nodes][3]. STATUS_NAN, or STATUS_INVERTED where the surface has no
 * normal; results are then of no use. */
enum status shell_assembly_strain(const struct shell_assembly *s, const double *x,
                                  double *strain);
enum status shell_assembly_energy(const struct shell_assembly *s, const double *x,
                                  double *energy);
enum status shell_assembly_force(const struct shell_assembly *s, const struct shell_path *path,
                                 const double *x, double *force);

/* Which stress the geometric part of a tangent takes; both NULL: that of x. A thin shell whose
 * step has turned it has spurious membrane stress to second order in the step, enormous beside
 * the true one; Newton's method then takes an order of magnitude more iterations. */
struct shell_foresight {
    const double *strain; /* these strains, such as those at the step's start          */
    const double *change; /* [nodes][3] the change that led to x: the strains that its
                             linearisation foresaw (shell_element_foresee)             */
    bool none;            /* no stress at all: a tangent that is never indefinite      */
};

/* K[pairs], symmetric: exact in statics without foresight; in time, where the derivative of
 * the force is not symmetric, with the geometry's strain variations on both sides. */
enum status shell_assembly_tangent(const struct shell_assembly *s,
                                   const struct shell_path *path, const double *x,
                                   struct shell_foresight foresight, double (*K)[9]);

#endif
