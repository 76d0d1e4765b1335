#include "models/mechanics/dead_load.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/gauss.h"

static void values(const struct dead_load_line *line, double t, double *N)
{
    const int last = line->n - 1;

    if (line->value) {
        line->value(line->context, t, N);
        return;
    }
    memset(N, 0, (size_t)line->n * sizeof *N);
    if (last == 0) {
        N[0] = 1;
        return;
    }
    int k = (int)fmin(floor(t * last), last - 1);
    N[k + 1] = t * last - k;
    N[k] = 1 - N[k + 1];
}

static double end_of(const struct dead_load_line *line, int k)
{
    return line->at ? line->at[k] : (double)k / (line->n - 1);
}

/* Computes means of the functions over [lo, hi], or values if lo = hi, mean[n]; work[n]. */
static void line_means(const struct dead_load_line *line, double lo, double hi,
                       double *mean, double *work)
{
    const int points = line->degree / 2 + 1;
    const int breaks = line->at ? line->breaks : line->n;
    double x[GAUSS_MAX], w[GAUSS_MAX];

    if (!(hi > lo) || breaks < 2) {
        values(line, lo, mean);
        return;
    }
    gauss_rule(points, x, w);
    memset(mean, 0, (size_t)line->n * sizeof *mean);
    for (int k = 0; k + 1 < breaks; k++) {
        double from = fmax(lo, end_of(line, k)), to = fmin(hi, end_of(line, k + 1));
        for (int q = 0; to > from && q < points; q++) {
            values(line, from + (to - from) * x[q], work);
            for (int a = 0; a < line->n; a++)
                mean[a] += w[q] * (to - from) / (hi - lo) * work[a];
        }
    }
}

enum status dead_load_add(const struct scene *scene, const struct dead_load_line line[3],
                          double *f)
{
    const size_t n[3] = {(size_t)line[0].n, (size_t)line[1].n, (size_t)line[2].n};
    double *mean[3], *work, *all = malloc(2 * (n[0] + n[1] + n[2]) * sizeof *all);

    if (!all)
        return STATUS_MEMORY;
    mean[0] = all, mean[1] = mean[0] + n[0], mean[2] = mean[1] + n[1];
    work = mean[2] + n[2];
    for (int l = 0; l < scene->load_count; l++) {
        const struct scene_load *load = &scene->loads[l];
        double *to = f;
        for (int d = 0; d < 3; d++)
            line_means(&line[d], load->lo[d], load->hi[d], mean[d], work);
        for (size_t a = 0; a < n[0] * n[1] * n[2]; a++, to += 3) {
            double share =
                mean[0][a / (n[1] * n[2])] * mean[1][a / n[2] % n[1]] * mean[2][a % n[2]];
            for (int i = 0; i < 3; i++)
                to[i] += share * load->force[i];
        }
    }
    free(all);
    return STATUS_OK;
}

enum status dead_load_make(const struct scene *scene, const struct dead_load_line line[3],
                           double **dead, double *load)
{
    const size_t count = 3 * (size_t)line[0].n * (size_t)line[1].n * (size_t)line[2].n;

    if (!scene->load_count)
        return STATUS_OK;
    if (!(*dead = calloc(count, sizeof **dead)))
        return STATUS_MEMORY;
    enum status st = dead_load_add(scene, line, *dead);
    for (size_t t = 0; t < count; t++)
        load[t] += (*dead)[t];
    return st;
}
