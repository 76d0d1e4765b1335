/* solid_element.h - matrices of one isotropic linear-elastic element on a given geometry.
 *
 *   K_ai,bj = int lambda N_a,i N_b,j + mu N_a,j N_b,i + mu delta_ij N_a,k N_b,k dV
 *   M_ab    = int rho N_a N_b dV,        volume_a = int N_a dV
 * (Hughes 2000, sec. 2.7-2.9), by the space's Gauss rule.
 * A space with a `layer` has the stiffness of solid_layer.h instead.
 *
 * Gradients are with respect to the geometry given, which is the rest shape or, in the
 * kinematics that rebuild, the present one.
 */
#ifndef SOLID_ELEMENT_H
#define SOLID_ELEMENT_H

#include "models/solid/solid_green_element.h"

struct solid_material solid_element_material(const struct law *law, double density);

/* Working storage and results of one thread; rows of functions padded to `row`. */
struct solid_element {
    int local, row, gauss, modes;
    struct solid_functions shape;
    double *X;      /* [local][4]          geometry, gathered; fourth zero       [m]   */
    double *centre; /* [3][row]            the space's centre_gradient; with modes     */
    double *g;      /* [gauss][3][row]     physical gradients                    [1/m] */
    double *mode;   /* [gauss][modes][3]   the same of internal modes            [1/m] */
    double *dV;     /* [gauss]             weight det J                          [m^3] */
    double *A;      /* [INTERNAL][INTERNAL] of solid_green_rest                  [N/m] */
    double *wN;     /* [gauss][row]        values times density dV                     */
    double *M;      /* [local][row]        valid for b >= a                      [kg]  */
    double *volume; /* [row]                                                     [m^3] */
    struct solid_green_rest rest; /* of the element computed; points to the above      */
    struct solid_green_element green; /* room for its stiffness                        */
    void *memory;
};

enum status solid_element_init(struct solid_element *e, const struct solid_space *space);
void solid_element_clear(struct solid_element *e);

/* Computes M, volume and rest of one element on the coefficients x[nodes][3] [m]; K is the
 * tangent there of no displacement (solid_green_element.h).
 * STATUS_INVERTED if det J <= 0 at a Gauss point, STATUS_NAN if it is not a number. */
enum status solid_element_compute(struct solid_element *e, const struct solid_space *space,
                                  int element, const struct solid_material *material,
                                  const double *x);

#endif
