/* The stability map of `stress`: which step serves which stiffness, model by model. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "bench/stress/stress.h"
#include "bench/sweep/sweep.h"
#include "bench/sweep/sweep_map.h"
#include "models/grid.h"
#include "models/metric/metric.h"

/* A sheet of 1 m x 1 m x 1 cm let go for 0.3 s. Each run is held against that of the same
 * model, net and stiffness with the finest step: what is told apart is the step's part
 * alone. As a share of how far the sheet has moved, at the worst of 0.1, 0.2 and 0.3 s; a
 * twentieth can just be seen. */
static const double bound = 0.05;

static const char *const steps[] = {"[1e-4, 5e-4, 2e-3, 5e-3, 0.02, 0.05, 0.1]",
                                    "[1e-3, 0.01, 0.1]"};
static const char *const stiffnesses[] = {"[1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9]",
                                          "[1e4, 1e6, 1e8]"};
enum { SIDE = 6, TIME_LIMIT = 600, TIMES = 3 };

static void path_of(const char *folder, const char *name, char *path, int size)
{
    snprintf(path, (size_t)size, "%s/map%s%s", folder, *name ? "/" : "", name);
}

static void write_case(struct output *out, const struct stress_model *m)
{
    output_print(out, "  - {name: %s, model: %s, discretization.points: [%d,%d%s]", m->name,
                 m->model, SIDE, SIDE, m->layers ? ",2" : "");
    for (int n = 0; n < STRESS_SETTINGS && m->settings[n]; n++) {
        const char *equals = strchr(m->settings[n], '=');
        output_print(out, ", %.*s: %s", (int)(equals - m->settings[n]), m->settings[n],
                     equals + 1);
    }
    output_print(out, "}\n");
}

static enum status write_plan(const char *path, const bool *wanted, bool quick,
                              struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(output_create(path, &out, why));
    output_print(
        out,
        "name: stability\n"
        "source: clothbench stress\n"
        "scene: %s\n"
        "settings: {sheet.thickness: 0.01, time.end: 0.3, snapshots: [0.1, 0.2, 0.3]}\n"
        "cases:\n",
        stress_scene);
    for (int m = 0; m < STRESS_MODELS; m++)
        if (wanted[m])
            write_case(out, &stress_models[m]);
    output_print(out,
                 "axes:\n"
                 "  - {key: young_over_density, scale: log, values: %s}\n"
                 "  - {key: time.step, scale: log, values: %s}\n"
                 "look: 1000000\nkeep: snapshots\ntime_limit: %d\n"
                 "map: {x: time.step, y: young_over_density, panel: name}\n",
                 stiffnesses[quick], steps[quick], TIME_LIMIT);
    st = output_close(out, why);
out:
    return st;
}

/* A new run does not go on with an old one. */
static enum status forget(const char *folder, struct message *why)
{
    static const char *const endings[] = {"h5", "txt", "xdmf"};
    struct sweep_folder old = {.lock = -1, .log = -1};
    char path[SWEEP_FOLDER_PATH + 32];
    bool more = true;

    path_of(folder, "", old.path, sizeof old.path);
    for (long n = 0; more; n++) {
        more = n < 1000;
        for (int e = 0; e < 3; e++) {
            sweep_folder_file(&old, n, endings[e], path);
            more |= unlink(path) == 0;
        }
    }
    path_of(folder, "manifest.txt", path, sizeof path);
    if (unlink(path) == 0 || errno == ENOENT)
        return STATUS_OK;
    return status_fail(why, STATUS_FILE, "%s: cannot be removed: %s", path,
                       strerror(errno));
}

enum status stress_map_measure(const char *folder, const bool *wanted, int jobs, bool quick,
                               struct message *why)
{
    char path[SWEEP_FOLDER_PATH];
    struct plan plan = {0};
    enum status st;

    path_of(folder, "", path, sizeof path);
    TRY(folder_make(path, why));
    TRY(forget(folder, why));
    path_of(folder, "plan.yaml", path, sizeof path);
    TRY(write_plan(path, wanted, quick, why));
    TRY(plan_read(path, &plan, why));
    path_of(folder, "", path, sizeof path);
    st = sweep_run(&plan,
                   &(struct sweep_options){.folder = path, .jobs = jobs, .quiet = true},
                   stdout, why);
out:
    plan_clear(&plan);
    return st;
}

/* A case on the map. */
struct spot {
    enum stress_end end;
    bool reference; /* it has the finest step                                          */
    double error;
};

