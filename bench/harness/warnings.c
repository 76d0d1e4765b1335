#include "bench/harness/warnings.h"

#include <math.h>
#include <string.h>

#include "bench/harness/net_fit.h"
#include "iga/support_knots.h"

/* Bounds: span over thickness from which degree 2 loses a tenth; thickness over side; share
 * of a swing lost in a second; span over the length that a clamp bends. */
static const double long_span = 20, thick = 0.1, swing_lost = 0.01, bends = 4;

static bool is_solid(const struct run *r)
{
    return r->contestant->layers > 0;
}

/* Returns whether the model consists of springs and constraints between points. */
static bool is_net(const struct run *r)
{
    return !is_solid(r) && r->discretization.degree[0] == 1;
}

static int in_plane_degree(const struct run *r)
{
    const int *degree = r->discretization.degree;

    return degree[0] < degree[1] ? degree[0] : degree[1];
}

static bool is_cured(const struct run *r)
{
    return !is_solid(r) || r->discretization.remedy != REMEDY_NONE;
}

/* Degree 1 locks: a layer's strain through the thickness is constant, where bending needs
 * it linear; plane stress has (1 - 2 nu) / (1 - nu)^2 of its stiffness. */
static bool thickness_locks(const struct run *r, struct message *sentence)
{
    const double nu = r->scene.poisson, layers = r->discretization.points[2] - 1;
    const double excess = ((1 - nu) * (1 - nu) / (1 - 2 * nu) - 1) / (layers * layers);

    if (is_cured(r) || r->discretization.degree[2] != 1 || nu == 0)
        return false;
    status_fail(
        sentence, STATUS_OK,
        "degree 1 through the thickness with remedy=none and nu = %g: up to %.2g %% "
        "too stiff in bending, on any net",
        nu, 100 * excess);
    return true;
}

static bool degree_1_locks(const struct run *r, struct message *sentence)
{
    if (is_cured(r) || in_plane_degree(r) != 1)
        return false;
    status_fail(
        sentence, STATUS_OK,
        "degree 1 with remedy=none locks in shear: 10x10x2 hexahedra keep 0.02 %% of "
        "a tip at h/L = 1e-3, 32x32x2 keep 0.3 %%");
    return true;
}

/* Returns the longest span of a direction of degree 2, in thicknesses. */
static double quadratic_span(const struct run *r)
{
    const struct discretization *d = &r->discretization;
    const double side[] = {r->scene.length, r->scene.width};
    double most = 0;

    for (int i = 0; i < 2; i++)
        if (d->degree[i] == 2)
            most = fmax(most, side[i] / (d->points[i] - 2) / r->scene.thickness);
    return most;
}

static bool degree_2_locks(const struct run *r, struct message *sentence)
{
    const double span = quadratic_span(r);

    if (is_cured(r) || !(span > long_span))
        return false;
    status_fail(sentence, STATUS_OK,
                "degree 2 with remedy=none locks in shear where spans are longer than %g "
                "thicknesses, here %.3g: at 125 it keeps 68 %% of a tip",
                long_span, span);
    return true;
}

static bool strain_is_small(const struct run *r, struct message *sentence)
{
    const double gamma = scene_gamma(&r->scene);

    if (r->discretization.kinematics != KINEMATICS_LINEAR ||
        !(gamma > SCENE_GAMMA_ONE_PERCENT))
        return false;
    status_fail(
        sentence, STATUS_OK,
        "small-strain theory misses a cantilever's tip by more than %s at this Gamma",
        gamma > SCENE_GAMMA_TEN_PERCENT ? "10 %" : "1 %");
    return true;
}

static bool is_viscous(const struct run *r, struct message *sentence)
{
    if (r->discretization.kinematics != KINEMATICS_PRINTED)
        return false;
    status_fail(sentence, STATUS_OK,
                "kinematics=printed is a viscous sheet without elastic memory: its "
                "viscosity is E dt = %.3g Pa s, and changes with the step",
                r->scene.young * r->scene.step);
    return true;
}

static bool is_thick(const struct run *r, struct message *sentence)
{
    const struct scene *s = &r->scene;
    const double ratio = s->thickness / fmin(s->length, s->width);

    if (is_solid(r) || ratio < thick * (1 - 1e-9))
        return false;
    status_fail(
        sentence, STATUS_OK,
        "a model of the mid-surface leaves shear through the thickness out: 2 %% of "
        "a tip at h/L = 0.1, here %.2g",
        ratio);
    return true;
}

/* Backward Euler damps: amplitudes shrink by (1 + omega^2 dt^2)^(-1/2) a step; a sheet
 * swings as a rod, omega^2 = 3/2 g / L. */
