/* shell_tangent.h - the tangent of one shell element (formulas: shell_element.h). */
#ifndef SHELL_TANGENT_H
#define SHELL_TANGENT_H

#include "models/mechanics/large_body.h"
#include "shell_ref/shell_room.h"

/* Return the kernel's rows over an element's functions at all points, left and right. */
size_t shell_tangent_left(const struct shell_space *space);
size_t shell_tangent_right(const struct shell_space *space);

/* Computes e->K on the geometry e->X[1], by the path's shares: s1 times the material part
 * (the membrane's s1 + lag) plus g1 times the geometric part with the stress of e->strain.
 * In steps by mean forces (g1 < 1) bending moments have no geometric part: beside the rest
 * of bending it is as the angle that a span turns by to 1, and bending itself is little
 * beside inertia. Newton's method takes the same tangents and iterations without it
 * (edge_drop, cloak, h/L 1e-3 to 1e-2), a tangent of degree 3 for .74 of the time. */
void shell_tangent_compute(struct shell_element *e, const struct shell_material *material,
                           const double *const rest[], const struct large_path *path);

#endif
