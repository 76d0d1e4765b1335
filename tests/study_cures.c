/* study cures: its 3-D truth is FreeFEM's, the cures meet it where one layer can, six zero
 * modes; and where they can't, the clamp is why. */
#include "bench/studies/studies.h"
#include "bench/studies/study_cures.h"
#include "fem_ref/reference.h"
#include "tests/check.h"

/* FreeFEM's P3 tetrahedra, graded, against B-splines of degree (4,4,3), graded: the corner
 * of the clamp is singular, the more the larger nu. Measured 2e-4, 6e-4 and 3e-3. */
static const double TOL_FREEFEM[STUDY_CURES_NUS] = {5e-4, 1e-3, 5e-3};

/* Degree 3 at nu = 0, which no clamp disturbs: shear is 0.8 % of the drop at h/L = 0.1, and
 * its correction 5/6 a sixth of that. Measured 1.6e-4. */
static const double TOL_SHEAR = 5e-4;

enum { THICK = 0, SELECTIVE_2 = 2, SELECTIVE_3 = 5 };

/* Drop of the middle of the free edge at h/L = 0.1 by a stored run, as a tip: w D / q L^4;
 * the mean of the two nodes beside the middle. */
static double freefem(int nu)
{
    static const char *const files[STUDY_CURES_NUS] = {"nu00", "nu03", "nu049"};
    const double h = 0.1, poisson = study_cures_nu[nu], weight = 0.5 * 9.81 * h;
    double stiffness = 1e5 * h * h * h / (12 * (1 - poisson * poisson)), sum = 0;
    struct reference *table;
    struct message why = {""};
    char path[1024];
    int found = 0;

    snprintf(path, sizeof path, REFERENCE_DIR "/freefem_static_h100mm_%s.csv", files[nu]);
    REQUIRE(reference_open(path, &table, &why) == STATUS_OK);
    for (int row = 0; row < reference_rows(table); row++)
        if (reference_number(table, row, "u") > 0.99 &&
            fabs(reference_number(table, row, "v") - 0.5) < 0.05) {
            sum -= reference_number(table, row, "dz");
            found++;
        }
    reference_close(table);
    REQUIRE(found == 2);
    return sum / found * stiffness / weight;
}

static double tip(int what, int law, int nu, int thickness)
{
    struct study_cures_tip t;
    struct message why = {""};

    REQUIRE(study_cures_solve(what, law, nu, thickness, false, &t, &why) == STATUS_OK);
    return t.z;
}

int main(void)
{
    for (int nu = 0; nu < STUDY_CURES_NUS; nu++) {
        double truth = tip(STUDY_CURES_TRUTH, 0, nu, THICK);
        CHECK_NEAR(truth / freefem(nu), 1, TOL_FREEFEM[nu]);
        if (nu == 0)
            CHECK_NEAR(tip(SELECTIVE_3, 0, nu, THICK) / truth, 1, TOL_SHEAR);
        if (nu < STUDY_CURES_NUS - 1) {
            CHECK_NEAR(tip(SELECTIVE_2, 0, nu, THICK) / truth, 1, study_cures_target);
            CHECK_NEAR(tip(SELECTIVE_3, 0, nu, THICK) / truth, 1, study_cures_target);
            continue;
        }
        /* a clamp that leaves the thickness free is most of what a plate has too much */
        double miss = tip(SELECTIVE_3, 0, nu, THICK) / truth - 1;
        double slit = tip(STUDY_CURES_SLIT, 0, nu, THICK) / truth - 1;
        CHECK(slit > miss / 2 && slit < miss);
    }
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        struct message why = {""};
        int zero = 0;
        CHECK(study_cures_zero_modes(&study_cures_space[n], &zero, &why) == STATUS_OK);
        CHECK(zero == 6);
    }
    return check_result();
}
