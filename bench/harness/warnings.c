#include "bench/harness/warnings.h"

#include <math.h>

#include "iga/support_knots.h"
#include "models/contact/contact.h"
#include "models/pattern.h"
#include "models/support_lines.h"
#include "models/vector.h"

/* Bounds: span over thickness from which degree 2 loses a tenth; thickness over side; share
 * of a swing lost in a second; span over the length that a clamp bends. */
static const double LONG_SPAN = 20, THICK = 0.1, SWING_LOST = 0.01, BENDS = 4;

/* Samples of contact a span, of degree 2 and above (iga/bspline_contact.c). */
static const double SPAN_SAMPLES = 4;

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
static bool thickness_locks(const struct run *r, double number[])
{
    const double nu = r->scene.poisson, layers = r->discretization.points[2] - 1;

    number[0] = nu;
    number[1] = 100 * ((1 - nu) * (1 - nu) / (1 - 2 * nu) - 1) / (layers * layers);
    return !is_cured(r) && r->discretization.degree[2] == 1 && nu != 0;
}

/* Takes the longest span of a direction of degree 2, in thicknesses. */
static bool degree_2_locks(const struct run *r, double number[])
{
    const struct discretization *d = &r->discretization;
    const double side[] = {r->scene.length, r->scene.width};
    double span = 0;

    for (int i = 0; i < 2; i++)
        if (d->degree[i] == 2)
            span = fmax(span, side[i] / (d->points[i] - 2) / r->scene.thickness);
    number[0] = LONG_SPAN, number[1] = span;
    return !is_cured(r) && span > LONG_SPAN;
}

static bool strain_is_small(const struct run *r, double number[])
{
    const double gamma = scene_gamma(&r->scene);

    number[0] = gamma > SCENE_GAMMA_TEN_PERCENT ? 10 : 1;
    return r->discretization.kinematics == KINEMATICS_LINEAR &&
           gamma > SCENE_GAMMA_ONE_PERCENT;
}

static bool is_viscous(const struct run *r, double number[])
{
    number[0] = r->scene.young * r->scene.step;
    return r->discretization.kinematics == KINEMATICS_PRINTED;
}

static bool is_thick(const struct run *r, double number[])
{
    const struct scene *s = &r->scene;

    number[0] = s->thickness / fmin(s->length, s->width);
    return !is_solid(r) && number[0] >= THICK * (1 - 1e-9);
}

/* Backward Euler damps: what swings or turns slows down by (1 + omega^2 dt^2)^(-1/2) a
 * step; a sheet swings as a rod, omega^2 = 3/2 g / L, or turns as it starts. */
static bool swings_less(const struct run *r, double number[])
{
    const struct scene *s = &r->scene;
    const int pieces = r->discretization.substeps > 0 ? r->discretization.substeps : 1;
    const double omega2 = fmax(1.5 * vector_length(s->gravity) / s->length,
                               vector_dot(s->spin, s->spin)),
                 lost = omega2 * s->step / pieces / 2;

    number[0] = 100 * lost;
    return is_net(r) && r->discretization.integrator == INTEGRATOR_IMPLICIT &&
           lost > SWING_LOST;
}

/* Returns the velocity along a path before its row k, from the row before or the start. */
static double before_row(const struct scene *s, const struct scene_motion *m, int k, int i)
{
    if (k == 0)
        return m->path[0][0] > 0 ? 0 : s->velocity[i];
    return (m->path[k][1 + i] - m->path[k - 1][1 + i]) /
           (m->path[k][0] - m->path[k - 1][0]);
}

/* Returns the largest jump of velocity at a row of a support's path [m/s]: of a tenth of
 * its greatest velocity and more, for the rows of a smooth way jump, too. */
