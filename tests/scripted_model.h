/* scripted_model.h - a model that does as it is told and writes down what it is asked: a
 * sheet that rises by a millimetre a frame. For tests of who runs models, not of models. */
#ifndef SCRIPTED_MODEL_H
#define SCRIPTED_MODEL_H

#include <time.h>

#include "bench/harness/contestant.h"
#include "models/clock.h"
#include "models/grid.h"
#include "tests/check.h"

/* What happens; all zero: nothing. Frames count from 1. */
static struct {
    int dies, escapes; /* the frame that cannot be had; that is far away                */
    enum status death, create, equilibrium;
    double create_seconds;
    int slow;         /* the frame that takes at least SCRIPT_SLOW seconds */
    int idle;         /* the frame that waits as long without a processor  */
    int refuse_after; /* creates that succeed before `create` is returned              */
    bool folds;       /* the sheet passes through itself within three places of the grid */
} script;

/* Of every create a capital, of every step a small letter: 'A' + points along u - 2. */
static char script_log[4096];
static int script_creates, script_advances, script_looks;

static void script_reset(void)
{
    memset(&script, 0, sizeof script);
    script_log[0] = '\0';
    script_creates = script_advances = script_looks = 0;
}

struct scripted {
    const struct scene *scene;
    int frame, letter;
};

static void script_note(int letter)
{
    const size_t used = strlen(script_log);

    REQUIRE(used + 1 < sizeof script_log);
    script_log[used] = (char)letter;
    script_log[used + 1] = '\0';
}

#define SCRIPT_SLOW 5e-3

/* Works for so long on the processor. */
static void script_wait(double seconds)
{
    const double start = clock_processor();

    while (clock_processor() - start < seconds)
        ;
}

static enum status scripted_init(void *state, const struct scene *scene,
                                 const struct discretization *d, struct message *why)
{
    struct scripted *s = state;

    if (script.create && script_creates >= script.refuse_after)
        return status_fail(why, script.create, "scripted: would not");
    script_creates++;
    script_wait(script.create_seconds);
    s->scene = scene;
    s->letter = d->points[0] - 2;
    script_note('A' + s->letter);
    return STATUS_OK;
}

static enum status scripted_advance(void *state, struct counters *counters)
{
    struct scripted *s = state;

    script_note('a' + s->letter);
    script_advances++;
    if (++s->frame == script.slow)
        script_wait(SCRIPT_SLOW);
    if (s->frame == script.idle)
        nanosleep(&(struct timespec){0, (long)(SCRIPT_SLOW * 1e9)}, NULL);
    counters->steps++;
    counters->substeps += 3;
    return s->frame == script.dies ? script.death : STATUS_OK;
}

/* Moves a point of the grid's places 50 to 53 along u. */
static void script_fold(double u, double xyz[3])
{
    static const double to[4][2] = {{51.5, 0}, {51.5, 1}, {50, 1}, {50, -1}};
    const long k = lround(u * (GRID_U - 1)) - 50;

    if (k >= 0 && k < 4)
        xyz[0] = to[k][0] / (GRID_U - 1), xyz[2] += to[k][1] / (GRID_U - 1);
}

static void scripted_probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct scripted *s = state;

    script_looks++;
    for (int p = 0; p < n; p++) {
        scene_rest_point(s->scene, uvw + 3 * p, xyz + 3 * p);
        if (script.folds)
            script_fold(uvw[3 * p], xyz + 3 * p);
        xyz[3 * p + 2] += s->frame == script.escapes && s->frame ? 1e3 : 1e-3 * s->frame;
    }
}

static void scripted_size(const void *state, struct model_size *size)
{
    (void)state;
    *size = (struct model_size){.nodes = 4, .unknowns = 12};
}

/* The number of the frame, so that a late look is found out. */
static void scripted_energy(const void *state, struct energy *energy)
{
    const struct scripted *s = state;

    *energy = (struct energy){.kinetic = s->frame, .elastic = NAN, .potential = 1};
}

static enum status scripted_equilibrium(void *state, struct counters *work,
                                        struct message *why)
{
    struct scripted *s = state;

    s->frame = 7;
    work->solves++;
    return script.equilibrium ? status_fail(why, script.equilibrium, "scripted: no rest")
                              : STATUS_OK;
}

static const struct model scripted_model = {
    .name = "scripted",
    .title = "does as it is told",
    .source = "a test",
    .defaults = {.points = {2, 2, 1}, .degree = {1, 1, 1}},
    .bytes = sizeof(struct scripted),
    .init = scripted_init,
    .advance = scripted_advance,
    .probe = scripted_probe,
    .size = scripted_size,
    .energy = scripted_energy,
    .equilibrium = scripted_equilibrium,
};

static const struct contestant scripted = {.name = "scripted",
                                           .title = "scripted",
                                           .column = "scripted",
                                           .model = &scripted_model};

#endif
