#include "bench/run/run_command.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "bench/run/describe.h"
#include "bench/run/matrices.h"
#include "bench/run/probe.h"
#include "bench/harness/record.h"
#include "bench/harness/registry.h"
#include "bench/run/rest.h"
#include "models/clock.h"
#include "models/reader/scene_file.h"

enum task { TASK_MOTION, TASK_STATIC, TASK_MODES };

enum { MODES_MOST = 1000 };

struct run {
    enum task task;
    bool settled; /* modes are those about static equilibrium */
    bool quiet;
    long mode_count;
    long every; /* frames: which of them a file keeps */
    enum table_format format;
    const struct model *model;
    struct scene scene;
    struct discretization discretization;
    struct provenance provenance;
    struct probe probe;
    struct record *record; /* NULL: nothing is kept */
    void *state;
    double create_seconds;
};

static enum status read_options(struct run *r, const struct command_line *line,
                                struct message *why)
{
    enum status st = STATUS_OK;
    const char *name = command_value(line, "--model");
    const char *format = command_value(line, "--format");
    int count;
    const char *const *points = command_values(line, "--probe", &count);

    r->quiet = command_given(line, "--quiet");
    if (command_given(line, "--static"))
        r->task = TASK_STATIC;
    if (command_given(line, "--modes")) {
        r->settled = r->task == TASK_STATIC;
        r->task = TASK_MODES;
        TRY(command_integer(line, "--modes", 1, MODES_MOST, &r->mode_count, why));
    }
    r->every = 1;
    TRY(command_integer(line, "--every", 1, INT_MAX, &r->every, why));
    if (command_given(line, "--every") &&
        (r->task != TASK_MOTION || !command_given(line, "--out")))
        TRY(status_fail(why, STATUS_INPUT,
                        "--every is for the frames of a motion that --out keeps"));
    if (r->task == TASK_MODES && (count || command_given(line, "--out")))
        TRY(status_fail(why, STATUS_INPUT, "--modes has no positions: %s makes no sense",
                        count ? "--probe" : "--out"));
    if (format && r->task == TASK_MOTION)
        TRY(status_fail(why, STATUS_INPUT,
                        "--format is for the tables of --static and --modes"));
    if (format)
        TRY(table_format_parse(format, &r->format, why));
    TRY(registry_find(name ? name : registry[0]->name, &r->model, why));
    TRY(probe_init(&r->probe, count, points, why));
out:
    return st;
}

/* Scene and settings. Statics and modes of solids are linear unless the user says
 * otherwise: the setting comes first, later ones win. */
static enum status read_scene(struct run *r, const struct command_line *line,
                              struct message *why)
{
    enum status st = STATUS_OK;
    int given;
    const char *const *set = command_values(line, "--set", &given);
    const char **settings = malloc((size_t)(given + 1) * sizeof *settings);
    int count = 0;
    char *path = NULL;

    if (!settings)
        return STATUS_MEMORY;
    r->model->defaults(&r->discretization);
    if (r->task != TASK_MOTION && r->discretization.kinematics != KINEMATICS_NONLINEAR)
        settings[count++] = "discretization.kinematics=linear";
    for (int n = 0; n < given; n++)
        settings[count++] = set[n];
    TRY(scene_file_find(line->words[0], &path, why));
    TRY(scene_file_read(path, count, settings, &r->scene, &r->discretization, why));
    if (r->settled && r->discretization.kinematics != KINEMATICS_NONLINEAR)
        TRY(status_fail(why, STATUS_INPUT,
                        "--static --modes: modes about static equilibrium need "
                        "discretization.kinematics=nonlinear; linear ones are those of the "
                        "rest shape, --modes alone"));
out:
    free(settings);
    free(path);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a scene that cannot be read is input */
}

static enum status create_state(struct run *r, struct message *why)
{
    double start = clock_now();
    enum status st = r->model->create(&r->scene, &r->discretization, &r->state, why);

    r->create_seconds = clock_now() - start;
    return st;
}

static enum status open_record(struct run *r, const char *path, struct message *why)
{
    struct store_run kept = {.scene = &r->scene,
                             .model = r->model,
                             .discretization = &r->discretization,
                             .provenance = &r->provenance};
    struct motion m;

    if (!path)
        return STATUS_OK;
    provenance_collect(&r->provenance);
    enum status st = motion_init(&m, r->model, &r->scene, r->state);
    if (st == STATUS_OK)
        st = record_create(path, &kept, m.frame_count, (int)r->every, &r->record, why);
    motion_clear(&m);
    return st;
}

static enum status watch_frame(void *context, const struct motion *m, struct message *why)
{
    enum status st = STATUS_OK;
    struct run *r = context;

    if (r->probe.count)
        TRY(probe_print(&r->probe, r->model, r->state, m->time, stdout, why));
    if (r->record)
        TRY(record_frame(r->record, r->state, m->time, &m->counters, why));
out:
    return st;
}

/* The file is completed even after a death: a death is a result. */
static enum status close_record(struct run *r, const struct motion *m, struct message *why)
{
    struct record *record = r->record;

