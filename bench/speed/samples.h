/* samples.h - numbers of a benchmark that is not a run: seconds of short calls, every
 * repeat, and other numbers of its table, by case and name. They are kept as a CSV file,
 * from which the table is printed again. */
#ifndef SAMPLES_H
#define SAMPLES_H

#include <stdbool.h>

#include "models/clock.h"
#include "models/status.h"

enum { SAMPLES_NAME = 64 };

struct samples {
    int count, room;
    struct sample {
        char name[SAMPLES_NAME], what[SAMPLES_NAME]; /* no commas                      */
        double value;
    } * all; /* [room]                                                           owned */
    enum status status; /* not STATUS_OK: an addition failed                           */
};
void samples_clear(struct samples *s); /* all-zero is allowed, and left */

void samples_add(struct samples *s, const char *name, const char *what, double value);

/* Return the summary, or the median alone, of all samples of that case and name; count = 0
 * and NaN: there is none. */
struct clock_summary samples_of(const struct samples *s, const char *name,
                                const char *what);
double samples_number(const struct samples *s, const char *name, const char *what);

/* A short call to be timed. */
struct samples_task {
    const char *name, *what;
    enum status (*call)(void *context);
    void (*prepare)(void *context); /* before each call, not timed; NULL: nothing      */
    void *context;
};

/* Times all tasks in turn, short ones after an untimed sample, repeated as timing.h says; a
 * sample is the mean of as many calls as make up a millisecond. */
enum status samples_time(struct samples *s, bool quick, int count,
                         const struct samples_task *tasks);

/* Writes FOLDER/samples.csv: case, quantity, value. STATUS_FILE, STATUS_MEMORY,
 * STATUS_INPUT with a sentence. */
enum status samples_save(const struct samples *s, const char *folder, struct message *why);
enum status samples_read(struct samples *s, const char *folder, struct message *why);

#endif
