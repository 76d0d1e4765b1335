/* Draws the stability map of `stress`: which step serves which stiffness, model by model.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/experiment/plan.h"
#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/stress/stress.h"
#include "bench/sweep/sweep.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* A sheet of 1 m x 1 m x 1 cm let go for 0.3 s. Each run is held against that of the same
 * model, net and stiffness with the finest step, which tells the step's part alone: as a
 * share of how far the sheet has moved, at the worst of 0.1, 0.2 and 0.3 s; a twentieth can
 * just be seen. */
static const double bound = 0.05;

static const char *const steps[] = {"[1e-4, 5e-4, 2e-3, 5e-3, 0.02, 0.05, 0.1]",
                                    "[1e-3, 0.01, 0.1]"};
static const char *const stiffnesses[] = {"[1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9]",
                                          "[1e4, 1e6, 1e8]"};
#define QUICK " --quick" /* in the source of the map's plan */
enum { SIDE = 6, TIME_LIMIT = 600, TIMES = 3 };

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

/* --- judging ----------------------------------------------------------------------------
 */

/* The map that lies in a folder. */
struct map {
    struct plan plan;
    struct sweep_folder folder;
    struct sweep_rows rows;   /* with the labels of the map                              */
    double *rest;             /* the sheet at rest (grid.h) [m]                    owned */
    struct run_result finest; /* with fields: of the finest step; empty: it died       */
    double moved[TIMES];      /* by it [m]                                             */
    bool lost;                /* nobody knows the run with the finest step any more    */
    struct table *models, *spots; /* a row a model, a row a case                       */
    int unknown;                  /* cases whose file is damaged or missing            */
};

static const struct plan_settings *values_of(const struct map *m, int axis)
{
    return &m->plan.axes[axis].values;
}

/* Replaces the run with the finest step. */
static void take_finest(struct map *m, enum sweep_state state, struct run_result *r)
{
    m->lost = state == SWEEP_GONE || state == SWEEP_DAMAGED || state == SWEEP_CUT;
    run_result_clear(&m->finest);
    if (state != SWEEP_RAN || r->outcome != STATUS_OK)
        return;
    HAND_OVER(&m->finest, *r);
    for (int k = 0; k < TIMES; k++)
        m->moved[k] = metric_rmse(m->finest.xyz[k], m->rest);
}

/* Returns the error of a run at the worst of the times; NaN without the finest step. */
static double worst(const struct map *m, const struct run_result *r)
{
    double error = m->finest.xyz ? 0 : NAN;

    for (int k = 0; m->finest.xyz && k < TIMES; k++) {
        const double at = metric_rmse(r->xyz[k], m->finest.xyz[k]) / m->moved[k];
        if (!(at <= error))
            error = at;
    }
    return error;
}

/* Reads and labels a case; *end: how it ended, STRESS_ENDS: nobody knows. */
static enum status judge(struct map *m, long number, enum stress_end *end, double *error)
{
    const bool finest = number % values_of(m, 1)->count == 0;
    struct run_result r;
    struct message sentence;
    enum sweep_state state;
    enum status st;

    TRY(sweep_folder_read(&m->folder, number, NULL, true, &state, &r, &sentence));
    TRY(sweep_rows_set(&m->rows, number, state, &r, sentence.text));
    const bool open = sweep_rows_open(&m->rows, number), refused = run_result_refused(&r);
    const bool ran = state == SWEEP_RAN && r.outcome == STATUS_OK;
    if (finest)
        take_finest(m, state, &r);
    *error = ran ? worst(m, finest ? &m->finest : &r) : NAN;
    *end = open || (ran && m->lost) ? STRESS_ENDS
           : refused                ? STRESS_REFUSED
           : !ran                   ? STRESS_DIED
           : *error <= bound        ? STRESS_ACCURATE
                                    : STRESS_DEGRADED;
    st = sweep_rows_label(&m->rows, number,
                          finest && ran            ? "reference"
                          : *end != STRESS_ENDS    ? stress_end_name[*end]
                          : state == SWEEP_DAMAGED ? "damaged"
                          : ran                    ? "not judged"
                                                   : "not run");
out:
    run_result_clear(&r);
    return st;
}

/* --- tables -----------------------------------------------------------------------------
 */

