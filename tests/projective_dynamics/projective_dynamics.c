/* The energy of projective dynamics: local steps that are its gradient, as those of the
 * nearest points are, strains that cost what plane stress costs, bending that is
 * Kirchhoff's. */
#include <float.h>

#include "fem_ref/kirchhoff.h"
#include "tests/pd_fixture.h"

/* --- gradients ---------------------------------------------------------------------------
 */

/* y = A x, three fields, held nodes as if free. */
static void multiply(const struct pd_system *s, const double *x, double *y)
{
    const struct pd_net *net = s->net;
    const struct blocks *g = &s->graph;
    const ptrdiff_t stride = pd_net_stride(net);

    for (int c = 0; c < 3; c++, x += stride, y += stride) {
        memset(y, 0, (size_t)net->nodes * sizeof *y);
        for (int k = 0; k < net->nodes; k++)
            for (long n = g->start[k]; n < g->start[k + 1]; n++) {
                y[k] += s->entry[n] * x[g->node[n]];
                if (g->node[n] != k)
                    y[g->node[n]] += s->entry[n] * x[k];
            }
    }
}

/* A x - M x - local step - constant, over dt^2: dE/dx. */
static void gradient(struct pd_motion *m, const double *x, double *g)
{
    const struct pd_net *net = &m->energy.net;
    double *pulled = pd_net_fields(net, 3);

    multiply(&m->system, x, g);
    pd_local_step(&m->local, x, m->system.constant, pulled);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++) {
            ptrdiff_t at = c * pd_net_stride(net) + k;
            g[at] = (g[at] - m->energy.mass[k] * x[at] - pulled[at]) / (m->dt * m->dt);
        }
    pd_net_free_fields(net, pulled);
}

/* The best of a sweep of steps, on a grid or a mesh: error of (E(x+s) - E(x-s)) / 2s
 * against the gradient. */
static void check_gradient(char *mesh, enum constraint constraint,
                           enum parameters parameters, double nu)
{
    /* At the best step truncation and rounding meet near eps^(2/3) = 4e-11 of the largest
     * entry, times the sum's length over one term's. */
    const double tol_gradient = 1e-7;
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(7, 5, constraint);
    double largest = 0, worst = 0, force[3] = {0}, torque[3] = {0};

    o.parameters = parameters;
    o.mesh = mesh;
    pd_fixture_scene(&scene, nu);
    scene.width = 0.7;
    pd_fixture_hold(&scene, 0, 0, 0, 1, FIX_XYZ); /* clamps have a gradient too */
    pd_fixture_motion(&m, &scene, &o);
    const struct pd_net *net = &m.energy.net;
    double *g = pd_net_fields(net, 3);
    pd_fixture_shake(net, m.x, 0.04, 11);
    gradient(&m, m.x, g);
    for (int k = 0; k < net->nodes; k++)
        for (int c = 0; c < 3; c++)
            largest = fmax(largest, fabs(g[c * pd_net_stride(net) + k]));
    for (int k = 0; k < net->nodes; k++)
        for (int c = 0; c < 3; c++) {
            ptrdiff_t at = c * pd_net_stride(net) + k;
            double keep = m.x[at], best = INFINITY;
            for (double s = 1e-3; s > 1e-8; s /= 4) {
                m.x[at] = keep + s;
                double ahead = pd_energy_value(&m.energy, m.x);
                m.x[at] = keep - s;
                double behind = pd_energy_value(&m.energy, m.x);
                best = fmin(best, fabs((ahead - behind) / (2 * s) - g[at]));
            }
            m.x[at] = keep;
            worst = fmax(worst, best / largest);
        }
    CHECK_NEAR(worst, 0, tol_gradient);
    pd_motion_clear(&m);

    /* Unsupported, it neither pushes nor turns itself. */
    const double tol_balance = 1e-11; /* 35 nodes, positions about 1 m, 1e3 eps */
    scene.support_count = 0;
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_shake(net, m.x, 0.04, 12);
    gradient(&m, m.x, g);
    for (int k = 0; k < net->nodes; k++)
        for (int c = 0; c < 3; c++) {
            ptrdiff_t stride = pd_net_stride(net), p = (c + 1) % 3 * stride + k,
                      q = (c + 2) % 3 * stride + k;
            force[c] += k < m.mesh.vertices ? g[c * stride + k] / largest : 0;
            torque[c] += (m.x[p] * g[q] - m.x[q] * g[p]) / largest;
        }
    for (int c = 0; c < 3; c++) {
        CHECK_NEAR(force[c], 0, tol_balance);
        CHECK_NEAR(torque[c], 0, tol_balance);
    }
    pd_net_free_fields(net, g);
    pd_motion_clear(&m);
    scene.support_count = 1;
    scene_clear(&scene);
}