static bool swings_less(const struct run *r, struct message *sentence)
{
    const double *g = r->scene.gravity;
    const int pieces = r->discretization.substeps > 0 ? r->discretization.substeps : 1;
    const double omega2 =
                     1.5 * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / r->scene.length,
                 lost = omega2 * r->scene.step / pieces / 2;

    if (!is_net(r) || r->discretization.integrator != INTEGRATOR_IMPLICIT ||
        !(lost > swing_lost))
        return false;
    status_fail(
        sentence, STATUS_OK,
        "backward Euler takes %.2g %% of a swing in every second at this step, half "
        "of that at half the step",
        100 * lost);
    return true;
}

static bool damping_is_no_rate(const struct run *r, struct message *sentence)
{
    const struct scene_damping *d = &r->scene.damping;

    if (d->kind != DAMPING_VELOCITY_SCALE || d->value == 1 ||
        r->discretization.kinematics == KINEMATICS_PRINTED)
        return false;
    status_fail(sentence, STATUS_OK,
                "damping velocity_scale is no rate: at half the step the sheet is damped "
                "twice as much, and there is no limit");
    return true;
}

static int spans_of(const struct run *r, int along)
{
    return r->discretization.points[along] - r->discretization.degree[along];
}

/* Returns the points along u (0) or v (1), at least the present ones, with which lines of
 * the net, or knots, fit the supports; 0: there are none. */
static int fitting_points(const struct run *r, int along)
{
    const struct discretization *d = &r->discretization;
    const int points = d->points[along], degree = d->degree[along],
              fit = net_fit_points(&r->scene, along, points, degree),
              least = degree + 1 +
                      support_knots_repeats(&r->scene, along, degree,
                                            is_solid(r) ? SUPPORT_KNOTS_SOLID
                                                        : SUPPORT_KNOTS_SHELL);

    return d->knots[along] ? points : degree > 1 && fit && fit < least ? least : fit;
}

static bool supports_end_between(const struct run *r, struct message *sentence)
{
    const int *points = r->discretization.points,
              fit[] = {fitting_points(r, 0), fitting_points(r, 1)};

    if (fit[0] == points[0] && fit[1] == points[1])
        return false;
    status_fail(sentence, STATUS_OK,
                "a support begins or ends between lines of this net, which holds up to a "
                "cell too little or too much: 20x20 springs held at 10 cm were 4 %% of L "
                "off, 21x21 1 %%");
    if (fit[0] && fit[1])
        snprintf(sentence->text + strlen(sentence->text),
                 sizeof sentence->text - strlen(sentence->text),
                 "; %d x %d points have lines there", fit[0], fit[1]);
    return true;
}

/* A clamp may be too narrow for the net: under its own weight, tension T = rho g h L, a
 * sheet turns down from a clamp within (D / T)^(1/2) = L Gamma^(-1/2). */
static bool clamp_is_narrow(const struct run *r, struct message *sentence)
{
    const struct scene *s = &r->scene;
    const struct discretization *d = &r->discretization;
    const double span = fmin(s->length / spans_of(r, 0), s->width / spans_of(r, 1)),
                 bend = s->length / sqrt(scene_gamma(s));

    if (in_plane_degree(r) < 2 || d->remedy == REMEDY_NONE || d->knots[0] || d->knots[1] ||
        d->kinematics != KINEMATICS_NONLINEAR || !(span > bends * bend))
        return false;
    status_fail(
        sentence, STATUS_OK,
        "spans of %.2g m, but at this Gamma a sheet may bend within %.2g m: between "
        "the points where a cured net asks for strain it stretches and shrinks by "
        "turns, by 32 %% at 13 times, 15 %% at 3 times; finer spans, or knots_u and "
        "knots_v that are dense where it bends",
        span, bend);
    return true;
}

static bool weighs_nothing(const struct run *r, struct message *sentence)
{
    const double *g = r->scene.gravity;

    if (g[0] != 0 || g[1] != 0 || g[2] != 0)
        return false;
    status_fail(sentence, STATUS_OK, "the scene has no gravity");
    return true;
}

const struct warnings_rule warnings_rules[] = {
    {"thickness", "study locking", thickness_locks},
    {"degree_1", "study locking", degree_1_locks},
    {"degree_2", "study locking", degree_2_locks},
    {"linear", "verify elastica", strain_is_small},
    {"printed", "study timestep", is_viscous},
    {"surface", "verify cantilever", is_thick},
    {"euler", "amplification of backward Euler", swings_less},
    {"scale", "study timestep", damping_is_no_rate},
    {"between", "compare corners_patch", supports_end_between},
    {"clamp", "run napkin_drop", clamp_is_narrow},
    {"gravity", "key gravity, m/s^2", weighs_nothing},
    {NULL, NULL, NULL},
};

void warnings_print(const struct run *run, const char *before, FILE *file)
{
    struct message sentence;

    for (const struct warnings_rule *rule = warnings_rules; rule->name; rule++)
        if (rule->holds(run, &sentence))
            fprintf(file, "%s%s (%s)\n", before, sentence.text, rule->source);
}
