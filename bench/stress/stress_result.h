/* stress_result.h - how a contestant ended on a hard case, in a text file of its own. */
#ifndef STRESS_RESULT_H
#define STRESS_RESULT_H

#include "bench/stress/stress_case.h"

enum stress_end { STRESS_ACCURATE, STRESS_DEGRADED, STRESS_REFUSED, STRESS_DIED };

/* "accurate", ...; static storage. */
const char *stress_end_name(enum stress_end end);

/* How a run went. */
struct stress_result {
    enum stress_outcome { STRESS_RAN, STRESS_SAID_NO, STRESS_DEAD } outcome;
    double error;   /* ran; NaN otherwise                                              */
    double time;    /* of death, or until when the error was within the bound; NaN [s] */
    double seconds; /* of processor time                                               */
    struct message sentence; /* why refused or dead; what else is worth knowing        */
};

/* The one of four. An error that is no number is a death. */
enum stress_end stress_result_end(const struct stress_result *r, double bound);

/* Its file, FOLDER/CASE.CONTESTANT.txt. STATUS_FILE, STATUS_INPUT: it is none. */
enum status stress_result_write(const char *folder, const struct stress_case *c,
                                const struct contestant *contestant,
                                const struct stress_result *r, struct message *why);
enum status stress_result_read(const char *folder, const struct stress_case *c,
                               const struct contestant *contestant, struct stress_result *r,
                               struct message *why);

#endif
