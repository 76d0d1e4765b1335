/* protocol_place.c - the stored runs of our own contestants, which engines are compared
 * with. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/score/protocol.h"
#include "models/reader/named_file.h"

#define ERRORS "rmse_over_length_"

/* Times are the same to within this [s]. */
#define SAME_TIME 1e-6

/* Error over the length below which the engine has none: frames may have six digits. */
static const double NONE = 1e-5;

/* The files, without their ending; all of them may have runs on a scene. */
static const char *const tables[PROTOCOL_TABLES] = {"compare_protocol", "compare_rest",
                                                    "compare_scenes"};

static const struct named_file_kind kind = {
    .what = "table of contestants",
    .ending = ".csv",
    .environment = "CLOTHBENCH_CONTESTANTS",
    .from_program = CONTESTANTS_FROM_PROGRAM,
    .in_source = CONTESTANTS_IN_SOURCE,
};

/* Returns the next table of a scene's runs, after `last`, NULL for the first; NULL: none.
 */
static const struct csv_table *next_table(const struct protocol *p, const char *scene,
                                          const struct csv_table *last)
{
    char caption[160];
    bool begun = !last;

    snprintf(caption, sizeof caption, "Every run on %.100s (", scene);
    for (const struct csv *csv = p->contestants; csv < p->contestants + PROTOCOL_TABLES;
         csv++)
        for (int n = 0; n < csv->count; n++) {
            if (begun && strstr(csv->table[n].caption, caption))
                return &csv->table[n];
            begun = begun || last == &csv->table[n];
        }
    return NULL;
}

/* Returns the largest error of a row of the table, or of the engine where the row is -1, at
 * the times that both have; NaN: there are none, or the row has not all of them. */
static double error_of(const struct csv_table *t, int row, const struct protocol_run *run)
{
    double worst = -1, time;

    for (int n = 0; n < t->columns; n++)
        for (int m = 0; sscanf(t->cell[n], ERRORS "%lf_s", &time) == 1 && m < run->times;
             m++)
            if (fabs(run->row[m].time - time) < SAME_TIME) {
                const double error = row < 0 ? run->row[m].error : csv_number(t, row, n);
                worst = error > worst ? error : error >= 0 ? worst : NAN;
            }
    return worst >= 0 ? worst : NAN;
}

/* Puts a run in the place of the same contestant's if it is better, or behind all. */
static void enter(struct protocol_rival *rival, int *count, const struct protocol_rival *r)
{
    int n = 1; /* behind the engine */

    while (n < *count && strcmp(rival[n].title, r->title) != 0)
        n++;
    if (n == *count)
        rival[(*count)++] = *r;
    else if (r->error < rival[n].error)
        rival[n] = *r;
}

static double rank(const struct protocol_rival *r)
{
    return r->own && r->error < NONE ? -1 : r->error;
}

static int compare_rivals(const void *a, const void *b)
{
    const double left = rank(a), right = rank(b);

    return (left > right) - (left < right);
}

enum status protocol_place_read(struct csv contestants[PROTOCOL_TABLES],
                                struct message *why)
{
    enum status st = STATUS_OK;

    for (int k = 0; k < PROTOCOL_TABLES && st == STATUS_OK; k++) {
        char *path = NULL;
        st = named_file_find(&kind, tables[k], &path, NULL);
        contestants[k] = (struct csv){0};
        if (st == STATUS_OK)
            st = csv_read(path, &contestants[k], why);
        else if (st != STATUS_MEMORY) /* none is installed */
            st = STATUS_OK;
        free(path);
    }
    return st;
}

/* Enters the runs of a table that have no more points than the engine's; the room is for
 * all. */
static void enter_table(const struct csv_table *t, const struct protocol_run *run,
                        struct protocol_rival *rivals, int *count)
{
    struct protocol_rival r = {0};

    for (int row = 0; row < t->rows; row++) {
        const double side = csv_number_of(t, row, "side"),
                     across = csv_number_of(t, row, "across");
        r.error = error_of(t, row, run);
        if (!(side * across <= (double)run->net[0] * run->net[1]) || isnan(r.error))
            continue;
        r.net[0] = (int)side, r.net[1] = (int)across;
        snprintf(r.title, sizeof r.title, "%s", csv_words_of(t, row, "title"));
        enter(rivals, count, &r);
    }
}

enum status protocol_place(const struct protocol *p, const struct protocol_scene *scene,
                           int *count, struct protocol_rival **rivals)
{
    const struct protocol_run *run = protocol_finest(scene);
    const struct csv_table *first = scene->own ? NULL : next_table(p, scene->name, NULL);
    struct protocol_rival own = {.own = true, .net = {run->net[0], run->net[1]}};
    size_t rows = 1;

    *count = 0;
    *rivals = NULL;
    if (!first || isnan(own.error = error_of(first, -1, run)))
        return STATUS_OK;
    for (const struct csv_table *t = first; t; t = next_table(p, scene->name, t))
        rows += (size_t)t->rows;
    *rivals = malloc(rows * sizeof **rivals);
    if (!*rivals)
        return STATUS_MEMORY;
    snprintf(own.title, sizeof own.title, "%s", p->name ? p->name : p->folder);
    (*rivals)[(*count)++] = own;
    for (const struct csv_table *t = first; t; t = next_table(p, scene->name, t))
        enter_table(t, run, *rivals, count);
    qsort(*rivals, (size_t)*count, sizeof **rivals, compare_rivals);
    return STATUS_OK;
}
