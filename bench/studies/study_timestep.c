#include "bench/studies/study_timestep.h"

#include <math.h>

#include "bench/harness/fit.h"
#include "models/grid.h"

double study_timestep_factor(double mu)
{
    return (1 + mu) / (2 * (1 - mu));
}

const struct study_frame *study_timestep_frame(const struct study_timestep *s,
                                               enum study_timestep_kind kind, int level)
{
    return &s->kind[kind].row[level].frame[STUDY_TIMESTEP_TIMES - 1];
}

/* Depth [m] of the middle of the free edge in a frame; NaN after a death. */
static double depth(const struct study_row *row, int frame)
{
    const double *xyz = row->frame[frame].xyz;
    double z = 0;

    for (int k = 0; xyz && k < GRID_W; k++)
        for (int j = GRID_V / 2 - 1; j <= GRID_V / 2; j++)
            z -= xyz[((k * GRID_V + j) * GRID_U + GRID_U - 1) * 3 + 2] / 4;
    return xyz ? z : NAN;
}

static struct study_timestep_fall fall_of(const struct study *printed,
                                          const struct study *incremental, int n)
{
    const struct study_row *a = &printed->row[n], *b = &incremental->row[n];
    const double tau = printed->time[1] - printed->time[0];
    const double mu = a->run.scene.damping.value;

    return (struct study_timestep_fall){
        .mu = mu,
        .step = a->run.scene.step,
        .expected = -a->run.scene.gravity[2] * study_timestep_factor(mu),
        .acceleration = (depth(a, 2) - 2 * depth(a, 1) + depth(a, 0)) / (tau * tau),
        .speed = (depth(b, 2) - depth(b, 1)) / tau};
}

void study_timestep_read(const struct study_results *r, struct study_timestep *s)
{
    const struct study *printed = study_find(r, "fall_printed");
    const struct study *incremental = study_find(r, "fall_incremental");
    const struct study *creep = study_find(r, "creep");
    const struct study *sag = study_find(r, "creep_static");

    s->kind = r->study;
    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++)
        s->fall[n] = fall_of(printed, incremental, n);
    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const struct study_row *row = &creep->row[n];
        s->creep[n] = (struct study_timestep_creep){
            .young = row->run.scene.young,
            .step = row->run.scene.step,
            .speed = (depth(row, 1) - depth(row, 0)) / (creep->time[1] - creep->time[0]),
            .sag = depth(&sag->row[n], 0)};
    }
}

double study_timestep_order(const struct study_timestep *s, enum study_timestep_kind kind)
{
    double size[STUDY_TIMESTEP_LEVELS], next[STUDY_TIMESTEP_LEVELS];
    int count = 0;

    for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++) {
        double v = study_timestep_frame(s, kind, n)->next;
        if (isnan(v))
            continue;
        size[count] = s->kind[kind].row[n].level->size;
        next[count++] = v;
    }
    return count < 2 ? NAN : fit_exponent(count, size, next);
}