static double largest_jump(const struct scene *s)
{
    double most = 0;

    for (int n = 0; n < s->support_count; n++) {
        const struct scene_motion *m = &s->supports[n].motion;
        const double until = s->supports[n].until,
                     end = until > 0 ? fmin(until, s->end) : s->end;
        double jump = 0, fastest = 0;
        for (int k = 0; k < m->path_count; k++) {
            double v[3], by[3];
            for (int i = 0; i < 3; i++) {
                v[i] = k + 1 < m->path_count ? before_row(s, m, k + 1, i) : 0;
                by[i] = v[i] - before_row(s, m, k, i);
            }
            fastest = fmax(fastest, vector_length(v));
            if (m->path[k][0] >= s->supports[n].from && m->path[k][0] < end)
                jump = fmax(jump, vector_length(by));
        }
        most = jump > fastest / 10 ? fmax(most, jump) : most;
    }
    return most;
}

/* A jump of velocity v sends a wave along the sheet that strains it by v / c; it buckles
 * from some (h / L)^2 on, and what an implicit step makes of a wave that runs farther than
 * a tenth of the sheet in it is not the wave. */
static bool path_has_kink(const struct run *r, double number[])
{
    const struct scene *s = &r->scene;
    const double c = sqrt(scene_law(s).young / s->density),
                 share = s->thickness / s->length;
    const enum integrator by = r->discretization.integrator;

    number[0] = largest_jump(s), number[1] = c * s->step / s->length;
    return by != INTEGRATOR_LEAPFROG && by != INTEGRATOR_EXPLICIT && number[1] > 0.1 &&
           number[0] / c > share * share;
}

static bool damping_is_no_rate(const struct run *r, double number[])
{
    const struct scene_damping *d = &r->scene.damping;

    (void)number;
    return d->kind == DAMPING_VELOCITY_SCALE && d->value != 1 &&
           r->discretization.kinematics != KINEMATICS_PRINTED;
}

static bool is_around(const struct run *r, int along)
{
    return along == 1 && scene_closed(&r->scene);
}

int warnings_spans(const struct run *r, int along)
{
    const struct discretization *d = &r->discretization;
    const struct pattern *p = r->scene.pattern;

    if (p && p->mesh.nodes && !d->mesh) /* of edges as long as those of the triangles */
        return (int)fmax(1, p->size[along] * ldexp(1, d->refine) /
                                sqrt(2 * p->area / p->mesh.triangles));
    return r->discretization.points[along] -
           (is_around(r, along) ? 0 : r->discretization.degree[along]);
}

/* Returns the points along u (0) or v (1), at least the present ones, with which lines of
 * the net, or knots, fit the supports; 0: there are none. */
static int fitting_points(const struct run *r, int along)
{
    const struct discretization *d = &r->discretization;
    const int points = d->points[along], degree = d->degree[along],
              fit = support_lines_points(&r->scene, along, points, degree),
              least = degree + 1 +
                      support_knots_repeats(&r->scene, along, degree,
                                            is_solid(r) ? SUPPORT_KNOTS_SOLID
                                                        : SUPPORT_KNOTS_SHELL);

    if (is_around(r, along))
        return fit;
    return d->knots[along] ? points : degree > 1 && fit && fit < least ? least : fit;
}

/* Tells whether a support ends within the box of a sheet with an outline, whose mesh has no
 * lines. */
static bool ends_within(const struct scene *scene)
{
    bool within = false;

    for (int n = 0; n < 4 * scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n / 4];
        const double end = n % 4 < 2 ? s->lo[n % 2] : s->hi[n % 2];
        within |= !s->part_count && end > 0 && end < 1;
    }
    return within;
}

static bool supports_end_between(const struct run *r, double number[])
{
    const int *points = r->discretization.points;

    number[0] = number[1] = 0;
    if (r->scene.pattern)
        return ends_within(&r->scene);
    number[0] = fitting_points(r, 0), number[1] = fitting_points(r, 1);
    return number[0] != points[0] || number[1] != points[1];
}

static bool ends_could_fit(const struct run *r, double number[])
{
    return supports_end_between(r, number) && number[0] > 0 && number[1] > 0;
}

static bool no_ends_could_fit(const struct run *r, double number[])
{
    return supports_end_between(r, number) && !(number[0] > 0 && number[1] > 0);
}

/* A clamp may be too narrow for the net: under its own weight, tension T = rho g h L, a
 * sheet turns down from a clamp within (D / T)^(1/2) = L Gamma^(-1/2). */
