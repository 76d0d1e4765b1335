/* The patch test: states of even strain, which any net of points holds, and a bend. */
#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: where every strain is even, or none, the answer lies in every space, and a rule
 * that is consistent finds it, to what Newton's method and the factor of a thin sheet
 * leave. Of the bend 1 %, as is asked; the one that is marked locks. */
#define EXACT  1e-9, "the answer lies in the space"
#define LIMITS 0, "its forces follow another law, or end before the answer"
#define ROWS   0, "bending between its points resists stretch, too, by some (h / L)^2 of it"
static const double ASKED = 0.01;

#define DEGREE(p) .more = "p = " #p, .settings = {"discretization.degree=[" #p "," #p ",1]"}

static const struct verify_subject entries[] = {
    {"iga,iga_nonlinear,iga_nonlinear_3", EXACT},
    {"iga_selective", EXACT},
    {"hex_nonlinear", EXACT, .mark = true},
    {"hex_incompatible", EXACT},
    {"shell,shell_2,shell_3,shell_selective_2", EXACT},
    {"iga,shell", EXACT, {7}, {6}, DEGREE(4)},
    {"iga,shell", EXACT, {8}, {7}, DEGREE(5)},
    {"triangles", ROWS},
    VERIFY_MESHES(EXACT),
    {"mass_spring,position_based,projective_dynamics,vbd", LIMITS},
    {NULL}};
static const struct verify_field field = {entries,
                                          CONTESTANT_LARGE,
                                          "iga_selective_3,shell_selective_3," VERIFY_TWINS,
                                          {7, 11, 19},
                                          {6, 8, 12}};

/* The sheet, nu = 0: [m], [Pa]. Thick enough not to buckle under the shear below. */
static const double LENGTH = 1, WIDTH = 0.5, THICKNESS = 0.05, YOUNG = 1e6;
static const double STRETCH = 1.05, SHEAR = 1e-3, HALF = 1.5;

static const double ROUND_OFF = 1e-13; /* of places, over L */

enum { POINTS = 5 }; /* a side, of material points that are compared */

/* The state of a case: where the sheet's axes go. */
struct state {
    double u[3], v[3];
};

/* Returns the force on an edge so long that pulls it to STRETCH (St. Venant-Kirchhoff). */
static double pull(double length)
{
    return YOUNG * THICKNESS * length * STRETCH * (STRETCH * STRETCH - 1) / 2;
}

static struct state pulled_u(struct verify_trial *t)
{
    verify_trial_set(t,
                     "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: yz}];"
                     "loads=[{at: {u: 1}, force: [%.17g,0,0]}]",
                     pull(WIDTH));
    return (struct state){{STRETCH}, {0, 1}};
}

static struct state pulled_v(struct verify_trial *t)
{
    verify_trial_set(t,
                     "supports=[{at: {v: 0}, fix: xyz}, {at: {v: 1}, fix: xz}];"
                     "loads=[{at: {v: 1}, force: [0,%.17g,0]}]",
                     pull(LENGTH));
    return (struct state){{1}, {0, STRETCH}};
}

/* Three corners hold a sheet that is free otherwise, and have nothing to carry. */
#define CORNERS                                                                            \
    "supports=[{at: {u: 0, v: 0}, fix: xyz}, {at: {u: 1, v: 0}, fix: yz},"                 \
    "{at: {u: 0, v: 1}, fix: z}];"

static struct state pulled_free(struct verify_trial *t)
{
    verify_trial_set(t,
                     CORNERS "loads=[{at: {u: 0}, force: [%.17g,0,0]},"
                             "{at: {u: 1}, force: [%.17g,0,0]}]",
                     -pull(WIDTH), pull(WIDTH));
    return (struct state){{STRETCH}, {0, 1}};
}

/* Sides keep their lengths, e_12 = SHEAR / 2; dead forces F S N on all edges. */
static struct state sheared(struct verify_trial *t)
{
    const double stress = YOUNG * THICKNESS * SHEAR / 2, across = sqrt(1 - SHEAR * SHEAR),
                 x = stress * SHEAR * WIDTH, y = stress * across * WIDTH,
                 along = stress * LENGTH;

    verify_trial_set(t,
                     CORNERS "loads=[{at: {u: 1}, force: [%.17g,%.17g,0]},"
                             "{at: {u: 0}, force: [%.17g,%.17g,0]},"
                             "{at: {v: 1}, force: [%.17g,0,0]},"
                             "{at: {v: 0}, force: [%.17g,0,0]}]",
                     x, y, -x, -y, along, -along);
    return (struct state){{1}, {SHEAR, across}};
}

static struct state half_longer(struct verify_trial *t)
{
    verify_trial_set(t,
                     "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, path: "
                     "[[0,0,0,0],[1,%.17g,0,0]]}]",
                     LENGTH * (HALF - 1));
    return (struct state){{HALF}, {0, 1}};
}

#define TURNED "turn: {axis: [0,1,0], about: [0,0,0], angles: [[0,0],[1,90]]}"

static struct state turned(struct verify_trial *t)
{
    verify_trial_set(t, "supports=[{at: {u: 0}, fix: xyz, " TURNED "}]");
    return (struct state){{0, 0, -1}, {0, 1}};
}

