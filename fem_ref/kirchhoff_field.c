#include "fem_ref/kirchhoff_field.h"
#include "models/grid.h"
#include "models/vector.h"

#include <math.h>

enum status kirchhoff_field_plate(const struct scene *scene, struct kirchhoff_plate *plate,
                                  struct message *why)
{
    /* The rounding of axes given with 16 digits. */
    const double in_plane = 1e-14 * sqrt(vector_dot(scene->gravity, scene->gravity));

    if (scene->shape != SCENE_FLAT)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth knows flat sheets only");
    if (!scene_is_cantilever(scene))
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "the Kirchhoff truth knows one sheet with one support, the whole "
            "edge u = 0");
    if (fabs(vector_dot(scene->gravity, scene->axis_u)) > in_plane ||
        fabs(vector_dot(scene->gravity, scene->axis_v)) > in_plane)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth needs gravity normal to the sheet");
    if (scene->obstacle_count || scene->load_count || scene->drag != 0)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth knows no obstacles, no loads and no drag");
    if (scene_needs(scene) & SCENE_NEED_INITIAL_MOTION)
        return status_fail(why, STATUS_UNSUPPORTED, "the Kirchhoff truth begins at rest");
    if (scene->damping.kind != DAMPING_NONE && scene->damping.kind != DAMPING_MASS)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth knows mass damping only");
    if (scene->is_fabric)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth is of isotropic sheets");
    if (scene->poisson < 0)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth is verified for 0 <= nu < 0.5 only");
    *plate = (struct kirchhoff_plate){.length = scene->length,
                                      .width = scene->width,
                                      .thickness = scene->thickness,
                                      .young = scene->young,
                                      .poisson = scene->poisson,
                                      .density = scene->density};
    return STATUS_OK;
}

static enum status sample(const struct kirchhoff *k, const struct scene *scene, double t,
                          double *xyz)
{
    enum status st;
    static const double half[GRID_W] = {-0.5, 0.5};
    double w[GRID_V][GRID_U], wx[GRID_V][GRID_U], wy[GRID_V][GRID_U]; /* 240 kB */
    double x[GRID_U], y[GRID_V], n[3];

    scene_normal(scene, n);
    const double q = scene->density * scene->thickness * vector_dot(scene->gravity, n);
    const double alpha = scene->damping.kind == DAMPING_MASS ? scene->damping.value : 0;
    for (int i = 0; i < GRID_U; i++)
        x[i] = scene->length * i / (GRID_U - 1);
    for (int j = 0; j < GRID_V; j++)
        y[j] = scene->width * j / (GRID_V - 1);
    TRY(kirchhoff_grid(k, q, alpha, t, GRID_U, x, GRID_V, y, w[0], wx[0], wy[0]));
    for (int p = 0; p < GRID_POINTS; p++) {
        int i = p % GRID_U, j = p / GRID_U % GRID_V;
        double uvw[3], z = half[p / (GRID_U * GRID_V)] * scene->thickness;
        grid_point(p, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * p);
        for (int c = 0; c < 3; c++)
            xyz[3 * p + c] += w[j][i] * n[c] - z * (wx[j][i] * scene->axis_u[c] +
                                                    wy[j][i] * scene->axis_v[c]);
    }
out:
    return st;
}

enum status kirchhoff_field(const struct scene *scene, int terms, int times,
                            const double *time, double *const *xyz, struct message *why)
{
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    enum status st;

    TRY(kirchhoff_field_plate(scene, &plate, why));
    TRY(kirchhoff_create(&plate, terms, &k));
    for (int n = 0; n < times; n++)
        TRY(sample(k, scene, time[n], xyz[n]));
out:
    kirchhoff_destroy(k);
    return st;
}
