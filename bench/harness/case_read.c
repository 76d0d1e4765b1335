/* The file of a case, read back. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/case_looks.h"
#include "bench/files/store_scene.h"

static enum status find_outcome(const char *text, const char *path, enum status *outcome,
                                struct message *why)
{
#define CASE_OUTCOME(code, sentence) STATUS_##code,
    static const enum status all[] = {STATUS_LIST(CASE_OUTCOME)};
#undef CASE_OUTCOME

    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        if (!strcmp(text, status_text(all[n]))) {
            *outcome = all[n];
            return STATUS_OK;
        }
    return status_fail(why, STATUS_INPUT, "%s: unknown outcome '%.100s'", path, text);
}

/* An array of as many numbers as there are looks into value[], every `stride`-th. */
static enum status read_numbers(const struct store_read *file, const char *path,
                                const char *name, int count, int stride, double *value,
                                struct message *why)
{
    enum status st;
    double *array = NULL;
    int rows, columns;

    TRY(store_read_array(file, name, &array, &rows, &columns, why));
    if (rows != count || columns != 1)
        TRY(status_fail(why, STATUS_INPUT, "%s: %s has %d numbers for %d looks", path, name,
                        rows * columns, count));
    for (int n = 0; n < count; n++)
        value[n * stride] = array[n];
out:
    free(array);
    return st;
}

static enum status read_looks(const struct store_read *file, const char *path,
                              struct case_looks *l, struct message *why)
{
    enum status st;
    double *time = NULL;
    char name[64];
    int count, columns;

    TRY(store_read_array(file, "time", &time, &count, &columns, why));
    TRY(case_looks_init(l, count));
    l->count = count;
    TRY(read_numbers(file, path, "time", count, 1, l->time, why));
    for (int n = 0; n < CASE_LOOKS_SERIES; n++) {
        snprintf(name, sizeof name, "metrics/%s", case_looks_name(n));
        TRY(read_numbers(file, path, name, count, 1, l->series[n], why));
    }
    TRY(read_numbers(file, path, "energy/kinetic", count, 3, &l->energy->kinetic, why));
    TRY(read_numbers(file, path, "energy/elastic", count, 3, &l->energy->elastic, why));
    TRY(read_numbers(file, path, "energy/potential", count, 3, &l->energy->potential, why));
out:
    free(time);
    return st;
}

static enum status read_sum(const struct store_read *file, const char *name, double *sum,
                            struct message *why)
{
    double *array = NULL;
    int rows, columns;
    enum status st = store_read_array(file, name, &array, &rows, &columns, why);

    *sum = 0;
    for (int n = 0; st == STATUS_OK && n < rows * columns; n++)
        *sum += array[n];
    free(array);
    return st;
}

enum status case_read(const char *path, struct case_result *result, struct message *why)
{
    enum status st;
    struct case_result r = {0};
    struct case_looks looks = {0};
    struct store_read *file = NULL;
    struct scene scene = {0};
    char *outcome = NULL, *note = NULL;
    double death_time = NAN;

    TRY(store_read_open(path, &file, why));
    TRY(store_read_text(file, "/", "outcome", &outcome, why));
    TRY(find_outcome(outcome, path, &r.outcome, why));
    if (r.outcome == STATUS_UNSUPPORTED)
        TRY(store_read_text(file, "/", "note", &note, why));
    else if (r.outcome)
        TRY(store_read_number(file, "death_time", &death_time, why));
    TRY(store_scene(file, path, &scene, why));
    TRY(read_looks(file, path, &looks, why));
    TRY(read_sum(file, "seconds/create", &r.create_seconds, why));
    TRY(read_sum(file, "seconds/advance", &r.step_seconds, why));
    TRY(read_sum(file, "seconds/look", &r.look_seconds, why));
    TRY(case_looks_reduce(&looks, &scene, death_time, note ? note : "", &r));
    *result = r;
out:
    free(outcome);
    free(note);
    scene_clear(&scene);
    case_looks_clear(&looks);
    store_read_close(file);
    return st;
}
