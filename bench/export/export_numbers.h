/* export_numbers.h - the numbers that a simulator needs besides the mesh: materials.csv,
 * times.csv, and where the scene has them obstacles.csv, paths.csv, loads.csv,
 * velocities.csv. */
#ifndef EXPORT_NUMBERS_H
#define EXPORT_NUMBERS_H

#include "bench/export/export_held.h"
#include "bench/truth/truth.h"
#include "bench/ui/table.h"

/* Makes a table of the numbers of a net of points (export_numbers.c): equal ones share a
 * row with their count; owned by the caller. STATUS_MEMORY. */
enum status export_numbers_table(const struct export_sheet *s, struct table **table);

/* Writes all files: materials.csv has the same numbers one by one, times.csv step and end
 * of the scene and the times at which its truth is known, the others what the scene has.
 * *misfit says what matched springs cannot represent; empty: nothing. */
enum status export_numbers_write(const struct export_sheet *s,
                                 const struct export_held *held, const struct truth *known,
                                 struct message *misfit, struct message *why);

#endif
