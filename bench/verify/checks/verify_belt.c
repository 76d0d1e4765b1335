#include <math.h>
#include <string.h>

#include "bench/harness/warnings.h"
#include "bench/verify/verify_check.h"

/* Claims: 1 %; the sheet touches with some twenty points, which turn it by a tenth each. */
#define BELT 0.01, NULL
static const struct verify_subject entries[] = {
    {"iga_selective,hex_incompatible", BELT, {64}, {3}, .dear = true},
    {"shell_3", BELT, {64}, {4}, .dear = true},
    {"triangles,mass_spring,mass_spring_momentum,position_based", BELT, {64}, {3}},
    {"projective_dynamics", BELT, {64}, {3}, VERIFY_TO_THE_END, .dear = true},
    {NULL}};
static const struct verify_field field = {.subject = entries};

/* All that slide, on coarse nets: 2 % is asked, or a result that says itself why not. */
#define ASKED 0.02, NULL
static const struct verify_subject coarse[] = {
    {"triangles,triangles_explicit,mass_spring,mass_spring_momentum", ASKED},
    {"mass_spring_leapfrog,position_based,projective_dynamics,vbd", ASKED},
    {"iga,hex,shell,shell_explicit_3", ASKED, .dear = true},
    {NULL}};
enum { NETS = 3 };
static const struct verify_field nets = {.subject = coarse, .along = {11, 21, 33}};

/* A strip 1 m long over a rod, of radius R to its mid-surface; one end is pulled by PULL
 * per width, the other is led down to the slope DOWN and then away. The law's speed of
 * creep is a thousandth of that at which it is led down, 0.4 mm/s. */
static const double R = 0.15, CONTACT = 0.002, WIDTH = 0.05, PULL = 1, DOWN = 1.0;
static const double TOP = 0.6, LED = 1, SLIDE = 0.3, SPEED = 0.01;
static const double B = 3.3e6 * 3e-4 * 3e-4 * 3e-4 / 12;

/* Means of the last frames, in x and z: a step's force swings with what iterations leave.
 */
enum { LAST = 20 };
struct seen {
    const struct verify_trial *trial;
    double force[2];  /* on the sheet [N]                              */
    double end[2][2]; /* unit vectors along its ends, outwards      */
    const char *told; /* why the run is not to be trusted; NULL: it does not say so */
};

/* Returns what a run says against itself. */
static const char *told_of(const struct verify_trial *t, const struct motion *m)
{
    double number[WARNINGS_NUMBERS];

    if (m->counters.missed)
        return "told: not all steps have arrived";
    for (const struct warnings_rule *rule = warnings_rules; rule->name; rule++)
        if (!strcmp(rule->name, "round") && rule->holds(&t->run, number))
            return "told: the rod is round between two points of the net";
    return NULL;
}

static enum status look(void *context, const struct motion *m, struct message *why)
{
    static const double uvw[4][3] = {
        {0.1, 0.5, 0.5}, {0, 0.5, 0.5}, {0.92, 0.5, 0.5}, {0.98, 0.5, 0.5}};
    struct seen *s = context;
    struct model_contact c = {0};
    double x[4][3];

    (void)why;
    if (m->frames + LAST <= m->frame_count)
        return STATUS_OK;
    s->told = told_of(s->trial, m);
    m->model->contact(m->state, &c);
    m->model->probe(m->state, 4, uvw[0], x[0]);
    s->force[0] += c.force[0] / LAST, s->force[1] += c.force[2] / LAST;
    for (int e = 0; e < 2; e++) {
        const double *from = x[2 * e], *to = x[2 * e + 1];
        const double length = hypot(to[0] - from[0], to[2] - from[2]);
        s->end[e][0] += (to[0] - from[0]) / length / LAST;
        s->end[e][1] += (to[2] - from[2]) / length / LAST;
    }
    return STATUS_OK;
}

