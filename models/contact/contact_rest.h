/* contact_rest.h - sheets that begin in a body, or in each other. */
#ifndef CONTACT_REST_H
#define CONTACT_REST_H

#include "models/discretization.h"
#include "models/scene.h"

/* Returns how far a sheet at rest reaches into a body at t = 0 [m], 0 if none does: the
 * distance at which their contact starts (contact_law_body) less the least distance of its
 * mid-surface. Exact for planes and spheres that do not turn; else the least at points of a
 * grid that is refined, up to 128 x 128 cells, where the body may be near, so that what
 * reaches in between its points may be missed by half a cell's diagonal. */
double contact_rest_depth(const struct scene *scene, const struct scene_obstacle *o);
#define CONTACT_REST_DEPTH "the sheet at rest reaches %.3g m into obstacle %d"

/* Returns by how much a sheet, from 0, lies nearer to another before it than where their
 * contact starts, at rest, and which that is [m]; 0 if none, or if sheets do not meet. */
double contact_rest_overlap(const struct scene *scene, int sheet, int *before);
#define CONTACT_REST_OVERLAP "sheet %d begins %.3g m too near to sheet %d, in contact"

/* Refuses, with a sentence, sheets that begin in a body or in each other, as the reader of
 * scenes does, with the line: STATUS_INPUT; contact under linear kinematics, and of the
 * control points of several sheets or of a closed one: STATUS_UNSUPPORTED. */
enum status contact_rest_refuse(const struct scene *scene, const struct discretization *d,
                                struct message *why);

#endif
