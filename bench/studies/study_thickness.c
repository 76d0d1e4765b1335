#include "bench/studies/study_thickness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

enum { LEVELS = STUDY_THICKNESS_LEVELS, NETS = STUDY_THICKNESS_NETS };

static const struct study_level levels[LEVELS] = {
    {"1 mm", "1mm", NULL, {"sheet.thickness=0.001"}},
    {"2 mm", "2mm", NULL, {"sheet.thickness=0.002"}},
    {"5 mm", "5mm", NULL, {"sheet.thickness=0.005"}},
};
enum { TIMES = STUDY_THICKNESS_TIMES };
static const double times[TIMES] = {0.2, 0.4, 0.6, 0.8};

const struct study study_thickness_solid[STUDY_THICKNESS_SOLIDS] = {
    {.name = "printed",
     .caption = "Fig. 10, a cloak of 1, 2 and 5 mm, the paper's scheme and net, mu = 0.5",
     .scene = "cloak",
     .numerics = {"discretization.kinematics=printed"},
     .count = LEVELS,
     .levels = levels,
     .times = TIMES,
     .time = times},
    {.name = "printed_better",
     .caption = "The same on a better net, (3,3,2) 16x16x3",
     .scene = "cloak",
     .numerics = {"discretization.kinematics=printed", "discretization.degree=[3,3,2]",
                  "discretization.points=[16,16,3]"},
     .count = LEVELS,
     .levels = levels,
     .times = TIMES,
     .time = times},
    {.name = "incremental",
     .caption = "The paper's net, incremental, without damping",
     .scene = "cloak",
     .settings = {"damping={kind: none}"},
     .numerics = {"discretization.kinematics=incremental"},
     .count = LEVELS,
     .levels = levels,
     .times = TIMES,
     .time = times},
};

/* What thickness does in linear theory. */
static const struct study linear = {.name = "linear",
                                    .caption = "Linear equilibrium",
                                    .scene = "cloak",
                                    .numerics = {"discretization.kinematics=linear",
                                                 "discretization.points=[16,16]",
                                                 "discretization.degree=[3,3]"},
                                    .count = LEVELS,
                                    .levels = (const struct study_level[]){
                                        {"1 mm", "1mm", "shell", {"sheet.thickness=0.001"}},
                                        {"2 mm", "2mm", "shell", {"sheet.thickness=0.002"}},
                                        {"5 mm", "5mm", "shell", {"sheet.thickness=0.005"}},
                                    }};

/* The nonlinear shell on two nets, undamped: their difference is its error bar. Some
 * minutes a run: not timed with repeats as the levels of a study are. */
struct shell_run {
    const char *settings[5];
    char name[32];
};

static const char *const net_setting[2][NETS] = {
    {"discretization.points=[16,16]", "discretization.points=[20,20]"},
    {"discretization.points=[12,12]", "discretization.points=[14,14]"}, /* quick */
};

static struct rung_plan shell_plan(struct shell_run *run, const char *path,
                                   const char *folder, bool quick, int thickness, int net)
{
    *run = (struct shell_run){
        .settings = {levels[thickness].settings[0], "damping={kind: none}", "snapshots=[]",
                     "discretization.degree=[3,3]", net_setting[quick][net]}};
    snprintf(run->name, sizeof run->name, "shell_%s_%s", levels[thickness].name,
             net ? "fine" : "coarse");
    return (struct rung_plan){.path = path,
                              .setting_count = 5,
                              .settings = run->settings,
                              .model = "shell",
                              .times = TIMES,
                              .time = times,
                              .folder = folder,
                              .name = run->name};
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    char *path = NULL;
    enum status st;

    for (int n = 0; n < STUDY_THICKNESS_SOLIDS; n++)
        TRY(study_measure(&study_thickness_solid[n], options, why));
    TRY(study_measure(&linear, options, why));
    TRY(scene_file_find("cloak", &path, why));
    for (int n = 0; n < LEVELS * NETS; n++) {
        struct shell_run run;
        struct rung_plan plan =
            shell_plan(&run, path, options->folder, options->quick, n / NETS, n % NETS);
        experiment_progress(options, "nonlinear shell", n, LEVELS * NETS);
        TRY(rung_run(&plan, why));
    }
    experiment_progress(options, "nonlinear shell", LEVELS * NETS, LEVELS * NETS);
out:
    free(path);
    return st;
}

