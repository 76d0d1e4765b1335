/* What supports and bodies exert on a sheet (model.h's `forces`): with gravity, loads and
 * friction it is the change of momentum, without motion of supports that of angular
 * momentum; at rest it is in balance; and it has its closed forms. */
#include "models/mechanics/march.h"
#include "models/vector.h"
#include "tests/opened_run.h"

#define KEY     "discretization."
#define LINEAR  KEY "kinematics=linear"
#define LARGE   KEY "kinematics=nonlinear"
#define SQUARES KEY "integrator=momentum"
#define LEAPS   KEY "integrator=leapfrog"

/* Of momentum, in weights, and of its moment, in weights times the length, once iterations
 * end at round-off: that of 1e-16 of positions times the thickness' stiffness. */
#define BALANCE 1e-9
/* Where a support turns, velocities beside its clamp follow the stretch at a step's end. */
#define TURNED 5e-4
/* Loads act at the mean place of a frame, which is not that of its explicit steps. */
#define MEANS 5e-5
/* The damping of a clamp of springs resists what is free alone, against the ground. */
#define CLAMPED 1e-3
/* Newton's iteration ends at changes of this [m]. */
static const double TIGHT = 1e-13;

enum { OPTIONS = 5, SETTINGS = 16, FRAMES = 30 };

static const double step = 0.005;

/* A sheet that is held along an edge, and falls onto spheres. */
static const char *const onto_sphere[] = {
    "sheet={length: 0.5, width: 0.4, thickness: 0.004}",
    "pose={origin: [0.1,0.2,0.3], u: [1,0,0], v: [0,1,0]}",
    "material={young: 1e5, poisson: 0.3, density: 200}",
    "damping={kind: none}",
    "loads=[{at: {v: 0}, force: [0,-0.1,0.05]}]",
    "obstacles=[{sphere: {center: [0.35,0.3,0.18], radius: 0.1, friction: 0.3}},"
    "{sphere: {center: [0.5,0.5,0.2], radius: 0.05}}]",
    "time={step: 0.005, end: 0.2}",
    "snapshots=[]",
    NULL};
static const char still[] = "supports=[{at: {u: 0}, fix: xyz}]",
                  moving[] = "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1, v: 1}, fix: "
                             "xyz, path: [[0,0,0,0], [0.2,-0.02,0,0.05]]}, {at: {u: 1, v: "
                             "0}, fix: z, path: [[0,0,0,0], [0.2,0,0,0.02]]}]",
                  turning[] =
                      "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, turn: "
                      "{axis: [1,0.2,0], about: [0.1,0.2,0.3], angles: [[0,0],[1,300]]}}]",
                  grips[] =
                      "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, until: "
                      "0.05}]",
                  beside[] =
                      "supports=[{at: {u: 1, v: 0}, fix: xyz, until: 0.05}, {at: {u: 0}, "
                      "fix: xyz, turn: {axis: [0,1,0.2], about: [0.1,0.2,0.3], angles: "
                      "[[0,0],[1,100]]}}]",
                  empty[] = "obstacles=[]",
                  stiff[] = "damping={kind: rayleigh, alpha: 0, beta: 0.001}";
/* This comes to the held edge, within reach of its law. */
static const char under[] = "obstacles=[{sphere: {center: [0.1,0.4,0.19], radius: 0.1}, "
                            "path: [[0,0,0,0], [0.05,0,0,0.0083]]}]";

static void open_with(struct run *run, const char *scene, const char *model,
                      const char *const *settings, const char *const *more)
{
    const char *list[SETTINGS + OPTIONS] = {NULL};
    int count = 0;

    for (; *settings; settings++)
        list[count++] = *settings;
    for (int n = 0; n < OPTIONS && more[n]; n++)
        list[count++] = more[n];
    list[count++] = !strcmp(model, "iga") || !strcmp(model, "hex") ? KEY "points=[8,7,2]"
                                                                   : KEY "points=[8,7,1]";
    opened_run(run, scene, model, count, list);
    if (run->model->forces == march_forces && !run->discretization.iterations)
        ((struct march *)run->state)->tolerance = TIGHT;
}

static void forces_of(const struct run *run, double support[][6], double body[][6])
{
    CHECK(run->model->forces(run->state, support, body) == STATUS_OK);
}

/* Adds the momentum of v by the mass M, of what is a place and no difference, and its
 * moment. */
