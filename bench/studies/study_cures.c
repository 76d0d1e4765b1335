#include "bench/studies/study_cures.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/experiment/judge.h"
#include "bench/studies/studies.h"
#include "bench/studies/study_cantilever.h"
#include "bench/truth/truth_plate.h"
#include "fem_ref/elastica.h"
#include "fem_ref/reference.h"

const struct study_cures_space study_cures_space[STUDY_CURES_SPACES] = {
    {"IGA (2,2,1), none, the paper's", "none_2", "iga_linear"},
    {"IGA (2,2,1), reduced", "reduced_2", "iga_reduced_linear"},
    {"IGA (2,2,1), selective", "selective_2", "iga_selective_linear"},
    {"IGA (3,3,1), none", "none_3", "iga_linear_3"},
    {"IGA (3,3,1), reduced", "reduced_3", "iga_reduced_linear_3"},
    {"IGA (3,3,1), selective", "selective_3", "iga_selective_linear_3"},
};
const double study_cures_thickness[STUDY_CURES_THICKNESSES] = {1e-1, 1e-2, 1e-3, 1e-4,
                                                               1e-5};
const double study_cures_nu[STUDY_CURES_NUS] = {0, 0.3, 0.49};
const double study_cures_gamma[STUDY_CURES_LAWS] = {0, 10, 100};
const double study_cures_target = 0.02;

enum { PATH = 4096 };

/* --- Tips. */

/* Small enough that nothing turns; linear answers scale. */
static const double LOAD = 0.01;
static const struct study_cures_tip none = {NAN, NAN};

/* Nonlinear, the load is Gamma. */
static void add_physics(struct settings *s, double nu, double h, double gamma)
{
    study_cantilever_sheet(s, nu, h, gamma > 0 ? gamma : LOAD);
    settings_word(s, "discretization.kinematics", gamma > 0 ? "nonlinear" : "linear");
}

static enum status read(const char *contestant, const struct settings *s, struct run *run,
                        struct message *why)
{
    struct run_plan plan = {.path = "cantilever", .settings = s};
    const enum status st = contestant_find(contestant, &plan.contestant, why);

    return st == STATUS_OK ? run_read(run, &plan, why) : st;
}

/* The tip of a contestant with a net and more; a death or refusal leaves NaN. Takes the
 * settings. */
static enum status solve(const char *name, double nu, double h, double gamma,
                         struct settings *s, struct study_cures_tip *tip,
                         struct message *why)
{
    struct counters work = {0};
    struct run run = {0};
    double x[3];
    enum status st;

    *tip = none;
    add_physics(s, nu, h, gamma);
    TRY(read(name, s, &run, why));
    st = run_build(&run, why);
    if (st == STATUS_OK)
        st = run_settle(&run, &work, why);
    if (st == STATUS_OK) {
        run.model->probe(run.state, 1, (double[3]){1, 0.5, 0.5}, x);
        *tip = (struct study_cures_tip){x[0], -x[2] / (gamma > 0 ? 1 : LOAD)};
    }
    st = run_file_is_refusal(st) ? STATUS_OK : st;
out:
    run_close(&run);
    settings_clear(s);
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

    *tip = none;
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
        tip->x = 1; /* nothing turns */
        TRY(truth_plate_coefficient(nu, 24, &tip->z));
    }
out:
    return st;
}

enum status study_cures_zero_modes(const struct study_cures_space *space, int *count,
                                   struct message *why)
{
    enum { MODES = 12 };
    struct settings s = {0};
    struct run run = {0};
    double omega[MODES];
    enum status st;

    settings_set(&s, "sheet.thickness=0.02");
    settings_set(&s, "supports=[]");
    settings_set(&s, "discretization.points=[10,10,2]");
    TRY(read(space->contestant, &s, &run, why));
    TRY(run_build(&run, why));
    TRY(run_modes(&run, MODES, omega, why));
    *count = 0;
    /* round-off: 1e-15 of the largest lambda, some 1e8 times the twelfth's; its root */
    while (*count < MODES && omega[*count] < 1e-2 * omega[MODES - 1])
        ++*count;
out:
    run_close(&run);
    settings_clear(&s);
    return st;
}