static bool clamp_is_narrow(const struct run *r, double number[])
{
    const struct scene *s = &r->scene;
    const struct discretization *d = &r->discretization;

    number[0] = fmin(s->length / warnings_spans(r, 0), s->width / warnings_spans(r, 1));
    number[1] = s->length / sqrt(scene_gamma(s));
    return in_plane_degree(r) >= 2 && d->remedy != REMEDY_NONE && !d->knots[0] &&
           !d->knots[1] && d->kinematics == KINEMATICS_NONLINEAR &&
           number[0] > BENDS * number[1];
}

/* Returns whether a support holds the slope of the sheet, not only places. */
static bool is_clamped(const struct scene *s)
{
    for (int n = 0; n < s->support_count; n++) {
        const struct scene_support *a = &s->supports[n];
        if (a->hi[2] > a->lo[2] || (a->hi[0] > a->lo[0] && a->hi[1] > a->lo[1]))
            return true;
    }
    return false;
}

/* Returns whether all that holds the sheet does so from one side to the other, along v, and
 * no body meets it: it bends along u. */
static bool bends_along(const struct scene *s)
{
    bool whole = s->support_count && !s->obstacle_count && !s->contact.self;

    for (int n = 0; n < s->support_count; n++)
        whole = whole && s->supports[n].lo[1] <= 0 && s->supports[n].hi[1] >= 1;
    return whole || scene_same_across(s);
}

/* Returns the longest span of a net that may have to bend, in metres. */
static double longest_span(const struct run *r)
{
    const double along = r->scene.length / warnings_spans(r, 0);

    return bends_along(&r->scene) ? along
                                  : fmax(along, r->scene.width / warnings_spans(r, 1));
}

/* Within three times the length of a clamp's bend a sheet makes 95 % of its turn: where one
 * span has that, the strain points of a cured solid see little of it, and it was off by 9
 * to 26 % of the length. Shells of the same spans were right. */
static bool clamp_gives_way(const struct run *r, double number[])
{
    number[0] = longest_span(r);
    number[1] = r->scene.length / sqrt(scene_gamma(&r->scene));
    return is_solid(r) && in_plane_degree(r) >= 2 && is_cured(r) && is_clamped(&r->scene) &&
           r->discretization.kinematics == KINEMATICS_NONLINEAR &&
           number[0] > 3 * number[1];
}

/* Returns whether contact follows the law of the scene. */
static bool has_law(const struct run *r)
{
    return contact_wanted(&r->scene) && !kinematics_rebuilds(r->discretization.kinematics);
}

/* Returns the curvature, times the length, by which its weight bends a sheet: Gamma^(1/2)
 * at a clamp (above); where nothing holds its slope, its bending moment D k is that of the
 * weight of as much of it as bends, rho g h / k^2, and k L = Gamma^(1/3). */
static double weight_bends(const struct scene *s, double gamma)
{
    return pow(gamma, is_clamped(s) ? 1. / 2 : 1. / 3);
}

/* Returns the energy of the stretch that a net without a cure can't avoid when it bends by
 * a curvature k, over that of the bend; kl: k times the length. Over a span s, a spline of
 * degree p follows the derivatives of an arc to (k s / pi)^p (Favard's bound for splines of
 * degree p - 1, whose constant is near 1): this is its strain e, and
 * h e^2 / (h^3 k^2 / 12) the ratio. A hexahedron with incompatible modes has straight
 * edges, and its own parabola, which frees it from shear, has (k s x)^2 / 8 of strain,
 * -1 < x < 1, of which nothing takes what is not its mean, 4 / 45 of the square. More than
 * half a turn a span is none that a net follows. */
static double stretch_of_bends(const struct run *r, double kl)
{
    const double pi = acos(-1.0), s = longest_span(r), thin = s / r->scene.thickness,
                 turn = fmin(pi, s * kl / r->scene.length);
    const int p = in_plane_degree(r);

    return p == 1 ? 12 * turn * turn / 64 * 4 / 45 * thin * thin
                  : 12 * pow(turn / pi, 2 * p) / (turn * turn) * thin * thin;
}

