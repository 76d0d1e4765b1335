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

/* Computes the range [lo, hi] along u as s of a sheet; returns its length, which is 1 for a
 * line on that sheet. */
static double part_on(const struct scene *scene, int sheet, double lo, double hi,
                      double s[2])
{
    const double from = scene_sheet_u(scene, sheet, 0), to = scene_sheet_u(scene, sheet, 1);

    if (!(hi > lo)) {
        const bool on = scene_sheet_at(scene, lo, &s[0]) == sheet;
        s[1] = s[0];
        return on;
    }
    s[0] = fmin(fmax((lo - from) / (to - from), 0), 1);
    s[1] = fmin(fmax((hi - from) / (to - from), 0), 1);
    return s[1] - s[0];
}

/* Adds `force` [N] to one sheet's nodes, by the means of the functions there. */
static void add_sheet(const struct dead_load_line line[3], double *const mean[3],
                      const double force[3], double *f)
{
    const size_t n[3] = {(size_t)line[0].n, (size_t)line[1].n, (size_t)line[2].n};

    for (size_t a = 0; a < n[0] * n[1] * n[2]; a++, f += 3) {
        double share =
            mean[0][a / (n[1] * n[2])] * mean[1][a / n[2] % n[1]] * mean[2][a % n[2]];
        for (int i = 0; i < 3; i++)
            f[i] += share * force[i];
    }
}

/* Adds a load; work: as for line_means. */
static void add_load(const struct scene *scene, const struct scene_load *load,
                     const struct dead_load_line line[3], double *const mean[3],
                     double *work, double *f)
{
    const size_t count = 3 * (size_t)line[0].n * (size_t)line[1].n * (size_t)line[2].n;
    double whole = 0, s[2], force[3];

    for (int d = 1; d < 3; d++)
        line_means(&line[d], load->lo[d], load->hi[d], mean[d], work);
    for (int k = 0; k < scene_sheets(scene); k++)
        whole += part_on(scene, k, load->lo[0], load->hi[0], s);
    for (int k = 0; k < scene_sheets(scene); k++, f += count) {
        const double part = part_on(scene, k, load->lo[0], load->hi[0], s);
        if (part == 0)
            continue;
        line_means(&line[0], s[0], s[1], mean[0], work);
        for (int i = 0; i < 3; i++)
            force[i] = part / whole * load->force[i];
        add_sheet(line, mean, force, f);
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
    for (int l = 0; l < scene->load_count; l++)
        add_load(scene, &scene->loads[l], line, mean, work, f);
    free(all);
    return STATUS_OK;
}

enum status dead_load_make(const struct scene *scene, const struct dead_load_line line[3],
                           double **dead, double *load)
{
    const size_t count = 3 * (size_t)scene_sheets(scene) * (size_t)line[0].n *
                         (size_t)line[1].n * (size_t)line[2].n;

    if (!scene->load_count)
        return STATUS_OK;
    if (!(*dead = calloc(count, sizeof **dead)))
        return STATUS_MEMORY;
    enum status st = dead_load_add(scene, line, *dead);
    for (size_t t = 0; t < count; t++)
        load[t] += (*dead)[t];
    return st;
}
