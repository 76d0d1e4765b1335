/* solid_green_element.h - strains, forces and tangent of one solid element at large
 * displacements: total Lagrangian, Green strain, St. Venant-Kirchhoff law.
 *
 * Displacement functions have rest gradients g_a. With D = sum u_a g_a^T, F = I + D:
 *   E = (D + D^T + D^T D)/2,   S = lambda tr(E) I + 2 mu E,
 * f_a = int F S g_a dV, K_ab = int lambda p_a p_b^T + mu p_b p_a^T + mu (g_a.g_b) F F^T +
 * (g_a.S g_b) I dV, p_a = F g_a (Holzapfel 2000, sec. 8.4, with the isotropic law written
 * out).
 *
 * Internal modes (solid_space.h) are strains sym(alpha_m g_m^T) added to E: with this law
 * alpha is a linear function of E, so that nothing has to be iterated or remembered
 * (Klinkel, Wagner 1997); at small displacements it is the incompatible element.
 *
 * solid_green_layer.h does all of this but the room in a space with a layer
 * (solid_layer.h). Its tables of strains could have these, too, six at a point, but a pair
 * of functions then takes 54 products a point in place of 21: the isotropic law needs the
 * nine of p_a p_b alone, and twelve for what is symmetric.
 */
#ifndef SOLID_GREEN_ELEMENT_H
#define SOLID_GREEN_ELEMENT_H

#include "models/solid/solid_layer.h"

/* Strains at a Gauss point: xx, yy, zz, xy, yz, zx, shear not doubled. */
enum { SOLID_GREEN_STRAINS = 6, SOLID_GREEN_INTERNAL = 9 };

/* Rest data of an element; rows padded as in solid_space.h. */
struct solid_green_rest {
    const double *g;    /* [gauss][3][row] gradients                              [1/m] */
    const double *mode; /* [gauss][modes][3] of the internal modes                [1/m] */
    const double *dV;   /* [gauss]                                                [m^3] */
    const double
        *A; /* [INTERNAL][INTERNAL] Cholesky factor of the modes' stiffness [N/m] */
    struct solid_layer_rest layer; /* layer of a space that has one, instead of all this */
};

/* Working storage for one element; one per thread. */
struct solid_green_element {
    int local, row, gauss, modes;
    double *U[3];   /* [row][4]: displacement, present and of the geometry, for which first
                       stands what is beside the change; last change; fourth zero   [m]   */
    double *strain; /* [gauss][6]; solid_layer_strains                                  */
    double *f;      /* [row][4]                                                   [N]   */
    double *p, *wp; /* [gauss][3][row] F g and dV F g                                   */
    double *Sg;     /* [3][row] at one point                                            */
    double *H;      /* [row][9][row] int p_ai p_bj; valid for b >= a                    */
    double *C;      /* [row][6][row] xx, yy, zz, xy, yz, zx of what is symmetric        */
    double *Y; /* [3 modes][3 row] coupling of the modes, L^-1 applied                  */
    struct solid_layer *layer; /* room; NULL: no layer                                  */
    void *memory;
};

enum status solid_green_element_init(struct solid_green_element *e,
                                     const struct solid_space *space);
void solid_green_element_clear(struct solid_green_element *e);

/* Computes the factored stiffness of the internal modes, A. For set-up. */
enum status solid_green_element_modes(const struct solid_green_element *e,
                                      const struct solid_material *material,
                                      const struct solid_green_rest *rest, double *A);

/* Computes e->strain of the displacement e->U[0]: zero, to the bit, at rest. False if it is
 * not finite or det F <= 0 somewhere. With `change`, less the product of e->U[1] and
 * e->U[2], `beside` and `change` of large_foresight: the strain as a linearisation foresaw
 * it (Magisano, Leonetti, Garcea, CMAME 313, 2017). Modes included. */
bool solid_green_element_strain(struct solid_green_element *e,
                                const struct solid_material *material,
                                const struct solid_green_rest *rest, bool change);

/* Returns the elastic energy of e->strain [J]. */
double solid_green_element_energy(const struct solid_green_element *e,
                                  const struct solid_material *material,
                                  const struct solid_green_rest *rest);

/* Computes e->f of the stress of e->strain on the geometry e->U[1]. */
void solid_green_element_force(struct solid_green_element *e,
                               const struct solid_material *material,
                               const struct solid_green_rest *rest);

/* Computes the tangent on the geometry e->U[1]: stress_share times the material part and
 * geometry_share times the geometric part with the stress of e->strain; geometry_share 0:
 * at rest instead, whatever e->U[1] is. Kept in *e for solid_green_element_blocks. */
void solid_green_element_stiffness(struct solid_green_element *e,
                                   const struct solid_material *material,
                                   const struct solid_green_rest *rest, double stress_share,
                                   double geometry_share);

/* Adds K_ab for b = first .. last - 1, all >= a, row-major, to K[last - first][9]. */
void solid_green_element_blocks(const struct solid_green_element *e,
                                const struct solid_material *material, double stress_share,
                                int a, int first, int last, double (*K)[9]);

#endif