static void add_momentum(const struct march *m, const double *M, double sign, double *y,
                         double p[6])
{
    blocks_multiply_mass(m->graph, M, march_velocity(m), y);
    for (int a = 0; a < m->graph->nodes; a++) {
        double moment[3];
        vector_cross(m->x + 3 * (size_t)a, y + 3 * (size_t)a, moment);
        for (int i = 0; i < 3; i++) {
            const bool place = !m->uvw || m->uvw[a][2] >= SUPPORTS_MIDDLE;
            p[i] += place ? sign * y[3 * a + i] : 0;
            p[3 + i] += sign * moment[i];
        }
    }
}

static void momentum_of(const struct march *m, double p[6])
{
    double *y = calloc(march_count(m), sizeof *y);

    REQUIRE(y);
    memset(p, 0, 6 * sizeof *p);
    add_momentum(m, m->M, 1, y, p);
    free(y);
}

/* Adds gravity and loads, and their moment at the mean of two places. */
static void add_loads(const struct march *m, const double *x, const double *x_old,
                      double sum[6])
{
    for (int a = 0; a < m->graph->nodes; a++) {
        double at[3], moment[3];
        for (int i = 0; i < 3; i++)
            at[i] = (x[3 * a + i] + x_old[3 * a + i]) / 2;
        vector_cross(at, m->load + 3 * (size_t)a, moment);
        for (int i = 0; i < 3; i++) {
            const bool place = !m->uvw || m->uvw[a][2] >= SUPPORTS_MIDDLE;
            sum[i] += place ? m->load[3 * a + i] : 0;
            sum[3 + i] += moment[i];
        }
    }
}

static double weight_of(const struct run *run)
{
    const struct scene *s = &run->scene;

    return 9.81 * s->density * s->thickness * s->length * s->width;
}

/* Adds the forces of all supports and bodies. */
static void add_pushes(const struct run *run, double sum[6])
{
    double support[4][6], body[2][6];

    forces_of(run, support, body);
    for (int n = 0; n < 6 * run->scene.support_count; n++)
        sum[n % 6] += support[n / 6][n % 6];
    for (int n = 0; n < 6 * run->scene.obstacle_count; n++)
        sum[n % 6] += body[n / 6][n % 6];
}

/* --- motion ------------------------------------------------------------------------------
 */

/* Bodies' forces are model_contact's. */
static void check_bodies(const struct run *run)
{
    double support[4][6], body[2][6], sum[3] = {0};
    struct model_contact c;

    forces_of(run, support, body);
    run->model->contact(run->state, &c);
    for (int n = 0; n < run->scene.obstacle_count; n++)
        for (int i = 0; i < 3; i++)
            sum[i] += body[n][i];
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(sum[i], c.force[i], BALANCE);
}

/* The change of momentum in a frame is that by all forces; the moments' count. */
static void balance_frame(struct run *run, int numbers, double off)
{
    struct march *m = run->state;
    const size_t bytes = march_count(m) * sizeof *m->x;
    double p[2][6], sum[6] = {0}, *x_old = malloc(bytes);

    REQUIRE(x_old);
    memcpy(x_old, m->x, bytes);
    momentum_of(m, p[0]);
    CHECK(run->model->forces(run->state, NULL, NULL) == STATUS_OK);
    opened_steps(run, 1);
    momentum_of(m, p[1]);
    add_pushes(run, sum);
    add_loads(m, m->x, x_old, sum);
    for (int i = 0; i < numbers; i++)
        CHECK_NEAR((p[1][i] - p[0][i]) / step, sum[i], off * weight_of(run));
    free(x_old);
}

/* In the first frame supports that move jump to their velocity, which is no force. What was
 * not asked for is not known; asking changes no bit. */
struct motion_row {
    const char *model, *more[OPTIONS];
    int numbers; /* 3: momentum, 6: angular momentum, too */
    double off;
};

static void balance(const struct motion_row *row)
{
    static double xyz[2][3 * GRID_POINTS];
    double support[4][6], body[2][6];
    struct run run, other;

    open_with(&run, "ground", row->model, onto_sphere, row->more);
    open_with(&other, "ground", row->model, onto_sphere, row->more);
    opened_steps(&run, 1);
    forces_of(&run, support, body);
    CHECK(isnan(support[0][0]));
    for (int n = 1; n < FRAMES; n++)
        balance_frame(&run, row->numbers, row->off);
    if (run.scene.obstacle_count)
        check_bodies(&run);
    opened_steps(&other, FRAMES);
    model_sample(run.model, run.state, xyz[0]);
    model_sample(run.model, other.state, xyz[1]);
    CHECK(!memcmp(xyz[0], xyz[1], sizeof *xyz));
    run_close(&run);
    run_close(&other);
}

