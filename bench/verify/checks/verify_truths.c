/* The scenes that have no closed form: every model against the truths that are stored. */
#include <stdlib.h>

#include "bench/truth/truth.h"
#include "bench/verify/verify_check.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

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
    {"shell_selective_3", COARSE, "coarse, but bends without locking", {13}},
    {"triangles", COARSE, "as of shells", {21}},
    {"mass_spring", 0, "implicit Euler; nu = 1/3 at best", {21}},
    {"mass_spring_momentum", 0, "nu = 1/3 at best", {21}},
    {"position_based", 0, "damps as implicit Euler, in small steps", {21}},
    {"projective_dynamics", 0, "implicit Euler", {21}},
    {"projective_dynamics_bdf2", COARSE, "as of triangles", {21}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "iga_nonlinear," VERIFY_LOCKED, {11}, {11}};

/* The motions part with time: judged not later than this [s]. */
static const double LATEST = 0.3, QUICK = 0.1;

struct stored {
    const char *scene;
    double length;
    struct settings settings; /* as its truth moves                                    */
    struct truth truth;
    int index; /* of the time at which they are judged, -1: none                       */
    double uvw[3 * GRID_POINTS], xyz[3 * GRID_POINTS];
};

static void add_row(struct stored *s, const struct verify_subject *subject)
{
    const double time = s->truth.time[s->index];
    struct verify_trial t =
        verify_trial_of(subject, s->scene, "%s, rms / L at %.3g s", s->scene, time);

    settings_append(&t.settings, &s->settings);
    if (verify_trial_motion(&t, 1, &time, GRID_POINTS, s->uvw, s->xyz))
        verify_row_judge_error(t.row,
                               metric_rmse(s->xyz, s->truth.xyz[s->index]) / s->length,
                               s->truth.error[s->index] / s->length);
}

/* The scene as its truth moves, and that truth. STATUS_UNSUPPORTED: it is of other physics.
 */
static enum status find_truth(struct stored *s, struct message *why)
{
    char *path = NULL;
    struct scene scene = {0};
    enum status st;

    TRY(scene_file_find(s->scene, &path, why));
    TRY(truth_plan_scene(path, &s->settings, &scene, why));
    s->length = scene.length;
    TRY(truth_file_find(s->scene, &scene, &s->truth, why));
out:
    scene_clear(&scene);
    free(path);
    return st;
}

/* Nobody is judged by a truth of other physics. */
static void add_stale(struct verify_sheet *sheet, const struct stored *s,
                      const struct message *sentence)
{
    struct verify_subject subject;

    for (int n = 0; verify_sheet_next(sheet, &field, &n, &subject);)
        verify_row_end(verify_sheet_add(&subject, "%s, rms / L", s->scene),
                       VERIFY_NOT_APPLICABLE, "%s", sentence->text);
}

static enum status add_scene(struct verify_sheet *sheet, struct stored *s)
{
    const double latest = sheet->quick ? QUICK : LATEST;
    struct verify_subject subject;
    struct message sentence = {""};
    const enum status st = find_truth(s, &sentence);

    s->index = -1;
    for (int n = 0; n < s->truth.claimed && s->truth.time[n] <= latest + 1e-9; n++)
        s->index = n;
    for (int n = 0; s->index >= 0 && verify_sheet_next(sheet, &field, &n, &subject);)
        add_row(s, &subject);
    truth_clear(&s->truth);
    settings_clear(&s->settings);
    if (st == STATUS_UNSUPPORTED)
        add_stale(sheet, s, &sentence);
    else if (st != STATUS_OK)
        return status_fail(&sheet->why, st, "%s", sentence.text);
    return STATUS_OK;
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
    TRY(named_file_names(&truth_file_kind, &files, &count, &sheet->why));
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
