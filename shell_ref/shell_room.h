/* shell_room.h - what a shell element works with (shell_element.h). */
#ifndef SHELL_ROOM_H
#define SHELL_ROOM_H

#include "shell_ref/shell_space.h"

/* Strains or resultants at Gauss points, rows of the padded points. */
enum { SHELL_STRAINS = 6 };

/* What the rest shape gives each Gauss point: area, metric, curvature, and C without h,
 * entries (0,0) (0,1) (0,2) (1,1) (1,2) (2,2). */
enum { REST_AREA, REST_METRIC, REST_CURVATURE = 4, REST_LAW = 7, SHELL_REST_ROWS = 13 };

struct shell_material {
    double young, poisson, density, thickness;
};

/* Room for one element; one per thread. */
struct shell_element {
    int local, row, padded, gauss; /* functions, padded; Gauss points padded, and not  */
    void *memory;                  /*                                          owned   */
    double *T;                     /* [SHELL_DERIVATIVES][local][padded]               */
    double *X[3];                  /* [local][3]: present, geometry, last change       */
    double *strain;                /* [SHELL_STRAINS][padded]                          */
    double *f;                     /* [local][3]                                       */
    double *left, *right;          /* [gauss][rows][row], see the kernel               */
    double *K;                     /* [local][9][row], columns b >= a filled           */
};

#endif
