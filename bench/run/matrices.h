/* matrices.h - stiffness and mass of a rest shape as Matrix Market files. */
#ifndef MATRICES_H
#define MATRICES_H

#include "models/model.h"

/* Writes folder/K.mtx and folder/M.mtx; makes the folder if there is none. Unknowns are the
 * control points whatever *d says, held components included. STATUS_UNSUPPORTED if the
 * model has no matrices; STATUS_FILE. With a sentence. */
enum status matrices_write(const char *folder, const struct model *model,
                           const struct scene *scene, const struct discretization *d,
                           struct message *why);

#endif
