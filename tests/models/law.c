/* The law of the sheet: stress against differences of the energy, turned axes against
 * turned strains, curved parameters against plain ones, strips of any angle, isotropic
 * sheets. */
#include "models/law/law.h"

#include "tests/check.h"
#include "tests/noise.h"

/* Sums of a few products of order one. */
static const double ROUNDING = 1e-13;

/* A denim-like fabric whose moduli have no ratio in common, so that no two can be mixed up.
 */
static const struct law_fabric DENIM = {
    {1700, 3200, 900, 810}, {1.1e-4, 2.2e-4, 0.4e-4, 0.7e-4}, 25};

static void fill(double e[3], int seed)
{
    for (int i = 0; i < 3; i++)
        e[i] = noise(3 * seed + i);
}

static void check_stress(void)
{
    const double step = 0.5; /* exact: the energy is quadratic */
    const struct law law = law_of_fabric(&DENIM);

    for (int part = 0; part < LAW_PARTS; part++) {
        const double *M = law.matrix[part], scale = M[LAW_11];
        double e[3], s[3];
        fill(e, part);
        law_stress(M, e, s);
        for (int i = 0; i < 3; i++) {
            double up[3] = {e[0], e[1], e[2]}, down[3] = {e[0], e[1], e[2]};
            up[i] += step, down[i] -= step;
            CHECK_NEAR((law_energy(M, up) - law_energy(M, down)) / scale, s[i] / scale,
                       ROUNDING);
        }
    }
}

/* Strains (11, 22, 2 12) along axes turned by an angle, from the tensor itself. */
static void strain_along(const double e[3], double degrees, double out[3])
{
    const double t = degrees * acos(-1) / 180, a[2] = {cos(t), sin(t)},
                 b[2] = {-a[1], a[0]};
    const double E[2][2] = {{e[0], e[2] / 2}, {e[2] / 2, e[1]}};

    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            out[0] += a[i] * E[i][j] * a[j];
            out[1] += b[i] * E[i][j] * b[j];
            out[2] += 2 * a[i] * E[i][j] * b[j];
        }
}

/* The energy in warp's axes is the moduli's own, wherever the warp runs; and a right angle
 * exchanges warp and weft to the bit. */
static void check_turn(void)
{
    static const double angles[] = {0, 25, 45, 90, 135, -70, 180, 270};

    for (size_t n = 0; n < sizeof angles / sizeof *angles; n++) {
        struct law_fabric fabric = DENIM;
        fabric.warp = angles[n];
        const struct law law = law_of_fabric(&fabric);
        const double *B = fabric.bending;
        double k[3], own[3];
        fill(k, (int)n);
        strain_along(k, fabric.warp, own);
        CHECK_RELATIVE(law_energy(law.matrix[LAW_BENDING], k),
                       (B[LAW_WARP] * own[0] * own[0] + B[LAW_WEFT] * own[1] * own[1]) / 2 +
                           B[LAW_CROSS] * own[0] * own[1] +
                           2 * B[LAW_SHEAR] * (own[2] / 2) * (own[2] / 2),
                       ROUNDING);
        CHECK(law_is_aligned(&law) == (fmod(angles[n], 90) == 0));
        const bool swapped = fmod(angles[n], 180) != 0;
        if (law_is_aligned(&law))
            CHECK(law.matrix[LAW_MEMBRANE][LAW_11] == fabric.membrane[swapped]);
    }
}

/* Parameters that stretch and lean: e_uv = a_u . E a_v. */
static void check_surface(bool isotropic)
{
    const struct law law = isotropic ? law_isotropic(3, 0.3, 0.1) : law_of_fabric(&DENIM);
    const double u[2] = {1.7, 0}, v[2] = {0.6, 0.8}; /* u runs along the first axis */
    const double metric[3] = {u[0] * u[0], v[0] * v[0] + v[1] * v[1], u[0] * v[0]};
    const double h = law.thickness, over[] = {1 / h, 12 / (h * h * h)};

    for (int part = 0; part < LAW_PARTS; part++) {
        double M[LAW_ENTRIES], e[3], share[2];
        fill(e, part);
        const double E[2][2] = {{e[0], e[2] / 2}, {e[2] / 2, e[1]}};
        double covariant[3] = {0};
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++) {
                covariant[0] += u[i] * E[i][j] * u[j];
                covariant[1] += v[i] * E[i][j] * v[j];
                covariant[2] += 2 * u[i] * E[i][j] * v[j];
            }
        law_on_surface(&law, (enum law_part)part, metric,
                       metric[0] * metric[1] - metric[2] * metric[2], M);
        CHECK_RELATIVE(law_energy(M, covariant),
                       over[part] * law_energy(law.matrix[part], e), ROUNDING);
        /* what is left is singular, and not negative in any strain tried */
        law_shares(&law, metric, M, share);
        M[LAW_11] -= share[0], M[LAW_22] -= share[1];
        const double det = M[LAW_11] * (M[LAW_22] * M[LAW_33] - M[LAW_23] * M[LAW_23]) -
                           M[LAW_12] * (M[LAW_12] * M[LAW_33] - M[LAW_23] * M[LAW_13]) +
                           M[LAW_13] * (M[LAW_12] * M[LAW_23] - M[LAW_22] * M[LAW_13]);
        const double scale = M[LAW_11] + M[LAW_22] + M[LAW_33];
        CHECK_NEAR(det / (scale * scale * scale), 0, ROUNDING);
        for (int n = 0; n < 100; n++) {
            fill(e, n);
            CHECK(law_energy(M, e) >= -ROUNDING * scale);
        }
    }
}

