/* The scenes that have no closed form: every model against the truths that are stored. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/truth_file.h"
#include "bench/verify/verify.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

extern const struct verify_check verify_truths;

/* A thirtieth of the length, of nets of a dozen points a side that bend without locking:
 * what a reader of a picture of these motions would not see. */
#define COARSE 0.03

/* Nets with a node at a tenth of the length, where the clamps of corners_patch end. */
#define NET(points, rest) "discretization.points=[" points "] " rest
static const struct verify_subject subjects[] = {
    {"iga, none, incremental, 12x12x2", "iga",
     NET("12,12,2", "discretization.kinematics=incremental"), NAN, "locks"},
    {"iga, reduced, incremental, 12x12x2", "iga",
     NET("12,12,2", "discretization.kinematics=incremental discretization.remedy=reduced"),
     NAN, "forgets its shape at rest"},
    {"iga, reduced, nonlinear, 12x12x2", "iga",
     NET("12,12,2", "discretization.kinematics=nonlinear discretization.remedy=reduced"),
     COARSE, "coarse, but bends without locking"},
    {"hex, incompatible, nonlinear, 11x11x2", "hex",
     NET("11,11,2", "discretization.kinematics=nonlinear "
                    "discretization.remedy=incompatible"),
     NAN, "flat elements"},
    {"shell, p = 3, nonlinear, 13x13", "shell", NET("13,13", "discretization.degree=[3,3]"),
     COARSE, "coarse, fully integrated"},
    {"mass_spring, matched, 21x21", "mass_spring", NET("21,21", ""), NAN,
     "implicit Euler; nu = 1/3 at best"},
    {"projective_dynamics, matched, 21x21", "projective_dynamics", NET("21,21", ""), NAN,
     "implicit Euler"},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* The motions part with time: judged not later than this [s]. */
static const double LATEST = 0.3, QUICK = 0.1;

struct stored {
    const char *scene;
    double length;
    const char *damping; /* setting, or NULL                                           */
    struct truth_made truth;
    int index; /* of the time at which they are judged, -1: none                       */
    double *uvw;
};

static enum status add_row(struct verify_sheet *sheet, const struct stored *s,
                           const struct verify_subject *subject, double *xyz,
                           struct message *why)
{
    const char *settings[] = {s->damping, NULL};
    double time = s->truth.time[s->index];
    bool lived;
    struct verify_row *row =
        verify_add(sheet, subject, "%s, rms / L at %.3g s", s->scene, time);
    enum status st = verify_motion(row, subject, s->scene, settings, 1, &time, GRID_POINTS,
                                   s->uvw, xyz, &lived, why);

    if (st == STATUS_OK && lived)
        verify_judge_error(row, metric_rmse(xyz, s->truth.xyz[s->index]) / s->length,
                           s->truth.value[s->index][TRUTH_ERROR] / s->length);
    return st;
}

static enum status read_scene(struct stored *s, struct message *why)
{
    struct scene scene = {0};
    struct discretization unused = {0};
    char *path = NULL;
    enum status st;

    TRY(scene_file_find(s->scene, &path, why));
    TRY(scene_file_read(path, 0, NULL, &scene, &unused, why));
    s->length = scene.length;
    s->damping = truth_plan_damping(&scene);
out:
    scene_clear(&scene);
    discretization_clear(&unused);
    free(path);
    return st;
}

static enum status add_scene(struct verify_sheet *sheet, struct stored *s, double *xyz,
                             struct message *why)
{
    double latest = verify_quick(sheet) ? QUICK : LATEST;
    char *file = NULL, *physics = NULL;
    enum status st;

    TRY(read_scene(s, why));
    TRY(named_file_find(&truth_file_kind, s->scene, &file, why));
    TRY(truth_file_read(file, &s->truth, &physics, why));
    s->index = -1;
    for (int n = 0; n < s->truth.claimed && s->truth.time[n] <= latest + 1e-9; n++)
        s->index = n;
    for (int n = 0; n < SUBJECTS && s->index >= 0; n++)
        if (verify_wanted(sheet, &subjects[n]))
            TRY(add_row(sheet, s, &subjects[n], xyz, why));
out:
    truth_made_clear(&s->truth);
    free(physics);
    free(file);
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct named_file_entry *entries = NULL;
    struct stored s = {0};
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    int count = 0;

    s.uvw = malloc(3 * GRID_POINTS * sizeof *s.uvw);
    if (!xyz || !s.uvw)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, s.uvw + 3 * n);
    TRY(named_file_list(&truth_file_kind, &entries, &count, why));
    for (int n = 0; n < count; n++) {
        s.scene = entries[n].name;
        TRY(add_scene(sheet, &s, xyz, why));
    }
out:
    named_file_list_free(entries, count);
    free(s.uvw);
    free(xyz);
    return st;
}

const struct verify_check verify_truths = {
    .item = {"truths", "scenes that have no closed form: falls, a flag, clamps, contact"},
    .source = "nonlinear solid and nonlinear shell, refined until they agree "
              "(clothbench truth), with their error bars",
    .run = run,
};
