/* Contact with obstacles, held to what every model owes: weight, gaps, energy, Coulomb's
 * law on an incline, and no preferred direction. One program, a row of tests/CMakeLists.txt
 * a model: contact_truth MODEL[.VARIANT]. */
#include "bench/harness/contestant.h"
#include "mass_spring/spring_motion.h"
#include "models/grid.h"
#include "models/mechanics/large_newton.h"
#include "models/metric/metric.h"
#include "position_based/pb_motion.h"
#include "projective_dynamics/projective_dynamics_model.h"
#include "tests/check.h"

/* Gaps of the net, of the sheet's length: closed to round-off of the model's solver. */
static const double CLOSED = 1e-11;

/* Force of a sheet at rest against its weight; acceleration on an incline against g. */
static const double BALANCE = 1e-6;

/* The same of a sheet that has landed, on a floor which is tilted by 0.02: cos^2 of that.
 */
static const double LANDED = 1e-3;

/* Iterations end at 1e-6 to 1e-8 of the length. */
static const double STUCK = 1e-5, TURNED = 1e-4;

/* Energy that an impact may add, of the energy that the sheet fell with. Explicit steps
 * have their velocities half a step before their positions: the energy of both swings with
 * the step (0.08 where a frame is two, 0.011 where it is 16), also without obstacles. */
static const double GAIN = 1e-3, GAIN_EXPLICIT = 0.1, GAIN_EXPLICIT_16 = 0.02;
/* The bound of contact_step.h; what is let go pulls by round-off. */
static const double GAIN_LINEAR = 1e-8;

enum { QUARTERS = 4 };

/* The longest piece of a step that Newton's method is let solve [s]. */
static double longest = INFINITY;

enum status __real_large_newton_solve(struct large_motion *m,
                                      const struct large_equation *e, double *x,
                                      struct counters *counters);
enum status __wrap_large_newton_solve(struct large_motion *m,
                                      const struct large_equation *e, double *x,
                                      struct counters *counters);
enum status __wrap_large_newton_solve(struct large_motion *m,
                                      const struct large_equation *e, double *x,
                                      struct counters *counters)
{
    if (e->mass < 2 / (longest * longest)) /* the motion halves its step */
        return STATUS_DIVERGED;
    return __real_large_newton_solve(m, e, x, counters);
}

struct fixture {
    const struct model *model;
    struct discretization d;
    struct scene scene;
    void *state;
    double *xyz, *other;
    double gain;  /* allowed                                                            */
    int pieces;   /* that a step must be taken in; 1: any                               */
    int settling; /* frames until a solid has stopped swinging               */
};

/* A solid swings through its thickness, and breathes, when its weight comes onto it: rest
 * and incline wait for the end of that, with a step that resolves it and stiffness damping,
 * which leaves rigid motion alone; at rest mass damping ends what is slower. */
static void settle(struct fixture *f, double mass)
{
    if (!f->settling)
        return;
    f->scene.step = f->pieces * 2e-4;
    f->scene.damping =
        (struct scene_damping){.kind = DAMPING_RAYLEIGH, .alpha = mass, .beta = 4e-3};
}

static void set_variant(struct fixture *f, const char *variant)
{
    struct discretization *d = &f->d;

    f->gain = GAIN, f->pieces = 1;
    if (!strcmp(variant, "explicit"))
        d->integrator = INTEGRATOR_EXPLICIT, f->gain = GAIN_EXPLICIT;
    else if (!strcmp(variant, "explicit16"))
        d->integrator = INTEGRATOR_EXPLICIT, d->substeps = 16, f->gain = GAIN_EXPLICIT_16;
    else if (!strcmp(variant, "leapfrog"))
        d->integrator = INTEGRATOR_LEAPFROG, f->gain = GAIN_EXPLICIT;
    else if (!strcmp(variant, "momentum"))
        d->integrator = INTEGRATOR_MOMENTUM, d->tolerance = 0;
    else if (!strcmp(variant, "limited"))
        OWN(spring_own, d)->strain_limit = 0.05;
    else if (!strcmp(variant, "quarters"))
        f->pieces = QUARTERS, d->points[0] = d->points[1] = 4;
    else if (!strcmp(variant, "paper"))
        d->parameters = PARAMETERS_PAPER;
    else if (!strcmp(variant, "chebyshev"))
        OWN(pd_own, d)->acceleration = ACCELERATION_CHEBYSHEV;
    else if (!strcmp(variant, "admm"))
        OWN(pd_own, d)->acceleration = ACCELERATION_ADMM;
    else if (!strcmp(variant, "bdf2"))
        d->integrator = INTEGRATOR_BDF2;
    else if (!strcmp(variant, "edges"))
        OWN(pd_own, d)->constraint = CONSTRAINT_EDGES;
    else if (!strcmp(variant, "pbd"))
        OWN(pb_own, d)->projection = PROJECTION_PBD;
    else if (!strcmp(variant, "linear"))
        d->kinematics = KINEMATICS_LINEAR, f->gain = GAIN_LINEAR;
    else if (!strcmp(variant, "nonlinear"))
        d->kinematics = KINEMATICS_NONLINEAR;
    else if (!strcmp(variant, "incremental"))
        d->kinematics = KINEMATICS_INCREMENTAL;
    else
        REQUIRE(!*variant);
}

