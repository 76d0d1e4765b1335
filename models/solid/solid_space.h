/* solid_space.h - a discretized solid as the assembly sees it: elements, their nodes and
 * their basis functions at Gauss points. Filled by iga/ (B-splines) and fem_ref/
 * (hexahedra); what is below it - element matrices, assembly, stepping - is the same code
 * for both.
 *
 * "Node" means a coefficient of a basis function. With the Legendre basis through the
 * thickness (UNKNOWNS_THICKNESS) coefficient 0 of a column is its mid-surface position,
 * coefficient 1 half its thickness vector, and so on.
 */
#ifndef SOLID_SPACE_H
#define SOLID_SPACE_H

#include <stdbool.h>

#include "models/scene.h"

/* Vectors of 4 doubles: rows of basis functions are padded to a multiple of it with zeros,
 * so that the kernels have no remainders. */
enum { SOLID_LANES = 4 };
#define SOLID_PADDED(columns) (((columns) + SOLID_LANES - 1) / SOLID_LANES * SOLID_LANES)

/* Strains of one layer that share quadrature points (solid_layer.h): stretch along u, along
 * v; shear along the sheet, with what Poisson's ratio couples of these; shear and stretch
 * across it; bending. */
enum solid_strains {
    SOLID_ALONG_U,
    SOLID_ALONG_V,
    SOLID_PLANE,
    SOLID_ACROSS,
    SOLID_BENDING,
    SOLID_KINDS
};

/* Basis functions of one element; rows padded as above, each aligned to its lanes. */
struct solid_functions {
    double *N;      /* [gauss][padded]    values                                       */
    double *G;      /* [gauss][3][padded] parametric gradients                         */
    double *weight; /* [gauss]            parametric quadrature weights                */
};

/* The functions of one element along one direction, at their points; borrowed. */
struct solid_line {
    int points, order;
    const double *value;  /* [points][2][order] values and slopes                      */
    const double *weight; /* [points]                                                  */
};

/* Columns of nodes whose mid-surface a support holds: solid_hinge.h. */
struct solid_hinge {
    int layers, at; /* nodes of a column; which of them stands for the mid-surface  */
    void *room;     /* memory of the arrays                                 owned   */
    unsigned char *column; /* [nodes / layers] it is such a one; NULL: none is */
    double *middle; /* [layers] values of the functions through it at w = 1/2       */
};

struct solid_space {
    int nodes, elements;
    int local;  /* functions per element                                                */
    int gauss;  /* Gauss points per element                                             */
    void *room; /* memory of ien, uvw and rest                                 owned   */
    int *ien;   /* [elements][local] ascending nodes of each element                    */

    /* Elements [slab[s], slab[s+1]) form slab s; slabs s and s+2 share no node, so that
     * all even slabs, then all odd ones, may be assembled side by side with sums in an
     * order that no thread count changes. */
    int slabs;
    int *slab; /* [slabs + 1]                                                  owned   */

    double (*uvw)[3]; /* [nodes] parameters of each node (Greville abscissae): decides
                         which supports hold it; in the thickness basis w is one of
                         supports.h's SUPPORTS_MIDDLE, SUPPORTS_DIFFERENCE             */
    double *rest;     /* [nodes][3] rest coefficients                  [m]             */

    /* The parity, 0/1 per component, of a flat sheet with the thickness basis: linear
     * stiffness and mass couple only equal ones (membrane and bending motion). NULL where
     * it is unknown. */
    unsigned char *parity; /* [nodes][3]                                       owned   */
    bool thickness_basis;  /* coefficients are Legendre through the thickness          */

    /* Fills out->N, G, weight (room given by the caller; padding already zero). Pure:
     * any thread. */
    void (*functions)(const struct solid_space *space, int element,
                      struct solid_functions *out);
    void *tables; /* data of the owner of `functions`                                  */

    /* The lines along u, v, w (i = 0, 1, 2) whose products the functions, points and
     * weights are, w fastest, then v, as many in all elements; NULL: they are none. */
    struct solid_line (*line)(const struct solid_space *space, int element, int i);

    /* Remedy for locking of one layer of linear functions: its stiffness is that of
     * solid_layer.h (NULL: not). Fills parametric gradients on the mid-surface and their
     * derivatives by w, [points][6][padded], and weights of the points of a kind of strain;
     * returns their number, at most layer_points[kind]. */
    int (*layer)(const struct solid_space *space, int element, enum solid_strains kind,
                 double *G, double *weight);
    int layer_points[SOLID_KINDS];

    /* Element-internal displacement modes without mass, condensed out of the stiffness
     * (Wilson et al. 1973; Taylor, Beresford, Wilson 1976): parametric gradients
     * [gauss][3][modes], the same for all elements; pushed forward with the Jacobian at
     * the element's centre, given by the functions' gradients [3][padded] there. */
    int modes;
    const double *mode_gradient;
    const double *centre_gradient;

    struct solid_hinge hinge; /* hidden from the layers above                             */
};

/* Frees what is marked owned, not `tables`. Accepts all-zero, leaves all-zero. */
void solid_space_clear(struct solid_space *space);

/* Allocates ien, uvw and rest of the elements and nodes that *space says; makes slabs for
 * elements numbered in columns of `per_column`, of which `width` + 1 neighbouring ones
 * share nodes. */
enum status solid_space_allocate(struct solid_space *space, int per_column, int width);

/* Turns the nodes' parameters s along their sheets, which have as many nodes each, one
 * after the other, into the scene's u. */
void solid_space_spread(struct solid_space *space, const struct scene *scene);

#endif
