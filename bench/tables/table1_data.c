#include "bench/tables/table1_data.h"

#include <math.h>
#include <stdlib.h>

#include "bench/truth/paper.h"
#include "bench/files/store_scene.h"
#include "bench/experiment/timed.h"
#include "models/metric/metric.h"

void table1_data_clear(struct table1_data *d)
{
    if (!d)
        return;
    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++) {
            for (int t = 0; t < TABLE1_TIMES; t++)
                free(d->cell[part][n].xyz[t]);
            free(d->cell[part][n].outcome);
        }
    truth_plate_clear(&d->truth);
    free(d);
}

static enum status load_cell(const char *path, struct table1_cell *c, struct message *why)
{
    struct store_read *file = NULL;
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_read_number(file, "unknowns", &c->unknowns, why));
    TRY(store_read_text(file, "/", "outcome", &c->outcome, why));
    c->frames = store_read_frames(file);
    if (c->frames > TABLE1_TIMES) {
        st = status_fail(why, STATUS_INPUT, "%s: %d frames, but Table 1 keeps %d", path,
                         c->frames, TABLE1_TIMES);
        goto out;
    }
    for (int t = 0; t < c->frames; t++) {
        c->xyz[t] = malloc(3 * GRID_POINTS * sizeof(double));
        if (!c->xyz[t])
            TRY(STATUS_MEMORY);
        TRY(store_read_frame(file, t, c->xyz[t], why));
    }
    TRY(timed_seconds(file, "create", &c->create, why));
    TRY(timed_seconds(file, "advance", &c->step, why));
out:
    store_read_close(file);
    return st;
}

static enum status load_cells(const char *folder, struct table1_data *d,
                              struct message *why)
{
    enum status st = STATUS_OK;
    char path[4096];

    for (int part = 0; part < TABLE1_PARTS; part++)
        for (int n = 0; n < TABLE1_VARIANTS; n++) {
            struct table1_cell *c = &d->cell[part][n], *baseline = &d->cell[part][0];
            table1_path(folder, part, n, path, sizeof path);
            TRY(load_cell(path, c, why));
            for (int t = 0; t < TABLE1_TIMES; t++)
                c->rmse[t] = t < c->frames && t < baseline->frames
                                 ? metric_rmse(c->xyz[t], baseline->xyz[t])
                                 : NAN;
        }
out:
    return st;
}

/* Truth for the scene of the linear runs. */
static enum status load_truth(const char *folder, struct truth_plate *truth,
                              struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    char path[4096];
    enum status st;

    table1_path(folder, TABLE1_LINEAR, 0, path, sizeof path);
    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    TRY(truth_plate_init(truth, &scene, TABLE1_TIMES, table1_time, why));
out:
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

enum status table1_data_load(const char *folder, struct table1_data **d,
                             struct message *why)
{
    struct table1_data *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(load_cells(folder, new, why));
    TRY(load_truth(folder, &new->truth, why));
    *d = new, new = NULL;
out:
    table1_data_clear(new);
    return st;
}

bool table1_data_within(const struct table1_cell *c)
{
    for (int t = 0; t < TABLE1_TIMES; t++)
        if (!(c->rmse[t] <= PAPER_TABLE1_RMSE))
            return false;
    return true;
}

/* The first density that meets the paper's criterion at all times; -1 if none does. */
int table1_data_first(const struct table1_cell *cells, bool incompatible)
{
    for (int n = 0; n < TABLE1_DENSITIES; n++) {
        int variant = 1 + n + (incompatible ? TABLE1_DENSITIES : 0);
        if (table1_data_within(&cells[variant]))
            return variant;
    }
    return -1;
}
