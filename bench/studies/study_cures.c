#include "bench/studies/study_cures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/harness/registry.h"
#include "fem_ref/reference.h"
#include "models/reader/scene_file.h"

const struct study_cures_space study_cures_space[STUDY_CURES_SPACES] = {
    {"IGA (2,2,1), none, the paper's", "none_2", 2, REMEDY_NONE},
    {"IGA (2,2,1), reduced", "reduced_2", 2, REMEDY_REDUCED},
    {"IGA (2,2,1), selective", "selective_2", 2, REMEDY_SELECTIVE},
    {"IGA (3,3,1), none", "none_3", 3, REMEDY_NONE},
    {"IGA (3,3,1), reduced", "reduced_3", 3, REMEDY_REDUCED},
    {"IGA (3,3,1), selective", "selective_3", 3, REMEDY_SELECTIVE},
};
const double study_cures_thickness[STUDY_CURES_THICKNESSES] = {1e-1, 1e-2, 1e-3, 1e-4,
                                                               1e-5};
const double study_cures_nu[STUDY_CURES_NUS] = {0, 0.3, 0.49};
const double study_cures_gamma[STUDY_CURES_LAWS] = {0, 10, 100};
const double study_cures_target = 0.02;

/* Quick: every other thickness. */
static bool asked(bool quick, int thickness)
{
    return !quick || thickness % 2 == 0;
}

static enum status solve(int what, int law, int nu, int thickness, bool quick,
                         struct study_cures_tip *tip, struct message *why)
{
    if (what >= STUDY_CURES_SPACES)
        return study_cures_truth(what, law, nu, thickness, quick, tip, why);

    const struct study_cures_space *space = &study_cures_space[what];
    const struct study_cures_case c = {.model = "iga",
                                       .nu = study_cures_nu[nu],
                                       .thickness = study_cures_thickness[thickness],
                                       .gamma = study_cures_gamma[law],
                                       .degree = {space->degree, space->degree, 1},
                                       .points = {10, 10, 2},
                                       .remedy = space->remedy};
    return study_cures_solve(&c, tip, why);
}

/* FOLDER/tips.csv, a line for each tip. */
static enum status measure_tips(const struct exhibit_options *options, struct message *why)
{
    enum { ALL = STUDY_CURES_LAWS * STUDY_CURES_NUS * STUDY_CURES_THICKNESSES };
    struct output *out = NULL;
    struct study_cures_tip tip[STUDY_CURES_WHATS];
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/tips.csv", options->folder);
    TRY(output_create(path, &out, why));
    output_print(out, "what,law,nu,thickness,x,z\n");
    for (int n = 0; n < ALL; n++) {
        int law = n / (STUDY_CURES_NUS * STUDY_CURES_THICKNESSES);
        int nu = n / STUDY_CURES_THICKNESSES % STUDY_CURES_NUS;
        int h = n % STUDY_CURES_THICKNESSES;
        exhibit_progress(options, "tips", n, ALL);
        for (int what = 0; what < STUDY_CURES_WHATS && asked(options->quick, h); what++) {
            /* thin sheets have one truth: the last thickness has left it in tip[] */
            if (what < STUDY_CURES_SPACES || h <= (options->quick ? 2 : 1))
                TRY(solve(what, law, nu, h, options->quick, &tip[what], why));
            if (!isnan(tip[what].z))
                output_print(out, "%d,%d,%d,%d,%.17g,%.17g\n", what, law, nu, h,
                             tip[what].x, tip[what].z);
        }
    }
    exhibit_progress(options, "tips", ALL, ALL);
    st = output_close(out, why);
    out = NULL;
out:
    output_discard(out);
    return st;
}

/* FOLDER/zero_modes.csv */
static enum status measure_zero_modes(const char *folder, struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/zero_modes.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "space,zero_modes\n");
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        int count;
        TRY(study_cures_zero_modes(&study_cures_space[n], &count, why));
        output_print(out, "%d,%d\n", n, count);
    }
    st = output_close(out, why);
    out = NULL;
out:
    output_discard(out);
    return st;
}