/* Leads the end u = 1 down around the rod, and then pulls. */
static void add_path(struct verify_trial *t)
{
    enum { ROWS = 10 };

    settings_set(&t->settings, "supports=[{at: {u: 1, w: 0.5}, fix: xyz, path: [");
    for (int n = 0; n <= ROWS; n++) {
        const double turn = DOWN * n / ROWS, rest = 1 - TOP - R * turn;
        settings_more(&t->settings, "%s[%g,%.17g,0,%.17g]", n ? "," : "", LED * n / ROWS,
                      R * sin(turn) + rest * cos(turn) - (1 - TOP),
                      R * (cos(turn) - 1) - rest * sin(turn));
        if (n == ROWS)
            settings_more(&t->settings, ",[%g,%.17g,0,%.17g]]}]", LED + SLIDE,
                          R * sin(turn) + (rest + SLIDE * SPEED) * cos(turn) - (1 - TOP),
                          R * (cos(turn) - 1) - (rest + SLIDE * SPEED) * sin(turn));
    }
}

/* Judges the ratio of the tensions at the ends that balance the force. Bending lifts the
 * strip off before its end's direction, but presses there in return: of the angle it takes
 * nothing, of the ratio B / (T R^2). */
static void judge(struct verify_row *row, const struct seen *s, double friction)
{
    const double(*d)[2] = s->end, det = d[0][0] * d[1][1] - d[0][1] * d[1][0];
    const double T1 = -(s->force[0] * d[1][1] - s->force[1] * d[1][0]) / det / WIDTH,
                 T2 = -(s->force[1] * d[0][0] - s->force[0] * d[0][1]) / det / WIDTH;
    const double turn = acos(-d[0][0] * d[1][0] - d[0][1] * d[1][1]);

    verify_row_judge(row, T2 / T1, exp(friction * turn), B / (T1 * R * R));
    verify_row_note(row, "turned by %.4g, T1 = %.4g N/m", turn, T1);
}

/* may_tell: a missed claim may be one that the run tells of. */
static void draw(struct verify_subject *s, double friction, bool may_tell)
{
    struct verify_trial t =
        verify_trial_of(s, "free_fall", "ratio of tensions, mu = %g", friction);
    struct seen seen = {.trial = &t};

    add_path(&t);
    verify_trial_set(
        &t,
        "sheet={length: 1, width: %g, thickness: 3e-4}; pose={origin: [0,0,0]};"
        "material={young: 3.3e6, poisson: 0, density: 33}; gravity=[0,0,0];"
        "damping={kind: mass, value: 100};"
        "loads=[{at: {u: 0}, force: [%.17g,0,%.17g]}];"
        "obstacles=[{capsule: {from: [%g,-1,%.17g], to: [%g,1,%.17g], radius: %.17g,"
        "friction: %g}}];"
        "contact={self: false, thickness: %g, stiffness: 1e3}; time={step: 0.005, end: %g}",
        WIDTH, -PULL * WIDTH * cos(DOWN), -PULL * WIDTH * sin(DOWN), TOP, -R, TOP, -R,
        R - CONTACT / 2, friction, CONTACT, LED + SLIDE);
    if (verify_trial_watch(&t, look, &seen))
        judge(t.row, &seen, friction);
    if (may_tell && t.row->verdict == VERDICT_MISSED && seen.told)
        verify_row_end(t.row, VERDICT_OUT_OF_RANGE, "%s", seen.told);
}

static void add_row(struct verify_subject *s)
{
    draw(s, (double[]){0.3, 0.6}[s->at], false);
}

static void add_net(struct verify_subject *s)
{
    if (s->sheet->quick)
        return;
    verify_subject_only(s, s->at);
    draw(s, 0.3, true);
}

const struct verify_check verify_belt = {
    {"belt", "a strip drawn over a round rod, against friction"},
    "Euler 1762, T2 / T1 = exp(mu phi)",
    .parts = {{&field, add_row, 2, .every = 2}, {&nets, add_net, NETS}}};
