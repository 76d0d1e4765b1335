/* ladder.h - the rungs on which `compare` sets each model: nets, time steps, iterations,
 * from cheap to dear, as settings on top of the user's.
 */
#ifndef LADDER_H
#define LADDER_H

#include <stdbool.h>

#include "models/status.h"

enum { LADDER_SETTINGS = 8, LADDER_TEXT = 96 };

struct ladder_rung {
    const char *model;
    const char *family; /* "iga printed": what one line of a plot joins      static    */
    int side;           /* points along u and v                                        */
    int divisor;        /* the scene's frame is divided into so many steps             */
    int iterations;     /* local-global iterations, 0: the model has none              */
    char name[LADDER_TEXT]; /* of the file: [a-z0-9_]+         */
    int count;
    char settings[LADDER_SETTINGS][LADDER_TEXT]; /* KEY=VALUE                       */
};

/* All rungs of the models named in `models` ("iga,hex"; "all" or NULL: all that
 * are built), with
 * frames of `step` seconds. *rungs is freed by the receiver. STATUS_INPUT with a sentence
 * for an unknown name. `quick` leaves out the dear half. */
enum status ladder_make(const char *models, double step, bool quick,
                        struct ladder_rung **rungs, int *count, struct message *why);

#endif
