#include "bench/experiment/timed.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/files/store.h"
#include "bench/harness/oldtiming.h"
#include "models/grid.h"
#include "models/metric/metric.h"

/* At least nine repeats (fair timing). A solid's frame costs the same all along the motion,
 * so twenty frames a repeat do; where it does not, a case says how many it takes. */
enum { REPEATS = 9, FRAMES = 20, QUICK_REPEATS = 3, QUICK_FRAMES = 5, WARMUP = 2 };

/* Share of the processor below which a machine counts as busy. */
static const double ENOUGH = 0.95;

static const char *const phase_name[BENCH_SOLID_FRAME] = {"assemble", "factor", "solve"};

/* One state on its way, sampled: what is stored of it. */
static enum status keep(struct timed_case *c, void *state, double t,
                        const struct counters *counters, const double *xyz,
                        struct message *why)
{
    struct energy energy;

    if (c->model->energy)
        c->model->energy(state, &energy);
    return store_frame(c->store, t, xyz, c->model->energy ? &energy : NULL, counters, why);
}

static enum status follow(struct timed_case *c, void *state, double *xyz,
                          struct message *why)
{
    struct counters counters = {0};
    enum status st = STATUS_OK;
    int frame = 0;

    if (!c->times) {
        TRY(c->model->equilibrium(state, &counters, why));
        c->model->sample(state, xyz);
        TRY(keep(c, state, 0, &counters, xyz, why));
    }
    for (int n = 0; n < c->times; n++) {
        for (; st == STATUS_OK && frame < lround(c->time[n] / c->scene->step); frame++)
            st = c->model->advance(state, &counters);
        c->model->sample(state, xyz);
        if (st == STATUS_OK)
            st = metric_blowup(c->scene, xyz);
        if (status_is_death(st)) {
            store_death(c->store, st, frame * c->scene->step);
            return STATUS_OK;
        }
        TRY(st);
        TRY(keep(c, state, c->time[n], &counters, xyz, why));
    }
out:
    return st;
}

/* NAME.txt beside NAME.h5. */
static void sentence_path(const char *path, char text[TIMED_PATH])
{
    snprintf(text, TIMED_PATH, "%.*s.txt", (int)(strlen(path) - strlen(".h5")), path);
}

enum status timed_refuse(const char *path, const char *sentence, struct message *why)
{
    struct output *out = NULL;
    char text[TIMED_PATH];
    enum status st;

    sentence_path(path, text);
    TRY(output_create(text, &out, why));
    output_print(out, "%s\n", sentence);
    TRY(output_close(out, why));
    remove(path); /* of an earlier run */
out:
    return st;
}

static enum status open_case(struct timed_case *c, const struct provenance *provenance,
                             double *xyz, struct message *why)
{
    struct store_run what = {.scene = c->scene,
                             .model = c->model,
                             .discretization = &c->d,
                             .provenance = provenance,
                             .single = true};
    struct model_size size;
    struct message sentence = {""};
    void *state = NULL;
    char path[TIMED_PATH];
    enum status st = c->model->create(c->scene, &c->d, &state, &sentence);

    if (st == STATUS_UNSUPPORTED)
        return timed_refuse(c->path, sentence.text, why);
    if (st != STATUS_OK)
        return status_fail(why, st, "%s", sentence.text);
    sentence_path(c->path, path);
    remove(path);
    TRY(store_create(c->path, &what, &c->store, why));
    c->model->size(state, &size);
    TRY(store_size(c->store, &size, why));
    TRY(follow(c, state, xyz, why));
out:
    c->model->destroy(state);
    return st;
}

struct reporter {
    const struct experiment_options *options;
    const char *what;
};

static void report(void *context, int done, int total)
{
    const struct reporter *r = context;

    experiment_progress(r->options, r->what, done, total);
}

static enum status time_phases(struct timed_case *c, int repeats, struct message *why)
{
    double seconds[REPEATS];
    struct counters counters = {0};
    void *state = NULL;
    enum status st = c->model->create(c->scene, &c->d, &state, why);

    for (int n = 0; n < WARMUP && st == STATUS_OK; n++)
        st = c->model->advance(state, &counters);
    for (int p = 0; p < BENCH_SOLID_FRAME && st == STATUS_OK; p++) {
        st = bench_solid_time(c->model, state, p, repeats, seconds);
        if (st == STATUS_OK)
            st = store_seconds(c->store, phase_name[p], seconds, repeats, 0, why);
    }
    c->model->destroy(state);
    return status_is_death(st) ? STATUS_OK : st;
}

