/* arrival.h - tells when the iterations of an implicit step have done enough: a default
 * goes on until the step's equation holds, up to a limit.
 *
 * A step ends where the forces M (x - y) / dt^2 + grad V(x) vanish, y the place that
 * inertia and loads alone lead to. What is left after some iterations is the sum of the
 * lengths of these forces over the free points, as a share of the sum of the loads'
 * lengths, or of that of the step's change of momentum, M (x - x0 - dt v) / dt^2, if that
 * is more. The sums are newtons of the whole sheet: they mean the same on every net, and 1
 * % is 1 % of the loads at most, wherever it acts. (Root mean squares are not: a load on a
 * line weighs more in them than what is left all over the sheet.)
 *
 * Without loads the measure is a share of the supports' forces.
 *
 * Forces that move the sheet by less than 1e-10 of its length in a step, or that rounded
 * positions have, are nothing: a sheet at rest without loads has nothing to compare them
 * with.
 *
 * A number of iterations that was chosen is followed, and what it leaves is measured now
 * and then.
 */
#ifndef ARRIVAL_H
#define ARRIVAL_H

#include "models/model.h"

/* The share of the loads at which a step has arrived; and the one at which a descent has
 * gone astray: what it has not brought down is more than all that moves the sheet, which
 * goes as if under other loads. */
#define ARRIVAL_SHARE  0.01
#define ARRIVAL_ASTRAY 1.0

struct arrival {
    bool fixed;       /* the number of iterations was chosen                           */
    bool descends;    /* each iteration lowers the step's energy; forces of others, as of
                         ADMM, swing about none, and much that is left may move little  */
    int most;         /* iterations of a step; if they are fixed, of every step        */
    int first;        /* those of a step before its forces are measured                */
    double loads;     /* sum of the loads' lengths                               [N]   */
    double nothing;   /* forces that are nothing                                 [N]   */
    double left;      /* largest share that a step has left so far               [1]   */
    double left_time; /* when that step ended                                    [s]   */
    long missed;      /* steps that have not arrived at the limit                      */
};

/* Prepares for steps of dt with so many iterations, or, if that is 0, at most `limit`;
 * loads: the sum of their lengths [N]; mass: of the sheet, of so many nodes [kg]. */
void arrival_init(struct arrival *a, int iterations, int limit, double loads, double mass,
                  int nodes, const struct scene *scene, double dt);

/* The sums of a step's forces [N]: those left on free components, the supports' on others,
 * and the change of momentum over dt. */
struct arrival_forces {
    double left, held, momentum;
};

/* Returns the sum of the lengths of vectors[nodes][3], times mass[nodes] unless that is
 * NULL: of their components that are free, place[nodes][3] >= 0, or of the others. */
double arrival_sum(int nodes, const int *place, bool free, const double *mass,
                   const double *vectors);

/* Returns after how many iterations to measure a step of which `done` are done. */
int arrival_next(const struct arrival *a, int done);

/* Takes the forces after `done` iterations of a step that ends at t; returns whether the
 * step ends with them. */
bool arrival_ends(struct arrival *a, int done, const struct arrival_forces *f, double t);

/* Write the counters, a doubt about a fixed number that leaves too much, and how many
 * iterations a step has, as words after what is in the line. */
void arrival_count(const struct arrival *a, struct counters *counters);
void arrival_doubt(const struct arrival *a, struct message *line);
void arrival_describe(const struct arrival *a, const char *iterations,
                      struct message *line);

#endif
