/* A free sheet that falls without deforming: what time stepping and damping make of a rigid
 * body. */
#include <math.h>

#include "bench/verify/verify_check.h"

/* Round-off of a solve with a matrix of condition 2e7, over hundreds of steps; Newton's
 * method and local-global iterations end at 1e-7 L. */
#define EXACT 1e-8
static const double SPEED = 1e-6;
#define G  9.81
#define T  1.0
#define DT 0.005

/* Of a damped fall the average acceleration is second order: (alpha dt)^2 / 12 = 5e-5 with
 * alpha = 5; implicit Euler, and a start without acceleration, are first order: dt / t of
 * the way. */
static const double SECOND = 1e-4;
#define FIRST (DT / T * (1 + 1e-6))

#define LATE "starts without acceleration: dt / t"
/* Marked: the kinetic energy is that of the step's mean speed, not of v. */
static const struct verify_entry entries[] = {
    {"iga_linear", EXACT, NULL, {5}, {4}},
    {"iga_paper", 0, "the paper's scheme", {5}, {4}, .mark = true},
    {"iga_incremental", FIRST, LATE, {5}, {4}, .mark = true},
    {"iga_nonlinear", EXACT, NULL, {5}, {4}},
    {"hex_linear", EXACT, NULL, {5}, {4}},
    {"hex_nonlinear", EXACT, NULL, {5}, {4}},
    {"shell_linear", EXACT, NULL, {5}},
    {"shell_2", EXACT, NULL, {5}},
    {"triangles", EXACT, NULL, {5}},
    {"mass_spring", FIRST, "implicit Euler: dt / t", {5}},
    {"position_based", FIRST, "as implicit Euler: dt / t", {5}},
    {"mass_spring_leapfrog", EXACT, NULL, {5}},
    {"mass_spring_momentum", EXACT, NULL, {5}},
    {"projective_dynamics", FIRST, "implicit Euler: dt / t", {5}},
    {"projective_dynamics_bdf2", EXACT, NULL, {5}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {5}, {5}};

/* One kind of fall, until T: rest + way along -z. */
struct fall {
    const char *quantity;
    const char *drag, *damping;
    double rate; /* alpha = c / rho, or of mass damping                         [1/s] */
};

static const struct fall falls[] = {
    {"free fall, way over g t^2 / 2", "drag.coefficient=0", "damping={kind: none}", 0},
    {"fall with drag, way at 1 s", "drag.coefficient=2.5", "damping={kind: none}", 5},
    {"fall with mass damping, way at 1 s", "drag.coefficient=0",
     "damping={kind: mass, value: 5}", 5},
};
enum { FALLS = sizeof falls / sizeof *falls, POINTS = 5 };

static const double uvw[POINTS][3] = {
    {0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {1, 1, 0.5}, {0.3, 0.6, 0.5}};

/* Largest deviation over the way fallen. */
static double deviation(const void *context, const double *a, const double *b)
{
    double worst = 0;

    for (int n = 0; n < 3 * POINTS; n++)
        worst = fmax(worst, fabs(a[n] - b[n]));
    return worst / *(const double *)context;
}

static void add_fall(struct verify_subject *s, const struct fall *f)
{
    const char *settings[] = {f->drag, f->damping, NULL};
    const double time = T, way = f->rate > 0
                                     ? G / f->rate * (T - (1 - exp(-f->rate * T)) / f->rate)
                                     : G * T * T / 2;
    double truth[POINTS][3];
    struct verify_trial_refine r = {.scene = "drag_fall",
                                    .settings = settings,
                                    .steps = VERIFY_TRIAL_STEPS,
                                    .step = DT,
                                    .times = 1,
                                    .time = &time,
                                    .n = POINTS,
                                    .uvw = uvw[0],
                                    .truth = truth[0],
                                    .measure = deviation,
                                    .context = &way};

    for (int n = 0; n < POINTS; n++) {
        truth[n][0] = uvw[n][0], truth[n][1] = uvw[n][1];
        truth[n][2] = -way;
    }
    if (f->rate > 0 && s->tolerance == EXACT)
        s->tolerance = SECOND, s->reason = "second order";
    if (f->rate == 0 && s->tolerance == EXACT)
        r.steps = 1;
    verify_trial_refine(s, &r, f->quantity);
}

/* Speed of a sheet of mass rho h L W by its kinetic energy [m/s]. */
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

/* Terminal speed rho g / c; exp(-c t / rho) of it is missing. */
static void add_terminal(struct verify_subject *s)
{
    const double end = 2, truth = 1.962, missing = exp(-5 * end);
    double speed;

    verify_subject_claim(s, missing, NULL);
    struct verify_trial t =
        verify_trial_of(s, "drag_fall", "terminal speed with drag [m/s]");
    t.end = end;
    if (verify_trial_watch(&t, see_speed, &speed))
        verify_row_judge(t.row, speed, truth, missing);
}

/* v <- mu v after every step: mu / (1 - mu) g dt, a speed that the step sets. */
static void add_scaled(struct verify_subject *s, double mu, double truth)
{
    const double dt = 0.001, end = mu > 0.95 ? 2 : 0.2; /* mu^n is missing */
    double speed;

    verify_subject_claim(s, SPEED, NULL);
    struct verify_trial t =
        verify_trial_of(s, "drag_fall", "v <- %g v: speed / (g dt)", mu);
    t.end = end;
    settings_set(&t.settings, "drag.coefficient=0");
    settings_set(&t.settings, "time.step=0.001");
    settings_print(&t.settings, "damping={kind: velocity_scale, value: %g}", mu);
    if (verify_trial_watch(&t, see_speed, &speed))
        verify_row_judge(t.row, speed / (G * dt) - (s->mark ? 0.5 : 0), truth,
                         fmax(pow(mu, end / dt), 1e-12));
}

static void run(struct verify_sheet *sheet)
{
    const struct reference *table = sheet->table;
    struct verify_subject s;

    for (int f = 0; f < FALLS; f++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);)
            add_fall(&s, &falls[f]);
    for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);)
        add_terminal(&s);
    for (int n = 0; (n = reference_find(table, n, "case", "newmark_vscale")) >= 0; n++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);)
            add_scaled(&s, reference_number(table, n, "a"),
                       reference_number(table, n, "v1"));
}

const struct verify_check verify_fall = {
    .item = {"fall", "free fall, body drag, mass damping and scaled velocities"},
    .table = "beam_elastica_cable",
    .source = "closed forms; mu / (1 - mu) by tests/reference/beam_elastica_cable.csv",
    .run = run,
};