/* At rest nothing pulls, whichever edge or line is clamped. */
static void check_rest(void)
{
    static const double line[][4] = {{0, 0, 0, 1}, {1, 1, 0, 1},     {0, 1, 0, 0},
                                     {0, 1, 1, 1}, {0.5, 0.5, 0, 1}, {0, 0.5, 0, 1}};
    const double tol_rest = 1e-12; /* N; weights up to 1e3 N/m times eps */

    for (size_t n = 0; n < sizeof line / sizeof *line; n++) {
        struct scene scene;
        struct pd_motion m;
        struct pd_options o = pd_fixture_options(7, 5, CONSTRAINT_TRIANGLES);
        pd_fixture_scene(&scene, 0.3);
        pd_fixture_hold(&scene, line[n][0], line[n][1], line[n][2], line[n][3], FIX_XYZ);
        pd_fixture_motion(&m, &scene, &o);
        double *g = pd_net_fields(&m.energy.net, 3),
               *zero = pd_net_fields(&m.energy.net, 3);
        gradient(&m, m.x, g);
        CHECK_NEAR(pd_fixture_distance(&m.energy.net, g, zero), 0, tol_rest);
        CHECK(pd_energy_value(&m.energy, m.x) == 0);
        pd_net_free_fields(&m.energy.net, g);
        pd_net_free_fields(&m.energy.net, zero);
        pd_fixture_close(&m, &scene);
    }
}

/* --- matched: plane stress ---------------------------------------------------------------
 */

/* Stretch energy per area of the homogeneous strain (e_u, e_v, g_uv). */
static double strain_energy(const struct pd_energy *e, double eu, double ev, double guv)
{
    const struct pd_net *net = &e->net;
    double *x = pd_net_fields(net, 3), value;

    for (int k = 0; k < net->nodes; k++) {
        double u = k / net->m * net->du, v = k % net->m * net->dv;
        x[k] = u * (1 + eu) + v * guv / 2;
        x[pd_net_stride(net) + k] = v * (1 + ev) + u * guv / 2;
    }
    value = pd_energy_value(e, x);
    pd_net_free_fields(net, x);
    return value / (net->du * (net->n - 1) * net->dv * (net->m - 1));
}

static double plane_stress(const struct scene *scene, double eu, double ev, double guv)
{
    double nu = scene->poisson;
    double C = scene->young * scene->thickness / (1 - nu * nu);

    return C / 2 * (eu * eu + ev * ev + 2 * nu * eu * ev + (1 - nu) / 2 * guv * guv);
}

/* No modulus is another's multiple by what a mistake would take for it. */
static const struct law_fabric fabric = {
    {2000, 5000, 800, 300}, {1e-5, 4e-5, 4e-6, 6e-6}, 0, 0.1};

/* Returns the energy of edges, which have G for Y12, and the sheet's stiffness against
 * tension with free sides: Y11 - Y12^2 / Y22 along u, and so along v. */
static double edges_energy(const struct scene *scene, double eu, double ev, double guv)
{
    const struct law law = scene_law(scene);
    const double *A = law.matrix[LAW_MEMBRANE], G = A[LAW_33];
    const double free_u = A[LAW_11] - A[LAW_12] * A[LAW_12] / A[LAW_22],
                 free_v = A[LAW_22] - A[LAW_12] * A[LAW_12] / A[LAW_11];
    const double root = sqrt(free_u * free_v + 4 * G * G), mean = sqrt(free_u * free_v);
    const double C11 = (mean + root) / 2 * sqrt(free_u / free_v),
                 C22 = (mean + root) / 2 * sqrt(free_v / free_u);

    return (C11 * eu * eu + C22 * ev * ev + G * (2 * eu * ev + guv * guv)) / 2;
}

