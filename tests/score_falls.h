/* score_falls.h - frames of sheets that fall free, by closed forms with one flaw each. */
#ifndef SCORE_FALLS_H
#define SCORE_FALLS_H

#include "tests/score_said.h"

/* Of a sheet under g at frames 10 ms apart; the physics of the scene are g t^2 / 2. */
struct fall {
    double first_order, g, damping, late, above;
};

static double fallen(const struct fall *f, double t)
{
    t = t > f->late ? t - f->late : 0;
    if (f->damping != 0)
        return f->g * (f->damping * t - 1 + exp(-f->damping * t)) /
               (f->damping * f->damping);
    return .5 * f->g * t * (t + f->first_order);
}

static void falls(void)
{
    static const struct {
        const char *name;
        int from; /* frame */
        struct fall fall;
        enum score_kind kind;
        double value, tolerance;
        const char *words;
    } row[] = {
        {"fall.csv", 0, {0, 9.81, 0, 0}, SCORE_SOUND, 0, 1e-4, "Nothing wrong"},
        {"fall_1.csv", 0, {.01, 9.81, 0, 0}, SCORE_FIRST_ORDER_STEP, .01, 1e-4, "10 ms"},
        {"fall_5.csv", 5, {.01, 9.81, 0, 0}, SCORE_FIRST_ORDER_STEP, .01, 1e-4, "10 ms"},
        {"fall_g.csv", 0, {0, 1.02 * 9.81, 0, 0}, SCORE_GRAVITY, 1.02, 1e-4, "x 1.020:"},
        {"fall_c.csv", 0, {0, 9.81, .3, 0}, SCORE_DAMPING, .3, .02, "Is damped like by 0."},
        {"fall_e.csv", 0, {0, 9.81, -.3, 0}, SCORE_DAMPING, -.3, .02, "Gains energy"},
        {"fall_z.csv", 0, {0, 9.81, 0, 0, .1}, SCORE_SUPPORT, .1, 1e-3, "(0, 0, 0.1) m"},
        {"fall_p.csv", 0, {0, 4 * 9.81, 0, 0}, SCORE_GRAVITY, 4, 1e-3, "2 times as fast"},
        {"fall_t.csv", 0, {0, 9.81, 0, .004}, SCORE_LAG, .004, 1e-4, "Lags behind"},
        {"fall_a.csv", 0, {0, 9.81, 0, -.004}, SCORE_LAG, -.004, 2e-4, "Is ahead of"}};

    for (size_t r = 0; r < sizeof row / sizeof *row; r++) {
        char path[4096];
        file_of(row[r].name, path);
        FILE *file = fopen(path, "w");
        REQUIRE(file);
        for (int k = row[r].from; k <= 50; k++)
            for (int n = 0; n < 16; n++)
                fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k / 100., n % 4 / 3.,
                        n / 4 / 3., n % 4 / 3., n / 4 / 3.,
                        row[r].fall.above - fallen(&row[r].fall, k / 100.));
        REQUIRE(fclose(file) == 0);
        check_said("free_fall", row[r].name, &plain, row[r].kind, row[r].value,
                   row[r].tolerance);
        check_words(row[r].name, row[r].words);
    }
}

#endif
