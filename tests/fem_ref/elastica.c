/* The heavy elastica against values computed elsewhere by another method, and its limits.
 */
#include "fem_ref/elastica.h"
#include "fem_ref/reference.h"
#include "tests/check.h"

/* The table's own trust, relative; and absolute at its smallest Gamma, where its drop
 * leaves Gamma / 8 (1 - Gamma^2 / 80) by 5e-13 (ours keeps it: check_limits). */
#define TOL_TABLE 1e-10
#define TOL_SMALL 1e-12

static double allowed(double value)
{
    return TOL_SMALL + TOL_TABLE * fabs(value);
}

static void check_cell(const struct reference *t, int row, const char *column, double value)
{
    const double want = reference_number(t, row, column), TOL_CELL = allowed(want);
    CHECK_NEAR(value, want, TOL_CELL);
}

static void check_table(void)
{
    struct reference *t = NULL;
    struct elastica_point e;

    REQUIRE(!reference_open(REFERENCE_DIR "/heavy_elastica.csv", &t, NULL));
    for (int row = 0; row < reference_rows(t); row++) {
        double gamma = reference_number(t, row, "Gamma");
        REQUIRE(!elastica_solve(gamma, &e));
        check_cell(t, row, "H_over_L", e.drop);
        check_cell(t, row, "W_over_L", e.reach);
        check_cell(t, row, "theta_tip_rad", e.angle);
    }
    CHECK(reference_rows(t) > 40);
    reference_close(t);
}

static void check_limits(void)
{
    struct elastica_point e;
    /* Stiff: drop Gamma / 8 (1 - Gamma^2 / 80), next term of order Gamma^4 / 1000. */
    const double stiff = 0.01, TOL_STIFF = 2e-11;
    REQUIRE(!elastica_solve(stiff, &e));
    CHECK_RELATIVE(e.drop, stiff / 8 * (1 - stiff * stiff / 80), TOL_STIFF);
    /* Limp: at the root the weight is a force P = Gamma, which pulls at a right angle
     * there: the bend of a long elastica takes (2 - sqrt 2) / sqrt P off the drop;
     * corrections of order 1 / Gamma. */
    const double limp = 1e6, TOL_LIMP = 1e-3;
    REQUIRE(!elastica_solve(limp, &e));
    CHECK_NEAR(e.drop, 1 - (2 - sqrt(2)) / sqrt(limp), TOL_LIMP / sqrt(limp) * 10);
    CHECK_NEAR(e.angle, acos(0), TOL_TABLE);
}

static void check_refusals(void)
{
    struct elastica_point e = {.drop = -1};
    const double bad[] = {0, -1, NAN, INFINITY, 1e-5, 1e7};
    for (int i = 0; i < 6; i++)
        CHECK(elastica_solve(bad[i], &e) == STATUS_INPUT);
    CHECK(e.drop == -1);
}

/* v1 of another solution's table to its 12 digits: shortening, middle / L. */
static void check_buckled(void)
{
    static const double table[][2] = {
        {0.001, 0.020125392707}, {0.01, 0.0634627217646}, {0.1, 0.194924311376},
        {0.3, 0.314312612956},   {0.5, 0.373306427445},
    };
    const double TOL_DIGITS = 1e-12;

    for (size_t n = 0; n < sizeof table / sizeof *table; n++)
        CHECK_NEAR(elastica_buckled(table[n][0]), table[n][1], TOL_DIGITS);
    /* Barely buckled: half a sine, whose length exceeds its chord by pi^2 middle^2 / 4. */
    const double small = 1e-6, TOL_SMALL_BEND = 1e-6;
    CHECK_RELATIVE(elastica_buckled(small), 2 / (2 * acos(0)) * sqrt(small),
                   TOL_SMALL_BEND);
    CHECK(isnan(elastica_buckled(0)) && isnan(elastica_buckled(0.95)) &&
          isnan(elastica_buckled(NAN)));
}

/* The elastica that softens is the plain one without softening, and that of a strip a tenth
 * as stiff with so much that every point is on the law's last line, where M = M0 + 0.1 B k
 * and M0 tends to 0. */
static void check_soft(void)
{
    static const double gammas[] = {0.1, 3, 30}, all[] = {0, -1e9}, share[] = {1, 0.1};

    for (int c = 0; c < 2; c++)
        for (int n = 0; n < 3; n++) {
            const struct law_fabric cloth = {
                {1, 1, 0, 1}, {2e-3, 3e-3, 0, 1e-3}, 0, 1, {all[c], all[c]}};
            const struct law law = law_of_fabric(&cloth);
            struct elastica_point soft, want;
            const double bar = elastica_soft(&law, gammas[n] * share[c] * 2e-3, &soft);
            CHECK(elastica_solve(gammas[n], &want) == STATUS_OK);
            CHECK_NEAR(soft.drop, want.drop, bar);
            CHECK_NEAR(soft.reach, want.reach, bar);
        }
}

int main(void)
{
    check_soft();
    check_buckled();
    check_table();
    check_limits();
    check_refusals();
    return check_result();
}
