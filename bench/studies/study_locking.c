#include "bench/studies/study_locking.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/harness/registry.h"
#include "bench/truth/truth_plate.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"

/* clang-format off */
const struct study_locking_space study_locking_space[STUDY_LOCKING_SPACES] = {
    {"IGA (2,2,1) 10x10x2, the paper's", "iga_221_10", "iga", {2, 2, 1}, {10, 10, 2},
     REMEDY_NONE, {"0.605", "0.749", "0.834"}},
    {"IGA (2,2,1) 20x20x2", "iga_221_20", "iga", {2, 2, 1}, {20, 20, 2},
     REMEDY_NONE, {"0.753", "0.838", "0.847"}},
    {"IGA (3,3,1) 10x10x2", "iga_331_10", "iga", {3, 3, 1}, {10, 10, 2},
     REMEDY_NONE, {"0.832", "0.842", "0.846"}},
    {"IGA (4,4,1) 10x10x2", "iga_441_10", "iga", {4, 4, 1}, {10, 10, 2}, REMEDY_NONE},
    {"IGA (2,2,2) 10x10x3", "iga_222_10", "iga", {2, 2, 2}, {10, 10, 3}, REMEDY_NONE},
    {"IGA (3,3,2) 10x10x3", "iga_332_10", "iga", {3, 3, 2}, {10, 10, 3},
     REMEDY_NONE, {"0.981", "0.986", "0.989"}},
    {"IGA (4,4,2) 10x10x3", "iga_442_10", "iga", {4, 4, 2}, {10, 10, 3}, REMEDY_NONE},
    {"hex 10x10x2", "hex_10", "hex", {0}, {10, 10, 2},
     REMEDY_NONE, {"0.0002", "0.0056", "0.081"}},
    {"hex 32x32x2, the paper's", "hex_32", "hex", {0}, {32, 32, 2},
     REMEDY_NONE, {"0.00265", "0.061", "0.465"}},
    {"hex 10x10x2 incompatible", "hex_10_incompatible", "hex", {0}, {10, 10, 2},
     REMEDY_INCOMPATIBLE},
    {"hex 32x32x2 incompatible", "hex_32_incompatible", "hex", {0}, {32, 32, 2},
     REMEDY_INCOMPATIBLE, {"0.989", "0.999", "1.001"}},
    {"shell p=2 10x10", "shell_2_10", "shell", {2, 2, 0}, {10, 10, 0}, REMEDY_NONE},
    {"shell p=3 10x10", "shell_3_10", "shell", {3, 3, 0}, {10, 10, 0}, REMEDY_NONE},
    {"shell p=3 20x20", "shell_3_20", "shell", {3, 3, 0}, {20, 20, 0}, REMEDY_NONE},
    {"IGA (2,2,1) 10x10x2 reduced", "iga_221_10_reduced", "iga", {2, 2, 1}, {10, 10, 2},
     REMEDY_REDUCED},
    {"IGA (3,3,1) 10x10x2 reduced", "iga_331_10_reduced", "iga", {3, 3, 1}, {10, 10, 2},
     REMEDY_REDUCED},
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
enum { USUAL = sizeof usual / sizeof *usual };

/* The weight is such that Kirchhoff's tip falls this far [m]; linear answers scale. */
static const double TIP = 0.1;

/* Few functions: six digits do for ratios that are told with three. */
enum status study_locking_coefficient(double nu, double *coefficient)
{
    return truth_plate_coefficient(nu, 24, coefficient);
}

static void file_of(const char *folder, int space, double nu, double h,
                    char path[TIMED_PATH])
{
    snprintf(path, TIMED_PATH, "%s/%s_nu%g_h%gmm.h5", folder,
             study_locking_space[space].name, nu, 1e3 * h);
}

static enum status read_scene(double nu, double h, struct scene *scene, struct message *why)
{
    enum { SETTINGS = 4, TEXT = 64 };
    const double young = 1e5, density = 1;
    struct discretization unused = {0};
    char text[SETTINGS][TEXT], *path = NULL;
    const char *settings[SETTINGS + 1] = {text[0], text[1], text[2], text[3],
                                          "material.young=1e5"};
    double coefficient, stiffness = young * h * h * h / (12 * (1 - nu * nu));
    enum status st;

    TRY(study_locking_coefficient(nu, &coefficient));
    snprintf(text[0], TEXT, "sheet.thickness=%.17g", h);
    snprintf(text[1], TEXT, "material.poisson=%.17g", nu);
    snprintf(text[2], TEXT, "material.density=%.17g", density);
    snprintf(text[3], TEXT, "gravity=[0, 0, %.17g]",
             -TIP * stiffness / (coefficient * density * h));
    TRY(scene_file_find("cantilever", &path, why));
    TRY(scene_file_read(path, SETTINGS + 1, settings, scene, &unused, why));
    discretization_clear(&unused);
out:
    free(path);
    return st;
}

static enum status set_up(const struct exhibit_options *options, int space, int nu,
                          const struct scene *scene, struct timed_case *c,
                          struct message *why)
{
    const struct study_locking_space *s = &study_locking_space[space];
    enum status st = registry_find(s->model, &c->model, why);

    if (st != STATUS_OK)
        return st;
    c->model->defaults(&c->d);
    c->d.kinematics = KINEMATICS_LINEAR;
    c->d.remedy = s->remedy;
    for (int i = 0; i < 3; i++) {
        if (s->degree[i])
            c->d.degree[i] = s->degree[i];
        if (s->points[i])
            c->d.points[i] = s->points[i];
    }
    c->scene = scene;
    c->rest = nu == STUDY_LOCKING_NUS - 1; /* nu costs nothing */
    file_of(options->folder, space, study_locking_nu[nu], scene->thickness, c->path);
    return STATUS_OK;
}

/* All spaces at one thickness. */
static enum status measure_thickness(const struct exhibit_options *options, double h,
                                     const struct provenance *provenance,
                                     struct message *why)
{
    enum { CASES = STUDY_LOCKING_SPACES * STUDY_LOCKING_NUS };
    struct timed_case *cases = calloc(CASES, sizeof *cases);
    struct scene scene[STUDY_LOCKING_NUS] = {{0}};
    char what[64];
    enum status st = cases ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    snprintf(what, sizeof what, "h = %g mm", 1e3 * h);
    for (int nu = 0; nu < STUDY_LOCKING_NUS; nu++)
        TRY(read_scene(study_locking_nu[nu], h, &scene[nu], why));
    for (int n = 0; n < CASES; n++) {
        int nu = n % STUDY_LOCKING_NUS;
        TRY(set_up(options, n / STUDY_LOCKING_NUS, nu, &scene[nu], &cases[n], why));
    }
    TRY(timed_measure(options, what, provenance, CASES, cases, why));
out:
    for (int nu = 0; nu < STUDY_LOCKING_NUS; nu++)
        scene_clear(&scene[nu]);
    free(cases);
    return st;
}

/* FOLDER/thickness.txt names the thicknesses, a line each, for whoever prints. */
static enum status write_thicknesses(const char *folder, int count, const double *h,
                                     struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/thickness.txt", folder);
    TRY(output_create(path, &out, why));
    for (int n = 0; n < count; n++)
        output_print(out, "%.17g\n", h[n]);
    return output_close(out, why);
out:
    return st;
}

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    const double *h = options->value_count ? options->value : usual;
    int count = options->value_count ? options->value_count : USUAL;
    struct provenance provenance;
    enum status st = STATUS_OK;

    if (count > STUDY_LOCKING_MOST)
        return status_fail(why, STATUS_INPUT, "--values: at most %d thicknesses",
                           STUDY_LOCKING_MOST);
    provenance_collect(&provenance);
    for (int n = 0; n < count; n++)
        TRY(measure_thickness(options, h[n], &provenance, why));
    TRY(write_thicknesses(options->folder, count, h, why));
out:
    return st;
}

