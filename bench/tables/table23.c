#include "bench/tables/table23.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/registry.h"
#include "bench/files/store_scene.h"
#include "models/contact.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"

const char *const table23_kind_name[TABLE23_KINDS] = {"printed", "incremental", "linear"};

/* The paper does not say what moves in Figs. 12 and 13 and in Table 3; a frame of a solid
 * costs the same whatever its supports and its material. */
static const char *const scene_of[PAPER_TABLE2_ROWS] = {
    "edge_drop", "corners_drop", "ground",    "edge_drop", "edge_drop",
    "edge_drop", "edge_drop",    "edge_drop", "edge_drop", "flag"};

/* Kept besides the seconds: where the sheet is then, and the work done up to it [s]. */
static const double kept[] = {0.5}, kept_quick[] = {0.1};

/* A sheet that falls on an obstacle: its frames cost more once it lies there, so that all
 * of them are timed, from the fall to well after the landing [s]. */
static const double landed[] = {1}, landed_quick[] = {0.3};

int table23_rows(enum table23 which)
{
    return which == TABLE23_SECOND ? PAPER_TABLE2_ROWS : PAPER_TABLE3_ROWS;
}

struct table23_row table23_row(enum table23 which, int n)
{
    const struct paper_cost *paper =
        which == TABLE23_SECOND ? &paper_table2[n] : &paper_table3[n];
    const struct paper_cost *material =
        which == TABLE23_SECOND ? paper : &paper_table2[PAPER_GROWTH];
    struct table23_row row = {.paper = paper,
                              .scene = which == TABLE23_SECOND ? scene_of[n] : "edge_drop",
                              .young = material->young,
                              .poisson = material->poisson,
                              .density = material->density,
                              .damping = material->damping};
    int turn = paper->points[0] == 2 ? 1 : 0; /* 2 x n x n */

    for (int i = 0; i < 3; i++) {
        row.degree[i] = paper->degree[(i + turn) % 3];
        row.points[i] = paper->points[(i + turn) % 3];
    }
    return row;
}

int table23_control_points(const struct table23_row *row)
{
    return row->points[0] * row->points[1] * row->points[2];
}

int table23_elements(const struct table23_row *row)
{
    int count = 1;

    for (int i = 0; i < 3; i++)
        count *= row->points[i] - row->degree[i];
    return count;
}

double table23_assembly_work(const struct table23_row *row)
{
    double functions = 1; /* and Gauss points: degree + 1 in each direction */

    for (int i = 0; i < 3; i++)
        functions *= row->degree[i] + 1;
    return table23_elements(row) * functions * functions * functions;
}

/* FOLDER/fig_7_edge_fixed_printed.h5, FOLDER/133_15x15_linear.h5. */
static void file_of(const char *folder, const struct table23_row *row,
                    enum table23_kind kind, char path[TIMED_PATH])
{
    snprintf(path, TIMED_PATH, "%s/%s_%d%d%d_%dx%d_e%.0f_mu%.0f_%s.h5", folder, row->scene,
             row->degree[0], row->degree[1], row->degree[2], row->points[0], row->points[1],
             row->young, 100 * row->damping, table23_kind_name[kind]);
}

static enum status read_scene(const char *path, const struct table23_row *row,
                              enum table23_kind kind, struct scene *scene,
                              struct message *why)
{
    enum { SETTINGS = 4, TEXT = 96 };
    struct discretization unused = {0};
    char text[SETTINGS][TEXT];
    const char *settings[SETTINGS];
    enum status st;

    snprintf(text[0], TEXT, "material.young=%.17g", row->young);
    snprintf(text[1], TEXT, "material.poisson=%.17g", row->poisson);
    snprintf(text[2], TEXT, "material.density=%.17g", row->density);
    if (kind == TABLE23_PRINTED)
        snprintf(text[3], TEXT, "damping={kind: velocity_scale, value: %.17g}",
                 row->damping);
    else
        snprintf(text[3], TEXT, "damping={kind: none}");
    for (int n = 0; n < SETTINGS; n++)
        settings[n] = text[n];
    st = scene_file_read(path, SETTINGS, settings, scene, &unused, why);
    discretization_clear(&unused);
    return st;
}

static enum status set_up(const struct experiment_options *options,
                          const struct table23_row *row, enum table23_kind kind,
                          struct scene *scene, struct timed_case *c, struct message *why)
{
    static const enum kinematics kinematics[TABLE23_KINDS] = {
        KINEMATICS_PRINTED, KINEMATICS_INCREMENTAL, KINEMATICS_LINEAR};
    struct message nowhere = {""};
    char *path = NULL;
    enum status st;

    file_of(options->folder, row, kind, c->path);
    if (scene_file_find(row->scene, &path, &nowhere) != STATUS_OK)
        return timed_refuse(c->path, nowhere.text, why);
    TRY(registry_find("iga", &c->model, why));
    TRY(read_scene(path, row, kind, scene, why));
    c->scene = scene;
    c->model->defaults(&c->d);
    c->d.kinematics = kinematics[kind];
    memcpy(c->d.degree, row->degree, sizeof row->degree);
    memcpy(c->d.points, row->points, sizeof row->points);
    c->time = options->quick ? kept_quick : kept;
    c->times = 1;
    c->phases = kind == TABLE23_PRINTED;
    if (scene_needs(scene) & SCENE_NEED_CONTACT) {
        c->time = options->quick ? landed_quick : landed;
        c->frames = (int)lround(*c->time / scene->step);
    }
out:
    free(path);
    return st;
}

