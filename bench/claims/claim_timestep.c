/* Claims on the time step (plan timestep).
 *
 * `velocity_scale` multiplies the velocity by mu after every step, however short: the rate
 * it damps at is log(1/mu) / dt. `printed` never resets its displacement d, which acts as
 * velocity times dt: its K d is the force of a viscosity E dt, and of a free sheet of
 * weight g the recursion d += dt v + dt^2 a / 2, v <- mu (v + dt a) makes one that falls
 * with g (1 + mu) / (2 (1 - mu)). */
#include <math.h>
#include <stdlib.h>

#include "bench/claims/claim.h"

enum { STEPS = 5 };

/* An exponent of the step above it is nearer to a first-order scheme's 1 than to none. */
static const double SETTLES = 0.5;

/* Returns the exponent of the step in a quantity at the last time; of `to_next` it is the
 * observed order, if the motion has a limit. */
static double exponent(const struct study_results *d, enum quantity q, const char *study)
{
    return results_exponent(d, QUANTITY_SIZE, q, WHERE({"study", study}));
}

static double at(const struct study_results *d, enum quantity q, const char *study,
                 const char *step)
{
    return results_at(d, q, WHERE({"study", study}, {"step", step}));
}

/* A rate gives the same motion at every step, up to an error that falls with the step. */
static enum verdict scale_is_none(const struct study_results *d, FILE *because)
{
    const double e = exponent(d, QUANTITY_DROP, "nonlinear_scale");

    fprintf(because,
            "As a property of the cloth it would not depend on the step. An elastic sheet "
            "(nonlinear) drops %.3f L by 0.4 s at 10 ms and %.4f L at 0.625 ms, as "
            "dt^%.2f; the incremental one as dt^%.2f.",
            at(d, QUANTITY_DROP, "nonlinear_scale", "10 ms"),
            at(d, QUANTITY_DROP, "nonlinear_scale", "0.625 ms"), e,
            exponent(d, QUANTITY_DROP, "incremental_scale"));
    return judge_below(SETTLES, fabs(e));
}

static enum verdict step_is_free(const struct study_results *d, FILE *because)
{
    const struct where *all = WHERE({NULL, NULL});
    const double order = results_exponent(d, QUANTITY_SIZE, QUANTITY_NEXT, all);

    fputs("Halving the step moves the sheet by ", because);
    results_write(d, QUANTITY_NEXT, WHERE({"step", "!0.625 ms"}), because);
    fprintf(because, " L at 0.4 s, as dt^%.2f; its largest stretch is ", order);
    results_write(d, QUANTITY_STRETCH, all, because);
    fputs(" from 10 to 0.625 ms.", because);
    return judge_below(SETTLES, order);
}

static enum verdict is_stable(const struct study_results *d, FILE *because)
{
    double death[STEPS];
    const int count = results_values(d, QUANTITY_DEATH, WHERE({NULL, NULL}), STEPS, death);
    int dead = 0;

    for (int n = 0; n < count; n++)
        dead += !isnan(death[n]);
    fprintf(because, "The scheme dies at %d of %d steps%s", dead, count,
            dead ? ", after " : ".");
    if (dead) {
        results_write(d, QUANTITY_DEATH, WHERE({NULL, NULL}), because);
        fputs(" s.", because);
    }
    return !count ? VERDICT_OPEN : dead ? VERDICT_FAILS : VERDICT_HOLDS;
}

/* Returns how far the free sheet is from theory at most: the printed one's acceleration,
 * and the incremental one's speed, which is that times the step. */
static double fall_off(const struct study_results *d)
{
    static const char *const label[] = {"0.2", "1/3", "0.5", "0.7"}, *const dt[] = {
                                                                         "10 ms", "2.5 ms"};
    static const double mu[] = {0.2, 1 / 3., 0.5, 0.7}, g = 1;
    double off = 0;

    for (int n = 0; n < 8; n++) {
        const double theory = g * (1 + mu[n / 2]) / (2 * (1 - mu[n / 2]));
        const double step = 1e-3 * strtod(dt[n % 2], NULL);
        double printed[3] = {NAN, NAN, NAN};
        results_values(d, QUANTITY_SPEED,
                       WHERE({"scheme", "printed"}, {"mu", label[n / 2]}, {"dt", dt[n % 2]},
                             {"at", "*"}),
                       3, printed);
        const double speed = results_at(
            d, QUANTITY_SPEED,
            WHERE({"scheme", "incremental"}, {"mu", label[n / 2]}, {"dt", dt[n % 2]}));
        off = judge_most(off, fabs((printed[2] - printed[1]) / 0.25 / theory - 1));
        off = judge_most(off, fabs(speed / (step * theory) - 1));
    }
    return off;
}

