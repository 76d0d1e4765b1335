/* What study_cures.h solves: the cantilever's tip by any contestant, and the truths. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/harness/run.h"
#include "bench/studies/study_cures.h"
#include "bench/truth/truth_plate.h"
#include "fem_ref/elastica.h"
#include "models/reader/scene_file.h"

/* Small enough that nothing turns; linear answers scale. */
static const double LOAD = 0.01;

/* Square, 1 m: the sheet, and a load such that Gamma or, linear, the tip is known. */
static void add_physics(struct settings *s, double nu, double h, double gamma)
{
    const double D = 1e5 * h * h * h / (12 * (1 - nu * nu));

    settings_number(s, "sheet.thickness", h);
    settings_number(s, "material.poisson", nu);
    settings_set(s, "material.young=1e5");
    settings_set(s, "material.density=1");
    settings_numbers(s, "gravity", 3,
                     (double[]){0, 0, -(gamma > 0 ? gamma : LOAD) * D / h});
    settings_word(s, "discretization.kinematics", gamma > 0 ? "nonlinear" : "linear");
}

/* The tip of a contestant with a net and more; a death leaves NaN. Takes the settings. */
static enum status solve(const char *name, double nu, double h, double gamma,
                         struct settings *s, struct study_cures_tip *tip,
                         struct message *why)
{
    struct run_plan plan = {.settings = s};
    struct counters work = {0};
    struct run run = {0};
    char *path = NULL;
    double x[3];
    enum status st;

    *tip = (struct study_cures_tip){NAN, NAN};
    add_physics(s, nu, h, gamma);
    TRY(scene_file_find("cantilever", &path, why));
    TRY(contestant_find(name, &plan.contestant, why));
    plan.path = path;
    TRY(run_open(&run, &plan, why));
    st = run_settle(&run, &work, why);
    if (st == STATUS_OK) {
        run.model->probe(run.state, 1, (double[3]){1, 0.5, 0.5}, x);
        *tip = (struct study_cures_tip){x[0], -x[2] / (gamma > 0 ? 1 : LOAD)};
    }
    st = status_is_death(st) ? STATUS_OK : st;
out:
    run_close(&run);
    settings_clear(s);
    free(path);
    return st;
}

/* Open knots of `degree` on `spans` whose ends crowd at 0 and, if `both`, at 1: the solid's
 * stress is singular at the clamp and varies over h at free edges. To six digits. */
static void add_knots(struct settings *s, const char *key, int degree, int spans, bool both)
{
    enum { MOST = 32 };
    double knot[MOST];
    char text[32];
    int count = 0;

    for (int k = -degree; k <= spans + degree && count < MOST; k++) {
        double t = fmin(1, fmax(0, (double)k / spans));
        snprintf(text, sizeof text, "%.6g", both ? t * t * (3 - 2 * t) : pow(t, 2.5));
        knot[count++] = strtod(text, NULL);
    }
    settings_numbers(s, key, count, knot);
}

/* Coarser: a level less. */
static enum status solve_solid(int what, double nu, double h, double gamma, bool quick,
                               struct study_cures_tip *tip, struct message *why)
{
    const int less = (what == STUDY_CURES_COARSER ? 2 : 0) + (quick || gamma > 0 ? 3 : 0);
    const int degree[] = {4, 4, 3}, points[] = {14 - less, 12 - less, 4};
    struct settings s = {0};

    settings_integers(&s, "discretization.degree", 3, degree);
    settings_integers(&s, "discretization.points", 3, points);
    add_knots(&s, "discretization.knots_u", degree[0], points[0] - degree[0], false);
    add_knots(&s, "discretization.knots_v", degree[1], points[1] - degree[1], true);
    if (what == STUDY_CURES_SLIT) {
        settings_set(&s, "discretization.unknowns=points");
        settings_set(&s, "supports=[{at: {u: 0}, fix: xy}, {at: {u: 0, w: 0}, fix: z}]");
    } else {
        settings_set(&s, "discretization.unknowns=thickness");
    }
    return solve("iga_linear", nu, h, gamma, &s, tip, why);
}

static enum status solve_shell(int what, double nu, double gamma, bool quick,
                               struct study_cures_tip *tip, struct message *why)
{
    const int less = (what == STUDY_CURES_COARSER ? 6 : 0) + (quick ? 4 : 0);
    struct settings s = {0};

    settings_set(&s, "discretization.degree=[4,4]");
    settings_integers(&s, "discretization.points", 2, (int[]){24 - less, 16 - less});
    return solve("shell_linear", nu, 1e-2, gamma, &s, tip, why);
}

enum status study_cures_solve(int what, int law, int n, int thickness, bool quick,
                              struct study_cures_tip *tip, struct message *why)
{
    const double gamma = study_cures_gamma[law], h = study_cures_thickness[thickness];
    const double nu = study_cures_nu[n];
    const bool thick = h > 0.05, slit = what == STUDY_CURES_SLIT;
    struct settings s = {0};
    struct elastica elastica;
    enum status st = STATUS_OK;

    *tip = (struct study_cures_tip){NAN, NAN};
    if (what < STUDY_CURES_SPACES) {
        settings_set(&s, "discretization.points=[10,10,2]");
        settings_set(&s, "discretization.unknowns=thickness");
        return solve(study_cures_space[what].contestant, nu, h, gamma, &s, tip, why);
    }
    /* bent as sharply as it is thick: nobody's elastic sheet */
    if ((thick && gamma > 10) || (slit && (!thick || gamma > 0)))
        return STATUS_OK;
    if (thick)
        return solve_solid(what, nu, h, gamma, quick, tip, why);
    if (gamma > 0 && nu > 0)
        return solve_shell(what, nu, gamma, quick, tip, why);
    if (gamma > 0) {
        TRY(elastica_solve(gamma, &elastica));
        *tip = (struct study_cures_tip){elastica.reach, elastica.drop};
    } else {
        TRY(truth_plate_coefficient(nu, 24, &tip->z));
    }
out:
    return st;
}

enum status study_cures_zero_modes(const struct study_cures_space *space, int *count,
                                   struct message *why)
{
    enum { MODES = 12 };
    static const char *const texts[] = {"sheet.thickness=0.02", "supports=[]"};
    struct settings s = {0};
    struct run_plan plan = {.settings = &s};
    struct run run = {0};
    char *path = NULL;
    double omega[MODES];
    enum status st;

    settings_list(&s, sizeof texts / sizeof *texts, texts);
    TRY(scene_file_find("cantilever", &path, why));
    TRY(contestant_find(space->contestant, &plan.contestant, why));
    contestant_points(plan.contestant, 10, 10, &s);
    plan.path = path;
    TRY(run_open(&run, &plan, why));
    TRY(run_modes(&run, MODES, omega, why));
    *count = 0;
    /* round-off: 1e-15 of the largest lambda, some 1e8 times the twelfth's; its root */
    while (*count < MODES && omega[*count] < 1e-2 * omega[MODES - 1])
        ++*count;
out:
    run_close(&run);
    settings_clear(&s);
    free(path);
    return st;
}
