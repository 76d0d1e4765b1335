#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: forces and accelerations, of the weight and of g, since iterations end far below;
 * creep and compression, since they follow from the force through a law of which the
 * iterations, 1e-6 to 1e-8 L, see a part: creep moves 2e-7 m a step. */
#define BALANCE 1e-6, NULL
static const double CREPT = 0.01, COMPRESSED = 1e-4;
/* The compression of a spline's net, whose samples share the area otherwise than its weight
 * is shared: least at the edge. */
static const double UNEVEN = 0.1;

static const double G = 9.81, SLOPE = 0.4, LENGTH = 0.5;
static const double PRESSURE = 9.81 * 200 * 0.004, AREA = 0.5 * 0.4;
/* The law: its range towards a body, half of the scene's; the pressure at half of it; the
 * speed below which what sticks creeps, over sqrt(g L). */
static const double RANGE = 1e-3, KAPPA = 4000, CREEP = 1e-3;

/* A solid swings through its thickness, and breathes, when its weight comes onto it: forces
 * are looked at after that, with a step that resolves it and stiffness damping, which
 * leaves rigid motion alone; at rest mass damping ends what is slower. */
static const struct verify_subject entries[] = {
    {"iga_nonlinear,hex_nonlinear,shell_2,triangles", BALANCE},
    {"mass_spring", BALANCE, .settings = {"discretization.tolerance=1e-9"}},
    {"mass_spring_momentum,position_based", BALANCE},
    {"projective_dynamics", BALANCE, .settings = {"discretization.tolerance=1e-9"}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {8}, {7}};

enum { SIDE = 21, LOOKS = 12 };

/* Measurements of the last frames. */
struct seen {
    double settled;  /* start of the measurements                                  [s] */
    double force;    /* along z, the farthest from the weight                      [N] */
    double gap;      /* least, the last                                            [m] */
    double along[3]; /* the centre's x in the last three frames                    [m] */
    int looks;
};

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct seen *s = context;
    struct model_contact c = {0};
    double sum = 0, total = 0;

    (void)why;
    if (m->time < s->settled - m->scene->step / 4 || m->frames == 0)
        return STATUS_OK;
    m->model->contact(m->state, &c);
    const double weight = PRESSURE * AREA;
    if (s->looks++ == 0 || fabs(c.force[2] - weight) > fabs(s->force - weight))
        s->force = c.force[2];
    s->gap = c.least_gap;
    for (int n = 0; n < SIDE * SIDE; n++) { /* the trapezoidal rule */
        const double i = n % SIDE, j = n / SIDE, last = SIDE - 1;
        const double share = (fmod(i, last) > 0 ? 1 : 0.5) * (fmod(j, last) > 0 ? 1 : 0.5);
        double x[3];
        m->model->probe(m->state, 1, (double[]){i / last, j / last, 0.5}, x);
        sum += share * x[0];
        total += share;
    }
    s->along[0] = s->along[1], s->along[1] = s->along[2], s->along[2] = sum / total;
    return STATUS_OK;
}

/* Judges what the last frames showed: a share of the range by which a pressure compresses
 * the contact; or a pull along the slope, that of friction less. */
static void judge(struct verify_subject *s, struct verify_trial *t, const struct seen *seen,
                  double dt, double slope, double friction)
{
    const double pull = G * (sin(slope) - friction * cos(slope));
    const double root = sqrt(PRESSURE / KAPPA);

    if (slope == 0) {
        verify_row_judge(t->row, seen->force, PRESSURE * AREA, 0);
        verify_subject_claim(s, s->degree > 1 ? UNEVEN : COMPRESSED, NULL);
        verify_row_judge(verify_sheet_add(s, "compression / range"), -seen->gap / RANGE,
                         1 - 1 / (1 + root), 0);
    } else if (pull > 0) {
        t->row->value = (seen->along[2] - 2 * seen->along[1] + seen->along[0]) / (dt * dt);
        t->row->truth = pull;
        verify_row_judge_error(t->row, fabs(t->row->value - pull) / G, 0);
    } else
        verify_row_judge(
            t->row, (seen->along[2] - seen->along[1]) / (dt * sqrt(G * LENGTH) * CREEP),
            1 - sqrt(1 - tan(slope) / friction), 0);
}

/* Adds the rows of a sheet at rest on the level, and then of planes inclined by SLOPE
 * (gravity is). */
static void add_rows(struct verify_subject *s)
{
    const bool rest = s->at == 0;
    const double friction = (double[]){0.5, 0, 0.2, 0.6}[s->at], slope = rest ? 0 : SLOPE;
    const double dt = s->layers ? 2e-4 : 0.001;
    const bool slides = tan(slope) > friction;
    struct seen seen = {.settled = 0.1};

    if (!rest && !slides)
        verify_subject_claim(s, CREPT, s->reason);
    struct verify_trial t =
        rest ? verify_trial_of(s, "ground", "force on the ground [N]")
             : verify_trial_of(s, "ground",
                               slides ? "slides, mu = %g [m/s^2], error / g"
                                      : "creeps, mu = %g, over the law's speed",
                               friction);
    verify_trial_set(
        &t,
        "sheet={length: 0.5, width: 0.4, thickness: 0.004};"
        "pose={origin: [0,0,0.002], u: [1,0,0], v: [0,1,0]};"
        "material={young: 1e5, poisson: 0.3, density: 200};"
        "gravity=[%.17g,0,%.17g]; time.step=%.17g; damping={kind: none};"
        "contact={self: false, thickness: 0.004, range: %.17g, stiffness: %g};"
        "obstacles=[{plane: {point: [3,-1,0], normal: [0,0,2], friction: %g}}]",
        G * sin(slope), -G * cos(slope), dt, 2 * RANGE, KAPPA, friction);
    if (s->layers)
        verify_trial_set(&t, "damping={kind: rayleigh, alpha: %d, beta: 4e-3}",
                         rest ? 300 : 0);
    t.end = seen.settled + LOOKS * dt;
    if (verify_trial_watch(&t, look, &seen))
        judge(s, &t, &seen, dt, slope, friction);
}

const struct verify_check verify_contact = {
    {"contact", "a sheet that lies, creeps and slides on a plane"},
    "its weight; the law: compression r - r / (1 + sqrt(p / kappa)), creep v (1 - sqrt(1 - "
    "tan / mu)); Coulomb: g (sin - mu cos) on an incline of 0.4",
    .slow = true,
    .parts = {{&field, add_rows, 4}}};
