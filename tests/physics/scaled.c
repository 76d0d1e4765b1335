/* Tests that a scene has no unit of its own: with all lengths 1/1024 and all times 1/32
 * of what they were, so that gravity stays, contact moves a sheet by the same shares of its
 * length. No number is rounded otherwise where all units are powers of two, with or without
 * contact: the growth of round-off is 0, and positions are equal to the last bit. A row a
 * model. */
#include "tests/opened_run.h"
#include "tests/run_fixture.h"

enum { FRAMES = 30 };
static const double TINY = 1.0 / 32; /* of times; of lengths its square */

#define KEY   "discretization."
#define SOLID KEY "points=[5,5,2]"
#define NET   KEY "points=[9,9]"
static const struct row {
    const char *model, *settings;
} rows[] = {
    {"triangles", NET}, /* which shows all ways */
    {"iga_selective", SOLID},
    {"hex_incompatible", SOLID},
    {"shell_selective_3", KEY "points=[5,5]"},
    {"shell_explicit_3", KEY "points=[5,5]"},
    {"triangles_explicit", NET},
    {"mass_spring", NET},
    {"mass_spring_explicit", NET},
    {"mass_spring_momentum", NET},
    {"mass_spring_leapfrog", NET},
    {"position_based", NET},
    {"position_based_pbd", NET},
    {"projective_dynamics", NET},
    {"projective_dynamics_admm", NET},
    {"projective_dynamics_bdf2", NET},
    {"vbd", NET},
};

/* Writes the scene: a sheet that an edge draws over a ball, blown by a wind, and that may
 * meet itself; or, of the law's other speeds, one without gravity that is thrown or pushed
 * onto the ball. */
enum driven { BY_GRAVITY, BY_THROW, BY_LOAD, WAYS };
static void describe(struct settings *set, enum driven by, double t)
{
    const double l = t * t, a = l * l * l;
    char text[512];

    snprintf(text, sizeof text,
             "sheet={length: %.17g, width: %.17g, thickness: %.17g};snapshots=[];"
             "pose={origin: [%.17g,%.17g,%.17g]};damping={kind: mass, value: %.17g};"
             "material={young: %.17g, poisson: 0.3, density: 200}",
             0.4 * l, 0.3 * l, 2e-3 * l, 0.1 * l, 0.2 * l, 0.3 * l, 1 / t, 2e5 * l);
    set_words(set, text);
    snprintf(text, sizeof text,
             "obstacles=[{sphere: {center: [%.17g,%.17g,%.17g], radius: %.17g, friction: "
             "0.4}}];contact={friction: 0.3};time={step: %.17g, end: %.17g}",
             0.35 * l, 0.35 * l, 0.196 * l, 0.1 * l, 5e-3 * t, 0.25 * t);
    set_words(set, text);
    if (by == BY_GRAVITY)
        snprintf(text, sizeof text,
                 "gravity=[0,0,-9.81];drag={coefficient: %.17g, wind: [%.17g,%.17g,%.17g]};"
                 "motion={velocity: [0,%.17g,0]};loads=[{at: {u: 1}, force: [0,0,%.17g]}]",
                 30 / t, t, 2 * t, t / 2, 0.1 * t, 0.02 * a);
    else
        snprintf(text, sizeof text,
                 "gravity=[0,0,0];motion={velocity: [0,0,%.17g]};"
                 "loads=[{at: {u: [0, 1]}, force: [0,0,%.17g]}]",
                 by == BY_THROW ? -t : 0, by == BY_LOAD ? -0.4 * a : 0);
    set_words(set, text);
    snprintf(text, sizeof text,
             by == BY_GRAVITY ? "supports=[{at: {u: 0}, fix: xyz, path: [[0,0,0,0],"
                                "[%.17g,0,0,%.17g],[%.17g,%.17g,0,%.17g]]}]"
                              : "supports=[{at: {u: 0}, fix: xyz}]",
             0.1 * t, 0.02 * l, 0.2 * t, 0.03 * l, 0.02 * l);
    set_words(set, text);
}

/* Moves the sheet to x; returns in how many frames it touched the ball. */
static int move(const struct row *row, enum driven by, double unit, double *x)
{
    struct case_plan plan = {SCENES "sphere.yaml", named(row->model), {0}, 0};
    struct message why = {""};
    struct run run;
    int touched = 0;

    describe(&plan.settings, by, unit);
    set_words(&plan.settings, row->settings);
    REQUIRE_SAY(run_open(&run, &plan, &why) == STATUS_OK, "%s: %s", row->model, why.text);
    for (int n = 0; n < FRAMES; n++) {
        struct model_contact c;
        opened_steps(&run, 1);
        run.model->contact(run.state, &c);
        touched += c.nodes > 0;
    }
    model_sample(run.model, run.state, x);
    run_close(&run);
    settings_clear(&plan.settings);
    return touched;
}

int main(void)
{
    static double x[2][3 * GRID_POINTS];

    for (const struct row *row = rows; row < rows + sizeof rows / sizeof *rows; row++)
        for (int by = 0; by < (row == rows ? WAYS : 1); by++) {
            double worst = 0;
            CHECK(move(row, (enum driven)by, 1, x[0]) > FRAMES / 10);
            CHECK(move(row, (enum driven)by, TINY, x[1]) > FRAMES / 10);
            for (int n = 0; n < 3 * GRID_POINTS; n++)
                worst = fmax(worst, fabs(x[1][n] / (TINY * TINY) - x[0][n]));
            SAY_UNLESS(CHECK_NEAR(worst, 0, 0), "%s, scene %d", row->model, by);
        }
    return check_result();
}
