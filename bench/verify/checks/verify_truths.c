#include <stdlib.h>

#include "bench/truth/truth.h"
#include "bench/verify/verify_check.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

/* Claim for nets of a dozen points a side that bend without locking: a thirtieth of the
 * length, which is not seen in a picture of these motions. */
#define COARSE 0.03

/* Nets with a node at a tenth of the length, where the clamps of corners_patch end. */
static const struct verify_subject entries[] = {
    {"iga_incremental", 0, "locks", {12}},
    {"iga_selective_incremental", 0, "forgets its shape at rest", {12}},
    {"iga_selective", COARSE, "coarse, but bends without locking", {12}, .dear = true},
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

/* Latest time at which motions are judged: errors grow with time [s]. */
static const double LATEST = 0.3, QUICK = 0.1;

struct stored {
    const char *scene;
    double length;
    bool several;             /* sheets, which meet: dear in each model                */
    struct settings settings; /* of the truth's own runs                               */
    struct truth truth;
    double uvw[3 * GRID_POINTS], xyz[3 * GRID_POINTS];
};

/* Finds the scene's truth, and the settings of its runs. STATUS_UNSUPPORTED: the truth is
 * one of other physics. */
static enum status find_truth(struct stored *s, struct message *why)
{
    char *path SCOPED(scope_free) = NULL;
    struct scene scene SCOPED(scene_clear) = {0};

    CALL(scene_file_find(s->scene, &path, why));
    CALL(truth_plan_scene(path, &s->settings, &scene, why));
    s->length = scene.length;
    s->several = scene.sheets > 1;
    return truth_file_find(s->scene, &scene, &s->truth, why);
}

/* Adds the rows of a scene. A truth of other physics judges nobody; a quick run leaves
 * scenes of several sheets to the check `stack`. */
static void add_scene(struct verify_sheet *sheet, struct stored *s)
{
    const double latest = sheet->quick ? QUICK : LATEST;
    struct verify_subject all[VERIFY_MOST];
    struct message sentence = {""};
    const enum status st = find_truth(s, &sentence);
    int index = -1;

    while (!(sheet->quick && s->several) && index + 1 < s->truth.claimed &&
           s->truth.time[index + 1] <= latest + 1e-9)
        index++;
    if (st != STATUS_OK && st != STATUS_UNSUPPORTED)
        verify_sheet_holds(sheet, status_fail(&sheet->why, st, "%s", sentence.text));
    const int subjects = verify_sheet_subjects(sheet, &field, all);
    for (const struct verify_subject *who = all; who < all + subjects; who++)
        if (st == STATUS_UNSUPPORTED)
            verify_row_end(verify_sheet_add(who, "%s, rms / L", s->scene),
                           VERDICT_NOT_APPLICABLE, "%s", sentence.text);
        else if (index >= 0) {
            const double time = s->truth.time[index], length = s->length;
            struct verify_trial t =
                verify_trial_of(who, s->scene, "%s, rms / L at %.3g s", s->scene, time);
            settings_append(&t.settings, &s->settings);
            if (verify_trial_motion(&t, 1, &time, GRID_POINTS, s->uvw, s->xyz))
                verify_row_judge_error(t.row,
                                       metric_rmse(s->xyz, s->truth.xyz[index]) / length,
                                       s->truth.error[index] / length);
        }
    truth_clear(&s->truth);
    settings_clear(&s->settings);
}

static void run(struct verify_sheet *sheet)
{
    struct named_file_entry *files = NULL;
    struct stored *s = arena_take(&sheet->arena, 1, sizeof *s);
    int count = 0;

    verify_sheet_holds(sheet,
                       named_file_names(&truth_file_kind, &files, &count, &sheet->why));
    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, s->uvw + 3 * n);
    for (int n = 0; n < count && sheet->status == STATUS_OK; n++) {
        s->scene = files[n].name;
        add_scene(sheet, s);
    }
    named_file_list_free(files, count);
}

const struct verify_check verify_truths = {
    {"truths", "scenes that have no closed form: falls, a flag, clamps, contact"},
    "nonlinear solid and nonlinear shell, refined until they agree (clothbench truth), "
    "with their error bars",
    .run = run};
