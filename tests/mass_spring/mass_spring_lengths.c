/* Springs on lengths, and struts, by leapfrog: the explicit method's motion, the slope of
 * the energy, the step where springs are stretched. */
#include "models/net/spring_stencil.h"
#include "tests/mass_spring.h"

/* The supports of a sheet: its edge, which is one row of clamps; patches of several; a
 * point in the middle, beyond which the sheet goes on; the edge and points beside it, in
 * one direction. */
enum hold { HOLD_EDGE, HOLD_PATCH, HOLD_POINT, HOLD_ROLLER };

static void hold_by(struct scene *scene, enum hold hold)
{
    static const struct scene_support supports[] = {
        {.hi = {0, 1, 1}, .fix = FIX_XYZ},
        {.lo = {0, 0.4, 0}, .hi = {0.4, 1, 1}, .fix = FIX_XYZ},
        {.lo = {0.45, 0.45, 0}, .hi = {0.55, 0.55, 1}, .fix = FIX_XYZ},
        {.hi = {0.2, 0, 1}, .fix = FIX_Y}};

    REQUIRE(scene_add_support(scene, &supports[hold]) == STATUS_OK);
    if (hold == HOLD_ROLLER)
        REQUIRE(scene_add_support(scene, &supports[HOLD_EDGE]) == STATUS_OK);
    scene->velocity[0] = 0.3, scene->velocity[2] = 1;
}

/* A net whose springs are lengths, by leapfrog. */
static void lengths(struct net *s, int n, int m, bool held, enum bending bending)
{
    net_init(s, n, m, held);
    s->d.integrator = INTEGRATOR_LEAPFROG;
    OWN(spring_own, &s->d)->springs = SPRINGS_LENGTHS, s->d.bending = bending;
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
    struct net s[2];
    double off = 0, moved = 0;

    for (int k = 0; k < 2; k++) {
        if (k)
            net_init(&s[k], n, m, false), s[k].d.integrator = INTEGRATOR_EXPLICIT;
        else
            lengths(&s[k], n, m, false, BENDING_STRUT), s[k].d.precision = precision;
        hold_by(&s[k].scene, hold);
        s[k].scene.step = 1e-3, s[k].d.substeps = 60;
        net_start(&s[k]);
        if (k)
            half_back(&s[k].m);
        net_steps(&s[k], 5);
    }
    for (int t = 0; t < 3 * n * m; t++) {
        off = fmax(off, fabs(s[0].m.x[t] - s[1].m.x[t]));
        moved = fmax(moved, fabs(s[0].m.x[t] - s[0].m.net.rest[t]));
    }
    if (!CHECK(off < SAME[precision] && moved > 1e-3))
        printf("%d x %d, held %d: off by %g of %g m\n", n, m, hold, off, moved);
    for (int k = 0; k < 2; k++)
        net_clear(&s[k]);
}

/* A step too short to move anything shows what pulls: the slope of the energy. */
static void check_slope(int n, int m, enum bending bending)
{
    enum { EVERY = 23 };
    const double SLOPE = 1e-5; /* of differences, of the greatest                       */
    struct net s;
    double most = 0, off = 0, *f = calloc(3 * (size_t)(n * m), sizeof *f);

    REQUIRE(f);
    lengths(&s, n, m, false, bending);
    hold_by(&s.scene, HOLD_PATCH);
    s.scene.step = 1e-9, s.d.substeps = 1;
    net_start(&s);
    const int *place = s.m.newton.supports.free_index;
    double *x = s.m.x, small = 1e-4 * s.scene.length / n;
    for (int t = 0; t < 3 * n * m; t++)
        x[t] += place[t] < 0 ? 0 : 1e3 * small * noise(t);
    spring_motion_place(&s.m, 0);
    net_steps(&s, 1);
    net_energy(&s); /* brings v up to date */
    if (spring_motion_stencil(&s.m))
        spring_stencil_force_add(spring_motion_stencil(&s.m), x, f);
    else
        spring_force_add(&s.m.net, x, f);
    for (int t = 0; t < 3 * n * m; t += EVERY) {
        double was = x[t], slope, load = s.m.points.load[t];
        if (place[t] < 0)
            continue;
        x[t] = was + small, slope = spring_motion_elastic(&s.m);
        x[t] = was - small, slope -= spring_motion_elastic(&s.m);
        x[t] = was, slope = load - slope / (2 * small);
        off = fmax(off, fabs(s.m.v[t] * s.m.points.mass[t / 3] / s.scene.step - slope));
        off = fmax(off, fabs(load + f[t] - slope));
        most = fmax(most, fabs(slope));
    }
    free(f);
    if (!CHECK(off < SLOPE * most))
        printf("%d x %d, bending %d: %g of %g\n", n, m, (int)bending, off, most);
    net_clear(&s);
}

/* A weak net that its weight stretches by half and more becomes stiffer, on lengths across,
 * too: the step follows, and with the number of steps fixed at what rest asks for it dies.
 */
static void check_watched(enum springs springs, enum bending bending)
{
    const bool squares = springs == SPRINGS_SQUARES;
    struct net s;
    enum status st = STATUS_OK;

    lengths(&s, 6, 5, true, bending);
    OWN(spring_own, &s.d)->springs = springs;
    s.scene.young = squares ? 6 : 600;
    s.scene.gravity[0] = squares ? 30 : 1500, s.scene.gravity[2] = 0;
    s.scene.step = 0.02;
    net_start(&s);
    const double dt = spring_leapfrog_step(s.m.leapfrog);
    double limit = spring_leapfrog_limit(s.m.leapfrog);
    net_steps(&s, 200);
    double stretch2 = spring_stencil_stretch2(&s.m.stencil, s.m.x);
    limit = squares ? 0.9 * dt : limit / sqrt(2 - 1 / sqrt(stretch2));
    CHECK(stretch2 > 1.5 && dt > limit);
    CHECK(spring_leapfrog_step(s.m.leapfrog) < limit);
    spring_motion_clear(&s.m);
    if (squares) {
        s.d.substeps = (int)round(s.scene.step / dt);
        net_start(&s);
        for (int n = 0; n < 200 && st == STATUS_OK; n++)
            st = spring_motion_step(&s.m, &s.counters);
        CHECK(st == STATUS_NAN);
    }
    net_clear(&s);
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
