#include <math.h>
#include <string.h>

#include "bench/verify/verify_check.h"
#include "models/metric/intersection.h"
#include "models/vector.h"

/* Claims. Momentum: iterations end at 1e-7 of the length, which leaves 1e-4 of a step's
 * force; friction's, 1e-3, since what sticks moves no more than 2e-6 of the length a step.
 * Angular momentum: forces are those of a step's end, and differences of places its
 * middle's velocities, so that it errs by a step's way over the arm, 2e-3 m of 0.1 m, while
 * the ball is passed. Energy: kept as in `energy`. */
static const double MOMENTUM = 1e-4, ROUGH = 1e-3, TURN = 0.02, GAIN = 1e-3;
#define CLAIMED 1, NULL

static const struct verify_subject entries[] = {
    {"iga_linear,hex_linear,shell_linear", 0, "turns by small angles alone", {8}, {8}},
    {"iga_paper", 0, "the paper's scheme", {8}, {8}},
    {"iga_incremental", 0, "forgets its stress", {8}, {8}},
    {"iga_nonlinear,hex_nonlinear,shell_2,shell_explicit_3", CLAIMED, {8}, {8}},
    {"triangles,triangles_explicit", CLAIMED},
    {"mass_spring,mass_spring_momentum,mass_spring_leapfrog,position_based,projective_"
     "dynamics",
     CLAIMED},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {11}, {11}};

static const double LENGTH = 0.4, AREAL = 0.8, DT = 2e-3;
static const double CENTER[3] = {0.1, 0.12, -0.13};

/* Sums of a motion; momenta per area of the sheet. */
struct sums {
    const struct verify_subject *subject;
    double last[3], begin[3], end[3]; /* momentum's place before; momenta  [m], [m/s]    */
    double turn[2][3];                /* angular momentum about the ball, first and last */
    double impulse[3];                /* of the ball                              [N s] */
    double energy, most;              /* at the start, largest                      [J] */
    double *x;                        /* [points][3] of the last frame                   */
    double torque[3];                 /* of loads, over time                    [N m s] */
    struct intersection work;
    long crossings; /* pairs of triangles that meet, of all frames                       */
    int touched;    /* frames in which it met something                                  */
};

/* Fills the points and weights of a rule along one side that a net's mass is exact for:
 * Gauss in spans of splines, the trapezoidal rule at points. Returns how many. */
enum { GAUSS = 4, SIDE = 48 };
static int rule(const struct verify_subject *s, double *at, double *weight)
{
    static const double place[GAUSS] = {-0.861136311594053, -0.339981043584856,
                                        0.339981043584856, 0.861136311594053};
    static const double share[GAUSS] = {0.347854845137454, 0.652145154862546,
                                        0.652145154862546, 0.347854845137454};
    const int spans = s->along[0] - s->degree;

    if (s->degree == 1) {
        for (int n = 0; n <= spans; n++) {
            at[n] = (double)n / spans;
            weight[n] = (n % spans ? 1.0 : 0.5) / spans;
        }
        return spans + 1;
    }
    for (int n = 0; n < GAUSS * spans; n++) {
        at[n] = (n / GAUSS + (1 + place[n % GAUSS]) / 2) / spans;
        weight[n] = share[n % GAUSS] / 2 / spans;
    }
    return GAUSS * spans;
}

/* Computes where the centre is, and the angular momentum over area and density, of a move
 * from `last` in a step's middle. */
static void measure(const struct sums *sums, const struct motion *m, double *last,
                    double center[3], double turn[3])
{
    double at[SIDE], weight[SIDE];
    const int side = rule(sums->subject, at, weight);

    memset(center, 0, 3 * sizeof *center);
    memset(turn, 0, 3 * sizeof *turn);
    for (int n = 0; n < side * side; n++, last += 3) {
        double x[3], arm[3], way[3], moment[3], share = weight[n / side] * weight[n % side];
        m->model->probe(m->state, 1, (double[]){at[n / side], at[n % side], 0.5}, x);
        for (int i = 0; i < 3; i++) {
            arm[i] = (x[i] + last[i]) / 2 - CENTER[i];
            way[i] = (x[i] - last[i]) / DT;
            center[i] += share * x[i];
        }
        vector_cross(arm, way, moment);
        for (int i = 0; i < 3; i++)
            turn[i] += share * moment[i];
        memcpy(last, x, sizeof x);
    }
}

