#define _POSIX_C_SOURCE 200809L
/* The scripted model in a program of its own, where a sweep can run it: its script is the
 * scene's density, a number from the list below. What says "wild" comes to a good end where
 * ODD_TAME is in the environment. */
#include "tests/odd_model.h"

#include <signal.h>
#include <unistd.h>

#include "tests/scripted_model.h"

enum odd {
    ODD_SOUND = 1,
    ODD_DIES,        /* at its third frame                                             */
    ODD_ESCAPES,     /* likewise, 1000 m away                                          */
    ODD_HANGS,       /* for ever                                                       */
    ODD_CRASHES,     /* by a signal of its own                                         */
    ODD_LEAVES,      /* the process, with exit code 3                                  */
    ODD_KILLED,      /* wild: by a signal of somebody else's                           */
    ODD_MEMORY,      /* wild: runs out of it                                           */
    ODD_LIBRARY,     /* fails                                                          */
    ODD_UNSUPPORTED, /* when it is created                                             */
    ODD_INPUT,       /* likewise: impossible                                           */
};

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    const enum odd what = (enum odd)scene->density;

    script_reset();
    script.dies = what == ODD_DIES ? 3 : 0;
    script.death = STATUS_NAN;
    script.escapes = what == ODD_ESCAPES ? 3 : 0;
    script.create = what == ODD_UNSUPPORTED ? STATUS_UNSUPPORTED
                    : what == ODD_INPUT     ? STATUS_INPUT
                                            : STATUS_OK;
    return scripted_init(state, scene, d, why);
}

static enum status advance(void *state, struct counters *counters)
{
    const struct scripted *s = state;
    const bool tame = getenv("ODD_TAME");

    switch ((enum odd)s->scene->density) {
    case ODD_HANGS:
        for (;;) /* it has nothing to wait for, and uses the processor */
            script_advances++;
    case ODD_CRASHES:
        signal(SIGABRT, SIG_DFL);
        abort();
    case ODD_LEAVES:
        _exit(3);
    case ODD_KILLED:
        if (!tame)
            raise(SIGKILL);
        break;
    case ODD_MEMORY:
        return tame ? scripted_advance(state, counters) : STATUS_MEMORY;
    case ODD_LIBRARY:
        return STATUS_LIBRARY;
    default:
        break;
    }
    return scripted_advance(state, counters);
}

const struct model odd_model = {
    .name = "odd",
    .title = "ends as it is told",
    .source = "a test",
    .defaults = {.points = {2, 2, 1}, .degree = {1, 1, 1}},
    .bytes = sizeof(struct scripted),
    .init = init,
    .advance = advance,
    .probe = scripted_probe,
    .size = scripted_size,
    .energy = scripted_energy,
};
