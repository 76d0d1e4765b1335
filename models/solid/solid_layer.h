/* solid_layer.h - one layer of linear functions through the thickness taken as a plate:
 * nine strains of its mid-surface w = 1/2, each kind (solid_space.h) by its own quadrature
 * (remedy=selective).
 *
 * With F the gradient of the deformation from the geometry given, F' its derivative by w,
 * t_1, t_2, t_3 the geometry's tangents and normal, orthonormal, c_k = F t_k, e_k = F' t_k:
 *   stretches  c_k.c_l/2 - t_k.t_l/2 of membrane (11, 22, 2 12), transverse shear (2 13,
 *              2 23) and thickness (33),
 *   bends      (c_k.e_l + c_l.e_k)/2 (11, 22, 2 12),
 * both quadratic in displacements, and in small strain their linear parts. Energy
 *   int N.stretch dV + int M.bend dV / 12, halved: plane stress along the sheet, 5/6 mu in
 * shear (Reissner 1945), Young's modulus across. Whatever must vanish in a thin sheet has
 * one point a function, or it locks; stretches 11 and 22 have points of their own
 * (plate_model_select), as have those across the sheet. The plane-stress law, E / (1 -
 * nu^2) (e_11^2 + e_22^2 + 2 nu e_11 e_22), is therefore parted into E / (1 + |nu|) of each
 * at its own points and E |nu| / (1
 * - nu^2) (e_11 +- e_22)^2, the sign nu's, at those of 12: no part is negative.
 */
#ifndef SOLID_LAYER_H
#define SOLID_LAYER_H

#include "models/solid/solid_material.h"
#include "models/solid/solid_space.h"

enum {
    SOLID_LAYER_STRAINS = 3, /* most strains of a point                                */
    SOLID_LAYER_VECTORS = 4, /* a point's: t_1, t_2, t_3, unused; or t_1, t_2, 0, 0    */
};

/* Data of an element in a geometry, its points kind by kind. Vectors are rows q of t: of
 * the displacement u_a, d_k = sum u_a q_k[a]: those of F t_1, F t_2, F t_3; or of F t_1, F
 * t_2, F' t_1, F' t_2. */
struct solid_layer_rest {
    int points[SOLID_KINDS];
    const double *q;  /* [points][VECTORS][row]                                   [1/m] */
    const double *t;  /* [points][VECTORS][3]                                           */
    const double *dV; /* [points]; of bending, a twelfth                         [m^3] */
};

/* Working storage of one thread; rows padded as in solid_space.h. */
struct solid_layer {
    int local, row;
    int points[SOLID_KINDS]; /* points of the element placed                        */
    double *G, *weight;      /* [points][6][row], [points] solid_space.h                 */
    double *normal;          /* [row] gradients along the normal                         */
    double *q, *t, *dV;      /* solid_layer_rest of the element placed                   */
    double *b, *wb;          /* [strains][3][row] variations of strains; their stress dV */
    void *memory;
};

/* Creates; *layer is owned by the caller, also on failure. */
enum status solid_layer_create(const struct solid_space *space, struct solid_layer **layer);
void solid_layer_destroy(struct solid_layer *s); /* NULL is allowed */

/* Return an element's number of points, and of strains, those of a point in sequence. */
int solid_layer_points(const int points[SOLID_KINDS]);
int solid_layer_strains(const int points[SOLID_KINDS]);

/* Returns the kind of an element's point n. */
enum solid_strains solid_layer_kind(const int points[SOLID_KINDS], int n);

/* Fills points, q, t and dV of an element on the coefficients X[local][4]. STATUS_INVERTED
 * if det J <= 0 at a point, STATUS_NAN if it is not a number. */
enum status solid_layer_place(struct solid_layer *s, const struct solid_space *space,
                              int element, const double *X);
struct solid_layer_rest solid_layer_placed(const struct solid_layer *s);

/* Computes the stress times dV of the strains at a point. */
void solid_layer_stress(const struct solid_material *m, enum solid_strains kind, double dV,
                        const double *strain, double *stress);

/* Strain r is the sum of factor (t_k.d_l + t_l.d_k + d_k.d_l) over its terms. */
struct solid_layer_term {
    int strain, k, l;
    double factor;
};
struct solid_layer_form {
    int strains, terms;
    struct solid_layer_term term[4];
};
extern const struct solid_layer_form solid_layer_form[SOLID_KINDS];

/* Computes variations of the strains of point n with vectors c[4][3], and their stress dV,
 * in the rows of s->b, s->wb that follow strain `first`. Returns the strains written. */
int solid_layer_vary(struct solid_layer *s, const struct solid_layer_rest *rest, int n,
                     double c[SOLID_LAYER_VECTORS][3], const struct solid_material *m,
                     int first);

#endif
