/* clock.h - monotonic seconds and summaries of repeats. */
#ifndef CLOCK_H
#define CLOCK_H

/* Returns the monotonic time [s]. */
double clock_now(void);

/* Returns the time that this thread has had a processor [s]: less than by clock_now where
 * other threads compete for it. */
double clock_processor(void);

/* Quartiles are linear between order statistics (type 7 of Hyndman & Fan 1996). */
struct clock_summary {
    int count;
    double min, lower, median, upper, max; /* [s] */
};

/* Summarizes seconds[count], count >= 1; the input is not changed. */
struct clock_summary clock_summarise(const double *seconds, int count);

/* Returns the peak resident memory of the process so far [bytes]. */
long clock_peak_memory(void);

/* Returns the bytes that malloc counts as allocated: all of a thread that works alone, and
 * all large blocks. Freed blocks of up to a kilobyte may still count, some of each size. */
double clock_allocated(void);

#endif
