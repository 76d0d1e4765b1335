/* progress_seen.h - what an experiment tells of how far it is: each case when it is done.
 */
#ifndef PROGRESS_SEEN_H
#define PROGRESS_SEEN_H

#include "tests/check.h"

struct progress_seen {
    int done, total;
};

/* For experiment_options.progress, with a struct progress_seen of zeros behind. */
static inline void progress_seen(void *context, const char *what, int done, int total)
{
    struct progress_seen *s = context;

    CHECK(*what && done == s->done + 1 && done <= total);
    CHECK(!s->total || total == s->total);
    *s = (struct progress_seen){done, total};
}

static inline void progress_seen_all(const struct progress_seen *s, int total)
{
    CHECK(s->done == total && s->total == total);
}

#endif