/* Adds a step's torque of the loads, at the end of it. */
static void add_torque(struct sums *s, const struct motion *m)
{
    static const double share[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6}; /* Simpson's rule */

    for (int n = 0; n < m->scene->load_count; n++)
        for (int k = 0; k < 3; k++) {
            const struct scene_load *l = &m->scene->loads[n];
            double x[3], arm[3], torque[3];
            m->model->probe(m->state, 1,
                            (double[]){l->lo[0] + k * (l->hi[0] - l->lo[0]) / 2, 0.5, 0.5},
                            x);
            vector_between(CENTER, x, arm);
            vector_cross(arm, l->force, torque);
            for (int i = 0; i < 3; i++)
                s->torque[i] += share[k] * torque[i] * DT;
        }
}

/* Counts where the sheet passes through itself. */
static enum status count(struct sums *s, const struct motion *m)
{
    enum { U = 49, V = 9 };
    double x[U * V][3];
    long pairs = 0;

    for (int n = 0; n < U * V; n++)
        m->model->probe(m->state, 1, (double[]){n % U / (U - 1.0), n / U / (V - 1.0), 0.5},
                        x[n]);
    const enum status st = intersection_count(&s->work, U, V, x[0], &pairs);
    s->crossings += pairs;
    return st;
}

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct sums *s = context;
    struct model_contact c = {0};
    struct energy e = {NAN, NAN, NAN};
    double center[3], turn[3];

    (void)why;
    measure(s, m, s->x, center, turn);
    if (m->model->energy)
        m->model->energy(m->state, &e);
    const double total = e.kinetic + e.elastic;
    if (m->frames == 0) {
        s->energy = s->most = total;
        memcpy(s->last, center, sizeof center);
        return STATUS_OK;
    }
    m->model->contact(m->state, &c);
    s->touched += c.nodes > 0;
    s->most = verify_row_worse(total, s->most);
    add_torque(s, m);
    for (int i = 0; i < 3; i++) {
        s->end[i] = (center[i] - s->last[i]) / DT;
        s->impulse[i] += c.force[i] * DT;
    }
    if (m->frames == 1)
        memcpy(s->begin, s->end, sizeof s->end), memcpy(s->turn[0], turn, sizeof turn);
    memcpy(s->last, center, sizeof center), memcpy(s->turn[1], turn, sizeof turn);
    return m->scene->contact.self ? count(s, m) : STATUS_OK;
}

/* Judges the ball's impulse by the sheet's change of momentum, and what the ball, which
 * pushes through its centre, may not change without friction. */
static void judge(struct verify_subject *s, struct verify_trial *t, const struct sums *sums,
                  bool smooth)
{
    const double mass = AREAL * LENGTH * LENGTH;
    double change[3], off[3], turned[3];

    for (int i = 0; i < 3; i++) {
        change[i] = mass * (sums->end[i] - sums->begin[i]);
        off[i] = change[i] - sums->impulse[i];
    }
    t->row->value = vector_length(sums->impulse), t->row->truth = vector_length(change);
    verify_row_judge_error(t->row, vector_length(off) / vector_length(change), 0);
    if (smooth) {
        verify_subject_claim(s, TURN, NULL);
        vector_between(sums->turn[0], sums->turn[1], turned);
        verify_row_judge_error(verify_sheet_add(s, "angular momentum changed, mu = 0"),
                               vector_length(turned) / vector_length(sums->turn[0]), 0);
    }
    if (isnan(sums->most))
        return;
    verify_subject_claim(s, GAIN, NULL);
    verify_row_judge_error(verify_sheet_add(s, "energy gained, mu = %g", smooth ? 0 : 0.3),
                           sums->most / sums->energy - 1, 0);
}

