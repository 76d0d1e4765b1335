/* Constraints on positions: what steps converge to, rest, damping. (Order in
 * time, single precision: time_order.c.) */
#include "position_based/position_based_model.h"
#include "projective_dynamics/pd_motion.h"
#include "tests/mass_spring.h"

/* A net under constraints that moves. */
struct constraints {
    struct scene scene;
    struct discretization d;
    struct pb_motion m;
};

static void init(struct constraints *s, int n, int m, bool held)
{
    *s = (struct constraints){.d = net_of(n, m)};
    s->d.iterations = 1;
    fill_scene(&s->scene, held);
}

static void begin(struct constraints *s)
{
    struct message why = {{0}};

    CHECK_SAY(pb_motion_init(&s->m, &s->scene, &s->d, &why) == STATUS_OK, "%s", why.text);
    REQUIRE(s->m.net.x);
}

static void frames(struct constraints *s, int count)
{
    struct counters counters = {0};

    for (int n = 0; n < count; n++)
        REQUIRE(pb_motion_frame(&s->m, &counters) == STATUS_OK);
}

static void clear(struct constraints *s)
{
    pb_motion_clear(&s->m);
    scene_clear(&s->scene);
}

static double distance(const double *a, const double *b, int numbers)
{
    double sum = 0;

    for (int n = 0; n < numbers; n++)
        sum += (a[n] - b[n]) * (a[n] - b[n]);
    return sqrt(sum);
}

/* A sheet that is thrown, of springs that hardly bend, for one step of three solvers. */
static void throw_sheet(struct scene *scene, double dt)
{
    scene->thickness = 1e-5;
    scene->young = 1e6;
    scene->step = dt;
    scene->spin[1] = 4;
}

/* Springs by Newton's method, projective dynamics and constraints make the same step of
 * implicit Euler (Liu et al. 2013), constraints but for what springs turn on the way: how
 * far off they end, of how far they moved. */
static double same_step(int n, int m, double dt, double *projective)
{
    struct springs springs;
    struct constraints pb;
    struct pd_motion pd;
    const struct pd_options o = {.points = {n, m},
                                 .constraint = CONSTRAINT_EDGES,
                                 .substeps = 1,
                                 .iterations = 200000,
                                 .tolerance = 1e-13};
    const int count = 3 * n * m;
    double *x = calloc((size_t)count, sizeof *x);

    REQUIRE(x);
    springs_init(&springs, n, m, true);
    throw_sheet(&springs.scene, dt);
    springs.d.tolerance = 1e-10;
    springs_start(&springs);
    springs_steps(&springs, 1);
    REQUIRE(pd_motion_init(&pd, &springs.scene, &o, NULL) == STATUS_OK);
    CHECK(pd_motion_frame(&pd, &springs.counters) == STATUS_OK);
    for (int a = 0; a < count; a++)
        x[a] = pd.x[a % 3 * pd_net_stride(&pd.energy.net) + a / 3];
    init(&pb, n, m, true);
    throw_sheet(&pb.scene, dt);
    pb.d.iterations = 3000, pb.d.substeps = 1;
    begin(&pb);
    frames(&pb, 1);
    double moved = distance(springs.m.net.x, springs.m.net.mesh.rest, count);
    *projective = distance(springs.m.net.x, x, count) / moved;
    double off = distance(springs.m.net.x, pb.m.net.x, count) / moved;
    pd_motion_clear(&pd);
    clear(&pb);
    springs_clear(&springs);
    free(x);
    return off;
}

static void check_same_step(void)
{
    const double iterated = 1e-6; /* 1e-13 of the length a round, at rates of 0.999 */
    double projective[2];
    double coarse = same_step(6, 5, 4e-3, &projective[0]);
    double fine = same_step(6, 5, 2e-3, &projective[1]);

    printf("one step: projective dynamics off springs by %.1e, %.1e; constraints by %.2e, "
           "with half the step %.2e\n",
           projective[0], projective[1], coarse, fine);
    CHECK(projective[0] < iterated && projective[1] < iterated);
    CHECK(coarse < 0.01);
    CHECK(coarse / fine > 3); /* of second order in what turns */
}

/* --- what it comes to rest at ------------------------------------------------------------
 */

/* Slope of the energy along a change of free components, over that of the loads. */
static double slope(struct pb_motion *m, int number)
{
    const double small = 1e-6;
    struct energy e[2];
    double loads = 0;

    for (int side = 0; side < 2; side++) {
        for (int n = 0; n < 3 * m->net.mesh.nodes; n++) {
            double step =
                m->net.supports.free_index[n] < 0 ? 0 : small * noise(n + 31 * number);
            m->net.x[n] += side ? -2 * step : step;
            loads += side ? 0 : fabs(step * m->net.load[n]);
        }
        pb_motion_energy(m, &e[side]);
    }
    for (int n = 0; n < 3 * m->net.mesh.nodes; n++)
        if (m->net.supports.free_index[n] >= 0)
            m->net.x[n] += small * noise(n + 31 * number);
    return fabs(e[0].elastic + e[0].potential - e[1].elastic - e[1].potential) /
           (2 * loads);
}

