/* solid_green_room.h - working storage of a solid element at large displacements
 * (solid_green_element.h). */
#ifndef SOLID_GREEN_ROOM_H
#define SOLID_GREEN_ROOM_H

#include "models/solid/solid_layer.h"

/* Strains at a Gauss point: xx, yy, zz, xy, yz, zx, shear not doubled. */
enum { SOLID_GREEN_STRAINS = 6, SOLID_GREEN_INTERNAL = 9 };

/* Rest data of an element; rows padded as in solid_space.h. */
struct solid_green_rest {
    int points;         /* of the stiffness                                             */
    bool plane_stress;  /* solid_element.h                                              */
    const double *n;    /* [gauss][3] unit normals; plane_stress only                   */
    const double *g;    /* [gauss][3][row] gradients                              [1/m] */
    const double *mode; /* [gauss][modes][3] of the internal modes                [1/m] */
    const double *dV;   /* [gauss]                                                [m^3] */
    const double
        *A; /* [INTERNAL][INTERNAL] Cholesky factor of the modes' stiffness [N/m] */
    struct solid_layer_rest layer; /* of a space with a layer, instead of all this     */
};

/* Working storage for one element; one per thread. */
struct solid_green_element {
    int local, row, gauss, modes;
    bool plane;   /* space->plane_stress                                                  */
    double *U[3]; /* [row][4]: displacement, present and of the geometry, for which first
                     stands what is beside the change; last change; fourth zero   [m]   */
    double *strain; /* [gauss][6]; solid_layer_strains                                  */
    double *f;      /* [row][4]                                                   [N]   */
    double *p, *wp; /* [gauss][3][row] F g and dV F g                                   */
    double *y, *wy; /* [2 gauss][3][row] F P g, F n (n.g); weighted; plane_stress only  */
    double *L;      /* [row][9][row] as in solid_element.h                              */
    double *Sg;     /* [3][row] at one point                                            */
    double *H;      /* [row][9][row] int p_ai p_bj; valid for b >= a                    */
    double *C;      /* [row][6][row] xx, yy, zz, xy, yz, zx of what is symmetric        */
    double *Y; /* [3 modes][3 row] coupling of the modes, L^-1 applied                  */
    struct solid_layer *layer; /* room; NULL: no layer                                  */
    void *memory;
};

#endif