/* In an element of degree 1 a bend of curvature k is a shear of k x: its energy over that
 * of the bend. */
static bool degree_1_locks(const struct run *r, double number[])
{
    const double thin = longest_span(r) / r->scene.thickness;

    number[1] = (1 - r->scene.poisson) / 2 * thin * thin;
    return !is_cured(r) && in_plane_degree(r) == 1;
}

/* A net locks where stretching takes more than bending: heavy cantilevers of degrees 2 and
 * 3, h/L from 1e-2 to 1e-4, then drop by .5 to .7 % too little, and by 3 to 4 % where it
 * takes 40 times as much. */
static bool bends_stretch(const struct run *r, double number[])
{
    const enum remedy remedy = r->discretization.remedy;

    number[0] = longest_span(r) / r->scene.thickness;
    number[1] = stretch_of_bends(r, weight_bends(&r->scene, scene_gamma(&r->scene)));
    return r->discretization.kinematics == KINEMATICS_NONLINEAR && number[1] > 1 &&
           (remedy == REMEDY_INCOMPATIBLE ||
            (remedy == REMEDY_NONE && in_plane_degree(r) > 1));
}

/* A sheet bends under its own weight from GAMMA_BENDS on; a net that locks by so much that
 * it has less left does not. At a clamp it may be as stiff as its sheet times STIFF: of
 * drawn runs those of up to 6.3 were right, and those of more than 6.6 wrong. */
static const double GAMMA_BENDS = 10, STIFF = 6.5;

/* Returns the Gamma that a net which locks has left. It bends until its weight and its own
 * stiffness agree, and gives way to a smaller curvature than the sheet's: this falls from k
 * at the clamp as exp(-k x), so that the energy of the stretch, of the power 2 p of k (4 of
 * hexahedra), is 1 / p of that of an arc of k all along. */
static double gamma_left(const struct run *r)
{
    const double gamma = scene_gamma(&r->scene), share = 1. / fmax(2, in_plane_degree(r));
    double low = 0, high = gamma;

    for (int n = 0; n < 60; n++) {
        const double left = (low + high) / 2,
                     more = stretch_of_bends(r, weight_bends(&r->scene, left));
        if (left * (1 + share * more) > gamma)
            high = left;
        else
            low = left;
    }
    return low;
}

static bool hardly_bends(const struct run *r, const double number[])
{
    const double gamma = scene_gamma(&r->scene), left = gamma_left(r);

    (void)number;
    return gamma >= GAMMA_BENDS &&
           left < (is_clamped(&r->scene) ? gamma / STIFF : GAMMA_BENDS);
}

/* The energy of the shear is known well. A cantilever sags by Gamma / 8 of its length, and
 * not beyond it: by Gamma / (8 + Gamma), of which a tenth of the length may be lost.
 * Weightless ones are bent by their supports. */
static bool hardly_shears(const struct run *r, const double number[])
{
    const double gamma = scene_gamma(&r->scene), left = gamma / (1 + number[1]);

    return gamma > 0 ? gamma / (8 + gamma) - left / (8 + left) > 0.1
                     : number[1] > GAMMA_BENDS;
}

static bool is_far_out(const struct run *r, const double number[])
{
    (void)r;
    return number[0] > 1;
}

/* Takes the side along u of an area that is held and, if that is narrower, the place that
 * the net has for it: a cell; of splines, at the sheet's ends, the way from the first
 * control point to the second, a span over the degree, else a span. Of the drawn sheets,
 * which hang from u = 0, none was worse for few or long spans across. */
static bool holds_less_than_a_cell(const struct run *r, double number[])
{
    const double length = r->scene.length, span = length / warnings_spans(r, 0);
    bool less = false;

    for (int n = 0; n < r->scene.support_count; n++) {
        const struct scene_support s = scene_support_along(&r->scene, n);
        const double side = (s.hi[0] - s.lo[0]) * length,
                     cell = s.lo[0] <= 0 || s.hi[0] >= 1
                                ? span / r->discretization.degree[0]
                                : span;
        if (side > 0 && side < cell * (1 - 1e-9))
            less = true, number[0] = side, number[1] = cell;
    }
    return less;
}