static enum status read_thicknesses(const char *folder, struct study_locking *s,
                                    struct message *why)
{
    char path[TIMED_PATH];
    FILE *file;

    snprintf(path, sizeof path, "%s/thickness.txt", folder);
    file = fopen(path, "r");
    if (!file)
        return status_fail(why, STATUS_FILE, "%s cannot be read", path);
    while (s->count < STUDY_LOCKING_MOST &&
           fscanf(file, "%lf", &s->thickness[s->count]) == 1)
        s->count++;
    fclose(file);
    return s->count ? STATUS_OK : status_fail(why, STATUS_INPUT, "%s: no thickness", path);
}

static enum status read_tip(const char *path, double *tip, struct message *why)
{
    struct store_read *file = NULL;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    enum status st = xyz ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(store_read_open(path, &file, why));
    if (store_read_frames(file) != 1) {
        st = status_fail(why, STATUS_INPUT, "%s: one equilibrium is wanted", path);
        goto out;
    }
    TRY(store_read_frame(file, 0, xyz, why));
    *tip = -truth_plate_edge(xyz, NULL);
out:
    store_read_close(file);
    free(xyz);
    return st;
}

static enum status read_cells(const char *folder, struct study_locking *s,
                              struct message *why)
{
    enum status st = STATUS_OK;

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++)
        for (int nu = 0; nu < STUDY_LOCKING_NUS; nu++)
            for (int n = 0; n < s->count; n++) {
                struct study_locking_cell *c = &s->cell[space][nu][n];
                char path[TIMED_PATH];
                file_of(folder, space, study_locking_nu[nu], s->thickness[n], path);
                TRY(timed_read(path, &c->run, why));
                c->tip = NAN;
                if (c->run.refused)
                    continue;
                TRY(read_tip(path, &c->tip, why));
                c->tip /= TIP;
                if (!*s->machine)
                    strcpy(s->machine, path);
            }
out:
    return st;
}

/* Thin limit of r = 1 (header): tip of the plate with D' and nu' over that with D and nu.
 */
static enum status read_limit(struct study_locking *s)
{
    double nu = study_locking_nu[STUDY_LOCKING_NUS - 1], stiff, soft;
    enum status st;

    TRY(study_locking_coefficient(nu, &soft));
    TRY(study_locking_coefficient(nu / (1 - nu), &stiff));
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
    TRY(read_cells(folder, new, why));
    TRY(read_limit(new));
    *s = new, new = NULL;
out:
    study_locking_destroy(new);
    return st;
}

void study_locking_destroy(struct study_locking *s)
{
    for (int space = 0; s && space < STUDY_LOCKING_SPACES; space++)
        for (int nu = 0; nu < STUDY_LOCKING_NUS; nu++)
            for (int n = 0; n < s->count; n++)
                timed_clear(&s->cell[space][nu][n].run);
    free(s);
}

double study_locking_shear(const struct study_locking *s, int space, int thickness)
{
    return s->cell[space][0][thickness].tip;
}

double study_locking_through(const struct study_locking *s, int space, int thickness)
{
    return s->cell[space][STUDY_LOCKING_NUS - 1][thickness].tip /
           study_locking_shear(s, space, thickness);
}

const struct exhibit study_locking_exhibit = {
    .item = {"locking", "tip of a cantilevered sheet over Kirchhoff's, by space and "
                        "thickness: shear and thickness locking"},
    .values = "thicknesses [m] of a sheet 1 m long",
    .measure = measure,
    .print = study_locking_print,
};
