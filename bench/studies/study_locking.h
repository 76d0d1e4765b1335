/* study_locking.h - how much of a plate's deflection a discretization has, for any
 * thickness: a square cantilever under its own weight, static and linear, tip over
 * Kirchhoff's.
 *
 * Two diseases, told apart by Poisson's ratio. At nu = 0 nothing couples bending to the
 * thickness, and what is missing is transverse shear locking. The quotient of the answers
 * at nu = 0.3 and nu = 0 is then thickness locking: with r = 1 the strain through the
 * thickness cannot vary, and the sheet bends as a plate of stiffness D' = E h^3 / 12 (1 -
 * nu) / ((1 + nu)(1 - 2 nu)),   nu' = nu / (1 - nu), (plane strain in w) whatever the net.
 * D / D' = (1 - 2 nu) / (1 - nu)^2 is the whole of it only for a strip; a plate's nu'
 * matters too.
 */
#ifndef STUDY_LOCKING_H
#define STUDY_LOCKING_H

#include "bench/experiment/experiment.h"

enum { STUDY_LOCKING_SPACES = 16, STUDY_LOCKING_MOST = 12, STUDY_LOCKING_PROTOTYPES = 3 };

struct study_locking_space {
    const char *label, *name; /* of tables; of files, [a-z0-9_]+                       */
    const char *family;       /* spaces that share a panel stand together              */
    const char *contestant;
    const char *degree; /* a setting that changes the contestant's; NULL: none         */
    int points;         /* a side                                                      */

    /* Tip over Kirchhoff at the thicknesses below, nu = 0.3, that an independent prototype
     * of the same spaces printed before this program was written, with its digits; NULL:
     * none. */
    const char *prototype[STUDY_LOCKING_PROTOTYPES];
};
extern const struct study_locking_space study_locking_space[STUDY_LOCKING_SPACES];
extern const double study_locking_thickness[STUDY_LOCKING_PROTOTYPES]; /* [m], of 1 m  */

/* The prototype's number and half a unit of its last digit; false: there is none. */
bool study_locking_prototype(const struct study_locking_space *space, int n, double *value,
                             double *half_unit);

/* Poisson's ratios: shear locking alone, both. */
enum { STUDY_LOCKING_NUS = 2, STUDY_LOCKING_BOTH = STUDY_LOCKING_NUS - 1 };
extern const double study_locking_nu[STUDY_LOCKING_NUS];

struct study_locking_cell { /* NaN: there is no equilibrium, or it was not timed        */
    double tip;             /* over Kirchhoff's                                         */
    double unknowns, setup, equilibrium; /* median seconds                              */
    struct message said;                 /* why there is none; empty: there is one      */
};

struct study_locking {
    int count;                            /* thicknesses                                */
    double thickness[STUDY_LOCKING_MOST]; /* [m]                                        */
    struct study_locking_cell cell[STUDY_LOCKING_SPACES][STUDY_LOCKING_NUS]
                                  [STUDY_LOCKING_MOST];
    double limit; /* of r = 1 at nu = 0.3: tip over Kirchhoff's in the thin limit        */
    char machine[4096]; /* file of a timed run                                          */
};

/* What measure left in the folder; freed by the receiver. */
enum status study_locking_read(const char *folder, struct study_locking **s,
                               struct message *why);

/* Tip over Kirchhoff's at nu = 0, shear locking alone; the quotient that is thickness
 * locking where there is no shear locking (where there is, nu changes it too). */
double study_locking_shear(const struct study_locking *s, int space, int thickness);
double study_locking_through(const struct study_locking *s, int space, int thickness);

/* Tables and sentences; locking.csv and the chart `locking` into the folder
 * (study_locking_print.c). */
enum status study_locking_tell(const struct study_locking *s, const char *folder,
                               enum table_format format, FILE *file, struct message *why);

#endif
