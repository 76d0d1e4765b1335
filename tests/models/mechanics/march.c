/* The march itself, on the smallest body: two points and an elastic rod of Green's strain,
 * one point held. Each scheme in time against its closed form, order, or what it keeps; and
 * what all of them share: damping, loads, supports that move, equilibrium, modes. */
#include "models/mechanics/march.h"

#include <complex.h>

#include "tests/check.h"

static const double LENGTH = 0.7, RIGID = 40, MASS = 0.3, GRAVITY = 9.81; /* m, N, kg */

/* Sums of some hundred steps, and Newton's 1e-7 of the length. */
static const double ROUND_OFF = 1e-11, CONVERGED = 1e-6;

/* The rod: strain (l^2 - L^2) / (2 L^2), stress RIGID times it. */
struct rod {
    double strain[1], edge[3], geometry[3];
};

static void edge_of(const double *x, double e[3])
{
    for (int i = 0; i < 3; i++)
        e[i] = x[3 + i] - x[i];
}

static double strain_at(const double e[3])
{
    return ((e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) / (LENGTH * LENGTH) - 1) / 2;
}

static double *strain_of(const void *self, int thread, int element, const double *x,
                         const struct large_foresight *foresight)
{
    struct rod *r = (struct rod *)self;

    (void)thread, (void)element, (void)foresight;
    edge_of(x, r->edge);
    r->strain[0] = strain_at(r->edge);
    return r->strain;
}

static void set_geometry(const void *self, int thread, int element, const double *x_old,
                         double share)
{
    struct rod *r = (struct rod *)self;
    double old[3] = {0};

    (void)thread, (void)element;
    if (share < 1)
        edge_of(x_old, old);
    for (int i = 0; i < 3; i++)
        r->geometry[i] = (1 - share) * old[i] + share * r->edge[i];
}

static void add_force(const void *self, int thread, int element, double *force)
{
    const struct rod *r = self;

    (void)thread, (void)element;
    for (int i = 0; i < 3; i++) {
        const double f = RIGID * r->strain[0] * r->geometry[i] / LENGTH;
        force[i] -= f;
        force[3 + i] += f;
    }
}

static void add_tangent(const void *self, int thread, int element,
                        const struct large_path *path, double (*K)[9])
{
    const struct rod *r = self;
    const double *g = r->geometry;

    (void)thread, (void)element;
    for (int k = 0; k < 9; k++) {
        const double block = RIGID / LENGTH *
                             (path->s1 * g[k / 3] * g[k % 3] / (LENGTH * LENGTH) +
                              (k % 4 == 0 ? path->g1 * r->strain[0] : 0));
        K[0][k] += block;
        K[1][k] -= block;
        K[2][k] += block;
    }
}

static enum status energy_of(const void *self, const double *x, double *energy)
{
    double e[3];

    (void)self;
    edge_of(x, e);
    *energy = RIGID * LENGTH * strain_at(e) * strain_at(e) / 2;
    return STATUS_OK;
}

struct fixture {
    struct march march; /* first: march.h */
    struct scene scene;
    struct discretization d;
    struct rod rod;
    struct blocks graph;
    struct supports supports;
    double rest[6], mass[2], load[6], K[3][9];
};

/* The rod lies along x; its first point is held. K is that of the rod at rest, and as
 * stiff in all directions: then a linear body has closed forms. */
static void start(struct fixture *f, enum kinematics kinematics, enum integrator integrator)
{
    static const int nodes[] = {0, 1}, slab[] = {0, 1};
    double uvw[2][3] = {{0, 0.5, 0.5}, {1, 0.5, 0.5}};
    struct scene *s = &f->scene;

    REQUIRE(blocks_init(&f->graph, 2, 1, 2, nodes) == STATUS_OK);
    REQUIRE(supports_init(&f->supports, s, 2, uvw, f->rest, NULL) == STATUS_OK);
    for (int k = 0; k < 27; k++)
        f->K[k / 9][k % 9] = k % 9 % 4 ? 0 : (k / 9 == 1 ? -1 : 1) * RIGID / LENGTH;
    f->d.kinematics = kinematics;
    f->d.integrator = integrator;
    f->march = (struct march){
        .body = {.self = &f->rod,
                 .nodes = 2,
                 .slabs = 1,
                 .threads = 1,
                 .slab = slab,
                 .pairs = 3,
                 .strains = 1,
                 .strain = strain_of,
                 .geometry = set_geometry,
                 .force = add_force,
                 .tangent = add_tangent,
                 .energy = energy_of},
        .scene = s,
        .graph = &f->graph,
        .mass = f->mass,
        .stiffness = kinematics == KINEMATICS_NONLINEAR ? NULL : (const double(*)[9])f->K,
        .rest = f->rest,
        .load = f->load,
        .net = {2, 1, 1},
        .supports = &f->supports,
        .unknowns = "mid-surface points",
    };
    REQUIRE(march_init(&f->march, &f->d, NULL) == STATUS_OK);
}

