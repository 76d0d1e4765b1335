#include "bench/ui/command.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store.h"
#include "bench/harness/run_file.h"
#include "bench/run/describe.h"
#include "bench/run/statics.h"
#include "bench/ui/show.h"
#include "models/reader/scene_file.h"

/* Material points followed through a motion, as CSV: t,u,v,w,x,y,z with 17 digits, a line a
 * point and frame. */
struct probe {
    int count;
    double *uvw, *xyz;  /* [count][3] */
    bool begun;         /* the line of keys is printed */
    struct arena arena; /* of both                                              owned */
};

static void probe_clear(struct probe *p)
{
    arena_clear(&p->arena);
}

static enum status probe_init(struct probe *p, int count, const char *const *texts,
                              struct message *why)
{
    *p = (struct probe){count};
    p->uvw = arena_take(&p->arena, 3 * (size_t)count, sizeof *p->uvw);
    p->xyz = arena_take(&p->arena, 3 * (size_t)count, sizeof *p->xyz);
    for (int n = 0; n < count; n++) {
        double *x = p->uvw + 3 * n;
        char more;
        bool good = sscanf(texts[n], "%lf,%lf,%lf%c", x, x + 1, x + 2, &more) == 3;
        for (int i = 0; i < 3; i++)
            good = good && x[i] >= 0 && x[i] <= 1;
        if (!good)
            return status_fail(
                why, STATUS_INPUT,
                "--probe %s: must be u,v,w, three numbers from 0 to 1 with commas between",
                texts[n]);
    }
    return STATUS_OK;
}

static enum status probe_print(struct probe *p, const struct run *run, double t,
                               struct message *why)
{
    run->model->probe(run->state, p->count, p->uvw, p->xyz);
    errno = 0;
    if (!p->begun)
        puts("t,u,v,w,x,y,z");
    p->begun = true;
    for (int n = 0; n < p->count; n++) {
        const double *u = p->uvw + 3 * n, *x = p->xyz + 3 * n;
        printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", t, u[0], u[1], u[2], x[0],
               x[1], x[2]);
    }
    if (ferror(stdout))
        return status_fail(why, STATUS_FILE, "--probe: the run ends at t = %.6g s: %s", t,
                           errno == EPIPE ? "the reader of standard output went away"
                                          : strerror(errno));
    return STATUS_OK;
}

enum task { TASK_MOTION, TASK_STATIC, TASK_MODES };

enum { MODES_MOST = 1000 };

struct job {
    enum task task;
    bool settled; /* modes are those about static equilibrium */
    bool quiet, told;
    long mode_count;
    long every; /* frames: which of them a file keeps */
    struct printer *printer;
    struct case_plan c;
    struct run run;
    struct probe probe;
    struct run_file *file; /* NULL: nothing is looked at */
};

/* Refuses options that make no sense together. */
static enum status check_options(const struct job *j, const struct command_line *line,
                                 struct message *why)
{
    const bool out = command_given(line, "--out");

    if (command_given(line, "--every") && (j->task != TASK_MOTION || !out))
        return status_fail(why, STATUS_INPUT,
                           "--every is for the frames of a motion that --out keeps");
    if (j->task == TASK_MODES && (j->probe.count || out))
        return status_fail(why, STATUS_INPUT, "--modes has no positions: %s makes no sense",
                           j->probe.count ? "--probe" : "--out");
    if (command_given(line, "--picture") && !out)
        return status_fail(why, STATUS_INPUT, "--picture is of what --out keeps");
    if (command_given(line, "--format") && j->task == TASK_MOTION)
        return status_fail(why, STATUS_INPUT,
                           "--format is for the tables of --static and --modes");
    return STATUS_OK;
}

static enum status read_options(struct job *j, const struct command_line *line,
                                struct message *why)
{
    const char *name = command_value(line, "--model"), *out = command_value(line, "--out");
    int count;
    const char *const *points = command_values(line, "--probe", &count);

    j->quiet = command_given(line, "--quiet");
    if (command_given(line, "--static"))
        j->task = TASK_STATIC;
    if (command_given(line, "--modes")) {
        j->settled = j->task == TASK_STATIC;
        j->task = TASK_MODES;
        CALL(command_integer(line, "--modes", 1, MODES_MOST, &j->mode_count, why));
    }
    j->every = 1;
    CALL(command_integer(line, "--every", 1, INT_MAX, &j->every, why));
    CALL(probe_init(&j->probe, count, points, why));
    CALL(check_options(j, line, why));
    CALL(out ? store_try(out, why) : STATUS_OK);
    j->c.contestant = contestant_table;
    if (name)
        CALL(contestant_find(name, &j->c.contestant, why));
    return STATUS_OK;
}

/* Takes triangles for a sheet that is no rectangle, in place of the first of the models. */
static enum status choose_model(struct job *j, struct message *why)
{
    struct scene scene SCOPED(scene_clear) = {0};

