/* Springs on lengths, and struts, by leapfrog: the explicit method's motion, the slope of
 * the energy, the step where springs are stretched. */
#include "models/net/spring_stencil.h"
#include "tests/mass_spring.h"

static struct discretization leapfrog(int n, int m, enum bending bending)
{
    struct discretization d = net_of(n, m);

    d.integrator = INTEGRATOR_LEAPFROG;
    OWN(spring_own, &d)->springs = SPRINGS_LENGTHS, d.bending = bending;
    return d;
}

/* What holds a sheet: its edge, which is one row of clamps; patches of several; a point in
 * the middle, beyond which the sheet goes on; the edge and points beside it, in one
 * direction. */
enum hold { HOLD_EDGE, HOLD_PATCH, HOLD_POINT, HOLD_ROLLER };

static void fill(struct scene *scene, enum hold hold)
{
    static const struct scene_support supports[] = {
        {.hi = {0, 1, 1}, .fix = FIX_XYZ},
        {.lo = {0, 0.4, 0}, .hi = {0.4, 1, 1}, .fix = FIX_XYZ},
        {.lo = {0.45, 0.45, 0}, .hi = {0.55, 0.55, 1}, .fix = FIX_XYZ},
        {.hi = {0.2, 0, 1}, .fix = FIX_Y}};

    fill_scene(scene, false);
    REQUIRE(scene_add_support(scene, &supports[hold]) == STATUS_OK);
    if (hold == HOLD_ROLLER)
        REQUIRE(scene_add_support(scene, &supports[HOLD_EDGE]) == STATUS_OK);
    scene->velocity[0] = 0.3, scene->velocity[2] = 1;
}

/* The explicit method keeps the velocity of half a step ago: it begins with what half a
 * kick leaves of the leapfrog's. */
static void half_back(struct spring_motion *m)
{
    for (int t = 0; t < 3 * m->net.nodes; t++)
        if (m->newton.supports.free_index[t] >= 0)
            m->v[t] -= m->dt / 2 * m->points.load[t] / m->points.mass[t / 3];
}

static void check_same(int n, int m, enum hold hold, enum precision precision)
{
    const double SAME[] = {[PRECISION_DOUBLE] = 1e-12, [PRECISION_SINGLE] = 2e-5};
    struct scene scene;
    struct spring_motion motion[2];
    double off = 0, moved = 0;

    fill(&scene, hold);
    scene.step = 1e-3;
    for (int k = 0; k < 2; k++) {
        struct discretization d = k ? net_of(n, m) : leapfrog(n, m, BENDING_STRUT);
        d.integrator = k ? INTEGRATOR_EXPLICIT : INTEGRATOR_LEAPFROG;
        d.substeps = 60, d.precision = k ? PRECISION_DOUBLE : precision;
        start(&motion[k], &scene, &d);
        if (k)
            half_back(&motion[k]);
        steps(&motion[k], 5);
    }
    for (int t = 0; t < 3 * n * m; t++) {
        off = fmax(off, fabs(motion[0].x[t] - motion[1].x[t]));
        moved = fmax(moved, fabs(motion[0].x[t] - motion[0].net.rest[t]));
    }
    if (!CHECK(off < SAME[precision] && moved > 1e-3))
        printf("%d x %d, held %d: off by %g of %g m\n", n, m, hold, off, moved);
    for (int k = 0; k < 2; k++)
        spring_motion_clear(&motion[k]);
    scene_clear(&scene);
}

