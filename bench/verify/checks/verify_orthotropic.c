/* Fabrics against closed forms of orthotropic sheets, for models that have them and
 * statics: heavy strips cut at any angle, strips that are pulled, a sheet that is sheared,
 * plates. Test vertex_block holds vbd against triangles. */
#include <math.h>

#include "bench/verify/verify_check.h"
#include "fem_ref/elastica.h"
#include "models/law/law.h"

/* No modulus is another's multiple by what a mistake would take for it. The cloth of strips
 * is 100 times as stiff against bending, hence ten times as thick: a strip as wide as W
 * that bends with the curvature k keeps its cross-section straight, and is up to 40 %
 * stiffer, once W^2 k / h_eff is some 10 (Searle 1908); here it is 0.05. */
static const struct law_fabric plate_cloth = {
    {2000, 5000, 800, 300}, {1e-5, 4e-5, 4e-6, 6e-6}, 0, 0.1};
static const struct law_fabric strip_cloth = {
    {2000, 5000, 800, 300}, {1e-3, 4e-3, 4e-4, 6e-4}, 0, 0.1};

static const double angles[] = {0, 90, 30, 45, -17};
enum { ANGLES = 5, SOFT_ANGLES = 3 };

/* Adds the fabric with its warp at an angle to u, in a sheet of length 1. */
static struct law set_cloth(struct verify_trial *t, const struct law_fabric *cloth,
                            double width, double angle)
{
    const double *Y = cloth->membrane, *B = cloth->bending;
    struct law_fabric turned = *cloth;

    turned.warp = angle;
    verify_trial_set(t,
                     "sheet.width=%.17g; material={membrane: [%.17g, %.17g, %.17g, %.17g], "
                     "bending: [%.17g, %.17g, %.17g, %.17g], areal_density: %.17g, "
                     "warp: %.17g, softening: [%.17g, %.17g]}",
                     width, Y[0], Y[1], Y[2], Y[3], B[0], B[1], B[2], B[3],
                     cloth->areal_density, angle, cloth->softening[0], cloth->softening[1]);
    return law_of_fabric(&turned);
}

/* Fails a claim that a model does not run, although it says that it has such fabrics. */
static void must_run(struct verify_trial *t, double angle)
{
    const unsigned needs = fmod(angle, 90) == 0 ? SCENE_NEED_FABRIC : SCENE_NEED_BIAS;

    if (t->row->verdict == VERDICT_NOT_APPLICABLE && !isnan(t->row->tolerance) &&
        t->subject->contestant->model->serves & needs)
        t->row->verdict = VERDICT_DIED;
}

/* --- Strips bent by their weight: 1 / (B^-1)_11. */

static const double STRIP_WIDTH = 0.005;
/* m g L^3 / B of strips along warp or weft, and of others, which twist as they bend: if
 * they bend far they wind out of their plane, and the elastica does not hold. */
enum { GAMMAS = 2 };
static const double gammas[2][GAMMAS] = {{3, 30}, {0.3, 1}};
#define STRIP 0.01, "asked of the nonlinear solid in elastica"
static const struct verify_subject strip_subjects[] = {
    {"shell_3,shell_selective_3", STRIP, {16, 32}, {4, 4}, 2},
    {"iga_selective_3", STRIP, {16, 32}, {4, 4}, 2},
    {"triangles", STRIP, {40, 80}, {3, 3}},
    VERIFY_MESHES(STRIP, {40, 80}, {3, 3}),
    {"mass_spring", 0, "springs bend as a plate only in the limit", {20, 40}, {3, 5}},
    {NULL}};
static const struct verify_field strips = {strip_subjects};

static void add_strip(struct verify_subject *s)
{
    const double angle = angles[s->at], *gamma = gammas[fmod(angle, 90) != 0];
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "tip, warp at %g degrees, Gamma = %g, %g", angle,
                        gamma[0], gamma[1]);

    for (int k = 0; k < GAMMAS; k++) {
        struct elastica_point want;
        double error[VERIFY_NETS], xyz[3] = {0};
        if (!verify_sheet_holds(s->sheet, elastica_solve(gamma[k], &want)))
            return;
        for (t.net = 0; t.net < s->nets; t.net++) {
            const struct law law = set_cloth(&t, &strip_cloth, STRIP_WIDTH, angle);
            const double gravity =
                gamma[k] * law_narrow(law.matrix[LAW_BENDING]) / strip_cloth.areal_density;
            verify_trial_set(&t, "gravity=[0,0,%.17g]", -gravity);
            if (!verify_trial_tip(&t, xyz)) {
                must_run(&t, angle);
                return;
            }
            error[t.net] = hypot(xyz[0] - want.reach, -xyz[2] - want.drop) / want.drop;
        }
        verify_trial_worst(&t, -xyz[2], want.drop, error, 1e-10);
    }
}

/* --- The same with softening: M = B k + C k |k| along warp and weft. */

