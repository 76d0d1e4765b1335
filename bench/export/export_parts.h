/* export_parts.h - what an export is made of; private to this room. */
#ifndef EXPORT_PARTS_H
#define EXPORT_PARTS_H

#include "bench/export/export_held.h"
#include "bench/files/output.h"
#include "bench/truth/truth.h"

struct export_job {
    struct scene scene; /* as its truth moves                                            */
    struct settings settings;
    struct export_sheet sheet;
    struct export_held held;
    struct truth known;    /* no times: no truth is known                                */
    struct message misfit; /* what matched springs cannot represent; empty: nothing      */
    bool undamped;         /* the scene is damped by a factor a step, its truth is not   */
};

/* Write one file each. STATUS_MEMORY; output.h says what cannot be written. */
enum status export_sheet_obj(struct export_job *j, struct output *out);
enum status export_sheet_ply(struct export_job *j, struct output *out);
enum status export_sheet_csv(struct export_job *j, struct output *out);
enum status export_held_csv(struct export_job *j, struct output *out);
enum status export_numbers_materials(struct export_job *j, struct output *out);
enum status export_numbers_times(struct export_job *j, struct output *out);
enum status export_numbers_obstacles(struct export_job *j, struct output *out);
enum status export_numbers_paths(struct export_job *j, struct output *out);
enum status export_numbers_loads(struct export_job *j, struct output *out);
enum status export_numbers_velocities(struct export_job *j, struct output *out);

#endif