/* It is pulled while it turns: by the path of its other end, which turns, too. */
static struct state turned_longer(struct verify_trial *t)
{
    verify_trial_set(t,
                     "supports=[{at: {u: 0}, fix: xyz, " TURNED "},"
                     "{at: {u: 1}, fix: xyz, " TURNED ", path: [[0,0,0,0],[1,0,0,%.17g]]}]",
                     -LENGTH * (STRETCH - 1));
    return (struct state){{0, 0, -STRETCH}, {0, 1}};
}

/* The same between two clamps, where no edge lies along a coordinate axis. */
static struct state skew(struct verify_trial *t)
{
    const double u[3] = {0.36, -0.8, 0.48}, v[3] = {0.48, 0.6, 0.64},
                 way = LENGTH * (STRETCH - 1);
    struct state s;

    for (int i = 0; i < 3; i++)
        s.u[i] = STRETCH * u[i], s.v[i] = v[i];
    verify_trial_set(t,
                     "pose={origin: [0,0,0], u: [%.17g,%.17g,%.17g], v: [%.17g,%.17g,"
                     "%.17g]}; supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, "
                     "path: [[0,0,0,0],[1,%.17g,%.17g,%.17g]]}]",
                     u[0], u[1], u[2], v[0], v[1], v[2], way * u[0], way * u[1],
                     way * u[2]);
    return s;
}

static const struct {
    const char *name;
    struct state (*set)(struct verify_trial *t);
} states[] = {{"pulled along u by 5 %, clamped", pulled_u},
              {"pulled along v by 5 %, clamped", pulled_v},
              {"pulled along u by 5 %, free", pulled_free},
              {"sheared by 1e-3, free", sheared},
              {"longer by half, both ends clamped", half_longer},
              {"turned by 90 degrees by its clamp", turned},
              {"turned and pulled by 5 % by both clamps", turned_longer},
              {"askew, pulled by 5 % by both clamps", skew}};

/* Sets the sheet; returns the error of places over its length. */
static double measure(struct verify_trial *t, void *context)
{
    double uvw[POINTS * POINTS][3], xyz[POINTS * POINTS][3], want[POINTS * POINTS][3];

    (void)context;
    verify_trial_set(t,
                     "sheet={length: %g, width: %g, thickness: %g};"
                     "material={young: %g, poisson: 0, density: 1000};"
                     "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}; gravity=[0,0,0];"
                     "time={step: 0.1, end: 1}",
                     LENGTH, WIDTH, THICKNESS, YOUNG);
    const struct state s = states[t->subject->at].set(t);
    for (int n = 0; n < POINTS * POINTS; n++) {
        const double u = n % POINTS / (POINTS - 1.0), v = n / POINTS / (POINTS - 1.0);
        uvw[n][0] = u, uvw[n][1] = v, uvw[n][2] = 0.5;
        for (int i = 0; i < 3; i++)
            want[n][i] = LENGTH * u * s.u[i] + WIDTH * v * s.v[i];
    }
    if (!verify_trial_equilibrium(t, POINTS * POINTS, uvw[0], xyz[0]))
        return NAN;
    return verify_row_apart(3 * POINTS * POINTS, xyz[0], want[0]) / LENGTH;
}

static void add_row(struct verify_subject *s)
{
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "%s: places / L", states[s->at].name);

    verify_trial_nets(&t, measure, NULL, NAN, ROUND_OFF);
}

/* Bends a thin sheet by a small force at its end: F L^3 / 3 D, which leaves shear out, .6
 * (h / L)^2 of it. */
static double bend(struct verify_trial *t, void *context)
{
    const double h = 0.01 * LENGTH, small = 1e-4 * LENGTH,
                 D = YOUNG * h * h * h / 12 * WIDTH;
    double xyz[3] = {0};

    (void)context;
    verify_trial_set(t,
                     "sheet={length: %g, width: %g, thickness: %g};"
                     "material={young: %g, poisson: 0, density: 1000};"
                     "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}; gravity=[0,0,0];"
                     "supports=[{at: {u: 0}, fix: xyz}];"
                     "loads=[{at: {u: 1}, force: [0,0,%.17g]}]",
                     LENGTH, WIDTH, h, YOUNG, 3 * D * small / pow(LENGTH, 3));
    verify_trial_tip(t, xyz);
    return xyz[2] / small;
}

static void add_bend(struct verify_subject *s)
{
    const double SHEARS = 1e-4; /* see bend() */
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "bent by a force at its end: tip");

    t.row->tolerance = s->mark || isnan(s->tolerance) ? NAN : ASKED;
    verify_trial_nets(&t, bend, NULL, 1, SHEARS);
}

const struct verify_check verify_patch = {
    {"patch", "the patch test: even strain, rigid turns, a bend; clamped and free"},
    "even strain: x = F X with the forces F S N of St. Venant-Kirchhoff's law; the bend: a "
    "beam's cubic",
    .parts = {{&field, add_row, sizeof states / sizeof *states}, {&field, add_bend, 1}}};
