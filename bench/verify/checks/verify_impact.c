#include <math.h>
#include <string.h>

#include "bench/verify/verify_check.h"
#include "models/metric/intersection.h"
#include "models/vector.h"

/* Claims. Momentum, in the table: iterations end at 1e-7 of the length, which leaves 1e-4
 * of a step's force; ROUGH times as much of friction's, since what sticks moves no more
 * than 2e-6 of the length a step. Angular momentum: forces are those of a step's end, and
 * differences of places its middle's velocities, so that it errs by a step's way over the
 * arm, 2e-3 m of 0.1 m, while the ball is passed. Energy: kept as in `energy`. */
#define KEPT 1e-4, NULL
static const double ROUGH = 10, TURN = 0.02, GAIN = 1e-3, NONE = 1e-9;
/* Energy kept of a flat impact, from both sides: steps resolve the way through the range by
 * a hundredth, where they have forces of their end. */
static const double RETURNED = 0.05;

#define NETS "triangles,mass_spring_momentum,triangles_explicit,mass_spring_leapfrog"
#define PROJECTED                                                                          \
    {                                                                                      \
        "projective_dynamics", 0, "its iterations leave 5e-4 of a push, of friction 0.01"  \
    }
static const struct verify_subject entries[] = {
    {"iga_nonlinear,hex_nonlinear,shell_2", KEPT, {8}, {8}},
    {"shell_explicit_3", KEPT, {8}, {8}},
    {"mass_spring", KEPT, .settings = {"discretization.tolerance=1e-7"}},
    {NETS ",position_based", KEPT},
    PROJECTED,
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {11}, {11}};
static const struct verify_subject folding[] = {
    {"iga_selective,shell_3,shell_explicit_3", KEPT, {12}, {12}, .dear = true},
    {"mass_spring", 0, "its iteration fails where the sheet closes"},
    {NETS ",position_based", KEPT},
    PROJECTED,
    {NULL}};
static const struct verify_field folded = {
    .subject = folding, .along = {21}, .across = {21}};

static const double LENGTH = 0.4, MASS = 0.8 * 0.4 * 0.4, DT = 2e-3;
static const double CENTER[3] = {0.1, 0.12, -0.13}; /* of the ball */

/* Sums of a motion; momenta are those of its first and last step. */
struct sums {
    int spans; /* a side                                            */
    double *x; /* [2 spans][2 spans][3] places in the last frame    */
    double momentum[2][3], spin[2][3]; /* about the ball                                  */
    double impulse[3], twist[3]; /* of the ball, [N s]; of loads, [N m s]             */
    double energy, most;         /* at the start, largest                       [J]   */
    int touched;                 /* frames in which something was                     */
    long crossings;              /* pairs of triangles that meet, of all frames       */
    struct intersection work;
};

/* Computes momenta by moves from the last frame, at Gauss points, to which the mass of a
 * net of degree 3 or less is exact. */
static void measure(struct sums *s, const struct motion *m)
{
    const int side = 2 * s->spans;
    double *p = s->momentum[m->frames > 1], *spin = s->spin[m->frames > 1], *last = s->x;

    memset(p, 0, 3 * sizeof *p);
    memset(spin, 0, 3 * sizeof *spin);
    for (int n = 0; n < side * side; n++, last += 3) {
        double uvw[3] = {n / side, n % side, 0.5}, x[3], arm[3], way[3], moment[3];
        for (int i = 0; i < 2; i++) {
            const int half = (int)uvw[i] % 2;
            uvw[i] =
                (floor(uvw[i] / 2) + 0.5 + (half ? 1 : -1) * sqrt(1.0 / 12)) / s->spans;
        }
        m->model->probe(m->state, 1, uvw, x);
        for (int i = 0; i < 3; i++) {
            arm[i] = (x[i] + last[i]) / 2 - CENTER[i];
            way[i] = MASS * (x[i] - last[i]) / (DT * side * side);
            p[i] += way[i];
        }
        vector_cross(arm, way, moment);
        for (int i = 0; i < 3; i++)
            spin[i] += moment[i];
        memcpy(last, x, sizeof x);
    }
}

