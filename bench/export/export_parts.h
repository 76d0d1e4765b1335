/* export_parts.h - what an export is made of; private to this room.
 *
 * Vertices outside the sheet make a clamp of an edge: where bending is an angle between
 * elements, a held row alone is a hinge. A support through the whole thickness that holds
 * the direction from an edge into the sheet keeps the edge from turning. A vertex whose
 * neighbour inside is free and that has none on the other side gets one there, where the
 * mid-surface would go on, held as it is. A patch of several rows needs none.
 */
#ifndef EXPORT_PARTS_H
#define EXPORT_PARTS_H

#include "bench/export/export_sheet.h"
#include "bench/files/output.h"
#include "bench/truth/truth.h"

struct export_held_vertex {
    int vertex, i, j; /* its number, from n m on for those outside; its place           */
    unsigned fix;     /* FIX_X...                                                       */
    int support;      /* that it moves with; -1: it does not move                       */
    int beside;       /* outside: the held vertex that it stands beside; else -1        */
};

struct export_held {
    int count, outside;
    struct export_held_vertex *vertex; /* [count], those of the sheet first      owned */
    struct message doubt; /* where the net holds too little; empty: nowhere            */
};

/* Finds the held vertices. STATUS_UNSUPPORTED with a sentence: vertices cannot express how
 * the scene holds the sheet, STATUS_INPUT: a support holds none of them. Free with
 * export_held_clear. */
enum status export_held_find(const struct export_sheet *s, struct export_held *held,
                             struct message *why);
void export_held_clear(struct export_held *held); /* all-zero is allowed */

struct export_job;

/* Returns the path in paths.csv of the nth held vertex: its support's number, or, as a turn
 * moves each vertex another way, one of its own after those; -1: it does not move. */
int export_held_path(const struct export_job *j, int n);

struct export_job {
    struct scene scene; /* as its truth moves                                            */
    struct settings settings;
    struct export_sheet sheet;
    struct export_held held;
    struct truth known;    /* no times: no truth is known                                */
    struct message misfit; /* what matched springs cannot represent; empty: nothing      */
    int body;              /* the obstacle of export_mesh_body                            */
    bool undamped;         /* the scene is damped by a factor a step, its truth is not   */
};

/* Finds the corners of the n-th triangle, counted from 0: counter-clockwise seen from where
 * u x v points. A cell's diagonals alternate, so that the mesh has no bias. */
void export_mesh_triangle(const struct export_sheet *s, int n, int corner[3]);
int export_mesh_triangles(const struct export_sheet *s);

/* Finds the velocity of vertex n at t = 0, none in components that are held [m/s]. *held
 * goes through the held vertices as n goes up from 0, and begins at 0. */
void export_numbers_velocity(const struct export_job *j, int n, int *held, double v[3]);

/* Write one file each. STATUS_MEMORY; output.h says what cannot be written. */
enum status export_mesh_obj(struct export_job *j, struct output *out);
enum status export_mesh_ply(struct export_job *j, struct output *out);
enum status export_mesh_csv(struct export_job *j, struct output *out);
enum status export_held_csv(struct export_job *j, struct output *out);
enum status export_mesh_body(struct export_job *j, struct output *out);
enum status export_numbers_materials(struct export_job *j, struct output *out);
enum status export_numbers_times(struct export_job *j, struct output *out);
enum status export_numbers_obstacles(struct export_job *j, struct output *out);
enum status export_numbers_paths(struct export_job *j, struct output *out);
enum status export_numbers_loads(struct export_job *j, struct output *out);
enum status export_numbers_velocities(struct export_job *j, struct output *out);
enum status export_usd(struct export_job *j, struct output *out);

#endif
