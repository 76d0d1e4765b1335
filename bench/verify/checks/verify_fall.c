/* A free sheet that falls without deforming: what time stepping and damping make of a rigid
 * body. */
#include <math.h>
#include <stdio.h>

#include "bench/verify/verify_refine.h"

extern const struct verify_check verify_fall;

/* Round-off of a solve with a matrix of condition 2e7, over hundreds of steps; Newton's
 * method and local-global iterations end at 1e-7 L. */
static const double EXACT = 1e-8, SPEED = 1e-6;
#define G  9.81
#define T  1.0
#define DT 0.005

/* Of a damped fall the average acceleration is second order: (alpha dt)^2 / 12 = 5e-5 with
 * alpha = 5; implicit Euler, and a start without acceleration, are first order: dt / t of
 * the way. */
static const double SECOND = 1e-4, FIRST = DT / T * (1 + 1e-6);

struct subject {
    struct verify_subject subject;
    bool mean; /* its kinetic energy is that of the step's mean speed, not of v         */
};

#define KINEMATICS(k) "discretization.points=[5,4,2] discretization.kinematics=" k
#define SHELL(k)      "discretization.points=[5,5] discretization.kinematics=" k
#define LATE          "starts without acceleration: dt / t"
#define EULER         "implicit Euler: dt / t"
static const struct subject subjects[] = {
    {{"iga, linear", "iga", KINEMATICS("linear"), EXACT, NULL}, false},
    {{"iga, printed", "iga", KINEMATICS("printed"), NAN, "the paper's scheme"}, true},
    {{"iga, incremental", "iga", KINEMATICS("incremental"), FIRST, LATE}, true},
    {{"iga, nonlinear", "iga", KINEMATICS("nonlinear"), EXACT, NULL}, false},
    {{"hex, linear", "hex", KINEMATICS("linear"), EXACT, NULL}, false},
    {{"hex, nonlinear", "hex", KINEMATICS("nonlinear"), EXACT, NULL}, false},
    {{"shell, linear", "shell", SHELL("linear"), EXACT, NULL}, false},
    {{"shell, nonlinear", "shell", SHELL("nonlinear"), EXACT, NULL}, false},
    {{"mass_spring", "mass_spring", "discretization.points=[5,5]", FIRST, EULER}, false},
    {{"projective_dynamics", "projective_dynamics", "discretization.points=[5,5]", FIRST,
      EULER},
     false},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

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

static enum status add_fall(struct verify_sheet *sheet, const struct subject *s,
                            const struct fall *f, struct message *why)
{
    const char *settings[] = {f->drag, f->damping, NULL}, *nothing = "sheet.length=1";
    const double time = T, way = f->rate > 0
                                     ? G / f->rate * (T - (1 - exp(-f->rate * T)) / f->rate)
                                     : G * T * T / 2;
    double truth[POINTS][3];
    struct verify_subject subject = s->subject;
    bool lived;
    struct verify_refine r = {.scene = "drag_fall",
                              .settings = settings,
                              .nets = 1,
                              .net = &nothing,
                              .steps = VERIFY_REFINE_STEPS,
                              .step = DT,
                              .times = 1,
                              .time = &time,
                              .n = POINTS,
                              .uvw = uvw[0],
                              .truth = truth[0],
                              .bar = 0,
                              .measure = deviation,
                              .context = &way};

    for (int n = 0; n < POINTS; n++) {
        truth[n][0] = uvw[n][0], truth[n][1] = uvw[n][1];
        truth[n][2] = -way;
    }
    if (f->rate > 0 && subject.tolerance == EXACT)
        subject.tolerance = SECOND, subject.reason = "second order";
    if (f->rate == 0 && subject.tolerance == EXACT)
        r.steps = 1;
    return verify_refine(sheet, &subject, &r, f->quantity, &lived, why);
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
static enum status add_terminal(struct verify_sheet *sheet, const struct subject *s,
                                struct message *why)
{
    enum status st;
    const double end = 2, truth = 1.962, missing = exp(-5 * end);
    struct verify_subject subject = s->subject;
    double speed;
    bool lived;

    if (!isnan(subject.tolerance))
        subject.tolerance = missing, subject.reason = NULL;
    struct verify_row *row = verify_add(sheet, &subject, "terminal speed with drag [m/s]");
    TRY(verify_watch(row, &subject, "drag_fall", NULL, end, see_speed, &speed, &lived,
                     why));
    if (lived)
        verify_judge(row, speed, truth, missing);
out:
    return st;
}

/* v <- mu v after every step: mu / (1 - mu) g dt, a speed that the step sets. */
static enum status add_scaled(struct verify_sheet *sheet, const struct subject *s,
                              double mu, double truth, struct message *why)
{
    enum status st;
    const double dt = 0.001, end = mu > 0.95 ? 2 : 0.2; /* mu^n is missing */
    char damping[64];
    const char *settings[] = {"drag.coefficient=0", "time.step=0.001", damping, NULL};
    struct verify_subject subject = s->subject;
    double speed;
    bool lived;

    if (!isnan(subject.tolerance))
        subject.tolerance = SPEED, subject.reason = NULL;
    struct verify_row *row = verify_add(sheet, &subject, "v <- %g v: speed / (g dt)", mu);
    snprintf(damping, sizeof damping, "damping={kind: velocity_scale, value: %g}", mu);
    TRY(verify_watch(row, &subject, "drag_fall", settings, end, see_speed, &speed, &lived,
                     why));
    if (lived)
        verify_judge(row, speed / (G * dt) - (s->mean ? 0.5 : 0), truth,
                     fmax(pow(mu, end / dt), 1e-12));
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("beam_elastica_cable", &table, why));
    for (int f = 0; f < FALLS; f++)
        for (int s = 0; s < SUBJECTS; s++)
            if (verify_wanted(sheet, &subjects[s].subject))
                TRY(add_fall(sheet, &subjects[s], &falls[f], why));
    for (int s = 0; s < SUBJECTS; s++)
        if (verify_wanted(sheet, &subjects[s].subject))
            TRY(add_terminal(sheet, &subjects[s], why));
    for (int n = 0; (n = reference_find(table, n, "case", "newmark_vscale")) >= 0; n++)
        for (int s = 0; s < SUBJECTS; s++)
            if (verify_wanted(sheet, &subjects[s].subject))
                TRY(add_scaled(sheet, &subjects[s], reference_number(table, n, "a"),
                               reference_number(table, n, "v1"), why));
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_fall = {
    .item = {"fall", "free fall, body drag, mass damping and scaled velocities"},
    .source = "closed forms; mu / (1 - mu) by tests/reference/beam_elastica_cable.csv",
    .run = run,
};