    CALL(contestant_read_scene(&j->c.settings, j->c.path, &scene, why));
    return scene.pattern ? contestant_find("triangles", &j->c.contestant, why) : STATUS_OK;
}

static enum status read_scene(struct job *j, const struct command_line *line,
                              struct message *why)
{
    int given;
    char *path = NULL;
    const char *const *set = command_values(line, "--set", &given);

    settings_set_all(&j->c.settings, given, set);
    CALL(scene_file_find(line->words[0], &path, why));
    j->c.path = arena_keep(&j->c.settings.arena, path);
    if (!command_given(line, "--model"))
        CALL(choose_model(j, why));
    CALL(run_read(&j->run, &j->c, why));
    if (j->settled && j->run.discretization.kinematics != KINEMATICS_NONLINEAR)
        return status_fail(
            why, STATUS_INPUT,
            "--static --modes: modes about static equilibrium need "
            "discretization.kinematics=nonlinear; linear ones are those of the "
            "rest shape, --modes alone");
    return STATUS_OK;
}

/* The frames examined where no file is kept; a run's sentences may open with a finding. */
enum { LOOKS = 20 };

static enum status open_file(struct job *j, const char *path, struct message *why)
{
    const int frames = (int)lround(j->run.scene.end / j->run.scene.step);

    j->c.keep = (struct run_keep){.file = path,
                                  .every = path ? (int)j->every : 1 + frames / LOOKS,
                                  .fields = path ? RUN_FIELDS_ALL : RUN_FIELDS_NONE,
                                  .intersections = true,
                                  .doubles = true};
    return path || !j->quiet ? run_file_open(&j->run, &j->c.keep, &j->file, why)
                             : STATUS_OK;
}

/* Prints the run's sentences; those that say that the result cannot be right come first. */
static void tell(struct job *j, const struct run_result *r)
{
    if (j->quiet || j->told)
        return;
    j->told = true;
    if (r && *r->distrust.text)
        fprintf(stderr, "%s\n", r->distrust.text);
    describe_setup(&j->run, stderr);
}

static enum status watch_frame(void *context, const struct motion *m, struct message *why)
{
    struct job *j = context;

    if (j->probe.count)
        CALL(probe_print(&j->probe, &j->run, m->time, why));
    if (j->file)
        CALL(run_file_watch(j->file, m, why));
    return STATUS_OK;
}

/* Completes the file, even after a death: a death is a result. */
static enum status close_file(struct job *j, const struct motion *m, struct message *why)
{
    struct run_file *file = j->file;
    struct run_result r;

    j->file = NULL;
    if (!file)
        return STATUS_OK;
    CALL(run_file_close(file, m, &r, why));
    tell(j, &r);
    return STATUS_OK;
}

static enum status run_motion(struct job *j, struct message *why)
{
    struct motion m SCOPED(motion_clear) = {0};

    motion_init(&m, j->run.model, &j->run.scene, j->run.state);
    CALL(motion_run(&m, watch_frame, j, j->quiet, why));
    CALL(close_file(j, &m, why));
    if (!j->quiet)
        describe_motion(&m, stderr);
    if (m.death)
        CALL(motion_tell_death(&m, why));
    if (!j->quiet)
        CALL(describe_state(&j->run, m.time, stderr));
    return STATUS_OK;
}

/* Finds equilibrium; a remark of the model on its success goes to *told. */
static enum status settle(struct job *j, struct message *told, struct message *why)
{
    struct counters work = {0};
    enum status st = run_settle(&j->run, &work, told);

    if (st != STATUS_OK)
        return status_fail(why, st, "%s", told->text);
    if (j->file)
        CALL(run_file_rest(j->file, &work, why));
    return close_file(j, NULL, why);
}

/* Finds equilibrium and prints its table, unless points use standard output. */
static enum status run_static(struct job *j, struct message *why)
{
    struct message told = {""};

    CALL(settle(j, &told, why));
    if (j->probe.count)
        j->printer->file = stderr;
    CALL(statics_print(&j->run, &told, j->printer));
    if (j->probe.count)
        CALL(probe_print(&j->probe, &j->run, 0, why));
    return STATUS_OK;
}

static enum status run_modes_of(struct job *j, struct message *why)
{
    struct message told = {""};

    if (j->settled)
        CALL(settle(j, &told, why));
    tell(j, NULL);
    return statics_modes(&j->run, (int)j->mode_count, j->settled, j->printer, why);
}

static enum status run_task(struct job *j, struct message *why)
{
    return j->task == TASK_STATIC  ? run_static(j, why)
           : j->task == TASK_MODES ? run_modes_of(j, why)
                                   : run_motion(j, why);
}

/* Adds to a refusal the models that serve what the scene needs. */
static enum status tell_who_serves(const struct job *j, struct message *why)
{
    const unsigned needs = scene_needs(&j->run.scene);
    char names[256] = "";

