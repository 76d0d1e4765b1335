/* store.h - the result file of one run: scene, model, discretization, motion, seconds.
 *
 * HDF5, after a first line of text, the seal (seal.h), which shows damage;
 * texts are of fixed length. In /, F = frames kept, K <= F = those of them with their
 * field, R = repeats:
 *
 *   attributes        format, scene (its YAML text), scene_name, scene_source, model,
 *                     model_title, model_source, discretization (lines `key=value` as
 *                     --set takes them), outcome ("done", "not_arrived" where the
 *                     iterations of a step ended at their limit, or a death's sentence),
 *                     death_time [s] (only then), note (a sentence, if there is one),
 *                     quick ("yes", of a quick run only), made_for (run_file.h),
 *                     warnings (a line each, if there are any: harness/warnings.h),
 *                     length, width, thickness [m], nodes, unknowns, factor_entries,
 *                     corner_u, corner_v [m] (of a sheet that is no rectangle: where its
 *                     box begins, from the pose's origin),
 *                     contact_thickness, contact_range [m], contact_stiffness [Pa],
 *                     contact_friction (the law of the sheet on itself, of scenes with
 *                     contact only), contact_distance, contact_edge [m] (from a body under
 *                     the sheet's weight: of its mid-surface, and lambda),
 *                     solver, unknown_basis, model_bytes (of a run that was timed)
 *   provenance        a group whose attributes are provenance.h's keys
 *   time              [F]                          double [s]
 *   xyz               [K][w 2][v 100][u 100][3]    double [m] (or float, if asked for)
 *   xyz_time          [K]                          double [s]
 *   frame/0, frame/1, ...                          views of xyz[0], xyz[1], for XDMF
 *   surface/triangle  [T][3]                       int, of a sheet that is no rectangle:
 *                     triangles of its mid-surface, for pictures
 *   surface/uv        [N][2]                       double [1], their points on the sheet
 *   surface/0, surface/1, ...  [N][3]              double [m], at xyz_time[0], ...
 *   surface/start     [N][3]                       double [m], of what starts in space:
 *                     along u and v from the box's corner, and along the normal
 *   support_0, ...    [parts][6]                   double [1], u v of corners of what a
 *                     support holds that names vertices or a group
 *   energy/kinetic, energy/elastic, energy/potential   [F]   double [J], NaN if not known
 *   counters/steps, ...                            [F]   work done up to the frame
 *   forces/support_0, ..., forces/obstacle_0, ...  [F][3]   double [N], what the scene's
 *                     supports and obstacles exert on the sheet (model.h), NaN: not known
 *   moments/support_0, ...                         [F][3]   double [N m], about the origin
 *   metrics/NAME      [F]                          double
 *   seconds/create                                 [R]            raw, every repeat
 *   seconds/look                                   [1]            sampling and measuring
 *   seconds/advance                                [R][steps]     raw, every step
 *   seconds/equilibrium                            [R][1]         raw
 *   seconds/timed, seconds/processor               [1]   all that was timed together with
 *                     this run; of that, with a processor: less where others want it too
 *   seconds/assemble, seconds/factor, seconds/solve  [R]          raw, phases of a step
 *
 * Every dataset has the attributes `unit` ("m", "s", "1", ...) and `axes` (what its axes
 * count, in order: "frame of xyz, w, v, u, component").
 *
 * Beside FILE.h5 stands FILE.xdmf, if there are fields, which opens in ParaView (path with
 * a slash in it). Both are written aside and renamed (atomic_file.h): a run that fails
 * leaves neither.
 */
#ifndef STORE_H
#define STORE_H

#include <stdbool.h>

#include "bench/files/scope.h"
#include "models/model.h"

#define STORE_NOT_ARRIVED "not_arrived" /* the outcome */

struct store;

/* The description of a run before its first step; all borrowed during store_create. */
struct store_run {
    const struct scene *scene;
    const struct model *model;
    const struct discretization *discretization;
    bool single; /* positions as 32-bit floats: 1e-8 m on a 1 m sheet, half the file */
    bool packed; /* shuffled and deflated: a quarter of a smooth field's bytes */
};

/* Learns before a long set-up whether a result file can be written there. STATUS_INPUT: the
 * name is one of another format, STATUS_FILE; with a sentence. */
