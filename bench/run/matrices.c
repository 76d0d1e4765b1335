#include "bench/run/matrices.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/files/matrix_market.h"
#include "models/reader/scene_schema.h"

static enum status write_one(const char *folder, const char *name, const char *what,
                             const struct run *run, const struct matrix *A,
                             struct message *why)
{
    const struct discretization *d = &run->discretization;
    enum status st = STATUS_OK;
    char path[4096], *settings = NULL, *comment = NULL;
    size_t size;
    FILE *text = NULL;

    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path)
        return status_fail(why, STATUS_INPUT, "--matrices: the folder's name is too long");
    TRY(scene_schema_print(d, &settings));
    text = open_memstream(&comment, &size);
    if (!text)
        TRY(STATUS_MEMORY);
    fprintf(
        text,
        "%s\n"
        "model %s (%s), scene %s\n"
        "Order: row = 3 node + component + 1, component 0 x, 1 y, 2 z;\n"
        "node = (i m + j) l + k with m = %d points along v, l = %d along w;\n"
        "i along u, j along v, k along w, all from 0. Held components are not removed.\n"
        "%s",
        what, run->model->name, run->model->title, run->scene.name, d->points[1],
        d->points[2], settings);
    if (fclose(text) != 0)
        TRY(STATUS_MEMORY);
    TRY(matrix_market_write(path, A, comment, why));
out:
    free(settings);
    free(comment);
    return st;
}

enum status matrices_write(const char *folder, const struct run_plan *plan,
                           struct message *why)
{
    enum status st = STATUS_OK;
    struct settings settings = {0};
    struct run_plan points = *plan;
    struct run run = {0};
    struct matrix K = {0}, M = {0};

    if (!plan->contestant->model->matrices)
        return status_fail(why, STATUS_UNSUPPORTED, "%s has no matrices to write",
                           plan->contestant->name);
    settings_append(&settings, plan->settings);
    settings_word(&settings, "discretization.unknowns", "points");
    points.settings = &settings;
    TRY(run_open(&run, &points, why));
    TRY(run.model->matrices(run.state, &K, &M));
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        TRY(status_fail(why, STATUS_FILE, "%s: the folder cannot be made: %s", folder,
                        strerror(errno)));
    TRY(write_one(folder, "K.mtx", "Stiffness matrix of the rest shape [N/m]", &run, &K,
                  why));
    TRY(write_one(folder, "M.mtx", "Mass matrix of the rest shape [kg]", &run, &M, why));
out:
    matrix_clear(&K);
    matrix_clear(&M);
    run_close(&run);
    settings_clear(&settings);
    return st;
}