static bool is_timed(const struct timed_case *c)
{
    return c->store && (c->times || c->rest);
}

static enum status time_cases(const struct oldtiming_plan *plan, int count,
                              struct timed_case *cases, struct message *why)
{
    assert(count > 0);
    struct oldtiming_case *timing = calloc((size_t)count, sizeof *timing);
    enum status st = timing ? STATUS_OK : STATUS_MEMORY;
    int timed = 0;

    TRY(st);
    for (int n = 0; n < count; n++)
        if (is_timed(&cases[n]))
            timing[timed++] = (struct oldtiming_case){.model = cases[n].model,
                                                      .scene = cases[n].scene,
                                                      .discretization = &cases[n].d,
                                                      .frames = cases[n].frames,
                                                      .rest = cases[n].rest};
    double start = clock_now(), processor = clock_processor();
    TRY(oldtiming_run(plan, timed, timing, why));
    double all = clock_now() - start, ours = clock_processor() - processor;
    for (int n = 0, k = 0; n < count; n++) {
        if (!is_timed(&cases[n]))
            continue;
        TRY(store_seconds(cases[n].store, "create", timing[k].create, plan->repeats, 0,
                          why));
        TRY(store_seconds(cases[n].store, cases[n].rest ? "equilibrium" : "advance",
                          timing[k].advance, plan->repeats, timing[k].frames, why));
        TRY(store_seconds(cases[n].store, "timed", &all, 1, 0, why));
        TRY(store_seconds(cases[n].store, "processor", &ours, 1, 0, why));
        if (cases[n].phases)
            TRY(time_phases(&cases[n], plan->repeats, why));
        k++;
    }
out:
    for (int k = 0; k < timed; k++)
        oldtiming_clear(&timing[k]);
    free(timing);
    return st;
}

enum status timed_measure(const struct experiment_options *options, const char *what,
                          const struct provenance *provenance, int count,
                          struct timed_case *cases, struct message *why)
{
    assert(options->repeats >= 0 && options->repeats <= REPEATS);
    struct reporter reporter = {options, what};
    int usual = options->quick ? QUICK_REPEATS : REPEATS;
    struct oldtiming_plan plan = {.repeats = options->repeats ? options->repeats : usual,
                                  .warmup = WARMUP,
                                  .frames = options->quick ? QUICK_FRAMES : FRAMES,
                                  .progress = report,
                                  .context = &reporter};
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    enum status st = xyz ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < count; n++)
        if (cases[n].scene)
            TRY(open_case(&cases[n], provenance, xyz, why));
    TRY(time_cases(&plan, count, cases, why));
    for (int n = 0; n < count; n++) {
        struct store *store = cases[n].store;
        cases[n].store = NULL;
        if (store)
            TRY(store_close(store, why));
    }
out:
    for (int n = 0; n < count; n++) {
        store_discard(cases[n].store);
        cases[n].store = NULL;
    }
    free(xyz);
    return st;
}

enum status timed_seconds(const struct store_read *file, const char *name,
                          struct clock_summary *summary, struct message *why)
{
    enum status st;
    double *seconds = NULL;
    int rows, columns, repeats = 0;
    char path[64];

    snprintf(path, sizeof path, "seconds/%s", name);
    if (!store_read_has(file, path))
        return STATUS_OK;
    TRY(store_read_array(file, path, &seconds, &rows, &columns, why));
    for (int r = 0; r < rows; r++) {
        double sum = 0;
        int frames = 0;
        for (int n = 0; n < columns; n++)
            if (!isnan(seconds[r * columns + n])) {
                sum += seconds[r * columns + n];
                frames++;
            }
        if (frames)
            seconds[repeats++] = sum / frames;
    }
    if (repeats)
        *summary = clock_summarise(seconds, repeats);
out:
    free(seconds);
    return st;
}

static enum status read_refusal(const char *path, struct timed_result *r)
{
    char text[TIMED_PATH], line[512] = "";
    FILE *file;