static bool always(const struct run *r, const double number[])
{
    (void)r, (void)number;
    return true;
}

static bool forgets_its_shape(const struct run *r, double number[])
{
    (void)number;
    return r->discretization.kinematics == KINEMATICS_INCREMENTAL &&
           r->scene.support_count > 0;
}

/* Takes the law at a body under the sheet's weight. */
static bool edge_is_short(const struct run *r, double number[])
{
    const struct contact_law law = contact_law_body(&r->scene);

    number[0] = longest_span(r);
    number[1] = contact_law_edge(&law, scene_bending_stiffness(&r->scene),
                                 contact_law_weight(&r->scene));
    return has_law(r) && number[0] > number[1];
}

/* Between two samples of contact, four a span of smooth nets, a chord lies as deep in a
 * round body as the arc is high: s^2 / 8 R. */
static bool body_is_round(const struct run *r, double number[])
{
    const struct contact_law law = contact_law_body(&r->scene);
    const double s = longest_span(r) / (in_plane_degree(r) > 1 ? SPAN_SAMPLES : 1);

    number[0] = 0, number[1] = law.range;
    for (int o = 0; o < r->scene.obstacle_count; o++)
        if (r->scene.obstacles[o].radius > 0)
            number[0] =
                fmax(number[0], s * s / 8 / (r->scene.obstacles[o].radius + law.start));
    return has_law(r) && number[0] > number[1];
}

/* printed and incremental kinematics put what is inside a body on its surface, no more. */
static bool has_no_friction(const struct run *r, double number[])
{
    number[0] = r->scene.contact.self ? r->scene.contact.friction : 0;
    for (int o = 0; o < r->scene.obstacle_count; o++)
        number[0] = fmax(number[0], r->scene.obstacles[o].friction);
    return kinematics_rebuilds(r->discretization.kinematics) && number[0] > 0;
}

static bool meets_bodies_only(const struct run *r, double number[])
{
    (void)number;
    return kinematics_rebuilds(r->discretization.kinematics) && r->scene.contact.self;
}

static bool is_put_back(const struct run *r, double number[])
{
    (void)number;
    return kinematics_rebuilds(r->discretization.kinematics) && r->scene.obstacle_count > 0;
}

static bool weighs_nothing(const struct run *r, double number[])
{
    const double *g = r->scene.gravity;

    (void)number;
    return g[0] == 0 && g[1] == 0 && g[2] == 0;
}

#define BETWEEN                                                                            \
    "a support begins or ends, or a load lies, between lines of this net, and acts "       \
    "up to a cell away: 20 points along a strip sag 5 to 12 %% too little under a load "   \
    "in its middle, 20x20 springs held at 10 cm were 4 %% of L off, 21x21 1 %%"

