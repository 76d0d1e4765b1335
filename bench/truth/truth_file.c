#include "bench/truth/truth_file.h"

#include <inttypes.h>
#include <libgen.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/files/store.h"
#include "bench/harness/run.h"
#include "bench/truth/truth_physics.h"
#include "bench/truth/truth_third.h"
#include "models/grid.h"

static const struct {
    const char *name, *unit;
} columns[] = {
#define TRUTH_COLUMN_ROW(code, name, unit) {name, unit},
    TRUTH_COLUMN_LIST(TRUTH_COLUMN_ROW)
#undef TRUTH_COLUMN_ROW
};

/* FNV-1a, 64 bits (Fowler, Noll, Vo 1991). */
static const uint64_t PRIME = UINT64_C(0x100000001b3);

static uint64_t add(uint64_t sum, const void *bytes, size_t size)
{
    const unsigned char *b = bytes;

    for (size_t n = 0; n < size; n++)
        sum = (sum ^ b[n]) * PRIME;
    return sum;
}

/* Its four bytes, from the lowest: as add(), without a look at memory for each. */
static uint64_t add_float(uint64_t sum, float x)
{
    uint32_t bits;

    memcpy(&bits, &x, sizeof bits);
    for (int n = 0; n < 4; n++, bits >>= 8)
        sum = (sum ^ (bits & 255)) * PRIME;
    return sum;
}

/* As the file has it: fields as float. Orders that do not exist are one NaN, not many. */
static void checksum(const char *physics, const struct truth_made *m, char text[17])
{
    uint64_t sum = add(UINT64_C(0xcbf29ce484222325), physics, strlen(physics));

    for (int n = 0; n < m->times; n++) {
        sum = add(sum, &m->time[n], sizeof m->time[n]);
        for (int c = 0; c < TRUTH_STORED; c++)
            if (!isnan(m->value[n][c]))
                sum = add(sum, &m->value[n][c], sizeof m->value[n][c]);
        for (int k = 0; n < m->claimed && k < 3 * GRID_POINTS; k++)
            sum = add_float(sum, (float)m->xyz[n][k]);
    }
    snprintf(text, 17, "%016" PRIx64, sum);
}

static enum status put_columns(struct store *store, const struct truth_made *made,
                               struct message *why)
{
    double *column = malloc((size_t)made->times * sizeof *column);
    enum status st = column ? STATUS_OK : STATUS_MEMORY;

    for (int c = 0; c < TRUTH_STORED && st == STATUS_OK; c++) {
        for (int n = 0; n < made->times; n++)
            column[n] = made->value[n][c];
        st =
            store_metric(store, columns[c].name, columns[c].unit, column, made->times, why);
    }
    free(column);
    return st;
}

static enum status put_all(struct store *store, const struct scene *scene,
                           const struct truth_made *made, struct message *why)
{
    char sum[17], *physics = NULL;
    enum status st;

    TRY(truth_physics(scene, &physics));
    checksum(physics, made, sum);
    for (int n = 0; n < made->times; n++)
        TRY(store_frame(store, made->time[n], n < made->claimed ? made->xyz[n] : NULL, NULL,
                        NULL, why));
    TRY(put_columns(store, made, why));
    TRY(store_text(store, "note", made->note, why));
    TRY(store_text(store, "horizon", made->horizon, why));
    TRY(store_text(store, "physics", physics, why));
    TRY(store_text(store, "checksum", sum, why));
out:
    free(physics);
    return st;
}

/* The run that the field is from; of a closed form the scene alone. */
static enum status read_run(const struct truth_runs *runs, const struct truth_made *made,
                            struct run *run, struct message *why)
{
    struct settings settings = {0};
    struct run_plan plan = {.path = runs->path, .settings = &settings};
    enum status st;

    if (made->closed || made->foreign)
        return contestant_read_scene(runs->settings, runs->path, &run->scene, why);
    TRY(truth_level_settings(runs, &made->level, &settings, why));
    plan.contestant = truth_level_contestant(made->level.model);
    TRY(run_read(run, &plan, why));
out:
    settings_clear(&settings);
    return st;
}

