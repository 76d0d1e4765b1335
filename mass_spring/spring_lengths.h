/* spring_lengths.h - a net of springs in lengths and of struts (spring_force.h) as a body
 * at large displacements, for Euler's implicit steps and for equilibrium. The strain is the
 * force at each point itself; the tangent is, in time, the
 * clamped Jacobian, so that every change goes down (Baraff and Witkin 1998), and in statics
 * the true one.
 */
#ifndef SPRING_LENGTHS_H
#define SPRING_LENGTHS_H

#include "mass_spring/spring_force.h"
#include "models/mechanics/large_body.h"
#include "models/net/spring_plate.h"

struct spring_lengths {
    const struct spring_net *net; /*                                          borrowed  */
    struct large_body body;
    int slab[2];
    void *room;     /* memory of the arrays                                 owned     */
    double *hinges; /* [pairs] spring_force_hinges                                    */
    double *strain; /* [nodes][3] the force, less its sign                  [N]       */
    struct spring_forms forms; /* bending of a mesh that is no grid          owned     */
    double *plate;             /* [pairs] their second derivatives           [N/m]     */
    const double *x; /* [nodes][3] where the strain is of                    borrowed  */
};

/* Prepares; the net and *s must stay where they are. STATUS_MEMORY. */
enum status spring_lengths_init(struct spring_lengths *s, const struct scene *scene,
                                const struct spring_net *net);
void spring_lengths_clear(struct spring_lengths *s);

#endif
