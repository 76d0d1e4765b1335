/* matrices.h - stiffness and mass of a rest shape as Matrix Market files. */
#ifndef MATRICES_H
#define MATRICES_H

#include "bench/harness/run.h"

/* Writes folder/K.mtx and folder/M.mtx of such a run; makes the folder if there is none.
 * Unknowns are the control points whatever its settings say, held components included.
 * STATUS_UNSUPPORTED if the model has no matrices; STATUS_FILE. With a sentence. */
enum status matrices_write(const char *folder, const struct run_plan *plan,
                           struct message *why);

#endif
