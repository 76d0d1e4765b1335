#include "bench/score/score_ladder.h"

#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames_npz.h"
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

/* Whether a scene has the same physics as the ladder's scene. */
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

static enum status take(const struct npz *npz, const char *name, size_t count,
                        double **values, struct message *why)
{
    struct npz_array a;
    enum status st = npz_load(npz, name, count, &a, values, why);

    if (st == STATUS_UNSUPPORTED || (st == STATUS_OK && npz_count(&a) != count))
        st = status_fail(why, STATUS_INPUT,
                         "%s: has no %s of %zu numbers; tools/ladder "
                         "makes such a file",
                         npz->bytes.path, name, count);
    return st;
}

static enum status read_all(const struct npz *npz, struct score_ladder *l,
                            struct message *why)
{
    struct npz_array a;
    enum status st;

    TRY(npz_load(npz, "t.npy", TIMES_MOST, &a, &l->time, why));
    const size_t times = npz_count(&a), field = times * LADDER_POINTS * 3;
    TRY(take(npz, "scale.npy", LADDER_RUNGS, &l->scale, why));
    TRY(take(npz, "size.npy", LADDER_FLAWS, &l->size, why));
    TRY(take(npz, "bending.npy", LADDER_RUNGS * field, &l->rung, why));
    TRY(take(npz, "flaw.npy", LADDER_FLAWS * field, &l->flaw, why));
    TRY(take(npz, "bending_bar.npy", LADDER_RUNGS * times, &l->bar, why));
    l->times = (int)times;
out:
    return st;
}

enum status score_ladder_read(const struct scene *scene, struct score_ladder *l,
                              struct message *why)
{
    struct npz npz = {0};
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
    TRY(npz_open(path, &npz, why));
    st = read_all(&npz, l, why);
out:
    free(path);
    npz_close(&npz);
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