static void create_tables(struct map *m)
{
    static const struct table_column spots[] = {
        {"model"},
        {"young_over_density", "m^2/s^2", .key = "young_over_density"},
        {"step", "s", .key = "step"},
        {"end"},
        {"error"}};
    struct table_column columns[1 + 16 + STRESS_ENDS] = {
        {"step [s] by E/rho", NULL, TABLE_LEFT}};
    int count = 1;

    for (int e = 0; e < values_of(m, 0)->count; e++)
        columns[count++] = (struct table_column){values_of(m, 0)->list[e].value};
    for (int n = 0; n < STRESS_ENDS; n++)
        columns[count++] = (struct table_column){stress_end_name[n]};
    m->models = table_create(
        count, columns,
        "Stability: the largest step up to which all steps tried are accurate");
    m->spots = table_create(sizeof spots / sizeof *spots, spots, NULL);
}

/* Adds a model's cases, by stiffness the largest step up to which all are accurate, and how
 * many ended how. */
static enum status add_model(struct map *m, int model)
{
    const struct plan_settings *stiffness = values_of(m, 0), *step = values_of(m, 1);
    const char *name = m->plan.listed[model].name;
    long number = (long)model * stiffness->count * step->count;
    int count[STRESS_ENDS + 1] = {0};
    enum stress_end end;
    double error;
    enum status st = STATUS_OK;

    table_row(m->models);
    table_text(m->models, "%s", name);
    for (int e = 0; e < stiffness->count; e++) {
        int good = 0; /* steps before the first that is not                            */
        for (int n = 0; n < step->count; n++, number++) {
            TRY(judge(m, number, &end, &error));
            count[end]++;
            good += good == n && end == STRESS_ACCURATE;
            table_row(m->spots);
            table_text(m->spots, "%s", name);
            table_text(m->spots, "%s", stiffness->list[e].value);
            table_text(m->spots, "%s", step->list[n].value);
            table_text(m->spots, "%s", m->rows.row[number].label);
            table_number(m->spots, error, 3);
        }
        table_text(m->models, "%s", good ? step->list[good - 1].value : "none");
    }
    for (int n = 0; n < STRESS_ENDS; n++)
        table_integer(m->models, count[n]);
    m->unknown += count[STRESS_ENDS];
out:
    return st;
}

static void add_notes(const struct map *m)
{
    table_note(
        m->models,
        "A sheet of 1 m x 1 m x 1 cm let go, at the worst of 0.1, 0.2 and 0.3 s, %d x %d "
        "points. E/rho in m^2/s^2. Accurate: within %g of how far the sheet has moved, "
        "from the run of the same model with the finest step (%s s), which is counted as "
        "accurate; what lives where that has died is degraded.",
        SIDE, SIDE, bound, values_of(m, 1)->list[0].value);
    if (strstr(m->plan.source, QUICK))
        table_note(m->models,
                   "Quick: %d steps by %d stiffnesses; the whole map has 7 by 7.",
                   values_of(m, 1)->count, values_of(m, 0)->count);
    if (m->unknown)
        table_note(
            m->models,
            "No result of %d cases: their files, or those of their finest steps, are "
            "damaged or gone, or they were cut short. Run the map again.",
            m->unknown);
}

static enum status open_map(struct map *m, const char *path, struct message *why)
{
    const struct plan_settings none = {0};
    struct scene scene = {0};
    enum status st;

    TRY(plan_read(path, &m->plan, why));
    TRY(sweep_rows_init(&m->rows, &m->plan));
    TRY(plan_case_mark(&m->plan, &none, &scene, why)); /* all have the same sheet */
    m->rest = metric_rest_field(&scene);
    TRY(m->rest ? STATUS_OK : STATUS_MEMORY);
    create_tables(m);
out:
    scene_clear(&scene);
    return st;
}

static void clear_map(struct map *m)
{
    sweep_rows_clear(&m->rows);
    plan_clear(&m->plan);
    run_result_clear(&m->finest);
    table_destroy(m->models);
    table_destroy(m->spots);
    free(m->rest);
}

enum status stress_map_print(const char *folder, enum table_format format, FILE *file,
                             bool *there, struct message *why)
{
    struct map m = {.folder = {.lock = -1, .log = -1}};
    struct chart *chart = NULL;
    char path[SWEEP_FOLDER_PATH];
    enum status st;

    snprintf(m.folder.path, sizeof m.folder.path, "%s/map", folder);
    snprintf(path, sizeof path, "%s/map/plan.yaml", folder);
    *there = access(path, R_OK) == 0;
    if (!*there)
        return STATUS_OK;
    TRY(open_map(&m, path, why));
    for (int n = 0; n < m.plan.listed_count; n++)
        TRY(add_model(&m, n));
    TRY(table_save(m.spots, m.folder.path, "stability", why));
    TRY(sweep_map(&m.rows, "accurate", &chart, why));
    TRY(chart_save(chart, m.folder.path, "map", why));
    add_notes(&m);
    if (file)
        st = table_print(m.models, format, file);
out:
    clear_map(&m);
    return st;
}
