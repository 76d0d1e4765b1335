#include "bench/score/score_stretch.h"

#include <math.h>
#include <stdlib.h>

/* Lines of the net longer, or shorter, than the truth's by this share are said: chords of a
 * coarse net and what lies between two frames are too short, never too long. */
#define STRETCH_LEAST 0.005
#define SHRINK_LEAST  0.01

/* Where the truth itself stretches by more than this, its stretch is the measure: frames
 * whose differs by this share of it have a sentence. */
#define STRAIN_LEAST 1e-3
#define STRAIN_OFF   0.1

static double piece(const double *field, int point, int to)
{
    const double *a = field + 3L * point, *b = field + 3L * to;
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];

    return sqrt(x * x + y * y + z * z);
}

double score_stretch_share(const struct score_lines *l)
{
    return l->got / l->truth - 1;
}

/* Of the truth's stretch. */
bool score_stretch_has(const struct score_lines *l)
{
    return l->truth / l->rest - 1 > STRAIN_LEAST && l->got > l->rest;
}

/* A share of the truth's own stretch, where it has one; and what chords of this net cut off
 * the truth's lines, which are `whole` long. */
static double floor_of(const struct score_lines *l, double whole)
{
    const double cut = fabs(whole / l->truth - 1);

    if (score_stretch_has(l))
        return cut + STRAIN_OFF * (1 - l->rest / l->truth);
    return cut + (score_stretch_share(l) > 0 ? STRETCH_LEAST : SHRINK_LEAST);
}

struct score_lines score_stretch_lines(const struct score *s, const double *whole,
                                       const double *truth, const double *got, bool along_v)
{
    double length = 0;
    struct score_lines l = {0};
    double sum = 0, squares = 0;
    int pieces = 0;

    for (int j = 0; j < GRID_V - along_v; j++)
        for (int i = 0; i < GRID_U - !along_v; i++) {
            const int a = j * GRID_U + i, b = a + (along_v ? GRID_U : 1);
            const double wanted = piece(truth, a, b), there = piece(got, a, b);
            l.rest += piece(s->truth.rest, a, b);
            length += piece(whole, a, b);
            l.truth += wanted;
            l.got += there;
            sum += there / wanted;
            squares += there / wanted * (there / wanted);
            pieces++;
        }
    l.spread = sqrt(fmax(0, squares / pieces - sum / pieces * (sum / pieces)));
    l.floor = floor_of(&l, length);
    return l;
}

enum status score_stretch_find(const struct score *s, struct score_lines *most,
                               double *when)
{
    double *seen = malloc(3 * SCORE_POINTS * sizeof *seen), far = 1;

    *when = 0;

    for (int n = 0; seen && n < s->truth.times; n++) {
        if (!s->row[n].known)
            continue;
        score_seen(s, n, seen);
        for (int k = 0; k < 2; k++) {
            const struct score_lines l =
                score_stretch_lines(s, score_truth_field(&s->truth, n), seen,
                                    s->field + 3L * SCORE_POINTS * n, k);
            if (fabs(score_stretch_share(&l)) > far * l.floor) {
                far = fabs(score_stretch_share(&l)) / l.floor;
                *most = l;
                *when = s->row[n].time;
            }
        }
    }
    free(seen);
    return seen ? STATUS_OK : STATUS_MEMORY;
}
