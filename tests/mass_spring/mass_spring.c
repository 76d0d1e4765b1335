/* Net of springs in implicit and explicit steps of first order: decay, factors
 * in single precision, strain limit. (Falls: fall.c; the stability limit: with leapfrog's.)
 */
#include <float.h>
#include <omp.h>

#include "models/reader/scene_file.h"
#include "tests/mass_spring.h"

/* A large net's factor is in single precision, and in double where that is too coarse: in
 * one step of a free fall, the longer the less the mass counts beside the springs; heavy:
 * times the masses and moduli, which floats may not hold. */
static void check_single(double step, double heavy)
{
    /* Newton's tolerance is on what its last two steps let expect, not on what is left. */
    static const double EXPECTED = 2;
    struct springs s;
    double off = 0;

    springs_init(&s, 24, 24, false);
    s.scene.step = step;
    s.scene.young *= heavy, s.scene.density *= heavy;
    springs_start(&s);
    springs_steps(&s, 1);
    for (int t = 0; t < 3 * s.m.net.mesh.nodes; t++)
        off = fmax(off, fabs(s.m.net.x[t] - s.m.net.mesh.rest[t] -
                             step * step * s.scene.gravity[t % 3]));
    CHECK_NEAR(off, 0, EXPECTED * s.m.march.tolerance);
    springs_clear(&s);
}

/* Energy never grows under implicit Euler, whatever the damping, and falls to that of rest.
 */
static void check_decay(enum parameters parameters, struct scene_damping damping)
{
    enum { STEPS = 400 };
    struct springs s;
    struct energy e;
    double before = 0, gain = 0, first = 0;

    springs_init(&s, 6, 5, true);
    s.scene.damping = damping;
    s.d.parameters = parameters, s.d.tolerance = 1e-9;
    springs_start(&s);
    for (int n = 0; n < STEPS; n++) {
        springs_steps(&s, 1);
        spring_motion_energy(&s.m, &e);
        double total = e.kinetic + e.elastic + e.potential;
        gain = fmax(gain, total - before);
        before = total;
        first = fmax(first, e.kinetic);
    }
    /* Newton's tolerance of 1e-9 cells against forces of the weight. */
    const double solved = 1e-7;
    CHECK_NEAR(fmax(gain, 0) / first, 0, solved);
    CHECK(before < -0.1 * first);
    springs_clear(&s);
}

/* corners_drop as in the paper's Fig. 6: largest elongation of a spring over the fall. */
static double largest_elongation(enum parameters parameters, double limit)
{
    struct springs s = {.d = net_of(10, 10)};
    double most = 0;

    REQUIRE(scene_file_read(SOURCE_DIR "/models/scenes/corners_drop.yaml", 0, NULL,
                            &s.scene, &s.d, NULL) == STATUS_OK);
    s.d.parameters = parameters;
    OWN(spring_own, &s.d)->strain_limit = limit;
    springs_start(&s);
    for (int n = 0; n < 300; n++) {
        springs_steps(&s, 1);
        most = fmax(most, springs_strain(&s));
    }
    springs_clear(&s);
    return most;
}

/* Both ends of a spring give way alike: a free net stays where it is as a whole. */
static void check_strain_centre(void)
{
    const double rounding = 1e-12; /* some thousand moves of points within 1 m */
    struct springs s;
    double centre[3] = {0}, rest[3] = {0};

    springs_init(&s, 6, 5, false);
    springs_start(&s);
    for (int t = 0; t < 3 * s.m.net.mesh.nodes; t++) {
        s.m.net.x[t] *= 1.3 + 0.1 * noise(t);
        rest[t % 3] += s.m.net.x[t];
    }
    spring_motion_limit(&s.m.springs, &s.m.net.supports, 0.1, s.m.net.x);
    for (int t = 0; t < 3 * s.m.net.mesh.nodes; t++)
        centre[t % 3] += s.m.net.x[t];
    CHECK(springs_strain(&s) <= 0.1 * 1.001);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(centre[i], rest[i], rounding);
    springs_clear(&s);
}

static void check_strain_limit(void)
{
    const double limit = 0.1, slack = 1e-3; /* spring_motion.c */
    const double paper = largest_elongation(PARAMETERS_PAPER, 0),
                 limited = largest_elongation(PARAMETERS_PAPER, limit),
                 matched = largest_elongation(PARAMETERS_MATCHED, 0);

    printf(
        "corners_drop 10x10, longest spring: the paper's %.4f too long, by Provot's limit "
        "of 10 %% %.4f, matched to E, nu, h %.4f\n",
        paper, limited, matched);
    CHECK(paper > 0.2 && matched < 0.02);
    CHECK(limited > 0.09 && limited <= limit * (1 + slack));
}

/* Gains of velocity that grow as a power of time are guessed once as many are known, and
 * seen to be right; one iteration, if so asked, and no more. */
static void check_guess(bool once, int power)
{
    enum { STEPS = 12 };
    struct springs s;

    springs_init(&s, 5, 4, once);
    s.d.iterations = once;
    springs_start(&s);
    for (int n = 1; n <= STEPS; n++) {
        springs_steps(&s, 1);
        for (int t = 0; t < 3 * s.m.net.mesh.nodes; t++)
            s.m.net.load[t] *= pow((n + 1.0) / n, power);
    }
    CHECK(s.counters.iterations >= STEPS &&
          s.counters.iterations <= STEPS + (once ? 0 : power + 1));
    CHECK(s.counters.factorisations <= STEPS);
    springs_clear(&s);
}

int main(void)
{
    omp_set_num_threads(1);
    for (double step = 1e-3; step < 2; step *= 10)
        check_single(step, 1);
    check_single(0.01, 1e40);
    check_decay(PARAMETERS_MATCHED, (struct scene_damping){.kind = DAMPING_NONE});
    check_decay(PARAMETERS_MATCHED,
                (struct scene_damping){.kind = DAMPING_MASS, .value = 2});
    check_decay(PARAMETERS_MATCHED,
                (struct scene_damping){.kind = DAMPING_RAYLEIGH, .alpha = 1, .beta = 0.01});
    check_decay(PARAMETERS_MATCHED,
                (struct scene_damping){.kind = DAMPING_VELOCITY_SCALE, .value = 0.9});
    check_decay(PARAMETERS_PAPER, (struct scene_damping){.kind = DAMPING_NONE});
    check_strain_centre();
    check_strain_limit();
    check_guess(true, 0);
    check_guess(false, 0);
    return check_result();
}
