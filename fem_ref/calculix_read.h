/* calculix_read.h - what CalculiX wrote, checked: whole, finite, of this job. */
#ifndef CALCULIX_READ_H
#define CALCULIX_READ_H

#include "fem_ref/calculix_deck.h"
#include "models/model.h"

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

/* Reads <stem>.dof, .sti and .mas into answer->K and M. STATUS_LIBRARY with a sentence if
 * an unknown is missing, named twice or not the job's, or an entry is not a finite number.
 * What was read so far is the caller's to clear. */
enum status calculix_read_matrices(const struct calculix_job *job, const char *stem,
                                   struct calculix_answer *answer, struct message *why);

/* Reads <stem>.dat into time and shift. STATUS_LIBRARY also if a clamped node moves,
 * nothing moves, a time is not the job's, or a node moves by more than a million lengths
 * (what a singular matrix leaves). */
enum status calculix_read_shifts(const struct calculix_job *job, const char *stem,
                                 struct calculix_answer *answer, struct message *why);

#endif
