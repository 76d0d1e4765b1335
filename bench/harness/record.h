/* record.h - a motion into a result file (store.h): its frames, with their metrics. */
#ifndef RECORD_H
#define RECORD_H

#include "bench/harness/motion.h"
#include "bench/files/store.h"

struct record;

/* Opens the file aside, for a motion of at most frame_count + 1 frames, of which each
 * `every`-th is kept (1: all), the first and the last always: where a run dies, the last
 * one that it lived through. */
enum status record_create(const char *path, const struct store_run *run, int frame_count,
                          int every, struct record **record, struct message *why);

/* The next frame: the present state. */
enum status record_frame(struct record *r, const void *state, double t,
                         const struct counters *counters, struct message *why);

/* Metrics, seconds, what was built and how it ended; then the file gets its name. Frees in
 * any case. `m` is NULL for a state that did not move. */
enum status record_close(struct record *r, const void *state, double create_seconds,
                         const struct motion *m, struct message *why);

/* Gives up; NULL is allowed. */
void record_discard(struct record *r);

#endif