static const struct motion_row motions[] = {
    {"shell", {still}, 6, BALANCE},
    {"hex", {still}, 6, BALANCE},
    {"iga", {still, LARGE}, 6, BALANCE},
    {"triangles", {still}, 6, BALANCE},
    {"mass_spring", {still, SQUARES}, 6, BALANCE},
    {"shell", {moving}, 3, BALANCE},
    {"hex", {moving}, 3, BALANCE},
    {"iga", {moving, LARGE}, 3, BALANCE},
    {"triangles", {moving}, 3, BALANCE},
    {"triangles", {moving, KEY "mesh=irregular"}, 3, BALANCE},
    {"mass_spring", {moving, SQUARES}, 3, BALANCE},
    {"mass_spring", {moving, KEY "integrator=implicit"}, 3, BALANCE},
    {"mass_spring", {moving, KEY "integrator=implicit", stiff}, 3, CLAMPED},
    {"shell", {moving, stiff}, 3, BALANCE},
    {"hex", {moving, LEAPS, stiff}, 3, BALANCE},
    {"shell", {moving, LEAPS}, 3, BALANCE},
    {"hex", {moving, LEAPS}, 3, BALANCE},
    {"iga", {moving, LARGE, LEAPS}, 3, BALANCE},
    {"triangles", {moving, LEAPS, KEY "bending=hinge"}, 3, BALANCE},
    {"triangles", {still, LEAPS, KEY "bending=hinge", under}, 3, BALANCE},
    {"mass_spring", {moving, KEY "integrator=explicit"}, 3, BALANCE},
    {"shell", {turning, LEAPS}, 3, BALANCE},
    {"shell", {turning}, 3, TURNED},
    {"shell", {still, LEAPS, empty}, 3, BALANCE},
    {"shell", {grips}, 6, BALANCE},
    {"shell", {grips, LEAPS}, 3, BALANCE},
    {"shell", {beside, LEAPS}, 3, TURNED},
    {"triangles", {still, LEAPS, KEY "bending=hinge", empty}, 6, MEANS},
    {"iga", {still, LARGE, LEAPS, empty}, 3, BALANCE},
    {"shell", {moving, LINEAR, empty}, 3, BALANCE},
    {"hex", {moving, LINEAR, empty}, 3, BALANCE},
    {"iga", {moving, LINEAR, empty}, 3, BALANCE},
};

/* --- rest --------------------------------------------------------------------------------
 */

/* At rest supports bear weight and loads, and their moment; of linear bodies at the places
 * of rest. */
static void check_rest(void)
{
    static const struct {
        const char *model, *more[OPTIONS];
    } row[] = {{"shell", {still}},         {"hex", {still}},
               {"iga", {still, LARGE}},    {"triangles", {still}},
               {"shell", {moving}},        {"mass_spring", {still, SQUARES}},
               {"shell", {still, LINEAR}}, {"hex", {still, LINEAR}},
               {"iga", {still, LINEAR}},   {"mass_spring", {still, LEAPS}}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        const char *const all[OPTIONS] = {row[n].more[0], empty, row[n].more[1]};
        double sum[6] = {0};
        struct run run;

        open_with(&run, "ground", row[n].model, onto_sphere, all);
        const struct march *m = run.state;
        opened_settle(&run);
        const double *x = m->kinematics == KINEMATICS_LINEAR ? m->rest : m->x;
        add_pushes(&run, sum);
        add_loads(m, x, x, sum);
        for (int i = 0; i < 6; i++)
            CHECK_NEAR(sum[i], 0, BALANCE * weight_of(&run));
        run_close(&run);
    }
}

/* --- closed forms ------------------------------------------------------------------------
 */

#define STRIP                                                                              \
    "sheet={length: 0.2, width: 0.05, thickness: 0.001}",                                  \
        "material={young: 1e6, poisson: 0, density: 1000}",                                \
        "damping={kind: mass, value: 100}", "time={step: 0.005, end: 1.5}",                \
        "snapshots=[]", empty