/* A free sheet of 0.8 kg/m^2 over nothing, 0.5 m x 0.4 m. */
static void make(struct fixture *f, const char *name)
{
    const struct contestant *c = NULL;
    struct message why;
    char model[64];
    const char *dot = strchr(name, '.');

    memset(f, 0, sizeof *f);
    snprintf(model, sizeof model, "%.*s", dot ? (int)(dot - name) : 63, name);
    REQUIRE(contestant_find(model, &c, &why) == STATUS_OK);
    f->model = c->model;
    model_defaults(f->model, &f->d);
    f->d.points[0] = 8;
    f->d.points[1] = 7;
    if (!strcmp(model, "mass_spring"))
        f->d.tolerance =
            1e-9; /* its 1e-6 of a cell is 1e-4 of what gravity moves in a step */
    set_variant(f, dot ? dot + 1 : "");
    f->settling = f->d.points[2] > 1 ? 450 / f->pieces : 0;
    REQUIRE(scene_init(&f->scene) == STATUS_OK);
    f->scene.length = 0.5;
    f->scene.width = 0.4;
    f->scene.thickness = 0.004;
    f->scene.young = 1e5;
    f->scene.poisson = 0.3;
    f->scene.density = 200;
    f->scene.gravity[2] = -9.81;
    f->scene.end = 10;
    f->xyz = malloc(3 * GRID_POINTS * sizeof *f->xyz);
    f->other = malloc(3 * GRID_POINTS * sizeof *f->other);
    REQUIRE(f->xyz && f->other);
}

static void clear(struct fixture *f)
{
    f->model->destroy(f->state);
    scene_clear(&f->scene);
    free(f->xyz);
    free(f->other);
}

static bool is_of_net(const struct fixture *f)
{
    return !strcmp(f->model->name, "mass_spring") ||
           !strcmp(f->model->name, "projective_dynamics");
}

/* Models that have no number of substeps halve their steps where Newton's method fails. */
static void start(struct fixture *f)
{
    struct message why = {{0}};

    longest = f->pieces > 1 ? 1.01 * f->scene.step / f->pieces : INFINITY;
    if (f->pieces > 1 && is_of_net(f))
        f->d.substeps = f->pieces;
    if (!CHECK(f->model->create(&f->scene, &f->d, &f->state, &why) == STATUS_OK))
        printf("%s\n", why.text);
    REQUIRE(f->state);
}

static void advance(struct fixture *f)
{
    struct counters counters = {0};

    enum status st = f->model->advance(f->state, &counters);
    if (!CHECK(st == STATUS_OK))
        printf("%s: %s\n", f->model->name, status_text(st));
    CHECK(f->pieces == 1 || counters.substeps == f->pieces);
    REQUIRE(st == STATUS_OK);
    f->model->sample(f->state, f->xyz);
}

static struct model_contact contact_of(const struct fixture *f)
{
    struct model_contact c;

    f->model->contact(f->state, &c);
    return c;
}

static double energy_of(const struct fixture *f)
{
    struct energy e;

    f->model->energy(f->state, &e);
    return e.kinetic + e.elastic + e.potential;
}

/* Paper's parameters have a mass of their own: 1 kg for projective dynamics, 1 kg/m^2 for
 * mass-spring. */
