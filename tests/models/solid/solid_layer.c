/* Tests the law of one layer: its parts add up to plane stress, or to a fabric's two
 * matrices, on the points of each kind; none of them is negative; across the sheet are
 * Young's modulus and five sixths of the shear modulus. */
#include "models/solid/solid_layer.h"

#include "models/solid/solid_element.h"
#include "tests/check.h"

static const double ROUND_OFF = 1e-14, YOUNG = 2e5, THICKNESS = 2e-3, dV = 0.25;

/* Stresses 11, 22, 12 over dV: of stretches, those of all kinds together; or of bends. */
static void stress(const struct solid_material *m, bool bends, const double e[3],
                   double out[3])
{
    double along[2], plane[3];

    solid_layer_stress(m, bends ? SOLID_BENDING : SOLID_PLANE, dV, e, plane);
    solid_layer_stress(m, SOLID_ALONG_U, dV, e, along);
    solid_layer_stress(m, SOLID_ALONG_V, dV, e + 1, along + 1);
    for (int i = 0; i < 3; i++)
        out[i] = (plane[i] + (bends || i == 2 ? 0 : along[i])) / dV;
}

/* The work of a kind's stress is not negative on any stretch. */
static void check_definite(const struct solid_material *m, enum solid_strains kind)
{
    for (int t = 0; t < 360; t++) {
        const double e[3] = {cos(t), sin(t), cos(3 * t)};
        double s[3] = {0};
        solid_layer_stress(m, kind, 1, e, s);
        CHECK(e[0] * s[0] + e[1] * s[1] + e[2] * s[2] >= -ROUND_OFF * YOUNG);
    }
}

/* Against the law's own matrices over h and h^3 / 12. */
static void check_law(const struct law *law)
{
    const struct solid_material m = solid_element_material(law, 1);
    const double h = law->thickness, over[] = {h, h * h * h / 12};

    for (int bends = 0; bends < 2; bends++)
        for (int k = 0; k < 3; k++) {
            double e[3] = {0}, s[3], want[3];
            e[k] = 1;
            stress(&m, bends, e, s);
            law_stress(law->matrix[bends ? LAW_BENDING : LAW_MEMBRANE], e, want);
            for (int i = 0; i < 3; i++)
                CHECK_NEAR(s[i] / YOUNG, want[i] / over[bends] / YOUNG, ROUND_OFF);
        }
    for (enum solid_strains kind = 0; kind < SOLID_KINDS; kind++)
        check_definite(&m, kind);
}

static void check_across(const struct law *law)
{
    const struct solid_material m = solid_element_material(law, 1);
    const double e[] = {1, 1, 1}, shear = 5. / 6 * YOUNG / 2 / (1 + law->poisson);
    double s[3];

    solid_layer_stress(&m, SOLID_ACROSS, dV, e, s);
    CHECK_RELATIVE(s[0], dV * shear, ROUND_OFF);
    CHECK_RELATIVE(s[1], dV * shear, ROUND_OFF);
    CHECK_RELATIVE(s[2], dV * YOUNG, ROUND_OFF);
}

int main(void)
{
    static const double ratio[] = {0.3, 0, -0.4};
    static const struct law_fabric fabric = {{380, 250, 90, 60}, {4e-4, 3e-4, 1e-4, 5e-5}};
    const struct law woven = law_of_fabric(&fabric);

    for (int n = 0; n < 3; n++) {
        const struct law law = law_isotropic(YOUNG, ratio[n], THICKNESS);
        check_law(&law);
        check_across(&law);
    }
    check_law(&woven);
    return check_result();
}
