#include "bench/studies/study_locking.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/studies/studies.h"
#include "bench/studies/study_cantilever.h"
#include "bench/truth/truth_plate.h"
#include "fem_ref/reference.h"

#define ONE   "IGA, r = 1"
#define TWO   "IGA, r = 2"
#define HEX   "hexahedra"
#define CURED "shell, reduced IGA"

/* clang-format off */
const struct study_locking_space study_locking_space[STUDY_LOCKING_SPACES] = {
    {"IGA (2,2,1) 10x10x2, the paper's", "iga_221_10", ONE, "iga_linear", NULL, 10,
     {"0.605", "0.749", "0.834"}},
    {"IGA (2,2,1) 20x20x2", "iga_221_20", ONE, "iga_linear", NULL, 20,
     {"0.753", "0.838", "0.847"}},
    {"IGA (3,3,1) 10x10x2", "iga_331_10", ONE, "iga_linear_3", NULL, 10,
     {"0.832", "0.842", "0.846"}},
    {"IGA (4,4,1) 10x10x2", "iga_441_10", ONE, "iga_linear_3",
     "discretization.degree=[4,4,1]", 10, {NULL}},
    {"IGA (2,2,2) 10x10x3", "iga_222_10", TWO, "iga_linear_32",
     "discretization.degree=[2,2,2]", 10, {NULL}},
    {"IGA (3,3,2) 10x10x3", "iga_332_10", TWO, "iga_linear_32", NULL, 10,
     {"0.981", "0.986", "0.989"}},
    {"IGA (4,4,2) 10x10x3", "iga_442_10", TWO, "iga_linear_32",
     "discretization.degree=[4,4,2]", 10, {NULL}},
    {"hex 10x10x2", "hex_10", HEX, "hex_linear", NULL, 10, {"0.0002", "0.0056", "0.081"}},
    {"hex 32x32x2, the paper's", "hex_32", HEX, "hex_linear", NULL, 32,
     {"0.00265", "0.061", "0.465"}},
    {"hex 10x10x2 incompatible", "hex_10_incompatible", HEX, "hex_incompatible_linear",
     NULL, 10, {NULL}},
    {"hex 32x32x2 incompatible", "hex_32_incompatible", HEX, "hex_incompatible_linear",
     NULL, 32, {"0.989", "0.999", "1.001"}},
    {"shell p=2 10x10", "shell_2_10", CURED, "shell_linear", NULL, 10, {NULL}},
    {"shell p=3 10x10", "shell_3_10", CURED, "shell_linear_3", NULL, 10, {NULL}},
    {"shell p=3 20x20", "shell_3_20", CURED, "shell_linear_3", NULL, 20, {NULL}},
    {"IGA (2,2,1) 10x10x2 reduced", "iga_221_10_reduced", CURED, "iga_reduced_linear",
     NULL, 10, {NULL}},
    {"IGA (3,3,1) 10x10x2 reduced", "iga_331_10_reduced", CURED, "iga_reduced_linear_3",
     NULL, 10, {NULL}},
};
/* clang-format on */

const double study_locking_thickness[STUDY_LOCKING_PROTOTYPES] = {1e-3, 5e-3, 20e-3};
const double study_locking_nu[STUDY_LOCKING_NUS] = {0, 0.3};

bool study_locking_prototype(const struct study_locking_space *space, int n, double *value,
                             double *half_unit)
{
    const char *text = space->prototype[n];

    if (!text)
        return false;
    *value = strtod(text, NULL);
    *half_unit = 0.5 * pow(10, -(double)strlen(strchr(text, '.') + 1));
    return true;
}

static const double usual[] = {1e-4, 1e-3, 5e-3, 20e-3, 100e-3}; /* h [m]             */
enum { USUAL = sizeof usual / sizeof *usual, PATH = 4096 };

/* The weight is such that Kirchhoff's tip falls this far [m]; linear answers scale. */
static const double TIP = 0.1;

/* Few functions: six digits do for ratios that are told with three. */
enum { TERMS = 24 };

static void file_of(const char *folder, int space, double nu, double h, char path[PATH])
{
    snprintf(path, PATH, "%s/%s_nu%g_h%gmm.h5", folder, study_locking_space[space].name, nu,
             1e3 * h);
}

struct job {
    struct settings settings;
    char file[PATH];
};

/* The scene, and the net on it. */
static enum status fill(const struct study_locking_space *s,
                        const struct contestant *contestant, double nu, double h,
                        struct settings *settings)
{
    double coefficient;
    const enum status st = truth_plate_coefficient(nu, TERMS, &coefficient);

    if (st != STATUS_OK)
        return st;
    study_cantilever_sheet(settings, nu, h, TIP / coefficient);
    if (s->degree)
        settings_set(settings, s->degree);
    contestant_points(contestant, s->points, s->points, settings);
    return STATUS_OK;
}

