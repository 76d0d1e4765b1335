#include "bench/tables/table1.h"

#include <math.h>
#include <stdlib.h>

#include "bench/experiment/measurement.h"
#include "bench/files/store_scene.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

const double table1_time[TABLE1_TIMES] = {0.1, 0.2, 0.3, 0.4};
static const char *const part_name[TABLE1_PARTS] = {"printed", "incremental", "linear",
                                                    "static"};

const struct contestant *table1_contestant(enum table1_part part, int variant)
{
    static const char *const name[][TABLE1_PARTS] = {
        {"iga_paper", "iga_incremental", "iga_linear", "iga_linear"},
        {"hex_paper", "hex_incremental", "hex_linear", "hex_linear"},
        {"hex_incompatible_paper", "hex_incompatible_incremental",
         "hex_incompatible_linear", "hex_incompatible_linear"},
        {"shell_2", "shell_2", "shell_linear", "shell_linear"}};
    const struct contestant *c = NULL;

    contestant_find(name[(variant + TABLE1_DENSITIES - 1) / TABLE1_DENSITIES][part], &c,
                    NULL);
    return c;
}

int table1_side(int variant)
{
    static const int density[TABLE1_DENSITIES] = {10, 16, 24, 32, 40};

    return variant == 0 || variant == TABLE1_SHELL
               ? 10
               : density[(variant - TABLE1_HEX) % TABLE1_DENSITIES];
}

void table1_path(const char *folder, enum table1_part part, int variant, char *path,
                 int size)
{
    snprintf(path, (size_t)size, "%s/%s_%s_%d%s.h5", folder, part_name[part],
             table1_contestant(part, variant)->model->name, table1_side(variant),
             TABLE1_CURED <= variant && variant < TABLE1_SHELL ? "_incompatible" : "");
}

enum { PATH = 4096 };

/* A solid's frame costs the same all along the motion; the shell's Newton iterations are
 * more in some frames than in others, so it is timed over the whole motion. */
static struct measurement_case set_up(enum table1_part part, int variant, const char *scene,
                                      const char *file, struct settings *s)
{
    const bool rest = part == TABLE1_STATIC;
    const struct contestant *c = table1_contestant(part, variant);

    contestant_points(c, table1_side(variant), table1_side(variant), s);
    /* the velocity scaling of the paper belongs to its own kinematics */
    if (part != TABLE1_PRINTED || variant == TABLE1_SHELL)
        settings_set(s, "damping={kind: none}");
    return (struct measurement_case){
        .plan = {scene, c, s, table1_time[TABLE1_TIMES - 1]},
        .keep = {.file = file, .times = rest ? 0 : TABLE1_TIMES, .time = table1_time},
        .rest = rest,
        .timed = rest                      ? MEASUREMENT_UNTIMED
                 : variant == TABLE1_SHELL ? MEASUREMENT_WHOLE
                                           : MEASUREMENT_SOME};
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    struct measurement_options how = {.quick = options->quick,
                                      .repeats = options->repeats,
                                      .progress = options->progress,
                                      .context = options->context};
    struct measurement_case cases[TABLE1_VARIANTS];
    struct settings settings[TABLE1_VARIANTS] = {{0}};
    char file[TABLE1_VARIANTS][PATH], *scene = NULL;
    enum status st;

    TRY(scene_file_find("edge_drop", &scene, why));
    for (int part = 0; part < TABLE1_PARTS; part++) {
        for (int n = 0; n < TABLE1_VARIANTS; n++) {
            table1_path(options->folder, part, n, file[n], PATH);
            settings_clear(&settings[n]);
            cases[n] = set_up(part, n, scene, file[n], &settings[n]);
        }
        how.what = part_name[part];
        TRY(measurement_run(&how, TABLE1_VARIANTS, cases, why));
    }
out:
    for (int n = 0; n < TABLE1_VARIANTS; n++)
        settings_clear(&settings[n]);
    free(scene);
    return st;
}

void table1_clear(struct table1_data *d)
{
    if (!d)
        return;
    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++)
            run_result_clear(&d->cell[part][n].run);
    truth_plate_clear(&d->truth);
    free(d);
}

static enum status load_cell(const char *path, const struct run_result *baseline,
                             struct table1_cell *c, struct message *why)
{
    enum status st = run_result_read(path, true, &c->run, why);

    if (st == STATUS_OK && c->run.frames > TABLE1_TIMES)
        st = status_fail(why, STATUS_INPUT, "%s: %d frames, but Table 1 keeps %d", path,
                         c->run.frames, TABLE1_TIMES);
    for (int t = 0; t < TABLE1_TIMES && st == STATUS_OK; t++)
        c->rmse[t] = t < c->run.frames && t < baseline->frames
                         ? metric_rmse(c->run.xyz[t], baseline->xyz[t])
                         : NAN;
    return st;
}

/* Truth for the scene of the linear runs. */
static enum status load_truth(const char *path, struct truth_plate *truth,
                              struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    TRY(truth_plate_init(truth, &scene, TABLE1_TIMES, table1_time, why));
out:
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

enum status table1_load(const char *folder, struct table1_data **d, struct message *why)
{
    struct table1_data *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;
    char path[PATH];

    TRY(st);
    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++) {
            table1_path(folder, part, n, path, PATH);
            TRY(load_cell(path, &new->cell[part][0].run, &new->cell[part][n], why));
        }
    table1_path(folder, TABLE1_LINEAR, 0, path, PATH);
    TRY(load_truth(path, &new->truth, why));
    *d = new, new = NULL;
out:
    table1_clear(new);
    return st;
}

const struct experiment table1_exhibit = {
    .item = {"1", "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at "
                  "equal looks and against truth"},
    .measure = measure,
    .print = table1_print,
};