/* --- Files. */

/* FOLDER/tips.csv, a line for each tip. Quick: every other thickness. */
static enum status measure_tips(const struct experiment_options *options,
                                study_cures_solver *solver, struct message *why)
{
    enum { ALL = STUDY_CURES_LAWS * STUDY_CURES_NUS * STUDY_CURES_THICKNESSES };
    static const struct table_column columns[] = {{"what"},      {"law"}, {"nu"},
                                                  {"thickness"}, {"x"},   {"z"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, NULL);
    struct study_cures_tip tip[STUDY_CURES_WHATS];
    const bool quick = options->quick;
    enum status st = STATUS_OK;

    for (int n = 0; n < ALL; n++) {
        const int law = n / (STUDY_CURES_NUS * STUDY_CURES_THICKNESSES);
        const int nu = n / STUDY_CURES_THICKNESSES % STUDY_CURES_NUS;
        const int h = n % STUDY_CURES_THICKNESSES;
        experiment_progress(options, "tips", n, ALL);
        for (int what = 0; what < STUDY_CURES_WHATS && !(quick && h % 2); what++) {
            /* thin sheets have one truth: the last thickness has left it in tip[] */
            if (what < STUDY_CURES_SPACES || h <= (quick ? 2 : 1))
                TRY(solver(what, law, nu, h, quick, &tip[what], why));
            if (isnan(tip[what].z))
                continue;
            const double row[] = {what, law, nu, h, tip[what].x, tip[what].z};
            table_row(t);
            for (size_t i = 0; i < sizeof row / sizeof *row; i++)
                if (isnan(row[i])) /* Kirchhoff's tip has no x: read again, no word */
                    table_dash(t);
                else
                    table_number(t, row[i], 6);
        }
    }
    experiment_progress(options, "tips", ALL, ALL);
    TRY(table_save(t, options->folder, "tips", why));
out:
    table_destroy(t);
    return st;
}

/* FOLDER/zero_modes.csv */
static enum status measure_zero_modes(const char *folder, struct message *why)
{
    static const struct table_column columns[] = {{"space"}, {"zero modes"}};
    struct table *t = table_create(2, columns, NULL);
    enum status st = STATUS_OK;

    for (int n = 0, count; n < STUDY_CURES_SPACES; n++) {
        TRY(study_cures_zero_modes(&study_cures_space[n], &count, why));
        table_row(t);
        table_integer(t, n);
        table_integer(t, count);
    }
    TRY(table_save(t, folder, "zero_modes", why));
out:
    table_destroy(t);
    return st;
}

static void frame_path(const char *folder, int space, char path[PATH])
{
    snprintf(path, PATH, "%s/frame_%s.h5", folder, study_cures_space[space].name);
}

/* Rebuilt frames, which the paper's are. `incremental`, for the cured sheet dies under the
 * printed scheme; both do the same work. */
static enum status measure_frames(const struct experiment_options *options,
                                  struct message *why)
{
    static const double time = 0.1, end = 0.25; /* [s] */
    const struct measurement_options how = experiment_measurement(options, "frames");
    struct measurement_case cases[STUDY_CURES_SPACES] = {{{0}}};
    char file[STUDY_CURES_SPACES][PATH];
    struct settings incremental = {0};
    enum status st = STATUS_OK;

    settings_set(&incremental, "discretization.kinematics=incremental");
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        struct measurement_case *c = &cases[n];
        frame_path(options->folder, n, file[n]);
        c->plan = (struct run_plan){"edge_drop", NULL, &incremental, end};
        c->keep = (struct run_keep){.file = file[n], .times = 1, .time = &time};
        c->timed = MEASUREMENT_SOME;
        c->phases = true;
        TRY(contestant_find(study_cures_space[n].contestant, &c->plan.contestant, why));
    }
    TRY(measurement_run(&how, STUDY_CURES_SPACES, cases, why));
out:
    settings_clear(&incremental);
    return st;
}

