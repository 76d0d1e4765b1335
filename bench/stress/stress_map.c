/* The stability map of `stress`: which step serves which stiffness, model by model. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/store.h"
#include "bench/stress/stress.h"
#include "bench/sweep/sweep.h"
#include "bench/experiment/plan.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* A sheet of 1 m x 1 m x 1 cm let go for 0.3 s. Each run is held against that of the same
 * model, net and stiffness with the finest step: what is told apart is the step's part
 * alone. As a share of how far the sheet has moved, at the worst of 0.1, 0.2 and 0.3 s; a
 * twentieth can just be seen. */
static const double bound = 0.05;

static const char *const steps[] = {"[1e-4, 5e-4, 2e-3, 5e-3, 0.02, 0.05, 0.1]",
                                    "[1e-3, 0.01, 0.1]"};
static const char *const stiffnesses[] = {"[1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9]",
                                          "[1e4, 1e6, 1e8]"};
#define QUICK " --quick" /* in the source of the map's plan */
enum { SIDE = 6, TIME_LIMIT = 600, TIMES = 3, ENDS = STRESS_UNJUDGED };

static enum status write_plan(const char *path, const struct stress_choice *choice,
                              struct message *why)
{
    const struct contestant *at = NULL;
    struct output *out = NULL;
    enum status st;

    TRY(output_create(path, &out, why));
    output_print(
        out,
        "name: stability\n"
        "source: clothbench stress%s\n"
        "scene: %s\n"
        "settings: {sheet.thickness: 0.01, time.end: 0.3, snapshots: [0.1, 0.2, 0.3]}\n"
        "cases:\n",
        choice->quick ? QUICK : "", stress_case_scene);
    while ((at = stress_choice_next(choice, at)))
        output_print(out, "  - {name: %s, model: %s, discretization.points: [%d,%d%s]}\n",
                     at->name, at->name, SIDE, SIDE, at->layers ? ",2" : "");
    output_print(out,
                 "axes:\n"
                 "  - {key: young_over_density, scale: log, values: %s}\n"
                 "  - {key: time.step, scale: log, values: %s}\n"
                 "look: 1000000\nkeep: snapshots\ntime_limit: %d\n"
                 "map: {x: time.step, y: young_over_density, panel: name}\n",
                 stiffnesses[choice->quick], steps[choice->quick], TIME_LIMIT);
    st = output_close(out, why);
out:
    return st;
}

enum status stress_map_measure(const char *folder, const struct stress_choice *choice,
                               int jobs, struct message *why)
{
    char map[SWEEP_FOLDER_PATH], path[SWEEP_FOLDER_PATH];
    struct plan plan = {0};
    enum status st;

    snprintf(map, sizeof map, "%s/map", folder);
    snprintf(path, sizeof path, "%s/map/plan.yaml", folder);
    TRY(folder_make(map, why));
    TRY(write_plan(path, choice, why));
    TRY(plan_read(path, &plan, why));
    st = sweep_run(&plan,
                   &(struct sweep_options){
                       .folder = map, .start = SWEEP_AGAIN, .jobs = jobs, .quiet = true},
                   why);
out:
    plan_clear(&plan);
    return st;
}

/* What is drawn and printed of a map. */
struct map {
    struct plan plan;
    struct sweep_folder folder;
    int stiffnesses, steps;
    struct run_result reference; /* with fields: that of the finest step               */
    double moved[TIMES];         /* by the reference [m] */
    bool lost;                   /* nobody knows the reference any more                */
    struct sweep_map *picture;
    struct table *models, *spots; /* a row a model, a row a case                       */
    int unknown;                  /* cases whose file is damaged or missing            */
};

static const char *value_of(const struct map *m, int axis, int n)
{
    return m->plan.axes[axis].values.list[n].value;
}

static void create_tables(struct map *m)
{
    static const struct table_column spots[] = {
        {"model"},
        {"young_over_density", "m^2/s^2", .key = "young_over_density"},
        {"step", "s", .key = "step"},
        {"end"},
        {"error"}};
    struct table_column columns[1 + 16 + ENDS] = {{"step [s] by E/rho", NULL, TABLE_LEFT}};
    int count = 1;

    for (int e = 0; e < m->stiffnesses; e++)
        columns[count++] = (struct table_column){value_of(m, 0, e), NULL, TABLE_RIGHT};
    for (int n = 0; n < ENDS; n++)
        columns[count++] = (struct table_column){stress_end_name[n], NULL, TABLE_RIGHT};
    m->models = table_create(
        count, columns,
        "Stability: the largest step up to which all steps tried are accurate");
    m->spots = table_create(sizeof spots / sizeof *spots, spots, NULL);
}

/* *there is false where no map was made. */
static enum status open_map(struct map *m, const char *folder, bool *there,
                            struct message *why)
{
    char path[SWEEP_FOLDER_PATH];
    enum status st = STATUS_OK;

    *m = (struct map){.folder = {.lock = -1, .log = -1}};
    snprintf(m->folder.path, sizeof m->folder.path, "%s/map", folder);
    snprintf(path, sizeof path, "%s/map/plan.yaml", folder);
    *there = access(path, R_OK) == 0;
    if (!*there)
        return st;
    TRY(plan_read(path, &m->plan, why));
    TRY(sweep_map_create(&m->picture, &m->plan, "accurate"));
    m->stiffnesses = m->plan.axes[0].values.count;
    m->steps = m->plan.axes[1].values.count;
    create_tables(m);
out:
    return st;
}

static void clear_map(struct map *m)
{
    plan_clear(&m->plan);
    run_result_clear(&m->reference);
    sweep_map_destroy(m->picture);
    table_destroy(m->models);
    table_destroy(m->spots);
}

