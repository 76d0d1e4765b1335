/* kirchhoff_field.h - the Kirchhoff truth (kirchhoff.h) as positions of the material grid,
 * for scenes that are a cantilevered sheet under its own weight. */
#ifndef KIRCHHOFF_FIELD_H
#define KIRCHHOFF_FIELD_H

#include "fem_ref/kirchhoff.h"
#include "models/scene.h"

/* Finds the plate of a scene: whole edge u = 0 held in x, y, z at rest, gravity along the
 * normal, no or mass damping, from rest, nothing else. Otherwise STATUS_UNSUPPORTED and a
 * sentence. */
enum status kirchhoff_field_plate(const struct scene *scene, struct kirchhoff_plate *plate,
                                  struct message *why);

/* Computes positions xyz[times][GRID_W][GRID_V][GRID_U][3] [m] (grid.h) of such a scene at
 * time[times] >= 0 (INFINITY: in equilibrium under its weight) by Kirchhoff's linear
 * kinematics: a point z above the mid-surface moves by w e_w - z grad w. `terms` as for
 * kirchhoff_create. Statuses of both. */
enum status kirchhoff_field(const struct scene *scene, int terms, int times,
                            const double *time, double *const *xyz, struct message *why);

#endif