enum status study_cures_measure(const struct experiment_options *options,
                                study_cures_solver *solver, struct message *why)
{
    enum status st;

    TRY(measure_tips(options, solver, why));
    TRY(measure_zero_modes(options->folder, why));
    TRY(measure_frames(options, why));
out:
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    return study_cures_measure(options, study_cures_solve, why);
}

/* A whole number below `count` from a cell; -1: it is none. */
static int index_of(const struct reference *table, int row, const char *column, int count)
{
    const double value = reference_number(table, row, column);

    return value >= 0 && value < count && value == floor(value) ? (int)value : -1;
}

static enum status read_tips(const char *path, struct study_cures *s, struct message *why)
{
    struct reference *table = NULL;
    enum status st;

    TRY(reference_open(path, &table, why));
    for (int row = 0; row < reference_rows(table); row++) {
        const int what = index_of(table, row, "what", STUDY_CURES_WHATS);
        const int law = index_of(table, row, "law", STUDY_CURES_LAWS);
        const int nu = index_of(table, row, "nu", STUDY_CURES_NUS);
        const int h = index_of(table, row, "thickness", STUDY_CURES_THICKNESSES);
        if (what < 0 || law < 0 || nu < 0 || h < 0)
            TRY(status_fail(why, STATUS_INPUT, "%s: row %d is of no case", path, row + 1));
        s->tip[what][law][nu][h] = (struct study_cures_tip){
            reference_number(table, row, "x"), reference_number(table, row, "z")};
    }
    TRY(reference_fault(table, why));
out:
    reference_close(table);
    return st;
}

static enum status read_zero_modes(const char *path, struct study_cures *s,
                                   struct message *why)
{
    struct reference *table = NULL;
    enum status st;

    TRY(reference_open(path, &table, why));
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        const int row = n < reference_rows(table) ? n : -1;
        s->zero_modes[n] = row < 0 ? -1 : index_of(table, row, "zero_modes", INT_MAX);
        if (s->zero_modes[n] < 0)
            TRY(status_fail(why, STATUS_INPUT, "%s: zero modes of '%s' are wanted", path,
                            study_cures_space[n].label));
    }
    TRY(reference_fault(table, why));
out:
    reference_close(table);
    return st;
}

enum status study_cures_read(const char *folder, struct study_cures **s,
                             struct message *why)
{
    enum { TIPS = sizeof(*s)->tip / sizeof(struct study_cures_tip) };
    struct study_cures *new = calloc(1, sizeof *new);
    char path[PATH];
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < TIPS; n++)
        (&new->tip[0][0][0][0])[n] = (struct study_cures_tip){NAN, NAN};
    snprintf(path, sizeof path, "%s/tips.csv", folder);
    TRY(read_tips(path, new, why));
    snprintf(path, sizeof path, "%s/zero_modes.csv", folder);
    TRY(read_zero_modes(path, new, why));
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        frame_path(folder, n, path);
        TRY(run_result_read(path, false, &new->frame[n], why));
    }
    frame_path(folder, 0, new->machine);
    new->quick = judge_marked(folder);
    *s = new, new = NULL;
out:
    study_cures_destroy(new);
    return st;
}

void study_cures_destroy(struct study_cures *s)
{
    for (int n = 0; s && n < STUDY_CURES_SPACES; n++)
        run_result_clear(&s->frame[n]);
    free(s);
}

double study_cures_ratio(const struct study_cures *s, int space, int law, int nu, int n)
{
    return s->tip[space][law][nu][n].z / s->tip[STUDY_CURES_TRUTH][law][nu][n].z;
}

double study_cures_error(const struct study_cures *s, int space, int law, int nu, int n)
{
    return fabs(study_cures_ratio(s, space, law, nu, n) - 1);
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_cures *s = NULL;
    enum status st;

    TRY(study_cures_read(folder, &s, why));
    TRY(study_cures_tell(s, folder, format, file, why));
out:
    study_cures_destroy(s);
    return st;
}

const struct experiment study_cures_experiment = {
    .item = {"cures",
             "the cures for locking beside each other: accuracy at every thickness "
             "and Poisson's ratio, zero modes, cost"},
    .measure = measure,
    .print = print,
};