/* A step too short to move anything shows what pulls: the slope of the energy. */
static void check_slope(int n, int m, enum bending bending)
{
    enum { EVERY = 23 };
    const double SLOPE = 1e-5; /* of differences, of the greatest                       */
    struct scene scene;
    struct spring_motion motion;
    struct discretization d = leapfrog(n, m, bending);
    struct energy e;
    double most = 0, off = 0, *f = calloc(3 * (size_t)(n * m), sizeof *f);

    REQUIRE(f);
    fill(&scene, HOLD_PATCH);
    scene.step = 1e-9, d.substeps = 1;
    start(&motion, &scene, &d);
    double *x = motion.x, small = 1e-4 * scene.length / n;
    for (int t = 0; t < 3 * n * m; t++)
        x[t] += motion.newton.supports.free_index[t] < 0 ? 0 : 1e3 * small * noise(t);
    spring_motion_place(&motion, 0);
    steps(&motion, 1);
    spring_motion_energy(&motion, &e);
    if (spring_motion_stencil(&motion))
        spring_stencil_force_add(spring_motion_stencil(&motion), x, f);
    else
        spring_force_add(&motion.net, x, f);
    for (int t = 0; t < 3 * n * m; t += EVERY) {
        double was = x[t], slope;
        if (motion.newton.supports.free_index[t] < 0)
            continue;
        x[t] = was + small, slope = spring_motion_elastic(&motion);
        x[t] = was - small, slope -= spring_motion_elastic(&motion);
        x[t] = was, slope = motion.points.load[t] - slope / (2 * small);
        off = fmax(off, fabs(motion.v[t] * motion.points.mass[t / 3] / scene.step - slope));
        off = fmax(off, fabs(motion.points.load[t] + f[t] - slope));
        most = fmax(most, fabs(slope));
    }
    free(f);
    if (!CHECK(off < SLOPE * most))
        printf("%d x %d, bending %d: %g of %g\n", n, m, (int)bending, off, most);
    spring_motion_clear(&motion);
    scene_clear(&scene);
}

/* A weak net that its weight stretches by half and more becomes stiffer, on lengths across,
 * too: the step follows, and with the number of steps fixed at what rest asks for it dies.
 */
static void check_watched(enum springs springs, enum bending bending)
{
    struct scene scene;
    struct spring_motion m;
    struct discretization d = leapfrog(6, 5, bending);
    struct counters counters = {0};
    enum status st = STATUS_OK;

    fill_scene(&scene, true);
    scene.young = springs == SPRINGS_LENGTHS ? 600 : 6;
    scene.gravity[0] = springs == SPRINGS_LENGTHS ? 1500 : 30, scene.gravity[2] = 0;
    scene.step = 0.02;
    OWN(spring_own, &d)->springs = springs;
    start(&m, &scene, &d);
    double dt = spring_leapfrog_step(m.leapfrog), limit = spring_leapfrog_limit(m.leapfrog);
    steps(&m, 200);
    double stretch2 = spring_stencil_stretch2(&m.stencil, m.x);
    limit = springs == SPRINGS_LENGTHS ? limit / sqrt(2 - 1 / sqrt(stretch2)) : 0.9 * dt;
    CHECK(stretch2 > 1.5 && dt > limit);
    CHECK(spring_leapfrog_step(m.leapfrog) < limit);
    spring_motion_clear(&m);
    d.substeps = (int)round(scene.step / dt);
    start(&m, &scene, &d);
    for (int n = 0; springs == SPRINGS_SQUARES && n < 200 && st == STATUS_OK; n++)
        st = spring_motion_step(&m, &counters);
    CHECK(springs == SPRINGS_LENGTHS || st == STATUS_NAN);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

int main(void)
{
    static const int points[][2] = {{9, 8}, {2, 3}, {11, 21}, {35, 19}};

    for (int k = 0; k < 4; k++) /* three points have a middle, nine by eight have none */
        for (enum hold hold = HOLD_EDGE; hold <= HOLD_ROLLER; hold++)
            if (hold != HOLD_POINT || k > 1)
                for (enum precision p = PRECISION_DOUBLE; p <= PRECISION_SINGLE; p++)
                    check_same(points[k][0], points[k][1], hold, p);
    check_slope(6, 7, BENDING_QUADRATIC);
    check_slope(35, 19, BENDING_QUADRATIC);
    check_slope(6, 7, BENDING_STRUT);
    check_watched(SPRINGS_SQUARES, BENDING_QUADRATIC);
    check_watched(SPRINGS_LENGTHS, BENDING_QUADRATIC);
    check_watched(SPRINGS_LENGTHS, BENDING_STRUT);
    return check_result();
}
