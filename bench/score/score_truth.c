#include "bench/score/score_truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/metric/metric_rest.h"
#include "models/reader/scene_file.h"

enum { TENTHS_MOST = 100 };

int score_truth_few(int n)
{
    return n / SCORE_SIDE * SCORE_EVERY * GRID_U + n % SCORE_SIDE * SCORE_EVERY;
}

/* Replaces the first layer of a field by the mean of both. */
static void flatten(double *xyz)
{
    for (int n = 0; n < 3 * SCORE_POINTS; n++)
        xyz[n] = .5 * (xyz[n] + xyz[3 * SCORE_POINTS + n]);
}

/* Takes a closed form or a stored truth; nothing is claimed where there is neither. */
static enum status take_known(struct score_truth *t, struct message *why)
{
    const enum status st = truth_known(&t->scene, &t->known, why);

    t->moves = st == STATUS_OK && !t->known.closed;
    return st == STATUS_FILE || st == STATUS_UNSUPPORTED ? STATUS_OK : st;
}

/* Evaluates an exact solution every tenth of a second; `word` is the user's name for it. */
static enum status take_formula(const char *word, const char *path,
                                const struct settings *settings, struct score_truth *t,
                                struct message *why)
{
    const int all = (int)floor(10 * t->scene.end + 1e-9);
    const int times = all < 1 ? 1 : all < TENTHS_MOST ? all : TENTHS_MOST;
    double time[TENTHS_MOST];
    struct truth *truth = NULL;
    enum status st;

    for (int n = 0; n < times; n++)
        time[n] = all < 1 ? t->scene.end : (n + 1) / 10.0;
    st = truth_find(path, settings, times, time, NULL, &truth, NULL);
    if (st != STATUS_OK && st != STATUS_MEMORY) {
        st = truth_plan_check(&t->scene, why);
        TRY(st == STATUS_UNSUPPORTED ? STATUS_INPUT : st);
        st = status_fail(why, STATUS_INPUT,
                         "nothing is known of the motion of %s; clothbench truth %s makes "
                         "its truth by runs, and CLOTHBENCH_TRUTHS=results/truths before "
                         "this command has it found",
                         word, word);
    }
    TRY(st);
    truth_clear(&t->known);
    t->known = *truth;
    free(truth);
out:
    return st;
}

/* Chooses the times at which frames are judged: of a stored truth those at which tables
 * judge, or its last one; of others all. */
static enum status choose_times(struct score_truth *t)
{
    const int claimed = t->known.claimed;

    t->at = malloc((size_t)claimed * sizeof *t->at);
    if (!t->at)
        return STATUS_MEMORY;
    for (int n = 0; n < claimed; n++)
        if (!t->moves || truth_plan_judges(&t->scene, t->known.time[n]) ||
            (n == claimed - 1 && !t->times))
            t->at[t->times++] = n;
    return STATUS_OK;
}

enum status score_truth_read(const char *scene, struct score_truth *t, struct message *why)
{
    struct settings settings = {0};
    char *path = NULL;
    enum status st;

    memset(t, 0, sizeof *t);
    TRY(scene_file_find(scene, &path, why));
    TRY(truth_plan_scene(path, &settings, &t->scene, why));
    t->undamped = settings.count > 0;
    TRY(take_known(t, why));
    if (!t->known.claimed)
        TRY(take_formula(scene, path, &settings, t, why));
    TRY(choose_times(t));
    for (int n = 0; n < t->known.claimed; n++)
        flatten(t->known.xyz[n]);
    t->rest = metric_rest_field(&t->scene);
    TRY(t->rest ? STATUS_OK : STATUS_MEMORY);
    flatten(t->rest);
out:
    settings_clear(&settings);
    free(path);
    if (st != STATUS_OK)
        score_truth_clear(t);
    return st;
}

void score_truth_clear(struct score_truth *t)
{
    scene_clear(&t->scene);
    truth_clear(&t->known);
    free(t->at);
    free(t->rest);
    memset(t, 0, sizeof *t);
}