/* Triangles and springs stretch unevenly beside a clamp, by the bending of their clamps;
 * springs in lengths, whose law has nu = 1/3, more. */
static const double EXACT = 1e-9, UNEVEN = 1e-3, MISFIT = 0.03;
/* What damping leaves of a strip's swings after 1.5 s, and iterations of its weight (doc/
 * iterations.md). */
static const double SWUNG = 1e-6, LEFT = 0.01;
/* Points of the net come onto the rod, and leave it. */
static const double BELT = 0.02;

/* The force of the law that a model has where the strip is 1.5 lengths long. */
enum { GREEN, LENGTHS };

static const struct strip_row {
    const char *model, *more[OPTIONS - 2];
    bool rests, weaves; /* settles by itself; knows fabrics                      */
    int law;
    double pulled, hung; /* tolerances */
} strips[] = {
    {"shell", {NULL}, true, true, GREEN, EXACT, EXACT},
    {"hex", {NULL}, true, false, GREEN, EXACT, EXACT},
    {"iga", {LARGE}, true, false, GREEN, EXACT, EXACT},
    {"triangles", {NULL}, true, true, GREEN, UNEVEN, EXACT},
    {"triangles", {LEAPS}, false, false, GREEN, UNEVEN, SWUNG},
    {"vbd", {NULL}, false, false, GREEN, UNEVEN, SWUNG},
    {"mass_spring", {SQUARES}, true, false, GREEN, UNEVEN, EXACT},
    {"mass_spring", {LEAPS}, false, false, GREEN, UNEVEN, SWUNG},
    {"mass_spring", {KEY "integrator=implicit"}, false, false, LENGTHS, MISFIT, SWUNG},
    {"projective_dynamics", {NULL}, false, false, LENGTHS, UNEVEN, LEFT},
    {"position_based", {NULL}, false, false, LENGTHS, MISFIT, LEFT},
};

/* Leaves a strip at rest, or as it is at the end of its motion. */
static void open_strip(struct run *run, const struct strip_row *row, bool rests,
                       const char *const *strip)
{
    open_with(run, "ground", row->model, strip, row->more);
    if (rests) {
        opened_settle(run);
        return;
    }
    opened_steps(run, 299);
    CHECK(run->model->forces(run->state, NULL, NULL) == STATUS_OK);
    opened_steps(run, 1);
}

/* The first two supports pull a strip along x by `want`. */
static void check_ends(const struct strip_row *row, const char *const *strip, double want)
{
    double support[4][6], body[1][6];
    struct run run;

    open_strip(&run, row, row->rests, strip);
    forces_of(&run, support, body);
    CHECK_RELATIVE(support[0][0], -want, row->pulled);
    CHECK_RELATIVE(support[1][0], want, row->pulled);
    run_close(&run);
}

#define LEVEL STRIP, "gravity=[0,0,0]", "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}"

/* Pulled to 1.5 lengths, nu = 0: E A (e + e^2/2)(1 + e), or E A e. */
static void check_pulled(const struct strip_row *row)
{
    const char *const strip[] = {
        LEVEL,
        "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, path: [[0,0,0,0], "
        "[0.5,0.1,0,0]]}]",
        NULL};
    const double e = 0.5, EA = 1e6 * 0.05 * 0.001;

    check_ends(row, strip, row->law == GREEN ? EA * (e + e * e / 2) * (1 + e) : EA * e);
}

/* A balanced weave that is pulled at 45 degrees to its yarns between clamps that let it
 * narrow (bias extension): its sides are free, so that E_vv = -Q12 / Q11 E_uu of the turned
 * law. */
static void check_biased(const struct strip_row *row)
{
    const char *const strip[] = {
        LEVEL, "sheet={length: 0.2, width: 0.05}",
        "material={membrane: [2000, 2000, 500, 100], bending: [1e-5, "
        "1e-5, 0, 5e-6], areal_density: 0.2, warp: 45}",
        "supports=[{at: {u: 0}, fix: x}, {at: {u: 1}, fix: x, path: [[0,0,0,0], "
        "[0.5,0.02,0,0]]}, {at: {v: 0.5}, fix: y}, {at: {u: [0, 1]}, fix: z}]",
        NULL};
    const double Y = 2000, Y12 = 500, G = 100, width = 0.05, stretch = 1.1;
    const double Q11 = (Y + Y12) / 2 + G, Q12 = (Y + Y12) / 2 - G;

    check_ends(row, strip,
               (Q11 - Q12 * Q12 / Q11) * stretch * (stretch * stretch - 1) / 2 * width);
}