    for (int n = 0; needs & ~j->run.model->serves && contestant_model(n); n++)
        if (!(needs & ~contestant_model(n)->serves))
            TEXT_JOIN(names, ", ", "%s", contestant_model(n)->name);
    const struct message refusal = *why;
    return status_fail(why, STATUS_UNSUPPORTED,
                       *names ? "%s; these models have it: %s" : "%s", refusal.text, names);
}

/* Has the sheet drawn. Without Python what was computed is there all the same. */
static enum status draw(const char *file, const char *picture, struct message *why)
{
    struct message lack = {""};
    const enum status st =
        show_run((const char *const[]){"picture", file, picture, NULL}, &lack);

    if (st != STATUS_LIBRARY)
        return st ? status_fail(why, st, "%s", lack.text) : st;
    fprintf(stderr, "%s: %s\n", picture, lack.text);
    return STATUS_OK;
}

static enum status run(struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;
    struct job j = {.printer = &line->printer};
    const char *folder = command_value(line, "--matrices"),
               *out = command_value(line, "--out"),
               *picture = command_value(line, "--picture");

    TRY(read_options(&j, line, why));
    TRY(read_scene(&j, line, why));
    st = run_build(&j.run, why);
    TRY(st == STATUS_UNSUPPORTED ? tell_who_serves(&j, why) : st);
    TRY(open_file(&j, out, why));
    if (folder)
        TRY(statics_matrices(folder, &j.c, why));
    TRY(run_task(&j, why));
    if (picture)
        TRY(draw(out, picture, why));
out:
    if (j.run.state)
        tell(&j, NULL);
    run_file_discard(j.file);
    run_close(&j.run);
    probe_clear(&j.probe);
    case_clear(&j.c);
    return st;
}

static const struct command_option options[] = {
    {"--model", "NAME", false,
     "a model or a contestant; without it the first of\n"
     "`clothbench list models`, triangles of a sheet that is no rectangle"},
    {"--set", "KEY=VALUE", true,
     "a key of the scene (material.young=5e4) or of the\n"
     "discretization (discretization.points=[20,20,2],\n"
     ".degree=[3,3,1], .kinematics=linear|printed|incremental|nonlinear);\n"
     "all keys: clothbench help scene"},
    {"--static", NULL, false,
     "static equilibrium instead of motion, and whether it is\n"
     "stable; at large displacements unless\n"
     "discretization.kinematics=linear; also on obstacles"},
    {"--modes", "N", false,
     "the N lowest natural frequencies instead of motion,\n"
     "about the rest shape or, with --static, about nonlinear\n"
     "static equilibrium, and whether that is stable"},
    {"--format", PRINTER_FORMATS, false,
     "format of the table of --static or --modes (text)"},
    {"--probe", "U,V,W", true,
     "print the position of this material point in every\n"
     "frame, as CSV t,u,v,w,x,y,z with 17 digits"},
    {"--out", "FILE.h5", false,
     "store every frame in an HDF5 file, and write a FILE.xdmf\n"
     "beside it that opens in ParaView"},
    {"--picture", "FILE.png", false, "draw the sheet at six times of what --out keeps"},
    {"--every", "N", false, "store only each N-th frame, the first and the last"},
    {"--matrices", "FOLDER", false,
     "also write stiffness and mass of the rest shape to\n"
     "FOLDER/K.mtx and M.mtx, in Matrix Market form"},
    {"--quiet", NULL, false, "print no words for people and no progress bar"},
    {0},
};

const struct command run_command = {
    .name = "run",
    .summary = "run one model on one scene: its motion, static equilibrium or frequencies",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Runs a model on a scene: a name from `clothbench list scenes` or the path of a\n"
        "YAML file. Standard error gets Gamma, the discretization, milliseconds a frame,\n"
        "counts of work and the metrics of the last frame. If the sheet stretched far,\n"
        "went through itself or deep into an obstacle, a sentence says first that the\n"
        "result is not to be trusted. Positions and tables go to standard output.\n",
    .options = options,
    .examples =
        "run edge_drop\n"
        "run edge_drop --model hex --set discretization.points=[16,16,2]\n"
        "run edge_drop --set material.young=5e4 --set time.end=1 --out drop.h5 --every 10\n"
        "run edge_drop --probe 1,0.5,0.5 --probe 1,0,0.5 > tips.csv\n"
        "run cantilever --static --set discretization.degree=[3,3,2] --set "
        "discretization.points=[10,10,3]\n"
        "run cantilever --modes 4 --format csv\n"
        "run cantilever --model shell --static --modes 3 --set gravity=[0,-9.81,0]\n"
        "run napkin_drape --model shell --static\n"
        "run cantilever --static --matrices matrices\n",
    .least = 1,
    .most = 1,
    .run = run,
};
