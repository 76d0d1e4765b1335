/* Contact with obstacles, held to what every model owes: no way through, energy, no
 * preferred direction, and, of solids, what each kinematics promises; of variants that
 * `clothbench verify contact` has not, also the weight and the gap of the law under it,
 * Coulomb's law on an incline and the creep below its cone.
 * One program, a row of tests/CMakeLists.txt a model: contact_truth MODEL[.VARIANT]. */

#include "models/contact/contact_law.h"
#include "models/grid.h"
#include "models/mechanics/large_newton.h"
#include "models/metric/metric.h"
#include "tests/opened_run.h"

/* Gaps of the net: those of the law to round-off of the model's solver [m]. */
static const double CLOSED = 1e-11;

/* Force of a sheet at rest against its weight; acceleration on an incline against g. */
static const double BALANCE = 1e-6;

/* Force of a sheet that has landed, on a floor which is tilted by 0.02: cos^2 of that. */
static const double LANDED = 1e-3;

/* Iterations end at 1e-6 to 1e-8 of the length. */
static const double STUCK = 1e-5, TURNED = 1e-4;

/* The creep's speed; the paper's parameters drag at points by 5.2e-3 of friction. */
static const double CREEP = 9e-3;

/* What a flat impact keeps, of the energy at the speed of rebound: what leaves comes near
 * to that speed as exp(-V), V = 316; the last step, which ends beyond the contact, has less
 * of a push. */
static const double ROUNDED = 1e-9, LEFT_OUT = 1e-3;

/* This may be left of a lean of first order on a rod. */
static const double LEAN = 0.1;

/* Energy that an impact may add, of the energy that the sheet fell with. Explicit steps
 * have their velocities half a step before their positions: the energy of both swings with
 * the step (0.08 where a frame is two), also without obstacles. */
#define GAIN          1e-3
#define GAIN_EXPLICIT 0.1

enum { SETTINGS = 12, QUARTERS = 4, SETTLING = 60 }; /* frames until it lies */

/* MODEL.VARIANT: settings and the allowed gain. */
#define KEY "discretization."
static const struct variant {
    const char *name, *settings[3];
    double gain;
} variants[] = {
    {"", {0}, GAIN},
    {"explicit", {KEY "integrator=explicit"}, GAIN_EXPLICIT},
    {"leapfrog", {KEY "integrator=leapfrog"}, GAIN_EXPLICIT},
    {"momentum", {KEY "integrator=momentum"}, GAIN},
    {"quarters", {0}, GAIN},
    {"paper", {KEY "parameters=paper"}, GAIN},
    {"pbd", {KEY "projection=pbd"}, GAIN},
    {"edges", {KEY "constraint=edges"}, GAIN},
    {"chebyshev", {KEY "acceleration=chebyshev"}, GAIN},
    {"admm", {KEY "acceleration=admm"}, GAIN},
    {"bdf2", {KEY "integrator=bdf2"}, GAIN},
    {"nonlinear", {KEY "kinematics=nonlinear"}, GAIN},
    {"irregular", {KEY "mesh=irregular", KEY "seed=2"}, GAIN},
};

/* The longest piece of a step that Newton's method is let solve [s]. */
static double longest = INFINITY;

enum status __real_large_newton_solve(struct march *m, const struct large_equation *e,
                                      double *x, struct counters *counters);
enum status __wrap_large_newton_solve(struct march *m, const struct large_equation *e,
                                      double *x, struct counters *counters);
enum status __wrap_large_newton_solve(struct march *m, const struct large_equation *e,
                                      double *x, struct counters *counters)
{
    if (e->mass < 2 / (longest * longest)) /* the motion halves its step */
        return STATUS_DIVERGED;
    return __real_large_newton_solve(m, e, x, counters);
}

struct fixture {
    struct run run;
    const struct variant *variant;
    int pieces;  /* that a step must be taken in; 1: any                                */
    bool swings; /* through its thickness, as solids do                                 */
    double xyz[3 * GRID_POINTS];
};