double study_thickness_of(int level)
{
    return strtod(strchr(levels[level].settings[0], '=') + 1, NULL);
}

static double *rest_field(const struct scene *scene)
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);

    for (int n = 0; xyz && n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * n);
    }
    return xyz;
}

/* Rms displacement of the hem [m]. */
static double hem_moved(const double *rest, const double *xyz)
{
    double sum = 0;

    for (int n = GRID_U - 1; n < GRID_POINTS; n += GRID_U)
        for (int c = 0; c < 3; c++)
            sum += pow(xyz[3 * n + c] - rest[3 * n + c], 2);
    return sqrt(sum / (GRID_V * GRID_W));
}

static void widen(double *swing, const struct scene *scene, double angle, const double *xyz)
{
    if (xyz)
        *swing = fmax(*swing, metric_angle(scene, xyz) - angle); /* NaN: none so far */
}

static enum status read_level(struct study_thickness *s, int level, const char *path,
                              const char *folder, const struct scene *scene,
                              const double *rest, struct message *why)
{
    const double *sunk = s->linear.row[level].frame[0].xyz;
    enum status st = STATUS_OK;

    s->sunk[level] = sunk ? hem_moved(rest, sunk) : NAN;
    for (int n = 0; n < STUDY_THICKNESS_SCHEMES; n++)
        s->swing[n][level] = NAN;
    for (int n = 0; n < STUDY_THICKNESS_SOLIDS * TIMES; n++) {
        const int scheme = n / TIMES;
        widen(&s->swing[scheme][level], scene, s->angle,
              s->solid[scheme].row[level].frame[n % TIMES].xyz);
    }
    for (int net = 0; net < NETS; net++) {
        struct rung_result *r = &s->shell[level][net];
        struct shell_run run;
        struct rung_plan plan = shell_plan(&run, path, folder, false, level, net);
        TRY(rung_read(&plan, r, why));
        for (int t = 0; t < r->frames; t++)
            widen(&s->swing[STUDY_THICKNESS_SOLIDS + net][level], scene, s->angle,
                  r->xyz[t]);
    }
out:
    return st;
}

enum status study_thickness_read(const char *folder, struct study_thickness **s,
                                 struct message *why)
{
    struct study_thickness *new = calloc(1, sizeof *new);
    struct discretization unused = {0};
    struct scene scene = {0};
    double *rest = NULL;
    char *path = NULL;
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < STUDY_THICKNESS_SOLIDS; n++)
        TRY(study_read(&study_thickness_solid[n], folder, &new->solid[n], why));
    TRY(study_read(&linear, folder, &new->linear, why));
    TRY(scene_file_find("cloak", &path, why));
    TRY(scene_file_read(path, 1, levels[0].settings, &scene, &unused, why));
    rest = rest_field(&scene);
    if (!rest)
        TRY(STATUS_MEMORY);
    new->angle = metric_angle(&scene, rest);
    new->length = scene.length;
    new->gamma = scene_gamma(&scene);
    for (int n = 0; n < LEVELS; n++)
        TRY(read_level(new, n, path, folder, &scene, rest, why));
    *s = new, new = NULL;
out:
    study_thickness_destroy(new);
    scene_clear(&scene);
    free(rest);
    free(path);
    return st;
}

void study_thickness_destroy(struct study_thickness *s)
{
    if (!s)
        return;
    for (int n = 0; n < STUDY_THICKNESS_SOLIDS; n++)
        study_result_clear(&s->solid[n]);
    study_result_clear(&s->linear);
    for (int n = 0; n < LEVELS * NETS; n++)
        rung_clear(&s->shell[n / NETS][n % NETS]);
    free(s);
}

const struct experiment study_thickness_experiment = {
    .item = {"thickness", "Ren et al. 2024, Fig. 10: a cloak of 1 mm and of 5 mm swings"},
    .measure = measure,
    .print = study_thickness_print,
};
