/* motion.h - moves one model through one scene: the frames, their seconds, and how it ends.
 * Seconds are those of advance() alone; watchers of the frames sample outside of them. */
#ifndef MOTION_H
#define MOTION_H

#include <stdbool.h>

#include "bench/files/arena.h"
#include "models/model.h"

struct motion {
    const struct model *model; /*                                             borrowed */
    const struct scene *scene; /*                                             borrowed */
    void *state;               /* of the model                                borrowed */
    int frame_count;           /* that the scene requires                              */
    int frames;                /* that were survived                                   */
    double time;               /* of the last of them                              [s] */
    double *seconds;           /* [frame_count] of each step; a fatal one has its, too */
    int steps;                 /* numbers in `seconds`                                 */
    struct counters counters;
    double (*clock)(void); /* of the seconds: clock_now, unless set after motion_init  */
    bool judged;        /* set after motion_init: every frame was judged in a run before  */
    double until;       /* set after motion_init: when it is stopped (deadline.h)         */
    enum status death;  /* STATUS_OK: it lives                                          */
    double death_time;  /* of the frame that failed                                 [s] */
    struct arena arena; /* of seconds                                             owned */
};

/* A watcher is called at t = 0 and after every frame survived; if it returns anything but
 * STATUS_OK, the run ends. */
typedef enum status motion_watcher(void *context, const struct motion *m,
                                   struct message *why);

/* Builds the state at the scene's start. *m is overwritten; free with motion_clear. */
void motion_init(struct motion *m, const struct model *model, const struct scene *scene,
                 void *state);
void motion_clear(struct motion *m);

/* Runs all frames, up to scene->end or a death, which is a result: STATUS_OK and m->death;
 * or up to its deadline, STATUS_LATE with a sentence. After each frame
 * some points are examined, and, if one is far away, the whole grid (metric_blowup).
 * `watch` may be NULL. */
enum status motion_run(struct motion *m, motion_watcher *watch, void *context, bool quiet,
                       struct message *why);

/* Writes the sentence of its death, with the time; returns its status. */
enum status motion_tell_death(const struct motion *m, struct message *why);

#endif
