/* calculix_read.h - what CalculiX wrote, checked: whole, finite, of this job. */
#ifndef CALCULIX_READ_H
#define CALCULIX_READ_H

#include "fem_ref/calculix.h"

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
