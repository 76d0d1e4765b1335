/* What study_cures.h solves: the cantilever's tip by any model, and the truths. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/studies/study_cures.h"
#include "bench/truth/truth_plate.h"
#include "bench/harness/trial.h"
#include "fem_ref/elastica.h"
#include "models/reader/scene_file.h"

enum { SETTINGS = 13, TEXT = 256 };

/* Small enough that nothing turns; linear answers scale. */
static const double LOAD = 0.01;

/* Open knots of `degree` on `spans` whose ends crowd at 0 and, if `both`, at 1: the solid's
 * stress is singular at the clamp and varies over h at free edges. */
static void write_knots(char text[TEXT], char direction, int degree, int spans, bool both)
{
    int at = snprintf(text, TEXT, "discretization.knots_%c=[", direction);

    for (int k = -degree; k <= spans + degree; k++) {
        double t = fmin(1, fmax(0, (double)k / spans));
        double u = both ? t * t * (3 - 2 * t) : pow(t, 2.5);
        at += snprintf(text + at, TEXT - (size_t)at, "%s%.6g", k > -degree ? "," : "", u);
    }
    snprintf(text + at, TEXT - (size_t)at, "]");
}

static int write_settings(const struct study_cures_case *c, char text[SETTINGS][TEXT])
{
    const double h = c->thickness, young = 1e5;
    double D = young * h * h * h / (12 * (1 - c->nu * c->nu));
    bool solid = !strcmp(c->model, "iga");
    int n = 0;

    snprintf(text[n++], TEXT, "sheet.thickness=%.17g", h);
    snprintf(text[n++], TEXT, "material.poisson=%.17g", c->nu);
    snprintf(text[n++], TEXT, "material.density=1");
    snprintf(text[n++], TEXT, "gravity=[0,0,%.17g]",
             -(c->gamma > 0 ? c->gamma : LOAD) * D / h);
    snprintf(text[n++], TEXT, "discretization.kinematics=%s",
             c->gamma > 0 ? "nonlinear" : "linear");
    snprintf(text[n++], TEXT,
             solid ? "discretization.degree=[%d,%d,%d]" : "discretization.degree=[%d,%d]",
             c->degree[0], c->degree[1], c->degree[2]);
    snprintf(text[n++], TEXT,
             solid ? "discretization.points=[%d,%d,%d]" : "discretization.points=[%d,%d]",
             c->points[0], c->points[1], c->points[2]);
    snprintf(text[n++], TEXT, "discretization.remedy=%s", remedy_name(c->remedy));
    if (solid)
        snprintf(text[n++], TEXT, "discretization.unknowns=%s",
                 c->slit ? "points" : "thickness");
    if (c->slit)
        snprintf(text[n++], TEXT,
                 "supports=[{at: {u: 0}, fix: xy}, {at: {u: 0, w: 0}, fix: z}]");
    for (int i = 0; c->graded && i < 2; i++)
        write_knots(text[n++], "uv"[i], c -> degree[i], c -> points[i] - c -> degree[i],
                    i == 1);
    return n;
}

enum status study_cures_solve(const struct study_cures_case *c, struct study_cures_tip *tip,
                              struct message *why)
{
    char text[SETTINGS][TEXT], *path = NULL;
    const char *settings[SETTINGS];
    struct counters counters = {0};
    struct message death;
    struct trial trial = {0};
    double x[3];
    enum status st;
    int count = write_settings(c, text);

    *tip = (struct study_cures_tip){NAN, NAN};
    for (int n = 0; n < count; n++)
        settings[n] = text[n];
    TRY(scene_file_find("cantilever", &path, why));
    TRY(trial_open(&trial, path, count, settings, c->model, why));
    st = trial.model->equilibrium(trial.state, &counters, &death);
    if (st == STATUS_OK) {
        trial.model->probe(trial.state, 1, (double[3]){1, 0.5, 0.5}, x);
        *tip = (struct study_cures_tip){x[0], -x[2] / (c->gamma > 0 ? 1 : LOAD)};
    } else if (status_is_death(st)) {
        st = STATUS_OK;
    }
out:
    trial_close(&trial);
    free(path);
    return st;
}

