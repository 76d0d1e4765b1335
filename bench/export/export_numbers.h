/* export_numbers.h - what a simulator is told besides the mesh: materials.csv, times.csv,
 * and where the scene has them obstacles.csv, paths.csv, loads.csv, velocities.csv. */
#ifndef EXPORT_NUMBERS_H
#define EXPORT_NUMBERS_H

#include "bench/export/export_held.h"
#include "bench/truth/truth_made.h"

/* quantity,a,b,value,unit,rest_length,compliance: the material; the mass of each vertex a;
 * of a flat sheet each matched spring from a to b (mass_spring/spring_net.h), with
 * 1 / stiffness for XPBD. *misfit: what those springs are not, for people; empty: none. */
enum status export_numbers_materials(const struct export_sheet *s, struct message *misfit,
                                     struct message *why);

/* what,time,bar: step and end of the scene, times at which its truth is known. */
enum status export_numbers_times(const struct export_sheet *s,
                                 const struct truth_made *known, struct message *why);

/* The other files, as far as the scene has what is in them. */
enum status export_numbers_world(const struct export_sheet *s,
                                 const struct export_held *held, struct message *why);

#endif