/* Pull, pull both ways, shear, and all at once. */
static void check_strains(enum constraint constraint, double nu, bool is_fabric)
{
    static const double strain[4][3] = {{1, -0.2, 0}, {1, 1, 0}, {0, 0, 1}, {0.7, -0.4, 1}};
    const double size = 1e-6;       /* the next order is as small beside the first       */
    const double tol_strain = 1e-5; /* 10 size                                           */
    const double tol_rounding = 1e-4; /* 2 eps / size^2: the energy is a difference       */
    struct scene scene;
    struct pd_energy e;
    struct mesh mesh;

    pd_fixture_scene(&scene, nu);
    scene.width = 1.1;
    if (is_fabric)
        scene.fabric = fabric, scene_use_fabric(&scene);
    REQUIRE(mesh_init(&mesh, &scene, (int[]){6, 7}) == STATUS_OK);
    REQUIRE(pd_energy_init(&e, &scene, &mesh, constraint, PARAMETERS_MATCHED) == STATUS_OK);
    e.row_count = 0;
    for (int n = 0; n < 4; n++) {
        const double *s = strain[n];
        double want = constraint == CONSTRAINT_EDGES
                          ? edges_energy(&scene, s[0], s[1], s[2])
                          : plane_stress(&scene, s[0], s[1], s[2]);
        double got = strain_energy(&e, size * s[0], size * s[1], size * s[2]);
        CHECK_RELATIVE(got / (size * size), want, tol_strain + tol_rounding);
    }
    pd_energy_clear(&e);
    mesh_clear(&mesh);
    scene_clear(&scene);
}

/* --- matched: bending --------------------------------------------------------------------
 */

/* Deflection of row i, in the middle of it, under a small load: the plate alone, without
 * stretch. */
static double deflection_at(const struct scene *scene, int n, int i)
{
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(n, n, CONSTRAINT_TRIANGLES);
    const double load = 1;

    pd_fixture_motion(&m, scene, &o);
    const struct pd_net *net = &m.energy.net;
    double *z = pd_net_fields(net, 3), *up = z + 2 * pd_net_stride(net);
    m.energy.link_count = 0;
    pd_system_clear(&m.system);
    REQUIRE(pd_system_init(&m.system, &m.energy, &m.supports, 0, 1, 1, SOLVER_AUTO) ==
            STATUS_OK);
    for (int k = 0; k < net->nodes; k++)
        up[k] = m.system.held[2 * net->nodes + k] ? 0 : m.mesh.area[k] * load;
    REQUIRE(pd_system_solve(&m.system, z) == STATUS_OK);
    double deflection = up[i * net->m + net->m / 2];
    pd_net_free_fields(net, z);
    pd_motion_clear(&m);
    return deflection / load;
}

static void check_plate(double nu)
{
    const double tol_order =
        0.25;                    /* second order; the corners' weak singularity at nu > 0 */
    const double tol_tip = 3e-3; /* at 41 x 41 nodes: 2 (h/L)^2 = 1.3e-3, measured        */
    struct scene scene;
    struct kirchhoff *k = NULL;
    double error[3];

    pd_fixture_scene(&scene, nu);
    pd_fixture_hold(&scene, 0, 0, 0, 1, FIX_XYZ);
    const struct kirchhoff_plate plate = {scene.length, scene.width,   scene.thickness,
                                          scene.young,  scene.poisson, scene.density};
    REQUIRE(kirchhoff_create(&plate, 24, &k) == STATUS_OK);
    double want = kirchhoff_static(k, 1, 1, 0.5);
    for (int n = 0; n < 3; n++)
        error[n] = deflection_at(&scene, (10 << n) + 1, 10 << n) / want - 1;
    printf(
        "tip of a clamped plate, nu %g: %.2e, %.2e, %.2e of it off at 11, 21, 41 nodes\n",
        nu, error[0], error[1], error[2]);
    CHECK_NEAR(error[2], 0, tol_tip);
    CHECK_NEAR(log2(fabs(error[1] / error[2])), 2, tol_order);
    kirchhoff_destroy(k);
    scene_clear(&scene);
}

