/* bench_solid.h - where a frame's time goes: the phases of a solid model's step.
 *
 * The sheet of edge_drop. Every phase is timed on its own, `repeats` times after one of
 * each untimed, on the matrices of the rest shape.
 */
#ifndef BENCH_SOLID_H
#define BENCH_SOLID_H

#include "bench/speed/bench_baseline.h"
#include "models/model.h"

struct bench_solid {
    struct model_size size;
    double create;                                       /* [s]                       */
    struct clock_summary assemble, factor, solve, frame; /* [s]; frame: a whole step  */
};

enum bench_solid_phase {
    BENCH_SOLID_ASSEMBLE, /* K and M on the rest shape                                 */
    BENCH_SOLID_FACTOR,
    BENCH_SOLID_SOLVE,
    BENCH_SOLID_FRAME /* a whole step: moves the sheet; the last                      */
};

/* Seconds of one phase of a solid's state, [repeats], after one untimed. The matrices are
 * afterwards those of the rest shape. */
enum status bench_solid_time(const struct model *model, void *state,
                             enum bench_solid_phase phase, int repeats, double *seconds);

/* `settings` as on the command line ("discretization.points=[10,10,2]"), the last NULL. */
enum status bench_solid_measure(const char *model, const char *const *settings, int repeats,
                                struct bench_solid *b, struct message *why);

/* The step's matrix M + dt^2/4 K of such a case, handed to `use`. */
enum status bench_solid_matrix(const char *model, const char *const *settings,
                               enum status (*use)(const struct bench_matrix *A,
                                                  void *context),
                               void *context, struct message *why);

#endif