/* With enough iterations a sheet comes to rest where its energy has no slope, whatever the
 * size of its net: rows that fill vectors, and rows that do not. So thick, it bends in
 * every substep. */
static void check_rest(int n, int m, double nu, unsigned fix, double thickness)
{
    const double tolerance = 1e-3; /* e^-10 of the swing, and what iterations leave */
    struct scene_support corner = {.lo = {1, 1, 0}, .hi = {1, 1, 1}, .fix = fix};
    struct constraints s;

    init(&s, n, m, true);
    REQUIRE(scene_add_support(&s.scene, &corner) == STATUS_OK);
    s.scene.poisson = nu, s.scene.thickness = thickness, s.scene.young = 2e4;
    s.scene.damping = (struct scene_damping){.kind = DAMPING_VELOCITY_SCALE, .value = 0.9};
    s.d.substeps = 10, s.d.iterations = 30;
    begin(&s);
    CHECK(s.m.bending_every == 1);
    frames(&s, 300);
    for (int k = 0; k < 3; k++) {
        double off = slope(&s.m, k);
        CHECK_SAY(off < tolerance, "%d x %d, nu = %g: slope %.2e of the loads'", n, m, nu,
                  off);
    }
    clear(&s);
}

/* --- in time -----------------------------------------------------------------------------
 */

/* The energy of a cell that breathes along u after 0.2 s; *rate: beta omega^2 of it, K / M
 * over its springs and the two points that move. */
static double breath(double beta, double *rate)
{
    static const struct scene_support supports[] = {
        {.hi = {0, 1, 1}, .fix = FIX_XYZ},
        {.lo = {1, 0, 0}, .hi = {1, 1, 1}, .fix = FIX_Y | FIX_Z}};
    struct constraints s;
    struct energy e;
    double stiffness = 0;

    init(&s, 2, 2, false);
    for (int k = 0; k < 2; k++)
        REQUIRE(scene_add_support(&s.scene, &supports[k]) == STATUS_OK);
    memset(s.scene.gravity, 0, sizeof s.scene.gravity);
    s.scene.velocity[0] = 1e-3, s.scene.young = 1000;
    s.scene.damping = (struct scene_damping){.kind = DAMPING_RAYLEIGH, .beta = beta};
    s.d.substeps = 200;
    begin(&s);
    frames(&s, 40);
    pb_motion_energy(&s.m, &e);
    for (int n = 0; n < s.m.springs.spring_count; n++) {
        const struct spring *one = &s.m.springs.springs[n];
        double along = s.m.net.mesh.rest[3 * one->b] - s.m.net.mesh.rest[3 * one->a];
        stiffness += one->stiffness * along * along / (one->length * one->length);
    }
    *rate = beta * stiffness / (s.m.net.mass[2] + s.m.net.mass[3]);
    clear(&s);
    return e.kinetic + e.elastic;
}

/* Stiffness damping takes beta omega^2 of the energy a second; what the steps take besides
 * is in both. */
static void check_damping(void)
{
    const double tolerance = 0.03; /* where in its swing it ends: 1 / 2 omega t */
    double rate, before = breath(0, &rate), after = breath(2e-4, &rate);

    CHECK_RELATIVE(log(before / after), rate * 0.2, tolerance);
}

/* A single iteration of steps that are too long is told: springs give way. Those that go on
 * until they arrive do not. */
static void check_doubt(void)
{
    for (int k = 0; k < 2; k++) {
        struct constraints s;
        struct message line = {{0}};
        init(&s, 12, 12, true);
        s.d.substeps = k ? 0 : 1, s.d.iterations = k ? 0 : 1;
        begin(&s);
        frames(&s, 61);
        position_based_model.doubt(&s.m, &line);
        CHECK((line.text[0] == 0) == (k == 1));
        clear(&s);
    }
}

int main(void)
{
    check_same_step();
    check_rest(2, 3, 0.3, FIX_Z, 0.2);
    check_rest(3, 2, 0.3, FIX_XYZ, 0.2);
    check_rest(5, 9, -0.4, FIX_Z, 0.04);
    check_rest(7, 8, 0.3, FIX_X, 0.04);
    check_rest(6, 10, 0, FIX_X | FIX_Z, 0.04);
    check_damping();
    check_doubt();
    return check_result();
}
