/* statics.h - what needs no time: static equilibrium, natural frequencies, the
 * matrices of a rest shape. */
#ifndef STATICS_H
#define STATICS_H

#include "bench/harness/run.h"
#include "bench/ui/table.h"

/* Moves the state to equilibrium and prints displacements of the sheet's corners, edges and
 * centre. STATUS_UNSUPPORTED with a sentence if the model has no statics. */
enum status statics_print(struct run *run, enum table_format format, FILE *file,
                          struct message *why);

/* Prints the `count` lowest frequencies about the rest shape or, if `settled`, about static
 * equilibrium, to which the state is moved (nonlinear kinematics). STATUS_UNSUPPORTED with
 * a sentence. */
enum status statics_modes(struct run *run, int count, bool settled,
                          enum table_format format, FILE *file, struct message *why);

/* Writes folder/K.mtx and folder/M.mtx of such a run; makes the folder if there is none.
 * Unknowns are the control points whatever its settings say, held components included.
 * STATUS_UNSUPPORTED if the model has no matrices; STATUS_FILE. With a sentence. */
enum status statics_matrices(const char *folder, const struct run_plan *plan,
                             struct message *why);

#endif
