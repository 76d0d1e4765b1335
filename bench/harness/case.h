/* case.h - one run as it is asked for: a contestant on a scene with settings, how it ends,
 * what is kept of it and whether it is timed. It is plain data: commands, studies, sweeps,
 * truths and hard cases differ in the cases that they ask for.
 *
 *     struct case_plan c = {"edge_drop", contestant, .end = 0.5, .keep = {.every = 10}};
 *     settings_number(&c.settings, "time.step", 0.005);
 *     case_file(&c, folder, "iga_paper_10");
 *     TRY(run_file_write(&c, &result, why));
 */
#ifndef CASE_H
#define CASE_H

#include "bench/harness/contestant.h"
#include "bench/harness/settings.h"

enum run_fields {
    RUN_FIELDS_TIMES, /* of the looks at `time` alone                                  */
    RUN_FIELDS_ALL,   /* of all looks; the last survived frame becomes one */
    RUN_FIELDS_NONE,
};

/* The choice of what to keep of a run; all borrowed. */
struct run_keep {
    const char *file;   /* FILE.h5; NULL: none, the result alone                       */
    int every;          /* frames from look to look, the last one, too; 0: none        */
    int times;          /* further looks at; < 0: the scene's snapshots (measurement.h) */
    const double *time; /* [times], multiples of the step, increasing [s]              */
    enum run_fields fields;
    bool intersections;   /* count self-intersections at every look                      */
    bool doubles;         /* fields as 64-bit numbers, not 32                            */
    bool quick;           /* of --quick: noted in the file; no verdict rests on it       */
    const char *made_for; /* one line, noted in the file; NULL: none                   */

    /* Finds, at every look in motion, the distance of the field from the truth at that time
     * and the truth's error bar, both over the length, which are kept as metrics (looks.h);
     * NULL: none is known. */
    void (*truth)(const void *context, double time, const double *xyz, double *error,
                  double *bar);
    const void *context;
};

enum case_timed {
    CASE_UNTIMED,
    CASE_FAIR,  /* WHOLE where the cost of a frame changes along the motion (Newton's
                   iterations, contact), SOME where it does not                         */
    CASE_SOME,  /* twenty after two: where a frame costs the same all along the motion */
    CASE_WHOLE, /* all that it lives through                                           */
};

struct case_plan {
    const char *path;                    /* of the scene file, or a scene's name       */
    const struct contestant *contestant; /*                                   borrowed */
    struct settings settings; /* on top of the contestant's; their arena has what else the
                                 case owns: path and file, where they are not borrowed   */
    double end;               /* instead of the scene's; 0: the scene's [s] */
    struct run_keep keep;
    bool rest; /* static equilibrium instead of motion                                  */
    enum case_timed timed;
    int repeats;  /* of the timing; 0: as timing.h has it                                */
    bool phases;  /* a solid that is rebuilt is timed: also its phases, apart            */
    double until; /* when it is stopped between two frames (deadline.h); 0: never        */
    bool done;    /* out: its file is there (measurement.h)                              */
};

/* Frees what lies in its arena. All-zero is allowed, and left. */
void case_clear(struct case_plan *c);

/* Names its file "FOLDER/NAME.h5", and returns that. */
const char *case_file(struct case_plan *c, const char *folder, const char *name);

enum { CASE_KEY = 32 };

/* Returns a sum of what the bits of results depend on besides their cases: the sources of
 * the models, compiler and flags; for what is `timed` also the machine. */
unsigned long case_program(bool timed);

/* Writes the key of a case: a sum of all that its file depends on. The scene, read with the
 * case's settings, has them and what its meshes are in its text; `before` is the sum of
 * what else counts, such as case_program. */
void case_key(const struct case_plan *c, const struct scene *scene, unsigned long before,
              char key[CASE_KEY]);

#endif