static double weight_of(const struct fixture *f)
{
    const struct scene *s = &f->scene;
    double area = s->length * s->width;

    if (f->d.parameters == PARAMETERS_PAPER)
        return 9.81 * (!strcmp(f->model->name, "mass_spring") ? area : 1);
    return 9.81 * s->density * s->thickness * area;
}

static void add_floor(struct fixture *f, double below, double friction)
{
    struct scene_obstacle floor = {.kind = OBSTACLE_PLANE,
                                   .normal = {0, 0, 2},
                                   .friction = friction,
                                   .point = {3, -1, -f->scene.thickness / 2 - below}};

    REQUIRE(scene_add_obstacle(&f->scene, &floor) == STATUS_OK);
}

/* A ball below the middle of the sheet, somewhat off so that nothing is symmetric. */
static void add_ball(struct fixture *f, double below, double friction)
{
    struct scene_obstacle ball = {.kind = OBSTACLE_SPHERE,
                                  .radius = 0.12,
                                  .friction = friction,
                                  .point = {0.26, 0.19, 0}};

    ball.point[2] = -f->scene.thickness / 2 - below - ball.radius;
    REQUIRE(scene_add_obstacle(&f->scene, &ball) == STATUS_OK);
}

static void turn(const double axis[3], double angle, double x[3])
{
    double along = axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2], y[3];

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        y[i] = cos(angle) * x[i] + sin(angle) * (axis[j] * x[k] - axis[k] * x[j]) +
               (1 - cos(angle)) * along * axis[i];
    }
    memcpy(x, y, sizeof y);
}

/* The whole scene about the origin, gravity only if asked. */
static void turn_scene(struct scene *s, const double axis[3], double angle, bool gravity)
{
    turn(axis, angle, s->origin);
    turn(axis, angle, s->axis_u);
    turn(axis, angle, s->axis_v);
    if (gravity)
        turn(axis, angle, s->gravity);
    for (int o = 0; o < s->obstacle_count; o++) {
        turn(axis, angle, s->obstacles[o].point);
        turn(axis, angle, s->obstacles[o].normal);
    }
}

/* Lying on the floor: stays there, and the floor carries the weight. */
static void check_rest(const char *name, double friction)
{
    struct fixture f;

    make(&f, name);
    add_floor(&f, 0, friction);
    settle(&f, 300);
    start(&f);
    double weight = weight_of(&f);
    for (int n = 0; n < f.settling; n++)
        advance(&f);
    if (f.d.integrator == INTEGRATOR_LEAPFROG)
        advance(&f); /* its first kick is half a one */
    for (int n = 0; n < 20; n++) {
        advance(&f);
        struct model_contact c = contact_of(&f);
        CHECK_RELATIVE(c.force[2], weight, BALANCE);
        CHECK_NEAR(c.force[0], 0, BALANCE * weight);
        CHECK_NEAR(c.force[1], 0, BALANCE * weight);
        CHECK(c.nodes > 0);
        CHECK_NEAR(c.least_gap, 0, CLOSED);
    }
    CHECK_NEAR(f.xyz[2], -f.scene.thickness / 2, CLOSED);
    CHECK_NEAR(f.xyz[0], 0, STUCK);
    clear(&f);
}

/* A fall: no node inside at any frame, no energy out of nothing, and the obstacle pushes.
 */
static void check_fall(const char *name, bool ball, double friction)
{
    struct fixture f;
    enum { FRAMES = 60 };
    double pushed = 0, deepest = 0, most = -INFINITY;

    make(&f, name);
    if (ball)
        add_ball(&f, 0.02, friction);
    else
        add_floor(&f, 0.02, friction);
    turn_scene(&f.scene, (const double[3]){0.6, 0.8, 0}, 0.02, false);
    start(&f);
    double fall = weight_of(&f) * 0.03, low = energy_of(&f);
    for (int n = 0; n < FRAMES; n++) {
        advance(&f);
        struct model_contact c = contact_of(&f);
        double now = energy_of(&f);
        CHECK(c.least_gap >= -CLOSED);
        CHECK(isfinite(now) || f.d.kinematics == KINEMATICS_INCREMENTAL);
        most = fmax(most, now - low);
        low = fmin(low, now);
        pushed += c.force[2] * f.scene.step;
        deepest = fmax(deepest, metric_penetration(&f.scene, f.xyz));
    }
    CHECK(pushed > 0.1 * weight_of(&f) * FRAMES * f.scene.step);
    CHECK(most <= f.gain * fall || f.d.kinematics == KINEMATICS_INCREMENTAL);
    printf("%s on a %s: energy gain %.2g of the fall, grid %.2g m deep at most\n", name,
           ball ? "ball" : "floor", most / fall, deepest);
    if (!ball)
        CHECK(deepest <= CLOSED);
    if (!ball && !f.settling)
        CHECK_RELATIVE(contact_of(&f).force[2], weight_of(&f), LANDED);
    clear(&f);
}

