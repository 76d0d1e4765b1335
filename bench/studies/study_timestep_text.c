/* What a reader should take away from study_timestep.h, in sentences from the numbers. */
#include <math.h>

#include "bench/harness/fit.h"
#include "bench/experiment/study_print.h"
#include "bench/studies/study_timestep.h"
#include "models/metric/metric.h"

enum { LAST = STUDY_TIMESTEP_TIMES - 1, FINEST = STUDY_TIMESTEP_LEVELS - 1 };

/* Drop at the last time ~ dt^e. */
static double drop_exponent(const struct study_timestep *s, enum study_timestep_kind kind)
{
    double size[STUDY_TIMESTEP_LEVELS], drop[STUDY_TIMESTEP_LEVELS];

    for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++) {
        size[n] = s->kind[kind].row[n].level->size;
        drop[n] = study_timestep_frame(s, kind, n)->drop;
    }
    return fit_exponent(STUDY_TIMESTEP_LEVELS, size, drop);
}

/* A rate gives the same motion at every step, up to an error that falls with the step. */
static void tell_scale(const struct study_timestep *s, FILE *file)
{
    double e = drop_exponent(s, STUDY_TIMESTEP_SHEET);

    study_print_verdict(
        file, "one damping coefficient mu limits the velocity, v <- mu v", fabs(e) < 0.5,
        "\n  As a property of the cloth it would not depend on the step. An elastic sheet "
        "(nonlinear) drops %.3f L\n  by 0.4 s at 10 ms and %.4f L at 0.625 ms, as dt^%.2f; "
        "the "
        "incremental one as dt^%.2f: the shorter the step, the stiffer\n  the air, and in "
        "the "
        "limit nothing moves.",
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET, 0)->drop,
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET, FINEST)->drop, e,
        drop_exponent(s, STUDY_TIMESTEP_INCREMENT));
}

static void tell_paper(const struct study_timestep *s, FILE *file)
{
    const struct study_row *row = s->kind[STUDY_TIMESTEP_PAPER].row;
    double order = study_timestep_order(s, STUDY_TIMESTEP_PAPER);

    study_print_verdict(
        file, "implicit integration does not depend on the time step (the printed scheme)",
        order > 0.5,
        "\n  Halving the step moves the sheet by %.2g, %.2g, %.2g and %.2g %% of L at 0.4 "
        "s, as "
        "dt^%.2f; its largest stretch is %.3f,\n  %.3f, %.3f, %.3f and %.3f from 10 to "
        "0.625 "
        "ms. A viscosity E dt changes with the step, and goes to nothing.",
        100 * row[0].frame[LAST].next, 100 * row[1].frame[LAST].next,
        100 * row[2].frame[LAST].next, 100 * row[3].frame[LAST].next, order,
        row[0].frame[LAST].stretch, row[1].frame[LAST].stretch, row[2].frame[LAST].stretch,
        row[3].frame[LAST].stretch, row[4].frame[LAST].stretch);
}

static void tell_stability(const struct study_timestep *s, FILE *file)
{
    int dead = 0;

    for (int n = 0; n < STUDY_TIMESTEP_LEVELS; n++)
        dead += !study_timestep_frame(s, STUDY_TIMESTEP_PAPER_MASS, n)->xyz;
    study_print_verdict(file, "implicit integration is unconditionally stable", dead == 0,
                        "\n  With mass damping instead of v <- mu v the printed scheme "
                        "dies at %d of %d steps, "
                        "sooner at shorter ones (above): its d,\n  never reset, is added "
                        "to the sheet again "
                        "every step, and only the scaling of v keeps it down.",
                        dead, STUDY_TIMESTEP_LEVELS);
}

static void tell_limits(const struct study_timestep *s, FILE *file)
{
    double rate = study_timestep_order(s, STUDY_TIMESTEP_SHEET_RATE);
    double mass = study_timestep_order(s, STUDY_TIMESTEP_SHEET_MASS);
    double increment = study_timestep_order(s, STUDY_TIMESTEP_INCREMENT_MASS);
    const struct study_frame *a =
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET_RATE, FINEST);
    const struct study_frame *b =
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET_MASS, FINEST);

    if (a->xyz && b->xyz)
        fprintf(
            file,
            "- What has a limit. An elastic sheet with a damping that is a rate: v <- (1 - "
            "2 "
            "dt) v converges with order %.2f, C = 2 M\n  with order %.2f, and to the same "
            "motion: at 0.625 ms they are %.2g %% of L apart.\n",
            rate, mass, 100 * metric_rmse(a->xyz, b->xyz) / s->kind[0].length);
    fprintf(
        file,
        "- What has none. incremental with C = 2 M forgets its strain every step, a "
        "viscosity E dt again: halving the step changes\n  its motion as dt^%.2f%s, and "
        "its stretch at 0.4 s goes from %.3f at 10 ms to %.3f at 0.625 ms.\n",
        increment, increment < 0.5 ? ", no limit in sight" : "",
        study_timestep_frame(s, STUDY_TIMESTEP_INCREMENT_MASS, 0)->stretch,
        study_timestep_frame(s, STUDY_TIMESTEP_INCREMENT_MASS, FINEST)->stretch);
}

static void tell_viscous(const struct study_timestep *s, FILE *file)
{
    double step[STUDY_TIMESTEP_CREEPS], speed[STUDY_TIMESTEP_CREEPS], fall = 0, creep = 0;

    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++)
        fall = fmax(fall, fabs(s->fall[n].acceleration / s->fall[n].expected - 1));
    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const struct study_timestep_creep *c = &s->creep[n];
        step[n] = c->young * c->step;
        speed[n] = c->speed;
        creep = fmax(creep, fabs(c->speed * c->step / c->sag - 1));
    }
    fprintf(
        file,
        "- The printed sheet is viscous. A free one falls with g (1 + mu) / (2 (1 - mu)) "
        "to "
        "%.1e, whatever the step; a loaded\n  cantilever creeps by its elastic sag every "
        "step to %.1e, so that its speed goes as (E dt)^%.3f.\n",
        fall, creep, fit_exponent(STUDY_TIMESTEP_CREEPS, step, speed));
}

void study_timestep_text(const struct study_timestep *s, FILE *file)
{
    fprintf(file, "What the step does\n\n");
    tell_scale(s, file);
    tell_paper(s, file);
    tell_stability(s, file);
    tell_viscous(s, file);
    tell_limits(s, file);
}
