#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/truth.h"
#include "fem_ref/elastica.h"
#include "fem_ref/kirchhoff.h"
#include "models/damping.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "models/vector.h"

/* The rounding of a sum of a few terms, over the terms. */
static const double ROUND_OFF = 16 * DBL_EPSILON;

/* The factor on exp(-rate t), the rate being that of the slowest mode as estimated; more
 * motion left than a thousandth is no rest. */
static const double LEFT = 10, MOST_LEFT = 1e-3;

/* --- fall --- */

static bool falls(const struct scene *s)
{
    const bool rate = s->damping.kind == DAMPING_NONE || s->damping.kind == DAMPING_MASS;

    return rate && s->sheets < 2 && !s->support_count && !s->load_count &&
           !s->obstacle_count && vector_length(s->spin) == 0 && !scene_ripples(s) &&
           s->air.density == 0;
}

/* Returns (exp(-x) - 1 + x) / x^2, x >= 0. */
static double second(double x)
{
    double sum = 0, term = 0.5;

    if (x > 1)
        return (expm1(-x) + x) / (x * x);
    for (int n = 3; n < 24; n++) {
        sum += term;
        term *= -x / n;
    }
    return sum;
}

/* Solves x'' = a - k x' from the velocity of the scene: how far at t. */
static void fall_shift(const struct scene *s, double t, double shift[3])
{
    const double drag = damping_drag(s), k = drag + damping_mass(s), x = k * t;
    const double first = x > 0 ? -expm1(-x) / x : 1;

    for (int c = 0; c < 3; c++) {
        const double a = s->gravity[c] + drag * s->wind[c];
        shift[c] = s->velocity[c] * t * first + a * t * t * second(x);
    }
}

static void fall_field(const struct scene *s, const double *rest, double t, double *xyz,
                       double *error)
{
    double shift[3];

    fall_shift(s, t, shift);
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        xyz[n] = rest[n] + shift[n % 3];
    *error = ROUND_OFF *
             (vector_length(s->origin) + s->length + s->width + vector_length(shift));
}

/* --- at rest --- */

/* Returns the direction in which gravity pulls along an axis, +1 or -1; 0: not along it
 * alone. */
static double pull(const struct scene *s, const double axis[3])
{
    const double along = vector_dot(s->gravity, axis), all = vector_length(s->gravity);

    return all > 0 && fabs(along) >= (1 - 1e-12) * all ? copysign(1, along) : 0;
}

/* Tells whether no strain along u comes with one across, nor with shear. */
static bool is_uncoupled(const struct scene *s)
{
    const struct law law = scene_law(s);

    for (int part = 0; part < LAW_PARTS; part++)
        if (law.matrix[part][LAW_12] != 0 || law.matrix[part][LAW_13] != 0)
            return false;
    return !law.softens;
}

static bool rests(const struct scene *s)
{
    return s->shape == SCENE_FLAT && is_uncoupled(s) && scene_is_cantilever(s) &&
           !s->load_count && !s->obstacle_count && s->drag == 0 && s->air.density == 0;
}

/* Returns what is left at t of a motion by x'' + alpha x' + omega^2 x = 0. */
static double left(double alpha, double omega, double t)
{
    const double half = alpha / 2, root = half * half - omega * omega;

    return LEFT * exp(-(half - (root > 0 ? sqrt(root) : 0)) * t);
}

/* Returns E along u [Pa]. */
static double young(const struct scene *s)
{
    return s->is_fabric ? scene_law(s).matrix[LAW_MEMBRANE][LAW_11] / s->thickness
                        : s->young;
}

/* Returns weight against stiffness, rho g L / E. */
static double strain(const struct scene *s)
{
    return s->density * vector_length(s->gravity) * s->length / young(s);
}

/* Returns the stretch l under the nominal stress q E: l (l^2 - 1) / 2 = q. */
static double stretch(double q)
{
    double l = 1 + q;

    for (int n = 0; n < 60; n++) /* Newton, convex: from above, to the last digit */
        l -= (l * (l * l - 1) / 2 - q) / ((3 * l * l - 1) / 2);
    return l;
}

/* Returns the integral of l dq. */
static double primitive(double l)
{
    return l * l * (3 * l * l / 8 - 0.25);
}

/* Return where the point s hangs, over L: by St. Venant and Kirchhoff; by Hooke's law on
 * lengths. */
static double hang(double e, double s)
{
    return (primitive(stretch(e)) - primitive(stretch(e * (1 - s)))) / e;
}

static double hang_linear(double e, double s)
{
    return s + e * (s - s * s / 2);
}

static double hang_field(const struct scene *s, const double *rest, double *xyz)
{
    const double e = strain(s);
    double sum = 0;

    for (int i = 0; i < GRID_U; i++) {
        const double u = (double)i / (GRID_U - 1), at = hang(e, u);
        const double apart = at - hang_linear(e, u);
        sum += apart * apart / GRID_U;
        for (int n = i; n < GRID_POINTS; n += GRID_U)
            for (int c = 0; c < 3; c++)
                xyz[3 * n + c] = rest[3 * n + c] + s->length * (at - u) * s->axis_u[c];
    }
    return s->length * sqrt(sum);
}

/* Fills a field bent about e_v, whose points stay on the normals of the middle surface; the
 * error bar. */
