#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: round-off of a solve with a matrix of condition 2e7, over hundreds of steps, and
 * iterations that end at 1e-7 L. */
#define EXACT 1e-8
static const double SPEED = 1e-6;
#define G  9.81
#define T  1.0
#define DT 0.005

/* Claims for a damped fall: average acceleration is second order, (alpha dt)^2 / 12 = 5e-5
 * with alpha = 5; implicit Euler, and a start without acceleration, first order, dt / t of
 * the way. */
static const double SECOND = 1e-4;
#define FIRST (DT / T * (1 + 1e-6))

#define LATE "starts without acceleration: dt / t"
/* Those marked have the kinetic energy of the step's mean speed, not of v. */
static const struct verify_subject entries[] = {
    {"iga_linear", EXACT, NULL, {5}, {4}},
    {"iga_paper", 0, "the paper's scheme", {5}, {4}, .mark = true},
    {"iga_incremental", FIRST, LATE, {5}, {4}, .mark = true},
    {"iga_nonlinear,hex_linear,hex_nonlinear", EXACT, NULL, {5}, {4}},
    {"shell_linear,shell_2,triangles", EXACT, NULL, {5}},
    {"mass_spring", FIRST, "implicit Euler: dt / t", {5}},
    {"position_based", FIRST, "as implicit Euler: dt / t", {5}},
    {"mass_spring_leapfrog,mass_spring_momentum", EXACT, NULL, {5}},
    {"projective_dynamics", FIRST, "implicit Euler: dt / t", {5}},
    {"projective_dynamics_bdf2", EXACT, NULL, {5}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {5}, {5}};

/* Kinds of fall until T. */
#define DRAG(c) "drag.coefficient=" c
static const struct fall {
    const char *quantity, *settings[3];
    double rate; /* alpha: c / rho, or that of mass damping [1/s]                         */
} falls[] = {{"free fall, way over g t^2 / 2", {DRAG("0"), "damping={kind: none}"}, 0},
             {"fall with drag, way at 1 s", {DRAG("2.5"), "damping={kind: none}"}, 5},
             {"fall with mass damping, way at 1 s",
              {DRAG("0"), "damping={kind: mass, value: 5}"},
              5}};
enum { FALLS = sizeof falls / sizeof *falls, POINTS = 5 };

/* Returns the largest deviation over the way fallen. */
static double deviation(const void *context, const double *a, const double *b)
{
    return verify_row_apart(3 * POINTS, a, b) / *(const double *)context;
}

static void add_fall(struct verify_subject *s)
{
    static const double uvw[POINTS][3] = {
        {0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {1, 1, 0.5}, {0.3, 0.6, 0.5}};
    const struct fall *f = &falls[s->at];
    const double time = T, rate = f->rate;
    const double way =
        rate > 0 ? G / rate * (T - (1 - exp(-rate * T)) / rate) : G * T * T / 2;
    const bool exact = s->tolerance == EXACT;
    double truth[POINTS][3];

    for (int n = 0; n < POINTS; n++)
        truth[n][0] = uvw[n][0], truth[n][1] = uvw[n][1], truth[n][2] = -way;
    if (rate > 0 && exact)
        verify_subject_claim(s, SECOND, "second order");
    struct verify_trial_refine r = {
        .scene = "drag_fall", .settings = f->settings, .step = DT};
    r.steps = rate == 0 && exact ? 1 : VERIFY_TRIAL_STEPS;
    r.times = 1, r.time = &time, r.n = POINTS, r.uvw = uvw[0], r.truth = truth[0];
    r.measure = deviation, r.context = &way;
    verify_trial_refine(s, &r, f->quantity);
}

/* Computes the speed of a sheet of mass rho h L W from its kinetic energy [m/s]. */
static enum status see_speed(void *context, const struct motion *m, struct message *why)
{
    const struct scene *s = m->scene;
    struct energy e = {NAN, NAN, NAN};

    (void)why;
    if (m->model->energy)
        m->model->energy(m->state, &e);
    *(double *)context =
        sqrt(2 * e.kinetic / (s->density * s->thickness * s->length * s->width));
    return STATUS_OK;
}

/* Judges the terminal speed rho g / c, of which exp(-c t / rho) is missing; and, in rows of
 * the table, that of v <- mu v after every step, mu / (1 - mu) g dt up to mu^n. */
static void add_speed(struct verify_subject *s)
{
    const bool drag = s->at == 0;
    const double mu = drag ? 1 : verify_number(s, "a"), dt = 0.001,
                 end = mu > 0.95 ? 2 : 0.2;
    const double missing = drag ? exp(-5 * end) : fmax(pow(mu, end / dt), 1e-12);
    double speed;

    verify_subject_claim(s, drag ? missing : SPEED, NULL);
    struct verify_trial t =
        drag ? verify_trial_of(s, "drag_fall", "terminal speed with drag [m/s]")
             : verify_trial_of(s, "drag_fall", "v <- %g v: speed / (g dt)", mu);
    t.end = end;
    if (!drag)
        verify_trial_set(
            &t, DRAG("0") "; time.step=0.001; damping={kind: velocity_scale, value: %g}",
            mu);
    if (!verify_trial_watch(&t, see_speed, &speed))
        return;
    if (drag)
        verify_row_judge(t.row, speed, 1.962, missing);
    else
        verify_row_judge(t.row, speed / (G * dt) - (s->mark ? 0.5 : 0),
                         verify_number(s, "v1"), missing);
}

const struct verify_check verify_fall = {
    {"fall", "free fall, body drag, mass damping and scaled velocities"},
    "closed forms; mu / (1 - mu) by tests/reference/beam_elastica_cable.csv",
    "beam_elastica_cable",
    .parts = {{&field, add_fall, FALLS},
              {&field, add_speed, 1},
              {&field, add_speed, .column = "case", .text = "newmark_vscale"}}};