struct map {
    struct plan plan;
    struct sweep_folder folder;
    int models, stiffnesses, steps;
    double *xyz, *reference[TIMES]; /* fields; the finest step's                 owned */
    double moved[TIMES];            /* by the reference [m]; NaN: it has died          */
};

static void clear_map(struct map *m)
{
    plan_clear(&m->plan);
    free(m->xyz);
    for (int k = 0; k < TIMES; k++)
        free(m->reference[k]);
}

/* *there is false where no map was made. */
static enum status open_map(struct map *m, const char *folder, bool *there,
                            struct message *why)
{
    char path[SWEEP_FOLDER_PATH];
    enum status st = STATUS_OK;

    *m = (struct map){.folder = {.lock = -1, .log = -1}};
    path_of(folder, "", m->folder.path, sizeof m->folder.path);
    path_of(folder, "plan.yaml", path, sizeof path);
    *there = access(path, R_OK) == 0;
    if (!*there)
        return st;
    TRY(plan_read(path, &m->plan, why));
    m->models = m->plan.listed_count;
    m->stiffnesses = m->plan.axes[0].values.count;
    m->steps = m->plan.axes[1].values.count;
    m->xyz = malloc(3 * GRID_POINTS * sizeof *m->xyz);
    st = m->xyz ? STATUS_OK : STATUS_MEMORY;
    for (int k = 0; k < TIMES; k++) {
        m->reference[k] = malloc(3 * GRID_POINTS * sizeof *m->xyz);
        if (!m->reference[k])
            st = STATUS_MEMORY;
    }
out:
    return st;
}

static enum status read_reference(struct map *m, const struct store_read *file,
                                  const char *path, struct message *why)
{
    struct scene scene = {0};
    double uvw[3];
    enum status st;

    TRY(store_scene(file, path, &scene, why));
    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        scene_rest_point(&scene, uvw, m->xyz + 3 * (size_t)n);
    }
    for (int k = 0; k < TIMES; k++) {
        TRY(store_read_frame(file, k, m->reference[k], why));
        m->moved[k] = metric_rmse(m->reference[k], m->xyz);
    }
out:
    scene_clear(&scene);
    return st;
}

/* The worst of the times. */
static enum status compare(struct map *m, const struct store_read *file, double *error,
                           struct message *why)
{
    enum status st = STATUS_OK;

    *error = 0;
    for (int k = 0; k < TIMES; k++) {
        TRY(store_read_frame(file, k, m->xyz, why));
        const double at = metric_rmse(m->xyz, m->reference[k]) / m->moved[k];
        if (!(at <= *error))
            *error = at;
    }
out:
    return st;
}

static enum status judge(struct map *m, long number, const struct sweep_row *row,
                         struct spot *spot, struct message *why)
{
    const bool finest = number % m->steps == 0;
    const bool refused = row->ran && row->result.outcome == STATUS_UNSUPPORTED;
    char path[SWEEP_FOLDER_PATH];
    struct store_read *file = NULL;
    enum status st = STATUS_OK;

    *spot = (struct spot){.end = refused ? STRESS_REFUSED : STRESS_DIED, .error = NAN};
    for (int k = 0; finest && k < TIMES; k++)
        m->moved[k] = NAN;
    if (!row->ran || row->result.outcome != STATUS_OK)
        return STATUS_OK;
    sweep_folder_file(&m->folder, number, "h5", path);
    TRY(store_read_open(path, &file, why));
    spot->reference = finest;
    if (finest)
        TRY(read_reference(m, file, path, why));
    TRY(compare(m, file, &spot->error, why));
    spot->end = spot->error <= bound ? STRESS_ACCURATE : STRESS_DEGRADED;
out:
    store_read_close(file);
    return st;
}

/* Of one model: counts, and by stiffness the largest step up to which all are accurate. */
struct summary {
    int count[4];
    int largest[16];
    bool broken[16];
};

static void note(struct summary *s, int stiffness, int step, const struct spot *spot)
{
    s->count[spot->end]++;
    if (spot->end != STRESS_ACCURATE)
        s->broken[stiffness] = true;
    if (!s->broken[stiffness])
        s->largest[stiffness] = step;
}

