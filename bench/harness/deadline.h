/* deadline.h - until when this process may go on with runs, for commands that were given a
 * budget: a motion in flight is stopped between two frames (motion.h), STATUS_LATE.
 */
#ifndef DEADLINE_H
#define DEADLINE_H

/* So many seconds from now on; INFINITY: as long as it takes, as at first. */
void deadline_set(double seconds);

/* Seconds that are left, negative when it is over. */
double deadline_left(void);

#endif
