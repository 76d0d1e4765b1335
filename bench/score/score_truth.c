#include "bench/score/score_truth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/truth.h"
#include "models/metric/metric_rest.h"
#include "models/reader/scene_file.h"

enum { TENTHS_MOST = 100 };

static void middle(const double *xyz, double *field)
{
    for (int n = 0; n < 3 * SCORE_POINTS; n++)
        field[n] = .5 * (xyz[n] + xyz[3 * SCORE_POINTS + n]);
}

/* The middle surfaces of a truth at the first `times` of its times. */
static enum status take(const struct truth *from, int times, struct score_truth *t)
{
    const size_t count = (size_t)times;
    double *rest = metric_rest_field(&t->scene);
    enum status st = STATUS_MEMORY;

    t->time = malloc(count * sizeof *t->time);
    t->bar = malloc(count * sizeof *t->bar);
    t->xyz = malloc(count * 3 * SCORE_POINTS * sizeof *t->xyz);
    t->rest = malloc(3 * SCORE_POINTS * sizeof *t->rest);
    if (rest && t->time && t->bar && t->xyz && t->rest) {
        st = STATUS_OK;
        t->times = times;
        middle(rest, t->rest);
        snprintf(t->source, sizeof t->source, "%s", from->source);
        memcpy(t->time, from->time, count * sizeof *t->time);
        memcpy(t->bar, from->error, count * sizeof *t->bar);
        for (int n = 0; n < times; n++)
            middle(from->xyz[n], t->xyz + 3L * SCORE_POINTS * n);
    }
    free(rest);
    return st;
}

int score_truth_few(int n)
{
    return n / SCORE_SIDE * SCORE_EVERY * GRID_U + n % SCORE_SIDE * SCORE_EVERY;
}

/* All frames that are stored, and before them the sheet at rest. */
static enum status take_motion(const struct truth *made, struct score_truth *t)
{
    const size_t count = (size_t)made->claimed + 1;
    double *rest = metric_rest_field(&t->scene);

    t->motion_time = calloc(count, sizeof *t->motion_time);
    t->motion = malloc(count * sizeof *t->motion);
    if (rest && t->motion_time && t->motion) {
        t->motions = (int)count;
        for (int k = 0; k < t->motions; k++) {
            const double *xyz = k ? made->xyz[k - 1] : rest;
            t->motion_time[k] = k ? made->time[k - 1] : 0;
            for (int n = 0; n < 3 * SCORE_FEW; n++) {
                const int at = 3 * score_truth_few(n / 3) + n % 3;
                t->motion[k][n / 3][n % 3] = .5 * (xyz[at] + xyz[3 * SCORE_POINTS + at]);
            }
        }
    }
    free(rest);
    return t->motions ? STATUS_OK : STATUS_MEMORY;
}

/* A truth that is stored, if its physics are these. */
static enum status from_stored(struct score_truth *t, struct truth *made,
                               struct message *why)
{
    enum status st = truth_file_find(t->scene.name, &t->scene, made, why);

    if (st == STATUS_FILE || st == STATUS_UNSUPPORTED)
        return STATUS_OK;
    TRY(st);
    TRY(take_motion(made, t));
    truth_thin(made, &t->scene);
out:
    return st;
}

/* Takes a closed form or a stored truth; t->times stays 0 where there is neither. */
static enum status from_known(struct score_truth *t, struct message *why)
{
    struct truth made = {0};
    enum status st = truth_closed_make(&t->scene, &made);

    TRY(st == STATUS_UNSUPPORTED ? from_stored(t, &made, why) : st);
    if (made.claimed)
        TRY(take(&made, made.claimed, t));
out:
    truth_clear(&made);
    return st;
}

/* Evaluates an exact solution every tenth of a second; `word` is the user's name for it. */
static enum status from_formula(const char *word, const char *path,
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
    TRY(take(truth, times, t));
out:
    truth_destroy(truth);
    return st;
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
    TRY(from_known(t, why));
    if (!t->times)
        TRY(from_formula(scene, path, &settings, t, why));
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
    free(t->time);
    free(t->bar);
    free(t->xyz);
    free(t->rest);
    free(t->motion_time);
    free(t->motion);
    memset(t, 0, sizeof *t);
}

const double *score_truth_field(const struct score_truth *t, int n)
{
    return t->xyz + 3L * SCORE_POINTS * n;
}
