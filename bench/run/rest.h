/* rest.h - what needs no time: static equilibrium and natural frequencies. */
#ifndef REST_H
#define REST_H

#include "bench/ui/table.h"
#include "models/model.h"

/* Moves the state to equilibrium and prints displacements of the sheet's corners, edges and
 * centre. STATUS_UNSUPPORTED with a sentence if the model has no statics. */
enum status rest_static(const struct scene *scene, const struct model *model, void *state,
                        enum table_format format, FILE *file, struct message *why);

/* Prints the `count` lowest frequencies about the rest shape or, if `settled`, about static
 * equilibrium, to which the state is moved (nonlinear kinematics). STATUS_UNSUPPORTED with
 * a sentence. */
enum status rest_modes(const struct scene *scene, const struct model *model, void *state,
                       int count, bool settled, enum table_format format, FILE *file,
                       struct message *why);

#endif
