/* deadline.h - the time until which this process may go on with runs, for commands that
 * were given a budget: a motion in flight is stopped between two frames (motion.h),
 * STATUS_LATE. */
#ifndef DEADLINE_H
#define DEADLINE_H

/* Sets the deadline so many seconds from now; INFINITY, as at first: there is none. */
void deadline_set(double seconds);

/* Returns the seconds that are left, negative when it is over. */
double deadline_left(void);

#endif
