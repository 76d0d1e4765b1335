/* The scenes that have no closed form: every model against the truths that are stored. */
#include <stdlib.h>

#include "bench/truth/truth_file.h"
#include "bench/verify/verify_check.h"
#include "models/grid.h"
#include "models/metric/metric.h"

/* A thirtieth of the length, of nets of a dozen points a side that bend without locking:
 * what a reader of a picture of these motions would not see. */
#define COARSE 0.03

/* Nets with a node at a tenth of the length, where the clamps of corners_patch end. */
static const struct verify_entry entries[] = {
    {"iga_incremental", 0, "locks", {12}},
    {"iga_reduced_incremental", 0, "forgets its shape at rest", {12}},
    {"iga_reduced", COARSE, "coarse, but bends without locking", {12}},
    {"hex_incompatible", 0, "flat elements", {11}},
    {"shell_3", COARSE, "coarse, fully integrated", {13}},
    {"mass_spring", 0, "implicit Euler; nu = 1/3 at best", {21}},
    {"projective_dynamics", 0, "implicit Euler", {21}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "iga_nonlinear," VERIFY_LOCKED, {11}, {11}};

/* The motions part with time: judged not later than this [s]. */
static const double LATEST = 0.3, QUICK = 0.1;

struct stored {
    const char *scene;
    double length;
    const char *damping; /* setting, or NULL                                           */
    struct truth_made truth;
    int index; /* of the time at which they are judged, -1: none                       */
    double uvw[3 * GRID_POINTS], xyz[3 * GRID_POINTS];
};

static void add_row(struct stored *s, const struct verify_subject *subject)
{
    const double time = s->truth.time[s->index];
    struct verify_trial t =
        verify_trial_of(subject, s->scene, "%s, rms / L at %.3g s", s->scene, time);

    if (s->damping)
        settings_set(&t.settings, s->damping);
    if (verify_trial_motion(&t, 1, &time, GRID_POINTS, s->uvw, s->xyz))
        verify_row_judge_error(t.row,
                               metric_rmse(s->xyz, s->truth.xyz[s->index]) / s->length,
                               s->truth.value[s->index][TRUTH_ERROR] / s->length);
}

static enum status add_scene(struct verify_sheet *sheet, struct stored *s)
{
    double latest = sheet->quick ? QUICK : LATEST;
    char *file = NULL, *physics = NULL;
    struct message *why = &sheet->why;
    struct verify_subject subject;
    struct scene scene = {0};
    enum status st;

    TRY(verify_trial_scene(s->scene, &scene, why));
    s->length = scene.length;
    s->damping = truth_plan_damping(&scene);
    TRY(named_file_find(&truth_file_kind, s->scene, &file, why));
    TRY(truth_file_read(file, &s->truth, &physics, why));
    s->index = -1;
    for (int n = 0; n < s->truth.claimed && s->truth.time[n] <= latest + 1e-9; n++)
        s->index = n;
    for (int n = 0; s->index >= 0 && verify_sheet_next(sheet, &field, &n, &subject);)
        add_row(s, &subject);
out:
    scene_clear(&scene);
    truth_made_clear(&s->truth);
    free(physics);
    free(file);
    return st;
}

static void run(struct verify_sheet *sheet)
{
    enum status st = STATUS_MEMORY;
    struct named_file_entry *files = NULL;
    struct stored *s = calloc(1, sizeof *s);
    int count = 0;

    if (!s)
        goto out;
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, s->uvw + 3 * n);
    TRY(named_file_list(&truth_file_kind, &files, &count, &sheet->why));
    for (int n = 0; n < count; n++) {
        s->scene = files[n].name;
        TRY(add_scene(sheet, s));
    }
out:
    verify_sheet_holds(sheet, st);
    named_file_list_free(files, count);
    free(s);
}

const struct verify_check verify_truths = {
    .item = {"truths", "scenes that have no closed form: falls, a flag, clamps, contact"},
    .source = "nonlinear solid and nonlinear shell, refined until they agree "
              "(clothbench truth), with their error bars",
    .run = run,
};
