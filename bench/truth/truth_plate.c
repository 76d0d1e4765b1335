#include "bench/truth/truth_plate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fem_ref/elastica.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

void truth_plate_clear(struct truth_plate *t)
{
    free(t->xyz[0]);
    free(t->rest);
    memset(t, 0, sizeof *t);
}

enum status truth_plate_fields(const struct scene *scene, int times, const double *time,
                               double *const *xyz, struct message *why)
{
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    enum status st;

    TRY(kirchhoff_field_plate(scene, &plate, why));
    TRY(kirchhoff_create(&plate, KIRCHHOFF_TERMS, &k));
    for (int n = 0; n < times; n++)
        TRY(kirchhoff_field_sample(k, scene, time[n], xyz[n], why));
out:
    kirchhoff_destroy(k);
    return st;
}

enum status truth_plate_init(struct truth_plate *t, const struct scene *scene, int times,
                             const double *time, struct message *why)
{
    const size_t field = 3 * GRID_POINTS;
    double at[TRUTH_PLATE_TIMES + 1];
    enum status st;

    *t = (struct truth_plate){.times = times,
                              .rest = metric_rest_field(scene),
                              .thickness_ratio = scene->thickness / scene->length,
                              .gamma = scene_gamma(scene)};
    t->xyz[0] = malloc(((size_t)times + 1) * field * sizeof(double));
    TRY(t->rest && t->xyz[0] ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n <= times; n++) {
        t->xyz[n] = t->xyz[0] + (size_t)n * field;
        at[n] = n < times ? time[n] : INFINITY;
    }
    TRY(truth_plate_fields(scene, times + 1, at, t->xyz, why));
out:
    if (st != STATUS_OK)
        truth_plate_clear(t);
    return st;
}

double truth_plate_edge(const double *xyz, const double *rest)
{
    double sum = 0;

    for (int k = 0; k < GRID_W; k++)
        for (int j = GRID_V / 2 - 1; j <= GRID_V / 2; j++) {
            const int n = ((k * GRID_V + j) * GRID_U + GRID_U - 1) * 3 + 2;
            sum += xyz[n] - (rest ? rest[n] : 0);
        }
    return sum / 4;
}

double truth_plate_drop(const struct scene *scene, bool linear)
{
    enum { TERMS = 24 }; /* six digits */
    const double L = scene->length, W = scene->width, gamma = scene_gamma(scene);
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    struct elastica e;
    double drop = NAN;

    if (kirchhoff_field_plate(scene, &plate, NULL) != STATUS_OK)
        return NAN;
    if (!linear)
        return elastica_solve(gamma, &e) == STATUS_OK ? e.drop : NAN;
    if (kirchhoff_create(&plate, TERMS, &k) == STATUS_OK)
        drop = kirchhoff_static(k, gamma * scene_bending_stiffness(scene) / (L * L * L), L,
                                W / 2) /
               L;
    kirchhoff_destroy(k);
    return drop;
}

enum status truth_plate_coefficient(double nu, int terms, double *coefficient)
{
    const struct kirchhoff_plate plate = {.length = 1,
                                          .width = 1,
                                          .thickness = 1,
                                          .young = 12 * (1 - nu * nu),
                                          .poisson = nu,
                                          .density = 1}; /* D = 1 */
    struct kirchhoff *k = NULL;
    const enum status st = kirchhoff_create(&plate, terms, &k);

    if (st == STATUS_OK)
        *coefficient = kirchhoff_static(k, 1, 1, 0.5);
    kirchhoff_destroy(k);
    return st;
}
