/* Whose field is the truth at each time, its bar, and until when it is claimed: of made-up
 * tables. */
#include "bench/truth/truth_made.h"

#include <math.h>

#include "bench/truth/truth.h"
#include "models/grid.h"
#include "tests/check.h"

static const double LENGTH = 2;

static const struct choice {
    double solid[3], shell[3], difference[3], growth[3];
    const char *whose; /* of each time: o, the solid's; h, the shell's */
    int claimed;
} choices[] = {
    {{.01, .02, .03}, {.01, .02, .04}, {0}, {0}, "ooo", 3},
    {{.01, .02, .04}, {.01, .02, .03}, {0}, {0}, "ooh", 3},
    {{.02, .02, .03}, {.01, .01, .03}, {0}, {0}, "hho", 3},
    {{.01, .01, .05}, {.01, .06, .04}, {0}, {0}, "ooh", 3},
    {{.01, .02, .11}, {.09, .09, .09}, {0}, {0}, "ooh", 3},
    {{.11, .02, .01}, {.09, .11, .11}, {0}, {0}, "hoo", 3},
    {{.01, .03, .2}, {.01, .02, .3}, {0}, {0}, "oho", 2},
    {{.01, INFINITY, .01}, {INFINITY, .02, INFINITY}, {0}, {0}, "oho", 3},
    {{.01, .01, .01}, {.02, .02, .02}, {0, .11, 0}, {0}, "ooo", 1},
    {{.01, .03, .01}, {.02, .02, .02}, {0, .09, 0}, {0}, "oho", 3},
    {{.01, .01, .01}, {.02, .02, .02}, {0}, {0, 0, 1001}, "ooo", 2},
    {{.01, .01, .01}, {.02, .02, .02}, {0}, {0, 0, 999}, "ooo", 3},
    {{.3, .3, .3}, {.2, .2, .2}, {0}, {0}, "hhh", 0},
};

/* Of a sheet of 2 m: 5 % are 0.1 m. */
static void check_choices(void)
{
    static const double three[3] = {0.1, 0.2, 0.3};

    for (size_t n = 0; n < sizeof choices / sizeof *choices; n++) {
        const struct choice *c = &choices[n];
        struct truth_made made;
        REQUIRE(truth_made_init(&made, 3, 0, three) == STATUS_OK);
        for (int t = 0; t < 3; t++) {
            made.value[t][TRUTH_SOLID_BAR] = c->solid[t];
            made.value[t][TRUTH_SHELL_BAR] = c->shell[t];
            made.value[t][TRUTH_DIFFERENCE] = c->difference[t];
            made.value[t][TRUTH_GROWTH] = c->growth[t];
        }
        truth_made_bar(&made, LENGTH);
        if (!CHECK(made.claimed == c->claimed))
            printf("choice %zu: %d claimed\n", n, made.claimed);
        for (int t = 0; t < 3; t++) {
            const bool solid = c->whose[t] == 'o';
            CHECK(truth_made_whose(made.value[t]) == (solid ? TRUTH_SOLID : TRUTH_SHELL));
            CHECK(made.value[t][TRUTH_ERROR] ==
                  fmax(solid ? c->solid[t] : c->shell[t], c->difference[t]));
        }
        truth_made_clear(&made);
    }
}

/* A truth of two times; bars and difference [m] at the second, on a sheet of 2 m. */
static void check_doubt(void)
{
    static const struct {
        double first, second, solid, shell, difference; /* first, second: the bar       */
        bool alone;
        const char *says;
    } rows[] = {
        {.01, .09, .03, .02, .09, false, ""},
        {.01, .11, .03, .02, .11, false,
         "sheet is not resolved from 0.2 s on: there solid and shell are 5.5 % of the "
         "length apart, and their own bars are 1.5 % and 1 %."},
        {.11, .01, .03, .02, .01, false,
         "sheet is not resolved from 0.1 s on: there solid and shell are 0.5 % of the "
         "length apart, and their own bars are 1.5 % and 1 %."},
        {.01, .12, .12, INFINITY, 0, true,
         "sheet is not resolved from 0.2 s on: one model alone was run, and its own bar is "
         "6 % of the length there."},
        {.01, .02, .02, INFINITY, 0, true, ""},
    };
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    free(scene.name);
    scene.name = strdup("sheet");
    scene.length = scene.width = LENGTH;
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        struct truth_made made;
        double error[] = {rows[n].first, rows[n].second};
        REQUIRE(truth_made_init(&made, 2, 2, (double[]){0.1, 0.2}) == STATUS_OK);
        for (int t = 0; t < 2; t++) {
            for (int g = 0; g < GRID_POINTS; g++) { /* flat, at rest */
                double uvw[3];
                grid_point(g, uvw);
                for (int i = 0; i < 2; i++)
                    made.xyz[t][3 * g + i] = LENGTH * uvw[i];
            }
            made.value[t][TRUTH_SOLID_BAR] = rows[n].solid;
            made.value[t][TRUTH_SHELL_BAR] = rows[n].shell;
            made.value[t][TRUTH_DIFFERENCE] = rows[n].difference;
        }
        struct truth truth = {
            .times = 2, .time = made.time, .xyz = made.xyz, .error = error};
        CHECK(truth_doubt(&scene, &made, &truth) == STATUS_OK);
        CHECK(truth.alone == rows[n].alone);
        CHECK(!strcmp(truth_bar_name(&truth),
                      rows[n].alone ? "one model's own bar" : "truth's error bar"));
        if (!CHECK(!strcmp(truth.unresolved, rows[n].says)))
            printf("row %zu says '%s'\n", n, truth.unresolved);
        truth_made_clear(&made);
    }
    scene_clear(&scene);
}

int main(void)
{
    check_choices();
    check_doubt();
    return check_result();
}