enum status table23_measure(enum table23 which, const struct experiment_options *options,
                            struct message *why)
{
    int rows = table23_rows(which), count = rows * TABLE23_KINDS, done = 0;
    struct timed_case *cases = calloc((size_t)count, sizeof *cases);
    struct scene *scenes = calloc((size_t)count, sizeof *scenes);
    struct provenance provenance;
    enum status st = cases && scenes ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    provenance_collect(&provenance);
    for (; done < count; done++) {
        struct table23_row row = table23_row(which, done / TABLE23_KINDS);
        TRY(set_up(options, &row, done % TABLE23_KINDS, &scenes[done], &cases[done], why));
    }
    TRY(timed_measure(options, which == TABLE23_SECOND ? "table 2" : "table 3", &provenance,
                      count, cases, why));
out:
    for (int n = 0; n < done; n++)
        scene_clear(&scenes[n]);
    free(scenes);
    free(cases);
    return st;
}

/* How far the sheet was from its obstacle at the last time kept. */
static enum status load_gap(const struct store_read *file, const struct scene *scene,
                            double *gap, struct message *why)
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    enum status st = xyz ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    if (store_read_frames(file)) {
        TRY(store_read_frame(file, store_read_frames(file) - 1, xyz, why));
        *gap = contact_least_gap(scene, GRID_POINTS, xyz);
    }
out:
    free(xyz);
    return st;
}

static enum status load_scene(const char *path, double *gamma, double *gap,
                              struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    *gamma = scene_gamma(&scene);
    if (scene_needs(&scene) & SCENE_NEED_CONTACT)
        TRY(load_gap(file, &scene, gap, why));
out:
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

static enum status load_row(struct table23_data *d, const char *folder, int n,
                            struct message *why)
{
    enum status st = STATUS_OK;
    char path[TIMED_PATH];

    d->gamma[n] = d->gap[n] = NAN;
    for (int kind = 0; kind < TABLE23_KINDS; kind++) {
        file_of(folder, &d->row[n], kind, path);
        TRY(timed_read(path, &d->cell[n][kind], why));
        if (d->cell[n][kind].refused)
            continue;
        if (isnan(d->gamma[n]))
            TRY(load_scene(path, &d->gamma[n], &d->gap[n], why));
        if (!*d->machine)
            strcpy(d->machine, path);
    }
out:
    return st;
}

enum status table23_load(enum table23 which, const char *folder, struct table23_data **d,
                         struct message *why)
{
    struct table23_data *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    new->which = which;
    new->rows = table23_rows(which);
    for (int n = 0; n < new->rows; n++) {
        new->row[n] = table23_row(which, n);
        TRY(load_row(new, folder, n, why));
    }
    *d = new, new = NULL;
out:
    table23_destroy(new);
    return st;
}

void table23_destroy(struct table23_data *d)
{
    if (!d)
        return;
    for (int n = 0; n < d->rows; n++)
        for (int kind = 0; kind < TABLE23_KINDS; kind++)
            timed_clear(&d->cell[n][kind]);
    free(d);
}

static double milliseconds(const struct clock_summary *s)
{
    return s->count ? 1e3 * s->median : NAN;
}

double table23_cost(const struct table23_data *d, int row, enum table23_kind kind)
{
    return milliseconds(&d->cell[row][kind].step);
}

double table23_phase(const struct table23_data *d, int row, enum bench_solid_phase phase)
{
    return milliseconds(&d->cell[row][TABLE23_PRINTED].phase[phase]);
}

double table23_factor_work(const struct table23_data *d, int row)
{
    const struct timed_result *r = &d->cell[row][TABLE23_PRINTED];

    return r->refused ? NAN : r->factor_entries * r->factor_entries / r->unknowns;
}

static enum status measure_second(const struct experiment_options *options,
                                  struct message *why)
{
    return table23_measure(TABLE23_SECOND, options, why);
}

static enum status print_second(const char *folder, enum table_format format, FILE *file,
                                struct message *why)
{
    return table23_print(TABLE23_SECOND, folder, format, file, why);
}

static enum status measure_third(const struct experiment_options *options,
                                 struct message *why)
{
    return table23_measure(TABLE23_THIRD, options, why);
}

static enum status print_third(const char *folder, enum table_format format, FILE *file,
                               struct message *why)
{
    return table23_print(TABLE23_THIRD, folder, format, file, why);
}

const struct experiment table23_second = {
    .item = {"2", "Ren et al. 2024, Table 2: milliseconds a frame over ten scenes, and how "
                  "they grow with the net"},
    .measure = measure_second,
    .print = print_second,
};

const struct experiment table23_third = {
    .item = {"3", "Ren et al. 2024, Table 3: milliseconds a frame over degree and net"},
    .measure = measure_third,
    .print = print_third,
};