static double elastica_field(const struct scene *s, double down, double *xyz)
{
    const double slender = s->thickness / s->length;
    struct elastica_point at[GRID_U];
    double u[GRID_U], e_w[3];

    for (int i = 0; i < GRID_U; i++)
        u[i] = (double)i / (GRID_U - 1);
    if (elastica_curve(scene_gamma(s), GRID_U, u, at) != STATUS_OK)
        return INFINITY;
    scene_normal(s, e_w);
    for (int n = 0; n < GRID_POINTS; n++) {
        const struct elastica_point *p = &at[n % GRID_U];
        double uvw[3];
        grid_point(n, uvw);
        const double z = (uvw[2] - 0.5) * s->thickness;
        const double out = s->length * p->reach - down * z * sin(p->angle);
        const double off = down * s->length * p->drop + z * cos(p->angle);
        for (int c = 0; c < 3; c++)
            xyz[3 * n + c] = s->origin[c] + out * s->axis_u[c] +
                             uvw[1] * s->width * s->axis_v[c] + off * e_w[c];
    }
    /* The elastica neither stretches (weight rho g L: half of that strain at the tip) nor
     * shears (6/5 of it). */
    return s->length * (1e-10 + 0.2 * scene_gamma(s) * slender * slender);
}

struct rest_shape {
    double bar;   /* error bar [m]; INFINITY: it is none of these                      */
    double omega; /* estimate of the lowest frequency [rad/s]                          */
    const char *source;
};

static struct rest_shape rest_shape(const struct scene *s, const double *rest, double *xyz)
{
    const double g = vector_length(s->gravity), L = s->length;
    double e_w[3];

    scene_normal(s, e_w);
    if (pull(s, s->axis_u) > 0)
        return (struct rest_shape){
            .bar = hang_field(s, rest, xyz),
            .omega = acos(0) * sqrt(young(s) / s->density) / L,
            .source =
                "at rest: a bar under its own weight, St. Venant-Kirchhoff, in closed "
                "form; error bar: how far Hooke's law on lengths is from that"};
    if (pull(s, e_w) !=
        0) /* a strip that bends, and a chain that hangs (both: Southwell) */
        return (struct rest_shape){
            .bar = elastica_field(s, pull(s, e_w), xyz),
            .omega = sqrt(12.36 * g / (scene_gamma(s) * L) + 1.446 * g / L),
            .source = "at rest: the heavy elastica, solved to 1e-10; error bar: what it "
                      "leaves out, stretch and shear, of the order of Gamma (h / L)^2"};
    return (struct rest_shape){.bar = INFINITY};
}

static enum status at_rest(const struct scene *s, const double *rest, struct truth *t)
{
    const struct rest_shape shape = rest_shape(s, rest, t->xyz[0]);
    const double way = metric_rmse(t->xyz[0], rest);

    if (!(shape.bar <= TRUTH_MOST_ERROR * s->length))
        return STATUS_UNSUPPORTED;
    for (int n = 0; n < t->times; n++) {
        const double share = left(damping_mass(s), shape.omega, t->time[n]);
        if (!(share <= MOST_LEFT))
            return STATUS_UNSUPPORTED;
        t->error[n] = shape.bar + share * way;
        if (n)
            memcpy(t->xyz[n], t->xyz[0], 3 * GRID_POINTS * sizeof(double));
    }
    snprintf(t->source, sizeof t->source, "%s", shape.source);
    return STATUS_OK;
}

enum status truth_closed_fields(const struct scene *scene, struct truth *t)
{
    enum status st = STATUS_OK;
    double *rest SCOPED(scope_free) = NULL;

    if (t->times < 1 || (!falls(scene) && !rests(scene)))
        return STATUS_UNSUPPORTED;
    rest = metric_rest_field(scene);
    if (!rest)
        return STATUS_MEMORY;
    if (rests(scene))
        st = at_rest(scene, rest, t);
    for (int n = 0; falls(scene) && n < t->times; n++)
        fall_field(scene, rest, t->time[n], t->xyz[n], &t->error[n]);
    if (falls(scene))
        snprintf(t->source, sizeof t->source,
                 "closed form: what nothing holds falls as one body; error bar: round-off");
    return st;
}

enum status truth_closed_make(const struct scene *s, struct truth *t)
{
    struct arena own = {0};
    double *time = arena_take(&own, (size_t)s->snapshot_count + 1, sizeof *time);
    enum status st;
    int count = 0;

    *t = (struct truth){0};
    TRY(!s->pattern && (falls(s) || rests(s)) ? STATUS_OK : STATUS_UNSUPPORTED);
    for (int n = 0; n < s->snapshot_count && falls(s); n++)
        if (s->snapshots[n] > 0)
            time[count++] = s->snapshots[n];
    if (!count || time[count - 1] < s->end)
        time[count++] = s->end;
    truth_init(t, count, count, time);
    TRY(truth_closed_fields(s, t));
    t->closed = true;
    for (int n = 0; n < count; n++)
        for (int c = 0; c < TRUTH_STORED; c++)
            t->value[n][c] = NAN;
    snprintf(t->horizon, sizeof t->horizon, "%s",
             falls(s) ? "none: it is known for ever"
                      : "it is known once it has come to rest, however it was damped");
out:
    if (st != STATUS_OK)
        truth_clear(t);
    arena_clear(&own);
    return st;
}

/* --- The plate --- */

double truth_plate_edge(const double *xyz)
{
    double sum = 0;

    for (int k = 0; k < GRID_W; k++)
        for (int j = GRID_V / 2 - 1; j <= GRID_V / 2; j++)
            sum += xyz[((k * GRID_V + j) * GRID_U + GRID_U - 1) * 3 + 2];
    return sum / 4;
}

double truth_plate_drop(const struct scene *scene, bool linear)
{
    enum { TERMS = 24 }; /* six digits */
    const double L = scene->length, W = scene->width, gamma = scene_gamma(scene);
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    struct elastica_point e;
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
