/* hinge_mesh.h - stiffnesses of hinges with which a mesh that is no grid bends as the sheet
 * does, on the mean over its directions and places.
 *
 * Points between bent triangles give way along the normal, which softens a net (Seung and
 * Nelson 1988 have that for equilateral triangles alone). With theta_i of an edge, the fold
 * under the curvature i = k11, k22, k12 after its points have given way, a net of
 * stiffnesses k has H_ij = sum k theta_i theta_j / area, and what can be developed bends as
 * the sheet in any direction if
 *
 *     H11 = B11, H22 = B22, 2 H12 + H33 = 2 B12 + 4 B33, H13 = 2 B13, H23 = 2 B23.
 *
 * k is the usual D |e|^2 / (A1 + A2) times factors that differ least from 1 (Kaczmarz's
 * method: a step towards each of the five in turn, along its slope), and the folds are
 * found again. Slopes of H with k are what they are with folds that stay, since what gives
 * way has the least energy. Where the five are not met to two per
 * cent all factors are 1: a mesh that is cut one way has but three kinds of edges, and no
 * stiffnesses of these meet them.
 */
#ifndef HINGE_MESH_H
#define HINGE_MESH_H

#include "models/law/law.h"
#include "models/mesh/mesh.h"

/* Computes factors[edges] on the usual stiffnesses for a bending matrix [N m] (law.h); 1
 * where a mesh is too small for it. Statuses of factor_create. */
enum status hinge_mesh_factors(const struct mesh *mesh, const double bending[LAW_ENTRIES],
                               double *factor);

#endif
