#include "bench/studies/study_timestep.h"

#include <math.h>
#include <stdlib.h>

#include "bench/harness/fit.h"

const double study_timestep_time[STUDY_TIMESTEP_TIMES] = {0.1, 0.2, 0.3, 0.4};

static const struct study_level levels[STUDY_TIMESTEP_LEVELS] = {
    {"10 ms", "10", NULL, {"time.step=0.01"}, 0.01, 0},
    {"5 ms", "5", NULL, {"time.step=0.005"}, 0.005, 0}, /* the paper's */
    {"2.5 ms", "2_5", NULL, {"time.step=0.0025"}, 0.0025, 0},
    {"1.25 ms", "1_25", NULL, {"time.step=0.00125"}, 0.00125, 0},
    {"0.625 ms", "0_625", NULL, {"time.step=0.000625"}, 0.000625, 0},
};

#define KIND(file, text, kinematics, damping)                                              \
    {                                                                                      \
        .name = file, .caption = text, .scene = "edge_drop",                               \
        .settings = {"snapshots=[]", "discretization.kinematics=" kinematics,              \
                     "damping=" damping},                                                  \
        .count = STUDY_TIMESTEP_LEVELS, .levels = levels, .times = STUDY_TIMESTEP_TIMES,   \
        .time = study_timestep_time                                                        \
    }
#define SCALE "{kind: velocity_scale, value: 0.5}"
#define RATE  "{kind: velocity_rate, value: 2}"
#define MASS  "{kind: mass, value: 2}"

const struct study study_timestep_kind[STUDY_TIMESTEP_KINDS] = {
    KIND("printed_scale", "printed, v <- 0.5 v", "printed", SCALE),
    KIND("printed_mass", "printed, C = 2 M", "printed", MASS),
    KIND("incremental_scale", "incremental, v <- 0.5 v", "incremental", SCALE),
    KIND("incremental_mass", "incremental, C = 2 M", "incremental", MASS),
    KIND("nonlinear_scale", "nonlinear, v <- 0.5 v", "nonlinear", SCALE),
    KIND("nonlinear_rate", "nonlinear, v <- (1 - 2 dt) v", "nonlinear", RATE),
    KIND("nonlinear_mass", "nonlinear, C = 2 M", "nonlinear", MASS),
};

double study_timestep_factor(double mu)
{
    return (1 + mu) / (2 * (1 - mu));
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    enum status st = STATUS_OK;

    for (int kind = 0; kind < STUDY_TIMESTEP_KINDS; kind++)
        TRY(study_measure(&study_timestep_kind[kind], options, why));
    TRY(study_timestep_viscous_measure(options, why));
out:
    return st;
}

enum status study_timestep_read(const char *folder, struct study_timestep **s,
                                struct message *why)
{
    struct study_timestep *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int kind = 0; kind < STUDY_TIMESTEP_KINDS; kind++)
        TRY(study_read(&study_timestep_kind[kind], folder, &new->kind[kind], why));
    TRY(study_timestep_viscous_read(folder, new, why));
    *s = new, new = NULL;
out:
    study_timestep_destroy(new);
    return st;
}

void study_timestep_destroy(struct study_timestep *s)
{
    for (int kind = 0; s && kind < STUDY_TIMESTEP_KINDS; kind++)
        study_result_clear(&s->kind[kind]);
    free(s);
}

double study_timestep_order(const struct study_timestep *s, enum study_timestep_kind kind)
{
    double size[STUDY_TIMESTEP_LEVELS], next[STUDY_TIMESTEP_LEVELS];
    int count = 0;

    for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++) {
        double v = s->kind[kind].row[n].frame[STUDY_TIMESTEP_TIMES - 1].next;
        if (isnan(v))
            continue;
        size[count] = levels[n].size;
        next[count++] = v;
    }
    return count < 2 ? NAN : fit_exponent(count, size, next);
}

const struct experiment study_timestep_experiment = {
    .item = {"timestep",
             "steps of 10 to 0.6 ms: v <- mu v is no rate, the printed scheme is "
             "a viscous sheet, and what has a limit"},
    .measure = measure,
    .print = study_timestep_print,
};
