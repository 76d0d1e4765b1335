/* study_thickness.h - Ren et al. 2024, Fig. 10: a cloak of 1 mm and one of 5 mm (and 2 mm),
 * in the paper's scheme on its net and on a better one, without damping, and as a nonlinear
 * shell on two nets, whose difference is its error bar.
 */
#ifndef STUDY_THICKNESS_H
#define STUDY_THICKNESS_H

#include "bench/harness/rung.h"
#include "bench/experiment/study.h"

extern const struct experiment study_thickness_experiment;

enum {
    STUDY_THICKNESS_LEVELS = 3, /* the first and the last are the paper's               */
    STUDY_THICKNESS_NETS = 2,   /* of the shell, coarse and fine                        */
    STUDY_THICKNESS_SOLIDS = 3, /* the paper's scheme, on a better net, undamped        */
    STUDY_THICKNESS_SCHEMES = STUDY_THICKNESS_SOLIDS + STUDY_THICKNESS_NETS,
    STUDY_THICKNESS_TIMES = 4,
};

extern const struct study study_thickness_solid[STUDY_THICKNESS_SOLIDS];

/* Thickness of a level [m]. */
double study_thickness_of(int level);

/* A swing is the largest turn, at any of the times, of the line from the neck's middle to
 * the hem's, out of its angle at rest. */
struct study_thickness {
    struct study_result solid[STUDY_THICKNESS_SOLIDS], linear;
    struct rung_result shell[STUDY_THICKNESS_LEVELS][STUDY_THICKNESS_NETS];
    double angle, length, gamma; /* at rest [degrees]; [m]; of the first level          */
    double swing[STUDY_THICKNESS_SCHEMES][STUDY_THICKNESS_LEVELS]; /* solids, shells;
                                     NaN: none                                [degrees] */
    double sunk[STUDY_THICKNESS_LEVELS]; /* the hem in linear equilibrium, rms      [m] */
};

enum status study_thickness_read(const char *folder, struct study_thickness **s,
                                 struct message *why);
void study_thickness_destroy(struct study_thickness *s); /* NULL is allowed */

enum status study_thickness_print(const char *folder, enum table_format format, FILE *file,
                                  struct message *why); /* study_thickness_print.c       */

#endif