/* Coarser: a level less. */
static enum status solve_solid(int what, double nu, double gamma, double h, bool quick,
                               struct study_cures_tip *tip, struct message *why)
{
    int less = (what == STUDY_CURES_COARSER ? 2 : 0) + (quick || gamma > 0 ? 3 : 0);
    const struct study_cures_case c = {.model = "iga",
                                       .nu = nu,
                                       .thickness = h,
                                       .gamma = gamma,
                                       .degree = {4, 4, 3},
                                       .points = {14 - less, 12 - less, 4},
                                       .graded = true,
                                       .slit = what == STUDY_CURES_SLIT};

    return study_cures_solve(&c, tip, why);
}

static enum status solve_shell(int what, double nu, double gamma, bool quick,
                               struct study_cures_tip *tip, struct message *why)
{
    int less = (what == STUDY_CURES_COARSER ? 6 : 0) + (quick ? 4 : 0);
    const struct study_cures_case c = {.model = "shell",
                                       .nu = nu,
                                       .thickness = 1e-2,
                                       .gamma = gamma,
                                       .degree = {4, 4},
                                       .points = {24 - less, 16 - less}};

    return study_cures_solve(&c, tip, why);
}

enum status study_cures_truth(int what, int law, int nu, int thickness, bool quick,
                              struct study_cures_tip *tip, struct message *why)
{
    double gamma = study_cures_gamma[law], h = study_cures_thickness[thickness];
    double poisson = study_cures_nu[nu];
    struct elastica elastica;
    enum status st = STATUS_OK;

    *tip = (struct study_cures_tip){NAN, NAN};
    if (h > 0.05 && gamma > 10) /* bent as sharply as it is thick: nobody's elastic sheet */
        return STATUS_OK;
    if (h > 0.05)
        return what == STUDY_CURES_SLIT && gamma > 0
                   ? STATUS_OK
                   : solve_solid(what, poisson, gamma, h, quick, tip, why);
    if (what == STUDY_CURES_SLIT)
        return STATUS_OK;
    if (gamma > 0 && poisson > 0)
        return solve_shell(what, poisson, gamma, quick, tip, why);
    if (gamma > 0) {
        TRY(elastica_solve(gamma, &elastica));
        *tip = (struct study_cures_tip){elastica.reach, elastica.drop};
    } else {
        TRY(truth_plate_coefficient(poisson, 24, &tip->z));
    }
out:
    return st;
}

enum status study_cures_zero_modes(const struct study_cures_space *space, int *count,
                                   struct message *why)
{
    enum { MODES = 12 };
    char text[3][TEXT], *path = NULL;
    const char *settings[] = {"sheet.thickness=0.02",
                              "supports=[]",
                              "discretization.kinematics=linear",
                              text[0],
                              text[1],
                              text[2]};
    struct trial trial = {0};
    double omega[MODES];
    enum status st;

    snprintf(text[0], TEXT, "discretization.degree=[%d,%d,1]", space->degree,
             space->degree);
    snprintf(text[1], TEXT, "discretization.points=[10,10,2]");
    snprintf(text[2], TEXT, "discretization.remedy=%s", remedy_name(space->remedy));
    TRY(scene_file_find("cantilever", &path, why));
    TRY(trial_open(&trial, path, sizeof settings / sizeof *settings, settings, "iga", why));
    TRY(trial.model->modes(trial.state, MODES, omega, why));
    *count = 0;
    /* round-off: 1e-15 of the largest lambda, some 1e8 times the twelfth's; its root */
    while (*count < MODES && omega[*count] < 1e-2 * omega[MODES - 1])
        ++*count;
out:
    trial_close(&trial);
    free(path);
    return st;
}
