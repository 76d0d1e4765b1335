#include "bench/score/score_support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is held is where the truth has it, to this share of the length: penalties give way.
 */
#define HELD_MOST 0.01

/* Of what is said [m]. */
#define DIGIT 1e-6

/* One shift of all where what is held is off by the same to this share of it. */
#define SAME 0.25

/* Sums over points, in what their supports fix [m]. */
struct sums {
    int points;
    double off[3], square;
};

static void add_points(const struct scene_support *held, const double *seen,
                       const double *got, struct sums *sums)
{
    const double NEAR = 1e-9;

    for (int p = 0; p < SCORE_POINTS; p++) {
        const double uv[2] = {p % GRID_U / (GRID_U - 1.), p / GRID_U / (GRID_V - 1.)};
        if (uv[0] < held->lo[0] - NEAR || uv[0] > held->hi[0] + NEAR ||
            uv[1] < held->lo[1] - NEAR || uv[1] > held->hi[1] + NEAR)
            continue;
        sums->points++;
        for (int c = 0; c < 3; c++)
            if (held->fix & 1u << c) {
                const double off = got[3 * p + c] - seen[3 * p + c];
                sums->off[c] += off;
                sums->square += off * off;
            }
    }
}

/* The mean into by[3]; its length. */
static double mean(const struct sums *sums, double by[3])
{
    double square = 0;

    for (int c = 0; c < 3; c++) {
        by[c] = sums->points ? sums->off[c] / sums->points : 0;
        square += by[c] * by[c];
    }
    return sqrt(square);
}

/* What nothing holds is off as it begins. */
static void begins_off(const struct score *s, struct score_support *support)
{
    const double *by = s->begin, length = s->truth.scene.length,
                 far = sqrt(by[0] * by[0] + by[1] * by[1] + by[2] * by[2]);

    support->steady = far > HELD_MOST * length && s->start - far < SAME * far;
    support->most = support->steady ? far / length : 0;
    memcpy(support->by, by, sizeof support->by);
    memcpy(support->shift, by, sizeof support->shift);
}

enum status score_support_find(const struct score *s, struct score_support *support)
{
    const struct scene *scene = &s->truth.scene;
    double *seen = malloc(3 * SCORE_POINTS * sizeof *seen), square = 0;
    struct sums all = {0};

    memset(support, 0, sizeof *support);
    for (int n = 0; seen && n < s->truth.times; n++) {
        const double *got = s->field + 3L * SCORE_POINTS * n;
        if (!s->row[n].known)
            continue;
        score_seen(s, n, seen);
        for (int k = 0; k < scene->support_count; k++) {
            struct sums one = {0};
            add_points(&scene->supports[k], seen, got, &one);
            add_points(&scene->supports[k], seen, got, &all);
            if (one.points && one.square / one.points > square) {
                square = one.square / one.points;
                support->which = k;
                support->time = s->row[n].time;
                mean(&one, support->by);
            }
        }
    }
    free(seen);
    if (!seen)
        return STATUS_MEMORY;
    support->most = sqrt(square) / scene->length;
    const double shift = mean(&all, support->shift);
    support->steady = shift > HELD_MOST * scene->length &&
                      all.square / all.points - shift * shift < SAME * SAME * shift * shift;
    if (!scene->support_count)
        begins_off(s, support);
    if (!support->steady)
        memset(support->shift, 0, sizeof support->shift);
    if (support->most <= HELD_MOST)
        support->most = 0;
    for (int c = 0; c < 3; c++)
        support->by[c] = round(support->by[c] / DIGIT) * DIGIT + 0.0;
    return STATUS_OK;
}
