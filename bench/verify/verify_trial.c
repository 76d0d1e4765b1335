#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify.h"
#include "models/clock.h"
#include "models/reader/scene_file.h"

enum { MOST_SETTINGS = 48, SETTINGS_TEXT = 1024 };

/* The check's settings, then the subject's, cut at blanks in `text`. Returns their number.
 */
static int settings_of(const struct verify_subject *subject, const char *const *settings,
                       char text[SETTINGS_TEXT], const char *all[MOST_SETTINGS])
{
    int count = 0;

    for (int n = 0; settings && settings[n] && count < MOST_SETTINGS; n++)
        all[count++] = settings[n];
    snprintf(text, SETTINGS_TEXT, "%s", subject->settings ? subject->settings : "");
    char *rest = NULL;
    for (char *word = strtok_r(text, " ", &rest); word && count < MOST_SETTINGS;
         word = strtok_r(NULL, " ", &rest))
        all[count++] = word;
    return count;
}

/* What a model's status means for the row; an error if it is neither a refusal nor a death.
 */
static enum status tell(struct verify_row *row, const struct verify_subject *subject,
                        enum status st, const struct message *sentence, struct message *why)
{
    if (st == STATUS_UNSUPPORTED)
        verify_not_applicable(row, "%s", sentence->text);
    else if (status_is_death(st))
        verify_died(row, "%s", *sentence->text ? sentence->text : status_text(st));
    else if (st != STATUS_OK)
        return status_fail(why, st, "%s: %s", subject->title, sentence->text);
    return STATUS_OK;
}

enum status verify_open(struct verify_row *row, const struct verify_subject *subject,
                        const char *scene, const char *const *settings, struct trial *trial,
                        bool *ready, struct message *why)
{
    enum status st;
    char *path = NULL, text[SETTINGS_TEXT];
    const char *all[MOST_SETTINGS];
    struct message sentence = {""};

    *ready = false;
    memset(trial, 0, sizeof *trial);
    TRY(scene_file_find(scene, &path, why));
    int count = settings_of(subject, settings, text, all);
    st = trial_open(trial, path, count, all, subject->model, &sentence);
    row->seconds += trial->create_seconds;
    *ready = st == STATUS_OK;
    TRY(tell(row, subject, st, &sentence, why));
out:
    free(path);
    return st;
}

enum status verify_settle(struct verify_row *row, const struct verify_subject *subject,
                          const char *scene, const char *const *settings,
                          struct trial *trial, bool *lived, struct message *why)
{
    enum status st;
    struct counters work = {0};
    struct message sentence = {""};

    TRY(verify_open(row, subject, scene, settings, trial, lived, why));
    if (!*lived)
        goto out;
    *lived = false;
    if (!trial->model->equilibrium) {
        verify_not_applicable(row, "%s has no static equilibrium", trial->model->name);
        goto out;
    }
    double start = clock_now();
    st = trial->model->equilibrium(trial->state, &work, &sentence);
    row->seconds += clock_now() - start;
    *lived = st == STATUS_OK;
    TRY(tell(row, subject, st, &sentence, why));
out:
    return st;
}

enum status verify_equilibrium(struct verify_row *row, const struct verify_subject *subject,
                               const char *scene, const char *const *settings, int n,
                               const double *uvw, double *xyz, bool *lived,
                               struct message *why)
{
    struct trial trial = {0};
    enum status st = verify_settle(row, subject, scene, settings, &trial, lived, why);

    if (*lived)
        trial.model->probe(trial.state, n, uvw, xyz);
    trial_close(&trial);
    return st;
}

/* Modes of the trial as it is. */
static enum status ask_modes(struct verify_row *row, const struct verify_subject *subject,
                             const struct trial *trial, int count, double *omega,
                             bool *lived, struct message *why)
{
    struct message sentence = {""};

    *lived = false;
    if (!trial->model->modes) {
        verify_not_applicable(row, "%s has no frequencies", trial->model->name);
        return STATUS_OK;
    }
    double start = clock_now();
    enum status st = trial->model->modes(trial->state, count, omega, &sentence);
    row->seconds += clock_now() - start;
    *lived = st == STATUS_OK;
    return tell(row, subject, st, &sentence, why);
}

enum status verify_modes(struct verify_row *row, const struct verify_subject *subject,
                         const char *scene, const char *const *settings, int count,
                         double *omega, bool *lived, struct message *why)
{
    struct trial trial = {0};
    enum status st = verify_open(row, subject, scene, settings, &trial, lived, why);

    if (*lived)
        st = ask_modes(row, subject, &trial, count, omega, lived, why);
    trial_close(&trial);
    return st;
}

enum status verify_settled_modes(struct verify_row *row,
                                 const struct verify_subject *subject, const char *scene,
                                 const char *const *settings, int count, double *omega,
                                 bool *lived, struct message *why)
{
    struct trial trial = {0};
    enum status st = verify_settle(row, subject, scene, settings, &trial, lived, why);

    if (*lived)
        st = ask_modes(row, subject, &trial, count, omega, lived, why);
    trial_close(&trial);
    return st;
}

enum status verify_watch(struct verify_row *row, const struct verify_subject *subject,
                         const char *scene, const char *const *settings, double end,
                         motion_watcher *watch, void *context, bool *lived,
                         struct message *why)
{
    enum status st;
    struct trial trial = {0};
    struct motion m = {0};

    TRY(verify_open(row, subject, scene, settings, &trial, lived, why));
    if (!*lived)
        goto out;
    trial.scene.end = end;
    TRY(motion_init(&m, trial.model, &trial.scene, trial.state));
    TRY(motion_run(&m, watch, context, true, why));
    for (int i = 0; i < m.steps; i++)
        row->seconds += m.seconds[i];
    if (m.death != STATUS_OK) {
        verify_died(row, "at %g s: %s", m.death_time, status_text(m.death));
        *lived = false;
    }
out:
    motion_clear(&m);
    trial_close(&trial);
    return st;
}

/* Keeps the points at the times that are wanted. */
struct keeper {
    int times, n, kept;
    const double *time, *uvw;
    double *xyz; /* [times][n][3] */
};

static enum status keep(void *context, const struct motion *m, struct message *why)
{
    struct keeper *k = context;

    (void)why;
    if (k->kept == k->times || m->time < k->time[k->kept] - m->scene->step / 4)
        return STATUS_OK;
    m->model->probe(m->state, k->n, k->uvw, k->xyz + 3 * (size_t)k->n * k->kept);
    k->kept++;
    return STATUS_OK;
}

enum status verify_motion(struct verify_row *row, const struct verify_subject *subject,
                          const char *scene, const char *const *settings, int times,
                          const double *time, int n, const double *uvw, double *xyz,
                          bool *lived, struct message *why)
{
    struct keeper k = {.times = times, .n = n, .time = time, .uvw = uvw, .xyz = xyz};

    return verify_watch(row, subject, scene, settings, time[times - 1], keep, &k, lived,
                        why);
}
