#include <math.h>

#include "bench/verify/verify_check.h"
#include "models/contact/contact_law.h"

/* Claims: forces and accelerations, of the weight and of g, since iterations end far below;
 * the creep of a sheet that sticks, of places 1e-6 m apart that iterations end near; slips
 * without one, at the ends of iterations, 1e-6 to 1e-8 L; gaps, round-off of the solve. */
#define BALANCE 1e-6, NULL
static const double CREEP = 2e-3, STUCK = 1e-5, CLOSED = 1e-11;

static const double G = 9.81, SLOPE = 0.4, LENGTH = 0.5;
static const double WEIGHT = 9.81 * 200 * 0.004 * 0.5 * 0.4, AREA = 0.5 * 0.4;

/* A sheet sinks from where contact starts to the gap that carries it; a solid swings
 * through its thickness, and breathes, when its weight comes onto it: forces are looked at
 * after that, with a step that resolves it and stiffness damping, which leaves rigid motion
 * alone; at rest mass damping ends what is slower. */
static const struct verify_subject entries[] = {
    {"iga_linear", BALANCE},
    {"iga_paper", 0, "the paper's scheme"},
    {"iga_incremental", 0, "forgets its stress"},
    {"iga_nonlinear,hex_linear,hex_nonlinear,shell_linear,shell_2,triangles", BALANCE},
    {"mass_spring", BALANCE, .settings = {"discretization.tolerance=1e-10"}},
    {"mass_spring_momentum,position_based,projective_dynamics", BALANCE},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {8}, {7}};

enum { SIDE = 21, LOOKS = 12 };

/* Measurements of the last frames. */
struct seen {
    double settled; /* start of the measurements                                  [s] */
    double force;   /* along z, the farthest from the weight                      [N] */
    double gap;     /* least                                                      [m] */
    struct contact_law law;
    double along[3]; /* the centre's x in the last three frames                    [m] */
    double from;     /* the centre's x at the first measurement                    [m] */
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
    s->law = contact_law_body(m->scene);
    if (s->looks == 0 || fabs(c.force[2] - WEIGHT) > fabs(s->force - WEIGHT))
        s->force = c.force[2];
    s->gap = s->looks ? fmin(s->gap, c.least_gap) : c.least_gap;
    for (int n = 0; n < SIDE * SIDE; n++) { /* the trapezoidal rule */
        const double i = n % SIDE, j = n / SIDE, last = SIDE - 1;
        const double weight = (fmod(i, last) > 0 ? 1 : 0.5) * (fmod(j, last) > 0 ? 1 : 0.5);
        double x[3];
        m->model->probe(m->state, 1, (double[]){i / last, j / last, 0.5}, x);
        sum += weight * x[0];
        total += weight;
    }
    s->along[0] = s->along[1], s->along[1] = s->along[2], s->along[2] = sum / total;
    if (s->looks++ == 0)
        s->from = s->along[2];
    return STATUS_OK;
}

/* Tells whether contact is a pressure over a gap; else points stop at half a thickness. */
static bool by_law(const struct verify_subject *s)
{
    return strcmp(s->contestant->model->name, "projective_dynamics") != 0;
}

static void judge_rest(struct verify_subject *s, struct verify_row *row,
                       const struct seen *seen)
{
    const double gap =
        by_law(s) ? contact_law_distance(&seen->law, WEIGHT / AREA) - seen->law.start : 0;

    verify_row_judge(row, seen->force, WEIGHT, 0);
    verify_subject_claim(s, CLOSED, NULL);
    row = verify_sheet_add(s, "gap under the weight [m], error / L");
    row->value = seen->gap, row->truth = gap;
    verify_row_judge_error(row, fabs(seen->gap - gap) / LENGTH, 0);
}

/* Friction is 2 y - y^2 of mu at the slip's speed y in that of the law's creep. */
static void judge_stick(const struct verify_subject *s, struct verify_row *row,
                        const struct seen *seen, double dt, double friction)
{
    if (by_law(s))
        verify_row_judge(row, (seen->along[2] - seen->along[1]) / dt,
                         seen->law.creep * (1 - sqrt(1 - tan(SLOPE) / friction)), 0);
    else
        verify_row_judge_error(row, fabs(seen->along[2] - seen->from) / LENGTH, 0);
}

/* Adds the rows of a sheet at rest on the level, and then of planes inclined by SLOPE
 * (gravity is). A quick run leaves out those of whom nothing is claimed. */
static void add_rows(struct verify_subject *s)
{
    const bool rest = s->at == 0;
    const double friction = (double[]){0.5, 0, 0.2, 0.6}[s->at], slope = rest ? 0 : SLOPE;
    const double dt = s->layers ? 2e-4 : 0.005,
                 pull = G * (sin(slope) - friction * cos(slope));
    struct seen seen = {.settled = (s->layers ? 450 : 60) * dt};

    if (s->sheet->quick && isnan(s->tolerance))
        return;
    if (!rest && pull <= 0)
        verify_subject_claim(s, by_law(s) ? CREEP : STUCK, s->reason);
    struct verify_trial t =
        rest ? verify_trial_of(s, "ground", "force on the ground [N]")
             : verify_trial_of(s, "ground",
                               pull > 0    ? "slides, mu = %g [m/s^2], error / g"
                               : by_law(s) ? "creeps, mu = %g [m/s]"
                                           : "slips / L, mu = %g",
                               friction);
    verify_trial_set(
        &t,
        "sheet={length: 0.5, width: 0.4, thickness: 0.004};"
        "pose={origin: [0,0,0.002], u: [1,0,0], v: [0,1,0]};"
        "material={young: 1e5, poisson: 0.3, density: 200};"
        "gravity=[%.17g,0,%.17g]; time.step=%.17g; damping={kind: none};"
        "obstacles=[{plane: {point: [3,-1,0], normal: [0,0,2], friction: %g}}]",
        G * sin(slope), -G * cos(slope), dt, friction);
    if (s->layers)
        verify_trial_set(&t, "damping={kind: rayleigh, alpha: %d, beta: 4e-3}",
                         rest ? 300 : 0);
    t.end = seen.settled + LOOKS * dt;
    if (!verify_trial_watch(&t, look, &seen))
        return;
    if (rest)
        judge_rest(s, t.row, &seen);
    else if (pull > 0) {
        t.row->value = (seen.along[2] - 2 * seen.along[1] + seen.along[0]) / (dt * dt);
        t.row->truth = pull;
        verify_row_judge_error(t.row, fabs(t.row->value - pull) / G, 0);
    } else
        judge_stick(s, t.row, &seen, dt, friction);
}

const struct verify_check verify_contact = {
    {"contact", "a sheet that lies, sticks and slides on a plane"},
    "its weight, the law's gap under it; Coulomb: g (sin - mu cos) on an incline of 0.4, "
    "and the law's creep",
    .slow = true,
    .parts = {{&field, add_rows, 4}}};