static void print_model(struct table *t, const struct map *m, int model,
                        const struct summary *s)
{
    table_row(t);
    table_text(t, "%s", m->plan.listed[model].name);
    for (int e = 0; e < m->stiffnesses; e++)
        if (s->largest[e] < 0)
            table_text(t, "none");
        else
            table_text(t, "%s", m->plan.axes[1].values.list[s->largest[e]].value);
    for (int n = 0; n < 4; n++)
        table_integer(t, s->count[n]);
}

static struct table *make_table(const struct map *m)
{
    struct table_column columns[1 + 16 + 4] = {{"step [s] by E/rho", NULL, TABLE_LEFT}};
    int count = 1;

    for (int e = 0; e < m->stiffnesses; e++)
        columns[count++] =
            (struct table_column){m->plan.axes[0].values.list[e].value, NULL, TABLE_RIGHT};
    for (int n = 0; n < 4; n++)
        columns[count++] =
            (struct table_column){stress_end_name((enum stress_end)n), NULL, TABLE_RIGHT};
    return table_create(count, columns,
                        "Stability: the largest step up to which all steps are accurate");
}

/* One model: spots onto the map and the CSV, a row of the table. */
static enum status add_model(struct map *m, int model, struct sweep_map *map,
                             struct output *csv, struct table *t, struct message *why)
{
    struct summary s = {{0}, {0}, {0}};
    const int cases = m->stiffnesses * m->steps;
    enum status st = STATUS_OK;

    for (int e = 0; e < 16; e++)
        s.largest[e] = -1;
    for (int n = 0; n < cases; n++) {
        const long number = (long)model * cases + n;
        struct plan_case c;
        struct sweep_row row;
        struct spot spot;

        sweep_folder_read(&m->folder, number, false, &row);
        TRY(judge(m, number, &row, &spot, why));
        const char *label = spot.reference ? "reference" : stress_end_name(spot.end);
        note(&s, n / m->steps, n % m->steps, &spot);
        TRY(plan_case_given(&m->plan, number, &c));
        sweep_map_row(map, &c, &row, label);
        plan_case_clear(&c);
        output_print(csv, "%s,%s,%s,%s,%.17g\n", m->plan.listed[model].name,
                     m->plan.axes[0].values.list[n / m->steps].value,
                     m->plan.axes[1].values.list[n % m->steps].value, label, spot.error);
    }
    print_model(t, m, model, &s);
out:
    return st;
}

static enum status draw(struct map *m, struct table *t, struct message *why)
{
    struct sweep_map *map = NULL;
    struct output *csv = NULL;
    struct message plot = {""};
    char path[SWEEP_FOLDER_PATH + 32];
    enum status st;

    snprintf(path, sizeof path, "%s/stability.csv", m->folder.path);
    TRY(output_create(path, &csv, why));
    output_print(csv, "model,young_over_density,step,end,error\n");
    TRY(sweep_map_open(&map, &m->plan, &m->folder, "accurate", why));
    for (int n = 0; n < m->models; n++)
        TRY(add_model(m, n, map, csv, t, why));
    struct output *whole = csv;
    csv = NULL;
    TRY(output_close(whole, why));
    struct sweep_map *drawn = map;
    map = NULL;
    st = sweep_map_close(drawn, &plot);
    if (st == STATUS_UNSUPPORTED || st == STATUS_LIBRARY) {
        fprintf(stderr, "No map: %s\n", plot.text);
        st = STATUS_OK;
    } else if (st != STATUS_OK) {
        *why = plot;
    } else {
        fprintf(stderr, "Map: %s/map.png\n", m->folder.path);
    }
out:
    sweep_map_discard(map);
    output_discard(csv);
    return st;
}

enum status stress_map_print(const char *folder, enum table_format format, FILE *file,
                             bool *there, struct message *why)
{
    struct map m;
    struct table *t = NULL;
    enum status st;

    TRY(open_map(&m, folder, there, why));
    if (!*there)
        goto out;
    t = make_table(&m);
    TRY(draw(&m, t, why));
    table_note(
        t,
        "A sheet of 1 m x 1 m x 1 cm let go, at the worst of 0.1, 0.2 and 0.3 s, %d x %d "
        "points. E/rho in "
        "m^2/s^2. Accurate: within %g of how far the sheet has moved, from the run of "
        "the same model with the finest step (%s s), which is counted as accurate; what "
        "lives where that has died is degraded.",
        SIDE, SIDE, bound, m.plan.axes[1].values.list[0].value);
    fputc('\n', file);
    st = table_print(t, format, file);
out:
    table_destroy(t);
    clear_map(&m);
    return st;
}
