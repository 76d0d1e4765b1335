#include "bench/speed/samples.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/timing.h"
#include "bench/ui/table.h"

void samples_clear(struct samples *s)
{
    free(s->all);
    *s = (struct samples){0};
}

void samples_add(struct samples *s, const char *name, const char *what, double value)
{
    if (s->count == s->room) {
        const int room = s->room ? 2 * s->room : 64;
        struct sample *all = realloc(s->all, (size_t)room * sizeof *all);
        if (!all) {
            s->status = STATUS_MEMORY;
            return;
        }
        s->all = all;
        s->room = room;
    }
    struct sample *new = &s->all[s->count++];
    snprintf(new->name, sizeof new->name, "%s", name);
    snprintf(new->what, sizeof new->what, "%s", what);
    new->value = value;
}

struct clock_summary samples_of(const struct samples *s, const char *name, const char *what)
{
    struct clock_summary summary = {0, NAN, NAN, NAN, NAN, NAN};
    double value[TIMING_REPEATS];
    int count = 0;

    for (int n = 0; n < s->count && count < TIMING_REPEATS; n++)
        if (!strcmp(s->all[n].name, name) && !strcmp(s->all[n].what, what))
            value[count++] = s->all[n].value;
    return count ? clock_summarise(value, count) : summary;
}

double samples_number(const struct samples *s, const char *name, const char *what)
{
    return samples_of(s, name, what).median;
}

static const double SAMPLE = 1e-3; /* [s] a sample lasts at least */

/* Times a task by the mean of its calls. The first fetches again what other tasks have
 * driven out of the caches: it isn't counted if there is time for more, of which short
 * calls have many, and long ones one or two. */
static enum status sample(const struct samples_task *task, double *seconds)
{
    const double begin = clock_now();
    double sum = 0;
    enum status st = STATUS_OK;

    for (int calls = 0; st == STATUS_OK && (!calls || clock_now() - begin < SAMPLE);
         calls++) {
        if (task->prepare)
            task->prepare(task->context);
        const double start = clock_now();
        st = task->call(task->context);
        sum = (calls > 1 ? sum : 0) + clock_now() - start;
        *seconds = sum / (calls > 1 ? calls : 1);
    }
    return st;
}

enum status samples_time(struct samples *s, bool quick, int count,
                         const struct samples_task *tasks)
{
    enum status st = STATUS_OK;

    for (int r = -1; r < TIMING_REPEATS; r++) /* -1: warm-up */
        for (int n = 0; n < count; n++) {
            const struct clock_summary so_far = samples_of(s, tasks[n].name, tasks[n].what);
            double seconds;
            if (so_far.count && so_far.count >= timing_repeats(so_far.min, quick))
                continue;
            TRY(sample(&tasks[n], &seconds));
            if (r >= 0 || seconds > TIMING_SHORT) /* long ones need no warm-up */
                samples_add(s, tasks[n].name, tasks[n].what, seconds);
        }
out:
    return st;
}

enum status samples_save(const struct samples *s, const char *folder, struct message *why)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT}, {"quantity", NULL, TABLE_LEFT}, {"value"}};
    struct table *t = table_create(3, columns, NULL);

    for (int n = 0; n < s->count; n++)
        table_line(t, "%s|%s|%.17g", s->all[n].name, s->all[n].what, s->all[n].value);
    const enum status st = s->status ? s->status : table_save(t, folder, "samples", why);
    table_destroy(t);
    return st;
}

enum status samples_read(struct samples *s, const char *folder, struct message *why)
{
    char path[4096], line[256], word[SAMPLES_NAME], what[SAMPLES_NAME];
    double value;

    snprintf(path, sizeof path, "%s/samples.csv", folder);
    FILE *file = fopen(path, "r");
    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
    while (fgets(line, sizeof line, file))
        if (sscanf(line, "%63[^,],%63[^,],%lf", word, what, &value) == 3)
            samples_add(s, word, what, value);
    fclose(file);
    if (!s->count)
        return status_fail(why, STATUS_INPUT, "%s: no samples of a benchmark", path);
    return s->status;
}