/* How far the run with the finest step has moved. */
static enum status find_moved(struct map *m, const char *path, struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    double *rest = NULL;
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    rest = metric_rest_field(&scene);
    TRY(rest ? STATUS_OK : STATUS_MEMORY);
    for (int k = 0; k < TIMES; k++)
        m->moved[k] = metric_rmse(m->reference.xyz[k], rest);
out:
    store_read_close(file);
    scene_clear(&scene);
    free(rest);
    return st;
}

/* The worst of the times; NaN without a reference. */
static double worst(const struct map *m, const struct run_result *r)
{
    double error = m->reference.xyz ? 0 : NAN;

    for (int k = 0; m->reference.xyz && k < TIMES; k++) {
        const double at = metric_rmse(r->xyz[k], m->reference.xyz[k]) / m->moved[k];
        if (!(at <= error))
            error = at;
    }
    return error;
}

/* *label: how the case ended; *end: the same, STRESS_ENDS: nobody knows. */
static enum status judge(struct map *m, long number, struct sweep_row *row,
                         enum stress_end *end, const char **label, double *error,
                         struct message *why)
{
    const bool finest = number % m->steps == 0;
    char path[SWEEP_FOLDER_PATH];
    enum status st = STATUS_OK;

    sweep_folder_file(&m->folder, number, "h5", path);
    TRY(sweep_row_read(&m->folder, number, NULL, true, row));
    const bool open = sweep_row_is_open(row), refused = run_result_refused(&row->result);
    const bool ran = row->state == SWEEP_ROW_RAN && row->result.outcome == STATUS_OK;
    if (finest) {
        run_result_clear(&m->reference);
        m->lost = open;
        if (ran) {
            HAND_OVER(&m->reference, row->result);
            TRY(find_moved(m, path, why));
        }
    }
    *error = ran ? worst(m, finest ? &m->reference : &row->result) : NAN;
    *end = open || (ran && m->lost) ? STRESS_ENDS
           : refused                ? STRESS_REFUSED
           : !ran                   ? STRESS_DIED
           : *error <= bound        ? STRESS_ACCURATE
                                    : STRESS_DEGRADED;
    *label = finest && ran                     ? "reference"
             : *end != STRESS_ENDS             ? stress_end_name[*end]
             : row->state == SWEEP_ROW_DAMAGED ? "damaged"
             : ran                             ? "not judged"
                                               : "not run";
out:
    return st;
}

/* A case, onto the map and into the table of spots. */
static enum status add_case(struct map *m, int model, int stiffness, int step,
                            enum stress_end *end, struct message *why)
{
    const long number = ((long)model * m->stiffnesses + stiffness) * m->steps + step;
    struct plan_case c = {0};
    struct sweep_row row = {0};
    const char *label;
    double error;
    enum status st;

    TRY(judge(m, number, &row, end, &label, &error, why));
    TRY(plan_case_given(&m->plan, number, &c));
    TRY(sweep_map_row(m->picture, &c, &row, label, false));
    table_row(m->spots);
    table_text(m->spots, "%s", m->plan.listed[model].name);
    table_text(m->spots, "%s", value_of(m, 0, stiffness));
    table_text(m->spots, "%s", value_of(m, 1, step));
    table_text(m->spots, "%s", label);
    table_number(m->spots, error, 3);
out:
    plan_case_clear(&c);
    run_result_clear(&row.result);
    return st;
}

/* By stiffness the largest step up to which all are accurate, and how many ended how. */
static enum status add_model(struct map *m, int model, struct message *why)
{
    int count[STRESS_ENDS + 1] = {0};
    enum stress_end end;
    enum status st = STATUS_OK;

    table_row(m->models);
    table_text(m->models, "%s", m->plan.listed[model].name);
    for (int e = 0; e < m->stiffnesses; e++) {
        int good = 0; /* steps before the first that is not                            */
        for (int n = 0; n < m->steps; n++) {
            TRY(add_case(m, model, e, n, &end, why));
            count[end]++;
            good += good == n && end == STRESS_ACCURATE;
        }
        table_text(m->models, "%s", good ? value_of(m, 1, good - 1) : "none");
    }
    for (int n = 0; n < ENDS; n++)
        table_integer(m->models, count[n]);
    m->unknown += count[STRESS_ENDS];
out:
    return st;
}

enum status stress_map_print(const char *folder, enum table_format format, FILE *file,
                             bool *there, struct message *why)
{
    struct map m;
    struct chart *chart = NULL;
    enum status st;

    TRY(open_map(&m, folder, there, why));
    if (!*there)
        goto out;
    for (int n = 0; n < m.plan.listed_count; n++)
        TRY(add_model(&m, n, why));
    TRY(table_save(m.spots, m.folder.path, "stability", why));
    TRY(sweep_map_chart(m.picture, &chart, why));
    TRY(chart_save(chart, m.folder.path, "map", why));
    table_note(
        m.models,
        "A sheet of 1 m x 1 m x 1 cm let go, at the worst of 0.1, 0.2 and 0.3 s, %d x %d "
        "points. E/rho in m^2/s^2. Accurate: within %g of how far the sheet has moved, "
        "from the run of the same model with the finest step (%s s), which is counted as "
        "accurate; what lives where that has died is degraded.",
        SIDE, SIDE, bound, value_of(&m, 1, 0));
    if (strstr(m.plan.source, QUICK))
        table_note(m.models, "Quick: %d steps by %d stiffnesses; the whole map has 7 by 7.",
                   m.steps, m.stiffnesses);
    if (m.unknown)
        table_note(
            m.models,
            "No result of %d cases: their files, or those of their finest steps, are "
            "damaged or gone, or they were cut short. Run the map again.",
            m.unknown);
    if (file)
        st = table_print(m.models, format, file);
out:
    clear_map(&m);
    return st;
}