/* Adds a step's torque of the loads, at the end of it. */
static void add_twist(struct sums *s, const struct motion *m)
{
    static const double share[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6}; /* Simpson's rule */

    for (int n = 0; n < 3 * m->scene->load_count; n++) {
        const struct scene_load *l = &m->scene->loads[n / 3];
        double x[3], arm[3], torque[3], u = l->lo[0] + n % 3 * (l->hi[0] - l->lo[0]) / 2;
        m->model->probe(m->state, 1, (double[]){u, 0.5, 0.5}, x);
        vector_between(CENTER, x, arm);
        vector_cross(arm, l->force, torque);
        for (int i = 0; i < 3; i++)
            s->twist[i] += share[n % 3] * torque[i] * DT;
    }
}

/* Counts where the sheet passes through itself. */
static enum status count(struct sums *s, const struct motion *m)
{
    enum { U = 41, V = 11 };
    double x[U * V][3];
    long pairs = 0;

    for (int n = 0; n < U * V; n++) {
        const double uvw[3] = {n % U / (U - 1.0), n / U / (V - 1.0), 0.5};
        m->model->probe(m->state, 1, uvw, x[n]);
    }
    const enum status st = intersection_count(&s->work, U, V, x[0], &pairs);
    s->crossings += pairs;
    return st;
}

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct sums *s = context;
    struct model_contact c = {0};
    struct energy e = {NAN, NAN, NAN};

    (void)why;
    measure(s, m);
    if (m->model->energy)
        m->model->energy(m->state, &e);
    s->most = m->frames ? verify_row_worse(e.kinetic + e.elastic, s->most)
                        : (s->energy = e.kinetic + e.elastic);
    if (m->frames == 0)
        return STATUS_OK;
    m->model->contact(m->state, &c);
    s->touched += c.nodes > 0;
    for (int i = 0; i < 3; i++)
        s->impulse[i] += c.force[i] * DT;
    add_twist(s, m);
    return m->scene->contact.self ? count(s, m) : STATUS_OK;
}

/* Moves a sheet of 0.8 kg/m^2. */
static bool fly(struct verify_trial *t, struct sums *s)
{
    static double x[40 * 40 * 3];

    s->x = x, s->spans = t->subject->along[0] - t->subject->degree;
    verify_trial_set(t,
                     "sheet={length: %g, width: %g, thickness: 0.004}; gravity=[0,0,0];"
                     "pose={origin: [0,0,0]}; damping={kind: none}; time.step=%g;"
                     "material={young: 1e6, poisson: 0.3, density: 200}",
                     LENGTH, LENGTH, DT);
    return verify_trial_watch(t, look, s);
}

/* Returns |a - b - c|. */
static double off(const double a[3], const double b[3], const double c[3])
{
    const double d[3] = {a[0] - b[0] - c[0], a[1] - b[1] - c[1], a[2] - b[2] - c[2]};

    return vector_length(d);
}

/* Judges the ball's impulse by the sheet's change of momentum, and what the ball, which
 * pushes through its centre, may not change without friction. */
static void add_ball(struct verify_subject *s)
{
    static const double none[3] = {0};
    const double friction = s->at ? 0.3 : 0;
    struct sums sums = {0};

    verify_subject_claim(s, s->at ? ROUGH * s->tolerance : s->tolerance, NULL);
    struct verify_trial t =
        verify_trial_of(s, "free_fall", "impulse of the ball [N s], mu = %g", friction);
    verify_trial_set(&t,
                     "motion={velocity: [1,0,-0.75]}; time.end=0.4; obstacles=[{sphere: "
                     "{center: [%g,%g,%g], radius: 0.1, friction: %g}}]",
                     CENTER[0], CENTER[1], CENTER[2], friction);
    if (!fly(&t, &sums))
        return;
    t.row->value = vector_length(sums.impulse);
    t.row->truth = off(sums.momentum[1], sums.momentum[0], none);
    verify_row_judge_error(
        t.row, off(sums.momentum[1], sums.momentum[0], sums.impulse) / t.row->truth, 0);
    if (!s->at) {
        verify_subject_claim(s, TURN, NULL);
        verify_row_judge_error(
            verify_sheet_add(s, "angular momentum changed, mu = 0"),
            off(sums.spin[1], sums.spin[0], none) / vector_length(sums.spin[0]), 0);
    }
    verify_subject_claim(s, GAIN, NULL);
    if (!isnan(sums.most))
        verify_row_judge_error(verify_sheet_add(s, "energy gained, mu = %g", friction),
                               sums.most / sums.energy - 1, 0);
}

