/* A sheet that lies on a plane, level and inclined, with Coulomb friction. */
#include <math.h>

#include "bench/verify/verify_check.h"

/* Forces and accelerations, of the weight and of g: iterations end far below. A sheet that
 * sticks: their ends, 1e-6 to 1e-8 L. Gaps: round-off of the solve. */
#define BALANCE 1e-6, NULL
static const double STUCK = 1e-5, CLOSED = 1e-11;

static const double G = 9.81, SLOPE = 0.4, LENGTH = 0.5;
static const double WEIGHT = 9.81 * 200 * 0.004 * 0.5 * 0.4;

/* A solid swings through its thickness, and breathes, when its weight comes onto it: forces
 * are looked at after that, with a step that resolves it and stiffness damping, which
 * leaves rigid motion alone; at rest mass damping ends what is slower. */
static const struct verify_entry entries[] = {
    {"iga_linear", BALANCE},
    {"iga_paper", 0, "the paper's scheme"},
    {"iga_incremental", 0, "forgets its stress"},
    {"iga_nonlinear", BALANCE},
    {"hex_linear", BALANCE},
    {"hex_nonlinear", BALANCE},
    {"shell_linear", BALANCE},
    {"shell_2", BALANCE},
    {"triangles", BALANCE},
    {"mass_spring", BALANCE, .settings = {"discretization.tolerance=1e-9"}},
    {"mass_spring_momentum", BALANCE},
    {"position_based", BALANCE},
    {"projective_dynamics", BALANCE},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {8}, {7}};

static double step_of(const struct verify_subject *s)
{
    return s->layers ? 2e-4 : 0.005;
}

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
static bool watch_sheet(struct verify_trial *t, double slope, double friction, double mass,
                        struct seen *seen)
{
    const bool solid = t->subject->layers;
    const double dt = step_of(t->subject);
    struct settings *s = &t->settings;

    *seen = (struct seen){.settled = solid ? 450 * dt : 0};
    settings_set(s, "sheet={length: 0.5, width: 0.4, thickness: 0.004}");
    settings_set(s, "pose={origin: [0,0,0.002], u: [1,0,0], v: [0,1,0]}");
    settings_set(s, "material={young: 1e5, poisson: 0.3, density: 200}");
    settings_numbers(s, "gravity", 3, (double[]){G * sin(slope), 0, -G * cos(slope)});
    settings_print(s,
                   "obstacles=[{plane: {point: [3,-1,0], normal: [0,0,2], friction: %g}}]",
                   friction);
    settings_number(s, "time.step", dt);
    if (solid)
        settings_print(s, "damping={kind: rayleigh, alpha: %g, beta: 4e-3}", mass);
    else
        settings_set(s, "damping={kind: none}");
    t->end = seen->settled + LOOKS * dt;
    return verify_trial_watch(t, look, seen);
}

static void add_rest(struct verify_subject *s)
{
    struct seen seen;
    struct verify_trial t = verify_trial_of(s, "ground", "force on the ground [N]");

    if (!watch_sheet(&t, 0, 0.5, 300, &seen))
        return;
    verify_row_judge(t.row, seen.force, WEIGHT, 0);
    verify_subject_claim(s, CLOSED, NULL);
    verify_row_judge_error(verify_sheet_add(s, "least gap of the net / L"),
                           fabs(seen.gap) / LENGTH, 0);
}

static void add_slide(const struct verify_subject *s, double friction)
{
    struct seen seen;
    const double dt = step_of(s), pull = G * (sin(SLOPE) - friction * cos(SLOPE));
    struct verify_trial t = verify_trial_of(
        s, "ground", pull > 0 ? "slides, mu = %g [m/s^2], error / g" : "slips / L, mu = %g",
        friction);

    if (pull <= 0 && !isnan(t.row->tolerance))
        t.row->tolerance = STUCK;
    if (!watch_sheet(&t, SLOPE, friction, 0, &seen))
        return;
    if (pull > 0) {
        t.row->value = (seen.along[2] - 2 * seen.along[1] + seen.along[0]) / (dt * dt);
        t.row->truth = pull;
        verify_row_judge_error(t.row, fabs(t.row->value - pull) / G, 0);
    } else
        verify_row_judge_error(t.row, fabs(seen.along[2] - seen.from) / LENGTH, 0);
}

/* The next; where nothing is claimed, the hasty do not look. */
static bool next(struct verify_sheet *sheet, int *n, struct verify_subject *s)
{
    while (verify_sheet_next(sheet, &field, n, s))
        if (!sheet->quick || !isnan(s->tolerance))
            return true;
    return false;
}

static void run(struct verify_sheet *sheet)
{
    static const double frictions[] = {0, 0.2, 0.6};
    struct verify_subject s;

    for (int k = 0; next(sheet, &k, &s);)
        add_rest(&s);
    for (int n = 0; n < 3; n++)
        for (int k = 0; next(sheet, &k, &s);)
            add_slide(&s, frictions[n]);
}

const struct verify_check verify_contact = {
    .item = {"contact", "a sheet that lies, sticks and slides on a plane"},
    .slow = true,
    .source = "its weight; Coulomb: g (sin - mu cos) on an incline of 0.4",
    .run = run,
};