static void add_rows(struct verify_subject *s)
{
    static double x[SIDE * SIDE * 3];
    const bool smooth = s->at == 0;
    struct sums sums = {.subject = s, .x = x};

    if (s->sheet->quick && isnan(s->tolerance))
        return;
    verify_subject_claim(s, smooth ? MOMENTUM : ROUGH, NULL);
    struct verify_trial t = verify_trial_of(
        s, "free_fall", "impulse on the ball [N s], mu = %g", smooth ? 0 : 0.3);
    verify_trial_set(
        &t,
        "sheet={length: %g, width: %g, thickness: 0.004}; pose={origin: [0,0,0]};"
        "material={young: 1e6, poisson: 0.3, density: 200}; gravity=[0,0,0];"
        "motion={velocity: [1,0,-0.75]}; damping={kind: none}; time={step: %g, end: 0.4};"
        "obstacles=[{sphere: {center: [%g,%g,%g], radius: 0.1, friction: %g}}]",
        LENGTH, LENGTH, DT, CENTER[0], CENTER[1], CENTER[2], smooth ? 0 : 0.3);
    if (verify_trial_watch(&t, look, &sums))
        judge(s, &t, &sums, smooth);
}

/* Judges a sheet that loads, whose sum is zero, press against itself. */
static void add_self(struct verify_subject *s)
{
    static double x[SIDE * SIDE * 3];
    const double mass = AREAL * LENGTH * LENGTH, pressed = 0.5 * 0.4; /* [N s] */
    struct sums sums = {.subject = s, .x = x};
    double off[3];

    if (s->sheet->quick && isnan(s->tolerance))
        return;
    verify_subject_claim(s, MOMENTUM, NULL);
    struct verify_trial t =
        verify_trial_of(s, "free_fall", "momentum gained, over what presses");
    verify_trial_set(
        &t,
        "sheet={length: %g, width: %g, thickness: 0.004}; pose={origin: [0,0,0]};"
        "material={young: 1e6, poisson: 0.3, density: 200}; gravity=[0,0,0];"
        "damping={kind: none}; time={step: %g, end: 0.4}; contact={friction: 0.3};"
        "loads=[{at: {u: 0}, force: [0.5,0,-0.2]}, {at: {u: 1}, force: [-0.5,0.05,-0.3]},"
        "{at: {u: [0.4,0.5]}, force: [0,-0.05,0.5]}]",
        LENGTH, LENGTH, DT);
    if (verify_trial_watch(&t, look, &sums)) {
        verify_row_judge_error(t.row, mass * vector_length(sums.end) / pressed, 0);
        verify_row_note(t.row, "touches in %d frames", sums.touched);
        for (int i = 0; i < 3; i++)
            off[i] = AREAL * LENGTH * LENGTH * (sums.turn[1][i] - sums.turn[0][i]) -
                     sums.torque[i];
        verify_subject_claim(s, TURN, NULL);
        verify_row_judge_error(verify_sheet_add(s, "angular momentum gained, over torque"),
                               vector_length(off) / (pressed * LENGTH), 0);
        verify_subject_claim(s, 1e-9, NULL);
        verify_row_judge_error(verify_sheet_add(s, "edges through faces, all frames"),
                               (double)sums.crossings, 0);
    }
    intersection_clear(&sums.work);
}

const struct verify_check verify_impact = {
    {"impact", "a sheet that meets a ball, and itself, flying freely"},
    "momentum: what the sheet gains, the ball gives; without friction through its centre; "
    "no "
    "energy comes of it; between two places of a sheet nothing comes of contact",
    .parts = {{&field, add_rows, 2, .every = 2}, {&field, add_self, 1}}};
