/* shell_room.h - working storage of a shell element (shell_element.h). */
#ifndef SHELL_ROOM_H
#define SHELL_ROOM_H

#include "models/law/law.h"
#include "shell_ref/shell_space.h"

/* Rest data of each point of the membrane and of bending: area, metric (or curvature), and
 * C without h, entries (0,0) (0,1) (0,2) (1,1) (1,2) (2,2); of the mass: its area alone. */
enum { REST_AREA, REST_FORM, REST_LAW = 4, SHELL_REST_ROWS = 10 };

struct shell_material {
    struct law law;
    double density;
    double along[2][3]; /* law.along of covariant strains, for flat sheets that soften */
};

/* An element's points of one rule. */
struct shell_points {
    int count, padded; /* points, and rows of them                                     */
    const double *T;   /* [SHELL_DERIVATIVES or SHELL_SLOPES][local][padded]           */
    double *room;      /* room to make them in                                         */
    double *strain;    /* [3][padded]; the mass has none                               */
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

#endif
