/* clock.h - monotonic seconds and summaries of repeats. */
#ifndef CLOCK_H
#define CLOCK_H

/* Monotonic time [s]. */
double clock_now(void);

/* Time that this thread has had a processor [s]: less than clock_now's where others want it
 * too. */
double clock_processor(void);

/* Quartiles of repeats, linear between order statistics (type 7 of Hyndman & Fan 1996). */
struct clock_summary {
    int count;
    double min, lower, median, upper, max; /* [s] */
};

/* Summary of seconds[count], count >= 1; the input is not changed. */
struct clock_summary clock_summarise(const double *seconds, int count);

/* Peak resident memory of the process so far [bytes]. */
long clock_peak_memory(void);

/* Bytes that malloc has given out and not got back, by its own books: all of a thread that
 * works alone, and whatever is large. Freed blocks of up to a kilobyte may count still,
 * some of each size. */
double clock_allocated(void);

#endif
