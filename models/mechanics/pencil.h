/* pencil.h - results from a stiffness K and a mass M of a vector field on a node graph:
 * natural frequencies, and the matrices themselves. */
#ifndef PENCIL_H
#define PENCIL_H

#include "models/linalg/blocks.h"
#include "models/supports.h"
#include "models/model.h"

struct pencil {
    const struct blocks *graph;
    const double (*K)[9]; /* [pairs] (blocks.h)                                        */
    const double *M;      /* [pairs]                                                   */
    bool stressed;        /* K may be indefinite; else negative eigenvalues are round-off */
};                        /* all borrowed */

/* Finds the `count` lowest angular frequencies [rad/s], ascending, of the free unknowns;
 * parity as in system.h. -s for a mode that grows as exp(s t), if stressed. STATUS_INPUT:
 * there are not so many; the codes of eigen_lowest. */
enum status pencil_modes(const struct pencil *p, const struct supports *held,
                         const unsigned char *parity, int count, double *omega,
                         struct message *why);

/* Copies all of K and M, lower triangle (model.h), held unknowns included. */
enum status pencil_matrices(const struct pencil *p, struct matrix *K, struct matrix *M);

#endif
