#include <math.h>

#include "bench/verify/verify_check.h"

/* Claims, of the clamp's way: what sticks creeps, some 1e-3 of the length, and slips within
 * a hundredth of a second; both are hundredths of the shortest way. */
#define SEEN 0.03, NULL
static const struct verify_subject entries[] = {
    {"iga_selective", SEEN, {40}, {3}, .dear = true},
    {"shell_3", SEEN, {40}, {4}, .dear = true},
    {"triangles,mass_spring,mass_spring_momentum", SEEN, {40}, {3}},
    {"position_based,projective_dynamics",
     0,
     "bends by its iterations",
     {40},
     {3},
     .dear = true},
    {NULL}};
static const struct verify_field field = {.subject = entries};

/* The clamp goes FARTHER than to where the foot shall slip, beginning slowly; the foot has
 * slipped when it is faster than what sticks, CREEP [m/s], after BUCKLED, when that is
 * over. B = 100 rho h: the strip is soon at rest. */
static const double TIME = 2, FARTHER = 1.2, BUCKLED = 0.8, CREEP = 1e-3, THICK = 0.01,
                    CONTACT = 0.002;

/* Values of the last frame; and the clamp's height when the foot slipped [m]; NAN: not yet.
 */
struct seen {
    double foot, speed, clamp, slipped;
};

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct seen *s = context;
    double x[2][3];

    (void)why;
    m->model->probe(m->state, 2, (double[]){1, 0.5, 0.5, 0, 0.5, 0.5}, x[0]);
    const double foot = fabs(x[0][0]), clamp = x[1][2];
    const double speed = (foot - s->foot) / m->scene->step;
    if (isnan(s->slipped) && m->time > BUCKLED && speed > CREEP)
        s->slipped = clamp + (s->clamp - clamp) * (speed - CREEP) / (speed - s->speed);
    s->foot = foot, s->speed = speed, s->clamp = clamp;
    return STATUS_OK;
}

static void add_path(struct verify_trial *t, double way)
{
    enum { ROWS = 40 };

    settings_set(&t->settings, "supports=[{at: {u: 0}, fix: xyz, path: [");
    for (int n = 0; n <= ROWS; n++)
        settings_more(&t->settings, "%s[%g,0,0,%.17g]", n ? "," : "", TIME * n / ROWS,
                      -way * n * n / (ROWS * ROWS));
    settings_more(&t->settings, "]}]");
}

static void add_row(struct verify_subject *s)
{
    const double mu = verify_number(s, "mu"), way = verify_number(s, "eps_at_slip");
    const double young = 12 * 100 / (THICK * THICK), top = 1 + CONTACT / 2 + 1e-9;
    struct seen seen = {.slipped = NAN};
    struct verify_trial t =
        verify_trial_of(s, "free_fall", "clamp's way / L at slip, mu = %g", mu);

    add_path(&t, way * FARTHER);
    verify_trial_set(
        &t,
        "sheet={length: 1, width: 0.1, thickness: %g};"
        "material={young: %.17g, poisson: 0, density: 1};"
        "pose={origin: [0,0,%.17g], u: [0,0,-1], v: [0,1,0]}; gravity=[0.5,0,0];"
        "damping={kind: mass, value: 50};"
        "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1], friction: %g}}];"
        "contact={self: false, thickness: %g, stiffness: 1e4}; time={step: 0.01, end: %g}",
        THICK, young, top, mu, CONTACT, TIME);
    if (verify_trial_watch(&t, look, &seen))
        verify_row_judge(t.row, top - seen.slipped, way, 1e-5);
}

const struct verify_check verify_stickslip = {
    {"stickslip", "a strip whose foot slips from under it as its clamp is lowered"},
    "inextensible elastica by shooting, tests/reference/contact_stickslip.csv; after Sano, "
    "Yamaguchi, Wada 2017",
    "contact_stickslip",
    .parts = {{&field, add_row, .every = 4}}};