/* Centre of mass along `down`, by the trapezoidal rule on the grid. */
static double centre_along(const struct fixture *f, const double down[3])
{
    double sum = 0, total = 0;

    for (int n = 0; n < GRID_POINTS; n++) {
        int i = n % GRID_U, j = n / GRID_U % GRID_V;
        double weight = (i % (GRID_U - 1) ? 1 : 0.5) * (j % (GRID_V - 1) ? 1 : 0.5);
        total += weight;
        for (int k = 0; k < 3; k++)
            sum += weight * down[k] * f->xyz[3 * n + k];
    }
    return sum / total;
}

/* On an incline of `slope`: along it the centre gains g (sin - mu cos) in each of the last
 * steps, or nothing. The second difference of three frames is exact for every scheme. */
static void check_incline(const char *name, double slope, double friction)
{
    struct fixture f;
    double along[3] = {0}, from = 0;
    double pull = 9.81 * (sin(slope) - friction * cos(slope));
    const double down[3] = {cos(slope), 0, -sin(slope)};

    make(&f, name);
    add_floor(&f, 0, friction);
    settle(&f, 0);
    /* what BDF2's start is off by shrinks to a third a step */
    const int frames = f.settling + (f.d.integrator == INTEGRATOR_BDF2 ? 30 : 12);
    turn_scene(&f.scene, (const double[3]){0, 1, 0}, slope, false);
    start(&f);
    f.model->sample(f.state, f.xyz);
    for (int n = 0; n < frames; n++) {
        if (n == f.settling)
            from = centre_along(&f, down);
        advance(&f);
        along[n % 3] = centre_along(&f, down);
        double twice = along[n % 3] - 2 * along[(n + 2) % 3] + along[(n + 1) % 3];
        if (pull > 0 && n > frames - 10)
            CHECK_NEAR(twice / pow(f.scene.step, 2), pull, 9.81 * BALANCE);
    }
    if (pull <= 0)
        CHECK_NEAR(along[(frames - 1) % 3], from, STUCK * f.scene.length);
    clear(&f);
}

/* Turned with all that belongs to it, a scene moves as before. */
static void check_turned(const char *name)
{
    const double axis[3] = {0.36, 0.48, 0.8};
    struct fixture f[2];
    double worst = 0;

    for (int k = 0; k < 2; k++) {
        make(&f[k], name);
        add_ball(&f[k], 0.01, 0.2);
        add_floor(&f[k], 0.15, 0.2);
        if (k)
            turn_scene(&f[k].scene, axis, 1.1, true);
        start(&f[k]);
        for (int n = 0; n < 30; n++)
            advance(&f[k]);
    }
    for (int n = 0; n < GRID_POINTS; n++) {
        turn(axis, 1.1, f[0].xyz + 3 * n);
        for (int i = 0; i < 3; i++)
            worst = fmax(worst, fabs(f[0].xyz[3 * n + i] - f[1].xyz[3 * n + i]));
    }
    CHECK_NEAR(worst / f[0].scene.length, 0, TURNED);
    clear(&f[0]);
    clear(&f[1]);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    check_rest(argv[1], 0.5);
    if (strstr(argv[1], ".quarters"))
        return check_result();
    check_rest(argv[1], 0);
    check_fall(argv[1], false, 0);
    check_fall(argv[1], false, 0.3);
    check_fall(argv[1], true, 0);
    check_fall(argv[1], true, 0.3);
    if (!strstr(argv[1], ".paper")) { /* which has a damping of its own */
        check_incline(argv[1], 0.4, 0);
        check_incline(argv[1], 0.4, 0.2);
    }
    check_incline(argv[1], 0.4, 0.6);
    check_turned(argv[1]);
    return check_result();
}