/* All spaces at one thickness. nu costs nothing, and is timed at one value only. */
static enum status measure_thickness(const struct experiment_options *options, double h,
                                     struct message *why)
{
    enum { CASES = STUDY_LOCKING_SPACES * STUDY_LOCKING_NUS };
    struct measurement_case cases[CASES] = {0};
    struct job *jobs = calloc(CASES, sizeof *jobs);
    char what[64];
    enum status st = jobs ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < CASES; n++) {
        const int space = n / STUDY_LOCKING_NUS, nu = n % STUDY_LOCKING_NUS;
        struct measurement_case *c = &cases[n];
        c->plan.path = "cantilever";
        c->plan.settings = &jobs[n].settings;
        c->keep.file = jobs[n].file;
        c->rest = true;
        c->timed = nu == STUDY_LOCKING_BOTH ? MEASUREMENT_SOME : MEASUREMENT_UNTIMED;
        file_of(options->folder, space, study_locking_nu[nu], h, jobs[n].file);
        TRY(contestant_find(study_locking_space[space].contestant, &c->plan.contestant,
                            why));
        TRY(fill(&study_locking_space[space], c->plan.contestant, study_locking_nu[nu], h,
                 &jobs[n].settings));
    }
    snprintf(what, sizeof what, "h = %g mm", 1e3 * h);
    const struct measurement_options how = experiment_measurement(options, what);
    TRY(measurement_run(&how, CASES, cases, why));
out:
    for (int n = 0; jobs && n < CASES; n++)
        settings_clear(&jobs[n].settings);
    free(jobs);
    return st;
}

/* FOLDER/thickness.csv names the thicknesses for whoever prints. */
static enum status write_thicknesses(const char *folder, int count, const double *h,
                                     struct message *why)
{
    struct table *t = table_create(1, &(struct table_column){"thickness", "m"}, NULL);
    enum status st;

    for (int n = 0; n < count; n++) {
        table_row(t);
        table_number(t, h[n], 3);
    }
    st = table_save(t, folder, "thickness", why);
    table_destroy(t);
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    const double *h = options->value_count ? options->value : usual;
    int count = options->value_count ? options->value_count : USUAL;
    enum status st = STATUS_OK;

    if (count > STUDY_LOCKING_MOST)
        return status_fail(why, STATUS_INPUT, "--values: at most %d thicknesses",
                           STUDY_LOCKING_MOST);
    for (int n = 0; n < count; n++)
        TRY(measure_thickness(options, h[n], why));
    TRY(write_thicknesses(options->folder, count, h, why));
out:
    return st;
}

static enum status read_thicknesses(const char *folder, struct study_locking *s,
                                    struct message *why)
{
    struct reference *table = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/thickness.csv", folder);
    TRY(reference_open(path, &table, why));
    while (s->count < STUDY_LOCKING_MOST && s->count < reference_rows(table)) {
        s->thickness[s->count] = reference_number(table, s->count, "thickness_m");
        s->count++;
    }
    TRY(reference_fault(table, why));
    if (!s->count)
        st = status_fail(why, STATUS_INPUT, "%s: no thickness", path);
out:
    reference_close(table);
    return st;
}

static enum status read_cell(const char *path, struct study_locking_cell *c,
                             struct message *why)
{
    struct run_result r = {0};
    enum status st;

    TRY(run_result_read(path, true, &r, why));
    *c = (struct study_locking_cell){NAN, NAN, NAN, NAN, {""}};
    if (r.outcome != STATUS_OK) {
        c->said = r.sentence;
    } else if (r.frames != 1) {
        st = status_fail(why, STATUS_INPUT, "%s: one equilibrium is wanted", path);
    } else {
        c->tip = -truth_plate_edge(r.xyz[0], NULL) / TIP;
        c->unknowns = r.unknowns;
        if (r.step.count)
            c->setup = r.create.median, c->equilibrium = r.step.median;
    }
out:
    run_result_clear(&r);
    return st;
}

/* Thin limit of r = 1 (header): tip of the plate with D' and nu' over that with D and nu.
 */
static enum status read_limit(struct study_locking *s)
{
    double nu = study_locking_nu[STUDY_LOCKING_BOTH], stiff, soft;
    enum status st;

    TRY(truth_plate_coefficient(nu, TERMS, &soft));
    TRY(truth_plate_coefficient(nu / (1 - nu), TERMS, &stiff));
    s->limit = stiff / soft * (1 - 2 * nu) / ((1 - nu) * (1 - nu));
out:
    return st;
}

enum status study_locking_read(const char *folder, struct study_locking **s,
                               struct message *why)
{
    struct study_locking *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(read_thicknesses(folder, new, why));
    for (int n = 0; n < STUDY_LOCKING_SPACES * STUDY_LOCKING_NUS * new->count; n++) {
        const int space = n / new->count / STUDY_LOCKING_NUS;
        const int nu = n / new->count % STUDY_LOCKING_NUS, h = n % new->count;
        file_of(folder, space, study_locking_nu[nu], new->thickness[h], new->machine);
        TRY(read_cell(new->machine, &new->cell[space][nu][h], why));
    }
    file_of(folder, 0, study_locking_nu[STUDY_LOCKING_BOTH], new->thickness[0],
            new->machine);
    TRY(read_limit(new));
    *s = new, new = NULL;
out:
    free(new);
    return st;
}

double study_locking_shear(const struct study_locking *s, int space, int thickness)
{
    return s->cell[space][0][thickness].tip;
}

double study_locking_through(const struct study_locking *s, int space, int thickness)
{
    return s->cell[space][STUDY_LOCKING_BOTH][thickness].tip /
           study_locking_shear(s, space, thickness);
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_locking *s = NULL;
    enum status st;

    TRY(study_locking_read(folder, &s, why));
    TRY(study_locking_tell(s, folder, format, file, why));
out:
    free(s);
    return st;
}

const struct experiment study_locking_experiment = {
    .item = {"locking", "tip of a cantilevered sheet over Kirchhoff's, by space and "
                        "thickness: shear and thickness locking"},
    .values = "thicknesses [m] of a sheet 1 m long",
    .measure = measure,
    .print = print,
};