/* Returns how far the cantilever is from creeping by its elastic sag every step. */
static double creep_off(const struct study_results *d)
{
    static const char *const row[][2] = {{"4e7 Pa", "10 ms"},  {"4e7 Pa", "5 ms"},
                                         {"4e7 Pa", "2.5 ms"}, {"4e7 Pa", "1.25 ms"},
                                         {"2e7 Pa", "5 ms"},   {"8e7 Pa", "5 ms"}};
    double off = 0;

    for (int n = 0; n < 6; n++) {
        const double sag =
            results_at(d, QUANTITY_DEPTH, WHERE({"study", "sag"}, {"young", row[n][0]}));
        const double speed =
            results_at(d, QUANTITY_SPEED,
                       WHERE({"study", "creep"}, {"young", row[n][0]}, {"dt", row[n][1]}));
        off = judge_most(off, fabs(1e-3 * strtod(row[n][1], NULL) * speed / sag - 1));
    }
    return off;
}

static enum verdict is_viscous(const struct study_results *d, FILE *because)
{
    static const double VISCOUS = 0.01; /* what theory may be missed by */
    const double fall = fall_off(d), creep = creep_off(d);

    fprintf(because,
            "A free one falls with g (1 + mu) / (2 (1 - mu)) to %.1e, whatever the step, "
            "and incremental with that times the step for a speed; a loaded cantilever "
            "creeps by its elastic sag every step to %.1e, whatever E and the step.",
            fall, creep);
    return judge_both(judge_below(fall, VISCOUS), judge_below(creep, VISCOUS));
}

/* Judges a rate by a limit's sign: a halving moves as far as all later ones together. */
static enum verdict rate_has_limit(const struct study_results *d, FILE *because)
{
    const double rate = exponent(d, QUANTITY_NEXT, "nonlinear_rate");
    const double mass = exponent(d, QUANTITY_NEXT, "nonlinear_mass");
    const double apart =
        results_apart(d, WHERE({"study", "nonlinear_rate"}, {"step", "0.625 ms"}),
                      WHERE({"study", "nonlinear_mass"}, {"step", "0.625 ms"}));
    const double left = 2 * at(d, QUANTITY_NEXT, "nonlinear_rate", "1.25 ms");

    fprintf(because,
            "v <- (1 - 2 dt) v has order %.2f, C = 2 M order %.2f, and at 0.625 ms their "
            "motions are %.2g L apart, where %.2g L may be left to the limit.",
            rate, mass, apart, left);
    return judge_both(judge_both(judge_below(SETTLES, rate), judge_below(SETTLES, mass)),
                      judge_below(apart, left));
}

static enum verdict incremental_has_limit(const struct study_results *d, FILE *because)
{
    const double order = exponent(d, QUANTITY_NEXT, "incremental_mass");

    fprintf(because,
            "It forgets its strain every step, a viscosity E dt again: halving the step "
            "changes its motion as dt^%.2f, and its stretch at 0.4 s goes from %.3f at 10 "
            "ms to %.3f at 0.625 ms.",
            order, at(d, QUANTITY_STRETCH, "incremental_mass", "10 ms"),
            at(d, QUANTITY_STRETCH, "incremental_mass", "0.625 ms"));
    return judge_below(SETTLES, order);
}

#define OF(study_) WHERE({"study", study_})
#define TEXT       "the paper's text, eq. 18 to 22, with v <- mu v"
const struct claim claim_timestep[] = {
    {"implicit integration allows large steps: the motion does not depend on the step",
     "3.2", false, step_is_free,
     .readings = CLAIM_READINGS({"printed, v <- mu v", OF("printed_scale")},
                                {"incremental, v <- mu v", OF("incremental_scale")},
                                {"incremental, C = 2 M", OF("incremental_mass")},
                                {"nonlinear, C = 2 M", OF("nonlinear_mass"), .ours = true}),
     .reason = TEXT},
    {"average acceleration is unconditionally stable", "3.2", false, is_stable,
     .readings = CLAIM_READINGS({"printed, v <- mu v", OF("printed_scale")},
                                {"printed, C = 2 M", OF("printed_mass")},
                                {"incremental, v <- mu v", OF("incremental_scale")},
                                {"nonlinear, C = 2 M", OF("nonlinear_mass"), .ours = true}),
     .reason = TEXT},
    {"v <- mu v is no property of the cloth: its motion depends on the step", "", false,
     scale_is_none},
    {"The printed sheet is viscous", "", false, is_viscous},
    {"An elastic sheet with a damping that is a rate has a limit, the same for both rates",
     "", false, rate_has_limit},
    {"An incremental sheet with C = 2 M has a limit", "", false, incremental_has_limit},
    {0}};
