/* deadline.h - the time until which runs may go on, of commands that were given a budget: a
 * motion in flight is stopped between two frames (motion.h), STATUS_LATE. */
#ifndef DEADLINE_H
#define DEADLINE_H

/* Returns the seconds that are left until a time of clock_now(), negative when it is over;
 * INFINITY for 0: there is no deadline. */
double deadline_left(double until);

#endif
