/* Springs matched to E, nu, h: small-strain membrane and bending against plane stress and
 * Kirchhoff's plate. */
#include <float.h>
#include <omp.h>

#include "tests/mass_spring.h"
#include "tests/opened_run.h"

/* A sheet that lies askew, so that no product of components vanishes by chance. */
static void fill_askew(struct scene *scene, double poisson)
{
    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 0.8;
    scene->width = 0.7;
    scene->thickness = 0.003;
    scene->young = 2e5;
    scene->poisson = poisson;
    const double u[3] = {2. / 3, 2. / 3, 1. / 3}, v[3] = {-2. / 3, 1. / 3, 2. / 3};
    memcpy(scene->axis_u, u, sizeof u);
    memcpy(scene->axis_v, v, sizeof v);
}

/* d' K d / 2 at rest for a field d. */
static double quadratic(struct spring_motion *m, const double *d)
{
    double *Kd = malloc(3 * (size_t)m->net.mesh.nodes * sizeof *Kd), sum = 0;

    REQUIRE(Kd);
    spring_force_jacobian(&m->springs, m->net.mesh.rest, m->march.K);
    blocks_multiply(&m->springs.graph, (const double(*)[9])m->march.K, d, Kd);
    for (int t = 0; t < 3 * m->net.mesh.nodes; t++)
        sum += d[t] * Kd[t] / 2;
    free(Kd);
    return sum;
}

/* Energy of the small homogeneous strain e = (e_u, e_v, g), or of w = (a s^2 + b t^2) / 2 +
 * c s t with the curvatures (a, b, c). */
static double energy(const struct scene *scene, int n, int m, bool bends, const double e[3])
{
    struct spring_motion motion;
    struct discretization d = net_of(n, m);
    const double *u = scene->axis_u, *v = scene->axis_v;
    double normal[3];

    scene_normal(scene, normal);
    REQUIRE(spring_motion_init(&motion, scene, &d, NULL) == STATUS_OK);
    double *field = malloc(3 * (size_t)motion.net.mesh.nodes * sizeof *field);
    REQUIRE(field);
    for (int a = 0; a < motion.net.mesh.nodes; a++) {
        const double s = motion.net.mesh.uvw[a][0] * scene->length;
        const double t = motion.net.mesh.uvw[a][1] * scene->width;
        const double w = e[0] * s * s / 2 + e[1] * t * t / 2 + e[2] * s * t;
        for (int i = 0; i < 3; i++)
            field[3 * a + i] =
                bends ? w * normal[i]
                      : (e[0] * s + e[2] / 2 * t) * u[i] + (e[2] / 2 * s + e[1] * t) * v[i];
    }
    double sum = quadratic(&motion, field);
    free(field);
    spring_motion_clear(&motion);
    return sum;
}

static double membrane_energy(const struct scene *scene, int n, int m, const double e[3])
{
    return energy(scene, n, m, false, e) / (scene->length * scene->width);
}

static double plane_stress_energy(const struct spring_law_stiffness *c, const double e[3])
{
    return c->c11 * e[0] * e[0] / 2 + c->c22 * e[1] * e[1] / 2 + c->c12 * e[0] * e[1] +
           c->c33 * e[2] * e[2] / 2;
}

/* Sums over a few hundred springs, whose directions and rest lengths are rounded. */
static const double sum_rounding = 1e-11;

static const struct {
    const char *name;
    double e[3];
} STRAINS[] = {{"stretch along u", {1, 0, 0}},
               {"stretch along v", {0, 1, 0}},
               {"uniaxial stress", {1, -1. / 3, 0}},
               {"biaxial stretch", {1, 1, 0}},
               {"shear", {0, 0, 1}},
               {"all", {0.3, -0.8, 0.5}}};

enum { STRAIN_COUNT = sizeof STRAINS / sizeof *STRAINS };

/* Returns the stress along u of a strain of 1 along it, with free sides. */
static double tension(struct spring_law_stiffness c)
{
    return c.c11 - c.c12 * c.c12 / c.c22;
}

/* What spring_law_effective says is what the net does, whatever the cells; tension with
 * free sides, E h, and C33 are plane stress's, C12 = C33, which is its at nu = 1/3. */
static void check_misfit(void)
{
    static const struct {
        double poisson;
        int n, m;
    } rows[] = {{0, 9, 8},      {0.2, 9, 8},    {0.3, 2, 2},
                {1. / 3, 9, 8}, {1. / 3, 7, 7}, {0.45, 9, 8}};

    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        struct scene scene;
        struct spring_law law;
        const int n = rows[k].n, m = rows[k].m;
        fill_askew(&scene, rows[k].poisson);
        const double cell[2] = {scene.length / (n - 1), scene.width / (m - 1)};
        spring_law_make(&scene, PARAMETERS_MATCHED, cell, &law);
        struct spring_law_stiffness net = spring_law_effective(&law, cell);
        struct spring_law_stiffness sheet = spring_law_plane_stress(&scene);
        CHECK_RELATIVE(tension(net), scene.young * scene.thickness, sum_rounding);
        CHECK_RELATIVE(net.c22, net.c11, sum_rounding);
        CHECK_RELATIVE(net.c33, sheet.c33, sum_rounding);
        CHECK_RELATIVE(net.c12, sheet.c33, sum_rounding);
        for (int t = 0; t < STRAIN_COUNT; t++)
            SAY_UNLESS(CHECK_RELATIVE(membrane_energy(&scene, n, m, STRAINS[t].e),
                                      plane_stress_energy(&net, STRAINS[t].e),
                                      sum_rounding),
                       "%s", STRAINS[t].name);
        scene_clear(&scene);
    }
}