    sentence_path(path, text);
    file = fopen(text, "r");
    if (!file)
        return STATUS_FILE;
    if (fgets(line, sizeof line, file))
        line[strcspn(line, "\n")] = '\0';
    fclose(file);
    r->refused = strdup(line);
    return r->refused ? STATUS_OK : STATUS_MEMORY;
}

static enum status read_work(const struct store_read *file, struct counters *work,
                             struct message *why)
{
    const struct {
        const char *name;
        long *count;
    } counters[] = {{"counters/steps", &work->steps},
                    {"counters/assemblies", &work->assemblies},
                    {"counters/factorisations", &work->factorisations},
                    {"counters/solves", &work->solves},
                    {"counters/iterations", &work->iterations}};
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof counters / sizeof *counters; n++) {
        double *value = NULL;
        int rows, columns;
        st = store_read_array(file, counters[n].name, &value, &rows, &columns, why);
        if (st != STATUS_OK)
            return st;
        *counters[n].count = rows ? lround(value[rows - 1]) : 0;
        free(value);
    }
    return st;
}

static enum status read_outcome(const struct store_read *file, char **outcome,
                                struct message *why)
{
    static const char format[] = "%s at %.6g s";
    char *sentence = NULL;
    double time;
    enum status st;

    TRY(store_read_text(file, "/", "outcome", &sentence, why));
    if (!strcmp(sentence, "done")) {
        *outcome = sentence;
        return STATUS_OK;
    }
    TRY(store_read_number(file, "death_time", &time, why));
    int size = snprintf(NULL, 0, format, sentence, time) + 1;
    *outcome = malloc((size_t)size);
    if (!*outcome)
        TRY(STATUS_MEMORY);
    snprintf(*outcome, (size_t)size, format, sentence, time);
out:
    free(sentence);
    return st;
}

enum status timed_read(const char *path, struct timed_result *r, struct message *why)
{
    struct store_read *file = NULL;
    struct timed_result new = {0};
    enum status st = read_refusal(path, &new);

    if (st != STATUS_FILE) {
        *r = new;
        return st;
    }
    TRY(store_read_open(path, &file, why));
    TRY(store_read_number(file, "unknowns", &new.unknowns, why));
    TRY(store_read_number(file, "factor_entries", &new.factor_entries, why));
    TRY(read_outcome(file, &new.outcome, why));
    TRY(read_work(file, &new.work, why));
    TRY(timed_seconds(file, "create", &new.create, why));
    TRY(timed_seconds(file, "advance", &new.step, why));
    TRY(timed_seconds(file, "equilibrium", &new.step, why));
    for (int p = 0; p < BENCH_SOLID_FRAME; p++)
        TRY(timed_seconds(file, phase_name[p], &new.phase[p], why));
    *r = new;
    memset(&new, 0, sizeof new);
out:
    timed_clear(&new);
    store_read_close(file);
    return st;
}

void timed_clear(struct timed_result *r)
{
    free(r->refused);
    free(r->outcome);
    memset(r, 0, sizeof *r);
}

/* Milliseconds of a busy machine are too long; a reader should know. */
static void tell_share(const struct store_read *run, FILE *file)
{
    struct clock_summary all = {0}, ours = {0};

    if (timed_seconds(run, "timed", &all, NULL) != STATUS_OK ||
        timed_seconds(run, "processor", &ours, NULL) != STATUS_OK || !all.count ||
        !ours.count)
        return;
    fprintf(file, "; a processor for %.0f %% of the time", 100 * ours.median / all.median);
    if (ours.median < ENOUGH * all.median)
        fprintf(file, ": the machine was busy, the milliseconds are too long");
}

void timed_machine(const char *path, FILE *file)
{
    static const char *const keys[] = {
        "commit",      "changed_files", "compiler",    "flags",        "cpu",
        "blas_kernel", "cholmod",       "omp_threads", "blas_threads", "date"};
    struct store_read *run = NULL;

    if (store_read_open(path, &run, NULL) != STATUS_OK)
        return;
    fprintf(file, "\nMeasured:");
    for (size_t n = 0; n < sizeof keys / sizeof *keys; n++) {
        char *text = NULL;
        if (store_read_text(run, "provenance", keys[n], &text, NULL) == STATUS_OK)
            fprintf(file, "%s%s %s", n ? "; " : " ", keys[n], text);
        free(text);
    }
    tell_share(run, file);
    fprintf(file, "\n");
    store_read_close(run);
}
