/* Nets of springs and triangles bent by any load: the tip of a heavy strip at rest against
 * the elastica, on two nets. */
#include "fem_ref/elastica.h"
#include "tests/opened_run.h"

/* Asked of 32 cells [L]. */
static const double ASKED = 0.01;
/* Second order in the net, seen between two of them while errors have one sign: 2^1.7; a
 * clamp with the weights 1/2 and 1 has 2^0.9. */
static const double RATIO = 3.3;

static const struct row {
    const char *name, *settings[2];
    double poisson;
} rows[] = {
    {"mass_spring", {0}, 0.3}, /* one cell wide no spring bends across: a cylinder */
    {"mass_spring_leapfrog", {0}, 0},
    {"mass_spring_momentum", {0}, 0},
    {"triangles", {0}, 0},
    {"triangles", {"discretization.bending=hinge"}, 0},
};

static double tip_error(const struct row *row, int points, double gamma)
{
    const double h = 1e-3, D = 1e5 * h * h * h / (12 * (1 - row->poisson * row->poisson));
    char text[4][96];
    struct elastica_point want;
    struct run run;
    double tip[3];

    REQUIRE(elastica_solve(gamma, &want) == STATUS_OK);
    snprintf(text[0], sizeof *text, "sheet={length: 1, width: %.17g, thickness: %g}",
             1. / (points - 1), h);
    snprintf(text[1], sizeof *text, "material={young: 1e5, poisson: %g, density: %.17g}",
             row->poisson, gamma * D / (9.81 * h));
    snprintf(text[2], sizeof *text, "discretization.points=[%d,2]", points);
    OPENED_RUN(&run, "cantilever", row->name, text[0], text[1], text[2],
               "supports=[{at: {u: 0}, fix: xyz}, {at: {u: [0, 1]}, fix: y}]",
               row->settings[0], row->settings[1]);
    opened_settle(&run);
    run.model->probe(run.state, 1, (double[]){1, 0.5, 0.5}, tip);
    run_close(&run);
    return hypot(tip[2] + want.drop, tip[0] - want.reach);
}

int main(void)
{
    static const double gammas[] = {0.1, 1, 10, 100};

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        for (int g = 0; g < 4; g++) {
            const double coarse = tip_error(&rows[n], 17, gammas[g]),
                         fine = tip_error(&rows[n], 33, gammas[g]);
            printf("%s, Gamma %g: tip off by %.2e L, %.2e\n", rows[n].name, gammas[g],
                   coarse, fine);
            CHECK(fine < ASKED);
            CHECK(gammas[g] > 1 || coarse > RATIO * fine);
        }
    return check_result();
}
