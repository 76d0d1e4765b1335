/* statics.h - what needs no time: static equilibrium and natural frequencies. */
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

#endif