enum status store_try(const char *path, struct message *why);

/* Opens the file aside. STATUS_FILE with a sentence; *store is then untouched. Call
 * store_close or store_discard in the end. */
enum status store_create(const char *path, const struct store_run *run,
                         struct store **store, struct message *why);

/* Adds the triangles[count] of a surface of `points` points at uv[points][2]; start: NULL,
 * or where they begin. store_surface_frame adds their positions, and is called after each
 * frame with a field. */
enum status store_surface(struct store *store, int points, const double *uv,
                          const double (*start)[3], int count, const int (*triangle)[3],
                          struct message *why);
enum status store_surface_frame(struct store *store, const double *xyz,
                                struct message *why);

/* Appends a frame: field xyz (grid.h) at time t; NULL: a frame without its field, as
 * numbers alone. energy and counters may be NULL: NaN and zeros are stored. */
enum status store_frame(struct store *store, double t, const double *xyz,
                        const struct energy *energy, const struct counters *counters,
                        struct message *why);

/* Adds raw seconds[rows][columns] of a phase ("create", "advance", "look"); columns = 0:
 * one number a repeat. Call once per phase. */
enum status store_seconds(struct store *store, const char *phase, const double *seconds,
                          int rows, int columns, struct message *why);

/* Adds a number per frame stored so far, value[count], with its unit ("m", "1"). Call once
 * per name, [a-z_]+. */
enum status store_metric(struct store *store, const char *name, const char *unit,
                         const double *value, int count, struct message *why);

/* Adds a vector per frame stored so far, value[count][3], of that name, once each. */
enum status store_vectors(struct store *store, const char *name, const char *unit,
                          const double (*value)[3], int count, struct message *why);

/* Adds the size of the model that was built. */
enum status store_size(struct store *store, const struct model_size *size,
                       struct message *why);

/* Adds a text attribute of /, [a-z_]+, besides those above, such as "note", a sentence on
 * the run that its outcome does not say. Call once per key. */
enum status store_text(struct store *store, const char *key, const char *text,
                       struct message *why);

/* Adds a number as an attribute of /, once per key. */
enum status store_number(struct store *store, const char *key, double value,
                         struct message *why);

/* Notes that the run died at t with this status; store_close writes it. */
void store_death(struct store *store, enum status death, double t);

/* Completes the file, syncs, renames, writes the XDMF; frees in any case. On failure
 * nothing is left of the file that failed. */
enum status store_close(struct store *store, struct message *why);

/* Gives the run up: removes the temporary file. NULL is allowed. */
void store_discard(struct store *store);
SCOPE_OF(store_discard, struct store)

/* A result file that is being read: tables, plots and scores are made from it. */
struct store_read;

/* Opens FILE.h5 for reading. STATUS_FILE: cannot be read; STATUS_INPUT: HDF5, but not a
 * run. *file is freed with store_read_close. */
enum status store_read_open(const char *path, struct store_read **file,
                            struct message *why);
void store_read_close(struct store_read *file); /* NULL is allowed */
SCOPE_OF(store_read_close, struct store_read)

/* Returns the number of frames with a field; their times are the array "xyz_time". */
int store_read_frames(const struct store_read *file);

/* Reads the n-th field, 0 <= n < frames, into xyz (grid.h) [m]. */
enum status store_read_frame(const struct store_read *file, int n, double *xyz,
                             struct message *why);

bool store_read_has(const struct store_read *file, const char *name);

/* Reads an array of doubles by its name in the file ("time", "metrics/drop",
 * "seconds/advance"): *values [rows][columns], good until the file is closed; columns >= 1,
 * 1 for one number a row. */
enum status store_read_array(struct store_read *file, const char *name, double **values,
                             int *rows, int *columns, struct message *why);

/* Reads the text attribute `key` of `group` ("/", "provenance", "metrics/drop"); *text is
 * good until the file is closed. */
enum status store_read_text(struct store_read *file, const char *group, const char *key,
                            char **text, struct message *why);

/* Reads the number attribute `key` of "/" ("length", "unknowns"). */
enum status store_read_number(const struct store_read *file, const char *key,
                              double *number, struct message *why);

#endif
