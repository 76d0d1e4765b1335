/* table4.h - the paper's Table 4: which of 18 combinations of E, rho and mu give a sheet
 * that looks like cloth, and why not.
 *
 * The rows are run on two scenes, `flag` and `edge_drop`, under six readings of the
 * physics: the paper's own scheme, others for the same solid, and a nonlinear shell. Every
 * run is a case file (case.h) in a folder; verdicts are given by the rules of the plan
 * `table4`, when it is printed, the same for every row, scene and reading.
 */
#ifndef TABLE4_H
#define TABLE4_H

#include "bench/harness/case.h"
#include "bench/experiment/exhibit.h"
#include "bench/truth/paper.h"
#include "bench/experiment/verdict.h"

extern const struct exhibit table4_exhibit;
enum status table4_print(const char *folder, enum table_format format, FILE *file,
                         struct message *why); /* table4_print.c */

enum { TABLE4_FLAG, TABLE4_DROP, TABLE4_SCENES };
extern const char *const table4_scene[TABLE4_SCENES]; /* "flag", "edge_drop"           */

/* What a row's mu is taken for. */
enum table4_damping {
    TABLE4_SCALE,    /* v <- mu v after each frame, as the paper has it                */
    TABLE4_RATE,     /* the same at a frame's end, as mass damping -ln(mu) / 5 ms      */
    TABLE4_UNDAMPED, /* mu has no meaning: the motion is that of E / rho               */
};
enum {
    TABLE4_PRINTED, /* the paper's                                                     */
    TABLE4_INCREMENTAL,
    TABLE4_INCREMENTAL_UNDAMPED,
    TABLE4_LINEAR,
    TABLE4_SOLID,      /* the paper's space with an elastic law of large displacements */
    TABLE4_SHELL_RATE, /* and so has the shell                                         */
    TABLE4_SHELL,
    TABLE4_READINGS
};
struct table4_reading {
    const char *name;  /* of files                                                     */
    const char *title; /* for people                                                   */
    const char *model, *kinematics;
    enum table4_damping damping;
};
extern const struct table4_reading table4_reading[TABLE4_READINGS];

/* Whether a reading has a law that holds at these displacements. */
bool table4_is_physics(int reading);

/* The row whose run serves a row: undamped ones with the same E / rho share it. */
int table4_run_of(int reading, int row);

/* FOLDER/printed_flag_07.h5 into path[size]. */
void table4_path(const char *folder, int reading, int scene, int row, char *path, int size);

/* Rows run again, printed, on the flag, with four times their E and four times their rho.
 */
enum { TABLE4_SCALED = 3 };
extern const int table4_scaled[TABLE4_SCALED];
void table4_scaled_path(const char *folder, int n, char *path, int size);

#endif