static void frame_path(const char *folder, int space, char path[TIMED_PATH])
{
    snprintf(path, TIMED_PATH, "%s/frame_%s.h5", folder, study_cures_space[space].name);
}

/* Rebuilt frames, which the paper's are. `incremental`, for the cured sheet dies under the
 * printed scheme; both do the same work. */
static enum status measure_frames(const struct exhibit_options *options,
                                  struct message *why)
{
    static const double times[] = {0.1};
    struct timed_case cases[STUDY_CURES_SPACES] = {{0}};
    struct discretization unused = {0};
    struct provenance provenance;
    struct scene scene = {0};
    char *path = NULL;
    enum status st;

    provenance_collect(&provenance);
    TRY(scene_file_find("edge_drop", &path, why));
    TRY(scene_file_read(path, 0, NULL, &scene, &unused, why));
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        struct timed_case *c = &cases[n];
        TRY(registry_find("iga", &c->model, why));
        c->model->defaults(&c->d);
        c->d.kinematics = KINEMATICS_INCREMENTAL;
        c->d.remedy = study_cures_space[n].remedy;
        c->d.degree[0] = c->d.degree[1] = study_cures_space[n].degree;
        c->scene = &scene;
        c->times = 1;
        c->time = times;
        c->phases = true;
        frame_path(options->folder, n, c->path);
    }
    TRY(timed_measure(options, "frames", &provenance, STUDY_CURES_SPACES, cases, why));
out:
    free(path);
    discretization_clear(&unused);
    scene_clear(&scene);
    return st;
}

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    enum status st;

    TRY(measure_tips(options, why));
    TRY(measure_zero_modes(options->folder, why));
    TRY(measure_frames(options, why));
out:
    return st;
}

static bool in_range(double value, int count)
{
    return value >= 0 && value < count && value == floor(value);
}

static enum status read_tips(const char *path, struct study_cures *s, struct message *why)
{
    struct reference *table = NULL;
    enum status st;

    TRY(reference_open(path, &table, why));
    for (int row = 0; row < reference_rows(table); row++) {
        double what = reference_number(table, row, "what");
        double law = reference_number(table, row, "law");
        double nu = reference_number(table, row, "nu");
        double h = reference_number(table, row, "thickness");
        if (!in_range(what, STUDY_CURES_WHATS) || !in_range(law, STUDY_CURES_LAWS) ||
            !in_range(nu, STUDY_CURES_NUS) || !in_range(h, STUDY_CURES_THICKNESSES)) {
            st = status_fail(why, STATUS_INPUT, "%s: row %d is of no case", path, row + 1);
            goto out;
        }
        s->tip[(int)what][(int)law][(int)nu][(int)h] = (struct study_cures_tip){
            reference_number(table, row, "x"), reference_number(table, row, "z")};
    }
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
    for (int n = 0; n < STUDY_CURES_SPACES && n < reference_rows(table); n++)
        s->zero_modes[n] = (int)reference_number(table, n, "zero_modes");
out:
    reference_close(table);
    return st;
}

enum status study_cures_read(const char *folder, struct study_cures **s,
                             struct message *why)
{
    enum { TIPS = sizeof(*s)->tip / sizeof(struct study_cures_tip) };
    struct study_cures *new = calloc(1, sizeof *new);
    char path[TIMED_PATH];
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
        TRY(timed_read(path, &new->frame[n], why));
    }
    frame_path(folder, 0, new->machine);
    *s = new, new = NULL;
out:
    study_cures_destroy(new);
    return st;
}

void study_cures_destroy(struct study_cures *s)
{
    for (int n = 0; s && n < STUDY_CURES_SPACES; n++)
        timed_clear(&s->frame[n]);
    free(s);
}

double study_cures_error(const struct study_cures *s, int space, int law, int nu, int n)
{
    return fabs(s->tip[space][law][nu][n].z / s->tip[STUDY_CURES_TRUTH][law][nu][n].z - 1);
}

const struct exhibit study_cures_exhibit = {
    .item = {"cures",
             "the cures for locking beside each other: accuracy at every thickness "
             "and Poisson's ratio, zero modes, cost"},
    .measure = measure,
    .print = study_cures_print,
};