/* |C| k / B at the curvature of the linear root: within the law's range, and far beyond.
 * Subjects' second claim is that of the latter. */
static const double softness[2] = {0.3, 1.5};
#define CURLED                                                                             \
    .tolerance = 0.01, .second = 0.05,                                                     \
    .reason = "rims curl across as the linear law says: 5 % are allowed beyond the range", \
    .changed = "0.01 for both, on 80x3; missed by 0.011 and 0.09"
static const struct verify_subject soft_subjects[] = {
    {"shell_selective_3", STRIP, {16, 32}, {4, 4}, 2},
    {"triangles", .along = {160, 320}, .across = {5, 9}, CURLED},
    {"mass_spring_momentum", .along = {80}, .across = {5}, CURLED},
    {NULL}};
static const struct verify_field soft_strips = {soft_subjects};

static void add_soft_strip(struct verify_subject *s)
{
    const double angle = angles[s->at / 2], gamma = gammas[fmod(angle, 90) != 0][0];
    const double soft = softness[s->at % 2];
    struct verify_subject claim = *s;
    if (s->at % 2 && s->second > 0)
        claim.tolerance = s->second;
    struct verify_trial t = verify_trial_of(
        &claim, "cantilever", "tip, |C| k = %g B, warp at %g degrees", soft, angle);
    struct law_fabric cloth = strip_cloth;
    struct elastica_point want;
    double error[VERIFY_NETS], xyz[3] = {0};

    cloth.warp = angle;
    for (int d = 0; d < 2; d++)
        cloth.softening[d] = -soft * cloth.bending[d] / (gamma / 2);
    const struct law law = law_of_fabric(&cloth);
    const double weight = gamma * law_narrow(law.matrix[LAW_BENDING]);
    const double bar = elastica_soft(&law, weight, &want);
    for (t.net = 0; t.net < s->nets; t.net++) {
        set_cloth(&t, &cloth, STRIP_WIDTH, angle);
        verify_trial_set(&t, "gravity=[0,0,%.17g]", -weight / cloth.areal_density);
        if (!verify_trial_tip(&t, xyz)) {
            must_run(&t, angle);
            return;
        }
        error[t.net] = hypot(xyz[0] - want.reach, -xyz[2] - want.drop) / want.drop;
    }
    verify_trial_worst(&t, -xyz[2], want.drop, error, bar / want.drop);
}

/* --- Strips pulled along their length: 1 / (A^-1)_11. */

static const struct verify_subject flat_subjects[] = {
    {"shell_3,shell_selective_3", 0.005, "splines have its strain", {15, 30}, {5, 6}},
    {"iga_selective_3", 0.005, "splines have its strain", {15, 30}, {5, 6}},
    {"triangles", 0.01, "constant strains on each side of u = 1/2", {21, 41}, {5, 9}},
    {"mass_spring", 0.02, "rims are as the inside", {21, 41}, {4, 7}},
    {NULL}};
static const struct verify_field flat = {flat_subjects};

static const double PULL = 0.05 /* [N] */, PULL_WIDTH = 0.05;

static double stretch(struct verify_trial *t, void *context)
{
    const double uvw[2][3] = {{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    double xyz[2][3] = {{0}};

    set_cloth(t, &strip_cloth, PULL_WIDTH, *(double *)context);
    verify_trial_set(t, "gravity=[0,0,0]; loads=[{at: {u: 1}, force: [%.17g, 0, 0]}]",
                     PULL);
    verify_trial_equilibrium(t, 2, uvw[0], xyz[0]);
    return (xyz[1][0] - xyz[0][0]) / 0.5 - 1;
}

static void add_pull(struct verify_subject *s)
{
    struct law_fabric cloth = strip_cloth;
    double angle = angles[s->at];
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "stretch, warp at %g degrees", angle);

    cloth.warp = angle;
    const struct law law = law_of_fabric(&cloth);
    const double want = PULL / PULL_WIDTH / law_narrow(law.matrix[LAW_MEMBRANE]);
    verify_trial_nets(&t, stretch, &angle, want, 1.5 * want); /* of Green's strain */
    must_run(&t, angle);
}

/* --- A sheet sheared by a load along v, whose sides only slide so: u_y = m g x (2 L - x) /
 * 2 G, whatever the other moduli. */

static const double SHEAR = 2, SHEAR_WIDTH = 0.2; /* gravity along v [m/s^2] */

static double shear(struct verify_trial *t, void *context)
{
    double xyz[3] = {0};

    set_cloth(t, &strip_cloth, SHEAR_WIDTH, *(double *)context);
    verify_trial_set(t,
                     "gravity=[0,%.17g,0]; supports=[{at: {u: 0, w: 0.5}, fix: xyz}, "
                     "{at: {v: 0}, fix: xz}, {at: {v: 1}, fix: xz}]",
                     SHEAR);
    verify_trial_tip(t, xyz);
    return xyz[1] - SHEAR_WIDTH / 2;
}

static void add_shear(struct verify_subject *s)
{
    double angle = 90 * s->at;
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "shear, warp at %g degrees", angle);

    verify_trial_nets(
        &t, shear, &angle,
        strip_cloth.areal_density * SHEAR / (2 * strip_cloth.membrane[LAW_SHEAR]), 1e-4);
    must_run(&t, angle);
}

