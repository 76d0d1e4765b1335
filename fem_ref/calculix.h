/* calculix.h - a sheet of hexahedra by CalculiX (ccx; Dhondt 2004, The Finite Element
 * Method for Three-Dimensional Thermomechanical Applications): matrices, linear statics,
 * a large swing. An outside code on the same nodes as ours, or with another element.
 *
 * Sheet 0 <= x <= length, 0 <= y <= width, |z| <= thickness/2, of cells[3] boxes; at rest
 * until gravity along -z acts; face x = 0 clamped (matrices: free).
 */
#ifndef CALCULIX_H
#define CALCULIX_H

#include "models/model.h"

enum calculix_element {
    CALCULIX_C3D8,   /* trilinear, 2x2x2 Gauss                                         */
    CALCULIX_C3D8I,  /* with incompatible modes: no matrices, they hold the modes too */
    CALCULIX_C3D20R, /* quadratic serendipity, 2x2x2 Gauss                             */
};

enum calculix_task {
    CALCULIX_MATRICES, /* K and M                                                      */
    CALCULIX_STATIC,   /* small strain                                                 */
    CALCULIX_SWING,    /* large displacements, Green strain, average acceleration      */
};

struct calculix_job {
    enum calculix_task task;
    enum calculix_element element;
    double length, width, thickness; /*                                        [m] > 0 */
    int cells[3];                    /* >= 1                                           */
    double young, poisson, density;  /*                              [Pa, 1, kg/m^3]   */
    double gravity;                  /*                                        [m/s^2] */
    double step, end;                /* of the swing                               [s] */
    int every; /* steps between answers; every * step divides end                      */
    /* Moves nodes, for distorted elements of 8 nodes; NULL: nobody does. */
    void (*place)(double x[3]);
};

/* What came back: for matrices all unknowns, lower triangle, row = 3 node + component,
 * node = (i m + j) l + k (k through the thickness, fastest), 14 digits; otherwise the
 * displacement of the mid-surface at the corners of the cells, 7 digits. */
struct calculix_answer {
    struct matrix K, M;
    int times, points[2]; /* points = cells[0] + 1, cells[1] + 1                       */
    double *time;         /* [times]; statics: one, INFINITY                       [s] */
    double *shift;        /* [times][points[0]][points[1]][3]                      [m] */
    char version[32];     /* what the program calls itself                             */
};

/* Accepts all-zero and leaves all-zero. */
void calculix_clear(struct calculix_answer *answer);

/* At time number t and corner i, j. */
const double *calculix_shift(const struct calculix_answer *answer, int t, int i, int j);

/* "C3D8", ... Static storage. */
const char *calculix_element_name(enum calculix_element element);

/* Runs `program` (NULL: ccx from the PATH; otherwise its whole path) on the job's deck in a
 * temporary folder of TMPDIR. STATUS_UNSUPPORTED if there is no such program;
 * STATUS_LIBRARY, with CalculiX's own words, if it failed - it ends with exit code 201, but
 * with 0 after a deck that it cannot open and after a singular matrix - or if what it wrote
 * is not whole, finite and of this job. On failure *answer is untouched. */
enum status calculix_run(const struct calculix_job *job, const char *program,
                         struct calculix_answer *answer, struct message *why);

#endif