/* Reads a free sheet of 0.8 kg/m^2 over nothing, 0.5 m x 0.4 m, with more settings. */
static void read_sheet(struct fixture *f, const char *name, const char *const *more)
{
    const char *dot = strchr(name, '.'), *variant = dot ? dot + 1 : "";
    char model[64];
    struct case_plan plan = {"ground", NULL, {0}, 0};
    struct message why = {""};

    memset(f, 0, sizeof *f);
    snprintf(model, sizeof model, "%.*s", dot ? (int)(dot - name) : 63, name);
    REQUIRE(contestant_find(model, &plan.contestant, NULL) == STATUS_OK);
    for (f->variant = variants; strcmp(f->variant->name, variant);)
        REQUIRE(++f->variant < variants + sizeof variants / sizeof *variants);
    const bool quarters = !strcmp(variant, "quarters");
    f->pieces = quarters ? QUARTERS : 1;
    f->swings = plan.contestant->layers > 0;
    settings_set_all(
        &plan.settings, 7,
        (const char *const[]){"sheet={length: 0.5, width: 0.4, thickness: 0.004}",
                              "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}",
                              "material={young: 1e5, poisson: 0.3, density: 200}",
                              "damping={kind: none}", "obstacles=[]",
                              "time={step: 0.005, end: 10}", "snapshots=[]"});
    contestant_points(plan.contestant, quarters ? 4 : 8, quarters ? 4 : 7, &plan.settings);
    /* its 1e-6 of a cell is 1e-4 of what gravity moves in a step, and 0.4 % of the gap */
    if (!strcmp(model, "mass_spring") &&
        (!*variant || quarters || !strcmp(variant, "paper")))
        settings_set(&plan.settings, KEY "tolerance=1e-10");
    /* a default ends where 1 % of the loads is left: here what a scheme converges to is
     * tested */
    if (strstr(model, "projective"))
        settings_set(&plan.settings, KEY "tolerance=1e-9");
    if (quarters && (!strcmp(model, "mass_spring") || strstr(model, "projective")))
        settings_integer(&plan.settings, KEY "substeps", QUARTERS);
    settings_list(&plan.settings, 3, f->variant->settings);
    settings_list(&plan.settings, SETTINGS, more);
    CHECK_SAY(run_read(&f->run, &plan, &why) == STATUS_OK, "%s", why.text);
    settings_clear(&plan.settings);
}

static void make(struct fixture *f, const char *name)
{
    read_sheet(f, name, (const char *const[]){NULL});
}

/* Models that have no number of substeps halve their steps where Newton's method fails. */
static void start(struct fixture *f)
{
    longest = f->pieces > 1 && !f->run.discretization.substeps
                  ? 1.01 * f->run.scene.step / f->pieces
                  : INFINITY;
    opened_build(&f->run);
}

static void advance(struct fixture *f)
{
    const struct counters work = opened_steps(&f->run, 1);

    CHECK(f->pieces == 1 || work.substeps == f->pieces);
    model_sample(f->run.model, f->run.state, f->xyz);
}

static struct model_contact contact_of(const struct fixture *f)
{
    struct model_contact c;

    f->run.model->contact(f->run.state, &c);
    return c;
}

/* Paper's parameters have a mass of their own: 1 kg for projective dynamics, 1 kg/m^2 for
 * mass-spring. */
static double weight_of(const struct fixture *f)
{
    const struct scene *s = &f->run.scene;
    double area = s->length * s->width;

    if (f->run.discretization.parameters == PARAMETERS_PAPER)
        return 9.81 * (!strcmp(f->run.model->name, "mass_spring") ? area : 1);
    return 9.81 * s->density * s->thickness * area;
}

/* Returns how far from the start of contact a plane carries the sheet's weight [m], <= 0.
 */
static double resting(const struct fixture *f)
{
    const struct scene *s = &f->run.scene;
    const struct contact_law law = contact_law_body(s);
    const double pressure = weight_of(f) / (s->length * s->width);

    return contact_law_distance(&law, pressure) - law.start;
}

/* Returns how far nodes may come nearer than the start of contact [m]: to the wall. */
static double deepest_gap(const struct fixture *f)
{
    return contact_law_body(&f->run.scene).range;
}