/* Cells too long for their width, or too wide: the springs along them keep their share,
 * without which the colours of a chequered board slide past each other; tension with free
 * sides is plane stress's, and the shear that is missing is owned up to. */
static void check_oblong(void)
{
    static const double cells[][2] = {{0.3, 0.1}, {0.1, 0.3}}, KEPT = 0.4;

    for (int k = 0; k < 2; k++) {
        struct scene scene;
        struct spring_law law;
        fill_askew(&scene, 0.3);
        spring_law_make(&scene, PARAMETERS_MATCHED, cells[k], &law);
        struct spring_law_stiffness net = spring_law_effective(&law, cells[k]);
        for (int n = 0; n < SPRING_DIRECTIONS; n++)
            CHECK(law.stiffness[n] >= 0 && law.strut[n] >= 0);
        CHECK_RELATIVE(law.stiffness[k] * cells[k][k] / cells[k][1 - k], KEPT * net.c11,
                       sum_rounding);
        CHECK_RELATIVE(tension(net), scene.young * scene.thickness, sum_rounding);
        CHECK_RELATIVE(net.c22, net.c11, sum_rounding);
        CHECK(net.c33 < 0.5 * spring_law_plane_stress(&scene).c33);
        scene_clear(&scene);
    }
}

/* Kirchhoff's energy. Cylindrical bending: exact for every nu over the part that hinges
 * cover (one stands for the area around its centre, one on the rim for half of it). Any
 * bending at nu = 1/3: exact per hinge, so first order for the strip they leave out. */
static void check_bending(void)
{
    /* P / a against k: springs' own transverse stiffness is k times a rounded 1 - r/l */
    const double spring_rounding = 1e-8;
    const int n = 9, m = 8;
    struct scene scene;

    for (int step = 0; step < 4; step++) {
        fill_askew(&scene, step / 9.);
        double D = scene_bending_stiffness(&scene), L = scene.length, W = scene.width;
        CHECK_RELATIVE(energy(&scene, n, m, true, (double[]){1, 0, 0}),
                       D / 2 * W * L * (n - 2) / (n - 1), spring_rounding);
        CHECK_RELATIVE(energy(&scene, n, m, true, (double[]){0, 1, 0}),
                       D / 2 * L * W * (m - 2) / (m - 1), spring_rounding);
        scene_clear(&scene);
    }
    fill_askew(&scene, 1. / 3);
    double D = scene_bending_stiffness(&scene), nu = scene.poisson, error[3][3];
    static const double curvatures[3][3] = {{1, 1, 0}, {1, -1, 0}, {0, 0, 1}};
    for (int level = 0; level < 3; level++)
        for (int k = 0; k < 3; k++) {
            const double *c = curvatures[k];
            int cells = 8 << level;
            double want = D / 2 * scene.length * scene.width *
                          (c[0] * c[0] + c[1] * c[1] + 2 * nu * c[0] * c[1] +
                           2 * (1 - nu) * c[2] * c[2]);
            error[level][k] = energy(&scene, cells + 1, cells + 1, true, c) / want - 1;
        }
    for (int k = 0; k < 3; k++)
        for (int level = 1; level < 3; level++) {
            const double least_rate = 1.8; /* 2 and terms of second order */
            double rate = error[level - 1][k] / error[level][k];
            CHECK_SAY(rate > least_rate && fabs(error[level][k]) < 2. / (8 << level) * 1.2,
                      "curvature %d, level %d: error %g, rate %g", k, level,
                      error[level][k], rate);
        }
    scene_clear(&scene);
}

/* A strip that is pulled by what stretches the sheet by a twentieth gives way 1.5 e more
 * where springs are linear in their length, and says so; else as the sheet does. */
static void check_pull(void)
{
    static const double strain = 0.05, few = 0.006; /* of the strain; e^2 and the net's */
    static const char *const who[] = {"mass_spring", "mass_spring_momentum"};
    static const double end[3] = {1, 0.5, 0.5};

    for (int n = 0; n < 2; n++) {
        struct message line = {""};
        struct run run;
        double x[3];
        opened_run(&run, SOURCE_DIR "/tests/cases/pull.yaml", who[n], 0, NULL);
        opened_steps(&run, (int)lround(run.scene.end / run.scene.step));
        run.model->probe(run.state, 1, end, x);
        run.model->describe(run.state, &line);
        const double more = (x[0] / run.scene.length - 1) / strain - 1;
        CHECK_NEAR(more, n ? 0 : 1.5 * strain, few);
        CHECK(!strstr(line.text, "1.5 e less") == (n == 1));
        run_close(&run);
    }
}

int main(void)
{
    omp_set_num_threads(1);
    check_pull();
    check_misfit();
    check_oblong();
    check_bending();
    return check_result();
}