/* Hung by an edge off the origin, nothing but its weight pulls. */
static void check_hung(const struct strip_row *row)
{
    const char *const strip[] = {STRIP, "gravity=[0,0,-9.81]",
                                 "pose={origin: [0.3,0,0], u: [0,0,-1], v: [0,1,0]}",
                                 "supports=[{at: {u: 0}, fix: xyz}]", NULL};
    const bool moments = strcmp(row->model, "projective_dynamics");
    double support[1][6], body[1][6];
    struct run run;

    open_strip(&run, row, row->rests, strip);
    const double weight = weight_of(&run);
    forces_of(&run, support, body);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(support[0][i], i == 2 ? weight : 0, row->hung * weight);
    CHECK(isnan(support[0][4]) != moments);
    if (moments)
        CHECK_RELATIVE(support[0][4], -0.3 * weight, row->hung);
    run_close(&run);
}

/* Held all over and sped up, a strip needs its mass times that, and its damping's force. */
static void check_carried(const char *model)
{
    const char *const strip[] = {
        STRIP,
        "gravity=[0,0,0]",
        "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}",
        "supports=[{at: {u: [0,1]}, fix: xyz, path: [[0,0,0,0], [0.005,0,0,0], "
        "[0.01,1e-4,0,0], [0.015,3e-4,0,0], [0.02,6e-4,0,0]]}]",
        KEY "substeps=1",
        NULL};
    double support[1][6], body[1][6];
    struct run run;

    open_with(&run, "ground", model, strip, (const char *const[OPTIONS]){NULL});
    opened_steps(&run, 2);
    forces_of(&run, support, body);
    const double mass = 1000 * 0.2 * 0.05 * 0.001, v = 0.03, a = 4, alpha = 100;
    CHECK_RELATIVE(support[0][0], mass * (a + alpha * v), EXACT);
    run_close(&run);
}

/* A belt that is pulled over a quarter of a rod against a weight: the support pulls as
 * exp(mu pi / 2) of what the rod and the support's own part of the belt's weight leave of
 * the vertical; mean over frames, in which points of the net come and go. */
static void check_belt(void)
{
    enum { FIRST = 140, LAST = 180 };
    const double mu = 0.3;
    struct run run;
    double support[1][6], body[1][6], pull = 0, carried = 0;

    OPENED_RUN(&run, "ground", "triangles",
               "sheet={length: 0.4, width: 0.05, thickness: 0.0005}",
               "pose={origin: [-0.2,0,0.0303], u: [1,0,0], v: [0,1,0]}",
               "material={young: 1e7, poisson: 0.3, density: 400}", "contact={self: false}",
               "damping={kind: mass, value: 10}",
               "supports=[{at: {u: 0}, fix: xyz, path: [[0,0,0,0],[0.6,0,0,0],"
               "[1.2,-0.03,0,0]]}]",
               "loads=[{at: {u: 1}, force: [0,0,-2]}]",
               "obstacles=[{capsule: {from: [0,-0.1,0], to: [0,0.15,0], radius: 0.03, "
               "friction: 0.3}}]",
               "time={step: 0.005, end: 1.2}", "snapshots=[]", KEY "points=[41,4,1]");
    opened_steps(&run, FIRST);
    for (int n = FIRST; n < LAST; n++) {
        CHECK(run.model->forces(run.state, NULL, NULL) == STATUS_OK);
        opened_steps(&run, 1);
        forces_of(&run, support, body);
        pull -= support[0][0], carried += body[0][2];
    }
    CHECK_RELATIVE(pull / carried, exp(mu * acos(-1) / 2), BELT);
    run_close(&run);
}

int main(void)
{
    for (size_t n = 0; n < sizeof motions / sizeof *motions; n++)
        balance(&motions[n]);
    check_rest();
    for (size_t n = 0; n < sizeof strips / sizeof *strips; n++) {
        check_pulled(&strips[n]);
        check_hung(&strips[n]);
        if (strips[n].weaves)
            check_biased(&strips[n]);
    }
    check_carried("vbd");
    check_carried("projective_dynamics");
    check_carried("position_based");
    check_belt();
    return check_result();
}
