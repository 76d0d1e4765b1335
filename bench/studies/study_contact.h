/* study_contact.h - the paper's Fig. 9, a sheet that falls onto the ground, by several
 * models: what the obstacle carries, how far net and surface keep from it, and whether the
 * sheet passes through itself, which nothing here prevents.
 */
#ifndef STUDY_CONTACT_H
#define STUDY_CONTACT_H

#include "bench/experiment/experiment.h"
#include "bench/harness/run_result.h"

/* The solids come first. */
enum { STUDY_CONTACT_CASES = 7, STUDY_CONTACT_SOLIDS = 4, STUDY_CONTACT_TIMES = 5 };

/* One number a frame. */
enum {
    STUDY_CONTACT_NET_GAP,       /* least, of control points or nodes          [m]     */
    STUDY_CONTACT_SURFACE_GAP,   /* least, of the material grid                [m]     */
    STUDY_CONTACT_CARRIED,       /* control points or nodes                            */
    STUDY_CONTACT_FORCE,         /* of the ground, against gravity             [N]     */
    STUDY_CONTACT_CROSSINGS,     /* of the mid-surface with itself; NaN: not looked at */
    STUDY_CONTACT_NET_CROSSINGS, /* of the net's middle                                */
    STUDY_CONTACT_SERIES
};

struct study_contact_case {
    const char *label, *name; /* in tables; of its file, [a-z0-9_]+                    */
    const char *contestant;
    int side;            /* points of the paper's net, or what comes near it            */
    const char *damping; /* a setting; NULL: the paper's, which belongs to its scheme   */
};
extern const struct study_contact_case study_contact_case[STUDY_CONTACT_CASES];

struct study_contact_run {
    struct run_result result; /* with the fields at the scene's snapshots      owned   */
    double weight;            /* of the sheet [N]                                      */
    double thickness;         /* [m]                                                   */
    int frames;
    double *time;                         /* [frames] [s]                      owned   */
    double *series[STUDY_CONTACT_SERIES]; /* [frames]                          owned   */
};

/* What measure left in `folder`; free every run with study_contact_clear. */
enum status study_contact_read(const char *folder, int n, struct study_contact_run *run,
                               struct message *why);
void study_contact_clear(struct study_contact_run *run);

/* Table and sentences of run[STUDY_CONTACT_CASES], which `quick` has on small nets;
 * contact.csv, chart and pictures into the folder (study_contact_print.c). */
enum status study_contact_tell(const struct study_contact_run *run, bool quick,
                               const char *folder, enum table_format format, FILE *file,
                               struct message *why);

#endif