const struct warnings_rule warnings_rules[] = {
    {"thickness", "study locking", thickness_locks,
     "degree 1 through the thickness with remedy=none and nu = %g: up to %.2g %% too stiff "
     "in bending, on any net"},
    {"degree_1", "study locking", degree_1_locks,
     "degree 1 with remedy=none locks in shear: 10x10x2 hexahedra keep 0.02 %% of a tip at "
     "h/L = 1e-3, 32x32x2 keep 0.3 %%",
     hardly_shears, "its net locks in shear"},
    {"degree_2", "study locking", degree_2_locks,
     "degree 2 with remedy=none locks in shear where spans are longer than %g thicknesses, "
     "here %.3g: at 125 it keeps 68 %% of a tip"},
    {"bends", "verify elastica", bends_stretch,
     "this net locks where the weight bends the sheet: in spans of %.3g thicknesses "
     "stretch "
     "that it can't avoid takes %.2g times the energy of the bend; finer spans, or a net "
     "with "
     "a cure of its membrane",
     hardly_bends, "its net locks"},
    {"linear", "verify elastica", strain_is_small,
     "small-strain theory misses a cantilever's tip by more than %g %% at this Gamma",
     is_far_out, "small-strain theory does not reach this far"},
    {"printed", "study timestep", is_viscous,
     "kinematics=printed is a viscous sheet without elastic memory: its viscosity is E dt "
     "= "
     "%.3g Pa s, and changes with the step"},
    {"surface", "verify cantilever", is_thick,
     "a model of the mid-surface leaves shear through the thickness out: 2 %% of a tip at "
     "h/L = 0.1, here %.2g"},
    {"euler", "amplification of backward Euler", swings_less,
     "backward Euler takes %.2g %% of a swing or turn in every second at this step, half "
     "of that at half the step"},
    {"kink", "time.step", path_has_kink,
     "the velocity of a support jumps by %.2g m/s, and the wave that this sends along the "
     "sheet runs %.2g L in a step: implicit steps were 6 to 7 %% of L off behind such a "
     "kink, and 1.5 to 2.5 %% at a sixteenth of the step; hold them against shorter ones"},
    {"scale", "study timestep", damping_is_no_rate,
     "damping velocity_scale is no rate: at half the step the sheet is damped twice as "
     "much, "
     "and there is no limit"},
    {"between", "compare corners_patch", no_ends_could_fit, BETWEEN},
    {"between", "compare corners_patch", ends_could_fit,
     BETWEEN "; %g x %g points have lines there"},
    {"narrow", "distrust_trial", holds_less_than_a_cell,
     "%.2g m of the sheet are held, less than a cell of %.2g m: the net has no place for "
     "that",
     always, "a place that is held is narrower than a cell of its net"},
    {"forgets", "distrust_trial", forgets_its_shape,
     "kinematics=incremental forgets part of the shape at rest: a sheet that is held sags "
     "as if its stiffness relaxed",
     always, "its scheme forgets the shape at rest"},
    {"clamp", "run napkin_drop", clamp_is_narrow,
     "spans of %.2g m, but at this Gamma a sheet may bend within %.2g m: between the "
     "points "
     "where a cured net asks for strain it stretches and shrinks by turns, by 32 %% at 13 "
     "times, 15 %% at 3 times; finer spans, or knots_u and knots_v that are dense where it "
     "bends"},
    {"way", "distrust_trial", clamp_gives_way,
     "spans of %.2g m, but this clamp bends the sheet within %.2g m, less than a third of "
     "a span: the clamp of a cured solid gives way, in edge_drop by 18 %% of L with 6 "
     "spans "
     "of degree 2, 4 %% with 6 of degree 3",
     always, "its clamp gives way"},
    {"edge", "doc/contact.md", edge_is_short,
     "spans of %.2g m, but at the edge of a zone of contact the sheet bends within lambda "
     "= "
     "%.2g m: the edge is as sharp as the net"},
    {"round", "doc/contact.md", body_is_round,
     "between the samples of contact a round body comes up to %.2g m nearer, but contact "
     "has "
     "a range of %.2g m: the body reaches into the sheet"},
    {"put", "models/mechanics/integrator_printed.c", is_put_back,
     "what a step leads into a body is put on its surface with kinematics=printed or "
     "incremental: there is no law of contact, and no force to tell"},
    {"smooth", "models/mechanics/integrator_printed.c", has_no_friction,
     "friction is left out with kinematics=printed or incremental, and the scene has mu = "
     "%g"},
    {"crossing", "models/mechanics/integrator_printed.c", meets_bodies_only,
     "the sheet may cross itself with kinematics=printed or incremental: crossings are "
     "counted, no more"},
    {"gravity", "key gravity, m/s^2", weighs_nothing, "the scene has no gravity"},
    {NULL},
};

void warnings_print(const struct run *run, const char *before, FILE *file)
{
    for (const struct warnings_rule *rule = warnings_rules; rule->name; rule++) {
        double number[WARNINGS_NUMBERS] = {0};
        if (!rule->holds(run, number))
            continue;
        fputs(before, file);
        fprintf(file, rule->sentence, number[0], number[1]);
        fprintf(file, " (%s)\n", rule->source);
    }
}