static void add_plane(struct fixture *f, double x, double z, double below, double friction)
{
    struct scene_obstacle plane = {
        .kind = OBSTACLE_PLANE,
        .normal = {2 * x, 0, 2 * z},
        .friction = friction,
        .point = {x == 0 ? 3 : 0, -1, -f->run.scene.thickness / 2 - below}};

    REQUIRE(scene_add_obstacle(&f->run.scene, &plane) == STATUS_OK);
}

/* Adds a ball below the middle of the sheet, somewhat off so that nothing is symmetric. */
static void add_ball(struct fixture *f, double below, double friction)
{
    struct scene_obstacle ball = {.kind = OBSTACLE_SPHERE,
                                  .radius = 0.12,
                                  .friction = friction,
                                  .point = {0.26, 0.19, 0}};

    ball.point[2] = -f->run.scene.thickness / 2 - below - ball.radius;
    REQUIRE(scene_add_obstacle(&f->run.scene, &ball) == STATUS_OK);
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

enum ground { FLOOR, BALL, GROOVE }; /* the ball lies on a floor */

static void add_ground(struct fixture *f, enum ground ground, double friction)
{
    if (ground == BALL)
        add_ball(f, 0.02, friction);
    if (ground != GROOVE) {
        add_plane(f, 0, 1, ground == BALL ? 0.1 : 0.02, friction);
        return;
    }
    add_plane(f, 0.3, 1, 0.1, friction);
    add_plane(f, -0.3, 1, 0.25, friction);
}

/* Lying on the floor: stays there, and the floor carries the weight. */
static void check_rest(const char *name, double friction)
{
    static struct fixture f;

    make(&f, name);
    const double gap = resting(&f);
    add_plane(&f, 0, 1, 0, friction);
    start(&f);
    double weight = weight_of(&f);
    for (int n = 0; n < SETTLING; n++)
        advance(&f);
    for (int n = 0; n < 20; n++) {
        advance(&f);
        struct model_contact c = contact_of(&f);
        CHECK_RELATIVE(c.force[2], weight, BALANCE);
        CHECK_NEAR(c.force[0], 0, BALANCE * weight);
        CHECK_NEAR(c.force[1], 0, BALANCE * weight);
        CHECK(c.nodes > 0);
        CHECK_NEAR(c.least_gap, gap, CLOSED);
    }
    CHECK_NEAR(f.xyz[2], gap - f.run.scene.thickness / 2, CLOSED);
    CHECK_NEAR(f.xyz[0], 0, STUCK);
    run_close(&f.run);
}

/* A fall: no node inside at any frame, no energy out of nothing, and the obstacle pushes.
 */
static void check_fall(const char *name, enum ground ground, double friction)
{
    static struct fixture f;
    enum { FRAMES = 60 };
    double pushed = 0, deepest = 0, most = -INFINITY;

    make(&f, name);
    add_ground(&f, ground, friction);
    turn_scene(&f.run.scene, (const double[3]){0.6, 0.8, 0}, 0.02, false);
    start(&f);
    double fall = weight_of(&f) * 0.03, low = opened_total(&f.run);
    for (int n = 0; n < FRAMES; n++) {
        advance(&f);
        struct model_contact c = contact_of(&f);
        double now = opened_total(&f.run);
        CHECK(c.least_gap >= -deepest_gap(&f));
        CHECK(isfinite(now));
        most = fmax(most, now - low);
        low = fmin(low, now);
        pushed += c.force[2] * f.run.scene.step;
        deepest = fmax(deepest, metric_penetration(&f.run.scene, 0, f.xyz));
    }
    CHECK(metric_blowup(&f.run.scene, 0, f.xyz) == STATUS_OK);
    CHECK(pushed > 0.1 * weight_of(&f) * FRAMES * f.run.scene.step);
    CHECK(!(most > f.variant->gain * fall));
    printf("%s on ground %d: energy gain %.2g of the fall, grid %.2g m deep at most\n",
           name, (int)ground, most / fall, deepest);
    if (ground == FLOOR)
        CHECK(deepest <= deepest_gap(&f));
    if (ground == FLOOR && !f.swings)
        CHECK_RELATIVE(contact_of(&f).force[2], weight_of(&f), LANDED);
    run_close(&f.run);
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
 * steps; or it creeps, at v (1 - sqrt(1 - tan / mu)) with the law's speed v, as friction is
 * 2 y - y^2 of mu at y = v_slip / v. The second difference of three frames is exact for
 * every scheme. */
static void check_incline(const char *name, double slope, double friction)
{
    static struct fixture f;
    double along[3] = {0};
    double pull = 9.81 * (sin(slope) - friction * cos(slope));
    const double down[3] = {cos(slope), 0, -sin(slope)};

    make(&f, name);
    add_plane(&f, 0, 1, 0, friction);
    const int frames = SETTLING + 12;

    turn_scene(&f.run.scene, (const double[3]){0, 1, 0}, slope, false);
    start(&f);
    model_sample(f.run.model, f.run.state, f.xyz);
    for (int n = 0; n < frames; n++) {
        advance(&f);
        along[n % 3] = centre_along(&f, down);
        double twice = along[n % 3] - 2 * along[(n + 2) % 3] + along[(n + 1) % 3];
        if (pull > 0 && n > frames - 10)
            CHECK_NEAR(twice / pow(f.run.scene.step, 2), pull, 9.81 * BALANCE);
    }
    if (pull <= 0) {
        double way = along[(frames - 1) % 3] - along[(frames - 2) % 3];
        CHECK_RELATIVE(way / f.run.scene.step,
                       contact_law_body(&f.run.scene).creep *
                           (1 - sqrt(1 - tan(slope) / friction)),
                       CREEP);
    }
    run_close(&f.run);
}

static void check_inclines(const char *name)
{
    if (!strstr(name, ".paper")) { /* which has a damping of its own */
        check_incline(name, 0.4, 0);
        check_incline(name, 0.4, 0.2);
    }
    check_incline(name, 0.4, 0.6);
}

/* Whether `clothbench verify contact --quick` has the model's rest, slides and creep. Of
 * solids it has all but explicit ones, which take the steps of explicit shells. */
static bool is_verified(const char *name)
{
    const char *variant = strchr(name, '.');

    return variant ? !strcmp(variant, ".momentum") : strcmp(name, "vbd") != 0;
}

/* Turned with all that belongs to it, a scene moves as before. */
static void check_turned(const char *name)
{
    const double axis[3] = {0.36, 0.48, 0.8};
    static struct fixture f[2];
    double worst = 0;

    for (int k = 0; k < 2; k++) {
        make(&f[k], name);
        add_ball(&f[k], 0.01, 0.2);
        add_plane(&f[k], 0, 1, 0.15, 0.2);
        if (k)
            turn_scene(&f[k].run.scene, axis, 1.1, true);
        start(&f[k]);
        for (int n = 0; n < 30; n++)
            advance(&f[k]);
    }
    for (int n = 0; n < GRID_POINTS; n++) {
        turn(axis, 1.1, f[0].xyz + 3 * n);
        for (int i = 0; i < 3; i++)
            worst = fmax(worst, fabs(f[0].xyz[3 * n + i] - f[1].xyz[3 * n + i]));
    }
    CHECK_NEAR(worst / f[0].run.scene.length, 0, TURNED);
    run_close(&f[0].run);
    run_close(&f[1].run);
}

/* A flat sheet that is thrown onto the floor, without gravity, and meets it at the end of a
 * frame: the trapezoidal rule would throw it back in the next one at the speed that it came
 * with. It leaves with the energy of the law's restitution (contact_law.h), W/V = 1/V of
 * what comes as fast, no more and no less. */
static void check_impact(const char *name, bool solid)
{
    static struct fixture f;
    struct energy before, after;
    enum { FALL = 10, MOST = 1000 };
    const double speed = 0.5;
    int frames = 0;

    read_sheet(&f, name,
               (const char *const[]){"sheet={length: 1, width: 1, thickness: 0.01}",
                                     "material.density=0.5", "gravity=[0,0,0]",
                                     "motion={velocity: [0,0,-0.5]}",
                                     solid ? KEY "unknowns=points" : NULL, NULL});
    const struct contact_law law = contact_law_body(&f.run.scene);
    add_plane(&f, 0, 1, speed * FALL * f.run.scene.step * (1 + 1e-9), 0);
    start(&f);
    opened_steps(&f.run, FALL);
    f.run.model->energy(f.run.state, &before);
    CHECK(contact_of(&f).nodes == 0);
    opened_steps(&f.run, 1);
    CHECK(contact_of(&f).nodes > 0);
    for (; contact_of(&f).nodes > 0 && frames < MOST; frames++)
        opened_steps(&f.run, 1);
    CHECK(frames < MOST);
    f.run.model->energy(f.run.state, &after);
    const double kept = after.kinetic / before.kinetic * pow(speed / law.rebound, 2);
    printf("%s keeps 1 %+.1e of the energy of rebound\n", name, kept - 1);
    CHECK(kept <= 1 + ROUNDED && kept >= 1 - LEFT_OUT);
    run_close(&f.run);
}

/* Returns the angle at which a block is that slid for a time t [s] from the top of a round
 * rod of radius R at the speed v, by Heun's method: R theta'' = g sin - mu (g cos - R
 * theta'^2). */
static double slid_to(double v, double mu, double R, double t)
{
    enum { PARTS = 10000 };
    const double dt = t / PARTS, g = 9.81;
    double angle = 0, rate = v / R;

    for (int n = 0; n < PARTS; n++) {
        double a[2], end[2] = {angle, rate};
        for (int k = 0; k < 2; k++) {
            a[k] = g / R * (sin(end[0]) - mu * cos(end[0])) + mu * end[1] * end[1];
            end[0] += dt * rate, end[1] += dt * a[0];
        }
        angle += dt * (rate + dt / 2 * a[0]);
        rate += dt / 2 * (a[0] + a[1]);
    }
    return angle;
}

/* A small sheet that slides over a rod: the pressure that a step has along the normal of
 * its end leans by v dt / 2R, and leads ahead by g v dt t^2 / 4R^2; of that little is left.
 */
static void check_round(const char *name)
{
    static struct fixture f;
    enum { STEPS = 80 };
    const double dt = 0.0025, t = STEPS * dt, v = 1.5, R = 1.002, mu = 0.2;

    read_sheet(&f, name,
               (const char *const[]){"sheet={length: 1e-3, width: 1e-3, thickness: 0.004}",
                                     "pose={origin: [-5e-4,-5e-4,1.0020001], u: [1,0,0], "
                                     "v: [0,1,0]}",
                                     "motion={velocity: [1.5,0,0]}", "time.step=0.0025",
                                     "contact={self: false, stiffness: 1e7}",
                                     "obstacles=[{capsule: {from: [0,-1,0], to: [0,1,0], "
                                     "radius: 1, friction: 0.2}}]",
                                     NULL});
    start(&f);
    opened_steps(&f.run, STEPS);
    model_sample(f.run.model, f.run.state, f.xyz);
    const double *x = f.xyz, ahead = atan2(x[0] + x[3 * (GRID_POINTS - 1)],
                                           x[2] + x[3 * (GRID_POINTS - 1) + 2]) -
                                     slid_to(v, mu, R, t);
    const double lead = 9.81 * v * dt * t * t / (4 * R * R);
    printf("%s slides %.2g of a lean ahead\n", name, ahead / lead);
    CHECK_NEAR(ahead / lead, 0, LEAN);
    run_close(&f.run);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    const char *name = argv[1];
    const bool solid = !strncmp(name, "iga", 3) || !strncmp(name, "hex", 3);
    const int falls = strstr(name, ".quarters") ? 0
                      : solid && strstr(name, ".leapfrog")
                          ? 4 /* hundreds of steps a frame */
                          : 5;
    for (int n = 0; n < falls; n++)
        check_fall(name, (enum ground)(n / 2), n % 2 ? 0 : 0.3);
    if (!solid && !is_verified(name))
        check_rest(name, 0.5);
    if (strstr(name, ".quarters"))
        return check_result();
    if (!solid && !is_verified(name))
        check_inclines(name);
    check_turned(name);
    if (strstr(name, ".nonlinear") || !strcmp(name, "shell") || !strcmp(name, "triangles"))
        check_impact(name, solid);
    if (!strcmp(name, "mass_spring.momentum") || !strcmp(name, "shell") ||
        !strcmp(name, "triangles"))
        check_round(name);
    return check_result();
}
