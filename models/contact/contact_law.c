#include "models/contact/contact_law.h"

#include <math.h>

#include "models/vector.h"

/* The height to which a sheet leaps that leaves a body at the speed of rebound, over its
 * length; the speed of creep, over that of the scene. */
static const double LEAP = 5e-6, CREEP = 1e-3;

static const double PI = 3.14159265358979323846;

/* Returns the greatest speed along the path, and by the turn so far from its axis [m/s]. */
static double fastest(const struct scene_motion *m, double arm)
{
    double most = 0, turns = 0;

    for (int n = 1; n < m->turn_count; n++)
        turns = fmax(turns, fabs(m->turn[n][1] - m->turn[n - 1][1]) /
                                (m->turn[n][0] - m->turn[n - 1][0]));

    for (int n = 1; n < m->path_count; n++) {
        double way[3];
        vector_between(m->path[n - 1] + 1, m->path[n] + 1, way);
        most = fmax(most, vector_length(way) / (m->path[n][0] - m->path[n - 1][0]));
    }
    return most + arm * turns * PI / 180;
}

/* Returns the fastest speed that the scene gives: of the sheet at the start, a support, a
 * body, or the wind [m/s]. */
static double given_speed(const struct scene *s)
{
    const double L = s->length;
    double most =
        vector_length(s->velocity) + L * vector_length(s->spin) + vector_length(s->ripple);

    for (int n = 0; n < s->support_count; n++)
        most = fmax(most, fastest(&s->supports[n].motion, L));
    for (int o = 0; o < s->obstacle_count; o++)
        most = fmax(most, fastest(&s->obstacles[o].motion, L));
    return fmax(most, scene_wind_speed(s));
}

double contact_law_speed(const struct scene *s)
{
    const double g = vector_length(s->gravity), given = given_speed(s), L = s->length;
    double load = fabs(s->pressure);

    if (g > 0 || given > 0)
        return g > 0 ? sqrt(g * L) : given;
    for (int n = 0; n < s->load_count; n++)
        load = fmax(load, vector_length(s->loads[n].force) / (L * s->width));
    return sqrt(load * L / (s->density * s->thickness));
}

/* Returns the energy per area of a sheet that contact has to stop [J/m^2]: of a fall
 * through the sheet's length, of its speed at the start, or that of a body; and, for sheets
 * without weight, of bending to a circle. */
static double energy_to_stop(const struct scene *s)
{
    const double areal = s->density * s->thickness, round = 2 * PI / s->length;
    double v = vector_length(s->velocity);

    for (int o = 0; o < s->obstacle_count; o++)
        v = fmax(v, vector_length(s->velocity) + fastest(&s->obstacles[o].motion, 0));
    return areal * (vector_length(s->gravity) * s->length + v * v / 2) +
           scene_bending_stiffness(s) * round * round / 2;
}

/* Returns the largest of all sheets. */
static double most_to_stop(const struct scene *scene)
{
    double most = 0;

    for (int k = 0; k < scene_sheets(scene); k++) {
        const struct scene one = scene_sheet(scene, k);
        most = fmax(most, energy_to_stop(&one));
    }
    return most;
}

struct contact_law contact_law_self(const struct scene *scene)
{
    const struct scene_contact *c = &scene->contact;
    const double t = c->thickness > 0 ? c->thickness : scene->thickness;
    const double speed = contact_law_speed(scene), U = speed > 0 ? speed : INFINITY;

    return (struct contact_law){.start = t,
                                .range = c->range > 0 ? c->range : t / 2,
                                .stiffness = c->stiffness > 0 ? c->stiffness
                                                              : 4 * most_to_stop(scene) / t,
                                .rebound = 2 * sqrt(2 * LEAP) * U,
                                .creep = CREEP * U};
}

struct contact_law contact_law_body(const struct scene *scene)
{
    struct contact_law law = contact_law_self(scene);

    law.start /= 2, law.range /= 2, law.rebound /= 2;
    return law;
}

static double wall(const struct contact_law *law)
{
    return law->start - law->range;
}

double contact_law_pressure(const struct contact_law *law, double D, double *slope)
{
    const double x = (D - wall(law)) / law->range, y = fmax(x, CONTACT_LAW_FLOOR);

    if (!(x < 1)) { /* also NaN */
        if (slope)
            *slope = x - x;
        return x - x == 0 ? 0 : x;
    }
    const double steep = 2 * law->stiffness / law->range * (1 - y) / (y * y * y);
    if (slope)
        *slope = steep;
    return law->stiffness * (1 / y - 1) * (1 / y - 1) + steep * (y - x) * law->range;
}

double contact_law_potential(const struct contact_law *law, double D)
{
    const double x = (D - wall(law)) / law->range, y = fmax(x, CONTACT_LAW_FLOOR);
    double slope;

    if (!(x < 1))
        return x - x;
    const double p = contact_law_pressure(law, wall(law) + y * law->range, &slope);
    const double below = (y - x) * law->range;
    return law->stiffness * law->range * (1 / y - y + 2 * log(y)) + p * below +
           slope * below * below / 2;
}

double contact_law_distance(const struct contact_law *law, double p)
{
    return wall(law) + law->range / (1 + sqrt(p / law->stiffness));
}

double contact_law_weight(const struct scene *scene)
{
    return scene->density * scene->thickness * vector_length(scene->gravity);
}

double contact_law_edge(const struct contact_law *law, double bending, double pressure)
{
    double slope;

    contact_law_pressure(law, contact_law_distance(law, pressure), &slope);
    return pow(4 * bending / slope, 0.25);
}

double contact_law_push(const struct contact_law *law, double D, double D_old, double dt,
                        double *slope)
{
    double steep;
    const double p = contact_law_pressure(law, D, &steep);
    const double share = 1 - (D - D_old) / (dt * law->rebound);

    if (slope)
        *slope = share > 0 ? share * steep + p / (dt * law->rebound) : 0;
    return share > 0 ? share * p : 0;
}

/* The force falls as the distance grows, so that there is one solution; Newton's method
 * within what is known to hold it. */
double contact_law_solve(const struct contact_law *law, double D, double D_old, double dt,
                         double area, double compliance)
{
    enum { MOST = 100 };
    static const double CLOSE = 1e-14; /* relative to the range */
    double low = D, high = fmax(law->start, D), at = fmin(fmax(D_old, low), high);

    if (!(D < law->start))
        return 0;
    for (int n = 0; n < MOST && high - low > CLOSE * law->range; n++) {
        double slope, p = contact_law_push(law, at, D_old, dt, &slope);
        double off = at - D - compliance * area * p;
        if (off > 0)
            high = at;
        else
            low = at;
        double next = at - off / (1 + compliance * area * slope);
        if (fabs(next - at) <= CLOSE * law->range)
            break;
        at = next > low && next < high ? next : (low + high) / 2;
    }
    return area * contact_law_push(law, at, D_old, dt, NULL);
}

double contact_law_friction(const struct contact_law *law, double slip, double dt)
{
    const double y = slip / (law->creep * dt);

    return y < 1 ? y * (2 - y) : 1;
}

double contact_law_hold(const struct contact_law *law, double slip, double dt, double most)
{
    const double unit = law->creep * dt, S = slip / unit, q = most / unit;

    if (S >= 1 + q)
        return 1;
    /* y = S - q (2 y - y^2) */
    const double b = 1 + 2 * q, y = 2 * S / (b + sqrt(b * b - 4 * q * S));
    return y * (2 - y);
}
