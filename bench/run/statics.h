/* statics.h - results that need no time stepping: static equilibrium, natural frequencies,
 * the matrices of a rest shape. */
#ifndef STATICS_H
#define STATICS_H

#include "bench/harness/run.h"
#include "bench/data/printer.h"

/* Prints displacements of the sheet's corners, edges and centre in static equilibrium, to
 * which run_settle moved the state; `told` is what it said of it, or nothing. */
enum status statics_print(struct run *run, const struct message *told, struct printer *p);

/* Prints the `count` lowest frequencies about the rest shape or, if it was `settled`, about
 * static equilibrium (nonlinear kinematics). STATUS_UNSUPPORTED with a sentence. */
enum status statics_modes(struct run *run, int count, bool settled, struct printer *p,
                          struct message *why);

/* Writes folder/K.mtx and folder/M.mtx of the run that the plan describes; makes the folder
 * if there is none. Unknowns are the control points whatever its settings say, held
 * components included. STATUS_UNSUPPORTED if the model has no matrices; STATUS_FILE; both
 * with a sentence. */
enum status statics_matrices(const char *folder, const struct case_plan *c,
                             struct message *why);

#endif
