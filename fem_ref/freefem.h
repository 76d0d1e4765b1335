/* freefem.h - a cantilevered sheet as a 3-D elastic solid, by FreeFEM: reads the fields
 * that fem_ref/freefem/store.sh computed (tests/reference/freefem_*.csv).
 *
 * The script is fem_ref/freefem/transient.edp; its header tells mesh, elements and time
 * stepping. A field is the displacement of FREEFEM_SIDE^2 points of the mid-surface, every
 * ninth of the material grid (grid.h), u = i / 11, v = j / 11, along the sheet's own axes
 * (e_u, e_v, e_w), under gravity along -e_w.
 */
#ifndef FREEFEM_H
#define FREEFEM_H

#include "models/status.h"

enum { FREEFEM_SIDE = 12, FREEFEM_TIMES = 4 };

struct freefem_field {
    int times;                  /* FREEFEM_TIMES, or 1: static                       */
    double time[FREEFEM_TIMES]; /* 0.1 .. 0.4 [s]; INFINITY: static                  */
    double shift[FREEFEM_TIMES][FREEFEM_SIDE][FREEFEM_SIDE][3]; /* [t][j][i] [m]     */
    double error[FREEFEM_TIMES]; /* error bar (rms) [m]; NaN: not known              */
};

/* Reads a field. Refuses (STATUS_INPUT, with file and line or row) missing or surplus rows,
 * other points or times, anything not finite, a clamped edge that moves, nothing that
 * moves. Without notes of the error its bar is NaN. */
enum status freefem_read(const char *path, struct freefem_field *field,
                         struct message *why);

/* Returns the rms over the points, at time number t, of |a - b| [m]. */
double freefem_difference(const struct freefem_field *a, const struct freefem_field *b,
                          int t);

#endif
