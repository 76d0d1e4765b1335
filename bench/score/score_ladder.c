#include "bench/score/score_ladder.h"

#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames_array.h"
#include "bench/harness/settings.h"
#include "bench/truth/truth.h"
#include "models/reader/named_file.h"
#include "models/reader/scene_file.h"

#define SCENE "edge_drop"
enum { TIMES_MOST = 1000 };

static const struct named_file_kind kind = {
    .what = "ladder of truths",
    .ending = ".npz",
    .environment = "CLOTHBENCH_LADDERS",
    .from_program = LADDERS_FROM_PROGRAM,
    .in_source = LADDERS_IN_SOURCE,
};

/* Finds whether a scene has the same physics as the ladder's scene. */
static enum status serves(const struct scene *scene, bool *does)
{
    struct settings settings = {0};
    struct scene own = {0};
    char *path = NULL, *text = NULL;
    enum status st;

    *does = false;
    TRY(scene_file_find(SCENE, &path, NULL));
    TRY(truth_plan_scene(path, &settings, &own, NULL));
    TRY(truth_physics(&own, &text));
    *does = truth_physics_check(text, scene, NULL) == STATUS_OK;
out:
    free(path);
    free(text);
    scene_clear(&own);
    settings_clear(&settings);
    return st == STATUS_MEMORY ? st
                               : STATUS_OK; /* without such a scene there is no ladder */
}

static enum status read_all(struct frames_array *file, const char *path,
                            struct score_ladder *l, struct message *why)
{
    unsigned long long size[8];
    enum status st;

    TRY(frames_array_begin(file, "t", size, why));
    if (size[0] < 1 || size[0] > TIMES_MOST)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: has %llu times; tools/ladder makes a file "
                        "of 1 to %d",
                        path, size[0], TIMES_MOST));
    const size_t times = (size_t)size[0];
    TRY(frames_array_load(file, "t", times, 1, &l->time, why));
    TRY(frames_array_load(file, "scale", LADDER_RUNGS, 1, &l->scale, why));
    TRY(frames_array_load(file, "size", LADDER_FLAWS, 1, &l->size, why));
    TRY(frames_array_load(file, "bending", LADDER_RUNGS * times * LADDER_POINTS, 3,
                          &l->rung, why));
    TRY(frames_array_load(file, "flaw", LADDER_FLAWS * times * LADDER_POINTS, 3, &l->flaw,
                          why));
    TRY(frames_array_load(file, "bending_bar", LADDER_RUNGS * times, 1, &l->bar, why));
    l->times = (int)times;
out:
    return st;
}

enum status score_ladder_read(const struct scene *scene, struct score_ladder *l,
                              struct message *why)
{
    struct frames_array *file = NULL;
    char *path = NULL;
    bool does;
    enum status st;

    memset(l, 0, sizeof *l);
    TRY(serves(scene, &does));
    if (does)
        st = named_file_find(&kind, SCENE "_ladder", &path, NULL);
    if (!does || st != STATUS_OK) { /* none is installed: nothing is fitted */
        st = st == STATUS_MEMORY ? st : STATUS_OK;
        goto out;
    }
    TRY(frames_array_open(path, &file, why));
    TRY(read_all(file, path, l, why));
out:
    free(path);
    frames_array_close(file);
    if (st != STATUS_OK)
        score_ladder_clear(l);
    return st == STATUS_UNSUPPORTED ? STATUS_INPUT : st;
}

void score_ladder_clear(struct score_ladder *l)
{
    free(l->time);
    free(l->scale);
    free(l->size);
    free(l->rung);
    free(l->flaw);
    free(l->bar);
    memset(l, 0, sizeof *l);
}

const double *score_ladder_rung(const struct score_ladder *l, int rung, int time)
{
    return l->rung + 3L * LADDER_POINTS * (rung * l->times + time);
}

const double *score_ladder_flaw(const struct score_ladder *l, int flaw, int time)
{
    return l->flaw + 3L * LADDER_POINTS * (flaw * l->times + time);
}
