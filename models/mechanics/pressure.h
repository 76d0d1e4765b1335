/* pressure.h - a scene's pressure: p on the face w = 1 against the normal n, which it
 * follows as the sheet turns.
 *
 * The force on coefficients x_a with functions N_a is -p int N_a (x_u x x_v) du dv, exact
 * at quadrature points that integrate products of three functions. Its potential, of a
 * sheet that is closed along v, is p times the enclosed volume, int (x - (x e) e) n dA / 2
 * with the axis e: exact where the edges u = 0 and 1 stay in planes across the axis; beside
 * a free edge that leaves its plane it does work that no potential has. A ring of width w
 * has p w times the area inside. The tangent is the symmetric part,
 *
 *   K_ab = p/2 int [c]x,  c = (N_a N_b,v - N_b N_a,v) x_u - (N_a N_b,u - N_b N_a,u) x_v;
 *
 * the other part is an integral along both edges, which has no work on motions of them
 * that are held or stay in such planes. Where it has, Newton's method takes more iterations
 * to the same end.
 */
#ifndef PRESSURE_H
#define PRESSURE_H

#include "models/linalg/blocks.h"
#include "models/scene.h"

enum { PRESSURE_MOST = 64 }; /* points an element                                      */

struct pressure {
    double value;   /* pushes against the normal; 0: there is none            [Pa]     */
    double axis[3]; /* e                                                                */
    int elements, points, local; /* points an element, functions alive there            */
    const int *node;             /* [elements][local] ascending               borrowed  */
    double *shape; /* [elements][points][3][local] N times the weight, N_u, N_v   owned */
};

/* Makes room for the functions, which the caller fills in; nothing for a scene without
 * pressure. STATUS_MEMORY. */
enum status pressure_init(struct pressure *p, const struct scene *scene, int elements,
                          int points, int local, const int *node);
void pressure_clear(struct pressure *p);

/* Adds `factor` times the force at (1 - share) x_old + share x to f[nodes][3]; x_old may be
 * NULL if share is 1. */
void pressure_force(const struct pressure *p, double factor, const double *x_old,
                    double share, const double *x, double *f);

/* Adds to K[pairs] what `factor` times that force takes from it, by x. */
void pressure_tangent(const struct pressure *p, double factor, const double *x_old,
                      double share, const double *x, const struct blocks *graph,
                      double (*K)[9]);

/* Returns its potential at x[nodes][3], less that at rest [J]. */
double pressure_energy(const struct pressure *p, const double *rest, const double *x);

#endif
