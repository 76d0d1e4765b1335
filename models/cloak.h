/* cloak.h - the curved rest shape `cloak`: part of a cone (of a cylinder without flare) as
 * wide as an opening angle around its axis, hung or held by its upper edge.
 *
 * With W the length of the mid-surface's upper edge, alpha the opening, beta the flare
 * (generators against axis) and e_w = e_u x e_v:
 *   X(u,v,w) = origin + z e_u + r (sin phi e_v + cos phi e_w),
 *   r   = W / alpha + u L sin beta + (w - 1/2) h cos beta,
 *   z   =             u L cos beta - (w - 1/2) h sin beta,
 *   phi = 2 atan((2 v - 1) tan(alpha / 4)).
 * So e_u is the axis, `origin` the upper edge's centre, u runs from that edge to the hem
 * along straight generators, v around, w outwards along the normal: parallel surfaces of a
 * cone are cones. phi(v) is the parametrisation of the arc as one rational quadratic (Piegl
 * & Tiller 1997, sec. 7.3), which every NURBS of degree 2 or more in v contains exactly;
 * d phi / d v is 1 / cos(alpha/4)^2 times smaller at the ends than in the middle.
 */
#ifndef CLOAK_H
#define CLOAK_H

struct scene;

/* Largest opening [deg]; d phi / d v then varies 7-fold. */
#define CLOAK_MAX_OPENING 270

/* tan(alpha / 4). */
double cloak_quarter_tangent(const struct scene *scene);

/* Radius r and height z at u, w [m]. */
void cloak_meridian(const struct scene *scene, double u, double w, double *r, double *z);

/* The point at height z and r times the vector (along e_v, along e_w) from the axis [m]. */
void cloak_place(const struct scene *scene, double z, double along_v, double along_w,
                 double xyz[3]);

/* X(u,v,w) [m]. */
void cloak_point(const struct scene *scene, const double uvw[3], double xyz[3]);

#endif
