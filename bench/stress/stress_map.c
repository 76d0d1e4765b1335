/* The stability map of `stress`: which step serves which stiffness, model by model. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/store_scene.h"
#include "bench/stress/stress.h"
#include "bench/sweep/sweep.h"
#include "bench/sweep/sweep_map.h"
#include "bench/experiment/plan_read.h"
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
enum { SIDE = 6, TIME_LIMIT = 600, TIMES = 3 };

static void path_of(const char *folder, const char *name, char *path, int size)
{
    snprintf(path, (size_t)size, "%s/map%s%s", folder, *name ? "/" : "", name);
}

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
        "source: clothbench stress\n"
        "scene: %s\n"
        "settings: {sheet.thickness: 0.01, time.end: 0.3, snapshots: [0.1, 0.2, 0.3]}\n"
        "cases:\n",
        stress_case_scene);
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
    char path[SWEEP_FOLDER_PATH];
    struct plan plan = {0};
    enum status st;

    path_of(folder, "", path, sizeof path);
    TRY(folder_make(path, why));
    path_of(folder, "plan.yaml", path, sizeof path);
    TRY(write_plan(path, choice, why));
    TRY(plan_read(path, &plan, why));
    path_of(folder, "", path, sizeof path);
    st = sweep_run(&plan,
                   &(struct sweep_options){
                       .folder = path, .start = SWEEP_AGAIN, .jobs = jobs, .quiet = true},
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
    struct run_result reference; /* with fields: that of the finest step               */
    double moved[TIMES];         /* by the reference [m] */
};

static void clear_map(struct map *m)
{
    plan_clear(&m->plan);
    run_result_clear(&m->reference);
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
out:
    return st;
}

/* Takes the run with the finest step over. */
static enum status set_reference(struct map *m, struct run_result *r, const char *path,
                                 struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    double *rest = NULL;
    enum status st;

    m->reference = *r;
    *r = (struct run_result){0};
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

static enum status judge(struct map *m, long number, const struct sweep_row *row,
                         struct spot *spot, struct message *why)
{
    const bool refused = run_result_refused(&row->result);
    const bool finest = number % m->steps == 0;
    char path[SWEEP_FOLDER_PATH];
    struct run_result r = {0};
    enum status st = STATUS_OK;

    *spot = (struct spot){.end = refused ? STRESS_REFUSED : STRESS_DIED, .error = NAN};
    if (finest)
        run_result_clear(&m->reference);
    if (!row->ran || row->result.outcome != STATUS_OK)
        return STATUS_OK;
    sweep_folder_file(&m->folder, number, "h5", path);
    TRY(run_result_read(path, true, &r, why));
    if (finest)
        TRY(set_reference(m, &r, path, why));
    spot->reference = finest;
    spot->error = worst(m, finest ? &m->reference : &r);
    spot->end = spot->error <= bound ? STRESS_ACCURATE : STRESS_DEGRADED;
out:
    run_result_clear(&r);
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

/* Of each case a spot. */
static struct table *make_spots(void)
{
    static const struct table_column columns[] = {
        {"model"},
        {"young_over_density", "m^2/s^2", .key = "young_over_density"},
        {"step", "s", .key = "step"},
        {"end"},
        {"error"}};

    return table_create(sizeof columns / sizeof *columns, columns, NULL);
}

/* What is drawn and printed of a map. */
struct shown {
    struct sweep_map *map;
    struct table *steps, *spots;
};

/* A case: onto the map, into the tables. */
static enum status add_case(struct map *m, int model, int n, struct shown *to,
                            struct summary *s, struct message *why)
{
    const long number = (long)model * m->stiffnesses * m->steps + n;
    struct plan_case c = {0};
    struct sweep_row row;
    struct spot spot;
    enum status st;

    sweep_folder_read(&m->folder, number, false, &row);
    TRY(judge(m, number, &row, &spot, why));
    const char *label = spot.reference ? "reference" : stress_end_name(spot.end);
    note(s, n / m->steps, n % m->steps, &spot);
    TRY(plan_case_given(&m->plan, number, &c));
    TRY(sweep_map_row(to->map, &c, &row, label));
    table_row(to->spots);
    table_text(to->spots, "%s", m->plan.listed[model].name);
    table_text(to->spots, "%s", m->plan.axes[0].values.list[n / m->steps].value);
    table_text(to->spots, "%s", m->plan.axes[1].values.list[n % m->steps].value);
    table_text(to->spots, "%s", label);
    table_number(to->spots, spot.error, 3);
out:
    plan_case_clear(&c);
    run_result_clear(&row.result);
    return st;
}

static enum status add_model(struct map *m, int model, struct shown *to,
                             struct message *why)
{
    struct summary s = {{0}, {0}, {0}};
    enum status st = STATUS_OK;

    for (int e = 0; e < 16; e++)
        s.largest[e] = -1;
    for (int n = 0; n < m->stiffnesses * m->steps; n++)
        TRY(add_case(m, model, n, to, &s, why));
    print_model(to->steps, m, model, &s);
out:
    return st;
}

static enum status show(struct map *m, struct shown *to, struct message *why)
{
    struct chart *chart = NULL;
    enum status st;

    TRY(sweep_map_create(&to->map, &m->plan, "accurate"));
    for (int n = 0; n < m->models; n++)
        TRY(add_model(m, n, to, why));
    TRY(table_save(to->spots, m->folder.path, "stability", why));
    TRY(sweep_map_chart(to->map, &chart, why));
    st = chart_save(chart, m->folder.path, "map", why);
out:
    sweep_map_destroy(to->map);
    return st;
}

enum status stress_map_print(const char *folder, enum table_format format, FILE *file,
                             bool *there, struct message *why)
{
    struct map m;
    struct shown shown = {NULL};
    enum status st;

    TRY(open_map(&m, folder, there, why));
    if (!*there)
        goto out;
    shown.steps = make_table(&m);
    shown.spots = make_spots();
    TRY(show(&m, &shown, why));
    table_note(
        shown.steps,
        "A sheet of 1 m x 1 m x 1 cm let go, at the worst of 0.1, 0.2 and 0.3 s, %d x %d "
        "points. E/rho in "
        "m^2/s^2. Accurate: within %g of how far the sheet has moved, from the run of "
        "the same model with the finest step (%s s), which is counted as accurate; what "
        "lives where that has died is degraded.",
        SIDE, SIDE, bound, m.plan.axes[1].values.list[0].value);
    if (file)
        st = table_print(shown.steps, format, file);
out:
    table_destroy(shown.steps);
    table_destroy(shown.spots);
    clear_map(&m);
    return st;
}
