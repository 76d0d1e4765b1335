/* study_timestep.h - the plan timestep: one scene at ever shorter steps, which scheme's
 * motion has a limit, and what the step does in those that have none.
 *
 * `velocity_scale` multiplies the velocity by mu after every step, however short: the rate
 * it damps at is log(1/mu) / dt. `printed` never resets its displacement d, which acts as
 * velocity times dt: its K d is the force of a viscosity E dt, and of a free sheet of
 * weight g the recursion d += dt v + dt^2 a / 2, v <- mu (v + dt a) makes one that falls
 * with g (1 + mu) / (2 (1 - mu)).
 */
#ifndef STUDY_TIMESTEP_H
#define STUDY_TIMESTEP_H

#include "bench/experiment/experiment.h"
#include "bench/experiment/study.h"

/* edge_drop by kinematics and damping: the first studies of the plan. */
enum study_timestep_kind {
    STUDY_TIMESTEP_PAPER,          /* printed, v <- mu v                                */
    STUDY_TIMESTEP_PAPER_MASS,     /* printed, C = 2 M                                  */
    STUDY_TIMESTEP_INCREMENT,      /* incremental, v <- mu v                            */
    STUDY_TIMESTEP_INCREMENT_MASS, /* incremental, C = 2 M                              */
    STUDY_TIMESTEP_SHEET,          /* nonlinear, v <- mu v                              */
    STUDY_TIMESTEP_SHEET_RATE,     /* nonlinear, v <- (1 - 2 dt) v                      */
    STUDY_TIMESTEP_SHEET_MASS,     /* nonlinear, C = 2 M                                */
    STUDY_TIMESTEP_KINDS
};
enum { STUDY_TIMESTEP_LEVELS = 5, STUDY_TIMESTEP_TIMES = 4 };

/* A free sheet under `printed` and `incremental`, v <- mu v; `expected`: what the header
 * says of its acceleration, which times the step is its speed under `incremental`. */
enum { STUDY_TIMESTEP_FALLS = 8 };
struct study_timestep_fall {
    double mu, step, expected, acceleration, speed; /* -, [s], [m/s^2] twice, [m/s]      */
};

/* A cantilever under `printed` creeps: speed of its tip, and how far linear statics bends
 * the same space. */
enum { STUDY_TIMESTEP_CREEPS = 6 };
struct study_timestep_creep {
    double young, step, speed, sag; /* [Pa], [s], [m/s], [m]                            */
};

struct study_timestep {
    const struct study *kind; /* [STUDY_TIMESTEP_KINDS]                       borrowed  */
    struct study_timestep_fall fall[STUDY_TIMESTEP_FALLS];
    struct study_timestep_creep creep[STUDY_TIMESTEP_CREEPS];
};

/* From what came of the plan, which it borrows from. */
void study_timestep_read(const struct study_results *r, struct study_timestep *s);

/* (1 + mu) / (2 (1 - mu)) */
double study_timestep_factor(double mu);

/* A level at the last time. */
const struct study_frame *study_timestep_frame(const struct study_timestep *s,
                                               enum study_timestep_kind kind, int level);

/* Exponent e of (difference from the next shorter step) ~ dt^e at the last time: the
 * observed order if the motion has a limit; NaN with fewer than two differences. */
double study_timestep_order(const struct study_timestep *s, enum study_timestep_kind kind);

#endif