    r->record = NULL;
    return record ? record_close(record, r->state, r->create_seconds, m, why) : STATUS_OK;
}

static enum status run_motion(struct run *r, struct message *why)
{
    enum status st = STATUS_OK;
    struct motion m = {0};

    TRY(motion_init(&m, r->model, &r->scene, r->state));
    TRY(motion_run(&m, watch_frame, r, r->quiet, why));
    TRY(close_record(r, &m, why));
    if (!r->quiet)
        describe_motion(&m, stderr);
    if (m.death)
        TRY(motion_tell_death(&m, why));
    if (!r->quiet)
        TRY(describe_state(&r->scene, r->model, r->state, m.time, stderr));
out:
    motion_clear(&m);
    return st;
}

/* The table goes to standard output, unless points asked for do. */
static enum status run_static(struct run *r, struct message *why)
{
    enum status st = STATUS_OK;

    TRY(rest_static(&r->scene, r->model, r->state, r->format,
                    r->probe.count ? stderr : stdout, why));
    if (r->probe.count) {
        TRY(probe_print(&r->probe, r->model, r->state, 0, stdout, why));
    }
    if (r->record)
        TRY(record_frame(r->record, r->state, 0, NULL, why));
    TRY(close_record(r, NULL, why));
out:
    return st;
}

static enum status run_task(struct run *r, struct message *why)
{
    switch (r->task) {
    case TASK_STATIC:
        return run_static(r, why);
    case TASK_MODES:
        return rest_modes(&r->scene, r->model, r->state, (int)r->mode_count, r->settled,
                          r->format, stdout, why);
    case TASK_MOTION:
        break;
    }
    return run_motion(r, why);
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;
    struct run r = {0};
    const char *folder = command_value(line, "--matrices");

    TRY(read_options(&r, line, why));
    TRY(read_scene(&r, line, why));
    TRY(create_state(&r, why));
    TRY(open_record(&r, command_value(line, "--out"), why));
    if (!r.quiet)
        describe_setup(&r.scene, r.model, &r.discretization, r.state, r.create_seconds,
                       stderr);
    if (folder)
        TRY(matrices_write(folder, r.model, &r.scene, &r.discretization, why));
    TRY(run_task(&r, why));
out:
    record_discard(r.record);
    if (r.model)
        r.model->destroy(r.state);
    probe_clear(&r.probe);
    scene_clear(&r.scene);
    discretization_clear(&r.discretization);
    return st;
}

static const struct command_option options[] = {
    {"--model", "NAME", false, "iga unless told otherwise; see clothbench list models"},
    {"--set", "KEY=VALUE", true,
     "a key of the scene (material.young=5e4) or of the\n"
     "discretization (discretization.points=[20,20,2],\n"
     ".degree=[3,3,1], .kinematics=linear|printed|incremental|nonlinear);\n"
     "all keys: clothbench help scene"},
    {"--static", NULL, false,
     "static equilibrium instead of motion; of solids linear\n"
     "unless discretization.kinematics=nonlinear is set"},
    {"--modes", "N", false,
     "the N lowest natural frequencies instead of motion:\n"
     "about the rest shape, or with --static about nonlinear\n"
     "static equilibrium, and whether that is stable"},
    {"--format", "FORMAT", false,
     "of the table of --static or --modes: text, csv,\nmarkdown, latex or json"},
    {"--probe", "U,V,W", true,
     "where this material point is in every frame, as CSV\n"
     "t,u,v,w,x,y,z with 17 digits on standard output"},
    {"--out", "FILE.h5", false,
     "keep every frame in an HDF5 file, and a FILE.xdmf\nbeside it that opens in ParaView"},
    {"--every", "N", false,
     "keep only each N-th frame in --out; the first and the\nlast always"},
    {"--matrices", "FOLDER", false,
     "also write stiffness and mass of the rest shape to\n"
     "FOLDER/K.mtx and M.mtx, in Matrix Market form"},
    {"--quiet", NULL, false, "no words for people, no progress bar"},
    {0},
};

const struct command run_command = {
    .name = "run",
    .summary = "one model on one scene: its motion, static equilibrium or frequencies",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs a model on a scene: a name from `clothbench list scenes` or the path of a\n"
        "YAML file. What it did is told on standard error: Gamma, the discretization,\n"
        "milliseconds a frame, work done, metrics of the last frame. Positions and tables\n"
        "go to standard output.\n",
    .options = options,
    .examples =
        "run edge_drop\n"
        "run edge_drop --model hex --set discretization.points=[16,16,2]\n"
        "run edge_drop --set material.young=5e4 --set time.end=1 --out drop.h5 --every 10\n"
        "run edge_drop --probe 1,0.5,0.5 --probe 1,0,0.5 > tips.csv\n"
        "run cantilever --static --set discretization.degree=[3,3,2]"
        " --set discretization.points=[10,10,3]\n"
        "run cantilever --modes 4 --format csv\n"
        "run cantilever --model shell --static --modes 3 --set gravity=[0,-9.81,0]\n"
        "run cantilever --static --matrices matrices\n",
    .least = 1,
    .most = 1,
    .run = run,
};
