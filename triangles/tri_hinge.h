/* tri_hinge.h - the angle between two triangles that share an edge: 0 if they are flat.
 *
 * The edge goes from x[0] to x[1]; x[2] and x[3] lie on its two sides. Discrete hinges
 * (Grinspun, Hirani, Desbrun, Schroeder 2003, "Discrete shells") have energies in squares
 * of it.
 */
#ifndef TRI_HINGE_H
#define TRI_HINGE_H

/* Returns the angle in (-pi, pi); NaN for triangles without area. */
double tri_hinge_angle(const double x[4][3]);

/* Compute its first and second derivatives [1/m], [1/m^2]; H is symmetric. */
void tri_hinge_gradient(const double x[4][3], double gradient[12]);
void tri_hinge_hessian(const double x[4][3], double H[12][12]);

#endif