/* Judges the energy of a sheet that is thrown flat onto a plane, from both sides: the law
 * (contact_law.h) lets what comes with V times the speed of rebound leave with W, -W - ln(1
 * - W) = V - ln(1 + V). Without gravity the scene's speed is that of the sheet, V =
 * sqrt(1e5); or that of a wind, of a drag too small to matter, at V = 1. */
static void add_plane(struct verify_subject *s)
{
    static const double kept_of[] = {1e-5, 0.35239};
    const double v = s->at ? 0.01 : 1, start = s->at ? 0.04 : 0.004;
    struct sums sums = {0};

    if (isnan(s->tolerance))
        return;
    verify_subject_claim(s, RETURNED, NULL);
    struct verify_trial t =
        verify_trial_of(s, "free_fall", "energy kept of a flat impact at %g m/s", v);
    verify_trial_set(&t,
                     "motion={velocity: [0,0,%g]}; time.end=%g;"
                     "drag={coefficient: 1e-9, wind: [%.17g,0,0]};"
                     "contact={self: false, thickness: %g, stiffness: %g};"
                     "obstacles=[{plane: {point: [0,0,%.17g], normal: [0,0,1]}}]",
                     -v, s->at ? 2 : 0.6, s->at ? v * sqrt(1e5) : 0, start,
                     1.6 * v * v / start, -start / 2 - 5.5 * DT * v);
    if (!fly(&t, &sums))
        return;
    const double kept = vector_dot(sums.momentum[1], sums.momentum[1]) /
                        vector_dot(sums.momentum[0], sums.momentum[0]);
    verify_row_judge(t.row, kept, kept_of[s->at], 0);
    verify_row_note(t.row, "touches in %d frames", sums.touched);
}

/* Judges a sheet that loads, whose sum is zero, fold and press upon itself. */
static void add_fold(struct verify_subject *s)
{
    const double pressed = 0.25 * 0.5; /* [N s] */
    struct sums sums = {0};

    struct verify_trial t =
        verify_trial_of(s, "free_fall", "momentum gained, over what presses");

    verify_trial_set(&t,
                     "contact={friction: 0.3}; time.end=0.5; loads=[{at: {u: 0}, force: "
                     "[0.25,0,-0.1]}, {at: {u: 1}, force: [-0.25,0.025,-0.15]},"
                     "{at: {u: [0.4,0.5]}, force: [0,-0.025,0.25]}]");
    if (fly(&t, &sums)) {
        verify_row_judge_error(t.row, vector_length(sums.momentum[1]) / pressed, 0);
        verify_row_note(t.row, "touches in %d frames", sums.touched);
        if (!sums.touched)
            verify_row_end(t.row, VERDICT_NOT_APPLICABLE, "which shows nothing");
        verify_subject_claim(s, TURN, NULL);
        verify_row_judge_error(
            verify_sheet_add(s, "angular momentum without its torque"),
            off(sums.spin[1], sums.spin[0], sums.twist) / (pressed * LENGTH), 0);
        verify_subject_claim(s, NONE, NULL);
        verify_row_judge_error(verify_sheet_add(s, "edges through faces, all frames"),
                               (double)sums.crossings, 0);
    }
    intersection_clear(&sums.work);
}

const struct verify_check verify_impact = {
    {"impact", "a sheet that meets a ball, and itself, flying freely"},
    "momentum: what the sheet gains, the ball gives, without friction through its centre; "
    "no "
    "energy comes of it; thrown flat, it keeps what restitution says; between two places "
    "of a sheet nothing comes of contact",
    .parts = {
        {&field, add_ball, 2, .every = 2}, {&field, add_plane, 2}, {&folded, add_fold, 1}}};