enum status truth_file_write(const char *path, const struct truth_runs *runs,
                             const struct truth_made *made, struct message *why)
{
    /* No models of ours: the names that the file has of them. */
    static const struct model none = {.name = "closed_form",
                                      .title = "closed form",
                                      .source = "bench/truth/truth_closed.h"},
                              foreign = {.name = "foreign",
                                         .title = "somebody else's program",
                                         .source = "bench/truth/truth_third.h"};
    struct run run = {0};
    struct provenance provenance;
    struct store *store = NULL, *done;
    enum status st;

    TRY(read_run(runs, made, &run, why));
    provenance_collect(&provenance);
    TRY(store_create(path,
                     &(struct store_run){.scene = &run.scene,
                                         .model = made->closed    ? &none
                                                  : made->foreign ? &foreign
                                                                  : run.model,
                                         .discretization = &run.discretization,
                                         .provenance = &provenance,
                                         .single = true,
                                         .packed = true},
                     &store, why));
    TRY(put_all(store, &run.scene, made, why));
    done = store, store = NULL;
    TRY(store_close(done, why));
out:
    store_discard(store);
    run_close(&run);
    return st;
}

static enum status read_columns(const struct store_read *file, struct truth_made *made)
{
    enum status st = STATUS_OK;
    double *column = NULL;
    int rows, width;

    for (int c = 0; c < TRUTH_STORED; c++) {
        char name[64];
        snprintf(name, sizeof name, "metrics/%s", columns[c].name);
        TRY(store_read_array(file, name, &column, &rows, &width, NULL));
        if (rows != made->times || width != 1)
            TRY(STATUS_INPUT);
        for (int n = 0; n < rows; n++)
            made->value[n][c] = column[n];
        free(column), column = NULL;
    }
out:
    free(column);
    return st;
}

/* An entry of the provenance, of what room[size] takes; "unknown" if the file has none. */
static enum status read_origin(const struct store_read *file, const char *key, char *room,
                               size_t size)
{
    char *text = NULL;
    enum status st = store_read_text(file, "provenance", key, &text, NULL);

    snprintf(room, size, "%s", st == STATUS_OK ? text : "unknown");
    free(text);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

static enum status read_made(const struct store_read *file, struct truth_made *made)
{
    enum status st;
    double *time = NULL;
    char *note = NULL, *horizon = NULL;
    int times, width, claimed = store_read_frames(file);

    TRY(store_read_array(file, "time", &time, &times, &width, NULL));
    if (claimed > times)
        TRY(STATUS_INPUT);
    TRY(truth_made_init(made, times, claimed, time));
    TRY(read_columns(file, made));
    for (int n = 0; n < claimed; n++)
        TRY(store_read_frame(file, n, made->xyz[n], NULL));
    TRY(store_read_text(file, "/", "note", &note, NULL));
    TRY(store_read_text(file, "/", "horizon", &horizon, NULL));
    snprintf(made->note, sizeof made->note, "%s", note);
    snprintf(made->horizon, sizeof made->horizon, "%s", horizon);
    TRY(read_origin(file, "commit", made->commit, sizeof made->commit));
    TRY(read_origin(file, "changed_files", made->changed, sizeof made->changed));
out:
    free(time);
    free(note);
    free(horizon);
    return st;
}

static enum status read_alone(const char *path, struct truth_made *made, char **physics,
                              struct message *why)
{
    struct store_read *file = NULL;
    char sum[17], *kept = NULL, *text = NULL;
    enum status st;

    memset(made, 0, sizeof *made);
    TRY(store_read_open(path, &file, why));
    st = store_read_text(file, "/", "physics", &text, NULL);
    if (st == STATUS_OK)
        st = store_read_text(file, "/", "checksum", &kept, NULL);
    if (st == STATUS_OK)
        st = read_made(file, made);
    if (st == STATUS_MEMORY)
        goto out;
    if (st != STATUS_OK)
        TRY(status_fail(why, STATUS_INPUT, "%s: is not a stored truth", path));
    checksum(text, made, sum);
    if (strcmp(sum, kept) != 0)
        TRY(status_fail(
            why, STATUS_INPUT,
            "%s: was changed after it was made (its checksum is %s, not %.40s); "
            "make it again: clothbench truth",
            path, sum, kept));
    *physics = text, text = NULL;
out:
    if (st != STATUS_OK)
        truth_made_clear(made);
    free(text);
    free(kept);
    store_read_close(file);
    return st;
}

enum status truth_file_third(const char *path, char *third, size_t size,
                             struct message *why)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;

    if (snprintf(third, size, "%.*s/third/%s", slash ? (int)(slash - path) : 1,
                 slash ? path : ".", name) < (int)size)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT, "%s: the name is too long", path);
}