static void open_scene(struct fixture *f, double step)
{
    *f = (struct fixture){.rest = {0, 0, 0, LENGTH},
                          .mass = {MASS, MASS},
                          .load = {0, 0, -MASS * GRAVITY, 0, 0, -MASS * GRAVITY}};
    REQUIRE(scene_init(&f->scene) == STATUS_OK);
    f->scene.step = step;
    f->scene.length = LENGTH;
    const struct scene_support held = {.hi = {0, 1, 1}, .fix = FIX_XYZ};
    REQUIRE(scene_add_support(&f->scene, &held) == STATUS_OK);
}

static void close_scene(struct fixture *f)
{
    march_clear(&f->march);
    supports_clear(&f->supports);
    blocks_clear(&f->graph);
    scene_clear(&f->scene);
}

static void go(struct fixture *f, int steps)
{
    struct counters work = {0};

    for (int n = 0; n < steps; n++)
        REQUIRE(march_step(f, &work) == STATUS_OK);
    CHECK(work.steps == steps);
}

/* Returns what the trapezoidal rule makes of q'' + c q' + lambda q = 0 from q and v after n
 * steps, exactly: roots s of s^2 + c s + lambda are mapped to
 * z = (1 + s dt/2) / (1 - s dt/2). */
static double trapezoidal(double c, double lambda, double q, double v, double dt, int n)
{
    const double complex root = csqrt(c * c / 4 - lambda), s1 = -c / 2 + root,
                         s2 = -c / 2 - root;
    const double complex z1 = (1 + s1 * dt / 2) / (1 - s1 * dt / 2),
                         z2 = (1 + s2 * dt / 2) / (1 - s2 * dt / 2);

    return creal(((s2 * q - v) * cpow(z1, n) - (s1 * q - v) * cpow(z2, n)) / (s2 - s1));
}

/* Holds the scene's support on a path of that speed along z. */
static void move_support(struct scene *s, double speed)
{
    const double path[] = {-1, 0, 0, -speed, 10, 0, 0, 10 * speed};

    s->supports[0].motion.path = malloc(sizeof path);
    REQUIRE(s->supports[0].motion.path);
    s->supports[0].motion.path_count = 2;
    memcpy(s->supports[0].motion.path, path, sizeof path);
}

/* A spring is thrown, below a point that is still or moves at a constant speed; its
 * dampings are those that are linear. In the point's frame mass damping is a load, too. */
static void check_newmark(double speed)
{
    static const struct scene_damping damping[] = {
        {.kind = DAMPING_NONE},
        {.kind = DAMPING_MASS, .value = 1.5},
        {.kind = DAMPING_RAYLEIGH, .alpha = 0.7, .beta = 0.02}};
    enum { STEPS = 200 };
    const double step = 0.01, lambda = RIGID / LENGTH / MASS, thrown = 0.3;

    for (size_t n = 0; n < sizeof damping / sizeof *damping; n++) {
        const double alpha = damping[n].value + damping[n].alpha,
                     c = alpha + damping[n].beta * lambda,
                     rest = -(GRAVITY + alpha * speed) / lambda;
        struct fixture f;
        open_scene(&f, step);
        f.scene.damping = damping[n];
        f.scene.velocity[2] = thrown;
        move_support(&f.scene, speed);
        start(&f, KINEMATICS_LINEAR, INTEGRATOR_IMPLICIT);
        go(&f, STEPS);
        CHECK_NEAR(f.march.x[5],
                   speed * STEPS * step + rest +
                       trapezoidal(c, lambda, -rest, thrown - speed, step, STEPS),
                   ROUND_OFF);
        CHECK_NEAR(f.march.x[3], LENGTH, ROUND_OFF);
        close_scene(&f);
    }
}

/* Returns how far off the end is after half a second, in steps, of what fine ones give. */
static double distance_after(enum integrator integrator, bool euler, int steps,
                             const double *fine, double *x)
{
    struct fixture f;
    double sum = 0;

    open_scene(&f, 0.5 / steps);
    start(&f, KINEMATICS_NONLINEAR, integrator);
    f.march.euler = euler;
    go(&f, steps);
    memcpy(x, f.march.x, 6 * sizeof *x);
    for (int i = 0; fine && i < 6; i++)
        sum += (x[i] - fine[i]) * (x[i] - fine[i]);
    close_scene(&f);
    return sqrt(sum);
}

