/* cantilever_fixture.h - tips of cantilevered solids in statics, and the elastica's. */
#ifndef CANTILEVER_FIXTURE_H
#define CANTILEVER_FIXTURE_H

#include "fem_ref/reference.h"
#include "tests/motion_fixture.h"

/* Tip of the IGA cantilever, L = 1 m, at a Gamma in a kinematics [m], with degree and
 * points set so. */
static inline void cantilever_tip(double nu, double h, double gamma, const char *kinematics,
                                  const char *const set[2], const char *remedy,
                                  double tip[3])
{
    char thickness[64], poisson[64], gravity[64], law[64];
    struct message why = {""};
    struct run run;
    double D = 1e5 * h * h * h / (12 * (1 - nu * nu));

    snprintf(thickness, sizeof thickness, "sheet.thickness=%.17g", h);
    snprintf(poisson, sizeof poisson, "material.poisson=%.17g", nu);
    snprintf(gravity, sizeof gravity, "gravity=[0,0,%.17g]", -gamma * D / h);
    snprintf(law, sizeof law, "discretization.kinematics=%s", kinematics);
    run_open(&run, "iga", "cantilever",
             RUN_SETTINGS(thickness, poisson, gravity, "material.density=1", law, set[0],
                          set[1], remedy));
    if (!CHECK(run.model->equilibrium(run.state, &run.counters, &why) == STATUS_OK))
        printf("nu %g, h %g, Gamma %g: %s\n", nu, h, gamma, why.text);
    run.model->probe(run.state, 1, (double[3]){1, 0.5, 0.5}, tip);
    run_close(&run);
}

/* How far the elastica's tip lies along and below its clamp, in lengths. */
static inline void cantilever_elastica(double gamma, double tip[2])
{
    struct reference *truth;
    struct message why = {""};
    int row = 0;

    REQUIRE(reference_open(REFERENCE_DIR "/heavy_elastica.csv", &truth, &why) == STATUS_OK);
    while (reference_number(truth, row, "Gamma") != gamma)
        row++;
    tip[0] = reference_number(truth, row, "W_over_L");
    tip[1] = reference_number(truth, row, "H_over_L");
    reference_close(truth);
}

#endif