/* One of other physics than the truth's says nothing of it. */
static enum status judge_by_third(const char *path, const char *physics,
                                  struct truth_made *made, struct message *why)
{
    struct truth_made third = {0};
    char *text = NULL, file[4096];
    struct stat there;
    enum status st;

    TRY(truth_file_third(path, file, sizeof file, why));
    if (stat(file, &there) != 0)
        goto out;
    TRY(read_alone(file, &third, &text, why));
    if (strcmp(text, physics) == 0)
        truth_third_judge(&third, made);
    else
        snprintf(made->third, sizeof made->third,
                 "not compared, as it is of other physics");
out:
    truth_made_clear(&third);
    free(text);
    return st;
}

enum status truth_file_read(const char *path, struct truth_made *made, char **physics,
                            struct message *why)
{
    char *text = NULL;
    enum status st;

    TRY(read_alone(path, made, &text, why));
    TRY(judge_by_third(path, text, made, why));
    *physics = text, text = NULL;
out:
    if (st != STATUS_OK)
        truth_made_clear(made);
    free(text);
    return st;
}

bool truth_file_clean(const char *commit, const char *changed)
{
    return strcmp(commit, "unknown") != 0 && !strcmp(changed, "0");
}

enum status truth_file_may_store(const char *path, const struct provenance *program,
                                 struct message *why)
{
    const char *commit = provenance_value(program, "commit");
    const char *changed = provenance_value(program, "changed_files");
    char *folder = strdup(path);
    struct stat there, ours;
    const bool same = folder && stat(dirname(folder), &there) == 0 &&
                      stat(truth_file_kind.in_source, &ours) == 0 &&
                      there.st_ino == ours.st_ino && there.st_dev == ours.st_dev;

    free(folder);
    if (!same || truth_file_clean(commit, changed))
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: truths that come with the program are made from a commit with "
                       "no file changed; this is commit %s with %s changed",
                       path, commit, changed);
}

enum status truth_file_find(const char *name, const struct scene *scene,
                            struct truth_made *made, struct message *why)
{
    char *path = NULL, *physics = NULL;
    struct message other = {""};
    enum status st;

    memset(made, 0, sizeof *made);
    st = named_file_find(&truth_file_kind, name, &path, why);
    if (st != STATUS_OK)
        return st == STATUS_INPUT ? STATUS_FILE : st;
    TRY(truth_file_read(path, made, &physics, why));
    st = truth_physics_check(physics, scene, &other);
    if (st == STATUS_UNSUPPORTED)
        status_fail(why, st, "the stored truth of %s is %s", name, other.text);
out:
    if (st != STATUS_OK)
        truth_made_clear(made);
    free(physics);
    free(path);
    return st;
}

static char *describe(const char *path)
{
    struct truth_made made;
    struct message why;
    char text[sizeof made.note + 64], *physics;

    if (truth_file_read(path, &made, &physics, &why) != STATUS_OK)
        return strdup(why.text);
    snprintf(text, sizeof text, "to %.3g s; %s",
             made.claimed ? made.time[made.claimed - 1] : 0, made.note);
    truth_made_clear(&made);
    free(physics);
    return strdup(text);
}

const struct named_file_kind truth_file_kind = {
    .what = "truth",
    .ending = ".h5",
    .environment = "CLOTHBENCH_TRUTHS",
    .from_program = TRUTHS_FROM_PROGRAM,
    .in_source = TRUTHS_IN_SOURCE,
    .describe = describe,
};
