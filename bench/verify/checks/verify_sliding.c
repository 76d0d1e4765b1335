#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims: asked, on each net, of steps and iterations as they ship; a result that is
 * farther off says itself that steps have not arrived. Euler's step is 1 / 80 of the time,
 * and errs by as much of the way. */
#define ASKED 0.02, NULL
static const struct verify_subject entries[] = {
    {"iga,hex,shell", ASKED, .dear = true},
    {"shell_explicit_3", ASKED, {11, 21}, {5, 8}, .dear = true}, /* 22 s a row on 33 */
    {"triangles,triangles_explicit", ASKED},
    {"mass_spring,mass_spring_explicit,mass_spring_momentum,mass_spring_leapfrog", ASKED},
    {"position_based,projective_dynamics,projective_dynamics_admm", ASKED},
    {"projective_dynamics_bdf2,vbd", ASKED},
    {NULL}};
enum { NETS = 3 };
static const struct verify_field field = {
    .subject = entries, .along = {11, 21, 33}, .across = {5, 8, 12}};

/* A sheet on a plane that is inclined, and under friction; or that moves, as a belt. */
static const double G = 9.81, LENGTH = 0.3, DT = 0.005, END = 0.4;
static const struct {
    const char *quantity;
    double slope, friction, belt; /* [1], [1], [m/s] */
} cases[] = {{"slides without friction [m]", 0.5, 0, 0},
             {"slides, mu = 0.3 [m]", 0.5, 0.3, 0},
             {"creeps, mu = 0.8, over the law's speed", 0.5, 0.8, 0},
             {"is drawn along by a belt, mu = 0.3 [m]", 0, 0.3, 0.5}};
enum { CASES = sizeof cases / sizeof *cases };

/* The middle's x at half the time and at the end [m]; steps that have not arrived. */
struct seen {
    double half, end;
    long missed;
};

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct seen *s = context;
    double x[3];

    (void)why;
    m->model->probe(m->state, 1, (double[]){0.5, 0.5, 0.5}, x);
    s->end = x[0] - LENGTH / 2;
    if (m->time < END / 2 + DT / 4)
        s->half = s->end;
    s->missed = m->counters.missed;
    return STATUS_OK;
}

/* Returns the way of a block from rest: at an even acceleration, until a belt has it. */
static double way_of(double slope, double friction, double belt)
{
    const double a = belt > 0 ? friction * G : G * (sin(slope) - friction * cos(slope));

    return belt > 0 ? belt * END - belt * belt / (2 * a) : a * END * END / 2;
}

static void add_row(struct verify_subject *s)
{
    const int n = s->at / NETS;
    const double slope = cases[n].slope, friction = cases[n].friction;
    const double belt = cases[n].belt, speed = 1e-3 * sqrt(G * LENGTH); /* of creep */
    struct seen seen = {.half = NAN};

    if (s->at % NETS >= s->nets)
        return;
    verify_subject_only(s, s->at % NETS);
    struct verify_trial t = verify_trial_of(s, "ground", "%s", cases[n].quantity);
    verify_trial_set(
        &t,
        "sheet={length: %g, width: 0.1, thickness: 0.002};"
        "pose={origin: [0,0,0.001001], u: [1,0,0], v: [0,1,0]};"
        "material={young: 1e6, poisson: 0.3, density: 300}; damping={kind: none};"
        "gravity=[%.17g,0,%.17g]; time.step=%g; contact={self: false};"
        "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1], friction: %g},"
        "path: [[0,0,0,0],[1,%g,0,0]]}]",
        LENGTH, G * sin(slope), -G * cos(slope), DT, friction, belt);
    t.end = END;
    if (!verify_trial_watch(&t, look, &seen))
        return;
    if (tan(slope) < friction && belt == 0)
        verify_row_judge(t.row, (seen.end - seen.half) / (END / 2 * speed),
                         1 - sqrt(1 - tan(slope) / friction), 0);
    else
        verify_row_judge(t.row, seen.end, way_of(slope, friction, belt), 0);
    if (t.row->verdict == VERDICT_MISSED && seen.missed)
        verify_row_end(t.row, VERDICT_OUT_OF_RANGE, "told: %ld steps have not arrived",
                       seen.missed);
}

const struct verify_check verify_sliding = {
    {"sliding", "a sheet that slides, creeps, and is drawn along, on three nets"},
    "Coulomb: g (sin - mu cos) t^2 / 2 on a slope of 0.5, v t - v^2 / (2 mu g) on a belt "
    "of "
    "the speed v; the law's creep, 1 - sqrt(1 - tan / mu)",
    .slow = true,
    .parts = {{&field, add_row, CASES *NETS, .every = NETS}}};