/* The order in time, from both sides, of a swing that stretches the rod. */
static void check_order(enum integrator integrator, bool euler, double want)
{
    const double ORDER = 0.1; /* of steps that are not yet infinitely short */
    double fine[6], x[6];

    distance_after(INTEGRATOR_IMPLICIT, false, 20000, NULL, fine);
    const double coarse = distance_after(integrator, euler, 200, fine, x);
    const double half = distance_after(integrator, euler, 400, fine, x);
    CHECK_NEAR(log2(coarse / half), want, ORDER);
}

/* Energy-momentum steps keep the energy of a swing, as far as Newton's method solves. */
static void check_energy(void)
{
    struct fixture f;
    double elastic;

    open_scene(&f, 0.01);
    start(&f, KINEMATICS_NONLINEAR, INTEGRATOR_IMPLICIT);
    for (int n = 0; n < 50; n++) {
        const double *v = f.march.v + 3;
        go(&f, 4);
        REQUIRE(energy_of(NULL, f.march.x, &elastic) == STATUS_OK);
        const double kinetic = MASS * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2;
        CHECK_NEAR((elastic + kinetic) / (MASS * GRAVITY * LENGTH) + f.march.x[5] / LENGTH,
                   0, CONVERGED);
    }
    close_scene(&f);
}

static enum status same(struct march *m)
{
    (void)m;
    return STATUS_OK;
}

/* Without stiffness the paper's scheme falls by g (1 + mu) / (2 (1 - mu)) dt^2 a step in
 * the end. */
static void check_printed(void)
{
    const double mu = 0.5, step = 0.01;
    struct fixture f;

    open_scene(&f, step);
    f.scene.damping.kind = DAMPING_VELOCITY_SCALE;
    f.scene.damping.value = mu;
    start(&f, KINEMATICS_PRINTED, INTEGRATOR_IMPLICIT);
    f.march.rebuild = same;
    f.march.measure = f.mass, f.march.depth = 1;
    f.march.density[0] = 1;
    f.scene.gravity[2] = -GRAVITY;
    memset(f.K, 0, sizeof f.K);
    go(&f, 100);
    const double d = f.march.d[5];
    go(&f, 1);
    CHECK_NEAR((d - f.march.d[5]) / (step * step), GRAVITY * (1 + mu) / (2 * (1 - mu)),
               1e-9);
    close_scene(&f);
}

/* A factor on velocities, or a rate of them, acts once a step, and not on what is held. */
static void check_damping(void)
{
    static const struct scene_damping damping[] = {
        {.kind = DAMPING_VELOCITY_SCALE, .value = 0.25},
        {.kind = DAMPING_VELOCITY_RATE, .value = 75}};

    for (size_t n = 0; n < sizeof damping / sizeof *damping; n++) {
        struct fixture f;
        open_scene(&f, 0.01);
        f.scene.damping = damping[n];
        start(&f, KINEMATICS_LINEAR, INTEGRATOR_IMPLICIT);
        memset(f.K, 0, sizeof f.K);
        go(&f, 30);
        /* v <- 1/4 (v + g dt) */
        CHECK_NEAR(f.march.v[5], -GRAVITY * 0.01 / 3, ROUND_OFF);
        CHECK(f.march.v[2] == 0);
        close_scene(&f);
    }
}

/* It hangs by m g = RIGID e (l / L), and swings about that with w^2 = g / l; explicit steps
 * have nothing to solve with before that. */
static void check_rest(enum integrator integrator)
{
    struct fixture f;
    struct counters work = {0};
    double omega[3];

    open_scene(&f, 0.01);
    start(&f, KINEMATICS_NONLINEAR, integrator);
    go(&f, 1);
    CHECK((f.march.system.graph == NULL) == (integrator == INTEGRATOR_LEAPFROG));
    REQUIRE(march_equilibrium(&f, &work, NULL) == STATUS_OK);
    const double l = -f.march.x[5], e[3] = {f.march.x[3], f.march.x[4], f.march.x[5]};
    CHECK_NEAR(f.march.x[3], 0, CONVERGED);
    CHECK_NEAR(RIGID * strain_at(e) * l / LENGTH, MASS * GRAVITY, 1e-4 * MASS * GRAVITY);
    REQUIRE(march_modes(&f, 3, omega, NULL) == STATUS_OK);
    for (int n = 0; n < 2; n++)
        CHECK_RELATIVE(omega[n], sqrt(GRAVITY / l), 1e-4);
    CHECK(work.assemblies > 0 && f.march.v[5] == 0);
    close_scene(&f);
}

int main(void)
{
    check_newmark(0);
    check_newmark(0.4);
    check_order(INTEGRATOR_IMPLICIT, false, 2);
    check_order(INTEGRATOR_IMPLICIT, true, 1);
    check_order(INTEGRATOR_LEAPFROG, false, 2);
    check_energy();
    check_printed();
    check_damping();
    check_rest(INTEGRATOR_IMPLICIT);
    check_rest(INTEGRATOR_LEAPFROG);
    return check_result();
}
