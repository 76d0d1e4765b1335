/* Damping acts on what is free: held points have the velocity of their support under each
 * kind of damping and each kind of support, in every contestant; and beside a
 * support a sheet moves alike by every scheme of a model, linear or not, explicit or not.
 */
#include "tests/opened_run.h"

static const char *const dampings[] = {
    "damping={kind: none}",
    "damping={kind: velocity_scale, value: 0.8}",
    "damping={kind: velocity_rate, value: 100}",
    "damping={kind: mass, value: 200}",
    "damping={kind: rayleigh, alpha: 100, beta: 1.0e-4}",
};

/* Paths are straight, so that schemes that look ahead and those that look back see the same
 * velocity; the sheet starts with its support's, so that no wave of the net's own starts.
 */
#define TURN "turn: {axis: [0.2,1,0.1], about: [0,0,0.1], angles: [[-1,-2],[1,2]]}"
#define PATH "path: [[-1,0.003,-0.005,-0.01],[1,-0.003,0.005,0.01]]"
static const struct support {
    const char *name, *motion, *start; /* start: of the sheet                             */
} supports[] = {
    {"fixed", "", "motion={velocity: [0,0,0]}"},
    {"on a path", ", " PATH, "motion={velocity: [-0.003,0.005,0.01]}"},
    {"turning", ", " TURN,
     "motion={velocity: [-3.40652e-3,6.8131e-4,0], spin: "
     "[6.8131e-3,0.0340652,3.40652e-3]}"},
};

enum { DAMPINGS = sizeof dampings / sizeof *dampings, STEPS = 12 };
#define EACH_SUPPORT                                                                       \
    const struct support *s = supports;                                                    \
    s < supports + sizeof supports / sizeof *supports;                                     \
    s++

/* Opens a run whose support holds u; false if the model refuses the scene. */
static bool open(struct run *run, const char *name, const char *points, const char *u,
                 const struct support *s, const char *damping, const char *own)
{
    struct case_plan plan = {.path = "cantilever"};
    struct message why = {""};
    char held[256];

    snprintf(held, sizeof held, "supports=[{at: {u: %s}, fix: xyz%s}]", u, s->motion);
    REQUIRE(contestant_find(name, &plan.contestant, NULL) == STATUS_OK);
    const char *const text[] = {"sheet={length: 1, width: 0.7, thickness: 0.01}",
                                "material={young: 1.0e5, poisson: 0.3, density: 5}",
                                "gravity=[0,0,-1]",
                                "time={step: 0.001, end: 0.1}",
                                held,
                                damping,
                                s->start,
                                points,
                                own};
    settings_list(&plan.settings, own ? 9 : 8, text);
    enum status st = run_read(run, &plan, &why);
    if (st == STATUS_OK)
        st = run_build(run, &why);
    settings_clear(&plan.settings);
    if (st != STATUS_OK && !CHECK(st == STATUS_UNSUPPORTED))
        printf("%s: %s\n", name, why.text);
    return st == STATUS_OK;
}

/* --- held everywhere -------------------------------------------------------------------
 */

/* Undamped and damped velocities of held points come from one sum, or lie in another. */
static const double ROUND_OFF = 1e-12, SINGLE_ROUND_OFF = 1e-5;

static int check_carried(const struct contestant *c, const struct support *s)
{
    struct energy e, plain = {0};
    struct run run;
    char points[64];
    int ran = 0;

    snprintf(points, sizeof points,
             c->layers ? "discretization.points=[%d,%d,%d]"
                       : "discretization.points=[%d,%d]",
             contestant_least(c), contestant_least(c), c->layers);
    for (int n = 0; n < DAMPINGS; n++) {
        if (!open(&run, c->name, points, "[0,1]", s, dampings[n], NULL))
            continue;
        opened_steps(&run, 3);
        run.model->energy(run.state, &e);
        const bool single = run.discretization.precision == PRECISION_SINGLE;
        plain = n ? plain : e;
        SAY_UNLESS(
            CHECK_RELATIVE(e.kinetic, plain.kinetic, single ? SINGLE_ROUND_OFF : ROUND_OFF),
            "%s held, %s, %s", c->name, s->name, dampings[n]);
        CHECK(!*s->motion == !(plain.kinetic > 0));
        run_close(&run), ran++;
    }
    return ran;
}

/* --- held at an edge -------------------------------------------------------------------
 */

#define NET   "discretization.points=[6,5]"
#define SOLID "discretization.points=[6,5,2]"
#define SET   "discretization."
/* Of the largest displacement. Schemes of second order see the sheet fall within a few
 * squares of a step over all steps; Euler's are a step early or late, two where damping
 * ends the fall in the middle. */
static const double SECOND = 4.0 / (STEPS * STEPS), FIRST = 2.5 / STEPS;

static const struct row {
    const char *name, *points, *own;
    double off; /* tolerance against the last row with 0                                  */
} rows[] = {
    {"shell", NET, SET "kinematics=linear", 0},
    {"shell", NET, SET "kinematics=nonlinear", SECOND},
    {"iga", SOLID, SET "kinematics=linear", 0},
    {"iga", SOLID, SET "kinematics=nonlinear", SECOND},
    {"hex", SOLID, SET "kinematics=linear", 0},
    {"hex", SOLID, SET "kinematics=nonlinear", SECOND},
    {"triangles", NET, SET "integrator=leapfrog", 0},
    {"triangles", NET, NULL, SECOND},
    {"triangles", NET, SET "integrator=implicit", FIRST},
    {"mass_spring_leapfrog", NET, NULL, 0},
    {"mass_spring_momentum", NET, NULL, SECOND},
    {"mass_spring", NET, NULL, FIRST},
    {"mass_spring_explicit", NET, NULL, SECOND},
    {"position_based", NET, NULL, FIRST},
    {"vbd", NET, SET "iterations=200", FIRST},
    {"projective_dynamics", NET, SET "iterations=500", FIRST},
};

static double field[2][GRID_POINTS][3], rest[GRID_POINTS][3];

static void check_family(const struct support *s, const char *damping)
{
    bool known = false;
    struct run run;

    for (const struct row *r = rows; r < rows + sizeof rows / sizeof *rows; r++) {
        const int at = r->off > 0;
        const bool ran = open(&run, r->name, r->points, "0", s, damping, r->own);
        known = at ? known : ran;
        if (!ran)
            continue;
        model_sample(run.model, run.state, rest[0]);
        opened_steps(&run, STEPS);
        model_sample(run.model, run.state, field[at][0]);
        run_close(&run);
        const double moved = opened_apart(field[0][0], rest[0]),
                     off = opened_apart(field[0][0], field[1][0]);
        CHECK(moved > 0);
        if (at && known && !CHECK_NEAR(off / moved, 0, r->off))
            printf("  %s, %s, %s, %s\n", r->name, r->own ? r->own : "", s->name, damping);
    }
}

int main(void)
{
    for (EACH_SUPPORT) {
        for (const struct contestant *c = contestant_table; c->name; c++)
            CHECK(check_carried(c, s) >= 3 || strstr(s->motion, "turn"));
        for (int n = 0; n < DAMPINGS; n++)
            check_family(s, dampings[n]);
    }
    return check_result();
}
