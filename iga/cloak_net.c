/* Coefficient i of a polynomial in a B-spline space is its blossom at the p knots after
 * knot i (Ramshaw 1989): of 1, v and v^2 these are 1, the mean of the knots (Greville's
 * abscissa), and the mean of the products of two of them. */
#include "iga/cloak_net.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

bool cloak_net_exact(const struct bspline *v)
{
    return v->p >= 2 && !v->wrap;
}

static double square_coefficient(const struct bspline *b, int i)
{
    double sum = 0;

    for (int j = 1; j <= b->p; j++)
        for (int k = 1; k < j; k++)
            sum += b->U[i + j] * b->U[i + k];
    return 2 * sum / (b->p * (b->p - 1));
}

/* Computes coefficients of 2 s, 1 - s^2 and 1 + s^2, where s = (2 v - 1) tan(alpha/4): the
 * arc in homogeneous coordinates. Of a closed basis: those of the sine, the cosine and 1,
 * on a circle that the spline of even knots reduces to radius 1. */
static void arc(const struct scene *scene, const struct bspline *b, int i, double out[3])
{
    double t = scene_cloak_quarter_tangent(scene), v = bspline_greville(b, i);
    double squared = cloak_net_exact(b) ? square_coefficient(b, i) : v * v;
    double ss = t * t * (4 * squared - 4 * v + 1);

    if (b->wrap) {
        const double half = PI / bspline_points(b);
        const double radius = pow(half / sin(half), b->p + 1), phi = PI * (2 * v - 1);
        out[0] = radius * sin(phi), out[1] = radius * cos(phi), out[2] = 1;
        return;
    }
    out[0] = 2 * t * (2 * v - 1);
    out[1] = 1 - ss;
    out[2] = 1 + ss;
}

enum status cloak_net(const struct scene *scene, const struct bspline *u,
                      const struct bspline *v, int layers, const double *w, double *point,
                      double *weight, struct message *why)
{
    for (int i = 0; i < u->n; i++)
        for (int j = 0; j < bspline_points(v); j++) {
            double a[3], r, z;

            arc(scene, v, j, a);
            if (!(a[2] > 0))
                return status_fail(why, STATUS_INPUT,
                                   "an opening of %g degrees needs more than %d points "
                                   "along v: a weight would not be positive",
                                   scene->opening, v->n);
            for (int k = 0; k < layers; k++, point += 3) {
                scene_cloak_meridian(scene, bspline_greville(u, i), w[k], &r, &z);
                scene_cloak_place(scene, z, r * a[0] / a[2], r * a[1] / a[2], point);
                *weight++ = cloak_net_exact(v) ? a[2] : 1;
            }
        }
    return STATUS_OK;
}