/* The middle of a fabric's plate, hinged on four sides (Navier's series). */
static void check_fabric(double warp)
{
    enum { TERMS = 99, POINTS = 41 };
    const double tol_plate = 3e-3; /* second order: pi^2 / 12 (h/L)^2, twice four orders  */
    const double pi = acos(-1), b = 0.7, *B = fabric.bending;
    const int along = fmod(warp, 180) == 0 ? LAW_WARP : LAW_WEFT;
    struct scene scene;
    double want = 0;

    pd_fixture_scene(&scene, 0);
    scene.width = b;
    for (int edge = 0; edge < 4; edge++) {
        struct scene_support s = {.lo = {0, 0, 0.5}, .hi = {1, 1, 0.5}, .fix = FIX_XYZ};
        s.lo[edge / 2] = s.hi[edge / 2] = edge % 2;
        REQUIRE(scene_add_support(&scene, &s) == STATUS_OK);
    }
    scene.fabric = fabric, scene.fabric.warp = warp;
    scene_use_fabric(&scene);
    const double a = scene.length;
    for (int m = 1; m < TERMS; m += 2)
        for (int n = 1; n < TERMS; n += 2) {
            const double p = pow(m * pi / a, 2), q = pow(n * pi / b, 2);
            const double plate = B[along] * p * p + B[LAW_WEFT - along] * q * q +
                                 2 * (B[LAW_CROSS] + 2 * B[LAW_SHEAR]) * p * q;
            want += ((m + n) % 4 == 2 ? 16 : -16) / (pi * pi * m * n * plate);
        }
    CHECK_RELATIVE(deflection_at(&scene, POINTS, POINTS / 2), want, tol_plate);
    scene_clear(&scene);
}

/* The paper's weights are 10 of strain, squared, and 10 of mean curvature; its sheet has
 * 1 kg, and loses 0.005 of its velocity a frame. */
static void check_paper(void)
{
    const double size = 1e-5, tol_size = 1e-4; /* the next order, and 2 eps / size^2 */
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(6, 7, CONSTRAINT_TRIANGLES);
    double mass = 0, area = 0;

    o.parameters = PARAMETERS_PAPER;
    pd_fixture_scene(&scene, 0);
    scene.velocity[2] = 1;
    pd_fixture_motion(&m, &scene, &o);
    const struct pd_net *net = &m.energy.net;
    const ptrdiff_t up = 2 * pd_net_stride(net);
    pd_fixture_frames(&m, 1);
    CHECK_RELATIVE(m.v[up], 1 - 0.005, tol_size);
    CHECK_RELATIVE(strain_energy(&m.energy, size, 0, 0) / (size * size), 50.0, tol_size);
    for (int k = 0; k < net->nodes; k++) {
        const int i = k / net->m;
        m.x[up + k] = size * pow(i * net->du, 2) / 2;
        mass += m.energy.mass[k], area += i && i < net->n - 1 ? m.mesh.area[k] : 0;
    }
    CHECK_NEAR(mass, 1, tol_size);
    CHECK_RELATIVE(pd_energy_value(&m.energy, m.x) / (size * size), 5 * area, tol_size);
    pd_fixture_close(&m, &scene);
}

int main(void)
{
    check_paper();
    check_rest();
    check_gradient(NULL, CONSTRAINT_EDGES, PARAMETERS_MATCHED, 0.3);
    check_gradient("irregular", CONSTRAINT_EDGES, PARAMETERS_MATCHED, 0.3);
    check_gradient(NULL, CONSTRAINT_TRIANGLES, PARAMETERS_MATCHED, 0.3);
    check_gradient("irregular", CONSTRAINT_TRIANGLES, PARAMETERS_MATCHED, 0.3);
    check_gradient(NULL, CONSTRAINT_TRIANGLES, PARAMETERS_MATCHED, -0.4);
    check_gradient("irregular", CONSTRAINT_TRIANGLES, PARAMETERS_MATCHED, -0.4);
    check_gradient(NULL, CONSTRAINT_TRIANGLES, PARAMETERS_PAPER, 0.3);
    check_gradient(NULL, CONSTRAINT_EDGES, PARAMETERS_PAPER, 0.3);
    for (double nu = -0.4; nu < 0.5; nu += 0.2)
        check_strains(CONSTRAINT_TRIANGLES, nu, false);
    check_strains(CONSTRAINT_EDGES, 1.0 / 3, false);
    check_strains(CONSTRAINT_EDGES, 0.25, false);
    check_plate(0);
    check_strains(CONSTRAINT_EDGES, 0, true);
    check_plate(0.3);
    check_fabric(0);
    check_fabric(90);
    return check_result();
}
