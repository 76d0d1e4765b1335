/* shell_assembly.h - mass, strains, internal forces and tangents of a whole shell.
 *
 * The pattern and every element's places in it are found once, the mass and what the rest
 * shape gives each Gauss point too. Assembly runs over slabs in parallel; sums are made in
 * an order that does not depend on the number of threads.
 */
#ifndef SHELL_ASSEMBLY_H
#define SHELL_ASSEMBLY_H

#include "models/linalg/blocks.h"
#include "models/mechanics/large_body.h"
#include "models/scene.h"
#include "shell_ref/shell_element.h"

struct shell_assembly {
    const struct shell_space *space; /* borrowed                                       */
    int sheets; /* whose elements stand one after the other                             */
    struct shell_material material[SCENE_MAX_SHEETS];
    struct blocks graph;
    struct large_body body; /* the lag is for the membrane strains                     */
    void *room;   /* of the arrays but place                               owned   */
    double *M;    /* [pairs] consistent mass rho h                [kg]                 */
    double *area; /* [nodes] int N_a dA at rest                   [m^2]                */
    double *rest[SHELL_PARTS]; /* [elements][SHELL_REST_ROWS][padded]                  */
    int *place; /* [elements][local][order u] pair of (node, first of run)   owned   */
    int threads;
    struct shell_element *work; /* [threads]                                           */
};

/* Prepares a shell of so many sheets, with equally many elements each, of material[sheets];
 * *s must stay where it is. Threads: as many as OpenMP would give at this moment.
 * STATUS_INPUT with a sentence if the rest shape has no normal somewhere. */
enum status shell_assembly_init(struct shell_assembly *s, const struct shell_space *space,
                                int sheets, const struct shell_material *material,
                                struct message *why);
void shell_assembly_clear(struct shell_assembly *s);

#endif
