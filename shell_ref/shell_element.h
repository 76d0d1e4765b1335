/* shell_element.h - strains, forces and tangent of one element of the rotation-free
 * Kirchhoff-Love shell with a St. Venant-Kirchhoff law (Kiendl, Bletzinger, Linhard,
 * Wuechner, CMAME 198, 2009), with exact first and second variations.
 *
 * Mid-surface x(u,v): a_1 = x_u, a_2 = x_v, unit normal n, a_ab = a_a . a_b,
 * b_ab = x_ab . n; capitals at rest. With c = 11, 22, 12 (shear doubled):
 *   membrane strain (a_ab - A_ab)/2,   bending strain B_ab - b_ab,
 *   resultants h C e and h^3/12 C k,   C the plane-stress law in the metric A^ab.
 * With phi_ab = N_ab - Gamma^c_ab N_c the variations are  d b_ab = phi_ab n  and
 *   d d' b_ab = -(n.da_c)(a^c.phi'_ab) - (n.da'_c)(a^c.phi_ab) - b_ab a^cd
 * (n.da_c)(n.da'_d).
 */
#ifndef SHELL_ELEMENT_H
#define SHELL_ELEMENT_H

#include "models/law/law.h"
#include "models/mechanics/large_body.h"
#include "shell_ref/shell_space.h"

/* Working storage. */

/* Rest data of each point of the membrane and of bending: area, metric (or curvature), and
 * C without h, entries (0,0) (0,1) (0,2) (1,1) (1,2) (2,2); of the mass: its area alone. Of
 * a row: a point's factor, and the stiffness of all. */
enum { REST_AREA, REST_FORM, REST_LAW = 4, SHELL_REST_ROWS = 10 };

struct shell_material {
    struct law law;
    double density;
    double along[2][3]; /* law.along of covariant strains, for flat sheets that soften */
};

/* An element's points of one rule. */
struct shell_points {
    int count, padded; /* points, and rows of them                                     */
    int plain;         /* the first of them, each with strains of its own              */
    int rows[2];       /* then rows of points that share one strain along u, along v   */
    int each[2];       /* points of such a row                                         */
    const double *factor[2]; /* [each] by which their strains make this sum            */
    const double *T; /* [SHELL_DERIVATIVES or SHELL_SLOPES][local][padded]           */
    double *room;    /* room to make them in                                         */
    double *strain;  /* [3][padded]; the mass has none                               */
    struct shell_surface *surface; /* [padded / SHELL_LANES] of the strain; likewise   */
};

/* Working storage for one element; one per thread. */
struct shell_element {
    int local, row; /* functions, and padded                                           */
    void *memory;   /*                                                         owned   */
    struct shell_points at[SHELL_RULES];
    double *X[3];         /* [local][3]: present, geometry, last change                */
    bool same;            /* the geometry is the present one                           */
    double *strain;       /* of membrane, then of bending                              */
    double *f;            /* [local][3]                                                */
    double *left, *right; /* rows of all points, see the kernel                        */
    double *K;            /* [local][9][row], columns b >= a filled                    */
};

/* Returns the numbers in e->strain of a part or, with SHELL_PARTS, of both. */
static inline size_t shell_room_strains(const struct shell_space *space, int part)
{
    const struct shell_rule *r = space->rule;

    return 3 * (size_t)(part == SHELL_PARTS ? r[0].padded + r[1].padded : r[part].padded);
}

enum status shell_element_init(struct shell_element *e, const struct shell_space *space);
void shell_element_clear(struct shell_element *e);

/* Loads the element's functions of the first so many rules; before the other calls. */
void shell_element_load(struct shell_element *e, const struct shell_space *space,
                        int element, int rules);

/* Computes rest[SHELL_REST_ROWS][padded] of a rule from the element's control points
 * e->X[0] and place[]. STATUS_INPUT if the surface has no normal there. */
enum status shell_element_rest(struct shell_element *e, int rule,
                               const struct shell_material *material,
                               const struct shell_place *place, double *rest);

/* Computes e->strain on the control points e->X[0]. rest[SHELL_PARTS], here and below: of
 * membrane and bending. False if they are not finite or the surface has no normal.
 *
 * `foreseen` subtracts half the product of the change e->X[2] and e->X[1]
 * (large_foresight's beside) in the membrane: this is the strain as the tangent foresaw it.
 * Magisano, Leonetti, Garcea 2017 base the geometric part on it: Newton's method on thin
 * shells then needs far fewer steps. */
bool shell_element_strain(struct shell_element *e, const double *const rest[],
                          bool foreseen);

/* Returns the elastic energy of e->strain [J]. */
double shell_element_energy(const struct shell_element *e,
                            const struct shell_material *material,
                            const double *const rest[]);

/* Computes e->f: forces of the stress of e->strain on the geometry e->X[1]. */
void shell_element_force(struct shell_element *e, const struct shell_material *material,
                         const double *const rest[]);

/* Computes e->K on the geometry e->X[1], by the path's shares: s1 times the material part
 * (the membrane's s1 + lag) plus g1 times the geometric part with the stress of e->strain.
 * In steps by mean forces (g1 < 1) bending moments have no geometric part: beside the rest
 * of bending it is as the angle that a span turns by to 1, and bending itself is little
 * beside inertia. Newton's method takes the same tangents and iterations without it
 * (edge_drop, cloak, h/L 1e-3 to 1e-2), a tangent of degree 3 for .74 of the time. */
void shell_element_tangent(struct shell_element *e, const struct shell_material *material,
                           const double *const rest[], const struct large_path *path);

#endif
