#include "bench/tables/table1_truth.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/metric/metric.h"

void table1_truth_clear(struct table1_truth *t)
{
    if (!t)
        return;
    for (int n = 0; n <= TABLE1_TIMES; n++)
        free(t->xyz[n]);
    free(t->rest);
    memset(t, 0, sizeof *t);
}

enum status table1_truth_init(struct table1_truth *t, const struct scene *scene,
                              struct message *why)
{
    enum status st;
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    struct table1_truth new = {.thickness_ratio = scene->thickness / scene->length,
                               .gamma = scene_gamma(scene)};

    TRY(kirchhoff_field_plate(scene, &plate, why));
    TRY(kirchhoff_create(&plate, KIRCHHOFF_TERMS, &k));
    new.rest = malloc(3 * GRID_POINTS * sizeof *new.rest);
    if (!new.rest)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, new.rest + 3 * n);
    }
    for (int n = 0; n <= TABLE1_TIMES; n++) {
        new.xyz[n] = malloc(3 * GRID_POINTS * sizeof *new.xyz[n]);
        if (!new.xyz[n])
            TRY(STATUS_MEMORY);
        TRY(kirchhoff_field_sample(k, scene, n < TABLE1_TIMES ? table1_time[n] : INFINITY,
                                   new.xyz[n], why));
    }
    *t = new;
    memset(&new, 0, sizeof new);
out:
    table1_truth_clear(&new);
    kirchhoff_destroy(k);
    return st;
}

double table1_truth_error(const struct table1_truth *t, int time, const double *xyz)
{
    return metric_rmse(xyz, t->xyz[time]) / metric_rmse(t->xyz[time], t->rest);
}

/* Displacement along z of the two grid points nearest the middle of the free edge, either
 * side, both layers. */
static double tip(const double *xyz, const double *rest)
{
    double sum = 0;

    for (int k = 0; k < GRID_W; k++)
        for (int j = GRID_V / 2 - 1; j <= GRID_V / 2; j++) {
            int n = ((k * GRID_V + j) * GRID_U + GRID_U - 1) * 3 + 2;
            sum += xyz[n] - rest[n];
        }
    return sum / 4;
}

double table1_truth_tip(const struct table1_truth *t, const double *xyz)
{
    return tip(xyz, t->rest) / tip(t->xyz[TABLE1_TIMES], t->rest);
}
