/* export_numbers.h - what a simulator is told besides the mesh: materials.csv, times.csv,
 * and where the scene has them obstacles.csv, paths.csv, loads.csv, velocities.csv. */
#ifndef EXPORT_NUMBERS_H
#define EXPORT_NUMBERS_H

#include "bench/export/export_held.h"
#include "bench/truth/truth_made.h"
#include "bench/ui/table.h"

struct export_number {
    const char *quantity;
    int a, b; /* vertices; -1: none                                                    */
    double value;
    const char *unit;
    double length, compliance; /* at rest [m], 1/value; NaN: none                      */
};
typedef void export_numbers_take(void *context, const struct export_number *number);

/* What a net of points is made of, one by one: the material; the mass of each vertex a; of
 * a flat sheet the stiffness of a hinge between two triangles over an inner edge along u,
 * along v and along a diagonal, D |e|^2 / (A1 + A2) (theta^2 / 2 times it is the energy;
 * Grinspun et al. 2003), and twice that where one of the two is held; and each matched
 * spring from a to b (mass_spring/spring_net.h). *misfit: what those springs are not, for
 * people; empty: none. STATUS_MEMORY. */
enum status export_numbers_each(const struct export_sheet *s, export_numbers_take *take,
                                void *context, struct message *misfit);

/* The same as a table, those that are alike in one row with their number; owned by the
 * caller. STATUS_MEMORY. */
enum status export_numbers_table(const struct export_sheet *s, struct table **table);

/* The same as a file: quantity,a,b,value,unit,rest_length,compliance. */
enum status export_numbers_materials(const struct export_sheet *s, struct message *misfit,
                                     struct message *why);

/* what,time,bar: step and end of the scene, times at which its truth is known. */
enum status export_numbers_times(const struct export_sheet *s,
                                 const struct truth_made *known, struct message *why);

/* The other files, as far as the scene has what is in them. */
enum status export_numbers_world(const struct export_sheet *s,
                                 const struct export_held *held, struct message *why);

#endif
