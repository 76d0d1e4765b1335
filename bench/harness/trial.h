/* trial.h - what every run begins with: a scene file with settings, and a model built on
 * it. */
#ifndef TRIAL_H
#define TRIAL_H

#include "models/model.h"

struct trial {
    const struct model *model;
    struct scene scene;
    struct discretization discretization;
    void *state; /* of the model; NULL: it could not be built                */
    double create_seconds;
};

/* *trial is overwritten. In case of failure it keeps what was read so far: the scene if
 * only the model could not be built on it. Call trial_close in any case. */
enum status trial_open(struct trial *trial, const char *path, int setting_count,
                       const char *const *settings, const char *model, struct message *why);

/* The two halves of it, for who changes something in between: trial->scene and
 * trial->discretization as read; then the model. Errors as above. */
enum status trial_read(struct trial *trial, const char *path, int setting_count,
                       const char *const *settings, const char *model, struct message *why);
enum status trial_build(struct trial *trial, struct message *why);

void trial_close(struct trial *trial);

#endif
