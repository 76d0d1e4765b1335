/* export_numbers.h - what a simulator is told besides the mesh: materials.csv, times.csv,
 * and where the scene has them obstacles.csv, paths.csv, loads.csv, velocities.csv. */
#ifndef EXPORT_NUMBERS_H
#define EXPORT_NUMBERS_H

#include "bench/export/export_held.h"
#include "bench/truth/truth.h"
#include "bench/ui/table.h"

/* What a net of points is made of (export_numbers.c) as a table: those that are alike stand
 * in one row with their number; owned by the caller. STATUS_MEMORY. */
enum status export_numbers_table(const struct export_sheet *s, struct table **table);

/* All files: materials.csv has the same one by one, times.csv step and end of the scene and
 * the times at which its truth is known, the others what the scene has. *misfit: what
 * matched springs are not, for people; empty: none. */
enum status export_numbers_write(const struct export_sheet *s,
                                 const struct export_held *held, const struct truth *known,
                                 struct message *misfit, struct message *why);

#endif
