/* calculix.h - a sheet of hexahedra by CalculiX (ccx; Dhondt 2004, The Finite Element
 * Method for Three-Dimensional Thermomechanical Applications): matrices, linear statics,
 * a large swing. An outside code on the same nodes as ours, or with another element.
 *
 * Sheet 0 <= x <= length, 0 <= y <= width, |z| <= thickness/2, of cells[3] boxes; at rest
 * until gravity along -z acts; face x = 0 clamped (matrices: free).
 */
#ifndef CALCULIX_H
#define CALCULIX_H

#include "fem_ref/calculix_read.h"

/* Accepts all-zero and leaves all-zero. */
void calculix_clear(struct calculix_answer *answer);

/* At time number t and corner i, j. */
const double *calculix_shift(const struct calculix_answer *answer, int t, int i, int j);

/* Runs `program` (NULL: ccx from the PATH; otherwise its whole path) on the job's deck in a
 * temporary folder of TMPDIR. STATUS_UNSUPPORTED if there is no such program;
 * STATUS_LIBRARY, with CalculiX's own words, if it failed - it ends with exit code 201, but
 * with 0 after a deck that it cannot open and after a singular matrix - or if what it wrote
 * is not whole, finite and of this job. On failure *answer is untouched. */
enum status calculix_run(const struct calculix_job *job, const char *program,
                         struct calculix_answer *answer, struct message *why);

#endif
