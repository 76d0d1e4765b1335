/* Whose field is the truth at each time, its bar, and until when it is claimed: of made-up
 * tables. */
#include "bench/truth/truth_made.h"

#include <math.h>

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

int main(void)
{
    check_choices();
    return check_result();
}