/* --- An oblong plate supported on four sides, after Navier. */

static const double PLATE_WIDTH = 0.7;
enum { MODES = 8, TERMS = 99 };

static const struct verify_subject plate_subjects[] = {
    {"shell_linear_3,shell_selective_3", 0.005, "half of what is asked of solids", {8, 16}},
    {"iga_selective_linear_3,iga_selective_3", 0.01, "asked of cured solids", {8, 16}},
    {"triangles", 0.02, "asked of cured plates that vibrate", {16, 32}},
    {NULL}};
static const struct verify_field plates = {plate_subjects};

/* Returns the stiffness of bending into m by n half waves. */
static double wave_stiffness(const struct law *law, int m, int n)
{
    const double *B = law->matrix[LAW_BENDING], a = acos(-1) * m,
                 b = acos(-1) * n / PLATE_WIDTH;

    return B[LAW_11] * pow(a, 4) + 2 * (B[LAW_12] + 2 * B[LAW_33]) * a * a * b * b +
           B[LAW_22] * pow(b, 4);
}

/* Returns the deflection of the centre under a load of 1 Pa. */
static double navier(const struct law *law)
{
    double sum = 0;

    for (int m = 1; m <= TERMS; m += 2)
        for (int n = 1; n <= TERMS; n += 2)
            sum += ((m + n) % 4 == 2 ? 1 : -1) * 16 /
                   (acos(-1) * acos(-1) * m * n * wave_stiffness(law, m, n));
    return sum;
}

static double sag(struct verify_trial *t, void *context)
{
    double xyz[3] = {0};
    const struct law law = set_cloth(t, &plate_cloth, PLATE_WIDTH, *(double *)context);
    /* 1/50 of the thickness: the plane is hardly stretched */
    const double load = law.thickness / 50 / navier(&law);

    verify_trial_set(t, "gravity=[0,0,%.17g]", -load / plate_cloth.areal_density);
    verify_trial_equilibrium(t, 1, (double[]){0.5, 0.5, 0.5}, xyz);
    return -xyz[2] / load;
}

/* Judges the worst of three modes; those in the plane lie among them, so that the nearest
 * of those found counts. */
static void add_modes(struct verify_subject *s, double angle)
{
    static const int waves[][2] = {{1, 1}, {2, 1}, {1, 2}};
    double omega[VERIFY_NETS][MODES];
    struct verify_trial t = verify_trial_of(
        s, "navier", "plate's omega [rad/s], worst of 3, warp at %g degrees", angle);
    struct law law;

    for (t.net = 0; t.net < s->nets; t.net++) {
        law = set_cloth(&t, &plate_cloth, PLATE_WIDTH, angle);
        verify_trial_set(&t, "gravity=[0,0,0]");
        if (!verify_trial_modes(&t, false, MODES, omega[t.net])) {
            must_run(&t, angle);
            return;
        }
    }
    for (int k = 0; k < 3; k++) {
        const double want = sqrt(wave_stiffness(&law, waves[k][0], waves[k][1]) /
                                 plate_cloth.areal_density);
        double error[VERIFY_NETS], found = NAN;
        for (int net = 0; net < s->nets; net++) {
            found = INFINITY;
            for (int n = 0; n < MODES; n++)
                if (fabs(omega[net][n] - want) < fabs(found - want))
                    found = omega[net][n];
            error[net] = fabs(found / want - 1);
        }
        verify_trial_worst(&t, found, want, error, 0);
    }
}

static void add_plate(struct verify_subject *s)
{
    double angle = 90 * s->at;
    struct verify_trial t = verify_trial_of(
        s, "navier", "plate's deflection under 1 Pa [m], warp at %g degrees", angle);
    struct law_fabric cloth = plate_cloth;

    cloth.warp = angle;
    const struct law law = law_of_fabric(&cloth);
    verify_trial_nets(&t, sag, &angle, navier(&law), 1e-6);
    must_run(&t, angle);
    add_modes(s, angle);
}

const struct verify_check verify_orthotropic = {
    {"orthotropic",
     "fabrics: strips at any angle bent and pulled, softening, shear, plates"},
    "the elastica with 1 / (B^-1)_11, and with softening by shooting, rods with 1 / "
    "(A^-1)_11, shear by G, Navier's "
    "orthotropic plate; moduli in bench/verify/checks/verify_orthotropic.c",
    .parts = {{&strips, add_strip, ANGLES},
              {&soft_strips, add_soft_strip, 2 * SOFT_ANGLES},
              {&flat, add_pull, ANGLES},
              {&flat, add_shear, 2},
              {&plates, add_plate, 2}}};