/* A narrow strip's stiffness is the least energy over what its sides are free to do. */
static void check_strip(void)
{
    const double tiny = 1e-3;
    const struct law law = law_of_fabric(&DENIM);
    const double *B = law.matrix[LAW_BENDING];
    double inverse[LAW_ENTRIES], s[3];

    law_invert(B, inverse);
    const double k[3] = {1, inverse[LAW_12] / inverse[LAW_11],
                         inverse[LAW_13] / inverse[LAW_11]};
    law_stress(B, k, s);
    CHECK_RELATIVE(s[0], law_narrow(B), ROUNDING);
    CHECK_NEAR(s[1] / s[0], 0, ROUNDING);
    CHECK_NEAR(s[2] / s[0], 0, ROUNDING);
    for (int n = 0; n < 20; n++) {
        const double other[3] = {1, k[1] + tiny * noise(n), k[2] + tiny * noise(n + 50)};
        CHECK(law_energy(B, other) >= law_energy(B, k));
    }
    const struct law plain = law_isotropic(3, 0.3, 0.1);
    CHECK_RELATIVE(law_narrow(plain.matrix[LAW_MEMBRANE]), 0.3, ROUNDING); /* E h */
}

/* Softening: energy, moment and tangent are each other's derivatives, below and above the
 * greatest curvature of C k |k|, where the tangent stays; the whole tangent is positive. */
static void check_softening(void)
{
    const double step = 1e-4;       /* of `most` */
    const double DIFFERENCE = 1e-6; /* step^2 / 3, over the least share tried, squared */
    struct law_fabric fabric = DENIM;

    fabric.softening[0] = -3e-7, fabric.softening[1] = -5e-7;
    const struct law law = law_of_fabric(&fabric);
    CHECK(law.softens && !law_of_fabric(&DENIM).softens);
    for (int i = 0; i < 2; i++) {
        const struct law_soft *s = &law.soft[i];
        double least, B[LAW_ENTRIES] = {[LAW_12] = fabric.bending[LAW_CROSS]};
        for (double share = -2.1; share < 2.2; share += 0.2) {
            const double k = share * s->most, h = step * s->most;
            double tangent, other, up = law_soft_moment(s, k + h, &other),
                                   down = law_soft_moment(s, k - h, &other);
            const double moment = law_soft_moment(s, k, &tangent);
            const double slope = law_soft_energy(s, k + h) - law_soft_energy(s, k - h);
            CHECK_RELATIVE(slope / (2 * h), moment, DIFFERENCE);
            CHECK_RELATIVE((up - down) / (2 * h), tangent, DIFFERENCE);
            if (fabs(share) < 1)
                CHECK_RELATIVE(moment, fabric.softening[i] * k * fabs(k), ROUNDING);
        }
        for (int n = 0; n < 2; n++) {
            law_soft_moment(&law.soft[n], 1e6, &least);
            B[n ? LAW_22 : LAW_11] = fabric.bending[n] + least;
        }
        CHECK(B[LAW_11] > 0 && B[LAW_11] * B[LAW_22] > B[LAW_12] * B[LAW_12]);
    }
    /* along the warp: the strain turned there */
    const double k[3] = {0.3, -0.7, 0.9};
    double own[3];
    strain_along(k, fabric.warp, own);
    for (int i = 0; i < 2; i++)
        CHECK_NEAR(law.along[i][0] * k[0] + law.along[i][1] * k[1] + law.along[i][2] * k[2],
                   own[i], ROUNDING);
}

/* A fabric with an isotropic sheet's moduli is that sheet, at any angle. */
static void check_isotropic(void)
{
    const double young = 3e5, nu = 0.3, h = 1e-3;
    const struct law plain = law_isotropic(young, nu, h);
    struct law_fabric fabric = {.warp = 33};

    for (int part = 0; part < LAW_PARTS; part++) {
        const double *m = plain.matrix[part];
        double *to = part == LAW_BENDING ? fabric.bending : fabric.membrane;
        to[LAW_WARP] = m[LAW_11], to[LAW_WEFT] = m[LAW_22];
        to[LAW_CROSS] = m[LAW_12], to[LAW_SHEAR] = m[LAW_33];
        CHECK(law_definite(to));
    }
    const struct law law = law_of_fabric(&fabric);
    CHECK_RELATIVE(law.thickness, h, ROUNDING);
    CHECK_RELATIVE(law.young, young, ROUNDING);
    CHECK_RELATIVE(law.poisson, nu, ROUNDING);
    for (int part = 0; part < LAW_PARTS; part++)
        for (int k = 0; k < LAW_ENTRIES; k++)
            CHECK_NEAR(law.matrix[part][k] / plain.matrix[part][LAW_11],
                       plain.matrix[part][k] / plain.matrix[part][LAW_11], ROUNDING);
}

static void check_definite(void)
{
    static const double indefinite[][LAW_MODULI] = {{-1, 1, 0, 1},   {1, 0, 0, 1},
                                                    {1, 1, 0, -1},   {1, 4, 2, 1},
                                                    {1, 4, -2.5, 1}, {1, 1, NAN, 1}};
    static const double definite[][LAW_MODULI] = {{1, 4, 1.9, 1}, {1, 4, -1.9, 1e-3}};

    for (size_t n = 0; n < sizeof indefinite / sizeof *indefinite; n++)
        CHECK(!law_definite(indefinite[n]));
    for (size_t n = 0; n < sizeof definite / sizeof *definite; n++)
        CHECK(law_definite(definite[n]));
}

int main(void)
{
    check_stress();
    check_turn();
    check_surface(true);
    check_surface(false);
    check_strip();
    check_softening();
    check_isotropic();
    check_definite();
    return check_result();
}
