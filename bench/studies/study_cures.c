#include "bench/studies/study_cures.h"

#include <math.h>
#include <stdlib.h>

#include "bench/experiment/measurement.h"
#include "fem_ref/reference.h"
#include "models/reader/scene_file.h"

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

static void add_tip(struct table *t, int what, int law, int nu, int h,
                    const struct study_cures_tip *tip)
{
    if (isnan(tip->z))
        return;
    table_row(t);
    table_integer(t, what);
    table_integer(t, law);
    table_integer(t, nu);
    table_integer(t, h);
    table_number(t, tip->x, 6);
    table_number(t, tip->z, 6);
}

/* FOLDER/tips.csv, a line for each tip. Quick: every other thickness. */
static enum status measure_tips(const struct experiment_options *options,
                                struct message *why)
{
    enum { ALL = STUDY_CURES_LAWS * STUDY_CURES_NUS * STUDY_CURES_THICKNESSES };
    static const struct table_column columns[] = {{"what"},      {"law"}, {"nu"},
                                                  {"thickness"}, {"x"},   {"z"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, NULL);
    struct study_cures_tip tip[STUDY_CURES_WHATS];
    const bool quick = options->quick;
    enum status st = STATUS_OK;

    for (int n = 0; n < ALL; n++) {
        int law = n / (STUDY_CURES_NUS * STUDY_CURES_THICKNESSES);
        int nu = n / STUDY_CURES_THICKNESSES % STUDY_CURES_NUS;
        int h = n % STUDY_CURES_THICKNESSES;
        experiment_progress(options, "tips", n, ALL);
        for (int what = 0; what < STUDY_CURES_WHATS && !(quick && h % 2); what++) {
            /* thin sheets have one truth: the last thickness has left it in tip[] */
            if (what < STUDY_CURES_SPACES || h <= (quick ? 2 : 1))
                TRY(study_cures_solve(what, law, nu, h, quick, &tip[what], why));
            add_tip(t, what, law, nu, h, &tip[what]);
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
    int count;

    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
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
    struct measurement_case cases[STUDY_CURES_SPACES] = {{{0}}};
    char file[STUDY_CURES_SPACES][PATH], *path = NULL;
    struct settings incremental = {0};
    enum status st;

    settings_set(&incremental, "discretization.kinematics=incremental");
    TRY(scene_file_find("edge_drop", &path, why));
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        struct measurement_case *c = &cases[n];
        frame_path(options->folder, n, file[n]);
        c->plan = (struct run_plan){path, NULL, &incremental, end};
        c->keep = (struct run_keep){.file = file[n], .times = 1, .time = &time};
        c->phases = true;
        TRY(contestant_find(study_cures_space[n].contestant, &c->plan.contestant, why));
    }
    TRY(measurement_run(&(struct measurement_options){"frames", options->quick,
                                                      options->repeats, options->progress,
                                                      options->context},
                        STUDY_CURES_SPACES, cases, why));
out:
    settings_clear(&incremental);
    free(path);
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    enum status st;

    TRY(measure_tips(options, why));
    TRY(measure_zero_modes(options->folder, why));
    TRY(measure_frames(options, why));
out:
    return st;
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

const struct experiment study_cures_experiment = {
    .item = {"cures",
             "the cures for locking beside each other: accuracy at every thickness "
             "and Poisson's ratio, zero modes, cost"},
    .measure = measure,
    .print = study_cures_print,
};
