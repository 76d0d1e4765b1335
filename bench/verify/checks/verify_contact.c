/* A sheet that lies on a plane, level and inclined, with Coulomb friction. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/verify/verify.h"

extern const struct verify_check verify_contact;

/* Forces and accelerations, of the weight and of g: iterations end far below. A sheet that
 * sticks: their ends, 1e-6 to 1e-8 L. Gaps: round-off of the solve. */
static const double BALANCE = 1e-6, STUCK = 1e-5, CLOSED = 1e-11;

static const double G = 9.81, SLOPE = 0.4, LENGTH = 0.5;
static const double WEIGHT = 9.81 * 200 * 0.004 * 0.5 * 0.4;

/* A solid swings through its thickness, and breathes, when its weight comes onto it: forces
 * are looked at after that, with a step that resolves it and stiffness damping, which
 * leaves rigid motion alone; at rest mass damping ends what is slower. */
struct subject {
    struct verify_subject subject;
    bool solid;
};

#define SOLID(k) "discretization.points=[8,7,2] discretization.kinematics=" k
#define SHELL(k) "discretization.points=[8,7] discretization.kinematics=" k
#define NET      "discretization.points=[8,7]"
static const struct subject subjects[] = {
    {{"iga, linear", "iga", SOLID("linear"), BALANCE, NULL}, true},
    {{"iga, printed", "iga", SOLID("printed"), NAN, "the paper's scheme"}, true},
    {{"iga, incremental", "iga", SOLID("incremental"), NAN, "forgets its stress"}, true},
    {{"iga, nonlinear", "iga", SOLID("nonlinear"), BALANCE, NULL}, true},
    {{"hex, linear", "hex", SOLID("linear"), BALANCE, NULL}, true},
    {{"hex, nonlinear", "hex", SOLID("nonlinear"), BALANCE, NULL}, true},
    {{"shell, linear", "shell", SHELL("linear"), BALANCE, NULL}, false},
    {{"shell, nonlinear", "shell", SHELL("nonlinear"), BALANCE, NULL}, false},
    {{"mass_spring", "mass_spring", NET " discretization.tolerance=1e-9", BALANCE, NULL},
     false},
    {{"projective_dynamics", "projective_dynamics", NET, BALANCE, NULL}, false},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

enum { SIDE = 21, LOOKS = 12 };

/* What is seen of the last frames. */
struct seen {
    double settled;  /* when looking begins                                        [s] */
    double force;    /* along z, the farthest from the weight                      [N] */
    double gap;      /* least                                                      [m] */
    double along[3]; /* the centre's x in the last three frames                    [m] */
    double from;     /* ... and when looking began                                     */
    int looks;
};

/* Centre of mass along x, by the trapezoidal rule. */
static double centre(const struct motion *m)
{
    double sum = 0, total = 0;

    for (int n = 0; n < SIDE * SIDE; n++) {
        const int i = n % SIDE, j = n / SIDE;
        const double uvw[3] = {(double)i / (SIDE - 1), (double)j / (SIDE - 1), 0.5};
        double x[3], weight = (i % (SIDE - 1) ? 1 : 0.5) * (j % (SIDE - 1) ? 1 : 0.5);
        m->model->probe(m->state, 1, uvw, x);
        sum += weight * x[0];
        total += weight;
    }
    return sum / total;
}

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct seen *s = context;
    struct model_contact c = {0};

    (void)why;
    if (m->time < s->settled - m->scene->step / 4 || m->frames == 0)
        return STATUS_OK;
    m->model->contact(m->state, &c);
    if (s->looks == 0 || fabs(c.force[2] - WEIGHT) > fabs(s->force - WEIGHT))
        s->force = c.force[2];
    s->gap = s->looks ? fmin(s->gap, c.least_gap) : c.least_gap;
    s->along[0] = s->along[1], s->along[1] = s->along[2], s->along[2] = centre(m);
    if (s->looks++ == 0)
        s->from = s->along[2];
    return STATUS_OK;
}

/* Runs a sheet on a plane inclined by `slope` (gravity is): what is seen of it. */
static enum status watch_sheet(struct verify_row *row, const struct subject *s,
                               double slope, double friction, double mass,
                               struct seen *seen, bool *lived, struct message *why)
{
    char gravity[96], obstacle[128], damping[96];
    const char *settings[] = {"sheet={length: 0.5, width: 0.4, thickness: 0.004}",
                              "pose={origin: [0,0,0.002], u: [1,0,0], v: [0,1,0]}",
                              "material={young: 1e5, poisson: 0.3, density: 200}",
                              gravity,
                              obstacle,
                              damping,
                              s->solid ? "time.step=2e-4" : "time.step=0.005",
                              NULL};
    const double dt = s->solid ? 2e-4 : 0.005;

    *seen = (struct seen){.settled = s->solid ? 450 * dt : 0};
    snprintf(gravity, sizeof gravity, "gravity=[%.17g,0,%.17g]", G * sin(slope),
             -G * cos(slope));
    snprintf(obstacle, sizeof obstacle,
             "obstacles=[{plane: {point: [3,-1,0], normal: [0,0,2], friction: %g}}]",
             friction);
    snprintf(damping, sizeof damping,
             s->solid ? "damping={kind: rayleigh, alpha: %g, beta: 4e-3}"
                      : "damping={kind: none}",
             mass);
    return verify_watch(row, &s->subject, "ground", settings, seen->settled + LOOKS * dt,
                        look, seen, lived, why);
}

static enum status add_rest(struct verify_sheet *sheet, const struct subject *s,
                            struct message *why)
{
    enum status st;
    struct seen seen;
    struct verify_subject gap = s->subject;
    bool lived;
    struct verify_row *row = verify_add(sheet, &s->subject, "force on the ground [N]");

    TRY(watch_sheet(row, s, 0, 0.5, 300, &seen, &lived, why));
    if (!lived)
        goto out;
    verify_judge(row, seen.force, WEIGHT, 0);
    gap.tolerance = isnan(gap.tolerance) ? NAN : CLOSED;
    gap.reason = NULL;
    row = verify_add(sheet, &gap, "least gap of the net / L");
    verify_judge_error(row, fabs(seen.gap) / LENGTH, 0);
out:
    return st;
}

static enum status add_slide(struct verify_sheet *sheet, const struct subject *s,
                             double friction, struct message *why)
{
    enum status st;
    struct seen seen;
    const double dt = s->solid ? 2e-4 : 0.005;
    const double pull = G * (sin(SLOPE) - friction * cos(SLOPE));
    struct verify_subject subject = s->subject;
    bool lived;

    if (pull <= 0 && !isnan(subject.tolerance))
        subject.tolerance = STUCK;
    struct verify_row *row = verify_add(
        sheet, &subject,
        pull > 0 ? "slides, mu = %g [m/s^2], error / g" : "slips / L, mu = %g", friction);
    TRY(watch_sheet(row, s, SLOPE, friction, 0, &seen, &lived, why));
    if (!lived)
        goto out;
    if (pull > 0) {
        row->value = (seen.along[2] - 2 * seen.along[1] + seen.along[0]) / (dt * dt);
        row->truth = pull;
        verify_judge_error(row, fabs(row->value - pull) / G, 0);
    } else
        verify_judge_error(row, fabs(seen.along[2] - seen.from) / LENGTH, 0);
out:
    return st;
}

/* Where nothing is claimed, the hasty do not look. */
static bool wanted(const struct verify_sheet *sheet, const struct verify_subject *subject)
{
    return verify_wanted(sheet, subject) &&
           (!verify_quick(sheet) || !isnan(subject->tolerance));
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;
    static const double frictions[] = {0, 0.2, 0.6};

    for (int s = 0; s < SUBJECTS; s++)
        if (wanted(sheet, &subjects[s].subject))
            TRY(add_rest(sheet, &subjects[s], why));
    for (int n = 0; n < 3; n++)
        for (int s = 0; s < SUBJECTS; s++)
            if (wanted(sheet, &subjects[s].subject))
                TRY(add_slide(sheet, &subjects[s], frictions[n], why));
out:
    return st;
}

const struct verify_check verify_contact = {
    .item = {"contact", "a sheet that lies, sticks and slides on a plane"},
    .slow = true,
    .source = "its weight; Coulomb: g (sin - mu cos) on an incline of 0.4",
    .run = run,
};
